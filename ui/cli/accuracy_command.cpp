// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl bench accuracy: the error of every method, as CSV, JSON, figures and a report; bench
// closed-forms: contact, heat and thread beside closed forms, as figures and a page.

#include <algorithm>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>

#include "bench/accuracy_report.h"
#include "bench/closed_forms.h"
#include "curriculum/utc_time.h"
#include "sim/verify/accuracy.h"
#include "ui/cli/solver_commands.h"
#include "ui/cli/write_file.h"

namespace placode::cli {
namespace {

namespace fs = std::filesystem;
using sim::AccuracyRow;

struct AccuracyCommandOptions {
    bool quick = false, field = false;
    std::string out, report, only;
};

Json to_json(const AccuracyRow& row) {
    return {{"study", row.study},       {"setting", row.setting},
            {"method", row.method},     {"quantity", row.quantity},
            {"unit", row.unit},         {"h_s", row.h_s},
            {"edge_m", row.edge_m},     {"tets", row.tets},
            {"courant", row.courant},   {"value", row.value},
            {"expected", row.expected}, {"error", row.error},
            {"target", row.target},     {"cpu_s_per_simulated_s", row.cost}};
}

int accuracy(const Context& context, const AccuracyCommandOptions& options) {
    need_writable_folder("--out", options.out);
    need_writable_file("--report", options.report);
    const auto start = std::chrono::steady_clock::now();
    Json json{{"benchmark", "accuracy"}, {"quick", options.quick}, {"machine", machine()}};
    bench::AccuracyRun measured_on{bench::this_machine(), options.quick, options.field, 0};
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
                  << bench::accuracy_percent(row.error) << " %\n";
    };
    std::vector<AccuracyRow> rows = sim::measure_accuracy(measured);
    std::map<std::string, size_t> first;  // studies in the order in which they were begun
    for (const AccuracyRow& row : rows) first.emplace(row.study, first.size());
    std::stable_sort(rows.begin(), rows.end(), [&](const auto& a, const auto& b) {
        return first.at(a.study) < first.at(b.study);
    });
    const double wall =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    measured_on.wall_s = wall;
    json["wall_s"] = wall;
    json["rows"] = Json::array();
    std::vector<std::vector<std::string>> cells{
        {"study", "setting", "method", "h [ms]", "error [%]", "target [%]", ""}};
    for (const AccuracyRow& row : rows) {
        json["rows"].push_back(to_json(row));
        cells.push_back({row.study, row.setting, row.method, fixed(row.h_s * 1e3, 4),
                         bench::accuracy_percent(row.error),
                         row.target > 0 ? bench::accuracy_percent(row.target) : "-",
                         bench::accuracy_verdict(row)});
    }
    std::vector<bench::Figure> figures;
    if (!options.out.empty()) {
        const fs::path out = options.out;
        figures = bench::write_accuracy_figures(rows, out);
        write_file(out / "bench_accuracy.csv", bench::accuracy_csv(rows));
        write_file(out / "bench_accuracy.json", json.dump(2) + "\n");
        write_file(out / "REPORT.md", bench::accuracy_report(rows, figures, measured_on, ""));
    }
    if (!options.report.empty()) {
        // Figures stand in figures/ beside the report.
        const fs::path folder = fs::path(options.report).parent_path() / "figures";
        std::error_code error;
        fs::create_directories(folder, error);
        figures = bench::write_accuracy_figures(rows, folder);
        write_file(options.report, bench::accuracy_report(rows, figures, measured_on, "figures/"));
    }
    print(context, json, table(cells));
    return 0;
}

/// Figures and a page for docs/measurements.
int closed_forms(const Context& context, const std::string& folder) {
    need_writable_folder("--out", folder);
    const fs::path out = folder;
    std::error_code error;
    if (!folder.empty() && !fs::create_directories(out, error) && error)
        throw InputError("--out " + folder + ": cannot be made; choose another place");
    Json json{{"benchmark", "closed-forms"}, {"machine", machine()}, {"rows", Json::array()}};
    std::vector<std::vector<std::string>> cells{{"case", "series", "against", "difference [%]"}};
    std::vector<bench::ClosedFormFigure> figures;
    for (int which = 0; which < 3; ++which) {
        figures.push_back(which == 0   ? bench::contact_closed_forms()
                          : which == 1 ? bench::heat_closed_forms()
                                       : bench::thread_closed_forms());
        const bench::ClosedFormFigure& figure = figures.back();
        std::cerr << figure.title << '\n';
        for (const bench::ClosedFormPanel& panel : figure.panels)
            for (const bench::ClosedFormSeries& series : panel.series) {
                json["rows"].push_back({{"figure", figure.name},
                                        {"case", panel.title},
                                        {"series", series.name},
                                        {"against", panel.exact_name},
                                        {"measure", panel.measure},
                                        {"error", series.error},
                                        {"target", panel.target}});
                cells.push_back(
                    {panel.title, series.name, panel.exact_name, fixed(100 * series.error, 3)});
            }
        if (!folder.empty())
            write_file(out / (figure.name + ".svg"), bench::closed_form_svg(figure));
    }
    if (!folder.empty())
        write_file(out / "closed_forms.md",
                   bench::closed_form_page(figures, bench::this_machine(),
                                           curriculum::utc_day(std::time(nullptr))));
    print(context, json, table(cells));
    return 0;
}

}  // namespace

void add_accuracy_command(CLI::App& bench, Context& context) {
    auto options = std::make_shared<AccuracyCommandOptions>();
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

void add_closed_forms_command(CLI::App& bench, Context& context) {
    auto out = std::make_shared<std::string>();
    CLI::App* command = bench.add_subcommand(
        "closed-forms", "Contact, heat and thread against closed forms, as figures and a table");
    command->add_option("--out", *out,
                        "Folder for contact.svg, heat.svg, thread.svg and closed_forms.md");
    command->callback(
        [&context, out] { context.run = [&context, out] { return closed_forms(context, *out); }; });
}

}  // namespace placode::cli
