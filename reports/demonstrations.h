// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Attempts as demonstrations for machines that learn: HDF5 in the layout of robomimic, with the
// recordings beside them as proof, a data sheet, a licence and a split that no person crosses.
// Layout: https://robomimic.github.io/docs/datasets/overview.html

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "reports/hdf5_file.h"
#include "sim/step/recording.h"

namespace placode::reports {

/// An attempt as a demonstration.
struct Demonstration {
    std::string recording_file;
    std::string operator_name;  ///< "expert", ...; "person" for people.
    /// Whose it is: nobody is in two parts of the split. Kept out of the data set.
    std::string person;
    bool of_a_person = false;
    std::string task;
    double points = 0;
    bool passed = false;
};

struct DemonstrationArrays {
    Matrix observations;                 ///< (N x names): at the beginning of each step.
    Matrix next_observations;            ///< (N x names): at its end.
    Matrix actions;                      ///< (N x 8 tools): environment/hands.h, absolute units.
    std::vector<double> rewards, dones;  ///< (N)
};

/// Their names are those of an environment where they mean the same (environment/observation.cpp).
[[nodiscard]] std::vector<std::string> demonstration_names(size_t tools);
[[nodiscard]] std::vector<std::string> demonstration_action_names(size_t tools);
/// In steps of `step_s`, a multiple of 10 ms. Rewards are sparse: the points over 100 at the end.
/// Throws ReportError for a recording that is shorter than a step.
[[nodiscard]] DemonstrationArrays demonstration_arrays(const sim::Recording& recording,
                                                       double points, double step_s);

struct DemonstrationOptions {
    double step_s = 0.02;
    std::array<int, 3> split{80, 10, 10};  ///< Train, validation, test: shares of persons [%].
    uint64_t seed = 1;                     ///< Of the split.
    std::string licence = "not stated: ask whoever gave you these files";
    std::string origin;       ///< For the data sheet: where the attempts come from.
    std::string consent;      ///< For the data sheet: what people agreed to.
    int left_out = 0;         ///< Attempts of people who did not agree.
    std::string software;     ///< That wrote it.
    std::string reader_file;  ///< Example in Python, copied beside the data.
};

/// 0 train, 1 validation, 2 test; by demonstration. All of one person are in one part; the first
/// part gets somebody before the others do.
[[nodiscard]] std::vector<int> split_by_person(const std::vector<Demonstration>& demonstrations,
                                               const std::array<int, 3>& shares, uint64_t seed);

/// Told how many are done; false stops.
using DemonstrationProgress = std::function<bool(size_t done, size_t of)>;

/// Writes TASK.hdf5 for each task, recordings/, DATASHEET.md, LICENCE.txt, read_dataset.py and
/// SHA256SUMS into a folder that must be empty or not there; reads the arrays back and compares.
/// Returns the files. Throws ReportError.
std::vector<std::string> write_demonstrations(const std::vector<Demonstration>& demonstrations,
                                              const DemonstrationOptions& options,
                                              const std::string& folder,
                                              const DemonstrationProgress& progress);

}  // namespace placode::reports
