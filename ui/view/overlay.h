// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What stands around the picture: time, phase, goal, energy, force, ring, one warning; help,
// performance and the pause menu over it.

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "haptics/control_layout.h"
#include "haptics/hint_device.h"
#include "sim/core/practice.h"
#include "sim/step/snapshot.h"
#include "ui/view/camera.h"
#include "ui/view/depth_cue.h"
#include "ui/view/label_rows.h"
#include "ui/view/post_process.h"
#include "ui/view/step_watch.h"
#include "ui/view/text.h"
#include "ui/view/tuning_view.h"

namespace placode::view {

/// "needle": English, translated by whoever writes it.
[[nodiscard]] const char* tool_word(sim::ToolKind kind);

/// Steps of a practice task, in the user's language: what to do, and how with the device at hand.
struct PracticeOverlay {
    struct Step {
        std::string text, hint;
        bool changes_hand = false;  ///< The step before was for the other hand.
    };
    std::vector<Step> steps;  ///< Empty = the task has none.
    /// Whose keys and buttons the hints show.
    haptics::HintDevice device = haptics::HintDevice::kNone;
    sim::PracticeGoal goal;  ///< Where it stands.
    int in_hand = -1;        ///< The tool that the window's one hand moves; -1 = not known.
};

/// The pause menu, or a question. Texts are already in the user's language.
struct MenuOverlay {
    bool shown = false;
    std::string title;
    std::vector<std::string> lines;  ///< What should be known before an item is chosen.
    std::vector<std::string> items;
    int selected = 0;
};

/// What the program wants said. Texts are already in the user's language unless noted.
struct OverlayState {
    std::string language = "en";
    std::string title, goal;
    std::vector<std::pair<std::string, std::string>>
        help;             ///< Control, what it does (English keys).
    std::string heading;  ///< Above the title: "Replay: exam" (English); empty = the phase.
    /// At the foot: the keys that matter now (English).
    std::string keys = "F1 help   Esc pause   hold Enter: finish";
    std::string banner;       ///< "DEMONSTRATION", "TUNED, not scored" (English).
    std::string notice;       ///< Short-lived note (English).
    bool help_waits = false;  ///< The help stands until somebody presses something.
    double time_limit_s = 0;  ///< 0 = none.
    bool remaining = false;   ///< Show what is left of it, in every mode.
    bool depth_aid = true;    ///< Shadow below the instruments and the gauge beside the tips.
    bool motion = true;       ///< Hints move; false where the desktop asks for stillness.
    double cut_power_w = 0, coag_power_w = 0;
    double full_force_n = 0.4;  ///< Right end of the force bar.
    bool exam = false;          ///< Time only.
    bool warnings = true;       ///< Short phrases at the rim.
    bool show_help = false, show_performance = false, show_guide = false;
    bool waiting = false;  ///< The clock starts with the first motion.
    MenuOverlay menu;
    double holding = 0;  ///< How far Enter has been held, 0..1.
    PracticeOverlay practice;
    haptics::ControlLayout layout;  ///< Keys that help and hints name.
    TuningOverlay tuning;
};
inline constexpr double kGaugeMm = 5;  ///< Height that the gauge beside a tip shows [mm].

/// Times of the drawing itself, for the performance read-out.
struct FrameTimes {
    double mean_ms = 0, p99_ms = 0;
    double render_scale = 1;
    int samples = 0;
    bool plain = false;
    std::string renderer;
};

/// What the view knows about the instruments, and the watcher's clock.
struct TipScene {
    const std::vector<sim::ToolSpec>* tools = nullptr;
    std::array<TipFoot, sim::kMaxTools> feet;
    double clock_s = 0;
};

class Overlay {
 public:
    void draw(TextPainter& painter, const sim::Snapshot& snapshot, const OverlayState& state,
              const Circle& circle, const Camera& camera, const TipScene& tips,
              const FrameTimes& times, int width, int height);
    /// Menu item under a pointer [px], -1 = none.
    [[nodiscard]] int menu_item_at(double x, double y) const;
    /// Item of the tuning panel there, -1 = none.
    [[nodiscard]] int tuning_item_at(double x, double y) const { return tuning_.item_at(x, y); }

 private:
    // overlay_words.cpp: clock, phase, goal, keys, banner, note.
    void read_outs();
    /// Each writes from `y` on, beside the circle where there is `room` [px]; returns its foot.
    double task_words(double y, double room);
    [[nodiscard]] std::vector<std::string> key_lines() const;
    void keys();
    double banner(double y, double room);
    void notice(double room);
    // overlay.cpp
    void energy();
    // overlay_meters.cpp: a bar of force per hand, what the machine does.
    void force();
    void force_bar(int tool, double y, bool named);
    [[nodiscard]] std::array<int, sim::kMaxTools> force_tools(int& count) const;
    void ring();
    /// A ring whose parts light up where they are done, with the share [0..1] in its middle.
    void gauge(double share, const char* name, std::span<const uint8_t> done);
    // overlay_practice.cpp: the list of steps.
    [[nodiscard]] double practice_steps(double y, double room);
    [[nodiscard]] double present_step(double y, double room);
    [[nodiscard]] double step_height(int step, double room);
    [[nodiscard]] std::pair<int, int> listed_steps(double y, double room);
    void practice_line();
    void tick(double x, double y);
    [[nodiscard]] std::string amount_text() const;
    // overlay_goal.cpp, overlay_targets.cpp: what the present step is about, in the picture.
    void goals();
    void anchor_watch(int tool);
    void targets();
    void suture_line();
    void patch_margin();
    void patch_goal();
    void exam_targets();
    double exam_steps(double y, double room);
    void target_text(int tool, const sim::Vec2& px, double radius, const sim::Vec3& away_mm,
                     bool above);
    void take_mark(int tool);
    void end_marks(int tool);
    void scope_marks();
    void shaft_scale(int tool, double low_mm, double high_mm, double now_mm, int next);
    void turn_arc(int tool);
    [[nodiscard]] int tool_of(sim::Hand hand) const;  ///< -1 = none.
    /// Another instrument than the step's is in hand: nothing that the hint says would help.
    [[nodiscard]] bool wrong_hand() const;
    /// How to do the present step; first of all how to get its instrument back.
    [[nodiscard]] std::string hint_text() const;
    [[nodiscard]] int goal_tool() const { return tool_of(state_->practice.goal.step.hand); }
    // overlay_depth.cpp: gauge beside the tips, what is below the surface.
    void depth();
    [[nodiscard]] sim::Vec2 gauge_foot(int tool, const sim::Vec2& tip_px);
    void height(int tool, double gap_mm);
    void depth_gauge(int tool, double gap_mm);
    void buried(int tool);
    [[nodiscard]] double gap_mm(int tool) const;
    [[nodiscard]] sim::Vec2 beside(int tool, const sim::Vec2& tip_px) const;
    void label(const sim::Vec2& at, const std::string& text, const Colour& colour,
               Align align = Align::kCentre);
    // overlay_hint.cpp: the very key or button, when nothing comes of a step.
    void hint();
    /// A translated text with the keys that the person has chosen.
    [[nodiscard]] std::string with_keys(std::string_view text) const;
    /// %1 and %2 of a translated pattern replaced.
    [[nodiscard]] std::string phrase(std::string_view english, const std::string& first,
                                     const std::string& second = {}) const;
    void warning();
    void help();
    void performance();
    void menu();
    void hold_ring();  ///< Fills while Enter is held.
    void waiting();
    /// Where a point of W [mm] stands in the window [px]; false behind the lens or off the picture.
    [[nodiscard]] bool place_of(const sim::Vec3& mm, sim::Vec2& px) const;
    [[nodiscard]] bool practising() const;
    [[nodiscard]] bool energised_tools() const;  ///< One of the instruments can carry current.
    [[nodiscard]] std::string say(std::string_view english) const;

    // Of the picture being drawn.
    TextPainter* paint_ = nullptr;
    const sim::Snapshot* snapshot_ = nullptr;
    const OverlayState* state_ = nullptr;
    const Camera* camera_ = nullptr;
    const TipScene* tips_ = nullptr;
    const FrameTimes* times_ = nullptr;
    StepWatch watch_;
    Circle circle_;
    double width_ = 0, height_ = 0, unit_ = 16, margin_ = 16, column_ = 150;
    double foot_top_ = 0;           // of what stands at the foot of a narrow window
    double text_foot_ = 0;          // of what is written at the left, from the top
    double bars_top_ = 0;           // of the bars of force, from the bottom
    std::vector<LabelBox> labels_;  // labels, rings and gauges so far: no two lie over each other
    LabelBox hint_box_;             // of the last picture; empty without a hint
    double menu_x_ = 0, menu_y_ = 0, menu_width_ = 0, menu_row_ = 0;
    bool menu_shown_ = false;
    int menu_count_ = 0;
    TuningView tuning_;
};

/// "3:07".
[[nodiscard]] std::string clock_text(double seconds);

}  // namespace placode::view
