// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// For tests of the store: a folder that goes away, and a private PostgreSQL server on loopback.

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <pwd.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QCoreApplication>
#include <QSqlDatabase>
#include <QSqlError>
#include <QSqlQuery>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <thread>

#include "db/station_guard.h"
#include "db/station_role.h"
#include "db/store.h"
#include "tests/scratch_root.h"

namespace placode::test {

namespace fs = std::filesystem;

class TemporaryFolder {
 public:
    TemporaryFolder() {
        std::string name = (scratch_root() / "placode-store-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("mkdtemp");
        path_ = name;
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    [[nodiscard]] std::string file(const std::string& name) const {
        return (path_ / name).string();
    }
    [[nodiscard]] const fs::path& path() const { return path_; }

 private:
    fs::path path_;
};

/// Of the centre's key, in every test that signs with it.
inline constexpr const char* kPassphrase = "four words are good";

/// A connection of the test itself, past the store, for faults and for looking behind it.
class RawConnection {
 public:
    RawConnection(const QString& driver, const std::string& database, int port = 0,
                  const std::string& password = {}, const QString& user = "placode") {
        static std::atomic<int> counter{0};
        name_ = QStringLiteral("raw-%1").arg(++counter);
        connection_ = QSqlDatabase::addDatabase(driver, name_);
        connection_.setDatabaseName(QString::fromStdString(database));
        if (port != 0) {
            connection_.setHostName(QStringLiteral("127.0.0.1"));
            connection_.setPort(port);
            connection_.setUserName(user);
            connection_.setPassword(QString::fromStdString(password));
        }
        open_ = connection_.open();
    }
    ~RawConnection() {
        connection_.close();
        connection_ = QSqlDatabase();
        QSqlDatabase::removeDatabase(name_);
    }
    [[nodiscard]] bool is_open() const { return open_; }
    bool run(const std::string& sql) {
        ++edits();
        QSqlQuery query(connection_);
        const bool done = query.exec(QString::fromStdString(sql));
        if (!done) problem_ = query.lastError().text().toStdString();
        return done;
    }
    /// First value of the first row, "" when there is none.
    std::string value(const std::string& sql) {
        QSqlQuery query(connection_);
        if (!query.exec(QString::fromStdString(sql)) || !query.next()) return {};
        return query.value(0).toString().toStdString();
    }
    [[nodiscard]] const std::string& problem() const { return problem_; }
    [[nodiscard]] QSqlDatabase& handle() { return connection_; }
    /// How often any test of this program went past the store.
    static int& edits() {
        static int count = 0;
        return count;
    }

 private:
    QString name_;
    QSqlDatabase connection_;
    bool open_ = false;
    std::string problem_;
};

/// PostgreSQL 15 on 127.0.0.1 and a free port, scram with a made-up password, in a folder of its
/// own. It dies with the test, however the test ends. initdb takes longer than most tests: with
/// PLACODE_TEST_CLUSTER, a folder that need not be there, its result is kept for the next program.
class PostgresqlServer {
 public:
    PostgresqlServer() {
        if (!fs::exists(kPrograms + "initdb") || !fs::exists(kPrograms + "postgres")) {
            problem_ = "PostgreSQL 15 is not installed (" + kPrograms + "initdb)";
            return;
        }
        folder_ = std::make_unique<TemporaryFolder>();
        give_away(folder_->path());
        port_ = free_port();
        if (!take_kept_cluster() && !make_cluster()) return;
        std::vector<std::string> command{kPrograms + "postgres", "-D", folder_->file("data"), "-p",
                                         std::to_string(port_)};
        for (const std::string& setting : settings()) {
            command.emplace_back("-c");
            command.push_back(setting);
        }
        server_ = start(command);
        for (int i = 0; i < 600 && !ready(); ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
        if (!ready()) problem_ = "the server did not start: " + log();
    }
    ~PostgresqlServer() {
        if (server_ <= 0) return;
        ::kill(server_, SIGQUIT);  // At once: the data is thrown away.
        wait_for(server_);
    }
    PostgresqlServer(const PostgresqlServer&) = delete;
    PostgresqlServer& operator=(const PostgresqlServer&) = delete;

    /// Missing programs are a reason to skip, everything else to fail.
    [[nodiscard]] bool missing() const { return folder_ == nullptr; }
    [[nodiscard]] const std::string& problem() const { return problem_; }
    /// Copied file by file: through the log it takes five times as long.
    /// @param options behind CREATE DATABASE NAME; none: texts are sorted by their bytes.
    [[nodiscard]] std::string new_database(const std::string& options = "") {
        const std::string name = "store" + std::to_string(++databases_);
        RawConnection admin("QPSQL", "postgres", port_, password_);
        if (!admin.run("CREATE DATABASE " + name + " STRATEGY file_copy " + options))
            throw std::runtime_error(admin.problem());
        return name;
    }
    [[nodiscard]] std::string url(const std::string& database) const {
        return "postgresql://placode:" + password_ + "@127.0.0.1:" + std::to_string(port_) + "/" +
               database;
    }
    /// As the owner of the tables.
    [[nodiscard]] RawConnection connect(const std::string& database) const {
        return {"QPSQL", database, port_, password_};
    }
    /// As a program of the centre, which has what a station may do to rows, and whose word the
    /// server takes for whom it works (db/station_guard.h).
    [[nodiscard]] std::string service_url(const std::string& database) const {
        return "postgresql://jobs:" + password_ + "@127.0.0.1:" + std::to_string(port_) + "/" +
               database;
    }
    /// As a station: a log-in that was given what db/station_role.h says.
    [[nodiscard]] std::string station_url(const std::string& database) const {
        return "postgresql://theatre:" + password_ + "@127.0.0.1:" + std::to_string(port_) + "/" +
               database;
    }
    [[nodiscard]] RawConnection connect_station(const std::string& database) const {
        return {"QPSQL", database, port_, password_, "theatre"};
    }
    /// A database with the tables of the store and the roles of make_station(). All are copies of
    /// the first: making the tables takes longer than most tests.
    [[nodiscard]] std::string new_store(const db::StoreOptions& options) {
        if (model_.empty()) {
            const std::string made = new_database();
            (void)db::open_store(url(made), options);
            make_station(made);
            model_ = made;
        }
        std::string copy = new_database("TEMPLATE " + model_);
        // Rights on a database itself are not copied with it.
        RawConnection owner = connect(copy);
        for (const std::string& each : db::station_role_statements())
            if (each.find(" ON DATABASE ") != std::string::npos && !owner.run(each))
                throw std::runtime_error(owner.problem() + "\n" + each);
        return copy;
    }
    void make_station(const std::string& database) const {
        RawConnection owner = connect(database);
        std::vector<std::string> statements;
        // From the second database on there is the group, and whoever made the tables gave it its
        // rights.
        if (owner.value("SELECT COUNT(*) FROM pg_namespace WHERE nspname = 'placode_guard'") == "0")
            statements = db::station_role_statements();
        for (const auto& [login, group] :
             {std::pair("theatre", db::kStationRole), std::pair("jobs", db::kServiceRole)})
            statements.push_back(
                std::string("DO $$ BEGIN IF NOT EXISTS (SELECT FROM pg_roles WHERE "
                            "rolname = '") +
                login + "') THEN CREATE ROLE " + login + " LOGIN PASSWORD '" + password_ +
                "' IN ROLE " + group + "; END IF; END $$");
        for (const std::string& each : statements)
            if (!owner.run(each)) throw std::runtime_error(owner.problem() + "\n" + each);
    }
    [[nodiscard]] RawConnection connect_service(const std::string& database) const {
        return {"QPSQL", database, port_, password_, "jobs"};
    }
    [[nodiscard]] const std::string& password() const { return password_; }
    /// All that the server has said.
    [[nodiscard]] std::string log() const {
        std::ifstream in(folder_->file("log"));
        return {std::istreambuf_iterator<char>(in), {}};
    }

 private:
    inline static const std::string kPrograms = "/usr/lib/postgresql/15/bin/";

    /// It keeps nothing and copies itself nowhere, and tables are small: a tenth of its time went
    /// into what only a server of a centre needs.
    [[nodiscard]] std::vector<std::string> settings() const {
        return {"listen_addresses=127.0.0.1",
                "unix_socket_directories=" + folder_->path().string(),
                "fsync=off",
                "full_page_writes=off",
                "wal_level=minimal",
                "max_wal_senders=0",
                "autovacuum=off",
                "jit=off",
                "shared_preload_libraries=plpgsql"};
    }
    bool make_cluster() {
        std::random_device random;
        for (int i = 0; i < 24; ++i) password_ += static_cast<char>('a' + random() % 26);
        std::ofstream(folder_->file("password")) << password_;
        give_away(folder_->file("password"));
        const int made =
            wait_for(start({kPrograms + "initdb", "-D", folder_->file("data"), "-U", "placode",
                            "-A", "scram-sha-256", "-E", "UTF8", "--no-locale", "--no-sync",
                            "--pwfile=" + folder_->file("password")}));
        if (made != 0) problem_ = "initdb failed: " + log();
        if (made == 0) keep_cluster();
        return made == 0;
    }
    /// Whole or not at all: programs run side by side.
    void keep_cluster() const {
        const char* kept = std::getenv("PLACODE_TEST_CLUSTER");
        if (kept == nullptr) return;
        const std::string part = kept + std::string(".") + std::to_string(::getpid());
        std::error_code failed;
        fs::create_directory(part, failed);
        fs::permissions(part, fs::perms::owner_all, failed);
        for (const char* name : {"data", "password"})
            if (!failed)
                fs::copy(folder_->file(name), fs::path(part) / name, fs::copy_options::recursive,
                         failed);
        if (!failed) fs::rename(part, kept, failed);  // Fails where another program was first.
        fs::remove_all(part, failed);
    }
    bool take_kept_cluster() {
        const char* kept = std::getenv("PLACODE_TEST_CLUSTER");
        std::error_code failed;
        if (kept == nullptr || !fs::exists(kept, failed)) return false;
        if (fs::last_write_time(kept, failed) < fs::last_write_time(kPrograms + "initdb", failed)) {
            fs::remove_all(kept, failed);  // PostgreSQL was updated.
            return false;
        }
        const std::string data = folder_->file("data");
        fs::copy(fs::path(kept) / "data", data, fs::copy_options::recursive, failed);
        std::ifstream(fs::path(kept) / "password") >> password_;
        if (failed || password_.empty()) {
            fs::remove_all(data, failed);
            password_.clear();
            return false;
        }
        give_away(data);
        for (const auto& each : fs::recursive_directory_iterator(data)) give_away(each.path());
        return true;
    }
    /// Root may not run a server: it is run as `postgres` then.
    void give_away(const fs::path& path) const {
        if (::geteuid() != 0) return;
        const passwd* user = ::getpwnam("postgres");
        if (user == nullptr || ::chown(path.c_str(), user->pw_uid, user->pw_gid) != 0)
            throw std::runtime_error("chown to postgres");
    }
    pid_t start(const std::vector<std::string>& command) const {
        std::vector<char*> arguments;
        for (const auto& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
        arguments.push_back(nullptr);
        const passwd* user = ::geteuid() == 0 ? ::getpwnam("postgres") : nullptr;
        const std::string out = folder_->file("log");
        const pid_t child = ::fork();
        if (child != 0) return child;
        if (::freopen(out.c_str(), "a", stdout) == nullptr || ::dup2(1, 2) < 0) ::_exit(126);
        if (user != nullptr && (::setgid(user->pw_gid) != 0 || ::setuid(user->pw_uid) != 0))
            ::_exit(126);
        if (::chdir("/") != 0) ::_exit(126);
        ::prctl(PR_SET_PDEATHSIG, SIGQUIT);
        ::execv(arguments[0], arguments.data());
        ::_exit(127);
    }
    static int wait_for(pid_t child) {
        int status = 0;
        ::waitpid(child, &status, 0);
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    static int free_port() {
        const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof address;
        const bool bound = ::bind(socket, reinterpret_cast<sockaddr*>(&address), size) == 0 &&
                           ::getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size) == 0;
        ::close(socket);
        if (!bound) throw std::runtime_error("no free port on 127.0.0.1");
        return ntohs(address.sin_port);
    }
    [[nodiscard]] bool ready() const { return connect("postgres").is_open(); }

    std::unique_ptr<TemporaryFolder> folder_;
    std::string password_, problem_;
    std::string model_;  ///< The database that new_store() copies.
    int port_ = 0, databases_ = 0;
    pid_t server_ = -1;
};

/// Qt finds its database drivers through the application object; the server is started once.
class World : public testing::Environment {
 public:
    /// Before main(): `World* const world = World::install();`; several files share one.
    static World* install() {
        if (installed_ == nullptr) {
            installed_ = static_cast<World*>(testing::AddGlobalTestEnvironment(new World));
        }
        return installed_;
    }
    static World& get() { return *installed_; }
    /// Another kind of application, for tests that draw; to be set before main().
    inline static std::function<std::unique_ptr<QCoreApplication>(int& argc, char** argv)> make =
        [](int& argc, char** argv) { return std::make_unique<QCoreApplication>(argc, argv); };
    void SetUp() override { application_ = make(argc_, argv_); }
    void TearDown() override {
        server_.reset();
        application_.reset();
    }
    PostgresqlServer& server() {
        if (!server_) server_ = std::make_unique<PostgresqlServer>();
        return *server_;
    }

 private:
    inline static World* installed_ = nullptr;
    int argc_ = 1;
    char name_[6] = "store";
    char* argv_[2] = {name_, nullptr};
    std::unique_ptr<QCoreApplication> application_;
    std::unique_ptr<PostgresqlServer> server_;
};

/// For new_database(): one that sorts texts as people do, as most servers are set up.
inline constexpr const char* kSortedAsPeopleDo =
    "TEMPLATE template0 LOCALE_PROVIDER icu ICU_LOCALE 'en-US' LOCALE 'C'";

/// A test that runs on both engines, each time on an empty database:
/// `INSTANTIATE_TEST_SUITE_P(Engines, ..., testing::Values("Sqlite", "Postgresql"), engine_name)`.
class EngineTest : public testing::TestWithParam<const char*> {
 protected:
    void SetUp() override {
        options.cheap_passwords = true;
        edits_before_ = RawConnection::edits();
        // Never the key of whoever runs the tests.
        ::setenv("PLACODE_STATION_KEY", folder.file("station.key").c_str(), 1);
        if (!is_sqlite()) {
            PostgresqlServer& server = World::get().server();
            if (server.missing()) GTEST_SKIP() << server.problem();
            ASSERT_EQ(server.problem(), "");
            database = at_station() ? server.new_store(options) : server.new_database();
        }
        ready();
    }
    /// On a server all is done with what a station may do to rows; the owner has made the tables
    /// before. No person signs in to most tests, so their log-in is a service's.
    [[nodiscard]] virtual bool at_station() const { return !owner_; }
    /// From here on with the log-in that made the tables, as updates are.
    void become_owner() {
        owner_ = true;
        options.station = false;
    }
    /// Whatever a test did through the store, its trail and its seals fit what is in it.
    void TearDown() override {
        const bool there = is_sqlite() ? fs::exists(folder.file("placode.db")) : !database.empty();
        if (IsSkipped() || HasFailure() || !there || RawConnection::edits() != edits_before_)
            return;
        db::StoreOptions plain;
        plain.cheap_passwords = true;
        for (const std::string& problem : db::open_store(url(), plain)->check())
            EXPECT_EQ(problem.find("seals:") == 0 || problem.find("audit:") == 0, false) << problem;
    }
    /// The rest of SetUp, where the engine is there.
    virtual void ready() {}

    [[nodiscard]] bool is_sqlite() const { return std::string(GetParam()) == "Sqlite"; }
    [[nodiscard]] std::string url() const {
        if (is_sqlite()) return "sqlite:" + folder.file("placode.db");
        const PostgresqlServer& server = World::get().server();
        return at_station() ? server.service_url(database) : server.url(database);
    }
    /// Where people sit: the server believes nothing that is not proved.
    [[nodiscard]] std::unique_ptr<db::Store> open_at_station() const {
        if (is_sqlite()) return open();
        db::StoreOptions its = options;
        its.station = true;
        return db::open_store(World::get().server().station_url(database), its);
    }
    [[nodiscard]] std::unique_ptr<db::Store> open() const { return db::open_store(url(), options); }
    [[nodiscard]] RawConnection raw() const {
        if (is_sqlite()) return {"QSQLITE", folder.file("placode.db")};
        return World::get().server().connect(database);
    }

    TemporaryFolder folder;
    std::string database;
    db::StoreOptions options;

 private:
    int edits_before_ = 0;
    bool owner_ = false;
};

inline std::string engine_name(const testing::TestParamInfo<const char*>& info) {
    return info.param;
}

inline std::string read_text(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Runs `work` and returns the StoreError it throws; fails the test when it throws none.
template <class Work>
db::StoreError failure_of(Work&& work) {
    try {
        work();
    } catch (const db::StoreError& error) {
        return error;
    }
    ADD_FAILURE() << "no StoreError was thrown";
    return {db::StoreError::Kind::kOther, ""};
}

}  // namespace placode::test
