// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// An attempt in real time on a force device (the stand-in for libHD.so with its own scheduler), and
// its replay: the same bits and the same forces.
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <thread>

#include "curriculum/attempt_runner.h"
#include "haptics/real_time.h"
#include "tests/attempt_fixture.h"
#include "tests/stand_in/hd_stand_in.h"

namespace placode::curriculum {
namespace THIS_TEST {

using sim::Vec3;

const FakeHd& hd() {
    static const FakeHd* controls = [] {
        void* library = dlopen(PLACODE_HD_STAND_IN, RTLD_NOW | RTLD_LOCAL);
        if (library == nullptr) throw std::runtime_error(dlerror());
        return reinterpret_cast<const FakeHd* (*)()>(dlsym(library, "fakehd"))();
    }();
    return *controls;
}

/// The coarse task with a field that a test can afford.
Task quick_task() { return test::tiny_task("diathermy_ring_small"); }

class HapticReplay : public testing::Test {
 protected:
    void SetUp() override {
        path_ = (std::filesystem::temp_directory_path() /
                 ("haptic_replay_" + std::to_string(::getpid()) + ".conf"))
                    .string();
        std::ofstream(path_) << "openhaptics.library = " << PLACODE_HD_STAND_IN
                             << "\narm.mapping = tip\n";
        setenv("PLACODE_STATION", path_.c_str(), 1);
        hd().reset();
        hd().use_thread(1);
    }
    void TearDown() override {
        hd().use_thread(0);
        unsetenv("PLACODE_STATION");
        std::filesystem::remove(path_);
    }
    std::string path_;
};

/// Presses the first instrument into the tissue and draws it along, as a hand of flesh would: on
/// the clock of the wall, whatever the simulation does.
void press(AttemptRunner& runner, const std::shared_ptr<sim::Recording>& recording) {
    const haptics::Station station = haptics::Station::of_this_computer();
    const auto trocars =
        haptics::default_trocars(runner.task().scene.tools, "openhaptics", station);
    const haptics::Trocar trocar(runner.task().scene.tools[0], trocars[0]);
    const Vec3 home = trocars[0].home_tip_m;
    const int64_t start = haptics::monotonic_ns();
    // The end comes by the time limit; this one only keeps a broken build from hanging.
    while (!runner.finished() && haptics::monotonic_ns() - start < 120'000'000'000) {
        const double t = runner.status().time_s;
        const double down = std::min(1.0, t / 0.8), along = std::max(0.0, t - 0.8);
        const Vec3 tip(home.x() + 0.002 * std::sin(3 * along), home.y(), home.z() - 0.0155 * down);
        const Vec3 hand = 1000 * trocar.device_position(tip);
        hd().place(0, hand.x(), hand.y(), hand.z());
        haptics::sleep_until(haptics::monotonic_ns() + 1'000'000);
    }
    runner.wait();
    ASSERT_TRUE(runner.finished());
    ASSERT_FALSE(recording->inputs.empty());
}

TEST_F(HapticReplay, GivesTheSameBitsAndTheSameForces) {
    AttemptOptions options;
    options.device = "openhaptics";
    options.duration_s = 1.6;
    options.threads = 1;
    auto recording = std::make_shared<sim::Recording>();
    AttemptRunner runner(quick_task(), 3, options, std::make_unique<test::MemorySink>(recording));
    runner.start();
    press(runner, recording);
    EXPECT_STREQ(hd().violation(), "");

    // It was a haptic attempt: the hand felt the tissue, held with the stiffness of its coupling.
    const auto certificate = haptics::certificate_from_json(runner.haptic_certificate());
    EXPECT_TRUE(certificate.force);
    EXPECT_FALSE(certificate.lock_step);
    EXPECT_GT(certificate.peak_force_n, 0.005);
    EXPECT_EQ(recording->header.tools[0].hand_n_m, haptics::CouplingSettings{}.stiffness_n_m);
    int touching = 0;
    for (const sim::Sample& sample : recording->samples) touching += sample.tools[0].in_contact;
    ASSERT_GT(touching, 10);

    // Every sample's force again, bit for bit, at any number of threads.
    for (const int threads : {1, 2}) {
        size_t next = 0, compared = 0;
        const ReplayResult result =
            replay(*recording, threads, [&](const sim::Scene& scene, const sim::State& state) {
                if (next == recording->samples.size() ||
                    recording->samples[next].time_s != state.time_s)
                    return;
                const sim::Sample& sample = recording->samples[next++];
                for (size_t i = 0; i < scene.tools.size(); ++i) {
                    std::array<float, 3> force{};
                    for (int k = 0; k < 3; ++k)
                        force[static_cast<size_t>(k)] =
                            static_cast<float>(state.tools[i].force_n[k]);
                    ASSERT_EQ(
                        std::memcmp(force.data(), sample.tools[i].force_n.data(), sizeof force), 0)
                        << "tool " << i << " at " << state.time_s << " s";
                }
                ++compared;
            });
        EXPECT_TRUE(result.identical) << result.message;
        EXPECT_EQ(compared, recording->samples.size());
    }
    // The stiffness of the hand is part of the recording: with another one it differs.
    sim::Recording other = *recording;
    for (sim::ToolSpec& tool : other.header.tools) tool.hand_n_m = 600;
    EXPECT_FALSE(replay(other, 1).identical);
}

// The other half: what the hand felt. The states of hands and tools of one run, given again on the
// same clock, make the same forces; so a trace of them is enough to hear a complaint again.
TEST_F(HapticReplay, TheSameHandsAndToolStatesGiveTheSameForces) {
    struct Tick {
        int64_t t_ns = 0;
        haptics::DeviceState hand;
        sim::ToolFeedback tool;
        Vec3 force_n = Vec3::Zero();
    };
    class Hand final : public haptics::DeviceGroup {
     public:
        explicit Hand(Tick& tick) : tick_(tick) {}
        [[nodiscard]] std::vector<haptics::DeviceInfo> info() const override {
            haptics::DeviceInfo info;
            info.dof_force = 3;
            return {info};
        }
        void read(int64_t, std::span<haptics::DeviceState> states) noexcept override {
            states[0] = tick_.hand;
        }
        void write(std::span<const haptics::DeviceCommand> commands) noexcept override {
            tick_.force_n = commands[0].force_n;
        }
        [[nodiscard]] bool lock_step() const noexcept override { return true; }

     private:
        Tick& tick_;
    };
    const sim::ToolSpec tool;
    haptics::TrocarSettings settings;
    settings.mapping = haptics::Mapping::kTip;
    const auto run = [&](std::vector<Tick>& trace) {
        Tick now;
        haptics::Servo servo(std::make_unique<Hand>(now), std::span(&tool, 1),
                             std::span(&settings, 1), {});
        std::array<sim::ToolInput, 1> inputs{};
        for (Tick& tick : trace) {
            now = tick;
            servo.tick(tick.t_ns, inputs, std::span(&tick.tool, 1));
            tick.force_n = now.force_n;
        }
    };
    // A trace with everything in it: contact, an uneven clock, a stall, a lost device, no number.
    std::vector<Tick> trace(4000);
    int64_t t = 0;
    for (int i = 0; i < 4000; ++i) {
        Tick& tick = trace[static_cast<size_t>(i)];
        t += 1'000'000 + (i * 7919 % 300) * 1000 + (i == 2500 ? 8'000'000 : 0);
        tick.t_ns = t;
        tick.hand.position_m = Vec3(0.001 * std::sin(0.01 * i), 0, -0.0015 * std::sin(0.004 * i));
        if (i == 3000) tick.hand.position_m.x() = std::nan("");
        if (i > 3300 && i < 3320) tick.hand.status = haptics::DeviceStatus::kLost;
        const int seen = i > 1500 && i < 1560 ? 1500 : i;
        tick.tool.time_s = 1e-3 * (seen + 1);
        tick.tool.proxy.p = settings.home_tip_m + trace[static_cast<size_t>(seen)].hand.position_m;
        tick.tool.proxy.p.z() = std::max(tick.tool.proxy.p.z(), settings.home_tip_m.z() - 5e-4);
        if (!tick.tool.proxy.p.allFinite()) tick.tool.proxy.p = settings.home_tip_m;
    }
    run(trace);
    std::vector<Tick> again = trace;
    for (Tick& tick : again) tick.force_n.setConstant(1);
    run(again);
    int felt = 0;
    for (size_t i = 0; i < trace.size(); ++i) {
        ASSERT_EQ(std::memcmp(trace[i].force_n.data(), again[i].force_n.data(), sizeof(Vec3)), 0)
            << i;
        felt += trace[i].force_n.norm() > 0.05 ? 1 : 0;
    }
    EXPECT_GT(felt, 500) << "there were forces to compare";
}

}  // namespace THIS_TEST
}  // namespace placode::curriculum
