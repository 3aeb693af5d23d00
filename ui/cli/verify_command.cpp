// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl verify: simulates exams and attempts of studies again; they count once the same came
// out. The shell does it by itself; this is for what was imported, and for the night.

#include <memory>

#include "sim/core/counted.h"
#include "ui/cli/cli.h"
#include "ui/cli/progress.h"
#include "ui/cli/verify.h"

namespace placode::cli {
namespace {

struct VerifyOptions {
    int64_t attempt = 0;  ///< 0 = all that wait.
};

int verify_command(const Context& context, const VerifyOptions& options) {
    Session session(context, Missing::kRefuse);
    std::vector<int64_t> ids{options.attempt};
    if (options.attempt == 0) {
        session.need(db::Action::kViewAttempts, db::Scope::kOther);
        ids = session.store().attempts().waiting_for_replay();
    } else {
        session.need_for(db::Action::kViewAttempts,
                         session.store().attempts().detail(options.attempt).record.user_id);
    }
    Json json{{"attempts", Json::array()}};
    std::vector<std::vector<std::string>> rows{{"attempt", "simulated again", "difference"}};
    int differ = 0, left = 0;
    for (const int64_t id : ids) {
        if (CancelOn::requested()) break;
        const auto verdict = verify(session, id);
        const char* const state = db::replay_name(!verdict             ? db::ReplayState::kWaiting
                                                  : verdict->identical ? db::ReplayState::kIdentical
                                                                       : db::ReplayState::kDiffers);
        const std::string difference =
            verdict ? verdict->difference
            : CancelOn::requested()
                ? "stopped"
                : "recorded by another build or processor, or of a task that is unknown here";
        differ += verdict && !verdict->identical ? 1 : 0;
        left += verdict ? 0 : 1;
        json["attempts"].push_back(
            {{"attempt", id}, {"replay", state}, {"difference", difference}});
        rows.push_back({std::to_string(id), state, difference});
    }
    json["differ"] = differ;
    json["waiting"] = left;
    json["cancelled"] = CancelOn::requested();
    print(context, json,
          rows.size() == 1 ? std::string("no attempt waits for being simulated again")
                           : table(rows) + sim::counted(differ, "attempt") + " differ, " +
                                 std::to_string(left) + " still wait");
    return CancelOn::requested() ? 1 : 0;
}

}  // namespace

std::optional<curriculum::ReplayVerdict> verify(Session& session, int64_t attempt_id) {
    const CancelOn cancel{SIGINT};
    const auto verdict = db::verify_attempt(session.program_store(), attempt_id, [&](double share) {
        show_progress("simulating attempt " + std::to_string(attempt_id) +
                      " again: " + std::to_string(static_cast<int>(100 * share)) + " %");
        return !CancelOn::requested();
    });
    clear_progress();
    return verdict;
}

void add_verify_command(CLI::App& app, Context& context) {
    auto options = std::make_shared<VerifyOptions>();
    CLI::App* command = app.add_subcommand(
        "verify", "Simulates exams and attempts of studies again; they count once it is the same");
    command->add_option("ATTEMPT", options->attempt, "Number (default: all that wait)");
    command->callback([&context, options] {
        context.run = [&context, options] { return verify_command(context, *options); };
    });
}

}  // namespace placode::cli
