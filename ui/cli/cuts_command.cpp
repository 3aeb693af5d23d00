// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl bench cuts: how smooth the rim of a cut is, and what that costs.

#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>

#include "bench/cuts.h"
#include "bench/machine.h"
#include "curriculum/task.h"
#include "ui/cli/cli.h"
#include "ui/cli/write_file.h"

namespace placode::cli {
namespace {

using bench::CutRow;

struct CutsOptions {
    std::string task = "sb_dissection", out;
    int snips = 24;
};

Json to_json(const CutRow& row) {
    return {{"cut_snap", row.snap},
            {"snips", row.snips},
            {"rim_rms_mm", row.rms_mm},
            {"rim_max_mm", row.max_mm},
            {"length_over_path", row.length_over_path},
            {"least_quality", row.least_quality},
            {"slides", row.slides},
            {"refused", row.refused},
            {"frame_us", row.frame_us},
            {"worst_frame_us", row.worst_us},
            {"energy_jump", row.energy_jump}};
}

int run(const Context& context, const CutsOptions& options) {
    if (options.snips < 1 || options.snips > 1000)
        throw InputError("--snips " + std::to_string(options.snips) + ": expected 1 to 1000");
    need_writable_folder("--out", options.out);
    const auto spec = curriculum::load_task(options.task).scene;
    Json json{{"benchmark", "cuts"}, {"task", options.task}, {"machine", machine()}};
    json["rows"] = Json::array();
    std::vector<std::vector<std::string>> cells{{"cut_snap", "rim rms [mm]", "max [mm]",
                                                 "length / path", "least quality", "slides",
                                                 "us a frame", "worst", "energy jump [%]"}};
    for (const double snap : {0.0, 0.35, 0.5, 0.65, 0.75}) {
        std::cerr << "cut_snap " << fixed(snap, 2) << ": " << options.snips << " snips ...\n";
        const CutRow row = bench::measure_cuts(spec, snap, options.snips);
        json["rows"].push_back(to_json(row));
        cells.push_back({fixed(snap, 2), fixed(row.rms_mm, 4), fixed(row.max_mm, 3),
                         fixed(row.length_over_path, 3), fixed(row.least_quality, 3),
                         std::to_string(row.slides), fixed(row.frame_us, 0), fixed(row.worst_us, 0),
                         fixed(100 * row.energy_jump, 3)});
    }
    if (!options.out.empty()) {
        std::error_code error;
        std::filesystem::create_directories(options.out, error);
        std::ofstream document(options.out + "/bench_cuts.json");
        document << json.dump(2) << '\n';
        document.flush();
        if (!document)
            throw InputError("--out " + options.out + ": cannot be written; choose another place");
    }
    warn_if_busy(json["machine"]);
    print(context, json,
          table(cells) + std::to_string(options.snips) +
              " snips of 6 mm along the planned incision, each in an untouched field of " +
              options.task + ". One thread; us: the slides of a frame, alone.");
    return 0;
}

}  // namespace

void add_cuts_command(CLI::App& bench, Context& context) {
    auto options = std::make_shared<CutsOptions>();
    CLI::App* command = bench.add_subcommand(
        "cuts", "How smooth the rim of a cut is, what that costs, and what is left of the mesh");
    command->add_option("--task", options->task, "Task whose field is cut")->capture_default_str();
    command->add_option("--snips", options->snips, "Snips for each setting")->capture_default_str();
    command->add_option("--out", options->out, "Folder for bench_cuts.json");
    command->callback([&context, options] {
        context.run = [&context, options] { return run(context, *options); };
    });
}

}  // namespace placode::cli
