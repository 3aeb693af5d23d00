// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/web/frame.h"

#include <QFile>

#include "db/access.h"
#include "ui/web/words.h"

namespace placode::web {

using namespace std::string_view_literals;

namespace {

Html rail_entry(const Reader& reader, const std::string& path, const Text& words) {
    Html out;
    out << "<li><a href=\"" << text(path) << "\"";
    if (reader.path == path) out << " aria-current=\"page\"";
    out << ">" << words << "</a></li>";
    return out;
}

/// What the roles lead to; whether it may be seen, the store says.
Html rail(const Reader& reader) {
    const auto may = [&](db::Action action) {
        return db::allowed(reader.user->roles, action, db::Scope::kOther);
    };
    Html out;
    out << "<nav class=\"rail\" aria-label=\"" << Web::phrase("Main") << "\"><ul>"
        << rail_entry(reader, "/", Web::phrase("My page"));
    if (may(db::Action::kViewAttempts))
        out << rail_entry(reader, "/cohort", Web::phrase("Cohort"))
            << rail_entry(reader, "/attempts", Web::phrase("Attempts"))
            << rail_entry(reader, "/standards", Web::phrase("Standards"))
            << rail_entry(reader, "/norms", Web::phrase("Norms"));
    if (may(db::Action::kRunQuestionnaire))
        out << rail_entry(reader, "/studies", Web::phrase("Studies"));
    if (may(db::Action::kViewPersonalData))
        out << rail_entry(reader, "/people", Web::phrase("People"));
    out << "</ul></nav>";
    return out;
}

/// One entry of the switch, named in its own language.
Html language_entry(const Reader& reader, std::string_view code, std::string_view name) {
    const bool asks = reader.address.find('?') != std::string::npos;
    Html out;
    out << "<li><a href=\"" << text(reader.address) << text(asks ? "&"sv : "?"sv)
        << text(std::string_view(kLanguageKey)) << "=" << text(code) << "\" hreflang=\""
        << text(code) << "\" lang=\"" << text(code) << "\" aria-label=\"" << text(name) << "\"";
    if (code == spoken_code()) out << " aria-current=\"true\"";
    out << ">"
        << text(QString::fromUtf8(code.data(), static_cast<qsizetype>(code.size())).toUpper())
        << "</a></li>";
    return out;
}

Html languages(const Reader& reader) {
    Html out;
    out << "<nav class=\"languages\" aria-label=\"" << Web::phrase("Language") << "\"><ul>"
        << language_entry(reader, "en", "EN, English") << language_entry(reader, "pl", "PL, polski")
        << "</ul></nav>";
    return out;
}

}  // namespace

std::string review_script(const std::string& name) {
    // A resource of this program: nothing that is asked for leads to a file.
    QFile file(QStringLiteral(":/web/review/") + QString::fromStdString(name));
    if (!name.ends_with(".js") || !file.open(QIODevice::ReadOnly)) return {};
    return file.readAll().toStdString();
}

std::string document(const Text& title, const Html& body, const Reader& reader) {
    const Text placode = text("Placode"sv);
    Html out;
    out << "<!doctype html>\n<html lang=\"" << text(spoken_code())
        << "\"><head><meta charset=\"utf-8\"><title>" << title << " · " << placode
        << "</title><meta name=\"viewport\" content=\"width=device-width, "
           "initial-scale=1\"><meta name=\"color-scheme\" content=\"light dark\"><link "
           "rel=\"icon\" href=\"data:,\"><link rel=\"stylesheet\" "
           "href=\"/style.css\"></head>\n<body><a class=\"skip\" href=\"#content\">"
        << Web::phrase("Skip to the content") << "</a>\n<header><a class=\"brand\" href=\"/\">"
        << placode << "</a>";
    if (reader.user != nullptr) out << rail(reader);
    out << languages(reader);
    if (reader.user != nullptr)
        out << "<form class=\"out\" method=\"post\" action=\"/sign-out\"><input type=\"hidden\" "
               "name=\"form_token\" value=\""
            << text(reader.form_token) << "\"><span class=\"small\">"
            << text(reader.user->display_name) << "</span> <button type=\"submit\">"
            << Web::phrase("Sign out") << "</button></form>";
    out << "</header>\n<main id=\"content\" tabindex=\"-1\">\n"
        << body << "</main>\n<footer>"
        << Web::phrase(
               "Placode, for reading only: what is to be changed is changed in the program on the "
               "station. Times are UTC.")
        << "</footer></body></html>\n";
    return out.str();
}

}  // namespace placode::web
