// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A serial port that speaks in lines of text, for a servo thread: nothing blocks, allocates or
// throws after construction; a port that was pulled out is looked for again.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace placode::haptics {

class SerialLine {
 public:
    SerialLine(std::string path, double settle_s);
    ~SerialLine();
    SerialLine(const SerialLine&) = delete;
    SerialLine& operator=(const SerialLine&) = delete;

    /// Opens when closed (once a second), receives. Every tick. True: open and settled.
    bool step(int64_t t_ns) noexcept;
    /// The next complete line without its end, valid until the next call.
    [[nodiscard]] bool next_line(std::string_view& line) noexcept;
    /// False: the port does not take it.
    bool send(std::string_view text) noexcept;
    void close() noexcept;
    /// What the last attempt to open said (errno); 0 = it is open.
    [[nodiscard]] int problem() const noexcept { return problem_; }
    [[nodiscard]] const std::string& path() const noexcept { return path_; }

 private:
    void open(int64_t t_ns) noexcept;

    std::string path_;
    int64_t settle_ns_, ready_ns_ = 0, retry_ns_ = 0;
    int file_ = -1, problem_ = 0;
    std::array<char, 4096> in_{};
    size_t size_ = 0, taken_ = 0;
};

}  // namespace placode::haptics
