// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What is said to people, kept as what is meant: a sentence with its places and what stands in
// them. Scripts, logs and exports get it in English; reports::said_words() says it in the reader's
// language.

#include <cstdint>
#include <string>
#include <vector>

namespace placode::sim {

class Said {
#ifdef LUPDATE
    // Never compiled. The translation tool reads every branch, and finds here the context of what
    // stands behind `Said::that` (cmake/compiler.cmake).
    Q_DECLARE_TR_FUNCTIONS(Said)
#endif

 public:
    /// The context of the sentences in the translation files.
    static constexpr const char* kContext = "Said";

    /// English as it stands in the source, %1 to %9 for what varies.
    struct Sentence {
        const char* english;
        consteval Sentence(const char* literal) : english(literal) {}  // NOLINT: meant to convert
    };

    /// Nothing is said.
    Said() = default;
    /// A sentence that has a translation: `Said::that("it ended at %1").with(day)`. Small first
    /// letter, no full stop: it goes on "operation place: ".
    [[nodiscard]] static Said that(Sentence sentence) { return listed(sentence.english); }
    /// A word of a list whose entries are marked with QT_TRANSLATE_NOOP("Said", ...), or a sentence
    /// that was kept.
    [[nodiscard]] static Said listed(const std::string& english);
    /// What nobody translates: a name, a number, an address, what an engine or a file says.
    [[nodiscard]] static Said as_is(const std::string& text);
    [[nodiscard]] static Said as_is(const std::string& text, const std::string& polish);
    /// What a definition says, in each of its languages (curriculum::LocalText).
    template <class Text>
    requires requires(const Text& text) {
        text.en;
        text.pl;
    }
    [[nodiscard]] static Said as_is(const Text& text) { return as_is(text.en, text.pl); }

    /// Fills the next place.
    [[nodiscard]] Said with(const Said& part) const;
    [[nodiscard]] Said with(const std::string& part) const { return with(as_is(part)); }
    [[nodiscard]] Said with(int64_t part) const { return with(std::to_string(part)); }

    [[nodiscard]] std::string english() const;
    /// As it stands in the source; nullptr for what is as it is.
    [[nodiscard]] const char* sentence() const noexcept {
        return sentence_.empty() ? nullptr : sentence_.c_str();
    }
    /// What fills the places of sentence(), in their order.
    [[nodiscard]] const std::vector<Said>& parts() const noexcept { return parts_; }
    /// Of what is as it is: the words, in Polish where they have any of their own.
    [[nodiscard]] const std::string& words_in(const std::string& code) const noexcept {
        return code == "pl" && !words_pl_.empty() ? words_pl_ : words_;
    }
    /// In another language. @param code of the definitions' texts ("pl").
    /// @param translate makes a sentence of another one; places stay as they are.
    template <class Translate>
    [[nodiscard]] std::string in(const std::string& code, const Translate& translate) const {
        if (sentence_.empty()) return words_in(code);
        std::vector<std::string> parts;
        for (const Said& part : parts_) parts.push_back(part.in(code, translate));
        return filled(translate(sentence_.c_str()), parts);
    }

    [[nodiscard]] bool operator==(const Said&) const = default;

 private:
    [[nodiscard]] static std::string filled(const std::string& sentence,
                                            const std::vector<std::string>& parts);

    std::string sentence_;  ///< Empty: the words as they are.
    std::string words_, words_pl_;
    std::vector<Said> parts_;
};

}  // namespace placode::sim
