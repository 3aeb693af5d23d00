// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placode-sim --test-device: a device by itself, for the shell's page of devices and for a bench.

#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "haptics/catalogue/device_trial.h"
#include "haptics/pedal_watch.h"
#include "ui/attempt/line_output.h"
#include "ui/attempt/sessions.h"

namespace placode::ui {
namespace {

using Json = nlohmann::ordered_json;
constexpr auto kEvery = std::chrono::milliseconds(50);
constexpr std::string_view kPedals = "pedals";

/// A reader that hangs must not keep the loop from `quit`, from a signal or from the end of the
/// input: each of them takes the force off.
void print(LineOutput& output, const Json& object) {
    output.send(object.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n');
}

const char* status_word(const haptics::DeviceState& state) {
    switch (state.status) {
        case haptics::DeviceStatus::kReady:
            return state.engaged ? "ready" : "resting";
        case haptics::DeviceStatus::kNotCalibrated:
            return "not_calibrated";
        case haptics::DeviceStatus::kLost:
            return "lost";
        case haptics::DeviceStatus::kFault:
            return "fault";
    }
    return "fault";
}

Json triple(const sim::Vec3& v) { return {v.x(), v.y(), v.z()}; }

Json arm_json(const haptics::TrialArm& arm) {
    return {{"vendor", arm.info.vendor},
            {"model", arm.info.model},
            {"serial", arm.info.serial},
            {"hand", arm.info.left_hand ? "left" : "right"},
            {"force_device", arm.info.dof_force > 0},
            {"status", status_word(arm.state)},
            {"position_m", triple(arm.state.position_m)},
            {"roll_rad", arm.state.roll_rad},
            {"jaw_rad", arm.state.jaw_rad},
            {"buttons", arm.state.buttons},
            {"pedals", arm.state.pedals},
            {"motor_heat", arm.state.motor_heat},
            {"force_n", triple(arm.force_n)},
            {"height_m", arm.height_m}};
}

Json report_json(const haptics::TrialReport& report, double time_s) {
    Json arms = Json::array();
    for (const haptics::TrialArm& arm : report.arms) arms.push_back(arm_json(arm));
    const haptics::HapticCertificate& loop = report.certificate;
    return {{"t_s", time_s},
            {"arms", arms},
            {"floor", report.floor},
            {"limit_n", report.force_n},
            {"stiffness_n_m", report.stiffness_n_m},
            {"identity", {{"asked", report.identity.asked}, {"arm", report.identity.arm}}},
            {"period_p50_us", loop.period_p50_us},
            {"period_p999_us", loop.period_p999_us},
            {"gaps", loop.gaps},
            {"faults", loop.faults},
            {"peak_force_n", loop.peak_force_n},
            {"compared_ticks", loop.compared},
            {"differing_ticks", loop.differing},
            {"last_error", loop.last_error},
            {"real_time", loop.real_time}};
}

/// Calls `each` every 50 ms with the time and every line that came, until it is told to end.
template <class Command, class Report>
int until_told(Command&& command, Report&& report) {
    const auto start = std::chrono::steady_clock::now();
    LineInput input;
    std::string line;
    while (!stop_requested() && !finish_requested()) {
        while (input.next(line)) {
            if (line == "quit") return 0;
            command(line);
        }
        // Who watches is gone: no force without somebody who looks.
        if (input.closed()) return 0;
        const std::chrono::duration<double> since = std::chrono::steady_clock::now() - start;
        report(since.count());
        std::this_thread::sleep_for(kEvery);
    }
    return 0;
}

int test_pedals(const std::string& named) {
    std::string path = named;
    if (path.empty()) path = haptics::Station::of_this_computer().text("pedals.device");
    if (path.empty())
        throw UsageError(
            "--test-device pedals: none is set; name one, pedals:/dev/input/by-id/...-event-kbd");
    haptics::PedalWatch watch(path);
    LineOutput output;
    return until_told([](const std::string&) {},
                      [&](double time_s) {
                          const bool there = watch.poll();
                          print(output, {{"t_s", time_s},
                                         {"pedals", watch.path()},
                                         {"connected", there},
                                         {"key", watch.last_key()},
                                         {"pressed", watch.pressed()}});
                      });
}

int test_arms(const Arguments& arguments) {
    haptics::TrialSettings settings;
    settings.device = arguments.test_device;
    settings.station = haptics::Station::of_this_computer();
    settings.force_n = arguments.test_force_n;
    haptics::DeviceTrial trial(settings);
    trial.start();
    LineOutput output;
    std::string problem;
    const auto command = [&](const std::string& line) {
        problem.clear();
        if (line == "floor on" || line == "floor off")
            trial.set_floor(line == "floor on");
        else if (line == "identify")
            trial.identify();
        else
            problem = "found \"" + line + "\", expected floor on, floor off, identify or quit";
    };
    const int status = until_told(command, [&](double time_s) {
        Json object = report_json(trial.report(), time_s);
        if (!problem.empty()) object["problem"] = problem;
        print(output, object);
    });
    trial.stop();
    return status;
}

}  // namespace

int run_device_test(const Arguments& arguments) {
    const std::string& name = arguments.test_device;
    if (name == kPedals) return test_pedals({});
    if (name.rfind("pedals:", 0) == 0) return test_pedals(name.substr(kPedals.size() + 1));
    return test_arms(arguments);
}

}  // namespace placode::ui
