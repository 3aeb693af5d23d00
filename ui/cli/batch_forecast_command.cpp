// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl batch forecast: time and cost of a larger batch, from the shards of one that was run.

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "batches/forecast.h"
#include "sim/core/counted.h"
#include "sim/core/number_text.h"
#include "ui/cli/batch.h"
#include "ui/finite_range.h"

namespace placode::cli {
namespace {

struct BatchForecastOptions {
    std::string folder;
    int64_t items = 0;  ///< 0 = as many as this batch has.
    int shard_size = 0;
    std::vector<int> workers{1, 8, 64, 512};
    double lost_percent = 0, price = 0;
};

std::string duration(double seconds) {
    if (seconds < 120) return sim::fixed_text(seconds, 1) + " s";
    if (seconds < 2 * 3600) return sim::fixed_text(seconds / 60, 1) + " min";
    if (seconds < 72 * 3600) return sim::fixed_text(seconds / 3600, 1) + " h";
    return sim::fixed_text(seconds / 86400, 1) + " days";
}

batches::Forecast forecast_of(const batches::ForecastOrder& order) {
    try {
        return batches::forecast(order);
    } catch (const std::invalid_argument& error) {
        throw InputError(std::string("batch forecast: ") + error.what());
    }
}

/// The queue against this batch itself, where it was run in one go.
std::string checked(const BatchForecastOptions& options, const batches::Manifest& manifest,
                    batches::ForecastOrder order, Json& json) {
    const auto measured = batches::read_run_cost(options.folder);
    if (!measured || order.measured.size() != static_cast<size_t>(manifest.shards())) return {};
    order.items = std::ssize(manifest.items);
    order.shard_size = manifest.shard_size;
    order.workers = measured->workers;
    order.lost_share = 0;
    const batches::Forecast found = forecast_of(order);
    json["check"] = {{"workers", measured->workers},
                     {"measured_s", measured->wall_s},
                     {"forecast_s", found.mean_s}};
    return "this batch took " + duration(measured->wall_s) + " with " +
           sim::counted(measured->workers, "worker") + "; forecast " + duration(found.mean_s) +
           "\n";
}

int run(const Context& context, const BatchForecastOptions& options) {
    const batches::Manifest manifest = batches::read_manifest(options.folder);
    batches::ForecastOrder order;
    order.measured = batches::read_costs(options.folder, manifest);
    if (order.measured.empty())
        throw InputError(options.folder +
                         ": no shard was done and timed here yet; expected a batch of which "
                         "`placodectl batch run` has done some shards");
    order.items = options.items > 0 ? options.items : std::ssize(manifest.items);
    order.shard_size = options.shard_size > 0 ? options.shard_size : manifest.shard_size;
    order.lost_share = options.lost_percent / 100;
    Json json{{"batch", manifest.seal},
              {"kind", manifest.kind},
              {"measured_shards", order.measured.size()},
              {"items", order.items},
              {"shard_size", order.shard_size},
              {"lost_percent", options.lost_percent},
              {"workers", Json::array()}};
    std::vector<std::vector<std::string>> rows{
        {"workers", "time", "5 % to 95 %", "worker-hours", options.price > 0 ? "price" : ""}};
    for (const int workers : options.workers) {
        order.workers = workers;
        const batches::Forecast found = forecast_of(order);
        const double hours = found.worker_s / 3600;
        json["workers"].push_back({{"workers", workers},
                                   {"mean_s", found.mean_s},
                                   {"low_s", found.low_s},
                                   {"high_s", found.high_s},
                                   {"worker_hours", hours},
                                   {"price", hours * options.price}});
        rows.push_back({std::to_string(workers), duration(found.mean_s),
                        duration(found.low_s) + " to " + duration(found.high_s),
                        sim::fixed_text(hours, 1),
                        options.price > 0 ? sim::fixed_text(hours * options.price, 2) : ""});
    }
    const std::string check = checked(options, manifest, order, json);
    print(context, json,
          check + sim::counted(order.items, "item") + " in shards of " +
              std::to_string(order.shard_size) + ", from " +
              sim::counted(order.measured.size(), "measured shard") + "\n" + table(rows));
    return 0;
}

}  // namespace

void add_batch_forecast_command(CLI::App& batch, Context& context) {
    auto options = std::make_shared<BatchForecastOptions>();
    CLI::App* command = batch.add_subcommand(
        "forecast", "Time and cost of a larger batch, from the shards that were done in this one");
    command->add_option("FOLDER", options->folder, "Of a batch that was run, whole or in part")
        ->required();
    command->add_option("--items", options->items, "Of the larger batch (default: of this one)")
        ->check(CLI::Range(int64_t{1}, int64_t{1'000'000'000}));
    command->add_option("--shard-size", options->shard_size, "Default: as in this batch")
        ->check(CLI::Range(1, 1'000'000));
    command->add_option("--workers", options->workers, "How many at the same time, with commas")
        ->delimiter(',')
        ->check(CLI::Range(1, 1'000'000))
        ->capture_default_str();
    command
        ->add_option("--lost", options->lost_percent,
                     "Percent of the shards that are killed somewhere and begin anew")
        ->check(ui::finite_range(0.0, 90.0));
    command->add_option("--price", options->price, "Of a worker and hour")
        ->check(ui::finite_range(0.0, 1e6));
    command->callback([&context, options] {
        context.run = [&context, options] {
            return of_batch([&] { return run(context, *options); });
        };
    });
}

}  // namespace placode::cli
