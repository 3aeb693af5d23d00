// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Words for people in the language of the program: reasons, damage, phases, instruments. English
// where no translator is installed. The shell's translation file lists them
// (translatable_strings.cpp).

#include <QLocale>
#include <QString>
#include <optional>

#include "assessment/ledger.h"
#include "assessment/scoring.h"
#include "assessment/themes.h"
#include "db/said.h"
#include "db/study_deviations.h"

namespace placode::reports {

/// While it lives, words and numbers of this thread are in that language, whatever the program's
/// is: a server speaks to several readers at once, each in a thread. The words still come from the
/// program's translators, which may ask spoken() (ui/web/words.cpp).
class Speaking {
 public:
    explicit Speaking(const QLocale& language);
    ~Speaking();
    Speaking(const Speaking&) = delete;
    Speaking& operator=(const Speaking&) = delete;

 private:
    std::optional<QLocale> before_;
};
/// What this thread speaks; where nothing was said of it, the program's.
[[nodiscard]] QLocale spoken();
/// A number as it stands in every report ("3.5"), with the decimal sign of who is spoken to; as it
/// is where no language was said.
[[nodiscard]] QString with_spoken_sign(QString number);

/// What the store says to people, as a sentence in the program's language.
[[nodiscard]] QString said_words(const db::Said& said);
/// As it stands within a sentence: without capital and full stop.
[[nodiscard]] QString said_part(const db::Said& said);

/// A word of the figures, translated.
[[nodiscard]] QString figure_word(const char* english);

/// Why points were lost, in the program's language. What an older program scored stays English;
/// scored again it has its meaning, too.
[[nodiscard]] QString reason_words(const assessment::Reason& reason);

/// " between bites 2 and 3"; empty where `between` says nothing.
[[nodiscard]] QString between_words(const assessment::BetweenBites& between);

/// Why an attempt is void, from what the store keeps (db/void_reason.h), in the program's language.
[[nodiscard]] QString void_words(const std::string& text, const std::string& meaning = {});

/// In which language something is said: the program's, or English for files.
enum class Language : uint8_t { kProgram, kEnglish };

/// Why an attempt does not count, in a few words that go on a sentence ("left after 5 s; the
/// computer was too slow"): every reason, what the person did first. Empty when it counts. Pages,
/// tables and reports say it in these words.
[[nodiscard]] QString not_counted_words(const db::AttemptRecord& attempt,
                                        Language language = Language::kProgram);

/// Why a step of a study is still to be done, from what its record keeps, in the program's
/// language.
[[nodiscard]] QString not_done_words(const std::string& text, const std::string& meaning = {});

/// "Stood still twice, 12 s in all (menu, help)."
[[nodiscard]] QString deviation_words(const db::Deviation& deviation,
                                      Language language = Language::kProgram);
/// "Pauses": what the report counts.
[[nodiscard]] QString deviation_title(db::DeviationKind kind,
                                      Language language = Language::kProgram);

/// "Placode touched, 0.4 s, at most 12 mN"
[[nodiscard]] QString ledger_words(const assessment::LedgerEntry& entry);
/// "4 o'clock, junctional zone"; empty without a place.
[[nodiscard]] QString place_words(const assessment::LedgerEntry& entry);
[[nodiscard]] QString phase_words(sim::Phase phase);
[[nodiscard]] QString theme_words(assessment::Theme theme);
[[nodiscard]] QString lane_words(assessment::HarmLane lane);
[[nodiscard]] QString tool_words(sim::ToolKind kind);
[[nodiscard]] QString region_words(assessment::Region region);

/// "1:05" in minutes and seconds, for axes and lists.
[[nodiscard]] QString minute_second(double seconds);

}  // namespace placode::reports
