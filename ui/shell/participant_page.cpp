// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Participant: one person answers one questionnaire. Answer, review, submit; the rail is hidden,
// because the screen belongs to somebody who has no account here.

#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QDateTime>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QRadioButton>
#include <QScrollArea>
#include <QSlider>
#include <QStackedWidget>
#include <algorithm>

#include "db/study_conduct.h"
#include "ui/shell/pages.h"
#include "ui/shell/parts.h"

namespace placode::ui {
namespace {

using curriculum::ItemKind;
using curriculum::QuestionnaireItem;

constexpr int kNoValue = 1000;  ///< "does not apply" among the values of a scale.

class ParticipantPage : public Page {
    Q_DECLARE_TR_FUNCTIONS(ParticipantPage)
 public:
    ParticipantPage(AppContext& context, const Place& place)
        : Page(context),
          code_(place.text),
          questionnaire_(curriculum::load_questionnaire(
              place.state.value("questionnaire").toString().toStdString())),
          study_(place.state.value("study", place.state.value("questionnaire"))
                     .toString()
                     .toStdString()),
          visit_(place.state.value("visit", 1).toInt()),
          run_(place.state.value("run").toBool()),
          rating_of_(place.state.value("rating_of").toLongLong()) {
        if (rating_of_ != 0)
            context.require(db::Action::kViewAttempts, db::Scope::kOther);
        else
            context.require(db::Action::kRunQuestionnaire);
        const QVariantMap kept = place.state.value("answers").toMap();
        for (auto it = kept.begin(); it != kept.end(); ++it)
            answers_[it.key().toStdString()] = it.value().toString().toStdString();
        for (const QVariant& each : place.state.value("changes").toList()) {
            const QStringList change = each.toStringList();
            changes_.push_back({change.value(0).toStdString(), change.value(1).toStdString(),
                                change.value(2).toStdString(), change.value(3).toStdString()});
        }
        auto* layout = new QVBoxLayout(this);
        layout->setContentsMargins(0, 0, 0, 0);
        steps_ = new QStackedWidget;
        layout->addWidget(steps_);
        steps_->addWidget(answerStep());
    }

    [[nodiscard]] QString title() const override {
        return rating_of_ != 0 ? tr("Rate an attempt") : tr("Participant %1").arg(code_);
    }
    [[nodiscard]] bool alone() const override { return rating_of_ == 0; }
    [[nodiscard]] QVariantMap state() const override {
        QVariantMap kept;
        for (const auto& [id, answer] : answers_) kept[qstr(id)] = qstr(answer);
        QVariantList changes;
        for (const db::AnswerChange& each : changes_)
            changes << QStringList{qstr(each.item), qstr(each.old_answer), qstr(each.new_answer),
                                   qstr(each.at_utc)};
        return {{"answers", kept},
                {"changes", changes},
                {"questionnaire", qstr(questionnaire_.id)},
                {"study", qstr(study_)},
                {"visit", visit_},
                {"run", run_},
                {"rating_of", QVariant::fromValue<qint64>(rating_of_)}};
    }
    [[nodiscard]] bool mayLeave() override {
        if (submitted_ || answers_.empty()) return true;
        return confirm(this, tr("Leave without submitting?"),
                       tr("The answers given so far are not saved."), tr("Leave"));
    }

 private:
    QWidget* answerStep() {
        auto* step = new QWidget;
        QVBoxLayout* column = make_column(step, 900);
        column->addWidget(make_label(context_.in(questionnaire_.title), "display"));
        column->addWidget(make_label(context_.in(questionnaire_.introduction), "muted"));
        std::string section;
        for (const QuestionnaireItem& item : questionnaire_.items) {
            if (item.section != section)
                for (const auto& each : questionnaire_.sections)
                    if (each.id == item.section)
                        column->addWidget(make_label(context_.in(each.title), "heading"));
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

    /// The letter of an item, or its number where the id is a word for machines.
    [[nodiscard]] QString markOf(const QuestionnaireItem& item) const {
        if (item.id.size() <= 2) return qstr(item.id);
        return QString::number(&item - questionnaire_.items.data() + 1);
    }

    QWidget* itemCard(const QuestionnaireItem& item) {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace12);
        QString text = markOf(item) + "  " + context_.in(item.text);
        if (!item.required) text += tr(" (may be left out)");
        layout->addWidget(make_label(text, "heading"));
        switch (item.kind) {
            case ItemKind::kLikert:
                if (item.point_labels.empty())
                    layout->addLayout(scale(item));
                else
                    layout->addLayout(labelledScale(item));
                break;
            case ItemKind::kChoice:
                layout->addWidget(choice(item));
                break;
            case ItemKind::kMultiple:
                layout->addLayout(multiple(item));
                break;
            case ItemKind::kDate:
                layout->addWidget(date(item));
                break;
            case ItemKind::kVisualAnalogue:
                layout->addLayout(analogue(item));
                break;
            default:
                layout->addWidget(line(item));
        }
        if (item.not_applicable && item.kind != ItemKind::kLikert)
            layout->addWidget(doesNotApply(item));
        QFrame* card = make_card(layout);
        cards_[item.id] = card;
        return card;
    }

    QHBoxLayout* scale(const QuestionnaireItem& item) {
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace8);
        QLabel* low = make_label(context_.in(item.anchor_low), "muted");
        low->setFixedWidth(150);
        low->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        row->addWidget(low);
        auto* group = new QButtonGroup(this);
        for (int value = item.scale_min; value <= item.scale_max; ++value) {
            auto* button = new QRadioButton(QString::number(value));
            button->setObjectName(QString("answer_%1_%2").arg(qstr(item.id)).arg(value));
            QString name = tr("%1: %2 of %3").arg(markOf(item)).arg(value).arg(item.scale_max);
            if (value == item.scale_min) name += ", " + context_.in(item.anchor_low);
            if (value == item.scale_max) name += ", " + context_.in(item.anchor_high);
            button->setAccessibleName(name);
            button->setMinimumSize(72, kTouchTarget);
            button->setChecked(answer(item.id) == QString::number(value));
            group->addButton(button, value);
            row->addWidget(button);
        }
        QLabel* high = make_label(context_.in(item.anchor_high), "muted");
        high->setFixedWidth(150);
        row->addWidget(high);
        if (item.not_applicable) {
            auto* none = new QRadioButton(tr("does not apply"));
            none->setObjectName(QString("answer_%1_NA").arg(qstr(item.id)));
            none->setMinimumHeight(kTouchTarget);
            none->setChecked(answer(item.id) == curriculum::kNotApplicable);
            group->addButton(none, kNoValue);
            row->addWidget(none);
        }
        row->addStretch();
        connect(group, &QButtonGroup::idClicked, this, [this, id = item.id](int value) {
            keep(id,
                 value == kNoValue ? QString(curriculum::kNotApplicable) : QString::number(value));
        });
        return row;
    }

    /// Every value with its words, one below the other.
    QVBoxLayout* labelledScale(const QuestionnaireItem& item) {
        auto* column = new QVBoxLayout;
        auto* group = new QButtonGroup(this);
        const auto add = [&](int value, const QString& text, const QString& name, bool checked) {
            auto* button = new QRadioButton(text);
            button->setObjectName(QString("answer_%1_%2").arg(qstr(item.id), name));
            button->setMinimumHeight(kTouchTarget);
            button->setChecked(checked);
            group->addButton(button, value);
            column->addWidget(button);
        };
        for (int value = item.scale_min; value <= item.scale_max; ++value) {
            const auto& label = item.point_labels.at(static_cast<size_t>(value - item.scale_min));
            const QString number = QString::number(value);
            add(value, number + "  " + context_.in(label), number, answer(item.id) == number);
        }
        if (item.not_applicable)
            add(kNoValue, tr("does not apply"), "NA",
                answer(item.id) == curriculum::kNotApplicable);
        connect(group, &QButtonGroup::idClicked, this, [this, id = item.id](int value) {
            keep(id,
                 value == kNoValue ? QString(curriculum::kNotApplicable) : QString::number(value));
        });
        return column;
    }

    QVBoxLayout* multiple(const QuestionnaireItem& item) {
        auto* column = new QVBoxLayout;
        const auto given = curriculum::answer_indices(answer(item.id).toStdString());
        std::vector<QCheckBox*> boxes;
        for (size_t i = 0; i < item.choices.size(); ++i) {
            auto* box = new QCheckBox(context_.in(item.choices[i]));
            box->setObjectName(QString("answer_%1_%2").arg(qstr(item.id)).arg(i));
            box->setMinimumHeight(kTouchTarget);
            box->setChecked(given && std::find(given->begin(), given->end(), static_cast<int>(i)) !=
                                         given->end());
            boxes.push_back(box);
            column->addWidget(box);
        }
        for (QCheckBox* box : boxes) {
            connect(box, &QCheckBox::clicked, this, [this, boxes, id = item.id] {
                QStringList chosen;
                for (size_t i = 0; i < boxes.size(); ++i)
                    if (boxes[i]->isChecked()) chosen << QString::number(i);
                keep(id, chosen.join(';'));
            });
        }
        return column;
    }

    QWidget* date(const QuestionnaireItem& item) {
        auto* edit = new QLineEdit(answer(item.id));
        edit->setObjectName("answer_" + qstr(item.id));
        edit->setAccessibleName(context_.in(item.text));
        edit->setPlaceholderText(tr("year-month-day, e.g. 2026-11-21"));
        edit->setMaximumWidth(320);
        connect(edit, &QLineEdit::textChanged, this,
                [this, edit, id = item.id] { keep(id, edit->text().trimmed()); });
        return edit;
    }

    /// A line without marks. Nothing is answered before it was touched.
    QHBoxLayout* analogue(const QuestionnaireItem& item) {
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace12);
        row->addWidget(make_label(context_.in(item.anchor_low), "muted"));
        auto* slider = new QSlider(Qt::Horizontal);
        slider->setObjectName("answer_" + qstr(item.id));
        slider->setAccessibleName(context_.in(item.text));
        slider->setRange(static_cast<int>(item.number_min), static_cast<int>(item.number_max));
        slider->setMinimumSize(360, kTouchTarget);
        slider->setValue(answer(item.id).isEmpty() ? (slider->minimum() + slider->maximum()) / 2
                                                   : answer(item.id).toInt());
        auto* state =
            make_label(answer(item.id).isEmpty() ? tr("not answered") : tr("answered"), "small");
        const auto take = [this, slider, state, id = item.id] {
            keep(id, QString::number(slider->value()));
            state->setText(tr("answered"));
        };
        connect(slider, &QSlider::valueChanged, this, take);
        connect(slider, &QSlider::sliderReleased, this, take);  // a tap on the middle counts
        row->addWidget(slider, 1);
        row->addWidget(make_label(context_.in(item.anchor_high), "muted"));
        row->addWidget(state);
        return row;
    }

    QWidget* doesNotApply(const QuestionnaireItem& item) {
        auto* box = new QCheckBox(tr("does not apply"));
        box->setObjectName(QString("answer_%1_NA").arg(qstr(item.id)));
        box->setChecked(answer(item.id) == curriculum::kNotApplicable);
        connect(box, &QCheckBox::clicked, this, [this, id = item.id](bool on) {
            keep(id, on ? QString(curriculum::kNotApplicable) : QString());
        });
        return box;
    }

    QWidget* choice(const QuestionnaireItem& item) {
        auto* box = new QComboBox;
        box->setObjectName("answer_" + qstr(item.id));
        box->setAccessibleName(context_.in(item.text));
        box->addItem(tr("Choose …"), -1);
        for (size_t i = 0; i < item.choices.size(); ++i)
            box->addItem(context_.in(item.choices[i]), static_cast<int>(i));
        const QString given = answer(item.id);
        if (!given.isEmpty()) box->setCurrentIndex(given.toInt() + 1);
        box->setMaximumWidth(420);
        connect(box, &QComboBox::currentIndexChanged, this, [this, box, id = item.id] {
            const int value = box->currentData().toInt();
            keep(id, value < 0 ? QString() : QString::number(value));
        });
        return box;
    }

    QWidget* line(const QuestionnaireItem& item) {
        if (item.kind == ItemKind::kText) {
            auto* edit = new QPlainTextEdit(answer(item.id));
            edit->setObjectName("answer_" + qstr(item.id));
            edit->setAccessibleName(context_.in(item.text));
            edit->setTabChangesFocus(true);
            edit->setFixedHeight(110);
            connect(edit, &QPlainTextEdit::textChanged, this,
                    [this, edit, id = item.id] { keep(id, edit->toPlainText().trimmed()); });
            return edit;
        }
        auto* edit = new QLineEdit(answer(item.id));
        edit->setObjectName("answer_" + qstr(item.id));
        edit->setAccessibleName(context_.in(item.text));
        edit->setPlaceholderText(qstr(item.unit));
        edit->setMaximumWidth(240);
        // A comma is a decimal point to half of Europe; the store always holds '.'.
        connect(edit, &QLineEdit::textChanged, this,
                [this, edit, id = item.id] { keep(id, edit->text().trimmed().replace(',', '.')); });
        return edit;
    }

    [[nodiscard]] QString answer(const std::string& id) const {
        const auto found = answers_.find(id);
        return found == answers_.end() ? QString() : qstr(found->second);
    }

    /// Every change is kept with its time; typing in one field is one change.
    void logChange(const std::string& id, const std::string& before, const std::string& now) {
        if (before == now) return;
        const std::string at = QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
        const QuestionnaireItem* item = questionnaire_.item(id);
        const bool typed = item->kind == ItemKind::kText || item->kind == ItemKind::kNumber ||
                           item->kind == ItemKind::kDate || item->kind == ItemKind::kVisualAnalogue;
        if (typed && !changes_.empty() && changes_.back().item == id) {
            changes_.back().new_answer = now;
            changes_.back().at_utc = at;
        } else {
            changes_.push_back({id, before, now, at});
        }
    }

    void keep(const std::string& id, const QString& text) {
        logChange(id, answer(id).toStdString(), text.toStdString());
        if (text.isEmpty()) {
            answers_.erase(id);
        } else {
            answers_[id] = text.toStdString();
        }
        unmark(id);
        showBranches();
    }

    /// Items that an answer hides: their answers are put aside, and come back with them.
    void showBranches() {
        for (const QuestionnaireItem& item : questionnaire_.items) {
            if (!item.show_if) continue;
            const bool shown = curriculum::is_shown(questionnaire_, item, answers_);
            if (shown && aside_.contains(item.id)) {
                answers_[item.id] = aside_[item.id];
                aside_.erase(item.id);
            } else if (!shown && answers_.contains(item.id)) {
                aside_[item.id] = answers_[item.id];
                answers_.erase(item.id);
            }
            cards_[item.id]->setVisible(shown);
        }
    }

    void unmark(const std::string& id) {
        mark(id, "");
        message_->hide();
    }

    void mark(const std::string& id, const char* tone) {
        QFrame* card = cards_[id];
        card->setProperty("tone", tone);
        card->style()->unpolish(card);
        card->style()->polish(card);
    }

    /// All answers that are missing are marked; the message names the first problem.
    [[nodiscard]] bool complete() {
        const QuestionnaireItem* first = nullptr;
        for (const QuestionnaireItem& item : questionnaire_.items) {
            const bool missing = item.required && answers_.count(item.id) == 0 &&
                                 curriculum::is_shown(questionnaire_, item, answers_);
            mark(item.id, missing ? "accent" : "");
            if (missing && first == nullptr) first = &item;
        }
        if (first != nullptr) {
            message_->setText(tr("Question %1 needs an answer.").arg(markOf(*first)));
            message_->show();
            if (auto* scroll = steps_->currentWidget()->findChild<QScrollArea*>())
                scroll->ensureWidgetVisible(cards_[first->id]);
            return false;
        }
        const auto problem = curriculum::check_answers(questionnaire_, answers_);
        message_->setText(problem ? qstr(*problem) : QString());
        message_->setVisible(problem.has_value());
        return !problem;
    }

    void review() {
        if (!complete()) return;
        auto* step = new QWidget;
        QVBoxLayout* column = make_column(step, 900);
        column->addWidget(make_label(tr("Review"), "display"));
        column->addWidget(make_label(
            tr("Nothing is saved yet. Go back to change an answer, or submit."), "muted"));
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace12);
        for (const QuestionnaireItem& item : questionnaire_.items) {
            if (!curriculum::is_shown(questionnaire_, item, answers_)) continue;
            auto* row = new QHBoxLayout;
            row->setSpacing(kSpace16);
            row->addWidget(make_label(markOf(item) + "  " + context_.in(item.text)), 1);
            QLabel* given = make_label(shown(item), "heading");
            given->setAlignment(Qt::AlignRight);
            given->setMaximumWidth(320);
            row->addWidget(given);
            layout->addLayout(row);
            layout->addWidget(make_rule());
        }
        column->addWidget(make_card(layout));
        auto* row = new QHBoxLayout;
        QPushButton* change = make_button(context_, tr("Change"), "secondary", "back");
        change->setObjectName("change_answers");
        connect(change, &QPushButton::clicked, this, [this, step] {
            steps_->removeWidget(step);
            step->deleteLater();
        });
        QPushButton* submit = make_button(context_, tr("Submit"), "primary", "check");
        submit->setObjectName("submit_answers");
        connect(submit, &QPushButton::clicked, this, [this] { this->submit(); });
        row->addWidget(change);
        row->addStretch();
        row->addWidget(submit);
        column->addLayout(row);
        column->addStretch();
        steps_->addWidget(step);
        steps_->setCurrentWidget(step);
        submit->setFocus();
    }

    [[nodiscard]] QString shown(const QuestionnaireItem& item) const {
        const QString given = answer(item.id);
        if (given.isEmpty()) return "–";
        if (given == curriculum::kNotApplicable && item.not_applicable) return tr("does not apply");
        if (item.kind == ItemKind::kMultiple) {
            QStringList chosen;
            for (const int index :
                 curriculum::answer_indices(given.toStdString()).value_or(std::vector<int>{}))
                chosen << context_.in(item.choices.at(static_cast<size_t>(index)));
            return chosen.join(", ");
        }
        if (item.kind == ItemKind::kChoice) return context_.in(item.choices.at(given.toUInt()));
        if (item.kind == ItemKind::kLikert) return tr("%1 of %2").arg(given).arg(item.scale_max);
        return item.unit.empty() ? given : given + " " + qstr(item.unit);
    }

    void submit() {
        if (submitted_) return;
        if (rating_of_ != 0) return saveRating();
        context_.guard(tr("Saving the answers"), [this] {
            db::AnswerRecord record;
            record.study_id = study_;
            record.participant = code_.toStdString();
            record.questionnaire_id = questionnaire_.id;
            record.questionnaire_version = questionnaire_.version;
            record.answered_utc =
                QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
            record.answers = answers_;
            record.changes = changes_;
            record.visit = visit_;
            record.language = context_.language().toStdString();
            record.demonstration = context_.user().demonstration;
            db::submit_answers(context_.store(), questionnaire_, record);
            submitted_ = true;
            run_ ? leave() : showThanks();
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
            rating.answers = answers_;
            (void)context_.store().save_rating(rating);
            submitted_ = true;
            Q_EMIT notice(tr("The rating is saved."));
            leave();
        });
    }

    /// Back to where the participant came from.
    void leave() {
        if (rating_of_ != 0)
            Q_EMIT go({PageId::kRatings, 0, {}, {}});
        else if (run_)
            Q_EMIT go({PageId::kStudyRun, 0, code_, {{"study", qstr(study_)}}});
        else
            Q_EMIT go({PageId::kStudies, 0, qstr(questionnaire_.id), {}});
    }

    void showThanks() {
        auto* step = new QWidget;
        auto* layout = new QVBoxLayout(step);
        layout->setSpacing(kSpace16);
        layout->addStretch();
        for (QLabel* label : {make_label(tr("Thank you."), "display"),
                              make_label(tr("The answers of %1 are saved. Please hand the screen "
                                            "back to the coordinator.")
                                             .arg(code_),
                                         "muted")}) {
            label->setAlignment(Qt::AlignCenter);
            layout->addWidget(label);
        }
        QPushButton* done = make_button(context_, tr("Back to the study"), "primary", "next");
        done->setObjectName("participant_done");
        connect(done, &QPushButton::clicked, this, [this] { leave(); });
        layout->addWidget(done, 0, Qt::AlignHCenter);
        layout->addStretch();
        steps_->addWidget(step);
        steps_->setCurrentWidget(step);
        done->setFocus();
    }

    QString code_;
    curriculum::Questionnaire questionnaire_;
    std::string study_;
    int visit_ = 1;
    bool run_ = false;       ///< Within a study run: goes back to it.
    int64_t rating_of_ = 0;  ///< A rater judges this attempt.
    curriculum::Answers answers_, aside_;
    std::vector<db::AnswerChange> changes_;
    std::map<std::string, QFrame*> cards_;
    QStackedWidget* steps_ = nullptr;
    QLabel* message_ = nullptr;
    bool submitted_ = false;
};

}  // namespace

Page* make_participant_page(AppContext& context, const Place& place) {
    return new ParticipantPage(context, place);
}

}  // namespace placode::ui
