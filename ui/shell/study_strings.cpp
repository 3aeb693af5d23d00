// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Titles and heads of the analyses in reports/study_analysis.h, listed for the translation tool.
// Captions and methods stay English, like the paper that they are written for.

#include <QtGlobal>

namespace {

[[maybe_unused]] const char* const kAnalysisWords[] = {
    QT_TRANSLATE_NOOP("Analysis", "Construct validity"),
    QT_TRANSLATE_NOOP("Analysis", "Test-retest reliability"),
    QT_TRANSLATE_NOOP("Analysis", "Learning curves"),
    QT_TRANSLATE_NOOP("Analysis", "Agreement of raters"),
    QT_TRANSLATE_NOOP("Analysis", "metric"),
    QT_TRANSLATE_NOOP("Analysis", "95 % interval"),
    QT_TRANSLATE_NOOP("Analysis", "first"),
    QT_TRANSLATE_NOOP("Analysis", "second"),
    QT_TRANSLATE_NOOP("Analysis", "participant"),
    QT_TRANSLATE_NOOP("Analysis", "attempts"),
    QT_TRANSLATE_NOOP("Analysis", "last"),
    QT_TRANSLATE_NOOP("Analysis", "best"),
    QT_TRANSLATE_NOOP("Analysis", "failures"),
    QT_TRANSLATE_NOOP("Analysis", "plateau a"),
    QT_TRANSLATE_NOOP("Analysis", "plateau reached"),
    QT_TRANSLATE_NOOP("Analysis", "rated"),
    QT_TRANSLATE_NOOP("Analysis", "raters"),
    QT_TRANSLATE_NOOP("Analysis",
                      "There are no two levels with attempts of at least two people each."),
    QT_TRANSLATE_NOOP("Analysis", "At least three people with two attempts each are needed."),
    QT_TRANSLATE_NOOP("Analysis", "There are no attempts yet."),
    QT_TRANSLATE_NOOP("Analysis", "There are attempts, but none of them counts."),
};

// Words of reports/conduct_words.cpp: why an attempt does not count, what deviated from a protocol.
[[maybe_unused]] const char* const kDeviationWords[] = {
    QT_TRANSLATE_NOOP("Deviation", "menu"),
    QT_TRANSLATE_NOOP("Deviation", "help"),
    QT_TRANSLATE_NOOP("Deviation", "asked before closing"),
    QT_TRANSLATE_NOOP("Deviation", "another window in front"),
    QT_TRANSLATE_NOOP("Deviation", "Stood still %1, %2 in all (%3)."),
    QT_TRANSLATE_NOOP("Deviation", "The computer fell behind %1, %2 in all."),
    QT_TRANSLATE_NOOP("Deviation", "Does not count: %1."),
    QT_TRANSLATE_NOOP("Deviation", "Ended after %1; the protocol asks for at least %2."),
    QT_TRANSLATE_NOOP("Deviation", "Broken off after %1."),
    QT_TRANSLATE_NOOP("Deviation",
                      "Done again; this attempt is kept and does not count. Reason: %1"),
    QT_TRANSLATE_NOOP("Deviation", "Done with %1; %2 was set."),
    QT_TRANSLATE_NOOP("Deviation", "Skipped."),
    QT_TRANSLATE_NOOP("Deviation", "%1 s"),
    QT_TRANSLATE_NOOP("Deviation", "once"),
    QT_TRANSLATE_NOOP("Deviation", "twice"),
    QT_TRANSLATE_NOOP("Deviation", "%1 times"),
    QT_TRANSLATE_NOOP("Deviation", "left after %1"),
    QT_TRANSLATE_NOOP("Deviation", "nothing was done"),
    QT_TRANSLATE_NOOP("Deviation", "Tissue or generator was tuned"),
    QT_TRANSLATE_NOOP("Deviation", "tissue or generator was tuned"),
    QT_TRANSLATE_NOOP("Deviation", "the force device did not work as it must"),
    QT_TRANSLATE_NOOP("Deviation", "the computer was too slow"),
    QT_TRANSLATE_NOOP("Deviation", "broken off"),
    QT_TRANSLATE_NOOP("Deviation", "it ended after %1 s, before %2 s were over"),
    QT_TRANSLATE_N_NOOP("Deviation",
                        "The computer was too slow: %n picture(s) a second, 20 are needed"),
    QT_TRANSLATE_NOOP("Deviation", "Practice, not verified: no task %1 is published here"),
    QT_TRANSLATE_NOOP("Deviation", "Practice, not verified: its task is not the published %1"),
    QT_TRANSLATE_NOOP("Deviation", "Practice, not verified: it cannot be scored (%1)"),
    QT_TRANSLATE_NOOP("Deviation", "Practice, not verified: attempt %1 is the same recording"),
    QT_TRANSLATE_NOOP("Deviation", "Practice, not verified: simulated again it differs (%1)"),
    QT_TRANSLATE_NOOP("Deviation",
                      "Practice, not verified: no computer signed the recording, or it was "
                      "changed"),
    QT_TRANSLATE_NOOP("Deviation",
                      "Practice, not verified: the computer %1 recorded it, which no "
                      "administrator has vouched for"),
    QT_TRANSLATE_NOOP("Deviation", "Practice, not verified: operated by %1"),
    QT_TRANSLATE_NOOP("Deviation", "Practice, not verified: nothing was recorded"),
    QT_TRANSLATE_NOOP("Deviation",
                      "Practice, not verified: it was begun for another person, exam or proctor"),
    QT_TRANSLATE_NOOP("Deviation",
                      "Practice, not verified: nothing shows for whom and for which exam it was "
                      "begun"),
    QT_TRANSLATE_NOOP("Deviation",
                      "Practice, not verified: the proctor is the person examined, or neither "
                      "educator nor administrator here"),
    QT_TRANSLATE_NOOP("Deviation", "practice, not verified"),
    QT_TRANSLATE_NOOP("Deviation", "it is still to be simulated again"),
    QT_TRANSLATE_NOOP("Deviation", "Attempts that do not count: %1 of %2 (%3)."),
    QT_TRANSLATE_NOOP("Deviation", "void, the computer too slow or a device at fault: %1"),
    QT_TRANSLATE_NOOP("Deviation", "practice, not verified: %1"),
    QT_TRANSLATE_NOOP("Deviation", "still to be simulated again: %1"),
    QT_TRANSLATE_NOOP("Deviation", "broken off: %1"),
    QT_TRANSLATE_NOOP("Deviation", "done again: %1"),
    QT_TRANSLATE_NOOP("Deviation", "shorter than the protocol asks: %1"),
    QT_TRANSLATE_NOOP("Deviation", "nothing was done: %1"),
    QT_TRANSLATE_NOOP(
        "Deviation",
        "The computer was too slow: the simulation ran at %1 % of real time, 95 % are needed"),
    QT_TRANSLATE_NOOP("Deviation", "Pauses"),
    QT_TRANSLATE_NOOP("Deviation", "Slow computer"),
    QT_TRANSLATE_NOOP("Deviation", "Ended too early"),
    QT_TRANSLATE_NOOP("Deviation", "Broken off"),
    QT_TRANSLATE_NOOP("Deviation", "Done again"),
    QT_TRANSLATE_NOOP("Deviation", "Another device"),
    QT_TRANSLATE_NOOP("Deviation", "Step skipped"),
    QT_TRANSLATE_NOOP("Deviation", "Note"),
    QT_TRANSLATE_NOOP("Deviation", "Nothing was done"),
    QT_TRANSLATE_NOOP("Deviation",
                      "Nothing was done in %1; the attempt is kept and no analysis uses it."),
};

}  // namespace
