// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/exam_check.h"

#include <QtGlobal>
#include <algorithm>
#include <optional>

#include "curriculum/shipped_definitions.h"
#include "curriculum/utc_time.h"
#include "db/course_rows.h"
#include "db/store_context.h"

namespace placode::db {
namespace {

/// The person's own word, and nobody else's: an order lay beside the recording, or who is examined
/// saves it.
bool own_word(StoreContext& context, const UserRecord& user, const AttemptResult& result) {
    return result.order || context.is_self(user.id);
}

struct Proctor {
    std::string kept;     ///< As the store keeps it; empty = none was named.
    bool may_be = false;  ///< An educator or administrator who is not examined.
};

/// Of an exam that was begun here its begin says who: that account may be closed since.
Proctor proctor_of(StoreContext& context, const UserRecord& user, const ExamContext& exam,
                   const ExamBeginRecord* begin) {
    if (begin != nullptr && !begin->proctor.empty())
        return {begin->proctor, begin->proctor != user_object(user.id)};
    if (exam.proctor.empty()) return {};
    // Under the account's number, which stays when the name is erased.
    if (const auto found = context.find_staff(exam.proctor))
        return {user_object(found->id), found->id != user.id};
    return {context.kept_name(exam.proctor), false};
}

/// Somebody else than the examined person says that it was an exam: a proctor, who signs in with
/// the program, or an account that may save for others. Whoever has the file of a store, or a
/// service's log-in, is nobody in particular.
bool vouched(StoreContext& context, const UserRecord& user, bool proctor) {
    if (context.is_self(user.id)) return proctor && !context.connection.hides_passwords();
    const bool signed_in = context.actor.kind == Actor::Kind::kAccount;
    return proctor || (signed_in && context.may(Action::kSaveAttempt));
}

/// @param why with a translation as what the store says.
std::optional<VoidReason> closed(const char* why) {
    return VoidReason{VoidCause::kExamClosed, 0, 0, Said::listed(why)};
}

/// Of an exam that was begun here: the rest was asked in the transaction that began it. What an
/// educator publishes or ends meanwhile takes nobody's exam.
std::optional<VoidReason> other_case(const AttemptResult& result, const ExamBeginRecord& begin) {
    if (result.header.task_id == begin.task_id && result.header.seed == begin.seed)
        return std::nullopt;
    return closed(QT_TRANSLATE_NOOP("Said", "another case is due by now"));
}

/// Of an import: attempts, assignment and stage as they are now.
std::optional<VoidReason> closed_by_now(StoreContext& context, const UserRecord& user,
                                        const AttemptResult& result, const CourseRows& rows,
                                        const std::string& now_utc) {
    const ExamContext& exam = result.exam;
    const CourseStanding standing = standing_from(context, exam.course_id, user.id, rows, now_utc);
    if (standing.assignment.id == 0)
        return closed(QT_TRANSLATE_NOOP("Said", "the course is not assigned to this person"));
    const curriculum::CourseStage* stage = standing.course.stage(exam.stage_id);
    if (stage == nullptr || stage->mode != curriculum::StageMode::kExam)
        return closed(QT_TRANSLATE_NOOP("Said", "the course has no such exam stage"));
    const curriculum::StageProgress& own = progress_of(standing, exam.stage_id);
    if (own.status == curriculum::StageStatus::kExhausted)
        return closed(QT_TRANSLATE_NOOP("Said", "all attempts are used"));
    if (result.header.task_id != stage->task_id || result.header.seed != own.next_seed)
        return closed(QT_TRANSLATE_NOOP("Said", "another case is due by now"));
    return std::nullopt;
}

/// Of an exam that was not begun here.
std::optional<VoidReason> import_doubt(StoreContext& context, const UserRecord& user, bool proctor,
                                       const AttemptResult& result) {
    const bool believed = vouched(context, user, proctor);
    if (result.exam.begin != 0 || result.order || (proctor && !believed))
        return closed(QT_TRANSLATE_NOOP("Said", "it was not begun here, or is saved already"));
    if (believed) return std::nullopt;
    return closed(QT_TRANSLATE_NOOP("Said",
                                    "it was not begun here, and neither a proctor nor an "
                                    "administrator vouches for it"));
}

/// The client's clock decides on dates and on whether a skill is fresh, so it has to be right.
std::optional<VoidReason> clock_doubt(const AttemptResult& result, const ExamBeginRecord* begin,
                                      const std::string& now_utc) {
    const std::string& said = result.header.started_utc;
    if (said.empty()) return std::nullopt;  // Kept as begun when it was saved.
    const VoidReason wrong{VoidCause::kClock, 0, 0, Said::as_is(said)};
    const auto started = curriculum::utc_seconds(said), now = curriculum::utc_seconds(now_utc);
    if (!started || (now && *started > *now + kClockAllowanceS)) return wrong;
    if (begin == nullptr) return std::nullopt;
    const auto begun = curriculum::utc_seconds(begin->begun_utc);
    const auto length = static_cast<int64_t>(std::clamp(result.end.duration_s, 0.0, 7200.0));
    if (!begun || *started < *begun - kClockAllowanceS ||
        *started > *begun + length + kClockAllowanceS)
        return wrong;
    return std::nullopt;
}

std::optional<VoidReason> version_doubt(const AttemptResult& result, int asked) {
    const int version = result.header.task_version;
    // 0: of an old recording, which is judged by the newest text anyway.
    if (version == 0 || asked == 0 || version == asked) return std::nullopt;
    return VoidReason{VoidCause::kTaskVersion, 0, 0,
                      Said::listed(QT_TRANSLATE_NOOP("Said", "%1 version %2"))
                          .with(result.header.task_id)
                          .with(version)};
}

/// Of practice: a newer version was published before it began. Who keeps an older, laxer one could
/// be scored by that for ever.
std::optional<VoidReason> replaced_version(StoreContext& context, const AttemptResult& result,
                                           const std::string& now_utc) {
    const sim::RecordingHeader& head = result.header;
    // A study asks for what it asks for, and an old recording (0) is judged by the newest anyway.
    if (head.task_version == 0 || !result.study.study.empty()) return std::nullopt;
    // Another station may have a newer Placode; what this one ships is right here.
    const auto shipped = curriculum::shipped_task(head.task_id);
    if (shipped && shipped->version == head.task_version) return std::nullopt;
    const auto began =
        curriculum::utc_seconds(head.started_utc.empty() ? now_utc : head.started_utc);
    if (!began) return std::nullopt;
    Statement newer(context.connection,
                    "SELECT version, published_utc FROM definitions WHERE kind = 'task' AND id = ? "
                    "AND version > ? ORDER BY version DESC");
    newer.run(head.task_id, head.task_version);
    while (newer.next()) {
        const auto published = curriculum::utc_seconds(newer.text("published_utc"));
        if (published && *began > *published + kClockAllowanceS)
            return VoidReason{VoidCause::kTaskDiffers, 0, 0,
                              Said::listed(QT_TRANSLATE_NOOP("Said", "%1 version %2"))
                                  .with(head.task_id)
                                  .with(static_cast<int>(newer.integer("version")))};
    }
    return std::nullopt;
}

const ExamBeginRecord* begin_in(const CourseRows& rows, const ExamContext& exam) {
    const auto found =
        std::find_if(rows.begins.begin(), rows.begins.end(), [&](const ExamBeginRecord& each) {
            return each.id == exam.begin && each.course_id == exam.course_id &&
                   each.stage_id == exam.stage_id && each.attempt_id == 0;
        });
    return found == rows.begins.end() ? nullptr : &*found;
}

void add(ExamCheck& check, const std::optional<VoidReason>& doubt) {
    if (doubt) check.doubts.push_back(*doubt);
}

}  // namespace

ExamCheck check_exam(StoreContext& context, const UserRecord& user, const AttemptResult& result) {
    ExamCheck check;
    const bool own = own_word(context, user, result);
    const std::string now = clock_of_store(context.connection);
    if (result.exam.course_id.empty()) {
        if (own) add(check, clock_doubt(result, nullptr, now));
        add(check, replaced_version(context, result, now));
        return check;
    }
    lock_exams(context.connection, user.id);
    const CourseRows rows = course_rows(context, user);
    const ExamBeginRecord* begin = begin_in(rows, result.exam);
    const Proctor proctor = proctor_of(context, user, result.exam, begin);
    check.begin = begin != nullptr ? begin->id : 0;
    check.proctor = proctor.kept;
    if (!proctor.kept.empty() && !proctor.may_be)
        check.doubts.push_back({VoidCause::kProctor, 0, 0, {}});
    std::optional<VoidReason> shut;
    if (begin != nullptr)
        shut = other_case(result, *begin);
    else
        shut = import_doubt(context, user, proctor.may_be, result);
    if (begin == nullptr && !shut) shut = closed_by_now(context, user, result, rows, now);
    add(check, shut);
    if (own || begin != nullptr) add(check, clock_doubt(result, begin, now));
    add(check, version_doubt(result, begin != nullptr
                                         ? begin->task_version
                                         : newest_task_version(context, result.header.task_id)));
    return check;
}

}  // namespace placode::db
