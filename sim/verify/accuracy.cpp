// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/verify/accuracy.h"

#include <cmath>

#include "sim/verify/accuracy_table.h"

namespace placode::sim {

VerificationScene accuracy_scene(const Vec3& size_m, const std::array<int, 3>& cells,
                                 double youngs_modulus_pa, double poissons_ratio) {
    VerificationScene scene;
    use_box(scene, size_m, cells);
    scene.material.youngs_modulus_pa = youngs_modulus_pa;
    scene.material.poissons_ratio = poissons_ratio;
    scene.material.density_kg_m3 = 1000;
    scene.material.damping_per_s = 0;
    scene.gravity_m_s2.setZero();
    scene.solver.threads = 1;
    scene.solver.allow_invalid = true;
    scene.solver.single_precision = true;
    return scene;
}

void set_text(std::string& text, const char* to) { text = std::string(to); }

void use_method(VerificationScene& scene, const MethodChoice& choice) {
    scene.solver.method = choice.method;
    scene.solver.substeps = choice.substeps;
    scene.solver.single_precision = !choice.double_float;
}

std::string method_of(const VerificationScene& scene) {
    std::string name = method_name(scene.solver.method);
    if (!scene.solver.single_precision) name += " 48-bit";
    return name;
}

double substep_of(const VerificationScene& scene) {
    return scene.solver.method == SolveMethod::kNewton
               ? 0
               : scene.solver.frame_s / scene.solver.substeps;
}

bool AccuracyTable::wants(const std::string& study, const VerificationScene& scene) const {
    return !options_.wanted || options_.wanted(study, method_of(scene), substep_of(scene));
}

HeldRegion held_plane(int axis, double at_m, uint8_t axes, const std::string& pointer) {
    HeldRegion region;
    region.box = {Vec3::Constant(-1), Vec3::Constant(1)};
    region.box.low[axis] = region.box.high[axis] = at_m;
    region.axes = axes;
    region.pointer = pointer;
    return region;
}

AccuracyRow row_of(const VerificationScene& scene, const SolveResult& result,
                   const std::string& study, const std::string& setting,
                   const std::string& quantity, double edge_m) {
    AccuracyRow row;
    row.study = study;
    row.setting = setting;
    row.method = method_of(scene);
    row.quantity = quantity;
    row.edge_m = edge_m;
    row.tets = static_cast<int>(scene.mesh.tets.size());
    row.h_s = substep_of(scene);
    if (scene.solver.method != SolveMethod::kNewton) {
        row.courant = result.max_courant;
        row.cost = result.simulated_s > 0 ? result.cpu_s / result.simulated_s : 0;
    }
    return row;
}

double displacement_error(const VerificationScene& scene, const SolveResult& result,
                          const SolveResult& reference) {
    double off = 0, size = 0;
    for (size_t i = 0; i < scene.output_points.size(); ++i) {
        off += (result.final_m[i] - reference.final_m[i]).squaredNorm();
        size += (reference.final_m[i] - scene.output_points[i]).squaredNorm();
    }
    return std::sqrt(off / size);
}

double convergence_order(const std::vector<AccuracyRow>& rows) {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (const AccuracyRow& row : rows) {
        if (!(row.h_s > 0) || !(row.error > 0)) continue;
        const double u = std::log(row.h_s), v = std::log(row.error);
        n += 1;
        x += u;
        y += v;
        xx += u * u;
        xy += u * v;
    }
    const double spread = n * xx - x * x;
    return n < 2 || !(spread > 0) ? 0 : (n * xy - x * y) / spread;
}

namespace {

struct Group {
    const char* name;
    void (*measure)(AccuracyTable&);
    bool on_field;
};
constexpr Group kGroups[] = {{"homogeneous", measure_homogeneous, false},
                             {"beams", measure_beams, false},
                             {"twist", measure_twist, false},
                             {"motion", measure_motion, false},
                             {"indentation", measure_indentation, false},
                             {"felt", measure_felt, false},
                             {"field", measure_field, true},
                             {"drives", measure_drives, true},
                             {"sleep", measure_sleep, true}};

}  // namespace

const std::vector<std::string>& accuracy_groups() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> out;
        for (const Group& group : kGroups) out.emplace_back(group.name);
        return out;
    }();
    return names;
}

std::vector<AccuracyRow> measure_accuracy(const AccuracyOptions& options) {
    AccuracyTable table(options);
    for (const Group& group : kGroups) {
        const bool wanted =
            options.only.empty() ? options.field || !group.on_field : options.only == group.name;
        if (wanted) group.measure(table);
    }
    return table.rows();
}

}  // namespace placode::sim
