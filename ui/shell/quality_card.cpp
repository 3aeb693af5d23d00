// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Metric quality: does a metric tell novices from experts, does it repeat, is it at its ceiling.

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QPointer>
#include <algorithm>
#include <memory>

#include "db/norm_bands.h"
#include "ui/shell/metric_words.h"
#include "ui/shell/parts.h"
#include "ui/shell/standard_cards.h"

namespace placode::ui {
namespace {

constexpr int kRepeats = 3;  ///< Attempts of a person that enter the ICC.

using MetricPanel = std::vector<assessment::MetricQuality>;

class QualityCard : public QFrame {
    Q_DECLARE_TR_FUNCTIONS(QualityCard)
 public:
    QualityCard(AppContext& context, const std::string& task, const std::vector<int64_t>& novices,
                const std::vector<int64_t>& experts)
        : context_(context), task_(task), novices_(novices), experts_(experts) {
        setProperty("role", "card");
        setObjectName("quality_card");
        layout_ = new QVBoxLayout(this);
        layout_->setContentsMargins(kSpace24, kSpace16, kSpace24, kSpace16);
        layout_->setSpacing(kSpace12);
        layout_->addWidget(make_label(tr("Quality of the metrics"), "heading"));
        layout_->addWidget(make_label(
            tr("A metric has evidence when experts differ from novices (the interval of Hedges' g "
               "is above 0), when it repeats (ICC of %1 attempts a person at least 0.5), and when "
               "at most 20 % of the values are at its best one.")
                .arg(kRepeats),
            "muted"));
        if (novices.size() < 2 || experts.size() < 2) {
            layout_->addWidget(make_label(
                tr("Choose at least two novices and two experts; scripted operators do not count."),
                "muted"));
            return;
        }
        show_ = make_button(context, tr("Show the panel"), "secondary", "results");
        show_->setObjectName("show_quality");
        connect(show_, &QPushButton::clicked, this, [this] { read(); });
        layout_->addWidget(show_, 0, Qt::AlignLeft);
    }

 private:
    void read() {
        show_->setEnabled(false);
        auto panel = std::make_shared<MetricPanel>();
        context_.background(
            this, tr("Reading the metrics of these people"),
            [panel, task = task_, novices = novices_, experts = experts_](db::Store& store) {
                const auto levels =
                    db::level_attempts(store, task, {{"expert", experts}, {"novice", novices}});
                *panel = db::metric_panel(levels.at(1), levels.at(0), kRepeats);
            },
            [this, panel](bool done) {
                show_->setEnabled(true);
                if (done) showPanel(*panel);
            });
    }

    [[nodiscard]] static QTableWidgetItem* number(const std::optional<double>& value,
                                                  int decimals) {
        return value ? make_number_cell(format_number(*value, decimals), *value)
                     : make_number_cell("–", -1e9);
    }

    /// Why evidence is missing, in the program's language.
    [[nodiscard]] static QString reason(const assessment::MetricQuality& one) {
        QStringList why;
        if (!one.separates) why << tr("does not tell the groups apart");
        if (!one.repeatable)
            why << (one.icc ? tr("does not repeat") : tr("too few repeats to know"));
        if (one.ceiling) why << tr("is at its best value too often");
        return why.join(", ");
    }

    void showPanel(const MetricPanel& panel) {
        show_->hide();
        auto* table = make_table({tr("Metric"), tr("Hedges' g"), tr("95 % interval"),
                                  tr("ICC(2,1)"), tr("At the best [%]"), tr("Evidence")},
                                 tr("Quality of the metrics"));
        table->setObjectName("quality_table");
        table->setSortingEnabled(false);
        table->setRowCount(static_cast<int>(panel.size()));
        int without = 0;
        for (int row = 0; row < table->rowCount(); ++row) {
            const assessment::MetricQuality& one = panel[static_cast<size_t>(row)];
            const auto* known = assessment::metric_definition(one.metric);
            table->setItem(row, 0,
                           make_cell(known == nullptr ? tr("Points") : metric_name(known->name)));
            table->setItem(row, 1, number(one.g, 2));
            table->setItem(row, 2,
                           make_cell(one.g ? tr("%1 to %2")
                                                 .arg(format_number(*one.g_low, 2),
                                                      format_number(*one.g_high, 2))
                                           : QStringLiteral("–")));
            table->setItem(row, 3, number(one.icc, 2));
            table->setItem(row, 4, number(one.ceiling_percent, 0));
            QTableWidgetItem* evidence =
                make_cell(one.evidence ? tr("✓ yes") : tr("▲ no: %1").arg(reason(one)));
            evidence->setForeground(one.evidence ? context_.colors().good : context_.colors().warn);
            evidence->setToolTip(evidence->text());
            table->setItem(row, 5, evidence);
            without += one.evidence ? 0 : 1;
        }
        fit_columns(table, 5);
        table->setColumnWidth(0, std::min(260, table->columnWidth(0)));
        table->setSortingEnabled(true);
        table->setFixedHeight(std::clamp(table->rowCount(), 1, 10) * kTouchTarget + 50);
        layout_->addWidget(table);
        QLabel* said = make_label(
            tr("Metrics: %1, without evidence: %2. A metric without evidence should weigh nothing "
               "in a rubric: take its line out, publish the rubric's next version and score the "
               "attempts again.")
                .arg(panel.size())
                .arg(without),
            "small");
        said->setObjectName("quality_said");
        layout_->addWidget(said);
    }

    AppContext& context_;
    std::string task_;
    std::vector<int64_t> novices_, experts_;
    QVBoxLayout* layout_ = nullptr;
    QPushButton* show_ = nullptr;
};

}  // namespace

QWidget* make_quality_card(AppContext& context, const std::string& task_id,
                           const std::vector<int64_t>& novices,
                           const std::vector<int64_t>& experts) {
    return new QualityCard(context, task_id, novices, experts);
}

}  // namespace placode::ui
