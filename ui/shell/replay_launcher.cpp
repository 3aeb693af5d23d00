// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/replay_launcher.h"

#include <QJsonDocument>
#include <QJsonObject>

#include "ui/shell/child_process.h"

namespace placode::ui {

ReplayLauncher::ReplayLauncher(LaunchOptions options, QObject* parent)
    : QObject(parent), options_(std::move(options)) {
    connect(&process_, &QProcess::readyReadStandardOutput, this, &ReplayLauncher::readStatus);
    connect(&process_, &QProcess::readyReadStandardError, this, [this] {
        errors_ += process_.readAllStandardError();
        errors_ = errors_.right(4000);
    });
    connect(&process_, &QProcess::finished, this, &ReplayLauncher::onFinished);
}

ReplayLauncher::~ReplayLauncher() {
    process_.disconnect(this);
    if (!running()) return;
    process_.terminate();
    if (!process_.waitForFinished(kPatienceMs)) process_.kill();
    process_.waitForFinished(1000);
}

void ReplayLauncher::start(const QString& recording_file, const QString& camera, double speed,
                           double from_s) {
    if (running())
        throw LaunchError(LaunchError::Kind::kBusy, "a replay is running; close it first");
    const QString path = simulator_path(options_);
    if (path.isEmpty()) throw LaunchError(LaunchError::Kind::kMissing, simulator_missing(options_));
    state_ = {};
    state_.camera = camera;
    state_.speed = speed;
    errors_.clear();
    QStringList arguments{"--device",   "play:" + recording_file, "--control", "--status",
                          "--language", options_.language,        "--camera",  camera,
                          "--speed",    QString::number(speed)};
    if (!place_.isNull())
        arguments << "--size" << QString("%1x%2").arg(place_.width()).arg(place_.height())
                  << "--position" << QString("%1,%2").arg(place_.x()).arg(place_.y());
    if (from_s > 0) arguments << "--from" << QString::number(from_s, 'f', 2);
    process_.start(path, arguments + options_.replay_arguments);
    if (!process_.waitForStarted(kPatienceMs))
        throw LaunchError(LaunchError::Kind::kFailed,
                          path.toStdString() + ": " + process_.errorString().toStdString() +
                              "; check that it is a program of this machine");
}

void ReplayLauncher::stop() { say("quit"); }

void ReplayLauncher::say(const QString& line) {
    if (running()) process_.write((line + "\n").toUtf8());
}

void ReplayLauncher::readStatus() {
    bool changed = false;
    while (process_.canReadLine()) {
        const QJsonObject json = QJsonDocument::fromJson(process_.readLine()).object();
        if (!json.contains("t_s")) continue;
        state_.time_s = json["t_s"].toDouble();
        changed = true;
        if (!json.contains("paused")) continue;
        state_.paused = json["paused"].toBool();
        state_.speed = json["speed"].toDouble(1);
        state_.pace = json["pace"].toDouble();
        state_.target_s = json["target_s"].toDouble(-1);
        state_.camera = json["camera"].toString("scope");
    }
    if (changed) Q_EMIT stateChanged();
}

void ReplayLauncher::onFinished(int exit_code, QProcess::ExitStatus status) {
    readStatus();
    errors_ += process_.readAllStandardError();
    const bool crashed = status != QProcess::NormalExit;
    if (!crashed && exit_code == 0) return Q_EMIT ended(std::nullopt);
    Q_EMIT ended(
        ProgramEnd{crashed, exit_code, true, {}, QString::fromUtf8(errors_.right(4000)).trimmed()});
}

}  // namespace placode::ui
