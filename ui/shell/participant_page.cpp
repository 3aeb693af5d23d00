// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Participant: one person answers one questionnaire. Answer, review, submit; the rail is hidden,
// because the screen belongs to somebody who has no account here.

#include <QDateTime>
#include <QHBoxLayout>
#include <QPointer>
#include <QScrollArea>
#include <QStackedWidget>
#include <algorithm>
#include <utility>

#include "db/study_conduct.h"
#include "db/study_records.h"
#include "reports/words.h"
#include "ui/shell/answer_fields.h"
#include "ui/shell/answers_given.h"
#include "ui/shell/pages.h"
#include "ui/shell/participant_steps.h"
#include "ui/shell/parts.h"
#include "ui/shell/study_preview.h"

namespace placode::ui {
namespace {

using curriculum::QuestionnaireItem;

class ParticipantPage : public Page {
    Q_DECLARE_TR_FUNCTIONS(ParticipantPage)
 public:
    ParticipantPage(AppContext& context, const Place& place)
        : Page(context),
          code_(place.text),
          preview_(place.state.value("preview").toString()),
          unsaved_(place.state.value("unsaved").toBool()),
          questionnaire_(questionnaireOf(context, place)),
          study_(place.state.value("study", place.state.value("questionnaire"))
                     .toString()
                     .toStdString()),
          visit_(place.state.value("visit", 1).toInt()),
          run_(place.state.value("run").toBool()),
          rating_of_(place.state.value("rating_of").toLongLong()),
          second_of_(place.state.value("second_of").toLongLong()),
          paper_(place.state.value("paper").toBool()),
          submitted_(place.state.value("submitted").toBool()) {
        if (rating_of_ != 0)
            context.require(db::Action::kViewAttempts, db::Scope::kOther);
        else
            context.require(db::Action::kRunQuestionnaire);
        given_.takeFrom(place.state);
        auto* layout = new QVBoxLayout(this);
        layout->setContentsMargins(0, 0, 0, 0);
        steps_ = new QStackedWidget;
        layout->addWidget(steps_);
        // Saved once: built anew in another language, the answers must not be there to send again.
        if (submitted_)
            showThanks();
        else
            steps_->addWidget(answerStep());
    }

    [[nodiscard]] QString title() const override {
        if (!preview_.isEmpty()) return tr("Preview");
        if (second_of_ != 0) return tr("Second entry of %1").arg(code_);
        return rating_of_ != 0 ? tr("Rate an attempt") : tr("Participant %1").arg(code_);
    }
    [[nodiscard]] QVariantMap state() const override {
        QVariantMap kept{{"questionnaire", qstr(questionnaire_.id)},
                         {"study", qstr(study_)},
                         {"visit", visit_},
                         {"run", run_},
                         {"rating_of", QVariant::fromValue<qint64>(rating_of_)},
                         {"second_of", QVariant::fromValue<qint64>(second_of_)},
                         {"version", questionnaire_.version},
                         {"paper", paper_},
                         {"preview", preview_},
                         {"unsaved", unsaved_},
                         {"submitted", submitted_}};
        if (!submitted_) given_.keepIn(kept);
        return kept;
    }
    [[nodiscard]] bool mayLeave() override {
        if (!preview_.isEmpty()) return mayLeavePreview();
        if (submitted_ || given_.all().empty()) return true;
        return confirm(this, tr("Leave without submitting?"),
                       tr("The answers given so far are not saved."), tr("Leave"),
                       tr("Go on answering"));
    }

 private:
    /// The answers are nobody's, but the text exists nowhere else. Back to its editor it is safe.
    [[nodiscard]] bool mayLeavePreview() {
        if (std::exchange(to_editor_, false) || !unsaved_) return true;
        return confirm(this, tr("Leave without saving?"),
                       tr("The text was changed and neither published nor exported."), tr("Leave"),
                       tr("Stay here"));
    }

    /// The text of an editor, the version that the store keeps, or what is shipped.
    static curriculum::Questionnaire questionnaireOf(AppContext& context, const Place& place) {
        const std::string preview = place.state.value("preview").toString().toStdString();
        if (!preview.empty()) return curriculum::load_questionnaire_text(preview, "preview");
        const std::string id = place.state.value("questionnaire").toString().toStdString();
        const int version = place.state.value("version").toInt();
        if (const auto published = context.store().definitions().find("questionnaire", id, version))
            return curriculum::load_questionnaire_text(published->json, "questionnaire " + id);
        return curriculum::load_questionnaire(id);
    }

    void addNote(QVBoxLayout* column) {
        QString note;
        if (!preview_.isEmpty()) note = tr("Preview: nothing is saved.");
        if (paper_) note = tr("Entry from paper of %1: type what the sheet says.").arg(code_);
        if (second_of_ != 0)
            note = tr("Second entry from paper of %1: the first one is not shown.").arg(code_);
        if (!note.isEmpty()) column->addWidget(make_badge(note, "accent"));
    }

    QWidget* answerStep() {
        auto* step = new QWidget;
        QVBoxLayout* column = make_column(step, 900);
        addNote(column);
        column->addWidget(make_label(context_.in(questionnaire_.title), "display"));
        column->addWidget(make_label(context_.in(questionnaire_.introduction), "muted"));
        std::string section;
        for (const QuestionnaireItem& item : questionnaire_.items) {
            if (item.section != section)
                for (const auto& each : questionnaire_.sections)
                    if (each.id == item.section) addSection(column, each);
            section = item.section;
            column->addWidget(itemCard(item));
        }
        showBranches();
        message_ = make_label({}, "critical");
        message_->setObjectName("participant_message");
        message_->hide();
        column->addWidget(message_);
        auto* row = new QHBoxLayout;
        QPushButton* cancel = make_button(context_, tr("Cancel"), "quiet", "close");
        cancel->setObjectName("cancel_participant");
        connect(cancel, &QPushButton::clicked, this, [this] { leave(); });
        QPushButton* review = make_button(context_, tr("Review the answers"), "primary", "next");
        review->setObjectName("review");
        connect(review, &QPushButton::clicked, this, [this] { this->review(); });
        row->addWidget(cancel);
        row->addStretch();
        row->addWidget(review);
        column->addLayout(row);
        column->addStretch();
        return step;
    }

    void addSection(QVBoxLayout* column, const curriculum::Section& section) {
        column->addWidget(make_label(context_.in(section.title), "heading"));
        if (!section.introduction.en.empty())
            column->addWidget(make_label(context_.in(section.introduction), "muted"));
    }

    /// Questions are counted as they are seen: one that an answer hides leaves no gap.
    [[nodiscard]] QString markOf(const QuestionnaireItem& item) const {
        return qstr(
            curriculum::question_mark(questionnaire_, item, showsAll() ? nullptr : &given_.all()));
    }
    [[nodiscard]] QString headingOf(const QuestionnaireItem& item) const {
        QString text = markOf(item) + "  " + context_.in(item.text);
        if (!item.required) text += tr(" (may be left out)");
        return text;
    }
    /// A preview shows every question, with its condition, until the first answer.
    [[nodiscard]] bool showsAll() const { return !preview_.isEmpty() && !previewed_; }

    QWidget* itemCard(const QuestionnaireItem& item) {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace12);
        QLabel* heading = make_label(headingOf(item), "heading");
        heading->setObjectName("question_" + qstr(item.id));
        headings_[item.id] = heading;
        layout->addWidget(heading);
        add_answer_field(layout, context_,
                         {item, context_.in(item.text), given_.of(item.id), this,
                          [this, id = item.id](const QString& text) { keep(id, text); },
                          // A field is left, too, when the window is taken down.
                          [page = QPointer<ParticipantPage>(this), &item] {
                              if (page) page->mark(item.id, page->problemOf(item));
                          }});
        if (const QString notes = item_notes(context_, questionnaire_, item);
            !preview_.isEmpty() && !notes.isEmpty()) {
            QLabel* label = make_label(notes, "small");
            label->setObjectName("notes_" + qstr(item.id));
            layout->addWidget(label);
        }
        QLabel* missing = make_label({}, "critical");
        missing->setObjectName("missing_" + qstr(item.id));
        missing->hide();
        missing_[item.id] = missing;
        layout->addWidget(missing);
        QFrame* card = make_card(layout);
        card->setObjectName("card_" + qstr(item.id));
        cards_[item.id] = card;
        return card;
    }

    void keep(const std::string& id, const QString& text) {
        given_.set(id, text);
        mark(id, {});
        message_->hide();
        showBranches();
    }

    /// Items that an answer hides: their answers are put aside, and come back with them.
    void showBranches() {
        if (!preview_.isEmpty() && !branching_seen_) {
            branching_seen_ = true;  // Who builds it sees every question first, with its condition.
            return;
        }
        for (const QuestionnaireItem& item : questionnaire_.items) {
            if (!item.show_if) continue;
            cards_[item.id]->setVisible(given_.follow(item));
        }
        previewed_ = branching_seen_;
        for (const QuestionnaireItem& item : questionnaire_.items)
            headings_[item.id]->setText(headingOf(item));
    }

    /// In the colour of what is wrong, and in words: the colour of focus says something else.
    void mark(const std::string& id, const QString& problem) {
        QFrame* card = cards_[id];
        card->setProperty("tone", problem.isEmpty() ? "" : "critical");
        card->style()->unpolish(card);
        card->style()->polish(card);
        missing_[id]->setText(problem);
        missing_[id]->setVisible(!problem.isEmpty());
    }

    [[nodiscard]] QString problemOf(const QuestionnaireItem& item) const {
        return answer_problem(context_, item, given_.of(item.id));
    }

    /// The first field of the question that can be answered by keys.
    void focusOn(const std::string& id) {
        for (QWidget* field : cards_[id]->findChildren<QWidget*>())
            if (field->objectName().startsWith("answer_") && field->focusPolicy() != Qt::NoFocus)
                return field->setFocus(Qt::OtherFocusReason);
    }

    /// All answers that are missing or impossible are marked at once; the message names them all.
    [[nodiscard]] bool complete() {
        const QuestionnaireItem* first = nullptr;
        QStringList missing_marks, problems;
        for (const QuestionnaireItem& item : questionnaire_.items) {
            const bool asked = curriculum::is_shown(questionnaire_, item, given_.all());
            const bool missing = asked && item.required && given_.all().count(item.id) == 0;
            const QString problem = asked ? problemOf(item) : QString();
            mark(item.id, missing ? tr("This question needs an answer.") : problem);
            if (missing) missing_marks << markOf(item);
            if (!problem.isEmpty()) problems << problem;
            if ((missing || !problem.isEmpty()) && first == nullptr) first = &item;
        }
        if (!missing_marks.isEmpty())
            problems.prepend(
                missing_marks.size() == 1
                    ? tr("Question %1 needs an answer.").arg(missing_marks.front())
                    : tr("Questions %1 need an answer.").arg(missing_marks.join(", ")));
        if (first == nullptr) {
            // What only the whole shows, e.g. an answer to a hidden question.
            if (const auto problem = curriculum::check_answers(questionnaire_, given_.all()))
                problems << reports::said_words(*problem);
        }
        message_->setText(problems.join("\n"));
        message_->setVisible(!problems.isEmpty());
        if (first == nullptr) return problems.isEmpty();
        focusOn(first->id);
        if (auto* scroll = steps_->currentWidget()->findChild<QScrollArea*>())
            scroll->ensureWidgetVisible(cards_[first->id]);
        return false;
    }

    void showStep(QWidget* step, const char* button) {
        steps_->addWidget(step);
        steps_->setCurrentWidget(step);
        step->findChild<QPushButton*>(button)->setFocus();
    }

    void review() {
        if (!complete()) return;
        const auto mark = [this](const QuestionnaireItem& item) { return markOf(item); };
        QWidget* step = make_review_step(context_, questionnaire_, given_.all(), mark);
        connect(step->findChild<QPushButton*>("change_answers"), &QPushButton::clicked, this,
                [this, step] {
                    steps_->removeWidget(step);
                    step->deleteLater();
                });
        connect(step->findChild<QPushButton*>("submit_answers"), &QPushButton::clicked, this,
                [this] { submit(); });
        showStep(step, "submit_answers");
    }

    void submit() {
        if (submitted_) return;
        if (rating_of_ != 0) return saveRating();
        if (second_of_ != 0) return saveSecondEntry();
        if (!preview_.isEmpty()) return leave();
        context_.guard(tr("Saving the answers"), [this] {
            db::AnswerRecord record;
            record.study_id = study_;
            record.participant = code_.toStdString();
            record.questionnaire_id = questionnaire_.id;
            record.questionnaire_version = questionnaire_.version;
            record.answered_utc =
                QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
            record.answers = given_.all();
            record.changes = given_.changes();
            record.visit = visit_;
            record.language = context_.language().toStdString();
            record.demonstration = context_.user().demonstration;
            db::submit_answers(context_.store(), questionnaire_, record);
            submitted_ = true;
            run_ || paper_ ? leave() : showThanks();
        });
    }

    void saveRating() {
        context_.guard(tr("Saving the rating"), [this] {
            db::publish_on_first_use(context_.store(), questionnaire_);
            db::RatingRecord rating;
            rating.attempt_id = rating_of_;
            rating.rater_id = context_.user().id;
            rating.questionnaire_id = questionnaire_.id;
            rating.questionnaire_version = questionnaire_.version;
            rating.answers = given_.all();
            (void)context_.store().reviews().save_rating(rating);
            submitted_ = true;
            Q_EMIT notice(tr("The rating is saved."));
            leave();
        });
    }

    void saveSecondEntry() {
        context_.guard(tr("Saving the second entry"), [this] {
            context_.store().records().save_second_entry({second_of_, given_.all(), {}, {}});
            submitted_ = true;
            Q_EMIT notice(tr("The second entry is saved; differences are listed below."));
            leave();
        });
    }

    void leavePreview() {
        to_editor_ = true;
        Q_EMIT go({PageId::kProtocols,
                   0,
                   {},
                   {{"kind", "questionnaire"}, {"text", preview_}, {"unsaved", unsaved_}}});
    }

    /// Back to where the participant came from.
    void leave() {
        if (!preview_.isEmpty())
            leavePreview();
        else if (second_of_ != 0 || paper_)
            Q_EMIT go({PageId::kStudyData, 0, code_, {{"study", qstr(study_)}}});
        else if (rating_of_ != 0)
            Q_EMIT go({PageId::kRatings, 0, {}, {}});
        else if (run_)
            Q_EMIT go({PageId::kStudyRun, 0, code_, {{"study", qstr(study_)}}});
        else
            Q_EMIT go({PageId::kStudies, 0, qstr(questionnaire_.id), {}});
    }

    void showThanks() {
        QWidget* step = make_thanks_step(context_, code_);
        connect(step->findChild<QPushButton*>("participant_done"), &QPushButton::clicked, this,
                [this] { leave(); });
        showStep(step, "participant_done");
    }

    QString code_;
    bool branching_seen_ = false, previewed_ = false;  ///< Of a preview.
    QString preview_;  ///< Text of a questionnaire that is being edited; empty = none.
    bool unsaved_;     ///< That text stands nowhere else.
    curriculum::Questionnaire questionnaire_;
    std::string study_;
    int visit_ = 1;
    bool run_ = false;       ///< Within a study run: goes back to it.
    int64_t rating_of_ = 0;  ///< A rater judges this attempt.
    int64_t second_of_ = 0;  ///< Typed a second time from paper: these answers.
    bool paper_ = false;     ///< Typed from paper by the coordinator.
    AnswersGiven given_{questionnaire_};
    std::map<std::string, QFrame*> cards_;
    std::map<std::string, QLabel*> headings_, missing_;
    QStackedWidget* steps_ = nullptr;
    QLabel* message_ = nullptr;
    bool submitted_ = false;  ///< Saved: what follows is thanks.
    bool to_editor_ = false;  ///< The preview is left for the editor with its text.
};

}  // namespace

Page* make_participant_page(AppContext& context, const Place& place) {
    return new ParticipantPage(context, place);
}

}  // namespace placode::ui
