// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl study lock | sign | unlock | correct | second-entry | differences | decide

#include <algorithm>
#include <memory>

#include "db/participant.h"
#include "db/study_conduct.h"
#include "db/study_records.h"
#include "ui/cli/session.h"
#include "ui/cli/study_options.h"
#include "ui/cli/study_records.h"

namespace placode::cli {
namespace {

struct StudyRecordOptions {
    std::string study, code, questionnaire, item, meaning, reason;
    std::vector<std::string> answers;
    int right = 1, visit = 1;
    int64_t set = 0;  ///< Number of a set of answers; 0 = none was named.
};

/// Refusals and what is not there are bad input.
template <class Work>
void records(Work&& work) {
    as_input(std::forward<Work>(work), db::StoreError::Kind::kNotFound);
}

int lock(const Context& context, const StudyRecordOptions& options) {
    Session session = coordinator(context);
    records(
        [&] { as_input([&] { session.store().records().lock(options.study, options.code); }); });
    print(context, {{"participant", options.code}, {"locked", true}},
          "the record of " + options.code + " is locked");
    return 0;
}

int sign(const Context& context, const StudyRecordOptions& options) {
    Session session = coordinator(context);
    if (!session.user())
        throw InputError("study sign: expected --as USER; a signature is a person's");
    const std::string password =
        read_password("PLACODE_PASSWORD", "Password of " + session.actor() + ", again", false);
    records([&] {
        as_input([&] {
            session.store().records().sign(options.study, options.code, session.actor(), password,
                                           options.meaning);
        });
    });
    const auto state = session.store().records().states(options.study).at(options.code);
    print(context,
          {{"participant", options.code},
           {"signed_by", state.signature->name},
           {"meaning", state.signature->remark},
           {"at_utc", state.signature->at_utc},
           {"checksum", state.signature->checksum}},
          options.code + " signed by " + state.signature->name + ", " + state.signature->at_utc +
              ": " + state.signature->remark);
    return 0;
}

int unlock(const Context& context, const StudyRecordOptions& options) {
    Session session = coordinator(context);
    records([&] {
        as_input(
            [&] { session.store().records().unlock(options.study, options.code, options.reason); });
    });
    print(context, {{"participant", options.code}, {"locked", false}},
          "the record of " + options.code + " is unlocked; a signature is cancelled");
    return 0;
}

using Sets = std::vector<db::AnswerRecord>;

/// "3 (before, 2026-01-02T03:04:05.000Z), 7 (...)": number, step and time of each.
std::string list_of(Session& session, const StudyRecordOptions& options, const Sets& sets) {
    const auto steps = session.store().studies().steps(options.study);
    std::string list;
    for (const db::AnswerRecord& each : sets) {
        const auto step = std::ranges::find(steps, each.id, &db::StepRecord::answer_id);
        list += (list.empty() ? "" : ", ") + std::to_string(each.id) + " (" +
                (step == steps.end() ? "" : step->step + ", ") + each.answered_utc + ")";
    }
    return list;
}

/// What the participant answered to the questionnaire at that visit: a protocol may ask twice. The
/// set that --set names, else all. Throws InputError where there is none.
Sets sets_of(Session& session, const StudyRecordOptions& options) {
    Sets sets = session.store().studies().answers(options.study);
    std::erase_if(sets, [&](const db::AnswerRecord& each) {
        return each.participant != options.code || each.questionnaire_id != options.questionnaire ||
               each.visit != options.visit;
    });
    const std::string what =
        " answers to \"" + options.questionnaire + "\" at visit " + std::to_string(options.visit);
    if (sets.empty())
        throw InputError("study " + options.study + ": " + options.code + " has no" + what);
    if (options.set == 0) return sets;
    const auto named = std::ranges::find(sets, options.set, &db::AnswerRecord::id);
    if (named == sets.end())
        throw InputError("study " + options.study + ": set " + std::to_string(options.set) +
                         " is not among the" + what + " of " + options.code +
                         "; expected one of: " + list_of(session, options, sets));
    return {*named};
}

/// Throws InputError where there are several: nobody guesses which sheet was meant.
void need_one(Session& session, const StudyRecordOptions& options, const Sets& sets) {
    if (sets.size() == 1) return;
    throw InputError("study " + options.study + ": " + options.code + " has " +
                     std::to_string(sets.size()) + " sets of answers to \"" +
                     options.questionnaire + "\" at visit " + std::to_string(options.visit) +
                     "; name one with --set: " + list_of(session, options, sets));
}

db::AnswerRecord answers_of(Session& session, const StudyRecordOptions& options) {
    const Sets sets = sets_of(session, options);
    need_one(session, options, sets);
    return sets.front();
}

curriculum::Answers typed(const std::vector<std::string>& pairs) {
    curriculum::Answers answers;
    for (const std::string& pair : pairs) {
        const size_t at = pair.find('=');
        if (at == std::string::npos || at == 0)
            throw InputError("answer: found \"" + pair + "\"; expected ITEM=VALUE");
        answers[pair.substr(0, at)] = pair.substr(at + 1);
    }
    return answers;
}

int correct(const Context& context, const StudyRecordOptions& options) {
    Session session = coordinator(context);
    const auto record = answers_of(session, options);
    records([&] {
        session.store().records().correct_answers(record.id, 1, typed(options.answers),
                                                  options.reason);
    });
    print(context, {{"participant", options.code}, {"corrected", options.answers.size()}},
          options.code + ": corrected, the old answers are kept with the reason");
    return 0;
}

int second_entry(const Context& context, const StudyRecordOptions& options) {
    Session session = coordinator(context);
    const auto record = answers_of(session, options);
    as_input([&] {
        session.store().records().save_second_entry({record.id, typed(options.answers), {}, {}});
    });
    size_t differences = 0;
    for (const auto& each : db::entry_differences(session.store(), options.study))
        differences += each.answer_id == record.id ? 1 : 0;
    print(context, {{"participant", options.code}, {"differences", differences}},
          options.code + ": second entry saved, " + std::to_string(differences) + " differences");
    return 0;
}

int differences(const Context& context, const StudyRecordOptions& options) {
    Session session = coordinator(context);
    Json json = Json::array();
    std::vector<std::vector<std::string>> rows{{"code", "questionnaire", "visit", "answered",
                                                "item", "first", "second", "typed by", "set"}};
    for (const auto& each : db::entry_differences(session.store(), options.study)) {
        json.push_back({{"participant", each.participant},
                        {"questionnaire", each.questionnaire_id},
                        {"visit", each.visit},
                        {"answered_utc", each.answered_utc},
                        {"item", each.item},
                        {"first", each.first},
                        {"second", each.second},
                        {"entered_by", each.entered_by},
                        {"answers", each.answer_id}});
        rows.push_back({each.participant, each.questionnaire_id, std::to_string(each.visit),
                        each.answered_utc, each.item, each.first, each.second, each.entered_by,
                        std::to_string(each.answer_id)});
    }
    print(context, json, rows.size() == 1 ? "no differences" : table(rows));
    return 0;
}

int decide(const Context& context, const StudyRecordOptions& options) {
    Session session = coordinator(context);
    // Where one of several sets differs in the item, that one is meant.
    Sets sets = sets_of(session, options);
    auto open = db::entry_differences(session.store(), options.study);
    std::erase_if(open, [&](const db::EntryDifference& each) {
        return each.item != options.item ||
               std::ranges::find(sets, each.answer_id, &db::AnswerRecord::id) == sets.end();
    });
    if (open.empty())
        throw InputError("study decide: the entries of " + options.code +
                         " do not differ in item \"" + options.item +
                         "\"; see `placodectl study differences " + options.study + "`");
    std::erase_if(sets, [&](const db::AnswerRecord& each) {
        return std::ranges::find(open, each.id, &db::EntryDifference::answer_id) == open.end();
    });
    need_one(session, options, sets);
    records([&] {
        db::decide_difference(session.store(), open.front(), options.right, options.reason);
    });
    print(context, {{"participant", options.code}, {"item", options.item}},
          options.code + " " + options.item + ": entry " + std::to_string(options.right) +
              " is right");
    return 0;
}

}  // namespace

void add_study_record_commands(CLI::App& study, Context& context) {
    auto options = std::make_shared<StudyRecordOptions>();
    const auto add = [&](const char* name, const char* text,
                         int (*work)(const Context&, const StudyRecordOptions&), bool code = true,
                         bool form = false) {
        CLI::App* command = study.add_subcommand(name, text);
        command->add_option("STUDY", options->study, "Study id")->required();
        if (code)
            command->add_option("CODE", options->code, "Of the participant, e.g. P001-C")
                ->required();
        if (form) {
            command->add_option("QUESTIONNAIRE", options->questionnaire, "Its id")->required();
            command->add_option("--visit", options->visit, "Number of the visit")
                ->check(CLI::Range(1, 100));
            command->add_option("--set", options->set,
                                "Number of the set, where there are several at the visit");
        }
        command->callback([&context, options, work] {
            context.run = [&context, options, work] { return work(context, *options); };
        });
        return command;
    };
    add("lock", "Nothing more is recorded for the participant", lock);
    add("sign", "Signs a locked record; asks for the password again", sign)
        ->add_option("--meaning", options->meaning, "\"reviewed and complete\"")
        ->required();
    add("unlock", "Cancels lock and signature", unlock)
        ->add_option("--reason", options->reason, "Why; kept in the audit trail")
        ->required();
    const auto with_answers = [&](CLI::App* command) {
        command->add_option("ANSWERS", options->answers, "ITEM=VALUE ...")->required();
        return command;
    };
    with_answers(add("correct", "Changes answers for a reason", correct, true, true))
        ->add_option("--reason", options->reason, "Why; kept in the audit trail")
        ->required();
    with_answers(add("second-entry", "The same sheet typed again", second_entry, true, true));
    add("differences", "Where the two entries differ", differences, false);
    CLI::App* decide_command =
        add("decide", "Which entry says what the sheet says", decide, true, true);
    decide_command->add_option("ITEM", options->item, "Id of the item that differs")->required();
    decide_command->add_option("--right", options->right, "1 or 2")
        ->required()
        ->check(CLI::Range(1, 2));
    decide_command->add_option("--reason", options->reason, "Why; kept in the audit trail")
        ->required();
}

}  // namespace placode::cli
