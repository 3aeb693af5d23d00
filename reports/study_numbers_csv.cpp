// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Every number of the report in one table, so that another program can be held against it:
// scripts/study_report.R computes the same from the exported CSV.

#include "reports/csv_table.h"
#include "reports/study_numbers.h"
#include "reports/text.h"

namespace placode::reports {
namespace {

/// Rows "form,field,statistic,value"; what cannot be computed is left out.
class Table {
 public:
    void begin(const Form& form) { form_ = form.name; }
    void add(const std::string& field, const std::string& statistic, double value) {
        text_ += csv_line({form_, field, statistic, shortest_text(value)});
    }
    void add(const std::string& field, const std::string& statistic, std::optional<double> value) {
        if (value) add(field, statistic, *value);
    }
    void add(const std::string& field, const std::string& statistic,
             const std::optional<assessment::Interval>& interval) {
        if (!interval) return;
        add(field, statistic + "_low", interval->low);
        add(field, statistic + "_high", interval->high);
    }
    [[nodiscard]] std::string text() const { return "form,field,statistic,value\n" + text_; }

 private:
    std::string form_, text_;
};

void add_item(Table& table, const ItemNumbers& item) {
    const std::string& id = item.field->id;
    const auto& s = item.summary;
    table.add(id, "n", static_cast<double>(s.n));
    table.add(id, "missing", static_cast<double>(s.missing));
    if (s.n == 0) return;
    table.add(id, "mean", s.mean);
    table.add(id, "sd", s.sd);
    table.add(id, "mean_ci95", item.mean_ci95);
    table.add(id, "median", s.median);
    table.add(id, "q1", s.lower_quartile);
    table.add(id, "q3", s.upper_quartile);
    table.add(id, "top2", static_cast<double>(s.top2));
    table.add(id, "top2_ci95", std::optional(item.top2_ci95));
}

void add_number(Table& table, const NumberNumbers& each) {
    const std::string& id = each.field->id;
    table.add(id, "n", static_cast<double>(each.values.size()));
    table.add(id, "mean", each.mean);
    table.add(id, "sd", each.sd);
    table.add(id, "mean_ci95", each.mean_ci95);
}

void add_comparison(Table& table, const GroupComparison& comparison) {
    table.begin(*comparison.form);
    for (const auto& row : comparison.rows) {
        table.add(row.field->id, "delta", row.delta.delta);
        if (!row.delta.separated)
            table.add(row.field->id, "delta_ci95", std::optional(row.delta.ci95));
        table.add(row.field->id, row.exact ? "p_exact" : "p_normal", row.p);
        table.add(row.field->id, "p_holm", row.p_holm);
    }
}

}  // namespace

std::string study_numbers_csv(const StudyNumbers& numbers) {
    Table table;
    for (const FormNumbers& form : numbers.forms) {
        table.begin(*form.form);
        for (const ItemNumbers& item : form.items) add_item(table, item);
        for (const NumberNumbers& each : form.numbers) add_number(table, each);
        for (const ChoiceNumbers& each : form.choices) {
            table.add(each.field->id, "n", static_cast<double>(each.n));
            for (size_t i = 0; i < each.counts.size(); ++i)
                table.add(each.field->id, "count_" + std::to_string(each.field->codes[i].value),
                          static_cast<double>(each.counts[i]));
        }
        for (const AlphaNumbers& each : form.alphas) {
            if (!each.alpha || each.scale == nullptr) continue;
            table.add(each.scale->id, "alpha", each.alpha->raw);
            table.add(each.scale->id, "alpha_ci95", std::optional(each.alpha->feldt_ci95));
        }
    }
    if (numbers.comparison) add_comparison(table, *numbers.comparison);
    return table.text();
}

}  // namespace placode::reports
