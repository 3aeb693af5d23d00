// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl store move: from the file of one computer to a centre's server, and back.

#include <algorithm>
#include <memory>
#include <optional>

#include "db/store_move.h"
#include "db/store_url.h"
#include "ui/cli/progress.h"
#include "ui/cli/session.h"

namespace placode::cli {
namespace {

using db::MoveProgress;

struct MoveCommandOptions {
    std::string to;
    bool dry_run = false;
};

std::string progress_words(const MoveProgress& at) {
    switch (at.step) {
        case MoveProgress::Step::kCheckHere:
            return "checking the store";
        case MoveProgress::Step::kCheckThere:
            return "checking the copy";
        case MoveProgress::Step::kFinish:
            return "finishing";
        case MoveProgress::Step::kCopy:
        case MoveProgress::Step::kCompare:
            break;
    }
    const int64_t percent = at.total > 0 ? std::min<int64_t>(100, 100 * at.done / at.total) : 100;
    return std::string(at.step == MoveProgress::Step::kCopy ? "copying" : "comparing") + " " +
           std::to_string(at.done) + " of " + std::to_string(at.total) + " rows, " +
           std::to_string(percent) + " % (" + at.table + ")";
}

std::string mebibytes(int64_t bytes) { return fixed(static_cast<double>(bytes) / 1048576, 1); }

int print_report(const Context& context, const db::MoveReport& report, bool dry_run) {
    Json json{{"from", report.from},
              {"to", report.to},
              {"dry_run", dry_run},
              {"moved", !dry_run && !report.stopped},
              {"went_on", report.went_on},
              {"rows", report.rows},
              {"recording_bytes", report.recording_bytes},
              {"tables", Json::array()}};
    std::vector<std::vector<std::string>> rows{{"table", "rows"}};
    for (const auto& table : report.tables) {
        json["tables"].push_back({{"table", table.name}, {"rows", table.rows}});
        rows.push_back({table.name, std::to_string(table.rows)});
    }
    if (!report.old_file.empty()) json["old_file"] = report.old_file;
    std::string text;
    if (dry_run) {
        text = table(rows) + std::to_string(report.rows) + " rows, " +
               mebibytes(report.recording_bytes) + " MiB of recordings would go from " +
               report.from + " to " + report.to +
               (report.went_on ? ", where an unfinished move goes on" : ", which is free");
    } else if (report.stopped) {
        text = "stopped; nothing has moved, what was copied is kept, and the same command goes on";
    } else {
        text = "moved " + report.from + " to " + report.to +
               "; every row was compared. The old place is kept and closed: give the new one with "
               "--store from now on";
        if (!report.old_file.empty())
            text += "; the file that was there is kept as " + report.old_file;
    }
    print(context, json, text);
    return report.stopped ? 1 : 0;
}

/// nullopt: the old place is closed already, where nobody can sign in. Its owner then ends what an
/// administrator has begun.
std::optional<Session> open_session(const Context& context, const std::string& to,
                                    std::optional<db::MoveReport>& finished) {
    try {
        std::optional<Session> session;
        session.emplace(context, Missing::kRefuse);
        return session;
    } catch (const db::StoreError& error) {
        if (error.kind() != db::StoreError::Kind::kRefused) throw;
        const std::string from = store_url_of(context);
        if (db::parse_store_url(from).engine == db::Engine::kSqlite)
            (void)need_local_administrator(from);
        finished = db::finish_move(url_to_open(from), to);
        if (!finished) throw;
    }
    return std::nullopt;
}

int move(const Context& context, const MoveCommandOptions& options) {
    refuse_open_password("--to", options.to);
    const std::string to = url_to_open(options.to);
    std::optional<db::MoveReport> report;
    std::optional<Session> session = open_session(context, to, report);
    if (!session) return print_report(context, *report, false);
    session->need(db::Action::kBackup, db::Scope::kOther);
    db::MoveOptions how;
    how.dry_run = options.dry_run;
    how.progress = [](const MoveProgress& at) {
        show_progress(progress_words(at));
        return !CancelOn::requested();
    };
    const CancelOn cancel{SIGINT, SIGTERM};
    struct Cleared {
        ~Cleared() { clear_progress(); }
    };
    {
        const Cleared cleared;
        report = session->store().move_to(to, how);
    }
    return print_report(context, *report, options.dry_run);
}

}  // namespace

void add_store_move_command(CLI::App& app, Context& context) {
    auto options = std::make_shared<MoveCommandOptions>();
    CLI::App* store = app.add_subcommand("store", "Moves the whole store to another place");
    store->require_subcommand(1);
    CLI::App* moved = store->add_subcommand(
        "move",
        "Moves the store of --store to a server, or back to a file: every row is compared, and "
        "the old place is kept and closed. Stopped or killed, the same command goes on");
    moved
        ->add_option("--to", options->to,
                     "postgresql://USER@HOST:PORT/NAME, an empty database with the log-in of its "
                     "owner, or sqlite:PATH, where there is no store")
        ->type_name("URL")
        ->required();
    moved->add_flag("--dry-run", options->dry_run, "Says what would be moved, and changes nothing");
    moved->callback([&context, options] {
        context.run = [&context, options] { return move(context, *options); };
    });
}

}  // namespace placode::cli
