// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Words for what became of an attempt beside its score: void for cause, deviations of a study.

#include <QCoreApplication>

#include "db/attempt_counting.h"
#include "reports/text.h"
#include "reports/words.h"

namespace placode::reports {
namespace {

class Speaker {
 public:
    explicit Speaker(Language language) : language_(language) {}
    [[nodiscard]] QString operator()(const char* english) const {
        return language_ == Language::kEnglish ? QString::fromUtf8(english)
                                               : QCoreApplication::translate("Deviation", english);
    }
    [[nodiscard]] QString seconds(double s) const {
        const QLocale locale = language_ == Language::kEnglish ? QLocale::c() : spoken();
        return (*this)("%1 s").arg(locale.toString(s, 'f', s < 10 ? 1 : 0));
    }
    [[nodiscard]] QString times(int n) const {
        if (n == 1) return (*this)("once");
        if (n == 2) return (*this)("twice");
        return (*this)("%1 times").arg(n);
    }

 private:
    Language language_;
};

QString cause_words(const Speaker& say, sim::PauseCause cause) {
    switch (cause) {
        case sim::PauseCause::kMenu:
            return say("menu");
        case sim::PauseCause::kHelp:
            return say("help");
        case sim::PauseCause::kClosing:
            return say("asked before closing");
        case sim::PauseCause::kFocus:
            return say("another window in front");
        case sim::PauseCause::kDevice:
            return say("the device was gone");
        case sim::PauseCause::kAsleep:
            return say("the computer was asleep");
    }
    return {};
}

QString pause_words(const Speaker& say, const db::Deviation& deviation) {
    QStringList causes;
    for (const sim::PauseCause cause : deviation.causes) causes << cause_words(say, cause);
    return say("Stood still %1, %2 in all (%3).")
        .arg(say.times(deviation.count), say.seconds(deviation.seconds), causes.join(", "));
}

QString slow_words(const Speaker& say, Language language, const db::Deviation& deviation) {
    QStringList parts;
    if (deviation.count > 0)
        parts << say("The computer fell behind %1, %2 in all.")
                     .arg(say.times(deviation.count), say.seconds(deviation.seconds));
    if (!deviation.text.empty())
        parts << say("Does not count: %1.")
                     .arg(language == Language::kEnglish
                              ? QString::fromStdString(deviation.text)
                              : void_words(deviation.text, deviation.meaning));
    return parts.join(' ');
}

QString doubt_words(const db::VoidReason& reason) {
    const auto say = [&](const char* english) {
        const QString words = QCoreApplication::translate("Deviation", english);
        return words.contains("%1") ? words.arg(said_part(reason.detail)) : words;
    };
    switch (reason.cause) {
        case db::VoidCause::kTaskUnknown:
            return say("Practice, not verified: no task %1 is published here");
        case db::VoidCause::kTaskDiffers:
            return say("Practice, not verified: its task is not the published %1");
        case db::VoidCause::kUnsound:
            return say("Practice, not verified: it cannot be scored (%1)");
        case db::VoidCause::kSameRecording:
            return say("Practice, not verified: attempt %1 is the same recording");
        case db::VoidCause::kReplayDiffers:
            return say("Practice, not verified: simulated again it differs (%1)");
        case db::VoidCause::kUnsigned:
            return reason.detail.english() == db::kNobody
                       ? say("Practice, not verified: no computer signed the recording, or it was "
                             "changed")
                       : say("Practice, not verified: the computer %1 recorded it, which no "
                             "administrator has vouched for");
        case db::VoidCause::kNoRecording:
            return say("Practice, not verified: nothing was recorded");
        case db::VoidCause::kOrderDiffers:
            return say("Practice, not verified: it was begun for another person, exam or proctor");
        case db::VoidCause::kOrderMissing:
            return say(
                "Practice, not verified: nothing shows for whom and for which exam it was "
                "begun");
        case db::VoidCause::kProctor:
            return say(
                "Practice, not verified: the proctor is the person examined, or neither "
                "educator nor administrator here");
        case db::VoidCause::kExamClosed:
            return say("Practice, not verified: it is not the exam that was open (%1)");
        case db::VoidCause::kClock:
            return say("Practice, not verified: the time that it says cannot be right (%1)");
        case db::VoidCause::kTaskVersion:
            return say("Practice, not verified: the exam asked for another version than %1");
        default:
            return say("Practice, not verified: operated by %1");
    }
}

QString void_reason_words(const db::VoidReason& reason) {
    const auto say = [](const char* english, int n = -1) {
        return QCoreApplication::translate("Deviation", english, nullptr, n);
    };
    switch (reason.cause) {
        case db::VoidCause::kFewPictures: {
            const QString words = say(
                "The computer was too slow: %n picture(s) a second, 20 are needed", reason.found);
            // Without a translator (the programs) the noun is still undecided.
            return QString(words).replace("picture(s)", reason.found == 1 ? "picture" : "pictures");
        }
        case db::VoidCause::kNotRealTime:
            return say("The computer was too slow: the simulation ran at %1 % of real time, "
                       "95 % are needed")
                .arg(reason.found);
        case db::VoidCause::kTuned:
            return say("Tissue or generator was tuned");
        case db::VoidCause::kGiven:
            return say("Begun at stage %1, what came before it was given").arg(reason.found);
        case db::VoidCause::kDevice:
            return said_part(reason.detail);
        case db::VoidCause::kTaskUnknown:
        case db::VoidCause::kTaskDiffers:
        case db::VoidCause::kUnsound:
        case db::VoidCause::kSameRecording:
        case db::VoidCause::kReplayDiffers:
        case db::VoidCause::kScript:
        case db::VoidCause::kUnsigned:
        case db::VoidCause::kNoRecording:
        case db::VoidCause::kOrderDiffers:
        case db::VoidCause::kOrderMissing:
        case db::VoidCause::kProctor:
        case db::VoidCause::kExamClosed:
        case db::VoidCause::kClock:
        case db::VoidCause::kTaskVersion:
            return doubt_words(reason);
    }
    return {};
}

/// As a part of a sentence that has begun already. The text of a device begins with its name.
QString void_reason_within(const db::VoidReason& reason) {
    QString words = void_reason_words(reason);
    if (reason.cause != db::VoidCause::kDevice && !words.isEmpty()) words[0] = words[0].toLower();
    return words;
}

}  // namespace

QString void_words(const std::string& text, const std::string& meaning) {
    QStringList parts;
    bool slow = false;  // Said already: the second figure of the same machine only adds itself.
    for (const db::VoidReason& reason : db::void_reasons(text, meaning)) {
        if (slow && reason.cause == db::VoidCause::kNotRealTime)
            parts << QCoreApplication::translate(
                         "Deviation", "the simulation ran at %1 % of real time, 95 % are needed")
                         .arg(reason.found);
        else
            parts << (parts.isEmpty() ? void_reason_words(reason) : void_reason_within(reason));
        slow |= reason.cause == db::VoidCause::kFewPictures;
    }
    return parts.join(QStringLiteral("; "));
}

QString not_counted_words(const db::AttemptRecord& attempt, Language language) {
    const Speaker say(language);
    QStringList said;
    if (attempt.end == sim::EndReason::kInterrupted)
        said << say("left after %1").arg(duration_words(attempt.duration_s));
    if (attempt.verdict == assessment::Verdict::kNotAttempted) said << say("nothing was done");
    // The figures of a machine stand where there is room for them.
    bool tuned = false, device = false, slow = false, doubt = false;
    int stage = 0;
    for (const db::VoidReason& reason : db::why_void(attempt)) {
        tuned |= reason.cause == db::VoidCause::kTuned;
        if (reason.cause == db::VoidCause::kGiven) stage = reason.found;
        device |= reason.cause == db::VoidCause::kDevice;
        slow |= reason.cause == db::VoidCause::kFewPictures ||
                reason.cause == db::VoidCause::kNotRealTime;
        doubt |= db::is_doubt(reason.cause);
    }
    if (stage > 0) said << say("begun at stage %1").arg(stage);
    if (tuned) said << say("tissue or generator was tuned");
    if (device) said << say("the force device did not work as it must");
    if (slow) said << say("the computer was too slow");
    if (doubt) said << say("practice, not verified");
    if (said.isEmpty() && attempt.replay == db::ReplayState::kWaiting)
        said << say("it is still to be simulated again");
    return said.join(QStringLiteral("; "));
}

QString not_done_words(const std::string& text, const std::string& meaning) {
    const Speaker say(Language::kProgram);
    const db::NotDone why = db::not_done(text, meaning);
    QStringList said;
    if (why.interrupted) said << say("broken off");
    if (why.least_s > 0)
        said << say("it ended after %1 s, before %2 s were over").arg(why.ended_s).arg(why.least_s);
    if (!why.note.empty()) said << QString::fromStdString(why.note);
    for (const db::VoidReason& reason : why.voids) said << void_reason_within(reason);
    return said.join(QStringLiteral("; "));
}

QString deviation_words(const db::Deviation& deviation, Language language) {
    const Speaker say(language);
    QString text = QString::fromStdString(deviation.text);
    switch (deviation.kind) {
        case db::DeviationKind::kPaused:
            return pause_words(say, deviation);
        case db::DeviationKind::kSlowMachine:
            return slow_words(say, language, deviation);
        case db::DeviationKind::kEndedEarly:
            return say("Ended after %1; the protocol asks for at least %2.")
                .arg(say.seconds(deviation.seconds), say.seconds(deviation.expected_s));
        case db::DeviationKind::kInterrupted:
            return say("Broken off after %1.").arg(say.seconds(deviation.seconds));
        case db::DeviationKind::kRepeated:
            return say("Done again; this attempt is kept and does not count. Reason: %1").arg(text);
        case db::DeviationKind::kOtherDevice:
            return say("Done with %1; %2 was set.")
                .arg(text, QString::fromStdString(deviation.expected));
        case db::DeviationKind::kSkipped:
            return say("Skipped.");
        case db::DeviationKind::kNote:
            return text;
        case db::DeviationKind::kNothingDone:
            return say("Nothing was done in %1; the attempt is kept and no analysis uses it.")
                .arg(say.seconds(deviation.seconds));
    }
    return text;
}

QString deviation_title(db::DeviationKind kind, Language language) {
    static constexpr const char* kTitles[]{"Pauses",       "Slow computer", "Ended too early",
                                           "Broken off",   "Done again",    "Another device",
                                           "Step skipped", "Note",          "Nothing was done"};
    return Speaker(language)(kTitles[static_cast<size_t>(kind)]);
}

}  // namespace placode::reports
