// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What the store refuses and why, in the reader's language. The store writes English sentences for
// scripts and logs ("create a user in sqlite:/x: the login is taken; choose another one"); here
// stand all that a person at the shell can meet, and a test finds the ones that are missing.

#include <QCoreApplication>
#include <QRegularExpression>
#include <algorithm>
#include <vector>

#include "ui/shell/messages.h"

namespace placode::ui {
namespace {

/// Sentences of the store; %1 to %3 stand for what varies.
constexpr const char* kSentences[]{
    // Accounts, PIN, invitations, erasure
    QT_TRANSLATE_NOOP("StoreWords", "the login is taken; choose another one"),
    QT_TRANSLATE_NOOP("StoreWords", "the login is empty"),
    QT_TRANSLATE_NOOP("StoreWords", "the name is empty"),
    QT_TRANSLATE_NOOP("StoreWords", "the user has no role"),
    QT_TRANSLATE_NOOP("StoreWords", "the length of the password is %1; it needs at least %2"),
    QT_TRANSLATE_NOOP("StoreWords", "the password is longer than %1 characters"),
    QT_TRANSLATE_NOOP("StoreWords", "the password is the login; choose another one"),
    QT_TRANSLATE_NOOP("StoreWords", "a PIN has four to twelve digits"),
    QT_TRANSLATE_NOOP("StoreWords",
                      "all digits the same, or in a row, is the first that somebody tries"),
    QT_TRANSLATE_NOOP("StoreWords",
                      "\"%1\" is the last active administrator; make another one first"),
    QT_TRANSLATE_NOOP("StoreWords", "the code is wrong or was used; ask for another one"),
    QT_TRANSLATE_NOOP("StoreWords", "the invitation ended on %1; ask for another one"),
    QT_TRANSLATE_NOOP("StoreWords", "the invitation has no role"),
    QT_TRANSLATE_NOOP("StoreWords",
                      "found the date \"%1\"; an invitation needs a last day, such as %2"),
    QT_TRANSLATE_NOOP("StoreWords", "erasure was asked for already"),
    QT_TRANSLATE_NOOP("StoreWords", "there is an account already; sign in to it"),
    QT_TRANSLATE_NOOP("StoreWords", "on a server everybody has an account and a password"),
    QT_TRANSLATE_NOOP("StoreWords", "there is no profile without a password here"),
    QT_TRANSLATE_NOOP("StoreWords",
                      "this store is one person's without a password; make an account of that "
                      "profile first"),
    // Groups, courses, exams, certificates
    QT_TRANSLATE_NOOP("StoreWords", "there is a group of this name; choose another one"),
    QT_TRANSLATE_NOOP("StoreWords", "found the date \"%1\"; expected a day such as %2"),
    QT_TRANSLATE_NOOP("StoreWords", "the course is due before it begins"),
    QT_TRANSLATE_NOOP("StoreWords", "a course is assigned to a person or to a group"),
    QT_TRANSLATE_NOOP("StoreWords", "version %1 is not published; publish it first"),
    QT_TRANSLATE_NOOP("StoreWords", "it is assigned already (assignment %1); end that one first"),
    QT_TRANSLATE_NOOP("StoreWords", "it ended at %1"),
    QT_TRANSLATE_NOOP("StoreWords", "found %1; expected 1 to 1000"),
    QT_TRANSLATE_NOOP("StoreWords", "a grant needs a reason"),
    QT_TRANSLATE_NOOP("StoreWords", "the course has no such exam stage"),
    QT_TRANSLATE_NOOP("StoreWords", "the course is not assigned to this person"),
    QT_TRANSLATE_NOOP("StoreWords", "locked; to be mastered first: %1"),
    QT_TRANSLATE_NOOP("StoreWords", "all attempts are used"),
    QT_TRANSLATE_NOOP("StoreWords", "the proctor's name is missing"),
    QT_TRANSLATE_NOOP("StoreWords", "the proctor \"%1\" has no account here"),
    QT_TRANSLATE_NOOP("StoreWords",
                      "\"%1\" is no active educator or administrator and cannot be the proctor"),
    QT_TRANSLATE_NOOP("StoreWords", "nobody can be their own proctor"),
    QT_TRANSLATE_NOOP("StoreWords", "the recording is larger than 1 GiB"),
    QT_TRANSLATE_NOOP("StoreWords", "the device has no haptic certificate"),
    QT_TRANSLATE_NOOP("StoreWords", "not mastered yet. %1"),
    // A server's log-ins
    QT_TRANSLATE_NOOP("StoreWords",
                      "its tables are missing or of an older version, and this log-in may not make "
                      "any; their owner does, with `placodectl station role --apply`"),
    QT_TRANSLATE_NOOP("StoreWords",
                      "this log-in to the server can do more than a station should (%1); use one "
                      "that is member of placode_station"),
    // A store that went to another place
    QT_TRANSLATE_NOOP("StoreWords",
                      "the store was moved to %1; use that address, or bring it back with `%2`"),
    QT_TRANSLATE_NOOP("StoreWords",
                      "the store was moved to %1; use that address, or bring it back with `%2`; "
                      "nothing was changed"),
    QT_TRANSLATE_NOOP("StoreWords",
                      "a store is being moved here from %1, and that is not finished; go on with "
                      "`%2`"),
    // A file that holds more than Placode puts into one
    QT_TRANSLATE_NOOP("StoreWords",
                      "it holds %1, which Placode did not make and which may be there to do harm; "
                      "nothing was changed; use another copy of the store, or have whoever put it "
                      "there take it out"),
    // Published texts
    QT_TRANSLATE_NOOP("StoreWords",
                      "%1 is published with another text, which is never changed; give your text "
                      "the next version"),
    QT_TRANSLATE_NOOP("StoreWords",
                      "version %1 is published already; give your text a higher version"),
    QT_TRANSLATE_NOOP("StoreWords", "an amendment needs a reason"),
    QT_TRANSLATE_NOOP("StoreWords",
                      "only questionnaires, studies, courses, tasks, rubrics, standards and seals "
                      "of consents are published"),
    QT_TRANSLATE_NOOP("StoreWords",
                      "rubric %1 version %2 is known with another text; give the rubric the next "
                      "version"),
    // Studies
    QT_TRANSLATE_NOOP("StoreWords", "the study \"%1\" has no participant \"%2\"; check the code"),
    QT_TRANSLATE_NOOP("StoreWords", "there is no such participant; check the code"),
    QT_TRANSLATE_NOOP("StoreWords", "%1 has withdrawn (%2); nothing more is recorded"),
    QT_TRANSLATE_NOOP("StoreWords", "%1 has not consented; record the step \"%2\" first"),
    QT_TRANSLATE_NOOP("StoreWords", "the participant has withdrawn already (%1)"),
    QT_TRANSLATE_NOOP("StoreWords", "a withdrawal needs a reason; \"not given\" is one"),
    QT_TRANSLATE_NOOP("StoreWords", "the step has no id"),
    QT_TRANSLATE_NOOP("StoreWords", "attempt %1 belongs to %2 of the study \"%3\""),
    QT_TRANSLATE_NOOP("StoreWords", "a repeat needs a reason"),
    QT_TRANSLATE_NOOP(
        "StoreWords",
        "there is no attempt of this step that counts; only a procedure that was done "
        "is done again"),
    QT_TRANSLATE_NOOP("StoreWords", "the note is empty"),
    QT_TRANSLATE_NOOP("StoreWords", "no device is named"),
    QT_TRANSLATE_NOOP("StoreWords", "the study has no id"),
    QT_TRANSLATE_NOOP("StoreWords", "the study has no published protocol that asks for one"),
    QT_TRANSLATE_NOOP("StoreWords", "the statement \"%1\" is required and was not agreed to"),
    QT_TRANSLATE_NOOP("StoreWords",
                      "the record of %1 is locked; unlock it with a reason first, which cancels "
                      "its signature"),
    QT_TRANSLATE_NOOP("StoreWords", "it is locked already"),
    QT_TRANSLATE_NOOP("StoreWords", "it is not locked"),
    QT_TRANSLATE_NOOP("StoreWords", "it is signed already, by %1"),
    QT_TRANSLATE_NOOP("StoreWords", "a signature needs its meaning, such as \"%1\""),
    QT_TRANSLATE_NOOP("StoreWords", "too many wrong passwords; try again in %1 s"),
    QT_TRANSLATE_NOOP("StoreWords", "login or password is wrong; nothing was signed"),
    QT_TRANSLATE_NOOP("StoreWords", "lock the record first: what is signed must not change"),
    QT_TRANSLATE_NOOP("StoreWords", "unlocking needs a reason"),
    QT_TRANSLATE_NOOP("StoreWords", "nothing was signed"),
    QT_TRANSLATE_NOOP("StoreWords", "the consent was signed at %1"),
    QT_TRANSLATE_NOOP("StoreWords",
                      "the questionnaire %1 is not published, so that nothing says which answers "
                      "are possible"),
    QT_TRANSLATE_NOOP("StoreWords", "a correction needs a reason"),
    QT_TRANSLATE_NOOP("StoreWords", "nothing would change"),
    QT_TRANSLATE_NOOP("StoreWords", "these answers have no second entry"),
    QT_TRANSLATE_NOOP("StoreWords", "these answers have a second entry, by %1"),
    // Names behind the codes
    QT_TRANSLATE_NOOP("StoreWords",
                      "the passphrase is too short; expected at least %1 characters, four words "
                      "are good"),
    QT_TRANSLATE_NOOP("StoreWords", "the passphrase is wrong, or the file was changed"),
    QT_TRANSLATE_NOOP("StoreWords", "\"%1\" is no participant's code"),
    QT_TRANSLATE_NOOP("StoreWords", "the name is missing"),
    QT_TRANSLATE_NOOP("StoreWords", "is there already; open it, or choose another place"),
    QT_TRANSLATE_NOOP("StoreWords", "there is no such file; create the key first"),
    // Review, standards, norms
    QT_TRANSLATE_NOOP("StoreWords", "the time is not within the attempt of %1 s"),
    QT_TRANSLATE_NOOP("StoreWords", "a remark needs a text or a time"),
    QT_TRANSLATE_NOOP("StoreWords", "nobody rates an attempt of their own"),
    QT_TRANSLATE_NOOP("StoreWords", "this rater has rated the attempt already"),
    QT_TRANSLATE_NOOP("StoreWords", "the centre has no name yet; give it with the first norm pack"),
    QT_TRANSLATE_NOOP("StoreWords",
                      "the level \"%1\" has %2 persons with attempts; at least %3 are needed, "
                      "because bands of fewer tell about persons"),
    QT_TRANSLATE_NOOP("StoreWords",
                      "%1 of %2 attempts were never simulated again; let `placodectl verify --all` "
                      "do that first"),
    QT_TRANSLATE_NOOP("StoreWords",
                      "its signature is wrong: the pack was changed after it was signed"),
    QT_TRANSLATE_NOOP("StoreWords", "its centre \"%1\" with the key %2 is not trusted here"),
    // Files
    QT_TRANSLATE_NOOP("StoreWords", "a PostgreSQL store is backed up on its server, with pg_dump"),
    QT_TRANSLATE_NOOP("StoreWords", "%1 exists and is not overwritten; give another name"),
    QT_TRANSLATE_NOOP("StoreWords", "the attempt has no recording"),
    QT_TRANSLATE_NOOP("StoreWords",
                      "the file is empty: the attempt never began; it can be removed"),
    // The centre's key
    QT_TRANSLATE_NOOP("StoreWords", "the passphrase of the centre's key is wrong; try again"),
    QT_TRANSLATE_NOOP(
        "StoreWords",
        "on a server the centre's key is sealed and changed with the log-in of the "
        "tables' owner; let an administrator run `placodectl norms key seal` with it"),
};

/// What a person may not do, and who can (db/access.cpp).
constexpr const char* kDeeds[]{
    QT_TRANSLATE_NOOP("Rights", "perform an attempt"),
    QT_TRANSLATE_NOOP("Rights", "see other people's attempts"),
    QT_TRANSLATE_NOOP("Rights", "see other people's personal data"),
    QT_TRANSLATE_NOOP("Rights", "manage accounts"),
    QT_TRANSLATE_NOOP("Rights", "have a questionnaire answered"),
    QT_TRANSLATE_NOOP("Rights", "export the data of a study"),
    QT_TRANSLATE_NOOP("Rights", "back up, restore or check the store"),
    QT_TRANSLATE_NOOP("Rights", "see the audit trail"),
    QT_TRANSLATE_NOOP("Rights", "publish courses"),
    QT_TRANSLATE_NOOP("Rights", "assign courses to this person or group"),
    QT_TRANSLATE_NOOP("Rights", "change groups"),
    QT_TRANSLATE_NOOP("Rights", "issue this person's certificate"),
    QT_TRANSLATE_NOOP("Rights", "review this person's attempts"),
    QT_TRANSLATE_NOOP("Rights", "set standards or rescore"),
    QT_TRANSLATE_NOOP("Rights", "export another person's data"),
    QT_TRANSLATE_NOOP("Rights", "ask for another person's erasure"),
    QT_TRANSLATE_NOOP("Rights", "erase a person"),
    QT_TRANSLATE_NOOP("Rights", "use the store without signing in"),
    QT_TRANSLATE_NOOP("Rights", "set another person's password"),
    QT_TRANSLATE_NOOP("Rights", "choose another person's PIN"),
    QT_TRANSLATE_NOOP("Rights", "save another person's attempt"),
    QT_TRANSLATE_NOOP("Rights", "remark on this person's attempts"),
    QT_TRANSLATE_NOOP("Rights", "say what simulating an attempt again gave"),
    QT_TRANSLATE_NOOP("Rights", "act in another person's name"),
};
constexpr const char* kWho[]{
    QT_TRANSLATE_NOOP("Rights", "everybody, in their own name"),
    QT_TRANSLATE_NOOP("Rights", "an educator"),
    QT_TRANSLATE_NOOP("Rights", "an educator or an administrator"),
    QT_TRANSLATE_NOOP("Rights", "an administrator"),
    QT_TRANSLATE_NOOP("Rights", "a coordinator"),
    QT_TRANSLATE_NOOP("Rights", "an educator of the group"),
    QT_TRANSLATE_NOOP("Rights", "an educator of the group or an administrator"),
    QT_TRANSLATE_NOOP("Rights", "the person, or an educator of the group,"),
    QT_TRANSLATE_NOOP("Rights", "an educator of the group, not the person,"),
    QT_TRANSLATE_NOOP("Rights", "the person"),
    QT_TRANSLATE_NOOP("Rights", "an administrator, not the person,"),
    QT_TRANSLATE_NOOP("Rights", "everybody who has signed in"),
    QT_TRANSLATE_NOOP("Rights", "the person or an administrator"),
    QT_TRANSLATE_NOOP("Rights", "only the program itself"),
};

/// "you may not see the audit trail; an administrator can"; empty when it is something else.
QString rights_words(const QString& sentence) {
    static const QRegularExpression kForm("^you may not (.+); (.+) can\\.?$",
                                          QRegularExpression::CaseInsensitiveOption);
    const QRegularExpressionMatch found = kForm.match(sentence);
    const auto listed = [](const auto& list, const QString& text) {
        return std::any_of(std::begin(list), std::end(list),
                           [&](const char* each) { return text == QLatin1String(each); });
    };
    if (!found.hasMatch() || !listed(kDeeds, found.captured(1)) || !listed(kWho, found.captured(2)))
        return {};
    const auto words = [&](int part) {
        return QCoreApplication::translate("Rights", found.captured(part).toUtf8().constData());
    };
    return QCoreApplication::translate("Rights", "You may not %1; %2 can.").arg(words(1), words(2));
}

QRegularExpression expression_of(const char* sentence) {
    QString text = QRegularExpression::escape(QString::fromUtf8(sentence));
    for (const char* mark : {"\\%1", "\\%2", "\\%3"}) text.replace(mark, "(.+)");
    return QRegularExpression("^" + text + "$");
}

const std::vector<QRegularExpression>& expressions() {
    static const std::vector<QRegularExpression> all = [] {
        std::vector<QRegularExpression> made;
        for (const char* sentence : kSentences) made.push_back(expression_of(sentence));
        return made;
    }();
    return all;
}

/// "the login is taken; choose another one" as people write it: a capital, a full stop.
QString as_sentence(QString text) {
    if (text.isEmpty()) return text;
    text[0] = text[0].toUpper();
    return text.endsWith('.') || text.endsWith('?') ? text : text + ".";
}

}  // namespace

QStringList store_sentences() { return QStringList(std::begin(kSentences), std::end(kSentences)); }

QString store_sentence(const QString& said) {
    // "operation place: sentence"; the place is a store's address, a file, or a person or thing.
    static const QRegularExpression kPlace(
        "^(?:.+? "
        "(?:sqlite:|postgresql://).*?|(?:consent|answers|exam|certificate|participant "
        "key|read recording|recover recording)\\b.*?): ");
    QString rest = said.section('\n', 0, 0);
    const QRegularExpressionMatch found = kPlace.match(rest);
    if (found.hasMatch()) rest = rest.mid(found.capturedEnd());
    return as_sentence(rest);
}

QString store_words(const QString& said) {
    QString rest = store_sentence(said);
    if (const QString rights = rights_words(rest); !rights.isEmpty()) return rights;
    if (rest.endsWith('.')) rest.chop(1);
    for (size_t i = 0; i < std::size(kSentences); ++i) {
        // The capital that store_sentence gave it is not in the catalogue.
        QString small = rest;
        if (!small.isEmpty()) small[0] = small[0].toLower();
        for (const QString& form : {rest, small}) {
            const QRegularExpressionMatch match = expressions()[i].match(form);
            if (!match.hasMatch()) continue;
            QString words = QCoreApplication::translate("StoreWords", kSentences[i]);
            for (int n = match.lastCapturedIndex(); n >= 1; --n)
                words.replace(QString("%%1").arg(n), match.captured(n));
            return as_sentence(words);
        }
    }
    return {};
}

}  // namespace placode::ui
