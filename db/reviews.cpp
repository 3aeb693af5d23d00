// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/reviews.h"

#include <cmath>
#include <map>

#include "db/id_parts.h"
#include "db/store_context.h"

namespace placode::db {

using Kind = StoreError::Kind;

Reviews::Reviews(StoreContext& context) : context_(context), connection_(context.connection) {}

int64_t Reviews::add_comment(const CommentRecord& comment) {
    connection_.begin_operation("remark on attempt " + std::to_string(comment.attempt_id) + " in");
    context_.need_for_attempt(Action::kRemark, comment.attempt_id);
    context_.need_for(Action::kActAs, comment.author_id);
    UnitOfWork work(connection_);
    Statement there(connection_, "SELECT duration_s FROM attempts WHERE id = ?");
    if (!there.run(comment.attempt_id).next())
        connection_.fail(Kind::kNotFound,
                         "there is no attempt " + std::to_string(comment.attempt_id));
    const double duration_s = there.real(0);
    if (!std::isfinite(comment.time_s) || comment.time_s > duration_s + 1)
        connection_.fail(
            Kind::kRefused,
            Said::that("the time is not within the attempt of %1 s").with(std::lround(duration_s)));
    if (comment.time_s < 0 && comment.text.empty())
        connection_.fail(Kind::kRefused, Said::that("a remark needs a text or a time"));
    (void)context_.need_user(comment.author_id);
    context_.touch("attempt", comment.attempt_id);
    Statement insert(connection_,
                     "INSERT INTO attempt_comments (attempt_id, author_id, time_s, comment, "
                     "at_utc, removed_utc) VALUES (?, ?, ?, ?, ?, '') RETURNING id");
    insert.run(comment.attempt_id, comment.author_id, comment.time_s < 0 ? -1.0 : comment.time_s,
               comment.text, utc_now());
    const int64_t id = insert.returned_id();
    context_.append_audit("comment.add", "attempt " + std::to_string(comment.attempt_id),
                          "comment " + std::to_string(id));
    work.commit();
    return id;
}

void Reviews::set_comment_removed(int64_t id, bool removed) {
    connection_.begin_operation("remove a remark from");
    int64_t attempt_id = 0, author_id = 0;
    {
        Statement of(connection_,
                     "SELECT attempt_id, author_id FROM attempt_comments WHERE id = ?");
        if (of.run(id).next())
            attempt_id = of.integer("attempt_id"), author_id = of.integer("author_id");
    }
    // One's own, or as who judges the attempt.
    // A server leaves out what is out of sight, and says as little as of one that is not there.
    if (attempt_id == 0) context_.need(Action::kReviewAttempts, Scope::kGroup);
    context_.is_self(author_id) ? context_.need(Action::kUseStore)
                                : context_.need_for_attempt(Action::kReviewAttempts, attempt_id);
    UnitOfWork work(connection_);
    if (attempt_id != 0) context_.touch("attempt", attempt_id);
    Statement update(connection_, "UPDATE attempt_comments SET removed_utc = ? WHERE id = ?");
    update.run(removed ? utc_now() : std::string(), id);
    if (update.affected() == 0)
        connection_.fail(Kind::kNotFound, "there is no remark " + std::to_string(id));
    context_.append_audit(removed ? "comment.remove" : "comment.restore",
                          "comment " + std::to_string(id), "");
    work.commit();
}

std::vector<CommentRecord> Reviews::comments(int64_t attempt_id) {
    return comments_of({attempt_id});
}

std::vector<CommentRecord> Reviews::comments_of(const std::vector<int64_t>& attempt_ids) {
    connection_.begin_operation("read the remarks of");
    context_.need_sight_of_attempts(attempt_ids);
    std::vector<CommentRecord> found;
    for (const IdPart& part : in_parts(attempt_ids)) {
        Statement query(
            connection_,
            "SELECT c.id, c.attempt_id, c.author_id, COALESCE(p.display_name, '') AS author_name, "
            "c.time_s, c.comment, c.at_utc FROM attempt_comments c LEFT JOIN persons p ON "
            "p.account_id = c.author_id WHERE c.attempt_id IN " +
                part.list + " AND c.removed_utc = '' ORDER BY c.attempt_id, c.time_s, c.id");
        query.run_list(part.values);
        while (query.next()) {
            CommentRecord& comment = found.emplace_back();
            comment.id = query.integer("id");
            comment.attempt_id = query.integer("attempt_id");
            comment.author_id = query.integer("author_id");
            comment.author_name = query.text("author_name");
            comment.time_s = query.real("time_s");
            comment.text = query.text("comment");
            comment.at_utc = query.text("at_utc");
        }
    }
    return found;
}

int64_t Reviews::save_rating(const RatingRecord& rating) {
    connection_.begin_operation("save a rating of attempt " + std::to_string(rating.attempt_id) +
                                " in");
    context_.need_for_attempt(Action::kReviewAttempts, rating.attempt_id);
    context_.need_for(Action::kActAs, rating.rater_id);
    UnitOfWork work(connection_);
    Statement there(connection_, "SELECT account_id, study FROM attempts WHERE id = ?");
    if (!there.run(rating.attempt_id).next())
        connection_.fail(Kind::kNotFound,
                         "there is no attempt " + std::to_string(rating.attempt_id));
    if (there.integer("account_id") == rating.rater_id && there.text("study").empty())
        connection_.fail(Kind::kRefused, Said::that("nobody rates an attempt of their own"));
    (void)context_.need_user(rating.rater_id);
    Statement before(connection_,
                     "SELECT id FROM attempt_ratings WHERE attempt_id = ? AND rater_id = ? AND "
                     "questionnaire_id = ?");
    if (before.run(rating.attempt_id, rating.rater_id, rating.questionnaire_id).next())
        connection_.fail(Kind::kConflict, Said::that("this rater has rated the attempt already"));
    context_.touch("attempt", rating.attempt_id);
    Statement insert(connection_,
                     "INSERT INTO attempt_ratings (attempt_id, rater_id, questionnaire_id, "
                     "questionnaire_version, blinded, rated_utc) VALUES (?, ?, ?, ?, ?, ?) "
                     "RETURNING id");
    insert.run(rating.attempt_id, rating.rater_id, rating.questionnaire_id,
               rating.questionnaire_version, rating.blinded, utc_now());
    const int64_t id = insert.returned_id();
    Statement item(connection_,
                   "INSERT INTO attempt_rating_items (rating_id, item, answer) VALUES (?, ?, ?)");
    for (const auto& [name, answer] : rating.answers) item.run(id, name, answer);
    context_.append_audit("rating.save", "attempt " + std::to_string(rating.attempt_id),
                          rating.questionnaire_id + " version " +
                              std::to_string(rating.questionnaire_version) +
                              (rating.blinded ? ", blinded" : ""));
    work.commit();
    return id;
}

std::vector<RatingRecord> Reviews::ratings(const std::string& questionnaire_id) {
    connection_.begin_operation("read the ratings of");
    context_.need_any({Action::kViewAttempts, Action::kExportStudy});
    std::vector<RatingRecord> found;
    std::map<int64_t, size_t> place;
    Statement query(connection_,
                    "SELECT id, attempt_id, rater_id, questionnaire_version, blinded, rated_utc "
                    "FROM attempt_ratings WHERE questionnaire_id = ? ORDER BY id");
    query.run(questionnaire_id);
    while (query.next()) {
        RatingRecord rating;
        rating.id = query.integer("id");
        rating.attempt_id = query.integer("attempt_id");
        rating.rater_id = query.integer("rater_id");
        rating.questionnaire_id = questionnaire_id;
        rating.questionnaire_version = static_cast<int>(query.integer("questionnaire_version"));
        rating.blinded = query.integer("blinded") != 0;
        rating.rated_utc = query.text("rated_utc");
        place[rating.id] = found.size();
        found.push_back(std::move(rating));
    }
    Statement items(connection_,
                    "SELECT i.rating_id, i.item, i.answer FROM attempt_rating_items i JOIN "
                    "attempt_ratings r ON r.id = i.rating_id WHERE r.questionnaire_id = ?");
    items.run(questionnaire_id);
    while (items.next()) {
        const auto at = place.find(items.integer("rating_id"));
        if (at != place.end()) found[at->second].answers[items.text("item")] = items.text("answer");
    }
    return found;
}

}  // namespace placode::db
