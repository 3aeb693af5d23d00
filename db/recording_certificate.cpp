// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The haptic certificate in a recording file: one more line of its `meta`, with its checksum. The
// store keeps the file byte for byte, and so keeps the certificate with every attempt.

#include "db/packing.h"
#include "db/recording_chunks.h"
#include "db/recording_file.h"
#include "db/recording_seal.h"
#include "db/station.h"

namespace placode::db {
namespace {

constexpr const char* kCertificateKey = "haptics";
const std::string kWriteCertificate = "write the haptic certificate of the recording";
const std::string kReadCertificate = "read the haptic certificate of the recording";

SqlitePointer open_to_write(const std::string& path) {
    sqlite3* database = nullptr;
    const int code = sqlite3_open_v2(path.c_str(), &database, SQLITE_OPEN_READWRITE, nullptr);
    SqlitePointer owner(database);
    if (code != SQLITE_OK) fail_sqlite(code, kWriteCertificate, path, "check that it is there");
    sqlite3_busy_timeout(database, 5000);
    return owner;
}

}  // namespace

void add_haptic_certificate(const std::string& path, const std::string& json) {
    const SqlitePointer database = open_to_write(path);
    sqlite3_exec(database.get(), "PRAGMA synchronous = EXTRA", nullptr, nullptr, nullptr);
    const char* const advice = "a recording takes one certificate, at its end";
    int code = sqlite3_exec(database.get(), "BEGIN IMMEDIATE", nullptr, nullptr, nullptr);
    if (code != SQLITE_OK) fail_sqlite(code, kWriteCertificate, path, advice);
    // Only what this computer signed is signed again: nothing else becomes sound by an addition.
    Station station;
    const RecordingSeal seal = recording_seal(database.get());
    const bool ours =
        seal.signature == RecordingSignature::kRight && seal.station == station.public_key_if_any();
    {
        RawStatement insert(database.get(),
                            "INSERT INTO meta (key, value, checksum) VALUES (?, ?, ?)");
        code = insert.prepared();
        if (code == SQLITE_OK)
            code = insert.bind(kCertificateKey)
                       .bind(json)
                       .bind(checksum_hex(std::string(kCertificateKey) + json))
                       .step();
        if (code != SQLITE_DONE) fail_sqlite(code, kWriteCertificate, path, advice);
    }
    code = ours ? sign_recording(database.get()) : SQLITE_OK;
    if (code == SQLITE_OK) code = sqlite3_exec(database.get(), "COMMIT", nullptr, nullptr, nullptr);
    if (code != SQLITE_OK) fail_sqlite(code, kWriteCertificate, path, advice);
}

std::string haptic_certificate(const std::string& path) {
    const ForeignDatabase database = open_recording(path, kReadCertificate);
    RawStatement query(database.get(), "SELECT value, checksum FROM meta WHERE key = ?");
    int code = query.prepared();
    if (code == SQLITE_OK) code = query.bind(kCertificateKey).step();
    if (code == SQLITE_DONE) return {};
    if (code != SQLITE_ROW) fail_sqlite(code, kReadCertificate, path, "the file may be damaged");
    const std::string json = query.text(0);
    if (checksum_hex(std::string(kCertificateKey) + json) != query.text(1))
        throw StoreError(StoreError::Kind::kDamaged, kReadCertificate + " " + path + ": checksum");
    return json;
}

}  // namespace placode::db
