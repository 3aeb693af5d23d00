// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl bench haptics: a simulated operator with three grips holds the real servo against
// walls, air and the tissue solver. Largest stable stiffness by grip and physics rate, energy of
// the port, free motion, and the period of the real servo thread on this machine.

#include <array>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <thread>

#include "haptics/port_bench.h"
#include "haptics/real_time.h"
#include "reports/report.h"
#include "ui/cli/bench_timing.h"
#include "ui/cli/cli.h"
#include "ui/cli/solver_commands.h"

namespace placode::cli {
namespace {

using haptics::PortCase;
using haptics::PortResult;
using haptics::PortWorld;

struct Options {
    bool quick = false;
    std::string out;
};

/// The law with and without its parts.
struct Law {
    const char* name;
    double damping_ns_m, passivity_ns_m;
};
constexpr Law kLaws[] = {
    {"as shipped", 1.5, 20}, {"no passivity control", 1.5, 0}, {"bare spring", 0, 0}};

// Limits: wall oscillation, port energy and its drift, free motion, and three times the default
// stiffness; see docs/devices.md.
constexpr double kWallM = 1e-4, kEnergyJ = -0.5e-3, kDriftJS = 1e-4, kFreeN = 0.15, kTimes = 3;

struct Check {
    std::string name;
    double value = 0, limit = 0;
    bool at_most = true;
    [[nodiscard]] bool passed() const { return at_most ? value <= limit : value >= limit; }
};

struct Row {
    std::string law, grip;
    double physics_hz = 0, k_max = 0;
};

const sim::Vec3 kDirections[] = {{0, 0, -1}, {1, 0, 0}, {0, -1, 0}, {0.6, 0, -0.8}};

/// Latency of the servo thread, with a device that costs nothing.
class IdleDevice final : public haptics::DeviceGroup {
 public:
    [[nodiscard]] std::vector<haptics::DeviceInfo> info() const override {
        return {haptics::DeviceInfo{}};
    }
    void read(int64_t t_ns, std::span<haptics::DeviceState> states) noexcept override {
        for (auto& state : states) state.t_ns = t_ns;
    }
    void write(std::span<const haptics::DeviceCommand>) noexcept override {}
};

haptics::HapticCertificate measure_thread(double seconds) {
    const sim::ToolSpec tool;
    const haptics::TrocarSettings trocar;
    haptics::Servo servo(std::make_unique<IdleDevice>(), std::span(&tool, 1), std::span(&trocar, 1),
                         {});
    servo.start();
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
    const haptics::HapticCertificate certificate = servo.certificate();
    servo.stop();
    return certificate;
}

class Bench {
 public:
    explicit Bench(const Options& options) : options_(options) {}

    void run() {
        json_["benchmark"] = "haptics";
        json_["machine"] = machine();
        control();
        sweep();
        walls();
        tissue();
        air();
        thread();
        for (const Check& check : checks_)
            json_["checks"].push_back({{"name", check.name},
                                       {"value", check.value},
                                       {check.at_most ? "at_most" : "at_least", check.limit},
                                       {"passed", check.passed()}});
    }
    [[nodiscard]] bool passed() const {
        for (const Check& check : checks_)
            if (!check.passed()) return false;
        return true;
    }
    [[nodiscard]] const Json& json() const { return json_; }
    [[nodiscard]] std::string text() const;
    void write(const std::string& folder) const;

 private:
    void check(const std::string& name, double value, double limit, bool at_most = true) {
        checks_.push_back({name, value, limit, at_most});
        if (!checks_.back().passed()) std::cerr << "not within its limit: " << name << '\n';
    }

    // The test of the test: a law that must buzz. If it does not, nothing here proves anything.
    void control() {
        for (const haptics::Grip& grip : haptics::grips()) {
            PortCase what;
            what.grip = grip;
            what.physics_hz = 250;
            what.hold_ticks = 4;
            what.seconds = 3.5;
            what.settings.stiffness_n_m = 4000;
            what.settings.damping_ns_m = what.settings.passivity_ns_m = 0;
            const PortResult result = haptics::run_port(what);
            check("control, " + std::string(grip.name) + ": seen to be unstable [m]",
                  result.peak_to_peak_m, 3e-4, false);
            if (grip.name == "light") unstable_ = result;
        }
    }

    void sweep() {
        const std::vector<double> rates =
            options_.quick ? std::vector<double>{1000, 250} : std::vector<double>{1000, 500, 250};
        for (const Law& law : kLaws) {
            if (options_.quick && &law == &kLaws[1]) continue;
            for (const haptics::Grip& grip : haptics::grips()) {
                for (const double hz : rates) {
                    PortCase what;
                    what.grip = grip;
                    what.physics_hz = hz;
                    what.settings.damping_ns_m = law.damping_ns_m;
                    what.settings.passivity_ns_m = law.passivity_ns_m;
                    const double k = haptics::largest_stiffness(what);
                    rows_.push_back({law.name, std::string(grip.name), hz, k});
                    json_["k_max"].push_back({{"law", law.name},
                                              {"grip", grip.name},
                                              {"physics_hz", hz},
                                              {"k_max_n_m", k}});
                    if (&law == &kLaws[0])
                        check("K_max, " + std::string(grip.name) + ", physics " + fixed(hz, 0) +
                                  " Hz [N/m]",
                              k, kTimes * haptics::CouplingSettings{}.stiffness_n_m, false);
                }
            }
        }
    }

    void note(const std::string& name, const PortCase& what, const PortResult& result) {
        json_["cases"].push_back({{"case", name},
                                  {"grip", what.grip.name},
                                  {"physics_hz", what.physics_hz},
                                  {"peak_to_peak_m", result.peak_to_peak_m},
                                  {"peak_force_n", result.peak_force_n},
                                  {"mean_force_n", result.mean_force_n},
                                  {"gap_m", result.gap_m},
                                  {"tissue_force_n", result.tissue_force_n},
                                  {"least_energy_j", result.least_energy_j},
                                  {"drift_j_s", result.drift_j_s}});
    }

    void walls() {
        double worst = 0, energy = 0, drift = 0, spring = 0;
        for (const haptics::Grip& grip : haptics::grips()) {
            for (const sim::Vec3& direction : kDirections) {
                PortCase what;
                what.grip = grip;
                what.direction = direction;
                const PortResult result = haptics::run_port(what);
                note("wall", what, result);
                worst = std::max(worst, result.peak_to_peak_m);
                energy = std::min(energy, result.least_energy_j);
                drift = std::max(drift, result.drift_j_s);
                const double expected = result.mean_force_n / what.settings.stiffness_n_m;
                spring = std::max(spring, std::abs(result.gap_m / expected - 1));
                if (grip.name == "light" && direction.z() == -1) stable_ = result;
            }
        }
        check("wall, 3 grips x 4 directions: oscillation [m]", worst, kWallM);
        check("wall: least port energy [J]", energy, kEnergyJ, false);
        check("wall: energy given at rest [J/s]", drift, kDriftJS);
        check("wall: depth against force / stiffness [share]", spring, 0.1);
    }

    void tissue() {
        double worst = 0, energy = 0, drift = 0;
        const std::vector<double> moduli =
            options_.quick ? std::vector<double>{60e3} : std::vector<double>{5e3, 60e3};
        for (const double modulus : moduli) {
            for (const haptics::Grip& grip : haptics::grips()) {
                PortCase what;
                what.grip = grip;
                what.world = PortWorld::kTissue;
                what.youngs_modulus_pa = modulus;
                what.push_m = 0.0015;
                what.seconds = 2.5;
                const PortResult result = haptics::run_port(what);
                note("tissue of " + fixed(modulus / 1000, 0) + " kPa", what, result);
                worst = std::max(worst, result.peak_to_peak_m);
                energy = std::min(energy, result.least_energy_j);
                drift = std::max(drift, result.drift_j_s);
                if (grip.name == "light") tissue_ = result;
            }
        }
        check("tissue solver, 3 grips: oscillation [m]", worst, kWallM);
        check("tissue solver: least port energy [J]", energy, kEnergyJ, false);
        check("tissue solver: energy given at rest [J/s]", drift, kDriftJS);
    }

    void air() {
        for (const double hz : {1000.0, 500.0, 250.0}) {
            PortCase what;
            what.grip = haptics::grips()[1];
            what.world = PortWorld::kAir;
            what.physics_hz = hz;
            const PortResult result = haptics::run_port(what);
            note("air", what, result);
            check("free motion at 0.1 m/s, physics " + fixed(hz, 0) + " Hz: force [N]",
                  result.peak_force_n, kFreeN);
            free_.push_back({hz, result.peak_force_n});
        }
    }

    void thread() {
        thread_ = measure_thread(options_.quick ? 2 : 20);
        json_["servo_thread"] = Json::parse(haptics::certificate_to_json(thread_));
        json_["servo_thread"]["missing"] =
            haptics::missing_rights(thread_.real_time, thread_.memory_locked);
    }

    Options options_;
    Json json_{{"checks", Json::array()}, {"k_max", Json::array()}, {"cases", Json::array()}};
    std::vector<Check> checks_;
    std::vector<Row> rows_;
    PortResult stable_, unstable_, tissue_;
    std::vector<std::pair<double, double>> free_;  // rate, force
    haptics::HapticCertificate thread_;
};

std::string Bench::text() const {
    std::vector<std::vector<std::string>> cells{{"law", "grip", "physics [Hz]", "K_max [N/m]"}};
    for (const Row& row : rows_)
        cells.push_back({row.law, row.grip, fixed(row.physics_hz, 0),
                         (row.k_max > 5200 ? ">= " : "") + fixed(row.k_max, 0)});
    std::string out = table(cells) + "\n";
    cells = {{"check", "value", "limit", ""}};
    for (const Check& one : checks_) {
        const auto number = [](double v) {
            return std::abs(v) < 0.01 && v != 0 ? fixed(1000 * v, 3) + "e-3" : fixed(v, 3);
        };
        cells.push_back({one.name, number(one.value),
                         (one.at_most ? "<= " : ">= ") + number(one.limit),
                         one.passed() ? "ok" : "NOT WITHIN"});
    }
    out += table(cells) + "\nFree motion at 0.1 m/s:";
    for (const auto& [hz, force] : free_)
        out += " " + fixed(force, 3) + " N at " + fixed(hz, 0) + " Hz;";
    out += " attempts run at 1000 Hz.\nServo thread, " + fixed(thread_.duration_s, 1) +
           " s: period p50 " + fixed(thread_.period_p50_us, 0) + ", p99 " +
           fixed(thread_.period_p99_us, 0) + ", p99.9 " + fixed(thread_.period_p999_us, 0) +
           ", max " + fixed(thread_.period_max_us, 0) + " us; " + std::to_string(thread_.missed) +
           " periods missed, " + std::to_string(thread_.gaps) + " gaps above 5 ms; " +
           (thread_.real_time ? "SCHED_FIFO" : "ordinary scheduling");
    const std::string missing = haptics::missing_rights(thread_.real_time, thread_.memory_locked);
    if (!missing.empty()) out += ".\n" + missing;
    return out;
}

reports::Curve curve_of(const std::string& name, const std::vector<float>& values, double scale) {
    reports::Curve curve;
    curve.name = name;
    for (size_t i = 0; i < values.size(); i += 5) {
        curve.x.push_back(1e-3 * static_cast<double>(i));
        curve.y.push_back(scale * static_cast<double>(values[i]));
    }
    return curve;
}

void Bench::write(const std::string& folder) const {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    std::ofstream csv(folder + "/bench_haptics.csv");
    csv << "law,grip,physics_hz,k_max_n_m\n";
    for (const Row& row : rows_)
        csv << row.law << ',' << row.grip << ',' << fixed(row.physics_hz, 0) << ','
            << fixed(row.k_max, 1) << '\n';
    std::ofstream traces(folder + "/bench_haptics_traces.csv");
    traces << "t_s,wall_position_m,wall_force_n,tissue_position_m,tissue_force_n,"
              "control_position_m,control_force_n\n";
    const auto cell = [](const std::vector<float>& v, size_t i) {
        return i < v.size() ? fixed(static_cast<double>(v[i]), 7) : std::string();
    };
    for (size_t i = 0; i < unstable_.position_m.size(); ++i)
        traces << fixed(1e-3 * static_cast<double>(i), 3) << ',' << cell(stable_.position_m, i)
               << ',' << cell(stable_.force_n, i) << ',' << cell(tissue_.position_m, i) << ','
               << cell(tissue_.force_n, i) << ',' << cell(unstable_.position_m, i) << ','
               << cell(unstable_.force_n, i) << '\n';
    std::ofstream document(folder + "/bench_haptics.json");
    document << json_.dump(2) << '\n';
    for (std::ofstream* file : {&csv, &traces, &document}) file->flush();
    if (!csv || !traces || !document)
        throw InputError("--out " + folder + ": cannot be written; choose another place");

    reports::CurveChart k_max;
    k_max.title = "Largest stable stiffness against a rigid wall (simulated operator)";
    k_max.x_label = "rate of the physics [Hz]";
    k_max.y_label = "K_max [N/m]";
    for (const Row& row : rows_) {
        const std::string name = row.grip + ", " + row.law;
        auto at = std::find_if(k_max.curves.begin(), k_max.curves.end(),
                               [&](const reports::Curve& c) { return c.name == name; });
        if (at == k_max.curves.end()) at = k_max.curves.insert(at, {name, {}, {}});
        at->x.push_back(row.physics_hz);
        at->y.push_back(row.k_max);
    }
    const double standard = haptics::CouplingSettings{}.stiffness_n_m;
    k_max.levels = {{"default", standard}, {"three times the default", kTimes * standard}};
    reports::write_chart_png(k_max, folder + "/bench_haptics_kmax.png");

    reports::CurveChart traces_chart;
    traces_chart.title = "A light grip pushes into wall and tissue: shipped law and control case";
    traces_chart.x_label = "time [s]";
    traces_chart.y_label = "position of the device [mm]";
    traces_chart.log_x = traces_chart.log_y = false;
    traces_chart.curves = {curve_of("wall", stable_.position_m, 1000),
                           curve_of("tissue", tissue_.position_m, 1000),
                           curve_of("control: K 4000, B 0, held 4 ms", unstable_.position_m, 1000)};
    reports::write_chart_png(traces_chart, folder + "/bench_haptics_traces.png");
}

int run(const Context& context, const Options& options) {
    Bench bench(options);
    bench.run();
    if (!options.out.empty()) bench.write(options.out);
    print(context, bench.json(), bench.text());
    return bench.passed() ? 0 : 1;
}

}  // namespace

void add_haptics_bench_command(CLI::App& bench, Context& context) {
    auto options = std::make_shared<Options>();
    CLI::App* command = bench.add_subcommand(
        "haptics", "Stability of the force law with a simulated operator, latency of the servo");
    command->add_flag("--quick", options->quick, "Fewer rates and laws, a shorter measurement");
    command->add_option("--out", options->out,
                        "Folder for bench_haptics.csv, .json, traces and figures");
    command->callback([&context, options] {
        context.run = [&context, options] { return run(context, *options); };
    });
}

}  // namespace placode::cli
