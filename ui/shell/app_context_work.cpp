// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Work in the background: who waits for whom, what is said of it, and how long it takes.
#include <QPointer>
#include <QThreadPool>

#include "ui/shell/app_context.h"

namespace placode::ui {
namespace {

constexpr double kWorthAnEstimateS = 2;  ///< Shorter work is over before anybody reads it.
constexpr double kOverdue = 1.5;         ///< Times the estimate; then it is worth nothing.
constexpr double kLateShare = 0.9;       ///< From here on the estimate was too short.
constexpr double kTeachingS = 5;         ///< Of a recording: a shorter one tells of the start-up.

/// Remembers how long a second of a recording takes, half of it from before.
void learn_pace(QSettings& settings, const WorkSize& size, double took_s) {
    if (size.kind.isEmpty() || size.recorded_s < kTeachingS || took_s <= 0) return;
    const QString key = "pace/" + size.kind;
    const double now = took_s / size.recorded_s, before = settings.value(key).toDouble();
    settings.setValue(key, before > 0 ? 0.5 * (before + now) : now);
}

}  // namespace

void AppContext::background(QObject* receiver, const QString& doing,
                            std::function<void(db::Store&)> work, std::function<void(bool)> done,
                            const WorkSize& size) {
    backgroundFor(user_ ? user_->id : 0, receiver, doing, std::move(work), std::move(done), size);
}

void AppContext::backgroundFor(int64_t account, QObject* receiver, const QString& doing,
                               std::function<void(db::Store&)> work, std::function<void(bool)> done,
                               const WorkSize& size,
                               std::function<bool(const std::exception_ptr&)> dealt_with,
                               Lane lane) {
    quietlyFor(account, this, std::move(work),
               beginBusy(receiver, doing, std::move(done), size, std::move(dealt_with)), lane);
}

std::function<void(const std::exception_ptr&)> AppContext::beginBusy(
    QObject* receiver, const QString& doing, std::function<void(bool)> done, const WorkSize& size,
    std::function<bool(const std::exception_ptr&)> dealt_with) {
    ++busy_;
    busy_with_ = doing;
    work_size_ = size;
    work_started_.start();
    Q_EMIT busyChanged(doing);
    const QPointer<QObject> alive(receiver);
    return [this, alive, doing, done = std::move(done), dealt_with = std::move(dealt_with), size,
            began = work_started_](const std::exception_ptr& error) {
        if (!error) learn_pace(*settings_, size, static_cast<double>(began.elapsed()) / 1000);
        if (--busy_ == 0) Q_EMIT busyChanged({});
        if (error && !(alive && dealt_with && dealt_with(error))) report(problem_of(error, doing));
        // `done` may read on, and no exception may leave a queued call.
        if (alive) guard(doing, [&] { done(!error); });
    };
}

void AppContext::quietlyFor(int64_t account, QObject* receiver,
                            std::function<void(db::Store&)> work,
                            std::function<void(const std::exception_ptr&)> done, Lane lane) {
    const auto with_store = [work = std::move(work), url = store_url_, user = user_, account] {
        const std::unique_ptr<db::Store> own = db::open_store(url);
        account != 0 ? own->act_for(account) : own->sign_out();
        if (user && user->id == account)
            if (const QString note = sessionProblem(own->accounts().find(user->id), *user);
                !note.isEmpty())
                throw Refusal(note);
        work(*own);
    };
    inThread(receiver, with_store, std::move(done), lane);
}

void AppContext::inThread(QObject* receiver, std::function<void()> work,
                          std::function<void(const std::exception_ptr&)> done, Lane lane) {
    // Shared: clang's analyzer follows copies of a QPointer into Qt and takes one for deleted.
    const auto alive = std::make_shared<const QPointer<QObject>>(receiver);
    (lane == Lane::kSaving ? saves_ : works_)
        .start([this, alive, work = std::move(work), done = std::move(done)] {
            std::exception_ptr error;
            try {
                work();
            } catch (...) {
                error = std::current_exception();
            }
            const auto deliver = [alive, done, error] {
                if (*alive) done(error);
            };
            QMetaObject::invokeMethod(this, deliver, Qt::QueuedConnection);
        });
}

void AppContext::restoreBackup(const QString& file, QObject* receiver,
                               std::function<void(bool)> done) {
    store_.reset();
    restoring_ = true;
    const QPointer<QObject> alive(receiver);
    const auto restored = [this, alive, done = std::move(done)](bool in_place) {
        restoring_ = false;
        const bool open = in_place && openStore();
        if (alive) done(open);
    };
    inThread(
        this, [url = store_url_, from = file.toStdString()] { (void)db::restore_store(url, from); },
        beginBusy(this, tr("Restoring the backup"), restored, {}, {}), Lane::kWork);
}

void AppContext::whenIdle(QObject* receiver, std::function<void()> act) {
    if (!busy()) return act();
    // Queued: whoever began the work hears first that it is done.
    auto* once = new QObject(receiver);
    connect(
        this, &AppContext::busyChanged, once,
        [this, once, act = std::move(act), done = false](const QString& what) mutable {
            // Two ends may have been queued before the first was heard.
            if (done || !what.isEmpty() || busy()) return;
            done = true;
            once->deleteLater();
            act();
        },
        Qt::QueuedConnection);
}

std::optional<WorkPace> AppContext::busyPace() const {
    if (busy_ != 1 || work_size_.kind.isEmpty() || work_size_.recorded_s <= 0) return std::nullopt;
    const double per_s = settings_->value("pace/" + work_size_.kind).toDouble();
    if (per_s <= 0) return std::nullopt;
    const double whole = per_s * work_size_.recorded_s;
    if (whole < kWorthAnEstimateS) return std::nullopt;
    const double passed = static_cast<double>(work_started_.elapsed()) / 1000;
    // Late work does not stand at its end: what is left shrinks ever more slowly.
    const double share = passed < kLateShare * whole
                             ? passed / whole
                             : 1 - (1 - kLateShare) * kLateShare * whole / passed;
    return WorkPace{share, passed / share - passed, passed > kOverdue * whole};
}

}  // namespace placode::ui
