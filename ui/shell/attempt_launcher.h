// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Starts placode-sim for one attempt, follows its status lines and tells how it ended. The
// simulator is a process of its own: it may crash, the shell goes on.

#include <QObject>
#include <QProcess>
#include <QProcessEnvironment>
#include <QString>
#include <QStringList>
#include <stdexcept>

#include "ui/shell/attempt_order.h"

namespace placode::ui {

/// placode-sim cannot be started. Names the program and the way out.
class LaunchError : public std::runtime_error {
 public:
    enum class Kind : uint8_t { kBusy, kMissing, kFailed };
    LaunchError(Kind kind, const std::string& message) : std::runtime_error(message), kind_(kind) {}
    [[nodiscard]] Kind kind() const noexcept { return kind_; }

 private:
    Kind kind_;
};

/// How the simulator is found and called.
struct LaunchOptions {
    QString program;             ///< Empty: $PLACODE_SIM, else beside this program.
    QStringList more_arguments;  ///< E.g. --headless --fast.
    QString language = "en";
    QStringList replay_arguments;  ///< For a replay, e.g. --headless.
    QString hands;  ///< Tests: who operates in place of the chosen device, e.g. script:expert.
};

/// Path of the simulator, or empty when it is not there.
[[nodiscard]] QString simulator_path(const LaunchOptions& options);
/// What to say then: where it was looked for, and the way out.
[[nodiscard]] std::string simulator_missing(const LaunchOptions& options);

/// Everything behind the program's name, and nobody's: every log-in of the computer can read it
/// (ps). @pre order.recording_file is set.
[[nodiscard]] QStringList simulator_arguments(const AttemptOrder& order,
                                              const LaunchOptions& options);
/// This program's, with the name of who tunes.
[[nodiscard]] QProcessEnvironment simulator_environment(const AttemptOrder& order);

/// The newest status line of the running attempt.
struct LiveStatus {
    double time_s = 0, cut_fraction = 0, servo_p999_us = 0;
    double pictures_hz = 0;  ///< Reached in nine of ten seconds; 0 = not known yet.
    bool too_slow = false;   ///< As it is now, the attempt will not count.
    qint64 dropped = 0;
    QString phase, warning;
};

/// How an attempt's process ended.
struct AttemptEnding {
    AttemptOrder order;
    bool crashed = false;  ///< Killed by a signal.
    bool asked = false;    ///< The user pressed Stop or Abort.
    int exit_code = 0;
    QString message;  ///< Last lines of its error output.
};

/// Main thread.
class AttemptLauncher : public QObject {
    Q_OBJECT
 public:
    explicit AttemptLauncher(LaunchOptions options, QObject* parent = nullptr);
    ~AttemptLauncher() override;

    /// Writes the order into `folder` and starts the simulator. One attempt at a time.
    /// Throws LaunchError or db::StoreError.
    void start(AttemptOrder order, const QString& folder);
    void finish();  ///< Stop and score: the simulator ends by itself and closes the recording.
    void abort();   ///< Ends at once; the recording ends as interrupted.
    void setLanguage(const QString& language) { options_.language = language; }

    [[nodiscard]] bool running() const;
    /// Throws LaunchError where no attempt can be started: one runs, or there is no simulator.
    void needReady() const;
    [[nodiscard]] qint64 processId() const;
    [[nodiscard]] const AttemptOrder& order() const { return order_; }
    [[nodiscard]] const LiveStatus& status() const { return status_; }
    /// Path of the simulator, or empty when it is not there.
    [[nodiscard]] QString program() const { return simulator_path(options_); }
    [[nodiscard]] const LaunchOptions& options() const { return options_; }

 Q_SIGNALS:
    void started();
    void statusChanged();
    void ended(const placode::ui::AttemptEnding& ending);

 private:
    void readStatus();
    void killLater();  ///< A simulator that does not end by itself; its recording stays readable.
    void onFinished(int exit_code, QProcess::ExitStatus status);

    LaunchOptions options_;
    QProcess process_;
    AttemptOrder order_;
    LiveStatus status_;
    QByteArray errors_;
    bool asked_ = false;
};

}  // namespace placode::ui
