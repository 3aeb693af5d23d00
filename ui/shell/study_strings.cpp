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
};

}  // namespace
