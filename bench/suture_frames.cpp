// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// bench contact --scene suture.

#include <algorithm>
#include <array>
#include <cmath>

#include "bench/hard_scenes.h"
#include "curriculum/scene_changes.h"
#include "curriculum/task.h"
#include "sim/anatomy/operative_field.h"
#include "sim/suture/thread_channel.h"

namespace placode::bench {
namespace {

using sim::Pose;
using sim::Vec3;

constexpr double kRowSettleS = 0.3;
constexpr int kBites = 8;
constexpr double kPitchM = 0.003, kFirstY = 0.012;         // the needle's bite is the ninth
constexpr double kMiddleX = 0.009, kHalfWidthM = 0.00335;  // as the marks of suture_run
constexpr double kPassagesM = 6e-4;  // what a channel keeps once the needle has left
constexpr double kTailM = 0.002;     // outside of the first bite, which its stopper comes up to
constexpr double kSpeedM_S = 0.005;  // of the point round its circle
constexpr double kAboveM = 0.001;    // where the point begins
constexpr double kDrawM_S = 0.020;   // of the hand that draws the thread tight
constexpr double kDrawnN = 0.05;     // where it stops
constexpr double kPressM = 0.0003;   // of the second driver, beside the row

struct StateOfRow {
    const char* name;
    enum class Needle { kNowhere, kHovers, kBites, kDraws } needle;
    int counted, end;
};
constexpr std::array<StateOfRow, 4> kRowStates{
    {{"eight bites, needle in the air", StateOfRow::Needle::kHovers, 200, 1400},
     {"eight bites drawn tight", StateOfRow::Needle::kDraws, 2500, 3700},
     {"needle in a ninth bite", StateOfRow::Needle::kBites, 600, 1800},
     {"without needle and thread", StateOfRow::Needle::kNowhere, 200, 1400}}};

/// Without needle and thread the second driver is a probe, for a driver needs a needle.
std::shared_ptr<const sim::Scene> row_field(bool needle) {
    curriculum::Task task = curriculum::with_scene_changes(curriculum::load_task("suture_run"),
                                                           R"({"domain_y_m": 0.031,
                                   "suture": {"thread": {"stopper": true}}})");
    std::vector<sim::ToolSpec>& tools = task.scene.tools;
    sim::ToolSpec second = tools.front();
    second.hand = sim::Hand::kLeft;
    second.pivot_m.y() = -second.pivot_m.y();
    tools.insert(tools.begin() + 1, second);
    if (!needle) {
        task.scene.suture.reset();
        tools[0].kind = tools[1].kind = sim::ToolKind::kProbe;
    }
    return sim::build_operative_field(task.scene);
}

/// The point of the tissue nearest to a place at rest.
sim::TissuePoint nearest_point(const sim::TetMesh& mesh, const Vec3& place) {
    sim::TissuePoint best;
    double out = 1e9;
    for (size_t t = 0; t < mesh.tets.size(); ++t) {
        const auto corner = [&](size_t k) -> const Vec3& {
            return mesh.rest[static_cast<size_t>(mesh.tets[t][k])];
        };
        sim::Mat3 edges;
        edges << corner(1) - corner(0), corner(2) - corner(0), corner(3) - corner(0);
        const Vec3 w = edges.inverse() * (place - corner(0));
        std::array<double, 4> b{1 - w.sum(), w.x(), w.y(), w.z()};
        const double outside = -*std::min_element(b.begin(), b.end());
        if (outside >= out) continue;
        out = outside;
        double sum = 0;
        for (double& one : b) sum += one = std::max(one, 0.0);
        for (double& one : b) one /= sum;
        best = {static_cast<int32_t>(t), b};
    }
    return best;
}

/// One attempt: tissue, needle in the first driver's jaws, thread in eight bites.
class Row {
 public:
    Row(const sim::Scene& scene, int threads)
        : scene_(scene),
          state_(scene, threads),
          radius_m_(scene.suture ? scene.suture->needle().radius_m() : 0.0054),
          centre_z_(std::sqrt(radius_m_ * radius_m_ - kHalfWidthM * kHalfWidthM)),
          begins_(std::asin((centre_z_ - kAboveM) / radius_m_)) {
        sim::settle(scene, state_, kRowSettleS);
    }
    FrameParts measure(const StateOfRow& what, bool quick) {
        const auto hands = [&](int frame, std::vector<sim::ToolInput>& inputs) {
            set_hands(what.needle, frame, inputs);
        };
        if (what.needle != StateOfRow::Needle::kNowhere) {
            // The first frame puts the needle into the jaws.
            (void)measure_hands(scene_, state_, what.name, {0, 0, 1}, hands);
            lay_thread();
        }
        const int end = quick ? what.counted + (what.end - what.counted) / 3 : what.end;
        return measure_hands(scene_, state_, what.name, {1, what.counted, end}, hands);
    }

 private:
    /// The needle upright over its bite, turned forwards by `angle` about its circle's centre.
    [[nodiscard]] Pose needle_at(double angle) const {
        sim::Mat3 upright;
        upright << 1, 0, 0, 0, 0, -1, 0, 1, 0;  // N.x is W.x, N.y is W.z
        const sim::Quat turned(Eigen::AngleAxisd(-angle, Vec3::UnitZ()));
        return {Vec3(kMiddleX, kFirstY - kBites * kPitchM, centre_z_), sim::Quat(upright) * turned};
    }
    void set_hands(StateOfRow::Needle what, int frame, std::vector<sim::ToolInput>& inputs) {
        double angle = begins_;
        if (what == StateOfRow::Needle::kBites) angle += 1e-3 * frame * kSpeedM_S / radius_m_;
        if (what == StateOfRow::Needle::kDraws && state_.suturing.thread_n < kDrawnN)
            drawn_m_ += 1e-3 * kDrawM_S;
        Pose hand = needle_at(angle) * scene_.needle_start.X_TN.inverse();
        hand.p.z() += drawn_m_;
        const Pose presses{Vec3(kMiddleX - 0.006, 0, -kPressM), sim::Quat(0, 1, 0, 0)};
        for (size_t i = 0; i < inputs.size(); ++i) {
            inputs[i].set_pose(i == 0 ? hand : presses);
            inputs[i].jaw_rad = 0;
            inputs[i].engaged = i == 1 || (i == 0 && what != StateOfRow::Needle::kNowhere) ? 1 : 0;
        }
    }
    void lay_thread() {
        const sim::Suture& suture = *scene_.suture;
        sim::SutureState& needle = state_.suturing.needle[0];
        const sim::SuturedTissue tissue{scene_.body, state_.body, scene_.surface, state_.surface};
        const double h = scene_.body.spec().solver.frame_s / state_.substeps;
        const double half = std::asin(kHalfWidthM / radius_m_);
        const int steps = static_cast<int>(std::ceil(2 * half * radius_m_ / kPassagesM));
        for (int bite = 0; bite < kBites; ++bite) {
            std::vector<sim::TissuePoint> points;
            for (int i = 0; i <= steps; ++i) {
                const double a = half * (1 - 2.0 * i / steps);
                points.push_back(
                    nearest_point(scene_.body.mesh(),
                                  Vec3(kMiddleX + radius_m_ * std::sin(a), kFirstY - bite * kPitchM,
                                       centre_z_ - radius_m_ * std::cos(a))));
            }
            lay_channel(suture, needle, tissue, points, h, suture.spec().thread.length_m - kTailM);
        }
        // Its front back onto the swage: what lay in front of the last bite is the way there, and
        // slack.
        sim::ThreadState& thread = needle.thread;
        thread.ends[1].mode = sim::ThreadEndMode::kSwage;
        const Vec3 last =
            place_of(tissue, thread.passages[static_cast<size_t>(thread.passage_count - 1)].at);
        thread.pieces[static_cast<size_t>(thread.channel_count)].stretch_m +=
            sim::thread_path_m(last, swage_m(suture, needle));
    }

    const sim::Scene& scene_;
    sim::State state_;
    double radius_m_, centre_z_, begins_;
    double drawn_m_ = 0;
};

}  // namespace

std::shared_ptr<const sim::Scene> suture_scene() { return row_field(true); }

std::vector<FrameParts> measure_suture_scene(int threads, bool quick) {
    std::vector<FrameParts> all;
    for (const StateOfRow& what : kRowStates) {
        const auto scene = row_field(what.needle != StateOfRow::Needle::kNowhere);
        all.push_back(Row(*scene, threads).measure(what, quick));
    }
    return all;
}

std::span<const HardScene> hard_scenes() noexcept {
    static constexpr HardScene kScenes[] = {{"suture", measure_suture_scene, suture_scene},
                                            {"patch", measure_patch_scene, patch_scene}};
    return kScenes;
}

}  // namespace placode::bench
