// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/attempt/attempt_overlay.h"

#include "curriculum/preset.h"
#include "curriculum/step_hints.h"
#include "haptics/control_words.h"
#include "ui/attempt/motion.h"
#include "ui/view/strings.h"

namespace placode::ui {
namespace {

using Help = std::vector<std::pair<std::string, std::string>>;

Help controls(const Arguments& arguments) {
    const std::string& device = arguments.device;
    Help help;
    if (device == "mouse") {
        help = {{"mouse", "Move the instrument"},
                {"wheel", "Deeper, shallower"},
                {"Shift + wheel", "The same, four times as far"},
                {"left button", "Cut (yellow pedal)"},
                {"right button", "Coagulate (blue pedal)"},
                {"middle button", "Move the scope"},
                {"Shift + mouse", "Turn about the shaft"},
                {"Ctrl", "Precise"},
                {"Space", "Hold the instrument still"},
                {"Tab", "Next instrument"}};
    } else if (device == "keyboard") {
        help = {{"W A S D", "Move the instrument"},
                {"R  F", "Shallower, deeper"},
                {"Q  E", "Turn about the shaft"},
                {"X", "Cut (yellow pedal)"},
                {"C", "Coagulate (blue pedal)"},
                {"arrows", "Move the scope"},
                {"Ctrl", "Precise"},
                {"Space", "Hold the instrument still"},
                {"Tab", "Next instrument"}};
    } else if (device == "gamepad") {
        help = {{"left stick", "Move the instrument"},   {"triggers", "Deeper, shallower"},
                {"right stick", "Turn about the shaft"}, {"A", "Cut (yellow pedal)"},
                {"B", "Coagulate (blue pedal)"},         {"left bumper", "Precise"}};
    } else if (device.rfind("play:", 0) == 0) {
        return {{"Space, Esc", "Pause, go on"}, {"← →", "5 s back, 5 s on"},
                {"↑ ↓", "Faster, slower"},      {"V", "Next camera"},
                {"F5", "Planned line on, off"}, {"F3", "Performance"},
                {"F1", "Help on, off"},         {"Q", "Close"}};
    } else if (device.rfind("script:", 0) == 0) {
        help = {{"", "The simulated operator works by itself; watch."}};
    } else {
        help = {{"arm", "Move the instrument"},
                {"pedals, 1", "Cut (yellow pedal)"},
                {"pedals, 2", "Coagulate (blue pedal)"}};
    }
    const curriculum::Conduct& conduct = curriculum::conduct_of(arguments.mode);
    const auto add = [&help](bool there, const char* key, const char* text) {
        if (there) help.emplace_back(key, text);
    };
    add(true, "L", "Wipe the lens");
    add(true, "M  + -", "Sound off, louder, softer");
    add(conduct.tuning, "F2", "Clinician's tuning; does not count");
    add(arguments.aids.planned_line, "F5", "Planned line on, off");
    add(conduct.performance, "F3", "Performance");
    add(conduct.screenshots, "F12", "Screenshot");
    add(true, "Esc", "Pause and menu; lets the pointer out");
    add(true, "hold Enter", conduct.own_score ? "Finish and be scored" : "Finish");
    add(conduct.help, "F1", "Help; the clock stands still");
    return help;
}

/// What a practice task asks for, with the hints for this device.
void set_steps(view::OverlayState& overlay, const curriculum::Task& task, const std::string& device,
               const std::string& language) {
    const auto with_keys = [&](const std::string& text) {
        return haptics::in_layout(text, overlay.layout, overlay.practice.device, language);
    };
    overlay.practice.device = haptics::hint_device(device);
    overlay.practice.steps.clear();
    const std::vector<curriculum::TaskStep> steps = curriculum::steps_for(task, device);
    for (size_t i = 0; i < steps.size(); ++i) {
        const curriculum::TaskStep& step = steps[i];
        const sim::Hand before = i > 0 ? steps[i - 1].goal.hand : sim::Hand::kRight;
        const bool changes = step.goal.hand != before && step.goal.hand != sim::Hand::kCamera;
        overlay.practice.steps.push_back(
            {with_keys(step.text.in(language)),
             with_keys(curriculum::step_hint(step, device, changes).in(language)), changes});
        // A line that is to be followed must be seen.
        overlay.show_guide = overlay.show_guide || step.goal.kind == sim::PracticeKind::kTrace;
    }
}

}  // namespace

view::OverlayState attempt_overlay(const curriculum::Task& task, const Arguments& arguments) {
    view::OverlayState overlay;
    overlay.language = arguments.language;
    overlay.title = task.title.in(arguments.language);
    overlay.goal = task.goal.in(arguments.language);
    overlay.help = controls(arguments);
    overlay.layout = arguments.layout;
    overlay.time_limit_s = task.time_limit_s > 0 || arguments.duration_s > 0
                               ? curriculum::limit_of(task, arguments.duration_s)
                               : 0;
    // A limit that somebody else set (a study's familiarisation, an exam) is shown as what is left.
    overlay.remaining =
        arguments.duration_s > 0 || arguments.mode == curriculum::AttemptMode::kExam;
    overlay.depth_aid = arguments.aids.depth;
    overlay.motion = motion_wanted();
    overlay.full_force_n = task.scene.contact.over_force_n;
    for (const sim::ToolSpec& tool : task.scene.tools) {
        if (tool.kind == sim::ToolKind::kScope) continue;
        overlay.cut_power_w = tool.cut_power_w;
        overlay.coag_power_w = tool.coag_power_w;
        break;
    }
    set_steps(overlay, task, arguments.device, arguments.language);
    overlay.exam = !arguments.aids.read_outs;
    overlay.warnings = arguments.aids.warnings;
    if (arguments.stage > 0) overlay.banner = "FROM A STAGE, not scored";
    if (!curriculum::preset_of(task).empty()) overlay.banner = "TUNED, not scored";
    if (arguments.demonstration) overlay.banner = "DEMONSTRATION";
    return overlay;
}

view::OverlayState replay_overlay(const curriculum::Task& task, const sim::Recording& recording,
                                  const Arguments& arguments) {
    view::OverlayState overlay = attempt_overlay(task, arguments);
    overlay.layout = {};  // nobody holds anything
    // The steps of whoever was recorded; nobody is to do anything now.
    set_steps(overlay, task, recording.header.device, arguments.language);
    for (auto& step : overlay.practice.steps) step.hint.clear();
    overlay.time_limit_s = recording.end.duration_s;
    overlay.keys = "F1 keys   Space pause   ← → 5 s   ↑ ↓ speed   V camera   Q close";
    overlay.heading = recording.header.mode == "exam"    ? "Replay: exam"
                      : recording.header.mode == "study" ? "Replay: study"
                                                         : "Replay: practice";
    if (recording.header.stage > 0) overlay.banner = "FROM A STAGE, not scored";
    if (recording.header.demonstration) overlay.banner = "DEMONSTRATION";
    return overlay;
}

view::ViewSettings view_settings(const Arguments& arguments, const std::string& title) {
    view::ViewSettings settings;
    settings.width = arguments.width;
    settings.height = arguments.height;
    settings.offscreen = arguments.headless;
    settings.adaptive = !arguments.headless;
    settings.fullscreen = arguments.fullscreen;
    settings.place = arguments.place;
    // Steered from another window, it must not vanish behind that one with the first click there.
    // Without a place of its own it would cover what it is steered by.
    settings.floating = arguments.control && arguments.place.has_value();
    settings.title = "Placode: " + title;
    settings.greeting = view::translated("The field is being prepared ...", arguments.language);
    if (arguments.headless) {  // pictures may take their time
        settings.quality.samples = 4;
        settings.quality.shadows = true;
    }
    return settings;
}

}  // namespace placode::ui
