// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Error of every method against the substep, and against its cost.

#include <algorithm>
#include <filesystem>
#include <map>

#include "bench/accuracy_report.h"
#include "reports/report.h"
#include "sim/core/number_text.h"

namespace placode::bench {

using sim::AccuracyRow;

namespace {

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
            name += ", " + sim::fixed_text(row.edge_m * 1e3, 0) + " mm" +
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

}  // namespace

std::vector<Figure> write_accuracy_figures(const std::vector<AccuracyRow>& rows,
                                           const std::filesystem::path& folder) {
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

}  // namespace placode::bench
