// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Scores of tasks into a platform's gradebook. Source: LTI Assignment and Grade Services 2.0.

#include <optional>
#include <string>
#include <vector>

#include "db/store.h"
#include "ui/lti/sending.h"
#include "ui/lti/sent_file.h"
#include "ui/lti/settings.h"
#include "ui/lti/web_token.h"

namespace placode::lti {

/// What a person has in a column.
struct Grade {
    std::string subject, login, task, line_item;
    /// Of the attempt that is taken, 0 to 100, in hundredths; nothing: no attempt counts.
    std::optional<double> points;
};

/// Whether a link's number and log-in name are still one account's. Throws StoreError.
[[nodiscard]] bool is_theirs(db::Store& store, const Link& link);
/// What is said of one that is not.
[[nodiscard]] std::string not_theirs(const Link& link);

/// For everybody who is linked. Only attempts that count (db/attempt_counting.h), none of a study.
/// `problems` gets whoever is linked with an account that is gone or somebody else's. Throws
/// StoreError.
[[nodiscard]] std::vector<Grade> grades_of(db::Store& store, const Platform& platform,
                                           const LineItem& item,
                                           std::vector<std::string>& problems);

/// The body of a score. @param timestamp "2026-11-21T18:03:00.123Z"
[[nodiscard]] std::string score_text(const Grade& grade, const std::string& timestamp);
/// ".../lineitem?x=1" to ".../lineitem/scores?x=1".
[[nodiscard]] std::string scores_address(const std::string& line_item);

enum class Sent : uint8_t { kSent, kSame, kNothing, kFailed };

/// Sends to one platform. A token is asked for when the first score is due.
class GradeSender {
 public:
    GradeSender(const Platform& platform, const SigningKey& key, SentFile& sent,
                const Patience& patience)
        : platform_(platform), key_(key), sent_(sent), patience_(patience) {}

    /// What send() would do, without doing it: kSent for what is due.
    [[nodiscard]] Sent due(const Grade& grade) const;
    /// Nothing is sent twice, and nothing of somebody without an attempt; who had one that counts
    /// no more is sent without a score, which clears it. `problem` says why it is kFailed.
    [[nodiscard]] Sent send(const Grade& grade, std::string& problem);
    /// The platform could not be reached or gave no token: all that follows fails as well.
    [[nodiscard]] bool is_away() const { return away_; }

 private:
    /// False with `problem`.
    [[nodiscard]] bool get_token(std::string& problem);
    [[nodiscard]] std::string key_of(const Grade& grade) const;

    const Platform& platform_;
    const SigningKey& key_;
    SentFile& sent_;
    Patience patience_;
    std::string token_;
    bool away_ = false;
};

}  // namespace placode::lti
