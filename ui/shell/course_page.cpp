// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Course: the stages as a path, what is open, what locks the rest and why, what is next.

#include <QComboBox>
#include <QHBoxLayout>
#include <QPainter>

#include "db/attempt_counting.h"
#include "db/course_conduct.h"
#include "reports/cohort_report.h"
#include "reports/words.h"
#include "ui/shell/course_station.h"
#include "ui/shell/course_words.h"
#include "ui/shell/pages.h"
#include "ui/shell/parts.h"
#include "ui/shell/training.h"

namespace placode::ui {
namespace {

using curriculum::StageStatus;

class CoursePage : public Page {
    Q_DECLARE_TR_FUNCTIONS(CoursePage)
 public:
    explicit CoursePage(AppContext& context) : Page(context), training_(load_training(context)) {
        QVBoxLayout* column = make_column(this, 960);
        auto* head = new QHBoxLayout;
        head->addWidget(make_label(context.in(training_.course.title), "display"), 1);
        addChooser(head);
        column->addLayout(head);
        column->addWidget(make_label(context.in(training_.course.description), "muted"));
        auto* path = new QVBoxLayout;
        path->setSpacing(0);
        for (size_t i = 0; i < training_.stages.size(); ++i) path->addLayout(stageRow(i));
        column->addLayout(path);
        addCertificate(column);
        column->addStretch();
    }

    [[nodiscard]] QString title() const override { return tr("Course"); }

 private:
    /// A mastered course has its certificate: issued here, written as a PDF. One of another version
    /// stays until this one is mastered, too.
    void addCertificate(QVBoxLayout* column) {
        const auto& there = training_.certificate;
        if (!training_.mastered && !there) return;
        const bool shown =
            there && (!training_.mastered || there->course_version == training_.course.version);
        auto* layout = new QHBoxLayout;
        layout->setSpacing(kSpace16);
        auto* text = new QVBoxLayout;
        text->addWidget(
            make_label(training_.mastered
                           ? tr("The course is mastered")
                           : tr("The course is mastered in version %1").arg(there->course_version),
                       "heading"));
        QLabel* code =
            make_label(shown ? tr("Certificate %1, mastered on %2")
                                   .arg(qstr(there->code), format_when(there->mastered_utc))
                             : tr("Your certificate is ready to be issued."),
                       "muted");
        code->setObjectName("certificate_code");
        text->addWidget(code);
        layout->addLayout(text, 1);
        QPushButton* write = make_button(context_, tr("Certificate"), "primary", "report");
        write->setObjectName("certificate");
        connect(write, &QPushButton::clicked, this, [this] { writeCertificate(); });
        layout->addWidget(write);
        QFrame* card = make_card(layout);
        card->setProperty("tone", "accent");
        column->addWidget(card);
    }

    void writeCertificate() {
        const QString path = context_.askSaveFile(this, tr("Write the certificate"),
                                                  "placode-" + qstr(training_.course.id) + ".pdf",
                                                  tr("PDF (*.pdf)"));
        if (path.isEmpty()) return;
        context_.guard(tr("Writing the certificate"), [&] {
            context_.require(db::Action::kIssueCertificate);
            const auto issued = db::issue_certificate(
                context_.store(), context_.user().id, training_.course.id,
                QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString());
            const curriculum::Course course =
                db::find_course(context_.store(), issued.course_id, issued.course_version);
            // Before the file: nothing leaves without its entry, also when it is written again.
            context_.audit("report.certificate", QString("user %1").arg(context_.user().id), path);
            reports::write_certificate_pdf(issued, context_.user(), course, path.toStdString());
            findChild<QLabel*>("certificate_code")
                ->setText(tr("Certificate %1, mastered on %2")
                              .arg(qstr(issued.code), format_when(issued.mastered_utc)));
            Q_EMIT written(tr("Certificate written: %1").arg(path), path);
        });
    }

    void addChooser(QHBoxLayout* head) {
        const std::vector<std::string> ids = course_ids(context_);
        if (ids.size() < 2) return;
        auto* chooser = new QComboBox;
        chooser->setAccessibleName(tr("Course"));
        for (const std::string& id : ids) {
            QString name = qstr(id);
            (void)context_.problemOf(
                [&] { name = context_.in(db::find_course(context_.store(), id).title); });
            chooser->addItem(name, qstr(id));
        }
        connect(chooser, &QComboBox::activated, this, [this, chooser] {
            choose_course(context_, chooser->currentData().toString());
            Q_EMIT go({PageId::kCourse, 0, {}, {}});
        });
        head->addWidget(chooser);
    }

    QHBoxLayout* stageRow(size_t index) {
        const TrainingStage& stage = training_.stages[index];
        const bool next = static_cast<int>(index) == training_.next_stage;
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace12);
        row->addWidget(new CourseStation(context_.colors(), static_cast<int>(index) + 1,
                                         stage.progress.status, index == 0,
                                         index + 1 == training_.stages.size(), next));
        auto* content = new QHBoxLayout;
        content->setSpacing(kSpace16);
        content->addLayout(stageText(stage, next), 1);
        const QString id = qstr(stage.task_id);
        const QString title = training_.taskTitle(context_, stage.task_id);
        if (!stage.problem && stage.progress.status != StageStatus::kLocked) {
            QPushButton* open =
                make_button(context_, stage.progress.attempts == 0 ? tr("Begin") : tr("Repeat"),
                            next ? "primary" : "secondary", "play");
            open->setObjectName("open_" + id);
            open->setAccessibleName(tr("Open task %1").arg(title));
            const bool exam = stage.rule.mode == curriculum::StageMode::kExam;
            if (exam) open->setObjectName("open_exam_" + qstr(stage.rule.id));
            if (exam) open->setText(tr("To the exam"));
            connect(open, &QPushButton::clicked, this,
                    [this, place = placeOf(stage)] { Q_EMIT go(place); });
            content->addWidget(open, 0, Qt::AlignVCenter);
        }
        QFrame* card = make_card(content);
        if (next) card->setProperty("tone", "accent");
        auto* padded = new QVBoxLayout;
        padded->setContentsMargins(0, kSpace8, 0, kSpace8);
        padded->addWidget(card);
        row->addLayout(padded, 1);
        return row;
    }

    [[nodiscard]] Place placeOf(const TrainingStage& stage) const {
        return {PageId::kTask, 0, qstr(stage.task_id), task_state(training_.course, stage.rule)};
    }

    QVBoxLayout* stageText(const TrainingStage& stage, bool next) {
        auto* text = new QVBoxLayout;
        text->setSpacing(kSpace4);
        auto* head = new QHBoxLayout;
        head->setSpacing(kSpace8);
        QLabel* name = make_label(training_.taskTitle(context_, stage.task_id), "heading");
        name->setWordWrap(false);
        head->addWidget(name);
        head->addWidget(statusBadge(stage, next));
        if (stage.rule.mode != curriculum::StageMode::kPractice)
            head->addWidget(
                make_badge(mode_word(stage.rule.mode),
                           stage.rule.mode == curriculum::StageMode::kExam ? "warn" : ""));
        head->addStretch();
        text->addLayout(head);
        if (stage.task) text->addWidget(make_label(context_.in(stage.task->goal), "muted"));
        if (stage.problem) {
            text->addWidget(make_label(stage.problem->title, "critical"));
            text->addWidget(make_label(stage.problem->detail, "small"));
        }
        QLabel* where = make_label(standing(stage), "small");
        where->setObjectName("standing_" + qstr(stage.rule.id));
        text->addWidget(where);
        return text;
    }

    QLabel* statusBadge(const TrainingStage& stage, bool next) {
        if (stage.problem) return make_badge(tr("Cannot be used"), "critical");
        switch (stage.progress.status) {
            case StageStatus::kMastered:
                return make_badge(tr("Mastered"), "good");
            case StageStatus::kLocked:
                return make_badge(tr("Locked"));
            case StageStatus::kExhausted:
                return make_badge(tr("All attempts used"), "critical");
            default:
                return next ? make_badge(tr("Next"), "accent") : make_badge(tr("Open"), "accent");
        }
    }

    /// "2. Title (Benchmark 70 points, once)": stages of one task differ by their number.
    [[nodiscard]] QString whatMasters(size_t index) const {
        curriculum::CourseStage rule = training_.stages[index].rule;
        rule.max_attempts = rule.remind_after_days = 0;  // what opens it, no more
        return QString("%1. %2 (%3)")
            .arg(index + 1)
            .arg(training_.taskTitle(context_, rule.task_id), stage_rule_words(rule));
    }

    /// Stages that still lock this one.
    [[nodiscard]] std::vector<size_t> missingFor(const TrainingStage& stage) const {
        const auto& ids = stage.rule.requires_stages;
        std::vector<size_t> out;
        for (size_t i = 0; i < training_.stages.size(); ++i) {
            const TrainingStage& each = training_.stages[i];
            if (each.progress.status != StageStatus::kMastered &&
                std::find(ids.begin(), ids.end(), each.rule.id) != ids.end())
                out.push_back(i);
        }
        return out;
    }

    /// A stage above this one is closed, so that an open one below it looks like a mistake.
    [[nodiscard]] bool aboveIsLocked(const TrainingStage& stage) const {
        for (const TrainingStage& each : training_.stages) {
            if (&each == &stage) return false;
            if (each.progress.status == StageStatus::kLocked) return true;
        }
        return false;
    }

    /// The last attempt that was made for this stage and does not count; null = none.
    [[nodiscard]] const db::AttemptRecord* lastTry(const TrainingStage& stage) const {
        const bool exam = stage.rule.mode == curriculum::StageMode::kExam;
        for (auto each = training_.attempts.rbegin(); each != training_.attempts.rend(); ++each) {
            if (each->task_id != stage.task_id || db::counts(*each)) continue;
            if (exam && (each->exam.course_id != training_.course.id ||
                         each->exam.stage_id != stage.rule.id))
                continue;
            return &*each;
        }
        return nullptr;
    }

    [[nodiscard]] QString standing(const TrainingStage& stage) const {
        if (stage.progress.status == StageStatus::kLocked) {
            QStringList missing;
            for (const size_t index : missingFor(stage)) missing << whatMasters(index);
            return tr("Locked. Opens when mastered: %1").arg(missing.join("; "));
        }
        QString rule = stage_rule_words(stage.rule);
        if (stage.rule.requires_stages.empty() && aboveIsLocked(stage))
            rule += tr(" · open to everybody: needs no stage before it");
        if (stage.progress.attempts_left >= 0 && stage.progress.status != StageStatus::kMastered)
            rule += tr(" · left: %1").arg(stage.progress.attempts_left);
        if (stage.progress.unfinished > 0)
            rule += tr(" · begun, not finished: %1").arg(stage.progress.unfinished);
        if (stage.progress.attempts == 0) {
            const db::AttemptRecord* last = lastTry(stage);
            return rule + (last == nullptr ? tr(" · not tried yet")
                                           : tr(" · tried, does not count: %1")
                                                 .arg(reports::not_counted_words(*last)));
        }
        return rule + tr(" · streak %1 · best %2 · attempts %3")
                          .arg(stage.progress.streak)
                          .arg(format_points(stage.progress.best_points))
                          .arg(stage.progress.attempts);
    }

    Training training_;
};

}  // namespace

Page* make_course_page(AppContext& context, const Place&) { return new CoursePage(context); }

}  // namespace placode::ui
