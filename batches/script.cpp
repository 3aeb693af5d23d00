// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "batches/script.h"

#include <algorithm>

#include "batches/batch_error.h"

namespace placode::batches {
namespace {

/// As one word for a shell.
std::string quoted(const std::string& text) {
    std::string word = "'";
    for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return word + "'";
}

/// Slurm takes array indices up to MaxArraySize - 1, which is 1000 unless its administrator said
/// otherwise.
constexpr int kMostArrayTasks = 1000;

/// "0-4,7"
std::string indices(const std::vector<int>& numbers) {
    std::string text;
    for (size_t i = 0; i < numbers.size();) {
        size_t end = i + 1;
        while (end < numbers.size() && numbers[end] == numbers[end - 1] + 1) ++end;
        text += (text.empty() ? "" : ",") + std::to_string(numbers[i]);
        if (end - i > 1) text += "-" + std::to_string(numbers[end - 1]);
        i = end;
    }
    return text;
}

std::string slurm_script(const Manifest& manifest, const std::string& work, const std::string& logs,
                         int threads, int jobs, const std::vector<int>& missing) {
    const int array = std::min(manifest.shards(), kMostArrayTasks);
    const std::string which =
        manifest.shards() == array ? indices(missing) : "0-" + std::to_string(array - 1);
    std::string text = "#!/bin/bash\n";
    text += "#SBATCH --job-name=placode-" + manifest.seal.substr(0, 8) + "\n";
    text += "#SBATCH --array=" + which + (jobs > 0 ? "%" + std::to_string(jobs) : "") + "\n";
    text += "#SBATCH --cpus-per-task=" + std::to_string(threads) + "\n";
    text += "#SBATCH --requeue\n";
    text += "#SBATCH --open-mode=append\n";
    text += "#SBATCH --output=\"" + logs + "/slurm-%a.log\"\n";
    text += "# " + std::to_string(manifest.shards()) +
            " shards. One that is done takes no time: submit it again after anything.\n";
    text += "status=0\n";
    text += "for ((shard = SLURM_ARRAY_TASK_ID; shard < " + std::to_string(manifest.shards()) +
            "; shard += " + std::to_string(array) + ")); do\n";
    text += "  " + work + " --shard \"$shard\" || status=1\n";
    text += "done\nexit $status\n";
    return text;
}

std::string parallel_script(const Manifest& manifest, const std::string& work,
                            const std::string& logs, int jobs) {
    return "#!/bin/bash\n# " + std::to_string(manifest.shards()) +
           " shards. One that is done takes no time: run it again after anything.\n"
           "seq 0 " +
           std::to_string(manifest.shards() - 1) + " | parallel --jobs " +
           (jobs > 0 ? std::to_string(jobs) : "100%") + " --joblog " +
           quoted(logs + "/parallel.log") + " \\\n  " + quoted(work + " --shard {}") + "\n";
}

}  // namespace

std::string runner_script(const std::string& runner, const Manifest& manifest,
                          const std::filesystem::path& folder, const std::string& program, int jobs,
                          const std::vector<int>& missing) {
    if (missing.empty())
        throw BatchError(BatchError::Kind::kBadInput,
                         folder.string() + ": every shard is done; next: placodectl batch merge " +
                             folder.string());
    const std::string place = std::filesystem::absolute(folder).lexically_normal().string();
    const std::string work = quoted(program) + " batch work " + quoted(place);
    const std::string logs = place + "/logs";
    if (runner == "slurm")
        return slurm_script(manifest, work, logs, manifest.options.value("threads", 1), jobs,
                            missing);
    if (runner == "parallel") return parallel_script(manifest, work, logs, jobs);
    throw BatchError(BatchError::Kind::kBadInput,
                     "--runner " + runner + ": unknown; expected slurm or parallel");
}

}  // namespace placode::batches
