// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/diagnostics/crash_report.h"

#include <cxxabi.h>
#include <execinfo.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fstream>
#include <iterator>
#include <typeinfo>

#include "ui/version.h"

namespace placode::ui {
namespace fs = std::filesystem;
namespace {

constexpr int kMostCalls = 64;
constexpr size_t kStackBytes = 64 * 1024;
constexpr std::array kSignals{SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};

// All that the handler uses is made before: in a crash nothing may be allocated.
std::array<char, 4096> path{}, head{};
std::array<char, 256> uncaught{};
std::array<void*, kMostCalls> calls{};
alignas(16) std::array<char, kStackBytes> own_stack{};

const char* name_of(int signal) noexcept {
    switch (signal) {
        case SIGSEGV:
            return "SIGSEGV";
        case SIGBUS:
            return "SIGBUS";
        case SIGFPE:
            return "SIGFPE";
        case SIGILL:
            return "SIGILL";
        default:
            return "SIGABRT";
    }
}

void put(int file, const char* text) noexcept {
    [[maybe_unused]] const ssize_t written = ::write(file, text, std::strlen(text));
}

/// Calls only what POSIX allows in a handler, and backtrace(), which was loaded before.
void on_crash(int signal) noexcept {
    const int file = ::open(path.data(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    if (file >= 0) {
        put(file, head.data());
        put(file, "signal: ");
        put(file, name_of(signal));
        put(file, "\n");
        if (uncaught[0] != '\0') {
            put(file, "exception that nobody caught: ");
            put(file, uncaught.data());
            put(file, "\n");
        }
        put(file, "calls, the last first:\n");
        ::backtrace_symbols_fd(calls.data(), ::backtrace(calls.data(), kMostCalls), file);
        ::close(file);
    }
    // SA_RESETHAND put the default back: it ends as if nobody had looked.
    ::raise(signal);
}

/// Its type, and not what it says: that may have a name in it.
[[noreturn]] void on_terminate() noexcept {
    if (const std::type_info* type = abi::__cxa_current_exception_type(); type != nullptr)
        std::snprintf(uncaught.data(), uncaught.size(), "%s", type->name());
    std::abort();
}

[[maybe_unused]] void install() {
    calls.fill(nullptr);
    ::backtrace(calls.data(), 1);  // loads what it needs
    stack_t stack{};
    stack.ss_sp = own_stack.data();
    stack.ss_size = own_stack.size();
    ::sigaltstack(&stack, nullptr);
    struct sigaction action {};
    action.sa_handler = on_crash;
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_ONSTACK | SA_NODEFER);
    ::sigemptyset(&action.sa_mask);
    for (const int signal : kSignals) ::sigaction(signal, &action, nullptr);
    std::set_terminate(on_terminate);
}

std::string without_home(std::string text) {
    const char* home = std::getenv("HOME");  // NOLINT(concurrency-mt-unsafe)
    const std::string folder = home != nullptr ? home : "";
    if (folder.size() < 2) return text;
    for (size_t at = text.find(folder); at != std::string::npos; at = text.find(folder, at + 1))
        text.replace(at, folder.size(), "~");
    return text;
}

CrashReport read_report(const fs::path& file) {
    CrashReport report;
    report.file = file;
    const std::string name = file.stem().string();
    report.program = name.substr(0, name.rfind('-'));
    struct stat about {};
    if (::stat(file.c_str(), &about) == 0) report.time = about.st_mtime;
    std::ifstream in(file, std::ios::binary);
    report.text = without_home({std::istreambuf_iterator<char>(in), {}});
    return report;
}

}  // namespace

void report_crashes(const fs::path& folder, LogWord program, const char* version) {
    if (folder.empty()) return;  // nowhere to keep one
    std::error_code ignored;
    if (fs::create_directories(folder, ignored))
        fs::permissions(folder, fs::perms::owner_all, ignored);
    const std::string file =
        (folder / program.text()).string() + "-" + std::to_string(::getpid()) + ".crash";
    fs::remove(file, ignored);  // of a process that had this number long ago
    if (file.size() >= path.size()) return;
    std::snprintf(path.data(), path.size(), "%s", file.c_str());
    std::snprintf(head.data(), head.size(),
                  "Placode: report of a crash\nprogram: %s\nversion: %s\n", program.text(),
                  version);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    install();
#endif
}

void begin_diagnostics(LogWord program) {
    const fs::path folder = diagnostics_folder();
    open_program_log(program);
    report_crashes(folder, program, version_text());
    log_note("started");
}

std::vector<CrashReport> crash_reports(const fs::path& folder) {
    std::vector<CrashReport> reports;
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(folder, ignored))
        if (entry.path().extension() == ".crash" && entry.is_regular_file(ignored))
            reports.push_back(read_report(entry.path()));
    std::sort(reports.begin(), reports.end(), [](const CrashReport& a, const CrashReport& b) {
        return a.time != b.time ? a.time > b.time : a.file > b.file;
    });
    while (std::ssize(reports) > kMostCrashReports) {
        fs::remove(reports.back().file, ignored);
        reports.pop_back();
    }
    return reports;
}

}  // namespace placode::ui
