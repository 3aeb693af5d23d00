// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/haptic_verdict.h"

#include <QtGlobal>
#include <exception>

#include "db/recording_file.h"
#include "db/store_error.h"
#include "haptics/certificate.h"

namespace placode::db {

HapticVerdict haptic_verdict(const AttemptResult& result) {
    HapticVerdict out;
    std::vector<VoidReason> reasons;
    const auto unreadable = [&] {
        out.grade = haptics::grade_name(haptics::CertificateGrade::kBad);
        reasons = {{VoidCause::kDevice, 0, 0,
                    Said::listed(QT_TRANSLATE_NOOP(
                        "Said", "the haptic certificate of the recording cannot be read"))}};
    };
    try {
        out.certificate = result.haptic_certificate;
        if (out.certificate.empty() && !result.recording_file.empty())
            out.certificate = haptic_certificate(result.recording_file);
        if (out.certificate.empty()) return out;
        // Judged anew by the limits of today, not by what the file says of itself.
        const auto verdict = haptics::judge(haptics::certificate_from_json(out.certificate));
        out.grade = haptics::grade_name(verdict.grade);
        if (verdict.grade != haptics::CertificateGrade::kBad) return out;
        for (const Said& reason : verdict.reasons)
            reasons.push_back({VoidCause::kDevice, 0, 0, reason});
    } catch (const StoreError& error) {
        if (may_pass(error)) throw;
        unreadable();
    } catch (const std::exception&) {
        unreadable();
    }
    if (!result.exam.course_id.empty()) out.voids = reasons;
    return out;
}

}  // namespace placode::db
