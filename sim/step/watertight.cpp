// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/step/watertight.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "sim/contact/slit_flow.h"
#include "sim/contact/slit_gap.h"
#include "sim/core/as_index.h"
#include "sim/solver/soft_body.h"
#include "sim/step/step.h"
#include "sim/world/add_event.h"
#include "sim/world/scene.h"
#include "sim/world/state.h"

namespace placode::sim {
namespace {

// Tissue follows within 0.2 s: at this rate it is as good as at rest (tests: watertight_test).
constexpr double kRisePaS = 2500;  // 25 cmH2O/s
constexpr double kHoldS = 0.2;     // before a leak is measured
constexpr double kFollow = 0.1;    // of the loads, a frame

}  // namespace

SlitPressure::SlitPressure(const Scene& scene, State& state) : scene_(scene), state_(state) {
    assert(scene.slit.watertight);
    const std::vector<Slit::Station>& stations = scene.slit.stations;
    for (size_t i = 0; i < stations.size(); ++i) {
        const auto half_way_to = [&](size_t other) {
            return 0.5 * (middle_at_rest(scene, static_cast<int>(i)) -
                          middle_at_rest(scene, static_cast<int>(other)))
                             .norm();
        };
        double length_m = 0;
        if (i > 0) length_m += half_way_to(i - 1);
        if (i + 1 < stations.size()) length_m += half_way_to(i + 1);
        length_m_.push_back(length_m);
        for (size_t level = 0; level <= as_index(scene.slit.layers); ++level)
            vertices_.insert(vertices_.end(), {stations[i].left[level], stations[i].right[level]});
    }
    std::sort(vertices_.begin(), vertices_.end());
    load_n_.resize(vertices_.size());
    flow_m3_s_.resize(stations.size());
    gap_m_.resize(stations.size());
    wall_pa_.resize(stations.size());
}

double SlitPressure::flow_m3_s() const noexcept {
    return std::accumulate(flow_m3_s_.begin(), flow_m3_s_.end(), 0.0);
}

void SlitPressure::flow_at(int station, double pressure_pa) noexcept {
    const auto i = as_index(station);
    SlitStretch stretch;
    stretch.length_m = length_m_[i];
    stretch.layers = scene_.slit.layers;
    for (int level = 0; level <= stretch.layers; ++level) {
        const auto k = as_index(level);
        stretch.gap_m[k] = open_gap(scene_, state_, station, level);
        stretch.depth_m[k] = depth_at_rest(scene_, station, level);
    }
    gap_m_[i] =
        *std::min_element(stretch.gap_m.begin(), stretch.gap_m.begin() + stretch.layers + 1);
    const SlitFlow flow = flow_through(stretch, pressure_pa);
    flow_m3_s_[i] = flow.flow_m3_s;
    for (size_t k = 0; k < as_index(stretch.layers); ++k)
        wall_pa_[i][k] += kFollow * (flow.pressure_pa[k] - wall_pa_[i][k]);
}

/// On a quadrilateral, to the side from which its corners run clockwise.
void SlitPressure::press(const std::array<int32_t, 4>& corners, double pressure_pa) noexcept {
    for (const auto& three : {std::array<size_t, 3>{0, 1, 2}, std::array<size_t, 3>{0, 2, 3}}) {
        std::array<Vec3, 3> x;
        for (size_t k = 0; k < 3; ++k) x[k] = position(state_.body, corners[three[k]]);
        const Vec3 third = pressure_pa * (x[1] - x[0]).cross(x[2] - x[0]) / 6;
        for (const size_t corner : three) {
            const auto at = std::lower_bound(vertices_.begin(), vertices_.end(), corners[corner]);
            load_n_[as_index(at - vertices_.begin())] += third;
        }
    }
}

void SlitPressure::push(double pressure_pa) noexcept {
    const std::vector<Slit::Station>& stations = scene_.slit.stations;
    for (int i = 0; i < static_cast<int>(stations.size()); ++i) flow_at(i, pressure_pa);
    std::fill(load_n_.begin(), load_n_.end(), Vec3::Zero());
    const auto floor = as_index(scene_.slit.layers);
    for (size_t i = 0; i + 1 < stations.size(); ++i) {
        const Slit::Station &a = stations[i], &b = stations[i + 1];
        for (size_t k = 0; k < floor; ++k) {
            const double pa = 0.5 * (wall_pa_[i][k] + wall_pa_[i + 1][k]);
            press({a.left[k], b.left[k], b.left[k + 1], a.left[k + 1]}, pa);
            press({a.right[k], a.right[k + 1], b.right[k + 1], b.right[k]}, pa);
        }
        press({a.left[floor], b.left[floor], b.right[floor], a.right[floor]}, pressure_pa);
    }
    for (size_t i = 0; i < vertices_.size(); ++i) {
        // Rags are not blown about.
        if (!is_whole(scene_, state_, vertices_[i])) load_n_[i] = Vec3::Zero();
        set_load(scene_.body, state_.body, vertices_[i], load_n_[i].cast<float>(), Vec3f::Zero(),
                 Vec3f::Zero());
    }
    rouse_all(state_.body);
}

namespace {

/// What each station lets through at a pressure, and how far it stands open.
struct Leaks {
    double pressure_pa = 0, all_m3_s = 0;
    std::vector<double> flow_m3_s, gap_m;
};

/// The pressure rises, stands, rises.
class PressureTest {
 public:
    PressureTest(const Scene& scene, State& state)
        : scene_(scene),
          state_(state),
          spec_(*scene.slit.watertight),
          fluid_(scene, state),
          opened_pa_(scene.slit.stations.size(), -1) {}

    std::vector<Event> run() {
        rise_to(WatertightSpec::kPassPa);
        measure();
        rise_to(WatertightSpec::kGoodPa);
        measure();
        while (!burst() && pressure_pa_ < spec_.most_pa) rise();
        const Leaks last = burst() ? burst_ : leaks();
        const double held_pa = burst() ? last.pressure_pa : spec_.most_pa;
        tell_stations(last, held_pa);
        tell(EventKind::kWatertight, -2, last.all_m3_s, held_pa);
        tell_opened();
        return std::move(events_);
    }

 private:
    [[nodiscard]] bool burst() const noexcept { return burst_.pressure_pa > 0; }
    [[nodiscard]] Leaks leaks() const {
        const auto flows = fluid_.flows(), gaps = fluid_.gaps();
        return {pressure_pa_,
                fluid_.flow_m3_s(),
                {flows.begin(), flows.end()},
                {gaps.begin(), gaps.end()}};
    }
    void push() noexcept {
        fluid_.push(pressure_pa_);
        for (size_t i = 0; i < opened_pa_.size(); ++i)
            if (opened_pa_[i] < 0 && fluid_.flows()[i] > kOpenShare * spec_.burst_m3_s)
                opened_pa_[i] = pressure_pa_;
    }
    void frame() {
        push();
        if (!burst() && fluid_.flow_m3_s() > spec_.burst_m3_s) burst_ = leaks();
        const size_t tools = scene_.tools.size();
        (void)step(scene_, state_, {nobody_.data(), tools}, {feedback_.data(), tools});
    }
    void rise() {
        pressure_pa_ =
            std::min(pressure_pa_ + kRisePaS * scene_.body.spec().solver.frame_s, spec_.most_pa);
        frame();
    }
    void rise_to(double pressure_pa) {
        while (pressure_pa_ < pressure_pa) rise();
        const double frames = kHoldS / scene_.body.spec().solver.frame_s;
        for (int i = 0; i < frames; ++i) frame();
    }
    /// At the present pressure, as a whole and station by station.
    void measure() {
        push();
        const Leaks now = leaks();
        tell(EventKind::kWatertight, -1, now.all_m3_s, pressure_pa_);
        tell_stations(now, pressure_pa_);
    }
    void tell_stations(const Leaks& at, double pressure_pa) {
        for (size_t i = 0; i < at.flow_m3_s.size(); ++i) {
            tell(EventKind::kWatertight, static_cast<int32_t>(i), at.flow_m3_s[i], pressure_pa);
            tell(EventKind::kSlitPressed, static_cast<int32_t>(i), at.gap_m[i], pressure_pa);
        }
    }
    void tell_opened() {
        tell(EventKind::kSlitOpened, -1, static_cast<double>(opened_pa_.size()), burst() ? 1 : 0);
        for (size_t i = 0; i < opened_pa_.size(); ++i) {
            const bool opened = opened_pa_[i] >= 0;
            tell(EventKind::kSlitOpened, static_cast<int32_t>(i),
                 opened ? opened_pa_[i] : pressure_pa_, opened ? 1 : 0);
        }
    }
    void tell(EventKind kind, int32_t element, double value, double value2) {
        Event event;
        event.kind = kind;
        event.element = element;
        event.value = static_cast<float>(value);
        event.value2 = static_cast<float>(value2);
        if (element >= 0) set_rest_position(event, middle_at_rest(scene_, element));
        events_.push_back(event);
    }

    const Scene& scene_;
    State& state_;
    const WatertightSpec& spec_;
    SlitPressure fluid_;
    std::vector<double> opened_pa_;  // of each station; -1 = not yet
    std::array<ToolInput, kMaxTools> nobody_{};
    std::array<ToolFeedback, kMaxTools> feedback_{};
    double pressure_pa_ = 0;
    Leaks burst_;  // no pressure = it has not burst
    std::vector<Event> events_;
};

}  // namespace

std::vector<Event> watertight_events(const Scene& scene, State& state) {
    if (!scene.slit.present() || !scene.slit.watertight) return {};
    return PressureTest(scene, state).run();
}

}  // namespace placode::sim
