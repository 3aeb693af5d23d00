// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl bench speed: substeps a second of the default field and of a plain slab, at one and
// two threads. Wall clock, median of several runs; the load of the machine is written down with it.

#include <sys/utsname.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <thread>

#include "curriculum/task.h"
#include "sim/anatomy/operative_field.h"
#include "sim/step/step.h"
#include "ui/cli/bench_timing.h"
#include "ui/cli/solver_commands.h"

namespace placode::cli {
namespace {

using Clock = std::chrono::steady_clock;

struct Options {
    bool quick = false;
    std::string out;
    std::string task = "diathermy_ring";
};

struct Row {
    std::string case_name, method;
    int vertices = 0, tets = 0, threads = 0, substeps_a_frame = 0;
    double per_second = 0, slowest = 0, fastest = 0;
};

/// The slab of the design's measurements: 43,200 tets.
constexpr std::array<int, 3> kSlabCells{60, 30, 4};

void fill(Row& row, const Rates& rates) {
    row.per_second = rates.median;
    row.slowest = rates.slowest;
    row.fastest = rates.fastest;
}

Row bench_slab(sim::Method method, int threads, const Plan& plan) {
    const sim::SoftBody body = slab(method, kSlabCells);
    sim::SoftBodyState state(body);
    sim::Workers workers(threads);
    Row row{"slab, solver only",
            method_name(method),
            body.vertex_count(),
            body.tet_count(),
            threads,
            8};
    fill(row, measure_rates(plan, [&](int n) { sim::run_substeps(body, state, n, workers); }));
    return row;
}

Row bench_field_body(const sim::Scene& scene, int threads, const Plan& plan) {
    sim::State state(scene, threads);
    Row row{"field, solver only",
            method_name(scene.body.spec().solver.method),
            scene.body.vertex_count(),
            scene.body.tet_count(),
            threads,
            state.substeps};
    fill(row, measure_rates(plan, [&](int n) {
             sim::run_substeps(scene.body, state.body, n, *state.workers);
         }));
    return row;
}

/// Tips at the planned contour, `depth_m` below the surface, each shaft through its trocar.
std::vector<sim::ToolInput> hands(const sim::Scene& scene, double depth_m) {
    std::vector<sim::ToolInput> inputs(scene.tools.size());
    for (size_t i = 0; i < inputs.size(); ++i) {
        const sim::ToolSpec& tool = scene.tools[i];
        if (tool.kind == sim::ToolKind::kScope || scene.geometry.planned_contour.empty()) continue;
        const sim::Vec3 target = scene.geometry.planned_contour.front() - sim::Vec3(0, 0, depth_m);
        const sim::Vec3 along = (target - tool.pivot_m).normalized();
        inputs[i].set_pose({target, sim::Quat::FromTwoVectors(sim::Vec3::UnitZ(), along)});
        inputs[i].engaged = 1;
    }
    return inputs;
}

Row bench_frames(const sim::Scene& scene, const std::string& name, double depth_m, int threads,
                 const Plan& plan) {
    sim::State state(scene, threads);
    const auto inputs = hands(scene, depth_m);
    std::vector<sim::ToolFeedback> feedback(inputs.size());
    Row row{name,
            method_name(scene.body.spec().solver.method),
            scene.body.vertex_count(),
            scene.body.tet_count(),
            threads,
            state.substeps};
    fill(row, measure_rates(plan, [&](int n) {
             for (int done = 0; done < n; done += state.substeps)
                 sim::step(scene, state, inputs, feedback);
         }));
    return row;
}

std::string processor() {
    std::ifstream in("/proc/cpuinfo");
    for (std::string line; std::getline(in, line);)
        if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
    return "unknown";
}

}  // namespace

Json machine() {
    double load[3]{};
    (void)getloadavg(load, 3);
    utsname name{};
    (void)uname(&name);
    return {{"processor", processor()},
            {"logical_cores", std::thread::hardware_concurrency()},
            {"system", std::string(name.sysname) + " " + name.release},
            {"compiler", "g++ " __VERSION__},
#ifdef NDEBUG
            {"build", "optimised"},
#else
            {"build", "with assertions"},
#endif
            {"kernel_target", sim::kernel_target()},
            {"load_average_1min_before", load[0]}};
}

namespace {

void write_files(const std::string& folder, const Json& json, const std::vector<Row>& rows) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    std::ofstream csv(folder + "/bench_speed.csv");
    csv << "case,method,vertices,tets,threads,substeps_per_frame,substeps_per_s,slowest_per_s,"
           "fastest_per_s,kernel_target\n";
    for (const Row& row : rows)
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

int speed(const Context& context, const Options& options) {
    const Plan plan = options.quick ? Plan{3, 400} : Plan{};
    Json json{{"benchmark", "speed"},
              {"machine", machine()},
              {"runs", plan.runs},
              {"substeps_a_run", plan.substeps}};
    const auto start = Clock::now();
    const auto scene = sim::build_operative_field(curriculum::load_task(options.task).scene);
    const double build_s = std::chrono::duration<double>(Clock::now() - start).count();
    json["field_build_s"] = build_s;
    std::vector<Row> rows;
    const auto add = [&](Row row) {
        std::cerr << row.case_name << ", " << row.method << ", " << row.threads
                  << " thread(s): " << fixed(row.per_second, 0) << " substeps/s\n";
        rows.push_back(std::move(row));
    };
    for (const int threads : {1, 2}) {
        add(bench_field_body(*scene, threads, plan));
        add(bench_frames(*scene, "field, whole frame, hands off", -0.01, threads, plan));
        add(bench_frames(*scene, "field, whole frame, needle 0.5 mm in", 0.0005, threads, plan));
        add(bench_slab(sim::Method::kVbd, threads, plan));
        add(bench_slab(sim::Method::kXpbd, threads, plan));
    }
    json["rows"] = Json::array();
    std::vector<std::vector<std::string>> cells{
        {"case", "method", "tets", "threads", "substeps/s", "slowest", "fastest", "x real time"}};
    for (const Row& row : rows) {
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
    auto options = std::make_shared<Options>();
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
    add_contact_bench_command(*bench, context);
    add_scaling_command(*bench, context);
    add_stability_command(*bench, context);
    add_haptics_bench_command(*bench, context);
    add_store_bench_command(*bench, context);
}

}  // namespace placode::cli
