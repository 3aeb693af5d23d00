// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl study | questionnaire list, show, publish: protocols and instruments.

#include <algorithm>
#include <cstdio>

#include "curriculum/draft_text.h"
#include "curriculum/study.h"
#include "db/study_conduct.h"
#include "ui/cli/session.h"
#include "ui/cli/study_options.h"

namespace placode::cli {
namespace {

int list_definitions(const Context& context, const std::string& kind) {
    Session session = coordinator(context);
    Json json = Json::array();
    std::vector<std::vector<std::string>> rows{{"id", "version", "published (UTC)", "by", "why"}};
    std::vector<std::string> published;
    for (const auto& each : session.store().definitions().list(kind)) {
        published.push_back(each.id);
        json.push_back({{"id", each.id},
                        {"version", each.version},
                        {"published_utc", each.published_utc},
                        {"published_by", each.published_by},
                        {"reason", each.reason},
                        {"checksum", each.checksum}});
        rows.push_back({each.id, std::to_string(each.version), each.published_utc,
                        each.published_by, each.reason});
    }
    const std::string folder = kind == "study" ? "studies" : "questionnaires";
    for (const std::string& id : curriculum::list_definitions(folder)) {
        if (std::find(published.begin(), published.end(), id) != published.end()) continue;
        json.push_back({{"id", id}, {"shipped", true}});
        rows.push_back({id, "", "shipped, not published", "", ""});
    }
    if (kind == "study") {
        for (const std::string& id : session.store().studies().ids()) {
            const auto n = session.store().studies().participants(id).size();
            for (Json& entry : json)
                if (entry["id"] == id) entry["participants"] = n;
            if (std::find(published.begin(), published.end(), id) != published.end()) continue;
            json.push_back({{"id", id}, {"participants", n}});
            rows.push_back({id, "", "answers without a protocol", "", ""});
        }
    }
    print(context, json, table(rows));
    return 0;
}

int show_definition(const Context& context, const std::string& kind, const StudyOptions& options) {
    Session session = coordinator(context);
    std::string text;
    if (const auto there = session.store().definitions().find(kind, options.id, options.version))
        text = there->json;
    else if (options.version != 0)
        throw InputError(kind + " " + options.id + ": version " + std::to_string(options.version) +
                         " is not published");
    else
        text = kind == "study" ? curriculum::load_study(options.id).json
                               : curriculum::load_questionnaire(options.id).json;
    print(context, Json::parse(text), text);
    return 0;
}

int publish(const Context& context, const std::string& kind, const StudyOptions& options) {
    Session session = coordinator(context, Missing::kCreate);
    db::DefinitionRecord definition;
    definition.kind = kind;
    definition.reason = options.reason;
    if (kind == "study") {
        const auto study = curriculum::load_study(options.file);
        definition.id = study.id;
        definition.version = study.version;
        definition.json = study.json;
        if (definition.reason.empty()) definition.reason = study.reason;
        for (const auto& step : study.steps)
            if (!step.questionnaire.empty())
                db::publish_on_first_use(session.store(),
                                         curriculum::load_questionnaire(step.questionnaire));
    } else {
        const auto read = curriculum::load_questionnaire(options.file);
        definition.id = read.id;
        definition.version = read.version;
        definition.json = read.json;
    }
    as_input([&] { session.store().definitions().publish(definition); });
    if (const auto draft = curriculum::draft_text(definition.json))
        std::fprintf(
            stderr,
            "placodectl: %s %s: its text calls itself a draft (\"%s\"); publish the approved "
            "text as the next version before participants read it\n",
            kind.c_str(), definition.id.c_str(), draft->in("en").c_str());
    const auto there = session.store().definitions().find(kind, definition.id, definition.version);
    print(context,
          {{"kind", kind},
           {"id", definition.id},
           {"version", definition.version},
           {"checksum", there->checksum}},
          "published " + kind + " " + definition.id + " version " +
              std::to_string(definition.version) + "; it is never changed from now on");
    return 0;
}

}  // namespace

void add_definition_commands(CLI::App& group, Context& context, const std::string& kind,
                             const std::shared_ptr<StudyOptions>& options) {
    CLI::App* list = group.add_subcommand("list", "What is published, and what is shipped");
    list->callback([&context, kind] {
        context.run = [&context, kind] { return list_definitions(context, kind); };
    });
    CLI::App* show = group.add_subcommand("show", "The text of a definition");
    show->add_option("ID", options->id, "Of the definition, see `list`")->required();
    show->add_option("--version", options->version, "0 = the newest");
    show->callback([&context, kind, options] {
        context.run = [&context, kind, options] {
            return show_definition(context, kind, *options);
        };
    });
    CLI::App* publish_command =
        group.add_subcommand("publish", "Publishes a version for good: it is never changed");
    publish_command->add_option("FILE", options->file, "FILE.json, or the id of a shipped one")
        ->required();
    publish_command->add_option("--reason", options->reason, "Needed after the first version");
    publish_command->callback([&context, kind, options] {
        context.run = [&context, kind, options] { return publish(context, kind, *options); };
    });
}

}  // namespace placode::cli
