// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl lti grades: scores into the gradebooks of learning platforms.

#include <iostream>
#include <memory>

#include "sim/core/counted.h"
#include "ui/cli/links.h"
#include "ui/cli/session.h"
#include "ui/finite_range.h"
#include "ui/lti/grades.h"

namespace placode::cli {
namespace {

struct GradesOptions {
    std::string config, issuer, client_id, task, line_item, take = "best", sent;
    bool dry_run = false;
    double wait_s = 2;
};

/// What one run did.
struct Tally {
    Json rows = Json::array();
    std::vector<std::vector<std::string>> lines{{"login", "task", "points", "what"}};
    std::vector<std::string> problems;
    int sent = 0;
};

const char* word_of(lti::Sent what, bool dry_run) {
    switch (what) {
        case lti::Sent::kSent:
            return dry_run ? "to be sent" : "sent";
        case lti::Sent::kSame:
            return "sent before";
        case lti::Sent::kNothing:
            return "no attempt that counts";
        case lti::Sent::kFailed:
            return "NOT SENT";
    }
    return "";
}

/// Those of the command line, else those of the file.
std::vector<lti::LineItem> line_items(const lti::Platform& platform, const GradesOptions& options) {
    if (!options.line_item.empty())
        return {{options.task, options.line_item,
                 options.take == "latest" ? lti::Take::kLatest : lti::Take::kBest}};
    std::vector<lti::LineItem> chosen;
    for (const lti::LineItem& each : platform.line_items)
        if (options.task.empty() || each.task == options.task) chosen.push_back(each);
    return chosen;
}

void check_grades(const GradesOptions& options) {
    if (options.line_item.empty()) return;
    if (options.task.empty()) throw InputError("--line-item: expected --task with it");
    try {
        (void)lti::parse_web_address(options.line_item);
    } catch (const std::invalid_argument& error) {
        throw InputError(std::string("--line-item: ") + error.what());
    }
}

std::vector<const lti::Platform*> chosen_platforms(const lti::Settings& settings,
                                                   const GradesOptions& options) {
    std::vector<const lti::Platform*> chosen;
    for (const lti::Platform& each : settings.platforms)
        if ((options.issuer.empty() || each.issuer == options.issuer) &&
            (options.client_id.empty() || each.client_id == options.client_id))
            chosen.push_back(&each);
    if (chosen.empty()) throw InputError("--issuer: " + settings.file + " holds no such platform");
    if (!options.line_item.empty() && chosen.size() > 1)
        throw InputError("--line-item: expected --issuer with it, because " + settings.file +
                         " holds several platforms");
    return chosen;
}

void send_one(lti::GradeSender& sender, const lti::Grade& grade, bool dry_run, Tally& tally) {
    std::string problem;
    lti::Sent what = sender.due(grade);
    if (what == lti::Sent::kSent && !dry_run)
        what = sender.is_away() ? lti::Sent::kFailed : sender.send(grade, problem);
    if (!problem.empty()) tally.problems.push_back(problem);
    if (what == lti::Sent::kSent) ++tally.sent;
    tally.rows.push_back({{"login", grade.login},
                          {"sub", grade.subject},
                          {"task", grade.task},
                          {"line_item", grade.line_item},
                          {"points", optional_number(grade.points)},
                          {"what", word_of(what, dry_run)}});
    tally.lines.push_back(
        {grade.login, grade.task, optional_text(grade.points, 2), word_of(what, dry_run)});
}

int run_grades(const Context& context, const GradesOptions& options) {
    check_grades(options);
    const lti::Settings settings = lti::read_settings(options.config);
    const auto platforms = chosen_platforms(settings, options);
    std::optional<lti::SigningKey> key;
    try {
        key.emplace(lti::read_secret(settings.private_key_file));
    } catch (const std::invalid_argument& error) {
        throw InputError(settings.private_key_file + ": " + error.what());
    }
    Session session(context, Missing::kRefuse);
    session.need(db::Action::kViewAttempts, db::Scope::kOther);
    lti::SentFile sent(options.sent.empty() ? options.config + ".sent" : options.sent);
    Tally tally;
    LeftOut left_out;
    for (const lti::Platform* platform : platforms) {
        lti::GradeSender sender(*platform, *key, sent, {3, options.wait_s});
        const int before = tally.sent;
        const lti::Platform there = without_erased(session, *platform, left_out);
        for (const lti::LineItem& item : line_items(there, options))
            for (const lti::Grade& grade :
                 lti::grades_of(session.store(), there, item, tally.problems))
                send_one(sender, grade, options.dry_run, tally);
        // Scores leave the store: the trail says how many and where to.
        if (!options.dry_run && tally.sent > before)
            session.store().audit().write(session.actor(), "lti.grades", platform->issuer,
                                          sim::counted(tally.sent - before, "score"));
    }
    // No failure: a job that runs every quarter of an hour would fail for ever.
    for (const std::string& each : left_out.erased) std::cerr << "placodectl: " << each << '\n';
    for (const std::string& each : tally.problems) std::cerr << "placodectl: " << each << '\n';
    print(
        context,
        {{"sent", options.dry_run ? 0 : tally.sent},
         {"dry_run", options.dry_run},
         {"grades", tally.rows},
         {"problems", tally.problems}},
        table(tally.lines) + "\n" +
            (options.dry_run ? sim::counted(tally.sent, "score") + " to be sent; nothing was"
                             : sim::counted(tally.sent, "score") + " sent") +
            (tally.problems.empty() ? "" : "; run it again for the others, nothing is sent twice"));
    return tally.problems.empty() ? 0 : 1;
}

}  // namespace

void add_lti_grades_command(CLI::App& lti, Context& context) {
    auto options = std::make_shared<GradesOptions>();
    CLI::App* command = lti.add_subcommand(
        "grades", "Send scores to the gradebooks: of who is linked, attempts that count");
    command->add_option("--config", options->config, "FILE.json with the platforms")->required();
    command->add_option("--issuer", options->issuer, "Only of this platform");
    command->add_option("--client-id", options->client_id,
                        "Where the issuer is there several times");
    command->add_option("--task", options->task, "Only this task");
    command->add_option("--line-item", options->line_item,
                        "Address of the column, instead of those in the file; with --task");
    command->add_option("--take", options->take, "Which attempt, with --line-item")
        ->check(CLI::IsMember({"best", "latest"}))
        ->capture_default_str();
    command->add_option("--sent", options->sent,
                        "File that remembers what was sent (default: beside the settings)");
    command->add_option("--wait", options->wait_s, "Before a second try [s]")
        ->check(ui::finite_range(0.0, 60.0))
        ->capture_default_str();
    command->add_flag("--dry-run", options->dry_run, "Say what would be sent, and send nothing");
    command->callback([&context, options] {
        context.run = [&context, options] { return run_grades(context, *options); };
    });
}

}  // namespace placode::cli
