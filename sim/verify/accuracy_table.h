// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the groups of accuracy cases share. Private to sim/verify.

#include "sim/verify/accuracy.h"
#include "sim/verify/verification_scene.h"

namespace placode::sim {

class AccuracyTable {
 public:
    explicit AccuracyTable(const AccuracyOptions& options) : options_(options) {}
    [[nodiscard]] bool quick() const { return options_.quick; }
    /// Whether anybody wants the rows that a run of this scene gives.
    [[nodiscard]] bool wants(const std::string& study, const VerificationScene& scene) const;
    void add(AccuracyRow row) {
        if (options_.progress) options_.progress(row);
        rows_.push_back(std::move(row));
    }
    [[nodiscard]] const std::vector<AccuracyRow>& rows() const { return rows_; }

 private:
    AccuracyOptions options_;
    std::vector<AccuracyRow> rows_;
};

/// One thread, no gravity, invalid steps allowed (the table shows what they cost).
[[nodiscard]] VerificationScene accuracy_scene(const Vec3& size_m, const std::array<int, 3>& cells,
                                               double youngs_modulus_pa, double poissons_ratio);
/// Out of line: g++ 12 warns wrongly (-Wrestrict) where it inlines such assignments.
void set_text(std::string& text, const char* to);
/// What a row measures: in the floats of the simulator, or with the low parts of positions.
struct MethodChoice {
    SolveMethod method = SolveMethod::kVbd;
    int substeps = 1;
    bool double_float = false;
};
void use_method(VerificationScene& scene, const MethodChoice& choice);
/// As in a row.
[[nodiscard]] std::string method_of(const VerificationScene& scene);
[[nodiscard]] double substep_of(const VerificationScene& scene);
[[nodiscard]] HeldRegion held_plane(int axis, double at_m, uint8_t axes,
                                    const std::string& pointer = "/fixed/0");
/// A row with method, step, mesh and cost of a run filled in.
[[nodiscard]] AccuracyRow row_of(const VerificationScene& scene, const SolveResult& result,
                                 const std::string& study, const std::string& setting,
                                 const std::string& quantity, double edge_m);
/// |x - reference| / |reference - rest| over all vertices, L2.
[[nodiscard]] double displacement_error(const VerificationScene& scene, const SolveResult& result,
                                        const SolveResult& reference);

}  // namespace placode::sim
