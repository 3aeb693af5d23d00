// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/patch_watch.h"

#include <algorithm>
#include <numeric>

namespace placode::curriculum {
namespace {

constexpr int kWays = 6;  // to either side of straight outwards: 0.9 % are missed at most

static_assert(sim::kTraceBins == sim::kPatchEdgePoints, "the goal shows one place for each point");

}  // namespace

PatchWatch::PatchWatch(const sim::Scene& scene, double overlap_m)
    : cover_(scene), overlap_m_(overlap_m) {
    if (!cover_.there()) return;
    for (size_t i = 0; i < cover_.edge().size(); ++i) {
        const sim::EdgePoint& point = cover_.edge()[i];
        height_m_[i] =
            static_cast<float>(sim::height_at_rest(scene, point.at_m + overlap_m_ * point.outward));
    }
    // Until all of it was seen it is not known to lie well.
    folded_m2_.assign(cover_.sheet().faces(), 1);
    area_m2_.assign(cover_.sheet().faces(), 1);
}

void PatchWatch::look(const sim::Scene& scene, const sim::State& state) noexcept {
    cover_.look(scene, state);
    sim::SheetCover& sheet = cover_.sheet();
    const auto& edge = cover_.edge();
    for (size_t i = round_; i < edge.size(); i += kRounds)
        laid_[i] =
            sheet.margin(edge[i].at_m, edge[i].outward, kWays, overlap_m_) >= overlap_m_ ? 1 : 0;
    const sim::Vec3 most_look = sheet.most_look();
    for (size_t t = round_; t < sheet.faces(); t += kRounds) {
        area_m2_[t] = static_cast<float>(sheet.area_m2(t));
        folded_m2_[t] = static_cast<float>(sheet.area_m2(t) * sheet.folded(t, most_look));
    }
    round_ = (round_ + 1) % kRounds;
    sight_.overlapped =
        static_cast<double>(std::count(laid_.begin(), laid_.end(), 1)) / sim::kPatchEdgePoints;
    const double whole = std::accumulate(area_m2_.begin(), area_m2_.end(), 0.0);
    sight_.folded = std::accumulate(folded_m2_.begin(), folded_m2_.end(), 0.0) / whole;
    for (size_t i = 0; i < scene.tools.size(); ++i) {
        const sim::Grasp& grasp = state.grasps[i];
        const auto held = std::span(grasp.held).first(static_cast<size_t>(grasp.count));
        sight_.held[i] = std::any_of(held.begin(), held.end(), [&](const sim::GraspedVertex& one) {
            return scene.patch->owns(one.vertex);
        });
    }
}

void PatchWatch::show(sim::PracticeGoal& goal) const noexcept {
    goal.traced = laid_;
    goal.margin = true;
    for (size_t i = 0; i < cover_.edge().size(); ++i) {
        const sim::EdgePoint& point = cover_.edge()[i];
        const sim::Vec2 at = point.at_m + overlap_m_ * point.outward;
        goal.margin_m[i] = {static_cast<float>(at.x()), static_cast<float>(at.y()), height_m_[i]};
    }
}

}  // namespace placode::curriculum
