// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/task_exam.h"

#include <QDateTime>
#include <QHBoxLayout>
#include <QLineEdit>

#include "ui/shell/attempt_launcher.h"
#include "ui/shell/course_words.h"
#include "ui/shell/form_keys.h"
#include "ui/shell/parts.h"

namespace placode::ui {
namespace {

std::string exam_now_utc() {
    return QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
}

}  // namespace

void TaskExam::read(const Place& place) {
    course_ = place.state.value("exam_course").toString().toStdString();
    if (course_.empty()) return;
    standing_ = db::course_standing(context_.store(), context_.user().id, course_, exam_now_utc());
    const curriculum::CourseStage* stage =
        standing_.course.stage(place.state.value("exam_stage").toString().toStdString());
    if (stage == nullptr || stage->mode != curriculum::StageMode::kExam) return course_.clear();
    stage_ = *stage;
    const auto at = static_cast<size_t>(stage - standing_.course.stages.data());
    const curriculum::StageProgress& own = standing_.progress.stages[at];
    // Whoever repeats it, as to refresh the skill, uses up none.
    left_ = own.status == curriculum::StageStatus::kMastered ? -1 : own.attempts_left;
}

QFrame* TaskExam::makeCard(const std::function<void()>& submit) {
    auto* layout = new QVBoxLayout;
    layout->setSpacing(kSpace8);
    auto* head = new QHBoxLayout;
    head->addWidget(make_label(tr("Exam"), "heading"));
    head->addWidget(make_badge(context_.in(standing_.course.title), "warn"));
    head->addStretch();
    layout->addLayout(head);
    QLabel* rules = make_label(exam_words(stage_->exam));
    rules->setObjectName("exam_rules");
    layout->addWidget(rules);
    layout->addWidget(make_label(stage_rule_words(*stage_), "small"));
    if (left_ >= 0) layout->addWidget(make_label(tr("Attempts left: %1").arg(left_), "warn"));
    if (stage_->exam.proctor) {
        proctor_ = new QLineEdit;
        proctor_->setObjectName("proctor_login");
        proctor_password_ = new QLineEdit;
        proctor_password_->setObjectName("proctor_password");
        proctor_password_->setEchoMode(QLineEdit::Password);
        layout->addLayout(make_field(tr("Proctor: log-in name"), proctor_));
        layout->addLayout(make_field(tr("Proctor: password"), proctor_password_));
        enter_submits({proctor_, proctor_password_}, proctor_, submit);
        layout->addWidget(make_label(
            tr("An educator or administrator who is present confirms that it may begin."),
            "small"));
    }
    QFrame* card = make_card(layout);
    card->setObjectName("exam_card");
    return card;
}

std::optional<db::UserRecord> TaskExam::confirmedProctor() {
    if (proctor_ == nullptr) return {};
    // The next key belongs to the field that is to be mended.
    const auto refuse = [this](const QString& why) {
        (proctor_->text().trimmed().isEmpty() ? proctor_ : proctor_password_)->setFocus();
        throw Refusal(why);
    };
    if (proctor_->text().trimmed().isEmpty() || proctor_password_->text().isEmpty())
        refuse(tr("The exam begins when a proctor has typed log-in name and password."));
    const db::SignIn found = context_.store().accounts().confirm(
        proctor_->text().trimmed().toStdString(), proctor_password_->text().toStdString());
    proctor_password_->clear();
    if (found.outcome == db::SignInOutcome::kThrottled)
        refuse(tr("Too many wrong passwords. Try again in %1 s.").arg(found.wait_s));
    if (found.outcome != db::SignInOutcome::kOk)
        refuse(tr("The proctor's log-in name or password is wrong."));
    if (found.user->id == context_.user().id)
        refuse(tr("Nobody can be their own proctor; ask somebody who is present."));
    if (!db::has_role(found.user->roles, db::Role::kEducator) &&
        !db::has_role(found.user->roles, db::Role::kAdministrator))
        refuse(tr("%1 is neither educator nor administrator and cannot be the proctor.")
                   .arg(qstr(found.user->display_name)));
    return found.user;
}

void TaskExam::refuseBesideLeftExam() const {
    for (const Leftover& left : find_leftovers(context_.recordingsFolder(), Depth::kLength)) {
        if (!left.order || left.problem || left.duration_s <= 0) continue;
        if (left.order->user_id == context_.user().id && left.order->exam.course_id == course_ &&
            left.order->exam.stage_id == stage_->id)
            throw Refusal(
                tr("An attempt at this exam was not finished and not saved. Save it "
                   "first: it uses up this attempt."));
    }
}

void TaskExam::prepare(AttemptOrder& order, bool haptic) {
    refuseBesideLeftExam();
    const std::string device = order.device.toStdString();
    // The loop of a force device is judged when the attempt is saved; anything else has none.
    const std::optional<db::UserRecord> proctor = confirmedProctor();
    const db::ExamOrder ready = db::prepare_exam(
        context_.store(), context_.user().id, course_, stage_->id,
        proctor ? proctor->login : std::string(), haptic ? device : std::string(), exam_now_utc());
    // What is known not to start uses up nothing.
    context_.launcher().needReady();
    AttemptOrder trial = order;
    write_order(trial, context_.recordingsFolder());  // A full disk shows here.
    remove_recording(trial.recording_file);
    order.exam = db::begin_exam(context_.store(), context_.user().id, ready).context;
    // The file that lies beside the recording names nobody.
    if (proctor) order.exam.proctor = "user " + std::to_string(proctor->id);
    order.seed = ready.seed;
}

}  // namespace placode::ui
