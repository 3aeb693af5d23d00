// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/attempt/replay_control.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace placode::ui {
namespace {

constexpr std::array<const char*, kReplayCameras> kNames{"scope", "above", "left", "feet", "near"};

bool number(std::string_view text, double& value) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() && std::isfinite(value);
}

std::string quoted(std::string_view text) {
    std::string with_marks(1, '"');
    with_marks.append(text);
    with_marks.push_back('"');
    return with_marks;
}

/// Speeds that the keys go through.
constexpr std::array<double, 7> kSpeeds{0.1, 0.25, 0.5, 1, 2, 4, 8};

double next_speed(double speed, int steps) {
    auto at = std::lower_bound(kSpeeds.begin(), kSpeeds.end(), speed - 1e-9) - kSpeeds.begin();
    return kSpeeds[static_cast<size_t>(
        std::clamp<std::ptrdiff_t>(at + steps, 0, std::ssize(kSpeeds) - 1))];
}

}  // namespace

bool camera_named(std::string_view name, ReplayCamera& camera) {
    for (size_t i = 0; i < kNames.size(); ++i) {
        if (name != kNames[i]) continue;
        camera = static_cast<ReplayCamera>(i);
        return true;
    }
    return false;
}

const char* camera_name(ReplayCamera camera) { return kNames[static_cast<size_t>(camera)]; }

void apply_line(std::string_view line, ReplayWish& wish) {
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
    if (line.empty()) return;
    const size_t space = std::min(line.find(' '), line.size());
    const std::string_view verb = line.substr(0, space);
    const std::string_view value = line.substr(std::min(space + 1, line.size()));
    wish.problem.clear();
    double wanted = 0;
    if (verb == "pause") {
        wish.paused = true;
    } else if (verb == "play") {
        wish.paused = false;
    } else if (verb == "quit") {
        wish.quit = true;
    } else if (verb == "camera") {
        if (!camera_named(value, wish.camera))
            wish.problem =
                "camera: found " + quoted(value) + ", expected scope, above, left, feet or near";
    } else if (verb == "speed") {
        if (number(value, wanted) && wanted >= kSlowest && wanted <= kFastest)
            wish.speed = wanted;
        else
            wish.problem = "speed: found " + quoted(value) + ", expected 0.1 to 8";
    } else if (verb == "seek") {
        if (number(value, wanted) && wanted >= 0)
            wish.seek_s = wanted;
        else
            wish.problem = "seek: found " + quoted(value) + ", expected seconds from 0";
    } else {
        wish.problem =
            "found " + quoted(verb) + ", expected camera, speed, seek, pause, play or quit";
    }
}

bool LineInput::next(std::string& line) {
    while (!closed_) {
        pollfd descriptor{STDIN_FILENO, POLLIN, 0};
        if (::poll(&descriptor, 1, 0) <= 0) break;
        char block[512];
        const ssize_t got = ::read(STDIN_FILENO, block, sizeof block);
        if (got <= 0) {
            closed_ = true;
            break;
        }
        pending_.append(block, static_cast<size_t>(got));
    }
    const size_t end = pending_.find('\n');
    if (end == std::string::npos) {
        if (pending_.size() > 4096) pending_.clear();  // not a command, whatever it is
        return false;
    }
    line = pending_.substr(0, end);
    pending_.erase(0, end + 1);
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.pop_back();
    return true;
}

void ControlInput::poll(ReplayWish& wish) {
    std::string line;
    while (input_.next(line)) apply_line(line, wish);
    // Who steered is gone: nobody could close the window any more.
    if (input_.closed()) wish.quit = true;
}

int ReplayKeys::presses_of(const sim::WindowInput& input, sim::Key key) {
    const auto i = static_cast<size_t>(key);
    return static_cast<int>(input.presses[i] - last_.presses[i]);
}

void ReplayKeys::apply(const sim::WindowInput& input, double now_s, ReplayWish& wish) {
    using sim::Key;
    // Esc pauses an attempt; in a replay it must not do more.
    const int pauses = presses_of(input, Key::kSpace) + presses_of(input, Key::kEscape);
    if (pauses % 2 != 0) wish.paused = !wish.paused;
    const int path = presses_of(input, Key::kRight) - presses_of(input, Key::kLeft);
    if (path != 0) wish.seek_s = std::max(0.0, now_s + 5.0 * path);
    const int faster = presses_of(input, Key::kUp) - presses_of(input, Key::kDown);
    if (faster != 0) wish.speed = next_speed(wish.speed, faster);
    const int cameras = presses_of(input, Key::kV);
    wish.camera =
        static_cast<ReplayCamera>((static_cast<int>(wish.camera) + cameras) % kReplayCameras);
    if (presses_of(input, Key::kQ) > 0) wish.quit = true;
    last_ = input;
}

void place_camera(ReplayCamera camera, const std::vector<sim::ToolSpec>& tools,
                  sim::Snapshot& snapshot) {
    if (camera == ReplayCamera::kScope) return;
    using sim::Vec3;
    Vec3 target = Vec3::Zero(), eye(0, 0, 0.045);
    if (camera == ReplayCamera::kLeft) eye = Vec3(0, 0.035, 0.022);
    if (camera == ReplayCamera::kFeet) eye = Vec3(-0.038, 0, 0.022);
    if (camera == ReplayCamera::kNear) {
        for (int i = 0; i < snapshot.tool_count; ++i) {
            const sim::ToolSnapshot& tool = snapshot.tools[static_cast<size_t>(i)];
            if (tool.kind == sim::ToolKind::kScope || tool.pose.p.norm() > 0.03) continue;
            target = tool.pose.p;
            break;
        }
        eye = target + Vec3(-0.009, 0.004, 0.014);
    }
    const view::Camera seen = view::look_at(1000 * eye, 1000 * target, 70);
    for (int i = 0; i < snapshot.tool_count; ++i) {
        sim::ToolSnapshot& tool = snapshot.tools[static_cast<size_t>(i)];
        if (tool.kind != sim::ToolKind::kScope) continue;
        sim::Mat3 axes;  // x right, y down, z into the picture
        axes.col(0) = seen.right;
        axes.col(1) = -seen.up;
        axes.col(2) = seen.forward;
        // An oblique optic looks past its axis: turned back by its angle.
        const double oblique =
            static_cast<size_t>(i) < tools.size()
                ? tools[static_cast<size_t>(i)].scope_angle_deg * 3.14159265358979 / 180
                : 0;
        tool.pose.p = eye;
        tool.pose.q = sim::Quat(axes) * sim::Quat(Eigen::AngleAxisd(oblique, sim::Vec3::UnitX()));
    }
}

}  // namespace placode::ui
