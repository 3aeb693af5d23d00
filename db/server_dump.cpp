// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/server_dump.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QStandardPaths>
#include <filesystem>
#include <map>
#include <string_view>

#include "db/durable_file.h"
#include "db/sqlite_file.h"
#include "db/station_role.h"
#include "db/store_context.h"
#include "db/store_place.h"
#include "db/store_tables.h"

namespace placode::db {
namespace {

using Kind = StoreError::Kind;
using RowCounts = std::map<std::string, int64_t>;

/// Where the path has none, Debian's newest beside the server.
QString program(Connection& connection, const char* name) {
    if (QString found = QStandardPaths::findExecutable(name); !found.isEmpty()) return found;
    const QDir versions(QStringLiteral("/usr/lib/postgresql"));
    QString best;
    int newest = 0;
    for (const QString& each : versions.entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
        const QString there = versions.filePath(each) + "/bin/" + name;
        if (each.toInt() > newest && QFile::exists(there)) newest = each.toInt(), best = there;
    }
    if (best.isEmpty())
        connection.fail(Kind::kUnavailable,
                        Said::that("%1 is not installed on this computer; install the package "
                                   "postgresql-client")
                            .with(std::string(name)));
    return best;
}

/// Where the server is, and its password: in the environment, because ps shows arguments.
QProcessEnvironment environment_of(const StoreUrl& url) {
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    const auto set = [&](const char* name, const std::string& value) {
        if (!value.empty()) environment.insert(name, QString::fromStdString(value));
    };
    set("PGHOST", url.host);
    set("PGPORT", std::to_string(url.port));
    set("PGUSER", url.user);
    set("PGPASSWORD", url.password);
    set("PGDATABASE", url.name);
    set("PGSSLMODE", url.sslmode);
    set("PGSSLROOTCERT", url.sslrootcert);
    environment.insert("LC_ALL", "C");
    return environment;
}

std::string last_line(const QByteArray& said) {
    const QList<QByteArray> lines = said.trimmed().split('\n');
    return lines.back().trimmed().toStdString();
}

/// Counts the rows of every table in the SQL that pg_restore writes: between "COPY public.NAME ("
/// and a line "\." each line is a row. Only the beginning of a line is kept: a recording is one
/// line.
class RowCounter {
 public:
    void take(const QByteArray& bytes) {
        for (const char byte : bytes) {
            if (byte != '\n') {
                if (line_.size() < kHead) line_ += byte;
                continue;
            }
            endLine();
            line_.clear();
        }
    }
    [[nodiscard]] const RowCounts& counts() const { return counts_; }

 private:
    static constexpr size_t kHead = 200;

    void endLine() {
        constexpr std::string_view kCopy = "COPY public.";
        if (!table_.empty()) {
            if (line_ == "\\.")
                table_.clear();
            else
                ++counts_[table_];
        } else if (line_.starts_with(kCopy)) {
            table_ = line_.substr(kCopy.size(), line_.find(' ', kCopy.size()) - kCopy.size());
            counts_[table_] = 0;
        }
    }

    RowCounts counts_;
    std::string line_, table_;
};

void run_dump(Connection& connection, const std::string& snapshot, const std::string& part) {
    QFile file(QString::fromStdString(part));
    if (!file.open(QIODevice::WriteOnly | QIODevice::Truncate) ||
        !file.setPermissions(QFile::ReadOwner | QFile::WriteOwner))
        connection.fail(Kind::kUnavailable, "cannot write " + part + " (" +
                                                file.errorString().toStdString() +
                                                "); the store is unchanged, give another place");
    file.close();
    QProcess dump;
    dump.setProcessEnvironment(environment_of(connection.url()));
    dump.start(program(connection, "pg_dump"),
               {"--format=custom", "--enable-row-security", "--no-password",
                "--exclude-table-data=placode_guard.sessions",
                "--exclude-table-data=placode_guard.channels",
                "--exclude-table-data=placode_guard.confirmations",
                "--snapshot=" + QString::fromStdString(snapshot),
                "--file=" + QString::fromStdString(part)});
    if (!dump.waitForStarted() || !dump.waitForFinished(-1) ||
        dump.exitStatus() != QProcess::NormalExit || dump.exitCode() != 0)
        connection.fail(Kind::kUnavailable, "pg_dump failed (" +
                                                last_line(dump.readAllStandardError()) +
                                                "); the store is unchanged");
}

RowCounts rows_in_dump(Connection& connection, const std::string& part) {
    QProcess list;
    list.start(program(connection, "pg_restore"),
               {"--data-only", "--file=-", QString::fromStdString(part)});
    RowCounter counter;
    if (!list.waitForStarted()) connection.fail(Kind::kUnavailable, "pg_restore cannot be started");
    while (list.waitForReadyRead(-1)) counter.take(list.readAllStandardOutput());
    list.waitForFinished(-1);
    counter.take(list.readAllStandardOutput());
    if (list.exitStatus() != QProcess::NormalExit || list.exitCode() != 0)
        connection.fail(Kind::kDamaged, "the dump cannot be read again (" +
                                            last_line(list.readAllStandardError()) + ")");
    return counter.counts();
}

/// What there was when the dump was made; its transaction keeps that moment for pg_dump.
class Moment {
 public:
    explicit Moment(Connection& connection) : connection_(connection) {
        connection_.execute("BEGIN ISOLATION LEVEL REPEATABLE READ READ ONLY");
    }
    ~Moment() { QSqlQuery(connection_.handle()).exec(QStringLiteral("ROLLBACK")); }
    Moment(const Moment&) = delete;
    Moment& operator=(const Moment&) = delete;

    [[nodiscard]] std::string snapshot() {
        Statement query(connection_, "SELECT pg_export_snapshot()");
        return query.run().next() ? query.text(0) : std::string();
    }
    [[nodiscard]] RowCounts rows() {
        RowCounts counts;
        for (const std::string& name : names_of_tables(connection_)) {
            Statement query(connection_, "SELECT COUNT(*) FROM public." + name);
            if (query.run().next()) counts[name] = query.integer(0);
        }
        return counts;
    }
    [[nodiscard]] TrailHead head() {
        TrailHead head;
        head.store = first_chain(connection_);
        const Station::Head last = end_of_trail(connection_);
        head.entry = last.entry;
        head.chain = last.chain;
        return head;
    }

 private:
    Connection& connection_;
};

std::string difference(const RowCounts& there, const RowCounts& dumped) {
    for (const auto& [table, rows] : there) {
        const auto found = dumped.find(table);
        const int64_t got = found == dumped.end() ? -1 : found->second;
        if (got != rows)
            return "the dump holds " + std::to_string(std::max<int64_t>(got, 0)) + " of " +
                   std::to_string(rows) + " rows of " + table;
    }
    return {};
}

}  // namespace

std::string owner_of_tables(StoreContext& context) {
    Statement query(context.connection,
                    "SELECT tableowner FROM pg_tables WHERE schemaname = 'public' AND tablename = "
                    "'accounts'");
    return query.run().next() ? query.text(0) : std::string();
}

void need_owner_of_tables(StoreContext& context) {
    Connection& connection = context.connection;
    if (!owns_tables(connection))
        connection.fail(Kind::kRefused,
                        Said::that("a backup of a server needs the log-in of the tables' owner, "
                                   "%1; a station sees only what people may see")
                            .with(owner_of_tables(context)));
}

TrailHead dump_store(StoreContext& context, const std::string& path) {
    Connection& connection = context.connection;
    need_owner_of_tables(context);
    const std::string part = path + kPartSuffix, failed = path + kFailedSuffix;
    try {
        Moment moment(connection);
        TrailHead head = moment.head();
        const RowCounts rows = moment.rows();
        run_dump(connection, moment.snapshot(), part);
        if (const std::string problem = difference(rows, rows_in_dump(connection, part));
            !problem.empty()) {
            std::filesystem::rename(part, failed);
            connection.fail(Kind::kDamaged, "the copy does not pass its check (" + problem +
                                                ") and is kept as " + failed);
        }
        sync_file(part);
        std::filesystem::rename(part, path);
        sync_folder_of(path);
        return head;
    } catch (const std::filesystem::filesystem_error& error) {
        forget_sqlite_file(part);
        connection.fail(Kind::kUnavailable, "cannot write " + path + " (" + error.code().message() +
                                                "); the store is unchanged, give another place");
    } catch (...) {
        forget_sqlite_file(part);
        throw;
    }
}

}  // namespace placode::db
