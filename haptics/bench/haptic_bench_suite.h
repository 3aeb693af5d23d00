// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What `bench haptics` measures: the law held by a simulated operator against walls, air and the
// tissue solver, and the real servo thread of this computer beside a real physics thread.

#include <functional>
#include <string>
#include <vector>

#include "haptics/bench/haptic_bench.h"

namespace placode::haptics {

/// Three times the default stiffness must be stable with every grip.
inline constexpr double kStableTimes = 3;
/// Largest stiffness that is tried [N/m]: a sweep that ends above this was stable throughout.
inline constexpr double kSweepTopNM = 4400;

/// The law with and without its parts.
struct HapticBenchLaw {
    const char* name;
    double damping_ns_m, passivity_ns_m;
};

/// One limit and what was found.
struct HapticBenchCheck {
    std::string name;
    double value = 0, limit = 0;
    bool at_most = true;
    [[nodiscard]] bool passed() const { return at_most ? value <= limit : value >= limit; }
};

/// Largest stable stiffness of a law in a world.
struct HapticBenchRow {
    std::string world, law, grip;
    double physics_hz = 0, k_max = 0;
};

/// One run that is reported by itself.
struct HapticBenchRun {
    std::string name, grip;
    double physics_hz = 0;
    HapticBenchResult result;
};

struct HapticBenchSuite {
    bool quick = false;
    std::function<void(const HapticBenchCheck&)> checked;  ///< Told every check as it is made.
    std::vector<HapticBenchCheck> checks;
    std::vector<HapticBenchRow> rows;
    std::vector<HapticBenchRun> runs;
    /// Time lines for the figures: a light grip.
    HapticBenchResult wall, tissue, control;
    HapticCertificate thread;

    void run();
    [[nodiscard]] bool passed() const;

 private:
    void check(const std::string& name, double value, double limit, bool at_most = true);
    void run_control();
    void sweep_wall();
    void sweep_tissue();
    void run_walls();
    void run_tissue();
    void run_air();
};

}  // namespace placode::haptics
