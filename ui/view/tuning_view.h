// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The clinician's tuning panel as a picture: rows with a value and two buttons each, and rows that
// are buttons. What the rows mean is the program's business.

#include <string>
#include <vector>

#include "ui/view/text.h"

namespace placode::view {

struct TuningRow {
    std::string label, value;  ///< In the user's language.
    bool button = false;       ///< The whole row is one.
    bool changed = false;      ///< Differs from what the scene says.
    bool gap_above = false;
};

struct TuningOverlay {
    bool shown = false;
    std::string title;
    std::string note;  ///< What a change means; stands above the rows.
    std::vector<TuningRow> rows;
    int selected = 0;
    std::string foot;   ///< How to use it, or what just happened.
    bool warn = false;  ///< The foot is a problem.
};

/// Parts of a row that can be clicked: item = kTuningParts * row + part.
enum TuningPart : int { kTuningWhole = 0, kTuningLess = 1, kTuningMore = 2, kTuningParts = 3 };

class TuningView {
 public:
    void draw(TextPainter& paint, const TuningOverlay& panel, double width, double height,
              double unit);
    /// Item under a pointer [px], -1 = none.
    [[nodiscard]] int item_at(double x, double y) const;
    void hide() { hits_.clear(); }

 private:
    struct Hit {
        double x = 0, y = 0, w = 0, h = 0;
        int item = -1;
    };
    void draw_row(TextPainter& paint, const TuningRow& r, const Hit& place, bool selected,
                  double unit);

    std::vector<Hit> hits_;  // the smaller ones later
};

}  // namespace placode::view
