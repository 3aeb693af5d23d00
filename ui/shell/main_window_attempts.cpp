// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of an attempt when its process has ended, and of those that a crash left over.
#include <QFile>
#include <QToolButton>
#include <memory>

#include "ui/diagnostics/program_log.h"
#include "ui/shell/dialog_frame.h"
#include "ui/shell/main_window.h"
#include "ui/shell/parts.h"
#include "ui/shell/waiting_recordings.h"

namespace placode::ui {
namespace {

QString used_up() {
    return MainWindow::tr(
        "It used up this attempt of the exam. An educator can grant another one.");
}

}  // namespace

Place MainWindow::placeOf(const AttemptOrder& order) {
    if (order.study.isEmpty()) return {PageId::kTask, 0, order.task, {}};
    return {
        PageId::kStudyRun, 0, order.participant, {{"study", order.study}, {"after_attempt", true}}};
}

bool MainWindow::isMine(const AttemptOrder& order) const {
    return context_.signedIn() && context_.user().id == order.user_id;
}

QVariantMap MainWindow::historyState() const {
    const QString task = page_ ? page_->aboutTask() : QString();
    return task.isEmpty() ? QVariantMap{} : QVariantMap{{"task", task}};
}

void MainWindow::leaveRunning(const AttemptOrder& order) {
    showPlace(isMine(order) ? placeOf(order) : home());
}

void MainWindow::onAttemptEnded(const AttemptEnding& ending) {
    updateFrame();
    log_note("simulator_ended", {{"exit_status", ending.exit_code},
                                 {"crashed", ending.crashed ? 1 : 0},
                                 {"asked", ending.asked ? 1 : 0}});
    const bool waiting = place_.page == PageId::kRunning;
    // Exit status 2 before the first frame: bad input, e.g. a device that is not there.
    const bool never_began =
        !ending.crashed && ending.exit_code == 2 && context_.launcher().status().time_s <= 0;
    // Of an exam nothing is asked: its case was seen, however it ended. An educator may grant
    // another attempt.
    const bool exam = ending.order.mode() == curriculum::AttemptMode::kExam;
    // Who did not wait until the stage was ready wanted just that.
    if (ending.order.stage > 0 && !ending.crashed && ending.exit_code == 0 &&
        !QFile::exists(ending.order.recording_file)) {
        remove_recording(ending.order.recording_file);
        notices_->showNotice(tr("The attempt was left before it began; nothing was kept."));
        if (waiting) leaveRunning(ending.order);
        return;
    }
    if (never_began || !QFile::exists(ending.order.recording_file)) {
        remove_recording(ending.order.recording_file);
        Problem problem = simulator_problem(
            {ending.crashed, ending.exit_code, false, ending.order.device, ending.message});
        if (exam) problem.way_out = used_up();
        context_.report(problem);
        if (waiting) leaveRunning(ending.order);
        return;
    }
    const bool broke = (ending.crashed || ending.exit_code != 0) && !ending.asked;
    if (broke && exam) {
        Problem problem = simulator_problem(
            {ending.crashed, ending.exit_code, true, ending.order.device, ending.message});
        problem.way_out =
            tr("What was recorded is saved and uses up this attempt of the exam. An "
               "educator can grant another one.");
        context_.report(problem);
    }
    if (broke && !exam) {
        // The person decides what becomes of it; until then the file stays. Of a study it is the
        // coordinator who decides, after taking the screen back.
        const bool study = !ending.order.study.isEmpty();
        if (waiting) showPlace(study ? placeOf(ending.order) : Place{PageId::kRecovery, 0, {}, {}});
        Problem problem = simulator_problem(
            {ending.crashed, ending.exit_code, true, ending.order.device, ending.message});
        if (study) problem.way_out = tr("What was recorded is kept. Please call the coordinator.");
        context_.report(problem);
        return;
    }
    saveAttempt(ending);
}

void MainWindow::saveAttempt(const AttemptEnding& ending) {
    auto saved = std::make_shared<SavedAttempt>();
    context_.savingBegins(ending.order.recording_file);
    // In the name of who began it, also when somebody else sits here by now.
    context_.backgroundFor(
        ending.order.user_id, this, tr("Scoring and saving the attempt"),
        [saved, order = ending.order](db::Store& store) { *saved = save_recording(store, order); },
        [this, saved, ending](bool done) {
            context_.savingEnds(ending.order.recording_file);
            // Who has begun the next attempt meanwhile watches that one.
            const bool waiting = place_.page == PageId::kRunning && !context_.launcher().running();
            if (!done) {
                // The banner has the reason; the recording stays and is offered again.
                if (waiting)
                    showPlace(ending.order.study.isEmpty() ? Place{PageId::kRecovery, 0, {}, {}}
                                                           : placeOf(ending.order));
                return;
            }
            if (saved->outcome == Saving::kGone) {
                if (waiting) leaveRunning(ending.order);
                return;
            }
            if (saved->outcome == Saving::kEmpty) {
                QString what = tr("The attempt was left before it began; nothing was kept.");
                if (ending.order.mode() == curriculum::AttemptMode::kExam) what += " " + used_up();
                notices_->showNotice(what);
                if (waiting) leaveRunning(ending.order);
                return;
            }
            context_.verifyAttempts();
            const AttemptOrder& order = ending.order;
            // A participant is led on; scores are not shown during a study.
            const Place result =
                order.study.isEmpty()
                    ? Place{PageId::kResult, saved->attempt_id, {}, {{"after_attempt", true}}}
                    : placeOf(order);
            if (!isMine(order)) {
                if (waiting) showPlace(home());
                return;
            }
            if (waiting) return showPlace(result);
            notices_->showNotice(
                tr("Your attempt was saved."),
                {order.study.isEmpty() ? tr("Open the result") : tr("Go on with the study"),
                 [this, result] { open(result); }});
        },
        {"scoring", context_.launcher().status().time_s},
        [this, order = ending.order](const std::exception_ptr& error) {
            context_.savingEnds(order.recording_file);
            return keepForLater(order, error);
        },
        Lane::kSaving);
}

bool MainWindow::keepForLater(const AttemptOrder& order, const std::exception_ptr& error) {
    if (!context_.waiting().keep(order, error)) return false;
    Problem problem = problem_of(error, {});
    problem.title = tr("The server is away. The attempt is kept on this computer.");
    problem.way_out = tr("It is saved by itself when the server is back.");
    context_.report(problem);
    return true;
}

void MainWindow::watchWaiting() {
    WaitingRecordings& waiting = context_.waiting();
    connect(&waiting, &WaitingRecordings::changed, this, &MainWindow::updateFrame);
    connect(&waiting, &WaitingRecordings::saved, this, &MainWindow::onWaitingSaved);
    connect(&waiting, &WaitingRecordings::failed, this,
            [this](const Problem& problem) { context_.report(problem); });
    connect(&waiting, &WaitingRecordings::stillAway, this, [this] {
        notices_->showNotice(tr("The server is still away. Placode goes on trying by itself."));
    });
}

void MainWindow::showWaitingCount() {
    const int count = context_.waiting().count();
    waiting_->setText(tr("Waiting: %1").arg(count));
    waiting_->setAccessibleName(waiting_->text());
    waiting_->setVisible(context_.signedIn() && count > 0 && !handedOver());
}

void MainWindow::onWaitingSaved(const AttemptOrder& order, qint64 attempt_id) {
    context_.verifyAttempts();
    if (!isMine(order) || handedOver()) return;
    when_no_question(this, [this] {
        if (place_.page == PageId::kRecovery) showAgain(whatIsShown());
    });
    const QString text = tr("An attempt that was kept on this computer is saved now.");
    // What a participant did is looked at by those who may, where studies are.
    if (!order.study.isEmpty()) return notices_->showNotice(text);
    notices_->showNotice(text, {tr("Open the result"), [this, attempt_id] {
                                    open({PageId::kResult, attempt_id, {}, {}});
                                }});
}

void MainWindow::onReplayed(qint64 attempt_id) {
    when_no_question(this, [this, attempt_id] {
        if (place_.page != PageId::kResult || place_.number != attempt_id || !page_) return;
        const QWidget* typed_in = focusWidget();
        const bool here = typed_in != nullptr && page_->isAncestorOf(typed_in);
        const QString field = here ? typed_in->objectName() : QString();
        showAgain(whatIsShown());
        auto* again = page_ && !field.isEmpty() ? page_->findChild<QWidget*>(field) : nullptr;
        if (again == nullptr) return;
        // Whoever writes a remark writes on, once the page is there.
        QTimer::singleShot(0, again, [again] { again->setFocus(Qt::OtherFocusReason); });
    });
}

void MainWindow::offerLeftovers() {
    int mine = 0;
    Leftover last;
    context_.guard(tr("Looking for unfinished attempts"), [&] {
        const bool all = context_.may(db::Action::kManageUsers, db::Scope::kOther);
        for (Leftover& leftover : context_.leftovers(Depth::kLength)) {
            const bool own = leftover.order && leftover.order->user_id == context_.user().id;
            if (!own && !(all && !leftover.order)) continue;
            if (context_.waiting().holds(leftover.recording_file)) continue;
            ++mine;
            last = std::move(leftover);
        }
    });
    if (mine == 0) return;
    const QString text =
        mine == 1 ? tr("An attempt of %1 was not finished or not saved (%2).")
                        .arg(format_clock(last.started_utc), format_duration(last.duration_s))
                  : tr("Attempts that were not finished or not saved: %1.").arg(mine);
    notices_->showNotice(text, {tr("Look at it"), [this] {
                                    open({PageId::kRecovery, 0, {}, {}});
                                }});
}

}  // namespace placode::ui
