// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What pages say, in the language of whoever asks for the page. The English text stands at its
// place in the source; polish.cpp has the Polish of each, and a test compares the two. Which
// language is spoken goes with the thread that answers (reports::Speaking): the reports' own words
// follow it, too.

#include <QString>
#include <QTranslator>
#include <concepts>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "curriculum/task.h"
#include "reports/words.h"
#include "ui/web/html.h"

namespace placode::web {

/// Languages of the portal by their codes.
inline constexpr std::string_view kLanguages[]{"en", "pl"};
/// "en" or "pl": what this thread speaks.
[[nodiscard]] std::string spoken_code();
/// For reports::Speaking. English for every other code.
[[nodiscard]] QLocale locale_of(std::string_view code);
/// The language that a header Accept-Language likes best of those there are; English where it names
/// none.
[[nodiscard]] std::string_view liked_language(const std::string& accept_language);

/// English words that stand in the source. %1 to %9 are places to be filled. Where the same English
/// has several meanings, what follows an @ tells them apart and is not shown: "open@record".
struct Phrase {
    std::string_view english;
    consteval Phrase(const char* literal) : english(literal) {}  // NOLINT: meant to be implicit
};

/// Plain text, which is no markup yet.
[[nodiscard]] std::string words(Phrase english, const std::vector<std::string>& parts = {});

/// The phrase with its places filled, for a page.
template <std::same_as<Text>... Parts>
[[nodiscard]] Text say(Phrase english, const Parts&... parts);
template <typename... Parts>
[[nodiscard]] Html say(Phrase english, const Parts&... parts);

/// A number with its noun; %1 is the number. @param many the English plural, by which polish.cpp
/// has the three Polish forms (1, 2 to 4, 5 and more).
template <std::same_as<Text>... Parts>
[[nodiscard]] Text say_count(std::integral auto number, Phrase one, Phrase many,
                             const Parts&... parts);

/// The same, plain.
[[nodiscard]] std::string words_count(std::integral auto number, Phrase one, Phrase many);

/// A text of a definition, in the reader's language.
[[nodiscard]] const std::string& in_words(const curriculum::LocalText& text);
/// The decimal sign of the language in a number as reports write it.
[[nodiscard]] Text number_text(const QString& number);

/// One entry of the table; `few` and `many` only where a number stands.
struct Polish {
    std::string_view english, polish, few = {}, many = {};
};
[[nodiscard]] std::span<const Polish> polish_table();  // polish.cpp

/// The reports' words in Polish (the shell's translation file), for threads that speak it.
class ReportsInPolish : public QTranslator {
 public:
    ReportsInPolish();  ///< Throws std::runtime_error where this program was built without it.
    [[nodiscard]] bool isEmpty() const override { return false; }
    [[nodiscard]] QString translate(const char* context, const char* english, const char* remark,
                                    int number) const override;
};

namespace inside {
/// What to say, with places.
[[nodiscard]] std::string escaped_phrase(std::string_view english);
[[nodiscard]] std::string_view counted_phrase(int64_t number, std::string_view one,
                                              std::string_view many);
/// One pass: a place in what is filled in stays.
[[nodiscard]] std::string filled(const std::string& pattern, const std::vector<std::string>& parts);
}  // namespace inside

template <std::same_as<Text>... Parts>
Text say(Phrase english, const Parts&... parts) {
    return {inside::filled(inside::escaped_phrase(english.english), {parts.escaped_text...})};
}

template <typename... Parts>
Html say(Phrase english, const Parts&... parts) {
    return Html(
        Text{inside::filled(inside::escaped_phrase(english.english), {Html(parts).str()...})});
}

template <std::same_as<Text>... Parts>
Text say_count(std::integral auto number, Phrase one, Phrase many, const Parts&... parts) {
    const auto n = static_cast<int64_t>(number);
    return {inside::filled(escaped(inside::counted_phrase(n, one.english, many.english)),
                           {std::to_string(n), parts.escaped_text...})};
}

std::string words_count(std::integral auto number, Phrase one, Phrase many) {
    const auto n = static_cast<int64_t>(number);
    return inside::filled(std::string(inside::counted_phrase(n, one.english, many.english)),
                          {std::to_string(n)});
}

}  // namespace placode::web
