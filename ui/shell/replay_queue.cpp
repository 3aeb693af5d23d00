// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/replay_queue.h"

#include <sys/resource.h>
#include <unistd.h>

#include <QThread>

#include "db/evidence.h"
#include "db/store.h"

namespace placode::ui {
namespace {

constexpr int kBehindOthers = 15;  ///< Nice level: shell and simulator come first.
constexpr int kHeldLookMs = 100;

}  // namespace

ReplayQueue::ReplayQueue(QObject* parent) : QObject(parent) { thread_.setMaxThreadCount(1); }

ReplayQueue::~ReplayQueue() {
    stopped_ = true;
    thread_.waitForDone();
}

void ReplayQueue::begin(const std::string& store_url, const std::string& actor) {
    if (working_) {
        next_ = Order{store_url, actor};
        return;
    }
    work({store_url, actor});
}

std::optional<double> ReplayQueue::share(int64_t attempt_id) const {
    if (!working_ || at_ != attempt_id) return std::nullopt;
    return share_;
}

void ReplayQueue::work(const Order& order) {
    working_ = true;
    thread_.start([this, order] {
        (void)setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kBehindOthers);
        try {
            verifyAll(order);
        } catch (const std::exception& error) {
            // The attempts wait on; the next time the shell is opened they are looked at again.
            qWarning("placode: simulating attempts again: %s", error.what());
        }
        QMetaObject::invokeMethod(
            this, [this] { ended(); }, Qt::QueuedConnection);
    });
}

void ReplayQueue::verifyAll(const Order& order) {
    const auto store = db::open_store(order.store_url);
    store->act_as(order.actor);
    for (const int64_t id : store->attempts().waiting_for_replay()) {
        if (!mayGoOn()) return;
        const auto verdict =
            db::verify_attempt(*store, id, [&](double share) { return goesOn(id, share); });
        if (verdict)
            QMetaObject::invokeMethod(
                this, [this, id] { Q_EMIT checked(id); }, Qt::QueuedConnection);
    }
}

bool ReplayQueue::goesOn(qint64 attempt_id, double share) {
    QMetaObject::invokeMethod(
        this,
        [this, attempt_id, share] {
            at_ = attempt_id;
            share_ = share;
            Q_EMIT moved(attempt_id);
        },
        Qt::QueuedConnection);
    return mayGoOn();
}

bool ReplayQueue::mayGoOn() const {
    while (held_ && !stopped_) QThread::msleep(kHeldLookMs);
    return !stopped_;
}

void ReplayQueue::ended() {
    working_ = false;
    if (!next_) return;
    const Order order = *next_;
    next_.reset();
    work(order);
}

}  // namespace placode::ui
