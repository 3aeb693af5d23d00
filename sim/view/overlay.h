// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What stands around the picture: time, phase, goal, energy, force, ring, one warning; help,
// performance and the pause menu over it.

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "sim/practice.h"
#include "sim/snapshot.h"
#include "sim/view/camera.h"
#include "sim/view/post_process.h"
#include "sim/view/text.h"
#include "sim/view/tuning_view.h"

namespace placode::sim {

/// Steps of a practice task, in the user's language: what to do, and how with the device at hand.
struct PracticeOverlay {
    struct Step {
        std::string text, hint;
    };
    std::vector<Step> steps;  ///< Empty = the task has none.
    PracticeGoal goal;        ///< Where it stands.
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
        help;                 ///< Control, what it does (English keys).
    std::string banner;       ///< "DEMONSTRATION", "REPLAY" (English).
    std::string notice;       ///< Short-lived note (English).
    bool help_waits = false;  ///< The help stands until somebody presses something.
    double time_limit_s = 0;
    double cut_power_w = 0, coag_power_w = 0;
    double full_force_n = 0.4;  ///< Right end of the force bar.
    bool exam = false;          ///< Time only.
    bool warnings = true;       ///< Short phrases at the rim.
    bool show_help = false, show_performance = false, show_guide = false;
    bool waiting = false;  ///< The clock starts with the first motion.
    MenuOverlay menu;
    double holding = 0;  ///< How far Enter has been held, 0..1.
    PracticeOverlay practice;
    TuningOverlay tuning;
};

/// Times of the drawing itself, for the performance read-out.
struct FrameTimes {
    double mean_ms = 0, p99_ms = 0;
    double render_scale = 1;
    int samples = 0;
    std::string renderer;
};

class Overlay {
 public:
    void draw(TextPainter& painter, const Snapshot& snapshot, const OverlayState& state,
              const Circle& circle, const Camera& camera, const FrameTimes& times, int width,
              int height);
    /// Menu item under a pointer [px], -1 = none.
    [[nodiscard]] int menu_item_at(double x, double y) const;
    /// Item of the tuning panel there, -1 = none.
    [[nodiscard]] int tuning_item_at(double x, double y) const { return tuning_.item_at(x, y); }

 private:
    void read_outs();
    void energy();
    void force();
    void ring();
    /// A ring whose parts light up where they are done, with the share [0..1] in its middle.
    void gauge(double share, const char* name, std::span<const uint8_t> done);
    [[nodiscard]] double practice_steps(double y, double room);
    void practice_line();
    void tick(double x, double y);
    void targets();
    void warning();
    void help();
    void performance();
    void menu();
    void hold_ring();  ///< Fills while Enter is held.
    void waiting();
    /// Where a point of W [mm] stands in the window [px]; false behind the lens or off the picture.
    [[nodiscard]] bool place_of(const Vec3& mm, Vec2& px) const;
    [[nodiscard]] bool practising() const;
    [[nodiscard]] bool energised_tools() const;  ///< One of the instruments can carry current.
    [[nodiscard]] std::string say(std::string_view english) const;

    // Of the picture being drawn.
    TextPainter* paint_ = nullptr;
    const Snapshot* snapshot_ = nullptr;
    const OverlayState* state_ = nullptr;
    const Camera* camera_ = nullptr;
    const FrameTimes* times_ = nullptr;
    Circle circle_;
    double width_ = 0, height_ = 0, unit_ = 16, margin_ = 16, column_ = 150;
    double menu_x_ = 0, menu_y_ = 0, menu_width_ = 0, menu_row_ = 0;
    bool menu_shown_ = false;
    int menu_count_ = 0;
    TuningView tuning_;
};

/// "3:07".
[[nodiscard]] std::string clock_text(double seconds);

}  // namespace placode::sim
