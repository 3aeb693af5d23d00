// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/attempt/prepare_stage.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>

#include "db/stage_cache.h"
#include "sim/step/snapshot.h"
#include "ui/attempt/attempt_overlay.h"
#include "ui/attempt/sessions.h"
#include "ui/attempt/user_settings.h"
#include "ui/view/fetoscope_view.h"
#include "ui/view/strings.h"

namespace placode::ui {
namespace {

using Clock = std::chrono::steady_clock;
// The picture is company, and the simulation is to be done soon.
constexpr auto kPictureEvery = std::chrono::milliseconds(125);
constexpr int kToldPercent = 10;

int percent(double share) { return static_cast<int>(std::lround(100 * share)); }

/// Says on standard error how far it is, every tenth of the way.
class ToldInWords {
 public:
    explicit ToldInWords(const curriculum::TaskStage& stage) : stage_(stage) {}
    bool operator()(double share) {
        if (stop_requested() || finish_requested()) return false;
        const int now = percent(share) / kToldPercent * kToldPercent;
        if (now == last_) return true;
        last_ = now;
        std::fprintf(stderr, "placode-sim: %s\n",
                     preparing_text(stage_, now / 100.0, "en").c_str());
        return true;
    }

 private:
    const curriculum::TaskStage& stage_;
    int last_ = -1;
};

/// The expert at work, as fast as it goes.
class ShownInWindow {
 public:
    ShownInWindow(const curriculum::Task& task, const curriculum::TaskStage& stage,
                  const Arguments& arguments)
        : stage_(stage), arguments_(arguments), overlay_(attempt_overlay(task, arguments)) {
        // Nobody has anything to do yet: neither steps nor keys, but one.
        overlay_.practice.steps.clear();
        overlay_.heading = "Preparing";
        overlay_.keys = "Esc stops";
        overlay_.warnings = false;
        if (const auto last = load_window_size(); last && !arguments.size_given) {
            arguments_.width = last->width;
            arguments_.height = last->height;
        }
    }

    bool operator()(double share, const sim::Scene& scene, const sim::State& state) {
        if (stop_requested() || finish_requested()) return false;
        if (Clock::now() - last_ < kPictureEvery) return true;
        if (!view_)
            view_.emplace(view::view_field(scene, arguments_.seed),
                          view_settings(arguments_, overlay_.title));
        view_->poll(totals_);
        if (wants_out()) return false;
        sim::fill_snapshot(scene, state, snapshot_);
        overlay_.notice = preparing_text(stage_, share, arguments_.language);
        view_->draw(snapshot_, overlay_);
        last_ = Clock::now();
        return true;
    }

 private:
    [[nodiscard]] bool wants_out() {
        const view::WindowEvents events = view_->events();
        using Kind = view::WindowEvent::Kind;
        return std::any_of(events.begin(), events.end(), [](const view::WindowEvent& event) {
            return event.kind == Kind::kClose ||
                   (event.kind == Kind::kKey && event.down && event.key == sim::Key::kEscape);
        });
    }

    const curriculum::TaskStage& stage_;
    Arguments arguments_;
    view::OverlayState overlay_;
    std::optional<view::FetoscopeView> view_;
    sim::Snapshot snapshot_;
    sim::WindowInput totals_;
    Clock::time_point last_{};
};

}  // namespace

std::string preparing_text(const curriculum::TaskStage& stage, double share,
                           const std::string& language) {
    std::string text = view::translated("Preparing stage: %1, %2 %", language);
    const auto put = [&text](const char* place, const std::string& value) {
        if (const size_t at = text.find(place); at != std::string::npos) text.replace(at, 2, value);
    };
    put("%2", std::to_string(percent(share)));
    put("%1", stage.title.in(language));
    return text;
}

std::shared_ptr<const curriculum::StageStart> prepare_stage(const curriculum::Task& task,
                                                            const Arguments& arguments) {
    const curriculum::TaskStage& stage = curriculum::stage_of(task, arguments.stage);
    const db::StageCache cache;
    if (auto kept = cache.find(task.json, arguments.seed, arguments.stage)) return kept;
    std::shared_ptr<const curriculum::StageStart> made;
    if (arguments.headless) {
        ToldInWords told(stage);
        made = curriculum::make_stage_start(
            task, arguments.seed, arguments.stage, arguments.threads,
            [&told](double share, const auto&, const auto&) { return told(share); });
    } else {
        ShownInWindow shown(task, stage, arguments);
        made = curriculum::make_stage_start(
            task, arguments.seed, arguments.stage, arguments.threads,
            [&shown](double share, const sim::Scene& scene, const sim::State& state) {
                return shown(share, scene, state);
            });
    }
    if (made) cache.keep(task.json, arguments.seed, *made);
    return made;
}

}  // namespace placode::ui
