// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A made recording of a sewn slit under pressure: nothing is simulated. A slit of 12 mm along y at
// x = 9 mm with stations every half millimetre, from -y on, and three bites, the first at +4 mm:
// left in the picture.

#include <algorithm>
#include <utility>
#include <vector>

#include "sim/step/recording.h"
#include "sim/world/slit.h"

namespace placode::test {

/// Leaks of each station, in the order of the recording.
struct LeakySlit {
    static constexpr int kStations = 23;
    std::vector<double> pass_ml_min = at({{20, 0.3}, {21, 0.1}});
    std::vector<double> good_ml_min = at({{20, 0.3}, {21, 0.1}, {6, 3.5}, {7, 5}, {8, 3.5}});
    std::vector<double> last_ml_min = at({{1, 7}, {2, 2.6}, {7, 1}});
    double burst_pa = 1000;
    bool burst = true;

    static std::vector<double> at(const std::vector<std::pair<int, double>>& some) {
        std::vector<double> all(kStations, 0);
        for (const auto& [station, leak] : some) all[static_cast<size_t>(station)] = leak;
        return all;
    }
};

inline sim::Event slit_event(sim::EventKind kind, int element, double value, double value2,
                             double y_m = 0, double x_m = 0.009) {
    sim::Event event;
    event.time_s = 30;
    event.kind = kind;
    event.element = element;
    event.value = static_cast<float>(value);
    event.value2 = static_cast<float>(value2);
    event.rest_position_m = {static_cast<float>(x_m), static_cast<float>(y_m), 0};
    return event;
}

/// In at +x, out at -x, at these places along y.
inline void add_bites(sim::Recording& recording, const std::vector<double>& places_m) {
    int number = 0;
    for (const double y : places_m) {
        const double time_s = 1 + 5 * number;
        const auto add = [&](sim::EventKind kind, double value2, double x, int element = -1) {
            sim::Event event = slit_event(kind, element, 0, value2, y, x);
            event.time_s = time_s;
            event.hash = static_cast<uint64_t>(number) + 1;
            recording.events.push_back(event);
        };
        add(sim::EventKind::kBiteMark, 0, 0.012, number);
        add(sim::EventKind::kBiteMark, 1, 0.006, number);
        add(sim::EventKind::kNeedleEntered, 0.8, 0.012);
        add(sim::EventKind::kBiteEntry, 0.0002, 0.012);
        add(sim::EventKind::kNeedleLeft, 0.0012, 0.006);
        add(sim::EventKind::kBiteExit, 0.0002, 0.006);
        add(sim::EventKind::kNeedleThrough, 0, 0.006);
        ++number;
    }
}

inline sim::Recording leaky_slit(const LeakySlit& slit = {}) {
    using enum sim::EventKind;
    sim::Recording recording;
    add_bites(recording, {0.004, 0, -0.004});
    const auto y_of = [](int station) { return -0.0055 + 0.0005 * station; };
    auto& events = recording.events;
    events.push_back(slit_event(kSlitGap, -1, LeakySlit::kStations, 0.0015));
    for (int i = 0; i < LeakySlit::kStations; ++i) {
        const bool open = slit.good_ml_min[static_cast<size_t>(i)] > 0;
        events.push_back(slit_event(kSlitGap, i, open ? 5e-5 : 0, open ? 8e-5 : 0, y_of(i)));
    }
    const auto stations = [&](const std::vector<double>& leaks, double pa) {
        for (int i = 0; i < LeakySlit::kStations; ++i) {
            const double leak = leaks[static_cast<size_t>(i)];
            events.push_back(slit_event(kWatertight, i, leak / 6e7, pa, y_of(i)));
            events.push_back(slit_event(kSlitPressed, i, leak > 0 ? 1e-4 : 0, pa, y_of(i)));
        }
    };
    const auto sum = [](const std::vector<double>& leaks) {
        double all = 0;
        for (const double leak : leaks) all += leak / 6e7;
        return all;
    };
    events.push_back(slit_event(kWatertight, -1, sum(slit.pass_ml_min), 588.4));
    stations(slit.pass_ml_min, 588.4);
    events.push_back(slit_event(kWatertight, -1, sum(slit.good_ml_min), 1225.8));
    stations(slit.good_ml_min, 1225.8);
    const double held_pa = slit.burst ? slit.burst_pa : sim::WatertightSpec{}.most_pa;
    stations(slit.last_ml_min, held_pa);
    events.push_back(slit_event(kWatertight, -2, sum(slit.last_ml_min), held_pa));
    events.push_back(slit_event(kSlitOpened, -1, LeakySlit::kStations, slit.burst ? 1 : 0));
    for (int i = 0; i < LeakySlit::kStations; ++i) {
        const auto at = static_cast<size_t>(i);
        const double pa = slit.pass_ml_min[at] > 0   ? 300
                          : slit.last_ml_min[at] > 0 ? 900
                          : slit.good_ml_min[at] > 0 ? 1100
                                                     : -1;
        events.push_back(
            slit_event(kSlitOpened, i, pa > 0 ? pa : held_pa, pa > 0 ? 1 : 0, y_of(i)));
    }
    recording.end.duration_s = 30;
    return recording;
}

/// A quarter turn: left becomes top.
inline sim::Recording upright(sim::Recording recording) {
    for (sim::Event& event : recording.events) {
        auto& p = event.rest_position_m;
        p = {p[1], 0.009F - p[0], 0};
    }
    return recording;
}

/// As a program recorded it that told the leaks at two pressures and nothing of when and where it
/// opened.
inline sim::Recording without_burst_list(sim::Recording recording) {
    int stations = 0;
    std::erase_if(recording.events, [&](const sim::Event& e) {
        if (e.kind == sim::EventKind::kWatertight && e.element >= 0)
            return ++stations > 2 * LeakySlit::kStations;
        return e.kind == sim::EventKind::kSlitPressed || e.kind == sim::EventKind::kSlitOpened;
    });
    return recording;
}

}  // namespace placode::test
