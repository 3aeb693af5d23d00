// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Tracks of attempts for the review page: one is made at a time, in a thread of its own with low
// priority, and the last ones are kept in memory and nowhere else, so nothing of an attempt stays
// when it is erased and the program ends.

#include <atomic>
#include <condition_variable>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "reports/review_track.h"

namespace placode::web {

inline constexpr size_t kReviewBytes = size_t{256} << 20;  ///< Tracks that are kept.
/// With the one that is made: their recordings are whole in memory, up to 1 GiB each. The limit of
/// packaging/placode-web.service goes with it.
inline constexpr size_t kMostReviewsWaiting = 2;

/// Any thread.
class ReviewMaker {
 public:
    enum class Stage : uint8_t {
        kReady,
        kMaking,
        kWaiting,  ///< For others that were asked for before.
        kReading,  ///< Somebody else asked for it just now.
        kBusy,     ///< Too many wait, or another is read: it was not taken.
        kFailed,   ///< Its task cannot be built, or the memory did not suffice.
    };
    struct Standing {
        Stage stage = Stage::kBusy;
        double share = 0;                                   ///< kMaking: 0 to 1.
        std::shared_ptr<const reports::ReviewTrack> track;  ///< kReady.
    };

    /// @param log is told why a track could not be made.
    ReviewMaker(size_t most_bytes, std::function<void(const std::string&)> log);
    /// Breaks off what is being made.
    ~ReviewMaker();
    ReviewMaker(const ReviewMaker&) = delete;
    ReviewMaker& operator=(const ReviewMaker&) = delete;

    /// How the track of `key` stands; where nobody asked for it, `read` is called at once for its
    /// recording, and it waits for its turn. Never two at a time are read, nor one twice. What
    /// `read` throws goes on to the caller, and the next one who asks reads again.
    [[nodiscard]] Standing ask(const std::string& key, const std::function<sim::Recording()>& read);
    /// The same without asking for it: kBusy where nobody did.
    [[nodiscard]] Standing of(const std::string& key);

 private:
    struct Entry {
        std::string key;
        Stage stage = Stage::kWaiting;
        sim::Recording recording;  ///< kWaiting.
        std::shared_ptr<const reports::ReviewTrack> track;
    };
    using Entries = std::list<Entry>;

    [[nodiscard]] Entries::iterator find(const std::string& key);
    [[nodiscard]] Standing standing(const std::string& key);
    [[nodiscard]] size_t waiting() const;
    void work();
    void keep(const std::string& key, std::shared_ptr<const reports::ReviewTrack> track);
    void drop_the_oldest();

    const size_t most_bytes_;
    std::function<void(const std::string&)> log_;
    std::mutex mutex_;
    std::condition_variable more_;
    Entries entries_;  ///< The most lately seen first.
    std::atomic<double> share_{0};
    std::atomic<bool> ending_{false};
    std::thread worker_;
};

}  // namespace placode::web
