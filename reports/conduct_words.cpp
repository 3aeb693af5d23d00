// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Words for what became of an attempt beside its score: void for cause, deviations of a study.

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>

#include "db/attempt_counting.h"
#include "reports/text.h"
#include "reports/words.h"

namespace placode::reports {
namespace {

/// As slow_machine_reason() says them; %1 is a whole number, and of pictures there may be one.
constexpr const char* kVoidPatterns[]{
    "The computer was too slow: the simulation ran at %1 % of real time, 95 % are needed",
    "Tissue or generator was tuned"};
constexpr const char* kPictures =
    "The computer was too slow: %n picture(s) a second, 20 are needed";

/// How every reason of a slow machine begins.
constexpr const char* kSlowStart = "The computer was too slow";

class Speaker {
 public:
    explicit Speaker(Language language) : language_(language) {}
    [[nodiscard]] QString operator()(const char* english) const {
        return language_ == Language::kEnglish ? QString::fromUtf8(english)
                                               : QCoreApplication::translate("Deviation", english);
    }
    [[nodiscard]] QString seconds(double s) const {
        const QLocale locale = language_ == Language::kEnglish ? QLocale::c() : QLocale();
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
                     .arg(language == Language::kEnglish ? QString::fromStdString(deviation.text)
                                                         : void_words(deviation.text));
    return parts.join(' ');
}

}  // namespace

QString void_words(const std::string& english) {
    QStringList parts;
    for (const QString& part : QString::fromStdString(english).split(QStringLiteral("; "))) {
        QString said = part;
        // Stores hold "1 pictures" of earlier versions, too.
        static const QRegularExpression kSlow(
            "^The computer was too slow: (-?\\d+) pictures? a second, 20 are needed$");
        if (const auto slow = kSlow.match(part); slow.hasMatch()) {
            const int n = slow.captured(1).toInt();
            const QString words = QCoreApplication::translate("Deviation", kPictures, nullptr, n);
            // Without a translator (the programs) the noun is still undecided.
            said = QString(words).replace("picture(s)", n == 1 ? "picture" : "pictures");
        }
        for (const char* pattern : kVoidPatterns) {
            QString text = QRegularExpression::escape(QString::fromUtf8(pattern));
            text.replace(QStringLiteral("\\%1"), QStringLiteral("(-?\\d+)"));
            const auto match = QRegularExpression("^" + text + "$").match(part);
            if (!match.hasMatch()) continue;
            said = QCoreApplication::translate("Deviation", pattern);
            if (match.lastCapturedIndex() > 0) said = said.arg(match.captured(1));
        }
        parts << said;
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
    bool tuned = false, device = false, slow = false;
    for (const QString& part : QString::fromStdString(attempt.void_reason)
                                   .split(QStringLiteral("; "), Qt::SkipEmptyParts)) {
        if (part == QLatin1String(db::kTunedReason.data(), db::kTunedReason.size()))
            tuned = true;
        else if (part.startsWith(QLatin1String(kSlowStart)))
            slow = true;
        else
            device = true;
    }
    if (tuned) said << say("tissue or generator was tuned");
    if (device) said << say("the force device did not work as it must");
    if (slow) said << say("the computer was too slow");
    return said.join(QStringLiteral("; "));
}

QString not_done_words(const std::string& english) {
    const QString said = QString::fromStdString(english);
    // What the person did stands before what the machine did.
    if (const auto at = said.indexOf(QStringLiteral("; void: ")); at > 0)
        return not_done_words(said.left(at).toStdString()) + QStringLiteral("; ") +
               not_done_words(said.mid(at + 2).toStdString());
    if (said == QLatin1String("interrupted"))
        return QCoreApplication::translate("Deviation", "broken off");
    static const QString kVoid = QStringLiteral("void: ");
    if (said.startsWith(kVoid)) return void_words(said.mid(kVoid.size()).toStdString());
    static const QRegularExpression kEarly(
        QStringLiteral("^ended after (\\d+) s, before the least duration of (\\d+) s$"));
    const auto match = kEarly.match(said);
    if (!match.hasMatch()) return said;
    return QCoreApplication::translate("Deviation", "it ended after %1 s, before %2 s were over")
        .arg(match.captured(1), match.captured(2));
}

QString deviation_words(const db::Deviation& deviation, Language language) {
    const Speaker say(language);
    const QString text = QString::fromStdString(deviation.text);
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
