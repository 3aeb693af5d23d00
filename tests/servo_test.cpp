// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/servo.h"

#include <gtest/gtest.h>
#include <linux/capability.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include "tests/count_allocations.h"

namespace placode::haptics {
namespace THIS_TEST {

// A hand that does what the test says and remembers what it was sent.
struct Script {
    DeviceState state;
    Vec3 force = Vec3::Ones();
    int64_t valid_until_ns = 0;
    std::atomic<int> reads{0}, stops{0};
};

class TestDevice final : public DeviceGroup {
 public:
    TestDevice(Script& script, bool lock_step) : script_(script), lock_step_(lock_step) {}
    [[nodiscard]] std::vector<DeviceInfo> info() const override { return {DeviceInfo{}}; }
    void read(int64_t t_ns, std::span<DeviceState> states) noexcept override {
        for (auto& state : states) {
            state = script_.state;
            state.t_ns = t_ns;
        }
        ++script_.reads;
    }
    void write(std::span<const DeviceCommand> commands) noexcept override {
        script_.force = commands[0].force_n;
        script_.valid_until_ns = commands[0].valid_until_ns;
    }
    [[nodiscard]] bool lock_step() const noexcept override { return lock_step_; }
    void stop() noexcept override { ++script_.stops; }

 private:
    Script& script_;
    bool lock_step_;
};

constexpr int64_t kMs = 1'000'000;

// An arm with a scheduler of its own, whose ticks and clock are the test's.
class ScheduledDevice final : public DeviceGroup {
 public:
    [[nodiscard]] std::vector<DeviceInfo> info() const override {
        DeviceInfo info;
        info.dof_force = 3;
        info.owns_servo = true;
        info.max_stiffness_n_m = 400;
        return {info};
    }
    void read(int64_t t_ns, std::span<DeviceState> states) noexcept override {
        clock_ns += read_ns;
        for (auto& state : states) {
            state = {};
            state.status = status;
            state.t_ns = t_ns;
        }
    }
    void write(std::span<const DeviceCommand> commands) noexcept override {
        force = commands[0].force_n;
    }
    [[nodiscard]] bool start(ServoTick tick, void* context) override {
        tick_ = tick;
        context_ = context;
        return true;
    }
    [[nodiscard]] int64_t now_ns() const noexcept override { return clock_ns; }
    void tick() noexcept {
        clock_ns += kMs;
        (void)tick_(context_, clock_ns);
    }

    int64_t clock_ns = kMs, read_ns = 0;
    Vec3 force = Vec3::Ones();
    DeviceStatus status = DeviceStatus::kReady;

 private:
    ServoTick tick_ = nullptr;
    void* context_ = nullptr;
};

struct ScheduledBench {
    ScheduledBench() : servo(take(), tools, std::vector(1, tip()), {}) { servo.start(); }
    static TrocarSettings tip() {
        TrocarSettings settings;
        settings.mapping = Mapping::kTip;
        return settings;
    }
    std::unique_ptr<DeviceGroup> take() {
        auto made = std::make_unique<ScheduledDevice>();
        device = made.get();
        return made;
    }
    void wait(int n) {  // for the first motion
        for (int i = 0; i < n; ++i) device->tick();
    }
    void tick(int n) {
        for (int i = 0; i < n; ++i) {
            auto& out = servo.exchange().feedback.back();
            out[0].proxy.p = TrocarSettings{}.home_tip_m + pushed_m;
            out[0].time_s = time_s += 1e-3;
            servo.exchange().feedback.publish();
            device->tick();
        }
    }
    [[nodiscard]] CertificateGrade grade() const { return judge(servo.certificate()).grade; }

    ScheduledDevice* device = nullptr;  // the servo's
    Vec3 pushed_m = Vec3::Zero();
    std::vector<sim::ToolSpec> tools{sim::ToolSpec{}};
    Servo servo;
    double time_s = 0;
};

struct Bench {
    explicit Bench(bool lock_step = true)
        : servo(std::make_unique<TestDevice>(script, lock_step), tools, trocars(), {}) {
        feedback[0].proxy.p = TrocarSettings{}.home_tip_m;
    }
    static std::vector<TrocarSettings> trocars() {
        TrocarSettings settings;
        settings.mapping = Mapping::kTip;
        return {settings};
    }
    const sim::ToolInput& tick() {
        t_ns += kMs;
        feedback[0].time_s = static_cast<double>(t_ns) * 1e-9;
        servo.tick(t_ns, inputs, feedback);
        return inputs[0];
    }

    Script script;
    std::vector<sim::ToolSpec> tools{sim::ToolSpec{}};
    Servo servo;
    std::array<sim::ToolInput, 1> inputs{};
    std::array<sim::ToolFeedback, 1> feedback{};
    int64_t t_ns = 0;
};

TEST(Servo, TurnsTheHandIntoAToolInput) {
    Bench bench;
    bench.script.state.position_m = Vec3(0.001, 0.002, 0.003);
    bench.script.state.jaw_rad = 0.25;
    bench.script.state.pedals = sim::kPedalCut;
    const auto& input = bench.tick();
    EXPECT_NEAR(input.position_m[0], 0.001, 1e-9);
    EXPECT_NEAR(input.position_m[2], 0.018, 1e-8);  // float
    EXPECT_EQ(input.jaw_rad, 0.25f);
    EXPECT_EQ(input.pedals, sim::kPedalCut);
    EXPECT_EQ(input.engaged, 1);
    EXPECT_EQ(bench.script.valid_until_ns, bench.t_ns + 10 * kMs);
    EXPECT_EQ(bench.servo.health().ticks, 1u);
}

TEST(Servo, SwitchesTheGeneratorOffForBothPedals) {
    Bench bench;
    bench.script.state.pedals = sim::kPedalCut | sim::kPedalCoag;
    EXPECT_EQ(bench.tick().pedals, 0);
}

TEST(Servo, LetsTheToolGoWithoutForceWhenTheDeviceIsLost) {
    Bench bench;
    bench.script.state.pedals = sim::kPedalCut;
    for (int i = 0; i < 700; ++i) bench.tick();
    bench.feedback[0].proxy.p.z() += 0.001;
    for (int i = 0; i < 50; ++i) bench.tick();
    ASSERT_GT(bench.script.force.norm(), 0.2) << "there was a force to lose";
    EXPECT_FALSE(bench.servo.device_lost());
    const auto before = bench.inputs[0].position_m;
    bench.script.state.status = DeviceStatus::kLost;
    bench.script.state.position_m = Vec3(0.02, 0, 0);
    const auto& input = bench.tick();
    EXPECT_EQ(bench.script.force, Vec3::Zero());
    EXPECT_EQ(input.engaged, 0);
    EXPECT_EQ(input.pedals, 0);
    EXPECT_EQ(input.position_m, before) << "the tool stays where the hand was last believed";
    EXPECT_EQ(bench.servo.health().faults, 1u);
    EXPECT_TRUE(bench.servo.device_lost()) << "for whoever pauses then";
    bench.script.state.status = DeviceStatus::kReady;
    bench.tick();
    EXPECT_FALSE(bench.servo.device_lost());
}

TEST(Servo, DropsPedalsAndForceForNumbersThatAreNone) {
    Bench bench;
    bench.script.state.pedals = sim::kPedalCut;
    for (int i = 0; i < 20; ++i) bench.tick();
    EXPECT_EQ(bench.inputs[0].engaged, 1);
    bench.script.state.position_m.x() = std::nan("");
    const auto& input = bench.tick();
    EXPECT_EQ(input.engaged, 0);
    EXPECT_EQ(input.pedals, 0);
    EXPECT_TRUE(std::isfinite(input.position_m[0]));
    EXPECT_EQ(bench.script.force, Vec3::Zero());
    bench.script.state.position_m.x() = 0;
    for (int i = 0; i < 110; ++i) bench.tick();
    EXPECT_EQ(bench.inputs[0].engaged, 1) << "and takes the tool up again";
}

TEST(Servo, RemembersThatTheOperatorIsDone) {
    Bench bench;
    bench.tick();
    EXPECT_FALSE(bench.servo.finish_requested());
    bench.script.state.finish = true;
    bench.tick();
    bench.script.state.finish = false;
    bench.tick();
    EXPECT_TRUE(bench.servo.finish_requested());
}

TEST(Servo, AllocatesNothingInATick) {
    Bench bench;
    bench.tick();
    const long probe = placode::test::allocations;
    ::operator delete(::operator new(8));
    ASSERT_GT(placode::test::allocations, probe) << "the interposer counts";
    const long before = placode::test::allocations;
    for (int i = 0; i < 3000; ++i) {
        bench.script.state.position_m = Vec3(0.001 * std::sin(0.01 * i), 0, -2e-6 * i);
        if (i == 1500) bench.script.state.position_m.x() = std::nan("");
        bench.script.state.status = i % 701 == 700 ? DeviceStatus::kLost : DeviceStatus::kReady;
        bench.tick();
    }
    EXPECT_EQ(placode::test::allocations, before);
}

TEST(Servo, KeepsForceAndStiffnessWithinTheDevice) {
    DeviceInfo weak;
    weak.max_force_n = 1.0;
    weak.max_stiffness_n_m = 200;
    weak.max_damping_ns_m = 1;
    const CouplingSettings settings = limited_to({}, weak);
    EXPECT_DOUBLE_EQ(settings.max_force_n, 0.91);
    EXPECT_DOUBLE_EQ(settings.stiffness_n_m, 200);
    EXPECT_DOUBLE_EQ(settings.damping_ns_m, 1);
    EXPECT_LE(settings.thermal_floor_n, settings.max_force_n);
    const CouplingSettings free = limited_to({}, DeviceInfo{});
    EXPECT_DOUBLE_EQ(free.max_force_n, CouplingSettings{}.max_force_n);
    EXPECT_DOUBLE_EQ(free.stiffness_n_m, CouplingSettings{}.stiffness_n_m);
}

// A hand whose motion is made five times larger feels 25 times the stiffness of the spring.
TEST(Servo, KeepsStiffnessWithinTheDeviceAtItsScale) {
    DeviceInfo arm;
    arm.max_stiffness_n_m = 400;
    arm.max_damping_ns_m = 4;
    EXPECT_DOUBLE_EQ(limited_to({}, arm, 5).stiffness_n_m, 16);
    EXPECT_DOUBLE_EQ(limited_to({}, arm, 5).damping_ns_m, 0.16);
    EXPECT_DOUBLE_EQ(limited_to({}, arm, 0.1).stiffness_n_m, CouplingSettings{}.stiffness_n_m);
    EXPECT_DOUBLE_EQ(limited_to({}, DeviceInfo{}, 5).stiffness_n_m,
                     CouplingSettings{}.stiffness_n_m);
    const std::vector<sim::ToolSpec> tools{sim::ToolSpec{}};
    TrocarSettings trocar;
    trocar.scale = 5;
    const Servo servo(std::make_unique<ScheduledDevice>(), tools, std::span(&trocar, 1), {});
    EXPECT_DOUBLE_EQ(servo.stiffness_n_m(0), 16) << "the physics holds the tool with as much";
}

TEST(Servo, CertifiesWhatItDid) {
    Bench bench;
    for (int i = 0; i < 1000; ++i) bench.tick();
    bench.feedback[0].proxy.p.z() += 0.001;
    for (int i = 0; i < 100; ++i) bench.tick();
    const double stopped = bench.feedback[0].time_s;
    for (int i = 0; i < 20; ++i) {  // the physics stands still
        bench.tick();
        bench.feedback[0].time_s = stopped;
        bench.servo.tick(bench.t_ns += kMs, bench.inputs, bench.feedback);
    }
    bench.script.state.status = DeviceStatus::kLost;
    bench.tick();
    const HapticCertificate certificate = bench.servo.certificate();
    EXPECT_TRUE(certificate.lock_step);
    EXPECT_EQ(certificate.ticks, 1141u);
    EXPECT_NEAR(certificate.duration_s, 1.140, 1e-9);
    EXPECT_EQ(certificate.faults, 1u);
    EXPECT_GT(certificate.peak_force_n, 0.2);
    EXPECT_GT(certificate.rms_force_n, 0);
    EXPECT_LT(certificate.rms_force_n, certificate.peak_force_n);
    EXPECT_GE(certificate.tool_states, 1100u);
    EXPECT_GT(certificate.silent, 0u);
}

TEST(Servo, DoesNotCountAPauseAgainstTheCertificate) {
    Bench bench;
    for (int i = 0; i < 100; ++i) bench.tick();
    const double stopped = bench.feedback[0].time_s;
    bench.servo.set_paused(true);
    for (int i = 0; i < 100; ++i) {
        bench.feedback[0].time_s = stopped;
        bench.servo.tick(bench.t_ns += kMs, bench.inputs, bench.feedback);
    }
    EXPECT_EQ(bench.script.force, Vec3::Zero());
    EXPECT_EQ(bench.servo.certificate().stale, 0u);
    bench.servo.set_paused(false);
    bench.servo.tick(bench.t_ns += kMs, bench.inputs, bench.feedback);
    EXPECT_EQ(bench.servo.certificate().stale, 1u);
}

TEST(Servo, CountsADoubtThatOutlastsItsPause) {
    Bench bench;
    const auto faults = [&] { return bench.servo.certificate().faults; };
    for (int i = 0; i < 100; ++i) bench.tick();
    bench.servo.set_paused(true);
    bench.script.state.status = DeviceStatus::kLost;
    bench.tick();
    bench.script.state.status = DeviceStatus::kReady;
    for (int i = 0; i < 200; ++i) bench.tick();
    bench.servo.set_paused(false);
    bench.tick();
    EXPECT_EQ(faults(), 0u) << "back before the pause was over";
    bench.servo.set_paused(true);
    bench.script.state.status = DeviceStatus::kLost;
    bench.tick();
    EXPECT_EQ(faults(), 0u);
    bench.servo.set_paused(false);
    bench.tick();
    bench.tick();
    EXPECT_EQ(faults(), 1u) << "once";
}

TEST(Servo, CountsNothingBeforeTheFirstFrame) {
    ScheduledBench bench;
    bench.device->status = DeviceStatus::kNotCalibrated;
    bench.wait(100);
    bench.device->clock_ns += 50 * kMs;
    bench.wait(1);
    bench.device->status = DeviceStatus::kReady;
    bench.wait(200);
    bench.tick(2000);
    const HapticCertificate certificate = bench.servo.certificate();
    EXPECT_EQ(certificate.faults, 0u);
    EXPECT_EQ(certificate.late, 0u);
    EXPECT_EQ(certificate.gaps, 0u);
    EXPECT_EQ(certificate.missed, 0u);
    EXPECT_EQ(bench.grade(), CertificateGrade::kSound);
    bench.device->status = DeviceStatus::kNotCalibrated;
    bench.tick(1);
    EXPECT_EQ(bench.servo.certificate().faults, 1u) << "from then on it does";
}

TEST(Servo, AccountsForASchedulerThatDiedWithoutAWord) {
    ScheduledBench bench;
    bench.tick(2000);
    ASSERT_EQ(bench.grade(), CertificateGrade::kSound);
    bench.device->clock_ns += 10 * kMs;
    bench.tick(1);
    EXPECT_EQ(bench.servo.certificate().missed, 10u);
    EXPECT_EQ(bench.grade(), CertificateGrade::kSound) << "one hiccup";
    bench.device->clock_ns += 3000 * kMs;
    bench.servo.stop();
    const HapticCertificate certificate = bench.servo.certificate();
    EXPECT_EQ(certificate.missed, 3009u);
    EXPECT_EQ(certificate.gaps, 2u);
    EXPECT_NEAR(certificate.duration_s, 5.010, 1e-9);
    EXPECT_EQ(bench.grade(), CertificateGrade::kBad);
}

TEST(Servo, HoldsTheTimeAfterItsReleaseAgainstNoScheduler) {
    ScheduledBench bench;
    bench.tick(2000);
    bench.servo.release();
    bench.tick(60);
    bench.device->clock_ns += 3000 * kMs;  // the attempt's last frame takes long
    bench.servo.stop();
    EXPECT_EQ(bench.servo.certificate().missed, 0u);
    EXPECT_EQ(bench.grade(), CertificateGrade::kSound);
}

TEST(Servo, SendsNoForceAfterAReadThatHung) {
    ScheduledBench bench;
    bench.pushed_m.z() = 0.001;
    bench.tick(700);
    ASSERT_GT(bench.device->force.norm(), 0.2) << "there was a force to hold";
    bench.device->read_ns = 20 * kMs;
    bench.tick(1);
    EXPECT_EQ(bench.device->force, Vec3::Zero());
    bench.device->read_ns = 0;
    bench.tick(700);
    EXPECT_GT(bench.device->force.norm(), 0.1) << "and it comes back by its ramp";
}

TEST(Servo, GivesTheSameBitsForTheSameHand) {
    const auto run = [] {
        Bench bench;
        std::array<double, 3> sum{};
        for (int i = 0; i < 1000; ++i) {
            bench.script.state.position_m = Vec3(0.001 * std::sin(0.01 * i), 0, -2e-6 * i);
            bench.tick();
            for (size_t k = 0; k < 3; ++k)
                sum[k] += bench.script.force[static_cast<int>(k)] * (i + 1);
        }
        return sum;
    };
    EXPECT_EQ(run(), run());
}

TEST(Servo, StopsTheDevicesOnceWithoutForce) {
    Bench bench;
    bench.tick();
    bench.servo.stop();
    bench.servo.stop();
    EXPECT_EQ(bench.script.stops, 1);
    EXPECT_EQ(bench.script.force, Vec3::Zero());
}

TEST(Servo, StartsNoThreadForAGroupInLockStep) {
    Bench bench;
    bench.servo.start();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_EQ(bench.script.reads, 0);
}

TEST(Servo, RunsInItsOwnThreadAndReportsItsHealth) {
    Bench bench(false);
    bench.script.state.position_m = Vec3(0.001, 0, 0);
    bench.script.state.pedals = sim::kPedalCoag;
    bench.servo.start();
    // Waits for the event, not for a time; the limit only keeps a broken build from hanging.
    const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    auto& exchange = bench.servo.exchange();
    int64_t published = 0;
    while (published < 50 && std::chrono::steady_clock::now() < limit) {
        published += exchange.inputs.refresh() ? 1 : 0;
        exchange.feedback.back()[0].proxy.p = TrocarSettings{}.home_tip_m;
        exchange.feedback.back()[0].time_s += 1e-3;
        exchange.feedback.publish();
        std::this_thread::sleep_for(std::chrono::microseconds(500));
    }
    bench.servo.stop();
    ASSERT_GE(published, 50);
    EXPECT_NEAR(exchange.inputs.front()[0].position_m[0], 0.001, 1e-8);
    EXPECT_EQ(exchange.inputs.front()[0].pedals, sim::kPedalCoag);
    const ServoHealth health = bench.servo.health();
    EXPECT_GE(health.ticks, 50u);
    // Whatever the machine did: the order of the percentiles is a matter of logic.
    EXPECT_GT(health.period_p50_us, 0);
    EXPECT_LE(health.period_p50_us, health.period_p99_us);
    EXPECT_LE(health.period_p99_us, health.period_p999_us);
    EXPECT_LE(health.period_p999_us, health.period_max_us);
    if (!health.real_time) {
        EXPECT_NE(health.remark.find("rtprio"), std::string::npos);
    }
    EXPECT_EQ(bench.script.stops, 1);
    EXPECT_EQ(bench.script.force, Vec3::Zero()) << "released at the end";
}

// What a plain user has: no right to SCHED_FIFO, none to lock memory. Rights of root are taken from
// a thread of its own and, with it, from those that it starts.
TEST(Servo, RunsWithoutRealTimeRightsAndSaysHowToGrantThem) {
    const auto limit_to = [](auto which, rlim_t soft) {
        rlimit limit{};
        getrlimit(which, &limit);
        const rlim_t before = limit.rlim_cur;
        limit.rlim_cur = std::min(soft, limit.rlim_max);
        setrlimit(which, &limit);
        return before;
    };
    const rlim_t priority = limit_to(RLIMIT_RTPRIO, 0), memory = limit_to(RLIMIT_MEMLOCK, 0);
    ServoHealth health;
    HapticCertificate certificate;
    std::thread plain_user([&] {
        __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
        __user_cap_data_struct none[2]{};
        ASSERT_EQ(syscall(SYS_capset, &header, none), 0);
        Bench bench(false);
        bench.servo.start();
        const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(20);
        while (bench.servo.health().ticks < 50 && std::chrono::steady_clock::now() < limit)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        health = bench.servo.health();
        certificate = bench.servo.certificate();
        bench.servo.stop();
    });
    plain_user.join();
    limit_to(RLIMIT_RTPRIO, priority);
    limit_to(RLIMIT_MEMLOCK, memory);
    EXPECT_GE(health.ticks, 50u) << "it runs";
    EXPECT_FALSE(health.real_time);
    EXPECT_FALSE(certificate.real_time);
    EXPECT_NE(health.remark.find("--limits-file"), std::string::npos);
#ifndef PLACODE_ONLY_NEW_IS_COUNTED  // a sanitizer pretends to lock memory
    EXPECT_FALSE(certificate.memory_locked);
    EXPECT_NE(health.remark.find("@placode - rtprio 85"), std::string::npos) << health.remark;
    EXPECT_NE(health.remark.find("@placode - memlock unlimited"), std::string::npos);
#endif
}

TEST(Servo, RefusesToolsWithoutTrocars) {
    Script script;
    const std::vector<sim::ToolSpec> tools(2);
    EXPECT_THROW(Servo(std::make_unique<TestDevice>(script, true), tools, Bench::trocars(), {}),
                 DeviceError);
}

}  // namespace THIS_TEST
}  // namespace placode::haptics
