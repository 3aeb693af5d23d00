// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/bench/haptic_bench_suite.h"

#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <memory>
#include <thread>

#include "haptics/bench/haptic_bench_tissue.h"
#include "haptics/real_time.h"

namespace placode::haptics {
namespace {

constexpr HapticBenchLaw kLaws[] = {
    {"as shipped", 1.5, 20}, {"no passivity control", 1.5, 0}, {"bare spring", 0, 0}};

// Limits: wall oscillation, port energy and its drift, and free motion; see docs/devices.md.
constexpr double kRestM = 1e-4, kEnergyJ = -0.5e-3, kDriftJS = 1e-4, kFreeN = 0.15;
// A run in tissue costs a hundred times one against a wall: wider steps, from what is wanted on.
constexpr StiffnessSweep kTissueSweep{900, 6000, 1.6};

const sim::Vec3 kDirections[] = {{0, 0, -1}, {1, 0, 0}, {0, -1, 0}, {0.6, 0, -0.8}};

/// A hand that stands still over the tissue and a device that costs nothing.
class IdleDevice final : public DeviceGroup {
 public:
    [[nodiscard]] std::vector<DeviceInfo> info() const override {
        DeviceInfo info;
        info.vendor = "Placode";
        info.model = "idle hand";
        info.dof_sensed = info.dof_force = 3;
        return {info};
    }
    void read(int64_t t_ns, std::span<DeviceState> states) noexcept override {
        for (auto& state : states) state.t_ns = t_ns;
    }
    void write(std::span<const DeviceCommand>) noexcept override {}
};

/// The servo thread of this computer beside a physics thread that simulates a block of tissue.
HapticCertificate measure_thread(double seconds) {
    sim::ToolSpec tool;
    tool.tip_radius_m = 0.0015;
    tool.pivot_m = sim::Vec3(0, 0, 0.1);
    TrocarSettings trocar;
    trocar.mapping = Mapping::kTip;
    trocar.home_tip_m = sim::Vec3(0, 0, 0.0002);
    Servo servo(std::make_unique<IdleDevice>(), std::span(&tool, 1), std::span(&trocar, 1), {});
    HapticBenchTissue tissue(tool, 60e3, 1e-3);
    std::atomic<bool> running{true};
    servo.start();
    std::thread physics([&] {
        (void)make_thread_real_time(kPhysicsPriority);
        PeriodSchedule schedule(monotonic_ns(), 1'000'000);
        auto& exchange = servo.exchange();
        while (running.load(std::memory_order_relaxed)) {
            sleep_until(schedule.next_ns());
            exchange.inputs.refresh();
            tissue.frame(exchange.inputs.front()[0], exchange.feedback.back()[0]);
            exchange.feedback.publish();
            (void)schedule.advance(monotonic_ns());
        }
    });
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
    const HapticCertificate certificate = servo.certificate();
    running = false;
    physics.join();
    servo.stop();
    return certificate;
}

/// Of a number without decimals.
std::string whole(double value) { return std::to_string(std::lround(value)); }

/// The worst of several runs.
struct Worst {
    double oscillation_m = 0, energy_j = 0, drift_j_s = 0;
    void add(const HapticBenchResult& result) {
        oscillation_m = std::max(oscillation_m, result.peak_to_peak_m);
        energy_j = std::min(energy_j, result.least_energy_j);
        drift_j_s = std::max(drift_j_s, result.drift_j_s);
    }
};

}  // namespace

void HapticBenchSuite::check(const std::string& name, double value, double limit, bool at_most) {
    checks.push_back({name, value, limit, at_most});
    if (checked) checked(checks.back());
}

bool HapticBenchSuite::passed() const {
    for (const HapticBenchCheck& one : checks)
        if (!one.passed()) return false;
    return true;
}

void HapticBenchSuite::run() {
    run_control();
    sweep_wall();
    sweep_tissue();
    run_walls();
    run_tissue();
    run_air();
    thread = measure_thread(quick ? 2 : 20);
}

void HapticBenchSuite::run_control() {
    for (const HandModel& grip : grips()) {
        const HapticBenchResult result = run_haptic_bench(control_case(grip));
        check("control, " + std::string(grip.name) + ": seen to be unstable [m]",
              result.peak_to_peak_m, 3e-4, false);
        if (grip.name == "light") control = result;
    }
}

void HapticBenchSuite::sweep_wall() {
    const std::vector<double> rates =
        quick ? std::vector<double>{1000, 250} : std::vector<double>{1000, 500, 250};
    for (const HapticBenchLaw& law : kLaws) {
        if (quick && &law == &kLaws[1]) continue;
        for (const HandModel& grip : grips()) {
            for (const double hz : rates) {
                HapticBenchCase what;
                what.grip = grip;
                what.physics_hz = hz;
                what.settings.damping_ns_m = law.damping_ns_m;
                what.settings.passivity_ns_m = law.passivity_ns_m;
                const double k = largest_stiffness(what);
                rows.push_back({"wall", law.name, std::string(grip.name), hz, k});
                if (&law != &kLaws[0]) continue;
                check("K_max, wall, " + std::string(grip.name) + ", " + whole(hz) + " Hz [N/m]", k,
                      kStableTimes * what.settings.stiffness_n_m, false);
            }
        }
    }
}

// The solver itself holds the tool: what it adds in energy would be felt here and not on the wall.
void HapticBenchSuite::sweep_tissue() {
    StiffnessSweep sweep = kTissueSweep;
    const double enough = kStableTimes * CouplingSettings{}.stiffness_n_m;
    if (quick) sweep.from_n_m = sweep.to_n_m = enough;
    const std::vector<double> rates =
        quick ? std::vector<double>{1000} : std::vector<double>{1000, 500, 250};
    for (const HandModel& grip : grips()) {
        for (const double hz : rates) {
            HapticBenchCase what;
            what.grip = grip;
            what.physics_hz = hz;
            what.world = HapticBenchWorld::kTissue;
            what.push_m = 0.0015;
            const double k = largest_stiffness(what, sweep);
            rows.push_back({"tissue", kLaws[0].name, std::string(grip.name), hz, k});
            check("K_max, tissue, " + std::string(grip.name) + ", " + whole(hz) + " Hz [N/m]", k,
                  enough, false);
        }
    }
}

void HapticBenchSuite::run_walls() {
    Worst worst;
    double spring = 0;
    for (const HandModel& grip : grips()) {
        for (const sim::Vec3& direction : kDirections) {
            HapticBenchCase what;
            what.grip = grip;
            what.direction = direction;
            const HapticBenchResult result = run_haptic_bench(what);
            runs.push_back({"wall", std::string(grip.name), what.physics_hz, result});
            worst.add(result);
            const double expected = result.mean_force_n / what.settings.stiffness_n_m;
            spring = std::max(spring, std::abs(result.gap_m / expected - 1));
            if (grip.name == "light" && direction.z() == -1) wall = result;
        }
    }
    double minute = 0;
    for (const HandModel& grip : grips()) {
        HapticBenchCase what;
        what.grip = grip;
        what.seconds = 60;
        minute = std::min(minute, run_haptic_bench(what).least_energy_j);
    }
    check("wall, a minute at rest: least port energy [J]", minute, kEnergyJ, false);
    check("wall, 3 grips x 4 directions: oscillation [m]", worst.oscillation_m, kRestM);
    check("wall: least port energy [J]", worst.energy_j, kEnergyJ, false);
    check("wall: energy given at rest [J/s]", worst.drift_j_s, kDriftJS);
    check("wall: depth against force / stiffness [share]", spring, 0.1);
}

void HapticBenchSuite::run_tissue() {
    Worst worst;
    double differing = 0, compared = 1e9;
    for (const double modulus : {5e3, 60e3}) {
        if (quick && modulus < 60e3) continue;
        for (const HandModel& grip : grips()) {
            HapticBenchCase what;
            what.grip = grip;
            what.world = HapticBenchWorld::kTissue;
            what.youngs_modulus_pa = modulus;
            what.push_m = modulus < 60e3 ? 0.003 : 0.0025;
            what.seconds = 2.5;
            const HapticBenchResult result = run_haptic_bench(what);
            runs.push_back({"tissue of " + whole(modulus / 1000) + " kPa", std::string(grip.name),
                            what.physics_hz, result});
            worst.add(result);
            // Soft tissue does not give the force from which the two are compared.
            if (modulus >= 60e3) {
                const auto ticks = static_cast<double>(result.certificate.compared);
                compared = std::min(compared, ticks);
                differing = std::max(differing, static_cast<double>(result.certificate.differing) /
                                                    std::max(1.0, ticks));
                if (grip.name == "light") tissue = result;
            }
        }
    }
    check("tissue solver, 3 grips: oscillation [m]", worst.oscillation_m, kRestM);
    check("tissue solver: least port energy [J]", worst.energy_j, kEnergyJ, false);
    check("tissue solver: energy given at rest [J/s]", worst.drift_j_s, kDriftJS);
    check("tissue solver: ticks at rest compared with its multipliers", compared, 50, false);
    check("tissue solver: of these more than 5 % apart [share]", differing, 0.01);
}

void HapticBenchSuite::run_air() {
    for (const HandModel& grip : grips()) {
        for (const double hz : {1000.0, 500.0, 250.0}) {
            HapticBenchCase what;
            what.grip = grip;
            what.world = HapticBenchWorld::kAir;
            what.physics_hz = hz;
            const HapticBenchResult result = run_haptic_bench(what);
            runs.push_back({"air", std::string(grip.name), hz, result});
            check("free motion at 0.1 m/s, " + std::string(grip.name) + ", " + whole(hz) +
                      " Hz: force [N]",
                  result.peak_force_n, kFreeN);
        }
    }
}

}  // namespace placode::haptics
