// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl batch keep: the scores of a rescoring batch, into the store that its recordings are
// of.

#include <algorithm>
#include <memory>
#include <random>

#include "batches/checksum.h"
#include "batches/scores.h"
#include "ui/cli/batch.h"
#include "ui/cli/progress.h"
#include "ui/cli/rescore_report.h"
#include "ui/cli/session.h"
#include "ui/version.h"

namespace placode::cli {
namespace {

using Scores = std::map<int64_t, batches::StoredScore>;

struct BatchKeepOptions {
    std::string folder;
    int check = 20;
    bool dry_run = false;
};

/// Attempts that are scored here as well. Nobody who helped with the batch can know which.
std::set<int64_t> sample_of(const Scores& scores, int count) {
    std::vector<int64_t> all, some;
    for (const auto& [attempt, score] : scores)
        if (score.problem.empty()) all.push_back(attempt);
    std::random_device random;
    std::sample(all.begin(), all.end(), std::back_inserter(some), count, random);
    return {some.begin(), some.end()};
}

std::optional<db::ComputedScore> score_of(const Scores& scores, int64_t attempt,
                                          const std::string& file) {
    const auto found = scores.find(attempt);
    if (found == scores.end()) return std::nullopt;
    if (batches::sha256_of_file(file) != found->second.recording_sha256)
        throw db::StoreError(db::StoreError::Kind::kConflict,
                             "attempt " + std::to_string(attempt) +
                                 ": the batch scored another recording than the store keeps; it "
                                 "is of another store, plan it anew");
    if (!found->second.problem.empty())
        throw db::StoreError(db::StoreError::Kind::kDamaged, found->second.problem);
    return found->second.score;
}

void need_this_build(const batches::Manifest& manifest) {
    const std::string here = batches::build_text(ui::version_text());
    if (manifest.build != here)
        throw InputError("batch keep: the batch was made by " + manifest.build + ", this is " +
                         here + "; run the batch again with this build");
}

int keep(const Context& context, const BatchKeepOptions& options) {
    const batches::Manifest manifest = batches::read_manifest(options.folder);
    need_this_build(manifest);
    const Scores scores = batches::scores_for_store(options.folder, manifest);
    const curriculum::Task task = batches::task_of_entry(manifest.tasks.at(0), options.folder);
    Session session(context, Missing::kRefuse);
    session.need(db::Action::kSetStandards, db::Scope::kOther);
    db::RescoreOptions how;
    how.dry_run = options.dry_run;
    how.computed = [&](int64_t attempt, const std::string& file) {
        return score_of(scores, attempt, file);
    };
    how.recompute = sample_of(scores, options.check);
    const CancelOn cancel{SIGINT, SIGTERM};
    return run_rescoring(context, session.store(), task, std::move(how), "keeping");
}

}  // namespace

void add_batch_keep_command(CLI::App& batch, Context& context) {
    auto options = std::make_shared<BatchKeepOptions>();
    CLI::App* command = batch.add_subcommand(
        "keep", "Takes the scores of a rescoring batch into the store; the first score stays");
    command->add_option("FOLDER", options->folder, "Of the batch")->required();
    command
        ->add_option("--check", options->check,
                     "So many attempts, chosen by chance, are scored here as well; when one "
                     "differs, nothing is kept")
        ->check(CLI::Range(1, 1'000'000))
        ->capture_default_str();
    command->add_flag("--dry-run", options->dry_run, "Compares, saves nothing");
    command->callback([&context, options] {
        context.run = [&context, options] {
            return of_batch([&] { return keep(context, *options); });
        };
    });
}

}  // namespace placode::cli
