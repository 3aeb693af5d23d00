// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A layer between SQLite and the disk (https://www.sqlite.org/vfs.html) that lets the n-th call
// fail, has no room left from the n-th write on, or loses power at the n-th call together with
// what was not synced. Whoever installs it also hands it every fsync() and fdatasync() of the
// program, so that it knows what the disk has to keep.
//
// Not modelled: the name of a file that the program itself made or renamed is kept at once, synced
// or not. Of files that SQLite makes or removes it is lost until their folder is synced.

#include <fcntl.h>
#include <sqlite3.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "sim/core/random.h"

namespace placode::test {

enum class Fault {
    kNone,
    kError,      ///< One write, sync, truncation, opening or removal answers that the disk failed.
    kReadError,  ///< One read does.
    kFull,       ///< From one write on there is no room.
    kPowerCut,   ///< The program ends, and everything that was not synced is as it was before.
    kPowerCutHalf  ///< The same, but the disk has kept about half of that, in any order.
};

inline constexpr int kPowerCutStatus = 9;  ///< Of a program that lost power.
inline constexpr int64_t kNever = -1;

class FaultVfs {
 public:
    /// SQLite's default from now on, in this program and in what it forks.
    static FaultVfs& install() {
        static FaultVfs layer;
        return layer;
    }
    FaultVfs(const FaultVfs&) = delete;
    FaultVfs& operator=(const FaultVfs&) = delete;

    /// @param at number of the call, from 0, of those that the fault is about; kNever = only count.
    /// @param attic a folder on the same disk for files that were removed and may come back.
    void arm(Fault fault, int64_t at, const std::string& attic) {
        const std::lock_guard lock(mutex_);
        fault_ = fault;
        at_ = at;
        attic_ = attic;
        calls_ = 0;
        disks_.clear();
        created_.clear();
        removed_.clear();
    }
    void disarm() { arm(Fault::kNone, kNever, {}); }
    /// Calls since it was armed, of those that the fault is about.
    [[nodiscard]] int64_t calls() const { return calls_; }

    /// For fsync() and fdatasync(). The machine that runs the tests need not keep anything, so
    /// nothing is synced in fact, which is also quicker.
    int on_sync(int number) {
        if (!inside() && step(Call::kSync) != SQLITE_OK) {
            errno = EIO;
            return -1;
        }
        struct stat status {};
        if (fault_ == Fault::kNone || ::fstat(number, &status) != 0) return 0;
        const std::lock_guard lock(mutex_);
        if (S_ISDIR(status.st_mode))
            folder_is_kept(status);
        else if (const auto disk = disks_.find(key_of(status)); disk != disks_.end())
            disk->second = {};
        return 0;
    }

 private:
    enum class Call { kRead, kWrite, kSync, kTruncate, kOpen, kDelete };
    using Key = std::pair<dev_t, ino_t>;

    /// Since the last sync of a file.
    struct Change {
        size_t at = 0;
        std::string bytes;
        bool cut = false;  ///< The file ends at `at`.
    };
    struct Disk {
        bool changed = false;
        std::string folder, before;  ///< Where it lies; what it held at the last sync.
        std::vector<Change> changes;
    };
    struct Removed {
        std::string path, hidden;
    };
    /// What SQLite holds; the default layer's own file follows it in memory.
    struct File {
        sqlite3_file base;
        std::string* path;  ///< nullptr: a temporary file without a name.
        [[nodiscard]] sqlite3_file* real() { return reinterpret_cast<sqlite3_file*>(this + 1); }
    };

    FaultVfs() : real_(sqlite3_vfs_find(nullptr)), layer_(*real_) {
        layer_.zName = "placode-faults";
        layer_.szOsFile = static_cast<int>(sizeof(File)) + real_->szOsFile;
        layer_.pNext = nullptr;
        layer_.xOpen = open;
        layer_.xDelete = remove;
        sqlite3_vfs_register(&layer_, 1);
    }
    ~FaultVfs() {
        sqlite3_vfs_register(real_, 1);
        sqlite3_vfs_unregister(&layer_);
    }

    /// True while the default layer works: its syncs were counted when SQLite asked for them.
    static bool& inside() {
        thread_local bool value = false;
        return value;
    }
    template <class Work>
    static int pass_on(Work&& work) {
        inside() = true;
        const int code = work();
        inside() = false;
        return code;
    }
    static Key key_of(const struct stat& status) { return {status.st_dev, status.st_ino}; }
    [[nodiscard]] bool power_may_go() const {
        return fault_ == Fault::kPowerCut || fault_ == Fault::kPowerCutHalf;
    }
    static std::string folder_of(const std::string& path) {
        return std::filesystem::path(path).parent_path().string();
    }

    static int code_of(Call call) {
        switch (call) {
            case Call::kRead:
                return SQLITE_IOERR_READ;
            case Call::kWrite:
                return SQLITE_IOERR_WRITE;
            case Call::kSync:
                return SQLITE_IOERR_FSYNC;
            case Call::kTruncate:
                return SQLITE_IOERR_TRUNCATE;
            case Call::kDelete:
                return SQLITE_IOERR_DELETE;
            case Call::kOpen:
                break;
        }
        return SQLITE_IOERR;
    }

    /// Before each call: what it answers instead, or SQLITE_OK.
    int step(Call call) {
        const std::lock_guard lock(mutex_);
        const bool about = fault_ == Fault::kReadError ? call == Call::kRead
                           : fault_ == Fault::kFull    ? call == Call::kWrite
                                                       : call != Call::kRead;
        if (fault_ == Fault::kNone || !about) return SQLITE_OK;
        const int64_t number = calls_++;
        if (fault_ == Fault::kFull) return at_ != kNever && number >= at_ ? SQLITE_FULL : SQLITE_OK;
        if (number != at_) return SQLITE_OK;
        if (power_may_go()) lose_power();
        return code_of(call);
    }

    // --- what the disk has ---------------------------------------------------------------------

    /// Before a file changes for the first time since its last sync.
    void keep(File& file, Change change) {
        const std::lock_guard lock(mutex_);
        struct stat status {};
        if (!power_may_go() || file.path == nullptr || ::stat(file.path->c_str(), &status) != 0)
            return;
        Disk& disk = disks_[key_of(status)];
        if (!disk.changed) {
            disk.changed = true;
            disk.folder = folder_of(*file.path);
            sqlite3_int64 size = 0;
            file.real()->pMethods->xFileSize(file.real(), &size);
            disk.before.resize(static_cast<size_t>(size));
            file.real()->pMethods->xRead(file.real(), disk.before.data(), static_cast<int>(size),
                                         0);
        }
        disk.changes.push_back(std::move(change));
    }

    void folder_is_kept(const struct stat& folder) {
        const auto here = [&folder](const std::string& path) {
            struct stat status {};
            return ::stat(folder_of(path).c_str(), &status) == 0 &&
                   key_of(status) == key_of(folder);
        };
        std::erase_if(created_, here);
        std::erase_if(removed_, [&](const Removed& file) {
            return here(file.path) && ::unlink(file.hidden.c_str()) == 0;
        });
    }

    [[noreturn]] void lose_power() {
        sim::SplitMix64 random(static_cast<uint64_t>(at_));
        const auto kept = [&] { return fault_ == Fault::kPowerCutHalf && random.next() % 2 == 0; };
        for (const auto& [key, disk] : disks_) {
            if (!disk.changed) continue;
            std::string image = disk.before;
            for (const Change& change : disk.changes) {
                if (!kept()) continue;
                if (const size_t end = change.at + change.bytes.size(); change.cut)
                    image.resize(std::min(image.size(), change.at));
                else
                    image.resize(std::max(image.size(), end)),
                        change.bytes.copy(image.data() + change.at, change.bytes.size());
            }
            put_back(key, disk.folder, image);
        }
        for (const std::string& path : created_)
            if (!kept()) ::unlink(path.c_str());
        for (auto file = removed_.rbegin(); file != removed_.rend(); ++file)
            if (!kept() && ::access(file->path.c_str(), F_OK) != 0)
                ::rename(file->hidden.c_str(), file->path.c_str());
        ::_exit(kPowerCutStatus);
    }
    /// Under whatever name the file has now.
    void put_back(const Key& key, const std::string& folder, const std::string& image) const {
        for (const std::string& place : {folder, attic_}) {
            std::error_code ignored;
            for (const auto& entry : std::filesystem::directory_iterator(place, ignored)) {
                struct stat status {};
                if (::stat(entry.path().c_str(), &status) != 0 || key_of(status) != key) continue;
                const int file = ::open(entry.path().c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC);
                if (::write(file, image.data(), image.size()) < 0) ::_exit(1);
                ::close(file);
                return;
            }
        }
    }

    // --- SQLite's calls ------------------------------------------------------------------------

    static FaultVfs& layer() { return install(); }
    static File& of(sqlite3_file* file) { return *reinterpret_cast<File*>(file); }

    static int open(sqlite3_vfs*, const char* name, sqlite3_file* out, int flags, int* got_flags) {
        File& file = of(out);
        file.base.pMethods = nullptr;
        file.path = nullptr;
        if (const int code = layer().step(Call::kOpen); code != SQLITE_OK) return code;
        const bool was_there = name != nullptr && ::access(name, F_OK) == 0;
        const int code = pass_on([&] {
            return layer().real_->xOpen(layer().real_, name, file.real(), flags, got_flags);
        });
        if (file.real()->pMethods == nullptr) return code;
        static const sqlite3_io_methods methods = all_methods();
        file.base.pMethods = &methods;
        if (name == nullptr) return code;
        file.path = new std::string(name);
        struct stat status {};
        const std::lock_guard lock(layer().mutex_);
        if (layer().power_may_go() && ::stat(name, &status) == 0) {
            // The number of a file that is gone may be given to the next one.
            if (status.st_size == 0) layer().disks_.erase(key_of(status));
            if (!was_there) layer().created_.insert(*file.path);
        }
        return code;
    }
    static int remove(sqlite3_vfs*, const char* name, int sync_folder) {
        if (const int code = layer().step(Call::kDelete); code != SQLITE_OK) return code;
        if (layer().power_may_go() && sync_folder == 0 && ::access(name, F_OK) == 0) {
            const std::lock_guard lock(layer().mutex_);
            if (layer().created_.erase(name) > 0) return ::unlink(name), SQLITE_OK;
            const std::string hidden = layer().attic_ + "/" +
                                       std::to_string(layer().removed_.size()) + "-" +
                                       std::to_string(layer().calls_);
            if (::rename(name, hidden.c_str()) != 0) return SQLITE_IOERR_DELETE;
            layer().removed_.push_back({name, hidden});
            return SQLITE_OK;
        }
        return pass_on([&] { return layer().real_->xDelete(layer().real_, name, sync_folder); });
    }
    static int close(sqlite3_file* file) {
        delete std::exchange(of(file).path, nullptr);
        return of(file).real()->pMethods->xClose(of(file).real());
    }
    static int read(sqlite3_file* file, void* to, int size, sqlite3_int64 at) {
        if (const int code = layer().step(Call::kRead); code != SQLITE_OK) return code;
        return of(file).real()->pMethods->xRead(of(file).real(), to, size, at);
    }
    static int write(sqlite3_file* file, const void* from, int size, sqlite3_int64 at) {
        if (const int code = layer().step(Call::kWrite); code != SQLITE_OK) return code;
        layer().keep(of(file), {static_cast<size_t>(at),
                                {static_cast<const char*>(from), static_cast<size_t>(size)},
                                false});
        return of(file).real()->pMethods->xWrite(of(file).real(), from, size, at);
    }
    static int truncate(sqlite3_file* file, sqlite3_int64 size) {
        if (const int code = layer().step(Call::kTruncate); code != SQLITE_OK) return code;
        layer().keep(of(file), {static_cast<size_t>(size), {}, true});
        return of(file).real()->pMethods->xTruncate(of(file).real(), size);
    }
    static int sync(sqlite3_file* file, int flags) {
        if (const int code = layer().step(Call::kSync); code != SQLITE_OK) return code;
        return pass_on([&] { return of(file).real()->pMethods->xSync(of(file).real(), flags); });
    }
    /// Version 2: the log's shared memory, but no mapped files, whose writes nobody would see.
    static sqlite3_io_methods all_methods() {
        sqlite3_io_methods all{};
        all.iVersion = 2;
        all.xClose = close;
        all.xRead = read;
        all.xWrite = write;
        all.xTruncate = truncate;
        all.xSync = sync;
        all.xFileSize = [](sqlite3_file* f, sqlite3_int64* size) {
            return of(f).real()->pMethods->xFileSize(of(f).real(), size);
        };
        all.xLock = [](sqlite3_file* f, int level) {
            return of(f).real()->pMethods->xLock(of(f).real(), level);
        };
        all.xUnlock = [](sqlite3_file* f, int level) {
            return of(f).real()->pMethods->xUnlock(of(f).real(), level);
        };
        all.xCheckReservedLock = [](sqlite3_file* f, int* held) {
            return of(f).real()->pMethods->xCheckReservedLock(of(f).real(), held);
        };
        all.xFileControl = [](sqlite3_file* f, int what, void* with) {
            return of(f).real()->pMethods->xFileControl(of(f).real(), what, with);
        };
        all.xSectorSize = [](sqlite3_file* f) {
            return of(f).real()->pMethods->xSectorSize(of(f).real());
        };
        all.xDeviceCharacteristics = [](sqlite3_file* f) {
            return of(f).real()->pMethods->xDeviceCharacteristics(of(f).real());
        };
        all.xShmMap = [](sqlite3_file* f, int page, int size, int extend, void volatile** at) {
            return of(f).real()->pMethods->xShmMap(of(f).real(), page, size, extend, at);
        };
        all.xShmLock = [](sqlite3_file* f, int offset, int n, int flags) {
            return of(f).real()->pMethods->xShmLock(of(f).real(), offset, n, flags);
        };
        all.xShmBarrier = [](sqlite3_file* f) {
            of(f).real()->pMethods->xShmBarrier(of(f).real());
        };
        all.xShmUnmap = [](sqlite3_file* f, int remove_it) {
            return of(f).real()->pMethods->xShmUnmap(of(f).real(), remove_it);
        };
        return all;
    }

    sqlite3_vfs* real_;
    sqlite3_vfs layer_;
    std::mutex mutex_;
    Fault fault_ = Fault::kNone;
    int64_t at_ = kNever, calls_ = 0;
    std::string attic_;
    std::map<Key, Disk> disks_;
    std::set<std::string> created_;
    std::vector<Removed> removed_;
};

}  // namespace placode::test
