// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Contact as it is felt: the simulator's own frame (sim/step) with an instrument in a hand, on
// blocks of tissue. The force that goes to the hand is held against Hertz, against Coulomb's cone,
// and, of a needle that is dragged, against the same frames in many more substeps.
#include <cmath>
#include <ctime>

#include "sim/core/as_index.h"
#include "sim/step/step.h"
#include "sim/verify/accuracy_table.h"

namespace placode::sim {
namespace {

constexpr double kFeltE = 60e3, kFeltNu = 0.45;

/// A block of one tissue, its top at z = 0 about the z axis, held at its bottom.
struct Block {
    Vec3 size_m = Vec3::Zero();
    std::array<int, 3> cells{};
    double friction = 0;
    double tip_radius_m = 1e-3;
    double tip_length_m = 2.5e-3;
    double grip_n_m = 1e7;  ///< A machine's: the instrument is where it is put.
    double length_m = 0.2;
    /// New coordinate along an axis of a plane of the lattice; nullptr = as it is.
    double (*graded)(int axis, double x) = nullptr;
};

Scene scene_of(const Block& block, int substeps) {
    SoftBodySpec spec;
    spec.mesh = box_mesh(block.size_m, block.cells, Tissue::kSkin);
    double bottom = 0;
    for (Vec3& x : spec.mesh.rest) {
        x -= Vec3(block.size_m.x() / 2, block.size_m.y() / 2, block.size_m.z());
        for (int k = 0; k < 3 && block.graded != nullptr; ++k) x[k] = block.graded(k, x[k]);
        bottom = std::min(bottom, x.z());
    }
    spec.mesh = renumbered(spec.mesh, rcm_order(spec.mesh));
    Material material;
    material.youngs_modulus_pa = kFeltE;
    material.poissons_ratio = kFeltNu;
    material.density_kg_m3 = 1050;
    material.damping_per_s = 30;
    material.friction = block.friction;
    material.friction_static_ratio = 1;
    material.fail_stretch = material.injury_stretch = 100;
    spec.materials.fill(material);
    spec.solver.substeps = substeps;
    spec.solver.over_relaxation = 1;  // 1.2 makes a lattice of stiff tissue tremble
    spec.solver.gravity_m_s2.setZero();
    for (int v = 0; v < static_cast<int>(spec.mesh.rest.size()); ++v) {
        if (spec.mesh.rest[as_index(v)].z() < bottom + 1e-9) spec.fixed.push_back(v);
    }
    Scene scene{SoftBody(std::move(spec))};
    scene.id = "block";
    ToolSpec tool;
    tool.kind = ToolKind::kProbe;
    tool.tip_radius_m = tool.shaft_radius_m = block.tip_radius_m;
    tool.tip_length_m = block.tip_length_m;
    tool.length_m = block.length_m;
    tool.grip_n_m = block.grip_n_m;
    scene.tools = {tool};
    for (const Vec3& x : scene.body.mesh().rest)
        scene.field.depth_m.push_back(static_cast<float>(-x.z()));
    return scene;
}

/// Frames of a hand that holds the instrument upright.
class Hands {
 public:
    explicit Hands(Scene scene) : scene_(std::move(scene)), state_(scene_, 1) {}

    Vec3 frame(const Vec3& tip) {
        ToolInput input;
        input.set_pose({tip, Quat(0, 1, 0, 0)});  // distal is down
        input.engaged = 1;
        const std::clock_t start = std::clock();
        (void)step(scene_, state_, {&input, 1}, {&feedback_, 1});
        cpu_s_ += static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        ++frames_;
        return feedback_.force_n;
    }
    /// Lowers the tip at 20 mm/s and waits.
    Vec3 press(double depth_m, double wait_s) {
        for (double z = 3e-4; z > -depth_m; z -= 2e-5) frame(Vec3(0, 0, z));
        Vec3 force = Vec3::Zero();
        for (int i = 0; i < static_cast<int>(wait_s * 1000); ++i)
            force = frame(Vec3(0, 0, -depth_m));
        return force;
    }
    [[nodiscard]] AccuracyRow row(const char* setting, const char* quantity) const {
        const SolverSettings& s = scene_.body.spec().solver;
        AccuracyRow out;
        set_text(out.study, "contact as felt");
        set_text(out.setting, setting);
        set_text(out.method, "vbd");
        set_text(out.quantity, quantity);
        out.h_s = s.frame_s / s.substeps;
        out.tets = scene_.body.tet_count();
        const auto courant = scene_.body.courant_numbers();
        out.courant = *std::max_element(courant.begin(), courant.end());
        out.cost = cpu_s_ / (frames_ * s.frame_s);
        return out;
    }

 private:
    const Scene scene_;
    State state_;
    ToolFeedback feedback_;
    double cpu_s_ = 0;
    int frames_ = 0;
};

constexpr int kFine = 12, kBeside = 8, kBelow = 10;  // planes of 0.1 mm, and growing ones

double graded(int axis, double x) {
    const double reach = axis == 2 ? 0.012 : 0.006, n = std::abs(x);
    constexpr double kEdge = 1e-4;
    if (n <= kFine) return kEdge * x;
    double outer = 0, all = 0;
    for (int i = 1; i <= (axis == 2 ? kBelow : kBeside); ++i) {
        all += std::pow(1.35, i);
        if (i <= n - kFine + 0.5) outer += std::pow(1.35, i);
    }
    return std::copysign(kEdge * kFine + (reach - kEdge * kFine) * outer / all, x);
}

/// A round tip that a machine presses into skin: the force of Hertz.
void hertz(AccuracyTable& table) {
    constexpr double kRadius = 1.5e-3, kDepth = 1e-4;
    Block block;
    const int beside = 2 * (kFine + kBeside);
    block.size_m = Vec3(beside, beside, kFine + kBelow);  // only numbers of planes
    block.cells = {beside, beside, kFine + kBelow};
    block.tip_radius_m = kRadius;
    block.graded = graded;
    for (const int substeps : {2, 4, 8}) {
        Hands hands(scene_of(block, substeps));
        const Vec3 force = hands.press(kDepth, table.quick() ? 0.05 : 0.2);
        AccuracyRow row = hands.row("probe of 1.5 mm pressed 0.1 mm into 60 kPa, nu 0.45",
                                    "force on the hand against Hertz");
        set_text(row.unit, "N");
        row.edge_m = 1e-4;
        row.value = force.z();
        row.expected =
            4.0 / 3 * kFeltE / (1 - kFeltNu * kFeltNu) * std::sqrt(kRadius) * std::pow(kDepth, 1.5);
        row.error = std::abs(row.value / row.expected - 1);
        row.target = 0.1;
        table.add(row);
    }
}

/// A plane (a tip of 50 m) drawn over tissue: its force leans by the angle of friction, the slope
/// at which a block begins to slide.
void incline(AccuracyTable& table) {
    for (const double mu : {0.1, 0.3, 0.5}) {
        Block block;
        block.size_m = Vec3(4e-3, 4e-3, 2e-3);
        block.cells = {8, 8, 4};
        block.friction = mu;
        block.tip_radius_m = 50;
        block.length_m = 200;
        block.grip_n_m = 1e9;
        Hands hands(scene_of(block, 4));
        hands.press(5e-5, 0.05);
        Vec3 force = Vec3::Zero();
        for (int i = 0; i < 350; ++i) force = hands.frame(Vec3(1e-6 * i, 0, -5e-5));
        AccuracyRow row = hands.row(mu < 0.2   ? "plane drawn over 60 kPa, friction 0.1"
                                    : mu < 0.4 ? "plane drawn over 60 kPa, friction 0.3"
                                               : "plane drawn over 60 kPa, friction 0.5",
                                    "tangent of the angle of the force against friction");
        row.edge_m = 5e-4;
        row.value = -force.x() / force.z();
        row.expected = mu;
        row.error = std::abs(row.value / mu - 1);
        row.target = 0.01;
        table.add(row);
    }
}

/// Forces of a needle's tip pressed in and dragged, frame by frame.
std::vector<Vec3> drag(Hands& hands) {
    constexpr double kDepth = 3e-4, kSpeed = 3e-3;
    hands.press(kDepth, 0.1);
    std::vector<Vec3> out;
    for (int i = 0; i < 500; ++i) out.push_back(hands.frame(Vec3(kSpeed * 1e-3 * i, 0, -kDepth)));
    return out;
}

void dragged_needle(AccuracyTable& table) {
    Block block;
    block.size_m = Vec3(8e-3, 8e-3, 3e-3);
    block.cells = {20, 20, 8};
    block.friction = 0.1;
    block.tip_radius_m = 2.5e-4;
    block.grip_n_m = 600;
    Hands truth(scene_of(block, 64));
    const std::vector<Vec3> expected = drag(truth);
    for (const int substeps : {2, 4, 8}) {
        Hands hands(scene_of(block, substeps));
        const std::vector<Vec3> found = drag(hands);
        double off = 0, size = 0;
        for (size_t i = 0; i < found.size(); ++i) {
            off += (found[i] - expected[i]).squaredNorm();
            size += expected[i].squaredNorm();
        }
        AccuracyRow row = hands.row("needle of 0.25 mm, 0.3 mm deep in 60 kPa, dragged at 3 mm/s",
                                    "force on the hand against 64 substeps a frame (RMS)");
        row.edge_m = 4e-4;
        row.value = row.error = std::sqrt(off / size);
        // A hand tells two forces apart from 7 to 10 % on.
        row.target = substeps >= 4 ? 0.1 : 0;
        table.add(row);
    }
}

}  // namespace

void measure_felt(AccuracyTable& table) {
    hertz(table);
    incline(table);
    dragged_needle(table);
}

}  // namespace placode::sim
