// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Version of the programs.

namespace placode::ui {

/// "0.1.0 (9e92fbd)": version and commit; "-dirty" behind it where files had been changed.
[[nodiscard]] const char* version_text() noexcept;

}  // namespace placode::ui
