// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/web/review_maker.h"

#include <sys/resource.h>

#include <algorithm>
#include <utility>

namespace placode::web {
namespace {

constexpr int kNiceness = 10;  // Pages go first.

}  // namespace

ReviewMaker::ReviewMaker(size_t most_bytes, std::function<void(const std::string&)> log)
    : most_bytes_(most_bytes), log_(std::move(log)), worker_([this] { work(); }) {}

ReviewMaker::~ReviewMaker() {
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
    }
    more_.notify_all();
    worker_.join();
}

ReviewMaker::Entries::iterator ReviewMaker::find(const std::string& key) {
    return std::find_if(entries_.begin(), entries_.end(),
                        [&](const Entry& each) { return each.key == key; });
}

size_t ReviewMaker::waiting() const {
    return static_cast<size_t>(
        std::count_if(entries_.begin(), entries_.end(), [](const Entry& each) {
            return each.stage == Stage::kReading || each.stage == Stage::kWaiting ||
                   each.stage == Stage::kMaking;
        }));
}

ReviewMaker::Standing ReviewMaker::standing(const std::string& key) {
    const auto found = find(key);
    if (found == entries_.end()) return {};
    entries_.splice(entries_.begin(), entries_, found);
    return {found->stage, found->stage == Stage::kMaking ? share_.load() : 0, found->track};
}

ReviewMaker::Standing ReviewMaker::of(const std::string& key) {
    const std::lock_guard lock(mutex_);
    return standing(key);
}

ReviewMaker::Standing ReviewMaker::ask(const std::string& key,
                                       const std::function<sim::Recording()>& read) {
    {
        const std::lock_guard lock(mutex_);
        if (find(key) != entries_.end()) return standing(key);
        const bool reading = std::ranges::any_of(
            entries_, [](const Entry& each) { return each.stage == Stage::kReading; });
        if (reading || waiting() >= kMostReviewsWaiting) return {};
        // Before a byte is read: it has its place, and whoever asks meanwhile reads nothing.
        entries_.push_front({key, Stage::kReading, {}, {}});
    }
    try {
        // Reading takes a while, and other pages must not wait for it.
        sim::Recording recording = read();
        const std::lock_guard lock(mutex_);
        const auto entry = find(key);
        entry->recording = std::move(recording);
        entry->stage = Stage::kWaiting;
        more_.notify_all();
        return standing(key);
    } catch (...) {
        const std::lock_guard lock(mutex_);
        entries_.erase(find(key));
        throw;
    }
}

void ReviewMaker::keep(const std::string& key, std::shared_ptr<const reports::ReviewTrack> track) {
    const std::lock_guard lock(mutex_);
    const auto entry = find(key);
    if (entry == entries_.end()) return;
    entry->stage = track ? Stage::kReady : Stage::kFailed;
    entry->track = std::move(track);
    drop_the_oldest();
}

/// Down to the memory that tracks may take; the last one stays, however large it is. Of those that
/// failed some are remembered, so that nobody tries them again and again.
void ReviewMaker::drop_the_oldest() {
    constexpr size_t kMostKept = 256;
    size_t bytes = 0, kept = 0;
    for (auto each = entries_.begin(); each != entries_.end();) {
        const bool made = each->stage == Stage::kReady || each->stage == Stage::kFailed;
        if (each->track) bytes += each->track->bytes();
        if (made) ++kept;
        const bool too_much = kept > 1 && (bytes > most_bytes_ || kept > kMostKept);
        each = made && too_much ? entries_.erase(each) : std::next(each);
    }
}

void ReviewMaker::work() {
    ::setpriority(PRIO_PROCESS, 0, kNiceness);  // Of this thread alone, on Linux.
    std::unique_lock lock(mutex_);
    while (!ending_) {
        // Who looked last, and so still waits at the page, goes first.
        const auto next = std::find_if(entries_.begin(), entries_.end(), [](const Entry& each) {
            return each.stage == Stage::kWaiting;
        });
        if (next == entries_.end()) {
            more_.wait(lock);
            continue;
        }
        next->stage = Stage::kMaking;
        share_ = 0;
        const std::string key = next->key;
        const sim::Recording recording = std::move(next->recording);
        lock.unlock();
        std::shared_ptr<const reports::ReviewTrack> track;
        try {
            auto made = reports::make_review_track(recording, [this](double share) {
                share_ = share;
                return !ending_;
            });
            if (made) track = std::make_shared<const reports::ReviewTrack>(std::move(*made));
        } catch (const std::exception& error) {
            log_("review of " + key + ": " + error.what());
        }
        keep(key, std::move(track));
        lock.lock();
    }
}

}  // namespace placode::web
