// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Whether anything may be recorded of a participant.

#include "curriculum/study.h"
#include "db/store_context.h"

namespace placode::db {

using Kind = StoreError::Kind;

void StoreContext::need_participant(const std::string& study_id, const std::string& code) {
    Statement there(connection, "SELECT number FROM participants WHERE study_id = ? AND code = ?");
    if (!there.run(study_id, code).next())
        connection.fail(Kind::kNotFound,
                        Said::that("the study \"%1\" has no participant \"%2\"; check the code")
                            .with(study_id)
                            .with(code));
}

void StoreContext::need_active_participant(const std::string& study_id, const std::string& code,
                                           const std::string& step) {
    Statement participant(
        connection,
        "SELECT COALESCE(s.protocol_version, 0) AS version, w.mode FROM participants p "
        "LEFT JOIN participant_states s ON s.study_id = p.study_id AND s.code = "
        "p.code LEFT JOIN withdrawals w ON w.study_id = p.study_id AND w.code = "
        "p.code WHERE p.study_id = ? AND p.code = ?");
    if (!participant.run(study_id, code).next())
        connection.fail(Kind::kNotFound,
                        Said::that("the study \"%1\" has no participant \"%2\"; check the code")
                            .with(study_id)
                            .with(code));
    const int version = static_cast<int>(participant.integer("version"));
    if (const std::string mode = participant.text("mode"); !mode.empty())
        connection.fail(
            Kind::kRefused,
            Said::that("%1 has withdrawn (%2); nothing more is recorded").with(code).with(mode));
    need_unlocked(study_id, code);
    if (version == 0) return;
    const auto published = find_definition("study", study_id, version);
    if (!published) return;
    const auto protocol = curriculum::load_study_text(published->json, "study " + study_id);
    if (!protocol.needs_consent()) return;
    if (const auto* asked = protocol.step(step);
        asked != nullptr && asked->kind == curriculum::StepKind::kConsent)
        return;
    for (const auto& each : protocol.steps) {
        if (each.kind != curriculum::StepKind::kConsent) continue;
        Statement consent(connection,
                          "SELECT id FROM study_steps WHERE study_id = ? AND code = ? AND step = ? "
                          "AND state = 'done'");
        if (!consent.run(study_id, code, each.id).next())
            connection.fail(Kind::kRefused,
                            Said::that("%1 has not consented; record the step \"%2\" first")
                                .with(code)
                                .with(each.id));
    }
}

bool StoreContext::is_locked(const std::string& study_id, const std::string& code) {
    Statement query(connection,
                    "SELECT event FROM record_events WHERE study_id = ? AND code = ? ORDER BY id "
                    "DESC LIMIT 1");
    query.run(study_id, code);
    return query.next() && query.text(0) != "unlocked";
}

void StoreContext::need_unlocked(const std::string& study_id, const std::string& code) {
    if (is_locked(study_id, code))
        connection.fail(Kind::kRefused, Said::that("the record of %1 is locked; unlock it with a "
                                                   "reason first, which cancels its signature")
                                            .with(code));
}

}  // namespace placode::db
