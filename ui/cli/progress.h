// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Long work on a terminal: a line that says how far it is, and Ctrl+C that ends it in good order.

#include <csignal>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace placode::cli {

/// One line of a terminal, drawn over itself on standard error; nothing where that is none.
void show_progress(const std::string& words);
/// Takes that line away.
void clear_progress();

/// While it lives these signals ask the work to end instead of killing the program.
class CancelOn {
 public:
    explicit CancelOn(std::initializer_list<int> signals);
    ~CancelOn();
    CancelOn(const CancelOn&) = delete;
    CancelOn& operator=(const CancelOn&) = delete;

    /// Of any such signal since the program began.
    [[nodiscard]] static bool requested() noexcept;

 private:
    std::vector<std::pair<int, void (*)(int)>> before_;
};

}  // namespace placode::cli
