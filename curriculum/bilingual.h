// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Sentences of the program itself that are needed in both languages at once, as a definition's
// texts are. The English stands in the source, its Polish and the forms of counted nouns in the
// translation files (context Bilingual).

#include <string>
#include <string_view>
#include <vector>

#include "curriculum/task.h"

namespace placode::curriculum {

class Bilingual {
#ifdef LUPDATE
    // Never compiled: here the translation tool finds the context of what stands behind
    // `Bilingual::phrase` and the others (cmake/compiler.cmake).
    Q_DECLARE_TR_FUNCTIONS(Bilingual)
#endif

 public:
    /// Of the sentences in the translation files.
    static constexpr std::string_view kContext = "Bilingual";

    /// English as it stands in the source, %1 to %9 for what varies.
    struct Phrase {
        const char* english = "";
        constexpr Phrase() = default;
        consteval Phrase(const char* literal) : english(literal) {}  // NOLINT: meant to convert
    };

    /// Marks a phrase of a table.
    [[nodiscard]] static consteval Phrase that(Phrase english) { return english; }
    /// With its places filled.
    [[nodiscard]] static LocalText phrase(Phrase english, const std::vector<LocalText>& parts = {});
    /// A number, %n, with its noun in the form that goes with it: "%n attempt(s)".
    [[nodiscard]] static LocalText count_phrase(Phrase english, int64_t number,
                                                const std::vector<LocalText>& parts = {});

    /// What is the same in every language: a day, a whole number.
    [[nodiscard]] static LocalText as_is(const std::string& text) { return {text, text}; }
    /// With the decimal sign of each language. @param digits that count, at most.
    [[nodiscard]] static LocalText number(double value, int digits);
};

}  // namespace placode::curriculum
