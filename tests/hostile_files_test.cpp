// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings and backups that somebody made to do harm: views that never end, triggers, bytes that
// unpack to thousands of times their size, expressions nested too deep. Each is refused with its
// reason within 5 s and 512 MB, and the store that was there stays as it was.

#include <gmock/gmock.h>
#include <sqlite3.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

#include "db/packing.h"
#include "db/raw_sqlite.h"
#include "db/recording_seal.h"
#include "tests/store_cases.h"

using namespace placode;
using namespace placode::test;
using testing::HasSubstr;
using testing::IsEmpty;

namespace THIS_TEST {

constexpr rlim_t kMostMemory = rlim_t{512} << 20;
constexpr unsigned kMostSeconds = 5;

rlim_t present_size() {
    rlim_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE));
}

/// What the work throws in a child process that may take 512 MB more and 5 s; "" = it throws
/// nothing; "killed by ..." where it does not come to an end.
template <class Work>
std::string refusal_of(const Work& work) {
    std::array<int, 2> channel{};
    if (::pipe(channel.data()) != 0) return "no pipe";
    const pid_t child = ::fork();
    if (child == 0) {
        const rlim_t most = present_size() + kMostMemory;
        const rlimit limit{most, most};
        ::setrlimit(RLIMIT_AS, &limit);
        ::alarm(kMostSeconds);
        std::string said;
        try {
            work();
        } catch (const db::StoreError& error) {
            said = error.what();
        } catch (const std::exception& error) {
            said = std::string("not refused, but failed: ") + error.what();
        }
        ::_exit(::write(channel[1], said.data(), said.size()) < 0 ? 1 : 0);
    }
    ::close(channel[1]);
    std::string said;
    std::array<char, 4096> part{};
    for (ssize_t got = 0; (got = ::read(channel[0], part.data(), part.size())) > 0;)
        said.append(part.data(), static_cast<size_t>(got));
    ::close(channel[0]);
    int status = 0;
    ::waitpid(child, &status, 0);
    if (WIFSIGNALED(status)) return "killed by signal " + std::to_string(WTERMSIG(status));
    return said;
}

/// A zstd frame of zeros, as RLE blocks of 128 KiB: 4 bytes each.
/// https://datatracker.ietf.org/doc/html/rfc8878#section-3.1.1
std::string zeros_in_zstd(uint64_t stated, int blocks) {
    std::string frame("\x28\xb5\x2f\xfd\xc0\x38", 6);  // size in 8 bytes, window of 128 KiB
    for (int i = 0; i < 8; ++i) frame += static_cast<char>(stated >> (8 * i));
    for (int i = 1; i <= blocks; ++i) {
        constexpr uint32_t kBlock = 128 << 10, kRle = 1 << 1;
        const uint32_t header = (kBlock << 3) | kRle | (i == blocks ? 1 : 0);
        for (int byte = 0; byte < 3; ++byte) frame += static_cast<char>(header >> (8 * byte));
        frame += '\0';
    }
    return frame;
}

const std::string kEndless =
    " AS WITH RECURSIVE n(x) AS (SELECT 1 UNION ALL SELECT x + 1 FROM n) SELECT ";
constexpr uint64_t kFourGiB = uint64_t{4} << 30, kHuge = uint64_t{1} << 40;

std::string deep_view(int depth) {
    std::string sql = "CREATE VIEW deep AS SELECT 1";
    for (int i = 0; i < depth; ++i) sql += "+1";
    return sql;
}

/// Written past SQLite's own limits.
std::string long_view() {
    return "PRAGMA writable_schema = ON; INSERT INTO sqlite_schema VALUES ('view', 'long', 'long', "
           "0, 'CREATE VIEW long AS SELECT ''" +
           std::string(1'000'000, 'x') + "'''); PRAGMA writable_schema = OFF";
}

/// Past every guard of SQLite, as whoever makes such a file would.
void edit(const std::string& path, const std::string& sql, const std::string& bytes = {}) {
    sqlite3* database = nullptr;
    ASSERT_EQ(sqlite3_open(path.c_str(), &database), SQLITE_OK);
    for (const char* name : {"audit_is_never_changed", "audit_is_never_deleted"})
        sqlite3_exec(database, (std::string("DROP TRIGGER IF EXISTS ") + name).c_str(), nullptr,
                     nullptr, nullptr);
    const char* rest = sql.c_str();
    while (*rest != '\0') {
        sqlite3_stmt* statement = nullptr;
        ASSERT_EQ(sqlite3_prepare_v2(database, rest, -1, &statement, &rest), SQLITE_OK)
            << sqlite3_errmsg(database);
        if (sqlite3_bind_parameter_count(statement) > 0)
            sqlite3_bind_blob(statement, 1, bytes.data(), static_cast<int>(bytes.size()), nullptr);
        const int code = sqlite3_step(statement);
        ASSERT_TRUE(code == SQLITE_DONE || code == SQLITE_ROW) << sqlite3_errmsg(database);
        sqlite3_finalize(statement);
        while (*rest == ' ') ++rest;
    }
    sqlite3_close(database);
}

struct Attack {
    const char* name;
    std::string sql, bytes;  ///< `?` = the bytes.
    const char* reason;
};

std::string attack_name(const testing::TestParamInfo<Attack>& info) { return info.param.name; }

// --- recordings ----------------------------------------------------------------------------------

std::string chunk_of(const std::string& bytes) {
    const auto span = std::as_bytes(std::span(bytes.data(), bytes.size()));
    return "UPDATE chunks SET content = ?, checksum = '" + db::checksum_hex(span) +
           "' WHERE id = 1";
}

std::vector<Attack> attacks_by_recording() {
    const std::string bomb = zeros_in_zstd(kFourGiB, 32768), huge = zeros_in_zstd(kHuge, 1);
    const std::string quiet_bomb = zeros_in_zstd(156'000, 32768);
    EXPECT_NEAR(static_cast<double>(bomb.size()), 131'000, 200);
    return {
        {"MetaThatNeverEnds",
         "DROP TABLE meta; CREATE VIEW meta" + kEndless +
             "'header' AS key, x AS value, x AS checksum FROM n",
         "", "the view \"meta\""},
        {"ChunksThatNeverEnd",
         "DROP TABLE chunks; CREATE VIEW chunks" + kEndless +
             "x AS id, 'inputs' AS kind, 0 AS first, 1 AS count, '' AS checksum, x'00' AS content "
             "FROM n",
         "", "the view \"chunks\""},
        {"Trigger", "CREATE TRIGGER t AFTER INSERT ON meta BEGIN UPDATE meta SET value = ''; END",
         "", "the trigger \"t\""},
        {"DeepExpression", deep_view(900), "", "maximum depth"},
        {"LongText", long_view(), "", "too big"},
        {"Bomb", chunk_of(bomb), bomb, "larger than 64 MiB"},
        {"BombThatSaysLess", chunk_of(quiet_bomb), quiet_bomb, "compressed bytes are damaged"},
        {"ChunkThatSaysTooMuch", chunk_of(huge), huge, "larger than 64 MiB"},
    };
}

class HostileRecording : public testing::TestWithParam<Attack> {};

TEST_P(HostileRecording, IsRefusedWithItsReason) {
    const TemporaryFolder folder;
    const std::string path = folder.file("a.placode");
    write_recording(path, 1);
    edit(path, GetParam().sql, GetParam().bytes);
    EXPECT_THAT(refusal_of([&] { (void)db::read_recording_file(path); }),
                HasSubstr(GetParam().reason));
    // Of the end only, where the header is whole.
    EXPECT_THAT(refusal_of([&] { (void)db::recording_summary(path); }),
                testing::Not(testing::AnyOf(HasSubstr("killed"), HasSubstr("not refused"))));
}

INSTANTIATE_TEST_SUITE_P(Files, HostileRecording, testing::ValuesIn(attacks_by_recording()),
                         attack_name);

/// Puts three levels of pages above the only one of a table or index, each of which leads hundreds
/// of times to the next: millions of times the same rows, from 16 kB.
/// https://www.sqlite.org/fileformat2.html#b_tree_pages
class RepeatedRows {
 public:
    explicit RepeatedRows(const std::string& path) : path_(path), bytes_(read_text(path)) {}

    void of(const std::string& name) {
        const size_t at = kPage * (root_of(name) - 1);
        const std::string leaf = bytes_.substr(at, kPage);
        // Of the first row, behind where it leads: number or key.
        const size_t first = number(leaf, 8, 2);
        const bool table = leaf[0] == 13;
        entry_ = table ? std::string(1, '\0') : leaf.substr(first, 1 + number(leaf, first, 1));
        kind_ = table ? 5 : 2;
        bytes_ += leaf;
        for (int level = 0; level < 2; ++level) bytes_ += leading_to(pages());
        bytes_.replace(at, kPage, leading_to(pages()));
        put(bytes_, 28, pages(), 4);
        std::ofstream(path_, std::ios::binary) << bytes_;
    }

 private:
    static constexpr size_t kPage = 4096, kHeader = 12;

    [[nodiscard]] size_t pages() const { return bytes_.size() / kPage; }
    [[nodiscard]] size_t root_of(const std::string& name) const {
        sqlite3* database = nullptr;
        EXPECT_EQ(sqlite3_open(path_.c_str(), &database), SQLITE_OK);
        int64_t root = 1;
        {
            db::RawStatement query(database, "SELECT rootpage FROM sqlite_schema WHERE name = ?");
            EXPECT_EQ(query.bind(name).step(), SQLITE_ROW);
            root = query.integer(0);
        }
        sqlite3_close(database);
        return static_cast<size_t>(root);
    }
    static size_t number(const std::string& bytes, size_t at, int size) {
        size_t value = 0;
        for (int i = 0; i < size; ++i)
            value = value << 8 | static_cast<uint8_t>(bytes[at + static_cast<size_t>(i)]);
        return value;
    }
    static void put(std::string& bytes, size_t at, size_t value, int size) {
        for (int i = size - 1; i >= 0; --i, value >>= 8)
            bytes[at + static_cast<size_t>(i)] = static_cast<char>(value & 0xff);
    }
    [[nodiscard]] std::string leading_to(size_t child) const {
        std::string page(kPage, '\0');
        const size_t length = 4 + entry_.size(), cells = (kPage - kHeader) / (2 + length);
        page[0] = kind_;
        put(page, 3, cells, 2);
        put(page, 5, kPage - cells * length, 2);
        put(page, 8, child, 4);
        for (size_t cell = 0; cell < cells; ++cell) {
            const size_t at = kPage - (cell + 1) * length;
            put(page, kHeader + 2 * cell, at, 2);
            put(page, at, child, 4);
            page.replace(at + 4, entry_.size(), entry_);
        }
        return page;
    }

    std::string path_, bytes_, entry_;
    char kind_ = 0;
};

TEST(HostileRows, ThatComeAgainMillionsOfTimesAreReadOnce) {
    const TemporaryFolder folder;
    ::setenv("PLACODE_STATION_KEY", folder.file("station.key").c_str(), 1);
    for (const char* repeated : {"chunks", "sqlite_autoindex_meta_1"}) {
        SCOPED_TRACE(repeated);
        const std::string path = folder.file(std::string(repeated) + ".placode");
        write_recording(path, 1);
        ASSERT_EQ(db::recording_seal(path).signature, db::RecordingSignature::kRight);
        RepeatedRows(path).of(repeated);
        const auto has_wrong_seal = [&] {
            if (db::recording_seal(path).signature != db::RecordingSignature::kWrong)
                throw std::runtime_error("its signature is not wrong");
        };
        EXPECT_EQ(refusal_of(has_wrong_seal), "");
        const std::string read = refusal_of([&] { (void)db::read_recording_file(path); });
        const std::string summary = refusal_of([&] { (void)db::recording_summary(path); });
        for (const std::string& said : {read, summary})
            EXPECT_THAT(
                said, testing::Not(testing::AnyOf(HasSubstr("killed"), HasSubstr("not refused"))));
        if (repeated == std::string("chunks")) {
            EXPECT_THAT(read, HasSubstr("chunk 2: is missing"));
        }
    }
}

// --- backups -------------------------------------------------------------------------------------

std::string recording_of(uint64_t size) {
    return "UPDATE recordings SET content = ?, size_bytes = " + std::to_string(size);
}

std::vector<Attack> attacks_by_backup() {
    return {
        {"TriggerThatMakesAdministrators",
         "CREATE TRIGGER t AFTER INSERT ON audit BEGIN UPDATE accounts SET roles = 15; END", "",
         "the trigger \"t\" of the table \"audit\""},
        {"ViewThatNeverEnds", "CREATE VIEW endless" + kEndless + "x FROM n", "",
         "the view \"endless\""},
        {"TableThatNeverEnds",
         "DROP TABLE audit; CREATE VIEW audit" + kEndless +
             "x AS id, '' AS at_utc, '' AS actor, '' AS action, '' AS object, '' AS detail, '' AS "
             "chain, '' AS seals, '' AS station, '' AS signature FROM n",
         "", "the view \"audit\""},
        {"RegisterThatNeverEnds",
         "DROP TABLE schema_migrations; CREATE VIEW schema_migrations" + kEndless +
             "x AS name, '' AS checksum, '' AS applied_utc FROM n",
         "", "the view \"schema_migrations\""},
        {"VirtualTable", "CREATE VIRTUAL TABLE words USING fts5(word)", "", "the table \"words\""},
        {"ColumnThatIsWorkedOut",
         "ALTER TABLE accounts ADD COLUMN bomb TEXT AS (hex(zeroblob(400000000)))", "",
         "the table \"accounts\""},
        {"IndexThatWorks", "CREATE INDEX slow ON audit (length(hex(zeroblob(id + 1000))))", "",
         "the index \"slow\" of the table \"audit\""},
        {"DeepExpression", deep_view(900), "", "maximum depth"},
        {"LongText", long_view(), "", "too big"},
        // Told by the seal of its attempt, and the recordings are looked at all the same.
        {"Bomb", recording_of(kFourGiB), zeros_in_zstd(kFourGiB, 32768), "attempt 1 was changed"},
        {"BombThatSaysLess", "UPDATE recordings SET content = ?", zeros_in_zstd(1000, 32768),
         "the recording of attempt 1 is damaged"},
        {"RecordingThatSaysTooMuch", recording_of(kHuge), zeros_in_zstd(kHuge, 1),
         "attempt 1 was changed"},
    };
}

/// A store with an attempt, and its backup.
class HostileStore : public testing::Test {
 protected:
    void SetUp() override {
        ASSERT_NE(world, nullptr);
        ::setenv("PLACODE_STATION_KEY", folder.file("station.key").c_str(), 1);
        options.cheap_passwords = true;
        const auto store = db::open_store(url, options);
        const int64_t anna = store->accounts().create(trainee("anna"));
        write_recording(folder.file("one.placode"));
        db::AttemptResult result = make_result();
        result.recording_file = folder.file("one.placode");
        (void)store->attempts().save(anna, result);
        store->backup(backup);
    }

    TemporaryFolder folder;
    const std::string path = folder.file("placode.db"), url = "sqlite:" + path,
                      backup = folder.file("backup.db");
    db::StoreOptions options;
};

class HostileBackup : public HostileStore, public testing::WithParamInterface<Attack> {};

TEST_P(HostileBackup, IsNotRestored) {
    edit(backup, GetParam().sql, GetParam().bytes);
    const std::string before = read_text(path), backup_before = read_text(backup);
    EXPECT_THAT(refusal_of([&] { (void)db::restore_store(url, backup, "bert"); }),
                HasSubstr(GetParam().reason));
    EXPECT_EQ(read_text(path), before) << "the store was touched";
    EXPECT_EQ(read_text(backup), backup_before) << "the backup was touched";
    for (const auto& entry : fs::directory_iterator(folder.path()))
        EXPECT_THAT(entry.path().string(), testing::Not(HasSubstr(".restoring")));
    const auto store = db::open_store(url, options);
    EXPECT_THAT(store->check(), IsEmpty());
    EXPECT_EQ(store->accounts().list().at(0).roles, trainee("anna").roles);
}

struct RecordingInStore {
    std::string sql, bytes, reason;
};

TEST_F(HostileStore, RecordingsThatUnpackToGigabytesAreNeverUnpacked) {
    const std::string full = zeros_in_zstd(uint64_t{1} << 30, 8192);
    for (const auto& [sql, bytes, reason] : std::vector<RecordingInStore>{
             {recording_of(kFourGiB), zeros_in_zstd(kFourGiB, 32768), " 4294967296 bytes, no"},
             {recording_of(kHuge), zeros_in_zstd(kHuge, 1), " 1099511627776 bytes, no"},
             {recording_of(uint64_t{1} << 30), full, " 1073741824 bytes, no"},
             {"UPDATE recordings SET content = ?, size_bytes = -1", "", " -1 bytes, no"}}) {
        SCOPED_TRACE(reason);
        edit(path, sql, bytes);
        EXPECT_THAT(refusal_of([&] {
                        std::string all;
                        for (const auto& each : db::open_store(url, options)->check()) all += each;
                        throw db::StoreError(db::StoreError::Kind::kDamaged, all);
                    }),
                    HasSubstr("attempt 1 is damaged (it says that it has" + reason));
        EXPECT_THAT(refusal_of([&] {
                        db::open_store(url, options)
                            ->attempts()
                            .extract_recording(1, folder.file("out.placode"));
                    }),
                    HasSubstr("the recording in the store is damaged"));
    }
}

INSTANTIATE_TEST_SUITE_P(Files, HostileBackup, testing::ValuesIn(attacks_by_backup()), attack_name);

}  // namespace THIS_TEST
