// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a store is sound: its file, its trail, what the trail says of it, and the recordings.

#include "db/store_check.h"

#include "db/foreign_store.h"
#include "db/sqlite_file.h"
#include "db/store.h"
#include "db/store_context.h"

namespace placode::db {
namespace {

struct CheckStopped {};

/// Asks and tells as seldom as it costs nothing: recordings take long, of rows there are millions.
class CheckTeller {
 public:
    explicit CheckTeller(const CheckOptions& options) : options_(options) { tell(); }

    void operator()(CheckProgress::Step step) {
        constexpr int64_t kRowsBetween = 256;
        at_.done = step == at_.step ? at_.done + 1 : 0;
        at_.step = step;
        if (step == CheckProgress::Step::kRecordings || at_.done % kRowsBetween == 0) tell();
    }
    /// A question about a file, which may take as long as all the rest.
    std::string ask(Connection& connection, std::string (*question)(Connection&)) const {
        const InterruptOn interrupt(connection, options_.stop);
        try {
            return question(connection);
        } catch (const StoreError&) {
            if (!interrupt.stopped()) throw;
        }
        throw CheckStopped{};
    }

 private:
    void tell() const {
        if (options_.stop && options_.stop()) throw CheckStopped{};
        if (options_.progress) options_.progress(at_);
    }

    const CheckOptions& options_;
    CheckProgress at_;
};

std::string reference_problem(Connection& connection) {
    Statement keys(connection, "PRAGMA foreign_key_check");
    keys.run();
    if (!keys.next()) return {};
    return "a row of " + keys.text("table") + " refers to a missing " + keys.text("parent");
}

void check_file(StoreContext& context, const CheckTeller& teller,
                std::vector<std::string>& problems) {
    Connection& connection = context.connection;
    const std::string problem = teller.ask(connection, sqlite_integrity_problem);
    if (!problem.empty()) problems.push_back("file: " + problem);
    const std::string other = foreign_object(connection, context.options.migrations);
    if (!other.empty())
        problems.push_back("schema: it holds " + other +
                           ", which Placode did not make; have it taken out, until then there "
                           "is no backup and no update");
    const std::string reference = teller.ask(connection, reference_problem);
    if (!reference.empty()) problems.push_back("references: " + reference);
}

}  // namespace

std::vector<std::string> Store::check() { return check(CheckOptions{}).value(); }

std::optional<std::vector<std::string>> Store::check(const CheckOptions& options) {
    Connection& connection = context_->connection;
    connection.begin_operation("check");
    context_->need(Action::kBackup);
    std::vector<std::string> problems;
    try {
        CheckTeller teller(options);
        if (connection.is_sqlite()) check_file(*context_, teller, problems);
        const auto pace = [&teller](CheckProgress::Step step) { teller(step); };
        try {
            audit_.check_chain(problems, pace);
            attempts_.check_recordings(problems, pace);
        } catch (const StoreError& error) {
            problems.emplace_back(error.what());
        }
    } catch (const CheckStopped&) {
        return std::nullopt;
    }
    return problems;
}

}  // namespace placode::db
