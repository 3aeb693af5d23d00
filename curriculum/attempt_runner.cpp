// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/attempt_runner.h"

#include <thread>

#include "curriculum/attempt_loop.h"
#include "curriculum/stage_start.h"
#include "haptics/catalogue/open_device.h"

#ifndef PLACODE_VERSION
#define PLACODE_VERSION "0"
#endif

namespace placode::curriculum {

std::string this_build() {
    return std::string("placode ") + PLACODE_VERSION + " " + sim::kernel_target();
}

sim::RecordingHeader recording_header(const Task& task, uint64_t seed,
                                      const AttemptOptions& options, const sim::Scene& scene) {
    sim::RecordingHeader header;
    header.task_id = task.id;
    header.task_version = task.version;
    header.task_json = task.json;
    header.seed = seed;
    header.build = this_build();
    header.device = options.device;
    header.started_utc = options.started_utc;
    // A scripted operator is never taken for a person, whoever started it.
    header.demonstration = options.demonstration || options.device.rfind("script:", 0) == 0;
    header.mode = mode_name(options.mode);
    header.frame_s = task.scene.solver.frame_s;
    header.tools = scene.tools;
    header.geometry = scene.geometry;
    if (options.start) {
        header.stage = options.start->stage;
        header.given_frames = static_cast<int64_t>(options.start->given.size());
        header.given_hash = options.start->hash;
    }
    return header;
}

namespace {

std::unique_ptr<haptics::Servo> open_servo(const Task& task, uint64_t seed,
                                           const AttemptOptions& options) {
    haptics::DeviceConfig config;
    config.name = options.device;
    config.seed = seed;
    config.tools = task.scene.tools;
    config.window = options.window;
    config.frame_s = task.scene.solver.frame_s;
    config.practice = !task.steps.empty();
    config.patch = lays_patch(task);
    config.station = haptics::Station::of_this_computer();
    return std::make_unique<haptics::Servo>(
        haptics::open_device(config), task.scene.tools,
        haptics::default_trocars(task.scene.tools, options.device, config.station),
        haptics::station_limits(config.station));
}

}  // namespace

struct AttemptRunner::Impl {
    Task task;
    std::shared_ptr<sim::Scene> scene;
    std::shared_ptr<const sim::Scene> shown;  // the same, for everybody else
    std::unique_ptr<AttemptRecorder> recorder;
    std::unique_ptr<AttemptLoop> loop;
    std::thread physics;
    bool started = false, written = false;
};

AttemptRunner::AttemptRunner(Task task, uint64_t seed, AttemptOptions options,
                             std::unique_ptr<sim::RecordingSink> sink)
    : impl_(std::make_unique<Impl>()) {
    task.scene.seed = seed;
    options.steps = steps_for(task, options.device);
    if (options.start && options.mode != AttemptMode::kPractice)
        throw DefinitionError("task " + task.id, "/stages",
                              "an exam or a study begins with the beginning");
    // The device first: the usual mistake is a device that is not there, and it is cheap to find.
    std::unique_ptr<haptics::Servo> servo = open_servo(task, seed, options);
    // What a hand with force feels is the coupling's spring on the gap between hand and tool: with
    // the same stiffness in the physics it is the tissue's force, and not a share of it.
    for (size_t i = 0; i < task.scene.tools.size(); ++i)
        if (const double held = servo->stiffness_n_m(i); held > 0)
            task.scene.tools[i].hand_n_m = held;
    // Built here and shared with nobody yet: the one scene that may be tuned
    // (sim/step/live_tuning.h).
    impl_->shown = sim::build_operative_field(task.scene);
    impl_->scene = std::const_pointer_cast<sim::Scene>(impl_->shown);
    impl_->recorder = std::make_unique<AttemptRecorder>(
        std::move(sink), recording_header(task, seed, options, *impl_->scene), options.start);
    impl_->loop = std::make_unique<AttemptLoop>(task, options, impl_->scene, std::move(servo),
                                                *impl_->recorder);
    impl_->task = std::move(task);
}

AttemptRunner::~AttemptRunner() {
    if (impl_->started && !impl_->written) {
        request_finish(sim::EndReason::kClosed);
        wait();
    }
}

void AttemptRunner::start() {
    if (impl_->started) return;
    impl_->started = true;
    impl_->recorder->start();
    impl_->physics = std::thread([this] { impl_->loop->run(); });
}

void AttemptRunner::request_finish(sim::EndReason reason) noexcept {
    impl_->loop->request_finish(reason);
}
void AttemptRunner::set_paused(bool paused, sim::PauseCause cause) noexcept {
    impl_->loop->set_paused(paused, cause);
}
void AttemptRunner::picture_drawn() noexcept { impl_->loop->picture_drawn(); }
void AttemptRunner::may_save_substeps(bool may) noexcept { impl_->loop->may_save_substeps(may); }
void AttemptRunner::tune(sim::TuneParameter parameter, sim::Tissue tissue, double value) noexcept {
    sim::Event wish;
    wish.kind = sim::EventKind::kTuned;
    wish.element = static_cast<int32_t>(parameter);
    wish.tissue = tissue;
    wish.value = static_cast<float>(value);
    impl_->loop->tune(wish);
}
bool AttemptRunner::finished() const noexcept { return impl_->loop->finished(); }

void AttemptRunner::wait() {
    if (!impl_->started || impl_->written) return;
    if (impl_->physics.joinable()) impl_->physics.join();
    impl_->recorder->finish(impl_->loop->end());
    impl_->written = true;
}

const std::shared_ptr<const sim::Scene>& AttemptRunner::scene() const noexcept {
    return impl_->shown;
}
const Task& AttemptRunner::task() const noexcept { return impl_->task; }

const sim::Snapshot& AttemptRunner::snapshot(bool* fresh) noexcept {
    const bool changed = impl_->loop->snapshots().refresh();
    if (fresh != nullptr) *fresh = changed;
    return impl_->loop->snapshots().front();
}

const sim::PracticeGoal& AttemptRunner::practice() noexcept {
    impl_->loop->practice().refresh();
    return impl_->loop->practice().front();
}

AttemptStatus AttemptRunner::status() const {
    AttemptLoop& loop = *impl_->loop;
    loop.numbers().refresh();
    const LoopNumbers& numbers = loop.numbers().front();
    AttemptStatus status;
    status.time_s = numbers.time_s;
    status.phase = numbers.phase;
    status.physics_hz = numbers.physics_hz;
    status.frame_p99_ms = numbers.frame_p99_ms;
    status.substeps = numbers.substeps;
    status.cut_fraction = numbers.cut_fraction;
    const haptics::HapticCertificate certificate = loop.servo().certificate();
    status.servo_p999_us = certificate.period_p999_us;
    status.servo_missed = certificate.missed;
    status.servo_gaps = certificate.gaps;
    status.servo_faults = certificate.faults;
    loop.set_servo_p999(status.servo_p999_us);
    status.dropped = numbers.dropped;
    status.running = impl_->started && !loop.finished();
    status.waiting = numbers.waiting;
    status.sleeps = numbers.sleeps;
    status.device_lost = loop.servo().device_lost();
    status.in_hand = loop.servo().in_hand();
    status.real_time = numbers.real_time;
    status.pictures_hz = numbers.pictures_hz;
    status.real_time_now = numbers.real_time_now;
    status.pictures_now_hz = numbers.pictures_now_hz;
    status.slow = numbers.slow;
    status.counts_not = numbers.counts_not;
    status.warning = impl_->recorder->problem();
    return status;
}

std::string AttemptRunner::haptic_certificate() const {
    return haptics::certificate_to_json(impl_->loop->servo().certificate());
}

sim::RecordingEnd AttemptRunner::end() const { return impl_->loop->end(); }

}  // namespace placode::curriculum
