// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/metric_words.h"

#include <QCoreApplication>

#include "ui/shell/parts.h"

namespace placode::ui {
namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(MetricWords)
};

QString direction_word(assessment::Direction direction) {
    switch (direction) {
        case assessment::Direction::kLowerIsBetter:
            return Words::tr("Lower is better.");
        case assessment::Direction::kHigherIsBetter:
            return Words::tr("Higher is better.");
        case assessment::Direction::kNeutral:
            break;
    }
    return Words::tr("Neither more nor less is better in itself.");
}

}  // namespace

QString metric_name(std::string_view english) {
    return QCoreApplication::translate("Metric", std::string(english).c_str());
}

QString metric_value(const assessment::MetricDefinition& metric, double value) {
    if (reports::is_ceiling(metric, value)) return "≥ " + format_number(value, 0);
    return reports::is_count(metric, value) ? format_number(value, 0) : format_value(value);
}

QString metric_explanation(const assessment::MetricDefinition& metric) {
    QString text =
        QCoreApplication::translate("MetricDefinition", std::string(metric.definition).c_str()) +
        " " + direction_word(metric.direction);
    if (!metric.unit.empty()) text += " " + Words::tr("Unit: %1.").arg(unit_sign(metric.unit));
    return text + " " +
           (metric.source == "Placode"
                ? Words::tr("Defined by this program.")
                : Words::tr("Source: %1.").arg(qstr(std::string(metric.source))));
}

QString metric_explanation(const assessment::MetricDefinition& metric,
                           const reports::TaskScope& scope) {
    const QString text = metric_explanation(metric);
    if (!reports::about_force_limit(metric.id) || !(scope.force_limit_n > 0)) return text;
    return text + " " +
           Words::tr("The limit of this scene: %1 mN.")
               .arg(format_number(1000 * scope.force_limit_n, 0));
}

}  // namespace placode::ui
