// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A questionnaire: versioned items, worded as they are shown.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "curriculum/task.h"

namespace placode::curriculum {

enum class ItemKind : uint8_t { kLikert, kNumber, kChoice, kText };

struct QuestionnaireItem {
    std::string id;  ///< "A"
    ItemKind kind = ItemKind::kLikert;
    LocalText text;
    int scale_min = 1, scale_max = 5;   ///< Likert.
    LocalText anchor_low, anchor_high;  ///< Likert.
    std::vector<LocalText> choices;     ///< Choice: the answer is the index from 0.
    double number_min = 0, number_max = 0;
    std::string unit;
    bool required = true;
};

struct Questionnaire {
    std::string id;
    int version = 1;
    LocalText title, introduction;
    std::vector<QuestionnaireItem> items;
};

/// Item id to answer; an unanswered item is absent. Numbers are written with '.'.
using Answers = std::map<std::string, std::string>;

[[nodiscard]] Questionnaire load_questionnaire(const std::string& id_or_file);

/// First problem in plain words ("item C needs an answer", "item age: 190 is above 120"), or
/// nothing.
[[nodiscard]] std::optional<std::string> check_answers(const Questionnaire& questionnaire,
                                                       const Answers& answers);

}  // namespace placode::curriculum
