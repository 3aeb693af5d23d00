// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Keys that are let go unseen: while another program has the keyboard for itself (a menu of the
// desktop, a picture of the screen), a window of X11 keeps the focus and is told of no release.

#include <bitset>
#include <optional>
#include <vector>

namespace placode::view {

/// The keyboard's own keys that are down, by scancode.
using DownKeys = std::bitset<256>;

/// What X11's keyboard says now; nothing under Wayland. Main thread, while a window is open.
[[nodiscard]] std::optional<DownKeys> keys_of_keyboard() noexcept;

/// The keys that are down by what the window was told. Main thread.
class HeldKeys {
 public:
    void pressed(int code, int scancode) {
        released(code);
        keys_.push_back({.code = code, .scancode = scancode});
    }
    void released(int code) {
        std::erase_if(keys_, [code](const Held& key) { return key.code == code; });
    }
    void clear() { keys_.clear(); }
    [[nodiscard]] bool has(int code) const {
        for (const Held& key : keys_)
            if (key.code == code) return true;
        return false;
    }
    /// Ten times a second, and only while a key is down: time to look at the keyboard.
    [[nodiscard]] bool due(double now_s) {
        if (keys_.empty() || now_s < looked_s_ + kEveryS) return false;
        looked_s_ = now_s;
        return true;
    }
    /// Codes of the keys that were let go unseen; they are held no more. Those that were up the
    /// last time as well: a release that is on its way arrives until then.
    [[nodiscard]] std::vector<int> lost(const DownKeys& keyboard) {
        std::vector<int> codes;
        for (Held& key : keys_) {
            const bool known = key.scancode >= 0 && key.scancode < 256;
            const bool up = known && !keyboard[static_cast<size_t>(key.scancode)];
            if (up && key.up) codes.push_back(key.code);
            key.up = up;
        }
        for (const int code : codes) released(code);
        return codes;
    }

    static constexpr double kEveryS = 0.1;

 private:
    struct Held {
        int code = 0, scancode = 0;
        bool up = false;  ///< When it was looked at last.
    };
    std::vector<Held> keys_;
    double looked_s_ = 0;
};

}  // namespace placode::view
