// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Beams: static and moving cantilever against the reference on the same mesh, mesh convergence
// against Timoshenko, hanging bar, unit systems.
#include <cmath>

#include "sim/verify/accuracy_table.h"

namespace placode::sim {
namespace {

struct Choice {
    SolveMethod method;
    std::vector<int> substeps;
    bool double_float = false;
};

/// Whether any of these runs is wanted: without one nobody needs their reference.
bool any_wanted(const AccuracyTable& table, const char* study, VerificationScene scene,
                const std::vector<Choice>& choices) {
    for (const Choice& choice : choices)
        for (const int substeps : choice.substeps) {
            use_method(scene, {choice.method, substeps, choice.double_float});
            if (table.wants(study, scene)) return true;
        }
    return false;
}

/// 40 x 10 x 10 mm, 5 kPa; gravity so that the tip sinks by about 20 % of the length.
VerificationScene cantilever(double edge_m, double nu) {
    const int n = static_cast<int>(std::lround(0.01 / edge_m));
    VerificationScene scene = accuracy_scene(Vec3(0.04, 0.01, 0.01), {4 * n, n, n}, 5e3, nu);
    scene.gravity_m_s2 = Vec3(0, 0, -1.4);
    scene.held.push_back(held_plane(0, 0, 7));
    scene.probes.push_back({"tip", held_plane(0, 0.04, 7).box, "/probes/0"});
    return scene;
}

std::string setting(double edge_m, double nu) {
    return std::string("40 x 10 x 10 mm, 5 kPa, nu ") + (nu > 0.47 ? "0.49" : "0.45") + ", " +
           (edge_m > 1.5e-3 ? "2" : "1") + " mm";
}

void static_cantilever(AccuracyTable& table, double edge_m, double nu,
                       const std::vector<Choice>& choices) {
    constexpr const char* kStudy = "cantilever, static";
    VerificationScene scene = cantilever(edge_m, nu);
    if (!any_wanted(table, kStudy, scene, choices)) return;
    use_method(scene, {SolveMethod::kNewton, 1});
    const SolveResult reference = solve(scene);
    scene.material.damping_per_s = 30;  // about critical: at rest after 1.2 s
    scene.sample_s = 1;
    for (const Choice& choice : choices) {
        // vbd comes to rest late where the Courant number is large, nu 0.49 after 4 s.
        scene.end_s = choice.method == SolveMethod::kVbd ? 6.0 : 1.2;
        for (const int substeps : choice.substeps) {
            use_method(scene, {choice.method, substeps, choice.double_float});
            if (!table.wants(kStudy, scene)) continue;
            const SolveResult result = solve(scene);
            AccuracyRow row = row_of(scene, result, kStudy, setting(edge_m, nu),
                                     "displacement against newton on the same mesh (L2)", edge_m);
            set_text(row.unit, "m");
            row.value = result.probe_m.back()[0].z() - 0.005;
            row.expected = reference.probe_m.back()[0].z() - 0.005;
            row.error = displacement_error(scene, result, reference);
            row.target = nu > 0.47 ? 0.05 : choice.method == SolveMethod::kXpbd ? 0.02 : 0.0;
            table.add(row);
        }
    }
}

void moving_cantilever(AccuracyTable& table, double edge_m, int reference_substeps,
                       const std::vector<Choice>& choices) {
    constexpr const char* kStudy = "cantilever, dynamic";
    VerificationScene scene = cantilever(edge_m, 0.45);
    if (!any_wanted(table, kStudy, scene, choices)) return;
    scene.end_s = 0.4;
    use_method(scene, {SolveMethod::kExplicit, reference_substeps});
    const SolveResult reference = solve(scene);
    for (const Choice& choice : choices) {
        std::vector<AccuracyRow> rows;
        for (const int substeps : choice.substeps) {
            use_method(scene, {choice.method, substeps, choice.double_float});
            if (!table.wants(kStudy, scene)) continue;
            const SolveResult result = solve(scene);
            double off = 0, size = 0;
            for (size_t i = 0; i < result.probe_m.size() && i < reference.probe_m.size(); ++i) {
                off += (result.probe_m[i][0] - reference.probe_m[i][0]).squaredNorm();
                size += (reference.probe_m[i][0] - reference.probe_m[0][0]).squaredNorm();
            }
            AccuracyRow row =
                row_of(scene, result, kStudy, setting(edge_m, 0.45),
                       "tip's path against explicit in double precision (RMS)", edge_m);
            row.error = std::sqrt(off / size);
            row.value = row.error;
            row.target = choice.method == SolveMethod::kXpbd ? 0.03 : 0.0;
            table.add(row);
            rows.push_back(row);
        }
        if (rows.size() < 2) continue;
        AccuracyRow order = rows.back();
        set_text(order.study, "order of convergence");
        set_text(order.quantity, "slope of log(error) over log(h), dynamic cantilever");
        order.value = convergence_order(rows);
        order.error = order.cost = order.h_s = order.target = 0;
        table.add(order);
    }
}

/// Locking of linear tets: ratio to Timoshenko at 20 mm length, 4 x 4 mm, 50 kPa, tip load 0.1 mN.
void mesh_convergence(AccuracyTable& table) {
    constexpr double kExpected[]{0.129, 0.306, 0.588, 0.819};
    const double timoshenko = 0.25847e-3;
    const int most = table.quick() ? 3 : 4;
    for (int i = 0; i < most; ++i) {
        const int layers = 1 << i;
        const double edge = 4e-3 / layers;
        VerificationScene scene =
            accuracy_scene(Vec3(0.02, 4e-3, 4e-3), {5 * layers, layers, layers}, 50e3, 0.45);
        scene.held.push_back(held_plane(0, 0, 7));
        LoadRegion load;
        load.box = held_plane(0, 0.02, 7).box;
        load.total_force_n = Vec3(0, 0, -1e-4);
        load.pointer = "/loads/0";
        scene.loads.push_back(load);
        scene.probes.push_back({"tip", load.box, "/probes/0"});
        use_method(scene, {SolveMethod::kNewton, 1});
        if (!table.wants("mesh convergence", scene)) continue;
        const SolveResult result = solve(scene);
        AccuracyRow row = row_of(scene, result, "mesh convergence",
                                 std::to_string(layers) + " layers of Kuhn tets",
                                 "tip deflection over Timoshenko's", edge);
        row.value = -(result.probe_m.back()[0].z() - result.probe_m.front()[0].z()) / timoshenko;
        row.expected = kExpected[i];
        row.error = std::abs(row.value - row.expected);  // absolute, as the target is
        row.target = 0.02;
        table.add(row);
    }
}

/// Hanging bar with nu = 0: one-dimensional, P(a) = mu (a - J / a^2), J = 2 - 1 / a.
double hanging_sag(double length, double e, double rho, double g) {
    const double mu = e / 2;
    double sag = 0;
    constexpr int kSlices = 4000;
    for (int i = 0; i < kSlices; ++i) {
        const double load = rho * g * length * (1 - (i + 0.5) / kSlices);
        double a = 1 + load / e;
        for (int k = 0; k < 20; ++k) {
            const double p = mu * (a - (2 - 1 / a) / (a * a));
            const double slope = mu * (1 + 4 / (a * a * a) - 3 / (a * a * a * a));
            a -= (p - load) / slope;
        }
        sag += (a - 1) * length / kSlices;
    }
    return sag;
}

void hanging_bar(AccuracyTable& table) {
    const double length = 0.02, e = 5e3, rho = 1000, g = 9.81;
    const double expected = hanging_sag(length, e, rho, g);
    for (const MethodChoice& choice :
         std::initializer_list<MethodChoice>{{SolveMethod::kNewton, 1},
                                             {SolveMethod::kVbd, 4},
                                             {SolveMethod::kVbd, 8},
                                             {SolveMethod::kVbd, 8, true},
                                             {SolveMethod::kXpbd, 8},
                                             {SolveMethod::kXpbd, 8, true},
                                             {SolveMethod::kXpbd, 32},
                                             {SolveMethod::kXpbd, 32, true},
                                             {SolveMethod::kExplicit, 16}}) {
        VerificationScene scene = accuracy_scene(Vec3(4e-3, 4e-3, length), {4, 4, 20}, e, 0);
        scene.gravity_m_s2 = Vec3(0, 0, -g);
        scene.held.push_back(held_plane(2, length, 7));
        scene.material.damping_per_s = 60;
        scene.end_s = 1.5;
        scene.probes.push_back({"end", held_plane(2, 0, 7).box, "/probes/0"});
        use_method(scene, choice);
        if (!table.wants("hanging bar", scene)) continue;
        const SolveResult result = solve(scene);
        AccuracyRow row =
            row_of(scene, result, "hanging bar", "20 x 4 x 4 mm, 5 kPa, nu 0, 1 mm",
                   "sag against the one-dimensional integral (rho g L^2 / 2E, large strain)", 1e-3);
        set_text(row.unit, "m");
        row.value = -result.probe_m.back()[0].z();
        row.expected = expected;
        row.error = std::abs(row.value / expected - 1);
        row.target = choice.method == SolveMethod::kXpbd ? 0.02 : 1e-3;
        table.add(row);
    }
}

/// The same cantilever in other units: lengths x s, times x 1, masses x m.
void unit_systems(AccuracyTable& table) {
    for (const auto& [method, substeps] :
         {std::pair{SolveMethod::kVbd, 4}, {SolveMethod::kXpbd, 16}}) {
        SolveResult si;
        for (const auto& [name, length, mass] :
             {std::tuple{"SI", 1.0, 1.0}, {"mm, g, s", 1e3, 1e3}, {"cm, 1e-4 kg, s", 1e2, 1e4}}) {
            VerificationScene scene = accuracy_scene(Vec3(0.02, 0.004, 0.004) * length, {10, 2, 2},
                                                     5e3 * mass / length, 0.45);
            scene.material.density_kg_m3 = 1000 * mass / std::pow(length, 3);
            scene.gravity_m_s2 = Vec3(0, 0, -2 * length);
            HeldRegion fixed = held_plane(0, 0, 7);
            fixed.box.low *= length;
            fixed.box.high *= length;
            scene.held.push_back(fixed);
            scene.end_s = 0.3;
            use_method(scene, {method, substeps});
            if (!table.wants("unit systems", scene)) continue;
            SolveResult result = solve(scene);
            if (length == 1.0) {
                si = result;
                continue;
            }
            double off = 0, size = 0;
            for (size_t i = 0; i < si.final_m.size(); ++i) {
                off += (result.final_m[i] / length - si.final_m[i]).squaredNorm();
                size += (si.final_m[i] - scene.output_points[i] / length).squaredNorm();
            }
            AccuracyRow row = row_of(scene, result, "unit systems", name,
                                     "displacement after 0.3 s of motion against SI (L2)", 2e-3);
            row.error = row.value = std::sqrt(off / size);
            row.target = 1e-4;
            row.cost = 0;
            table.add(row);
        }
    }
}

}  // namespace

void measure_beams(AccuracyTable& table) {
    const std::vector<Choice> coarse{{SolveMethod::kVbd, {1, 2, 4, 8}},
                                     {SolveMethod::kVbd, {8, 16}, true},
                                     {SolveMethod::kXpbd, {2, 4, 8, 16, 32}},
                                     {SolveMethod::kXpbd, {8, 16, 32}, true},
                                     {SolveMethod::kXpbdPair, {4, 8, 16, 32}}};
    static_cantilever(table, 2e-3, 0.45, coarse);
    static_cantilever(table, 2e-3, 0.49,
                      {{SolveMethod::kVbd, {2, 4, 8}}, {SolveMethod::kXpbd, {16, 32}}});
    moving_cantilever(table, 2e-3, 40,
                      {{SolveMethod::kVbd, {2, 4, 8, 16}},
                       {SolveMethod::kVbd, {4, 8, 16, 32}, true},
                       {SolveMethod::kXpbd, {4, 8, 16, 32}},
                       {SolveMethod::kXpbd, {4, 8, 16, 32}, true},
                       {SolveMethod::kXpbdPair, {8, 16, 32}},
                       {SolveMethod::kXpbdPair, {8, 16, 32}, true},
                       {SolveMethod::kExplicit, {8, 16}}});
    mesh_convergence(table);
    hanging_bar(table);
    unit_systems(table);
    if (table.quick()) return;
    static_cantilever(table, 1e-3, 0.45,
                      {{SolveMethod::kVbd, {2, 4, 8}},
                       {SolveMethod::kXpbd, {4, 8, 10, 16}},
                       {SolveMethod::kXpbd, {16}, true},
                       {SolveMethod::kXpbdPair, {8, 16}}});
    static_cantilever(table, 1e-3, 0.49, {{SolveMethod::kVbd, {4, 8}}});
    moving_cantilever(table, 1e-3, 16,
                      {{SolveMethod::kVbd, {4, 8}},
                       {SolveMethod::kXpbd, {8, 10, 16}},
                       {SolveMethod::kXpbd, {8, 16}, true}});
}

}  // namespace placode::sim
