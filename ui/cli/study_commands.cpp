// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl study | questionnaire: protocols and instruments, participants, what they did and
// answered.

#include <algorithm>
#include <cstdio>
#include <memory>

#include "curriculum/draft_text.h"
#include "curriculum/study.h"
#include "db/participant.h"
#include "db/study_conduct.h"
#include "sim/core/near_word.h"
#include "ui/cli/session.h"
#include "ui/cli/study_options.h"
#include "ui/cli/study_records.h"

namespace placode::cli {
namespace {

using db::Action;
using db::Scope;

// --- definitions -------------------------------------------------------------------------------

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

// --- participants ------------------------------------------------------------------------------

int enrol(const Context& context, const StudyOptions& options) {
    Session session = coordinator(context);
    const std::string code = as_input([&] {
        return session.store().studies().new_participant(options.id, options.demonstration);
    });
    if (options.consented)
        as_input([&] {
            db::record_consent(session.store(), options.id, code, options.language,
                               required_statements(session, options.id));
        });
    print(context, {{"study", options.id}, {"participant", code}, {"consented", options.consented}},
          code + (options.consented ? " (consent recorded)" : ""));
    return 0;
}

int consent(const Context& context, const StudyOptions& options) {
    Session session = coordinator(context);
    as_input([&] {
        db::record_consent(session.store(), options.id, need_code(options.code), options.language,
                           options.agreed);
    });
    print(context, {{"study", options.id}, {"participant", options.code}, {"consented", true}},
          "consent of " + options.code + " recorded");
    return 0;
}

int step(const Context& context, const StudyOptions& options) {
    Session session = coordinator(context);
    const auto protocol = db::published_study(session.store(), options.id);
    if (protocol && protocol->step(options.step) == nullptr) {
        std::string known;
        for (const auto& each : protocol->steps) known += (known.empty() ? "" : ", ") + each.id;
        throw InputError("study step: found \"" + options.step + "\"; expected one of: " + known);
    }
    if (protocol && protocol->step(options.step)->kind == curriculum::StepKind::kConsent)
        throw InputError("study step: \"" + options.step +
                         "\" is the consent; record it with `placodectl study consent`");
    db::StepRecord record;
    record.study_id = options.id;
    record.participant = need_code(options.code);
    record.visit = options.visit;
    record.step = options.step;
    record.state = options.state == "started"   ? db::StepState::kStarted
                   : options.state == "skipped" ? db::StepState::kSkipped
                                                : db::StepState::kDone;
    record.attempt_id = options.attempt;
    // Whether an attempt does the step is not a matter of what was typed.
    const bool judged = options.attempt != 0 && record.state == db::StepState::kDone;
    as_input([&] {
        judged ? db::record_attempt_step(session.store(), record)
               : static_cast<void>(session.store().studies().record_step(record));
    });
    std::string state = options.state, why;
    for (const auto& each : session.store().studies().steps(options.id))
        if (judged && each.attempt_id == options.attempt && each.state == db::StepState::kStarted)
            state = "started", why = ": " + each.detail;
    print(context, {{"participant", options.code}, {"step", options.step}, {"state", state}},
          options.code + ": " + options.step + " " + state + why);
    return 0;
}

const char* withdrawal_word(const db::ParticipantRecord& participant) {
    if (!participant.withdrawal) return "";
    switch (*participant.withdrawal) {
        case db::WithdrawalMode::kKeep:
            return "withdrew, data to date are used";
        case db::WithdrawalMode::kStop:
            return "withdrew, data are not used";
        case db::WithdrawalMode::kErase:
            break;
    }
    return "withdrew, data are erased";
}

int status(const Context& context, const StudyOptions& options) {
    Session session = coordinator(context);
    const auto list = db::study_progress(session.store(), options.id);
    if (list.empty())
        throw InputError("study status: \"" + options.id +
                         "\" has no participants; `placodectl study enrol " + options.id +
                         "` adds one" +
                         sim::did_you_mean(options.id, session.store().studies().ids()));
    Json json{{"study", options.id}, {"participants", Json::array()}};
    std::vector<std::vector<std::string>> rows{
        {"code", "enrolled (UTC)", "arm", "steps", "next", "last (UTC)", "remark"}};
    for (const auto& each : list) {
        const auto& who = each.participant;
        const std::string steps =
            each.total == 0 ? "-" : std::to_string(each.done) + " of " + std::to_string(each.total);
        json["participants"].push_back({{"code", who.code},
                                        {"enrolled_utc", who.enrolled_utc},
                                        {"protocol_version", who.protocol_version},
                                        {"arm", who.arm},
                                        {"demonstration", who.demonstration},
                                        {"done", each.done},
                                        {"total", each.total},
                                        {"visit", each.visit},
                                        {"next", each.next},
                                        {"device", who.device},
                                        {"open_because", each.open_because},
                                        {"withdrawal", withdrawal_word(who)}});
        std::string remark = withdrawal_word(who);
        if (remark.empty() && !each.open_because.empty()) remark = each.open_because;
        if (who.demonstration) remark += std::string(remark.empty() ? "" : "; ") + "DEMONSTRATION";
        rows.push_back({who.code, who.enrolled_utc, who.arm < 0 ? "" : std::to_string(who.arm + 1),
                        steps, who.withdrawal ? "" : each.next, each.last_utc, remark});
    }
    print(context, json, table(rows));
    return 0;
}

int withdraw(const Context& context, const StudyOptions& options) {
    Session session = coordinator(context);
    const db::WithdrawalMode mode = options.mode == "keep"   ? db::WithdrawalMode::kKeep
                                    : options.mode == "stop" ? db::WithdrawalMode::kStop
                                                             : db::WithdrawalMode::kErase;
    as_input([&] {
        session.store().studies().withdraw(options.id, need_code(options.code), mode,
                                           options.reason);
    });
    print(context, {{"participant", options.code}, {"mode", options.mode}},
          options.code + " has withdrawn (" + options.mode + "); code and withdrawal stay");
    return 0;
}

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

}  // namespace

void add_study_commands(CLI::App& app, Context& context) {
    auto options = std::make_shared<StudyOptions>();
    CLI::App* questionnaire = app.add_subcommand("questionnaire", "Instruments");
    questionnaire->require_subcommand(1);
    add_definition_commands(*questionnaire, context, "questionnaire", options);
    CLI::App* study = app.add_subcommand("study", "Protocols, participants, answers");
    study->require_subcommand(1);
    add_definition_commands(*study, context, "study", options);
    add_study_record_commands(*study, context);
    add_study_repeat_commands(*study, context);
    add_study_key_commands(*study, context);
    add_study_analysis_commands(*study, context);
    const auto add = [&](const char* name, const char* text,
                         int (*work)(const Context&, const StudyOptions&)) {
        CLI::App* command = study->add_subcommand(name, text);
        command->add_option("STUDY", options->id, "Study id")->required();
        command->callback([&context, options, work] {
            context.run = [&context, options, work] { return work(context, *options); };
        });
        return command;
    };
    const auto with_code = [&](CLI::App* command) {
        command->add_option("CODE", options->code, "Of the participant, e.g. P001-C")->required();
        return command;
    };
    const auto with_language = [&](CLI::App* command) {
        command->add_option("--language", options->language, "In which the text was read")
            ->check(CLI::IsMember({"en", "pl"}))
            ->capture_default_str();
        return command;
    };
    CLI::App* enrol_command = add("enrol", "Enrols a participant and prints the code", enrol);
    with_language(enrol_command);
    enrol_command->add_flag("--consented", options->consented,
                            "All required statements were agreed to");
    enrol_command->add_flag("--demonstration", options->demonstration, "A simulated participant");
    CLI::App* consent_command = with_code(add("consent", "Records a consent", consent));
    with_language(consent_command);
    consent_command->add_option("--agreed", options->agreed, "Ids of the statements")->required();
    CLI::App* step_command = with_code(add("step", "Records what a participant did", step));
    step_command->add_option("STEP", options->step, "Id in the protocol")->required();
    step_command->add_option("--state", options->state, "What became of the step")
        ->check(CLI::IsMember({"started", "done", "skipped"}))
        ->capture_default_str();
    step_command->add_option("--attempt", options->attempt, "Number of the attempt");
    step_command->add_option("--visit", options->visit, "Number of the visit")
        ->check(CLI::Range(1, 100));
    add("status", "Where everyone stands", status);
    CLI::App* answer_command = with_language(
        with_code(add("answer", "Saves the answers to a questionnaire", study_answer)));
    answer_command->add_option("QUESTIONNAIRE", options->questionnaire, "Id or FILE.json")
        ->required();
    answer_command->add_option("ANSWERS", options->answers, "ITEM=VALUE ...")->required();
    answer_command->add_option("--visit", options->visit, "Number of the visit")
        ->check(CLI::Range(1, 100));
    CLI::App* import_command = with_language(
        add("import", "Answers from a table: a row a participant, a column an item", study_import));
    import_command->add_option("FILE", options->file, "FILE.csv with a column participant")
        ->required();
    import_command->add_option("--questionnaire", options->questionnaire, "Id or FILE.json")
        ->required();
    CLI::App* withdraw_command = with_code(add("withdraw", "A participant withdraws", withdraw));
    withdraw_command
        ->add_option("--mode", options->mode,
                     "keep: data to date are used; stop: they stay, but are used no more; erase: "
                     "they are deleted")
        ->required()
        ->check(CLI::IsMember({"keep", "stop", "erase"}));
    withdraw_command->add_option("--reason", options->reason, "\"not given\" is one")->required();
    CLI::App* demo_command =
        study->add_subcommand("demo", "The paper's study with 14 simulated participants");
    demo_command->callback(
        [&context] { context.run = [&context] { return study_demo(context); }; });
}

}  // namespace placode::cli
