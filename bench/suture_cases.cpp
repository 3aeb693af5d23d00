// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/suture_cases.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "curriculum/scene_changes.h"
#include "curriculum/task.h"
#include "environment/environment.h"
#include "environment/expert.h"
#include "sim/anatomy/operative_field.h"
#include "sim/core/number_text.h"
#include "sim/core/random.h"
#include "sim/step/step.h"

namespace placode::bench {
namespace {

using sim::EventKind;
using sim::Pose;
using sim::StabilityVerdict;
using sim::Vec3;

constexpr const char* kTask = "suture_bite";
constexpr double kStillM = 1e-5;    // what lies still moves less
constexpr double kBackM = 2e-4;     // the surface, from where it lay before the needle came
constexpr double kBoundsM = 0.020;  // no part of the tissue gets so far from its place
constexpr double kCalmM_S = 0.01;   // what has come to rest is no faster
constexpr double kReachM = 0.045;  // what hangs on follows a hand, a needle's length and no farther
constexpr int64_t kFramesOfABite = 4000;
constexpr double kOpenRad = 0.6;
constexpr double kIntoBiteS = 0.25;  // after the point went in

/// What the scripted expert's hand asks, frame by frame, and what happened.
struct Bite {
    uint64_t seed = 1;  ///< Of the field.
    std::vector<sim::Input> inputs;
    std::vector<sim::Event> events;
    [[nodiscard]] double time_of(EventKind kind) const {
        for (const sim::Event& event : events)
            if (event.kind == kind) return event.time_s;
        throw std::runtime_error(std::string("the scripted expert's bite has no event: ") +
                                 std::string(sim::event_name(kind)));
    }
};

const Bite& experts_bite() {
    static const Bite bite = [] {
        environment::EnvironmentOptions options;
        options.units = environment::ActionUnits::kAbsolute;
        options.record = true;
        options.judge_every_s = 0;
        environment::Environment world(std::make_shared<environment::FieldCache>(), kTask, options);
        world.reset(1);
        environment::Expert expert(world, "expert", 1);
        std::vector<double> action(world.tools() * environment::kActionSize);
        while (!world.ended()) {
            const bool done = expert.act(world, 10, action);
            (void)world.step(action, 10, done);
        }
        const sim::Recording& recording = world.recording();
        return Bite{recording.header.seed, recording.inputs, recording.events};
    }();
    return bite;
}

/// The field with its needle, in the hands of a case.
class Stage {
 public:
    explicit Stage(const char* changes = "{}")
        : task_(task_with(changes)),
          scene_(sim::build_operative_field(task_.scene)),
          state_(std::make_unique<sim::State>(*scene_, 1)),
          inputs_(scene_->tools.size()),
          feedback_(inputs_.size()) {
        sim::settle(*scene_, *state_, task_.settle_s);
        for (size_t i = 0; i < inputs_.size(); ++i)
            if (scene_->tools[i].kind == sim::ToolKind::kNeedleDriver) driver_ = i;
        at_rest_.assign(state_->body.x.begin(), state_->body.x.end());
    }

    /// Does what the expert did until `time_s`.
    void bite_until(double time_s) {
        for (const sim::Input& input : experts_bite().inputs) {
            if (state_->time_s >= time_s) return;
            std::copy_n(input.tools, inputs_.size(), inputs_.begin());
            frame();
        }
        throw std::runtime_error("the scripted expert's bite ended too early");
    }
    /// Changes what the driver's hand asks.
    void hand(const Pose& X_WT, double jaw_rad, bool engaged = true) {
        inputs_[driver_].set_pose(X_WT);
        inputs_[driver_].jaw_rad = static_cast<float>(jaw_rad);
        inputs_[driver_].engaged = engaged ? 1 : 0;
    }
    void frame() {
        const sim::StepReport report = sim::step(*scene_, *state_, inputs_, feedback_);
        const bool not_finite = (report.flags & sim::kNotFinite) != 0;
        if (not_finite || !needle().needle.p.allFinite()) finite_ = false;
        for (int i = 0; i < state_->event_count; ++i) {
            const EventKind kind = state_->events[static_cast<size_t>(i)].kind;
            torn_ += kind == EventKind::kTorn ? 1 : 0;
            cuts_ += kind == EventKind::kThreadCut || kind == EventKind::kThreadToreOut ? 1 : 0;
            dropped_ += kind == EventKind::kNeedleReleased ? 1 : 0;
        }
        if (state_->frame % 10 == 0) farthest_m_ = std::max(farthest_m_, farthest());
    }
    void frames(double seconds) {
        const auto count = std::llround(seconds / scene_->body.spec().solver.frame_s);
        for (int64_t n = 0; n < count; ++n) frame();
    }

    /// Largest way of tissue that something holds from where it lay before anything came; what was
    /// torn off drifts or goes where it is drawn.
    [[nodiscard]] double farthest() const {
        double most = 0;
        const sim::SoftBodyState& body = state_->body;
        for (int32_t t = 0; t < scene_->body.tet_count(); ++t) {
            const auto at = static_cast<size_t>(t);
            if (body.tet_alive[at] == 0 || state_->pieces.of[at] >= 0) continue;
            for (const int32_t v : corners(scene_->body, body, t)) {
                // Copies that cuts and tears made began at another vertex's place.
                const auto n = static_cast<size_t>(v);
                if (n >= at_rest_.size() || body.free_vertex[n] != 0) continue;
                const double way = (to_vec(body.x[n]) - to_vec(at_rest_[n])).norm();
                most = std::isfinite(way) ? std::max(most, way) : 1;
            }
        }
        return most;
    }
    /// Speed of the fastest vertex that anything holds; crumbs drift.
    [[nodiscard]] double fastest() const {
        double most = 0;
        const sim::SoftBodyState& body = state_->body;
        for (size_t v = 0; v < body.v.size(); ++v) {
            const double speed = to_vec(body.v[v]).norm();
            if (!std::isfinite(speed)) return 1e3;
            if (body.free_vertex[v] == 0) most = std::max(most, speed);
        }
        return most;
    }
    [[nodiscard]] const sim::SutureState& needle() const { return state_->suturing.needle[0]; }
    [[nodiscard]] const sim::Suturing& suturing() const { return state_->suturing; }
    [[nodiscard]] Pose hand_pose() const { return inputs_[driver_].pose(); }
    [[nodiscard]] bool finite() const { return finite_; }
    [[nodiscard]] double farthest_ever() const { return farthest_m_; }
    [[nodiscard]] int cuts() const { return cuts_; }
    [[nodiscard]] int torn() const { return torn_; }
    [[nodiscard]] int dropped() const { return dropped_; }

 private:
    static curriculum::Task task_with(const char* changes) {
        curriculum::Task task =
            curriculum::with_scene_changes(curriculum::load_task(kTask), changes);
        task.scene.seed = experts_bite().seed;
        return task;
    }

    curriculum::Task task_;
    std::shared_ptr<const sim::Scene> scene_;
    std::unique_ptr<sim::State> state_;
    std::vector<sim::ToolInput> inputs_;
    std::vector<sim::ToolFeedback> feedback_;
    std::vector<sim::Float4> at_rest_;
    size_t driver_ = 0;
    bool finite_ = true;
    double farthest_m_ = 0;
    int cuts_ = 0, torn_ = 0, dropped_ = 0;
};

std::string millimetres(double metres) { return sim::rounded_text(1000 * metres, 3) + " mm"; }

void judge(sim::StabilityResult& result, const Stage& stage, bool good, const std::string& detail) {
    result.detail = detail + "; tissue at most " + millimetres(stage.farthest_ever()) + " away";
    const bool sound = stage.finite() && stage.farthest_ever() < kBoundsM;
    result.verdict = sound && good ? StabilityVerdict::kHolds : StabilityVerdict::kFails;
    if (!stage.finite()) result.detail += "; not finite";
}

/// The jaws open in the middle of a bite, and the driver leaves.
void let_go(sim::StabilityResult& result, double seconds) {
    Stage stage;
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
    Stage stage;
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
    Stage stage(R"({"suture": {"thread": {"length_m": 0.03, "stopper": true}}})");
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
void throw_about(Stage& stage, sim::SplitMix64& random, int64_t frames) {
    Pose now = stage.hand_pose();
    for (int64_t done = 0; done < frames;) {
        const Vec3 goal(random.uniform(-0.012, 0.012), random.uniform(-0.012, 0.012),
                        random.uniform(-0.002, 0.020));
        const Vec3 axis(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.1, 1));
        const sim::Quat turn(Eigen::AngleAxisd(random.uniform(-1.5, 1.5), axis.normalized()));
        const sim::Quat to = (turn * now.q).normalized();
        const double jaw = random.uniform(0, 1) < 0.1 ? kOpenRad : 0;
        const bool engaged = random.uniform(0, 1) < 0.95;
        const int way = 20 + static_cast<int>(random.uniform(0, 400));
        const Pose from = now;
        for (int n = 1; n <= way && done < frames; ++n, ++done) {
            const double share = static_cast<double>(n) / way;
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
        Stage stage(R"({"suture": {"thread": {"length_m": 0.05, "stopper": true}}})");
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

}  // namespace

std::vector<std::string> suture_case_names() {
    return {"needle let go in a bite", "needle torn away", "thread pulled until tissue gives",
            "random hand at needle and thread"};
}

sim::StabilityResult run_suture_case(const std::string& name,
                                     const sim::StabilityOptions& options) {
    sim::StabilityResult result;
    result.name = name;
    result.method = "vbd";  // needle and thread are blocks of its descent
    const auto names = suture_case_names();
    if (name == names[0])
        let_go(result, options.rest_seconds);
    else if (name == names[1])
        torn_away(result, options.seconds);
    else if (name == names[2])
        pulled_through(result, options.seconds);
    else if (name == names[3])
        without_sense(result, options);
    else
        throw std::invalid_argument("no stability case named " + name);
    return result;
}

}  // namespace placode::bench
