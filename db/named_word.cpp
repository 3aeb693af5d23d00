// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/named_word.h"

#include <algorithm>

namespace placode::db {
namespace {

bool is_ascii(char c) { return static_cast<unsigned char>(c) < 0x80; }

/// How many bytes the code point takes that begins with this one.
size_t size_of(char first) {
    const auto lead = static_cast<unsigned char>(first);
    if (lead >= 0xF0) return 4;
    if (lead >= 0xE0) return 3;
    return lead >= 0xC0 ? 2 : 1;
}

/// The code point at this byte, which goes on behind it. A byte that is no UTF-8 is one by itself.
QString next_code_point(const std::string& text, size_t& at) {
    const size_t size = std::min(size_of(text[at]), text.size() - at);
    QString found = QString::fromUtf8(text.data() + at, static_cast<qsizetype>(size));
    if (found.contains(QChar::ReplacementCharacter)) {
        ++at;
        return QString(QChar(QChar::ReplacementCharacter));
    }
    at += size;
    if (found.isEmpty()) found = QChar(QChar::ByteOrderMark);  // Qt leaves it out.
    return found;
}

char32_t code_of(const QString& letters, qsizetype unit) {
    const QChar c = letters[unit];
    if (c.isLowSurrogate() && unit > 0) return QChar::surrogateToUcs4(letters[unit - 1], c);
    if (c.isHighSurrogate() && unit + 1 < letters.size())
        return QChar::surrogateToUcs4(c, letters[unit + 1]);
    return c.unicode();
}

/// Apart from their accents, letters are the same however they were written.
QString folded(const QString& letter) {
    return letter.normalized(QString::NormalizationForm_D)
        .toCaseFolded()
        .normalized(QString::NormalizationForm_D);
}

}  // namespace

FoldedText::FoldedText(const std::string& text) {
    for (size_t at = 0; at < text.size();) {
        const size_t begin = at;
        // Most of all texts, and there are long trails of them.
        if (is_ascii(text[at]) && (at + 1 == text.size() || is_ascii(text[at + 1]))) {
            letters_ += QChar::fromLatin1(text[at++]).toLower();
            at_.push_back(begin);
            continue;
        }
        QString letter = next_code_point(text, at);
        while (at < text.size()) {
            size_t end = at;
            const QString next = next_code_point(text, end);
            if (!QChar::isMark(code_of(next, 0))) break;
            letter += next;
            at = end;
        }
        letters_ += folded(letter);
        at_.resize(static_cast<size_t>(letters_.size()), begin);
    }
    at_.push_back(text.size());
}

bool FoldedText::begins_letter(qsizetype unit) const {
    const auto place = static_cast<size_t>(unit);
    return place == 0 || at_[place] != at_[place - 1];
}

bool FoldedText::is_in_a_word(qsizetype unit) const {
    if (unit < 0 || unit >= letters_.size()) return false;
    const char32_t code = code_of(letters_, unit);
    return QChar::isLetterOrNumber(code) || QChar::isMark(code);
}

std::optional<WordPlace> FoldedText::find(const FoldedText& word, size_t from) const {
    const qsizetype size = word.letters_.size();
    if (size == 0) return std::nullopt;
    qsizetype begin = std::lower_bound(at_.begin(), at_.end(), from) - at_.begin();
    for (; (begin = letters_.indexOf(word.letters_, begin)) >= 0; ++begin) {
        const qsizetype end = begin + size;
        if (!begins_letter(begin) || !begins_letter(end)) continue;  // An accent was left behind.
        if (is_in_a_word(begin - 1) || is_in_a_word(end)) continue;
        const size_t at = at_[static_cast<size_t>(begin)];
        return WordPlace{at, at_[static_cast<size_t>(end)] - at};
    }
    return std::nullopt;
}

bool holds_word(const std::string& text, const std::string& word) {
    return FoldedText(text).find(FoldedText(word)).has_value();
}

std::string in_several_cases(const std::string& text) {
    const QString small =
        QString::fromStdString(text).normalized(QString::NormalizationForm_C).toLower();
    QString capital = small;
    bool first = true;
    for (QChar& c : capital) {
        if (first) c = c.toUpper();
        first = !c.isLetterOrNumber();
    }
    return text + "\n" + small.toStdString() + "\n" + capital.toStdString();
}

}  // namespace placode::db
