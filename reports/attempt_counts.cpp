// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/attempt_counts.h"

#include <QCoreApplication>
#include <QStringList>

#include "db/attempt_counting.h"

namespace placode::reports {

AttemptCounts attempt_counts(const Dataset& data) {
    AttemptCounts counts;
    const Form* form = data.form("attempts");
    if (form == nullptr) return counts;
    for (size_t i = 0; i < form->rows.size() && i < data.attempts.size(); ++i) {
        const Row& row = form->rows[i];
        ++counts.all;
        if (row.counts) continue;
        const db::AttemptRecord& record = data.attempts[i].record;
        const auto again = row.values.find("superseded");
        if (again != row.values.end() && again->second == "1")
            ++counts.repeated;
        else if (record.end == sim::EndReason::kInterrupted)
            ++counts.interrupted;
        else if (db::not_verified(record))
            ++counts.not_verified;
        else if (!record.void_reason.empty())
            ++counts.void_for_cause;
        else if (record.verdict == assessment::Verdict::kNotAttempted)
            ++counts.not_attempted;
        else if (record.replay == db::ReplayState::kWaiting)
            ++counts.waiting;
        else
            ++counts.not_done;
    }
    return counts;
}

QString uncounted_words(const AttemptCounts& counts) {
    if (counts.uncounted() == 0) return {};
    const auto say = [](const char* english) {
        return QCoreApplication::translate("Deviation", english);
    };
    QStringList why;
    const auto add = [&](int number, const char* english) {
        if (number > 0) why << say(english).arg(number);
    };
    add(counts.void_for_cause, "void, the computer too slow or a device at fault: %1");
    add(counts.not_verified, "practice, not verified: %1");
    add(counts.waiting, "still to be simulated again: %1");
    add(counts.interrupted, "broken off: %1");
    add(counts.repeated, "done again: %1");
    add(counts.not_done, "shorter than the protocol asks: %1");
    add(counts.not_attempted, "nothing was done: %1");
    return say("Attempts that do not count: %1 of %2 (%3).")
        .arg(counts.uncounted())
        .arg(counts.all)
        .arg(why.join(QStringLiteral("; ")));
}

}  // namespace placode::reports
