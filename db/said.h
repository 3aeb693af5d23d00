// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What is said to people, kept as what is meant: a sentence with its places and what stands in
// them. Scripts and logs get it in English; reports::said_words() says it in the reader's language.

#include <QCoreApplication>
#include <cstdint>
#include <string>
#include <vector>

namespace placode::curriculum {
struct LocalText;
}

namespace placode::db {

class Said {
    // The sentences' context in the translation file, where the translation tool puts what it finds
    // behind `Said::that` (cmake/compiler.cmake).
    Q_DECLARE_TR_FUNCTIONS(Said)

 public:
    /// English as it stands in the source, %1 to %9 for what varies.
    struct Sentence {
        const char* english;
        consteval Sentence(const char* literal) : english(literal) {}  // NOLINT: meant to convert
    };

    /// A sentence that has a translation: `Said::that("it ended at %1").with(day)`. Small first
    /// letter, no full stop: it goes on "operation place: ".
    [[nodiscard]] static Said that(Sentence sentence);
    /// A word of a list whose entries are marked with QT_TRANSLATE_NOOP("Said", ...).
    [[nodiscard]] static Said listed(const char* english);
    /// What nobody translates: a name, a number, an address, what an engine or a file says.
    [[nodiscard]] static Said as_is(const std::string& text);
    /// What a definition says, in each of its languages.
    [[nodiscard]] static Said as_is(const curriculum::LocalText& text);

    /// Fills the next place.
    [[nodiscard]] Said with(const Said& part) const;
    [[nodiscard]] Said with(const std::string& part) const { return with(as_is(part)); }
    [[nodiscard]] Said with(int64_t part) const { return with(std::to_string(part)); }

    [[nodiscard]] std::string english() const;
    /// As it stands in the source; nullptr for what is as it is.
    [[nodiscard]] const char* sentence() const noexcept { return sentence_; }
    /// In another language. @param code of the definitions' texts ("pl").
    /// @param translate makes a sentence of another one; places stay as they are.
    template <class Translate>
    [[nodiscard]] std::string in(const std::string& code, const Translate& translate) const {
        if (sentence_ == nullptr) return words_in(code);
        std::vector<std::string> parts;
        for (const Said& part : parts_) parts.push_back(part.in(code, translate));
        return filled(translate(sentence_), parts);
    }

 private:
    [[nodiscard]] std::string words_in(const std::string& code) const;
    [[nodiscard]] static std::string filled(const std::string& sentence,
                                            const std::vector<std::string>& parts);

    const char* sentence_ = nullptr;  ///< nullptr: the words as they are.
    std::string words_, words_pl_;
    std::vector<Said> parts_;
};

}  // namespace placode::db
