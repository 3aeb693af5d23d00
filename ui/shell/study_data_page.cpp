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
#include "ui/shell/copies_left.h"
#include "ui/shell/names_card.h"
#include "ui/shell/pages.h"
#include "ui/shell/parts.h"
#include "ui/shell/procedures_card.h"
#include "ui/shell/retention_card.h"
#include "ui/shell/study_corrections_card.h"
#include "ui/shell/study_entry_card.h"
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
        erased_ = place.state.value("erased").toString();
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
        if (QLabel* left = make_copies_left(context, erased_)) column->addWidget(left);
        column->addWidget(make_label(summary(), "muted"));
        column->addWidget(recordsCard(place.state.value("selected", place.text).toString()));
        auto* procedures = new ProceduresCard(context, *this, study_, [this] { again(); });
        column->addWidget(procedures);
        connect(table_, &QTableWidget::itemSelectionChanged, procedures,
                [this, procedures] { procedures->open(selected().toStdString()); });
        procedures->open(selected().toStdString());
        column->addWidget(make_entry_card(context, *this,
                                          {study_, progress_, answers_, differences_}, table_,
                                          [this] { again(); }));
        column->addWidget(make_corrections_card(context, *this, answers_, corrections_, table_,
                                                [this] { again(); }));
        column->addWidget(make_names_card(context, *this, study_, codes()));
        const auto erased = [this](const QString& codes) {
            Q_EMIT go(
                {PageId::kStudyData, 0, selected(), {{"study", qstr(study_)}, {"erased", codes}}});
        };
        if (QWidget* kept = make_retention_card(context, *this, study_, erased))
            column->addWidget(kept);
        column->addStretch();
    }

    [[nodiscard]] QString title() const override { return tr("Data"); }
    /// A change of theme or language still says where erased records may be, and is about the same
    /// participant: what is typed for a signature or to unlock stays.
    [[nodiscard]] QVariantMap state() const override {
        QVariantMap kept{{"study", qstr(study_)}, {"erased", erased_}};
        if (table_ != nullptr) kept["selected"] = selected();
        return kept;
    }

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

    std::vector<std::string> ids_;
    std::string study_;
    QString erased_;  ///< Participants whose records were just erased, or none.
    std::vector<db::Progress> progress_;
    std::vector<db::AnswerRecord> answers_;
    std::map<std::string, db::RecordState> states_;
    std::vector<db::EntryDifference> differences_;
    std::vector<db::Correction> corrections_;
    QTableWidget* table_ = nullptr;
};

}  // namespace

Page* make_study_data_page(AppContext& context, const Place& place) {
    return new StudyDataPage(context, place);
}

}  // namespace placode::ui
