// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Names in a text, as people read them: capitals name whom small letters name, also where the
// accents stand behind their letters, as some systems write file names.

#include <QString>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace placode::db {

/// A part of a text, in bytes of UTF-8.
struct WordPlace {
    size_t at = 0, size = 0;
};

/// A text to look for words in, or a word: without regard to case and to how accents are encoded.
class FoldedText {
 public:
    explicit FoldedText(const std::string& text);
    /// Where `word` stands by itself, from this byte of the text on; never for an empty word.
    [[nodiscard]] std::optional<WordPlace> find(const FoldedText& word, size_t from = 0) const;
    /// Small letters with their accents apart, in UTF-8.
    [[nodiscard]] std::string letters() const { return letters_.toStdString(); }

 private:
    [[nodiscard]] bool begins_letter(qsizetype unit) const;
    [[nodiscard]] bool is_in_a_word(qsizetype unit) const;

    QString letters_;
    std::vector<size_t> at_;  ///< Of every unit of letters_, and of the end: its letter's byte.
};

/// Whether `word` stands in the text by itself.
[[nodiscard]] bool holds_word(const std::string& text, const std::string& word);

/// The text, and the same in small letters and with a capital in every word, for a server that
/// looks for names in it and knows the case of ASCII letters only.
[[nodiscard]] std::string in_several_cases(const std::string& text);

}  // namespace placode::db
