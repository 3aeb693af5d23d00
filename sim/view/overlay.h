// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What stands around the picture: time, phase, goal, energy, force, ring, one warning; help,
// performance and the pause menu over it.

#include <string>
#include <utility>
#include <vector>

#include "sim/snapshot.h"
#include "sim/view/camera.h"
#include "sim/view/post_process.h"
#include "sim/view/text.h"

namespace placode::sim {

/// What the program wants said. Texts are already in the user's language unless noted.
struct OverlayState {
    std::string language = "en";
    std::string title, goal;
    std::vector<std::pair<std::string, std::string>>
        help;            ///< Control, what it does (English keys).
    std::string banner;  ///< "DEMONSTRATION", "REPLAY" (English).
    std::string notice;  ///< Short-lived note (English).
    double time_limit_s = 0;
    double cut_power_w = 0, coag_power_w = 0;
    double full_force_n = 0.4;  ///< Right end of the force bar.
    bool exam = false;          ///< Time only.
    bool show_help = false, show_performance = false, show_guide = false;
    bool menu = false;
    int menu_selected = 0;
};
inline constexpr int kMenuItems = 3;  ///< Continue, finish and score, leave.

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

 private:
    void read_outs();
    void energy();
    void force();
    void ring();
    void warning();
    void help();
    void performance();
    void menu();
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
};

/// "3:07".
[[nodiscard]] std::string clock_text(double seconds);

}  // namespace placode::sim
