// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl demo: people and attempts to look at. Every attempt is really simulated, by a scripted
// operator, and recorded; everything is marked as demonstration. A second run adds what is missing.

#include <array>
#include <chrono>
#include <csignal>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <memory>
#include <thread>

#include "curriculum/attempt_runner.h"
#include "curriculum/utc_time.h"
#include "db/demonstration.h"
#include "db/recording_file.h"
#include "sim/core/counted.h"
#include "ui/cli/progress.h"
#include "ui/cli/save_recording.h"
#include "ui/cli/scratch_folder.h"

namespace placode::cli {
namespace {

namespace fs = std::filesystem;

struct Person {
    const char *login, *name;
    db::Role role;
};
constexpr std::array kPeople{
    Person{"demo-anna", "Anna Demo", db::Role::kTrainee},
    Person{"demo-jan", "Jan Demo", db::Role::kTrainee},
    Person{"demo-educator", "Ewa Demo", db::Role::kEducator},
    Person{"demo-coordinator", "Karol Demo", db::Role::kCoordinator},
    Person{"demo-admin", "Adam Demo", db::Role::kAdministrator},
};

struct Planned {
    const char *login, *device;
    uint64_t seed;
};
constexpr std::array kAttempts{
    Planned{"demo-anna", "script:novice", 11},      Planned{"demo-anna", "script:intermediate", 12},
    Planned{"demo-anna", "script:expert", 13},      Planned{"demo-jan", "script:novice", 21},
    Planned{"demo-jan", "script:intermediate", 22},
};

struct DemoOptions {
    std::string task = "diathermy_ring";
    int attempts = static_cast<int>(kAttempts.size());
    int threads = 2;
};

/// Creates those who are missing; never changes an account that is there.
void add_people(Session& session, std::vector<std::string>& created) {
    for (const Person& person : kPeople) {
        if (session.program_store().accounts().find_login(person.login)) continue;
        session.program_store().accounts().create({person.login, person.name,
                                                   db::kDemonstrationPassword,
                                                   static_cast<db::Roles>(person.role), true});
        created.emplace_back(person.login);
    }
}

bool is_there(Session& session, const Planned& planned, const std::string& task) {
    const auto user = session.program_store().accounts().find_login(planned.login);
    for (const auto& attempt : session.program_store().attempts().list(user->id, task))
        if (attempt.device == planned.device && attempt.seed == planned.seed &&
            attempt.demonstration)
            return true;
    return false;
}

std::string progress_words(const std::string& what, const curriculum::AttemptStatus& status) {
    return what + ": " + fixed(status.time_s, 1) + " s, " +
           std::string(sim::phase_name(status.phase)) + ", " + fixed(100 * status.cut_fraction, 0) +
           " % cut";
}

/// Simulates, records, scores and saves one attempt. Returns false when it was cancelled.
bool run_attempt(Session& session, const Planned& planned, const DemoOptions& options,
                 const std::string& what, Json& json) {
    const ScratchFolder scratch;
    const std::string file = scratch.file("attempt.placode");
    const curriculum::Task task = curriculum::load_task(options.task);
    curriculum::AttemptOptions how;
    how.device = planned.device;
    how.threads = options.threads;
    how.fast = true;
    how.demonstration = true;
    how.started_utc = curriculum::utc_text(std::time(nullptr));
    const auto start = std::chrono::steady_clock::now();
    {
        curriculum::AttemptRunner runner(task, planned.seed, how, db::create_recording_file(file));
        runner.start();
        while (!runner.finished()) {
            if (CancelOn::requested()) runner.request_finish(sim::EndReason::kClosed);
            show_progress(progress_words(what, runner.status()));
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
        }
        runner.wait();
    }
    clear_progress();
    if (CancelOn::requested()) return false;
    const auto user = session.program_store().accounts().find_login(planned.login);
    const SavedAttempt saved = save_recording(session.program_store(), user->id, file);
    const double wall_s =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    json["attempts"].push_back({{"id", saved.id},
                                {"user", planned.login},
                                {"device", planned.device},
                                {"seed", planned.seed},
                                {"points", saved.attempt.score.points},
                                {"simulated_s", saved.duration_s},
                                {"wall_s", wall_s}});
    std::cerr << what << ": " << fixed(saved.attempt.score.points, 1) << " points after "
              << fixed(saved.duration_s, 1) << " s simulated in " << fixed(wall_s, 1) << " s\n";
    return true;
}

int demo(const Context& context, const DemoOptions& options) {
    Session session(context, Missing::kCreate);
    session.need(db::Action::kManageUsers, db::Scope::kOther);
    // Ends the attempt that runs, and keeps what is complete.
    const CancelOn on_interrupt{SIGINT, SIGTERM};
    std::vector<std::string> created;
    add_people(session, created);
    Json json{{"store", session.program_store().url()},
              {"created_users", created},
              {"password", db::kDemonstrationPassword},
              {"attempts", Json::array()}};
    int there = 0;
    const auto count = std::min<size_t>(kAttempts.size(), static_cast<size_t>(options.attempts));
    for (size_t i = 0; i < count && !CancelOn::requested(); ++i) {
        const Planned& planned = kAttempts[i];
        if (is_there(session, planned, options.task)) {
            ++there;
            continue;
        }
        (void)run_attempt(session, planned, options,
                          "attempt " + std::to_string(i + 1) + " of " + std::to_string(count) +
                              " (" + planned.login + ", " + planned.device + ")",
                          json);
    }
    json["already_there"] = there;
    json["cancelled"] = CancelOn::requested();
    std::string text = "demonstration accounts in " + session.program_store().url() +
                       ", password \"" + db::kDemonstrationPassword + "\":\n";
    for (const Person& person : kPeople) text += std::string("  ") + person.login + "\n";
    text += sim::counted(json["attempts"].size(), "attempt") + " simulated, " +
            std::to_string(there) + " were there";
    if (CancelOn::requested())
        text += "; cancelled, what is complete is kept: run it again for the rest";
    print(context, json, text);
    return CancelOn::requested() ? 1 : 0;
}

}  // namespace

void add_demo_commands(CLI::App& app, Context& context) {
    auto options = std::make_shared<DemoOptions>();
    CLI::App* command = app.add_subcommand(
        "demo", "Fills the store with demonstration accounts and attempts of scripted operators");
    command->add_option("--task", options->task, "Task id")->capture_default_str();
    command->add_option("--attempts", options->attempts, "How many attempts at most")
        ->check(CLI::Range(0, static_cast<int>(kAttempts.size())))
        ->capture_default_str();
    command->add_option("--threads", options->threads, "Threads of the simulation")
        ->check(CLI::Range(1, 64))
        ->capture_default_str();
    command->callback([&context, options] {
        context.run = [&context, options] { return demo(context, *options); };
    });
}

}  // namespace placode::cli
