// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/web/html.h"

#include <QUrl>

namespace placode::web {

std::string escaped(std::string_view words) {
    std::string out;
    out.reserve(words.size() + words.size() / 8);
    for (const char c : words) {
        switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            case '\'':
                out += "&#39;";
                break;
            case '\0':
                break;
            default:
                out += c;
        }
    }
    return out;
}

Text text(std::string_view words) { return {escaped(words)}; }
Text text(const QString& words) { return text(words.toStdString()); }

std::string path_part(const std::string& words) {
    return QUrl::toPercentEncoding(QString::fromStdString(words)).toStdString();
}

std::string query(const std::vector<QueryPart>& parts) {
    std::string out;
    for (const QueryPart& part : parts) {
        if (part.value.empty()) continue;
        out += (out.empty() ? "?" : "&") + path_part(part.key) + "=" + path_part(part.value);
    }
    return out;
}

Html link(const std::string& address, const Html& words) {
    Html out;
    out << "<a href=\"" << text(address) << "\">" << words << "</a>";
    return out;
}

Table::Table(Text caption, std::vector<Column> columns)
    : caption_(std::move(caption)), columns_(std::move(columns)) {}

void Table::row(const std::vector<Html>& cells) {
    ++rows_;
    body_ << "<tr>";
    for (size_t i = 0; i < cells.size() && i < columns_.size(); ++i) {
        if (i == 0)
            body_ << "<th scope=\"row\">" << cells[i] << "</th>";
        else if (columns_[i].number)
            body_ << "<td class=\"number\">" << cells[i] << "</td>";
        else
            body_ << "<td>" << cells[i] << "</td>";
    }
    body_ << "</tr>\n";
}

Html Table::html() const {
    Html out;
    // It can be reached by the keyboard, because what is scrolled has to be.
    out << "<div class=\"scroll\" role=\"region\" tabindex=\"0\" aria-label=\"" << caption_
        << "\"><table><caption>" << caption_ << "</caption><thead><tr>";
    for (const Column& column : columns_) {
        if (column.number)
            out << "<th scope=\"col\" class=\"number\">";
        else
            out << "<th scope=\"col\">";
        out << column.title << "</th>";
    }
    out << "</tr></thead><tbody>\n" << body_ << "</tbody></table></div>\n";
    return out;
}

Html badge(const Html& words, Tone tone) {
    Html out;
    switch (tone) {
        case Tone::kPlain:
            out << "<span class=\"badge\">";
            break;
        case Tone::kGood:
            out << "<span class=\"badge good\">";
            break;
        case Tone::kWarn:
            out << "<span class=\"badge warn\">";
            break;
        case Tone::kCritical:
            out << "<span class=\"badge critical\">";
            break;
    }
    out << words << "</span>";
    return out;
}

void Facts::add(const Html& name, const Html& value) {
    body_ << "<div><dt>" << name << "</dt><dd>" << value << "</dd></div>";
}

Html Facts::html() const {
    Html out;
    out << "<dl class=\"facts\">" << body_ << "</dl>\n";
    return out;
}

Html card(const Html& heading, const Html& body) {
    Html out;
    out << "<section class=\"card\"><h2>" << heading << "</h2>\n" << body << "</section>\n";
    return out;
}

}  // namespace placode::web
