// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/attempt_doubts.h"

#include <QtGlobal>

#include "db/attempt_rows.h"
#include "db/audit_check.h"
#include "db/recording_file.h"
#include "db/recording_order.h"
#include "db/recording_seal.h"
#include "db/store_context.h"

namespace placode::db {
namespace {

/// The first attempt with the same bytes, or with the same end of the same case: no two people move
/// alike to the last bit. Scripts do, and say that they are scripts.
std::optional<int64_t> same_recording(Connection& connection, const sim::RecordingHeader& header,
                                      const sim::RecordingEnd& its_end,
                                      const std::string& checksum) {
    if (const auto same = attempt_with(connection, checksum)) return same;
    if (header.demonstration || its_end.final_hash == 0) return std::nullopt;
    const bool guarded = connection.hides_passwords();
    Statement end(connection,
                  guarded ? "SELECT id FROM placode_guard.attempt_ending(?, ?, ?)"
                          : "SELECT id FROM attempts WHERE final_hash = ? AND task_id = ? AND "
                            "seed = ? AND demonstration = 0 ORDER BY id");
    end.run(std::to_string(its_end.final_hash), header.task_id, std::to_string(header.seed));
    if (end.next()) return end.integer(0);
    return std::nullopt;
}

/// What may count for a person, a study or a norm. A demonstration does not pretend to.
bool needs_signature(bool demonstration, sim::EndReason end, bool matters) {
    if (end == sim::EndReason::kInterrupted) return false;  // broke off before its end
    return !demonstration || matters;
}

/// "" when a computer of this store signed the recording; else the fingerprint of who did, or
/// kNobody.
std::string unknown_signer(StoreContext& context, const std::string& recording_file) {
    const RecordingSeal seal = recording_seal(recording_file);
    if (seal.signature != RecordingSignature::kRight) return kNobody;
    return is_trusted_station(context, seal.station) ? "" : fingerprint(seal.station);
}

/// The recording says itself that it was made as an exam or for a study, whatever is said later.
bool was_to_matter(const AttemptResult& result) {
    return matters(result) || result.header.mode != "practice";
}

}  // namespace

std::optional<int64_t> attempt_with(Connection& connection, const std::string& checksum) {
    const bool guarded = connection.hides_passwords();
    Statement query(connection,
                    guarded ? "SELECT attempt_id FROM placode_guard.attempt_with(?)"
                            : "SELECT attempt_id FROM recordings WHERE checksum = ? ORDER BY "
                              "attempt_id");
    if (!query.run(checksum).next()) return std::nullopt;
    return query.integer(0);
}

bool matters(const AttemptResult& result) noexcept {
    return !result.exam.course_id.empty() || !result.study.study.empty();
}

std::vector<VoidReason> doubts_in_store(StoreContext& context, const UserRecord& user,
                                        const AttemptResult& result, const std::string& checksum) {
    std::vector<VoidReason> doubts;
    // A script that passes an exam passes it for nobody but an account that shows how it is done.
    // Other demonstrations are void wherever they are read (only_shows, db/attempt_rows.h).
    if (!result.exam.course_id.empty() && result.header.demonstration && !user.demonstration)
        doubts.push_back(shown_by(result.header.device));
    if (checksum.empty()) {
        // Nothing that could be simulated again.
        if (matters(result)) doubts.push_back({VoidCause::kNoRecording, 0, 0, {}});
        return doubts;
    }
    if (result.order)
        if (const auto cause =
                order_doubt(result.recording_file, *result.order, was_to_matter(result)))
            doubts.push_back({*cause, 0, 0, {}});
    if (needs_signature(result.header.demonstration, result.end.reason, matters(result)))
        if (const std::string who = unknown_signer(context, result.recording_file); !who.empty())
            doubts.push_back({VoidCause::kUnsigned, 0, 0, Said::as_is(who)});
    if (const auto same = same_recording(context.connection, result.header, result.end, checksum))
        doubts.push_back({VoidCause::kSameRecording, 0, 0, Said::as_is(std::to_string(*same))});
    return doubts;
}

std::optional<Said> doubt_in_store(StoreContext& context, int64_t attempt_id,
                                   const std::string& recording_file) {
    const RecordingSummary recorded = recording_summary(recording_file);
    std::string checksum, final_hash;
    bool matters = false;
    {
        Statement query(context.connection,
                        "SELECT r.checksum, a.final_hash, CASE WHEN a.exam_course <> '' OR "
                        "a.exam_begin <> 0 OR a.study <> '' THEN 1 ELSE 0 END AS matters FROM "
                        "attempts a JOIN recordings r ON r.attempt_id = a.id WHERE a.id = ?");
        if (!query.run(attempt_id).next())
            context.connection.fail(
                StoreError::Kind::kNotFound,
                "there is no recording of attempt " + std::to_string(attempt_id));
        checksum = query.text("checksum");
        final_hash = query.text("final_hash");
        matters = query.integer("matters") != 0;
    }
    if (final_hash != std::to_string(recorded.end.final_hash))
        return Said::listed(QT_TRANSLATE_NOOP("Said",
                                              "the store holds something else than the recording "
                                              "(%1)"))
            .with("final_hash");
    if (needs_signature(recorded.header.demonstration, recorded.end.reason, matters) &&
        !unknown_signer(context, recording_file).empty())
        return Said::listed(
            QT_TRANSLATE_NOOP("Said", "no computer of this store signed its recording"));
    const auto first = same_recording(context.connection, recorded.header, recorded.end, checksum);
    if (first && *first < attempt_id)
        return Said::listed(QT_TRANSLATE_NOOP("Said", "its recording is that of attempt %1"))
            .with(*first);
    return std::nullopt;
}

}  // namespace placode::db
