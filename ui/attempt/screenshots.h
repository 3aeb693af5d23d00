// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Numbered pictures of an attempt at regular simulated times.

#include <string>

#include "ui/attempt/arguments.h"
#include "ui/view/fetoscope_view.h"

namespace placode::ui {

class Screenshots {
 public:
    /// Makes the folder. Throws UsageError when it cannot.
    explicit Screenshots(const Arguments& arguments);
    [[nodiscard]] bool wanted() const { return !folder_.empty(); }
    /// True when a picture is due at `time_s`.
    [[nodiscard]] bool due(double time_s) const { return wanted() && time_s >= next_s_; }
    /// Saves what `view` drew last. Throws ViewError.
    void save(view::FetoscopeView& view, double time_s);
    /// Saves on demand (F12), in the folder or among the user's pictures; returns the path.
    std::string save_extra(view::FetoscopeView& view, double time_s);
    [[nodiscard]] int saved() const { return saved_; }
    [[nodiscard]] const std::string& folder() const { return folder_; }

 private:
    std::string folder_;
    double every_s_ = 5, next_s_ = 0;
    int saved_ = 0;
};

}  // namespace placode::ui
