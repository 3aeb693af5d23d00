// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl demo: people and attempts to look at. Every attempt is really simulated, by a scripted
// operator, and recorded; everything is marked as demonstration. A second run adds what is missing.

#include <algorithm>
#include <chrono>
#include <csignal>
#include <iostream>
#include <memory>

#include "db/demonstration.h"
#include "db/demonstration_attempts.h"
#include "sim/core/counted.h"
#include "ui/cli/progress.h"
#include "ui/cli/save_recording.h"
#include "ui/cli/scratch_folder.h"

namespace placode::cli {
namespace {

struct DemoOptions {
    std::string task = "diathermy_ring";
    int attempts = static_cast<int>(db::demonstration_attempts().size());
    int threads = 2;
};

std::string progress_words(const std::string& what, const curriculum::AttemptStatus& status) {
    return what + ": " + fixed(status.time_s, 1) + " s, " +
           std::string(sim::phase_name(status.phase)) + ", " + fixed(100 * status.cut_fraction, 0) +
           " % cut";
}

/// Simulates, records, scores and saves one attempt. Returns false when it was cancelled.
bool run_attempt(Session& session, const db::DemonstrationAttempt& planned,
                 const DemoOptions& options, const std::string& what, Json& json) {
    const ScratchFolder scratch;
    const std::string file = scratch.file("attempt.placode");
    const auto start = std::chrono::steady_clock::now();
    const auto go_on = [&what](const curriculum::AttemptStatus& status) {
        show_progress(progress_words(what, status));
        return !CancelOn::requested();
    };
    const bool complete =
        db::record_demonstration(planned, options.task, options.threads, file, go_on);
    clear_progress();
    if (!complete || CancelOn::requested()) return false;
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
    const auto created = db::add_demonstration_people(session.program_store());
    Json json{{"store", session.program_store().url()},
              {"created_users", created},
              {"password", db::kDemonstrationPassword},
              {"attempts", Json::array()}};
    int there = 0;
    const auto attempts = db::demonstration_attempts();
    const auto count = std::min(attempts.size(), static_cast<size_t>(options.attempts));
    for (size_t i = 0; i < count && !CancelOn::requested(); ++i) {
        const db::DemonstrationAttempt& planned = attempts[i];
        if (db::has_demonstration(session.program_store(), planned, options.task)) {
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
    for (const db::DemonstrationPerson& person : db::demonstration_people())
        text += std::string("  ") + person.login + "\n";
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
        ->check(CLI::Range(0, options->attempts))
        ->capture_default_str();
    command->add_option("--threads", options->threads, "Threads of the simulation")
        ->check(CLI::Range(1, 64))
        ->capture_default_str();
    command->callback([&context, options] {
        context.run = [&context, options] { return demo(context, *options); };
    });
}

}  // namespace placode::cli
