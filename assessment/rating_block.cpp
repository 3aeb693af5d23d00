// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/rating_block.h"

#include <algorithm>
#include <bit>
#include <set>
#include <utility>

namespace placode::assessment {
namespace {

constexpr size_t kEveryGroupUpTo = 12;  // 4,096 groups.

using Bits = std::vector<uint64_t>;  ///< A bit for each attempt.

/// Raters, by their place in the order of ids, and the attempts that all of them judged.
struct Group {
    std::vector<size_t> raters;
    Bits attempts;
    size_t count = 0;  ///< Of the attempts.
};

class Search {
 public:
    Search(std::vector<Bits> judged, size_t least) : judged_(std::move(judged)), least_(least) {
        if (judged_.size() <= kEveryGroupUpTo) {
            every_group({}, 0);
            return;
        }
        for (size_t a = 0; a < judged_.size(); ++a)
            for (size_t b = a + 1; b < judged_.size(); ++b) grow(joined(joined({}, a), b));
    }
    [[nodiscard]] const Group& best() const { return best_; }

 private:
    [[nodiscard]] Group joined(const Group& group, size_t rater) const {
        Group larger{group.raters, judged_[rater], 0};
        larger.raters.push_back(rater);
        for (size_t i = 0; i < larger.attempts.size(); ++i) {
            if (!group.raters.empty()) larger.attempts[i] &= group.attempts[i];
            larger.count += static_cast<size_t>(std::popcount(larger.attempts[i]));
        }
        return larger;
    }

    void consider(const Group& group) {
        if (group.raters.size() < 2) return;
        const size_t cells = group.raters.size() * group.count,
                     before = best_.raters.size() * best_.count;
        if (cells > before || (cells == before && group.count > best_.count)) best_ = group;
    }

    /// All that `group` can become with raters from `next` on, in the order of the raters. A larger
    /// group never has more attempts.
    void every_group(const Group& group, size_t next) {
        for (size_t rater = next; rater < judged_.size(); ++rater) {
            const Group larger = joined(group, rater);
            if (larger.count < least_) continue;
            consider(larger);
            every_group(larger, rater + 1);
        }
    }

    void grow(Group group) {
        while (group.count >= least_) {
            consider(group);
            Group next;
            for (size_t rater = 0; rater < judged_.size(); ++rater) {
                if (std::count(group.raters.begin(), group.raters.end(), rater) > 0) continue;
                Group larger = joined(group, rater);
                if (next.raters.empty() || larger.count > next.count) next = std::move(larger);
            }
            group = std::move(next);
        }
    }

    std::vector<Bits> judged_;
    size_t least_;
    Group best_;
};

}  // namespace

RatingBlock complete_block(const RatingTable& ratings, size_t least_attempts) {
    std::set<int64_t> ids;
    for (const auto& [attempt, values] : ratings)
        for (const auto& [rater, value] : values) ids.insert(rater);
    const std::vector<int64_t> raters(ids.begin(), ids.end());
    std::vector<Bits> judged(raters.size(), Bits((ratings.size() + 63) / 64, 0));
    size_t place = 0;
    for (const auto& [attempt, values] : ratings) {
        for (size_t r = 0; r < raters.size(); ++r)
            if (values.contains(raters[r])) judged[r][place / 64] |= uint64_t{1} << (place % 64);
        ++place;
    }
    const Search search(std::move(judged), std::max<size_t>(1, least_attempts));
    RatingBlock block;
    for (const size_t r : search.best().raters) block.raters.push_back(raters[r]);
    std::sort(block.raters.begin(), block.raters.end());
    if (block.raters.empty()) return block;
    for (const auto& [attempt, values] : ratings) {
        std::vector<double> row;
        for (const int64_t rater : block.raters)
            if (const auto found = values.find(rater); found != values.end())
                row.push_back(found->second);
        if (row.size() == block.raters.size()) block.scores.push_back(std::move(row));
    }
    return block;
}

}  // namespace placode::assessment
