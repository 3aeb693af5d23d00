// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A block of tissue, a needle and a hand that drives it: frames of 1 ms with 4 substeps.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "sim/core/as_index.h"
#include "sim/suture/suture_step.h"

namespace placode::sim::test {

struct BlockOptions {
    Vec3 size_m = Vec3(0.010, 0.004, 0.003);
    std::array<int, 3> cells{25, 10, 8};
    double youngs_modulus_pa = 200e3;
    double slit_m = 0;  ///< The block is two halves, this far apart in x; `cells` are those of one.
    int threads = 1;
    SutureSpec suture;
};
/// A needle of 13 mm in skin that is stiff enough for the puncture forces of the tests, without
/// gravity: what is measured is the tissue's.
inline BlockOptions skin_block() {
    BlockOptions options;
    options.suture.needle.arc_m = 13e-3;
    options.suture.gravity_m_s2 = Vec3::Zero();
    return options;
}
inline void set_strength(SutureSpec& spec, double puncture_n, double friction_n_m = 40) {
    for (SutureStrength& s : spec.strength) {
        s.puncture_n = puncture_n;
        s.wall_friction_n_m = friction_n_m;
    }
}

/// Turn by `angle` about an axis through the origin.
inline Quat turned(double angle, const Vec3& axis) { return Quat(Eigen::AngleAxisd(angle, axis)); }

/// Block centred on the z axis, its top at z = 0, its bottom held. The needle's plane is y = 0:
/// N.x is W.x, N.y is W.z, so that the point looks down.
class SutureBlock {
 public:
    explicit SutureBlock(const BlockOptions& options, const Pose& X_WN)
        : suture(options.suture),
          body(body_spec(options)),
          surface(body.mesh()),
          tissue_state(body),
          faces(surface, body.mesh(), false),
          needle(suture, X_WN),
          scratch(body, suture),
          workers(options.threads, Workers::Team::kFixed),
          tissue{body, tissue_state, surface, faces} {}
    SutureBlock(const SutureBlock&) = delete;
    SutureBlock& operator=(const SutureBlock&) = delete;

    /// Upright in the needle's plane, its circle's centre at `centre`, turned forwards by `angle`.
    static Pose upright(const Vec3& centre, double angle = 0) {
        Mat3 r;
        r << 1, 0, 0, 0, 0, -1, 0, 1, 0;  // columns: x, z, -y
        return {centre, Quat(r) * turned(-angle, Vec3::UnitZ())};
    }

    /// One frame in which the hand goes to X_WH.
    void frame(const Pose& X_WH) {
        report.event_count = 0;
        begin_frame();
        const Pose from = needle.hold.hand;
        for (int s = 1; s <= kSubsteps; ++s) {
            const double share = static_cast<double>(s) / kSubsteps;
            Pose hand;
            hand.p = from.p + share * (X_WH.p - from.p);
            hand.q = from.q.slerp(share, X_WH.q);
            substep(hand);
        }
        ++frames;
    }
    void begin_frame() { faces.refit(tissue_state.x); }
    void substep(const Pose& hand) {
        begin_substep(body, tissue_state, kStep, workers);
        begin_suture(suture, needle, tissue, scratch, hand, kStep, report);
        solve_suture(suture, needle, tissue, scratch, kStep, false);
        sweep(body, tissue_state, kStep, workers);
        solve_suture(suture, needle, tissue, scratch, kStep, true);
        finish_suture(suture, needle, tissue, scratch, kStep, report);
        end_substep(body, tissue_state, kStep, workers);
    }
    void rest(int count) {
        const Pose hand = needle.hold.hand;
        for (int i = 0; i < count; ++i) frame(hand);
    }

    /// Force along the way of the point that the hand exerts [N].
    [[nodiscard]] double push_n() const {
        return needle.hold.force_n.dot(needle.needle.q * Needle::forward());
    }
    /// Torque of the hand about the circle's centre, over its radius: what drives the needle round.
    [[nodiscard]] double drive_n() const {
        const Vec3 grip = needle.needle.q * needle.hold.held_N;
        const Vec3 axis = needle.needle.q * Vec3::UnitZ();
        return -(grip.cross(needle.hold.force_n) + needle.hold.torque_n_m).dot(axis) /
               suture.needle().radius_m();
    }
    [[nodiscard]] bool saw(SutureEventKind kind) const {
        return std::any_of(report.events.begin(), report.events.begin() + report.event_count,
                           [&](const SutureEvent& e) { return e.kind == kind; });
    }
    /// Energy of the tissue, from the deformation gradient in double; nothing at rest [J].
    [[nodiscard]] double tissue_energy() const {
        const Material& material = body.spec().materials[0];
        const NeoHookean m = neo_hookean(material.youngs_modulus_pa, material.poissons_ratio);
        double sum = 0;
        for (const auto& tet : body.mesh().tets) {
            Mat3 rest, now;
            for (int k = 0; k < 3; ++k) {
                const auto a = as_index(tet[as_index(k + 1)]), o = as_index(tet[0]);
                rest.col(k) = body.mesh().rest[a] - body.mesh().rest[o];
                now.col(k) =
                    position(tissue_state, tet[as_index(k + 1)]) - position(tissue_state, tet[0]);
            }
            const Mat3 f = now * rest.inverse();
            const double j = f.determinant() - m.gamma, at_rest = 1 - m.gamma;
            sum += rest.determinant() / 6 *
                   (m.lambda_pa / 2 * (j * j - at_rest * at_rest) +
                    m.mu_pa / 2 * (f.squaredNorm() - 3));
        }
        return sum;
    }
    [[nodiscard]] double tissue_motion() const {
        double sum = 0;
        for (size_t i = 0; i < tissue_state.v.size(); ++i)
            sum += 0.5 * static_cast<double>(body.mass_kg()[i]) *
                   to_vec(tissue_state.v[i]).squaredNorm();
        return sum;
    }
    /// What the held bottom carries [N]: the force of the tissue on it.
    [[nodiscard]] Vec3 carried_n() const {
        Vec3 sum = Vec3::Zero();
        for (const int32_t v : body.spec().fixed) sum += elastic_force(body, tissue_state, v);
        return sum;
    }
    [[nodiscard]] double stored() const {
        return tissue_energy() + suture_energy(suture, needle, tissue);
    }
    [[nodiscard]] uint64_t hash() const {
        return state_hash(needle) ^ 3 * state_hash(tissue_state);
    }

    static constexpr int kSubsteps = 4;
    static constexpr double kStep = 0.25e-3;

    Suture suture;
    SoftBody body;
    Surface surface;
    SoftBodyState tissue_state;
    SurfaceState faces;
    SutureState needle;
    SutureScratch scratch;
    Workers workers;
    SuturedTissue tissue;
    SutureReport report;
    int frames = 0;

 private:
    static TetMesh block_mesh(const BlockOptions& options) {
        const Vec3& size = options.size_m;
        const bool halves = options.slit_m > 0;
        const double length = halves ? (size.x() - options.slit_m) / 2 : size.x();
        TetMesh mesh = box_mesh(Vec3(length, size.y(), size.z()), options.cells, Tissue::kSkin);
        for (Vec3& x : mesh.rest) x -= Vec3(size.x() / 2, size.y() / 2, size.z());
        if (!halves) return mesh;
        const auto count = static_cast<int32_t>(mesh.rest.size());
        const size_t tets = mesh.tets.size();
        for (int32_t v = 0; v < count; ++v)
            mesh.rest.push_back(mesh.rest[as_index(v)] + Vec3(length + options.slit_m, 0, 0));
        for (size_t t = 0; t < tets; ++t) {
            auto tet = mesh.tets[t];
            for (int32_t& v : tet) v += count;
            mesh.tets.push_back(tet);
            mesh.tissue.push_back(Tissue::kSkin);
        }
        return mesh;
    }
    static SoftBodySpec body_spec(const BlockOptions& options) {
        SoftBodySpec spec;
        spec.mesh = block_mesh(options);
        spec.mesh = renumbered(spec.mesh, rcm_order(spec.mesh));
        Material material;
        material.youngs_modulus_pa = options.youngs_modulus_pa;
        spec.materials.fill(material);
        spec.solver.over_relaxation = 1.0;
        spec.solver.gravity_m_s2 = Vec3::Zero();
        for (int v = 0; v < static_cast<int>(spec.mesh.rest.size()); ++v) {
            if (spec.mesh.rest[as_index(v)].z() < 1e-9 - options.size_m.z())
                spec.fixed.push_back(v);
        }
        return spec;
    }
};

/// Drives the needle round its centre at `speed_m_s` of the point for `path_m`; `look(block)` after
/// every frame, false stops.
template <class Look>
void drive_round(SutureBlock& block, double path_m, double speed_m_s, Look&& look) {
    const Pose start = block.needle.hold.hand;
    const double radius = block.suture.needle().radius_m();
    const int frames = static_cast<int>(std::ceil(std::abs(path_m) / (speed_m_s * 1e-3)));
    for (int i = 1; i <= frames; ++i) {
        const double angle = path_m / radius * i / frames;
        block.frame({start.p, start.q * turned(-angle, Vec3::UnitZ())});
        if (!look(block)) return;
    }
}

/// A needle upright in front of the block whose circle reaches `depth_m` below the surface, its
/// point `above_m` above it; in the hand, held `arc_m` behind the point.
inline Pose before_bite(const Needle& needle, double depth_m, double above_m) {
    const double r = needle.radius_m(), z = r - depth_m;
    return SutureBlock::upright(Vec3(0, 0, z), std::asin((z - above_m) / r));
}

}  // namespace placode::sim::test
