// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What pages say, in the language of whoever asks for the page. The English text stands at its
// place in the source, in `Web::phrase("...")`; its Polish, and the forms of counted nouns, in the
// shell's translation files (context Web). Which language is spoken goes with the thread that
// answers (reports::Speaking): the reports' own words follow it, too.

#include <QCoreApplication>
#include <QString>
#include <QTranslator>
#include <concepts>
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
    const char* english;
    consteval Phrase(const char* literal) : english(literal) {}  // NOLINT: meant to be implicit
};

/// The portal's texts. The translation tool finds them by these names (cmake/compiler.cmake).
class Web {
    Q_DECLARE_TR_FUNCTIONS(Web)

 public:
    /// Plain text, which is no markup yet.
    [[nodiscard]] static std::string plain_phrase(Phrase english,
                                                  const std::vector<std::string>& parts = {});

    /// The phrase with its places filled, for a page.
    template <std::same_as<Text>... Parts>
    [[nodiscard]] static Text phrase(Phrase english, const Parts&... parts);
    template <typename... Parts>
    [[nodiscard]] static Html phrase(Phrase english, const Parts&... parts);

    /// A number, %n, with its noun in the form that goes with it: "%n attempt(s)".
    template <std::same_as<Text>... Parts>
    [[nodiscard]] static Text count_phrase(Phrase english, std::integral auto number,
                                           const Parts&... parts);
    /// The same, plain.
    [[nodiscard]] static std::string plain_count_phrase(Phrase english, std::integral auto number);
};

/// A text of a definition, in the reader's language.
[[nodiscard]] const std::string& in_words(const curriculum::LocalText& text);
/// The decimal sign of the language in a number as reports write it.
[[nodiscard]] Text number_text(const QString& number);

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
[[nodiscard]] std::string translated(const char* english);
[[nodiscard]] std::string counted(const char* english, int64_t number);
/// One pass: a place in what is filled in stays.
[[nodiscard]] std::string filled(const std::string& pattern, const std::vector<std::string>& parts);
}  // namespace inside

template <std::same_as<Text>... Parts>
Text Web::phrase(Phrase english, const Parts&... parts) {
    return {inside::filled(escaped(inside::translated(english.english)), {parts.escaped_text...})};
}

template <typename... Parts>
Html Web::phrase(Phrase english, const Parts&... parts) {
    return Html(
        Text{inside::filled(escaped(inside::translated(english.english)), {Html(parts).str()...})});
}

template <std::same_as<Text>... Parts>
Text Web::count_phrase(Phrase english, std::integral auto number, const Parts&... parts) {
    return {inside::filled(escaped(inside::counted(english.english, static_cast<int64_t>(number))),
                           {parts.escaped_text...})};
}

std::string Web::plain_count_phrase(Phrase english, std::integral auto number) {
    return inside::counted(english.english, static_cast<int64_t>(number));
}

}  // namespace placode::web
