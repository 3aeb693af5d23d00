// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How whoever waits for a long export hears how far it is, and ends it.

#include <cstddef>
#include <exception>
#include <functional>
#include <string>

namespace placode::reports {

/// Somebody wanted an export to end: nothing of it was handed out.
class ExportStopped final : public std::exception {
 public:
    [[nodiscard]] const char* what() const noexcept override { return "the export was stopped"; }
};

/// What is made next.
struct ExportPart {
    std::string name;          ///< A format's or a figure's title.
    size_t done = 0, all = 0;  ///< Recordings of it; all = 0: they are not counted.
};

/// Both may be empty, and are called in the thread that exports.
struct ExportPace {
    std::function<bool()> stop;  ///< Asked between two parts; true, and the export ends.
    std::function<void(const ExportPart&)> progress;

    /// Before each part. Throws ExportStopped.
    void next(const ExportPart& part) const {
        if (stop && stop()) throw ExportStopped();
        if (progress) progress(part);
    }
};

}  // namespace placode::reports
