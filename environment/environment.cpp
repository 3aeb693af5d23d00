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
    episode_.seed = seed;
    sim::load_own_state(*state_, field_->settled);
    episode_.hands.emplace(field_->scene->tools);
    episode_.hands->reset(seed, options_.start_spread_m);
    const std::vector<curriculum::TaskStep> steps = curriculum::steps_for(field_->task, "script");
    episode_.frames.emplace(field_->task, steps, *field_->scene, *state_,
                            curriculum::limit_of(field_->task, options_.time_limit_s));
    curriculum::AttemptOptions header_of;
    header_of.device = "environment";
    header_of.demonstration = true;  // nobody takes it for a person's
    episode_.book = EpisodeBook(
        curriculum::recording_header(field_->task, field_->seed, header_of, *field_->scene),
        options_.record);
    episode_.inputs = {};
    episode_.feedback = {};
    episode_.frames->begin(episode_.book);
    episode_.judged = {};
    episode_.end = EndReason::kRunning;
    episode_.paid_points = 0;
    looked_ = -1;
    look_for_goals();
    episode_.reached = goals_.reached;
    episode_.potential_m = approach();
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
    const std::span<const sim::ToolInput> inputs{episode_.inputs.data(), count};
    const double frame_s = field_->task.scene.solver.frame_s;
    episode_.hands->aim(options_.units, options_.speed_m_s, actions, frames, frame_s);
    StepOutcome out;
    while (out.frames < frames && !ended()) {
        ++out.frames;
        episode_.hands->next({episode_.inputs.data(), count});
        const sim::StepReport report = episode_.frames->simulate(
            *state_, inputs, {episode_.feedback.data(), count}, episode_.book);
        episode_.frames->look(*state_, report, inputs, episode_.book);
        episode_.end = episode_.frames->ended(*state_, inputs, finish && out.frames == frames);
    }
    if (episode_.book.lost()) throw std::bad_alloc();
    if (ended())
        finish_attempt();
    else if (options_.judge_every_s > 0 &&
             state_->time_s - episode_.judged.at_s >= options_.judge_every_s - frame_s / 2)
        judge_now();
    out.end = episode_.end;
    out.success = ended() && episode_.judged.score.verdict == assessment::Verdict::kPassed;
    out.score_part = (episode_.judged.score.points - episode_.paid_points) / 100;
    episode_.paid_points = episode_.judged.score.points;
    look_for_goals();
    const double now = approach();
    // Something was reached: the way to the next goal begins here.
    if (goals_.reached == episode_.reached && !ended())
        out.approach_part =
            options_.approach_weight * (now - episode_.potential_m) / kApproachUnitM;
    episode_.reached = goals_.reached;
    episode_.potential_m = now;
    out.reward = options_.sparse ? (ended() ? episode_.judged.score.points / 100 : 0)
                                 : out.score_part + out.approach_part;
    return out;
}

void Environment::finish_attempt() {
    episode_.frames->close(*state_, episode_.book);
    episode_.book.end(episode_.frames->seal(*state_, episode_.end, episode_.book));
    episode_.judged = judge_finished(field_->task.rubric, episode_.book.recording());
}

void Environment::judge_now() {
    episode_.judged =
        judge_unfinished(field_->task.rubric, episode_.book.recording(),
                         episode_.frames->entries_if_closed(*state_), state_->time_s, false);
}

Judgement Environment::judge_in_full() {
    need_begun();
    if (ended()) return episode_.judged;
    return judge_unfinished(field_->task.rubric, episode_.book.recording(),
                            episode_.frames->entries_if_closed(*state_), state_->time_s, true);
}

haptics::Perception Environment::look() {
    need_begun();
    if (looked_ != state_->frame) sight_->look(*state_);
    looked_ = state_->frame;
    haptics::Perception seen = sight_->seen(*state_);
    seen.tools = feedback();
    seen.cut_fraction = static_cast<float>(episode_.frames->cut_fraction());
    seen.practice = episode_.frames->goal();
    return seen;
}

/// Before the first frame instruments are not in the field yet: what counts is where they will be.
std::array<sim::Pose, sim::kMaxTools> Environment::poses() const {
    std::array<sim::Pose, sim::kMaxTools> poses;
    for (size_t i = 0; i < tools(); ++i) poses[i] = state_->tools[i].proxy;
    if (state_->frame > 0) return poses;
    Hands hands = *episode_.hands;
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
                          *episode_.hands,
                          episode_.book,
                          {now.data(), tools()},
                          episode_.frames->time_limit_s(),
                          episode_.judged.score.points},
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
    return {episode_.feedback.data(), tools()};
}

std::span<const sim::Event> Environment::events() const { return episode_.book.recording().events; }

const sim::Recording& Environment::recording() const {
    need_begun();
    // Not the option: an attempt that was gone back to is as it was begun, perhaps elsewhere.
    if (!episode_.book.keeps_inputs())
        throw EnvironmentError(Kind::kBadArgument,
                               "nothing was recorded; make the environment in which the attempt "
                               "begins with the option record");
    if (!ended())
        throw EnvironmentError(Kind::kRunning,
                               "the attempt is not over: step with finish, then write it");
    return episode_.book.recording();
}

}  // namespace placode::environment
