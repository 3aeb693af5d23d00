// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What all methods of solve() share: selections put to vertices, ramps, start shapes, samples, the
// summary. Vertex numbers are those of the scene's mesh. Private to sim/verify.

#include <algorithm>
#include <chrono>
#include <memory>

#include "sim/verify/body_pieces.h"
#include "sim/verify/reference_body.h"
#include "sim/verify/verification_scene.h"

namespace placode::sim {

class SolveSetup {
 public:
    /// @throws VerificationError.
    SolveSetup(const VerificationScene& scene, SolveWatch watch);

    const VerificationScene& scene;
    SoftBodySpec spec;                    ///< Without held vertices.
    std::unique_ptr<ReferenceBody> body;  ///< The same, in double precision.
    std::vector<uint8_t> held;            ///< (V) axes bits.
    BodyPieces pieces;
    Coordinates start;                         ///< (3 V) start shape; held coordinates at rest.
    std::unique_ptr<SphereContacts> contacts;  ///< nullptr = no spheres.
    double max_courant = 0;
    std::vector<std::string> warnings;

    /// Tells the watch, at most twice a second.
    template <class Words>
    void report(Words&& words) const {
        if (!watch_) return;
        const auto now = std::chrono::steady_clock::now();
        if (now < next_report_) return;
        next_report_ = now + std::chrono::milliseconds(500);
        watch_(words());
    }
    /// The same of simulated time.
    void report_time(double time_s) const;

    /// Where a held coordinate is at time t [m].
    [[nodiscard]] double held_at(int vertex, int axis, double time_s) const;
    /// How far that is from rest [m].
    [[nodiscard]] double held_displacement(int vertex, int axis, double time_s) const;
    /// External forces without gravity at time t, added to `out` (3 V).
    void add_loads(double time_s, Coordinates& out) const;
    [[nodiscard]] bool has_loads() const { return !loads_.empty(); }
    /// Longest ramp [s].
    [[nodiscard]] double longest_ramp_s() const;
    /// Size of the accelerations that the scene is about [m/s^2]: gravity, loads over the mass, and
    /// what the stress of the prescribed strains does to a body of this size. 0 where nothing is
    /// held: what flies free keeps its velocity whatever its position rounds to.
    [[nodiscard]] double usual_acceleration() const;
    /// Of a body of this size that is accelerated so [Pa].
    [[nodiscard]] double usual_stress() const;
    /// From the first vertex to the farthest other, at rest [m].
    [[nodiscard]] double extent_m() const;
    /// Vertices that only some axes hold (V), ascending.
    [[nodiscard]] const std::vector<int32_t>& partly_held() const { return partly_; }

    /// Triangles of sheets that are not faces of the tets as well.
    [[nodiscard]] std::vector<std::array<int32_t, 3>> free_sheet() const;

    /// Adds a row to the probes.
    void sample(double time_s, const Coordinates& x, SolveResult& out) const;
    /// Everything that follows from the final state. @param v (3 V) velocities.
    void finish(const Coordinates& x, const Coordinates& v, double time_s, SolveResult& out) const;

 private:
    struct Load {
        Vec3 total = Vec3::Zero();
        double ramp_s = 0;
        std::vector<std::pair<int32_t, double>> share;  ///< vertex, share of the total
    };
    [[nodiscard]] std::vector<int32_t> select(const BoxSelection& box,
                                              const std::string& pointer) const;
    void check_spheres();
    void hold();
    void make_loads();
    void check_effect(const LoadRegion& region, const Load& load);
    void make_start();
    void check_collapse(SolveResult& out) const;
    void add_reactions(const Coordinates& x, double time_s, SolveResult& out) const;

    SolveWatch watch_;
    mutable std::chrono::steady_clock::time_point next_report_;  // reporting changes no result
    std::vector<std::array<int32_t, 3>> held_by_;                ///< (V x 3) region, -1 = free
    std::vector<int32_t> partly_;
    std::vector<Load> loads_;
    std::vector<std::vector<int32_t>> probe_vertices_;
};

/// Longest of the ways of all vertices (3 V) [m].
[[nodiscard]] inline double largest_displacement(const Coordinates& offset) {
    double farthest = 0;
    for (Eigen::Index i = 0; i < offset.size(); i += 3)
        farthest = std::max(farthest, offset.segment<3>(i).norm());
    return farthest;
}

/// Label of the k-th sheet's material; the tets have kSubcutis.
[[nodiscard]] inline Tissue sheet_tissue(size_t k) noexcept {
    const auto tets = static_cast<size_t>(Tissue::kSubcutis);
    return static_cast<Tissue>(k < tets ? k : k + 1);
}

// One runner for each family of methods; they fill `out` up to finish().
void run_fast(const SolveSetup& setup, SolveResult& out);      ///< xpbd, xpbd_pair, vbd
void run_explicit(const SolveSetup& setup, SolveResult& out);  ///< double precision, symplectic
void run_newton(const SolveSetup& setup, SolveResult& out);    ///< quasi-static

}  // namespace placode::sim
