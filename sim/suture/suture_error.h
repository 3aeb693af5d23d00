// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A needle, jaws, tissue strengths or thread that cannot be: which field, what was found, what is
// allowed.

#include <cmath>
#include <stdexcept>
#include <string>

#include "sim/core/number_text.h"

namespace placode::sim {

/// Thrown when a spec is taken in, never in a step.
class SutureError : public std::runtime_error {
 public:
    SutureError(std::string field, const std::string& message)
        : std::runtime_error(field + ": " + message), field_(std::move(field)) {}
    [[nodiscard]] const std::string& field() const noexcept { return field_; }

 private:
    std::string field_;
};

/// @throws SutureError unless `low` <= `found` <= `high`; NaN is refused.
inline void need_within(const char* field, double found, double low, double high) {
    if (found >= low && found <= high) return;
    throw SutureError(field, "found " + shortest_text(found) + "; expected a number from " +
                                 shortest_text(low) + " to " + shortest_text(high));
}

}  // namespace placode::sim
