// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "batches/costs.h"

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <ctime>
#include <fstream>
#include <iterator>
#include <sstream>

#include "batches/shard.h"

namespace placode::batches {
namespace {

namespace fs = std::filesystem;

fs::path cost_path(const fs::path& folder, int shard) {
    return folder / "times" / shard_path(folder, shard).stem().concat(".json");
}

void write(const fs::path& path, const Json& json) noexcept {
    try {
        fs::create_directories(path.parent_path());
        std::ofstream(path) << json.dump() << '\n';
    } catch (const std::exception&) {
    }
}

/// {KEY: a whole number, "wall_s": seconds}; wall_s 0 = it cannot be read.
std::pair<size_t, double> read(const fs::path& path, const char* key) {
    std::ifstream in(path);
    const std::string text(std::istreambuf_iterator<char>(in), {});
    const Json json = Json::parse(text, nullptr, false);
    if (!json.is_object() || !json.contains(key) || !json.contains("wall_s") ||
        !json[key].is_number_unsigned() || !json["wall_s"].is_number())
        return {};
    const double wall_s = json["wall_s"].get<double>();
    return {json[key].get<size_t>(), std::isfinite(wall_s) && wall_s > 0 ? wall_s : 0};
}

}  // namespace

void keep_cost(const fs::path& folder, const ShardCost& cost) noexcept {
    write(cost_path(folder, cost.shard), {{"items", cost.items}, {"wall_s", cost.wall_s}});
}

std::vector<ShardCost> read_costs(const fs::path& folder, const Manifest& manifest) {
    std::vector<ShardCost> costs;
    for (int shard = 0; shard < manifest.shards(); ++shard)
        if (const auto [items, wall_s] = read(cost_path(folder, shard), "items");
            items > 0 && wall_s > 0)
            costs.push_back({shard, items, wall_s});
    return costs;
}

double seconds_of_this_process() {
    std::ifstream in("/proc/self/stat");
    const std::string text(std::istreambuf_iterator<char>(in), {});
    // The name of the program is in brackets and may hold anything; the 20th word behind it is the
    // start in ticks since the computer started (proc(5)).
    const size_t bracket = text.rfind(')');
    if (bracket == std::string::npos) return 0;
    std::istringstream words(text.substr(bracket + 1));
    std::string word;
    for (int i = 0; i < 20; ++i) words >> word;
    double ticks = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), ticks);
    timespec now{};
    if (error != std::errc() || ::clock_gettime(CLOCK_BOOTTIME, &now) != 0) return 0;
    const double start_s = ticks / static_cast<double>(::sysconf(_SC_CLK_TCK));
    return std::max(
        0.0, static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec) - start_s);
}

void keep_run_cost(const fs::path& folder, const RunCost& cost) noexcept {
    write(folder / "times" / "run.json", {{"workers", cost.workers}, {"wall_s", cost.wall_s}});
}

std::optional<RunCost> read_run_cost(const fs::path& folder) {
    const auto [workers, wall_s] = read(folder / "times" / "run.json", "workers");
    if (workers == 0 || workers > 1'000'000 || wall_s == 0) return std::nullopt;
    return RunCost{static_cast<int>(workers), wall_s};
}

}  // namespace placode::batches
