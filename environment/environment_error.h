// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How an environment refuses: what is wrong, and what to do.

#include <stdexcept>

namespace placode::environment {

class EnvironmentError : public std::runtime_error {
 public:
    enum class Kind {
        kBadArgument,  ///< Wrong size, not a number, out of range.
        kNotReset,     ///< Nothing has begun: reset first.
        kEnded,        ///< The attempt is over: reset first.
        kRunning,      ///< The attempt is not over yet.
        kOtherTask     ///< A saved state of another task or of other changes to its scene.
    };
    EnvironmentError(Kind kind, const std::string& what) : std::runtime_error(what), kind_(kind) {}
    [[nodiscard]] Kind kind() const noexcept { return kind_; }

 private:
    Kind kind_;
};

}  // namespace placode::environment
