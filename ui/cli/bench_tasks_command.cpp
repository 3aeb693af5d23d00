// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl bench tasks: the benchmark for machine operators. Makes an entry, verifies one, writes
// the leader board.

#include <filesystem>
#include <memory>

#include "batches/benchmark.h"
#include "sim/core/counted.h"
#include "ui/cli/batch.h"
#include "ui/cli/progress.h"
#include "ui/cli/seed_list.h"
#include "ui/cli/write_file.h"
#include "ui/version.h"

namespace placode::cli {
namespace {

namespace fs = std::filesystem;

struct BenchTasksOptions {
    std::string policy, recordings, out, name, seeds, protocol, verify, board;
    std::vector<std::string> tasks, entries;
    bool no_replay = false;
};

bool tell(const std::string& what) {
    show_progress(what);
    return !CancelOn::requested();
}

batches::Protocol protocol_of(const BenchTasksOptions& options) {
    return batches::read_protocol(options.protocol.empty() ? batches::shipped_protocol()
                                                           : fs::path(options.protocol));
}

std::string entry_table(const Json& entry) {
    std::vector<std::vector<std::string>> rows{{"task", "attempts", "passed", "points"}};
    for (const Json& task : entry["tasks"])
        rows.push_back({task["task"], std::to_string(task["attempts"].get<int>()),
                        std::to_string(task["passed"].get<int>()),
                        fixed(task["points"].get<double>(), 1)});
    return table(rows);
}

int enter(const Context& context, const BenchTasksOptions& options) {
    if (options.policy.empty() == options.recordings.empty())
        throw InputError(
            "bench tasks: expected one of --policy NAME (with --out FOLDER), --recordings FOLDER, "
            "--verify FILE and --board FILE");
    if (!options.policy.empty() && options.out.empty())
        throw InputError("bench tasks --policy: expected --out FOLDER, for entry and recordings");
    if (!options.policy.empty()) need_writable_folder("--out", options.out);
    batches::EntryOrder order;
    order.policy = options.policy;
    order.name = options.name.empty() ? options.policy : options.name;
    if (order.name.empty())
        throw InputError("bench tasks --recordings: expected --name, how the operator is called");
    order.build = batches::build_text(ui::version_text());
    if (!options.seeds.empty()) order.seeds = seed_list("--seeds", options.seeds);
    order.only = options.tasks;
    const fs::path folder = options.policy.empty() ? options.recordings : options.out;
    const Json entry = batches::make_entry(protocol_of(options), order, folder, tell);
    clear_progress();
    print(context, entry,
          entry_table(entry) + "score " + fixed(entry["score"].get<double>(), 1) + " of 100" +
              (entry["complete"].get<bool>() ? "" : " over some of the tasks: not ranked") +
              (entry["held_out_seeds"].get<bool>() ? ", held-out seeds" : "") + "\n" +
              (folder / "entry.json").string());
    return 0;
}

int verify(const Context& context, const BenchTasksOptions& options) {
    const auto check = batches::check_entry(
        protocol_of(options), batches::entry_file(options.verify), !options.no_replay, tell);
    clear_progress();
    const bool genuine = check.problems.empty();
    std::string text;
    for (const std::string& problem : check.problems) text += problem + "\n";
    text += options.verify + ": ";
    if (!genuine)
        text += "not genuine";
    else if (check.replayed)
        text += "genuine: every attempt, simulated again, is the recorded one";
    else if (options.no_replay)
        text += "its sums and checksums fit; nothing was simulated again";
    else
        text +=
            "its sums and checksums fit; another build or processor recorded it, and only that "
            "one can simulate it again bit for bit";
    print(context,
          {{"entry", options.verify},
           {"genuine", genuine && check.replayed},
           {"replayed", check.replayed},
           {"problems", check.problems}},
          text);
    return genuine && (check.replayed || options.no_replay) ? 0 : 1;
}

int board(const Context& context, const BenchTasksOptions& options) {
    need_writable_file("--board", options.board);
    if (options.entries.empty())
        throw InputError(
            "bench tasks --board: expected entries, as --entries A/entry.json "
            "B/entry.json");
    const batches::Protocol protocol = protocol_of(options);
    std::vector<Json> entries;
    std::vector<batches::EntryCheck> checks;
    Json json{{"board", options.board}, {"entries", Json::array()}};
    // What cannot be printed is refused before hours of replays and not behind them.
    for (const std::string& file : options.entries)
        entries.push_back(batches::read_board_entry(batches::entry_file(file)));
    for (const std::string& file : options.entries) {
        checks.push_back(
            batches::check_entry(protocol, batches::entry_file(file), !options.no_replay, tell));
        json["entries"].push_back({{"entry", file},
                                   {"replayed", checks.back().replayed},
                                   {"problems", checks.back().problems}});
    }
    clear_progress();
    write_file(options.board, batches::board_text(protocol, entries, checks));
    print(context, json, options.board + ": " + sim::counted(entries.size(), "entry", "entries"));
    return 0;
}

int tasks(const Context& context, const BenchTasksOptions& options) {
    const CancelOn cancel{SIGINT, SIGTERM};
    try {
        if (!options.verify.empty()) return verify(context, options);
        if (!options.board.empty()) return board(context, options);
        return enter(context, options);
    } catch (const batches::Stopped&) {
        clear_progress();
        // Recordings that are made stay; what was compared so far is kept nowhere.
        const bool entering = options.verify.empty() && options.board.empty();
        throw std::runtime_error(entering
                                     ? "bench tasks: stopped; the same command goes on where it was"
                                     : "bench tasks: stopped; the same command begins again");
    }
}

}  // namespace

void add_bench_tasks_command(CLI::App& bench, Context& context) {
    auto options = std::make_shared<BenchTasksOptions>();
    CLI::App* command = bench.add_subcommand(
        "tasks", "The benchmark for machine operators: an entry, its proof, the leader board");
    command->add_option("--policy", options->policy,
                        "Make an entry: expert, intermediate, novice, nothing or random");
    command->add_option("--out", options->out, "Folder for its recordings and entry.json");
    command->add_option("--recordings", options->recordings,
                        "Make an entry from recordings of another operator; entry.json goes there");
    command->add_option("--name", options->name, "Of the operator, for the board");
    command->add_option("--seeds", options->seeds,
                        "Held-out seeds instead of the protocol's, as 9001-9010");
    command->add_option("--tasks", options->tasks, "These only, with commas: not ranked")
        ->delimiter(',');
    command->add_option("--protocol", options->protocol,
                        "FILE.json (default: the published one, data/benchmarks/tasks.json)");
    command->add_option("--verify", options->verify,
                        "ENTRY or ENTRY/entry.json: checks it and simulates every attempt again");
    command->add_option("--board", options->board,
                        "FILE.md: leader board of --entries, each of them verified");
    command->add_option("--entries", options->entries,
                        "Folders of entries, or their entry.json, for the board");
    command->add_flag("--no-replay", options->no_replay,
                      "Verify, board: checksums and sums only; the board says so");
    command->callback([&context, options] {
        context.run = [&context, options] {
            return of_batch([&] { return tasks(context, *options); });
        };
    });
}

}  // namespace placode::cli
