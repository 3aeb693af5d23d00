// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "batches/shard.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "batches/batch_error.h"
#include "batches/checksum.h"
#include "db/durable_file.h"

namespace placode::batches {
namespace {

namespace fs = std::filesystem;
using Kind = BatchError::Kind;

/// The file a shard is written into, locked as long as this lives. Its lock goes with the process,
/// and its name does not change: what a killed process left behind is written over.
class Draft {
 public:
    Draft(const fs::path& path, int shard) : path_(path) {
        // Whoever was at it before may rename the file between our opening and locking it: then
        // the lock is on another file than the name.
        do {
            close();
            file_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
            if (file_ < 0) fail();
            if (::flock(file_, LOCK_EX | LOCK_NB) != 0) {
                if (errno != EWOULDBLOCK) fail();
                close();
                throw BatchError(Kind::kBusy, "shard " + std::to_string(shard) +
                                                  ": another process is at it; wait for that one");
            }
        } while (!is_named());
        if (::ftruncate(file_, 0) != 0) fail();
    }
    ~Draft() {
        if (!kept_) ::unlink(path_.c_str());
        close();
    }
    Draft(const Draft&) = delete;
    Draft& operator=(const Draft&) = delete;

    /// On the disk, and then under its own name.
    void keep(const std::string& text, const fs::path& as) {
        for (size_t at = 0; at < text.size();) {
            const ssize_t written = ::write(file_, text.data() + at, text.size() - at);
            if (written < 0 && errno == EINTR) continue;
            if (written <= 0) fail();
            at += static_cast<size_t>(written);
        }
        if (::fsync(file_) != 0 || ::rename(path_.c_str(), as.c_str()) != 0) fail();
        kept_ = true;
        db::sync_folder_of(as.string());
    }

 private:
    [[nodiscard]] bool is_named() const {
        struct stat opened {
        }, named{};
        return ::fstat(file_, &opened) == 0 && ::stat(path_.c_str(), &named) == 0 &&
               opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
    }
    void close() {
        if (file_ >= 0) ::close(file_);
        file_ = -1;
    }
    [[noreturn]] void fail() {
        const std::string why = std::strerror(errno);
        close();
        throw BatchError(Kind::kFailed, path_.string() + ": cannot be written (" + why +
                                            "); make room there, or give this user the right");
    }

    fs::path path_;
    int file_ = -1;
    bool kept_ = false;
};

Json head_of(const Manifest& manifest, int shard, const std::string& lines) {
    const auto [first, behind] = manifest.range(shard);
    return {{"batch", manifest.seal},
            {"shard", shard},
            {"items", behind - first},
            {"build", manifest.build},
            {"sha256", sha256(lines)}};
}

void check_order(const Manifest& manifest, int shard, const std::string& build) {
    if (shard < 0 || shard >= manifest.shards())
        throw BatchError(Kind::kBadInput, "--shard " + std::to_string(shard) +
                                              ": the batch has no such shard; expected 0 to " +
                                              std::to_string(manifest.shards() - 1));
    if (build != manifest.build)
        throw BatchError(Kind::kBadInput,
                         "the batch was planned with " + manifest.build + " and this is " + build +
                             ": results could differ in their last bits; use that program and "
                             "processor, or plan anew in another folder");
}

}  // namespace

fs::path shard_path(const fs::path& folder, int shard) {
    char name[32];
    std::snprintf(name, sizeof name, "%06d.jsonl", shard);
    return folder / "shards" / name;
}

Shard read_shard(const fs::path& folder, const Manifest& manifest, int shard) {
    Shard result;
    const fs::path path = shard_path(folder, shard);
    if (!fs::exists(path)) return result;
    const std::string text = read_text(path);
    const size_t end = text.find('\n');
    const Json head = Json::parse(text.substr(0, end), nullptr, false);
    result.lines = end == std::string::npos ? "" : text.substr(end + 1);
    const auto is = [&](ShardState state, const std::string& problem) {
        result.state = state;
        result.problem = path.string() + ": " + problem;
    };
    if (!head.is_object() || !head.contains("batch") || !head.contains("sha256"))
        is(ShardState::kDamaged, "its first line cannot be read");
    else if (head["batch"] != manifest.seal)
        is(ShardState::kOfAnother, "is of another batch than manifest.json");
    else if (head != head_of(manifest, shard, result.lines))
        is(ShardState::kDamaged, "its checksum does not fit");
    else
        result.state = ShardState::kDone;
    return result;
}

bool do_shard(const fs::path& folder, const Manifest& manifest, int shard, const std::string& build,
              const GoOn& go_on, const ShardProgress& progress) {
    check_order(manifest, shard, build);
    const fs::path path = shard_path(folder, shard);
    if (read_shard(folder, manifest, shard).state == ShardState::kDone) return false;
    Draft draft(path.string() + ".part", shard);
    // Another process may have ended it meanwhile.
    const Shard before = read_shard(folder, manifest, shard);
    if (before.state == ShardState::kDone) return false;
    if (before.state == ShardState::kOfAnother)
        throw BatchError(Kind::kBadInput, before.problem +
                                              "; choose another folder for one of "
                                              "the two");
    Worker worker(folder, manifest, go_on);
    const auto [first, behind] = manifest.range(shard);
    std::string lines;
    for (size_t item = first; item < behind; ++item) {
        if (progress) progress(item - first, behind - first);
        lines += worker.perform(item).dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
    }
    draft.keep(head_of(manifest, shard, lines).dump() + "\n" + lines, path);
    return true;
}

}  // namespace placode::batches
