// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/study_corrections_card.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QGridLayout>
#include <QLineEdit>
#include <algorithm>

#include "ui/shell/parts.h"
#include "ui/shell/study_parts.h"
#include "ui/shell/typed_texts.h"

namespace placode::ui {
namespace {

/// In the context of the page that the card is on.
struct CorrectionWords {
    Q_DECLARE_TR_FUNCTIONS(StudyDataPage)
};

constexpr int kParticipantRole = Qt::UserRole + 1;

QTableWidget* corrections_table(const std::vector<db::Correction>& corrections) {
    QTableWidget* table = make_table({CorrectionWords::tr("When"), CorrectionWords::tr("By"),
                                      CorrectionWords::tr("Item"), CorrectionWords::tr("Before"),
                                      CorrectionWords::tr("After"), CorrectionWords::tr("Reason")},
                                     CorrectionWords::tr("Corrections"));
    table->setObjectName("corrections_table");
    table->setSortingEnabled(false);
    table->setRowCount(static_cast<int>(corrections.size()));
    for (int row = 0; row < table->rowCount(); ++row) {
        const db::Correction& each = corrections[static_cast<size_t>(row)];
        table->setItem(row, 0, make_cell(format_when(each.at_utc)));
        int column = 1;
        for (const std::string& text :
             {each.corrected_by, each.item, each.old_answer, each.new_answer, each.reason})
            table->setItem(row, column++, make_cell(text.empty() ? "–" : qstr(text)));
    }
    fit_columns(table, 5);
    table->setMinimumHeight(std::min(6, table->rowCount() + 1) * kTouchTarget + 10);
    return table;
}

QComboBox* make_sets(const std::vector<db::AnswerRecord>& answers, const QTableWidget* people) {
    auto* sets = new QComboBox;
    sets->setObjectName("correct_answers_of");
    sets->setAccessibleName(CorrectionWords::tr("Answers of"));
    sets->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    sets->setMinimumContentsLength(36);
    for (const auto& each : answers)
        sets->addItem(CorrectionWords::tr("%1  %2, visit %3, %4")
                          .arg(qstr(each.participant), qstr(each.questionnaire_id))
                          .arg(each.visit)
                          .arg(format_when(each.answered_utc)),
                      QVariant::fromValue<qint64>(each.id));
    for (int row = 0; row < sets->count(); ++row)
        sets->setItemData(row, qstr(answers[static_cast<size_t>(row)].participant),
                          kParticipantRole);
    // A correction is about whose record is selected above, until another set is chosen.
    const auto follow = [sets, people] {
        const auto* code = people->item(people->currentRow(), 0);
        sets->setCurrentIndex(code != nullptr ? sets->findData(code->text(), kParticipantRole)
                                              : -1);
    };
    QObject::connect(people, &QTableWidget::itemSelectionChanged, sets, follow);
    follow();
    keep_choice(sets);
    return sets;
}

}  // namespace

QWidget* make_corrections_card(AppContext& context, Page& page,
                               const std::vector<db::AnswerRecord>& answers,
                               const std::vector<db::Correction>& corrections,
                               const QTableWidget* people, const std::function<void()>& again) {
    auto* layout = new QVBoxLayout;
    layout->setSpacing(kSpace12);
    layout->addWidget(make_label(CorrectionWords::tr("Corrections"), "heading"));
    layout->addWidget(make_label(
        CorrectionWords::tr("An answer is changed for a reason; the old one stays readable here."),
        "muted"));
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(kSpace8);
    QComboBox* sets = make_sets(answers, people);
    auto* item = make_line("correct_item", CorrectionWords::tr("Item, e.g. A"));
    auto* value =
        make_line("correct_value", CorrectionWords::tr("New answer; empty takes it away"));
    auto* reason = make_line("correct_reason", CorrectionWords::tr("Reason"));
    grid->addWidget(sets, 0, 0, 1, 3);
    grid->addWidget(item, 1, 0);
    grid->addWidget(value, 1, 1, 1, 2);
    grid->addWidget(reason, 2, 0, 1, 2);
    grid->addWidget(make_action(context, &page, CorrectionWords::tr("Correct"), "secondary",
                                "check", "correct_answer",
                                [&context, again, sets, item, value, reason] {
                                    context.guard(CorrectionWords::tr("Correcting an answer"), [&] {
                                        context.require(db::Action::kRunQuestionnaire);
                                        context.store().records().correct_answers(
                                            sets->currentData().toLongLong(), 1,
                                            {{item->text().trimmed().toStdString(),
                                              value->text().trimmed().toStdString()}},
                                            reason->text().trimmed().toStdString());
                                        again();
                                    });
                                }),
                    2, 2);
    layout->addLayout(grid);
    if (!corrections.empty()) layout->addWidget(corrections_table(corrections));
    return make_card(layout);
}

}  // namespace placode::ui
