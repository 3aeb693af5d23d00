// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Looks for devices and tries one, through placode-sim: a driver that crashes or waits for ever
// does so in a process of its own.

#include <QObject>
#include <QProcess>
#include <QStringList>
#include <array>
#include <functional>
#include <vector>

#include "ui/shell/attempt_launcher.h"

namespace placode::ui {

class AppContext;

/// A line of `placode-sim --list-devices`.
struct ListedDevice {
    QString name, detail;
    bool available = false;
    QStringList found;
};

/// What is there. Main thread.
class DeviceLister : public QObject {
    Q_OBJECT
 public:
    explicit DeviceLister(LaunchOptions options, QObject* parent = nullptr);
    ~DeviceLister() override;
    /// Throws LaunchError. Asks again when it is asked already.
    void start();
    /// Takes over what was listed before, e.g. by the page that this one replaces.
    void take(const QByteArray& text);
    [[nodiscard]] const QByteArray& text() const { return text_; }
    [[nodiscard]] const std::vector<ListedDevice>& devices() const { return devices_; }
    [[nodiscard]] const QStringList& pedals() const { return pedals_; }

 Q_SIGNALS:
    /// @param problem empty: `devices` and `pedals` are new.
    void listed(const QString& problem);

 private:
    void onFinished(int exit_code, QProcess::ExitStatus status);

    LaunchOptions options_;
    QProcess process_;
    QByteArray text_;
    std::vector<ListedDevice> devices_;
    QStringList pedals_;
};

/// Calls `add` now for what a window needs only, and later, while `receiver` lives, for all other
/// devices that placode-sim finds here. Main thread.
void each_device(AppContext& context, QObject* receiver,
                 const std::function<void(const ListedDevice&)>& add);

/// One arm of a device that is being tried.
struct TriedArm {
    QString name, serial, hand, status;
    bool force_device = false;
    std::array<double, 3> position_mm{}, force_n{};
    double roll_deg = 0, jaw_deg = 0, height_mm = 0, heat = 0;
    unsigned buttons = 0, pedals = 0;
};

/// The newest line of placode-sim --test-device.
struct TrialState {
    std::vector<TriedArm> arms;
    bool floor = false, identity_asked = false, real_time = false;
    int identity_arm = -1;
    double limit_n = 0, stiffness_n_m = 0, period_p50_us = 0, period_p999_us = 0;
    qint64 gaps = 0, faults = 0;
    QString last_error;  ///< Of the device or its library; in English.
    // Foot pedals.
    bool connected = false, pressed = false;
    int key = 0;
};

/// Main thread.
class DeviceTester : public QObject {
    Q_OBJECT
 public:
    explicit DeviceTester(LaunchOptions options, QObject* parent = nullptr);
    ~DeviceTester() override;

    /// `device`: a name, or "pedals:/dev/input/...". Throws LaunchError. Ends what ran before.
    void start(const QString& device, double force_n);
    /// Force down by a ramp, device released. Waits for it.
    void stop();
    void say(const QString& line);
    [[nodiscard]] bool running() const { return process_.state() != QProcess::NotRunning; }
    [[nodiscard]] const TrialState& state() const { return state_; }

 Q_SIGNALS:
    void stateChanged();
    /// @param message why, when nobody asked for it.
    void ended(const QString& message);

 private:
    void readStatus();
    void onFinished(int exit_code, QProcess::ExitStatus status);

    LaunchOptions options_;
    QProcess process_;
    TrialState state_;
    QByteArray errors_;
};

}  // namespace placode::ui
