// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/recording_seal.h"

#include <sqlite3.h>

#include <optional>
#include <sstream>

#include "db/packing.h"
#include "db/recording_chunks.h"
#include "db/station.h"
#include "db/store_error.h"

namespace placode::db {
namespace {

constexpr const char* kStationKey = "station";
const std::string kReadSignature = "read the signature of the recording";

/// What is signed. The chunks' bytes are in it by their checksums, which every reader compares.
/// @return an SQLite result code; SQLITE_OK: `text` is all of it.
int signed_text_of(sqlite3* database, std::string& text) {
    std::string all;
    RawStatement meta(database, "SELECT key, value FROM meta WHERE key <> 'station' ORDER BY key");
    RawStatement chunks(database,
                        "SELECT kind, first, count, checksum, id FROM chunks ORDER BY id");
    if (meta.prepared() != SQLITE_OK) return meta.prepared();
    if (chunks.prepared() != SQLITE_OK) return chunks.prepared();
    // Pages of a damaged file may lead to the same rows for hours, and `all` would grow with them.
    int code = meta.step();
    for (std::optional<std::string> last; code == SQLITE_ROW; code = meta.step()) {
        if (last && meta.text(0) <= *last) return SQLITE_CORRUPT;
        last = meta.text(0);
        for (int i = 0; i < 2; ++i) add_text(all, meta.text(i));
    }
    all += '\n';
    if (code != SQLITE_DONE) return code;
    code = chunks.step();
    for (std::optional<int64_t> last; code == SQLITE_ROW; code = chunks.step()) {
        if (last && chunks.integer(4) <= *last) return SQLITE_CORRUPT;
        last = chunks.integer(4);
        add_text(all, chunks.text(0));
        for (int i = 1; i < 3; ++i) add_text(all, std::to_string(chunks.integer(i)));
        add_text(all, chunks.text(3));
    }
    if (code != SQLITE_DONE) return code;
    text = "placode recording 1\n" + checksum_hex(all);
    return SQLITE_OK;
}

/// Of a damaged file it can be said who signed it: nobody. Of one that the disk does not give now
/// nothing can be said.
void need_readable(sqlite3* database, int code) {
    switch (code & 0xff) {
        case SQLITE_OK:
        case SQLITE_ROW:
        case SQLITE_DONE:
        case SQLITE_ERROR:
        case SQLITE_CORRUPT:
        case SQLITE_NOTADB:
            return;
        default:
            fail_sqlite(code, kReadSignature, sqlite3_db_filename(database, "main"),
                        "try again, and check the disk");
    }
}

}  // namespace

int sign_recording(sqlite3* database) {
    Station station;
    if (station.public_key().empty()) return SQLITE_OK;
    std::string text;
    int code = signed_text_of(database, text);
    if (code != SQLITE_OK) return code;
    const std::string value = station.public_key() + " " + station.sign(text);
    code =
        sqlite3_exec(database, "DELETE FROM meta WHERE key = 'station'", nullptr, nullptr, nullptr);
    if (code != SQLITE_OK) return code;
    RawStatement insert(database, "INSERT INTO meta (key, value, checksum) VALUES (?, ?, ?)");
    if (insert.prepared() != SQLITE_OK) return insert.prepared();
    code = insert.bind(kStationKey).bind(value).bind(checksum_hex(kStationKey + value)).step();
    return code == SQLITE_DONE ? SQLITE_OK : code;
}

RecordingSeal recording_seal(sqlite3* database) {
    RawStatement query(database, "SELECT value FROM meta WHERE key = 'station'");
    int code = query.prepared() == SQLITE_OK ? query.step() : query.prepared();
    need_readable(database, code);
    if (code != SQLITE_ROW) return {};
    std::istringstream words(query.text(0));
    RecordingSeal seal{RecordingSignature::kWrong, {}};
    std::string signature;
    words >> seal.station >> signature;
    std::string text;
    code = signed_text_of(database, text);
    need_readable(database, code);
    if (code == SQLITE_OK && signature_is_right(text, signature, seal.station))
        seal.signature = RecordingSignature::kRight;
    return seal;
}

RecordingSeal recording_seal(const std::string& path) {
    const ForeignDatabase database = open_recording(path, kReadSignature);
    return recording_seal(database.get());
}

}  // namespace placode::db
