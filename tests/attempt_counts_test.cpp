// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/attempt_counts.h"

#include <gtest/gtest.h>

#include "db/void_reason.h"

namespace placode::reports {
namespace THIS_TEST {

void add(Dataset& data, bool counts, const db::AttemptRecord& record, bool again = false) {
    Row row;
    row.counts = counts;
    row.values.emplace("superseded", again ? "1" : "0");
    data.forms.front().rows.push_back(row);
    db::AttemptDetail detail;
    detail.record = record;
    data.attempts.push_back(detail);
}

Dataset study() {
    Dataset data;
    data.forms.emplace_back();
    data.forms.front().id = "attempts";
    return data;
}

TEST(AttemptCounts, EachStandsUnderOneReason) {
    Dataset data = study();
    db::AttemptRecord good, slow, broken, idle, waiting, forged;
    good.end = slow.end = idle.end = sim::EndReason::kFinished;
    good.verdict = slow.verdict = assessment::Verdict::kPassed;
    slow.void_reason = "The computer was too slow: 3 pictures a second, 20 are needed";
    broken.end = sim::EndReason::kInterrupted;
    idle.verdict = assessment::Verdict::kNotAttempted;
    waiting = forged = good;
    waiting.replay = db::ReplayState::kWaiting;
    forged.replay = db::ReplayState::kDiffers;
    forged.void_reason =
        db::void_text({{db::VoidCause::kReplayDiffers, 0, 0, db::Said::as_is("a sample at 2 s")}});
    add(data, true, good);
    add(data, true, good);
    add(data, false, waiting);
    add(data, false, forged);
    add(data, false, slow);
    add(data, false, broken);
    add(data, false, idle);
    add(data, false, slow, true);  // slow, and done again for it: another one counts
    add(data, false, good);        // ended before the least duration
    const AttemptCounts counts = attempt_counts(data);
    EXPECT_EQ(counts.all, 9);
    EXPECT_EQ(counts.waiting, 1);
    EXPECT_EQ(counts.not_verified, 1);
    EXPECT_EQ(counts.void_for_cause, 1);
    EXPECT_EQ(counts.interrupted, 1);
    EXPECT_EQ(counts.not_attempted, 1);
    EXPECT_EQ(counts.repeated, 1);
    EXPECT_EQ(counts.not_done, 1);
    EXPECT_EQ(counts.uncounted(), 7);
    EXPECT_EQ(uncounted_words(counts),
              "Attempts that do not count: 7 of 9 (void, the computer too slow or a device at "
              "fault: 1; practice, not verified: 1; still to be simulated again: 1; broken off: 1; "
              "done again: 1; shorter than the protocol asks: 1; nothing was done: 1).");
}

TEST(AttemptCounts, WhereAllCountNothingIsSaid) {
    Dataset data = study();
    add(data, true, {});
    EXPECT_EQ(attempt_counts(data).all, 1);
    EXPECT_EQ(uncounted_words(attempt_counts(data)), "");
    EXPECT_EQ(attempt_counts({}).all, 0);
}

}  // namespace THIS_TEST
}  // namespace placode::reports
