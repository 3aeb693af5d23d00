// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/servo.h"

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <ctime>
#include <thread>

#include "haptics/coupling.h"

namespace placode::haptics {

namespace {

constexpr int64_t kPeriodNs = 1'000'000;
constexpr int64_t kCommandLifeNs = 10'000'000;  // A driver zeroes an older force by itself.
constexpr int kPriority = 80;
constexpr int kReleaseTicks = 60;  // The release ramp takes 50.

int64_t monotonic_ns() noexcept {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return static_cast<int64_t>(now.tv_sec) * 1'000'000'000 + now.tv_nsec;
}

void sleep_until(int64_t t_ns) noexcept {
    const timespec until{static_cast<time_t>(t_ns / 1'000'000'000), t_ns % 1'000'000'000};
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == EINTR) {
    }
}

// Touches the stack once, so that no page fault comes in the loop.
void prefault_stack() noexcept {
    volatile char room[256 * 1024];
    for (size_t i = 0; i < sizeof room; i += 4096) room[i] = 0;
}

// Counts of periods: 5 us wide up to 5 ms, then 1 ms wide up to 1 s. One writer, any reader.
class PeriodHistogram {
 public:
    void add(int64_t period_ns) noexcept {
        const int64_t us = std::max<int64_t>(0, period_ns / 1000);
        const int64_t bin =
            us < kFineUs
                ? us / kFineWidthUs
                : std::min<int64_t>(kFine + (us - kFineUs) / kCoarseWidthUs, kFine + kCoarse - 1);
        counts_[static_cast<size_t>(bin)].fetch_add(1, std::memory_order_relaxed);
        if (period_ns > max_ns_.load(std::memory_order_relaxed))
            max_ns_.store(period_ns, std::memory_order_relaxed);
    }
    // Upper edge of the bin that holds the share `q` of all periods, never above the maximum [us].
    [[nodiscard]] double quantile_us(double q) const noexcept {
        uint64_t total = 0, sum = 0;
        for (const auto& count : counts_) total += count.load(std::memory_order_relaxed);
        if (total == 0) return 0;
        for (int64_t bin = 0; bin < kFine + kCoarse; ++bin) {
            sum += counts_[static_cast<size_t>(bin)].load(std::memory_order_relaxed);
            if (static_cast<double>(sum) < q * static_cast<double>(total)) continue;
            const int64_t edge = bin < kFine ? (bin + 1) * kFineWidthUs
                                             : kFineUs + (bin - kFine + 1) * kCoarseWidthUs;
            return std::min(static_cast<double>(edge), max_us());
        }
        return max_us();
    }
    [[nodiscard]] double max_us() const noexcept {
        return static_cast<double>(max_ns_.load(std::memory_order_relaxed)) * 1e-3;
    }

 private:
    static constexpr int64_t kFine = 1000, kCoarse = 1000, kFineWidthUs = 5, kCoarseWidthUs = 1000,
                             kFineUs = kFine * kFineWidthUs;
    std::array<std::atomic<uint32_t>, kFine + kCoarse> counts_{};
    std::atomic<int64_t> max_ns_{0};
};

// Locks memory only where no limit can turn a later allocation into a failure.
bool lock_memory() noexcept {
    rlimit limit{};
    const bool free = geteuid() == 0 ||
                      (getrlimit(RLIMIT_MEMLOCK, &limit) == 0 && limit.rlim_cur == RLIM_INFINITY);
    return free && mlockall(MCL_CURRENT | MCL_FUTURE | MCL_ONFAULT) == 0;
}

std::string missing_rights(bool real_time, bool locked) {
    if (real_time && locked) return {};
    std::string text = "The servo runs without ";
    if (!real_time) text += "real-time priority (SCHED_FIFO)";
    if (!real_time && !locked) text += " and ";
    if (!locked) text += "locked memory (mlockall)";
    text += ". To grant it, an administrator adds to /etc/security/limits.d/placode.conf: ";
    if (!real_time) text += "\"@placode - rtprio 85\"";
    if (!real_time && !locked) text += " and ";
    if (!locked) text += "\"@placode - memlock unlimited\"";
    return text + ", puts the user into the group placode, and the user logs in again.";
}

}  // namespace

struct Servo::Impl {
    struct HandLoop {
        Trocar trocar;
        Coupling coupling;
        sim::ToolInput held;  // Last trusted input.
    };

    std::unique_ptr<DeviceGroup> devices;
    // Servo thread (or the caller in lock step).
    std::vector<HandLoop> hands;
    std::vector<DeviceState> states;
    std::vector<DeviceCommand> commands;
    // Crosses threads.
    Exchange exchange;
    std::atomic<uint64_t> ticks{0}, overruns{0}, clamped{0}, faults{0}, stale{0};
    std::atomic<bool> finish{false}, running{false}, releasing{false}, real_time{false};
    PeriodHistogram periods;
    // Owner.
    std::thread thread;
    bool locked = false, was_started = false, stopped = false;

    void tick_hand(size_t i, int64_t t_ns, sim::ToolInput& input,
                   const sim::ToolFeedback& feedback) noexcept;
    void run() noexcept;
};

namespace {

void count(std::atomic<uint64_t>& counter, bool happened = true, uint64_t n = 1) noexcept {
    // One writer: a plain store is enough and never locks the bus.
    if (happened)
        counter.store(counter.load(std::memory_order_relaxed) + n, std::memory_order_relaxed);
}

}  // namespace

void Servo::Impl::tick_hand(size_t i, int64_t t_ns, sim::ToolInput& input,
                            const sim::ToolFeedback& feedback) noexcept {
    HandLoop& hand = hands[i];
    const DeviceState& state = states[i];
    const sim::Pose tip = hand.trocar.tip_pose(state);
    const CouplingResult result = hand.coupling.tick(t_ns, state, tip.p, feedback, hand.trocar);
    count(clamped, result.clamped);
    count(faults, result.fault);
    count(stale, result.stale);
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

void Servo::Impl::run() noexcept {
    prctl(PR_SET_TIMERSLACK, 1);
    prefault_stack();
    const sched_param param{.sched_priority = kPriority};
    real_time = pthread_setschedparam(pthread_self(), SCHED_FIFO, &param) == 0;
    std::array<sim::ToolInput, sim::kMaxTools> inputs{};
    int64_t next = monotonic_ns() + kPeriodNs, previous = 0;
    int release_ticks = -1;
    while (running.load(std::memory_order_relaxed)) {
        sleep_until(next);
        const int64_t now = monotonic_ns();
        if (previous != 0) periods.add(now - previous);
        previous = now;
        if (releasing.load(std::memory_order_relaxed) && release_ticks < 0) {
            release_ticks = kReleaseTicks;
            for (auto& hand : hands) hand.coupling.release();
        }
        if (release_ticks == 0) break;
        if (release_ticks > 0) --release_ticks;
        exchange.feedback.refresh();
        devices->read(now, states);
        const auto& feedback = exchange.feedback.front();
        for (size_t i = 0; i < hands.size(); ++i) tick_hand(i, now, inputs[i], feedback[i]);
        devices->write(commands);
        exchange.inputs.publish(inputs);
        count(ticks);
        // A missed period is skipped: a burst to catch up would act on one old hand position.
        next += kPeriodNs;
        const int64_t late = monotonic_ns() - next;
        if (late > 0) {
            const int64_t missed = late / kPeriodNs + 1;
            count(overruns, true, static_cast<uint64_t>(missed));
            next += missed * kPeriodNs;
        }
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
    for (size_t i = 0; i < tools.size(); ++i) {
        Impl::HandLoop hand{Trocar(tools[i], trocars[i]), Coupling(coupling), {}};
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
    impl.devices->read(t_ns, impl.states);
    const size_t n = std::min({impl.hands.size(), inputs.size(), feedback.size()});
    for (size_t i = 0; i < n; ++i) impl.tick_hand(i, t_ns, inputs[i], feedback[i]);
    impl.devices->write(impl.commands);
    count(impl.ticks);
}

void Servo::start() {
    Impl& impl = *impl_;
    if (impl.devices->lock_step() || impl.was_started) return;
    impl.was_started = true;
    impl.locked = lock_memory();
    impl.running = true;
    impl.thread = std::thread([this] { impl_->run(); });
}

void Servo::stop() noexcept {
    Impl& impl = *impl_;
    if (impl.stopped) return;
    impl.stopped = true;
    if (impl.thread.joinable()) {
        impl.releasing = true;
        impl.thread.join();
        impl.running = false;
    }
    std::fill(impl.commands.begin(), impl.commands.end(), DeviceCommand{});
    impl.devices->write(impl.commands);
    impl.devices->stop();
    if (impl.locked) munlockall();
}

Servo::Exchange& Servo::exchange() noexcept { return impl_->exchange; }
DeviceGroup& Servo::devices() noexcept { return *impl_->devices; }

ServoHealth Servo::health() const {
    const Impl& impl = *impl_;
    ServoHealth health;
    health.ticks = impl.ticks;
    health.overruns = impl.overruns;
    health.clamped = impl.clamped;
    health.faults = impl.faults;
    health.stale = impl.stale;
    health.period_p50_us = impl.periods.quantile_us(0.5);
    health.period_p99_us = impl.periods.quantile_us(0.99);
    health.period_p999_us = impl.periods.quantile_us(0.999);
    health.period_max_us = impl.periods.max_us();
    health.real_time = impl.real_time;
    if (impl.was_started) {
        health.remark = missing_rights(impl.real_time, impl.locked);
    } else if (impl.devices->lock_step()) {
        health.remark = "In step with the simulation: no servo thread, no real-time rights needed.";
    }
    return health;
}

bool Servo::finish_requested() const noexcept { return impl_->finish; }

}  // namespace placode::haptics
