// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A questionnaire: versioned items, worded as they are shown. A version that was used is never
// edited: the store keeps its text, and every answer names the version.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "curriculum/task.h"
#include "sim/core/said.h"

namespace placode::curriculum {

enum class ItemKind : uint8_t {
    kLikert,          ///< Whole number from scale_min to scale_max.
    kNumber,          ///< Decimal number with unit and limits.
    kChoice,          ///< Index of one choice, from 0.
    kText,            ///< Free text.
    kMultiple,        ///< Indices of the choices that apply, ascending: "0;2".
    kDate,            ///< "2026-11-21".
    kVisualAnalogue,  ///< Decimal number from number_min to number_max on an unmarked line.
};

/// The answer of who says that the item does not apply; only where the item allows it.
inline constexpr const char* kNotApplicable = "NA";

/// An item is shown when the answer to an earlier item is one of these.
struct ShowIf {
    std::string item;
    std::vector<std::string> any_of;
};

struct QuestionnaireItem {
    std::string id;  ///< "A"
    ItemKind kind = ItemKind::kLikert;
    LocalText text;
    int scale_min = 1, scale_max = 5;       ///< Likert.
    LocalText anchor_low, anchor_high;      ///< Likert and visual analogue.
    std::vector<LocalText> point_labels;    ///< Likert: one for each value, or none.
    std::vector<LocalText> choices;         ///< Choice and multiple: the answer is an index from 0.
    double number_min = 0, number_max = 0;  ///< Number and visual analogue.
    std::string unit;                       ///< Number.
    bool required = true;
    bool not_applicable = false;  ///< "Does not apply" may be answered.
    bool reverse = false;         ///< Turned round in scale scores (Likert).
    bool identifying = false;     ///< Names a person: leaves only with permission.
    std::string section;          ///< Id of the section; empty = none.
    std::optional<ShowIf> show_if;
};

struct Section {
    std::string id;
    LocalText title, introduction;
};

/// A score over several items: factor * (sum or mean of the items, reverse-keyed first) + offset.
struct ScaleScore {
    std::string id;
    LocalText title;
    std::vector<std::string> items;
    bool mean = true;  ///< Else the sum.
    double factor = 1, offset = 0;
    int minimum_answered = 0;  ///< Fewer answers: no score. 0 = all of them.
};

struct Questionnaire {
    std::string id;
    int version = 1;
    LocalText title, introduction;
    std::string source, licence;  ///< Whose wording, and on which terms.
    std::vector<Section> sections;
    std::vector<QuestionnaireItem> items;
    std::vector<ScaleScore> scales;
    std::string json;  ///< The text it was read from, for the store.

    [[nodiscard]] const QuestionnaireItem* item(const std::string& item_id) const;
};

/// Item id to answer; an unanswered item is absent. Numbers are written with '.'.
using Answers = std::map<std::string, std::string>;

[[nodiscard]] Questionnaire load_questionnaire(const std::string& id_or_file);
/// From the text that a store keeps. `origin` is used in messages. Throws DefinitionError.
[[nodiscard]] Questionnaire load_questionnaire_text(const std::string& json,
                                                    const std::string& origin);

/// False when branching hides the item from somebody with these answers.
[[nodiscard]] bool is_shown(const Questionnaire& questionnaire, const QuestionnaireItem& item,
                            const Answers& answers);
/// How people call the question: "A" where an instrument letters its items as it was printed, else
/// its place among the unlettered ones. With `answers`, only those that are shown are counted.
[[nodiscard]] std::string question_mark(const Questionnaire& questionnaire,
                                        const QuestionnaireItem& item,
                                        const Answers* answers = nullptr);

/// What is wrong with one answer that is given ("190 is above 120"), or nothing.
[[nodiscard]] std::optional<sim::Said> check_answer(const QuestionnaireItem& item,
                                                    const std::string& answer);

/// First problem ("item C needs an answer", "item age: 190 is above 120"), or nothing.
[[nodiscard]] std::optional<sim::Said> check_answers(const Questionnaire& questionnaire,
                                                     const Answers& answers);

/// The whole answer as a number, '.' decimals in every locale; nothing for "NA" and text.
[[nodiscard]] std::optional<double> answer_number(const std::string& answer);
/// Indices in "0;2"; nothing when it is not such a list.
[[nodiscard]] std::optional<std::vector<int>> answer_indices(const std::string& answer);

struct ScaleValue {
    std::string id;
    int answered = 0;             ///< Items with a number.
    std::optional<double> value;  ///< Absent when too few were answered.
};
/// All scores of one set of answers, in the order of the questionnaire.
[[nodiscard]] std::vector<ScaleValue> scale_scores(const Questionnaire& questionnaire,
                                                   const Answers& answers);

}  // namespace placode::curriculum
