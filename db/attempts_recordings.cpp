// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings in the store, read back: a store that was a backup may come from anybody.

#include <QSaveFile>

#include "db/attempts.h"
#include "db/packing.h"
#include "db/recording_chunks.h"
#include "db/store_context.h"

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
    QSaveFile out(QString::fromStdString(path));
    if (!out.open(QIODevice::WriteOnly) ||
        out.write(reinterpret_cast<const char*>(file.data()), static_cast<qint64>(file.size())) !=
            static_cast<qint64>(file.size()) ||
        !out.commit())
        connection_.fail(Kind::kUnavailable, "cannot write " + path + " (" +
                                                 out.errorString().toStdString() +
                                                 "); choose another place");
}

void Attempts::check_recordings(std::vector<std::string>& problems) {
    context_.need(Action::kBackup);
    std::vector<int64_t> ids;
    Statement list(connection_, "SELECT attempt_id FROM recordings ORDER BY attempt_id");
    list.run();
    while (list.next()) ids.push_back(list.integer(0));
    for (const int64_t id : ids) {
        Statement query(connection_,
                        "SELECT size_bytes, checksum, content FROM recordings WHERE attempt_id = "
                        "?");
        query.run(id);
        if (!query.next()) continue;
        const QByteArray content = query.bytes("content");
        const int64_t size = query.integer("size_bytes");
        std::string why;
        try {
            if (!is_believable(packed_bytes(content).size(), size))
                why = " (it says that it has " + std::to_string(size) + " bytes, no recording has)";
            else if (checksum_of_packed(packed_bytes(content), static_cast<size_t>(size)) ==
                     query.text("checksum"))
                continue;
        } catch (const StoreError&) {
            // Reported below, like a wrong checksum.
        }
        problems.push_back("recordings: the recording of attempt " + std::to_string(id) +
                           " is damaged" + why);
    }
}

}  // namespace placode::db
