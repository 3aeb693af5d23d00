// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The talk of a Haptic Avatar on a serial line. A line holds commands, the answer their integers in
// the same order; numbers are multiplied by 10,000. The next line is sent when the last was
// answered. Servo thread: no call blocks, allocates or throws after construction.

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "haptics/serial_line.h"

namespace placode::haptics::avatar {

inline constexpr int64_t kSilenceNs = 100'000'000, kAnswerNs = 20'000'000;
inline constexpr double kScale = 10'000;
inline constexpr size_t kMaxAnswers = 16;

/// One line out.
class Line {
 public:
    Line& add(int number) noexcept {
        const auto [end, error] = std::to_chars(at_, text_.data() + text_.size() - 2, number);
        if (error == std::errc{}) {
            at_ = end;
            *at_++ = ' ';
        }
        return *this;
    }
    Line& add_scaled(double value) noexcept {
        return add(std::isfinite(value) ? static_cast<int>(std::lround(value * kScale)) : 0);
    }
    [[nodiscard]] std::string_view text() noexcept {
        *at_ = '\n';
        return {text_.data(), static_cast<size_t>(at_ - text_.data()) + 1};
    }

 private:
    std::array<char, 128> text_{};
    char* at_ = text_.data();
};

/// Reads the integers of an answer; false when there are not exactly `count`.
inline bool read_answer(std::string_view line, size_t count, std::array<int, kMaxAnswers>& values) {
    size_t found = 0;
    const char* at = line.data();
    const char* const end = line.data() + line.size();
    while (at < end) {
        if (*at == ' ' || *at == '\r' || *at == '\t') {
            ++at;
            continue;
        }
        if (found == count) return false;
        const auto [next, error] = std::from_chars(at, end, values[found]);
        if (error != std::errc{}) return false;
        ++found;
        at = next;
    }
    return found == count;
}

/// A device on a line that answers one line at a time, in order. Answers carry no number of their
/// line: one that comes too late is still awaited and left out, or the next line would take it for
/// its own, and so would every line after it.
struct Talker {
    explicit Talker(const std::string& path, double settle_s) : serial(path, settle_s) {}
    SerialLine serial;
    bool waiting = false, asked_more = false;
    bool left_out = false;  // an owed answer, since the last line
    int64_t owed = 0;       // answers to lines that nobody waits for any more
    size_t expected = 0;
    int64_t sent_ns = 0, seen_ns = 0, lines = 0;

    [[nodiscard]] bool alive(int64_t t_ns) const noexcept {
        return seen_ns > 0 && t_ns - seen_ns <= kSilenceNs;
    }
    /// True with the answer to the last line.
    bool hear(int64_t t_ns, std::array<int, kMaxAnswers>& values) noexcept {
        bool good = false;
        if (!serial.step(t_ns)) {
            waiting = false;
            owed = 0;
            return false;
        }
        std::string_view line;
        while (serial.next_line(line)) {
            if (owed > 0) {
                --owed;
                left_out = true;
                continue;
            }
            // What does not fit is no answer to this line: its own may follow.
            if (!waiting || !read_answer(line, expected, values)) continue;
            waiting = false;
            good = true;
            seen_ns = t_ns;
        }
        if (waiting && t_ns - sent_ns > kAnswerNs) {
            waiting = false;
            // Left out was this line's own, then: what was owed never comes.
            owed = left_out ? 0 : owed + 1;
        }
        return good;
    }
    void say(int64_t t_ns, std::string_view line, size_t answers) noexcept {
        waiting = serial.send(line);
        left_out = false;
        expected = answers;
        sent_ns = t_ns;
        ++lines;
    }
};

}  // namespace placode::haptics::avatar
