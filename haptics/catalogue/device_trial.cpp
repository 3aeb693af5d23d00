// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/catalogue/device_trial.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>

#include "haptics/catalogue/open_device.h"
#include "haptics/real_time.h"

namespace placode::haptics {

namespace {

constexpr double kFloorBelowM = 0.010;
/// What can be tried without a window.
constexpr std::string_view kHardware[] = {"openhaptics", "haply", "avatar", "forcedimension",
                                          "spacemouse"};

/// What the watcher hands out: everything of one tick.
struct Signals {
    std::array<DeviceState, sim::kMaxTools> states{};
    std::array<Vec3, sim::kMaxTools> force_n{};
    IdentityState identity;
};

/// Stands between servo and device, and lets somebody look.
class WatchedGroup final : public DeviceGroup {
 public:
    explicit WatchedGroup(std::unique_ptr<DeviceGroup> inner) : inner_(std::move(inner)) {}
    [[nodiscard]] std::vector<DeviceInfo> info() const override { return inner_->info(); }
    void read(int64_t t_ns, std::span<DeviceState> states) noexcept override {
        inner_->read(t_ns, states);
        if (ask_.exchange(false, std::memory_order_relaxed)) identity_.ask();
        identity_.see(states);
        Signals& out = signals.back();
        std::copy_n(states.begin(), std::min(states.size(), out.states.size()), out.states.begin());
        out.identity = identity_.state();
    }
    void write(std::span<const DeviceCommand> commands) noexcept override {
        inner_->write(commands);
        Signals& out = signals.back();
        for (size_t i = 0; i < std::min(commands.size(), out.force_n.size()); ++i)
            out.force_n[i] = commands[i].force_n;
        signals.publish();
    }
    [[nodiscard]] bool start(ServoTick tick, void* context) override {
        return inner_->start(tick, context);
    }
    [[nodiscard]] bool lock_step() const noexcept override { return inner_->lock_step(); }
    [[nodiscard]] int64_t now_ns() const noexcept override { return inner_->now_ns(); }
    void hold(bool held) noexcept override { inner_->hold(held); }
    [[nodiscard]] std::string last_error() const override { return inner_->last_error(); }
    void stop() noexcept override { inner_->stop(); }
    void ask() noexcept { ask_.store(true, std::memory_order_relaxed); }

    sim::Latest<Signals> signals;

 private:
    std::unique_ptr<DeviceGroup> inner_;
    HandIdentity identity_;
    std::atomic<bool> ask_{false};
};

/// One tool a hand, so that two arms are two hands and one arm stands for one.
std::vector<sim::ToolSpec> trial_tools(const Station& station, bool two) {
    std::vector<sim::ToolSpec> tools(two ? 2 : 1);
    for (sim::ToolSpec& tool : tools) {
        tool.kind = sim::ToolKind::kProbe;
        // Far from its port: nothing bends the path of the hand.
        tool.pivot_m = Vec3(0, 0, 0.5);
        tool.length_m = 2;
    }
    if (two)
        tools[1].hand = sim::Hand::kLeft;
    else if (station.text("arm.one_hand") == "left")
        tools[0].hand = sim::Hand::kLeft;
    return tools;
}

bool two_arms(const std::string& device, const Station& station) {
    if (device == "forcedimension") return true;  // it says itself how many there are
    if (device != "openhaptics" && device != "haply" && device != "avatar") return false;
    return !station.text(device + ".left").empty();
}

// As in an attempt, so that the hand feels the same.
double trial_scale(const TrialSettings& settings, std::span<const sim::ToolSpec> tools) {
    return default_trocars(tools, settings.device, settings.station).front().scale;
}

CouplingSettings trial_law(const TrialSettings& settings, double scale) {
    CouplingSettings law = station_limits(settings.station);
    law.servo_gap_s = settings.servo_gap_s;
    // What is no number asks for no more than the first force.
    const double force_n = std::isfinite(settings.force_n) ? settings.force_n : kFirstForceN;
    law.max_force_n = std::min(law.max_force_n, force_n);
    law.thermal_floor_n = std::min(law.thermal_floor_n, law.max_force_n);
    if (!(force_n > kFirstForceN)) {
        const double felt = scale * scale;  // times what the law says
        law.stiffness_n_m = std::min(law.stiffness_n_m, kFirstStiffnessNM / felt);
        law.damping_ns_m /= std::max(1.0, felt);
    }
    return law;
}

}  // namespace

struct DeviceTrial::Impl {
    WatchedGroup* watched = nullptr;  // the servo's
    std::vector<DeviceInfo> infos;
    CouplingSettings law;
    std::unique_ptr<Servo> servo;
    size_t first = 0, shown = 0;  // which of the hands are arms
    double scale = 1;             // tip per hand
    // World thread.
    std::array<double, sim::kMaxTools> floor_m{};
    double stiffness_n_m = 0;  // of the coupling: what it stands on presses back with the same
    double time_s = 0;
    // Crosses threads.
    std::atomic<bool> running{false}, floor{false}, replace{false};
    std::array<std::atomic<double>, sim::kMaxTools> height_m{};
    // Owner.
    std::thread world;
    bool stopped = false;

    void frame() noexcept;
    void run() noexcept;
};

// Tip mapping with the device's own axes: y is up. A tool stands where its hand is, or on the
// floor.
void DeviceTrial::Impl::frame() noexcept {
    auto& exchange = servo->exchange();
    exchange.inputs.refresh();
    const auto& inputs = exchange.inputs.front();
    const bool anew = replace.exchange(false);
    const bool on = floor.load(std::memory_order_relaxed);
    time_s += 1e-3;
    auto& feedback = exchange.feedback.back();
    for (size_t i = 0; i < infos.size(); ++i) {
        sim::Pose tip = inputs[i].pose();
        if (anew) floor_m[i] = tip.p.y() - scale * kFloorBelowM;
        height_m[i].store(on ? (tip.p.y() - floor_m[i]) / scale : 0, std::memory_order_relaxed);
        const double below_m = on ? std::max(0.0, floor_m[i] - tip.p.y()) : 0;
        tip.p.y() += below_m;
        feedback[i].force_n = Vec3(0, stiffness_n_m * below_m, 0);
        feedback[i].proxy = tip;
        feedback[i].time_s = time_s;
    }
    exchange.feedback.publish();
}

void DeviceTrial::Impl::run() noexcept {
    PeriodSchedule schedule(monotonic_ns(), 1'000'000);
    while (running.load(std::memory_order_relaxed)) {
        sleep_until(schedule.next_ns());
        frame();
        (void)schedule.advance(monotonic_ns());
    }
}

DeviceTrial::DeviceTrial(const TrialSettings& settings) : impl_(std::make_unique<Impl>()) {
    if (std::find(std::begin(kHardware), std::end(kHardware), settings.device) ==
        std::end(kHardware)) {
        std::string names;
        for (const std::string_view name : kHardware)
            names.append(names.empty() ? "" : ", ").append(name);
        throw DeviceError("test of a device: found \"" + settings.device + "\", expected one of " +
                          names + "; mouse, keyboard and gamepad are tried in the window");
    }
    DeviceConfig config;
    config.name = settings.device;
    config.station = settings.station;
    config.clock_ns = settings.clock_ns;
    config.tools = trial_tools(settings.station, two_arms(settings.device, settings.station));
    TrocarSettings trocar;
    trocar.mapping = Mapping::kTip;
    trocar.scale = impl_->scale = trial_scale(settings, config.tools);
    trocar.home_tip_m = Vec3(0, 0, 0.020);
    auto group = std::make_unique<WatchedGroup>(open_device(config));
    impl_->watched = group.get();
    impl_->infos = group->info();
    impl_->law = trial_law(settings, impl_->scale);
    const std::vector<TrocarSettings> trocars(config.tools.size(), trocar);
    impl_->servo = std::make_unique<Servo>(std::move(group), config.tools, trocars, impl_->law);
    impl_->stiffness_n_m = impl_->servo->stiffness_n_m(0);
    impl_->infos.resize(config.tools.size());
    // One arm that would take turns with the tools of both hands is shown once.
    const std::vector<DeviceInfo>& infos = impl_->infos;
    if (infos.size() == 2 && infos[0].model == infos[1].model &&
        infos[0].serial == infos[1].serial) {
        impl_->first = infos[0].left_hand ? 1 : 0;
        impl_->shown = 1;
    } else {
        impl_->shown = infos.size();
    }
}

DeviceTrial::~DeviceTrial() { stop(); }

void DeviceTrial::start() {
    if (impl_->running.exchange(true)) return;
    impl_->servo->start();
    impl_->world = std::thread([impl = impl_.get()] { impl->run(); });
}

void DeviceTrial::set_floor(bool on) noexcept {
    if (on) impl_->replace = true;
    impl_->floor = on;
}

void DeviceTrial::identify() noexcept { impl_->watched->ask(); }

TrialReport DeviceTrial::report() {
    Impl& impl = *impl_;
    impl.watched->signals.refresh();
    const Signals& now = impl.watched->signals.front();
    TrialReport out;
    for (size_t i = impl.first; i < impl.first + impl.shown; ++i) {
        TrialArm arm;
        arm.info = impl.infos[i];
        arm.state = now.states[i];
        arm.force_n = now.force_n[i];
        arm.height_m = impl.height_m[i];
        out.arms.push_back(arm);
    }
    out.floor = impl.floor;
    const DeviceInfo first = impl.infos.empty() ? DeviceInfo{} : impl.infos.front();
    const CouplingSettings law = limited_to(impl.law, first, impl.scale);
    out.force_n = law.max_force_n;
    out.stiffness_n_m = impl.scale * impl.scale * law.stiffness_n_m;
    out.certificate = impl.servo->certificate();
    out.identity = now.identity;
    return out;
}

void DeviceTrial::stop() noexcept {
    Impl& impl = *impl_;
    if (impl.stopped) return;
    impl.stopped = true;
    impl.servo->stop();
    impl.running = false;
    if (impl.world.joinable()) impl.world.join();
}

}  // namespace placode::haptics
