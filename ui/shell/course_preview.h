// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a trainee sees of a course on the first day, for who builds it.

#include <QCoreApplication>
#include <QWidget>

#include "curriculum/course.h"

class QVBoxLayout;

namespace placode::ui {

class AppContext;

class CoursePreview : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(CourseEditorPage)
 public:
    explicit CoursePreview(AppContext& context);
    void follow(const curriculum::Course& course);

 private:
    AppContext& context_;
    QVBoxLayout* rows_ = nullptr;
};

}  // namespace placode::ui
