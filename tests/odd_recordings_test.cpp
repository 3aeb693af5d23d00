// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings that no attempt makes: random events and samples with values that are no numbers, huge
// ones, times that go back or jump by years. Metrics, phases and the score of such a recording are
// finite or absent; nothing throws, hangs or fills the memory.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "assessment/ledger.h"
#include "assessment/phases.h"
#include "assessment/scoring.h"
#include "sim/ledger/damage.h"

namespace placode::assessment {
namespace THIS_TEST {

constexpr int kRecordings = 200;
constexpr int kEventKinds = static_cast<int>(sim::EventKind::kNeedleLeftIn) + 1;

class OddMaker {
 public:
    explicit OddMaker(uint32_t seed) : random_(seed) {}

    sim::Recording make() {
        sim::Recording recording;
        recording.header.sample_s = pick<double>({0.01, 0.01, 0.01, 0, -1, NAN, 1e300});
        recording.header.tools.resize(static_cast<size_t>(below(7)));
        for (auto& tool : recording.header.tools)
            tool.kind = static_cast<sim::ToolKind>(below(sim::kToolKinds));
        if (below(4) > 0) add_field(recording.header.geometry);
        rate_ = pick<double>({0.01, 0.3, 0});
        const int samples = pick<int>({0, 1, 2, 3, 9, 10, 40, 300});
        const int clock = below(6);
        for (int k = 0; k < samples; ++k) recording.samples.push_back(sample(k, clock));
        for (int k = pick<int>({0, 1, 30, 200}); k > 0; --k) recording.events.push_back(event());
        recording.end.duration_s = number(3);
        return recording;
    }

 private:
    int below(int n) { return static_cast<int>(random_() % static_cast<uint32_t>(n)); }
    template <class T>
    T pick(std::initializer_list<T> from) {
        return *(from.begin() + below(static_cast<int>(from.size())));
    }
    /// Mostly around `size`, now and then not a number that anybody measured.
    double number(double size) {
        if (std::uniform_real_distribution<>(0, 1)(random_) >= rate_)
            return std::uniform_real_distribution<>(-size, size)(random_);
        constexpr double kInfinity = std::numeric_limits<double>::infinity();
        return pick<double>({NAN, kInfinity, -kInfinity, 1e300, -1e300, 1e38, 5e-324, 0});
    }
    float single(double size) { return static_cast<float>(number(size)); }

    void add_field(sim::FieldGeometry& field) {
        const int points = pick<int>({2, 3, 60});
        for (int i = 0; i < points; ++i) {
            const double a = 2 * std::numbers::pi * i / points;
            const sim::Vec3 offset(std::cos(a), std::sin(a), 0);
            field.planned_contour.push_back(0.006 * offset);
            field.placode_edge.push_back(0.004 * offset);
            field.skin_edge.push_back(0.009 * offset);
        }
        field.placode_volume_m3 = number(1e-7);
        field.target_depth_m = number(1e-3);
    }

    sim::Sample sample(int k, int clock) {
        sim::Sample s;
        s.time_s = clock == 0   ? number(10)
                   : clock == 1 ? 1
                   : clock == 2 ? -0.01 * k
                   : clock == 3 ? 0.01 * k + (k > 5 ? 1e9 : 0)
                                : 0.01 * k;
        for (sim::ToolSample& tool : s.tools) {
            for (float& x : tool.tip_m) x = single(0.01);
            for (float& x : tool.orientation) x = single(1);
            for (float& x : tool.force_n) x = single(0.3);
            tool.power_w = single(12);
            tool.pedals = static_cast<uint8_t>(below(4));
            tool.in_contact = static_cast<uint8_t>(below(2));
            tool.in_view = static_cast<uint8_t>(below(2));
            tool.touched = static_cast<sim::Tissue>(below(8));
        }
        s.placode_peak_c = single(90);
        s.placode_peak_cem43_min = single(1e3);
        s.placode_burned_m3 = single(1e-8);
        s.phase = static_cast<sim::Phase>(below(5));
        return s;
    }

    sim::Event event() {
        sim::Event e;
        e.time_s = number(5);
        e.kind = static_cast<sim::EventKind>(below(kEventKinds));
        e.tool = static_cast<int8_t>(below(6) - 1);
        e.tissue = static_cast<sim::Tissue>(below(8));
        e.value = single(1);
        e.value2 = single(1);
        for (float& x : e.rest_position_m) x = single(0.01);
        e.element = below(100) - 1;
        return e;
    }

    std::mt19937 random_;
    double rate_ = 0;
};

TEST(OddRecordings, HaveFiniteMetricsOrNone) {
    OddMaker maker(6);
    size_t metrics = 0;
    for (int i = 0; i < kRecordings; ++i) {
        SCOPED_TRACE("recording " + std::to_string(i));
        const sim::Recording recording = maker.make();
        MetricSet set;
        ASSERT_NO_THROW(set = compute_metrics(recording));
        for (const Metric& metric : set.values)
            ASSERT_TRUE(std::isfinite(metric.value)) << metric.id;
        metrics += set.values.size();
        ASSERT_NO_THROW((void)compute_phase_metrics(recording));
        ASSERT_NO_THROW((void)damage_ledger(recording.events, recording.header.geometry));
        Rubric rubric;
        for (const Metric& metric : set.values)
            rubric.items.push_back({metric.id, metric.id, "{value} {where} {count}", 0, 1, 1, 5});
        Score score;
        ASSERT_NO_THROW(score = score_attempt(rubric, set, recording));
        EXPECT_GE(score.points, 0);
        EXPECT_LE(score.points, 100);
    }
    EXPECT_GT(metrics, 1000u) << "they are odd, but not empty";
}

}  // namespace THIS_TEST
}  // namespace placode::assessment
