// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/study_entry_card.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <algorithm>
#include <map>
#include <memory>
#include <optional>

#include "db/study_conduct.h"
#include "ui/shell/parts.h"
#include "ui/shell/study_parts.h"
#include "ui/shell/typed_texts.h"

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
    EntryData data;
    QTableWidget* people;
    std::function<void()> again;
    std::map<int, std::optional<curriculum::StudyProtocol>> protocols{};  ///< By version.
    QComboBox *forms = nullptr, *visits = nullptr, *sets = nullptr;
    QTableWidget* table = nullptr;  ///< Of the differences.

    [[nodiscard]] QStringList questionnaires() const;
    [[nodiscard]] QString selected() const;
    void makeForms();
    void makeVisits();
    void makeSets();
    [[nodiscard]] int openVisit() const;
    void follow() const;
    void enterFirst() const;
    void enterSecond() const;
    [[nodiscard]] QTableWidget* make_table_of_differences();
    void decide(int right, const QLineEdit* reason) const;
};

/// Those of the protocol, and those with answers.
QStringList Entry::questionnaires() const {
    QStringList ids;
    if (const auto protocol = db::published_study(context.store(), data.study))
        for (const auto& step : protocol->steps)
            if (!step.questionnaire.empty()) ids << qstr(step.questionnaire);
    for (const auto& each : data.answers) ids << qstr(each.questionnaire_id);
    ids.removeDuplicates();
    return ids;
}

QString Entry::selected() const {
    const int row = people->currentRow();
    return row < 0 ? QString() : people->item(row, 0)->text();
}

void Entry::makeForms() {
    forms = new QComboBox;
    forms->setObjectName("entry_questionnaire");
    forms->setAccessibleName(EntryWords::tr("Questionnaire"));
    for (const QString& id : questionnaires()) forms->addItem(id, id);
}

/// Where there is one visit, nobody has to think of it.
void Entry::makeVisits() {
    int count = 1;
    for (const db::Progress& each : data.progress) {
        const int version = each.participant.protocol_version;
        if (version > 0 && !protocols.contains(version))
            protocols[version] = db::published_study(context.store(), data.study, version);
    }
    for (const auto& [version, protocol] : protocols)
        if (protocol) count = std::max(count, protocol->visits);
    for (const auto& each : data.answers) count = std::max(count, each.visit);
    visits = new QComboBox;
    visits->setObjectName("entry_visit");
    visits->setAccessibleName(EntryWords::tr("Visit"));
    for (int visit = 1; visit <= count; ++visit)
        visits->addItem(EntryWords::tr("Visit %1").arg(visit), visit);
    if (count == 1) visits->hide();
}

/// The first visit in which the participant has not answered the questionnaire yet; else the last
/// that asks for it.
int Entry::openVisit() const {
    const std::string asked = forms->currentData().toString().toStdString();
    int last = 1;
    for (const db::Progress& each : data.progress) {
        const auto found = protocols.find(each.participant.protocol_version);
        if (qstr(each.participant.code) != selected() || found == protocols.end() || !found->second)
            continue;
        for (int visit = 1; visit <= found->second->visits; ++visit) {
            for (const auto& step : found->second->steps) {
                if (step.questionnaire != asked || !step.for_arm(each.participant.arm) ||
                    !db::asked_at(step, visit))
                    continue;
                last = visit;
                const std::string key = std::to_string(visit) + "/" + step.id;
                if (std::ranges::find(each.finished, key) == each.finished.end()) return visit;
            }
        }
    }
    return last;
}

void Entry::makeSets() {
    sets = new QComboBox;
    sets->setObjectName("entry_second_of");
    sets->setAccessibleName(EntryWords::tr("First entry"));
    sets->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    sets->setMinimumContentsLength(28);
}

/// What the boxes offer, for the chosen participant and questionnaire.
void Entry::follow() const {
    visits->setCurrentIndex(visits->findData(openVisit()));
    sets->clear();
    for (const db::AnswerRecord& each : data.answers)
        if (qstr(each.participant) == selected() &&
            qstr(each.questionnaire_id) == forms->currentData().toString())
            sets->addItem(EntryWords::tr("%1, visit %2, %3")
                              .arg(selected())
                              .arg(each.visit)
                              .arg(format_when(each.answered_utc)),
                          QVariant::fromValue<qint64>(each.id));
}

void Entry::enterFirst() const {
    Q_EMIT page.go({PageId::kParticipant,
                    0,
                    selected(),
                    {{"questionnaire", forms->currentData()},
                     {"study", qstr(data.study)},
                     {"visit", visits->currentData()},
                     {"paper", true}}});
}

void Entry::enterSecond() const {
    const qint64 id = sets->currentData().toLongLong();
    const auto first = std::ranges::find(data.answers, id, &db::AnswerRecord::id);
    if (first == data.answers.end()) {
        context.report({EntryWords::tr("There is no first entry."),
                        EntryWords::tr("%1 has no answers to %2; enter the sheet from paper first.")
                            .arg(selected(), forms->currentData().toString()),
                        {}});
        return;
    }
    Q_EMIT page.go({PageId::kParticipant,
                    0,
                    qstr(first->participant),
                    {{"questionnaire", qstr(first->questionnaire_id)},
                     {"study", qstr(data.study)},
                     {"visit", first->visit},
                     {"version", first->questionnaire_version},
                     {"second_of", id}}});
}

QTableWidget* Entry::make_table_of_differences() {
    table =
        make_table({EntryWords::tr("Code"), EntryWords::tr("Questionnaire"), EntryWords::tr("Item"),
                    EntryWords::tr("First entry"), EntryWords::tr("Second entry"),
                    EntryWords::tr("Typed by"), EntryWords::tr("Visit"), EntryWords::tr("When")},
                   EntryWords::tr("Differences between entries"));
    table->setObjectName("differences_table");
    table->setSortingEnabled(false);
    table->setRowCount(static_cast<int>(data.differences.size()));
    for (int row = 0; row < table->rowCount(); ++row) {
        const db::EntryDifference& each = data.differences[static_cast<size_t>(row)];
        int column = 0;
        for (const std::string& text : {each.participant, each.questionnaire_id, each.item,
                                        each.first, each.second, each.entered_by})
            table->setItem(row, column++, make_cell(text.empty() ? "–" : qstr(text)));
        table->setItem(row, column++, make_number_cell(QString::number(each.visit), each.visit));
        table->setItem(row, column, make_cell(format_when(each.answered_utc)));
    }
    fit_columns(table, 2);
    table->setMinimumHeight(std::min(6, table->rowCount() + 1) * kTouchTarget + 10);
    table->selectRow(0);
    keep_choice(table);
    return table;
}

void Entry::decide(int right, const QLineEdit* reason) const {
    const int row = table->currentRow();
    if (row < 0) return;
    context.guard(EntryWords::tr("Deciding a difference"), [&] {
        context.require(db::Action::kRunQuestionnaire);
        db::decide_difference(context.store(), data.differences[static_cast<size_t>(row)], right,
                              reason->text().trimmed().toStdString());
        again();
    });
}

QLayout* entry_grid(const std::shared_ptr<Entry>& entry) {
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(kSpace8);
    grid->setVerticalSpacing(kSpace8);
    grid->setColumnStretch(0, 1);
    entry->makeForms();
    entry->makeVisits();
    entry->makeSets();
    grid->addWidget(entry->forms, 0, 0);
    grid->addWidget(entry->visits, 0, 1);
    grid->addWidget(entry->sets, 1, 0, 1, 2);
    QPushButton* first =
        make_action(entry->context, &entry->page, EntryWords::tr("Enter from paper"), "secondary",
                    "plus", "enter_first", [entry] { entry->enterFirst(); });
    QPushButton* second =
        make_action(entry->context, &entry->page, EntryWords::tr("Enter a second time"),
                    "secondary", "again", "enter_second", [entry] { entry->enterSecond(); });
    for (QPushButton* button : {first, second}) {
        button->setEnabled(entry->forms->count() > 0);  // Nobody has answered, no protocol.
        grid->addWidget(button, button == first ? 0 : 1, 2);
    }
    const auto follow = [entry] { entry->follow(); };
    QObject::connect(entry->forms, &QComboBox::currentIndexChanged, entry->sets, follow);
    QObject::connect(entry->people, &QTableWidget::itemSelectionChanged, entry->sets, follow);
    follow();
    return grid;
}

}  // namespace

QWidget* make_entry_card(AppContext& context, Page& page, const EntryData& data,
                         QTableWidget* people, const std::function<void()>& again) {
    const auto entry = std::make_shared<Entry>(Entry{context, page, data, people, again});
    auto* layout = new QVBoxLayout;
    layout->setSpacing(kSpace12);
    layout->addWidget(make_label(EntryWords::tr("Entry from paper"), "heading"));
    layout->addWidget(make_label(
        EntryWords::tr(
            "Type a sheet twice, best by two people: Placode lists where the entries differ."),
        "muted"));
    layout->addLayout(entry_grid(entry));
    if (data.differences.empty()) {
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
