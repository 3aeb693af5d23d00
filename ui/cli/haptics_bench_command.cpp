// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl bench haptics.

#include <iostream>
#include <memory>

#include "ui/cli/haptics_bench_report.h"
#include "ui/cli/solver_commands.h"
#include "ui/cli/write_file.h"

namespace placode::cli {
namespace {

struct HapticsBenchOptions {
    bool quick = false;
    std::string out;
};

int run(const Context& context, const HapticsBenchOptions& options) {
    need_writable_folder("--out", options.out);
    const Json computer = machine();  // the load before, not our own
    haptics::HapticBenchSuite bench;
    bench.quick = options.quick;
    bench.checked = [](const haptics::HapticBenchCheck& check) {
        if (!check.passed()) std::cerr << "not within its limit: " << check.name << '\n';
    };
    bench.run();
    Json json{{"benchmark", "haptics"}, {"machine", computer}};
    json.update(haptics_bench_json(bench));
    if (!options.out.empty()) write_haptics_bench(bench, json, options.out);
    print(context, json, haptics_bench_text(bench));
    return bench.passed() ? 0 : 1;
}

}  // namespace

void add_haptics_bench_command(CLI::App& bench, Context& context) {
    auto options = std::make_shared<HapticsBenchOptions>();
    CLI::App* command = bench.add_subcommand(
        "haptics", "Stability of the force law with a simulated operator, latency of the servo");
    command->add_flag("--quick", options->quick, "Fewer rates and laws, a shorter measurement");
    command->add_option("--out", options->out,
                        "Folder for bench_haptics.csv, .json, time lines and figures");
    command->callback([&context, options] {
        context.run = [&context, options] { return run(context, *options); };
    });
}

}  // namespace placode::cli
