// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The error of every method on the table: cases with a closed form, or with the double-precision
// reference on the same mesh, measured one by one. `placodectl bench accuracy` runs them.

#include <functional>
#include <string>
#include <vector>

namespace placode::sim {

/// One measured number.
struct AccuracyRow {
    std::string study;     ///< "cantilever, static", ...
    std::string setting;   ///< Mesh, material, load.
    std::string method;    ///< As in a verification scene.
    std::string quantity;  ///< What was measured.
    std::string unit;      ///< Of value and expected; "" = a ratio.
    double h_s = 0;        ///< Substep [s], 0 = none (quasi-static).
    double edge_m = 0;     ///< Mesh edge [m].
    int tets = 0;
    double courant = 0;
    double value = 0, expected = 0;
    double error = 0;   ///< Relative [-], as `quantity` says.
    double target = 0;  ///< The error aimed at [-], 0 = none.
    double cost = 0;    ///< CPU seconds of one core for one simulated second, 0 = not compared.
};

struct AccuracyOptions {
    bool quick = false;  ///< Small meshes and few steps only.
    bool field = true;   ///< With the default operative field (some minutes).
    std::string only;    ///< One of accuracy_groups(); empty = all.
    /// Of the beams, which runs are made: by study, method and substep [s] of their rows. Most take
    /// seconds; whoever looks at some rows need not wait for the others. None: all.
    std::function<bool(const std::string& study, const std::string& method, double h_s)> wanted;
    /// Called after every row.
    std::function<void(const AccuracyRow&)> progress;
};

/// homogeneous, beams, twist, motion, indentation, felt, field, drives, sleep.
[[nodiscard]] const std::vector<std::string>& accuracy_groups();

/// All cases. Runs for minutes; one thread.
[[nodiscard]] std::vector<AccuracyRow> measure_accuracy(const AccuracyOptions& options);

/// Slope of log(error) over log(h), least squares; 0 with fewer than two points.
[[nodiscard]] double convergence_order(const std::vector<AccuracyRow>& rows);

// Groups of cases, called by measure_accuracy().
class AccuracyTable;
void measure_homogeneous(AccuracyTable& table);
void measure_beams(AccuracyTable& table);
void measure_twist(AccuracyTable& table);
void measure_motion(AccuracyTable& table);
void measure_indentation(AccuracyTable& table);
void measure_felt(AccuracyTable& table);
void measure_field(AccuracyTable& table);
void measure_drives(AccuracyTable& table);
void measure_sleep(AccuracyTable& table);

}  // namespace placode::sim
