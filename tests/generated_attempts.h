// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Recordings made up from a seed, for rules that hold for every attempt: what a task asks for can
// be done to any degree, and any harm can be added.

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "curriculum/task.h"
#include "sim/core/practice.h"
#include "sim/cutting/attempt_progress.h"
#include "sim/cutting/pieces.h"
#include "sim/ledger/damage.h"
#include "sim/step/recording.h"

namespace placode::test {

using sim::Event;
using sim::EventKind;

class AttemptMaker {
 public:
    explicit AttemptMaker(uint32_t seed) : random_(seed) {}

    double number(double least, double most) {
        return std::uniform_real_distribution<double>(least, most)(random_);
    }
    int whole(int least, int most) {
        return std::uniform_int_distribution<int>(least, most)(random_);
    }

    /// An attempt of 30 s in which nothing was done, as this program records it.
    static sim::Recording idle(const curriculum::Task& task) {
        sim::Recording recording;
        recording.header.task_id = task.id;
        recording.header.task_json = task.json;
        recording.header.tools = task.scene.tools;
        recording.header.geometry.planned_contour = circle(kPlan);
        recording.header.geometry.placode_edge = circle(kPlan - 0.0015);
        recording.header.geometry.skin_edge = circle(kPlan + 0.0025);
        recording.header.geometry.placode_volume_m3 = 60e-9;
        for (int i = 0; i < 300; ++i) {
            sim::Sample sample;
            sample.time_s = 0.1 * i;
            recording.samples.push_back(sample);
        }
        recording.header.sample_s = 0.1;
        recording.end.reason = sim::EndReason::kFinished;
        recording.end.duration_s = 30;
        put(recording, sim::EventKind::kLedgerWritten, 0, sim::kLedgerVersion);
        put(recording, sim::EventKind::kStretchSum, 0, 0);
        put(recording, sim::EventKind::kTakenOut, 0, 0);
        put(recording, sim::EventKind::kMarkedLost, 30, 0);
        if (!task.steps.empty())
            put(recording, sim::EventKind::kPracticeSteps, 0,
                static_cast<double>(task.steps.size()));
        std::vector<sim::PracticeKind>& kinds = step_kinds()[task.id];
        kinds.clear();
        for (const curriculum::TaskStep& step : task.steps) kinds.push_back(step.goal.kind);
        if (is_row(kinds)) mark_bite(recording, 0, 0, 0);
        if (task.scene.patch) lay_patch(recording, 0);
        if (task.scene.irrigation) wash(recording, 0);
        if (task.scene.plane) undermine(recording, 0);
        return recording;
    }

    /// Everything that any task asks for, to this share.
    static void ask(sim::Recording& recording, double share) {
        recording.samples.back().cut_fraction = static_cast<float>(share);
        for (int s = 0; s < static_cast<int>(std::lround(share * sim::kSectors)); ++s)
            put(recording, EventKind::kSectorFree, 10, s, s + 1);
        if (share > 0) put(recording, EventKind::kPieceOut, 20, 3e-9, share);
        put(recording, sim::EventKind::kTakenOut, 20, 3e-9 * share, share, 0, 0.006);
        practise(recording, share);
        if (has_patch(recording)) {
            std::erase_if(recording.events, is_of_patch);
            lay_patch(recording, share);
            if (share > 0)
                put(recording, EventKind::kGrasped, 2, 3, 0.1, 0.004, 0, 0, sim::Tissue::kDura);
        }
        if (has_wash(recording)) {
            std::erase_if(recording.events, is_of_wash);
            wash(recording, share);
        }
        if (has_plane(recording)) {
            std::erase_if(recording.events, is_of_plane);
            undermine(recording, share);
        }
        const int grasps = has_patch(recording) ? 0 : static_cast<int>(std::lround(share * 3));
        for (int i = 0; i < grasps; ++i) {
            put(recording, EventKind::kGrasped, 1 + 9 * i, 6, 0.1, 0.004, 0.002, 0);
            put(recording, EventKind::kReleased, 9 + 9 * i, 8, 0.01, 0.004, 0.002, 0);
            for (sim::Sample& sample : recording.samples)
                if (sample.time_s > 1 + 9 * i && sample.time_s < 1 + 9 * i + 9.2 * share / grasps)
                    sample.tools[0].tip_m[2] = 0.001F;
        }
        if (share > 0) {
            put(recording, EventKind::kSnipped, 11, 2e-6, 0.001);
            put(recording, EventKind::kEnergyOff, 9, 3, 12);
        }
        sort(recording);
    }

    /// One harm of a random size, by its number in harms().
    void harm(sim::Recording& recording, size_t which) {
        static const std::vector<void (AttemptMaker::*)(sim::Recording&)> kinds{
            &AttemptMaker::touch_placode, &AttemptMaker::heat_placode, &AttemptMaker::cut_placode,
            &AttemptMaker::tear,          &AttemptMaker::press,        &AttemptMaker::waste_energy,
            &AttemptMaker::bury,          &AttemptMaker::stretch,      &AttemptMaker::jaws,
            &AttemptMaker::snip_skin,     &AttemptMaker::miss,         &AttemptMaker::cut_astray,
            &AttemptMaker::dawdle,        &AttemptMaker::look_away,    &AttemptMaker::stitch,
            &AttemptMaker::shift_patch,   &AttemptMaker::wash_badly,   &AttemptMaker::dig,
            &AttemptMaker::burn_skin,     &AttemptMaker::trace_again,  &AttemptMaker::stray,
            &AttemptMaker::heat_skin};
        (this->*kinds[which])(recording);
        sort(recording);
    }
    static constexpr size_t kHarms = 22;

    /// Some of what is asked, some harm.
    sim::Recording some(const curriculum::Task& task) {
        sim::Recording recording = idle(task);
        ask(recording, number(0, 1) < 0.2 ? 1 : number(0, 1));
        const int harms = whole(0, 8);
        for (int i = 0; i < harms; ++i) harm(recording, static_cast<size_t>(whole(0, kHarms - 1)));
        return recording;
    }

    static Event& put(sim::Recording& recording, EventKind kind, double time_s, double value,
                      double value2 = 0, double x = 0, double y = 0, int tool = 0,
                      sim::Tissue tissue = sim::Tissue::kZone) {
        Event e;
        e.time_s = time_s;
        e.kind = kind;
        e.value = static_cast<float>(value);
        e.value2 = static_cast<float>(value2);
        e.rest_position_m = {static_cast<float>(x), static_cast<float>(y), 0};
        e.tool = static_cast<int8_t>(tool);
        e.tissue = tissue;
        recording.events.push_back(e);
        return recording.events.back();
    }

    /// So many samples of 0.1 s with 6 W in the skin there.
    static void heat(sim::Recording& r, int samples, double x, double y) {
        for (int i = 0; i < samples; ++i) {
            sim::ToolSample& tool = r.samples[static_cast<size_t>(i)].tools[0];
            tool.power_w = 6;
            tool.touched = sim::Tissue::kSkin;
            tool.tip_m[0] = static_cast<float>(x);
            tool.tip_m[1] = static_cast<float>(y);
        }
    }
    /// In the order of time, as a recording has its events.
    static void sort(sim::Recording& recording) {
        std::stable_sort(recording.events.begin(), recording.events.end(),
                         [](const Event& a, const Event& b) { return a.time_s < b.time_s; });
    }

 private:
    static constexpr double kPlan = 0.006;

    static std::vector<sim::Vec3> circle(double radius_m) {
        std::vector<sim::Vec3> points;
        for (int i = 0; i < 360; ++i) {
            const double a = i * std::numbers::pi / 180;
            points.emplace_back(radius_m * std::cos(a), radius_m * std::sin(a), 0);
        }
        return points;
    }

    /// Of the tasks that attempts were made for, by their ids.
    static std::map<std::string, std::vector<sim::PracticeKind>>& step_kinds() {
        static std::map<std::string, std::vector<sim::PracticeKind>> kinds;
        return kinds;
    }
    static bool is_row(const std::vector<sim::PracticeKind>& kinds) {
        return std::count(kinds.begin(), kinds.end(), sim::PracticeKind::kNeedleIn) > 1;
    }
    // Far from where harm happens, so that no harm lies near the line by chance.
    static constexpr double kRowX = 0.04, kHalfBite = 0.003, kPitch = 0.004;
    static void mark_bite(sim::Recording& recording, double time_s, int step, int bite) {
        for (const int side : {0, 1})
            put(recording, EventKind::kBiteMark, time_s, step, side,
                kRowX + (side == 0 ? kHalfBite : -kHalfBite), kPitch * bite)
                .element = bite;
    }
    /// The first `done` steps of a row of bites, 0.2 mm beside their marks.
    static void sew(sim::Recording& recording, const std::vector<sim::PracticeKind>& kinds,
                    int done) {
        using sim::PracticeKind;
        int bite = -1;
        for (int s = 0; s < static_cast<int>(kinds.size()) && s <= done; ++s) {
            const double time_s = 2 + s, y = kPitch * std::max(0, bite);
            const PracticeKind kind = kinds[static_cast<size_t>(s)];
            if (kind == PracticeKind::kNeedleIn && ++bite > 0)
                mark_bite(recording, time_s - 0.9, s, bite);
            if (s == done) return;
            if (kind == PracticeKind::kNeedleIn) {
                const double at = kPitch * bite;
                put(recording, EventKind::kNeedleEntered, time_s, 0.025, 0.8, kRowX, at);
                put(recording, EventKind::kBiteEntry, time_s, s, 0.0002, kRowX + kHalfBite + 0.0002,
                    at);
            } else if (kind == PracticeKind::kNeedleOut) {
                put(recording, EventKind::kNeedleLeft, time_s, 0.025, 0.0012, kRowX, y);
                put(recording, EventKind::kBiteExit, time_s, s, 0.0002, kRowX - kHalfBite - 0.0002,
                    y);
            } else if (kind == PracticeKind::kNeedleThrough) {
                put(recording, EventKind::kNeedleThrough, time_s, 0, 0, kRowX, y);
            } else if (kind == PracticeKind::kThreadDraw) {
                put(recording, EventKind::kThreadDrawn, time_s, s, 0.2, kRowX, y);
            }
        }
    }

    static bool is_handling(const std::vector<sim::PracticeKind>& kinds) {
        return std::count(kinds.begin(), kinds.end(), sim::PracticeKind::kNeedleLay) > 0;
    }
    /// The first `done` steps with a needle that goes from hand to hand: square, at its place.
    static void hand_over(sim::Recording& recording, const std::vector<sim::PracticeKind>& kinds,
                          int done) {
        using sim::PracticeKind;
        for (int s = 0; s < done; ++s) {
            const double time_s = 2 + s;
            switch (kinds[static_cast<size_t>(s)]) {
                case PracticeKind::kNeedleTake:
                    put(recording, EventKind::kNeedleTaken, time_s, 0.01, 0.6, 0.006, 0.001);
                    put(recording, EventKind::kNeedleGrip, time_s, 1, 1, 0.006, 0.001);
                    put(recording, EventKind::kNeedlePlaced, time_s, s, 0.01, 0.006, 0.001);
                    break;
                case PracticeKind::kRelease:
                    put(recording, EventKind::kNeedleHandedOver, time_s, 0.01, 0.05, 0.006, 0.001)
                        .element = 200;
                    break;
                case PracticeKind::kNeedleLay:
                    put(recording, EventKind::kNeedleLaid, time_s, s, 0.001, 0.006, 0.001);
                    put(recording, EventKind::kNeedleSwung, time_s, 2, 0, 0.006, 0.001);
                    break;
                default:
                    break;
            }
        }
    }

    static void practise(sim::Recording& recording, double share) {
        int steps = 0;
        for (const Event& e : recording.events)
            if (e.kind == sim::EventKind::kPracticeSteps) steps = static_cast<int>(e.value);
        for (int s = 0; s < static_cast<int>(share * steps + 1e-9); ++s) {
            put(recording, sim::EventKind::kStepDone, 2 + s, s, 1);
            put(recording, sim::EventKind::kTargetTouched, 2 + s, s, 0.0002, 0.006, 0.001);
        }
        const int done = static_cast<int>(share * steps + 1e-9);
        const auto& kinds = step_kinds()[recording.header.task_id];
        if (is_row(kinds)) {
            sew(recording, kinds, done);
        } else if (is_handling(kinds)) {
            hand_over(recording, kinds, done);
        } else if (done > 0) {
            put(recording, EventKind::kNeedleEntered, 2, 0.025, 0.8, 0.006, 0.001);
            put(recording, sim::EventKind::kBiteEntry, 2, 0, 0.0002, 0.006, 0.001);
        }
        if (done > 1 && !is_row(kinds) && !is_handling(kinds)) {
            put(recording, EventKind::kNeedleLeft, 3, 0.025, 0.0012, 0.006, 0.003);
            put(recording, sim::EventKind::kBiteExit, 3, 1, 0.0002, 0.006, 0.003);
        }
        for (int s = 0; s < done && !is_row(kinds); ++s)
            if (kinds[static_cast<size_t>(s)] == sim::PracticeKind::kNeedleThrough)
                put(recording, EventKind::kNeedleThrough, 2 + s, 0, 0, 0.006, 0.002);
        if (std::count(kinds.begin(), kinds.end(), sim::PracticeKind::kThreadDraw) > 0)
            shut(recording, share);
        for (int bin = 0; bin < static_cast<int>(std::lround(share * sim::kTraceBins)); ++bin)
            put(recording, sim::EventKind::kTraced, 3 + 0.3 * bin, bin, 0.0001);
    }

    static bool is_of_wash(const Event& e) { return e.kind == EventKind::kIrrigated; }
    static bool has_wash(const sim::Recording& recording) {
        return std::any_of(recording.events.begin(), recording.events.end(), is_of_wash);
    }
    static Event& sum(sim::Recording& recording, sim::IrrigationSum what, double value,
                      double value2) {
        Event& e = put(recording, EventKind::kIrrigated, 30, value, value2);
        e.element = static_cast<int32_t>(what);
        return e;
    }
    /// Twelve crumbs and spots, a share of them cleared without harm; 0 = nothing was done.
    static void wash(sim::Recording& recording, double share) {
        using Sum = sim::IrrigationSum;
        sum(recording, Sum::kJet, 200 * share, 0);
        sum(recording, Sum::kFluid, 2e-8, 2e-5 * share);
        sum(recording, Sum::kView, 0.05, 0);
        sum(recording, Sum::kSuction, 0, 0);
        sum(recording, Sum::kDebris, 12, 12 * (1 - share));
    }
    /// The jet too near, the sucker on tissue, fluid and blood left.
    void wash_badly(sim::Recording& r) {
        const int what = whole(0, 3);
        const double more = number(0, 1);
        for (Event& e : r.events) {
            if (!is_of_wash(e) || e.element != what) continue;
            const double most[]{2000, 2e-7, 1, 10}, most2[]{10, 0, 60, 5};
            e.value += static_cast<float>(more * most[what]);
            e.value2 += static_cast<float>(more * most2[what]);
            if (what == 2) e.value = std::min(e.value, 1.0F);
        }
    }

    static bool is_of_plane(const Event& e) {
        return e.kind == EventKind::kUndermined || e.kind == EventKind::kClosingTension;
    }
    static bool has_plane(const sim::Recording& recording) {
        return std::any_of(recording.events.begin(), recording.events.end(), is_of_plane);
    }
    /// A square centimetre to be freed on each side, a bit more than enough of it when all is done.
    static void undermine(sim::Recording& recording, double share) {
        const auto told = [&](EventKind kind, int element, double left, double right) {
            put(recording, kind, 30, left, right).element = element;
        };
        told(EventKind::kUndermined, -1, 4, 0);
        told(EventKind::kUndermined, -2, 1e-4 * share, 1e-4 * share);
        told(EventKind::kUndermined, -3, 1e-4, 1e-4);
        told(EventKind::kUndermined, -4, 0.78e-4 * share, 0.78e-4 * share);
        told(EventKind::kUndermined, -5, 0, 0);
        for (int line = 0; line < 4; ++line)
            put(recording, EventKind::kUndermined, 30, 0.008 * share, line % 2 == 0 ? 1 : -1,
                0.002 * line, line % 2 == 0 ? 0.002 : -0.002)
                .element = line;
        told(EventKind::kClosingTension, -1, 23 * (1 - 0.3 * share), 23);
    }
    /// Too far, below the plane, or in vain.
    void dig(sim::Recording& r) {
        if (whole(0, 1) == 0) {
            anywhere(r, EventKind::kTorn, number(1e-10, 8e-9), 2, sim::Tissue::kMuscle);
            return;
        }
        const double more = number(0, 1);
        for (Event& e : r.events) {
            if (e.kind == EventKind::kUndermined && e.element == -5)
                e.value += static_cast<float>(1e-4 * more);
            if (e.kind == EventKind::kClosingTension) e.value += static_cast<float>(3 * more);
        }
    }

    static bool is_of_patch(const Event& e) {
        return e.kind == EventKind::kPatchEdge || e.kind == EventKind::kPatchFold;
    }
    static bool has_patch(const sim::Recording& recording) {
        return std::any_of(recording.events.begin(), recording.events.end(), is_of_patch);
    }
    /// A patch that reaches up to 5 mm beyond the placode's edge; 0 = beside it. All events carry
    /// the same time: their order is theirs.
    static void lay_patch(sim::Recording& recording, double share) {
        constexpr int kPoints = 72;
        put(recording, EventKind::kPatchEdge, 30, kPoints, share > 0 ? 0 : 1);
        for (int i = 0; i < kPoints; ++i) {
            const double a = 2 * std::numbers::pi * i / kPoints;
            put(recording, EventKind::kPatchEdge, 30, 0.005 * share, 0, kPlan * std::cos(a),
                kPlan * std::sin(a))
                .element = i;
        }
        put(recording, EventKind::kPatchFold, 30, 0, 3e-4, 0.004, 0.003);
    }
    /// It lies worse: drawn aside, off the placode, folded, or taken once more.
    void shift_patch(sim::Recording& r) {
        const int what = whole(0, 3);
        const double less = number(0, 1), more = number(0, 1);
        if (what == 3) {
            put(r, EventKind::kGrasped, number(3, 28), 3, 0.1, 0.005, 0.001, 0, sim::Tissue::kDura);
            if (!has_patch(r)) r.events.pop_back();
            return;
        }
        for (Event& e : r.events) {
            if (e.kind == EventKind::kPatchFold && what == 2)
                e.value += static_cast<float>(more) * (e.value2 - e.value);
            if (e.kind != EventKind::kPatchEdge || what == 2) continue;
            if (e.element < 0 && what == 1) e.value2 += static_cast<float>(more) * (1 - e.value2);
            if (e.element >= 0 && e.element % 3 == what) e.value *= static_cast<float>(less);
        }
    }

    /// A slit of 20 stations, shut from one end on.
    static void shut(sim::Recording& recording, double share) {
        constexpr int kStations = 20;
        const int closed = static_cast<int>(share * kStations + 1e-9);
        for (int i = 0; i < kStations; ++i) {
            const double gap_m = i < closed ? 0 : 0.00095;
            put(recording, EventKind::kSlitGap, 30, gap_m, gap_m, kRowX, 0.0005 * i).element = i;
        }
        // Under pressure: open anywhere it bursts at once.
        const bool tight = share > 1 - 0.5 / kStations;
        const double held_pa = tight ? 3922.7 : 1;
        const auto under = [&](double all_m3_s, double pa, int whole) {
            if (whole == -1)
                put(recording, EventKind::kWatertight, 30, all_m3_s, pa).element = whole;
            for (int i = 0; i < kStations; ++i) {
                const bool open = i >= closed && !tight;
                const double leak_m3_s = open ? all_m3_s / (kStations - closed) : 0;
                put(recording, EventKind::kWatertight, 30, leak_m3_s, pa, kRowX, 0.0005 * i)
                    .element = i;
                put(recording, EventKind::kSlitPressed, 30, open ? 0.001 : 0, pa, kRowX, 0.0005 * i)
                    .element = i;
            }
            if (whole == -2)
                put(recording, EventKind::kWatertight, 30, all_m3_s, pa).element = whole;
        };
        for (const double pa : {sim::WatertightSpec::kPassPa, sim::WatertightSpec::kGoodPa})
            under(tight ? 0 : 5e-6 * (1 - share), pa, -1);
        under(tight ? 0 : 2e-7, held_pa, -2);
        put(recording, EventKind::kSlitOpened, 30, kStations, tight ? 0 : 1).element = -1;
        for (int i = 0; i < kStations; ++i) {
            const bool open = i >= closed && !tight;
            put(recording, EventKind::kSlitOpened, 30, held_pa, open ? 1 : 0, kRowX, 0.0005 * i)
                .element = i;
        }
    }

    /// An event anywhere on the lesion and at any time.
    Event& anywhere(sim::Recording& recording, EventKind kind, double value, double value2,
                    sim::Tissue tissue = sim::Tissue::kZone) {
        const double a = number(0, 2 * std::numbers::pi), r = number(0.002, 0.009);
        return put(recording, kind, number(1, 29), value, value2, r * std::cos(a), r * std::sin(a),
                   0, tissue);
    }
    void touch_placode(sim::Recording& r) {
        anywhere(r, EventKind::kPlacodeContact, number(0.05, 3), number(0.001, 0.2));
        if (whole(0, 2) == 0) anywhere(r, EventKind::kPlacodeEnergised, number(0.01, 1), 90);
    }
    void heat_placode(sim::Recording& r) {
        const double when = anywhere(r, EventKind::kPlacodeOverheated, 60, 50).time_s;
        if (whole(0, 1) == 0) return;
        anywhere(r, EventKind::kPlacodeBurned, 300, 65).time_s = when;
        const auto more = static_cast<float>(number(0, 2e-9));
        for (sim::Sample& sample : r.samples)
            if (sample.time_s >= when) sample.placode_burned_m3 += more;
    }
    void cut_placode(sim::Recording& r) {
        if (whole(0, 1) == 0)
            anywhere(r, EventKind::kPlacodeCut, number(0, 2e-6), 0, sim::Tissue::kPlacode);
        else
            anywhere(r, EventKind::kVaporised, number(1e-12, 5e-10), 0.0004, sim::Tissue::kPlacode);
    }
    void tear(sim::Recording& r) {
        const std::vector<sim::Tissue> all{sim::Tissue::kSkin, sim::Tissue::kThinSkin,
                                           sim::Tissue::kZone, sim::Tissue::kPlacode};
        anywhere(r, EventKind::kTorn, number(1e-11, 4e-9), 2,
                 all[static_cast<size_t>(whole(0, 3))]);
    }
    void press(sim::Recording& r) {
        const Event e = anywhere(r, EventKind::kOverForce, number(0.05, 20), number(0.2, 1));
        r.samples[static_cast<size_t>(whole(0, 299))].tools[0].force_n = {0, 0, e.value2};
    }
    void waste_energy(sim::Recording& r) {
        anywhere(r, whole(0, 1) == 0 ? EventKind::kEnergyInAir : EventKind::kDwell, number(1, 6),
                 0);
    }
    void bury(sim::Recording& r) {
        anywhere(r, EventKind::kBuried, number(0.3, 6), number(0.0005, 0.004));
    }
    void stretch(sim::Recording& r) {
        anywhere(r, sim::EventKind::kStretchSum, number(1e-11, 2e-8), number(1.3, 2.5)).element = 5;
    }
    void jaws(sim::Recording& r) {
        const std::vector<EventKind> all{EventKind::kCrushed, EventKind::kSlipped,
                                         EventKind::kOverTraction};
        anywhere(r, all[static_cast<size_t>(whole(0, 2))], number(0.3, 2), number(0.03, 0.4));
    }
    /// The needle where it should not be, or as it should not go.
    void stitch(sim::Recording& r) {
        switch (whole(0, 9)) {
            case 5:
                anywhere(r, EventKind::kNeedleGrip, 0.5, number(0, 0.9));
                break;
            case 6:
                anywhere(r, EventKind::kNeedleDropped, 3, number(0, 0.02));
                break;
            case 7:
                anywhere(r, EventKind::kNeedleHandedOver, 0, 0).element = 0;
                break;
            case 8:
                anywhere(r, EventKind::kNeedleSwung, number(5, 30), 0);
                break;
            case 9:
                anywhere(r, EventKind::kNeedlePlaced, 1, number(0.05, 0.15));
                break;
            case 0:
                anywhere(r, sim::EventKind::kBiteEntry, 0, 0.02);
                break;
            case 1:
                anywhere(r, EventKind::kNeedleEntered, 0.02, 0);
                break;
            case 2:
                anywhere(r, EventKind::kNeedleTurned, 0.1, 0.01);
                break;
            case 3:
                anywhere(r, EventKind::kThreadCut, 700, 0);
                break;
            default:
                anywhere(r, EventKind::kNeedleTaken, 0.01, 0.7);
        }
    }
    void snip_skin(sim::Recording& r) {
        anywhere(r, EventKind::kSnipped, number(1e-7, 6e-6), 0.001, sim::Tissue::kSkin);
    }
    void miss(sim::Recording& r) {
        anywhere(r, sim::EventKind::kTargetMissed, whole(0, 3), number(0.001, 0.01));
    }
    /// Cut into healthy skin, or too near the placode.
    void cut_astray(sim::Recording& r) {
        const double a = number(0, 2 * std::numbers::pi);
        const double offset = whole(0, 1) == 0 ? number(0.0036, 0.0039) : number(-0.0014, -0.0011);
        put(r, EventKind::kVaporised, number(1, 29), number(1e-12, 2e-11), 0.0004,
            (kPlan + offset) * std::cos(a), (kPlan + offset) * std::sin(a));
    }
    /// Over the first stretch of the line again and again, well or badly: it was followed already.
    void trace_again(sim::Recording& r) {
        const double when = number(25, 29), offset = number(1e-5, 0.003);
        const int passes = whole(1, 200);
        const auto first = std::find_if(r.events.begin(), r.events.end(), [](const Event& e) {
            return e.kind == EventKind::kTraced;
        });
        if (first == r.events.end()) return;
        const int bin = static_cast<int>(first->value);
        for (int i = 0; i < passes; ++i) put(r, EventKind::kTraced, when, bin, offset);
    }
    /// Along no line at all, beside any stretch of this one.
    void stray(sim::Recording& r) {
        const bool traces = std::any_of(r.events.begin(), r.events.end(), [](const Event& e) {
            return e.kind == EventKind::kTraced;
        });
        if (!traces) return;
        const int from = whole(0, sim::kTraceBins - 1), passes = whole(1, 20);
        for (int i = 0; i < passes; ++i)
            put(r, EventKind::kTraced, number(1, 29), (from + i) % sim::kTraceBins,
                number(0.003, 0.009));
    }
    /// Current held on healthy skin, which stays.
    void heat_skin(sim::Recording& r) {
        const double a = number(0, 2 * std::numbers::pi), from = number(0.0096, 0.02);
        heat(r, whole(1, 40), from * std::cos(a), from * std::sin(a));
    }
    /// Healthy skin, from beside the lesion to the edge of the field.
    void burn_skin(sim::Recording& r) {
        const double a = number(0, 2 * std::numbers::pi), from = number(0.0096, 0.02);
        put(r, EventKind::kVaporised, number(1, 29), number(1e-12, 4e-9), 0.0002,
            from * std::cos(a), from * std::sin(a), 0,
            whole(0, 1) == 0 ? sim::Tissue::kSkin : sim::Tissue::kThinSkin);
    }
    void dawdle(sim::Recording& r) {
        const int more = whole(1, 6000);
        for (int i = 0; i < more; i += 60) {
            sim::Sample sample = r.samples.back();
            sample.time_s += 6;
            r.samples.push_back(sample);
        }
        r.end.duration_s = r.samples.back().time_s;
    }
    void look_away(sim::Recording& r) {
        const int from = whole(0, 250), n = whole(1, 49);
        for (int i = from; i < from + n; ++i)
            r.samples[static_cast<size_t>(i)].tools[0].in_view = 0;
    }

    std::mt19937 random_;
};

}  // namespace placode::test
