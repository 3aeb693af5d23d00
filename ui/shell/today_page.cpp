// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Today: what to do next and why, the last score, and how far the streak is.

#include <QHBoxLayout>

#include "db/attempt_counting.h"
#include "db/standards.h"
#include "ui/shell/attempts_table.h"
#include "ui/shell/day_text.h"
#include "ui/shell/newest_attempts_card.h"
#include "ui/shell/pages.h"
#include "ui/shell/parts.h"
#include "ui/shell/training.h"

namespace placode::ui {
namespace {

class TodayPage : public Page {
    Q_DECLARE_TR_FUNCTIONS(TodayPage)
 public:
    explicit TodayPage(AppContext& context) : Page(context), training_(load_training(context)) {
        QVBoxLayout* column = make_column(this);
        const QString name = qstr(context.user().display_name);
        column->addWidget(make_label(tr("Good to see you, %1.").arg(name), "display"));
        // Who teaches and does not train looks at others first.
        const bool trains = !training_.attempts.empty();
        QFrame* newest = make_newest_attempts_card(context, this);
        if (newest != nullptr && !trains) column->addWidget(newest);
        column->addWidget(nextCard());
        if (newest != nullptr && trains) column->addWidget(newest);
        addRemarks(column);
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace16);
        row->addWidget(lastScoreCard(), 1);
        row->addWidget(streakCard(), 1);
        row->addWidget(courseCard(), 1);
        column->addLayout(row);
        if (training_.attempts.size() >= 2) column->addWidget(chartCard());
        column->addStretch(1);  // All of the room below: else the cards grow with the window.
    }

    [[nodiscard]] QString title() const override { return tr("Today"); }

 private:
    [[nodiscard]] const TrainingStage* next() const {
        if (training_.next_stage < 0) return nullptr;
        return &training_.stages[static_cast<size_t>(training_.next_stage)];
    }

    QWidget* nextCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace12);
        const TrainingStage* stage = next();
        const bool finished = training_.next.kind == curriculum::NextKind::kFinished;
        layout->addWidget(make_label(finished ? tr("Course completed") : tr("Next task"), "muted"));
        QPushButton* open = nullptr;
        if (stage == nullptr) {
            layout->addWidget(make_label(
                finished ? tr("Every stage is mastered.") : QStringLiteral("–"), "title"));
            layout->addWidget(
                make_label(with_day_words(context_.in(training_.next.reason)), "muted"));
            if (finished)
                layout->addWidget(
                    make_label(tr("Repeat any task from the course to keep the skill."), "muted"));
            open = make_button(context_, tr("Open the course"), "primary", "course");
            connect(open, &QPushButton::clicked, this, [this] {
                Q_EMIT go({PageId::kCourse, 0, {}, {}});
            });
        } else {
            const QString id = qstr(stage->task_id);
            layout->addWidget(make_label(training_.taskTitle(context_, stage->task_id), "title"));
            layout->addWidget(
                make_label(with_day_words(context_.in(training_.next.reason)), "muted"));
            open = make_button(context_, tr("Open the task"), "primary", "play");
            const QVariantMap state = task_state(training_.course, stage->rule);
            connect(open, &QPushButton::clicked, this, [this, id, state] {
                Q_EMIT go({PageId::kTask, 0, id, state});
            });
        }
        open->setObjectName("open_next");
        auto* row = new QHBoxLayout;
        row->addWidget(open);
        row->addStretch();
        layout->addLayout(row);
        QFrame* card = make_card(layout);
        card->setProperty("tone", "accent");
        return card;
    }

    /// One line for remarks that nobody has opened on this computer yet.
    void addRemarks(QVBoxLayout* column) {
        const NewRemarks remarks = new_remarks(context_, training_.attempts);
        if (remarks.count == 0) return;
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace12);
        QLabel* words = make_label(
            tr("%n new remark(s) from your educator", nullptr, remarks.count), "heading");
        words->setObjectName("new_remarks_words");
        row->addWidget(words, 1);
        QPushButton* open = make_button(context_, tr("Read"), "secondary", "next");
        open->setObjectName("new_remarks");
        connect(open, &QPushButton::clicked, this, [this, id = remarks.attempt_id] {
            Q_EMIT go({PageId::kResult, id, {}, {}});
        });
        row->addWidget(open);
        column->addWidget(make_card(row));
    }

    QWidget* lastScoreCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace8);
        layout->addWidget(make_label(tr("Last score"), "muted"));
        if (training_.attempts.empty()) {
            layout->addWidget(make_label("–", "display"));
            layout->addWidget(
                make_label(tr("No attempt yet. Your first one shows up here."), "small"));
        } else {
            const db::AttemptRecord& last = training_.attempts.back();
            auto* line = new QHBoxLayout;
            // A number would read like a score where there is none.
            QLabel* points =
                make_label(db::counts(last) ? format_points(last.points) : "–", "display");
            points->setObjectName("today_last_points");
            line->addWidget(points);
            line->addWidget(make_badge(verdict_word(last), verdict_tone(last)));
            if (last.demonstration) line->addWidget(make_demonstration_badge());
            line->addStretch();
            layout->addLayout(line);
            layout->addWidget(make_label(
                training_.taskTitle(context_, last.task_id) + ", " + format_when(last.started_utc),
                "small"));
            QPushButton* open = make_button(
                context_, db::counts(last) ? tr("Why this score") : tr("Why it does not count"),
                "quiet", "next");
            open->setObjectName("open_last");
            connect(open, &QPushButton::clicked, this, [this, id = last.id] {
                Q_EMIT go({PageId::kResult, id, {}, {}});
            });
            layout->addWidget(open, 0, Qt::AlignLeft);
        }
        layout->addStretch();
        return make_card(layout);
    }

    QWidget* streakCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace8);
        layout->addWidget(make_label(tr("Towards mastery"), "muted"));
        const TrainingStage* stage = next();
        const int streak = stage ? stage->progress.streak : 0;
        const int wanted = stage ? stage->rule.consecutive : 0;
        layout->addWidget(
            make_label(stage ? tr("%1 of %2").arg(streak).arg(wanted) : "–", "display"));
        QLabel* words = make_label(
            stage == nullptr ? tr("nothing is open")
            : wanted == 1    ? tr("attempts with at least %1 points, on the next task")
                                .arg(format_points(stage->rule.benchmark_points))
                          : tr("attempts in a row with at least %1 points, on the next task")
                                .arg(format_points(stage->rule.benchmark_points)),
            "small");
        words->setObjectName("today_streak");
        layout->addWidget(words);
        layout->addStretch();
        return make_card(layout);
    }

    QWidget* courseCard() {
        int mastered = 0;
        for (const TrainingStage& stage : training_.stages)
            mastered += stage.progress.status == curriculum::StageStatus::kMastered ? 1 : 0;
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace8);
        layout->addWidget(make_label(tr("Course"), "muted"));
        layout->addWidget(
            make_label(tr("%1 of %2").arg(mastered).arg(training_.stages.size()), "display"));
        layout->addWidget(make_label(
            tr("stages mastered: %1").arg(context_.in(training_.course.title)), "small"));
        layout->addStretch();
        return make_card(layout);
    }

    QWidget* chartCard() {
        const std::string task = training_.attempts.back().task_id;
        std::vector<db::AttemptRecord> all, shown;
        for (const db::AttemptRecord& attempt : training_.attempts) {
            if (attempt.task_id != task) continue;
            all.push_back(attempt);
            if (db::counts(attempt)) shown.push_back(attempt);
        }
        double pass = 70;
        for (const TrainingStage& stage : training_.stages) {
            if (stage.task_id == task && stage.task)
                pass = db::rubric_at(context_.store(), *stage.task).pass_points;
        }
        auto* layout = new QVBoxLayout;
        const QString name = tr("Scores of %1").arg(training_.taskTitle(context_, task));
        layout->addWidget(make_label(name, "heading"));
        if (shown.empty()) {
            QLabel* why = make_label(why_nothing_counts(all), "muted");
            why->setObjectName("today_empty");
            layout->addWidget(why);
            return make_card(layout);
        }
        const reports::ChartStyle style = chart_style(context_.theme());
        layout->addWidget(make_picture(
            [shown, pass, style](QPainter& painter, const QRectF& where) {
                reports::draw_history(painter, where, shown, pass, style);
            },
            QSize(320, 220), name, tr("The same numbers stand in the history table.")));
        return make_card(layout);
    }

    Training training_;
};

}  // namespace

Page* make_today_page(AppContext& context, const Place&) { return new TodayPage(context); }

}  // namespace placode::ui
