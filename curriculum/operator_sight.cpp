// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/operator_sight.h"

#include <algorithm>
#include <cmath>

#include "curriculum/wash_watch.h"
#include "sim/cutting/diathermy.h"

namespace placode::curriculum {

namespace {

using sim::Vec3;

constexpr double kPieceShare = 0.3;   // of the marked volume: less is a shred, not the piece
constexpr double kBegunShare = 0.85;  // of the marked volume left: look anew where to take hold
constexpr double kAboutM = 5e-4;      // around the place to take hold: how high the tissue is there

/// Some of the needle is; drawn through both walls of a slit it leaves one before the other.
bool in_tissue(const sim::Suturing& suturing) noexcept {
    return suturing.placed != 0 && suturing.needle[0].passage_count > 0;
}

}  // namespace

OperatorSight::OperatorSight(const sim::Scene& scene)
    : scene_(scene),
      contour_(scene.contour_anchors.size(), Vec3::Zero()),
      contour_normal_(scene.contour_anchors.size(), Vec3::UnitZ()),
      outline_(scene.resection.anchors.size(), Vec3::Zero()),
      outline_normal_(scene.resection.anchors.size(), Vec3::UnitZ()),
      grasp_place_(1, Vec3::Zero()),
      grasp_normal_(1, Vec3::UnitZ()),
      patch_(sim::patch_handles(scene)) {
    for (size_t t = 0; t < scene.marked.size(); ++t) {
        if (scene.marked[t]) marked_.push_back(static_cast<int32_t>(t));
    }
    const sim::TetMesh& mesh = scene.body.mesh();
    for (size_t t = 0; t < mesh.tets.size() && t < mesh.tissue.size(); ++t) {
        if (mesh.tissue[t] != sim::Tissue::kPlacode) continue;
        placode_vertices_.insert(placode_vertices_.end(), mesh.tets[t].begin(), mesh.tets[t].end());
    }
    std::sort(placode_vertices_.begin(), placode_vertices_.end());
    placode_vertices_.erase(std::unique(placode_vertices_.begin(), placode_vertices_.end()),
                            placode_vertices_.end());
    placode_gap_m_.fill(1);
    placode_metal_gap_m_.fill(1);
}

/// Where points of a line lie now, and the normals there.
void OperatorSight::look_at(const sim::State& state, std::span<const sim::ContourAnchor> anchors,
                            std::vector<Vec3>& points, std::vector<Vec3>& normals) const noexcept {
    for (size_t i = 0; i < points.size(); ++i) {
        const auto& v = anchors[i].vertex;
        const Vec3 a = to_vec(state.body.x[static_cast<size_t>(v[0])]);
        const Vec3 b = to_vec(state.body.x[static_cast<size_t>(v[1])]);
        const Vec3 c = to_vec(state.body.x[static_cast<size_t>(v[2])]);
        const auto& w = anchors[i].weight;
        points[i] = static_cast<double>(w[0]) * a + static_cast<double>(w[1]) * b +
                    static_cast<double>(w[2]) * c;
        const Vec3 normal = (b - a).cross(c - a);
        if (normal.squaredNorm() > 0) normals[i] = normal.normalized();
    }
}

/// How much of the marked tissue still hangs on, how much lies loose in the jaws, and, once part of
/// it is gone, where to take hold of the rest: at its middle.
void OperatorSight::look_at_marked(const sim::State& state) noexcept {
    if (marked_.empty() || scene_.marked_volume_m3 <= 0) return;
    double left = 0, held = 0;
    Vec3 middle = Vec3::Zero();
    const auto centre = [&](int32_t t) {
        Vec3 sum = Vec3::Zero();
        for (const int32_t v : corners(scene_.body, state.body, t)) {
            sum += to_vec(state.body.x[static_cast<size_t>(v)]) / 4;
        }
        return sum;
    };
    const auto hangs_on = [&](int32_t t) {
        return state.body.tet_alive[static_cast<size_t>(t)] &&
               state.pieces.of[static_cast<size_t>(t)] < 0;
    };
    for (const int32_t t : marked_) {
        if (!state.body.tet_alive[static_cast<size_t>(t)]) continue;
        const double volume = static_cast<double>(scene_.body.volume_m3()[static_cast<size_t>(t)]);
        const int piece = state.pieces.of[static_cast<size_t>(t)];
        if (piece >= 0) {
            if (state.pieces.list[piece].held_by >= 0) held += volume;
            continue;
        }
        left += volume;
        middle += volume * centre(t);
    }
    left_share_ = left / scene_.marked_volume_m3;
    held_share_ = held / scene_.marked_volume_m3;
    if (left <= 0 || left_share_ > kBegunShare) return;
    middle /= left;
    // The tissue nearest to the middle, which may itself lie beside a curved rest, at its surface.
    double nearest = 1;
    Vec3 place = middle;
    for (const int32_t t : marked_) {
        if (!hangs_on(t)) continue;
        const Vec3 c = centre(t);
        const double away = (c - middle).head<2>().norm();
        if (away < nearest) {
            nearest = away;
            place = c;
        }
    }
    for (const int32_t t : marked_) {
        if (!hangs_on(t)) continue;
        const Vec3 c = centre(t);
        if ((c - place).head<2>().norm() < kAboutM) place.z() = std::max(place.z(), c.z());
    }
    grasp_place_[0] = place;
}

/// The placode is red, what surrounds it is not: how near it is to each tip, to all that lies
/// between the blades of scissors, and to the bare metal of a needle, whose flank burns as well.
void OperatorSight::look_at_placode(const sim::State& state) noexcept {
    for (size_t i = 0; i < scene_.tools.size(); ++i) {
        const sim::ToolSpec& tool = scene_.tools[i];
        if (tool.kind == sim::ToolKind::kScope) continue;
        const bool blades = tool.kind == sim::ToolKind::kScissors;
        const double length = blades ? tool.tip_length_m : 0;
        const double slope = blades ? std::tan(state.scissors[i].jaw_rad / 2) : 0;
        const sim::Pose to_tool = state.tools[i].proxy.inverse();
        const bool bare = conducts(tool.kind);
        double squared = 1, metal = 1;
        for (const int32_t v : placode_vertices_) {
            const Vec3 p = to_tool * to_vec(state.body.x[static_cast<size_t>(v)]);
            const double z = std::clamp(p.z(), -length, 0.0), wide = slope * (length + z);
            const Vec3 nearest(0, std::clamp(p.y(), -wide, wide), z);
            squared = std::min(squared, (p - nearest).squaredNorm());
            if (!bare) continue;
            const Vec3 axis(0, 0, std::clamp(p.z(), -tool.tip_length_m, 0.0));
            metal = std::min(metal, (p - axis).squaredNorm());
        }
        placode_gap_m_[i] = std::sqrt(squared) - tool.tip_radius_m;
        placode_metal_gap_m_[i] = bare ? std::sqrt(metal) - tool.tip_radius_m : 1;
    }
}

void OperatorSight::look(const sim::State& state) noexcept {
    look_at_placode(state);
    if (!in_tissue(state.suturing)) drawn_through_ = state.suturing.through;
    look_at(state, scene_.contour_anchors, contour_, contour_normal_);
    look_at(state, scene_.resection.anchors, outline_, outline_normal_);
    if (outline_.empty()) return;
    look_at(state, {&scene_.resection.grasp_anchor, 1}, grasp_place_, grasp_normal_);
    look_at_marked(state);
}

haptics::Perception OperatorSight::seen(const sim::State& state) const noexcept {
    haptics::Perception seen;
    seen.time_s = state.time_s;
    seen.contour = contour_;
    seen.contour_normal = contour_normal_;
    seen.contour_cut = state.progress.cut;
    seen.sector_free = state.release.free;
    seen.released = static_cast<float>(state.release.free_count) / sim::kSectors;
    for (size_t i = 0; i < scene_.tools.size(); ++i) {
        if (scene_.tools[i].kind == sim::ToolKind::kScope) continue;
        seen.in_contact = state.tools[i].in_contact != 0;
        seen.tip_gap_m = state.tools[i].tip_gap_m;
        break;
    }
    seen.outline = outline_;
    seen.outline_normal = outline_normal_;
    seen.outline_cut = state.resection.cut;
    seen.grasp_place_m = grasp_place_[0];
    seen.placode_gap_m = placode_gap_m_;
    seen.placode_metal_gap_m = placode_metal_gap_m_;
    seen.marked_left = left_share_;
    seen.marked_held = held_share_;
    for (size_t i = 0; i < scene_.tools.size(); ++i) {
        seen.touches[i] = state.tools[i].in_contact != 0;
        seen.holds[i] = state.grasps[i].count > 0;
        seen.pull_n[i] = state.grasps[i].force_n.norm();
    }
    for (const sim::Piece& piece : state.pieces.list) {
        seen.piece_free =
            seen.piece_free || (piece.tets > 0 && piece.held_by >= 0 &&
                                piece.volume_m3 > kPieceShare * scene_.marked_volume_m3);
    }
    seen.pieces_out = state.pieces.out;
    seen.patch = patch_.middle >= 0;
    for (size_t i = 0; seen.patch && i < patch_.corner.size(); ++i)
        seen.patch_corner_m[i] = position(state.body, patch_.corner[i]);
    if (scene_.irrigation) {
        const WashNow wash = look_at_wash(scene_, state);
        seen.stuck_left = wash.sight.stuck;
        seen.floating_left = wash.sight.loose;
        seen.standing_m3 = wash.sight.standing_m3;
        seen.hidden = state.irrigation.hidden;
        seen.stuck_m = wash.stuck_m;
        seen.fluid_m = wash.fluid_m;
    }
    const sim::Suturing& suturing = state.suturing;
    if (suturing.placed != 0) {
        seen.needle = true;
        seen.needle_held = suturing.driver >= 0;
        for (size_t i = 0; i < scene_.tools.size(); ++i)
            seen.holds_needle[i] = sim::hold_of(state, static_cast<int>(i)) != nullptr;
        seen.X_WN = suturing.needle[0].needle;
        seen.needle_arc_m = scene_.suture->needle().arc_m();
        seen.bites = suturing.entered;
        seen.exits = suturing.left;
        seen.drawn_through = in_tissue(suturing) ? drawn_through_ : suturing.through;
    }
    return seen;
}

}  // namespace placode::curriculum
