// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Reading a recording file.

#include "db/recording_file.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>

#include "db/raw_sqlite.h"
#include "db/recording_chunks.h"
#include "db/said.h"

namespace placode::db {
namespace {

namespace fs = std::filesystem;
using Kind = StoreError::Kind;

const std::string kRead = "read the recording";

std::string seconds(double time_s) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%lld.%02lld s", static_cast<long long>(time_s),
                  static_cast<long long>(time_s * 100) % 100);
    return text.data();
}

class FileReader {
 public:
    explicit FileReader(const std::string& path) : path_(path) { open(); }

    RecordingSummary summary() {
        RecordingSummary result;
        result.header = read_header();
        try {
            result.end = brief_end(result.header);
        } catch (const StoreError&) {
            // Damaged just there: only the whole file says how long it was.
            result.end = read().recording.end;
        }
        return result;
    }

    RecoveredRecording read() {
        RecoveredRecording result;
        result.recording.header = read_header();
        check_sizes();
        result.damage = read_chunks(result.recording);
        if (result.damage.empty()) result.damage = given_damage(result.recording);
        if (result.damage.empty()) result.damage = read_end(result.recording);
        finish(result.recording);
        if (!result.damage.empty())
            result.damage += "; " + seconds(time_of(result.recording)) + " before it are whole (" +
                             std::to_string(result.recording.inputs.size()) + " inputs, " +
                             std::to_string(result.recording.samples.size()) + " samples)";
        return result;
    }

 private:
    [[noreturn]] void fail(Kind kind, const std::string& problem) const {
        throw StoreError(kind, kRead + " " + path_ + ": " + problem);
    }

    /// The end, or after a crash the time that was committed, without reading a chunk.
    sim::RecordingEnd brief_end(const sim::RecordingHeader& header) {
        if (const auto end = meta("end")) return end_from_json(*end);
        RawStatement frames(
            database_->get(),
            "SELECT COALESCE(MAX(first + count), 0) FROM chunks WHERE kind = 'inputs'");
        const int code = frames.prepared() == SQLITE_OK ? frames.step() : frames.prepared();
        if (code != SQLITE_ROW) fail_sqlite(code, kRead, path_, "the file may be damaged");
        sim::RecordingEnd end;
        end.reason = sim::EndReason::kInterrupted;
        end.duration_s = static_cast<double>(frames.integer(0)) * header.frame_s;
        if (!(end.duration_s >= 0 && end.duration_s < 86'400))
            fail(Kind::kDamaged, "it says that it lasts longer than a day");
        return end;
    }

    sim::RecordingHeader read_header() {
        const auto header = meta("header");
        if (!header)
            fail(Kind::kDamaged, "it has no header: the attempt never began; nothing can be saved");
        try {
            return header_from_json(*header);
        } catch (const StoreError& error) {
            fail(error.kind(), std::string("chunk 0: ") + error.what());
        }
    }

    void open() {
        if (fs::is_directory(path_)) fail(Kind::kNotFound, "this is a folder; give a file");
        if (!fs::is_regular_file(path_)) fail(Kind::kNotFound, "there is no such file");
        need_content();
        if (fs::file_size(path_) > kMostRecordingBytes)
            fail(Kind::kDamaged, "the file is larger than 1 GiB, no recording is");
        database_.emplace(path_);
        if (database_->code() != SQLITE_OK)
            fail_sqlite(database_->code(), kRead, path_, "check that it may be read by you");
        sqlite3_busy_timeout(database_->get(), 5000);
        const bool ours = pragma("application_id") == kRecordingApplicationId;
        need_content();  // A journal of the very first change was rolled back.
        if (!ours) fail(Kind::kDamaged, "it is the database of another program, not a recording");
        const int64_t format = pragma("user_version");
        if (format > sim::kRecordingFormat)
            fail(Kind::kTooNew, "its format is " + std::to_string(format) +
                                    ", this program knows " +
                                    std::to_string(sim::kRecordingFormat) + "; update Placode");
        if (const std::string problem = database_->schema_problem(); !problem.empty())
            fail(Kind::kDamaged, "its tables cannot be read (" + problem + ")");
        if (const std::string other = database_->other_schema({kMetaTable, kChunksTable});
            !other.empty())
            fail(Kind::kDamaged, "it is no recording: it holds " + other +
                                     ", and a recording holds two tables and nothing else");
    }

    void need_content() const {
        if (fs::file_size(path_) == 0)
            throw StoreError(
                Kind::kDamaged, kRead + " " + path_ + ": ",
                Said::that("the file is empty: the attempt never began; it can be removed"));
    }

    int64_t pragma(const std::string& name) {
        RawStatement query(database_->get(), ("PRAGMA " + name).c_str());
        const int code = query.prepared() == SQLITE_OK ? query.step() : query.prepared();
        if ((code & 0xff) == SQLITE_NOTADB) fail(Kind::kDamaged, "the file is not a recording");
        if (code != SQLITE_ROW) fail_sqlite(code, kRead, path_, "the file may be damaged");
        return query.integer(0);
    }

    // Throws when the page cannot be read; nullopt when there is no such row.
    std::optional<std::string> meta(const std::string& key) {
        RawStatement query(database_->get(), "SELECT value, checksum FROM meta WHERE key = ?");
        int code = query.prepared();
        // open() has seen that what tables there are have this column: there are none.
        if (code == SQLITE_ERROR) return std::nullopt;
        if (code == SQLITE_OK) code = query.bind(key).step();
        if (code == SQLITE_DONE) return std::nullopt;
        if (code != SQLITE_ROW)
            fail_sqlite(code, kRead, path_, "its \"" + key + "\" cannot be read");
        const std::string value = query.text(0);
        if (checksum_hex(key + value) != query.text(1))
            fail(Kind::kDamaged, "its \"" + key + "\" is damaged (checksum)");
        return value;
    }

    /// Before a byte is unpacked: a small file may say that it is a huge one.
    void check_sizes() {
        RawStatement query(database_->get(), "SELECT id, length(content) FROM chunks ORDER BY id");
        if (query.prepared() != SQLITE_OK) return;  // read_chunks() says what is wrong.
        size_t sum = 0;
        // Pages of a damaged file may lead to the same rows for hours: what comes out of its turn
        // is the end for read_chunks(), too.
        for (int64_t id = 1; query.step() == SQLITE_ROW && query.integer(0) == id; ++id) {
            const std::string name = "chunk " + std::to_string(id);
            if (id > kMostChunks) fail(Kind::kDamaged, name + ": no recording has so many");
            const size_t size = stated_size_of(id, query.integer(1));
            if (size > kMostChunkBytes || query.integer(1) > static_cast<int64_t>(kMostChunkBytes))
                fail(Kind::kDamaged, name + ": is larger than 64 MiB, no chunk is");
            sum += size;
            if (sum > kMostRecordingBytes)
                fail(Kind::kDamaged, name + ": with it the recording is larger than 1 GiB");
        }
    }

    /// From the first bytes of a chunk, without reading the others.
    [[nodiscard]] size_t stated_size_of(int64_t id, int64_t length) const {
        std::array<std::byte, 18> head{};  // The longest header of a zstd frame.
        sqlite3_blob* blob = nullptr;
        if (sqlite3_blob_open(database_->get(), "main", "chunks", "content", id, 0, &blob) !=
            SQLITE_OK) {
            sqlite3_blob_close(blob);
            return 0;
        }
        const auto size = std::min<int64_t>(length, static_cast<int64_t>(head.size()));
        const bool read =
            sqlite3_blob_read(blob, head.data(), static_cast<int>(size), 0) == SQLITE_OK;
        sqlite3_blob_close(blob);
        return read ? stated_size(std::span(head).first(static_cast<size_t>(size))) : 0;
    }

    // Empty, or what is damaged.
    std::string read_chunks(sim::Recording& recording) {
        RawStatement query(database_->get(),
                           "SELECT id, kind, first, count, checksum, content FROM chunks ORDER BY "
                           "id");
        if (query.prepared() != SQLITE_OK)
            return std::string("chunk 1: ") + sqlite3_errstr(query.prepared());
        for (int64_t expected = 1;; ++expected) {
            const int code = query.step();
            if (code == SQLITE_DONE) return {};
            const std::string name = "chunk " + std::to_string(expected);
            if (code != SQLITE_ROW) return name + ": " + sqlite3_errstr(code);
            if (query.integer(0) != expected) return name + ": is missing";
            const std::string problem = read_chunk(query, recording);
            if (!problem.empty()) return name + ": " + problem;
        }
    }

    static std::string read_chunk(const RawStatement& row, sim::Recording& recording) {
        const auto content = row.bytes(5);
        if (checksum_hex(content) != row.text(4)) return "is damaged (checksum)";
        const std::string kind = row.text(1);
        const auto into = [&](auto& records) -> std::string {
            const size_t before = records.size();
            const int64_t count = row.integer(3);
            if (row.integer(2) != static_cast<int64_t>(before) || count < 1 || count > 100'000'000)
                return "does not follow the one before it";
            try {
                decode_chunk(content, static_cast<size_t>(count), records);
            } catch (const StoreError& error) {
                records.resize(before);
                return error.what();
            }
            return {};
        };
        if (kind == "given") return into(recording.given);
        if (kind == "inputs") return into(recording.inputs);
        if (kind == "samples") return into(recording.samples);
        if (kind == "events") return into(recording.events);
        return "is of an unknown kind";
    }

    std::string read_end(sim::Recording& recording) {
        try {
            if (const auto end = meta("end")) recording.end = end_from_json(*end);
        } catch (const StoreError& error) {
            return std::string("the end: ") + error.what();
        }
        return {};
    }

    /// Without all of what was given nothing of the attempt can be simulated again.
    static std::string given_damage(const sim::Recording& recording) {
        const auto found = static_cast<int64_t>(recording.given.size());
        if (found == recording.header.given_frames) return {};
        return "what was given: " + std::to_string(found) + " inputs, the header says " +
               std::to_string(recording.header.given_frames);
    }

    static double time_of(const sim::Recording& recording) {
        double time_s = 0;
        if (!recording.samples.empty()) time_s = recording.samples.back().time_s;
        if (!recording.inputs.empty())
            time_s = std::max(time_s, static_cast<double>(recording.inputs.back().frame + 1) *
                                          recording.header.frame_s);
        return time_s;
    }

    // No end was written: a crash.
    static void finish(sim::Recording& recording) {
        if (recording.end.reason != sim::EndReason::kRunning) return;
        recording.end.reason = sim::EndReason::kInterrupted;
        recording.end.duration_s = time_of(recording);
    }

    std::string path_;
    std::optional<ForeignDatabase> database_;
};

}  // namespace

RecoveredRecording recover_recording_file(const std::string& path) {
    return FileReader(path).read();
}

RecordingSummary recording_summary(const std::string& path) { return FileReader(path).summary(); }

sim::Recording read_recording_file(const std::string& path) {
    RecoveredRecording result = recover_recording_file(path);
    if (!result.damage.empty())
        throw StoreError(Kind::kDamaged, kRead + " " + path + ": " + result.damage);
    return std::move(result.recording);
}

ForeignDatabase open_recording(const std::string& path, const std::string& operation) {
    ForeignDatabase database(path);
    if (database.code() != SQLITE_OK)
        fail_sqlite(database.code(), operation, path, "check that it is there");
    sqlite3_busy_timeout(database.get(), 5000);
    if (const std::string other = database.other_schema({kMetaTable, kChunksTable}); !other.empty())
        throw StoreError(StoreError::Kind::kDamaged,
                         operation + " " + path + ": it is no recording, it holds " + other);
    return database;
}

void settle_recording_file(const std::string& path) {
    try {
        (void)FileReader(path);
    } catch (const StoreError& error) {
        if (may_pass(error)) throw;
        // Not a recording that could be settled: its bytes are taken as they are.
    }
}

}  // namespace placode::db
