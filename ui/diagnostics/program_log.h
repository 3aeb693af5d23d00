// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A log of what the programs did on this computer, for whoever looks for a fault: started, ended,
// what could not be opened. It holds no personal data, and the types see to that: a line is made of
// words that stand in the source, of numbers, and of the ids of definitions.

#include <concepts>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>

namespace placode::ui {

/// A word that stands in the source, so that nobody can have typed it.
class LogWord {
 public:
    // NOLINTNEXTLINE(google-explicit-constructor): a literal is one.
    consteval LogWord(const char* text) : text_(text) {}
    [[nodiscard]] const char* text() const noexcept { return text_; }

 private:
    const char* text_;
};

/// "seconds=12" beside what happened.
class LogField {
 public:
    LogField(LogWord name, LogWord value);
    template <std::integral Number>
    LogField(LogWord name, Number value) : text_(name.text()) {
        text_ += '=';
        text_ += std::to_string(value);
    }
    /// The id of a task, device or page: of other text only a-z, 0-9, "_", "-", "." and ":" are
    /// kept, 64 characters at most.
    [[nodiscard]] static LogField id(LogWord name, std::string_view id);
    [[nodiscard]] const std::string& text() const noexcept { return text_; }

 private:
    explicit LogField(std::string text) : text_(std::move(text)) {}
    std::string text_;
};

/// Any thread, any number of processes on one file. A log that cannot be written stops nothing: its
/// lines are lost.
class ProgramLog {
 public:
    /// The folder is made, for its owner only. `program` stands in every line.
    ProgramLog(std::filesystem::path folder, LogWord program);
    /// "2026-11-29T10:00:00Z placode-sim 4711 attempt_began task=suture_slit"
    void note(LogWord what, std::initializer_list<LogField> fields = {}) const noexcept;

    static constexpr int64_t kMostBytes =
        int64_t{256} * 1024;          ///< Of one file; then it is put aside.
    static constexpr int kOlder = 3;  ///< Files that are kept beside it.

 private:
    std::filesystem::path file_;
    LogWord program_;
};

/// Where logs and crash reports lie: $PLACODE_LOG, else $XDG_DATA_HOME/placode/log, else the same
/// in ~/.local/share. Empty without a home: then there are none.
[[nodiscard]] std::filesystem::path diagnostics_folder();
/// "placode.log"; the ones before it end in ".1" to ".3", the oldest last.
[[nodiscard]] std::filesystem::path log_file(const std::filesystem::path& folder);
/// Of the file and those before it, the oldest line first; "" without any.
[[nodiscard]] std::string read_log(const std::filesystem::path& folder);

/// From here on log_note() of this process writes there.
void open_program_log(LogWord program);
/// Nothing before the log was opened.
void log_note(LogWord what, std::initializer_list<LogField> fields = {}) noexcept;

}  // namespace placode::ui
