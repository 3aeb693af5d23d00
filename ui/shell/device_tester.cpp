// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/device_tester.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <numbers>

#include "ui/shell/app_context.h"
#include "ui/shell/child_process.h"

namespace placode::ui {
namespace {

constexpr double kDegree = 180 / std::numbers::pi;

QString need_simulator(const LaunchOptions& options) {
    const QString path = simulator_path(options);
    if (path.isEmpty()) throw LaunchError(LaunchError::Kind::kMissing, simulator_missing(options));
    return path;
}

void end(QProcess& process) {
    process.disconnect();
    if (process.state() == QProcess::NotRunning) return;
    process.terminate();
    if (!process.waitForFinished(kPatienceMs)) process.kill();
    process.waitForFinished(1000);
}

std::array<double, 3> triple(const QJsonArray& json, double scale) {
    return {scale * json[0].toDouble(), scale * json[1].toDouble(), scale * json[2].toDouble()};
}

TriedArm arm_of(const QJsonObject& json) {
    TriedArm arm;
    arm.name =
        QStringList{json["vendor"].toString(), json["model"].toString(), json["serial"].toString()}
            .join(' ')
            .simplified();
    arm.serial = json["serial"].toString();
    arm.hand = json["hand"].toString();
    arm.status = json["status"].toString();
    arm.force_device = json["force_device"].toBool();
    arm.position_mm = triple(json["position_m"].toArray(), 1000);
    arm.force_n = triple(json["force_n"].toArray(), 1);
    arm.roll_deg = kDegree * json["roll_rad"].toDouble();
    arm.jaw_deg = kDegree * json["jaw_rad"].toDouble();
    arm.height_mm = 1000 * json["height_m"].toDouble();
    arm.heat = json["motor_heat"].toDouble();
    arm.buttons = static_cast<unsigned>(json["buttons"].toInt());
    arm.pedals = static_cast<unsigned>(json["pedals"].toInt());
    return arm;
}

}  // namespace

DeviceLister::DeviceLister(LaunchOptions options, QObject* parent)
    : QObject(parent), options_(std::move(options)) {
    connect(&process_, &QProcess::finished, this, &DeviceLister::onFinished);
}

DeviceLister::~DeviceLister() { end(process_); }

void DeviceLister::start() {
    if (process_.state() != QProcess::NotRunning) return;
    process_.start(need_simulator(options_), {"--list-devices", "--json"});
}

void DeviceLister::onFinished(int exit_code, QProcess::ExitStatus status) {
    const QByteArray text = process_.readAllStandardOutput();
    if (status != QProcess::NormalExit || exit_code != 0 || !text.contains("\"devices\"")) {
        const QString said = QString::fromUtf8(process_.readAllStandardError()).trimmed();
        Q_EMIT listed(said.isEmpty() ? process_.errorString() : said);
        return;
    }
    take(text);
}

void DeviceLister::take(const QByteArray& text) {
    text_ = text;
    const QJsonObject json = QJsonDocument::fromJson(text).object();
    devices_.clear();
    for (const QJsonValue& value : json["devices"].toArray()) {
        ListedDevice device;
        device.name = value["name"].toString();
        device.detail = value["detail"].toString();
        device.available = value["available"].toBool();
        for (const QJsonValue& found : value["found"].toArray()) device.found << found.toString();
        devices_.push_back(device);
    }
    pedals_.clear();
    for (const QJsonValue& path : json["pedals"].toArray()) pedals_ << path.toString();
    Q_EMIT listed({});
}

void each_device(AppContext& context, QObject* receiver,
                 const std::function<void(const ListedDevice&)>& add) {
    // As haptics/catalogue/open_device.cpp says them.
    add({"mouse", "tip in the picture's plane, wheel for depth; no force", true, {}});
    add({"keyboard", "fixed speeds; no force", true, {}});
    auto* lister = new DeviceLister(context.launcher().options(), receiver);
    QObject::connect(lister, &DeviceLister::listed, receiver, [lister, add](const QString&) {
        for (const ListedDevice& device : lister->devices())
            if (device.available && !device.found.isEmpty()) add(device);
        lister->deleteLater();
    });
    try {
        lister->start();
    } catch (const LaunchError&) {
        lister->deleteLater();  // whoever presses Start is told
    }
}

DeviceTester::DeviceTester(LaunchOptions options, QObject* parent)
    : QObject(parent), options_(std::move(options)) {
    connect(&process_, &QProcess::readyReadStandardOutput, this, &DeviceTester::readStatus);
    connect(&process_, &QProcess::readyReadStandardError, this,
            [this] { errors_ = (errors_ + process_.readAllStandardError()).right(4000); });
    connect(&process_, &QProcess::finished, this, &DeviceTester::onFinished);
}

DeviceTester::~DeviceTester() { end(process_); }

void DeviceTester::start(const QString& device, double force_n) {
    const QString path = need_simulator(options_);
    stop();
    state_ = {};
    errors_.clear();
    process_.start(path, {"--test-device", device, "--test-force", QString::number(force_n)});
    if (!process_.waitForStarted(kPatienceMs))
        throw LaunchError(LaunchError::Kind::kFailed,
                          path.toStdString() + ": " + process_.errorString().toStdString() +
                              "; check that it is a program of this machine");
}

void DeviceTester::stop() {
    if (!running()) return;
    say("quit");
    if (process_.waitForFinished(kPatienceMs)) return;
    process_.kill();
    process_.waitForFinished(1000);
}

void DeviceTester::say(const QString& line) {
    if (running()) process_.write((line + "\n").toUtf8());
}

void DeviceTester::readStatus() {
    bool changed = false;
    while (process_.canReadLine()) {
        const QJsonObject json = QJsonDocument::fromJson(process_.readLine()).object();
        if (!json.contains("t_s")) continue;
        changed = true;
        state_.arms.clear();
        for (const QJsonValue& arm : json["arms"].toArray())
            state_.arms.push_back(arm_of(arm.toObject()));
        state_.floor = json["floor"].toBool();
        state_.identity_asked = json["identity"]["asked"].toBool();
        state_.identity_arm = json["identity"]["arm"].toInt(-1);
        state_.limit_n = json["limit_n"].toDouble();
        state_.stiffness_n_m = json["stiffness_n_m"].toDouble();
        state_.period_p50_us = json["period_p50_us"].toDouble();
        state_.period_p999_us = json["period_p999_us"].toDouble();
        state_.gaps = json["gaps"].toInteger();
        state_.last_error = json["last_error"].toString();
        state_.faults = json["faults"].toInteger();
        state_.real_time = json["real_time"].toBool();
        state_.connected = json["connected"].toBool();
        state_.pressed = json["pressed"].toBool();
        state_.key = json["key"].toInt();
    }
    if (changed) Q_EMIT stateChanged();
}

void DeviceTester::onFinished(int exit_code, QProcess::ExitStatus status) {
    readStatus();
    errors_ += process_.readAllStandardError();
    const bool fine = status == QProcess::NormalExit && exit_code == 0;
    Q_EMIT ended(fine ? QString() : QString::fromUtf8(errors_.right(4000)).trimmed());
}

}  // namespace placode::ui
