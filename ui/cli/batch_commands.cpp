// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl batch run | work | status | merge | script

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <thread>

#include "batches/costs.h"
#include "batches/merge.h"
#include "batches/runner.h"
#include "batches/script.h"
#include "batches/shard.h"
#include "sim/core/counted.h"
#include "ui/cli/batch.h"
#include "ui/cli/progress.h"
#include "ui/cli/write_file.h"
#include "ui/version.h"

namespace placode::cli {
namespace {

namespace fs = std::filesystem;

struct BatchOptions {
    std::string folder, out, runner = "slurm";
    int shard = -1, jobs = 0;
};

std::string this_program() { return fs::read_symlink("/proc/self/exe").string(); }

bool go_on() { return !CancelOn::requested(); }

std::string of_all(int done, int shards) {
    return std::to_string(done) + " of " + sim::counted(shards, "shard");
}

int run(const Context& context, const BatchOptions& options) {
    const batches::Manifest manifest = batches::read_manifest(options.folder);
    batches::RunOrder order;
    order.folder = options.folder;
    order.command = {this_program(), "batch", "work", options.folder, "--shard"};
    order.jobs = options.jobs > 0
                     ? options.jobs
                     : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    order.go_on = go_on;
    order.progress = [](int done, int of) { show_progress(of_all(done, of) + " done"); };
    const CancelOn cancel{SIGINT, SIGTERM};
    const auto start = std::chrono::steady_clock::now();
    const batches::RunOutcome outcome = batches::run_batch(manifest, order);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    clear_progress();
    const int done = outcome.done_before + outcome.done;
    if (outcome.done == manifest.shards())
        batches::keep_run_cost(options.folder, {order.jobs, took.count()});
    Json json{{"batch", manifest.seal},
              {"shards", manifest.shards()},
              {"done_before", outcome.done_before},
              {"done", outcome.done},
              {"cancelled", outcome.stopped},
              {"failed", Json::array()}};
    std::string text =
        of_all(done, manifest.shards()) + " done" +
        (outcome.done_before > 0 ? ", " + std::to_string(outcome.done_before) + " of them before"
                                 : "");
    for (const auto& [shard, problem] : outcome.failed) {
        json["failed"].push_back({{"shard", shard}, {"problem", problem}});
        text += "\nshard " + std::to_string(shard) + " failed: " + problem;
    }
    if (outcome.stopped) text += "\nstopped; the same command goes on where it was";
    if (done == manifest.shards()) text += "; next: placodectl batch merge " + options.folder;
    print(context, json, text);
    return done == manifest.shards() ? 0 : 1;
}

/// One shard; false when it had been done before.
bool do_one(const batches::Manifest& manifest, const BatchOptions& options, int shard) {
    const auto start = std::chrono::steady_clock::now();
    const bool fresh =
        batches::do_shard(options.folder, manifest, shard, batches::build_text(ui::version_text()),
                          go_on, [&](size_t done, size_t of) {
                              show_progress("shard " + std::to_string(shard) + ": " +
                                            std::to_string(done) + " of " + std::to_string(of));
                          });
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    const auto [first, behind] = manifest.range(shard);
    // A worker for one shard costs its start as well.
    const double wall_s = options.shard >= 0 ? batches::seconds_of_this_process() : 0;
    if (fresh)
        batches::keep_cost(options.folder, {shard, behind - first, std::max(wall_s, took.count())});
    return fresh;
}

/// Free shards one after the other, until none is left.
int do_free_ones(const batches::Manifest& manifest, const BatchOptions& options) {
    int done = 0;
    for (int shard = 0; shard < manifest.shards(); ++shard) {
        try {
            done += do_one(manifest, options, shard) ? 1 : 0;
        } catch (const batches::BatchError& error) {
            if (error.kind() != batches::BatchError::Kind::kBusy) throw;
        }
    }
    return done;
}

int work(const Context& context, const BatchOptions& options) {
    const batches::Manifest manifest = batches::read_manifest(options.folder);
    const CancelOn cancel{SIGINT, SIGTERM};
    try {
        if (options.shard < 0) {
            const int done = do_free_ones(manifest, options);
            clear_progress();
            print(context, {{"batch", manifest.seal}, {"done", done}},
                  sim::counted(done, "shard") + " done here");
            return 0;
        }
        const bool fresh = do_one(manifest, options, options.shard);
        clear_progress();
        print(context,
              {{"batch", manifest.seal}, {"shard", options.shard}, {"done_before", !fresh}},
              "shard " + std::to_string(options.shard) +
                  (fresh ? ": done" : ": had been done before"));
        return 0;
    } catch (const batches::Stopped&) {
        clear_progress();
        throw std::runtime_error("stopped; the shard is as it was");
    }
}

int status(const Context& context, const BatchOptions& options) {
    const batches::Manifest manifest = batches::read_manifest(options.folder);
    const batches::BatchStatus found = batches::batch_status(options.folder, manifest);
    std::string text = manifest.kind + ", " + sim::counted(manifest.items.size(), "item") + ", " +
                       of_all(found.done, found.shards) + " done";
    if (!found.missing.empty())
        text += "\nnot done yet: shards " + batches::ranges_text(found.missing);
    for (const auto* list : {&found.damaged, &found.of_another})
        for (const std::string& problem : *list) text += "\n" + problem;
    print(context,
          {{"batch", manifest.seal},
           {"kind", manifest.kind},
           {"build", manifest.build},
           {"items", manifest.items.size()},
           {"shards", found.shards},
           {"done", found.done},
           {"missing", found.missing},
           {"damaged", found.damaged},
           {"of_another_batch", found.of_another}},
          text);
    return 0;
}

int merge(const Context& context, const BatchOptions& options) {
    need_file_place("--out", options.out);
    const batches::Manifest manifest = batches::read_manifest(options.folder);
    const std::string out =
        options.out.empty() ? (fs::path(options.folder) / "result.jsonl").string() : options.out;
    const batches::Summary summary = batches::merge_batch(options.folder, manifest, out);
    Json json{{"batch", manifest.seal},
              {"result", out},
              {"items", summary.items},
              {"problems", summary.problems}};
    std::string text = out + ": " + sim::counted(summary.items, "item");
    if (manifest.kind == "replay") {
        json["identical"] = summary.identical;
        json["differ"] = summary.differ;
        text += ", " + std::to_string(summary.identical) + " identical, " +
                std::to_string(summary.differ) + " differ";
    }
    for (const auto& [verdict, count] : summary.verdicts) {
        json["verdicts"][verdict] = count;
        text += ", " + std::to_string(count) + " " + verdict;
    }
    if (summary.problems > 0)
        text += "; " + sim::counted(summary.problems, "item") + " with a problem, see the file";
    print(context, json, text);
    return 0;
}

int script(const Context& context, const BatchOptions& options) {
    const batches::Manifest manifest = batches::read_manifest(options.folder);
    const std::string text = batches::runner_script(
        options.runner, manifest, options.folder, this_program(), options.jobs,
        batches::batch_status(options.folder, manifest).to_do());
    print(context, {{"runner", options.runner}, {"script", text}}, text);
    return 0;
}

using Command = int (*)(const Context&, const BatchOptions&);

CLI::App* add(CLI::App& batch, Context& context, const std::shared_ptr<BatchOptions>& options,
              const char* name, const char* words, Command what) {
    CLI::App* command = batch.add_subcommand(name, words);
    command->add_option("FOLDER", options->folder, "Of the batch")->required();
    command->callback([&context, options, what] {
        context.run = [&context, options, what] {
            return of_batch([&] { return what(context, *options); });
        };
    });
    return command;
}

}  // namespace

void add_batch_commands(CLI::App& app, Context& context) {
    CLI::App* batch = app.add_subcommand(
        "batch", "Much work in shards, here or on a cluster: rescoring, replays, rollouts");
    batch->require_subcommand(1);
    add_batch_plan_command(*batch, context);
    add_batch_keep_command(*batch, context);
    add_batch_forecast_command(*batch, context);
    add_batch_queue_commands(*batch, context);
    auto options = std::make_shared<BatchOptions>();
    add(*batch, context, options, "run",
        "Does what is missing, by worker processes on this computer", run)
        ->add_option("--jobs", options->jobs, "At the same time (default: one for each core)")
        ->check(CLI::Range(1, 1024));
    add(*batch, context, options, "work",
        "Does one shard, or all that nobody is at: for job arrays and idle computers", work)
        ->add_option("--shard", options->shard, "Number from 0 (default: every free one)")
        ->check(CLI::NonNegativeNumber);
    add(*batch, context, options, "status", "What is done, missing or damaged", status);
    add(*batch, context, options, "merge", "Verifies every shard and writes one result file", merge)
        ->add_option("--out", options->out, "FILE.jsonl (default: FOLDER/result.jsonl)");
    CLI::App* scripts = add(*batch, context, options, "script",
                            "Prints the script for another program that runs the shards", script);
    scripts->add_option("--runner", options->runner, "slurm: a job array; parallel: GNU parallel")
        ->check(CLI::IsMember({"slurm", "parallel"}))
        ->capture_default_str();
    scripts->add_option("--jobs", options->jobs, "At the same time (default: as the runner likes)")
        ->check(CLI::Range(1, 1024));
}

}  // namespace placode::cli
