// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Writing a recording file, and finding out whether somebody still does.

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <tuple>

#include "db/raw_sqlite.h"
#include "db/recording_chunks.h"
#include "db/recording_file.h"
#include "db/recording_order.h"
#include "db/recording_seal.h"
#include "db/sqlite_file.h"

namespace placode::db {
namespace {

namespace fs = std::filesystem;

const std::string kWrite = "write the recording";
constexpr const char* kAdvice = "what was written before is safe; check disk and folder";

std::string first_word_of(const std::string& file) {
    std::ifstream in(file);
    std::string word;
    in >> word;
    return word;
}

// Field 22 of /proc/PID/stat: start in clock ticks after boot. With the id of the boot it tells a
// process from a later one that got the same number.
std::string start_of(int64_t pid) {
    std::ifstream in("/proc/" + std::to_string(pid) + "/stat");
    std::string text((std::istreambuf_iterator<char>(in)), {});
    const size_t after_name = text.rfind(')');
    if (after_name == std::string::npos) return {};
    // The name may hold blanks and brackets; field 3 follows its last bracket.
    std::istringstream rest(text.substr(after_name + 1));
    std::string word;
    for (int field = 3; field <= 22; ++field)
        if (!(rest >> word)) return {};
    return word;
}

std::string writer_name(int64_t pid) {
    return std::to_string(pid) + " " + start_of(pid) + " " +
           first_word_of("/proc/sys/kernel/random/boot_id");
}

class FileSink final : public sim::RecordingSink {
 public:
    FileSink(const std::string& path, const std::string& order) : path_(path) {
        const int file = ::open(path.c_str(), O_CREAT | O_EXCL | O_RDWR | O_CLOEXEC, 0600);
        if (file < 0)
            throw StoreError(
                errno == EEXIST ? StoreError::Kind::kConflict : StoreError::Kind::kUnavailable,
                "create the recording " + path + ": " + std::strerror(errno) +
                    (errno == EEXIST ? "; it is not overwritten, give another name"
                                     : "; choose another place"));
        ::close(file);
        try {
            open(order);
        } catch (...) {
            // What was never made keeps its name free.
            database_.reset();
            forget_sqlite_file(path);
            throw;
        }
    }

    /// An attempt that never began (its device was not there) leaves no file.
    ~FileSink() override {
        database_.reset();
        if (!began_) forget_sqlite_file(path_);
    }
    FileSink(const FileSink&) = delete;
    FileSink& operator=(const FileSink&) = delete;

    void begin(const sim::RecordingHeader& header) override {
        transact([&] { put_meta("header", header_to_json(header)); });
        began_ = true;
    }

    void give(std::span<const sim::Input> given) override {
        transact([&] {
            int64_t written = 0;
            for (size_t at = 0; at < given.size(); at += kGivenInChunk)
                put_chunk("given", given.subspan(at, std::min(kGivenInChunk, given.size() - at)),
                          written);
        });
    }

    void append(std::span<const sim::Input> inputs, std::span<const sim::Sample> samples,
                std::span<const sim::Event> events) override {
        if (inputs.empty() && samples.empty() && events.empty()) return;
        const auto before = std::array{inputs_, samples_, events_};
        try {
            transact([&] {
                put_chunk("inputs", inputs, inputs_);
                put_chunk("samples", samples, samples_);
                put_chunk("events", events, events_);
            });
        } catch (...) {
            std::tie(inputs_, samples_, events_) = std::tuple(before[0], before[1], before[2]);
            throw;
        }
    }

    void finish(const sim::RecordingEnd& end) override {
        transact([&] {
            put_meta("end", end_to_json(end));
            if (const int code = sign_recording(database_.get()); code != SQLITE_OK)
                fail_sqlite(code, kWrite, path_, kAdvice);
        });
    }

 private:
    void open(const std::string& order) {
        sqlite3* database = nullptr;
        const int code = sqlite3_open_v2(path_.c_str(), &database,
                                         SQLITE_OPEN_READWRITE | SQLITE_OPEN_FULLMUTEX, nullptr);
        database_.reset(database);
        if (code != SQLITE_OK) fail_sqlite(code, kWrite, path_, kAdvice);
        // Whoever reads the file of a running attempt locks it meanwhile: on a busy machine that
        // took more than 2 s once, and cost the rest of a recording. The rings hold what comes.
        sqlite3_busy_timeout(database, 15'000);
        // A rollback journal, not a write-ahead log: after every commit the one file is everything.
        // EXTRA also makes the removal of the journal survive a power cut.
        execute("PRAGMA journal_mode = DELETE");
        execute("PRAGMA synchronous = EXTRA");
        execute("PRAGMA application_id = " + std::to_string(kRecordingApplicationId));
        execute("PRAGMA user_version = " + std::to_string(sim::kRecordingFormat));
        execute("BEGIN IMMEDIATE");
        execute(kMetaTable);
        execute(kChunksTable);
        put_meta("writer", writer_name(::getpid()));
        if (!order.empty()) put_meta(kOrderKey, order);
        execute("COMMIT");
    }

    template <class Work>
    void transact(Work&& work) {
        execute("BEGIN IMMEDIATE");
        try {
            work();
            execute("COMMIT");
        } catch (...) {
            sqlite3_exec(database_.get(), "ROLLBACK", nullptr, nullptr, nullptr);
            throw;
        }
    }

    void execute(const std::string& sql) {
        const int code = sqlite3_exec(database_.get(), sql.c_str(), nullptr, nullptr, nullptr);
        if (code != SQLITE_OK)
            fail_sqlite(sqlite3_extended_errcode(database_.get()), kWrite, path_, kAdvice);
    }

    void put_meta(const std::string& key, const std::string& value) {
        RawStatement insert(database_.get(),
                            "INSERT INTO meta (key, value, checksum) VALUES (?, ?, ?)");
        const int code = insert.bind(key).bind(value).bind(checksum_hex(key + value)).step();
        if (code != SQLITE_DONE) fail_sqlite(code, kWrite, path_, kAdvice);
    }

    template <class Record>
    void put_chunk(const std::string& kind, std::span<const Record> records, int64_t& written) {
        if (records.empty()) return;
        const Bytes content = encode_chunk(records);
        RawStatement insert(
            database_.get(),
            "INSERT INTO chunks (kind, first, count, checksum, content) VALUES (?, ?, ?, ?, ?)");
        const int code = insert.bind(kind)
                             .bind(written)
                             .bind(static_cast<int64_t>(records.size()))
                             .bind(checksum_hex(content))
                             .bind(content)
                             .step();
        if (code != SQLITE_DONE) fail_sqlite(code, kWrite, path_, kAdvice);
        written += static_cast<int64_t>(records.size());
    }

    std::string path_;
    SqlitePointer database_;
    int64_t inputs_ = 0, samples_ = 0, events_ = 0;
    bool began_ = false;
};

bool has_living_writer(const std::string& path) {
    const ForeignDatabase database(path);
    if (database.code() != SQLITE_OK) return false;
    sqlite3_busy_timeout(database.get(), 2000);
    RawStatement query(
        database.get(),
        "SELECT value, EXISTS (SELECT 1 FROM meta WHERE key = 'end') FROM meta WHERE "
        "key = 'writer'");
    if (query.prepared() != SQLITE_OK)
        // Busy: somebody holds it right now. Anything else: nobody could be writing to this.
        return (query.prepared() & 0xff) == SQLITE_BUSY;
    const int step = query.step();
    if (step != SQLITE_ROW) return (step & 0xff) == SQLITE_BUSY;
    if (query.integer(1) != 0) return false;  // Finished.
    const std::string writer = query.text(0);
    const int64_t pid = std::atoll(writer.c_str());
    return pid > 0 && writer == writer_name(pid) && !start_of(pid).empty();
}

}  // namespace

std::unique_ptr<sim::RecordingSink> create_recording_file(const std::string& path,
                                                          const std::string& order) {
    return std::make_unique<FileSink>(path, order);
}

std::vector<std::string> leftover_recordings(const std::string& folder) {
    std::vector<std::string> found;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
        const std::string path = entry.path().string();
        if (!entry.is_regular_file(error) || entry.path().extension() != ".placode") continue;
        if (!has_living_writer(path)) found.push_back(path);
    }
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace placode::db
