// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "batches/merge.h"

#include <algorithm>
#include <sstream>

#include "batches/batch_error.h"
#include "batches/checksum.h"
#include "batches/shard.h"

namespace placode::batches {
namespace {

namespace fs = std::filesystem;

void count(const std::string& lines, Summary& summary) {
    std::istringstream in(lines);
    for (std::string line; std::getline(in, line);) {
        const Json item = Json::parse(line);
        ++summary.items;
        if (item.contains("problem")) ++summary.problems;
        if (item.contains("verdict")) ++summary.verdicts[item["verdict"].get<std::string>()];
        if (item.contains("replay"))
            ++(item["replay"] == "identical" ? summary.identical : summary.differ);
    }
}

std::string what_lacks(const BatchStatus& status) {
    std::string text;
    if (!status.missing.empty())
        text += "not done yet: shards " + ranges_text(status.missing) + "\n";
    for (const std::string& one : status.damaged) text += one + "\n";
    for (const std::string& one : status.of_another) text += one + "\n";
    return text;
}

}  // namespace

std::string ranges_text(const std::vector<int>& numbers) {
    std::vector<std::string> ranges;
    for (size_t i = 0; i < numbers.size();) {
        size_t end = i + 1;
        while (end < numbers.size() && numbers[end] == numbers[end - 1] + 1) ++end;
        ranges.push_back(std::to_string(numbers[i]));
        if (end - i > 1) ranges.back() += " to " + std::to_string(numbers[end - 1]);
        i = end;
    }
    std::string text;
    for (size_t i = 0; i < ranges.size(); ++i)
        text += (i == 0 ? "" : i + 1 == ranges.size() ? " and " : ", ") + ranges[i];
    return text;
}

std::vector<int> BatchStatus::to_do() const {
    std::vector<int> all = missing;
    all.insert(all.end(), damaged_shards.begin(), damaged_shards.end());
    std::sort(all.begin(), all.end());
    return all;
}

BatchStatus batch_status(const fs::path& folder, const Manifest& manifest) {
    BatchStatus status;
    status.shards = manifest.shards();
    for (int number = 0; number < status.shards; ++number) {
        const Shard shard = read_shard(folder, manifest, number);
        if (shard.state == ShardState::kMissing) status.missing.push_back(number);
        if (shard.state == ShardState::kDone) ++status.done;
        if (shard.state == ShardState::kDamaged) {
            status.damaged.push_back(shard.problem);
            status.damaged_shards.push_back(number);
        }
        if (shard.state == ShardState::kOfAnother) status.of_another.push_back(shard.problem);
    }
    return status;
}

void need_all_shards(const BatchStatus& status) {
    if (status.done != status.shards)
        throw BatchError(BatchError::Kind::kFailed,
                         std::to_string(status.done) + " of " + std::to_string(status.shards) +
                             " shards are done:\n" + what_lacks(status) +
                             "`placodectl batch run` does what is missing or damaged");
}

Shard read_done_shard(const fs::path& folder, const Manifest& manifest, int number) {
    Shard shard = read_shard(folder, manifest, number);
    if (shard.state != ShardState::kDone)
        throw BatchError(BatchError::Kind::kFailed, shard.problem + " since a moment ago");
    return shard;
}

Summary merge_batch(const fs::path& folder, const Manifest& manifest, const fs::path& result) {
    need_all_shards(batch_status(folder, manifest));
    Summary summary;
    std::string lines;
    for (int number = 0; number < manifest.shards(); ++number) {
        const Shard shard = read_done_shard(folder, manifest, number);
        count(shard.lines, summary);
        lines += shard.lines;
    }
    const Json head{{"batch", manifest.seal},  {"kind", manifest.kind},
                    {"build", manifest.build}, {"options", manifest.options},
                    {"tasks", manifest.tasks}, {"items", manifest.items.size()},
                    {"sha256", sha256(lines)}};
    write_whole(result, head.dump() + "\n" + lines);
    return summary;
}

}  // namespace placode::batches
