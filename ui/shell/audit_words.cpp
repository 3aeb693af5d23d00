// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/audit_words.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <algorithm>
#include <array>

#include "ui/shell/parts.h"

namespace placode::ui {
namespace {

struct Words {
    std::string_view action;
    const char* english;
};

// By code, for the binary search.
constexpr auto kWords = std::to_array<Words>({
    {"attempt.import", QT_TRANSLATE_NOOP("AuditWords", "imported an attempt")},
    {"attempt.replay",
     QT_TRANSLATE_NOOP("AuditWords", "simulated an attempt again, with the same outcome")},
    {"attempt.replay_differs",
     QT_TRANSLATE_NOOP("AuditWords", "simulated an attempt again, with another outcome")},
    {"attempt.replay_reset",
     QT_TRANSLATE_NOOP("AuditWords", "put an attempt back to be simulated again")},
    {"attempt.rescore", QT_TRANSLATE_NOOP("AuditWords", "scored an attempt again")},
    {"attempt.save", QT_TRANSLATE_NOOP("AuditWords", "saved an attempt")},
    {"attempt.void", QT_TRANSLATE_NOOP("AuditWords", "declared an attempt void")},
    {"audit.set_aside", QT_TRANSLATE_NOOP("AuditWords", "set an entry aside that does not fit")},
    {"audit.set_aside.why", QT_TRANSLATE_NOOP("AuditWords", "said why an entry was set aside")},
    {"backup.daily.off", QT_TRANSLATE_NOOP("AuditWords", "switched the daily backup off")},
    {"backup.daily.on", QT_TRANSLATE_NOOP("AuditWords", "switched the daily backup on")},
    {"batch.extract", QT_TRANSLATE_NOOP("AuditWords", "took recordings out for a batch")},
    {"batch.queue", QT_TRANSLATE_NOOP("AuditWords", "queued a batch for idle stations")},
    {"batch.unqueue", QT_TRANSLATE_NOOP("AuditWords", "took a batch out of the queue")},
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
    {"lti.grades", QT_TRANSLATE_NOOP("AuditWords", "sent scores to a learning platform")},
    {"lti.link", QT_TRANSLATE_NOOP("AuditWords", "linked a person with a learning platform")},
    {"lti.unlink", QT_TRANSLATE_NOOP("AuditWords", "took back a link with a learning platform")},
    {"norms.export", QT_TRANSLATE_NOOP("AuditWords", "exported a norm pack")},
    {"norms.keep", QT_TRANSLATE_NOOP("AuditWords", "took in a norm pack")},
    {"norms.key", QT_TRANSLATE_NOOP("AuditWords", "made the centre's signing key")},
    {"norms.key.export", QT_TRANSLATE_NOOP("AuditWords", "exported the centre's sealed key")},
    {"norms.key.import", QT_TRANSLATE_NOOP("AuditWords", "took in a key of the centre")},
    {"norms.key.passphrase",
     QT_TRANSLATE_NOOP("AuditWords", "changed the passphrase of the centre's key")},
    {"norms.key.renew", QT_TRANSLATE_NOOP("AuditWords", "made a new key of the centre")},
    {"norms.key.seal", QT_TRANSLATE_NOOP("AuditWords", "put the centre's key under a passphrase")},
    {"norms.trust", QT_TRANSLATE_NOOP("AuditWords", "trusted another centre's key")},
    {"norms.use", QT_TRANSLATE_NOOP("AuditWords", "put a norm pack to use")},
    {"questionnaire.publish", QT_TRANSLATE_NOOP("AuditWords", "published a questionnaire")},
    {"rating.save", QT_TRANSLATE_NOOP("AuditWords", "rated an attempt")},
    {"recording.copy", QT_TRANSLATE_NOOP("AuditWords", "copied a recovered recording elsewhere")},
    {"recording.delete", QT_TRANSLATE_NOOP("AuditWords", "deleted a recovered recording")},
    {"report.certificate", QT_TRANSLATE_NOOP("AuditWords", "wrote a certificate")},
    {"report.cohort", QT_TRANSLATE_NOOP("AuditWords", "wrote a cohort's report")},
    {"report.figures", QT_TRANSLATE_NOOP("AuditWords", "wrote a study's figures")},
    {"report.pdf", QT_TRANSLATE_NOOP("AuditWords", "wrote an attempt's report")},
    {"report.seal", QT_TRANSLATE_NOOP("AuditWords", "wrote the seal of an attempt")},
    {"report.study", QT_TRANSLATE_NOOP("AuditWords", "wrote a study's report")},
    {"report.trainee", QT_TRANSLATE_NOOP("AuditWords", "wrote a trainee's report")},
    {"rubric.publish", QT_TRANSLATE_NOOP("AuditWords", "published a rubric")},
    {"session.lock", QT_TRANSLATE_NOOP("AuditWords", "locked the station")},
    {"session.take_back",
     QT_TRANSLATE_NOOP("AuditWords", "took the screen back from a participant")},
    {"sign_in", QT_TRANSLATE_NOOP("AuditWords", "signed in")},
    {"sign_in.deactivated",
     QT_TRANSLATE_NOOP("AuditWords", "tried to sign in to a deactivated account")},
    {"sign_in.local_profile", QT_TRANSLATE_NOOP("AuditWords", "came in without a password")},
    {"sign_in.pin", QT_TRANSLATE_NOOP("AuditWords", "came back with the PIN")},
    {"sign_in.unknown",
     QT_TRANSLATE_NOOP("AuditWords", "tried to sign in with a log-in that nobody has")},
    {"sign_in.wrong_password", QT_TRANSLATE_NOOP("AuditWords", "wrong password")},
    {"sign_in.wrong_pin", QT_TRANSLATE_NOOP("AuditWords", "wrong PIN")},
    {"standard.publish", QT_TRANSLATE_NOOP("AuditWords", "set a pass mark")},
    {"station.save", QT_TRANSLATE_NOOP("AuditWords", "saved the station's devices")},
    {"station.trust", QT_TRANSLATE_NOOP("AuditWords", "trusted a station")},
    {"store.backup", QT_TRANSLATE_NOOP("AuditWords", "made a backup")},
    {"store.move", QT_TRANSLATE_NOOP("AuditWords", "moved the store")},
    {"store.restore", QT_TRANSLATE_NOOP("AuditWords", "restored a backup")},
    {"store.restore.doubt",
     QT_TRANSLATE_NOOP("AuditWords", "erased nobody on the word of an entry that is not proved")},
    {"store.seal", QT_TRANSLATE_NOOP("AuditWords", "sealed what was there")},
    {"study.answers", QT_TRANSLATE_NOOP("AuditWords", "saved a questionnaire's answers")},
    {"study.consent.signature", QT_TRANSLATE_NOOP("AuditWords", "saved a signed consent")},
    {"study.consent.signature.show",
     QT_TRANSLATE_NOOP("AuditWords", "looked at a consent's signature")},
    {"study.correct", QT_TRANSLATE_NOOP("AuditWords", "corrected an answer")},
    {"study.device", QT_TRANSLATE_NOOP("AuditWords", "chose a participant's device")},
    {"study.key.make", QT_TRANSLATE_NOOP("AuditWords", "made a study's key of names")},
    {"study.key.name", QT_TRANSLATE_NOOP("AuditWords", "named a participant in the key")},
    {"study.key.open", QT_TRANSLATE_NOOP("AuditWords", "opened a study's key of names")},
    {"study.note", QT_TRANSLATE_NOOP("AuditWords", "noted something on a step")},
    {"study.participant", QT_TRANSLATE_NOOP("AuditWords", "took in a participant")},
    {"study.publish", QT_TRANSLATE_NOOP("AuditWords", "published a protocol")},
    {"study.record.locked", QT_TRANSLATE_NOOP("AuditWords", "locked a participant's record")},
    {"study.record.signed", QT_TRANSLATE_NOOP("AuditWords", "signed a participant's record")},
    {"study.record.unlocked", QT_TRANSLATE_NOOP("AuditWords", "unlocked a participant's record")},
    {"study.repeat", QT_TRANSLATE_NOOP("AuditWords", "had a procedure done again")},
    {"study.retention",
     QT_TRANSLATE_NOOP("AuditWords", "erased records that had been kept long enough")},
    {"study.second_entry",
     QT_TRANSLATE_NOOP("AuditWords", "entered a questionnaire a second time")},
    {"study.step", QT_TRANSLATE_NOOP("AuditWords", "went through a step of a protocol")},
    {"study.withdraw", QT_TRANSLATE_NOOP("AuditWords", "withdrew a participant")},
    {"task.publish", QT_TRANSLATE_NOOP("AuditWords", "published a task")},
    {"user.activate", QT_TRANSLATE_NOOP("AuditWords", "activated an account")},
    {"user.ask_erasure", QT_TRANSLATE_NOOP("AuditWords", "asked for erasure")},
    {"user.create", QT_TRANSLATE_NOOP("AuditWords", "created an account")},
    {"user.data", QT_TRANSLATE_NOOP("AuditWords", "took a copy of the own data")},
    {"user.deactivate", QT_TRANSLATE_NOOP("AuditWords", "deactivated an account")},
    {"user.erase", QT_TRANSLATE_NOOP("AuditWords", "erased a person")},
    {"user.invite", QT_TRANSLATE_NOOP("AuditWords", "invited somebody")},
    {"user.invited", QT_TRANSLATE_NOOP("AuditWords", "followed an invitation")},
    {"user.named", QT_TRANSLATE_NOOP("AuditWords", "made an account of the local profile")},
    {"user.password", QT_TRANSLATE_NOOP("AuditWords", "changed a password")},
    {"user.pin", QT_TRANSLATE_NOOP("AuditWords", "set a PIN")},
    {"user.pin_removed", QT_TRANSLATE_NOOP("AuditWords", "removed the PIN")},
    {"user.roles", QT_TRANSLATE_NOOP("AuditWords", "changed the roles of a person")},
    {"xapi.send", QT_TRANSLATE_NOOP("AuditWords", "sent statements to a learning record store")},
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

// What is counted: "attempt 12".
constexpr auto kCounted = std::to_array<Words>({
    {"assignment", QT_TRANSLATE_NOOP("AuditWords", "assignment %1")},
    {"attempt", QT_TRANSLATE_NOOP("AuditWords", "attempt %1")},
    {"comment", QT_TRANSLATE_NOOP("AuditWords", "comment %1")},
    {"group", QT_TRANSLATE_NOOP("AuditWords", "group %1")},
    {"invitation", QT_TRANSLATE_NOOP("AuditWords", "invitation %1")},
    {"norm pack", QT_TRANSLATE_NOOP("AuditWords", "norm pack %1")},
    {"user", QT_TRANSLATE_NOOP("AuditWords", "person %1")},
});

// A detail that is one word of the store's own.
constexpr auto kDetails = std::to_array<Words>({
    {"attempts stay without a name",
     QT_TRANSLATE_NOOP("AuditWords", "attempts stay without a name")},
    {"cohort", QT_TRANSLATE_NOOP("AuditWords", "everybody")},
    {"educator", QT_TRANSLATE_NOOP("AuditWords", "educator")},
    {"member", QT_TRANSLATE_NOOP("AuditWords", "member")},
    {"out", QT_TRANSLATE_NOOP("AuditWords", "not in the group any more")},
    {"with attempts", QT_TRANSLATE_NOOP("AuditWords", "with attempts")},
});

QString counted(const QString& kind, const QString& number, const AuditNames& names) {
    const auto& known = kind == "group" ? names.groups : names.people;
    const auto found = known.find(number.toLongLong());
    if ((kind == "user" || kind == "group") && found != known.end()) return found->second;
    for (const Words& each : kCounted)
        if (kind == text_of(each.action)) return translated(each.english).arg(number);
    return kind + ' ' + number;
}

QString title_of(const QString& id, const AuditNames& names) {
    const auto found = names.titles.find(id);
    return found == names.titles.end() ? id : found->second;
}

/// In a sentence, such as the reason for a grant.
QString with_people(const QString& text, const AuditNames& names) {
    static const QRegularExpression kUser("user (\\d+)");
    QString shown;
    qsizetype from = 0;
    for (auto found = kUser.globalMatch(text); found.hasNext();) {
        const QRegularExpressionMatch one = found.next();
        shown += text.mid(from, one.capturedStart() - from);
        shown += counted(QStringLiteral("user"), one.captured(1), names);
        from = one.capturedEnd();
    }
    return shown + text.mid(from);
}

}  // namespace

QString audit_thing(const QString& text, const AuditNames& names) {
    static const QRegularExpression kNumbers(
        "^((assignment|attempt|comment|group|invitation|norm pack|user) \\d+ ?)+$"),
        kNumber("(assignment|attempt|comment|group|invitation|norm pack|user) (\\d+)"),
        kRoles("^roles (\\d+)(?: -> (\\d+))?$"), kVersion("^(\\S+) version (\\d+)( code (\\S+))?$"),
        kStudy("^study (\\S+)$"), kFirst("^(\\S+) (?:of )?(.+)$");
    for (const Words& each : kDetails)
        if (text == text_of(each.action)) return translated(each.english);
    if (kNumbers.match(text).hasMatch()) {
        QStringList parts;
        for (auto found = kNumber.globalMatch(text); found.hasNext();) {
            const QRegularExpressionMatch one = found.next();
            parts << counted(one.captured(1), one.captured(2), names);
        }
        return parts.join(" · ");
    }
    if (const auto roles = kRoles.match(text); roles.hasMatch()) {
        const auto named = [&](int part) {
            return role_names(static_cast<db::Roles>(roles.captured(part).toUInt()));
        };
        return roles.captured(2).isEmpty() ? named(1) : named(1) + " → " + named(2);
    }
    if (const auto version = kVersion.match(text); version.hasMatch()) {
        QString words = translated(QT_TRANSLATE_NOOP("AuditWords", "%1, version %2"))
                            .arg(title_of(version.captured(1), names), version.captured(2));
        if (!version.captured(4).isEmpty()) words += " · " + version.captured(4);
        return words;
    }
    static const QRegularExpression kProctor("^proctor (user \\d+)$");
    if (const auto proctor = kProctor.match(text); proctor.hasMatch())
        return translated(QT_TRANSLATE_NOOP("AuditWords", "proctor %1"))
            .arg(with_people(proctor.captured(1), names));
    if (const auto study = kStudy.match(text); study.hasMatch())
        return title_of(study.captured(1), names);
    const auto first = kFirst.match(text);
    if (first.hasMatch() && names.titles.contains(first.captured(1)))
        return title_of(first.captured(1), names) + " · " + with_people(first.captured(2), names);
    return with_people(title_of(text, names), names);
}

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
