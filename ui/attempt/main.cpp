// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placode-sim: one attempt in a process of its own. Exit status: 0 done, 1 ran and failed, 2 bad
// input or usage.

#include <cstdio>
#include <ctime>
#include <nlohmann/json.hpp>

#include "curriculum/attempt_runner.h"
#include "curriculum/preset.h"
#include "curriculum/utc_time.h"
#include "db/recording_file.h"
#include "db/store.h"
#include "haptics/catalogue/open_device.h"
#include "haptics/gamepad_search.h"
#include "haptics/pedal_watch.h"
#include "haptics/real_time.h"
#include "ui/arrived.h"
#include "ui/attempt/prepare_stage.h"
#include "ui/attempt/sessions.h"
#include "ui/diagnostics/crash_report.h"
#include "ui/view/gl_program.h"

namespace placode::ui {
namespace {

int list_devices(bool json) {
    const auto devices = haptics::list_devices(haptics::Station::of_this_computer());
    if (json) {
        auto list = nlohmann::ordered_json::array();
        for (const haptics::DeviceListing& device : devices)
            list.push_back({{"name", device.name},
                            {"available", device.available},
                            {"detail", device.detail},
                            {"found", device.found}});
        const nlohmann::ordered_json out{
            {"devices", list},
            {"pedals", haptics::pedal_devices()},
            {"station_file", haptics::Station::path_of_this_computer()}};
        std::printf(
            "%s\n",
            out.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace).c_str());
        return 0;
    }
    for (const haptics::DeviceListing& device : devices) {
        std::printf("%-22s %-13s %s\n", device.name.c_str(),
                    device.available ? "available" : "not available", device.detail.c_str());
        for (const std::string& found : device.found)
            std::printf("%-22s %-13s found: %s\n", "", "", found.c_str());
    }
    return 0;
}

int list_presets() {
    const auto presets = curriculum::list_presets();
    for (const curriculum::ScenePreset& p : presets)
        std::printf("%-28s on %-14s %s, %s  %s\n", p.id.c_str(), p.preset_of.c_str(),
                    p.author.empty() ? "-" : p.author.c_str(), p.saved_utc.c_str(), p.name.c_str());
    if (presets.empty())
        std::printf("no presets in %s; F2 in the simulator's window saves one\n",
                    curriculum::preset_folder().c_str());
    return 0;
}

// Files that an administrator or a user may want to start from.
int print_file(const std::string& text) {
    std::fputs(text.c_str(), stdout);
    return 0;
}

/// What kept the certificate from the recording; "" = it is in.
std::string certificate_problem(const std::string& recording, const std::string& certificate) {
    try {
        db::add_haptic_certificate(recording, certificate);
        return {};
    } catch (const db::StoreError& error) {
        return std::string("The recording lacks its end: ") + error.what();
    }
}

/// Somebody did not want to wait for the stage: nothing was recorded.
int stopped_before(const Arguments& arguments, StatusLine& status) {
    status.end({}, "closed", {});
    if (!arguments.status) std::printf("stopped before the attempt began\n");
    return 0;
}

int run_attempt(const Arguments& arguments, StatusLine& status) {
    status.print({}, true);
    curriculum::Task task = curriculum::load_task(arguments.task);
    if (!arguments.preset.empty())
        task = curriculum::with_preset(task, curriculum::load_preset(arguments.preset));
    if (arguments.scope_angle_deg >= 0) {
        for (sim::ToolSpec& tool : task.scene.tools) {
            if (tool.kind == sim::ToolKind::kScope)
                tool.scope_angle_deg = arguments.scope_angle_deg;
        }
    }
    // Nobody shall sit before a needle that does not move.
    if (arguments.device == "gamepad") haptics::need_gamepad();
    sim::Latest<sim::WindowInput> input;
    curriculum::AttemptOptions options;
    options.device = arguments.device;
    options.threads = arguments.threads;
    options.fast = arguments.fast;
    options.duration_s = arguments.duration_s;
    options.demonstration = arguments.demonstration;
    options.started_utc = curriculum::utc_text(std::time(nullptr));
    options.window = &input;
    options.mode = arguments.mode;
    options.wait_for_motion = !arguments.headless;
    if (arguments.stage > 0) {
        options.start = prepare_stage(task, arguments);
        if (!options.start) return stopped_before(arguments, status);
    }
    std::unique_ptr<sim::RecordingSink> sink;
    if (!arguments.record.empty())
        sink = db::create_recording_file(arguments.record, arguments.order);
    const bool has_ring = task.steps.empty();
    // Of a device its kind only: what follows may be a path.
    log_note("attempt_began",
             {LogField::id("task", task.id),
              LogField::id("device", arguments.device.substr(0, arguments.device.find(':'))),
              {"threads", arguments.threads}});
    curriculum::AttemptRunner runner(std::move(task), arguments.seed, options, std::move(sink));
    if (arguments.headless) {
        run_headless(runner, arguments, status);
    } else {
        run_in_window(runner, input, arguments, status);
    }
    runner.wait();
    const sim::RecordingEnd end = runner.end();
    log_note("attempt_ended", {{"reason", static_cast<int>(end.reason)},
                               {"seconds", static_cast<int64_t>(end.duration_s)}});
    curriculum::AttemptStatus last = runner.status();
    const std::string certificate = runner.haptic_certificate();
    if (!arguments.record.empty() && last.warning.empty())
        last.warning = certificate_problem(arguments.record, certificate);
    status.end(last, reason_text(end.reason), arguments.record, {}, certificate);
    if (!arguments.status) {
        // What could not be written is not called recorded.
        const char* recorded = arguments.record.empty() ? ""
                               : last.warning.empty()   ? ", recorded in "
                                                        : ", NOT recorded to its end in ";
        std::printf("%s after %.1f s", reason_text(end.reason).c_str(), end.duration_s);
        if (has_ring) std::printf(", ring %.0f %% cut", 100 * last.cut_fraction);
        std::printf("%s%s\n", recorded, arguments.record.c_str());
    }
    if (last.warning.empty()) return 0;
    std::fprintf(stderr, "placode-sim: %s\n", last.warning.c_str());
    return 1;
}

int run(int argc, char** argv) {
    bool exit_now = false;
    const Arguments arguments = parse_arguments(argc, argv, exit_now);
    if (exit_now) return 0;
    if (arguments.list_devices) return list_devices(arguments.json);
    if (arguments.list_presets) return list_presets();
    if (arguments.limits_file) return print_file(haptics::limits_file());
    if (arguments.station_file) return print_file(haptics::Station::of_this_computer().file_text());
    begin_diagnostics("placode-sim");
    catch_stop_signals();
    if (!arguments.test_device.empty()) return run_device_test(arguments);
    StatusLine status(arguments.status);
    return arguments.play.empty() ? run_attempt(arguments, status) : run_replay(arguments, status);
}

}  // namespace

}  // namespace placode::ui

int main(int argc, char** argv) {
    const auto complain = [](const std::exception& error, int status) {
        std::fprintf(stderr, "placode-sim: %s\n", error.what());
        placode::ui::log_note("failed", {{"exit_status", status}});
        return status;
    };
    try {
        return placode::ui::arrived("placode-sim", placode::ui::run(argc, argv));
    } catch (const placode::ui::UsageError& error) {
        return complain(error, 2);
    } catch (const placode::curriculum::DefinitionError& error) {
        return complain(error, 2);
    } catch (const placode::haptics::DeviceError& error) {
        std::fprintf(stderr,
                     "placode-sim: %s\nplacode-sim: without it: --device mouse, keyboard or "
                     "script:expert; --list-devices says what is there\n",
                     error.what());
        return 2;
    } catch (const placode::sim::MeshError& error) {
        return complain(error, 2);
    } catch (const placode::db::StoreError& error) {
        return complain(error, 2);
    } catch (const std::exception& error) {
        return complain(error, 1);
    }
}
