// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The clinician's tuning panel (F2): tissue and generator changed in the middle of an attempt, and
// saved as a preset with who and when. While it is open the attempt stands still and every key is
// its own; F2 or Esc closes it and gives everything back to the instruments. Main thread.

#include <array>
#include <functional>
#include <string>

#include "curriculum/preset.h"
#include "haptics/window_input.h"
#include "ui/view/overlay.h"

namespace placode::ui {

struct TuningSetup {
    std::string language = "en";
    std::string author;     ///< Who tunes; stands in a saved preset.
    bool allowed = true;    ///< False in an exam.
    std::string saved_utc;  ///< Clock for saving; empty = now.
    /// Carries a change to the attempt.
    std::function<void(sim::TuneParameter, sim::Tissue, double)> tune;
};

class TuningPanel {
 public:
    TuningPanel(const curriculum::Task& task, TuningSetup setup);

    void toggle();  ///< F2: opens and closes.
    /// Pointer and keys belong to the panel; the hands stand still.
    [[nodiscard]] bool shown() const { return shown_; }
    /// Letters go into the name of a preset.
    [[nodiscard]] bool typing() const { return typing_; }
    /// A key while the panel is shown. True when it was for the panel.
    [[nodiscard]] bool key(sim::Key key);
    void click(int item);  ///< Of TuningView; -1 does nothing.
    void type(const std::string& text);
    [[nodiscard]] bool tuned() const { return tuned_; }
    [[nodiscard]] double power_w(sim::TuneParameter parameter) const;
    /// What the overlay shows.
    [[nodiscard]] const view::TuningOverlay& picture();

 private:
    void change(int row, int direction);
    void press(int row);
    void set(sim::TuneParameter parameter, sim::Tissue tissue, double value);
    void reset();
    void save();
    [[nodiscard]] double value(sim::TuneParameter parameter, sim::Tissue tissue) const;
    [[nodiscard]] double published(sim::TuneParameter parameter, sim::Tissue tissue) const;
    [[nodiscard]] std::string say(const char* english) const;

    using Values = std::array<std::array<double, sim::kTissueCount>, sim::kTuneParameters>;
    TuningSetup setup_;
    std::string scene_id_;
    Values now_{}, before_{};
    sim::Tissue tissue_ = sim::Tissue::kZone;
    int selected_ = 0;
    bool shown_ = false, typing_ = false, tuned_ = false, warn_ = false;
    std::string name_, said_;
    view::TuningOverlay picture_;
};

/// "25.0 kPa", "0.08", "12 W": as the panel writes values.
[[nodiscard]] std::string tuning_text(sim::TuneParameter parameter, double value);

}  // namespace placode::ui
