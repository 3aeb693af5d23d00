// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/attempt_order.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRandomGenerator>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <array>
#include <cerrno>

#include "db/evidence.h"
#include "db/private_file.h"
#include "db/recording_file.h"
#include "db/recording_order.h"
#include "db/store_url.h"
#include "db/study_conduct.h"

namespace placode::ui {
namespace {

QString order_file(const QString& recording_file) {
    return QString::fromStdString(db::order_file(recording_file.toStdString()));
}

/// Without it the checksum in a recording that is passed on would tell who it is of: somebody could
/// try out the names.
QString fresh_nonce() {
    std::array<quint32, 4> words{};
    QRandomGenerator::system()->fillRange(words.data(), words.size());
    return QByteArray(reinterpret_cast<const char*>(words.data()), sizeof words).toHex();
}

bool matters(const AttemptOrder& order) {
    return order.mode() != curriculum::AttemptMode::kPractice;
}

/// An attempt of a study is a step of its participant.
void record_study_step(db::Store& store, const AttemptOrder& order, int64_t attempt_id) {
    if (order.study.isEmpty()) return;
    db::StepRecord step;
    step.study_id = order.study.toStdString();
    step.participant = order.participant.toStdString();
    step.visit = order.visit;
    step.step = order.step.toStdString();
    step.attempt_id = attempt_id;
    db::record_attempt_step(store, step);
}

/// One at a time saves a recording, in this program or in others: the store keeps the same
/// recording twice when it comes twice. The lock is on the order, which goes last, and ends with
/// the program.
class OnlySaver {
 public:
    explicit OnlySaver(const QString& recording_file)
        : file_(::open(QFile::encodeName(order_file(recording_file)).constData(),
                       O_RDONLY | O_CLOEXEC)) {
        while (file_ >= 0 && ::flock(file_, LOCK_EX) != 0 && errno == EINTR) continue;
    }
    ~OnlySaver() {
        if (file_ >= 0) ::close(file_);
    }
    OnlySaver(const OnlySaver&) = delete;
    OnlySaver& operator=(const OnlySaver&) = delete;

 private:
    int file_;
};

bool is_of(const db::AttemptOwner& owner, const AttemptOrder& order) {
    if (!order.study.isEmpty() || !owner.study.study.empty())
        return owner.study.study == order.study.toStdString() &&
               owner.study.participant == order.participant.toStdString();
    return owner.user_id == order.user_id;
}

}  // namespace

QString server_place(const std::string& store_url) {
    const db::StoreUrl url = db::parse_store_url(store_url);
    if (url.engine == db::Engine::kSqlite) return {};
    return QString("postgresql://%1:%2/%3")
        .arg(QString::fromStdString(url.host))
        .arg(url.port)
        .arg(QString::fromStdString(url.name));
}

QString recordings_folder(const std::string& store_url) {
    const QString url = QString::fromStdString(store_url);
    if (url.startsWith("sqlite:") && !url.contains(":memory:"))
        return QFileInfo(url.mid(7).section('?', 0, 0)).absolutePath() + "/recordings";
    return QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) +
           "/placode/recordings";
}

void write_order(AttemptOrder& order, const QString& folder) {
    using db::StoreError;
    if (!QDir().mkpath(folder)) {
        throw StoreError(StoreError::Kind::kUnavailable,
                         "create folder " + folder.toStdString() +
                             ": not allowed or disk full; choose another data folder");
    }
    const QString stamp = QDateTime::currentDateTimeUtc().toString("yyyyMMdd-HHmmss-zzz");
    order.recording_file =
        QString("%1/attempt-%2-%3.placode").arg(folder, stamp).arg(order.user_id);
    const QJsonObject json{
        {"user_id", static_cast<qint64>(order.user_id)},
        {"task", order.task},
        {"title", order.title},
        {"device", order.device},
        {"started_utc", order.started_utc},
        {"demonstration", order.demonstration},
        {"study", order.study},
        {"participant", order.participant},
        {"step", order.step},
        {"visit", order.visit},
        {"aids", order.aids},
        {"min_s", order.min_s},
        {"duration_s", order.duration_s},
        {"seed", QString::number(order.seed)},
        {"stage", order.stage},
        {"exam_course", QString::fromStdString(order.exam.course_id)},
        {"exam_course_version", order.exam.course_version},
        {"exam_stage", QString::fromStdString(order.exam.stage_id)},
        {"exam_begin", static_cast<qint64>(order.exam.begin)},
        {"proctor", QString::fromStdString(order.exam.proctor)},
        {"device_certificate", QString::fromStdString(order.exam.device_certificate)},
        {"store", order.store},
        {"nonce", fresh_nonce()}};
    db::PrivateFile file(order_file(order.recording_file).toStdString());
    order.text = QJsonDocument(json).toJson();
    if (!file.open(QIODevice::WriteOnly) || file.write(order.text) != order.text.size() ||
        !file.commit()) {
        throw StoreError(StoreError::Kind::kUnavailable,
                         "write " + file.fileName().toStdString() + ": " +
                             file.errorString().toStdString() + "; free space and try again");
    }
}

std::optional<AttemptOrder> read_order(const QString& recording_file) {
    QFile file(order_file(recording_file));
    if (!file.open(QIODevice::ReadOnly)) return std::nullopt;
    AttemptOrder order;
    order.text = file.readAll();
    const QJsonObject json = QJsonDocument::fromJson(order.text).object();
    if (!json.contains("user_id")) return std::nullopt;
    order.user_id = json["user_id"].toInteger();
    order.task = json["task"].toString();
    order.title = json["title"].toString();
    order.device = json["device"].toString();
    order.started_utc = json["started_utc"].toString();
    order.demonstration = json["demonstration"].toBool();
    order.study = json["study"].toString();
    order.participant = json["participant"].toString();
    order.step = json["step"].toString();
    order.visit = json["visit"].toInt(1);
    order.aids = json["aids"].toString();
    order.min_s = json["min_s"].toDouble();
    order.duration_s = json["duration_s"].toDouble();
    order.seed = json["seed"].toString().toULongLong();
    order.stage = json["stage"].toInt();
    order.exam.course_id = json["exam_course"].toString().toStdString();
    order.exam.course_version = json["exam_course_version"].toInt();
    order.exam.stage_id = json["exam_stage"].toString().toStdString();
    order.exam.begin = json["exam_begin"].toInteger();
    order.exam.proctor = json["proctor"].toString().toStdString();
    order.exam.device_certificate = json["device_certificate"].toString().toStdString();
    order.store = json["store"].toString();
    order.recording_file = recording_file;
    return order;
}

namespace {

void fill_in(Leftover& leftover, const sim::RecordingHeader& header, const sim::RecordingEnd& end) {
    leftover.duration_s = end.duration_s;
    leftover.complete =
        end.reason != sim::EndReason::kInterrupted && end.reason != sim::EndReason::kRunning;
    if (leftover.started_utc.isEmpty())
        leftover.started_utc = QString::fromStdString(header.started_utc);
    if (leftover.task.isEmpty()) leftover.task = QString::fromStdString(header.task_id);
}

}  // namespace

std::vector<Leftover> find_leftovers(const QString& folder, Depth depth,
                                     const std::set<QString>& saved) {
    std::vector<Leftover> found;
    if (!QDir(folder).exists()) return found;
    for (const std::string& path : db::leftover_recordings(folder.toStdString())) {
        Leftover leftover;
        leftover.recording_file = QString::fromStdString(path);
        if (saved.count(leftover.recording_file) > 0) continue;
        leftover.order = read_order(leftover.recording_file);
        if (leftover.order) {
            leftover.started_utc = leftover.order->started_utc;
            leftover.task = leftover.order->title;
        }
        // A damaged file is shown with its reason instead of hiding all the others.
        try {
            bool whole = depth == Depth::kWhole;
            if (!whole) {
                const db::RecordingSummary summary = db::recording_summary(path);
                fill_in(leftover, summary.header, summary.end);
                // A length of nothing may also be damage, which is for people to judge.
                whole = summary.end.duration_s <= 0;
            }
            if (whole) {
                const db::RecoveredRecording recovered = db::recover_recording_file(path);
                if (recovered.recording.inputs.empty() && recovered.damage.empty()) {
                    remove_recording(leftover.recording_file);
                    continue;
                }
                leftover.damage = QString::fromStdString(recovered.damage);
                fill_in(leftover, recovered.recording.header, recovered.recording.end);
            }
        } catch (const db::StoreError& error) {
            leftover.problem = error;
        }
        found.push_back(std::move(leftover));
    }
    return found;
}

void remove_recording(const QString& recording_file) {
    for (const char* suffix : {"", "-wal", "-shm", "-journal", kWaitingSuffix})
        QFile::remove(recording_file + suffix);
    QFile::remove(order_file(recording_file));
}

SavedAttempt save_recording(db::Store& store, const AttemptOrder& order) {
    const OnlySaver only(order.recording_file);
    if (!QFile::exists(order.recording_file)) return {Saving::kGone, 0};
    const std::string file = order.recording_file.toStdString();
    // Left over from a crash between saving and removing. An order that was changed does not make
    // it another step of a study: it goes on, and is void.
    if (const std::optional<int64_t> known = store.attempts().find_recording(file);
        known && is_of(store.attempts().owner_of(*known), order) &&
        !db::order_doubt(file, order.text.toStdString(), matters(order))) {
        record_study_step(store, order, *known);
        remove_recording(order.recording_file);
        return {Saving::kSaved, *known};
    }
    const sim::Recording recording = db::recover_recording_file(file).recording;
    if (recording.inputs.empty()) {
        remove_recording(order.recording_file);
        return {};
    }
    db::AttemptResult result = db::judged(store, recording);
    result.header.demonstration = recording.header.demonstration || order.demonstration;
    // An exam is what was asked for: this task with this case.
    if (recording.header.task_id == order.task.toStdString() && recording.header.seed == order.seed)
        result.exam = order.exam;
    result.study = {order.study.toStdString(), order.participant.toStdString()};
    result.recording_file = file;
    result.order = order.text.toStdString();
    db::publish_task_on_first_use(store, recording.header.task_id, recording.header.task_version);
    const int64_t id = store.attempts().save(order.user_id, result);
    record_study_step(store, order, id);
    remove_recording(order.recording_file);
    return {Saving::kSaved, id};
}

sim::Recording recording_of_file(const QString& file) {
    return db::recover_recording_file(file.toStdString()).recording;
}

sim::Recording stored_recording(db::Store& store, int64_t attempt_id) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("attempt.placode").toStdString();
    store.attempts().extract_recording(attempt_id, path);
    return db::recover_recording_file(path).recording;
}

}  // namespace placode::ui
