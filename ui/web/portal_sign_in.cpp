// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Into the portal and out of it.

#include <algorithm>
#include <chrono>

#include "ui/web/portal.h"
#include "ui/web/words.h"

namespace placode::web {

std::string Portal::session_name() const {
    return options_.behind_tls ? "__Host-placode" : "placode";
}
std::string Portal::form_name() const { return session_name() + "-form"; }

std::string Portal::cookie(const std::string& name, const std::string& value) const {
    return name + "=" + value + "; Path=/; HttpOnly; SameSite=Strict" +
           (options_.behind_tls ? "; Secure" : "") + (value.empty() ? "; Max-Age=0" : "");
}

Answer Portal::sign_in_form(const Html& said, int status) {
    const std::string token = new_token();
    Html body;
    body << "<section class=\"card narrow\"><h1>" << Web::phrase("Sign in")
         << "</h1>\n<p class=\"muted\">"
         << Web::phrase("With your account of Placode. Here everything is for reading only.")
         << "</p>\n";
    if (!said.empty()) body << "<p class=\"said\" role=\"alert\">" << said << "</p>\n";
    body << "<form method=\"post\" action=\"/sign-in\"><input type=\"hidden\" name=\"form_token\" "
            "value=\""
         << text(token) << "\"><div class=\"row\"><label for=\"login\">"
         << Web::phrase("Log-in name")
         << "</label><input id=\"login\" name=\"login\" autocomplete=\"username\" "
            "autocapitalize=\"none\" maxlength=\"200\" required></div><div class=\"row\"><label "
            "for=\"password\">"
         << Web::phrase("Password")
         << "</label><input id=\"password\" name=\"password\" type=\"password\" "
            "autocomplete=\"current-password\" maxlength=\"1000\" required></div><button "
            "class=\"primary\" type=\"submit\">"
         << Web::phrase("Sign in") << "</button></form></section>\n";
    Answer answer;
    answer.status = status;
    Reader nobody;
    nobody.address = "/sign-in";
    answer.body = document(Web::phrase("Sign in"), body, nobody);
    answer.headers.emplace_back("Set-Cookie", cookie(form_name(), token));
    return answer;
}

// The one thing that this program writes: the store counts wrong passwords and keeps who signed in
// when.
db::SignIn Portal::ask_the_store(const std::string& login, const std::string& password) {
    db::StoreOptions there = options_.store;
    there.known = true;  // It was there when this program began; no new one is made.
    there.portal = true;
    const auto store = db::open_store(options_.store_url, there);
    store->sign_out();
    return store->accounts().sign_in(login, password);
}

Answer Portal::sign_in(const Request& request) {
    const auto typed = [&](const char* key) {
        const auto found = request.form.find(key);
        return found == request.form.end() ? std::string() : found->second;
    };
    if (!same_token(typed("form_token"), cookie_of(request.cookies, form_name())))
        return sign_in_form(Web::phrase("That page was too old, or cookies are off. Try again."),
                            403);
    if (typed("login").empty() || typed("password").empty())
        return sign_in_form(Web::phrase("Type your log-in name and your password."), 403);
    db::SignIn found;
    try {
        const std::unique_lock door(door_, std::chrono::seconds(10));
        if (!door.owns_lock())
            return sign_in_form(Web::phrase("Many people are signing in. Try again in a moment."),
                                503);
        found = ask_the_store(typed("login"), typed("password"));
    } catch (const db::StoreError& error) {
        options_.log(std::string("sign in: ") + error.what());
        return trouble(error, {});
    }
    if (found.outcome == db::SignInOutcome::kThrottled) {
        Answer answer = sign_in_form(Web::phrase("Too many wrong passwords. Try again in %1 s.",
                                                 text(std::max(1, found.wait_s))),
                                     429);
        answer.headers.emplace_back("Retry-After", std::to_string(std::max(1, found.wait_s)));
        return answer;
    }
    if (found.outcome == db::SignInOutcome::kDeactivated)
        return sign_in_form(
            Web::phrase("This account is deactivated. An administrator can open it again."), 403);
    if (!found.user)
        return sign_in_form(Web::phrase("Log-in name or password is wrong. Try again."), 403);
    if (found.user->password_given)
        return sign_in_form(
            Web::phrase("Somebody else chose your password and knows it. Sign in to the "
                        "program Placode and choose your own, then come back."),
            403);
    sessions_.end(cookie_of(request.cookies, session_name()));
    Answer answer = redirect("/");
    answer.headers.emplace_back("Set-Cookie",
                                cookie(session_name(), sessions_.begin(found.user->id)));
    answer.headers.emplace_back("Set-Cookie", cookie(form_name(), ""));
    return answer;
}

Answer Portal::sign_out(const Request& request) {
    const Signed who = signed_in(request);
    const auto token = request.form.find("form_token");
    if (who.session.account != 0 &&
        (token == request.form.end() || !same_token(token->second, who.session.form_token)))
        return message(403, Web::phrase("Not signed out"),
                       Web::phrase("That did not come from a page of this portal."));
    sessions_.end(who.token);
    Answer answer = redirect("/sign-in");
    answer.headers.emplace_back("Set-Cookie", cookie(session_name(), ""));
    return answer;
}

}  // namespace placode::web
