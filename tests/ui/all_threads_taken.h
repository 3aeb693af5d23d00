// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSemaphore>
#include <QThreadPool>

namespace placode::ui {

/// Every thread for work in the background is taken until the end of its life.
class AllThreadsTaken {
 public:
    explicit AllThreadsTaken(QThreadPool& pool) : pool_(pool) {
        pool_.waitForDone();
        count_ = pool_.maxThreadCount();
        for (int i = 0; i < count_; ++i) pool_.start([this] { go_.acquire(); });
    }
    ~AllThreadsTaken() {
        go_.release(count_);
        pool_.waitForDone();
    }
    AllThreadsTaken(const AllThreadsTaken&) = delete;
    AllThreadsTaken& operator=(const AllThreadsTaken&) = delete;

 private:
    QThreadPool& pool_;
    QSemaphore go_;
    int count_ = 0;
};

}  // namespace placode::ui
