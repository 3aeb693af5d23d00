// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of a study: choices, items, scales, comparison of groups.

#include <algorithm>

#include "reports/analysis_parts.h"
#include "reports/study_report_parts.h"
#include "reports/text.h"

namespace placode::reports {
namespace {

QString interval(const assessment::Interval& range, int decimals, double factor = 1) {
    return number(factor * range.low, decimals) + " to " + number(factor * range.high, decimals);
}

QString p_text(double p) { return p < 0.001 ? QStringLiteral("&lt; 0.001") : number(p, 3); }

}  // namespace

void write_choices(Paper& paper, const FormNumbers& form) {
    std::vector<QStringList> rows;
    for (const NumberNumbers& each : form.numbers) {
        if (each.field->derived || each.values.empty()) continue;
        std::vector<double> sorted = each.values;
        std::sort(sorted.begin(), sorted.end());
        rows.push_back({safe(each.field->label) +
                            (each.field->unit.empty() ? "" : " [" + safe(each.field->unit) + "]"),
                        "mean (SD); least to greatest",
                        number(*each.mean, 1) + " (" + (each.sd ? number(*each.sd, 1) : "-") +
                            "); " + number(sorted.front(), 1) + " to " + number(sorted.back(), 1),
                        QString::number(each.values.size()), QString::number(each.missing)});
    }
    for (const ChoiceNumbers& each : form.choices) {
        for (size_t i = 0; i < each.counts.size(); ++i) {
            if (each.counts[i] == 0) continue;
            rows.push_back({i == 0 || rows.empty() || rows.back()[0] != safe(each.field->label)
                                ? safe(each.field->label)
                                : QString(),
                            safe(each.field->codes[i].label),
                            QString("%1 (%2 %)")
                                .arg(each.counts[i])
                                .arg(number(100.0 * each.counts[i] / std::max(1, each.n), 1)),
                            QString::number(each.n), QString::number(each.missing)});
        }
    }
    if (rows.empty()) return;
    QString last;  // The question stands once, before its first answer.
    for (QStringList& row : rows) {
        const QString own = row[0];
        if (!own.isEmpty() && own == last) row[0].clear();
        if (!own.isEmpty()) last = own;
    }
    paper.table(safe(form.form->title) + ": participants' characteristics and choices.",
                {"question", "answer", "value", "n", "missing"}, "llrrr", rows);
}

void write_items(Paper& paper, const FormNumbers& form) {
    if (form.items.empty()) return;
    std::vector<QStringList> rows;
    for (const ItemNumbers& item : form.items) {
        const auto& s = item.summary;
        if (s.n == 0) {
            rows.push_back({safe(item_label(*item.field)), "0", QString::number(s.missing), "-",
                            "-", "-", "-"});
            continue;
        }
        rows.push_back({safe(item_label(*item.field)), QString::number(s.n),
                        QString::number(s.missing),
                        number(*s.mean, 2) + (s.sd ? " (" + number(*s.sd, 2) + ")" : QString()),
                        item.mean_ci95 ? interval(*item.mean_ci95, 2) : QStringLiteral("-"),
                        number(*s.median, 1) + " [" + number(*s.lower_quartile, 1) + " - " +
                            number(*s.upper_quartile, 1) + "]",
                        QString("%1 (%2 %; %3)")
                            .arg(s.top2)
                            .arg(number(*s.top2_percent, 1), interval(item.top2_ci95, 0, 100))});
    }
    paper.table(safe(form.form->title) +
                    ": mean (sample SD) with Student's 95 % interval, median [quartiles, type 7], "
                    "top-2 answers (share; Wilson's 95 % interval, %). Missing counts unanswered "
                    "and not applicable.",
                {"item", "n", "missing", "mean (SD)", "95 % interval", "median [Q1 - Q3]", "top-2"},
                "lrrrrrr", rows);
}

void write_scales(Paper& paper, const FormNumbers& form) {
    std::vector<QStringList> rows;
    for (const NumberNumbers& each : form.numbers) {
        if (!each.field->derived) continue;
        QString alpha = "-";
        for (const AlphaNumbers& a : form.alphas) {
            if (a.scale != each.field) continue;
            alpha = a.alpha ? number(a.alpha->raw, 2) + " (" + interval(a.alpha->feldt_ci95, 2) +
                                  "), n " + QString::number(a.complete)
                            : "none: " + safe(a.problem);
        }
        rows.push_back(
            {safe(each.field->label), QString::number(each.values.size()),
             QString::number(each.missing),
             each.mean ? number(*each.mean, 2) + " (" + (each.sd ? number(*each.sd, 2) : "-") + ")"
                       : QStringLiteral("-"),
             each.mean_ci95 ? interval(*each.mean_ci95, 2) : QStringLiteral("-"), alpha});
    }
    if (rows.empty()) return;
    paper.table(safe(form.form->title) +
                    ": scale scores, mean (sample SD) with Student's 95 % interval; Cronbach's "
                    "alpha with Feldt's 95 % interval, complete cases, reverse-keyed items turned "
                    "round.",
                {"scale", "n", "missing", "mean (SD)", "95 % interval", "alpha"}, "lrrrrr", rows);
}

void write_comparison(Paper& paper, const StudyNumbers& numbers) {
    if (!numbers.comparison) return;
    const GroupComparison& c = *numbers.comparison;
    const size_t exact = c.exact_rows();
    const bool all_exact = exact == c.rows.size(), mixed = exact > 0 && !all_exact;
    std::vector<QStringList> rows;
    for (const auto& each : c.rows)
        rows.push_back(
            {safe(item_label(*each.field)), number(each.delta.delta, 2),
             each.delta.separated ? QStringLiteral("none") : interval(each.delta.ci95, 2),
             p_text(each.p) + (mixed ? each.exact ? " (exact)" : " (normal)" : ""),
             p_text(each.p_holm)});
    const QString least = c.least_p < 0.0001 ? "below 0.0001" : number(c.least_p, 4);
    paper.table(
        safe(c.by->label) + " " + safe(c.group1) + " (n = " + QString::number(c.n1) + ") against " +
            safe(c.group2) + " (n = " + QString::number(c.n2) +
            "): Cliff's delta with DeLong's 95 % interval, two-sided p of " +
            QString::fromStdString(mann_whitney_words(exact, c.rows.size())) +
            ", adjusted by Holm over " + QString::number(c.rows.size()) + " items." +
            (all_exact ? " The least p that these group sizes allow without ties is " + least + "."
                       : QString()),
        {"item", "delta", "95 % interval",
         all_exact ? "p (exact)"
         : mixed   ? "p"
                   : "p (normal)",
         "p (Holm)"},
        "lrrrr", rows);
}

}  // namespace placode::reports
