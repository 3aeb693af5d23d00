// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/attempt_launcher.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTimer>
#include <cassert>
#include <csignal>

#include "db/recording_order.h"
#include "ui/shell/child_process.h"

namespace placode::ui {
namespace {

constexpr int kKeptErrorBytes = 4000;
constexpr const char* kAuthor = "PLACODE_AUTHOR";

}  // namespace

QString simulator_path(const LaunchOptions& options) {
    QString path = options.program;
    if (path.isEmpty()) path = qEnvironmentVariable("PLACODE_SIM");
    if (path.isEmpty()) path = QCoreApplication::applicationDirPath() + "/placode-sim";
    const QFileInfo info(path);
    return info.isFile() && info.isExecutable() ? path : QString();
}

std::string simulator_missing(const LaunchOptions& options) {
    const QString looked =
        options.program.isEmpty() ? qEnvironmentVariable("PLACODE_SIM") : options.program;
    return "placode-sim: not found at " +
           (looked.isEmpty() ? QCoreApplication::applicationDirPath() + "/placode-sim" : looked)
               .toStdString() +
           "; build or install it beside placode, or set PLACODE_SIM to its path";
}

QStringList simulator_arguments(const AttemptOrder& order, const LaunchOptions& options) {
    assert(!order.recording_file.isEmpty());
    using curriculum::AttemptMode;
    const QString device = options.hands.isEmpty() ? order.device : options.hands;
    QStringList arguments{"--task",   order.task,           "--device", device,
                          "--record", order.recording_file, "--status"};
    if (!order.text.isEmpty())
        arguments << "--order"
                  << QString::fromStdString(db::order_checksum(order.text.toStdString()));
    if (!order.controls.isEmpty()) arguments << "--controls" << order.controls;
    if (order.demonstration) arguments << "--demonstration";
    if (order.duration_s > 0) arguments << "--duration" << QString::number(order.duration_s);
    const AttemptMode mode = order.mode();
    if (mode == AttemptMode::kExam || order.seed > 0)
        arguments << "--seed" << QString::number(order.seed);
    // The simulator refuses it in an exam and in a study; nobody shall have asked for it.
    if (mode == AttemptMode::kPractice && order.stage > 0)
        arguments << "--stage" << QString::number(order.stage);
    if (mode == AttemptMode::kExam) arguments << "--exam";
    if (mode == AttemptMode::kStudy) {
        arguments << "--study"
                  << "--aids" << order.aids;
        if (order.min_s > 0) arguments << "--min-duration" << QString::number(order.min_s);
    }
    arguments << "--language" << options.language << options.more_arguments;
    return arguments;
}

QProcessEnvironment simulator_environment(const AttemptOrder& order) {
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.remove(kAuthor);
    // Whose name stands on a preset that is saved while tuning.
    if (curriculum::conduct_of(order.mode()).tuning && !order.user_name.isEmpty())
        environment.insert(kAuthor, order.user_name);
    return environment;
}

AttemptLauncher::AttemptLauncher(LaunchOptions options, QObject* parent)
    : QObject(parent), options_(std::move(options)) {
    connect(&process_, &QProcess::readyReadStandardOutput, this, &AttemptLauncher::readStatus);
    connect(&process_, &QProcess::readyReadStandardError, this, [this] {
        errors_ += process_.readAllStandardError();
        // From the beginning of a line: half a line says nothing.
        if (errors_.size() > kKeptErrorBytes) {
            errors_ = errors_.right(kKeptErrorBytes);
            errors_ = errors_.mid(errors_.indexOf('\n') + 1);
        }
    });
    connect(&process_, &QProcess::finished, this, &AttemptLauncher::onFinished);
    connect(&process_, &QProcess::started, this, &AttemptLauncher::started);
}

AttemptLauncher::~AttemptLauncher() {
    if (!running()) return;
    // The shell is closing: the recording is complete up to here and is offered at the next start.
    process_.disconnect(this);
    process_.terminate();
    if (!process_.waitForFinished(kPatienceMs)) process_.kill();
    process_.waitForFinished(1000);
}

bool AttemptLauncher::running() const { return process_.state() != QProcess::NotRunning; }

qint64 AttemptLauncher::processId() const { return process_.processId(); }

void AttemptLauncher::needReady() const {
    if (running())
        throw LaunchError(LaunchError::Kind::kBusy,
                          "another attempt is still running; stop it first");
    if (program().isEmpty())
        throw LaunchError(LaunchError::Kind::kMissing, simulator_missing(options_));
}

void AttemptLauncher::start(AttemptOrder order, const QString& folder) {
    needReady();
    const QString path = program();
    write_order(order, folder);
    order_ = order;
    status_ = {};
    errors_.clear();
    asked_ = false;
    process_.setProcessEnvironment(simulator_environment(order));
    process_.start(path, simulator_arguments(order, options_));
    if (!process_.waitForStarted(kPatienceMs)) {
        const QString reason = process_.errorString();
        remove_recording(order.recording_file);
        throw LaunchError(LaunchError::Kind::kFailed,
                          path.toStdString() + ": " + reason.toStdString() +
                              "; check that it is a program of this machine");
    }
}

void AttemptLauncher::finish() {
    if (!running()) return;
    asked_ = true;
    ::kill(static_cast<pid_t>(process_.processId()), SIGUSR1);
    killLater();
}

void AttemptLauncher::abort() {
    if (!running()) return;
    asked_ = true;
    process_.terminate();
    killLater();
}

void AttemptLauncher::killLater() {
    QTimer::singleShot(kPatienceMs, this, [this, id = process_.processId()] {
        if (running() && process_.processId() == id) process_.kill();
    });
}

void AttemptLauncher::readStatus() {
    bool changed = false;
    while (process_.canReadLine()) {
        const QJsonDocument line = QJsonDocument::fromJson(process_.readLine());
        if (!line.isObject() || !line.object().contains("t_s")) continue;
        const QJsonObject json = line.object();
        status_.time_s = json["t_s"].toDouble();
        status_.pictures_hz = json["pictures_hz"].toDouble();
        status_.too_slow = json["too_slow"].toBool();
        status_.cut_fraction = json["cut_fraction"].toDouble();
        status_.servo_p999_us = json["servo_p999_us"].toDouble();
        status_.dropped = json["dropped"].toInteger();
        status_.phase = json["phase"].toString();
        status_.warning = json["warning"].toString();
        changed = true;
    }
    if (changed) Q_EMIT statusChanged();
}

void AttemptLauncher::onFinished(int exit_code, QProcess::ExitStatus status) {
    readStatus();
    errors_ += process_.readAllStandardError();
    AttemptEnding ending;
    ending.order = order_;
    ending.crashed = status == QProcess::CrashExit;
    ending.exit_code = exit_code;
    ending.asked = asked_;
    ending.message = QString::fromUtf8(errors_.right(kKeptErrorBytes)).trimmed();
    Q_EMIT ended(ending);
}

}  // namespace placode::ui
