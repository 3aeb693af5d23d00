// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/shell_pages.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <algorithm>
#include <random>

namespace placode::bench {
namespace {

constexpr int kPatienceMs = 600000;

std::string random_password() {
    std::random_device random;
    std::string text;
    for (int i = 0; i < 24; ++i) text += static_cast<char>('a' + random() % 26);
    return text;
}

void measure_as(const std::string& login, const std::string& password, const QString& program,
                const std::string& store_url, ShellPages& out) {
    QProcess shell;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("PLACODE_PASSWORD", QString::fromStdString(password));
    environment.insert("QT_QPA_PLATFORM", "offscreen");
    shell.setProcessEnvironment(environment);
    shell.setStandardErrorFile(QProcess::nullDevice());
    shell.start(program, {"--store", QString::fromStdString(store_url), "--time-pages",
                          QString::fromStdString(login)});
    if (!shell.waitForFinished(kPatienceMs) || shell.exitCode() != 0) {
        out.problem = "`placode --time-pages " + login + "` did not end as it should";
        shell.kill();
        return;
    }
    const QJsonObject said = QJsonDocument::fromJson(shell.readAllStandardOutput()).object();
    if (!said.contains("pages")) {
        out.problem = "`placode --time-pages` said nothing that can be read";
        return;
    }
    for (const QJsonValue& each : said["pages"].toArray())
        out.pages.push_back({login, each["page"].toString().toStdString(),
                             each["first_ms"].toDouble(), each["median_ms"].toDouble(),
                             each["worst_ms"].toDouble(), each["processor_ms"].toDouble(),
                             each["complete_ms"].toDouble()});
    out.peak_memory_mb = std::max(out.peak_memory_mb, said["peak_memory_mb"].toDouble());
}

}  // namespace

ShellPages time_shell_pages(const std::string& store_url, db::Store& store, int64_t trainee) {
    ShellPages out;
    const QString program = QCoreApplication::applicationDirPath() + "/placode";
    if (!QFileInfo(program).isExecutable()) {
        out.problem = program.toStdString() + " is not there";
        return out;
    }
    const std::string password = random_password(), everybody = "every-role";
    store.accounts().create({everybody, "Every Role", password, 15, true});
    measure_as(everybody, password, program, store_url, out);
    store.accounts().set_password(trainee, password);
    if (out.problem.empty())
        measure_as(store.accounts().find(trainee)->login, password, program, store_url, out);
    return out;
}

}  // namespace placode::bench
