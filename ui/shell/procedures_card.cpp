// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/procedures_card.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <algorithm>

#include "db/attempt_counting.h"
#include "db/study_conduct.h"
#include "db/study_records.h"
#include "reports/words.h"
#include "ui/shell/study_parts.h"
#include "ui/shell/table_width.h"
#include "ui/shell/typed_texts.h"

namespace placode::ui {

namespace {
constexpr int kShownProcedures = 6;  ///< Of a table, before it scrolls.
}  // namespace

ProceduresCard::ProceduresCard(AppContext& context, Page& page, const std::string& study,
                               std::function<void()> changed)
    : context_(context), page_(page), study_(study), changed_(std::move(changed)) {
    body_ = new QVBoxLayout(this);
    body_->setContentsMargins(0, 0, 0, 0);
}

void ProceduresCard::open(const std::string& code) {
    code_ = code;
    while (QLayoutItem* item = body_->takeAt(0)) {
        if (item->widget() != nullptr) item->widget()->deleteLater();
        delete item;
    }
    table_ = nullptr;
    context_.guard(tr("Reading the procedures"), [&] { readRows(); });
    auto* layout = new QVBoxLayout;
    layout->setSpacing(kSpace12);
    layout->addWidget(make_label(tr("Procedures of %1").arg(qstr(code)), "heading"));
    if (rows_.empty()) {
        layout->addWidget(
            make_label(tr("%1 has not worked at the simulator yet.").arg(qstr(code)), "muted"));
    } else {
        fillTable(layout);
        layout->addLayout(actions());
    }
    fillDeviations(layout);
    body_->addWidget(make_card(layout));
}

void ProceduresCard::readRows() {
    rows_.clear();
    attempts_.clear();
    titles_.clear();
    if (const auto protocol = db::protocol_of(context_.store(), study_, code_))
        for (const auto& step : protocol->steps) titles_[step.id] = context_.in(step.title);
    std::vector<int64_t> ids;
    for (db::StepRecord& record : context_.store().studies().steps(study_)) {
        if (record.participant != code_ || record.attempt_id == 0) continue;
        ids.push_back(record.attempt_id);
        rows_.push_back(std::move(record));
    }
    // An attempt that is gone leaves its step, and is not among them.
    attempts_ = context_.store().attempts().records(ids);
}

QString ProceduresCard::titleOf(const std::string& step) const {
    const auto found = titles_.find(step);
    return found == titles_.end() || found->second.isEmpty() ? qstr(step) : found->second;
}

bool ProceduresCard::idle(const db::StepRecord& record) {
    return record.state == db::StepState::kDone && record.detail == db::kNothingDone;
}

bool ProceduresCard::counts(const db::StepRecord& record) const {
    if (record.state != db::StepState::kDone || record.superseded() || idle(record)) return false;
    const auto attempt = attempts_.find(record.attempt_id);
    return attempt == attempts_.end() || db::counts(attempt->second);
}

QString ProceduresCard::stateWords(const db::StepRecord& record) const {
    if (record.superseded())
        return tr("done again: %1 (%2)")
            .arg(qstr(record.superseded_reason), qstr(record.superseded_by));
    if (idle(record)) return tr("kept, but no analysis uses it: nothing was done");
    if (counts(record)) return tr("counts");
    if (record.state == db::StepState::kDone) {
        const db::AttemptRecord& attempt = attempts_.at(record.attempt_id);
        const bool waits = attempt.replay == db::ReplayState::kWaiting && db::was_tried(attempt) &&
                           attempt.void_reason.empty();
        return (waits ? tr("does not count yet: %1") : tr("does not count: %1"))
            .arg(reports::not_counted_words(attempt));
    }
    return tr("does not count: %1")
        .arg(reports::not_done_words(record.detail, record.detail_meaning));
}

void ProceduresCard::fillTable(QVBoxLayout* layout) {
    table_ = make_table({tr("Step"), tr("When"), tr("Lasted"), tr("Device"), tr("State")},
                        tr("Procedures"));
    table_->setObjectName("procedures_table");
    keep_choice(table_);
    table_->setSortingEnabled(false);
    table_->setRowCount(static_cast<int>(rows_.size()));
    int row = 0;
    for (const db::StepRecord& record : rows_) {
        const auto attempt = attempts_.find(record.attempt_id);
        const bool there = attempt != attempts_.end();
        QString step = titleOf(record.step);
        if (record.visit > 1) step += tr(", visit %1").arg(record.visit);
        const QString state = stateWords(record);
        table_->setItem(row, 0, make_cell(step));
        table_->setItem(
            row, 1, make_cell(format_when(there ? attempt->second.started_utc : record.at_utc)));
        table_->setItem(row, 2,
                        make_cell(there ? format_duration(attempt->second.duration_s) : "–"));
        table_->setItem(row, 3, make_cell(there ? device_name(attempt->second.device) : "–"));
        table_->setItem(row, 4, make_cell(state));
        table_->item(row, 4)->setToolTip(state);
        const Tokens& colors = context_.colors();
        table_->item(row, 4)->setForeground(counts(record) ? colors.good : colors.warn);
        ++row;
    }
    fit_columns(table_, 4);
    // When it was stands in the result, a click away.
    keep_within(table_, {.stretch = 4, .least_px = 260, .keep_px = 260, .drop = {1}});
    wrap_rows(table_, kShownProcedures);
    table_->selectRow(row - 1);
    layout->addWidget(table_);
}

QLayout* ProceduresCard::actions() {
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(kSpace8);
    grid->setVerticalSpacing(kSpace8);
    reason_ = make_line("repeat_reason", tr("Why it went wrong, e.g. the pedal was unplugged"));
    note_ = make_line("step_note", tr("Note on the procedure"));
    grid->addWidget(reason_, 0, 0);
    grid->addWidget(make_action(context_, this, tr("Repeat this procedure …"), "secondary", "again",
                                "repeat_step", [this] { repeat(); }),
                    0, 1);
    grid->addWidget(note_, 1, 0);
    grid->addWidget(make_action(context_, this, tr("Add the note"), "secondary", "plus", "add_note",
                                [this] { note(); }),
                    1, 1);
    grid->addWidget(
        make_action(context_, this, tr("Open the result"), "quiet", "next", "open_attempt",
                    [this] {
                        if (selected() != nullptr)
                            Q_EMIT page_.go({PageId::kResult, selected()->attempt_id, {}, {}});
                    }),
        0, 2);
    grid->setColumnStretch(0, 1);
    return grid;
}

const db::StepRecord* ProceduresCard::selected() const {
    const int row = table_ == nullptr ? -1 : table_->currentRow();
    return row < 0 ? nullptr : &rows_[static_cast<size_t>(row)];
}

void ProceduresCard::repeat() {
    const db::StepRecord* record = selected();
    if (record == nullptr) return;
    const std::string reason = reason_->text().trimmed().toStdString();
    if (reason.empty()) {
        context_.report({tr("A repeat needs a reason."),
                         tr("Write what went wrong; it stands in every export and report."),
                         {}});
        reason_->setFocus();
        return;
    }
    if (!confirm(this, tr("Repeat %1?").arg(titleOf(record->step)),
                 tr("What %1 did is kept and marked with the reason; it counts no more. The "
                    "participant does this step again.")
                     .arg(qstr(code_)),
                 tr("Repeat")))
        return;
    context_.guard(tr("Having the procedure done again"), [&] {
        context_.require(db::Action::kRunQuestionnaire);
        context_.store().records().repeat_step(study_, code_, record->visit, record->step, reason);
        changed_();
    });
}

void ProceduresCard::note() {
    const db::StepRecord* record = selected();
    if (record == nullptr) return;
    context_.guard(tr("Adding the note"), [&] {
        context_.require(db::Action::kRunQuestionnaire);
        context_.store().records().note_step(study_, code_, record->visit, record->step,
                                             note_->text().trimmed().toStdString());
        changed_();
    });
}

void ProceduresCard::fillDeviations(QVBoxLayout* layout) {
    std::vector<db::Deviation> found;
    context_.guard(tr("Looking for deviations"),
                   [&] { found = db::study_deviations(context_.store(), study_, code_); });
    layout->addWidget(make_label(tr("Deviations from the protocol"), "heading"));
    if (found.empty()) {
        layout->addWidget(make_label(tr("There are none."), "muted"));
        return;
    }
    QTableWidget* table = make_table({tr("Step"), tr("Kind"), tr("What happened")},
                                     tr("Deviations from the protocol"));
    table->setObjectName("deviations_table");
    table->setSortingEnabled(false);
    table->setRowCount(static_cast<int>(found.size()));
    for (int row = 0; row < table->rowCount(); ++row) {
        const db::Deviation& each = found[static_cast<size_t>(row)];
        const QString words = reports::deviation_words(each);
        table->setItem(row, 0, make_cell(titleOf(each.step)));
        table->setItem(row, 1, make_cell(reports::deviation_title(each.kind)));
        table->setItem(row, 2, make_cell(words));
        table->item(row, 2)->setToolTip(words);
    }
    fit_columns(table, 2);
    keep_within(table, {.stretch = 2});
    wrap_rows(table, kShownProcedures);
    layout->addWidget(table);
}

}  // namespace placode::ui
