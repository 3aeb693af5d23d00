// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Requests and answers without the network, and the short pages that say why there is no other.

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "db/store_error.h"
#include "ui/web/frame.h"

namespace placode::web {

struct Request {
    std::string method;  ///< "GET" also stands for HEAD.
    std::string path;    ///< Decoded, without the query.
    std::map<std::string, std::string> query, form;
    std::string cookies;    ///< The header.
    std::string languages;  ///< The header Accept-Language.
};

struct Answer {
    int status = 200;
    std::string type = "text/html; charset=utf-8";
    std::string body;
    std::vector<std::pair<std::string, std::string>> headers;
};

/// Where learning platforms send people.
inline constexpr const char *kLtiLogin = "/lti/login", *kLtiLaunch = "/lti/launch";

/// The content security policy of a page that may run the script of this host and fetch from it.
[[nodiscard]] const std::string& policy_with_script();
/// On every answer, whatever it is; an answer may bring its own of a name.
[[nodiscard]] const std::vector<std::pair<std::string, std::string>>& fixed_headers();

[[nodiscard]] Answer redirect(const std::string& to);
/// A page of a heading and a sentence.
[[nodiscard]] Answer message(int status, const Text& title, const Html& words,
                             const Reader& reader = {});
/// What the store's trouble is to somebody at a browser; the log says it exactly.
[[nodiscard]] Answer trouble(const db::StoreError& error, const Reader& reader);
/// The page could not be made; why, the log says.
[[nodiscard]] Answer fault(const Reader& reader = {});
/// What is wrong with a request that asks for no page.
[[nodiscard]] Answer refusal(int status);

/// Path and query as a browser asks for them, without a language that is chosen in it; always on
/// this host.
[[nodiscard]] std::string address_of(const Request& request);

/// A value in the header of cookies; empty where there is none.
[[nodiscard]] std::string cookie_of(const std::string& header, const std::string& name);

}  // namespace placode::web
