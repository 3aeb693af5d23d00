// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl study: participants, what they did and answered. Protocols and questionnaires:
// study_definition_commands.cpp.

#include <iterator>
#include <memory>

#include "curriculum/study.h"
#include "db/participant.h"
#include "db/store_copies.h"
#include "db/store_url.h"
#include "db/study_conduct.h"
#include "db/unsaved_recordings.h"
#include "sim/core/near_word.h"
#include "ui/cli/session.h"
#include "ui/cli/study_options.h"
#include "ui/cli/study_records.h"

namespace placode::cli {

std::string copies_left(const Context& context, Json& left) {
    const std::string url = store_url_of(context);
    std::string text;
    for (const db::LeftCopy& each : db::copies_with_records(url)) {
        left.push_back({{"path", each.path}, {"why", each.why}});
        text += "\nmay still hold the data: " + each.path + ": " + each.why;
    }
    if (db::parse_store_url(url).engine == db::Engine::kPostgresql)
        text += "\nbackups of the server may still hold the data; ask its administrator";
    return text;
}

namespace {

using db::Action;
using db::Scope;

int enrol(const Context& context, const StudyOptions& options) {
    Session session = coordinator(context);
    const std::string code = as_input([&] {
        return session.store().studies().new_participant(options.id, options.demonstration);
    });
    if (options.consented)
        as_input([&] {
            db::record_consent(session.store(), options.id, code, options.language,
                               required_statements(session, options.id, code));
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
    const auto protocol = db::protocol_of(session.store(), options.id, options.code);
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
    const db::WithdrawalMode mode = db::withdrawal_mode_named(options.mode).value();
    as_input([&] {
        session.store().studies().withdraw(options.id, need_code(options.code), mode,
                                           options.reason);
    });
    const bool erases = mode == db::WithdrawalMode::kErase;
    const auto unsaved = db::unsaved_recordings(db::recordings_beside(session.store().url()),
                                                {options.id, options.code},
                                                erases ? db::Unsaved::kRemove : db::Unsaved::kName);
    std::string text =
        options.code + " has withdrawn (" + options.mode + "); code and withdrawal stay";
    for (const std::string& each : unsaved)
        text += "\n" + each +
                (erases ? " had not been saved and is removed"
                        : " was not saved and cannot be any more; delete it");
    Json left = Json::array();
    if (erases) text += copies_left(context, left);
    print(context,
          {{"participant", options.code},
           {"mode", options.mode},
           {"unsaved", unsaved},
           {"left", left}},
          text);
    return 0;
}

/// The group `study` of the parser, and what its commands have in common.
struct StudyGroup {
    CLI::App& study;
    Context& context;
    std::shared_ptr<StudyOptions> options;

    CLI::App* add(const char* name, const char* text,
                  int (*work)(const Context&, const StudyOptions&)) const {
        CLI::App* command = study.add_subcommand(name, text);
        command->add_option("STUDY", options->id, "Study id")->required();
        command->callback([&context = context, options = options, work] {
            context.run = [&context, options, work] { return work(context, *options); };
        });
        return command;
    }
    CLI::App* with_code(CLI::App* command) const {
        command->add_option("CODE", options->code, "Of the participant, e.g. P001-C")->required();
        return command;
    }
    CLI::App* with_language(CLI::App* command) const {
        command->add_option("--language", options->language, "In which the text was read")
            ->check(CLI::IsMember({"en", "pl"}))
            ->capture_default_str();
        return command;
    }
};

/// enrol, consent, step, status
void add_participant_commands(const StudyGroup& group) {
    CLI::App* enrol_command = group.add("enrol", "Enrols a participant and prints the code", enrol);
    group.with_language(enrol_command);
    enrol_command->add_flag("--consented", group.options->consented,
                            "All required statements were agreed to");
    enrol_command->add_flag("--demonstration", group.options->demonstration,
                            "A simulated participant");
    CLI::App* consent_command = group.with_code(group.add("consent", "Records a consent", consent));
    group.with_language(consent_command);
    consent_command->add_option("--agreed", group.options->agreed, "Ids of the statements")
        ->required();
    CLI::App* step_command =
        group.with_code(group.add("step", "Records what a participant did", step));
    step_command->add_option("STEP", group.options->step, "Id in the protocol")->required();
    step_command->add_option("--state", group.options->state, "What became of the step")
        ->check(CLI::IsMember({"started", "done", "skipped"}))
        ->capture_default_str();
    step_command->add_option("--attempt", group.options->attempt, "Number of the attempt");
    step_command->add_option("--visit", group.options->visit, "Number of the visit")
        ->check(CLI::Range(1, 100));
    group.add("status", "Where everyone stands", status);
}

/// answer, import
void add_answer_commands(const StudyGroup& group) {
    CLI::App* answer_command = group.with_language(
        group.with_code(group.add("answer", "Saves the answers to a questionnaire", study_answer)));
    answer_command->add_option("QUESTIONNAIRE", group.options->questionnaire, "Id or FILE.json")
        ->required();
    answer_command->add_option("ANSWERS", group.options->answers, "ITEM=VALUE ...")->required();
    answer_command->add_option("--visit", group.options->visit, "Number of the visit")
        ->check(CLI::Range(1, 100));
    CLI::App* import_command = group.with_language(group.add(
        "import", "Answers from a table: a row a participant, a column an item", study_import));
    import_command->add_option("FILE", group.options->file, "FILE.csv with a column participant")
        ->required();
    import_command->add_option("--questionnaire", group.options->questionnaire, "Id or FILE.json")
        ->required();
    import_command->add_option("--visit", group.options->visit, "Number of the visit of all rows")
        ->check(CLI::Range(1, 100));
}

void add_withdraw_command(const StudyGroup& group) {
    CLI::App* withdraw_command =
        group.with_code(group.add("withdraw", "A participant withdraws", withdraw));
    withdraw_command
        ->add_option("--mode", group.options->mode,
                     "keep: data to date are used; stop: they stay, but are used no more; erase: "
                     "they are deleted")
        ->required()
        ->check(CLI::IsMember(std::vector<std::string>(std::begin(db::kWithdrawalModeNames),
                                                       std::end(db::kWithdrawalModeNames))));
    withdraw_command->add_option("--reason", group.options->reason, "\"not given\" is one")
        ->required();
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
    add_study_retention_command(*study, context);
    add_study_analysis_commands(*study, context);
    const StudyGroup group{*study, context, options};
    add_participant_commands(group);
    add_answer_commands(group);
    add_withdraw_command(group);
    CLI::App* demo_command =
        study->add_subcommand("demo", "The paper's study with 14 simulated participants");
    demo_command->callback(
        [&context] { context.run = [&context] { return study_demo(context); }; });
}

}  // namespace placode::cli
