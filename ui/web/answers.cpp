// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/web/answers.h"

#include <algorithm>

#include "db/access.h"
#include "ui/web/words.h"

namespace placode::web {
namespace {

/// "You may not ...; an educator can.": not what was being done and where the store lies, as other
/// refusals say.
Text refusal_words(const db::StoreError& error) {
    return error.said() == nullptr || !db::is_about_rights(*error.said())
               ? Web::phrase("You may not see this.")
               : text(reports::said_words(*error.said()));
}

}  // namespace

const std::string& policy_with_script() {
    static const std::string policy =
        "default-src 'none'; script-src 'self'; connect-src 'self'; style-src 'self'; img-src "
        "'self' data:; form-action 'self'; frame-ancestors 'none'; base-uri 'none'";
    return policy;
}

const std::vector<std::pair<std::string, std::string>>& fixed_headers() {
    static const std::vector<std::pair<std::string, std::string>> headers{
        {"Content-Security-Policy",
         "default-src 'none'; style-src 'self'; img-src 'self' data:; form-action 'self'; "
         "frame-ancestors 'none'; base-uri 'none'"},
        {"X-Content-Type-Options", "nosniff"},
        {"Referrer-Policy", "no-referrer"},
        {"Cross-Origin-Opener-Policy", "same-origin"},
        {"Cross-Origin-Resource-Policy", "same-origin"},
        {"Cache-Control", "no-store"}};
    return headers;
}

Answer redirect(const std::string& to) {
    Answer answer;
    answer.status = 303;
    answer.headers.emplace_back("Location", to);
    return answer;
}

Answer message(int status, const Text& title, const Html& words, const Reader& reader) {
    Html body;
    body << "<h1>" << title << "</h1>\n<p>" << words << "</p>\n";
    if (reader.user != nullptr)
        body << "<p>" << link("/", Web::phrase("Back to my page")) << "</p>\n";
    Answer answer;
    answer.status = status;
    answer.body = document(title, body, reader);
    return answer;
}

Answer trouble(const db::StoreError& error, const Reader& reader) {
    using Kind = db::StoreError::Kind;
    switch (error.kind()) {
        case Kind::kRefused:
            return message(403, Web::phrase("Not for you"), refusal_words(error), reader);
        case Kind::kNotFound:
            return message(404, Web::phrase("Not there"),
                           Web::phrase("What this page is about is not in the store."), reader);
        case Kind::kLocked:
        case Kind::kUnavailable:
            return message(503, Web::phrase("Not now"),
                           Web::phrase("The store cannot be reached at the moment. Try again."),
                           reader);
        default:
            return message(
                500, Web::phrase("Something is wrong"),
                Web::phrase("The store cannot be read. Whoever runs this computer finds the "
                            "reason in the program's log."),
                reader);
    }
}

Answer fault(const Reader& reader) {
    return message(
        500, Web::phrase("Something is wrong"),
        Web::phrase(
            "The page could not be made. Whoever runs this computer finds the reason in the "
            "program's log."),
        reader);
}

Answer refusal(int status) {
    if (status == 404)
        return message(404, Web::phrase("Not there"), Web::phrase("There is no such page."));
    if (status == 405)
        return message(405, Web::phrase("For reading only"),
                       Web::phrase("Nothing can be sent to this page."));
    if (status == 413 || status == 414)
        return message(status, Web::phrase("Too long"),
                       Web::phrase("The request is longer than any page asks for."));
    return message(status, Web::phrase("Not understood"),
                   Web::phrase("The request cannot be read."));
}

std::string cookie_of(const std::string& header, const std::string& name) {
    for (size_t begin = 0; begin < header.size();) {
        const size_t end = std::min(header.find(';', begin), header.size());
        std::string one = header.substr(begin, end - begin);
        one.erase(0, std::min(one.find_first_not_of(' '), one.size()));
        if (one.rfind(name + "=", 0) == 0) return one.substr(name.size() + 1);
        begin = end + 1;
    }
    return {};
}

}  // namespace placode::web
