// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Result: the measures with the own last value and the band of the own earlier attempts.

#include <QHBoxLayout>
#include <QHeaderView>
#include <cmath>
#include <set>

#include "reports/attempt_figures.h"
#include "reports/task_scope.h"
#include "reports/text.h"
#include "reports/words.h"
#include "ui/shell/day_text.h"
#include "ui/shell/metric_words.h"
#include "ui/shell/result_cards.h"
#include "ui/shell/table_width.h"
#include "ui/shell/training.h"

namespace placode::ui {
namespace {

struct Metrics {
    Q_DECLARE_TR_FUNCTIONS(ResultPage)
};

constexpr int kStripWidth = 150, kNarrowStrip = 104;

/// And what everybody asks for first.
std::set<std::string> metrics_that_count(const reports::TaskScope& scope) {
    std::set<std::string> ids(scope.scored.begin(), scope.scored.end());
    ids.insert({"task_time_s", "path_length_mm"});
    if (scope.ring) ids.insert({"ring_completeness_percent", "contour_deviation_mm"});
    return ids;
}

QTableWidgetItem* change_cell(const AppContext& context, assessment::Direction direction,
                              double value, std::optional<double> before) {
    if (!before || direction == assessment::Direction::kNeutral) return make_cell("–");
    // Less than what the table shows is no change.
    if (format_value(value) == format_value(*before)) return make_cell(Metrics::tr("= same"));
    const bool better =
        (direction == assessment::Direction::kLowerIsBetter) == (value - *before < 0);
    QTableWidgetItem* cell = make_cell(better ? Metrics::tr("▲ better") : Metrics::tr("▼ worse"));
    cell->setForeground(better ? context.colors().good : context.colors().warn);
    return cell;
}

/// The band as a picture, and in words for who cannot see it.
QWidget* strip(const AppContext& context, const reports::Band& band, double value,
               const QString& name) {
    const reports::ChartStyle style = chart_style(context.theme());
    QWidget* picture = make_picture(
        [band, value, style](QPainter& painter, const QRectF& where) {
            reports::draw_band(painter, where, band, value, style);
        },
        QSize(kNarrowStrip, kTouchTarget - 8), name, {});
    const QString words = Metrics::tr("mean %1, SD %2, from %3 to %4, n = %5")
                              .arg(format_value(band.mean), format_value(band.sd),
                                   format_value(band.low), format_value(band.high))
                              .arg(band.n);
    picture->setAccessibleDescription(words);
    picture->setToolTip(words);
    return picture;
}

/// A band of a norm pack as it is drawn. Of a logarithmic one: the values it stands for.
reports::Band band_of_norm(const assessment::Benchmark& norm) {
    const auto value = [&](double x) { return norm.log ? std::exp(x) : x; };
    reports::Band band;
    band.mean = value(norm.mean);
    band.low = std::min(norm.q25, value(norm.mean - norm.sd));
    band.high = std::max(norm.q75, value(norm.mean + norm.sd));
    band.sd = (value(norm.mean + norm.sd) - value(norm.mean - norm.sd)) / 2;
    band.n = norm.n;
    return band;
}

/// Experts first, then one other group: there is no room for more.
std::vector<const curriculum::NormGroup*> shown_groups(const ResultData& data) {
    std::vector<const curriculum::NormGroup*> groups;
    if (!data.norms) return groups;
    if (const auto* experts = data.norms->pack.group("expert")) groups.push_back(experts);
    for (const curriculum::NormGroup& each : data.norms->pack.groups)
        if (each.level != "expert" && groups.size() < 2) groups.push_back(&each);
    return groups;
}

QString band_name(const curriculum::NormGroup& group) {
    if (group.level == "expert") return Metrics::tr("Expert band");
    if (group.level == "novice") return Metrics::tr("Novice band");
    return Metrics::tr("Band: %1").arg(qstr(group.level));
}

class MetricsTable {
 public:
    MetricsTable(AppContext& context, const ResultData& data)
        : context_(context),
          data_(data),
          scope_(task_scope(context, data.detail.record.task_id)),
          groups_(shown_groups(data)) {
        QStringList head{Metrics::tr("Measure"),  Metrics::tr("Value"),  Metrics::tr("Unit"),
                         Metrics::tr("Own last"), Metrics::tr("Change"), Metrics::tr("Own band")};
        for (const curriculum::NormGroup* group : groups_) head << band_name(*group);
        table_ = make_table(head, Metrics::tr("Measures"));
        table_->setObjectName("metrics");
        table_->setSortingEnabled(false);
        for (const assessment::MetricDefinition& each : assessment::metric_definitions()) {
            if (!reports::belongs(scope_, each.id)) continue;
            if (const auto value = data.detail.metrics.find(each.id)) add(each, *value);
        }
        fit_columns(table_, 0);
        for (int c = 5; c < table_->columnCount(); ++c)
            table_->setColumnWidth(c, (groups_.empty() ? kStripWidth : kNarrowStrip) + 16);
        // The bands show as well whether it was better than before.
        keep_within(table_, {.stretch = 0, .least_px = 220, .drop = {4, 3, 7}});
        table_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    }
    [[nodiscard]] QTableWidget* widget() const { return table_; }

 private:
    void add(const assessment::MetricDefinition& definition, double value) {
        const std::optional<double> before =
            data_.earlier.empty() ? std::nullopt : data_.earlier.back().metrics.find(definition.id);
        const int row = table_->rowCount();
        table_->insertRow(row);
        QTableWidgetItem* name = make_cell(metric_name(definition.name));
        name->setToolTip(metric_explanation(definition, scope_));
        name->setData(Qt::UserRole, qstr(std::string(definition.id)));
        table_->setItem(row, 0, name);
        // One unit for the row: minutes when one of the two is that long.
        const bool minutes =
            reports::in_minutes(definition, std::max(value, before.value_or(value)));
        const auto text = [&](double of) {
            return minutes ? reports::minute_second(of) : metric_value(definition, of);
        };
        table_->setItem(row, 1, make_number_cell(text(value), value));
        table_->setItem(row, 2,
                        make_cell(minutes                   ? "min"
                                  : definition.unit.empty() ? "–"
                                                            : unit_sign(definition.unit)));
        table_->setItem(row, 3, make_number_cell(before ? text(*before) : "–", before.value_or(0)));
        table_->setItem(row, 4, change_cell(context_, definition.direction, value, before));
        std::vector<double> values;
        for (const db::AttemptDetail& each : data_.earlier)
            if (const auto found = each.metrics.find(definition.id)) values.push_back(*found);
        const auto band = reports::band_of(values);
        table_->setItem(row, 5, make_cell(band ? QString() : "–"));
        if (band)
            table_->setCellWidget(
                row, 5,
                strip(context_, *band, value, Metrics::tr("Own band of %1").arg(name->text())));
        for (size_t g = 0; g < groups_.size(); ++g) {
            const int column = 6 + static_cast<int>(g);
            const curriculum::NormMetric* norm = groups_[g]->metric(definition.id);
            table_->setItem(row, column, make_cell(norm ? QString() : "–"));
            if (norm)
                table_->setCellWidget(
                    row, column,
                    strip(context_, band_of_norm(norm->band), value,
                          QString("%1: %2").arg(band_name(*groups_[g]), name->text())));
        }
    }

    AppContext& context_;
    const ResultData& data_;
    const reports::TaskScope scope_;
    std::vector<const curriculum::NormGroup*> groups_;
    QTableWidget* table_ = nullptr;
};

}  // namespace

QWidget* make_metrics_card(AppContext& context, const ResultData& data) {
    auto* layout = new QVBoxLayout;
    layout->setSpacing(kSpace12);
    auto* head = new QHBoxLayout;
    head->addWidget(make_label(Metrics::tr("Measures"), "heading"), 1);
    QPushButton* all = make_button(context, Metrics::tr("All measures"), "quiet");
    all->setObjectName("all_measures");
    head->addWidget(all);
    layout->addLayout(head);
    if (!data.earlier.empty())
        layout->addWidget(make_label(
            Metrics::tr("Own band: mean and standard deviation of your last %n attempt(s) "
                        "before this one; the dot is this attempt.",
                        nullptr, static_cast<int>(data.earlier.size())),
            "small"));
    if (data.norms)
        layout->addWidget(
            make_label(Metrics::tr("Bands of experts and novices: norm pack of %1, %2.")
                           .arg(qstr(data.norms->pack.centre), day_text(data.norms->pack.made_utc)),
                       "small"));
    QTableWidget* table = MetricsTable(context, data).widget();
    layout->addWidget(table);
    // A touch screen has no tool tips: a click tells the same below.
    QLabel* explained = make_label(
        Metrics::tr("Click a measure to read what it means and where it is from."), "small");
    explained->setObjectName("metric_explained");
    QObject::connect(table, &QTableWidget::currentCellChanged, explained,
                     [table, explained](int row) {
                         if (row < 0) return;
                         const QTableWidgetItem* name = table->item(row, 0);
                         explained->setText(name->text() + ": " + name->toolTip());
                     });
    layout->addWidget(explained);
    const auto show = [table, all,
                       wanted = metrics_that_count(
                           task_scope(context, data.detail.record.task_id))](bool everything) {
        int shown = 0;
        for (int row = 0; row < table->rowCount(); ++row) {
            const std::string id = table->item(row, 0)->data(Qt::UserRole).toString().toStdString();
            const bool fits = everything || wanted.count(id) > 0;
            table->setRowHidden(row, !fits);
            shown += fits ? 1 : 0;
        }
        table->setFixedHeight(shown * kTouchTarget + 46);
        all->setText(everything ? Metrics::tr("Only what counts") : Metrics::tr("All measures"));
    };
    QObject::connect(all, &QPushButton::clicked, table,
                     [show, everything = false]() mutable { show(everything = !everything); });
    show(false);
    return make_card(layout);
}

}  // namespace placode::ui
