// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/study_entry_card.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLineEdit>
#include <algorithm>
#include <memory>

#include "db/study_conduct.h"
#include "ui/shell/parts.h"
#include "ui/shell/study_parts.h"

namespace placode::ui {
namespace {

/// In the context of the page that the card is on.
struct EntryWords {
    Q_DECLARE_TR_FUNCTIONS(StudyDataPage)
};

/// What the card's buttons work with; lives as long as they do.
struct Entry {
    AppContext& context;
    Page& page;
    std::string study;
    std::vector<db::AnswerRecord> answers;
    std::vector<db::EntryDifference> differences;
    std::function<QString()> selected;
    std::function<void()> again;
    QTableWidget* table = nullptr;  ///< Of the differences.

    [[nodiscard]] QStringList questionnaires() const;
    void enter(const QString& questionnaire, bool second) const;
    [[nodiscard]] QTableWidget* make_table_of_differences();
    void decide(int right, const QLineEdit* reason) const;
};

/// Those of the protocol, and those with answers.
QStringList Entry::questionnaires() const {
    QStringList ids;
    if (const auto protocol = db::published_study(context.store(), study))
        for (const auto& step : protocol->steps)
            if (!step.questionnaire.empty()) ids << qstr(step.questionnaire);
    for (const auto& each : answers) ids << qstr(each.questionnaire_id);
    ids.removeDuplicates();
    return ids;
}

void Entry::enter(const QString& questionnaire, bool second) const {
    QVariantMap state{{"questionnaire", questionnaire}, {"study", qstr(study)}, {"paper", !second}};
    if (second) {
        const auto first = std::find_if(answers.begin(), answers.end(), [&](const auto& each) {
            return qstr(each.participant) == selected() &&
                   qstr(each.questionnaire_id) == questionnaire;
        });
        if (first == answers.end()) {
            context.report(
                {EntryWords::tr("There is no first entry."),
                 EntryWords::tr("%1 has no answers to %2; enter the sheet from paper first.")
                     .arg(selected(), questionnaire),
                 {}});
            return;
        }
        state["second_of"] = QVariant::fromValue<qint64>(first->id);
        state["version"] = first->questionnaire_version;
    }
    Q_EMIT page.go({PageId::kParticipant, 0, selected(), state});
}

QTableWidget* Entry::make_table_of_differences() {
    table = make_table(
        {EntryWords::tr("Code"), EntryWords::tr("Questionnaire"), EntryWords::tr("Item"),
         EntryWords::tr("First entry"), EntryWords::tr("Second entry"), EntryWords::tr("Typed by")},
        EntryWords::tr("Differences between entries"));
    table->setObjectName("differences_table");
    table->setSortingEnabled(false);
    table->setRowCount(static_cast<int>(differences.size()));
    for (int row = 0; row < table->rowCount(); ++row) {
        const db::EntryDifference& each = differences[static_cast<size_t>(row)];
        int column = 0;
        for (const std::string& text : {each.participant, each.questionnaire_id, each.item,
                                        each.first, each.second, each.entered_by})
            table->setItem(row, column++, make_cell(text.empty() ? "–" : qstr(text)));
    }
    fit_columns(table, 2);
    table->setMinimumHeight(std::min(6, table->rowCount() + 1) * kTouchTarget + 10);
    table->selectRow(0);
    return table;
}

void Entry::decide(int right, const QLineEdit* reason) const {
    const int row = table->currentRow();
    if (row < 0) return;
    context.guard(EntryWords::tr("Deciding a difference"), [&] {
        context.require(db::Action::kRunQuestionnaire);
        db::decide_difference(context.store(), differences[static_cast<size_t>(row)], right,
                              reason->text().trimmed().toStdString());
        again();
    });
}

}  // namespace

QWidget* make_entry_card(AppContext& context, Page& page, const std::string& study,
                         const std::vector<db::AnswerRecord>& answers,
                         const std::vector<db::EntryDifference>& differences,
                         const std::function<QString()>& selected,
                         const std::function<void()>& again) {
    const auto entry =
        std::make_shared<Entry>(Entry{context, page, study, answers, differences, selected, again});
    auto* layout = new QVBoxLayout;
    layout->setSpacing(kSpace12);
    layout->addWidget(make_label(EntryWords::tr("Entry from paper"), "heading"));
    layout->addWidget(make_label(
        EntryWords::tr(
            "Type a sheet twice, best by two people: Placode lists where the entries differ."),
        "muted"));
    auto* row = new QHBoxLayout;
    row->setSpacing(kSpace8);
    auto* forms = new QComboBox;
    forms->setObjectName("entry_questionnaire");
    forms->setAccessibleName(EntryWords::tr("Questionnaire"));
    for (const QString& id : entry->questionnaires()) forms->addItem(id, id);
    row->addWidget(forms, 1);
    QPushButton* first = make_action(
        context, &page, EntryWords::tr("Enter from paper"), "secondary", "plus", "enter_first",
        [entry, forms] { entry->enter(forms->currentData().toString(), false); });
    QPushButton* second = make_action(
        context, &page, EntryWords::tr("Enter a second time"), "secondary", "again", "enter_second",
        [entry, forms] { entry->enter(forms->currentData().toString(), true); });
    for (QPushButton* button : {first, second}) {
        button->setEnabled(forms->count() > 0);  // Nobody has answered, no protocol.
        row->addWidget(button);
    }
    layout->addLayout(row);
    if (differences.empty()) {
        layout->addWidget(make_label(EntryWords::tr("There are no open differences."), "small"));
        return make_card(layout);
    }
    layout->addWidget(entry->make_table_of_differences());
    auto* decide = new QHBoxLayout;
    decide->setSpacing(kSpace8);
    auto* reason = make_line("decide_reason", EntryWords::tr("Reason: \"looked at the sheet\""));
    decide->addWidget(reason, 1);
    for (const int right : {1, 2})
        decide->addWidget(make_action(context, &page,
                                      right == 1 ? EntryWords::tr("The first is right")
                                                 : EntryWords::tr("The second is right"),
                                      "secondary", "check",
                                      right == 1 ? "first_is_right" : "second_is_right",
                                      [entry, right, reason] { entry->decide(right, reason); }));
    layout->addLayout(decide);
    return make_card(layout);
}

}  // namespace placode::ui
