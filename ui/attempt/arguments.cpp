// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/attempt/arguments.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <vector>

#include "db/recording_order.h"
#include "sim/step/recording.h"
#include "ui/finite_range.h"
#include "ui/seed_range.h"
#include "ui/usage_message.h"
#include "ui/version.h"
#include "ui/view/picture_size.h"

namespace placode::ui {
namespace {

// The whole of `text` as a number, whatever the locale.
template <class T>
bool number(std::string_view text, T& value) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size();
}

void read_size(const std::string& text, Arguments& arguments) {
    const auto size = view::picture_size(text);
    if (!size || !is_window_size(size->width, size->height)) {
        throw UsageError("--size: found \"" + text +
                         "\", expected WxH from 160x120 to 7680x4320, e.g. 1280x800");
    }
    arguments.width = size->width;
    arguments.height = size->height;
}

// "X,Y"
void read_position(const std::string& text, Arguments& arguments) {
    const size_t comma = text.find(',');
    int x = 0, y = 0;
    if (comma == std::string::npos || !number(std::string_view(text).substr(0, comma), x) ||
        !number(std::string_view(text).substr(comma + 1), y) || std::abs(x) > 32767 ||
        std::abs(y) > 32767) {
        throw UsageError("--position: found \"" + text +
                         "\", expected X,Y in pixels of the desktop, e.g. 640,40");
    }
    arguments.place = {x, y};
}

// "DIR" or "DIR:EVERY_S"
void read_screenshots(const std::string& text, Arguments& arguments) {
    arguments.screenshot_folder = text;
    const size_t colon = text.rfind(':');
    if (colon == std::string::npos || colon + 1 == text.size()) return;
    double every = 0;
    if (!number(std::string_view(text).substr(colon + 1), every)) return;  // a colon in a name
    if (!(every >= 0.02 && every <= 3600)) {
        throw UsageError("--screenshots: every " + text.substr(colon + 1) +
                         " s is not from 0.02 to 3600 s");
    }
    arguments.screenshot_folder = text.substr(0, colon);
    arguments.screenshot_every_s = every;
}

void read_aids(const std::string& text, Arguments& arguments) {
    const auto aids = curriculum::aids_named(text);
    if (!aids)
        throw UsageError("--aids: found \"" + text +
                         "\", expected names of planned_line, read_outs, warnings, depth with "
                         "commas between them, or \"\" for none");
    arguments.aids = *aids;
}

void check(Arguments& arguments) {
    if (arguments.json && !arguments.list_devices)
        throw UsageError("--json goes with --list-devices; an attempt reports with --status");
    if (arguments.mode != curriculum::AttemptMode::kPractice && !arguments.preset.empty())
        throw UsageError(
            "--preset: an exam or a study is done on the task as it was published; leave it out");
    if (arguments.mode != curriculum::AttemptMode::kPractice && arguments.stage > 0)
        throw UsageError(
            "--stage: an exam or a study begins with the beginning of its task; leave it out");
    if (!arguments.order.empty() && !db::is_order_checksum(arguments.order))
        throw UsageError("--order: found \"" + arguments.order +
                         "\", expected a checksum of 64 hexadecimal digits, as placode gives it");
    if (!arguments.order.empty() && arguments.record.empty())
        throw UsageError("--order: stands in a recording; give --record FILE.placode as well");
    if (arguments.list_devices || arguments.list_presets || arguments.limits_file ||
        arguments.station_file)
        return;
    if (!arguments.test_device.empty()) {
        if (!arguments.task.empty() || !arguments.record.empty())
            throw UsageError("--test-device tries a device by itself, without --task and --record");
        return;
    }
    if (arguments.control && arguments.device.rfind("play:", 0) != 0)
        throw UsageError("--control: steers a replay only; use it with --device play:FILE");
    if (arguments.device.rfind("play:", 0) == 0) {
        arguments.play = arguments.device.substr(5);
        if (arguments.play.empty()) throw UsageError("--device play:FILE: the file is missing");
        if (arguments.stage > 0)
            throw UsageError("--stage: a replay begins as its attempt did; leave it out");
        if (!arguments.record.empty()) {
            throw UsageError(
                "--record: a replay is compared with its recording, not recorded again");
        }
    } else if (arguments.task.empty()) {
        throw UsageError(
            "--task is missing: the id of a task or a JSON file, e.g. --task diathermy_ring");
    }
    if (arguments.fast && !arguments.headless) {
        throw UsageError("--fast needs --headless: a window shows real time");
    }
    const bool hands = arguments.device == "mouse" || arguments.device == "keyboard" ||
                       arguments.device == "gamepad";
    if (arguments.headless && hands) {
        throw UsageError("--device " + arguments.device +
                         " needs a window; with --headless use script:expert, script:intermediate, "
                         "script:novice, "
                         "script:mouse or play:FILE");
    }
}

/// Options that are read once all of them are known.
struct Typed {
    std::string size, position, screenshots, camera, layout;
    std::optional<std::string> aids;
    bool is_exam = false, is_study = false;
};

// In the order of the help:

/// What is done: task, device, recording.
void add_attempt_options(CLI::App& app, Arguments& arguments) {
    app.add_option("--task", arguments.task, "Id of a task, or its JSON file")
        ->type_name("ID|FILE.json");
    app.add_option("--stage", arguments.stage,
                   "Begin at this stage of the task; what comes before is given, and the attempt "
                   "counts for nothing (0: the beginning)")
        ->check(CLI::Range(0, sim::kMostStages));
    app.add_option(
        "--device", arguments.device,
        "mouse, keyboard, gamepad, spacemouse, openhaptics, haply, avatar, forcedimension, "
        "script:expert|intermediate|novice|mouse, play:FILE");
    app.add_option("--record", arguments.record, "Write the recording here")
        ->type_name("FILE.placode");
    app.add_option("--order", arguments.order,
                   "Checksum of what the attempt is begun for, kept in the recording (placode)")
        ->type_name("CHECKSUM");
    app.add_flag("--headless", arguments.headless, "No window, no display needed");
    app.add_flag("--fast", arguments.fast, "As fast as possible (with --headless)");
    app.add_option("--duration", arguments.duration_s, "Stop after this many seconds")
        ->check(finite_range(0.001, 86400.0));
    app.add_option("--threads", arguments.threads, "Threads of the physics")
        ->check(CLI::Range(1, 64));
    app.add_option("--seed", arguments.seed, "Seed of anatomy and scripted operator")
        ->transform(seed_range());
}

/// How it is shown and saved.
void add_window_options(CLI::App& app, Arguments& arguments, Typed& typed) {
    app.add_option("--screenshots", typed.screenshots,
                   "Save pictures in DIR, every EVERY_S seconds (5)")
        ->type_name("DIR[:EVERY_S]");
    app.add_option("--size", typed.size, "Size of window and pictures")->type_name("WxH");
    app.add_option("--position", typed.position,
                   "Upper left corner of the window on the desktop [px]")
        ->type_name("X,Y");
    app.add_option("--scope", arguments.scope_angle_deg, "Angle of the optic [deg]")
        ->check(CLI::IsMember({0, 30}));
    app.add_option("--controls", typed.layout,
                   "Keys and buttons: left-handed, then NAME=KEY, buttons=exchanged, "
                   "sticks=exchanged with spaces between")
        ->type_name("LAYOUT");
    app.add_option("--language", arguments.language, "en or pl")
        ->check(CLI::IsMember({"en", "pl"}));
    app.add_flag("--status", arguments.status, "One JSON object a line on standard output");
    app.add_flag("--demonstration", arguments.demonstration,
                 "Mark picture and recording as demonstration");
    app.add_flag("--fullscreen", arguments.fullscreen, "Window over the whole screen");
}

/// How a recording is played.
void add_replay_options(CLI::App& app, Arguments& arguments, Typed& typed) {
    app.add_option("--camera", typed.camera, "Replay: scope, above, left, feet or near")
        ->check(CLI::IsMember({"scope", "above", "left", "feet", "near"}));
    app.add_option("--speed", arguments.wish.speed, "Replay: 0.1 to 8")
        ->check(finite_range(kSlowest, kFastest));
    app.add_option("--from", arguments.wish.seek_s, "Replay: start at this second")
        ->check(finite_range(0.0, 86400.0));
    app.add_flag("--control", arguments.control,
                 "Replay: read \"camera NAME\", \"speed X\", \"seek S\", \"pause\", \"play\", "
                 "\"quit\" from standard input");
}

/// Practice, exam or study, and what belongs to it.
void add_mode_options(CLI::App& app, Arguments& arguments, Typed& typed) {
    app.add_option("--preset", arguments.preset,
                   "Load a preset that was saved with F2; such an attempt is not scored as a pass")
        ->type_name("ID|FILE.json");
    app.add_option("--author", arguments.author,
                   "Who saves presets (default: $PLACODE_AUTHOR, else the login name)");
    auto* exam = app.add_flag("--exam", typed.is_exam,
                              "An exam: only the time is shown, no help, no tuning");
    auto* study = app.add_flag("--study", typed.is_study,
                               "A study's procedure: aids as --aids says, no tuning");
    study->excludes(exam);
    app.add_option("--aids", typed.aids,
                   "Study: what helps, of planned_line, read_outs, warnings, depth")
        ->type_name("NAME[,NAME]")
        ->needs(study);
    app.add_option("--min-duration", arguments.least_s,
                   "Study: ended earlier than this [s] the procedure does not count, and is asked")
        ->check(finite_range(0.0, 86400.0))
        ->needs(study);
}

/// Sound, and what placode-sim does beside an attempt.
void add_other_options(CLI::App& app, Arguments& arguments) {
    app.add_option("--volume", arguments.volume_percent, "Loudness of tones and alarms [%]")
        ->check(CLI::Range(0, 100));
    app.add_flag("--mute", arguments.mute, "No sound");
    app.add_flag("--list-presets", arguments.list_presets, "Presets of this user, then exit");
    app.add_flag("--list-devices", arguments.list_devices, "What can be used here, and why not");
    app.add_flag("--json", arguments.json, "With --list-devices: one JSON document");
    app.add_option("--test-device", arguments.test_device,
                   "Try a device by itself, or pedals[:DEVICE]: a line of JSON every 50 ms; reads "
                   "\"floor on|off\", \"identify\", \"quit\" from standard input")
        ->type_name("NAME");
    app.add_option("--test-force", arguments.test_force_n, "Its largest force [N], 0.5 at first")
        ->check(finite_range(0.1, 10.0));
    app.add_flag("--limits-file", arguments.limits_file,
                 "Print the limits file that grants real time to the haptic loop");
    app.add_flag("--station-file", arguments.station_file,
                 "Print this computer's device settings as a file to begin from");
}

/// What was typed as one text, in its parts. Throws UsageError.
void read_typed(const Typed& typed, Arguments& arguments) {
    if (typed.is_exam) arguments.mode = curriculum::AttemptMode::kExam;
    if (typed.is_study) arguments.mode = curriculum::AttemptMode::kStudy;
    arguments.aids = curriculum::conduct_of(arguments.mode).aids;
    if (typed.aids) read_aids(*typed.aids, arguments);
    if (!typed.camera.empty()) (void)camera_named(typed.camera, arguments.wish.camera);
    try {
        arguments.layout = haptics::ControlLayout::parse(typed.layout);
    } catch (const haptics::LayoutError& error) {
        throw UsageError(std::string("--controls: ") + error.what());
    }
    if (!typed.size.empty()) read_size(typed.size, arguments);
    arguments.size_given = !typed.size.empty();
    if (!typed.position.empty()) read_position(typed.position, arguments);
    if (!typed.screenshots.empty()) read_screenshots(typed.screenshots, arguments);
    // The shell says it so: others on the computer see what stands in a command line.
    for (const char* name : {"PLACODE_AUTHOR", "USER"})
        if (const char* said = std::getenv(name); said != nullptr && arguments.author.empty())
            arguments.author = said;
}

}  // namespace

Arguments parse_arguments(int argc, char** argv, bool& exit_now) {
    Arguments arguments;
    Typed typed;
    exit_now = false;
    CLI::App app("placode-sim: one attempt at a task, through the fetoscope", "placode-sim");
    app.set_version_flag("--version", std::string("placode-sim ") + version_text(),
                         "Version and commit");
    add_attempt_options(app, arguments);
    add_window_options(app, arguments, typed);
    add_replay_options(app, arguments, typed);
    add_mode_options(app, arguments, typed);
    add_other_options(app, arguments);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& asked) {  // --help, --version
        (void)app.exit(asked);
        exit_now = true;
        return arguments;
    } catch (const CLI::ParseError& error) {
        throw UsageError(usage_message(app, error));
    }
    read_typed(typed, arguments);
    check(arguments);
    return arguments;
}

}  // namespace placode::ui
