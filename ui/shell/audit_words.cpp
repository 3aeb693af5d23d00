// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/audit_words.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>

namespace placode::ui {
namespace {

struct Words {
    std::string_view action;
    const char* english;
};

// By code, for the binary search.
constexpr auto kWords = std::to_array<Words>({
    {"attempt.import", QT_TRANSLATE_NOOP("AuditWords", "imported an attempt")},
    {"attempt.rescore", QT_TRANSLATE_NOOP("AuditWords", "scored an attempt again")},
    {"attempt.save", QT_TRANSLATE_NOOP("AuditWords", "saved an attempt")},
    {"attempt.void", QT_TRANSLATE_NOOP("AuditWords", "declared an attempt void")},
    {"comment.add", QT_TRANSLATE_NOOP("AuditWords", "wrote a comment")},
    {"comment.remove", QT_TRANSLATE_NOOP("AuditWords", "removed a comment")},
    {"comment.restore", QT_TRANSLATE_NOOP("AuditWords", "brought a comment back")},
    {"consent_seal.publish", QT_TRANSLATE_NOOP("AuditWords", "sealed a consent form")},
    {"course.assign", QT_TRANSLATE_NOOP("AuditWords", "assigned a course")},
    {"course.certificate", QT_TRANSLATE_NOOP("AuditWords", "issued a certificate")},
    {"course.grant", QT_TRANSLATE_NOOP("AuditWords", "granted more attempts")},
    {"course.publish", QT_TRANSLATE_NOOP("AuditWords", "published a course")},
    {"course.unassign", QT_TRANSLATE_NOOP("AuditWords", "took a course back")},
    {"exam.begin", QT_TRANSLATE_NOOP("AuditWords", "began an exam")},
    {"export.cohort", QT_TRANSLATE_NOOP("AuditWords", "exported a cohort")},
    {"group.create", QT_TRANSLATE_NOOP("AuditWords", "made a group")},
    {"group.member", QT_TRANSLATE_NOOP("AuditWords", "changed who is in a group")},
    {"norms.export", QT_TRANSLATE_NOOP("AuditWords", "exported a norm pack")},
    {"norms.keep", QT_TRANSLATE_NOOP("AuditWords", "took in a norm pack")},
    {"norms.key", QT_TRANSLATE_NOOP("AuditWords", "made the centre's signing key")},
    {"norms.trust", QT_TRANSLATE_NOOP("AuditWords", "trusted another centre's key")},
    {"norms.use", QT_TRANSLATE_NOOP("AuditWords", "put a norm pack to use")},
    {"questionnaire.publish", QT_TRANSLATE_NOOP("AuditWords", "published a questionnaire")},
    {"rating.save", QT_TRANSLATE_NOOP("AuditWords", "rated an attempt")},
    {"recording.delete", QT_TRANSLATE_NOOP("AuditWords", "deleted a recovered recording")},
    {"report.cohort", QT_TRANSLATE_NOOP("AuditWords", "wrote a cohort's report")},
    {"report.figures", QT_TRANSLATE_NOOP("AuditWords", "wrote a study's figures")},
    {"report.pdf", QT_TRANSLATE_NOOP("AuditWords", "wrote an attempt's report")},
    {"report.study", QT_TRANSLATE_NOOP("AuditWords", "wrote a study's report")},
    {"report.trainee", QT_TRANSLATE_NOOP("AuditWords", "wrote a trainee's report")},
    {"rubric.publish", QT_TRANSLATE_NOOP("AuditWords", "published a rubric")},
    {"session.lock", QT_TRANSLATE_NOOP("AuditWords", "locked the station")},
    {"sign_in", QT_TRANSLATE_NOOP("AuditWords", "signed in")},
    {"sign_in.deactivated",
     QT_TRANSLATE_NOOP("AuditWords", "tried to sign in to a deactivated account")},
    {"sign_in.pin", QT_TRANSLATE_NOOP("AuditWords", "came back with the PIN")},
    {"sign_in.wrong_password", QT_TRANSLATE_NOOP("AuditWords", "wrong password")},
    {"sign_in.wrong_pin", QT_TRANSLATE_NOOP("AuditWords", "wrong PIN")},
    {"standard.publish", QT_TRANSLATE_NOOP("AuditWords", "set a pass mark")},
    {"station.save", QT_TRANSLATE_NOOP("AuditWords", "saved the station's devices")},
    {"store.backup", QT_TRANSLATE_NOOP("AuditWords", "made a backup")},
    {"store.restore", QT_TRANSLATE_NOOP("AuditWords", "restored a backup")},
    {"study.answers", QT_TRANSLATE_NOOP("AuditWords", "saved a questionnaire's answers")},
    {"study.consent.signature", QT_TRANSLATE_NOOP("AuditWords", "saved a signed consent")},
    {"study.consent.signature.show",
     QT_TRANSLATE_NOOP("AuditWords", "looked at a consent's signature")},
    {"study.correct", QT_TRANSLATE_NOOP("AuditWords", "corrected an answer")},
    {"study.key.make", QT_TRANSLATE_NOOP("AuditWords", "made a study's key of names")},
    {"study.key.name", QT_TRANSLATE_NOOP("AuditWords", "named a participant in the key")},
    {"study.key.open", QT_TRANSLATE_NOOP("AuditWords", "opened a study's key of names")},
    {"study.participant", QT_TRANSLATE_NOOP("AuditWords", "took in a participant")},
    {"study.publish", QT_TRANSLATE_NOOP("AuditWords", "published a protocol")},
    {"study.record.locked", QT_TRANSLATE_NOOP("AuditWords", "locked a participant's record")},
    {"study.record.signed", QT_TRANSLATE_NOOP("AuditWords", "signed a participant's record")},
    {"study.record.unlocked", QT_TRANSLATE_NOOP("AuditWords", "unlocked a participant's record")},
    {"study.second_entry",
     QT_TRANSLATE_NOOP("AuditWords", "entered a questionnaire a second time")},
    {"study.step", QT_TRANSLATE_NOOP("AuditWords", "went through a step of a protocol")},
    {"study.withdraw", QT_TRANSLATE_NOOP("AuditWords", "withdrew a participant")},
    {"user.activate", QT_TRANSLATE_NOOP("AuditWords", "activated an account")},
    {"user.ask_erasure", QT_TRANSLATE_NOOP("AuditWords", "asked for erasure")},
    {"user.create", QT_TRANSLATE_NOOP("AuditWords", "created an account")},
    {"user.data", QT_TRANSLATE_NOOP("AuditWords", "took a copy of the own data")},
    {"user.deactivate", QT_TRANSLATE_NOOP("AuditWords", "deactivated an account")},
    {"user.erase", QT_TRANSLATE_NOOP("AuditWords", "erased a person")},
    {"user.invite", QT_TRANSLATE_NOOP("AuditWords", "invited somebody")},
    {"user.invited", QT_TRANSLATE_NOOP("AuditWords", "followed an invitation")},
    {"user.password", QT_TRANSLATE_NOOP("AuditWords", "changed a password")},
    {"user.pin", QT_TRANSLATE_NOOP("AuditWords", "set a PIN")},
    {"user.pin_removed", QT_TRANSLATE_NOOP("AuditWords", "removed the PIN")},
});
static_assert(std::ranges::is_sorted(kWords, {}, &Words::action));

// What ends in a format, an analysis or an act: it stands in the sentence.
constexpr auto kBeginnings = std::to_array<Words>({
    {"export.", QT_TRANSLATE_NOOP("AuditWords", "exported a study as %1")},
    {"report.", QT_TRANSLATE_NOOP("AuditWords", "wrote the analysis %1")},
    {"study.key.", QT_TRANSLATE_NOOP("AuditWords", "used a study's key of names: %1")},
});

QString translated(const char* english) {
    return QCoreApplication::translate("AuditWords", english);
}

QString text_of(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

}  // namespace

QString audit_words(std::string_view action) {
    const auto* known = std::ranges::lower_bound(kWords, action, {}, &Words::action);
    if (known != kWords.end() && known->action == action) return translated(known->english);
    for (const Words& beginning : kBeginnings) {
        if (action.starts_with(beginning.action) && action.size() > beginning.action.size()) {
            return translated(beginning.english)
                .arg(text_of(action.substr(beginning.action.size())));
        }
    }
    return text_of(action);
}

}  // namespace placode::ui
