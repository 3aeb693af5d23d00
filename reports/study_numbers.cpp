// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/study_numbers.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "reports/analysis_parts.h"

namespace placode::reports {
namespace {

constexpr int kSmall = 30;  ///< Below: figures are shown with a caution.

/// First answers of everybody: repeated ones are not independent.
std::vector<const Row*> first_rows(const Form& form) {
    std::vector<const Row*> rows;
    for (const Row& row : form.rows)
        if (row.instance == 1) rows.push_back(&row);
    return rows;
}

ItemNumbers item_numbers(const Form& form, const Field& field) {
    ItemNumbers item;
    item.field = &field;
    std::vector<std::optional<int>> answers;
    std::vector<double> values;
    for (const Row* row : first_rows(form)) {
        if (row->not_asked.contains(field.id)) continue;
        const auto found = row->values.find(field.id);
        if (found != row->values.end() && found->second == curriculum::kNotApplicable)
            ++item.not_applicable;
        const auto value = value_of(*row, field.id);
        answers.push_back(value ? std::optional(static_cast<int>(*value)) : std::nullopt);
        if (value) values.push_back(*value);
    }
    item.summary =
        assessment::summarise_likert(answers, field.codes.front().value, field.codes.back().value);
    item.mean_ci95 = assessment::mean_interval(values);
    if (item.summary.n > 0)
        item.top2_ci95 = assessment::wilson_interval(item.summary.top2, item.summary.n);
    return item;
}

NumberNumbers number_numbers(const Form& form, const Field& field) {
    NumberNumbers result;
    result.field = &field;
    for (const Row* row : first_rows(form)) {
        if (const auto value = value_of(*row, field.id))
            result.values.push_back(*value);
        else if (!row->not_asked.contains(field.id))
            ++result.missing;
    }
    result.mean = assessment::mean_of(result.values);
    result.sd = assessment::sample_sd(result.values);
    result.mean_ci95 = assessment::mean_interval(result.values);
    return result;
}

ChoiceNumbers choice_numbers(const Form& form, const Field& field) {
    ChoiceNumbers result;
    result.field = &field;
    result.counts.assign(field.codes.size(), 0);
    for (const Row* row : first_rows(form)) {
        const auto found = row->values.find(field.id);
        const auto chosen =
            found == row->values.end() ? std::nullopt : curriculum::answer_indices(found->second);
        if (!chosen) {
            if (!row->not_asked.contains(field.id)) ++result.missing;
            continue;
        }
        ++result.n;
        for (size_t i = 0; i < field.codes.size(); ++i)
            result.counts[i] +=
                std::count(chosen->begin(), chosen->end(), field.codes[i].value) > 0;
    }
    return result;
}

AlphaNumbers alpha_numbers(const Form& form, const curriculum::Questionnaire& instrument,
                           const curriculum::ScaleScore& scale) {
    AlphaNumbers result;
    result.scale = form.field(scale.id);
    assessment::Scores scores;
    for (const Row* row : first_rows(form)) {
        std::vector<double> line;
        for (const std::string& id : scale.items) {
            const auto* item = instrument.item(id);
            const auto value = value_of(*row, id);
            if (item == nullptr || !value) break;
            const bool likert = item->kind == curriculum::ItemKind::kLikert;
            line.push_back(item->reverse ? assessment::reversed(
                                               *value, likert ? item->scale_min : item->number_min,
                                               likert ? item->scale_max : item->number_max)
                                         : *value);
        }
        if (line.size() == scale.items.size())
            scores.push_back(line);
        else
            ++result.left_out;
    }
    result.complete = static_cast<int>(scores.size());
    try {
        result.alpha = assessment::cronbach_alpha(scores);
    } catch (const std::invalid_argument& error) {
        result.problem = error.what();
    }
    return result;
}

/// The first yes-or-no question with at least three people on each side.
std::optional<GroupComparison> comparison_of(const Dataset& data) {
    for (const Form& groups : data.forms) {
        for (const Field& by : groups.fields) {
            if (by.kind != FieldKind::kCode || by.ordinal || by.codes.size() != 2) continue;
            if (!is_questionnaire(groups) && by.id != "arm") continue;
            std::map<std::string, int> group_of;
            for (const Row* row : first_rows(groups))
                if (const auto value = value_of(*row, by.id))
                    group_of[row->participant] = static_cast<int>(*value);
            const auto size_of = [&](int code) {
                return std::count_if(group_of.begin(), group_of.end(),
                                     [&](const auto& entry) { return entry.second == code; });
            };
            if (size_of(by.codes[0].value) < 3 || size_of(by.codes[1].value) < 3) continue;
            for (const Form& form : data.forms) {
                if (&form == &groups) continue;
                GroupComparison comparison;
                comparison.form = &form;
                comparison.by = &by;
                comparison.group1 = by.codes[1].label;
                comparison.group2 = by.codes[0].label;
                std::vector<double> p_values;
                for (const Field& field : form.fields) {
                    if (!field.ordinal) continue;
                    std::vector<double> first, second;
                    for (const Row* row : first_rows(form)) {
                        const auto group = group_of.find(row->participant);
                        const auto value = value_of(*row, field.id);
                        if (group == group_of.end() || !value) continue;
                        (group->second == by.codes[1].value ? first : second).push_back(*value);
                    }
                    if (first.size() < 3 || second.size() < 3) continue;
                    comparison.n1 = std::max(comparison.n1, static_cast<int>(first.size()));
                    comparison.n2 = std::max(comparison.n2, static_cast<int>(second.size()));
                    GroupComparison::Row row;
                    row.field = &field;
                    row.delta = assessment::cliffs_delta(first, second);
                    const auto test = assessment::mann_whitney(first, second);
                    row.p = test.p_exact.value_or(test.p_asymptotic_cc);
                    row.exact = test.p_exact.has_value();
                    p_values.push_back(row.p);
                    comparison.rows.push_back(row);
                }
                if (comparison.rows.empty()) continue;
                const auto holm = assessment::holm_adjusted(p_values);
                for (size_t i = 0; i < holm.size(); ++i) comparison.rows[i].p_holm = holm[i];
                const double orders =
                    std::exp(std::lgamma(comparison.n1 + comparison.n2 + 1) -
                             std::lgamma(comparison.n1 + 1) - std::lgamma(comparison.n2 + 1));
                comparison.least_p = std::min(1.0, 2 / orders);
                return comparison;
            }
        }
    }
    return std::nullopt;
}

/// Of forms that few have answered, however many were enrolled.
void add_cautions_of_few(StudyNumbers& numbers) {
    std::map<int, std::string> few;  // by the number of first answers
    for (const FormNumbers& form : numbers.forms) {
        const auto n = static_cast<int>(first_rows(*form.form).size());
        if (n == 0 || n >= kSmall) continue;
        few[n] += (few[n].empty() ? "" : ", ") + form.form->name;
    }
    for (const auto& [n, forms] : few) {
        const auto wide = assessment::wilson_interval((6 * n + 3) / 7, n);
        numbers.cautions.push_back(
            "n = " + std::to_string(n) + " (" + forms + "): a share of " +
            std::to_string((6 * n + 3) / 7) + "/" + std::to_string(n) +
            " has a 95 % interval from " +
            std::to_string(static_cast<int>(std::lround(100 * wide.low))) + " % to " +
            std::to_string(static_cast<int>(std::lround(100 * wide.high))) +
            " %. Differences between items smaller than the intervals are not established.");
    }
    if (few.empty()) return;
    numbers.cautions.push_back(
        "Student's intervals of means treat the answers as numbers from a normal "
        "distribution; on a scale of a few points and a small sample they are approximate. The "
        "median and the counts need no such assumption.");
    numbers.cautions.push_back(
        "McDonald's omega, factor structure and measurement invariance are not reported: "
        "fewer than 30 respondents cannot carry them. Cronbach's alpha is shown with its "
        "interval and must be read with it.");
}

void add_cautions(StudyNumbers& numbers, const Dataset& data) {
    if (data.demonstration)
        numbers.cautions.push_back(
            "The data are simulated (demonstration): they show what the report looks like and "
            "say nothing about the simulator.");
    add_cautions_of_few(numbers);
    for (const FormNumbers& form : numbers.forms)
        for (const ItemNumbers& item : form.items)
            if (item.summary.n > 0 && item.summary.sd && *item.summary.sd == 0)
                numbers.cautions.push_back("Item " + item.field->id +
                                           ": all answers are equal; no statistic of spread or "
                                           "agreement can be computed.");
    if (numbers.comparison) {
        const GroupComparison& c = *numbers.comparison;
        numbers.cautions.push_back(
            "The comparison of groups is exploratory: with " + std::to_string(c.n1) + " and " +
            std::to_string(c.n2) +
            " people only large effects can show, and a result that is not significant is no "
            "evidence of equality.");
        for (const auto& row : c.rows)
            if (row.delta.separated)
                numbers.cautions.push_back(
                    "Item " + row.field->id +
                    ": DeLong's variance is 0 (the groups do not overlap, or "
                    "nobody differs); there is no interval.");
    }
    if (data.participants_left_out > 0)
        numbers.cautions.push_back(std::to_string(data.participants_left_out) +
                                   " participant(s) withdrew the use of their data and are in no "
                                   "figure and no table.");
}

}  // namespace

size_t GroupComparison::exact_rows() const {
    return static_cast<size_t>(
        std::count_if(rows.begin(), rows.end(), [](const Row& row) { return row.exact; }));
}

std::string mann_whitney_words(size_t exact, size_t all) {
    if (exact == all) return "the exact Mann-Whitney test";
    return std::string("the Mann-Whitney test (") +
           (exact > 0 ? "exact up to 60 people, else " : "") +
           "normal approximation with continuity correction)";
}

StudyNumbers study_numbers(const Dataset& data,
                           const std::vector<curriculum::Questionnaire>& instruments) {
    StudyNumbers numbers;
    for (const Form& form : data.forms) {
        if (!is_questionnaire(form)) continue;
        FormNumbers result;
        result.form = &form;
        for (const Field& field : form.fields) {
            if (field.ordinal)
                result.items.push_back(item_numbers(form, field));
            else if (field.kind == FieldKind::kDecimal)
                result.numbers.push_back(number_numbers(form, field));
            else if (field.kind == FieldKind::kCode || field.kind == FieldKind::kMultiple)
                result.choices.push_back(choice_numbers(form, field));
        }
        for (const auto& instrument : instruments)
            if (instrument.id == form.id && instrument.version == form.version)
                for (const auto& scale : instrument.scales)
                    result.alphas.push_back(alpha_numbers(form, instrument, scale));
        numbers.forms.push_back(std::move(result));
    }
    numbers.comparison = comparison_of(data);
    add_cautions(numbers, data);
    return numbers;
}

}  // namespace placode::reports
