// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the commands of studies and questionnaires share.

#include <memory>
#include <string>
#include <vector>

#include "curriculum/study.h"
#include "ui/cli/session.h"

namespace placode::cli {

struct StudyOptions {
    std::string id, code, step, questionnaire, file, reason, mode, state = "done", language = "en";
    std::vector<std::string> answers, agreed;
    int64_t attempt = 0;
    int visit = 1, version = 0;
    bool demonstration = false, consented = false;
};

/// Throws for who may not run questionnaires.
[[nodiscard]] Session coordinator(const Context& context, Missing missing = Missing::kRefuse);
/// The code; throws InputError when its check letter does not fit.
std::string need_code(const std::string& code);
/// The published version, else the shipped one, else the file.
[[nodiscard]] curriculum::Questionnaire questionnaire_named(Session& session,
                                                            const std::string& id);
/// Of the consent that the participant is asked for; none without a protocol.
[[nodiscard]] std::vector<std::string> required_statements(Session& session,
                                                           const std::string& study,
                                                           const std::string& code);

// study_commands.cpp
/// Where the data of who was just erased may still be, a line each; into `left` for programs.
[[nodiscard]] std::string copies_left(const Context& context, Json& left);

// study_definition_commands.cpp
/// list, show, publish of a kind of definition: "study" or "questionnaire".
void add_definition_commands(CLI::App& group, Context& context, const std::string& kind,
                             const std::shared_ptr<StudyOptions>& options);

// study_answer_commands.cpp
int study_answer(const Context& context, const StudyOptions& options);
int study_import(const Context& context, const StudyOptions& options);
int study_demo(const Context& context);

}  // namespace placode::cli
