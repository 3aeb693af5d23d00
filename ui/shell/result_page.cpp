// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Result: verdict and score in one line, the three reasons that cost most, the numbers beside the
// person's own last ones, the picture of the incision, and what to do next.

#include <QHBoxLayout>
#include <QHeaderView>
#include <QStandardPaths>
#include <algorithm>
#include <memory>
#include <set>

#include "ui/shell/pages.h"
#include "ui/shell/parts.h"
#include "ui/shell/training.h"

namespace placode::ui {
namespace {

constexpr size_t kShownReasons = 3;

class ResultPage : public Page {
    Q_DECLARE_TR_FUNCTIONS(ResultPage)
 public:
    ResultPage(AppContext& context, const Place& place)
        : Page(context), detail_(context.store().attempt(place.number)) {
        const db::AttemptRecord& record = detail_.record;
        const bool own = record.user_id == context.user().id;
        context.require(db::Action::kViewAttempts, own ? db::Scope::kOwn : db::Scope::kOther);
        history_ = context.store().attempts(record.user_id, record.task_id);
        QVBoxLayout* column = make_column(this);
        column->addWidget(headCard(own));
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace16);
        auto* left = new QVBoxLayout;
        left->setSpacing(kSpace16);
        left->addWidget(reasonsCard());
        left->addWidget(metricsCard());
        left->addStretch();
        row->addLayout(left, 3);
        row->addWidget(pictureCard(), 2);
        column->addLayout(row);
        column->addStretch();
    }

    [[nodiscard]] QString title() const override { return tr("Result"); }

 private:
    QWidget* headCard(bool own) {
        const db::AttemptRecord& record = detail_.record;
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace8);
        auto* line = new QHBoxLayout;
        line->setSpacing(kSpace12);
        QLabel* points = make_label(tr("%1 points").arg(format_points(record.points)), "display");
        points->setObjectName("result_points");
        points->setWordWrap(false);
        line->addWidget(points);
        QLabel* verdict = make_badge(verdict_word(record), verdict_tone(record));
        verdict->setObjectName("result_verdict");
        line->addWidget(verdict);
        if (record.demonstration) line->addWidget(make_demonstration_badge());
        line->addStretch();
        addButtons(line, own);
        layout->addLayout(line);
        QStringList facts{task_title(context_, record.task_id), format_when(record.started_utc),
                          format_duration(record.duration_s), device_name(record.device),
                          end_word(record.end)};
        if (!own) facts.prepend(qstr(record.user_name));
        layout->addWidget(make_label(facts.join(" · "), "muted"));
        if (record.end == sim::EndReason::kInterrupted) {
            layout->addWidget(make_label(
                tr("The attempt was interrupted: it is kept, and does not count for the course."),
                "warn"));
        }
        return make_card(layout);
    }

    void addButtons(QHBoxLayout* line, bool own) {
        QPushButton* report = make_button(context_, tr("Report"), "secondary", "report");
        report->setObjectName("report_pdf");
        report->setToolTip(tr("Write a PDF of this attempt"));
        connect(report, &QPushButton::clicked, this, [this] { writeReport(); });
        line->addWidget(report);
        if (!own || !context_.may(db::Action::kPerformAttempt)) return;
        const QString task = qstr(detail_.record.task_id);
        QPushButton* again = make_button(context_, tr("Again"), "secondary", "again");
        again->setObjectName("again");
        connect(again, &QPushButton::clicked, this, [this, task] {
            Q_EMIT go({PageId::kTask, 0, task, {}});
        });
        QPushButton* next = make_button(context_, tr("Next"), "primary", "next");
        next->setObjectName("next");
        connect(next, &QPushButton::clicked, this, [this] {
            Q_EMIT go({PageId::kToday, 0, {}, {}});
        });
        line->addWidget(again);
        line->addWidget(next);
    }

    QWidget* reasonsCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace12);
        // A critical error decides the verdict, whatever it costs: it comes first.
        std::vector<assessment::Reason> reasons = detail_.score.reasons;
        std::stable_partition(reasons.begin(), reasons.end(),
                              [](const assessment::Reason& reason) { return reason.critical; });
        layout->addWidget(make_label(
            reasons.empty() ? tr("No points were lost") : tr("What cost most"), "heading"));
        if (reasons.empty())
            layout->addWidget(make_label(tr("Nothing in the rubric took points off."), "muted"));
        for (size_t i = 0; i < std::min(kShownReasons, reasons.size()); ++i) {
            if (i > 0) layout->addWidget(make_rule());
            layout->addLayout(reasonLine(reasons[i]));
        }
        if (reasons.size() > kShownReasons) {
            double rest = 0;
            for (size_t i = kShownReasons; i < reasons.size(); ++i) rest += reasons[i].points;
            layout->addWidget(make_label(tr("Smaller reasons: %1, together −%2 points.")
                                             .arg(reasons.size() - kShownReasons)
                                             .arg(format_number(rest, 1)),
                                         "small"));
        }
        return make_card(layout);
    }

    QHBoxLayout* reasonLine(const assessment::Reason& reason) {
        auto* line = new QHBoxLayout;
        line->setSpacing(kSpace12);
        const QString cost =
            reason.points >= 0.5 ? "−" + format_points(reason.points) : QString("!");
        QLabel* points = make_badge(cost, reason.critical ? "critical" : "warn");
        points->setAlignment(Qt::AlignCenter);
        points->setMinimumWidth(48);
        line->addWidget(points, 0, Qt::AlignTop);
        auto* text = new QVBoxLayout;
        text->setSpacing(kSpace4);
        text->addWidget(make_label(qstr(reason.text)));
        QStringList remarks;
        if (reason.critical) remarks << tr("critical error");
        if (reason.time_s >= 0) remarks << tr("at %1").arg(format_duration(reason.time_s));
        if (!remarks.isEmpty()) text->addWidget(make_label(remarks.join(" · "), "small"));
        line->addLayout(text, 1);
        return line;
    }

    /// The person's attempt at this task before this one.
    [[nodiscard]] std::optional<db::AttemptDetail> previous() {
        std::optional<int64_t> id;
        for (const db::AttemptRecord& attempt : history_) {
            if (attempt.id == detail_.record.id) break;
            if (attempt.end != sim::EndReason::kInterrupted) id = attempt.id;
        }
        if (!id) return std::nullopt;
        return context_.store().attempt(*id);
    }

    /// What the rubric looks at, and what everybody asks for first.
    [[nodiscard]] std::set<std::string> metricsThatCount() {
        std::set<std::string> ids{"task_time_s", "ring_completeness_percent",
                                  "contour_deviation_mm", "path_length_mm"};
        (void)context_.problemOf([&] {
            const curriculum::Task task = curriculum::load_task(detail_.record.task_id);
            for (const assessment::RubricItem& item : task.rubric.items) ids.insert(item.metric);
        });
        return ids;
    }

    QWidget* metricsCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace12);
        auto* head = new QHBoxLayout;
        head->addWidget(make_label(tr("Measures"), "heading"), 1);
        QPushButton* all = make_button(context_, tr("All measures"), "quiet");
        all->setObjectName("all_measures");
        head->addWidget(all);
        layout->addLayout(head);
        QTableWidget* table = make_table(
            {tr("Measure"), tr("Value"), tr("Unit"), tr("Own last"), tr("Change")}, tr("Measures"));
        table->setObjectName("metrics");
        table->setSortingEnabled(false);
        const std::optional<db::AttemptDetail> last = previous();
        for (const assessment::MetricDefinition& definition : assessment::metric_definitions()) {
            const std::optional<double> value = detail_.metrics.find(definition.id);
            if (value)
                addMetric(table, definition, *value,
                          last ? last->metrics.find(definition.id) : std::nullopt);
        }
        fit_columns(table, 0);
        table->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        layout->addWidget(table);
        const auto show = [table, all, wanted = metricsThatCount()](bool everything) {
            int shown = 0;
            for (int row = 0; row < table->rowCount(); ++row) {
                const std::string id =
                    table->item(row, 0)->data(Qt::UserRole).toString().toStdString();
                const bool fits = everything || wanted.count(id) > 0;
                table->setRowHidden(row, !fits);
                shown += fits ? 1 : 0;
            }
            table->setFixedHeight(shown * kTouchTarget + 46);
            all->setText(everything ? tr("Only what counts") : tr("All measures"));
        };
        connect(all, &QPushButton::clicked, table,
                [show, everything = false]() mutable { show(everything = !everything); });
        show(false);
        return make_card(layout);
    }

    void addMetric(QTableWidget* table, const assessment::MetricDefinition& definition,
                   double value, std::optional<double> before) const {
        const int row = table->rowCount();
        table->insertRow(row);
        QTableWidgetItem* name = make_cell(metric_name(definition.name));
        name->setToolTip(qstr(std::string(definition.definition)));
        name->setData(Qt::UserRole, qstr(std::string(definition.id)));
        table->setItem(row, 0, name);
        table->setItem(row, 1, make_number_cell(format_value(value), value));
        table->setItem(row, 2, make_cell(unit_sign(definition.unit)));
        table->setItem(row, 3,
                       make_number_cell(before ? format_value(*before) : "–", before.value_or(0)));
        table->setItem(row, 4, changeCell(definition.direction, value, before));
    }

    [[nodiscard]] QTableWidgetItem* changeCell(assessment::Direction direction, double value,
                                               std::optional<double> before) const {
        if (!before || direction == assessment::Direction::kNeutral) return make_cell("–");
        const double change = value - *before;
        // Less than what the table shows is no change.
        if (format_value(value) == format_value(*before)) return make_cell(tr("= same"));
        const bool better = (direction == assessment::Direction::kLowerIsBetter) == (change < 0);
        QTableWidgetItem* cell = make_cell(better ? tr("▲ better") : tr("▼ worse"));
        cell->setForeground(better ? context_.colors().good : context_.colors().warn);
        return cell;
    }

    QWidget* pictureCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace12);
        layout->addWidget(make_label(tr("The incision"), "heading"));
        QLabel* wait = make_label(tr("Reading the recording …"), "muted");
        layout->addWidget(wait);
        QFrame* card = make_card(layout);
        card->setMinimumWidth(360);
        auto recording = std::make_shared<sim::Recording>();
        const int64_t id = detail_.record.id;
        context_.background(
            this, tr("Reading the recording"),
            [recording, id](db::Store& store) { *recording = stored_recording(store, id); },
            [this, recording, layout, wait](bool done) {
                if (!done) return wait->setText(tr("The recording cannot be shown."));
                recording_ = recording;
                wait->hide();
                const reports::ChartStyle style = chart_style(context_.theme());
                QWidget* picture = make_picture(
                    [recording, style](QPainter& painter, const QRectF& where) {
                        reports::draw_incision(painter, where, *recording, style);
                    },
                    QSize(320, 380), tr("The incision"),
                    tr("The field from above: planned contour, what was cut, the needle's path. "
                       "The measures beside it say the same in numbers."));
                picture->setObjectName("incision");
                picture->setMaximumHeight(460);
                layout->insertWidget(2, picture, 1);
            });
        layout->addStretch();
        return card;
    }

    void writeReport() {
        const QString folder = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
        const QString proposal =
            QString("%1/placode-attempt-%2.pdf").arg(folder).arg(detail_.record.id);
        const QString path =
            context_.askSaveFile(this, tr("Write the report"), proposal, tr("PDF (*.pdf)"));
        if (path.isEmpty()) return;
        const auto detail = detail_;
        const auto history = history_;
        const auto known = recording_;
        context_.background(
            this, tr("Writing the report"),
            [detail, history, known, path](db::Store& store) {
                const sim::Recording recording =
                    known ? *known : stored_recording(store, detail.record.id);
                reports::write_attempt_pdf(detail, recording, history, path.toStdString());
            },
            [this, path](bool done) {
                if (done) Q_EMIT notice(tr("Report written: %1").arg(path));
            });
    }

    db::AttemptDetail detail_;
    std::vector<db::AttemptRecord> history_;
    std::shared_ptr<sim::Recording> recording_;
};

}  // namespace

Page* make_result_page(AppContext& context, const Place& place) {
    return new ResultPage(context, place);
}

}  // namespace placode::ui
