// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/servo.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include "haptics/real_time.h"
#include "haptics/servo_loop.h"

namespace placode::haptics {

namespace {

constexpr int64_t kPeriodNs = 1'000'000;
constexpr int64_t kLateNs = 1'100'000, kGapNs = 5'000'000;
constexpr int64_t kCommandLifeNs = 10'000'000;  // An older force is not sent.
constexpr int kReleaseTicks = 60;               // The release ramp takes 50.

}  // namespace

void Servo::Impl::note(size_t i, const CouplingResult& result,
                       const sim::ToolFeedback& feedback) noexcept {
    HandLoop& hand = hands[i];
    count(counters.saturated, result.clamped);
    count(counters.slewed, result.slewed);
    count(counters.hot, result.hot);
    count(counters.stale, result.stale);
    count(counters.silent, result.silent);
    count(counters.passivity, result.passive);
    count(counters.faults, result.fault);
    count(counters.compared, hand.force && result.compared);
    count(counters.differing, hand.force && result.differing);
    count(counters.tool_states, feedback.time_s != hand.tool_time_s);
    hand.tool_time_s = feedback.time_s;
    if (feedback.time_s > 0) counters.ages.add(std::llround(result.tool_age_s * 1e9));
    constexpr auto relaxed = std::memory_order_relaxed;
    const double size = result.force_n.norm();
    if (size > counters.peak_n.load(relaxed)) counters.peak_n.store(size, relaxed);
    const double least = hand.coupling.least_energy_j();
    if (least < counters.least_j.load(relaxed)) counters.least_j.store(least, relaxed);
    // Of the hand that works hardest.
    const double rms = hand.coupling.rms_force_n();
    if (rms > counters.rms_n.load(relaxed)) counters.rms_n.store(rms, relaxed);
}

// A fault that began in a pause, or before the clock, counts when it outlasts it: the hand is dead
// in the attempt, too.
void Servo::Impl::note_doubt(size_t i, const CouplingResult& result, bool counted) noexcept {
    bool& doubted = hands[i].doubted;
    // In its inkwell a sound arm may be whenever it likes.
    const bool away = !states[i].engaged && states[i].status == DeviceStatus::kReady;
    if (result.trusted || away) doubted = false;
    if (!counted) {
        doubted = doubted || result.fault;
        return;
    }
    count(counters.faults, doubted);
    doubted = false;
}

void Servo::Impl::tick_hand(size_t i, int64_t t_ns, sim::ToolInput& input,
                            const sim::ToolFeedback& feedback) noexcept {
    HandLoop& hand = hands[i];
    const DeviceState& state = states[i];
    const sim::Pose tip = hand.trocar.tip_pose(state);
    const CouplingResult result = hand.coupling.tick(t_ns, state, tip.p, feedback, hand.trocar);
    // Before the first frame a hand may be calibrated and taken up in peace.
    begun = begun || feedback.time_s > 0;
    const bool counted = begun && !paused.load(std::memory_order_relaxed);
    note_doubt(i, result, counted);
    if (counted) note(i, result, feedback);
    if (result.trusted) {
        hand.held.set_pose(tip);
        hand.held.jaw_rad = static_cast<float>(state.jaw_rad);
        // Both pedals at once mean nothing: the generator stays off.
        constexpr uint8_t both = sim::kPedalCut | sim::kPedalCoag;
        hand.held.pedals = (state.pedals & both) == both ? 0 : state.pedals & both;
        hand.held.engaged = 1;
        if (state.finish) finish.store(true, std::memory_order_relaxed);
    } else {
        // The tool stays where the hand was last believed, lets go, and its energy is off.
        hand.held.pedals = 0;
        hand.held.engaged = 0;
    }
    input = hand.held;
    commands[i] = {};
    commands[i].force_n = result.force_n;
    commands[i].valid_until_ns = t_ns + kCommandLifeNs;
}

void Servo::Impl::note_time(int64_t now_ns) noexcept {
    constexpr auto relaxed = std::memory_order_relaxed;
    if (previous_ns != 0) {
        const int64_t period = now_ns - previous_ns;
        counters.periods.add(period);
        count(counters.late, begun && period > kLateNs);
        count(counters.gaps, begun && period > kGapNs);
        // Our own schedule counts what it skips; another one shows it by its gaps only.
        if (begun && own_scheduler.load(relaxed) && period > kLateNs)
            count(counters.missed, true,
                  static_cast<uint64_t>((period + kPeriodNs / 2) / kPeriodNs - 1));
    } else {
        counters.first_ns.store(now_ns, relaxed);
    }
    previous_ns = now_ns;
    counters.last_ns.store(now_ns, relaxed);
}

// Counts the ticks of the ramp at the end.
void Servo::Impl::step_release() noexcept {
    if (release_ticks < 0) {
        if (!releasing.load(std::memory_order_relaxed)) return;
        release_ticks = kReleaseTicks;
        for (auto& hand : hands) hand.coupling.release();
    }
    if (release_ticks > 0 && --release_ticks == 0) released.store(true, std::memory_order_release);
}

void Servo::Impl::read(int64_t t_ns) noexcept {
    devices->read(t_ns, states);
    const auto is_lost = [](const DeviceState& s) { return s.status == DeviceStatus::kLost; };
    lost.store(std::all_of(states.begin(), states.end(), is_lost), std::memory_order_relaxed);
    const auto now =
        std::find_if(states.begin(), states.end(), [](const DeviceState& s) { return s.in_hand; });
    in_hand.store(now == states.end() ? -1 : static_cast<int>(now - states.begin()),
                  std::memory_order_relaxed);
}

// One tick of the thread or of the device's own scheduler. False: the session is over.
bool Servo::Impl::tick_all(int64_t now_ns) noexcept {
    note_time(now_ns);
    step_release();
    exchange.feedback.refresh();
    const auto& feedback = exchange.feedback.front();
    for (size_t i = 0; i < hands.size(); ++i) {
        const Trocar& trocar = hands[i].trocar;
        devices->turn_about(i, trocar.device_vector(feedback[i].turn_centre_m),
                            trocar.device_vector(Vec3::UnitZ()).normalized());
    }
    devices->hold(paused.load(std::memory_order_relaxed));
    read(now_ns);
    for (size_t i = 0; i < hands.size(); ++i) tick_hand(i, now_ns, inputs[i], feedback[i]);
    // A read that hung: these forces answer to a hand of the past.
    if (devices->now_ns() - now_ns > kCommandLifeNs)
        std::fill(commands.begin(), commands.end(), DeviceCommand{});
    devices->write(commands);
    exchange.inputs.publish(inputs);
    count(counters.ticks);
    return release_ticks != 0;
}

void Servo::Impl::run() noexcept {
    real_time = make_thread_real_time(kServoPriority);
    PeriodSchedule schedule(monotonic_ns(), kPeriodNs);
    while (running.load(std::memory_order_relaxed)) {
        sleep_until(schedule.next_ns());
        if (!tick_all(monotonic_ns())) break;
        const uint64_t missed = schedule.advance(monotonic_ns());
        count(counters.missed, begun && missed > 0, missed);
    }
}

Servo::Servo(std::unique_ptr<DeviceGroup> devices, std::span<const sim::ToolSpec> tools,
             std::span<const TrocarSettings> trocars, const CouplingSettings& coupling)
    : impl_(std::make_unique<Impl>()) {
    if (!devices) throw DeviceError("servo: no device group");
    if (tools.size() != trocars.size() || tools.size() > sim::kMaxTools)
        throw DeviceError("servo: " + std::to_string(tools.size()) + " tools and " +
                          std::to_string(trocars.size()) +
                          " trocars; expected one trocar per tool, "
                          "at most " +
                          std::to_string(sim::kMaxTools));
    impl_->devices = std::move(devices);
    const std::vector<DeviceInfo> infos = impl_->devices->info();
    for (size_t i = 0; i < tools.size(); ++i) {
        const DeviceInfo info = i < infos.size() ? infos[i] : DeviceInfo{};
        impl_->force = impl_->force || info.dof_force > 0;
        const std::string name =
            info.vendor + " " + info.model + (info.serial.empty() ? "" : " " + info.serial);
        if (impl_->device_names.find(name) == std::string::npos)
            impl_->device_names += (impl_->device_names.empty() ? "" : ", ") + name;
        const CouplingSettings law = limited_to(coupling, info, trocars[i].scale);
        Impl::HandLoop hand{Trocar(tools[i], trocars[i]), Coupling(law), {}};
        hand.force = info.dof_force > 0;
        hand.held.set_pose(hand.trocar.tip_pose(DeviceState{}));
        impl_->hands.push_back(hand);
    }
    impl_->states.resize(tools.size());
    impl_->commands.resize(tools.size());
}

Servo::~Servo() { stop(); }

void Servo::tick(int64_t t_ns, std::span<sim::ToolInput> inputs,
                 std::span<const sim::ToolFeedback> feedback) noexcept {
    Impl& impl = *impl_;
    impl.read(t_ns);
    const size_t n = std::min({impl.hands.size(), inputs.size(), feedback.size()});
    for (size_t i = 0; i < n; ++i) impl.tick_hand(i, t_ns, inputs[i], feedback[i]);
    impl.devices->write(impl.commands);
    if (impl.counters.ticks == 0) impl.counters.first_ns = t_ns;
    count(impl.counters.ticks);
    impl.counters.last_ns = t_ns;
}

void Servo::start() {
    Impl& impl = *impl_;
    if (impl.devices->lock_step() || impl.was_started) return;
    impl.was_started = true;
    impl.locked = lock_memory();
    impl.running = true;
    const auto tick = [](void* context, int64_t t_ns) noexcept {
        return static_cast<Impl*>(context)->tick_all(t_ns);
    };
    impl.own_scheduler = impl.devices->start(tick, &impl);
    if (!impl.own_scheduler) impl.thread = std::thread([this] { impl_->run(); });
}

void Servo::release() noexcept { impl_->releasing = true; }
void Servo::set_paused(bool paused) noexcept { impl_->paused = paused; }

void Servo::stop() noexcept {
    Impl& impl = *impl_;
    if (impl.stopped) return;
    impl.stopped = true;
    const int64_t asked_ns = impl.devices->now_ns();
    impl.releasing = true;
    if (impl.thread.joinable()) impl.thread.join();
    // A scheduler that died takes no ramp: after a fifth of a second the device is stopped anyway.
    for (int i = 0; impl.own_scheduler && i < 200 && !impl.released; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    impl.running = false;
    if (!impl.own_scheduler) {
        std::fill(impl.commands.begin(), impl.commands.end(), DeviceCommand{});
        impl.devices->write(impl.commands);
    }
    impl.devices->stop();
    // It died without a word: the account goes on to the end all the same.
    if (impl.own_scheduler && !impl.released && impl.counters.ticks > 0 &&
        asked_ns - impl.counters.last_ns > kGapNs)
        impl.note_time(asked_ns);
    if (impl.locked) unlock_memory();
}

Servo::Exchange& Servo::exchange() noexcept { return impl_->exchange; }
DeviceGroup& Servo::devices() noexcept { return *impl_->devices; }

bool Servo::finish_requested() const noexcept { return impl_->finish; }
int Servo::in_hand() const noexcept { return impl_->in_hand.load(std::memory_order_relaxed); }
bool Servo::device_lost() const noexcept { return impl_->lost.load(std::memory_order_relaxed); }
bool Servo::renders_force() const noexcept { return impl_->force; }

double Servo::stiffness_n_m(size_t hand) const noexcept {
    if (hand >= impl_->hands.size() || !impl_->hands[hand].force) return 0;
    return impl_->hands[hand].coupling.settings().stiffness_n_m;
}

}  // namespace placode::haptics
