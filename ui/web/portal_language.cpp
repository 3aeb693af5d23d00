// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// In which language a visit is answered: the one chosen in the head of a page, kept in a cookie;
// else what the browser asks for; else English.

#include <QUrl>
#include <algorithm>

#include "ui/web/portal.h"

namespace placode::web {
namespace {

constexpr int kYearS = 365 * 86400;

bool is_ours(std::string_view code) {
    return std::find(std::begin(kLanguages), std::end(kLanguages), code) != std::end(kLanguages);
}

}  // namespace

std::string address_of(const Request& request) {
    // "//host/page" would lead a browser to another host.
    if (request.path.empty() || request.path[0] != '/' || request.path.starts_with("//"))
        return "/";
    std::vector<QueryPart> parts;
    for (const auto& [key, value] : request.query)
        if (key != kLanguageKey) parts.push_back({key, value});
    return QUrl::toPercentEncoding(QString::fromStdString(request.path), "/").toStdString() +
           query(parts);
}

std::string Portal::language_name() const { return session_name() + "-language"; }

QLocale Portal::language_of(const Request& request) const {
    const std::string chosen = cookie_of(request.cookies, language_name());
    return locale_of(is_ours(chosen) ? chosen : liked_language(request.languages));
}

std::optional<Answer> Portal::choose_language(const Request& request) const {
    const auto asked = request.query.find(kLanguageKey);
    if (asked == request.query.end() || !is_ours(asked->second)) return std::nullopt;
    Answer answer = redirect(address_of(request));
    answer.headers.emplace_back("Set-Cookie", cookie(language_name(), asked->second) +
                                                  "; Max-Age=" + std::to_string(kYearS));
    return answer;
}

}  // namespace placode::web
