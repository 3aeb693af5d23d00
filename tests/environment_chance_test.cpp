// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Actions by chance in every task: never NaN, never a crash, no memory that grows, and every moment
// can be saved and gone back to. A sample in the suite; 10^6 actions with PLACODE_LONG_TESTS, which
// takes hours with a sanitizer: --gtest_filter and PLACODE_CHANCE_SEED=N share it among processes.

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <string_view>

#include "environment/environment.h"
#include "sim/world/saved_state.h"
#include "tests/bars.h"
#include "tests/environment_fixture.h"

namespace placode::environment {
namespace THIS_TEST {

constexpr const char* kTasks[] = {
    "touch_targets",        "trace_contour",      "grasp_and_lift",  "two_handed_traction",
    "diathermy_ring_small", "scissors_resection", "needle_handover", "suture_bite",
    "suture_run",           "sb_dissection",
};

/// What this program holds in memory now [MiB].
double resident_mib() {
    std::ifstream statm("/proc/self/statm");
    double pages = 0, resident = 0;
    statm >> pages >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1 << 20);
}

constexpr double kSpeedM_S = 0.1;

/// Hands without a plan: each keeps a wish for up to 80 steps.
class Chance {
 public:
    Chance(Environment& environment, uint64_t seed)
        : environment_(environment), random_(seed), wish_(environment.tools() * kActionSize) {
        environment_.reset(1 + below(4));
    }

    /// One action. @return whether all that a policy sees is a number.
    bool act() {
        if (environment_.ended() || below(20'000) == 0) environment_.reset(below(9));
        if (left_-- <= 0) wish_anew();
        const bool finish = below(50'000) == 0;
        const StepOutcome outcome = environment_.step(wish_, 1 + int(below(3)), finish);
        bool good = std::isfinite(outcome.reward) && outcome.frames > 0;
        for (const double number : test::observation_of(environment_))
            good = good && std::isfinite(number);
        for (const sim::ToolFeedback& felt : environment_.feedback())
            touched_ += felt.force_n.norm() > 0.02 ? 1 : 0;
        const double points = environment_.judged().score.points;
        good = good && points >= 0 && points <= 100;
        if (below(2'000) == 0) good = goes_back() && good;
        return good;
    }

    /// How many times an instrument felt something.
    [[nodiscard]] int touched() const { return touched_; }

 private:
    uint64_t below(uint64_t end) { return random_.next() % end; }

    void wish_anew() {
        left_ = static_cast<int>(below(80));
        for (double& number : wish_) number = random_.uniform(-1, 1);
        for (size_t tool = 0; tool < environment_.tools(); ++tool) {
            // Towards any place in or just above the tissue.
            const sim::Vec3 place(random_.uniform(-0.012, 0.012), random_.uniform(-0.01, 0.01),
                                  random_.uniform(-0.003, 0.005));
            const sim::Vec3 offset =
                10 * (place - environment_.feedback()[tool].proxy.p) / kSpeedM_S;
            for (int i = 0; i < 3; ++i)
                wish_[tool * kActionSize + i] = std::clamp(offset[i], -1.0, 1.0);
        }
    }

    /// A moment that was left and entered again goes on with the same bits.
    bool goes_back() {
        if (environment_.ended()) return true;
        environment_.save(moment_);
        environment_.step(wish_, 5);
        const uint64_t once = sim::whole_hash(environment_.state());
        environment_.restore(moment_);
        environment_.step(wish_, 5);
        return sim::whole_hash(environment_.state()) == once;
    }

    Environment& environment_;
    sim::SplitMix64 random_;
    std::vector<double> wish_;
    SavedMoment moment_;
    int left_ = 0, touched_ = 0;
};

/// A pad has less room between its marks: edges may be less coarse there.
constexpr const char* kCoarsePad = R"({"edge_outer_m": 0.0024, "solver": {"substeps": 2}})";

uint64_t chance_seed() {
    const char* set = std::getenv("PLACODE_CHANCE_SEED");
    return set != nullptr ? std::strtoull(set, nullptr, 10) : 7;
}

class EveryTask : public testing::TestWithParam<const char*> {};

TEST_P(EveryTask, SurvivesActionsByChance) {
    EnvironmentOptions options = test::coarse();
    const std::string_view task = GetParam();
    if (task.starts_with("suture") || task.starts_with("needle"))
        options.scene_changes_json = kCoarsePad;
    options.speed_m_s = kSpeedM_S;
    options.start_spread_m = 0.004;
    Environment environment(std::make_shared<FieldCache>(), GetParam(), options);
    Chance chance(environment, chance_seed());
    const std::string name = std::string("actions by chance: ") + GetParam();
    test::Bar bar(name.c_str());
    const int count = test::times(1'200, 112'000);
    double settled_mib = 0;
    for (int i = 0; i < count; ++i) {
        const bool good = chance.act();
        bar.tried(good);
        ASSERT_TRUE(good) << "action " << i << ", frame " << environment.state().frame;
        if (i == count / 2) settled_mib = resident_mib();
    }
    EXPECT_GT(chance.touched(), count / 20) << "chance hardly meets the tissue";
    // A sanitizer keeps freed memory for a while: 256 MiB of it.
    EXPECT_LT(resident_mib() - settled_mib, 300) << "memory grows";
}

INSTANTIATE_TEST_SUITE_P(Tasks, EveryTask, testing::ValuesIn(kTasks),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace THIS_TEST
}  // namespace placode::environment
