// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/waiting_recordings.h"

#include <QFile>
#include <algorithm>
#include <memory>

#include "db/recording_file.h"
#include "db/recording_order.h"
#include "db/recording_seal.h"
#include "db/station.h"
#include "ui/shell/app_context.h"

namespace placode::ui {
namespace {

bool may_pass(const std::exception_ptr& error) {
    try {
        std::rethrow_exception(error);
    } catch (const db::StoreError& e) {
        return db::may_pass(e);
    } catch (...) {
        return false;
    }
}

/// As it was begun, and by this computer: who can write into the folder has nothing saved in the
/// name of somebody who does not press Save.
bool is_beyond_doubt(const AttemptOrder& order) {
    try {
        const std::string file = order.recording_file.toStdString();
        const db::RecordingSeal seal = db::recording_seal(file);
        return seal.signature == db::RecordingSignature::kRight &&
               seal.station == db::Station().public_key_if_any() &&
               !db::order_doubt(file, order.text.toStdString(), true);
    } catch (const db::StoreError&) {
        return false;
    }
}

/// Who broke an attempt off by closing the shell is asked what becomes of it.
bool was_to_be_saved(const QString& recording_file) {
    if (QFile::exists(recording_file + kWaitingSuffix)) return true;
    try {
        const sim::EndReason end = db::recording_summary(recording_file.toStdString()).end.reason;
        return end != sim::EndReason::kInterrupted && end != sim::EndReason::kRunning;
    } catch (const db::StoreError&) {
        return false;
    }
}

}  // namespace

WaitingRecordings::WaitingRecordings(AppContext& context) : context_(context) {
    timer_.setSingleShot(true);
    connect(&timer_, &QTimer::timeout, this, &WaitingRecordings::begin);
    // Whoever has just signed in has reached the server.
    connect(&context, &AppContext::userChanged, this, [this] {
        refused_.clear();
        pause_ms_ = first_ms_;
        begin();
    });
}

void WaitingRecordings::setPauses(int first_ms, int longest_ms) {
    first_ms_ = pause_ms_ = first_ms;
    longest_ms_ = longest_ms;
}

bool WaitingRecordings::keep(const AttemptOrder& order, const std::exception_ptr& error) {
    if (order.store.isEmpty() || !may_pass(error) || !is_beyond_doubt(order)) return false;
    QFile mark(order.recording_file + kWaitingSuffix);
    if (!mark.open(QIODevice::WriteOnly)) return false;
    mark.close();
    look();
    pause_ms_ = first_ms_;
    pause();
    return true;
}

std::vector<AttemptOrder> WaitingRecordings::mine() const {
    std::vector<AttemptOrder> found;
    if (!context_.signedIn() || context_.storeIsFile()) return found;
    const QString here = server_place(context_.storeUrl());
    for (const std::string& file :
         db::leftover_recordings(context_.recordingsFolder().toStdString())) {
        const std::optional<AttemptOrder> order = read_order(QString::fromStdString(file));
        if (order && order->user_id == context_.user().id && order->store == here &&
            !context_.isBeingSaved(order->recording_file) &&
            was_to_be_saved(order->recording_file) && is_beyond_doubt(*order))
            found.push_back(*order);
    }
    return found;
}

void WaitingRecordings::look() {
    waiting_.clear();
    for (const AttemptOrder& order : mine()) waiting_.insert(order.recording_file);
    Q_EMIT changed();
}

void WaitingRecordings::pause() {
    if (waiting_.empty() || !context_.signedIn()) return timer_.stop();
    timer_.start(pause_ms_);
    pause_ms_ = std::min(2 * pause_ms_, longest_ms_);
}

void WaitingRecordings::tryNow() {
    asked_ = true;
    refused_.clear();
    pause_ms_ = first_ms_;
    begin();
}

void WaitingRecordings::begin() {
    if (trying_) return;
    look();
    // The simulator needs the processor.
    if (context_.launcher().running()) return pause();
    tryNext();
}

void WaitingRecordings::tryNext() {
    timer_.stop();
    for (const AttemptOrder& order : mine()) {
        if (refused_.count(order.recording_file) > 0) continue;
        trying_ = true;
        const auto outcome = std::make_shared<SavedAttempt>();
        return context_.quietlyFor(
            order.user_id, this,
            [outcome, order](db::Store& store) { *outcome = save_recording(store, order); },
            [this, outcome, order](const std::exception_ptr& error) {
                onTried(order, *outcome, error);
            },
            Lane::kSaving);
    }
    asked_ = false;
    look();
}

void WaitingRecordings::onTried(const AttemptOrder& order, const SavedAttempt& outcome,
                                const std::exception_ptr& error) {
    trying_ = false;
    // Whoever has signed out meanwhile could not save it any more.
    const bool still_here = context_.signedIn() && context_.user().id == order.user_id;
    if (error && !still_here) return tryNext();
    if (error && may_pass(error)) {
        if (asked_) Q_EMIT stillAway();
        asked_ = false;
        look();  // Somebody else may have signed in meanwhile.
        return pause();
    }
    if (error) {
        refused_.insert(order.recording_file);
        Q_EMIT failed(problem_of(error, tr("Saving the attempt")));
    } else if (outcome.outcome == Saving::kSaved) {
        // A folder that takes nothing away any more: not over and over again.
        if (QFile::exists(order.recording_file)) refused_.insert(order.recording_file);
        Q_EMIT saved(order, outcome.attempt_id);
    }
    pause_ms_ = first_ms_;
    tryNext();
}

}  // namespace placode::ui
