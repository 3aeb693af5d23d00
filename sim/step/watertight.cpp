// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/step/watertight.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "sim/contact/self_contact.h"
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

double floor_gap(const Scene& scene, const State& state, const Slit::Station& s) noexcept {
    const auto floor = as_index(scene.slit.layers);
    const Vec3 across = position(state.body, s.right[floor]) - position(state.body, s.left[floor]);
    return std::max(0.0, across.norm() - kTissueGapM);
}

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
    wall_pa_.resize(stations.size());
}

double SlitPressure::flow_m3_s() const noexcept {
    return std::accumulate(flow_m3_s_.begin(), flow_m3_s_.end(), 0.0);
}

void SlitPressure::flow_at(int station, double pressure_pa) noexcept {
    const auto i = as_index(station);
    const Slit::Station& s = scene_.slit.stations[i];
    SlitStretch stretch;
    stretch.length_m = length_m_[i];
    stretch.layers = scene_.slit.layers;
    for (int level = 0; level <= stretch.layers; ++level) {
        const auto k = as_index(level);
        stretch.gap_m[k] = level < stretch.layers ? open_gap(scene_, state_, station, level)
                                                  : floor_gap(scene_, state_, s);
        stretch.depth_m[k] = depth_at_rest(scene_, station, level);
    }
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

/// The pressure rises, stands, rises.
class PressureTest {
 public:
    PressureTest(const Scene& scene, State& state)
        : scene_(scene), state_(state), spec_(*scene.slit.watertight), fluid_(scene, state) {}

    std::vector<Event> run() {
        rise_to(WatertightSpec::kPassPa);
        measure();
        rise_to(WatertightSpec::kGoodPa);
        measure();
        while (burst_pa_ == 0 && pressure_pa_ < spec_.most_pa) rise();
        Event last = entry(-2, burst_pa_ > 0 ? burst_flow_m3_s_ : fluid_.flow_m3_s(),
                           burst_pa_ > 0 ? burst_pa_ : spec_.most_pa);
        events_.push_back(last);
        return std::move(events_);
    }

 private:
    void frame() noexcept {
        fluid_.push(pressure_pa_);
        if (burst_pa_ == 0 && fluid_.flow_m3_s() > spec_.burst_m3_s) {
            burst_pa_ = pressure_pa_;
            burst_flow_m3_s_ = fluid_.flow_m3_s();
        }
        const size_t tools = scene_.tools.size();
        (void)step(scene_, state_, {nobody_.data(), tools}, {feedback_.data(), tools});
    }
    void rise() noexcept {
        pressure_pa_ =
            std::min(pressure_pa_ + kRisePaS * scene_.body.spec().solver.frame_s, spec_.most_pa);
        frame();
    }
    void rise_to(double pressure_pa) noexcept {
        while (pressure_pa_ < pressure_pa) rise();
        const double frames = kHoldS / scene_.body.spec().solver.frame_s;
        for (int i = 0; i < frames; ++i) frame();
    }
    /// At the present pressure, as a whole and station by station.
    void measure() {
        fluid_.push(pressure_pa_);
        events_.push_back(entry(-1, fluid_.flow_m3_s(), pressure_pa_));
        for (size_t i = 0; i < fluid_.flows().size(); ++i) {
            Event event = entry(static_cast<int32_t>(i), fluid_.flows()[i], pressure_pa_);
            set_rest_position(event, middle_at_rest(scene_, event.element));
            events_.push_back(event);
        }
    }
    [[nodiscard]] static Event entry(int32_t element, double flow_m3_s, double pressure_pa) {
        Event event;
        event.kind = EventKind::kWatertight;
        event.element = element;
        event.value = static_cast<float>(flow_m3_s);
        event.value2 = static_cast<float>(pressure_pa);
        return event;
    }

    const Scene& scene_;
    State& state_;
    const WatertightSpec& spec_;
    SlitPressure fluid_;
    std::array<ToolInput, kMaxTools> nobody_{};
    std::array<ToolFeedback, kMaxTools> feedback_{};
    double pressure_pa_ = 0, burst_pa_ = 0, burst_flow_m3_s_ = 0;
    std::vector<Event> events_;
};

}  // namespace

std::vector<Event> watertight_events(const Scene& scene, State& state) {
    if (!scene.slit.present() || !scene.slit.watertight) return {};
    return PressureTest(scene, state).run();
}

}  // namespace placode::sim
