// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "environment/environment.h"

#include <algorithm>
#include <cmath>

#include "curriculum/scene_changes.h"
#include "sim/world/saved_state.h"

namespace placode::environment {

namespace {

using Kind = EnvironmentError::Kind;
using sim::EndReason;
using sim::Vec3;

constexpr int kMostFrames = 60'000;      // a minute in one call
constexpr double kFarM = 0.2;            // farther than this a goal draws no more
constexpr double kApproachUnitM = 0.02;  // so much of the way is worth 1, before the weight

void check_options(const EnvironmentOptions& o) {
    const auto refuse = [](const std::string& what) {
        throw EnvironmentError(Kind::kBadArgument, what);
    };
    if (o.threads < 1 || o.threads > 64) refuse("threads: expected 1 to 64");
    if (!(o.speed_m_s > 0) || o.speed_m_s > kFastestM_S)
        refuse("speed_m_s: expected more than 0, at most 0.3");
    if (!(o.time_limit_s >= 0) || !(o.judge_every_s >= 0) || !std::isfinite(o.approach_weight))
        refuse("time_limit_s, judge_every_s and approach_weight: expected finite numbers from 0");
    if (!(o.start_spread_m >= 0) || o.start_spread_m > 0.01)
        refuse("start_spread_m: expected 0 to 0.01");
}

}  // namespace

Environment::Environment(std::shared_ptr<FieldCache> fields, const std::string& task,
                         const EnvironmentOptions& options)
    : fields_(std::move(fields)), options_(options) {
    check_options(options_);
    task_ = curriculum::load_task(task);
    if (!options_.scene_changes_json.empty())
        task_ = curriculum::with_scene_changes(task_, options_.scene_changes_json);
    names_ =
        environment::observation_names(task_.scene.tools.size(), task_.scene.suture.has_value());
}

Environment::~Environment() = default;

uint64_t Environment::field_seed(uint64_t seed) const {
    return options_.fields == 0 ? seed : 1 + seed % options_.fields;
}

void Environment::enter(const std::shared_ptr<const Field>& field) {
    ++jumps_;
    if (field_ == field && state_) return;
    sight_.reset();
    state_.reset();
    field_ = field;
    state_ = std::make_unique<sim::State>(*field_->scene, options_.threads);
    sight_ = std::make_unique<curriculum::OperatorSight>(*field_->scene);
}

void Environment::reset(uint64_t seed) {
    enter(fields_->field(task_, field_seed(seed)));
    seed_ = seed;
    sim::load_own_state(*state_, field_->settled);
    hands_.emplace(field_->scene->tools);
    hands_->reset(seed, options_.start_spread_m);
    const std::vector<curriculum::TaskStep> steps = curriculum::steps_for(field_->task, "script");
    frames_.emplace(field_->task, steps, *field_->scene, *state_,
                    curriculum::limit_of(field_->task, options_.time_limit_s));
    curriculum::AttemptOptions header_of;
    header_of.device = "environment";
    header_of.demonstration = true;  // nobody takes it for a person's
    book_ = EpisodeBook(
        curriculum::recording_header(field_->task, field_->seed, header_of, *field_->scene),
        options_.record);
    inputs_ = {};
    feedback_ = {};
    frames_->begin(book_);
    judged_ = {};
    end_ = EndReason::kRunning;
    paid_points_ = 0;
    looked_ = -1;
    look_for_goals();
    reached_ = goals_.reached;
    potential_m_ = approach();
}

void Environment::need_begun() const {
    if (!began()) throw EnvironmentError(Kind::kNotReset, "no attempt has begun; call reset first");
}

void Environment::check(std::span<const double> actions, int frames) const {
    need_begun();
    if (ended())
        throw EnvironmentError(Kind::kEnded,
                               "the attempt is over; call reset before the next step");
    const size_t wanted = tools() * kActionSize;
    if (actions.size() != wanted)
        throw EnvironmentError(Kind::kBadArgument,
                               "an action of " + std::to_string(actions.size()) +
                                   " numbers; expected " + std::to_string(wanted) + ": " +
                                   std::to_string(kActionSize) + " for each of " +
                                   std::to_string(tools()) + " tools");
    for (size_t i = 0; i < actions.size(); ++i)
        if (!std::isfinite(actions[i]))
            throw EnvironmentError(Kind::kBadArgument,
                                   "number " + std::to_string(i) + " of the action is not finite");
    if (frames < 1 || frames > kMostFrames)
        throw EnvironmentError(
            Kind::kBadArgument,
            std::to_string(frames) + " frames; expected 1 to " + std::to_string(kMostFrames));
}

StepOutcome Environment::step(std::span<const double> actions, int frames, bool finish) {
    check(actions, frames);
    const size_t count = tools();
    const std::span<const sim::ToolInput> inputs{inputs_.data(), count};
    const double frame_s = field_->task.scene.solver.frame_s;
    hands_->aim(options_.units, options_.speed_m_s, actions, frames, frame_s);
    StepOutcome out;
    while (out.frames < frames && !ended()) {
        ++out.frames;
        hands_->next({inputs_.data(), count});
        const sim::StepReport report =
            frames_->simulate(*state_, inputs, {feedback_.data(), count}, book_);
        frames_->look(*state_, report, inputs, book_);
        end_ = frames_->ended(*state_, inputs, finish && out.frames == frames);
    }
    if (book_.lost()) throw std::bad_alloc();
    if (ended())
        finish_attempt();
    else if (options_.judge_every_s > 0 &&
             state_->time_s - judged_.at_s >= options_.judge_every_s - frame_s / 2)
        judge_now();
    out.end = end_;
    out.success = ended() && judged_.score.verdict == assessment::Verdict::kPassed;
    out.score_part = (judged_.score.points - paid_points_) / 100;
    paid_points_ = judged_.score.points;
    look_for_goals();
    const double now = approach();
    // Something was reached: the way to the next goal begins here.
    if (goals_.reached == reached_ && !ended())
        out.approach_part = options_.approach_weight * (now - potential_m_) / kApproachUnitM;
    reached_ = goals_.reached;
    potential_m_ = now;
    out.reward = options_.sparse ? (ended() ? judged_.score.points / 100 : 0)
                                 : out.score_part + out.approach_part;
    return out;
}

void Environment::finish_attempt() {
    frames_->close(*state_, book_);
    book_.end(frames_->seal(*state_, end_, book_));
    judged_ = judge_finished(field_->task.rubric, book_.recording());
}

void Environment::judge_now() {
    judged_ = judge_unfinished(field_->task.rubric, book_.recording(),
                               frames_->entries_if_closed(*state_), state_->time_s, false);
}

Judgement Environment::judge_in_full() {
    need_begun();
    if (ended()) return judged_;
    return judge_unfinished(field_->task.rubric, book_.recording(),
                            frames_->entries_if_closed(*state_), state_->time_s, true);
}

haptics::Perception Environment::look() {
    need_begun();
    if (looked_ != state_->frame) sight_->look(*state_);
    looked_ = state_->frame;
    haptics::Perception seen = sight_->seen(*state_);
    seen.tools = feedback();
    seen.cut_fraction = static_cast<float>(frames_->cut_fraction());
    seen.practice = frames_->goal();
    return seen;
}

/// Before the first frame instruments are not in the field yet: what counts is where they will be.
std::array<sim::Pose, sim::kMaxTools> Environment::poses() const {
    std::array<sim::Pose, sim::kMaxTools> poses;
    for (size_t i = 0; i < tools(); ++i) poses[i] = state_->tools[i].proxy;
    if (state_->frame > 0) return poses;
    Hands hands = *hands_;
    std::array<sim::ToolInput, sim::kMaxTools> first;
    hands.next({first.data(), tools()});
    for (size_t i = 0; i < tools(); ++i) poses[i] = first[i].pose();
    return poses;
}

void Environment::look_for_goals() {
    std::array<Vec3, sim::kMaxTools> tips;
    const auto now = poses();
    for (size_t i = 0; i < tools(); ++i) tips[i] = now[i].p;
    goals_ = goals_of(field_->scene->tools, look(), {tips.data(), tools()});
}

/// Minus the mean way to the goals [m]: 0 is there.
double Environment::approach() {
    double sum = 0;
    int goals = 0;
    for (size_t i = 0; i < tools(); ++i) {
        if (!goals_.place_m[i]) continue;
        sum += std::min(kFarM, goals_.away_m[i]);
        ++goals;
    }
    return goals == 0 ? 0 : -sum / goals;
}

void Environment::observe(std::span<double> out) {
    need_begun();
    if (out.size() != names_.size())
        throw EnvironmentError(Kind::kBadArgument, "room for " + std::to_string(out.size()) +
                                                       " numbers; an observation has " +
                                                       std::to_string(names_.size()));
    const haptics::Perception seen = look();
    const auto now = poses();
    environment::observe({*field_->scene,
                          *state_,
                          seen,
                          goals_,
                          *hands_,
                          book_,
                          {now.data(), tools()},
                          frames_->time_limit_s(),
                          judged_.score.points},
                         out);
}

const Field& Environment::field() const {
    need_begun();
    return *field_;
}

const sim::State& Environment::state() const {
    need_begun();
    return *state_;
}

std::span<const sim::ToolFeedback> Environment::feedback() const {
    return {feedback_.data(), tools()};
}

std::span<const sim::Event> Environment::events() const { return book_.recording().events; }

const sim::Recording& Environment::recording() const {
    need_begun();
    if (!options_.record)
        throw EnvironmentError(Kind::kBadArgument,
                               "nothing was recorded; make the environment with the option record");
    if (!ended())
        throw EnvironmentError(Kind::kRunning,
                               "the attempt is not over: step with finish, then write it");
    return book_.recording();
}

}  // namespace placode::environment
