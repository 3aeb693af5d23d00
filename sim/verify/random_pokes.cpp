// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/verify/random_pokes.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/core/random.h"
#include "sim/world/scene.h"
#include "sim/world/scratch.h"

namespace placode::sim {
namespace {

constexpr double kBin = 1e-6;  // of the histogram of penetrations [m]
constexpr int kBins = 4000;
constexpr double kAway = 0.005;       // the hand withdraws this far above the surface [m]
constexpr double kTravelSpeed = 0.5;  // between two pokes, in the air [m/s]

/// One hand: goes from way point to way point in straight lines.
struct Poker {
    std::vector<Vec3> path;
    size_t next = 0;
    Vec3 at = Vec3::Zero(), axis = -Vec3::UnitZ();  // tip; distal direction
    Vec3 old_axis = -Vec3::UnitZ();                 // turns to `axis` on the first leg, in the air
    double speed = 0.1;
    int wait = 0;
};

/// Place, direction, depth and drag of the next poke.
void plan(const State& state, const PokeOptions& options, SplitMix64& random, Poker& poker) {
    const auto triangles = state.surface.triangles();
    Vec3 target = Vec3::Zero();
    for (int attempt = 0; attempt < 200; ++attempt) {
        const auto i = static_cast<size_t>(random.uniform(0, 1) * triangles.size());
        const auto& v = triangles[std::min(i, triangles.size() - 1)].vertex;
        const Vec3 a = position(state.body, v[0]), b = position(state.body, v[1]),
                   c = position(state.body, v[2]);
        const Vec3 face = (b - a).cross(c - a);
        if (!(face.z() > 0.7 * face.norm())) continue;
        target = (a + b + c) / 3;
        break;
    }
    const double tilt = random.uniform(0, 0.6), turn = random.uniform(0, 6.2831853);
    poker.axis =
        Vec3(std::sin(tilt) * std::cos(turn), std::sin(tilt) * std::sin(turn), -std::cos(tilt));
    const double depth = random.uniform(0, options.deepest_m);
    const double drag = random.uniform(0, 1) < 0.5 ? random.uniform(0, options.longest_drag_m) : 0;
    const double course = random.uniform(0, 6.2831853);
    const Vec3 above = target - kAway * poker.axis, below = target + depth * poker.axis;
    poker.path = {poker.at, above, below};
    if (drag > 0) {
        poker.path.push_back(below + drag * Vec3(std::cos(course), std::sin(course), 0));
    }
    poker.path.push_back(poker.path.back() - (kAway + depth) * poker.axis);
    poker.next = 1;
    poker.speed = 0.02 * std::pow(options.fastest_m_s / 0.02, random.uniform(0, 1));
    poker.wait = static_cast<int>(random.uniform(0, 100));
}

/// Where the instrument points: it turns on the way to the next poke.
Vec3 direction(const Poker& poker) {
    if (poker.next != 1) return poker.axis;
    const double whole = (poker.path[1] - poker.path[0]).norm();
    const double share = whole > 0 ? (poker.at - poker.path[0]).norm() / whole : 1;
    return ((1 - share) * poker.old_axis + share * poker.axis).normalized();
}

/// Moves the hand by one frame; true when the poke is over.
bool advance(Poker& poker, double frame_s) {
    double left = (poker.next == 1 ? kTravelSpeed : poker.speed) * frame_s;
    while (poker.next < poker.path.size()) {
        const Vec3 to = poker.path[poker.next] - poker.at;
        const double length = to.norm();
        if (length > left) {
            poker.at += left / length * to;
            return false;
        }
        poker.at = poker.path[poker.next];
        left -= length;
        if (poker.next == 2 && poker.wait > 0) {
            --poker.wait;
            return false;
        }
        ++poker.next;
    }
    return true;
}

double percentile(const std::vector<int64_t>& histogram, int64_t total, double share) {
    int64_t sum = 0;
    for (size_t i = 0; i < histogram.size(); ++i) {
        sum += histogram[i];
        if (static_cast<double>(sum) >= share * static_cast<double>(total)) {
            return kBin * static_cast<double>(i + 1);
        }
    }
    return kBin * kBins;
}

}  // namespace

double penetration(const State& state, int tool, double reach_m) {
    const ToolShape& shape = state.scratch->contacts.shapes[tool];
    const Pose to_tool = state.tools[tool].proxy.inverse();
    double deepest = -reach_m;
    state.surface.tree().walk(
        [&](const SurfaceTree::Box& box) {
            const Vec3 low(box.low[0], box.low[1], box.low[2]);
            const Vec3 high(box.high[0], box.high[1], box.high[2]);
            // Boxes are those of the frame's start: a little larger.
            return signed_distance(shape, to_tool * Vec3(0.5 * (low + high))).value_m >
                   reach_m + 0.5 * (high - low).norm() + 0.001;
        },
        [&](int i) {
            Triangle x, x_T;
            for (int k = 0; k < 3; ++k) {
                x[k] = position(state.body, state.surface.triangles()[i].vertex[k]);
                x_T[k] = to_tool * x[k];
            }
            const TriangleDistance d = nearest_on_triangle(shape, x_T, reach_m);
            if (d.part < 0) return;
            const Vec3 face = (x[1] - x[0]).cross(x[2] - x[0]).normalized();
            if (!d.pierced && (state.tools[tool].proxy.q * d.gradient).dot(face) > 0) return;
            deepest = std::max(deepest, -d.value_m);
        });
    return deepest;
}

PokeReport random_pokes(const Scene& scene, State& state, const PokeOptions& options) {
    PokeReport report;
    SplitMix64 random(options.seed);
    const size_t tools = scene.tools.size();
    std::vector<Poker> pokers(tools);
    std::vector<ToolInput> inputs(tools);
    std::vector<ToolFeedback> feedback(tools);
    std::vector<int64_t> histogram(kBins, 0);
    const double frame_s = scene.body.spec().solver.frame_s;
    for (Poker& poker : pokers) {
        poker.at = Vec3(0, 0, 0.010);
        plan(state, options, random, poker);
    }
    for (; report.frames < options.frames; ++report.frames) {
        for (size_t t = 0; t < tools; ++t) {
            if (scene.tools[t].kind == ToolKind::kScope) continue;
            if (advance(pokers[t], frame_s)) plan(state, options, random, pokers[t]);
            inputs[t].set_pose(
                {pokers[t].at, Quat::FromTwoVectors(Vec3::UnitZ(), direction(pokers[t]))});
            inputs[t].engaged = 1;
        }
        const StepReport step_report = step(scene, state, inputs, feedback);
        report.not_finite += (step_report.flags & kNotFinite) != 0;
        report.dropped += (step_report.flags & kContactsDropped) != 0;
        report.step_limited += (step_report.flags & kStepLimited) != 0;
        double deepest = -1;
        for (size_t t = 0; t < tools; ++t) {
            if (!inputs[t].engaged) continue;
            report.largest_force_n = std::max(report.largest_force_n, feedback[t].force_n.norm());
            deepest = std::max(deepest, penetration(state, static_cast<int>(t), 1e-4));
        }
        if (deepest > 0) {
            ++report.touching;
            const double bin = std::min(deepest / kBin, kBins - 1.0);
            ++histogram[static_cast<size_t>(bin)];
            if (deepest > report.deepest_m) {
                report.deepest_m = deepest;
                report.deepest_frame = report.frames;
            }
        }
        if (report.frames % 16 == 0) {
            for (const Float4& v : state.body.v) {
                const double speed =
                    std::sqrt(static_cast<double>(v.x * v.x + v.y * v.y + v.z * v.z));
                report.fastest_m_s = std::max(report.fastest_m_s, speed);
            }
        }
        if (options.progress && (report.frames + 1) % 10000 == 0) {
            options.progress(report.frames + 1);
        }
    }
    report.median_m = percentile(histogram, report.touching, 0.5);
    report.p99_m = percentile(histogram, report.touching, 0.99);
    report.p999_m = percentile(histogram, report.touching, 0.999);
    return report;
}

}  // namespace placode::sim
