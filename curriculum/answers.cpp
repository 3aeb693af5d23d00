// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Answers to a questionnaire: are they complete and possible, and which scores follow.

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <set>

#include "curriculum/questionnaire.h"
#include "sim/core/number_text.h"

namespace placode::curriculum {

namespace {

using sim::Said;
using Problem = std::optional<Said>;

Problem check_number(const std::string& answer, double low, double high, bool whole) {
    const std::optional<double> value = answer_number(answer);
    if (!value) return Said::that("\"%1\" is not a number").with(answer);
    if (whole && *value != std::floor(*value))
        return Said::that("%1 is not a whole number").with(answer);
    if (*value < low)
        return Said::that("%1 is below %2").with(answer).with(sim::shortest_text(low));
    if (*value > high)
        return Said::that("%1 is above %2").with(answer).with(sim::shortest_text(high));
    return std::nullopt;
}

Problem check_multiple(const std::string& answer, size_t choices) {
    const auto indices = answer_indices(answer);
    if (!indices) return Said::that("\"%1\" is not a list of choices such as \"0;2\"").with(answer);
    for (size_t i = 0; i < indices->size(); ++i) {
        if ((*indices)[i] >= static_cast<int>(choices))
            return Said::that("%1 is above %2")
                .with((*indices)[i])
                .with(static_cast<int64_t>(choices) - 1);
        if (i > 0 && (*indices)[i] <= (*indices)[i - 1])
            return Said::that("\"%1\" names its choices twice or not in order").with(answer);
    }
    return std::nullopt;
}

Problem check_date(const std::string& answer) {
    const Said problem = Said::that("\"%1\" is not a date such as 2026-11-21").with(answer);
    if (answer.size() != 10 || answer[4] != '-' || answer[7] != '-') return problem;
    int parts[3] = {};
    constexpr size_t kBegin[3] = {0, 5, 8}, kLength[3] = {4, 2, 2};
    for (int i = 0; i < 3; ++i) {
        const char* begin = answer.data() + kBegin[i];
        const auto [end, error] = std::from_chars(begin, begin + kLength[i], parts[i]);
        if (error != std::errc() || end != begin + kLength[i]) return problem;
    }
    const std::chrono::year_month_day date{std::chrono::year(parts[0]),
                                           std::chrono::month(static_cast<unsigned>(parts[1])),
                                           std::chrono::day(static_cast<unsigned>(parts[2]))};
    return date.ok() ? std::nullopt : Problem(problem);
}

double lowest(const QuestionnaireItem& item) {
    return item.kind == ItemKind::kLikert ? item.scale_min : item.number_min;
}
double highest(const QuestionnaireItem& item) {
    return item.kind == ItemKind::kLikert ? item.scale_max : item.number_max;
}

}  // namespace

std::optional<Said> check_answer(const QuestionnaireItem& item, const std::string& answer) {
    if (answer == kNotApplicable && item.kind != ItemKind::kText)
        return item.not_applicable ? std::nullopt
                                   : Problem(Said::that("\"NA\" is not offered here"));
    switch (item.kind) {
        case ItemKind::kLikert:
            return check_number(answer, item.scale_min, item.scale_max, true);
        case ItemKind::kNumber:
        case ItemKind::kVisualAnalogue:
            return check_number(answer, item.number_min, item.number_max, false);
        case ItemKind::kChoice:
            return check_number(answer, 0, static_cast<double>(item.choices.size()) - 1, true);
        case ItemKind::kMultiple:
            return check_multiple(answer, item.choices.size());
        case ItemKind::kDate:
            return check_date(answer);
        case ItemKind::kText:
            break;
    }
    return std::nullopt;
}

std::optional<double> answer_number(const std::string& answer) {
    double value = 0;
    const auto [end, error] = std::from_chars(answer.data(), answer.data() + answer.size(), value);
    if (error != std::errc() || end != answer.data() + answer.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

std::optional<std::vector<int>> answer_indices(const std::string& answer) {
    std::vector<int> indices;
    const char* at = answer.data();
    const char* const last = at + answer.size();
    while (true) {
        int index = 0;
        const auto [end, error] = std::from_chars(at, last, index);
        if (error != std::errc() || index < 0) return std::nullopt;
        indices.push_back(index);
        if (end == last) return indices;
        if (*end != ';') return std::nullopt;
        at = end + 1;
    }
}

std::string question_mark(const Questionnaire& questionnaire, const QuestionnaireItem& item,
                          const Answers* answers) {
    const auto lettered = [](const QuestionnaireItem& each) { return each.id.size() <= 2; };
    if (lettered(item)) return item.id;
    int place = 0;
    for (const QuestionnaireItem& each : questionnaire.items) {
        const bool seen = answers == nullptr || is_shown(questionnaire, each, *answers);
        place += !lettered(each) && seen ? 1 : 0;
        if (&each == &item) break;
    }
    return std::to_string(place);
}

bool is_shown(const Questionnaire& questionnaire, const QuestionnaireItem& item,
              const Answers& answers) {
    if (!item.show_if) return true;
    const QuestionnaireItem* asked = questionnaire.item(item.show_if->item);
    // What hides the question hides all that hang on it.
    if (asked == nullptr || !is_shown(questionnaire, *asked, answers)) return false;
    const auto found = answers.find(item.show_if->item);
    if (found == answers.end()) return false;
    const auto& wanted = item.show_if->any_of;
    const auto is_wanted = [&](const std::string& answer) {
        return std::find(wanted.begin(), wanted.end(), answer) != wanted.end();
    };
    if (asked->kind != ItemKind::kMultiple) return is_wanted(found->second);
    const auto indices = answer_indices(found->second);
    return indices && std::any_of(indices->begin(), indices->end(),
                                  [&](int index) { return is_wanted(std::to_string(index)); });
}

std::optional<Said> check_answers(const Questionnaire& questionnaire, const Answers& answers) {
    std::set<std::string> known;
    for (const QuestionnaireItem& item : questionnaire.items) {
        known.insert(item.id);
        const auto found = answers.find(item.id);
        const bool given = found != answers.end() && !found->second.empty();
        if (!is_shown(questionnaire, item, answers)) {
            if (given)
                return Said::that("item %1 is answered, but hidden by the answer to item %2")
                    .with(item.id)
                    .with(item.show_if->item);
            continue;
        }
        if (!given) {
            if (item.required) return Said::that("item %1 needs an answer").with(item.id);
            continue;
        }
        if (const auto problem = check_answer(item, found->second))
            return Said::that("item %1: %2").with(item.id).with(*problem);
    }
    for (const auto& [id, unused] : answers) {
        if (!known.contains(id))
            return Said::that("item %1 is not part of questionnaire %2")
                .with(id)
                .with(questionnaire.id);
    }
    return std::nullopt;
}

std::vector<ScaleValue> scale_scores(const Questionnaire& questionnaire, const Answers& answers) {
    std::vector<ScaleValue> scores;
    for (const ScaleScore& scale : questionnaire.scales) {
        ScaleValue score{scale.id, 0, std::nullopt};
        double sum = 0;
        for (const std::string& name : scale.items) {
            const QuestionnaireItem* item = questionnaire.item(name);
            const auto found = answers.find(name);
            if (item == nullptr || found == answers.end()) continue;
            const std::optional<double> value = answer_number(found->second);
            if (!value) continue;
            ++score.answered;
            sum += item->reverse ? lowest(*item) + highest(*item) - *value : *value;
        }
        const int needed = scale.minimum_answered > 0 ? scale.minimum_answered
                                                      : static_cast<int>(scale.items.size());
        if (score.answered >= needed && score.answered > 0) {
            // A sum over fewer items than there are would be too small: take the mean, scaled up.
            const double mean = sum / score.answered;
            const double raw = scale.mean ? mean : mean * static_cast<double>(scale.items.size());
            score.value = scale.factor * raw + scale.offset;
        }
        scores.push_back(score);
    }
    return scores;
}

}  // namespace placode::curriculum
