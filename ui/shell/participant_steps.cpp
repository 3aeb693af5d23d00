// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/participant_steps.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLocale>

#include "ui/shell/parts.h"

namespace placode::ui {

using curriculum::ItemKind;
using curriculum::QuestionnaireItem;

namespace {

struct ParticipantWords {
    Q_DECLARE_TR_FUNCTIONS(ParticipantPage)
};

/// With the words that the value had where it was chosen: 1 may be the best and the worst.
QString likert_words(const AppContext& context, const QuestionnaireItem& item,
                     const QString& given) {
    const int value = given.toInt();
    if (!item.point_labels.empty())
        return given + "  " +
               context.in(item.point_labels.at(static_cast<size_t>(value - item.scale_min)));
    const QString words = ParticipantWords::tr("%1 of %2").arg(given).arg(item.scale_max);
    if (value == item.scale_min) return words + ", " + context.in(item.anchor_low);
    if (value == item.scale_max) return words + ", " + context.in(item.anchor_high);
    return words;
}

/// An answer as it is read in the review.
QString answer_words(const AppContext& context, const QuestionnaireItem& item,
                     const QString& given) {
    if (given.isEmpty()) return "–";
    if (given == curriculum::kNotApplicable && item.not_applicable)
        return ParticipantWords::tr("does not apply");
    if (item.kind == ItemKind::kMultiple) {
        QStringList chosen;
        for (const int index :
             curriculum::answer_indices(given.toStdString()).value_or(std::vector<int>{}))
            chosen << context.in(item.choices.at(static_cast<size_t>(index)));
        return chosen.join(", ");
    }
    if (item.kind == ItemKind::kChoice) return context.in(item.choices.at(given.toUInt()));
    if (item.kind == ItemKind::kLikert) return likert_words(context, item, given);
    if (item.kind != ItemKind::kNumber && item.kind != ItemKind::kVisualAnalogue) return given;
    return with_unit(QString(given).replace('.', QLocale().decimalPoint()), item.unit);
}

}  // namespace

QString with_unit(const QString& number, const std::string& unit) {
    if (unit.empty()) return number;
    if (unit != "years") return number + " " + qstr(unit);
    bool whole = false;
    const int years = number.toInt(&whole);
    return whole ? ParticipantWords::tr("%n year(s)", nullptr, years)
                 : ParticipantWords::tr("%1 years", "a number that is not whole").arg(number);
}

QString answer_problem(const AppContext& context, const QuestionnaireItem& item,
                       const QString& answer) {
    const std::string given = answer.toStdString();
    if (given.empty() || !curriculum::check_answer(item, given)) return {};
    const QString name = context.in(item.text);
    const auto said = [](double limit) { return QLocale().toString(limit, 'g', 6); };
    switch (item.kind) {
        case ItemKind::kNumber:
        case ItemKind::kVisualAnalogue:
            return ParticipantWords::tr("%1: a number from %2 to %3")
                .arg(name, said(item.number_min), with_unit(said(item.number_max), item.unit));
        case ItemKind::kDate:
            return ParticipantWords::tr("%1: a date such as 2026-11-21").arg(name);
        default:
            return ParticipantWords::tr("%1: one of the answers that are offered").arg(name);
    }
}

QWidget* make_review_step(AppContext& context, const curriculum::Questionnaire& questionnaire,
                          const curriculum::Answers& answers,
                          const std::function<QString(const QuestionnaireItem&)>& mark) {
    auto* step = new QWidget;
    QVBoxLayout* column = make_column(step, 900);
    column->addWidget(make_label(ParticipantWords::tr("Review"), "display"));
    column->addWidget(make_label(
        ParticipantWords::tr("Nothing is saved yet. Go back to change an answer, or submit."),
        "muted"));
    auto* layout = new QVBoxLayout;
    layout->setSpacing(kSpace12);
    for (const QuestionnaireItem& item : questionnaire.items) {
        if (!curriculum::is_shown(questionnaire, item, answers)) continue;
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace16);
        row->addWidget(make_label(mark(item) + "  " + context.in(item.text)), 1);
        const auto found = answers.find(item.id);
        QLabel* given = make_label(
            answer_words(context, item, found == answers.end() ? QString() : qstr(found->second)),
            "heading");
        given->setAlignment(Qt::AlignRight);
        given->setMaximumWidth(320);
        row->addWidget(given);
        layout->addLayout(row);
        layout->addWidget(make_rule());
    }
    column->addWidget(make_card(layout));
    auto* row = new QHBoxLayout;
    QPushButton* change = make_button(context, ParticipantWords::tr("Change"), "secondary", "back");
    change->setObjectName("change_answers");
    QPushButton* submit = make_button(context, ParticipantWords::tr("Submit"), "primary", "check");
    submit->setObjectName("submit_answers");
    row->addWidget(change);
    row->addStretch();
    row->addWidget(submit);
    column->addLayout(row);
    column->addStretch();
    return step;
}

QWidget* make_thanks_step(AppContext& context, const QString& code) {
    auto* step = new QWidget;
    auto* layout = new QVBoxLayout(step);
    layout->setSpacing(kSpace16);
    layout->addStretch();
    for (QLabel* label :
         {make_label(ParticipantWords::tr("Thank you."), "display"),
          make_label(ParticipantWords::tr("The answers of %1 are saved. Please hand the screen "
                                          "back to the coordinator.")
                         .arg(code),
                     "muted")}) {
        label->setAlignment(Qt::AlignCenter);
        layout->addWidget(label);
    }
    QPushButton* done =
        make_button(context, ParticipantWords::tr("Back to the study"), "primary", "next");
    done->setObjectName("participant_done");
    layout->addWidget(done, 0, Qt::AlignHCenter);
    layout->addStretch();
    return step;
}

}  // namespace placode::ui
