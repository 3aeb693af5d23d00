// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Steers a replay in placode-sim's window: starts it on a recording, tells it camera, speed, moment
// and pause, follows its status.

#include <QObject>
#include <QProcess>
#include <QRect>

#include <optional>

#include "ui/shell/attempt_launcher.h"
#include "ui/shell/messages.h"

namespace placode::ui {

/// The newest status line of the replay.
struct ReplayState {
    double time_s = 0;
    double speed = 1, pace = 0;
    double target_s = -1;  ///< Being simulated up to, without pictures.
    bool paused = false;
    QString camera = "scope";
};

/// Main thread.
class ReplayLauncher : public QObject {
    Q_OBJECT
 public:
    explicit ReplayLauncher(LaunchOptions options, QObject* parent = nullptr);
    ~ReplayLauncher() override;

    /// Where its next window goes on the desktop; null: wherever the desktop wants.
    void setPlace(const QRect& place) { place_ = place; }
    /// Throws LaunchError.
    void start(const QString& recording_file, const QString& camera, double speed, double from_s);
    void stop();
    [[nodiscard]] bool running() const { return process_.state() != QProcess::NotRunning; }
    [[nodiscard]] const ReplayState& state() const { return state_; }

    void setCamera(const QString& camera) { say("camera " + camera); }
    void setSpeed(double speed) { say("speed " + QString::number(speed)); }
    void setPaused(bool paused) { say(paused ? "pause" : "play"); }
    void seek(double time_s) { say("seek " + QString::number(time_s, 'f', 2)); }

 Q_SIGNALS:
    void stateChanged();
    /// @param end how, when it did not end by itself or by request.
    void ended(const std::optional<placode::ui::ProgramEnd>& end);

 private:
    void say(const QString& line);
    void readStatus();
    void onFinished(int exit_code, QProcess::ExitStatus status);

    LaunchOptions options_;
    QProcess process_;
    ReplayState state_;
    QByteArray errors_;
    QRect place_;
};

}  // namespace placode::ui
