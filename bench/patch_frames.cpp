// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// bench contact --scene patch.

#include <algorithm>
#include <array>

#include "bench/hard_scenes.h"
#include "curriculum/scene_changes.h"
#include "curriculum/task.h"
#include "sim/anatomy/operative_field.h"

namespace placode::bench {
namespace {

using sim::Vec3;

constexpr double kJawsOpenRad = 0.6, kJawsShutRad = 0.02, kPatchSettleS = 0.3;
constexpr double kSideX = 0.0115;   // of the patch, 1 mm inside
constexpr double kTakeZ = 0.00045;  // over where the tissue lies below it

/// Where the grasper's tip is at a frame, and how far it is open; straight between two of them.
struct Station {
    int frame;
    Vec3 above;  // over the tissue's height below the patch's side
    double jaw_rad;
};
const std::array<Station, 11> kGrasperWay{
    {{0, {kSideX, 0.006, 0.012}, kJawsOpenRad},
     {4000, {kSideX, 0.006, 0.012}, kJawsOpenRad},
     // Strokes along the middle of it, so that it cannot sleep.
     {4200, {0.004, -0.002, 0.0011}, kJawsShutRad},
     {5000, {0.004, 0.002, 0.0011}, kJawsShutRad},
     {5200, {kSideX, 0, 0.004}, kJawsOpenRad},
     {5400, {kSideX, 0, kTakeZ}, kJawsOpenRad},
     {5600, {kSideX, 0, kTakeZ}, kJawsShutRad},
     {6600, {kSideX - 0.004, 0, 0.014}, kJawsShutRad},
     {8000, {kSideX - 0.004, 0, 0.014}, kJawsShutRad},
     {9200, {kSideX - 0.016, 0, 0.004}, kJawsShutRad},
     {10200, {kSideX - 0.022, 0, 0.002}, kJawsShutRad}}};

struct StateOfPatch {
    const char* name;
    int counted, end;
};
// Each begins where the one before it ends.
constexpr std::array<StateOfPatch, 5> kPatchStates{{{"patch lies", 3400, 4000},
                                                    {"patch is stroked", 4200, 5000},
                                                    {"patch is lifted", 5600, 6600},
                                                    {"patch hangs", 7200, 8000},
                                                    {"patch is dragged over itself", 8600, 10200}}};

curriculum::Task patch_task() {
    return curriculum::with_scene_changes(
        curriculum::load_task("patch_place"),
        R"({"patch": {"length_m": 0.025, "width_m": 0.015, "centre_m": [0, 0]}})");
}

std::shared_ptr<const sim::Scene> patch_field(bool patch) {
    curriculum::Task task = patch_task();
    if (!patch) task.scene.patch.reset();
    return sim::build_operative_field(task.scene);
}

/// Height of the tissue below the side that is taken.
double height_at_side(const sim::Scene& scene, const sim::State& state) {
    double best = 1, z = 0;
    for (int32_t v = 0; v < scene.body.vertex_count(); ++v) {
        if (scene.patch && scene.patch->owns(v)) continue;
        const Vec3 p = position(state.body, v);
        const double away = (p - Vec3(kSideX, 0, 0.01)).norm();
        if (away >= best) continue;
        best = away;
        z = p.z();
    }
    return z;
}

/// Without a patch the jaws stay open: they would take tissue.
void hands_at(int frame, double height_m, bool patch, std::vector<sim::ToolInput>& inputs) {
    size_t next = 1;
    while (next + 1 < kGrasperWay.size() && kGrasperWay[next].frame < frame) ++next;
    const Station &a = kGrasperWay[next - 1], &b = kGrasperWay[next];
    const double share =
        std::clamp(static_cast<double>(frame - a.frame) / (b.frame - a.frame), 0.0, 1.0);
    const Vec3 tip = a.above + share * (b.above - a.above) + Vec3(0, 0, height_m);
    for (size_t i = 0; i < inputs.size(); ++i) {
        inputs[i].engaged = i == 0 ? 1 : 0;
        // A half turn about x: the jaws look down.
        inputs[i].set_pose({i == 0 ? tip : Vec3(0, 0, 0.03), sim::Quat(0, 1, 0, 0)});
        inputs[i].jaw_rad = static_cast<float>(a.jaw_rad + share * (b.jaw_rad - a.jaw_rad));
        if (!patch) inputs[i].jaw_rad = static_cast<float>(kJawsOpenRad);
    }
}

}  // namespace

std::shared_ptr<const sim::Scene> patch_scene() { return patch_field(true); }

std::vector<FrameParts> measure_patch_scene(int threads, bool /*quick*/) {
    std::vector<FrameParts> all;
    for (const bool patch : {true, false}) {
        const auto scene = patch_field(patch);
        sim::State state(*scene, threads);
        sim::settle(*scene, state, kPatchSettleS);
        const double height = height_at_side(*scene, state);
        int first = 0;
        for (const StateOfPatch& one : kPatchStates) {
            const std::string name = patch ? one.name : std::string(one.name) + ": without it";
            all.push_back(measure_hands(*scene, state, name, {first, one.counted, one.end},
                                        [&](int frame, std::vector<sim::ToolInput>& inputs) {
                                            hands_at(frame, height, patch, inputs);
                                        }));
            first = one.end;
        }
    }
    return all;
}

}  // namespace placode::bench
