// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings in the store, read back: a store that was a backup may come from anybody.

#include <optional>
#include <utility>

#include "db/attempts.h"
#include "db/packing.h"
#include "db/recording_chunks.h"
#include "db/store_context.h"
#include "db/whole_file.h"

namespace placode::db {
namespace {

using Kind = StoreError::Kind;

/// A recording in the store, still packed.
std::span<const std::byte> packed_bytes(const QByteArray& content) {
    return std::as_bytes(std::span(content.data(), content.size()));
}

/// What a row says about its recording has to be believable before a byte is unpacked: a backup may
/// come from anybody. A recording's chunks are packed already, so packing it again makes it 1 to 2
/// times smaller (tried on attempts of all levels); zeros get 30,000 times smaller.
bool is_believable(size_t packed, int64_t size) {
    constexpr size_t kMostTimesSmaller = 200, kSmall = size_t{1} << 20;
    return size >= 0 && static_cast<size_t>(size) <= kMostRecordingBytes &&
           static_cast<size_t>(size) <= kSmall + kMostTimesSmaller * packed;
}

/// What is wrong with a recording beyond being damaged; nullopt: it is sound.
std::optional<std::string> damage_of(int64_t size, const std::string& checksum,
                                     const QByteArray& content) {
    try {
        if (!is_believable(packed_bytes(content).size(), size))
            return " (it says that it has " + std::to_string(size) + " bytes, no recording has)";
        if (checksum_of_packed(packed_bytes(content), static_cast<size_t>(size)) == checksum)
            return std::nullopt;
    } catch (const StoreError&) {
        // Damaged, like a wrong checksum.
    }
    return "";
}

/// All recordings in pages of about 64 MiB as they are stored, by the first and last attempt: a
/// server answers a question for each page and not for each recording, and no page is long to wait
/// for. The sizes are those of the values: what a row says of its size may be made up.
std::vector<std::pair<int64_t, int64_t>> recording_pages(Connection& connection) {
    constexpr int64_t kPageBytes = int64_t{64} << 20;
    std::vector<std::pair<int64_t, int64_t>> pages;
    int64_t bytes = 0;
    Statement query(connection,
                    "SELECT attempt_id, LENGTH(content) AS bytes FROM recordings ORDER BY "
                    "attempt_id");
    query.run();
    while (query.next()) {
        const int64_t id = query.integer("attempt_id"), size = query.integer("bytes");
        if (pages.empty() || bytes + size > kPageBytes) {
            pages.emplace_back(id, id);
            bytes = 0;
        }
        pages.back().second = id;
        bytes += size;
    }
    return pages;
}

}  // namespace

void Attempts::extract_recording(int64_t attempt_id, const std::string& path) {
    connection_.begin_operation("extract the recording of attempt " + std::to_string(attempt_id) +
                                " from");
    context_.need_sight_of_attempt(attempt_id);
    Statement query(connection_,
                    "SELECT size_bytes, checksum, content FROM recordings WHERE attempt_id = ?");
    query.run(attempt_id);
    if (!query.next())
        connection_.fail(Kind::kNotFound, Said::that("the attempt has no recording"));
    const QByteArray content = query.bytes("content");
    const int64_t size = query.integer("size_bytes");
    Bytes file;
    try {
        if (is_believable(packed_bytes(content).size(), size))
            file = decompress(packed_bytes(content), static_cast<size_t>(size));
    } catch (const StoreError&) {
        file.clear();
    }
    if (checksum_hex(file) != query.text("checksum"))
        connection_.fail(Kind::kDamaged,
                         "the recording in the store is damaged; a backup may still have it");
    // Written beside and renamed: never half a file.
    WholeFile out(QString::fromStdString(path));
    if (!out.open(QIODevice::WriteOnly) ||
        out.write(reinterpret_cast<const char*>(file.data()), static_cast<qint64>(file.size())) !=
            static_cast<qint64>(file.size()) ||
        !out.commit())
        connection_.fail(Kind::kUnavailable, "cannot write " + path + " (" +
                                                 out.errorString().toStdString() +
                                                 "); choose another place");
}

void Attempts::check_recordings(std::vector<std::string>& problems, const CheckPace& pace) {
    context_.need(Action::kBackup);
    for (const auto& [first, last] : recording_pages(connection_)) {
        Statement query(connection_,
                        "SELECT attempt_id, size_bytes, checksum, content FROM recordings WHERE "
                        "attempt_id BETWEEN ? AND ? ORDER BY attempt_id");
        query.run(first, last);
        while (query.next()) {
            if (pace) pace(CheckProgress::Step::kRecordings);
            const std::optional<std::string> why = damage_of(
                query.integer("size_bytes"), query.text("checksum"), query.bytes("content"));
            if (why)
                problems.push_back("recordings: the recording of attempt " +
                                   std::to_string(query.integer("attempt_id")) + " is damaged" +
                                   *why);
        }
    }
}

}  // namespace placode::db
