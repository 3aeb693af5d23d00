// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The message catalogue: for every kind of trouble what happened and what to do, in words of the
// reader's language. The exact text of the part that failed goes along for whoever helps; the shell
// shows it behind "Details".

#include <QString>
#include <exception>

#include "db/store.h"

namespace placode::ui {

/// Something went wrong: the thing, the way out, and the exact words of the part that failed.
struct Problem {
    QString title;              ///< "The store is locked by another program."
    QString way_out;            ///< "Close it, or wait and try again."
    QString detail;             ///< For whoever helps, in English: paths, numbers, library names.
    bool open_details = false;  ///< Names a place in the user's own file: shown at once.
    QString doing = {};         ///< What failed; its next failure takes this one's place.

    [[nodiscard]] QString said() const { return (title + " " + way_out).trimmed(); }
};

/// What the shell refuses itself: the text is in the user's words already.
class Refusal : public db::StoreError {
 public:
    explicit Refusal(const QString& text)
        : db::StoreError(db::StoreError::Kind::kRefused, text.toStdString()) {}
};

/// Any exception of the floors below. `doing` names the operation: "Saving the attempt".
[[nodiscard]] Problem problem_of(const std::exception_ptr& error, const QString& doing);

/// What a driver or the simulator said about a device that cannot be used.
[[nodiscard]] Problem device_problem(const QString& device, const QString& said);

/// How placode-sim came to an end that nobody asked for.
struct ProgramEnd {
    bool crashed = false;  ///< By a signal.
    int exit_code = 0;
    bool began = true;  ///< A first moment was reached.
    QString device;     ///< Empty: a replay.
    QString said;       ///< Its error output.
};
[[nodiscard]] Problem simulator_problem(const ProgramEnd& end);

/// A recording that cannot be read.
[[nodiscard]] Problem recording_problem(const db::StoreError& error);
/// One that can be read in part; `damage` is the file's own complaint.
[[nodiscard]] Problem damaged_part(const QString& damage);

/// A line of the store's check.
[[nodiscard]] Problem health_problem(const QString& line);

}  // namespace placode::ui
