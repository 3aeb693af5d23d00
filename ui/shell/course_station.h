// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The piece of a course's path beside one stage.

#include <QWidget>

#include "curriculum/course.h"
#include "ui/shell/theme.h"

namespace placode::ui {

/// A numbered station with lines to its neighbours.
class CourseStation : public QWidget {
 public:
    /// `colors` must outlive it.
    CourseStation(const Tokens& colors, int number, curriculum::StageStatus status, bool first,
                  bool last, bool next);

 protected:
    void paintEvent(QPaintEvent* event) override;

 private:
    const Tokens& colors_;
    int number_;
    curriculum::StageStatus status_;
    bool first_, last_, next_;
};

}  // namespace placode::ui
