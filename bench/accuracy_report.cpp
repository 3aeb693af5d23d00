// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/accuracy_report.h"

#include <algorithm>

#include "sim/core/number_text.h"

namespace placode::bench {

using sim::AccuracyRow;

namespace {

constexpr const char* kWhyMissed =
    "\nWhy they are missed, as far as it is known: above Courant number 0.45 `xpbd` sweeps in one "
    "direction only, and between 0.2 and 0.45 turning leaves a little; `xpbd_pair` loads both of "
    "its constraints at rest; below 0.1 ms positions are rounded away (the 48-bit rows beside them "
    "meet the same targets); without the rigid modes, which those rows have, an implicit step "
    "loses angular momentum in proportion to h, and one sweep of `vbd` momentum as well; a sphere "
    "that is pressed into a stiff block in steps of 0.5 ms creeps.\n";

/// CPU seconds of one core for a simulated second that two cores have: 1.9 times as fast as one.
constexpr double kAffordable = 1.9;

std::string digits(double value) { return sim::rounded_text(value, 4); }

/// Milliseconds to five places, without zeros at the end.
std::string step_ms(const AccuracyRow& row) {
    return sim::shortest_text(std::stod(sim::fixed_text(row.h_s * 1e3, 5)));
}

std::string row_text(const AccuracyRow& row) {
    return "| " + row.setting + " | " + row.method + " | " + (row.h_s > 0 ? step_ms(row) : "-") +
           " | " + (row.courant > 0 ? sim::fixed_text(row.courant, 2) : "-") + " | " +
           row.quantity + " | " + digits(row.value) + " | " + digits(row.expected) + ' ' +
           row.unit + " | " +
           (row.study == "order of convergence" ? "-" : accuracy_percent(row.error)) + " | " +
           (row.target > 0 ? accuracy_percent(row.target) : "-") + " | " + accuracy_verdict(row) +
           " | " + (row.cost > 0 ? sim::fixed_text(row.cost, 3) : "-") + " |\n";
}

/// Largest error of the rows that fit, in %; "-" without any.
template <class Fits>
std::string worst(const std::vector<AccuracyRow>& rows, Fits&& fits) {
    double most = -1;
    for (const AccuracyRow& row : rows) {
        if (fits(row)) most = std::max(most, row.error);
    }
    return most < 0 ? "-" : accuracy_percent(most) + " %";
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
    return best == nullptr
               ? "-"
               : accuracy_percent(best->error) + " %" + " (" + sim::fixed_text(best->h_s * 1e3, 3) +
                     " ms, " + sim::fixed_text(best->cost, 2) + " core seconds a second)";
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
    line("Beam of 1 mm (24,000 tets) for at most " + sim::fixed_text(kAffordable, 1) +
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

/// Both errors of one run: of where its vertices are, and of the force that holds it.
struct Pair {
    const AccuracyRow* place = nullptr;
    const AccuracyRow* force = nullptr;
};

std::vector<Pair> pairs_of(const std::vector<AccuracyRow>& rows) {
    std::vector<Pair> out;
    for (const AccuracyRow& force : rows) {
        if (force.quantity.rfind("reaction", 0) != 0) continue;
        for (const AccuracyRow& place : rows) {
            if (place.quantity.rfind("displacement", 0) == 0 && place.study == force.study &&
                place.setting == force.setting && place.method == force.method &&
                place.h_s == force.h_s)
                out.push_back({&place, &force});
        }
    }
    return out;
}

/// What both errors may differ by, and below what an error of forces is no matter.
constexpr double kMuchLess = 3, kSmallForceError = 5e-3;

/// The headline's sentence on reactions, and a warning where they are worse than places.
std::string reactions(const std::vector<AccuracyRow>& rows) {
    std::string all, worse;
    std::vector<std::string> methods;
    const std::vector<Pair> pairs = pairs_of(rows);
    for (const Pair& p : pairs) {
        const AccuracyRow& r = *p.place;
        if (std::find(methods.begin(), methods.end(), r.method) == methods.end())
            methods.push_back(r.method);
        if (p.force->error > kMuchLess * r.error && p.force->error > kSmallForceError)
            worse += std::string(worse.empty() ? "" : "; ") + r.study + ", `" + r.method + "` at " +
                     step_ms(r) + " ms: " + accuracy_percent(r.error) + " % of displacement, " +
                     accuracy_percent(p.force->error) + " % of reaction";
    }
    for (const std::string& method : methods) {
        double place = 0, force = 0;
        for (const Pair& p : pairs) {
            if (p.place->method != method) continue;
            place = std::max(place, p.place->error);
            force = std::max(force, p.force->error);
        }
        all += std::string(all.empty() ? "" : ", ") + "`" + method + "` " +
               accuracy_percent(place) + " and " + accuracy_percent(force) + " %";
    }
    if (all.empty()) return "";
    return "- Displacement and reaction of the same runs, at most (twisted bar, operative "
           "field): " +
           all + ".\n" +
           (worse.empty()
                ? ""
                : "- **Warning: these reactions are more than " + sim::rounded_text(kMuchLess, 2) +
                      " times as far off as the displacements** (a force is made of "
                      "strains, and a method with compliant constraints reaches them "
                      "last): " +
                      worse + ". Take forces from `vbd` or from shorter steps.\n");
}

}  // namespace

std::string accuracy_percent(double error) { return digits(100 * error); }

std::string accuracy_verdict(const AccuracyRow& row) {
    return row.target <= 0 ? "" : row.error <= row.target ? "met" : "MISSED";
}

std::string accuracy_csv(const std::vector<AccuracyRow>& rows) {
    std::string text =
        "study,setting,method,quantity,unit,h_s,edge_m,tets,courant,value,expected,error,target,"
        "cpu_s_per_simulated_s\n";
    for (const AccuracyRow& r : rows) {
        text += '"' + r.study + "\",\"" + r.setting + "\"," + r.method + ",\"" + r.quantity +
                "\"," + r.unit + ',' + sim::shortest_text(r.h_s) + ',' +
                sim::shortest_text(r.edge_m) + ',' + std::to_string(r.tets) + ',' +
                sim::shortest_text(r.courant) + ',' + sim::shortest_text(r.value) + ',' +
                sim::shortest_text(r.expected) + ',' + sim::shortest_text(r.error) + ',' +
                sim::shortest_text(r.target) + ',' + sim::shortest_text(r.cost) + '\n';
    }
    return text;
}

namespace {

std::string how_measured(const AccuracyRun& run) {
    const Machine& machine = run.machine;
    return "Measured with `placodectl bench accuracy" + std::string(run.quick ? " --quick" : "") +
           (run.field ? " --field" : "") + "` on " + machine.processor + " (" +
           std::to_string(machine.logical_cores) + " logical cores), " + machine.system + ", " +
           machine.compiler + ", " + machine.build + ", kernels " + machine.kernel_target +
           ", load before " + sim::fixed_text(machine.load_average_1min, 1) + ", " +
           sim::fixed_text(run.wall_s, 0) +
           " s. One thread. Cost is CPU time of one core for one simulated second; with a load "
           "above 1 caches and the clock were shared with other programs, so that costs are upper "
           "bounds. Errors do not depend on the load. Positions are rounded to floats as in the "
           "simulator, except where the method is called 48-bit: there, as in `placodectl solve`, "
           "they carry what rounding takes off, the rigid modes of what nothing holds are solved, "
           "and what is left is the method's own error.\n\n";
}

std::string missed_targets(const std::vector<AccuracyRow>& rows) {
    int missed = 0;
    std::string list;
    for (const AccuracyRow& row : rows) {
        if (accuracy_verdict(row) != "MISSED") continue;
        ++missed;
        list += "- " + row.study + ", " + row.setting + ", " + row.method +
                (row.h_s > 0 ? " at " + step_ms(row) + " ms" : "") + ": " + row.quantity + ": " +
                accuracy_percent(row.error) + " % (target " + accuracy_percent(row.target) +
                " %)\n";
    }
    list = "\nTargets missed: " + std::to_string(missed) + "\n" + list;
    return missed > 0 ? list + kWhyMissed : list;
}

std::string all_numbers(const std::vector<AccuracyRow>& rows) {
    std::string text = "## All numbers\n";
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

}  // namespace

std::string accuracy_report(const std::vector<AccuracyRow>& rows,
                            const std::vector<Figure>& figures, const AccuracyRun& run,
                            const std::string& figure_folder) {
    std::string text =
        "<!-- Written by `placodectl bench accuracy`; run it again instead of editing. -->\n"
        "# Accuracy of the tissue solvers\n\n";
    text += how_measured(run);
    text += "## What is accurate, and what is not\n\n" + conclusions(rows) + reactions(rows);
    text += missed_targets(rows);
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
    text += all_numbers(rows);
    return text;
}

}  // namespace placode::bench
