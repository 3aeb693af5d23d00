// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl bench stability: hard cases for every method, each with a verdict.

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>

#include "bench/hard_cases.h"
#include "bench/stability_report.h"
#include "sim/verify/stability_cases.h"
#include "ui/cli/write_file.h"
#include "ui/finite_range.h"

namespace placode::cli {
namespace {

// What the full length means: ten minutes at rest, a million frames of random pokes.
constexpr int64_t kFullPokes = 1'000'000, kUsualPokes = 50'000, kQuickPokes = 2'000;
constexpr double kFullRest = 600, kUsualRest = 30, kQuickRest = 2;

struct StabilityCommandOptions {
    bool quick = false, full = false;
    std::string out, only, report;
    int64_t poke_frames = 0;  // 0 = as the length says
    double rest_s = 0;

    [[nodiscard]] int64_t pokes() const {
        if (poke_frames > 0) return poke_frames;
        return quick ? kQuickPokes : full ? kFullPokes : kUsualPokes;
    }
    [[nodiscard]] double rest() const {
        if (rest_s > 0) return rest_s;
        return quick ? kQuickRest : full ? kFullRest : kUsualRest;
    }
};

/// What was run, and what the full length would be.
std::string length_text(const StabilityCommandOptions& options) {
    const std::string text = std::to_string(options.pokes()) + " frames of random pokes, " +
                             shortest(options.rest()) + " s at rest";
    if (options.pokes() >= kFullPokes && options.rest() >= kFullRest) return text + ": full length";
    return text + ": shortened; --full runs " + std::to_string(kFullPokes) + " frames and " +
           shortest(kFullRest) + " s";
}

/// Every case that was asked for, with every method. @throws InputError for an unknown one.
std::vector<sim::StabilityResult> run_cases(const StabilityCommandOptions& options,
                                            const sim::StabilityOptions& cases) {
    const auto names = sim::stability_case_names(), in_tasks = bench::hard_case_names();
    auto every = names;
    every.insert(every.end(), in_tasks.begin(), in_tasks.end());
    if (!options.only.empty() &&
        std::find(every.begin(), every.end(), options.only) == every.end()) {
        std::string known;
        for (const std::string& name : every) known += (known.empty() ? "" : ", ") + name;
        throw InputError("--case " + options.only + ": no such case; one of: " + known);
    }
    std::vector<sim::StabilityResult> results;
    const auto keep = [&](sim::StabilityResult result) {
        std::cerr << result.name << ", " << result.method << ": "
                  << sim::verdict_name(result.verdict) << '\n';
        results.push_back(std::move(result));
    };
    const auto wanted = [&](const std::string& name) {
        return options.only.empty() || name == options.only;
    };
    for (const std::string& name : names)
        for (const sim::Method method :
             {sim::Method::kVbd, sim::Method::kXpbd, sim::Method::kXpbdPair})
            if (wanted(name)) keep(sim::run_stability_case(name, method, cases));
    for (const std::string& name : in_tasks)
        if (wanted(name)) keep(bench::run_hard_case(name, cases));
    return results;
}

int run(const Context& context, const StabilityCommandOptions& options) {
    need_writable_folder("--out", options.out);
    need_writable_file("--report", options.report);
    const auto start = std::chrono::steady_clock::now();
    sim::StabilityOptions cases;
    cases.seconds = options.quick ? 1 : 4;
    cases.rest_seconds = options.rest();
    cases.poke_frames = options.pokes();
    cases.progress = [](const std::string& text) { std::cerr << text << '\n'; };
    Json json{{"benchmark", "stability"},
              {"machine", machine()},
              {"seconds_a_case", cases.seconds},
              {"seconds_at_rest", cases.rest_seconds},
              {"poke_frames", cases.poke_frames},
              {"length", length_text(options)},
              {"rows", Json::array()}};
    bench::StabilityRun measured{bench::this_machine(), length_text(options), 0, 0};
    const auto results = run_cases(options, cases);
    std::vector<std::vector<std::string>> cells{{"case", "method", "verdict", "after", "detail"}};
    for (const sim::StabilityResult& r : results) {
        const std::string verdict = sim::verdict_name(r.verdict);
        measured.failed += r.verdict == sim::StabilityVerdict::kFails;
        json["rows"].push_back({{"case", r.name},
                                {"method", r.method},
                                {"verdict", verdict},
                                {"seconds", r.seconds},
                                {"error", r.error},
                                {"detail", r.detail}});
        cells.push_back({r.name, r.method, verdict, bench::recovery_text(r), r.detail});
    }
    measured.wall_s =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    json["failed"] = measured.failed;
    json["wall_s"] = measured.wall_s;
    if (!options.out.empty()) {
        std::error_code error;
        std::filesystem::create_directories(options.out, error);
        write_file(options.out + "/bench_stability.csv", bench::stability_csv(results));
        write_file(options.out + "/bench_stability.json", json.dump(2) + "\n");
    }
    if (!options.report.empty())
        write_file(options.report, bench::stability_report(results, measured));
    print(context, json,
          table(cells) + std::to_string(measured.failed) + " failed (" + measured.length + ")\n");
    return measured.failed == 0 ? 0 : 1;
}

}  // namespace

void add_stability_command(CLI::App& bench, Context& context) {
    auto options = std::make_shared<StabilityCommandOptions>();
    CLI::App* command = bench.add_subcommand(
        "stability", "Hard cases for every method: holds, recovers in t, or refused with a reason");
    CLI::Option* quick = command->add_flag("--quick", options->quick,
                                           "Shorter cases, 2 s at rest, 2,000 random pokes");
    command
        ->add_flag("--full", options->full,
                   "Full length: 600 s at rest and 1,000,000 frames of random pokes for every "
                   "method (without it 30 s and 50,000)")
        ->excludes(quick);
    command->add_option("--report", options->report,
                        "Writes the verdicts to this file (sim/verify/STABILITY.md)");
    command->add_option("--out", options->out,
                        "Folder for bench_stability.csv and bench_stability.json");
    command->add_option("--case", options->only, "One case only");
    command->add_option("--poke-frames", options->poke_frames, "Frames of random pokes instead")
        ->check(CLI::Range(int64_t{1}, int64_t{1'000'000'000}));
    command->add_option("--rest-seconds", options->rest_s, "Seconds of the case at rest instead")
        ->check(ui::finite_range(0.1, 1e5));
    command->callback([&context, options] {
        context.run = [&context, options] { return run(context, *options); };
    });
}

}  // namespace placode::cli
