// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl verify: simulates exams and attempts of studies again; they count once the same came
// out. The shell does it by itself; this is for what was imported, and, with practice, for the
// night. Killed half-way it goes on with the rest the next time.

#include <memory>

#include "curriculum/attempt_runner.h"
#include "sim/core/counted.h"
#include "ui/cli/cli.h"
#include "ui/cli/progress.h"
#include "ui/cli/verify.h"

namespace placode::cli {
namespace {

struct VerifyOptions {
    int64_t attempt = 0;  ///< 0 = all that wait.
    bool all = false;     ///< Practice, too, that was never simulated again.
};

struct ToVerify {
    int64_t id = 0;
    db::ReplayState state = db::ReplayState::kWaiting;  ///< Until it was simulated again.
};

std::vector<ToVerify> asked_for(Session& session, const VerifyOptions& options) {
    db::Attempts& attempts = session.store().attempts();
    if (options.attempt != 0) {
        session.need_for(db::Action::kViewAttempts,
                         attempts.detail(options.attempt).record.user_id);
        return {{options.attempt}};
    }
    session.need(db::Action::kViewAttempts, db::Scope::kOther);
    std::vector<ToVerify> found;
    // Exams and studies first: they count for nothing until then.
    for (const int64_t id : attempts.waiting_for_replay()) found.push_back({id});
    if (options.all)
        for (const int64_t id : attempts.never_replayed())
            found.push_back({id, db::ReplayState::kNotReplayed});
    return found;
}

struct Verified {
    Json attempts = Json::array();
    std::vector<std::vector<std::string>> rows{{"attempt", "simulated again", "difference"}};
    int identical = 0, differ = 0, left = 0;
};

/// Why nothing came out. @param build that alone could tell; empty = none is known.
std::string why_left(const std::string& build) {
    if (CancelOn::requested()) return "stopped";
    if (!build.empty()) return "waits for " + build + "; this is " + curriculum::this_build();
    return "scored by another build, of a task that is unknown here, or of whom your account may "
           "not say it on the server";
}

/// @param brief the table leaves out what is as it should be.
Verified verify_all(Session& session, const std::vector<ToVerify>& all, bool brief) {
    Verified done;
    for (size_t i = 0; i < all.size() && !CancelOn::requested(); ++i) {
        const std::string place = all.size() == 1 ? ""
                                                  : " (" + std::to_string(i + 1) + " of " +
                                                        std::to_string(all.size()) + ")";
        const auto verdict = verify(session, all[i].id, place);
        const char* const state = db::replay_name(!verdict             ? all[i].state
                                                  : verdict->identical ? db::ReplayState::kIdentical
                                                                       : db::ReplayState::kDiffers);
        const std::string build =
            verdict ? std::string()
                    : db::build_waited_for(session.store().attempts().detail(all[i].id).record);
        const std::string difference = verdict ? verdict->difference.english() : why_left(build);
        done.identical += verdict && verdict->identical ? 1 : 0;
        done.differ += verdict && !verdict->identical ? 1 : 0;
        done.left += verdict ? 0 : 1;
        done.attempts.push_back(
            {{"attempt", all[i].id}, {"replay", state}, {"difference", difference}});
        if (!build.empty()) done.attempts.back()["waits_for"] = build;
        if (!brief || !verdict || !verdict->identical)
            done.rows.push_back({std::to_string(all[i].id), state, difference});
    }
    return done;
}

int verify_command(const Context& context, const VerifyOptions& options) {
    Session session(context, Missing::kRefuse);
    const Verified done = verify_all(session, asked_for(session, options), options.all);
    const Json json{{"attempts", done.attempts},
                    {"differ", done.differ},
                    {"waiting", done.left},
                    {"cancelled", CancelOn::requested()}};
    const std::string summary =
        (options.all ? sim::counted(done.identical, "attempt") + " gave the same, " : "") +
        sim::counted(done.differ, "attempt") + " differ, " + std::to_string(done.left) +
        (options.all ? " could not be simulated again" : " still wait");
    print(context, json,
          done.attempts.empty()   ? std::string("no attempt waits for being simulated again")
          : done.rows.size() == 1 ? summary
                                  : table(done.rows) + summary);
    return CancelOn::requested() ? 1 : 0;
}

}  // namespace

std::optional<curriculum::ReplayVerdict> verify(Session& session, int64_t attempt_id,
                                                const std::string& place) {
    const CancelOn cancel{SIGINT, SIGTERM};
    const auto verdict = db::verify_attempt(session.program_store(), attempt_id, [&](double share) {
        show_progress("simulating attempt " + std::to_string(attempt_id) + " again" + place + ": " +
                      std::to_string(static_cast<int>(100 * share)) + " %");
        return !CancelOn::requested();
    });
    clear_progress();
    return verdict;
}

void add_verify_command(CLI::App& app, Context& context) {
    auto options = std::make_shared<VerifyOptions>();
    CLI::App* command = app.add_subcommand(
        "verify", "Simulates exams and attempts of studies again; they count once it is the same");
    auto* attempt =
        command->add_option("ATTEMPT", options->attempt, "Number (default: all that wait)");
    command
        ->add_flag("--all", options->all,
                   "Practice as well that was never simulated again; for the night")
        ->excludes(attempt);
    command->callback([&context, options] {
        context.run = [&context, options] { return verify_command(context, *options); };
    });
}

}  // namespace placode::cli
