// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/diagnostics/program_log.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <memory>
#include <sstream>

#include "sim/core/user_folders.h"

namespace placode::ui {
namespace fs = std::filesystem;
namespace {

constexpr size_t kMostId = 64;

std::unique_ptr<const ProgramLog>& log_of_this_process() {
    static std::unique_ptr<const ProgramLog> log;
    return log;
}

std::string now_utc() {
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    ::gmtime_r(&now, &parts);
    std::array<char, 32> text{};
    std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts);
    return text.data();
}

fs::path numbered(const fs::path& file, int number) {
    return file.string() + "." + std::to_string(number);
}

/// The file, open and locked. Another process may put it aside between opening and locking: then
/// the lock is on a file that is no longer the log.
class LockedFile {
 public:
    explicit LockedFile(const fs::path& path) {
        for (int tries = 0; tries < 10; ++tries) {
            descriptor_ =
                ::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC | O_NOFOLLOW, 0600);
            if (descriptor_ < 0) return;
            ::flock(descriptor_, LOCK_EX);
            struct stat here {
            }, there{};
            const bool same = ::fstat(descriptor_, &here) == 0 &&
                              ::stat(path.c_str(), &there) == 0 && here.st_ino == there.st_ino;
            bytes_ = here.st_size;
            if (same) return;
            close();
        }
    }
    ~LockedFile() { close(); }
    LockedFile(const LockedFile&) = delete;
    LockedFile& operator=(const LockedFile&) = delete;

    [[nodiscard]] bool is_open() const noexcept { return descriptor_ >= 0; }
    [[nodiscard]] int64_t bytes() const noexcept { return bytes_; }
    /// In one piece, or what fits on the disk.
    void write(const std::string& line) const noexcept {
        [[maybe_unused]] const ssize_t written = ::write(descriptor_, line.data(), line.size());
    }

 private:
    void close() noexcept {
        if (descriptor_ >= 0) ::close(descriptor_);
        descriptor_ = -1;
    }
    int descriptor_ = -1;
    int64_t bytes_ = 0;
};

/// The oldest goes.
void put_aside(const fs::path& file) {
    std::error_code ignored;
    for (int i = ProgramLog::kOlder; i > 1; --i)
        fs::rename(numbered(file, i - 1), numbered(file, i), ignored);
    fs::rename(file, numbered(file, 1), ignored);
}

void append(const fs::path& file, const std::string& line) {
    {
        const LockedFile log(file);
        if (!log.is_open()) return;
        if (log.bytes() + static_cast<int64_t>(line.size()) <= ProgramLog::kMostBytes)
            return log.write(line);
        put_aside(file);
    }
    const LockedFile anew(file);
    if (anew.is_open()) anew.write(line);
}

void add_file(const fs::path& file, std::string& text) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream all;
    if (in && in.peek() != std::ifstream::traits_type::eof()) all << in.rdbuf();
    text += all.str();
}

}  // namespace

LogField::LogField(LogWord name, LogWord value)
    : text_(std::string(name.text()) + "=" + value.text()) {}

LogField LogField::id(LogWord name, std::string_view id) {
    std::string text = std::string(name.text()) + "=";
    const size_t most = text.size() + kMostId;
    for (const char c : id) {
        const bool kept = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' ||
                          c == '-' || c == '.' || c == ':';
        if (kept && text.size() < most) text += c;
    }
    return LogField(std::move(text));
}

ProgramLog::ProgramLog(fs::path folder, LogWord program)
    : file_(log_file(folder)), program_(program) {
    std::error_code ignored;
    if (fs::create_directories(folder, ignored))
        fs::permissions(folder, fs::perms::owner_all, ignored);
}

void ProgramLog::note(LogWord what, std::initializer_list<LogField> fields) const noexcept {
    try {
        std::string line = now_utc() + " " + program_.text() + " " + std::to_string(::getpid()) +
                           " " + what.text();
        for (const LogField& field : fields) line += " " + field.text();
        append(file_, line + "\n");
    } catch (...) {  // no memory for a line: it is lost
    }
}

fs::path diagnostics_folder() {
    const char* chosen = std::getenv("PLACODE_LOG");  // NOLINT(concurrency-mt-unsafe)
    if (chosen != nullptr && *chosen != '\0') return chosen;
    return sim::user_path(sim::UserFolder::kData, "placode/log");
}

fs::path log_file(const fs::path& folder) {
    return folder.empty() ? folder : folder / "placode.log";
}

std::string read_log(const fs::path& folder) {
    std::string text;
    if (folder.empty()) return text;
    const fs::path file = log_file(folder);
    for (int i = ProgramLog::kOlder; i >= 1; --i) add_file(numbered(file, i), text);
    add_file(file, text);
    return text;
}

void open_program_log(LogWord program) {
    log_of_this_process() = std::make_unique<const ProgramLog>(diagnostics_folder(), program);
}

void log_note(LogWord what, std::initializer_list<LogField> fields) noexcept {
    if (log_of_this_process()) log_of_this_process()->note(what, fields);
}

}  // namespace placode::ui
