// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Recordings that a server's store did not take because it was away. They stay on this computer,
// and are saved without anybody's doing when the server is back: at the next sign-in of whose they
// are, and with growing pauses while that person is signed in; always in that person's name, so
// that nothing is saved that the person may not save. What is in doubt is not saved by itself: it
// is offered, as what a crash has left.

#include <QObject>
#include <QTimer>
#include <exception>
#include <set>
#include <vector>

#include "ui/shell/attempt_order.h"
#include "ui/shell/messages.h"

namespace placode::ui {

class AppContext;

/// Main thread; what takes time is done in the background.
class WaitingRecordings : public QObject {
    Q_OBJECT
 public:
    explicit WaitingRecordings(AppContext& context);

    /// Whether saving that failed with `error` is done later: the store is a server's and away, and
    /// the recording is beyond doubt. It then waits from now on, also after a restart.
    [[nodiscard]] bool keep(const AttemptOrder& order, const std::exception_ptr& error);
    /// Of whoever is signed in, oldest first: begun for this store by that person at this computer,
    /// as order and signature prove, and ended, or marked by keep().
    [[nodiscard]] std::vector<AttemptOrder> mine() const;
    [[nodiscard]] bool holds(const QString& recording_file) const {
        return waiting_.count(recording_file) > 0;
    }
    /// As it was when it was looked at last.
    [[nodiscard]] int count() const { return static_cast<int>(waiting_.size()); }
    /// Does not wait for the pause to be over. Not while an attempt runs.
    void tryNow();
    /// Between tries: the first, and that which doubling it ends at [ms].
    void setPauses(int first_ms, int longest_ms);

 Q_SIGNALS:
    void changed();  ///< count() may be another.
    void saved(const placode::ui::AttemptOrder& order, qint64 attempt_id);
    /// It will not be tried again before the next sign-in.
    void failed(const placode::ui::Problem& problem);
    void stillAway();  ///< Somebody had asked by tryNow().

 private:
    void look();
    void begin();
    void tryNext();
    void onTried(const AttemptOrder& order, const SavedAttempt& outcome,
                 const std::exception_ptr& error);
    void pause();

    AppContext& context_;
    QTimer timer_;
    std::set<QString> waiting_;  ///< Files of mine().
    std::set<QString> refused_;  ///< Not tried again in this session.
    int first_ms_ = 15'000, longest_ms_ = 600'000, pause_ms_ = 15'000;
    bool trying_ = false, asked_ = false;
};

}  // namespace placode::ui
