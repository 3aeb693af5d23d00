// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl bench stability: hard cases for every method, each with a verdict.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>

#include "sim/verify/stability_cases.h"
#include "ui/cli/cli.h"

namespace placode::cli {
namespace {

struct Options {
    bool quick = false;
    std::string out, only;
    int64_t poke_frames = 1'000'000;
    double rest_s = 600;
};

void write_files(const std::string& folder, const Json& json) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    std::ofstream csv(folder + "/bench_stability.csv");
    csv << "case,method,verdict,seconds,error,detail\n";
    for (const Json& row : json["rows"]) {
        std::string detail = row["detail"].get<std::string>();
        std::replace(detail.begin(), detail.end(), '"', '\'');
        csv << '"' << row["case"].get<std::string>() << "\"," << row["method"].get<std::string>()
            << ",\"" << row["verdict"].get<std::string>() << "\","
            << shortest(row["seconds"].get<double>()) << ',' << shortest(row["error"].get<double>())
            << ",\"" << detail << "\"\n";
    }
    std::ofstream document(folder + "/bench_stability.json");
    document << json.dump(2) << '\n';
    csv.flush();
    document.flush();
    if (!csv || !document)
        throw InputError("--out " + folder + ": cannot be written; choose another place");
}

int run(const Context& context, const Options& options) {
    sim::StabilityOptions cases;
    cases.seconds = options.quick ? 1 : 4;
    cases.rest_seconds = options.quick ? 2 : options.rest_s;
    cases.poke_frames = options.quick ? 2000 : options.poke_frames;
    cases.progress = [](const std::string& text) { std::cerr << text << '\n'; };
    const auto names = sim::stability_case_names();
    if (!options.only.empty() &&
        std::find(names.begin(), names.end(), options.only) == names.end()) {
        std::string known;
        for (const std::string& name : names) known += (known.empty() ? "" : ", ") + name;
        throw InputError("--case " + options.only + ": no such case; one of: " + known);
    }
    Json json{{"benchmark", "stability"},         {"machine", machine()},
              {"seconds_a_case", cases.seconds},  {"seconds_at_rest", cases.rest_seconds},
              {"poke_frames", cases.poke_frames}, {"rows", Json::array()}};
    std::vector<std::vector<std::string>> cells{{"case", "method", "verdict", "after", "detail"}};
    int failed = 0;
    for (const std::string& name : names) {
        if (!options.only.empty() && name != options.only) continue;
        for (const sim::Method method :
             {sim::Method::kVbd, sim::Method::kXpbd, sim::Method::kXpbdPair}) {
            const sim::StabilityResult r = sim::run_stability_case(name, method, cases);
            const std::string verdict = sim::verdict_name(r.verdict);
            const bool back = r.verdict == sim::StabilityVerdict::kRecovers ||
                              r.verdict == sim::StabilityVerdict::kReseeded;
            failed += r.verdict == sim::StabilityVerdict::kFails;
            std::cerr << name << ", " << r.method << ": " << verdict << '\n';
            json["rows"].push_back({{"case", r.name},
                                    {"method", r.method},
                                    {"verdict", verdict},
                                    {"seconds", r.seconds},
                                    {"error", r.error},
                                    {"detail", r.detail}});
            cells.push_back(
                {r.name, r.method, verdict, back ? fixed(r.seconds, 2) + " s" : "", r.detail});
        }
    }
    json["failed"] = failed;
    if (!options.out.empty()) write_files(options.out, json);
    print(context, json, table(cells) + std::to_string(failed) + " failed\n");
    return failed == 0 ? 0 : 1;
}

}  // namespace

void add_stability_command(CLI::App& bench, Context& context) {
    auto options = std::make_shared<Options>();
    CLI::App* command = bench.add_subcommand(
        "stability", "Hard cases for every method: holds, recovers in t, or refused with a reason");
    command->add_flag("--quick", options->quick, "Shorter cases, 2 s at rest, 2,000 random pokes");
    command->add_option("--out", options->out,
                        "Folder for bench_stability.csv and bench_stability.json");
    command->add_option("--case", options->only, "One case only");
    command->add_option("--poke-frames", options->poke_frames, "Frames of random pokes")
        ->capture_default_str()
        ->check(CLI::Range(int64_t{1}, int64_t{1'000'000'000}));
    command->add_option("--rest-seconds", options->rest_s, "Simulated time of the case at rest")
        ->capture_default_str()
        ->check(CLI::Range(0.1, 1e5));
    command->callback([&context, options] {
        context.run = [&context, options] { return run(context, *options); };
    });
}

}  // namespace placode::cli
