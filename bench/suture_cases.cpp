// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "bench/hard_case.h"
#include "bench/suture_stage.h"
#include "sim/core/number_text.h"
#include "sim/core/random.h"

namespace placode::bench {
namespace {

using sim::EventKind;
using sim::Pose;
using sim::StabilityVerdict;
using sim::Vec3;

constexpr double kStillM = 1e-5;    // what lies still moves less
constexpr double kBackM = 2e-4;     // the surface, from where it lay before the needle came
constexpr double kBoundsM = 0.020;  // no part of the tissue gets so far from its place
constexpr double kReachM = 0.045;  // what hangs on follows a hand, a needle's length and no farther
constexpr int64_t kFramesOfABite = 4000;
constexpr double kOpenRad = 0.6;
constexpr double kIntoBiteS = 0.25;  // after the point went in

void judge(sim::StabilityResult& result, const SutureStage& stage, bool good,
           const std::string& detail) {
    result.detail = detail + "; tissue at most " + millimetres(stage.farthest_ever()) + " away";
    const bool sound = stage.finite() && stage.farthest_ever() < kBoundsM;
    result.verdict = sound && good ? StabilityVerdict::kHolds : StabilityVerdict::kFails;
    if (!stage.finite()) result.detail += "; not finite";
}

/// The jaws open in the middle of a bite, and the driver leaves.
void let_go(sim::StabilityResult& result, double seconds) {
    SutureStage stage;
    stage.bite_until(experts_bite().time_of(EventKind::kNeedleEntered) + kIntoBiteS);
    Pose pose = stage.hand_pose();
    stage.hand(pose, kOpenRad);
    stage.frames(0.3);
    const Vec3 back = pose.q * Vec3(0, 0, -0.015);
    for (int n = 0; n < 500; ++n) {
        stage.hand({pose.p + n / 500.0 * back, pose.q}, kOpenRad);
        stage.frame();
    }
    stage.frames(1);
    const Vec3 there = stage.needle().needle.p;
    stage.frames(seconds);
    result.error = (stage.needle().needle.p - there).norm();
    judge(result, stage, stage.suturing().driver < 0 && result.error < kStillM,
          "moved " + sim::rounded_text(1e6 * result.error, 3) + " um in " +
              sim::rounded_text(seconds, 3) + " s");
}

/// The hand jumps away in one frame with the needle half through.
void torn_away(sim::StabilityResult& result, double seconds) {
    SutureStage stage;
    stage.bite_until(experts_bite().time_of(EventKind::kNeedleEntered) + kIntoBiteS);
    const Pose pose = stage.hand_pose();
    stage.hand({pose.p + Vec3(0.004, 0.010, 0.020), pose.q}, 0);
    stage.frames(1);
    stage.hand(stage.hand_pose(), kOpenRad, false);
    stage.frames(seconds);
    result.error = stage.farthest();
    // A needle that is still in the tissue bends it; one that came out lets it go back.
    const bool out = stage.needle().passage_count == 0;
    judge(result, stage, result.error < (out ? kBackM : 10 * kBackM),
          std::string(out ? "needle torn out" : "needle still in the tissue") +
              ", surface back to " + millimetres(result.error));
}

/// A thread with a stopper at its tail, through the bite, pulled on until the tissue gives.
void pulled_through(sim::StabilityResult& result, double seconds) {
    SutureStage stage(R"({"suture": {"thread": {"length_m": 0.03, "stopper": true}}})");
    stage.bite_until(experts_bite().time_of(EventKind::kNeedleThrough));
    const Pose pose = stage.hand_pose();
    double thread_n = 0;
    for (int n = 0; n < 4000; ++n) {
        stage.hand({pose.p + Vec3(0, 0, 1.5e-5 * n), pose.q}, 0);
        stage.frame();
        thread_n = std::max(thread_n, static_cast<double>(stage.suturing().thread_n));
    }
    const double left_n = static_cast<double>(stage.suturing().thread_n);
    stage.frames(std::max(3.0, seconds));
    result.error = stage.fastest();
    // What was torn off follows the thread; what matters is that all of it comes to rest.
    result.detail = "thread pulled with " + sim::rounded_text(thread_n, 3) + " N, then with " +
                    sim::rounded_text(left_n, 2) + " N: cut through " +
                    std::to_string(stage.cuts()) + " times, " + std::to_string(stage.torn()) +
                    " tets torn; fastest at the end " + sim::rounded_text(1000 * result.error, 2) +
                    " mm/s";
    const bool gave = stage.cuts() + stage.torn() > 0 && left_n < 0.1 * thread_n;
    result.verdict = stage.finite() && gave && result.error < kCalmM_S ? StabilityVerdict::kHolds
                                                                       : StabilityVerdict::kFails;
}

/// Any pose near the pad at up to 0.5 m/s, jaws open and closed, the hand on and off; from a bite.
void throw_about(SutureStage& stage, sim::SplitMix64& random, int64_t frames) {
    Pose now = stage.hand_pose();
    for (int64_t done = 0; done < frames;) {
        const Vec3 goal(random.uniform(-0.012, 0.012), random.uniform(-0.012, 0.012),
                        random.uniform(-0.002, 0.020));
        const Vec3 axis(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.1, 1));
        const sim::Quat turn(Eigen::AngleAxisd(random.uniform(-1.5, 1.5), axis.normalized()));
        const sim::Quat to = (turn * now.q).normalized();
        const double jaw = random.uniform(0, 1) < 0.1 ? kOpenRad : 0;
        const bool engaged = random.uniform(0, 1) < 0.95;
        const int path = 20 + static_cast<int>(random.uniform(0, 400));
        const Pose from = now;
        for (int n = 1; n <= path && done < frames; ++n, ++done) {
            const double share = static_cast<double>(n) / path;
            now = {from.p + share * (goal - from.p), from.q.slerp(share, to)};
            stage.hand(now, jaw, engaged);
            stage.frame();
        }
    }
}

/// Again and again from a bite, for a needle that was dropped is seldom met by chance.
void without_sense(sim::StabilityResult& result, const sim::StabilityOptions& options) {
    sim::SplitMix64 random(1);
    int64_t done = 0;
    int bites = 0, dropped = 0, cuts = 0, torn = 0;
    bool finite = true;
    while (done < options.poke_frames) {
        SutureStage stage(R"({"suture": {"thread": {"length_m": 0.05, "stopper": true}}})");
        stage.bite_until(experts_bite().time_of(EventKind::kNeedleEntered) +
                         kIntoBiteS * random.uniform(0, 8));
        const int64_t frames = std::min(kFramesOfABite, options.poke_frames - done);
        throw_about(stage, random, frames);
        done += frames;
        ++bites;
        dropped += stage.dropped();
        cuts += stage.cuts();
        torn += stage.torn();
        finite = finite && stage.finite();
        result.error = std::max(result.error, stage.farthest_ever());
        if (options.progress && bites % 10 == 0)
            options.progress("needle and thread without sense: " + std::to_string(done) +
                             " frames");
    }
    result.verdict =
        finite && result.error < kReachM ? StabilityVerdict::kHolds : StabilityVerdict::kFails;
    result.detail = std::to_string(done) + " frames from " + std::to_string(bites) +
                    " bites, needle let go " + std::to_string(dropped) +
                    " times, thread cut through " + std::to_string(cuts) + " times, " +
                    std::to_string(torn) + " tets torn; tissue that hangs on at most " +
                    millimetres(result.error) + " away" + (finite ? "" : "; not finite");
}

constexpr HardCase kSutureCases[]{
    {"needle let go in a bite",
     [](sim::StabilityResult& result, const sim::StabilityOptions& options) {
         let_go(result, options.rest_seconds);
     }},
    {"needle torn away",
     [](sim::StabilityResult& result, const sim::StabilityOptions& options) {
         torn_away(result, options.seconds);
     }},
    {"thread pulled until tissue gives",
     [](sim::StabilityResult& result, const sim::StabilityOptions& options) {
         pulled_through(result, options.seconds);
     }},
    {"random hand at needle and thread", without_sense}};

}  // namespace

std::span<const HardCase> suture_cases() { return kSutureCases; }

}  // namespace placode::bench
