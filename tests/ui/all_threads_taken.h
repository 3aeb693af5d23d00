// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSemaphore>
#include <QThreadPool>

namespace placode::ui {

/// Every thread for work in the background is taken until the end of its life.
class AllThreadsTaken {
 public:
    AllThreadsTaken() {
        QThreadPool* pool = QThreadPool::globalInstance();
        pool->waitForDone();
        count_ = pool->maxThreadCount();
        for (int i = 0; i < count_; ++i) pool->start([this] { go_.acquire(); });
    }
    ~AllThreadsTaken() {
        go_.release(count_);
        QThreadPool::globalInstance()->waitForDone();
    }
    AllThreadsTaken(const AllThreadsTaken&) = delete;
    AllThreadsTaken& operator=(const AllThreadsTaken&) = delete;

 private:
    QSemaphore go_;
    int count_ = 0;
};

}  // namespace placode::ui
