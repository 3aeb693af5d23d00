// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/demonstration_attempts.h"

#include <array>
#include <chrono>
#include <ctime>
#include <thread>

#include "curriculum/utc_time.h"
#include "db/demonstration.h"
#include "db/recording_file.h"

namespace placode::db {
namespace {

constexpr std::array kPeople{
    DemonstrationPerson{"demo-anna", "Anna Demo", Role::kTrainee},
    DemonstrationPerson{"demo-jan", "Jan Demo", Role::kTrainee},
    DemonstrationPerson{"demo-educator", "Ewa Demo", Role::kEducator},
    DemonstrationPerson{"demo-coordinator", "Karol Demo", Role::kCoordinator},
    DemonstrationPerson{"demo-admin", "Adam Demo", Role::kAdministrator},
};

constexpr std::array kAttempts{
    DemonstrationAttempt{"demo-anna", "script:novice", 11},
    DemonstrationAttempt{"demo-anna", "script:intermediate", 12},
    DemonstrationAttempt{"demo-anna", "script:expert", 13},
    DemonstrationAttempt{"demo-jan", "script:novice", 21},
    DemonstrationAttempt{"demo-jan", "script:intermediate", 22},
};

}  // namespace

std::span<const DemonstrationPerson> demonstration_people() noexcept { return kPeople; }
std::span<const DemonstrationAttempt> demonstration_attempts() noexcept { return kAttempts; }

std::vector<std::string> add_demonstration_people(Store& store) {
    std::vector<std::string> created;
    for (const DemonstrationPerson& person : kPeople) {
        if (store.accounts().find_login(person.login)) continue;
        store.accounts().create({person.login, person.name, kDemonstrationPassword,
                                 static_cast<Roles>(person.role), true});
        created.emplace_back(person.login);
    }
    return created;
}

bool has_demonstration(Store& store, const DemonstrationAttempt& planned, const std::string& task) {
    const auto user = store.accounts().find_login(planned.login);
    for (const auto& attempt : store.attempts().list(user->id, task))
        if (attempt.device == planned.device && attempt.seed == planned.seed &&
            attempt.demonstration)
            return true;
    return false;
}

bool record_demonstration(const DemonstrationAttempt& attempt, const std::string& task_id,
                          int threads, const std::string& file,
                          const std::function<bool(const curriculum::AttemptStatus&)>& go_on) {
    const curriculum::Task task = curriculum::load_task(task_id);
    curriculum::AttemptOptions how;
    how.device = attempt.device;
    how.threads = threads;
    how.fast = true;
    how.demonstration = true;
    how.started_utc = curriculum::utc_text(std::time(nullptr));
    curriculum::AttemptRunner runner(task, attempt.seed, how, create_recording_file(file));
    bool complete = true;
    runner.start();
    while (!runner.finished()) {
        if (!go_on(runner.status())) {
            complete = false;
            runner.request_finish(sim::EndReason::kClosed);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    runner.wait();
    return complete;
}

}  // namespace placode::db
