// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/attempts_table.h"

#include <QCoreApplication>
#include <QHeaderView>
#include <map>

#include "db/attempt_counting.h"
#include "reports/words.h"
#include "ui/shell/result_standing.h"
#include "ui/shell/table_width.h"
#include "ui/shell/training.h"

namespace placode::ui {
namespace {

struct AttemptsTable {
    Q_DECLARE_TR_FUNCTIONS(AttemptsTable)
};

constexpr int kTaskPx = 240, kRemarkPx = 260;  ///< Widths of "Task" and "Remark" [px].
constexpr int kAttemptIdRole = Qt::UserRole + 1;

/// Time as shown; sorted by the time itself.
QTableWidgetItem* when_cell(const std::string& utc) {
    const QDateTime when = QDateTime::fromString(qstr(utc), Qt::ISODate);
    QTableWidgetItem* cell =
        make_number_cell(format_when(utc), static_cast<double>(when.toSecsSinceEpoch()));
    cell->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    return cell;
}

/// What it was done for: an exam is looked at with other eyes than practice.
QTableWidgetItem* kind_cell(const AppContext& context, const db::AttemptRecord& attempt) {
    const bool exam = !attempt.exam.course_id.empty(), study = !attempt.study.study.empty();
    QTableWidgetItem* cell = make_cell(exam    ? AttemptsTable::tr("Exam")
                                       : study ? AttemptsTable::tr("Study")
                                               : AttemptsTable::tr("Practice"));
    cell->setForeground(exam ? context.colors().text : context.colors().muted);
    if (study)
        cell->setToolTip(AttemptsTable::tr("Study %1, participant %2")
                             .arg(qstr(attempt.study.study), qstr(attempt.study.participant)));
    return cell;
}

QTableWidgetItem* verdict_cell(const AppContext& context, const db::AttemptRecord& attempt) {
    // One word here; the result page says what the critical error was.
    const bool failed = db::counts(attempt) && attempt.verdict == assessment::Verdict::kFailed;
    QTableWidgetItem* cell =
        make_cell(failed ? AttemptsTable::tr("Failed") : verdict_word(attempt));
    const QString why = reports::not_counted_words(attempt);
    cell->setToolTip(why.isEmpty() ? verdict_word(attempt) : why);
    const Tokens& colors = context.colors();
    const std::string tone = verdict_tone(attempt);
    cell->setForeground(tone == "good"       ? colors.good
                        : tone == "critical" ? colors.critical
                        : tone == "warn"     ? colors.warn
                                             : colors.muted);
    return cell;
}

}  // namespace

QTableWidget* make_attempts_table(AppContext& context,
                                  const std::vector<db::AttemptRecord>& attempts,
                                  AttemptColumns columns) {
    QStringList headers{AttemptsTable::tr("When")};
    const bool everybody = columns == AttemptColumns::kEverybody;
    if (everybody) headers << AttemptsTable::tr("Person") << AttemptsTable::tr("Task");
    headers << AttemptsTable::tr("Kind") << AttemptsTable::tr("Points")
            << AttemptsTable::tr("Verdict") << AttemptsTable::tr("Time")
            << AttemptsTable::tr("Device") << AttemptsTable::tr("Remark");
    QTableWidget* table = make_table(headers, AttemptsTable::tr("Attempts"));
    table->setSortingEnabled(false);
    table->setRowCount(static_cast<int>(attempts.size()));
    std::map<std::string, QString> titles;
    int row = 0;
    for (const db::AttemptRecord& attempt : attempts) {
        int column = 0;
        QTableWidgetItem* when = when_cell(attempt.started_utc);
        when->setData(kAttemptIdRole, QVariant::fromValue<qint64>(attempt.id));
        table->setItem(row, column++, when);
        if (everybody) {
            auto title = titles.find(attempt.task_id);
            if (title == titles.end())
                title = titles.emplace(attempt.task_id, task_title(context, attempt.task_id)).first;
            table->setItem(row, column++, make_cell(qstr(attempt.user_name)));
            table->setItem(row, column++, make_cell(title->second));
            table->item(row, column - 1)->setToolTip(title->second);
        }
        const bool counts = db::counts(attempt);
        table->setItem(row, column++, kind_cell(context, attempt));
        table->setItem(row, column++,
                       make_number_cell(counts ? format_points(attempt.points) : "–",
                                        counts ? attempt.points : -1));
        table->setItem(row, column++, verdict_cell(context, attempt));
        table->setItem(row, column++,
                       make_number_cell(format_duration(attempt.duration_s), attempt.duration_s));
        table->setItem(row, column++, make_cell(device_name(attempt.device)));
        table->setItem(row, column++,
                       make_cell(!counts                 ? reports::not_counted_words(attempt)
                                 : attempt.demonstration ? AttemptsTable::tr("DEMONSTRATION")
                                                         : end_word(attempt.end)));
        table->item(row, column - 1)->setToolTip(table->item(row, column - 1)->text());
        ++row;
    }
    // Device and time stand on the result page, a click away.
    const int last = table->columnCount() - 1, stretch = everybody ? 2 : last;
    fit_columns(table, stretch);
    // A long remark gives way to the name of the task, and stands in its tool tip.
    if (everybody) table->setColumnWidth(last, std::min(table->columnWidth(last), kRemarkPx));
    keep_within(table, {.stretch = stretch,
                        .least_px = everybody ? 320 : 140,
                        .keep_px = everybody ? kTaskPx : 110,
                        .drop = {last - 1, last - 2}});
    table->setSortingEnabled(true);
    table->sortByColumn(0, Qt::DescendingOrder);
    return table;
}

namespace {

/// Why attempts do not count, how many for each reason, and what to do about it.
struct Uncounted {
    QStringList why, what;
};

Uncounted uncounted_of(const std::vector<db::AttemptRecord>& attempts) {
    int slow = 0, broken_off = 0, idle = 0, tuned = 0, doubted = 0, waiting = 0, elsewhere = 0,
        given = 0;
    for (const db::AttemptRecord& each : attempts) {
        // What the person did comes first, as on the result.
        if (each.end == sim::EndReason::kInterrupted)
            ++broken_off;
        else if (each.verdict == assessment::Verdict::kNotAttempted)
            ++idle;
        else if (db::machine_at_fault(each))
            ++slow;
        else if (db::not_verified(each))
            ++doubted;
        else if (db::given_stage(each) > 0)
            ++given;
        else if (!each.void_reason.empty())
            ++tuned;
        else if (each.replay == db::ReplayState::kWaiting)
            ++(can_be_replayed_here(each) ? waiting : elsewhere);
    }
    Uncounted found;
    QStringList &why = found.why, &what = found.what;
    if (idle > 0) {
        why << AttemptsTable::tr("nothing was done: %1").arg(idle);
        what << AttemptsTable::tr("Begin the first step of the task and go on as far as you can.");
    }
    if (broken_off > 0) {
        why << AttemptsTable::tr("broken off: %1").arg(broken_off);
        what << AttemptsTable::tr("Let an attempt come to its end, or hold Enter to end it.");
    }
    if (slow > 0) {
        why << AttemptsTable::tr("computer too slow or device at fault: %1").arg(slow);
        what << AttemptsTable::tr(
            "On a computer that is too slow close other programs, or use another one.");
    }
    if (tuned > 0) {
        why << AttemptsTable::tr("tuned: %1").arg(tuned);
        what << AttemptsTable::tr("Leave the tuning panel (F2) closed.");
    }
    if (given > 0) {
        why << AttemptsTable::tr("begun at a stage: %1").arg(given);
        what << AttemptsTable::tr("Begin at the beginning for an attempt that counts.");
    }
    if (doubted > 0) {
        why << AttemptsTable::tr("practice, not verified: %1").arg(doubted);
        what << AttemptsTable::tr("The result of each says what is in doubt.");
    }
    if (waiting > 0) {
        why << AttemptsTable::tr("still to be simulated again: %1").arg(waiting);
        what << AttemptsTable::tr("Placode simulates them by itself: come back later.");
    }
    if (elsewhere > 0) {
        why << AttemptsTable::tr("waiting for another version of Placode or processor: %1")
                   .arg(elsewhere);
        what << AttemptsTable::tr("The result of each says which one it waits for.");
    }
    return found;
}

}  // namespace

QString why_nothing_counts(const std::vector<db::AttemptRecord>& attempts) {
    const Uncounted found = uncounted_of(attempts);
    return AttemptsTable::tr("There is no score to show: no attempt at this task counts yet (%1).")
               .arg(found.why.join(", ")) +
           " " + found.what.join(" ");
}

QString why_nobody_counts(const std::vector<db::AttemptRecord>& attempts) {
    return AttemptsTable::tr("There are attempts, but none of them counts (%1).")
        .arg(uncounted_of(attempts).why.join(", "));
}

int64_t attempt_of_row(const QTableWidget* table, int row) {
    const QTableWidgetItem* item = table->item(row, 0);
    return item != nullptr ? item->data(kAttemptIdRole).toLongLong() : 0;
}

}  // namespace placode::ui
