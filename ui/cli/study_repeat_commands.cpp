// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl study repeat | note | deviations

#include <memory>

#include "db/study_deviations.h"
#include "db/study_records.h"
#include "reports/words.h"
#include "ui/cli/study_options.h"
#include "ui/cli/study_records.h"

namespace placode::cli {
namespace {

struct StudyRepeatOptions {
    std::string study, code, step, reason, note;
    int visit = 1;
};

/// Refusals and what is not there are bad input.
template <class Work>
void as_records(Work&& work) {
    as_input([&] { as_input(std::forward<Work>(work), db::StoreError::Kind::kNotFound); });
}

int repeat(const Context& context, const StudyRepeatOptions& options) {
    Session session = coordinator(context);
    as_records([&] {
        session.store().records().repeat_step(options.study, need_code(options.code), options.visit,
                                              options.step, options.reason);
    });
    print(context,
          {{"participant", options.code}, {"step", options.step}, {"visit", options.visit}},
          options.code + ": " + options.step +
              " is to be done again; what was recorded is kept and marked");
    return 0;
}

int note(const Context& context, const StudyRepeatOptions& options) {
    Session session = coordinator(context);
    as_records([&] {
        session.store().records().note_step(options.study, need_code(options.code), options.visit,
                                            options.step, options.note);
    });
    print(context, {{"participant", options.code}, {"step", options.step}},
          options.code + ": noted on " + options.step);
    return 0;
}

int deviations(const Context& context, const StudyRepeatOptions& options) {
    Session session = coordinator(context);
    Json json = Json::array();
    std::vector<std::vector<std::string>> rows{
        {"code", "visit", "step", "kind", "attempt", "what happened"}};
    for (const auto& each : db::study_deviations(session.store(), options.study, options.code)) {
        const std::string what =
            reports::deviation_words(each, reports::Language::kEnglish).toStdString();
        json.push_back({{"participant", each.participant},
                        {"visit", each.visit},
                        {"step", each.step},
                        {"kind", db::deviation_name(each.kind)},
                        {"attempt", each.attempt_id},
                        {"at_utc", each.at_utc},
                        {"what", what}});
        rows.push_back({each.participant, std::to_string(each.visit), each.step,
                        db::deviation_name(each.kind),
                        each.attempt_id == 0 ? "" : std::to_string(each.attempt_id), what});
    }
    print(context, json, rows.size() == 1 ? "no deviations" : table(rows));
    return 0;
}

}  // namespace

void add_study_repeat_commands(CLI::App& study, Context& context) {
    auto options = std::make_shared<StudyRepeatOptions>();
    const auto add = [&](const char* name, const char* text,
                         int (*work)(const Context&, const StudyRepeatOptions&)) {
        CLI::App* command = study.add_subcommand(name, text);
        command->add_option("STUDY", options->study, "Study id")->required();
        command->callback([&context, options, work] {
            context.run = [&context, options, work] { return work(context, *options); };
        });
        return command;
    };
    const auto with_step = [&](CLI::App* command) {
        command->add_option("CODE", options->code, "Of the participant, e.g. P001-C")->required();
        command->add_option("STEP", options->step, "Id in the protocol")->required();
        command->add_option("--visit", options->visit, "Number of the visit, from 1")
            ->check(CLI::Range(1, 100));
        return command;
    };
    with_step(add("repeat", "Has a procedure that went wrong done again; both are kept", repeat))
        ->add_option("--reason", options->reason, "Why, e.g. \"the foot pedal was unplugged\"")
        ->required();
    with_step(add("note", "Notes something on a step", note))
        ->add_option("TEXT", options->note, "What is noted")
        ->required();
    add("deviations", "Where it did not go as the protocol says", deviations)
        ->add_option("--participant", options->code, "Of this code only");
}

}  // namespace placode::cli
