// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Runs work in a child process under ptrace, sees every system call of it that changes files, and
// kills it at one of them (what `kill -9` leaves behind) or lets that one fail.

#include <fcntl.h>
#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/user.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace placode::test {

struct TracedOptions {
    int kill_at = -1;               ///< Number of the step before which it is killed; -1 = never.
    int every_nth_write = 16;       ///< Of the writes into files only these count as steps.
    int fail_at = -1;               ///< Number of the step that is not done; -1 = none.
    int fail_with = EIO;            ///< What that step answers.
    bool without_exchange = false;  ///< renameat2() answers EINVAL, as on some file systems.
    /// Sees each step before it happens, e.g. "fsync /x/placode.db.restoring".
    std::function<void(const std::string&)> before;
};

struct TracedRun {
    bool killed = false;
    int exit_status = -1;
    int steps = 0;
    std::vector<std::string> log;
};

class TracedChild {
 public:
    explicit TracedChild(TracedOptions options) : options_(std::move(options)) {}

    /// @param work returns the exit status of the child.
    TracedRun run(const std::function<int()>& work) {
        pid_ = ::fork();
        if (pid_ == 0) {
            ::ptrace(PTRACE_TRACEME, 0, nullptr, nullptr);
            ::raise(SIGSTOP);
            ::_exit(work());
        }
        int status = 0;
        ::waitpid(pid_, &status, 0);
        ::ptrace(PTRACE_SETOPTIONS, pid_, nullptr, PTRACE_O_TRACESYSGOOD | PTRACE_O_EXITKILL);
        long signal = 0;
        for (;;) {
            ::ptrace(PTRACE_SYSCALL, pid_, nullptr, signal);
            ::waitpid(pid_, &status, 0);
            if (WIFEXITED(status) || WIFSIGNALED(status)) break;
            signal = 0;
            if (WSTOPSIG(status) == (SIGTRAP | 0x80))
                on_call();
            else
                signal = WSTOPSIG(status);
        }
        result_.exit_status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
        return result_;
    }

 private:
    void on_call() {
        __ptrace_syscall_info info{};
        ::ptrace(PTRACE_GET_SYSCALL_INFO, pid_, sizeof info, &info);
        if (info.op == PTRACE_SYSCALL_INFO_EXIT && refused_ != 0) {
            answer(-refused_);
            refused_ = 0;
        }
        if (info.op != PTRACE_SYSCALL_INFO_ENTRY) return;
        const std::string step = name_of(info);
        if (step.empty()) return;
        result_.log.push_back(step);
        if (options_.before) options_.before(step);
        if (options_.kill_at == result_.steps) {
            ::kill(pid_, SIGKILL);
            result_.killed = true;
            return;
        }
        if (options_.fail_at == result_.steps) refused_ = options_.fail_with;
        ++result_.steps;
        if (options_.without_exchange && info.entry.nr == SYS_renameat2) refused_ = EINVAL;
        if (refused_ != 0) number(-1);
    }

    std::string name_of(const __ptrace_syscall_info& info) {
        const auto* at = info.entry.args;
        switch (info.entry.nr) {
            case SYS_rename:
                return "rename " + text(at[0]) + " " + text(at[1]);
            case SYS_renameat2:
                return "exchange " + text(at[1]) + " " + text(at[3]);
            case SYS_unlink:
                return "unlink " + text(at[0]);
            case SYS_unlinkat:
                return "unlink " + text(at[1]);
            case SYS_openat:
                return (at[2] & O_CREAT) != 0 ? "create " + text(at[1]) : "";
            case SYS_ftruncate:
                return "truncate " + file(at[0]);
            case SYS_fsync:
            case SYS_fdatasync:
                return "fsync " + file(at[0]);
            case SYS_copy_file_range:
            case SYS_sendfile:
                return "copy " + file(info.entry.nr == SYS_sendfile ? at[0] : at[2]);
            case SYS_link:
                return "link " + text(at[0]) + " " + text(at[1]);
            case SYS_mkdir:
                return "mkdir " + text(at[0]);
            case SYS_write:
                // Into a file, not a pipe or a counter of Qt's.
                return file(at[0]).starts_with('/') ? "write " + file(at[0]) : "";
            case SYS_pwrite64:
                return writes_++ % options_.every_nth_write == 0 ? "write " + file(at[0]) : "";
            default:
                return {};
        }
    }
    [[nodiscard]] std::string text(uint64_t address) const {
        char bytes[512] = {};
        iovec here{bytes, sizeof bytes - 1};
        iovec there{reinterpret_cast<void*>(address), sizeof bytes - 1};
        // A short text near the end of a page: as far as it can be read.
        while (there.iov_len > 0 && ::process_vm_readv(pid_, &here, 1, &there, 1, 0) < 0)
            there.iov_len /= 2;
        return bytes;
    }
    [[nodiscard]] std::string file(uint64_t number) const {
        std::error_code error;
        return std::filesystem::read_symlink(
                   "/proc/" + std::to_string(pid_) + "/fd/" + std::to_string(number), error)
            .string();
    }
#ifdef __x86_64__
    void number(long nr) const {
        user_regs_struct registers{};
        ::ptrace(PTRACE_GETREGS, pid_, nullptr, &registers);
        registers.orig_rax = static_cast<unsigned long long>(nr);
        ::ptrace(PTRACE_SETREGS, pid_, nullptr, &registers);
    }
    void answer(long value) const {
        user_regs_struct registers{};
        ::ptrace(PTRACE_GETREGS, pid_, nullptr, &registers);
        registers.rax = static_cast<unsigned long long>(value);
        ::ptrace(PTRACE_SETREGS, pid_, nullptr, &registers);
    }
#else
    void number(long) const {}
    void answer(long) const {}
#endif

    TracedOptions options_;
    TracedRun result_;
    pid_t pid_ = -1;
    int writes_ = 0;
    int refused_ = 0;  ///< What the call that is under way answers; 0 = what it likes.
};

}  // namespace placode::test
