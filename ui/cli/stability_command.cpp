// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl bench stability: hard cases for every method, each with a verdict.

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>

#include "sim/verify/stability_cases.h"
#include "ui/cli/cli.h"

namespace placode::cli {
namespace {

// What the full length means: ten minutes at rest, a million frames of random pokes.
constexpr int64_t kFullPokes = 1'000'000, kUsualPokes = 50'000, kQuickPokes = 2'000;
constexpr double kFullRest = 600, kUsualRest = 30, kQuickRest = 2;

struct Options {
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
std::string length_text(const Options& options) {
    const std::string text = std::to_string(options.pokes()) + " frames of random pokes, " +
                             shortest(options.rest()) + " s at rest";
    if (options.pokes() >= kFullPokes && options.rest() >= kFullRest) return text + ": full length";
    return text + ": shortened; --full runs " + std::to_string(kFullPokes) + " frames and " +
           shortest(kFullRest) + " s";
}

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

void write_report(const std::string& file, const Json& json, const std::string& length) {
    const Json& m = json["machine"];
    std::string text =
        "<!-- Written by `placodectl bench stability --report`; run it again instead of editing. "
        "-->\n# Hard cases for the tissue solvers\n\nRun by `placodectl bench stability` on " +
        m["processor"].get<std::string>() + ", " + m["compiler"].get<std::string>() + ", " +
        m["build"].get<std::string>() + ", kernels " + m["kernel_target"].get<std::string>() +
        ", one thread. " + length +
        ".\n\nA block of 6 mm, 1,296 tets of 1 mm, 5 kPa, nu 0.45; `vbd` "
        "with 4 substeps a frame of 1 ms, `xpbd` and `xpbd_pair` with 8. Verdicts: holds (never "
        "left "
        "its bounds), recovers (edges within 2 % and nothing inverted, from then to the end), "
        "re-seeded "
        "(an event says so), refused at load (with the reason), FAILS.\n\n"
        "| case | method | verdict | after | detail |\n|---|---|---|---|---|\n";
    for (const Json& row : json["rows"]) {
        const std::string verdict = row["verdict"].get<std::string>();
        const bool back = verdict == "recovers" || verdict == "re-seeded";
        text += "| " + row["case"].get<std::string>() + " | `" + row["method"].get<std::string>() +
                "` | " + verdict + " | " +
                (back ? fixed(row["seconds"].get<double>(), 2) + " s" : "") + " | " +
                row["detail"].get<std::string>() + " |\n";
    }
    text += "\n" + std::to_string(json["failed"].get<int>()) + " failed. Simulated in " +
            fixed(json["wall_s"].get<double>() / 60, 1) + " minutes.\n";
    std::ofstream out(file, std::ios::binary);
    out << text;
    out.flush();
    if (!out) throw InputError("--report " + file + ": cannot be written; choose another place");
}

int run(const Context& context, const Options& options) {
    const auto start = std::chrono::steady_clock::now();
    sim::StabilityOptions cases;
    cases.seconds = options.quick ? 1 : 4;
    cases.rest_seconds = options.rest();
    cases.poke_frames = options.pokes();
    cases.progress = [](const std::string& text) { std::cerr << text << '\n'; };
    const auto names = sim::stability_case_names();
    if (!options.only.empty() &&
        std::find(names.begin(), names.end(), options.only) == names.end()) {
        std::string known;
        for (const std::string& name : names) known += (known.empty() ? "" : ", ") + name;
        throw InputError("--case " + options.only + ": no such case; one of: " + known);
    }
    Json json{{"benchmark", "stability"},
              {"machine", machine()},
              {"seconds_a_case", cases.seconds},
              {"seconds_at_rest", cases.rest_seconds},
              {"poke_frames", cases.poke_frames},
              {"length", length_text(options)},
              {"rows", Json::array()}};
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
    json["wall_s"] =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (!options.out.empty()) write_files(options.out, json);
    if (!options.report.empty()) write_report(options.report, json, length_text(options));
    print(context, json,
          table(cells) + std::to_string(failed) + " failed (" + length_text(options) + ")\n");
    return failed == 0 ? 0 : 1;
}

}  // namespace

void add_stability_command(CLI::App& bench, Context& context) {
    auto options = std::make_shared<Options>();
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
        ->check(CLI::Range(0.1, 1e5));
    command->callback([&context, options] {
        context.run = [&context, options] { return run(context, *options); };
    });
}

}  // namespace placode::cli
