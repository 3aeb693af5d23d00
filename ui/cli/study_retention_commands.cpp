// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl study retention: until when records are kept, and erasing those whose time is over.

#include <algorithm>
#include <memory>

#include "db/sql_connection.h"
#include "db/study_retention.h"
#include "sim/core/near_word.h"
#include "ui/cli/study_options.h"
#include "ui/cli/study_records.h"

namespace placode::cli {
namespace {

struct RetentionOptions {
    std::string study;
    bool erase = false;
};

int show(const Context& context, Session& session, const RetentionOptions& options) {
    const auto kept = db::kept_records(session.store(), options.study);
    const std::string now = db::utc_now();
    Json json = Json::array();
    std::vector<std::vector<std::string>> rows{{"code", "last (UTC)", "kept until (UTC)", ""}};
    int overdue = 0;
    for (const db::KeptRecords& each : kept) {
        const bool over = each.overdue(now);
        overdue += over ? 1 : 0;
        json.push_back({{"participant", each.code},
                        {"last_utc", each.last_utc},
                        {"keep_years", each.keep_years},
                        {"until_utc", each.until_utc},
                        {"overdue", over}});
        rows.push_back({each.code, each.last_utc, each.until_utc, over ? "OVERDUE" : ""});
    }
    std::string text = table(rows);
    if (kept.empty())
        text = "\"" + options.study +
               "\": no records with a time; a protocol says it with \"keep_years\"";
    else if (overdue > 0)
        text += "\n" + std::to_string(overdue) + " overdue: `placodectl study retention " +
                options.study + " --erase` erases them for good";
    print(context, json, text);
    return 0;
}

int retention(const Context& context, const RetentionOptions& options) {
    Session session = coordinator(context);
    const auto ids = session.store().studies().ids();
    if (std::find(ids.begin(), ids.end(), options.study) == ids.end())
        throw InputError("study retention: there is no study \"" + options.study + "\"" +
                         sim::did_you_mean(options.study, ids));
    if (!options.erase) return show(context, session, options);
    const auto erased = db::erase_overdue(session.store(), options.study, db::utc_now());
    std::string text = erased.empty() ? "nothing is overdue; nothing was erased" : "erased:";
    for (const std::string& code : erased) text += " " + code;
    Json left = Json::array();
    if (!erased.empty()) text += copies_left(context, left);
    print(context, {{"study", options.study}, {"erased", erased}, {"left", left}}, text);
    return 0;
}

}  // namespace

void add_study_retention_command(CLI::App& study, Context& context) {
    auto options = std::make_shared<RetentionOptions>();
    CLI::App* command =
        study.add_subcommand("retention", "Until when records are kept; erases what is overdue");
    command->add_option("STUDY", options->study, "Study id")->required();
    command->add_flag("--erase", options->erase,
                      "Erases answers, attempts and signatures that are overdue; codes stay");
    command->callback([&context, options] {
        context.run = [&context, options] { return retention(context, *options); };
    });
}

}  // namespace placode::cli
