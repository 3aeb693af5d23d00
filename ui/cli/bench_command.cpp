// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl bench speed; the load of the machine is written down with the figures.

#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>

#include "bench/machine.h"
#include "bench/speed.h"
#include "ui/cli/batch.h"
#include "ui/cli/solver_commands.h"
#include "ui/cli/write_file.h"

namespace placode::cli {
namespace {

struct BenchOptions {
    bool quick = false;
    std::string out;
    std::string task = "diathermy_ring";
};

}  // namespace

Json machine() {
    const bench::Machine machine = bench::this_machine();
    return {{"processor", machine.processor},
            {"logical_cores", machine.logical_cores},
            {"system", machine.system},
            {"compiler", machine.compiler},
            {"build", machine.build},
            {"kernel_target", machine.kernel_target},
            {"load_average_1min_before", machine.load_average_1min}};
}

void warn_if_busy(const Json& machine) {
    const double busy = machine["load_average_1min_before"].get<double>();
    if (busy > 0.5)
        std::cerr << "placodectl: other programs were running (load " << fixed(busy, 1)
                  << "): the figures are too low; measure again on an idle machine\n";
}

namespace {

void write_files(const std::string& folder, const Json& json,
                 const std::vector<bench::SpeedRow>& rows) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    std::ofstream csv(folder + "/bench_speed.csv");
    csv << "case,method,vertices,tets,threads,substeps_per_frame,substeps_per_s,slowest_per_s,"
           "fastest_per_s,kernel_target\n";
    for (const bench::SpeedRow& row : rows)
        csv << '"' << row.case_name << "\"," << row.method << ',' << row.vertices << ',' << row.tets
            << ',' << row.threads << ',' << row.substeps_a_frame << ',' << fixed(row.per_second, 1)
            << ',' << fixed(row.slowest, 1) << ',' << fixed(row.fastest, 1) << ','
            << sim::kernel_target() << '\n';
    std::ofstream document(folder + "/bench_speed.json");
    document << json.dump(2) << '\n';
    csv.flush();
    document.flush();
    if (!csv || !document)
        throw InputError("--out " + folder + ": cannot be written; choose another place");
}

int speed(const Context& context, const BenchOptions& options) {
    need_writable_folder("--out", options.out);
    const bench::Plan plan = options.quick ? bench::Plan{3, 400} : bench::Plan{};
    Json json{{"benchmark", "speed"},
              {"machine", machine()},
              {"runs", plan.runs},
              {"substeps_a_run", plan.substeps}};
    const auto [build_s, rows] =
        bench::measure_speed(options.task, plan, [](const bench::SpeedRow& row) {
            std::cerr << row.case_name << ", " << row.method << ", " << row.threads
                      << " thread(s): " << fixed(row.per_second, 0) << " substeps/s\n";
        });
    json["field_build_s"] = build_s;
    json["rows"] = Json::array();
    std::vector<std::vector<std::string>> cells{
        {"case", "method", "tets", "threads", "substeps/s", "slowest", "fastest", "x real time"}};
    for (const bench::SpeedRow& row : rows) {
        const double real_time = row.per_second / (1000.0 * row.substeps_a_frame);
        json["rows"].push_back({{"case", row.case_name},
                                {"method", row.method},
                                {"vertices", row.vertices},
                                {"tets", row.tets},
                                {"threads", row.threads},
                                {"substeps_per_frame", row.substeps_a_frame},
                                {"substeps_per_s", row.per_second},
                                {"slowest_per_s", row.slowest},
                                {"fastest_per_s", row.fastest},
                                {"real_time_factor", real_time}});
        cells.push_back({row.case_name, row.method, std::to_string(row.tets),
                         std::to_string(row.threads), fixed(row.per_second, 0),
                         fixed(row.slowest, 0), fixed(row.fastest, 0), fixed(real_time, 2)});
    }
    if (!options.out.empty()) write_files(options.out, json, rows);
    const Json& at = json["machine"];
    warn_if_busy(at);
    print(context, json,
          table(cells) + at["processor"].get<std::string>() + ", " +
              std::to_string(at["logical_cores"].get<int>()) + " logical cores, kernels " +
              at["kernel_target"].get<std::string>() + ", " + at["compiler"].get<std::string>() +
              ", load before " + fixed(at["load_average_1min_before"].get<double>(), 2) +
              "; field built in " + fixed(build_s, 2) + " s; median of " +
              std::to_string(plan.runs) + " runs of " + std::to_string(plan.substeps) +
              " substeps; x real time: of frames of 1 ms");
    return 0;
}

}  // namespace

void add_bench_commands(CLI::App& app, Context& context) {
    auto options = std::make_shared<BenchOptions>();
    CLI::App* bench = app.add_subcommand("bench", "Measures on this machine");
    bench->require_subcommand(1);
    CLI::App* command = bench->add_subcommand(
        "speed", "Substeps a second of the default field and of a slab of 43,200 tetrahedra");
    command->add_flag("--quick", options->quick, "Fewer and shorter runs");
    command->add_option("--out", options->out, "Folder for bench_speed.csv and bench_speed.json");
    command->add_option("--task", options->task, "Task whose field is measured")
        ->capture_default_str();
    command->callback([&context, options] {
        context.run = [&context, options] { return speed(context, *options); };
    });
    add_accuracy_command(*bench, context);
    add_closed_forms_command(*bench, context);
    add_contact_bench_command(*bench, context);
    add_scaling_command(*bench, context);
    add_cuts_command(*bench, context);
    add_picture_bench_command(*bench, context);
    add_stability_command(*bench, context);
    add_haptics_bench_command(*bench, context);
    add_store_bench_command(*bench, context);
    add_environment_command(*bench, context);
    add_bench_tasks_command(*bench, context);
}

}  // namespace placode::cli
