// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Pages as text. What somebody typed can only get in escaped: markup is what stands in this
// program's source, known to the compiler, and everything else is Text. Markup says nothing: words
// come from words.h, in the reader's language, and the compiler refuses others.

#include <QString>
#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace placode::web {

/// `&`, `<`, `>` and both quotes as entities; a NUL is left out. For text and attributes alike.
[[nodiscard]] std::string escaped(std::string_view text);

/// True for letters outside tags, and in the attributes that are read out.
[[nodiscard]] constexpr bool says_something(std::string_view markup) {
    const size_t open = markup.find('<'), close = markup.find('>');
    // A piece may begin within a tag.
    bool in_tag = close < open || (open == std::string_view::npos && markup.find('"') != open);
    for (const char c : markup) {
        if (c == '<' || c == '>') in_tag = c == '<';
        if (!in_tag && ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'))) return true;
    }
    for (const std::string_view read_out : {"label=\"", "alt=\"", "title=\"", "placeholder=\""}) {
        const size_t at = markup.find(read_out);
        if (at != std::string_view::npos && at + read_out.size() < markup.size()) return true;
    }
    return false;
}

/// Markup from the source of this program, without words.
struct Markup {
    std::string_view text;
    consteval Markup(const char* literal) : text(literal) {  // NOLINT: meant to be implicit
        if (says_something(text)) throw "words belong into Web::phrase() of ui/web/words.h";
    }
};

/// What is shown as it is, whatever stands in it.
struct Text {
    std::string escaped_text;
};
[[nodiscard]] Text text(std::string_view words);
Text text(const char* words) =
    delete;  ///< Web::phrase("...") translates; a name or a sign is "–"sv.
[[nodiscard]] Text text(const QString& words);
[[nodiscard]] Text text(std::integral auto number) { return text(std::to_string(number)); }

class Html {
 public:
    Html() = default;
    Html(Markup markup) : text_(markup.text) {}                 // NOLINT: meant to be implicit
    Html(Text words) : text_(std::move(words.escaped_text)) {}  // NOLINT: meant to be implicit

    Html& operator<<(Markup markup) {
        text_ += markup.text;
        return *this;
    }
    Html& operator<<(const Text& words) {
        text_ += words.escaped_text;
        return *this;
    }
    Html& operator<<(const Html& part) {
        text_ += part.text_;
        return *this;
    }
    [[nodiscard]] const std::string& str() const noexcept { return text_; }
    [[nodiscard]] bool empty() const noexcept { return text_.empty(); }

 private:
    std::string text_;
};

/// "key=value&...", both percent-encoded; empty values are left out. With the question mark.
struct QueryPart {
    std::string key, value;
};
[[nodiscard]] std::string query(const std::vector<QueryPart>& parts);
/// A part of a path, percent-encoded.
[[nodiscard]] std::string path_part(const std::string& words);

/// `<a href>`; the address is escaped here.
[[nodiscard]] Html link(const std::string& address, const Html& words);

struct Column {
    Text title;
    bool number = false;  ///< Set to the right, figures of one width.
};

/// A table with caption and heads that name row and column, in a box of its own that scrolls where
/// the page is narrow; the first cell of a row is its head.
class Table {
 public:
    Table(Text caption, std::vector<Column> columns);
    void row(const std::vector<Html>& cells);
    [[nodiscard]] bool empty() const noexcept { return rows_ == 0; }
    [[nodiscard]] Html html() const;

 private:
    Text caption_;
    std::vector<Column> columns_;
    Html body_;
    int rows_ = 0;
};

/// A word, and a tone that says the same by colour.
enum class Tone : uint8_t { kPlain, kGood, kWarn, kCritical };
[[nodiscard]] Html badge(const Html& words, Tone tone);

/// Name and value, one under the other.
class Facts {
 public:
    void add(const Html& name, const Html& value);
    [[nodiscard]] Html html() const;

 private:
    Html body_;
};

/// A card with a heading of the second level.
[[nodiscard]] Html card(const Html& heading, const Html& body);

}  // namespace placode::web
