// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Data of a study: who is complete, lock and signature of records, entry from paper, differences
// between two entries, corrections, and the names behind the codes.

#include <QComboBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <algorithm>

#include "db/study_conduct.h"
#include "db/study_records.h"
#include "reports/dataset.h"
#include "ui/shell/names_card.h"
#include "ui/shell/pages.h"
#include "ui/shell/parts.h"
#include "ui/shell/procedures_card.h"
#include "ui/shell/study_parts.h"

namespace placode::ui {
namespace {

class StudyDataPage : public Page {
    Q_DECLARE_TR_FUNCTIONS(StudyDataPage)
 public:
    StudyDataPage(AppContext& context, const Place& place) : Page(context) {
        context.require(db::Action::kRunQuestionnaire);
        ids_ = context.store().studies().ids();
        study_ = chosen_study(context, ids_, place.state.value("study").toString());
        QVBoxLayout* column = make_column(this);
        auto* head = new QHBoxLayout;
        head->addWidget(make_label(tr("Data"), "display"), 1);
        if (QComboBox* chooser = make_study_chooser(context, ids_, study_)) {
            connect(chooser, &QComboBox::activated, this, [this, chooser] {
                Q_EMIT go(
                    {PageId::kStudyData, 0, {}, {{"study", chooser->currentData().toString()}}});
            });
            head->addWidget(chooser);
        }
        column->addLayout(head);
        if (study_.empty()) {
            column->addWidget(make_label(
                tr("No study has participants yet. Enrol the first one on the page Studies."),
                "muted"));
            QPushButton* open = make_action(context, this, tr("Open the studies"), "primary",
                                            "next", "open_studies", [this] {
                                                Q_EMIT go({PageId::kStudies, 0, {}, {}});
                                            });
            column->addWidget(open, 0, Qt::AlignLeft);
            column->addStretch();
            return;
        }
        read();
        column->addWidget(make_label(summary(), "muted"));
        column->addWidget(recordsCard(place.text));
        auto* procedures = new ProceduresCard(context, *this, study_, [this] { again(); });
        column->addWidget(procedures);
        connect(table_, &QTableWidget::itemSelectionChanged, procedures,
                [this, procedures] { procedures->open(selected().toStdString()); });
        procedures->open(selected().toStdString());
        column->addWidget(entryCard());
        column->addWidget(correctionsCard());
        column->addWidget(make_names_card(context, *this, study_, codes()));
        column->addStretch();
    }

    [[nodiscard]] QString title() const override { return tr("Data"); }
    [[nodiscard]] QVariantMap state() const override { return {{"study", qstr(study_)}}; }

 private:
    void read() {
        db::Store& store = context_.store();
        progress_ = db::study_progress(store, study_);
        answers_ = store.studies().answers(study_);
        states_ = store.records().states(study_);
        differences_ = db::entry_differences(store, study_);
        corrections_ = store.records().corrections(study_);
    }

    [[nodiscard]] QStringList codes() const {
        QStringList list;
        for (const auto& each : progress_) list << qstr(each.participant.code);
        return list;
    }

    [[nodiscard]] QString summary() const {
        const auto count = [&](auto wanted) {
            return std::count_if(progress_.begin(), progress_.end(), wanted);
        };
        const auto complete =
            count([](const auto& each) { return each.total > 0 && each.next.empty(); });
        const auto locked = count([&](const auto& each) {
            const auto found = states_.find(each.participant.code);
            return found != states_.end() && found->second.locked;
        });
        const auto signed_records = count([&](const auto& each) {
            const auto found = states_.find(each.participant.code);
            return found != states_.end() && found->second.signature.has_value();
        });
        return tr("Participants: %1 · complete: %2 · locked: %3 · signed: %4 · differences between "
                  "entries: %5 · corrections: %6")
            .arg(progress_.size())
            .arg(complete)
            .arg(locked)
            .arg(signed_records)
            .arg(differences_.size())
            .arg(corrections_.size());
    }

    [[nodiscard]] QString recordWord(const std::string& code) const {
        const auto found = states_.find(code);
        if (found == states_.end() || !found->second.locked) return tr("open");
        const db::RecordState& state = found->second;
        if (!state.signature) return tr("locked");
        const QString who =
            tr("signed: %1, %2, %3")
                .arg(qstr(state.signature->name), format_when(state.signature->at_utc),
                     qstr(state.signature->remark));
        return state.signature_fits ? who : tr("CHANGED AFTER THE SIGNATURE") + " (" + who + ")";
    }

    QWidget* recordsCard(const QString& chosen) {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace12);
        layout->addWidget(make_label(tr("Records"), "heading"));
        table_ = make_table({tr("Code"), tr("Steps"), tr("Answers"), tr("Record")}, tr("Records"));
        table_->setObjectName("records_table");
        table_->setSortingEnabled(false);
        table_->setRowCount(static_cast<int>(progress_.size()));
        int row = 0, selected = 0;
        for (const db::Progress& each : progress_) {
            const std::string& code = each.participant.code;
            if (qstr(code) == chosen) selected = row;
            const auto sets =
                std::count_if(answers_.begin(), answers_.end(),
                              [&](const auto& record) { return record.participant == code; });
            table_->setItem(row, 0, make_cell(qstr(code)));
            table_->setItem(
                row, 1,
                make_number_cell(
                    each.total == 0 ? QString("–") : tr("%1 of %2").arg(each.done).arg(each.total),
                    each.done));
            table_->setItem(row, 2,
                            make_number_cell(QString::number(sets), static_cast<double>(sets)));
            table_->setItem(row, 3, make_cell(recordWord(code)));
            ++row;
        }
        fit_columns(table_, 3);
        table_->setMinimumHeight(std::min(7, row + 1) * kTouchTarget + 10);
        if (row > 0) table_->selectRow(selected);
        layout->addWidget(table_);
        layout->addLayout(recordActions());
        return make_card(layout);
    }

    /// Asked again for every signature: whose it is must be beyond doubt.
    QLayout* recordActions() {
        auto* grid = new QGridLayout;
        grid->setHorizontalSpacing(kSpace8);
        grid->setVerticalSpacing(kSpace8);
        auto* meaning = make_line("sign_meaning", tr("Meaning: \"reviewed and complete\""));
        auto* password = make_line("sign_password", tr("Your password, again"), true);
        auto* reason = make_line("unlock_reason", tr("Reason for unlocking"));
        grid->addWidget(meaning, 0, 0);
        grid->addWidget(password, 0, 1);
        grid->addWidget(make_action(context_, this, tr("Sign"), "secondary", "check", "sign_record",
                                    [this, meaning, password] {
                                        act(tr("Signing the record"), [&](const std::string& code) {
                                            context_.store().records().sign(
                                                study_, code, context_.user().login,
                                                password->text().toStdString(),
                                                meaning->text().trimmed().toStdString());
                                        });
                                    }),
                        0, 2);
        grid->addWidget(reason, 1, 0, 1, 2);
        grid->addWidget(
            make_action(context_, this, tr("Unlock"), "secondary", "again", "unlock_record",
                        [this, reason] {
                            act(tr("Unlocking the record"), [&](const std::string& code) {
                                context_.store().records().unlock(
                                    study_, code, reason->text().trimmed().toStdString());
                            });
                        }),
            1, 2);
        grid->addWidget(make_action(context_, this, tr("Lock"), "primary", "lock", "lock_record",
                                    [this] {
                                        act(tr("Locking the record"), [&](const std::string& code) {
                                            context_.store().records().lock(study_, code);
                                        });
                                    }),
                        0, 3, 2, 1, Qt::AlignVCenter);
        return grid;
    }

    [[nodiscard]] QString selected() const {
        const int row = table_->currentRow();
        return row < 0 ? QString() : table_->item(row, 0)->text();
    }

    void act(const QString& doing, const std::function<void(const std::string&)>& work) {
        if (selected().isEmpty()) return;
        context_.guard(doing, [&] {
            context_.require(db::Action::kRunQuestionnaire);
            work(selected().toStdString());
            again();
        });
    }

    void again() { Q_EMIT go({PageId::kStudyData, 0, selected(), {{"study", qstr(study_)}}}); }

    QWidget* entryCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace12);
        layout->addWidget(make_label(tr("Entry from paper"), "heading"));
        layout->addWidget(make_label(
            tr("Type a sheet twice, best by two people: Placode lists where the entries differ."),
            "muted"));
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace8);
        auto* forms = new QComboBox;
        forms->setObjectName("entry_questionnaire");
        forms->setAccessibleName(tr("Questionnaire"));
        for (const QString& id : questionnaires()) forms->addItem(id, id);
        row->addWidget(forms, 1);
        QPushButton* first =
            make_action(context_, this, tr("Enter from paper"), "secondary", "plus", "enter_first",
                        [this, forms] { enter(forms->currentData().toString(), false); });
        QPushButton* second = make_action(
            context_, this, tr("Enter a second time"), "secondary", "again", "enter_second",
            [this, forms] { enter(forms->currentData().toString(), true); });
        for (QPushButton* button : {first, second}) {
            button->setEnabled(forms->count() > 0);  // Nobody has answered, no protocol.
            row->addWidget(button);
        }
        layout->addLayout(row);
        if (differences_.empty()) {
            layout->addWidget(make_label(tr("There are no open differences."), "small"));
            return make_card(layout);
        }
        layout->addWidget(differencesTable());
        auto* decide = new QHBoxLayout;
        decide->setSpacing(kSpace8);
        auto* reason = make_line("decide_reason", tr("Reason: \"looked at the sheet\""));
        decide->addWidget(reason, 1);
        for (const int right : {1, 2})
            decide->addWidget(make_action(
                context_, this, right == 1 ? tr("The first is right") : tr("The second is right"),
                "secondary", "check", right == 1 ? "first_is_right" : "second_is_right",
                [this, right, reason] { decideDifference(right, reason); }));
        layout->addLayout(decide);
        return make_card(layout);
    }

    /// Those of the protocol, and those with answers.
    [[nodiscard]] QStringList questionnaires() const {
        QStringList ids;
        if (const auto protocol = db::published_study(context_.store(), study_))
            for (const auto& step : protocol->steps)
                if (!step.questionnaire.empty()) ids << qstr(step.questionnaire);
        for (const auto& each : answers_) ids << qstr(each.questionnaire_id);
        ids.removeDuplicates();
        return ids;
    }

    void enter(const QString& questionnaire, bool second) {
        QVariantMap state{
            {"questionnaire", questionnaire}, {"study", qstr(study_)}, {"paper", !second}};
        if (second) {
            const auto first =
                std::find_if(answers_.begin(), answers_.end(), [&](const auto& each) {
                    return qstr(each.participant) == selected() &&
                           qstr(each.questionnaire_id) == questionnaire;
                });
            if (first == answers_.end()) {
                context_.report({tr("There is no first entry."),
                                 tr("%1 has no answers to %2; enter the sheet from paper first.")
                                     .arg(selected(), questionnaire),
                                 {}});
                return;
            }
            state["second_of"] = QVariant::fromValue<qint64>(first->id);
            state["version"] = first->questionnaire_version;
        }
        Q_EMIT go({PageId::kParticipant, 0, selected(), state});
    }

    QTableWidget* differencesTable() {
        differences_table_ = make_table({tr("Code"), tr("Questionnaire"), tr("Item"),
                                         tr("First entry"), tr("Second entry"), tr("Typed by")},
                                        tr("Differences between entries"));
        QTableWidget* table = differences_table_;
        table->setObjectName("differences_table");
        table->setSortingEnabled(false);
        table->setRowCount(static_cast<int>(differences_.size()));
        for (int row = 0; row < table->rowCount(); ++row) {
            const db::EntryDifference& each = differences_[static_cast<size_t>(row)];
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

    void decideDifference(int right, QLineEdit* reason) {
        const int row = differences_table_->currentRow();
        if (row < 0) return;
        context_.guard(tr("Deciding a difference"), [&] {
            context_.require(db::Action::kRunQuestionnaire);
            db::decide_difference(context_.store(), differences_[static_cast<size_t>(row)], right,
                                  reason->text().trimmed().toStdString());
            again();
        });
    }

    QWidget* correctionsCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace12);
        layout->addWidget(make_label(tr("Corrections"), "heading"));
        layout->addWidget(make_label(
            tr("An answer is changed for a reason; the old one stays readable here."), "muted"));
        auto* grid = new QGridLayout;
        grid->setHorizontalSpacing(kSpace8);
        auto* sets = new QComboBox;
        sets->setObjectName("correct_answers_of");
        sets->setAccessibleName(tr("Answers of"));
        for (const auto& each : answers_)
            sets->addItem(qstr(each.participant + "  " + each.questionnaire_id),
                          QVariant::fromValue<qint64>(each.id));
        auto* item = make_line("correct_item", tr("Item, e.g. A"));
        auto* value = make_line("correct_value", tr("New answer; empty takes it away"));
        auto* reason = make_line("correct_reason", tr("Reason"));
        grid->addWidget(sets, 0, 0);
        grid->addWidget(item, 0, 1);
        grid->addWidget(value, 0, 2);
        grid->addWidget(reason, 1, 0, 1, 2);
        grid->addWidget(
            make_action(context_, this, tr("Correct"), "secondary", "check", "correct_answer",
                        [this, sets, item, value, reason] {
                            context_.guard(tr("Correcting an answer"), [&] {
                                context_.require(db::Action::kRunQuestionnaire);
                                context_.store().records().correct_answers(
                                    sets->currentData().toLongLong(), 1,
                                    {{item->text().trimmed().toStdString(),
                                      value->text().trimmed().toStdString()}},
                                    reason->text().trimmed().toStdString());
                                again();
                            });
                        }),
            1, 2);
        layout->addLayout(grid);
        if (!corrections_.empty()) layout->addWidget(correctionsTable());
        return make_card(layout);
    }

    QTableWidget* correctionsTable() {
        QTableWidget* table =
            make_table({tr("When"), tr("By"), tr("Item"), tr("Before"), tr("After"), tr("Reason")},
                       tr("Corrections"));
        table->setObjectName("corrections_table");
        table->setSortingEnabled(false);
        table->setRowCount(static_cast<int>(corrections_.size()));
        for (int row = 0; row < table->rowCount(); ++row) {
            const db::Correction& each = corrections_[static_cast<size_t>(row)];
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

    std::vector<std::string> ids_;
    std::string study_;
    std::vector<db::Progress> progress_;
    std::vector<db::AnswerRecord> answers_;
    std::map<std::string, db::RecordState> states_;
    std::vector<db::EntryDifference> differences_;
    std::vector<db::Correction> corrections_;
    QTableWidget* table_ = nullptr;
    QTableWidget* differences_table_ = nullptr;
};

}  // namespace

Page* make_study_data_page(AppContext& context, const Place& place) {
    return new StudyDataPage(context, place);
}

}  // namespace placode::ui
