// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl batch plan: what a batch is to do, as a manifest.

#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>

#include "batches/checksum.h"
#include "batches/plan.h"
#include "db/standards.h"
#include "sim/core/counted.h"
#include "sim/core/text_file.h"
#include "ui/cli/batch.h"
#include "ui/cli/progress.h"
#include "ui/cli/seed_list.h"
#include "ui/cli/session.h"
#include "ui/cli/write_file.h"
#include "ui/finite_range.h"
#include "ui/version.h"

namespace placode::cli {
namespace {

namespace fs = std::filesystem;

struct BatchPlanOptions {
    std::string kind, out, recordings, task, seeds, scene_changes;
    std::vector<std::string> tasks, policies;
    bool from_store = false, metrics = false, record = false;
    int threads = 1, shard_size = 20, frames_per_step = 20;
    double time_limit_s = 0;
};

/// An option that the kind has no use for is a mistake, not a wish.
void refuse_useless(const BatchPlanOptions& options) {
    const bool rollouts = options.kind == "rollouts";
    const std::pair<bool, const char*> useless[] = {
        {rollouts && (!options.recordings.empty() || options.from_store),
         "--recordings and --from-store: of rescore and replay"},
        {!rollouts &&
             (!options.tasks.empty() || !options.policies.empty() || !options.seeds.empty() ||
              options.record || options.time_limit_s > 0 || !options.scene_changes.empty()),
         "--tasks, --policies, --seeds, --time-limit, --scene-changes and --record: of rollouts"},
        {options.kind == "replay" && options.metrics, "--metrics: of rescore and rollouts"},
        {options.kind != "replay" && options.threads != 1, "--threads: of replay"},
        {!options.task.empty() && options.kind == "rollouts", "--task: of rescore and replay"},
        {!options.task.empty() && options.kind == "replay" && !options.from_store,
         "--task: of rescore, and of replay with --from-store"},
    };
    for (const auto& [wrong, words] : useless)
        if (wrong)
            throw InputError("batch plan " + options.kind +
                             ": found an option of another "
                             "kind (" +
                             words + "); leave it out");
}

void go_on_unless_asked_to_stop() {
    if (!CancelOn::requested()) return;
    clear_progress();
    throw std::runtime_error("batch plan: stopped; nothing was planned");
}

/// Puts what was taken out in its place. What is there may be the input of a batch: it stays.
void put_recording(const fs::path& part, const fs::path& place, const std::string& out) {
    if (!fs::exists(place)) {
        fs::rename(part, place);
        return;
    }
    const bool same = batches::sha256_of_file(part) == batches::sha256_of_file(place);
    fs::remove(part);
    if (same) return;
    clear_progress();
    throw InputError("--out " + out + ": " + place.string() +
                     " is another recording than the store's of this number; choose another "
                     "folder, or remove that one");
}

/// Recordings out of the store, into the batch's own folder: a node of a cluster needs no access to
/// the store.
std::vector<batches::OrderedRecording> out_of_store(const Context& context,
                                                    const BatchPlanOptions& options) {
    if (options.task.empty())
        throw InputError("--from-store: expected --task as well, whose attempts are meant");
    Session session(context, Missing::kRefuse);
    session.need(db::Action::kSetStandards, db::Scope::kOther);
    session.need(db::Action::kViewAttempts, db::Scope::kOther);
    const curriculum::Task task = curriculum::load_task(options.task);
    const fs::path folder = fs::path(options.out) / "recordings";
    fs::create_directories(folder);
    std::vector<batches::OrderedRecording> files;
    const auto attempts = session.store().attempts().list(0, task.id);
    // Before the first recording: nothing leaves without its entry.
    session.store().audit().write(
        session.actor(), "batch.extract", "task " + task.id,
        "recordings of " + sim::counted(attempts.size(), "attempt") + " for a batch");
    for (const auto& attempt : attempts) {
        go_on_unless_asked_to_stop();
        show_progress("recording " + std::to_string(files.size() + 1) + " of " +
                      std::to_string(attempts.size()));
        char name[48];
        std::snprintf(name, sizeof name, "attempt-%09lld.placode",
                      static_cast<long long>(attempt.id));
        const fs::path part = folder / (std::string(name) + ".part");
        fs::remove(part);
        try {
            session.store().attempts().extract_recording(attempt.id, part.string());
        } catch (const db::StoreError& error) {
            if (error.kind() != db::StoreError::Kind::kNotFound) throw;
            continue;  // It was made without a recording.
        }
        put_recording(part, folder / name, options.out);
        files.push_back({folder / name, attempt.id, {}});
        if (options.kind == "rescore")
            files.back().pass_points =
                db::rubric_at(session.store(), task, attempt.started_utc).pass_points;
    }
    clear_progress();
    if (files.empty())
        throw InputError("--from-store: no attempts of " + task.id + " with a recording in " +
                         session.store().url());
    std::sort(files.begin(), files.end(),
              [](const auto& a, const auto& b) { return a.attempt < b.attempt; });
    return files;
}

std::string scene_changes_of(const BatchPlanOptions& options) {
    if (options.scene_changes.empty()) return {};
    std::ifstream in(options.scene_changes, std::ios::binary);
    auto text = sim::read_at_most(in, in ? sim::kLargestText : 0);
    if (!text || !Json::parse(*text, nullptr, false).is_object())
        throw InputError("--scene-changes " + options.scene_changes +
                         ": expected a file with a JSON object, as {\"edge_ring_m\": 0.001}");
    return std::move(*text);
}

batches::Manifest plan_of(const Context& context, const BatchPlanOptions& options) {
    if (options.kind == "rollouts") {
        if (options.tasks.empty() || options.policies.empty() || options.seeds.empty())
            throw InputError("batch plan rollouts: expected --tasks, --policies and --seeds");
        batches::RolloutsOrder order;
        order.tasks = options.tasks;
        order.policies = options.policies;
        order.seeds = seed_list("--seeds", options.seeds);
        order.frames_per_step = options.frames_per_step;
        order.time_limit_s = options.time_limit_s;
        order.scene_changes_json = scene_changes_of(options);
        order.metrics = options.metrics;
        order.record = options.record;
        return batches::plan_rollouts(order);
    }
    if (options.recordings.empty() != options.from_store)
        throw InputError("batch plan " + options.kind +
                         ": expected one of --recordings FOLDER and --from-store");
    batches::RecordingsOrder order;
    order.kind = options.kind;
    if (options.from_store) {
        order.recordings = out_of_store(context, options);
    } else {
        for (const fs::path& file : batches::recordings_in(options.recordings))
            order.recordings.push_back({file, 0, {}});
    }
    order.task = options.kind == "rescore" ? options.task : "";
    order.metrics = options.metrics;
    order.threads = options.threads;
    auto manifest = batches::plan_recordings(order, options.out, [](size_t done, size_t of) {
        go_on_unless_asked_to_stop();
        show_progress("checksum " + std::to_string(done + 1) + " of " + std::to_string(of));
    });
    clear_progress();
    return manifest;
}

int plan(const Context& context, const BatchPlanOptions& options) {
    refuse_useless(options);
    need_writable_folder("--out", options.out);
    const CancelOn cancel{SIGINT, SIGTERM};
    batches::Manifest manifest = plan_of(context, options);
    manifest.build = batches::build_text(ui::version_text());
    manifest.shard_size = options.shard_size;
    go_on_unless_asked_to_stop();
    batches::write_manifest(options.out, manifest);
    print(context,
          {{"batch", manifest.seal},
           {"folder", options.out},
           {"kind", manifest.kind},
           {"items", manifest.items.size()},
           {"shards", manifest.shards()},
           {"build", manifest.build}},
          options.out + ": " + sim::counted(manifest.items.size(), "item") + " in " +
              sim::counted(manifest.shards(), "shard") + "; next: placodectl batch run " +
              options.out);
    return 0;
}

void add_options(CLI::App& command, BatchPlanOptions& options) {
    command
        .add_option("KIND", options.kind,
                    "rescore: score recordings again; replay: simulate them again and compare; "
                    "rollouts: attempts of built-in policies")
        ->required()
        ->check(CLI::IsMember({"rescore", "replay", "rollouts"}));
    command.add_option("--out", options.out, "Folder of the batch")->required();
    command.add_option("--shard-size", options.shard_size, "Items done in one go")
        ->check(CLI::Range(1, 100'000))
        ->capture_default_str();
    command.add_option("--recordings", options.recordings,
                       "Rescore, replay: folder with FILE.placode");
    command.add_flag("--from-store", options.from_store,
                     "Rescore, replay: the recordings of --task in --store, copied into the batch");
    command.add_option("--task", options.task,
                       "Rescore: task id, or FILE.json with the new rubric (default: the program's "
                       "own of each recording)");
    command.add_flag("--metrics", options.metrics, "Rescore, rollouts: every metric in the result");
    command.add_option("--threads", options.threads, "Replay: threads of the physics")
        ->check(CLI::Range(1, 64))
        ->capture_default_str();
    command.add_option("--tasks", options.tasks, "Rollouts: task ids or files, with commas")
        ->delimiter(',');
    command
        .add_option("--policies", options.policies,
                    "Rollouts: expert, intermediate, novice, nothing, random, with commas")
        ->delimiter(',');
    command.add_option("--seeds", options.seeds, "Rollouts: as 1-20,31");
    command
        .add_option("--frames-per-step", options.frames_per_step,
                    "Rollouts: simulated ms between two actions")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command
        .add_option("--time-limit", options.time_limit_s,
                    "Rollouts: end earlier than the task would [s]")
        ->check(ui::finite_range(0.1, 3600.0));
    command.add_option("--scene-changes", options.scene_changes,
                       "Rollouts: FILE.json that is merged into every scene");
    command.add_flag("--record", options.record, "Rollouts: keep the recordings");
}

}  // namespace

void add_batch_plan_command(CLI::App& batch, Context& context) {
    auto options = std::make_shared<BatchPlanOptions>();
    CLI::App* command =
        batch.add_subcommand("plan", "Writes the manifest: what, inputs with checksums, shards");
    add_options(*command, *options);
    command->callback([&context, options] {
        context.run = [&context, options] {
            return of_batch([&] { return plan(context, *options); });
        };
    });
}

}  // namespace placode::cli
