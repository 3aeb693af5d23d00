// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/stage_cache.h"

#include <sys/stat.h>

#include <QByteArray>
#include <QFile>
#include <algorithm>
#include <locale>
#include <optional>
#include <span>
#include <sstream>
#include <vector>

#include "curriculum/attempt_runner.h"
#include "db/packing.h"
#include "db/recording_chunks.h"
#include "db/whole_file.h"
#include "sim/core/user_folders.h"

namespace placode::db {
namespace {

namespace fs = std::filesystem;
using curriculum::StageStart;

constexpr const char* kMagic = "placode-stage-1";
constexpr const char* kEnding = ".stage";
// Some 10 MB are usual: what says that it is much larger is none.
constexpr size_t kMostFileBytes = size_t{96} << 20, kMostStateBytes = size_t{256} << 20;
constexpr size_t kLongestHead = 400;

/// This program: bits are promised for the same one only, also between two builds of a version.
std::string program_mark() {
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    struct stat file {};
    if (error || ::stat(program.c_str(), &file) != 0) return {};
    return std::to_string(file.st_size) + " " + std::to_string(file.st_mtim.tv_sec) + " " +
           std::to_string(file.st_mtim.tv_nsec);
}

std::string key_of(const std::string& task_json, uint64_t seed, int stage) {
    std::string all;
    for (const std::string& part :
         {curriculum::this_build(), program_mark(), task_json, std::to_string(seed),
          std::to_string(stage), std::to_string(curriculum::kStageSeed)})
        add_text(all, part);
    return checksum_hex(all);
}

/// First line of a file; the packed inputs and the packed state follow.
struct Head {
    std::string key, check;
    size_t given = 0, given_bytes = 0, state = 0, state_bytes = 0;
    uint64_t hash = 0;
};

/// Of what a file holds, and of the hash that its head says.
std::string check_of(std::span<const std::byte> bytes, uint64_t hash) {
    return checksum_hex(std::to_string(hash) + " " + checksum_hex(bytes));
}

std::string text_of(const Head& head) {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out << kMagic << ' ' << head.key << ' ' << head.check << ' ' << head.given << ' '
        << head.given_bytes << ' ' << head.state << ' ' << head.state_bytes << ' ' << head.hash
        << '\n';
    return out.str();
}

std::optional<Head> head_of(const std::string& line) {
    std::istringstream in(line);
    in.imbue(std::locale::classic());
    std::string magic;
    Head head;
    if (!(in >> magic >> head.key >> head.check >> head.given >> head.given_bytes >> head.state >>
          head.state_bytes >> head.hash) ||
        magic != kMagic || head.given_bytes > kMostFileBytes || head.state > kMostStateBytes)
        return std::nullopt;
    return head;
}

std::shared_ptr<const StageStart> read(const fs::path& file, const std::string& key, int stage) {
    QFile in(QString::fromStdString(file.string()));
    if (!in.open(QIODevice::ReadOnly) || in.size() > static_cast<qint64>(kMostFileBytes))
        return nullptr;
    const auto head = head_of(in.readLine(kLongestHead).toStdString());
    if (!head || head->key != key) return nullptr;
    const QByteArray rest = in.readAll();
    const std::span bytes(reinterpret_cast<const std::byte*>(rest.constData()),
                          static_cast<size_t>(rest.size()));
    if (bytes.size() != head->given_bytes + head->state_bytes ||
        check_of(bytes, head->hash) != head->check)
        return nullptr;
    auto start = std::make_shared<StageStart>();
    start->stage = stage;
    start->hash = head->hash;
    decode_chunk(bytes.first(head->given_bytes), head->given, start->given);
    const Bytes state = decompress(bytes.subspan(head->given_bytes), head->state);
    const auto* first = reinterpret_cast<const uint8_t*>(state.data());
    start->state.assign(first, first + state.size());
    return start;
}

}  // namespace

fs::path StageCache::folder_of_this_user() {
    return sim::user_path(sim::UserFolder::kCache, "placode/stages");
}

StageCache::StageCache(fs::path folder, uint64_t most_bytes)
    : folder_(std::move(folder)), most_bytes_(most_bytes) {}

fs::path StageCache::file_of(const std::string& task_json, uint64_t seed, int stage) const {
    return folder_ / (key_of(task_json, seed, stage) + kEnding);
}

std::shared_ptr<const StageStart> StageCache::find(const std::string& task_json, uint64_t seed,
                                                   int stage) const noexcept {
    if (folder_.empty()) return nullptr;
    try {
        const std::string key = key_of(task_json, seed, stage);
        return read(folder_ / (key + kEnding), key, stage);
    } catch (const std::exception&) {  // damaged, or no memory for it
        return nullptr;
    }
}

std::shared_ptr<const StageStart> StageCache::find(
    const sim::RecordingHeader& header) const noexcept {
    if (header.stage <= 0) return nullptr;
    return find(header.task_json, header.seed, header.stage);
}

bool StageCache::keep(const std::string& task_json, uint64_t seed,
                      const StageStart& start) const noexcept {
    if (folder_.empty()) return false;
    try {
        Head head;
        head.key = key_of(task_json, seed, start.stage);
        head.hash = start.hash;
        head.given = start.given.size();
        head.state = start.state.size();
        Bytes bytes = encode_chunk(start.given);
        head.given_bytes = bytes.size();
        const Bytes state = compress(std::as_bytes(std::span(start.state)));
        head.state_bytes = state.size();
        bytes.insert(bytes.end(), state.begin(), state.end());
        head.check = check_of(bytes, head.hash);
        const std::string line = text_of(head);
        if (line.size() + bytes.size() > std::min<uint64_t>(kMostFileBytes, most_bytes_))
            return false;
        const fs::path file = folder_ / (head.key + kEnding);
        fs::create_directories(folder_);
        fs::permissions(folder_, fs::perms::owner_all);
        make_room(line.size() + bytes.size(), file);
        WholeFile out(QString::fromStdString(file.string()));
        if (!out.open(QIODevice::WriteOnly)) return false;
        out.write(line.data(), static_cast<qint64>(line.size()));
        out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<qint64>(bytes.size()));
        return out.commit();
    } catch (const std::exception&) {
        return false;
    }
}

/// Files of other keys, of programs that are gone, too: the oldest until the new one has room.
void StageCache::make_room(uint64_t for_bytes, const fs::path& own) const {
    struct Kept {
        fs::file_time_type at;
        fs::path path;
        uint64_t bytes;
    };
    std::vector<Kept> kept;
    uint64_t sum = for_bytes;
    for (const auto& entry : fs::directory_iterator(folder_)) {
        std::error_code error;
        if (entry.path().extension() != kEnding || entry.path() == own ||
            !entry.is_regular_file(error))
            continue;
        const uint64_t bytes = entry.file_size(error);
        if (error) continue;  // somebody else has just removed it
        kept.push_back({entry.last_write_time(error), entry.path(), bytes});
        sum += bytes;
    }
    std::sort(kept.begin(), kept.end(), [](const Kept& a, const Kept& b) { return a.at < b.at; });
    for (const Kept& oldest : kept) {
        if (sum <= most_bytes_) return;
        std::error_code error;
        if (fs::remove(oldest.path, error)) sum -= oldest.bytes;
    }
}

}  // namespace placode::db
