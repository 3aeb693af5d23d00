// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl bench accuracy: the error of every method, as CSV, JSON, figures and a report in
// Markdown that says what is accurate, what is not, and which method a scene should choose.

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>

#include "reports/report.h"
#include "sim/verify/accuracy.h"
#include "ui/cli/solver_commands.h"

namespace placode::cli {
namespace {

namespace fs = std::filesystem;
using sim::AccuracyRow;

constexpr const char* kWhyMissed =
    "\nWhy they are missed, as far as it is known: above Courant number 0.45 `xpbd` sweeps in one "
    "direction only, and between 0.2 and 0.45 turning leaves a little; `xpbd_pair` loads both of "
    "its constraints at rest; below 0.1 ms positions are rounded away (the 48-bit rows beside them "
    "meet the same targets); without the rigid modes, which those rows have, an implicit step "
    "loses angular momentum in proportion to h, and one sweep of `vbd` momentum as well; a sphere "
    "that is pressed into a stiff block in steps of 0.5 ms creeps.\n";

/// CPU seconds of one core for a simulated second that two cores have: 1.9 times as fast as one.
constexpr double kAffordable = 1.9;

struct Options {
    bool quick = false, field = false;
    std::string out, report, only;
};

/// Four significant digits.
std::string digits(double value) {
    std::array<char, 40> text{};
    const auto [end, error] =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 4);
    return error == std::errc{} ? std::string(text.data(), end) : "-";
}

std::string percent(double error) { return digits(100 * error); }

std::string verdict(const AccuracyRow& row) {
    return row.target <= 0 ? "" : row.error <= row.target ? "met" : "MISSED";
}

Json to_json(const AccuracyRow& row) {
    return {{"study", row.study},       {"setting", row.setting},
            {"method", row.method},     {"quantity", row.quantity},
            {"unit", row.unit},         {"h_s", row.h_s},
            {"edge_m", row.edge_m},     {"tets", row.tets},
            {"courant", row.courant},   {"value", row.value},
            {"expected", row.expected}, {"error", row.error},
            {"target", row.target},     {"cpu_s_per_simulated_s", row.cost}};
}

void write_text(const fs::path& path, const std::string& text) {
    std::ofstream out(path, std::ios::binary);
    out << text;
    out.flush();
    if (!out) throw InputError(path.string() + ": cannot be written; choose another place");
}

std::string csv_of(const std::vector<AccuracyRow>& rows) {
    std::string text =
        "study,setting,method,quantity,unit,h_s,edge_m,tets,courant,value,expected,error,target,"
        "cpu_s_per_simulated_s\n";
    for (const AccuracyRow& r : rows) {
        text += '"' + r.study + "\",\"" + r.setting + "\"," + r.method + ",\"" + r.quantity +
                "\"," + r.unit + ',' + shortest(r.h_s) + ',' + shortest(r.edge_m) + ',' +
                std::to_string(r.tets) + ',' + shortest(r.courant) + ',' + shortest(r.value) + ',' +
                shortest(r.expected) + ',' + shortest(r.error) + ',' + shortest(r.target) + ',' +
                shortest(r.cost) + '\n';
    }
    return text;
}

/// One curve per method (and mesh) of a study.
std::vector<reports::Curve> curves(const std::vector<AccuracyRow>& rows, const std::string& study,
                                   bool over_cost) {
    std::map<std::string, reports::Curve> found;
    std::vector<std::string> order;
    for (const AccuracyRow& row : rows) {
        if (row.study != study || !(row.h_s > 0) ||
            (study == "operative field" && row.quantity.find("reaction") == 0))
            continue;
        std::string name = row.method;
        if (study == "operative field" || study == "fast drives") name += ", " + row.setting;
        if (study.rfind("cantilever", 0) == 0)
            name += ", " + fixed(row.edge_m * 1e3, 0) + " mm" +
                    (row.setting.find("0.49") != std::string::npos ? ", nu 0.49" : "");
        if (found.find(name) == found.end()) order.push_back(name);
        reports::Curve& curve = found[name];
        curve.name = name;
        curve.x.push_back(over_cost ? row.cost * 1e9 / row.tets : row.h_s * 1e3);
        curve.y.push_back(100 * row.error);
    }
    std::vector<reports::Curve> out;
    for (const std::string& name : order) out.push_back(found[name]);
    return out;
}

struct Figure {
    std::string file, caption;
};

std::vector<Figure> write_figures(const std::vector<AccuracyRow>& rows, const fs::path& folder) {
    std::vector<Figure> out;
    const auto add = [&](reports::CurveChart chart, const std::string& file) {
        if (std::all_of(chart.curves.begin(), chart.curves.end(),
                        [](const auto& c) { return c.x.empty(); }))
            return;
        reports::write_chart_png(chart, (folder / file).string());
        out.push_back({file, chart.title});
    };
    const std::pair<const char*, const char*> studies[]{{"cantilever, static", "static"},
                                                        {"cantilever, dynamic", "dynamic"},
                                                        {"operative field", "field"},
                                                        {"fast drives", "drives"}};
    for (const auto& [study, name] : studies) {
        for (const bool cost : {false, true}) {
            reports::CurveChart chart;
            chart.title =
                std::string(study) + (cost ? ": error against cost" : ": error against h");
            chart.x_label = cost ? "CPU time per tet and simulated second [ns]" : "substep h [ms]";
            chart.y_label = "error [%]";
            chart.curves = curves(rows, study, cost);
            add(chart, std::string("accuracy_") + name + (cost ? "_cost.png" : "_h.png"));
        }
    }
    reports::CurveChart mesh;
    mesh.title = "mesh convergence: tip deflection of a bent beam (newton)";
    mesh.x_label = "mesh edge [mm]";
    mesh.y_label = "deflection over Timoshenko's";
    mesh.log_y = false;
    mesh.curves = {{"linear Kuhn tets, nu 0.45", {}, {}}, {"expected for this split", {}, {}}};
    for (const AccuracyRow& row : rows) {
        if (row.study != "mesh convergence") continue;
        for (auto& curve : mesh.curves) curve.x.push_back(row.edge_m * 1e3);
        mesh.curves[0].y.push_back(row.value);
        mesh.curves[1].y.push_back(row.expected);
    }
    add(mesh, "accuracy_mesh.png");
    return out;
}

std::string row_text(const AccuracyRow& row) {
    return "| " + row.setting + " | " + row.method + " | " +
           (row.h_s > 0 ? shortest(std::stod(fixed(row.h_s * 1e3, 5))) : "-") + " | " +
           (row.courant > 0 ? fixed(row.courant, 2) : "-") + " | " + row.quantity + " | " +
           digits(row.value) + " | " + digits(row.expected) + ' ' + row.unit + " | " +
           (row.study == "order of convergence" ? "-" : percent(row.error)) + " | " +
           (row.target > 0 ? percent(row.target) : "-") + " | " + verdict(row) + " | " +
           (row.cost > 0 ? fixed(row.cost, 3) : "-") + " |\n";
}

/// Largest error of the rows that fit, in %; "-" without any.
template <class Fits>
std::string worst(const std::vector<AccuracyRow>& rows, Fits&& fits) {
    double most = -1;
    for (const AccuracyRow& row : rows) {
        if (fits(row)) most = std::max(most, row.error);
    }
    return most < 0 ? "-" : percent(most) + " %";
}

/// What two cores buy on the beam of 1 mm (24,000 tets): the least error, in %.
std::string affordable(const std::vector<AccuracyRow>& rows, const std::string& study,
                       const std::string& method, const char* material) {
    const AccuracyRow* best = nullptr;
    for (const AccuracyRow& row : rows) {
        if (row.study != study || row.method != method || row.edge_m > 1.1e-3 ||
            row.cost > kAffordable || row.setting.find(material) == std::string::npos)
            continue;
        if (best == nullptr || row.error < best->error) best = &row;
    }
    return best == nullptr ? "-"
                           : percent(best->error) + " %" + " (" + fixed(best->h_s * 1e3, 3) +
                                 " ms, " + fixed(best->cost, 2) + " core seconds a second)";
}

/// Sentences whose numbers are those of this run.
std::string conclusions(const std::vector<AccuracyRow>& rows) {
    const auto of = [&](const std::string& study, const std::string& method, double low,
                        double high) {
        return worst(rows, [&](const AccuracyRow& r) {
            return r.study == study && r.method == method && r.courant >= low && r.courant < high &&
                   r.quantity.find("decay") == std::string::npos;
        });
    };
    std::string text;
    const auto line = [&](const std::string& s) { text += "- " + s + "\n"; };
    line("`newton` is the truth here: at most " +
         worst(rows,
               [](const AccuracyRow& r) {
                   return r.study == "homogeneous states" && r.method == "newton";
               }) +
         " off the closed forms of homogeneous states.");
    line("`vbd` at rest: at most " + of("cantilever, static", "vbd", 0, 1.2) +
         " on the cantilever up to Courant number 1.2, at most " +
         of("cantilever, static", "vbd", 1.2, 100) + " above; in motion at most " +
         of("cantilever, dynamic", "vbd", 0, 0.6) + " below 0.6 and " +
         of("cantilever, dynamic", "vbd", 0.6, 100) +
         " above: its fixed point is the equilibrium, what it loses is speed.");
    line("`vbd` on the operative field, settled: at most " + of("operative field", "vbd", 0, 1e9) +
         " in displacement and reaction over all substeps tried.");
    line("`xpbd` at rest: at most " + of("cantilever, static", "xpbd", 0, 0.35) +
         " up to Courant number 0.35, " + of("cantilever, static", "xpbd", 0.35, 0.7) +
         " up to 0.7, " + of("cantilever, static", "xpbd", 0.7, 100) + " above; in motion " +
         of("cantilever, dynamic", "xpbd", 0, 0.35) + ", " +
         of("cantilever, dynamic", "xpbd", 0.35, 0.7) + " and " +
         of("cantilever, dynamic", "xpbd", 0.7, 100) + ".");
    line("`xpbd` in homogeneous states: at most " + of("homogeneous states", "xpbd", 0, 0.2) +
         " up to Courant number 0.2, " + of("homogeneous states", "xpbd", 0.2, 0.45) +
         " up to 0.45, " + of("homogeneous states", "xpbd", 0.45, 100) +
         " above, where it does not sweep there and back in turns.");
    line("Beam of 1 mm (24,000 tets) for at most " + fixed(kAffordable, 1) +
         " core seconds a second, two cores in real time: nu 0.45 with `xpbd` at rest " +
         affordable(rows, "cantilever, static", "xpbd", "nu 0.45") + ", in motion " +
         affordable(rows, "cantilever, dynamic", "xpbd", "nu 0.45") +
         "; nu 0.49 with `vbd` at rest " +
         affordable(rows, "cantilever, static", "vbd", "nu 0.49") + ".");
    line("`xpbd_pair` at rest: at most " + of("cantilever, static", "xpbd_pair", 0, 0.35) +
         " up to Courant number 0.35 and " + of("cantilever, static", "xpbd_pair", 0.35, 100) +
         " above: it is kept to compare.");
    line("`explicit` below its limit: at most " + of("cantilever, dynamic", "explicit", 0, 10) +
         " in motion.");
    return text;
}

std::string report_of(const std::vector<AccuracyRow>& rows, const std::vector<Figure>& figures,
                      const Json& machine, const std::string& figure_folder, bool quick, bool field,
                      double wall_s) {
    std::string text =
        "<!-- Written by `placodectl bench accuracy`; run it again instead of editing. -->\n"
        "# Accuracy of the tissue solvers\n\n";
    text +=
        "Measured with `placodectl bench accuracy" + std::string(quick ? " --quick" : "") +
        (field ? " --field" : "") + "` on " + machine["processor"].get<std::string>() + " (" +
        std::to_string(machine["logical_cores"].get<int>()) + " logical cores), " +
        machine["system"].get<std::string>() + ", " + machine["compiler"].get<std::string>() +
        ", " + machine["build"].get<std::string>() + ", kernels " +
        machine["kernel_target"].get<std::string>() + ", load before " +
        fixed(machine["load_average_1min_before"].get<double>(), 1) + ", " + fixed(wall_s, 0) +
        " s. One thread. Cost is CPU time of one core for one simulated second; with a load "
        "above 1 caches and the clock were shared with other programs, so that costs are upper "
        "bounds. Errors do not depend on the load. Positions are rounded to floats as in the "
        "simulator, except where the method is called 48-bit: there, as in `placodectl solve`, "
        "they carry what rounding takes off, the rigid modes of what nothing holds are solved, and "
        "what is left is the method's own error.\n\n";
    text += "## What is accurate, and what is not\n\n" + conclusions(rows);
    int missed = 0;
    std::string list;
    for (const AccuracyRow& row : rows) {
        if (verdict(row) != "MISSED") continue;
        ++missed;
        list += "- " + row.study + ", " + row.setting + ", " + row.method +
                (row.h_s > 0 ? " at " + shortest(std::stod(fixed(row.h_s * 1e3, 5))) + " ms" : "") +
                ": " + row.quantity + ": " + percent(row.error) + " % (target " +
                percent(row.target) + " %)\n";
    }
    text += "\nTargets missed: " + std::to_string(missed) + "\n" + list;
    if (missed > 0) text += kWhyMissed;
    text +=
        "\n## Which method a scene should choose\n\n"
        "| scene | method | why |\n|---|---|---|\n"
        "| thin stiff layers, Courant number above 0.7 anywhere (the default operative field) | "
        "`vbd`, 4 substeps a 1 ms frame or more | exact at rest at any step; fast motion is damped "
        "with the Courant number |\n"
        "| one soft material, edges of about 1 mm, Courant number below 0.5 (the `paper` preset) | "
        "`xpbd` | livelier in motion than vbd at the same step |\n"
        "| a step below the CFL limit | `explicit` | nothing is more accurate at that cost |\n"
        "| equilibrium only | `newton` | exact on the given mesh |\n\n"
        "Linear tets lock in bending: compare a solver with `newton` on the same mesh, and choose "
        "the mesh by the table of mesh convergence.\n";
    if (!figures.empty()) text += "\n## Figures\n\n";
    for (const Figure& figure : figures)
        text += "![" + figure.caption + "](" + figure_folder + figure.file + ")\n\n";
    text += "## All numbers\n";
    std::string study;
    for (const AccuracyRow& row : rows) {
        if (row.study != study) {
            study = row.study;
            text += "\n### " + study +
                    "\n\n| setting | method | h [ms] | Courant | quantity | value | expected | "
                    "error [%] | target [%] | | CPU s / s |\n|---|---|---|---|---|---|---|---|---|-"
                    "--|---|\n";
        }
        text += row_text(row);
    }
    return text;
}

int accuracy(const Context& context, const Options& options) {
    const auto start = std::chrono::steady_clock::now();
    Json json{{"benchmark", "accuracy"}, {"quick", options.quick}, {"machine", machine()}};
    for (const std::string& folder :
         {options.out, fs::path(options.report).parent_path().string()}) {
        std::error_code error;
        if (!folder.empty() && !fs::create_directories(folder, error) && error)
            throw InputError(folder + ": cannot be made; choose another place");
    }
    sim::AccuracyOptions measured;
    measured.quick = options.quick;
    measured.field = options.field || !options.quick;
    measured.only = options.only;
    measured.progress = [](const AccuracyRow& row) {
        std::cerr << row.study << ", " << row.setting << ", " << row.method << ", h "
                  << fixed(row.h_s * 1e3, 4) << " ms: " << row.quantity << ": "
                  << percent(row.error) << " %\n";
    };
    std::vector<AccuracyRow> rows = sim::measure_accuracy(measured);
    std::map<std::string, size_t> first;  // studies in the order in which they were begun
    for (const AccuracyRow& row : rows) first.emplace(row.study, first.size());
    std::stable_sort(rows.begin(), rows.end(), [&](const auto& a, const auto& b) {
        return first.at(a.study) < first.at(b.study);
    });
    const double wall =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    json["wall_s"] = wall;
    json["rows"] = Json::array();
    std::vector<std::vector<std::string>> cells{
        {"study", "setting", "method", "h [ms]", "error [%]", "target [%]", ""}};
    for (const AccuracyRow& row : rows) {
        json["rows"].push_back(to_json(row));
        cells.push_back({row.study, row.setting, row.method, fixed(row.h_s * 1e3, 4),
                         percent(row.error), row.target > 0 ? percent(row.target) : "-",
                         verdict(row)});
    }
    std::vector<Figure> figures;
    if (!options.out.empty()) {
        const fs::path out = options.out;
        figures = write_figures(rows, out);
        write_text(out / "bench_accuracy.csv", csv_of(rows));
        write_text(out / "bench_accuracy.json", json.dump(2) + "\n");
        write_text(out / "REPORT.md", report_of(rows, figures, json["machine"], "", options.quick,
                                                options.field, wall));
    }
    if (!options.report.empty()) {
        // Figures stand in figures/ beside the report.
        const fs::path folder = fs::path(options.report).parent_path() / "figures";
        std::error_code error;
        fs::create_directories(folder, error);
        figures = write_figures(rows, folder);
        write_text(options.report, report_of(rows, figures, json["machine"], "figures/",
                                             options.quick, options.field, wall));
    }
    print(context, json, table(cells));
    return 0;
}

}  // namespace

void add_accuracy_command(CLI::App& bench, Context& context) {
    auto options = std::make_shared<Options>();
    CLI::App* command = bench.add_subcommand(
        "accuracy", "Error of every method against closed forms and double-precision references");
    command->add_flag("--quick", options->quick, "Small meshes only, without the operative field");
    command->add_option(
        "--out", options->out,
        "Folder for bench_accuracy.csv, bench_accuracy.json, REPORT.md and figures");
    command->add_option("--only", options->only, "One group of cases")
        ->check(CLI::IsMember(sim::accuracy_groups()));
    command->add_option("--report", options->report,
                        "Writes the report to this file (sim/verify/REPORT.md), figures beside it");
    command->callback([&context, options] {
        context.run = [&context, options] { return accuracy(context, *options); };
    });
}

}  // namespace placode::cli
