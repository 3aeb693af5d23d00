// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What takes hours when it is tried as often as it should be: the suite tries a sample of it, and
// `./test.sh --long` all, which ends with a table of what was tried and what failed.

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <fstream>

namespace placode::test {

/// @return `sample`, or `all` in a long run.
inline int times(int sample, int all) {
    return std::getenv("PLACODE_LONG_TESTS") != nullptr ? all : sample;
}

/// A line of the table, written when the test ends: name, tried, failed, seconds.
class Bar {
 public:
    /// @pre no comma in the name: the table is read as CSV.
    explicit Bar(const char* name) : name_(name) {}
    Bar(const Bar&) = delete;
    Bar& operator=(const Bar&) = delete;
    ~Bar() {
        const char* path = std::getenv("PLACODE_BARS");
        if (path == nullptr) return;
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin_;
        std::ofstream(path, std::ios::app)
            << name_ << ',' << tried_ << ',' << failed_ << ',' << took.count() << '\n';
    }
    void tried(bool good) {
        ++tried_;
        if (!good) ++failed_;
    }

 private:
    const char* name_;
    int64_t tried_ = 0, failed_ = 0;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace placode::test
