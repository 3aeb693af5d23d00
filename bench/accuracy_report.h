// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What `placodectl bench accuracy` writes: a table, figures, and a report in Markdown that says
// what is accurate, what is not, and which method a scene should choose.

#include <filesystem>
#include <string>
#include <vector>

#include "bench/machine.h"
#include "sim/verify/accuracy.h"

namespace placode::bench {

/// On what and how the rows were measured.
struct AccuracyRun {
    Machine machine;
    bool quick = false, field = false;
    double wall_s = 0;
};

struct Figure {
    std::string file, caption;
};

/// An error in percent, four significant digits.
[[nodiscard]] std::string accuracy_percent(double error);
/// "met", "MISSED"; "" for a row without a target.
[[nodiscard]] std::string accuracy_verdict(const sim::AccuracyRow& row);

[[nodiscard]] std::string accuracy_csv(const std::vector<sim::AccuracyRow>& rows);
/// PNG files into `folder`, which is there. Studies without rows have no figure.
std::vector<Figure> write_accuracy_figures(const std::vector<sim::AccuracyRow>& rows,
                                           const std::filesystem::path& folder);
/// @param rows studies one behind the other. @param figure_folder "figures/" or "" before names.
[[nodiscard]] std::string accuracy_report(const std::vector<sim::AccuracyRow>& rows,
                                          const std::vector<Figure>& figures,
                                          const AccuracyRun& run, const std::string& figure_folder);

}  // namespace placode::bench
