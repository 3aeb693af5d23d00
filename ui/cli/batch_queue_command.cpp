// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl batch queue | queued | pull | collect: through the centre's server.

#include <unistd.h>

#include <filesystem>
#include <memory>

#include "batches/merge.h"
#include "batches/queue.h"
#include "sim/core/counted.h"
#include "ui/cli/batch.h"
#include "ui/cli/progress.h"
#include "ui/cli/session.h"
#include "ui/version.h"

namespace placode::cli {
namespace {

namespace fs = std::filesystem;

struct QueueOptions {
    std::string folder;
    bool remove = false;
    int lease_s = 300;
};

bool goes_on() { return !CancelOn::requested(); }

db::WorkQueue queue_of(const Context& context) {
    return as_input([&] { return db::WorkQueue(db::parse_store_url(url_to_open(context))); });
}

/// Recordings of people go where every station can read them: for who may see them all.
void need_right(const Context& context, const char* action, const std::string& seal) {
    Session session(context, Missing::kRefuse);
    session.need(db::Action::kSetStandards, db::Scope::kOther);
    session.need(db::Action::kViewAttempts, db::Scope::kOther);
    session.store().audit().write(session.actor(), action, "batch " + seal.substr(0, 12), {});
}

int queue(const Context& context, const QueueOptions& options) {
    const batches::Manifest manifest = batches::read_manifest(options.folder);
    db::WorkQueue queue = queue_of(context);
    need_right(context, options.remove ? "batch.unqueue" : "batch.queue", manifest.seal);
    if (options.remove) {
        as_input([&] { queue.remove(manifest.seal); });
        print(context, {{"batch", manifest.seal}, {"removed", true}},
              "the batch is no longer queued; " + options.folder + " is as it was");
        return 0;
    }
    queue.set_up();
    batches::queue_batch(queue, options.folder, manifest, [](size_t done, size_t of) {
        if (!goes_on()) throw std::runtime_error("batch queue: stopped; the same command goes on");
        show_progress("input " + std::to_string(done + 1) + " of " + std::to_string(of));
    });
    clear_progress();
    print(context, {{"batch", manifest.seal}, {"shards", manifest.shards()}},
          sim::counted(manifest.shards(), "shard") +
              " queued; idle computers: placodectl --store URL batch pull; then here: placodectl "
              "--store URL batch collect " +
              options.folder);
    return 0;
}

int queued(const Context& context, const QueueOptions&) {
    db::WorkQueue queue = queue_of(context);
    Json json = Json::array();
    std::string text;
    for (const db::QueueState& each : queue.states()) {
        json.push_back({{"batch", each.seal},
                        {"build", each.build},
                        {"queued_utc", each.queued_utc},
                        {"shards", each.shards},
                        {"done", each.done},
                        {"at_work", each.held},
                        {"failed", each.failed}});
        text += (text.empty() ? "" : "\n") + each.seal.substr(0, 12) + ": " +
                std::to_string(each.done) + " of " + sim::counted(each.shards, "shard") +
                " done, " + std::to_string(each.held) + " at work, for " + each.build;
        for (const std::string& problem : each.failed) text += "\n  " + problem;
    }
    print(context, json, text.empty() ? "nothing is queued" : text);
    return 0;
}

/// A folder for this process, gone with it.
class OwnFolder {
 public:
    OwnFolder() {
        std::string name = (fs::temp_directory_path() / "placode-pull-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr)
            throw std::runtime_error(name + ": no folder can be made there");
        path_ = name;
    }
    ~OwnFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    OwnFolder(const OwnFolder&) = delete;
    OwnFolder& operator=(const OwnFolder&) = delete;
    [[nodiscard]] const fs::path& path() const { return path_; }

 private:
    fs::path path_;
};

std::string this_computer() {
    char name[256] = {};
    (void)::gethostname(name, sizeof name - 1);
    return std::string(name) + ", process " + std::to_string(::getpid());
}

int pull(const Context& context, const QueueOptions& options) {
    const OwnFolder folder;
    db::WorkQueue queue = queue_of(context);
    batches::PullOrder order;
    order.folder = folder.path();
    order.build = batches::build_text(ui::version_text());
    order.worker = this_computer();
    order.lease_s = options.lease_s;
    order.go_on = goes_on;
    order.progress = [](const db::WorkLease& at, size_t done, size_t of) {
        show_progress("batch " + at.seal.substr(0, 12) + ", shard " + std::to_string(at.shard) +
                      ": " + std::to_string(done) + " of " + std::to_string(of));
    };
    const CancelOn cancel{SIGINT, SIGTERM};
    const batches::PullOutcome outcome = batches::pull_shards(queue, order);
    clear_progress();
    std::string text = sim::counted(outcome.done, "shard") + " done here";
    if (outcome.stopped) text += "; stopped, and given back what was at work";
    for (const std::string& problem : outcome.failed) text += "\n" + problem;
    print(context,
          {{"done", outcome.done},
           {"lost", outcome.lost},
           {"stopped", outcome.stopped},
           {"failed", outcome.failed}},
          text);
    return outcome.failed.empty() ? 0 : 1;
}

int collect(const Context& context, const QueueOptions& options) {
    const batches::Manifest manifest = batches::read_manifest(options.folder);
    db::WorkQueue queue = queue_of(context);
    const batches::Collected found = batches::collect_results(queue, options.folder, manifest);
    const int missing =
        static_cast<int>(batches::batch_status(options.folder, manifest).to_do().size());
    std::string text = sim::counted(found.fresh, "result") + " fetched, " +
                       std::to_string(missing) + " of " + sim::counted(manifest.shards(), "shard") +
                       " still to do";
    for (const std::string& problem : found.damaged) text += "\n" + problem;
    if (missing == 0) text += "; next: placodectl batch merge " + options.folder;
    print(context,
          {{"batch", manifest.seal},
           {"fetched", found.fresh},
           {"missing", missing},
           {"damaged", found.damaged}},
          text);
    return missing == 0 ? 0 : 1;
}

using QueueCommand = int (*)(const Context&, const QueueOptions&);

CLI::App* add_queue_command(CLI::App& batch, Context& context,
                            const std::shared_ptr<QueueOptions>& options, const char* name,
                            const char* words, QueueCommand what) {
    CLI::App* command = batch.add_subcommand(name, words);
    command->callback([&context, options, what] {
        context.run = [&context, options, what] {
            return of_batch([&] { return what(context, *options); });
        };
    });
    return command;
}

}  // namespace

void add_batch_queue_commands(CLI::App& batch, Context& context) {
    auto options = std::make_shared<QueueOptions>();
    CLI::App* put =
        add_queue_command(batch, context, options, "queue",
                          "Puts a batch into the centre's server, for idle computers", queue);
    put->add_option("FOLDER", options->folder, "Of the batch")->required();
    put->add_flag("--remove", options->remove, "Takes it out again, with its results");
    add_queue_command(batch, context, options, "queued",
                      "What is queued on the centre's server, and how far", queued);
    add_queue_command(
        batch, context, options, "pull",
        "Does queued shards that nobody is at, until none is left; for idle computers", pull)
        ->add_option("--lease", options->lease_s,
                     "Seconds after which a computer that went silent loses its shard")
        ->check(CLI::Range(10, 86400))
        ->capture_default_str();
    add_queue_command(batch, context, options, "collect",
                      "Fetches the results from the centre's server into the batch's folder",
                      collect)
        ->add_option("FOLDER", options->folder, "Of the batch")
        ->required();
}

}  // namespace placode::cli
