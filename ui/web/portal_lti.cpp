// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Into the portal from a learning platform, by LTI 1.3: the platform says who somebody is, the
// settings say whose account that is, and nothing is guessed from names or addresses.

#include <algorithm>
#include <ctime>

#include "db/attempt_counting.h"
#include "db/password.h"
#include "db/reading_store.h"
#include "ui/lti/launch.h"
#include "ui/lti/web_client.h"
#include "ui/web/lti_visitors.h"
#include "ui/web/portal.h"

namespace placode::web {
namespace {

Answer not_in(int status, const Html& why) {
    return message(status, Web::phrase("Not signed in"), why);
}

Answer too_many() {
    Answer answer = not_in(429, Web::phrase("Many people are signing in. Try again in a moment."));
    answer.headers.emplace_back("Retry-After", "1");
    return answer;
}

/// Everybody learns the class of the reason, the log the reason.
Text words_of(lti::Refusal refusal) {
    using lti::Refusal;
    switch (refusal) {
        case Refusal::kMalformed:
            return Web::phrase("The platform's answer is incomplete or cannot be read.");
        case Refusal::kAlgorithm:
            return Web::phrase("The platform's answer is not signed with RS256.");
        case Refusal::kUnknownKey:
            return Web::phrase(
                "The platform's answer is signed with a key that the platform does not "
                "publish, or its keys cannot be read now. Try again in a minute.");
        case Refusal::kSignature:
            return Web::phrase("The signature of the platform's answer is wrong.");
        case Refusal::kIssuer:
            return Web::phrase(
                "The answer comes from another platform than the one that was asked.");
        case Refusal::kAudience:
            return Web::phrase("The platform's answer is for another tool.");
        case Refusal::kTime:
            return Web::phrase(
                "The platform's answer is too old, or the clocks of platform and portal "
                "differ. Start again from your course.");
        case Refusal::kNonce:
            return Web::phrase(
                "The platform's answer belongs to another sign-in. Start again from your "
                "course.");
        case Refusal::kDeployment:
            return Web::phrase("This deployment of the platform is not registered here.");
        case Refusal::kMessage:
            return Web::phrase(
                "From a platform, links to this portal can be opened by LTI 1.3, and "
                "nothing else.");
    }
    return {};
}

/// What a platform says went wrong ("login_required"): a word, or nothing that is shown.
std::string word_of(const std::string& said) {
    const bool is_word = said.size() <= 60 &&
                         said.find_first_not_of("abcdefghijklmnopqrstuvwxyz_") == std::string::npos;
    return is_word ? said : "?";
}

std::string value_of(const std::map<std::string, std::string>& values, const char* key) {
    const auto found = values.find(key);
    return found == values.end() ? std::string() : found->second;
}

Answer unknown_person(const lti::Platform& platform, const std::string& subject) {
    if (subject.empty()) return not_in(403, Web::phrase("The platform did not say who you are."));
    Html body;
    body << Web::phrase(
                "Nobody has said yet which account of Placode is yours. Give an administrator of "
                "Placode this address and this number of yours:")
         << "</p>\n<p><code>" << text(std::string_view(platform.issuer)) << "</code> · <code>"
         << text(std::string_view(subject)) << "</code>";
    return message(403, Web::phrase("Not known here yet"), body);
}

bool is_for(const lti::Link& link, const db::UserRecord& user) {
    return link.account == user.id && db::login_key(link.login) == db::login_key(user.login);
}

/// The own page of a task, where there is something on it.
std::string page_of(db::Store& store, int64_t account, const std::string& task) {
    if (task.empty()) return "/";
    const auto attempts = store.attempts().list(account, task);
    const bool any = std::any_of(attempts.begin(), attempts.end(), db::counts);
    return any ? "/people/" + std::to_string(account) + "/tasks/" + path_part(task) : "/";
}

}  // namespace

bool Portal::takes_forms(const std::string& path) const {
    return path == "/sign-in" || path == "/sign-out" ||
           (visitors_ != nullptr && (path == kLtiLogin || path == kLtiLaunch));
}

// Another host sends the browser here, which for that reason brings no cookie of this host unless
// it says so; and it says so of none that is not for https alone.
std::string Portal::lti_cookie(const std::string& value) const {
    return session_name() + "-lti=" + value + "; Path=/; HttpOnly; Max-Age=" +
           (value.empty() ? "0" : std::to_string(Arrivals::kLifeS)) +
           (options_.behind_tls ? "; Secure; SameSite=None" : "");
}

Answer Portal::lti(const Request& request) {
    try {
        const bool post = request.method == "POST";
        if (request.path == kLtiLogin && (post || request.method == "GET"))
            return lti_login(post ? request.form : request.query);
        if (request.path == kLtiLaunch && post) return lti_launch(request);
        if (request.path == "/lti/jwks.json" && request.method == "GET") return lti_keys();
    } catch (const lti::SettingsError& error) {
        options_.log(std::string("lti: ") + error.what());
        return fault();
    }
    return refusal(request.method == "GET" ? 404 : 405);
}

Answer Portal::lti_keys() {
    const lti::Settings settings = lti::read_settings(options_.lti_file);
    const lti::SigningKey key(lti::read_secret(settings.private_key_file));
    Answer answer;
    answer.type = "application/json";
    answer.body = lti::key_set_text(key.public_key());
    return answer;
}

Answer Portal::lti_login(const std::map<std::string, std::string>& said) {
    const int64_t now = options_.now_s();
    if (!visitors_->logins.take(now)) return too_many();
    // Read each time: a link that placodectl adds counts at once.
    const lti::Settings settings = lti::read_settings(options_.lti_file);
    const lti::Platform* platform =
        settings.platform(value_of(said, "iss"), value_of(said, "client_id"));
    if (platform == nullptr)
        return not_in(400, Web::phrase("This platform is not registered here."));
    const std::string hint = value_of(said, "login_hint");
    if (hint.empty()) return not_in(400, Web::phrase("The platform did not say who you are."));
    Arrival arrival{platform->issuer, platform->client_id, new_token(), new_token(), now};
    const std::string browser = arrival.browser, nonce = arrival.nonce;
    std::vector<std::pair<std::string, std::string>> asked{
        {"scope", "openid"},
        {"response_type", "id_token"},
        {"response_mode", "form_post"},
        {"prompt", "none"},
        {"client_id", platform->client_id},
        {"redirect_uri", settings.launch_url()},
        {"login_hint", hint},
        {"state", visitors_->arrivals.begin(std::move(arrival))},
        {"nonce", nonce}};
    // target_link_uri is not needed: where somebody goes is in the signed answer.
    const std::string message_hint = value_of(said, "lti_message_hint");
    if (!message_hint.empty()) asked.emplace_back("lti_message_hint", message_hint);
    const std::string& address = platform->authorization_url;
    Answer answer = redirect(address + (address.find('?') == std::string::npos ? "?" : "&") +
                             lti::form_text(asked));
    answer.headers.emplace_back("Set-Cookie", lti_cookie(browser));
    return answer;
}

Answer Portal::lti_launch(const Request& request) {
    const int64_t now = options_.now_s();
    if (!visitors_->launches.take(now)) return too_many();
    const auto arrival = visitors_->arrivals.take(value_of(request.form, "state"), now);
    if (!arrival)
        return not_in(
            400, Web::phrase("This sign-in is too old or was used already. Start again from your "
                             "course."));
    if (!same_token(arrival->browser, cookie_of(request.cookies, session_name() + "-lti")))
        return not_in(
            403, Web::phrase("This sign-in began in another browser, or cookies are off. Start "
                             "again from your course."));
    const lti::Settings settings = lti::read_settings(options_.lti_file);
    const lti::Platform* platform = settings.platform(arrival->issuer, arrival->client_id);
    if (platform == nullptr)
        return not_in(400, Web::phrase("This platform is not registered here."));
    const std::string problem = value_of(request.form, "error");
    if (!problem.empty())
        return not_in(403, Web::phrase("The platform did not sign you in: %1",
                                       text(std::string_view(word_of(problem)))));
    try {
        const auto find_key = [&](const std::string& id) {
            return visitors_->keys.find(*platform, id);
        };
        return lti_enter(
            *platform, lti::check_launch(value_of(request.form, "id_token"), *platform, find_key,
                                         arrival->nonce, static_cast<int64_t>(std::time(nullptr))));
    } catch (const lti::LaunchRefused& error) {
        options_.log("lti: " + platform->issuer + ": " + error.what());
        return not_in(error.refusal == lti::Refusal::kMalformed ? 400 : 403,
                      words_of(error.refusal));
    }
}

Answer Portal::lti_enter(const lti::Platform& platform, const lti::Launch& launch) {
    const lti::Link* link = platform.link_of(launch.subject);
    if (link == nullptr) {
        options_.log("lti: " + platform.issuer + ": nobody is linked with \"" + launch.subject +
                     "\"");
        return unknown_person(platform, launch.subject);
    }
    try {
        const auto store = db::open_for_reading(options_.store_url, link->account, options_.store);
        const auto user = store->accounts().find(link->account);
        if (!user || !user->active || !is_for(*link, *user)) {
            options_.log("lti: account " + std::to_string(link->account) + " is closed, or not " +
                         link->login + "'s");
            return not_in(
                403, Web::phrase("The account that you are linked with is closed or was changed. "
                                 "Ask an administrator of Placode."));
        }
        return lti_begin_session(platform, launch, *store, *user);
    } catch (const db::StoreError& error) {
        options_.log(std::string("lti: ") + error.what());
        return trouble(error, {});
    }
}

Answer Portal::lti_begin_session(const lti::Platform& platform, const lti::Launch& launch,
                                 db::Store& store, const db::UserRecord& user) {
    // Whoever runs the platform can come as everybody who is linked.
    if (db::has_role(user.roles, db::Role::kAdministrator))
        return not_in(403, Web::phrase("Administrators sign in with their password."));
    if (user.password_given)
        return not_in(403,
                      Web::phrase("Somebody else chose your password and knows it. Sign in to the "
                                  "program Placode and choose your own, then come back."));
    const std::string page = page_of(store, user.id, launch.task);
    Html body;
    body << Web::phrase("You are signed in as %1.", text(std::string_view(user.display_name)))
         << "</p>\n<p>" << link(page, Web::phrase("Go on"));
    Answer answer = message(200, Web::phrase("Signed in"), body);
    // Not a redirection: a browser takes that for the platform's, and brings no cookie that is for
    // this site alone.
    answer.headers.emplace_back("Refresh", "0; url=" + page);
    answer.headers.emplace_back(
        "Set-Cookie",
        cookie(session_name(),
               sessions_.begin(user.id, {platform.issuer, platform.client_id, launch.subject})));
    answer.headers.emplace_back("Set-Cookie", lti_cookie(""));
    options_.log(
        "lti: account " + std::to_string(user.id) + " signed in from " + platform.issuer +
        (launch.line_item.empty() ? "" : "; line item " + launch.line_item.substr(0, 500)));
    return answer;
}

// Asked for every page. Settings that cannot be read let nobody in.
bool Portal::lti_still_linked(const Session& session, const db::UserRecord& user) const {
    const CameFrom& from = session.came_from;
    if (from.issuer.empty()) return true;
    try {
        const lti::Settings settings = lti::read_settings(options_.lti_file);
        const lti::Platform* platform = settings.platform(from.issuer, from.client_id);
        const lti::Link* link = platform == nullptr ? nullptr : platform->link_of(from.subject);
        if (link != nullptr && is_for(*link, user)) return true;
        options_.log("lti: account " + std::to_string(user.id) + " is signed out: its link with " +
                     from.issuer + " is gone");
    } catch (const lti::SettingsError& error) {
        options_.log(std::string("lti: ") + error.what());
    }
    return false;
}

}  // namespace placode::web
