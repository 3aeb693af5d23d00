// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How many attempts of a study no analysis uses, and why.

#include <QString>

#include "reports/dataset.h"

namespace placode::reports {

/// Each attempt stands under one reason: the first of these that holds.
struct AttemptCounts {
    int all = 0;
    int repeated = 0;        ///< Done again for a reason; another attempt counts.
    int interrupted = 0;     ///< Broken off.
    int void_for_cause = 0;  ///< The computer was too slow, or a device failed.
    int not_verified = 0;    ///< What was recorded proves nothing.
    int waiting = 0;         ///< Still to be simulated again.
    int not_attempted = 0;   ///< Nothing was done.
    int not_done = 0;        ///< Shorter than the protocol asks, or its step is not done.
    [[nodiscard]] int uncounted() const {
        return repeated + interrupted + void_for_cause + not_verified + waiting + not_attempted +
               not_done;
    }
};
/// Of the rows of the form "attempts".
[[nodiscard]] AttemptCounts attempt_counts(const Dataset& data);

/// "3 of 12 attempts do not count: the computer was too slow: 2, broken off: 1." in the language
/// of the shell; empty when all count.
[[nodiscard]] QString uncounted_words(const AttemptCounts& counts);

}  // namespace placode::reports
