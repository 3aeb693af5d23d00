// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Study run: leads one participant through the protocol, step by step. What is done is in the
// store, so that an interruption costs nothing: the page goes on where the participant stopped.

#include <QDateTime>
#include <QHBoxLayout>
#include <algorithm>
#include <utility>

#include "curriculum/study.h"
#include "db/study_conduct.h"
#include "reports/words.h"
#include "ui/shell/consent_form.h"
#include "ui/shell/pages.h"
#include "ui/shell/parts.h"
#include "ui/shell/study_parts.h"

namespace placode::ui {
namespace {

using curriculum::StepKind;
using curriculum::StudyStep;

class StudyRunPage : public Page {
    Q_DECLARE_TR_FUNCTIONS(StudyRunPage)
 public:
    StudyRunPage(AppContext& context, const Place& place)
        : Page(context),
          code_(place.text),
          study_(place.state.value("study").toString().toStdString()),
          after_attempt_(place.state.value("after_attempt").toBool()),
          consent_draft_(place.state.value("consent").toMap()) {
        context.require(db::Action::kRunQuestionnaire);
        for (const db::Progress& each : db::study_progress(context.store(), study_))
            if (each.participant.code == code_.toStdString()) progress_ = each;
        const auto protocol =
            db::published_study(context.store(), study_, progress_.participant.protocol_version);
        if (!protocol || progress_.participant.code.empty())
            throw db::StoreError(db::StoreError::Kind::kNotFound,
                                 "study " + study_ + ": has no participant " + code_.toStdString() +
                                     " with a published protocol");
        protocol_ = *protocol;
        QVBoxLayout* column = make_column(this, 900);
        column->addWidget(make_label(context.in(protocol_.title), "display"));
        column->addWidget(make_label(tr("Participant %1 · step %2 of %3")
                                         .arg(code_)
                                         .arg(std::min(stepNumber(), progress_.total))
                                         .arg(progress_.total),
                                     "muted"));
        column->addWidget(stepsCard());
        const StudyStep* step =
            progress_.participant.withdrawal ? nullptr : protocol_.step(progress_.next);
        if (step == nullptr || step->kind != StepKind::kConsent) consent_draft_.clear();
        if (step != nullptr)
            column->addWidget(stepCard(*step));
        else
            column->addWidget(finishedCard());
        auto* row = new QHBoxLayout;
        QPushButton* leave =
            make_button(context, tr("Interrupt, back to the study"), "quiet", "back");
        leave->setObjectName("interrupt_run");
        connect(leave, &QPushButton::clicked, this, [this] { backToStudy(); });
        row->addWidget(leave);
        row->addStretch();
        // Everybody may stop without saying why, and finds the way to it on every step.
        if (step != nullptr && step->kind != StepKind::kConsent) {
            QPushButton* stop = make_button(context, tr("I want to stop"), "secondary", "close");
            stop->setObjectName("stop_taking_part");
            connect(stop, &QPushButton::clicked, this, [this] { stopTakingPart(); });
            row->addWidget(stop);
        }
        column->addLayout(row);
        column->addStretch();
    }

    [[nodiscard]] QString title() const override { return tr("Participant %1").arg(code_); }
    [[nodiscard]] QVariantMap state() const override {
        return {{"study", qstr(study_)}, {"consent", consent_draft_}};
    }
    [[nodiscard]] bool mayLeave() override {
        return consent_draft_.isEmpty() || confirm(this, tr("Leave the consent unfinished?"),
                                                   tr("The ticks and the signature are not kept."),
                                                   tr("Leave"), tr("Stay here"));
    }
    [[nodiscard]] bool mayTranslate() override {
        return consent_draft_.isEmpty() ||
               confirm(this, tr("Read the consent in another language?"),
                       tr("Consent is given in the language that it was read in: the ticks and the "
                          "signature are cleared."),
                       tr("Change the language"), tr("Stay here"));
    }

 protected:
    /// Enter goes on: whoever submitted a questionnaire by keys has no other focus. Not after an
    /// attempt, whose end is a held Enter, and never to begin one: that is a click, or Tab and
    /// Enter.
    void showEvent(QShowEvent* event) override {
        Page::showEvent(event);
        if (event->spontaneous()) return;
        QWidget* first = main_ != nullptr ? static_cast<QWidget*>(main_) : this;
        first->setFocus(Qt::OtherFocusReason);
    }

 private:
    [[nodiscard]] QString nameOf(const StudyStep& step) const {
        const QString name = context_.in(step.title);
        return name.isEmpty() ? qstr(step.id) : name;
    }

    /// Of the step that is asked for now; skipped ones are behind it, too.
    [[nodiscard]] int stepNumber() const {
        return progress_.done + static_cast<int>(progress_.skipped.size()) + 1;
    }

    QWidget* stepsCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace4);
        for (const StudyStep& step : protocol_.steps) {
            if (!step.for_arm(progress_.participant.arm)) continue;
            const std::string key = std::to_string(progress_.visit) + "/" + step.id;
            const auto& done = progress_.finished;
            const bool finished = std::find(done.begin(), done.end(), key) != done.end();
            const bool now = step.id == progress_.next;
            const auto& over = progress_.skipped;
            const bool skipped = std::find(over.begin(), over.end(), key) != over.end();
            QLabel* line =
                make_label((skipped    ? "–  "
                            : finished ? "✓  "
                            : now      ? "▸  "
                                       : "    ") +
                               (skipped ? tr("%1 (skipped)").arg(nameOf(step)) : nameOf(step)),
                           now                    ? "heading"
                           : finished && !skipped ? "good"
                                                  : "muted");
            line->setObjectName("step_line_" + qstr(step.id));
            layout->addWidget(line);
        }
        return make_card(layout);
    }

    QWidget* stepCard(const StudyStep& step) {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace12);
        layout->addWidget(make_label(nameOf(step), "title"));
        switch (step.kind) {
            case StepKind::kConsent:
                layout->addWidget(make_consent_form(
                    context_, protocol_.consent,
                    {[this](const auto& agreed, const QString& signature) {
                         giveConsent(agreed, signature);
                     },
                     [this] { refuseConsent(); },
                     [this](const QVariantMap& draft) { consent_draft_ = draft; }},
                    QVariantMap(consent_draft_)));
                break;
            case StepKind::kBriefing:
                for (const auto& text : step.text) layout->addWidget(make_label(context_.in(text)));
                addButton(layout, tr("Read, go on"), "step_done", [this] { finishStep(); });
                break;
            case StepKind::kQuestionnaire:
                addButton(layout, tr("Answer the questions"), "step_questionnaire", [this, step] {
                    Q_EMIT go({PageId::kParticipant,
                               0,
                               code_,
                               {{"questionnaire", qstr(step.questionnaire)},
                                {"study", qstr(study_)},
                                {"visit", progress_.visit},
                                {"run", true}}});
                });
                break;
            case StepKind::kFamiliarisation:
            case StepKind::kProcedure:
                addAttempt(layout, step);
                break;
        }
        QFrame* card = make_card(layout);
        card->setProperty("tone", "accent");
        return card;
    }

    QPushButton* addButton(QVBoxLayout* layout, const QString& text, const char* name,
                           const std::function<void()>& work) {
        QPushButton* button = make_button(context_, text, "primary", "next");
        button->setObjectName(name);
        connect(button, &QPushButton::clicked, this, work);
        layout->addWidget(button, 0, Qt::AlignRight);
        if (after_attempt_ || button->objectName() == "start_attempt") return button;
        main_ = button;
        setFocusProxy(button);  // the window hands the focus of the page before to this one
        return button;
    }

    /// Nothing of who does not consent may be used.
    void refuseConsent() {
        if (!confirm(window(), tr("You do not consent?"),
                     tr("You take no part, and nothing of you is used. You need not give a "
                        "reason. Please hand the screen back to the coordinator afterwards."),
                     tr("I do not consent")))
            return;
        end(db::WithdrawalMode::kStop, "did not consent");
    }

    /// What becomes of the data is asked in person: it may be used less later, never more.
    void stopTakingPart() {
        if (!confirm(window(), tr("Stop taking part?"),
                     tr("Your run ends here for good. You need not give a reason. Tell the "
                        "coordinator whether your data to date may be used, are used no more, or "
                        "are erased."),
                     tr("I want to stop")))
            return;
        end(db::WithdrawalMode::kKeep, "stopped by the participant; use of the data to be asked");
    }

    void end(db::WithdrawalMode mode, const char* reason) {
        context_.guard(tr("Ending the run"), [&] {
            context_.store().studies().withdraw(study_, code_.toStdString(), mode, reason);
            again();
        });
    }

    void giveConsent(const std::vector<std::string>& agreed, const QString& signature) {
        context_.guard(tr("Recording the consent"), [&] {
            db::record_consent(context_.store(), study_, code_.toStdString(),
                               context_.language().toStdString(), agreed, signature.toStdString());
            again();
        });
    }

    void addAttempt(QVBoxLayout* layout, const StudyStep& step) {
        QString text = tr("A window with the fetoscope's view opens.");
        if (const double limit = step_limit_s(step); limit > 0)
            text += " " + tr("It closes by itself after %1.").arg(format_duration(limit));
        if (step.min_s > 0)
            text +=
                " " +
                tr("An attempt shorter than %1 does not count.").arg(format_duration(step.min_s));
        // What is to be done. A task that is not there is said at the start.
        QString goal;
        (void)context_.problemOf(
            [&] { goal = context_.in(curriculum::load_task(step.task).goal); });
        if (!goal.isEmpty()) {
            QLabel* asked = make_label(goal);
            asked->setObjectName("run_goal");
            layout->addWidget(asked);
        }
        layout->addWidget(make_label(text, "muted"));
        if (!progress_.open_because.empty()) {
            QLabel* open = make_label(
                tr("The attempt before does not count: %1. Please do this step once more.")
                    .arg(reports::not_done_words(progress_.open_because, progress_.open_meaning)),
                "warn");
            open->setObjectName("open_because");
            layout->addWidget(open);
        }
        // The protocol's, or the coordinator's choice: never the participant's.
        const QString device =
            qstr(step.device.empty() ? progress_.participant.device : step.device);
        QLabel* shown =
            make_label(device.isEmpty() ? tr("No device is chosen. Please call the coordinator.")
                                        : tr("Device: %1").arg(device_name(device.toStdString())),
                       device.isEmpty() ? "warn" : "body");
        shown->setObjectName("run_device");
        layout->addWidget(shown);
        addButton(layout, tr("Start"), "start_attempt", [this, device, step] {
            if (std::exchange(waits_, true)) return;  // the second click of two
            // As on the page of a task: what is still worked on must not spoil the procedure.
            if (context_.busy())
                Q_EMIT notice(
                    tr("One moment: the procedure begins when what is being saved is "
                       "saved."));
            context_.whenIdle(this, [this, step, device] {
                waits_ = false;
                start(step, device);
            });
        })->setEnabled(!device.isEmpty());
        if (step.kind != StepKind::kFamiliarisation) return;
        QPushButton* skip = make_button(context_, tr("Not needed, go on"), "quiet");
        skip->setObjectName("step_skip");
        connect(skip, &QPushButton::clicked, this, [this] { finishStep(db::StepState::kSkipped); });
        layout->addWidget(skip, 0, Qt::AlignRight);
    }

    void start(const StudyStep& step, const QString& device) {
        context_.guard(tr("Starting the attempt"), [&] {
            context_.require(db::Action::kPerformAttempt);
            const curriculum::Task task = curriculum::load_task(step.task);
            AttemptOrder order;
            order.user_id = context_.user().id;
            order.user_name = code_;  // Whoever is signed in: it is the participant's.
            order.task = qstr(task.id);
            order.title = nameOf(step);
            order.device = device;
            order.started_utc = QDateTime::currentDateTimeUtc().toString(Qt::ISODate);
            order.demonstration =
                context_.user().demonstration || progress_.participant.demonstration;
            order.study = qstr(study_);
            order.participant = code_;
            order.step = qstr(step.id);
            order.visit = progress_.visit;
            order.aids = qstr(curriculum::aid_names(step.allowed_aids()));
            order.min_s = step.min_s;
            order.duration_s = step.max_s > 0 ? step.max_s : step.time_limit_s.value_or(0);
            order.store = server_place(context_.storeUrl());
            context_.launcher().start(order, context_.recordingsFolder());
            Q_EMIT go({PageId::kRunning, 0, {}, {}});
        });
    }

    QWidget* finishedCard() {
        auto* layout = new QVBoxLayout;
        layout->addWidget(make_label(tr("Thank you."), "title"));
        layout->addWidget(make_label(
            progress_.participant.withdrawal
                ? tr("Your run has ended; nothing more is recorded. Please hand the screen back to "
                     "the coordinator.")
                : tr("Everything is done. Please hand the screen back to the coordinator."),
            "muted"));
        addButton(layout, tr("Back to the study"), "run_finished", [this] { backToStudy(); });
        return make_card(layout);
    }

    void finishStep(db::StepState state = db::StepState::kDone) {
        context_.guard(tr("Recording the step"), [&] {
            db::StepRecord record;
            record.study_id = study_;
            record.participant = code_.toStdString();
            record.visit = progress_.visit;
            record.step = progress_.next;
            record.state = state;
            context_.store().studies().record_step(record);
            again();
        });
    }

    /// What stood in the form of consent is in the store, or of no use any more.
    void again() {
        consent_draft_.clear();
        Q_EMIT go({PageId::kStudyRun, 0, code_, {{"study", qstr(study_)}}});
    }
    void backToStudy() { Q_EMIT go({PageId::kStudies, 0, {}, {{"study", qstr(study_)}}}); }

    QString code_;
    std::string study_;
    bool after_attempt_ = false;  ///< One has just ended, perhaps by a key that is still held.
    QVariantMap consent_draft_;   ///< Ticks and signature that are not recorded yet.
    curriculum::StudyProtocol protocol_;
    db::Progress progress_;
    QPushButton* main_ = nullptr;  ///< What leads on from this step.
    bool waits_ = false;           ///< A start that waits for what is being saved.
};

}  // namespace

Page* make_study_run_page(AppContext& context, const Place& place) {
    return new StudyRunPage(context, place);
}

}  // namespace placode::ui
