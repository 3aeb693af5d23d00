// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Part of Store: remarks on attempts, and ratings by people.

#include <cstdint>
#include <string>
#include <vector>

#include "db/records.h"

namespace placode::db {

class Connection;
struct StoreContext;

/// `store.reviews()`. Every change is one transaction and in the audit trail.
class Reviews {
 public:
    explicit Reviews(StoreContext& context);

    /// Throws kNotFound, kRefused (time outside the attempt, neither text nor time).
    int64_t add_comment(const CommentRecord& comment);
    /// Takes a remark away, or puts it back. Throws kNotFound.
    void set_comment_removed(int64_t id, bool removed);
    [[nodiscard]] std::vector<CommentRecord> comments(int64_t attempt_id);  ///< By time.
    /// Of many attempts at once: by attempt, then by time.
    [[nodiscard]] std::vector<CommentRecord> comments_of(const std::vector<int64_t>& attempt_ids);
    /// Throws kConflict (rated already), kRefused (own attempt), kNotFound.
    int64_t save_rating(const RatingRecord& rating);
    /// Of all attempts, oldest first.
    [[nodiscard]] std::vector<RatingRecord> ratings(const std::string& questionnaire_id);

 private:
    StoreContext& context_;
    Connection& connection_;
};

}  // namespace placode::db
