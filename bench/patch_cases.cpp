// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <memory>

#include "bench/hard_case.h"
#include "bench/tissue_watch.h"
#include "curriculum/scene_changes.h"
#include "curriculum/task.h"
#include "sim/anatomy/operative_field.h"
#include "sim/core/number_text.h"
#include "sim/core/random.h"
#include "sim/step/step.h"

namespace placode::bench {
namespace {

using sim::EventKind;
using sim::StabilityVerdict;
using sim::Vec3;

constexpr double kWideRad = 0.6, kShutRad = 0.02;
constexpr double kTissueM = 0.020;   // no part of it gets so far from its place
constexpr double kLostM = 0.1;       // of the patch from the middle of the field
constexpr double kThroughM = 0.001;  // below the surface: it has gone into the hole
constexpr double kTakeM = 0.0001;    // of the tips over the patch's middle
constexpr int kReachFrames = 300, kShutFrames = 200;
constexpr double kBesideM = 0.002;  // of one hand from the other
constexpr double kHoleX = 0.014, kPatchX = 0.0165, kSideM = 0.0055;
constexpr int64_t kFramesOfAField = 20000;

// A patch of 13 x 12 mm over a hole of 4 x 8 mm in the skin beside the lesion; folded it spans it.
constexpr const char* kOverAHole = R"({
  "slit": {"from_m": [0.014, -0.004], "to_m": [0.014, 0.004], "width_m": 0.004, "layers": 3,
           "edge_m": 0.0008},
  "patch": {"length_m": 0.013, "width_m": 0.012, "centre_m": [0.0165, 0]},
  "contact": {"self_contact": true}})";

/// The field with its patch in the two hands of a case.
class PatchStage {
 public:
    explicit PatchStage(const char* changes)
        : scene_(sim::build_operative_field(
              curriculum::with_scene_changes(curriculum::load_task("patch_place"), changes).scene)),
          state_(std::make_unique<sim::State>(*scene_, 1)),
          inputs_(scene_->tools.size()),
          feedback_(inputs_.size()) {
        for (size_t i = 0; i < inputs_.size(); ++i)
            hand(i, Vec3(i == 0 ? 0.006 : -0.006, 0.008, 0.02), kWideRad, false);
        sim::settle(*scene_, *state_, 1.0);
        at_rest_.assign(state_->body.x.begin(), state_->body.x.end());
    }

    /// Straight down; the tip at `tip`.
    void hand(size_t tool, const Vec3& tip, double jaw_rad, bool engaged = true) {
        inputs_[tool].set_pose({tip, sim::Quat(0, 1, 0, 0)});
        inputs_[tool].jaw_rad = static_cast<float>(jaw_rad);
        inputs_[tool].engaged = engaged ? 1 : 0;
    }
    /// Tip and jaws of one hand go straight to these.
    void go(size_t tool, const Vec3& to, double jaw_rad, int count) {
        const Vec3 from = inputs_[tool].pose().p;
        const auto jaw = static_cast<double>(inputs_[tool].jaw_rad);
        for (int n = 1; n <= count; ++n) {
            const double share = static_cast<double>(n) / count;
            hand(tool, from + share * (to - from), jaw + share * (jaw_rad - jaw));
            frame();
        }
    }
    void frame() {
        const sim::StepReport report = sim::step(*scene_, *state_, inputs_, feedback_);
        finite_ = finite_ && (report.flags & sim::kNotFinite) == 0;
        for (int i = 0; i < state_->event_count; ++i)
            torn_ += state_->events[static_cast<size_t>(i)].kind == EventKind::kTorn ? 1 : 0;
        if (state_->frame % 10 != 0) return;
        tissue_m_ = std::max(tissue_m_, farthest_tissue(*scene_, *state_, at_rest_));
        patch_m_ = std::max(patch_m_, over_patch([](const Vec3& p) { return p.norm(); }));
    }
    void frames(double seconds) {
        const auto count = std::llround(seconds / scene_->body.spec().solver.frame_s);
        for (int64_t n = 0; n < count; ++n) frame();
    }
    /// The patch's vertex that is nearest to a place in the plane [m].
    [[nodiscard]] Vec3 nearest_to(double x, double y) const {
        Vec3 nearest = Vec3::Zero();
        double best = 1;
        for (int i = 0; i < scene_->patch->vertex_count; ++i) {
            const Vec3 p = position(state_->body, scene_->patch->first_vertex + i);
            const double away = (p - Vec3(x, y, p.z())).norm();
            if (away >= best) continue;
            best = away;
            nearest = p;
        }
        return nearest;
    }
    /// Most of `of(place)` over the patch's vertices; 1 m where one is no number.
    template <class Of>
    [[nodiscard]] double over_patch(Of&& of) const {
        double most = -1;
        for (int i = 0; i < scene_->patch->vertex_count; ++i) {
            const double value = of(position(state_->body, scene_->patch->first_vertex + i));
            most = std::isfinite(value) ? std::max(most, value) : 1;
        }
        return most;
    }
    [[nodiscard]] double fastest() const { return fastest_vertex(*state_); }
    [[nodiscard]] const sim::Grasp& held(size_t tool) const { return state_->grasps[tool]; }
    [[nodiscard]] bool finite() const { return finite_; }
    [[nodiscard]] int torn() const { return torn_; }
    [[nodiscard]] double tissue_m() const { return tissue_m_; }
    [[nodiscard]] double patch_m() const { return patch_m_; }

 private:
    std::shared_ptr<const sim::Scene> scene_;
    std::unique_ptr<sim::State> state_;
    std::vector<sim::ToolInput> inputs_;
    std::vector<sim::ToolFeedback> feedback_;
    std::vector<sim::Float4> at_rest_;
    bool finite_ = true;
    int torn_ = 0;
    double tissue_m_ = 0, patch_m_ = 0;
};

/// The patch between the jaws, from above, where it now lies nearest to a place.
void take(PatchStage& stage, size_t tool, double x, double y) {
    const Vec3 at = stage.nearest_to(x, y) + Vec3(0, 0, kTakeM);
    stage.go(tool, at + Vec3(0, 0, 0.004), kWideRad, kReachFrames);
    stage.go(tool, at, kWideRad, kReachFrames);
    stage.go(tool, at, kShutRad, kShutFrames);
}

/// Taken by one edge and laid back over the other, then pushed through the hole with shut jaws,
/// dragged about in it and left there.
void through_a_hole(sim::StabilityResult& result, double seconds) {
    PatchStage stage(kOverAHole);
    const double side = kPatchX + kSideM, other = kPatchX - kSideM;
    const double z = stage.nearest_to(side, 0).z();
    // The left hand holds one side, the right one lays the other back over it.
    take(stage, 1, other, 0);
    take(stage, 0, side, 0);
    const int taken = std::min(stage.held(0).count, stage.held(1).count);
    stage.go(0, {kPatchX, 0, z + 0.007}, kShutRad, 800);
    stage.go(0, {other + kBesideM, 0, z + 0.002}, kShutRad, 800);
    const double folded = stage.over_patch([](const Vec3& p) { return p.x() - kPatchX; });
    // It would spring open: the right hand keeps it shut until the left one has pushed it in.
    stage.go(1, {other, 0, stage.nearest_to(other, 0).z()}, kWideRad, 200);
    stage.go(1, {other, 0.004, z + 0.012}, kWideRad, 300);
    stage.go(1, {kHoleX - 0.001, 0, z + 0.007}, kShutRad, 300);
    stage.go(1, {kHoleX - 0.001, 0, z - 0.004}, kShutRad, 200);
    stage.go(0, {other + kBesideM, 0, z + 0.002}, kWideRad, 200);
    stage.go(0, {other + kBesideM, 0, z + 0.012}, kWideRad, 200);
    stage.go(1, {kHoleX - 0.001, 0.002, z - 0.003}, kShutRad, 100);
    stage.go(1, {kHoleX + 0.001, -0.003, z - 0.003}, kShutRad, 100);
    const double in_hole = -stage.over_patch([](const Vec3& p) { return -p.z(); });
    stage.go(1, {kHoleX, 0, z + 0.015}, kShutRad, 100);
    stage.frames(std::max(3.0, seconds));
    result.error = stage.fastest();
    result.detail = std::string(taken > 0 && folded < 0.6 * kSideM ? "folded" : "not folded") +
                    ", pushed to " + millimetres(z - in_hole) + " below; patch at most " +
                    millimetres(stage.patch_m()) + " off, tissue " + millimetres(stage.tissue_m()) +
                    " away, " + std::to_string(stage.torn()) + " tets torn; fastest at the end " +
                    sim::rounded_text(1000 * result.error, 2) + " mm/s";
    const bool done = taken > 0 && folded < 0.6 * kSideM && z - in_hole > kThroughM;
    const bool sound = stage.finite() && stage.patch_m() < kLostM && stage.tissue_m() < kTissueM &&
                       result.error < kCalmM_S;
    result.verdict = done && sound ? StabilityVerdict::kHolds : StabilityVerdict::kFails;
}

/// Both hands take it somewhere, go anywhere near it at up to 0.5 m/s, open and close.
void throw_about(PatchStage& stage, sim::SplitMix64& random, int64_t frames, int& taken) {
    const Vec3 middle(-0.0142, 0, 0.002);  // where the task puts it
    for (int64_t n = 0; n < frames;) {
        const size_t tool = random.uniform(0, 1) < 0.5 ? 0 : 1;
        const Vec3 to = middle + Vec3(random.uniform(-0.010, 0.014), random.uniform(-0.009, 0.009),
                                      random.uniform(-0.002, 0.010));
        if (random.uniform(0, 1) < 0.2) {
            take(stage, tool, to.x(), to.y());
            taken += stage.held(tool).count > 0 ? 1 : 0;
            n += 2 * kReachFrames + kShutFrames;
        }
        const int count = 20 + static_cast<int>(random.uniform(0, 400));
        stage.go(tool, to, random.uniform(0, 1) < 0.8 ? kShutRad : kWideRad, count);
        n += count;
    }
    for (const size_t tool : {size_t{0}, size_t{1}})
        stage.go(tool, {0.006, tool == 0 ? -0.008 : 0.008, 0.02}, kWideRad, 500);
    stage.frames(3);
}

/// In one field after the other; afterwards they let go, and all must come to rest.
void handled_without_sense(sim::StabilityResult& result, const sim::StabilityOptions& options) {
    sim::SplitMix64 random(1);
    int64_t done = 0;
    int fields = 0, taken = 0, torn = 0;
    bool finite = true;
    double patch_m = 0;
    while (done < options.poke_frames) {
        PatchStage stage("{}");
        const int64_t frames = std::min(kFramesOfAField, options.poke_frames - done);
        throw_about(stage, random, frames, taken);
        done += frames;
        ++fields;
        torn += stage.torn();
        finite = finite && stage.finite();
        patch_m = std::max(patch_m, stage.patch_m());
        result.error = std::max(result.error, stage.fastest());
        if (options.progress)
            options.progress("patch without sense: " + std::to_string(done) + " frames");
    }
    const bool sound = finite && patch_m < kLostM && result.error < kCalmM_S && taken > 0;
    result.verdict = sound ? StabilityVerdict::kHolds : StabilityVerdict::kFails;
    result.detail = std::to_string(done) + " frames in " + std::to_string(fields) +
                    " fields, patch taken " + std::to_string(taken) + " times, at most " +
                    millimetres(patch_m) + " off, " + std::to_string(torn) +
                    " tets torn; fastest at the end " + sim::rounded_text(1000 * result.error, 2) +
                    " mm/s" + (finite ? "" : "; not finite");
}

constexpr HardCase kPatchCases[]{
    {"patch folded and pushed through a hole",
     [](sim::StabilityResult& result, const sim::StabilityOptions& options) {
         through_a_hole(result, options.seconds);
     }},
    {"random hands at the patch", handled_without_sense}};

}  // namespace

std::span<const HardCase> patch_cases() { return kPatchCases; }

}  // namespace placode::bench
