// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A task asked for as an exam of a course: the rules stand on the page, the store decides at Start.

#include <QCoreApplication>
#include <functional>
#include <optional>

#include "db/course_conduct.h"
#include "ui/shell/attempt_order.h"
#include "ui/shell/pages.h"

class QFrame;
class QLineEdit;

namespace placode::ui {

class TaskExam {
    Q_DECLARE_TR_FUNCTIONS(TaskPage)
 public:
    explicit TaskExam(AppContext& context) : context_(context) {}

    /// Which exam `place` asks for. Throws StoreError.
    void read(const Place& place);

    /// nullptr: practice.
    [[nodiscard]] const curriculum::CourseStage* stage() const {
        return stage_ ? &*stage_ : nullptr;
    }
    /// Its id; empty = practice.
    [[nodiscard]] const std::string& course() const { return course_; }

    /// Rules and, where one is asked for, the proctor; Enter there calls `submit`.
    /// @pre stage() is not null, here and below.
    [[nodiscard]] QFrame* makeCard(const std::function<void()>& submit);
    /// Puts the exam into the order. Throws kRefused.
    /// @param haptic the order's device pushes back.
    void prepare(AttemptOrder& order, bool haptic);

 private:
    /// Log-in of who is present and confirms with the own password. Throws kRefused.
    [[nodiscard]] std::optional<db::UserRecord> confirmedProctor();
    /// An exam that a crash left over is saved before the next one: it uses up an attempt.
    void refuseBesideLeftExam() const;

    AppContext& context_;
    std::string course_;
    db::CourseStanding standing_;
    std::optional<curriculum::CourseStage> stage_;
    int left_ = -1;  ///< Attempts; -1 = no limit.
    QLineEdit *proctor_ = nullptr, *proctor_password_ = nullptr;
};

}  // namespace placode::ui
