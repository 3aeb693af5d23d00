// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Simulates exams and attempts of studies again, one after the other, behind everything else: they
// count once the same came out (db/evidence.h).

#include <QObject>
#include <QThreadPool>
#include <atomic>
#include <optional>
#include <string>

namespace placode::ui {

/// Main thread. Work that is broken off is begun anew the next time.
class ReplayQueue : public QObject {
    Q_OBJECT
 public:
    explicit ReplayQueue(QObject* parent = nullptr);
    ~ReplayQueue() override;

    /// Takes up all that waits in this store, in the name of `actor`. While it works already it
    /// looks again at the end.
    void begin(const std::string& store_url, const std::string& actor);
    /// The simulator needs the processor: stands still meanwhile.
    void hold(bool held) { held_ = held; }
    /// How far this attempt is, 0..1; nullopt: it is not its turn.
    [[nodiscard]] std::optional<double> share(int64_t attempt_id) const;
    [[nodiscard]] bool working() const { return working_; }

 Q_SIGNALS:
    void moved(qint64 attempt_id);    ///< share() changed.
    void checked(qint64 attempt_id);  ///< The store has what came out.

 private:
    struct Order {
        std::string store_url, actor;
    };
    void work(const Order& order);
    void verifyAll(const Order& order);
    [[nodiscard]] bool goesOn(qint64 attempt_id, double share);
    /// Waits while it is held. false: it is to end.
    [[nodiscard]] bool mayGoOn() const;
    void ended();

    QThreadPool thread_;
    std::atomic<bool> stopped_{false}, held_{false};
    bool working_ = false;
    std::optional<Order> next_;
    qint64 at_ = 0;
    double share_ = 0;
};

}  // namespace placode::ui
