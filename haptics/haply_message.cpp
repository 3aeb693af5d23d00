// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/haply_message.h"

#include <algorithm>
#include <cmath>

namespace placode::haptics {

namespace {

// {a, b, c, home}, {button_0..3} or one {button}.
uint32_t read_buttons(JsonScan& scan) noexcept {
    uint32_t held = 0;
    scan.object([&](std::string_view key) {
        int bit = -1;
        if (key == "a" || key == "button_0" || key == "button") bit = 0;
        if (key == "b" || key == "button_1") bit = 1;
        if (key == "c" || key == "button_2") bit = 2;
        if (key == "home" || key == "button_3") bit = 3;
        if (bit < 0) return;
        if (scan.truth(false) || scan.number(0) > 0.5) held |= 1u << bit;
    });
    return held;
}

void read_config(JsonScan& scan, HaplyFound& one) noexcept {
    scan.object([&](std::string_view key) {
        if (key != "handedness") return;
        const std::string_view side = scan.text();
        one.handed = side == "left" || side == "right";
        one.left = side == "left";
    });
}

void read_status(JsonScan& scan, HaplyFound& one) noexcept {
    scan.object([&](std::string_view key) {
        if (key == "calibrated") one.calibrated = scan.truth(false);
        if (key == "ready") one.ready = scan.truth(false);
    });
}

void read_state(JsonScan& scan, HaplyFound& one, int64_t t_ns) noexcept {
    const double none = std::nan("");
    scan.object([&](std::string_view key) {
        if (key == "cursor_position") {
            Vec3 position(none, none, none);
            scan.object([&](std::string_view axis) {
                if (axis.size() == 1 && axis[0] >= 'x' && axis[0] <= 'z')
                    position[axis[0] - 'x'] = scan.number(none);
            });
            one.position = position;  // a part that is missing is a doubt
            one.seen_ns = t_ns;
        } else if (key == "orientation") {
            double w = none, x = none, y = none, z = none;
            scan.object([&](std::string_view part) {
                if (part == "w") w = scan.number(none);
                if (part == "x") x = scan.number(none);
                if (part == "y") y = scan.number(none);
                if (part == "z") z = scan.number(none);
            });
            const Quat q(w, x, y, z);
            if (q.coeffs().allFinite() && q.norm() > 0.5) one.orientation = q.normalized();
            one.seen_ns = t_ns;
        } else if (key == "buttons") {
            one.buttons = read_buttons(scan);
        } else if (key == "button") {
            one.buttons = scan.truth(false) ? 1u : 0u;
        }
    });
}

// Reads into a spare place first: the id may come after the state.
void read_one(JsonScan& scan, int64_t t_ns, std::array<HaplyFound, HaplyParts::kMost>& found,
              size_t& count) noexcept {
    JsonScan ahead = scan;
    HaplyId id;
    ahead.object([&](std::string_view key) {
        if (key == "device_id") id.set(ahead.text());
    });
    if (id.view().empty()) return;
    size_t place = 0;
    while (place < count && found[place].id.view() != id.view()) ++place;
    if (place == found.size()) return;
    HaplyFound& one = found[place];
    if (place == count) {
        one = {};
        one.id = id;
        ++count;
    }
    scan.object([&](std::string_view key) {
        if (key == "config") read_config(scan, one);
        if (key == "state") read_state(scan, one, t_ns);
        if (key == "status") read_status(scan, one);
    });
}

}  // namespace

void HaplyId::set(std::string_view name) noexcept {
    text_.fill('\0');
    std::copy_n(name.begin(), std::min(name.size(), text_.size() - 1), text_.begin());
}

void HaplyParts::read(std::string_view message, int64_t t_ns) noexcept {
    JsonScan scan(message);
    scan.object([&](std::string_view key) {
        if (key == "inverse3")
            scan.array([&] { read_one(scan, t_ns, arms, arm_count); });
        else if (key.find("verse_grip") != std::string_view::npos)
            scan.array([&] { read_one(scan, t_ns, grips, grip_count); });
    });
}

}  // namespace placode::haptics
