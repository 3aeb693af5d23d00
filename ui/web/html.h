// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Pages as text. What somebody typed can only get in escaped: markup is what stands in this
// program's source, known to the compiler, and everything else is Text.

#include <QString>
#include <concepts>
#include <string>
#include <string_view>
#include <vector>

namespace placode::web {

/// `&`, `<`, `>` and both quotes as entities; a NUL is left out. For text and attributes alike.
[[nodiscard]] std::string escaped(std::string_view text);

/// Markup from the source of this program.
struct Markup {
    std::string_view text;
    consteval Markup(const char* literal) : text(literal) {}  // NOLINT: meant to be implicit
};

/// What is shown as it is, whatever stands in it.
struct Text {
    std::string escaped_text;
};
[[nodiscard]] Text text(std::string_view words);
[[nodiscard]] Text text(const char* words);
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

/// "key=value&...", percent-encoded; empty values are left out. With the question mark.
struct QueryPart {
    std::string key, value;
};
[[nodiscard]] std::string query(const std::vector<QueryPart>& parts);
/// A part of a path, percent-encoded.
[[nodiscard]] std::string path_part(const std::string& words);

/// `<a href>`; the address is escaped here.
[[nodiscard]] Html link(const std::string& address, const Html& words);

struct Column {
    std::string title;
    bool number = false;  ///< Set to the right, figures of one width.
};

/// A table with caption and heads that name row and column, in a box of its own that scrolls where
/// the page is narrow; the first cell of a row is its head.
class Table {
 public:
    Table(std::string caption, std::vector<Column> columns);
    void row(const std::vector<Html>& cells);
    [[nodiscard]] bool empty() const noexcept { return rows_ == 0; }
    [[nodiscard]] Html html() const;

 private:
    std::string caption_;
    std::vector<Column> columns_;
    Html body_;
    int rows_ = 0;
};

/// A word with a tone that says the same by colour: "good", "warn", "critical" or "".
[[nodiscard]] Html badge(const Html& words, Markup tone);

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
