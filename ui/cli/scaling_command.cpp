// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl bench scaling: cost, memory and building time against the number of tetrahedra, from
// 3,000 to 640,000, and of the default operative field. One thread, wall clock.

#include <malloc.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <optional>

#include "curriculum/task.h"
#include "reports/report.h"
#include "sim/anatomy/operative_field.h"
#include "sim/step/step.h"
#include "ui/cli/bench_timing.h"

namespace placode::cli {
namespace {

using Clock = std::chrono::steady_clock;

struct Options {
    bool quick = false;
    std::string out, task = "diathermy_ring";
};

struct Row {
    std::string case_name, method;
    int vertices = 0, tets = 0;
    double build_s = 0, bytes_a_tet = 0, per_second = 0;

    [[nodiscard]] double ns_a_tet() const { return 1e9 / (per_second * tets); }
};

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Bytes that the program holds on the heap, mapped blocks included.
double heap_bytes() {
    const auto info = mallinfo2();
    return static_cast<double>(info.uordblks + info.hblkhd);
}

Row measure_slab(sim::Method method, const std::array<int, 3>& cells, const Plan& plan) {
    Row row{"slab", method_name(method)};
    const double before = heap_bytes();
    const auto start = Clock::now();
    const sim::SoftBody body = slab(method, cells);
    sim::SoftBodyState state(body);
    row.build_s = seconds_since(start);
    row.vertices = body.vertex_count();
    row.tets = body.tet_count();
    row.bytes_a_tet = (heap_bytes() - before) / row.tets;
    sim::Workers workers(1);
    // Every size does the same number of tet passes, but at least four substeps a run.
    Plan scaled = plan;
    scaled.substeps = std::max(4, static_cast<int>(plan.substeps * 43200.0 / row.tets));
    row.per_second =
        measure_rates(scaled, [&](int n) { sim::run_substeps(body, state, n, workers); }).median;
    return row;
}

/// The whole scene: body, surface, heat, contact, progress; hands off.
Row measure_field(const std::string& task, const Plan& plan) {
    const auto spec = curriculum::load_task(task).scene;
    const double before = heap_bytes();
    const auto start = Clock::now();
    const auto scene = sim::build_operative_field(spec);
    sim::State state(*scene, 1);
    Row row{"field of " + task + ", whole frame", method_name(scene->body.spec().solver.method)};
    row.build_s = seconds_since(start);
    row.vertices = scene->body.vertex_count();
    row.tets = scene->body.tet_count();
    row.bytes_a_tet = (heap_bytes() - before) / row.tets;
    const std::vector<sim::ToolInput> inputs(scene->tools.size());
    std::vector<sim::ToolFeedback> feedback(inputs.size());
    row.per_second = measure_rates(plan, [&](int n) {
                         for (int done = 0; done < n; done += state.substeps)
                             sim::step(*scene, state, inputs, feedback);
                     }).median;
    return row;
}

std::vector<Row> measure(const Options& options) {
    const Plan plan = options.quick ? Plan{3, 50} : Plan{9, 200};
    // Slabs of 4, 5, 8, 12 and 20 layers; the last has 640,000 tets.
    std::vector<std::array<int, 3>> sizes{{16, 8, 4}, {36, 20, 5}, {45, 20, 8}, {70, 30, 12}};
    if (!options.quick) sizes.push_back({107, 50, 20});
    std::vector<Row> rows;
    const auto add = [&](Row row) {
        std::cerr << row.case_name << ", " << row.method << ", " << row.tets
                  << " tets: " << fixed(row.ns_a_tet(), 2) << " ns a tet and substep, "
                  << fixed(row.bytes_a_tet, 0) << " bytes a tet, built in " << fixed(row.build_s, 2)
                  << " s\n";
        rows.push_back(std::move(row));
    };
    for (const sim::Method method : {sim::Method::kVbd, sim::Method::kXpbd})
        for (const auto& cells : sizes) add(measure_slab(method, cells, plan));
    add(measure_field(options.task, plan));
    return rows;
}

/// Cost of a substep ~ N^exponent over the slabs.
double exponent(const std::vector<Row>& rows, const std::string& method) {
    std::vector<double> tets, cost;
    for (const Row& row : rows) {
        if (row.case_name != "slab" || row.method != method) continue;
        tets.push_back(row.tets);
        cost.push_back(1 / row.per_second);
    }
    return log_slope(tets, cost);
}

Json to_json(const Row& row) {
    return {{"case", row.case_name},
            {"method", row.method},
            {"vertices", row.vertices},
            {"tets", row.tets},
            {"build_s", row.build_s},
            {"bytes_per_tet", row.bytes_a_tet},
            {"substeps_per_s", row.per_second},
            {"ns_per_tet", row.ns_a_tet()}};
}

void draw(const std::string& path, const std::vector<Row>& rows) {
    reports::CurveChart chart;
    chart.title = "Cost of a substep, one thread";
    chart.x_label = "tetrahedra";
    chart.y_label = "ns a tetrahedron and substep";
    chart.log_y = false;
    for (const char* method : {"vbd", "xpbd"}) {
        reports::Curve curve;
        curve.name = method;
        for (const Row& row : rows) {
            if (row.case_name != "slab" || row.method != method) continue;
            curve.x.push_back(row.tets);
            curve.y.push_back(row.ns_a_tet());
        }
        chart.curves.push_back(curve);
    }
    reports::write_chart_png(chart, path);
}

void write_files(const std::string& folder, const Json& json, const std::vector<Row>& rows) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    std::ofstream csv(folder + "/bench_scaling.csv");
    csv << "case,method,vertices,tets,build_s,bytes_per_tet,substeps_per_s,ns_per_tet\n";
    for (const Row& row : rows)
        csv << '"' << row.case_name << "\"," << row.method << ',' << row.vertices << ',' << row.tets
            << ',' << fixed(row.build_s, 4) << ',' << fixed(row.bytes_a_tet, 1) << ','
            << fixed(row.per_second, 2) << ',' << fixed(row.ns_a_tet(), 3) << '\n';
    std::ofstream document(folder + "/bench_scaling.json");
    document << json.dump(2) << '\n';
    csv.flush();
    document.flush();
    if (!csv || !document)
        throw InputError("--out " + folder + ": cannot be written; choose another place");
    draw(folder + "/bench_scaling.png", rows);
}

int run(const Context& context, const Options& options) {
    Json json{{"benchmark", "scaling"}, {"quick", options.quick}, {"machine", machine()}};
    const std::vector<Row> rows = measure(options);
    json["rows"] = Json::array();
    std::vector<std::vector<std::string>> cells{
        {"case", "method", "tets", "substeps/s", "ns a tet", "bytes a tet", "built in [s]"}};
    for (const Row& row : rows) {
        json["rows"].push_back(to_json(row));
        cells.push_back({row.case_name, row.method, std::to_string(row.tets),
                         fixed(row.per_second, 0), fixed(row.ns_a_tet(), 2),
                         fixed(row.bytes_a_tet, 0), fixed(row.build_s, 2)});
    }
    json["exponent"] = {{"vbd", exponent(rows, "vbd")}, {"xpbd", exponent(rows, "xpbd")}};
    if (!options.out.empty()) write_files(options.out, json, rows);
    warn_if_busy(json["machine"]);
    print(context, json,
          table(cells) + "Cost of a substep grows with tets^" +
              fixed(json["exponent"]["vbd"].get<double>(), 3) + " (vbd) and ^" +
              fixed(json["exponent"]["xpbd"].get<double>(), 3) +
              " (xpbd). One thread, median; bytes: what body and state hold on the heap, of the "
              "field everything that an attempt simulates; kernels " +
              sim::kernel_target());
    return 0;
}

}  // namespace

void add_scaling_command(CLI::App& bench, Context& context) {
    auto options = std::make_shared<Options>();
    CLI::App* command = bench.add_subcommand(
        "scaling", "Cost, memory and building time from 3,000 to 640,000 tetrahedra");
    command->add_flag("--quick", options->quick, "Up to 151,200 tetrahedra, fewer runs");
    command->add_option("--out", options->out, "Folder for bench_scaling.csv, .json and .png");
    command->add_option("--task", options->task, "Task whose field is measured")
        ->capture_default_str();
    command->callback([&context, options] {
        context.run = [&context, options] { return run(context, *options); };
    });
}

}  // namespace placode::cli
