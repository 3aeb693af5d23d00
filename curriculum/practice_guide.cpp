// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/practice_guide.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "curriculum/undermine_watch.h"
#include "sim/contact/slit_gap.h"
#include "sim/step/tip_gap.h"

namespace placode::curriculum {

namespace {

using sim::Vec2;
using sim::Vec3;

/// A vertex by itself: its place to the last bit.
sim::ContourAnchor at_vertex(int32_t v) { return {{v, v, v}, {1, 0, 0}}; }

/// The surface's vertex that is nearest to a place.
std::optional<sim::ContourAnchor> nearest_vertex(const sim::Scene& scene, const sim::State& settled,
                                                 const Vec2& wanted) {
    std::optional<sim::ContourAnchor> found;
    double nearest = 1;
    for (size_t v = 0; v < scene.field.depth_m.size(); ++v) {
        if (scene.field.depth_m[v] > 0) continue;
        const double path = (to_vec(settled.body.x[v]).head<2>() - wanted).norm();
        if (path >= nearest) continue;
        nearest = path;
        found = at_vertex(static_cast<int32_t>(v));
    }
    return found;
}

/// The place itself, in the triangle of the surface that it lies in; none beside the field.
std::optional<sim::ContourAnchor> exact_place(const sim::Scene& scene, const sim::State& settled,
                                              const Vec2& wanted) {
    const auto on_top = [&](int32_t v) {
        return !(scene.field.depth_m[static_cast<size_t>(v)] > 0);
    };
    for (const sim::SurfaceTriangle& tri : settled.surface.triangles()) {
        if (!std::all_of(tri.vertex.begin(), tri.vertex.end(), on_top)) continue;
        std::array<Vec2, 3> p;
        for (size_t k = 0; k < 3; ++k)
            p[k] = to_vec(settled.body.x[static_cast<size_t>(tri.vertex[k])]).head<2>();
        const Vec2 u = p[1] - p[0], v = p[2] - p[0], w = wanted - p[0];
        const double area = u.x() * v.y() - u.y() * v.x();
        if (std::abs(area) < 1e-14) continue;  // seen from its edge [m^2]
        const double b = (w.x() * v.y() - w.y() * v.x()) / area,
                     c = (u.x() * w.y() - u.y() * w.x()) / area;
        if (b < -1e-9 || c < -1e-9 || b + c > 1 + 1e-9) continue;
        return sim::ContourAnchor{
            tri.vertex,
            {static_cast<float>(1 - b - c), static_cast<float>(b), static_cast<float>(c)}};
    }
    return std::nullopt;
}

/// Of a step with a patch: where to take it, or where its middle belongs and where it is.
int find_patch_targets(const sim::Scene& scene, const sim::State& settled, sim::PracticeKind kind,
                       std::array<sim::ContourAnchor, 2>& out) {
    const sim::PatchHandles handles = sim::patch_handles(scene);
    if (handles.rim < 0) return 0;
    if (kind == sim::PracticeKind::kPatchTake) {
        out[0] = at_vertex(handles.rim);
        return 1;
    }
    const auto goal = nearest_vertex(scene, settled, sim::placode_middle(scene));
    if (!goal) return 0;
    out = {*goal, at_vertex(handles.middle)};
    return 2;
}

/// Where the targets of a step are: they move with the tissue. A place on the clock of the contour
/// is the nearest vertex, as recordings have it; one that the step names is meant exactly.
int find_targets(const sim::Scene& scene, const sim::State& settled, const sim::PracticeStep& step,
                 std::array<sim::ContourAnchor, 2>& out) {
    if (sim::is_patch_step(step.kind)) return find_patch_targets(scene, settled, step.kind, out);
    if (sim::finds_targets(step.kind)) return 0;  // they change: WashWatch, undermine_watch.h
    int count = 0;
    for (int t = 0; t < sim::targets_of(step.kind); ++t) {
        const Vec2 wanted = assessment::practice_target(step, scene.geometry, t == 1);
        std::optional<sim::ContourAnchor> found;
        if (step.placed) found = exact_place(scene, settled, wanted);
        if (!found) found = nearest_vertex(scene, settled, wanted);
        if (found) out[static_cast<size_t>(count++)] = *found;
    }
    return count;
}

/// Weighted place of an anchor's vertices.
template <class PlaceOf>
Vec3 place_of(const sim::ContourAnchor& anchor, const PlaceOf& place_of_vertex) {
    Vec3 sum = static_cast<double>(anchor.weight[0]) * place_of_vertex(anchor.vertex[0]);
    for (size_t k = 1; k < 3; ++k)
        if (anchor.weight[k] != 0)
            sum += static_cast<double>(anchor.weight[k]) * place_of_vertex(anchor.vertex[k]);
    return sum;
}

}  // namespace

PracticeGuide::PracticeGuide(const std::vector<TaskStep>& steps, const sim::Scene& scene,
                             const sim::State& settled) {
    if (steps.empty()) return;
    scene_ = &scene;
    if (scene.suture) needle_arc_m_ = scene.suture->needle().arc_m();
    std::vector<sim::PracticeStep> goals;
    goals.reserve(steps.size());
    for (const TaskStep& step : steps) goals.push_back(step.goal);
    tracker_.emplace(goals, scene.tools, scene.geometry);
    const auto at_rest = [&](int32_t v) -> Vec3 {
        return scene.body.mesh().rest[static_cast<size_t>(v)];
    };
    for (const sim::PracticeStep& step : goals) {
        auto& targets = targets_.emplace_back();
        const int count = find_targets(scene, settled, step, targets);
        target_count_.push_back(count);
        auto& marks = mark_m_.emplace_back();
        marks.fill(Vec3::Zero());
        for (size_t t = 0; t < static_cast<size_t>(count); ++t)
            marks[t] = place_of(targets[t], at_rest);
        station_.push_back(step.kind == sim::PracticeKind::kThreadDraw && count == 2
                               ? sim::nearest_station(scene, 0.5 * (marks[0] + marks[1]).head<2>())
                               : -1);
    }
    for (const sim::PracticeStep& step : goals) {
        if (step.kind != sim::PracticeKind::kPatchLay || patch_.there()) continue;
        patch_ = PatchWatch(scene, step.distance_m);
    }
    if (scene.irrigation) wash_ = WashWatch(scene);
    goal_.bites = tracker_->bites();
    goal_.count = tracker_->count();
    look(settled);
}

void PracticeGuide::begin_at(int step, const sim::State& state) noexcept {
    if (!tracker_) return;
    tracker_->begin_at(step);
    look(state);
}

void PracticeGuide::look(const sim::State& state) noexcept {
    goal_.index = tracker_->index();
    goal_.step = tracker_->step();
    goal_.progress = tracker_->progress();
    goal_.traced = tracker_->traced();
    goal_.bite = tracker_->bite();
    goal_.targets = 0;
    if (tracker_->done()) return;
    const auto now = [&](int32_t v) -> Vec3 {
        return to_vec(state.body.x[static_cast<size_t>(v)]);
    };
    goal_.margin = false;
    if (patch_.there() && goal_.step.kind != sim::PracticeKind::kTrace) patch_.show(goal_);
    const auto step = static_cast<size_t>(goal_.index);
    for (; goal_.targets < target_count_[step]; ++goal_.targets) {
        const auto t = static_cast<size_t>(goal_.targets);
        goal_.target_m[t] = place_of(targets_[step][t], now);
    }
    if (sim::is_wash_step(goal_.step.kind) && wash_.there()) wash_.show(goal_);
    if (goal_.step.kind == sim::PracticeKind::kUndermine && scene_->plane.present())
        show_undermining(*scene_, state, goal_);
}

/// Who holds it, where, and where it is.
void PracticeGuide::look_at_handling(const sim::State& state,
                                     assessment::NeedleSight& needle) const noexcept {
    constexpr int kPlaces = 17;  // along the wire
    const sim::Pose& X_WN = state.suturing.needle[0].needle;
    const sim::Needle& shape = scene_->suture->needle();
    needle.handled = true;
    for (size_t t = 0; t < scene_->tools.size(); ++t) {
        const sim::NeedleHold* hold = sim::hold_of(state, static_cast<int>(t));
        needle.held[t] = hold != nullptr;
        needle.share[t] = hold != nullptr ? hold->arc_m / needle_arc_m_ : 0;
    }
    needle.point_m = X_WN * shape.tip_m();
    needle.middle_m = X_WN * shape.centre_m();
    needle.lowest_m = needle.point_m.z();
    for (int i = 1; i < kPlaces; ++i)
        needle.lowest_m = std::min(
            needle.lowest_m, (X_WN * shape.at(needle_arc_m_ * i / (kPlaces - 1)).place_m).z());
}

void PracticeGuide::look_at_needle(const sim::State& state,
                                   assessment::NeedleSight& needle) const noexcept {
    const sim::Suturing& s = state.suturing;
    if (s.needle.empty() || tracker_->done()) return;
    if (sim::has_two_drivers(*scene_)) look_at_handling(state, needle);
    needle.taken = s.taken;
    needle.held_share = s.needle[0].hold.arc_m / needle_arc_m_;
    needle.entered = s.entered;
    needle.left = s.left;
    needle.through = s.through;
    needle.in_tissue = s.needle[0].passage_count > 0;
    for (int k = 0; k < 3; ++k) {
        needle.entry_m[k] = static_cast<double>(s.entry_m[static_cast<size_t>(k)]);
        needle.exit_m[k] = static_cast<double>(s.exit_m[static_cast<size_t>(k)]);
    }
    // Through a wall, or through the underside of skin that was freed.
    const auto half_way = [&](const Vec3& place) {
        return sim::in_slit(*scene_, place.head<2>()) || sim::below_skin(*scene_, place);
    };
    needle.entry_in_slit = s.entered > 0 && half_way(needle.entry_m);
    needle.exit_in_slit = s.left > 0 && half_way(needle.exit_m);
    needle.mark_m = mark_m_[static_cast<size_t>(goal_.index)];
}

std::span<const sim::Event> PracticeGuide::see(const sim::State& state,
                                               std::span<const sim::ToolInput> inputs,
                                               const sim::Sample& sample) noexcept {
    if (!tracker_) return {};
    look(state);
    // A sample measures the way to the tissue up to 3 mm.
    sim::Sample far = sample;
    if (!tracker_->done() && goal_.step.kind == sim::PracticeKind::kWithdraw)
        for (size_t i = 0; i < inputs.size(); ++i)
            far.tools[i].tip_gap_m =
                static_cast<float>(sim::tip_gap(state, static_cast<int>(i), goal_.step.distance_m));
    assessment::PracticeSight sight{
        far,     {goal_.target_m.data(), static_cast<size_t>(goal_.targets)},
        {},      {},
        {},      {},
        -1,      0,
        nullptr, nullptr,
        nullptr};
    assessment::UndermineSight undermine;
    if (scene_->plane.present()) {
        undermine = look_at_undermining(*scene_, state);
        sight.undermine = &undermine;
    }
    if (wash_.there()) {
        wash_.look(*scene_, state);
        sight.wash = &wash_.sight();
    }
    if (patch_.there()) {
        patch_.look(*scene_, state);
        sight.patch = &patch_.sight();
    }
    // One driver carries its needle about: that is no tissue that it has grasped.
    const bool handled = sim::has_two_drivers(*scene_);
    for (size_t i = 0; i < inputs.size(); ++i) {
        sight.holds[i] = state.grasps[i].count > 0 ||
                         (handled && sim::hold_of(state, static_cast<int>(i)) != nullptr);
        sight.pull_n[i] = state.grasps[i].force_n.norm();
        sight.engaged[i] = inputs[i].engaged != 0;
    }
    look_at_needle(state, sight.needle);
    const int station = tracker_->done() ? -1 : station_[static_cast<size_t>(goal_.index)];
    if (station >= 0) sight.slit_gap_m = sim::narrowest_gap(*scene_, state, station);
    if (!state.suturing.needle.empty() && state.suturing.driver >= 0)
        sight.thread_pull_n = state.suturing.needle[0].thread.ends[1].force_n.norm();
    const std::span<const sim::Event> events = tracker_->see(sight);
    look(state);
    return events;
}

std::span<const sim::Event> PracticeGuide::end(double time_s) noexcept {
    return tracker_ ? tracker_->end(time_s) : std::span<const sim::Event>{};
}

}  // namespace placode::curriculum
