// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl bench scaling: cost, memory and building time against the number of tetrahedra.

#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>

#include "bench/machine.h"
#include "bench/scaling.h"
#include "reports/report.h"
#include "ui/cli/cli.h"
#include "ui/cli/write_file.h"

namespace placode::cli {
namespace {

using bench::ScalingRow;

struct ScalingOptions {
    bool quick = false;
    std::string out, task = "diathermy_ring";
};

Json to_json(const ScalingRow& row) {
    return {{"case", row.case_name},
            {"method", row.method},
            {"vertices", row.vertices},
            {"tets", row.tets},
            {"build_s", row.build_s},
            {"bytes_per_tet", row.bytes_a_tet},
            {"substeps_per_s", row.per_second},
            {"ns_per_tet", row.ns_a_tet()}};
}

void draw(const std::string& path, const std::vector<ScalingRow>& rows) {
    reports::CurveChart chart;
    chart.title = "Cost of a substep, one thread";
    chart.x_label = "tetrahedra";
    chart.y_label = "ns a tetrahedron and substep";
    chart.log_y = false;
    for (const char* method : {"vbd", "xpbd"}) {
        reports::Curve curve;
        curve.name = method;
        for (const ScalingRow& row : rows) {
            if (row.case_name != "slab" || row.method != method) continue;
            curve.x.push_back(row.tets);
            curve.y.push_back(row.ns_a_tet());
        }
        chart.curves.push_back(curve);
    }
    reports::write_chart_png(chart, path);
}

void write_files(const std::string& folder, const Json& json, const std::vector<ScalingRow>& rows) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    std::ofstream csv(folder + "/bench_scaling.csv");
    csv << "case,method,vertices,tets,build_s,bytes_per_tet,substeps_per_s,ns_per_tet\n";
    for (const ScalingRow& row : rows)
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

int run(const Context& context, const ScalingOptions& options) {
    need_writable_folder("--out", options.out);
    Json json{{"benchmark", "scaling"}, {"quick", options.quick}, {"machine", machine()}};
    const std::vector<ScalingRow> rows =
        bench::measure_scaling(options.task, options.quick, [](const ScalingRow& row) {
            std::cerr << row.case_name << ", " << row.method << ", " << row.tets
                      << " tets: " << fixed(row.ns_a_tet(), 2) << " ns a tet and substep, "
                      << fixed(row.bytes_a_tet, 0) << " bytes a tet, built in "
                      << fixed(row.build_s, 2) << " s\n";
        });
    json["rows"] = Json::array();
    std::vector<std::vector<std::string>> cells{
        {"case", "method", "tets", "substeps/s", "ns a tet", "bytes a tet", "built in [s]"}};
    for (const ScalingRow& row : rows) {
        json["rows"].push_back(to_json(row));
        cells.push_back({row.case_name, row.method, std::to_string(row.tets),
                         fixed(row.per_second, 0), fixed(row.ns_a_tet(), 2),
                         fixed(row.bytes_a_tet, 0), fixed(row.build_s, 2)});
    }
    json["exponent"] = {{"vbd", bench::exponent(rows, "vbd")},
                        {"xpbd", bench::exponent(rows, "xpbd")}};
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
    auto options = std::make_shared<ScalingOptions>();
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
