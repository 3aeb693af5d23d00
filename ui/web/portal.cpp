// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/web/portal.h"

#include <QCoreApplication>
#include <algorithm>
#include <chrono>
#include <ctime>

#include "curriculum/utc_time.h"
#include "db/reading_store.h"
#include "ui/web/frame.h"
#include "ui/web/lti_visitors.h"

namespace placode::web {
namespace {

constexpr size_t kLongestPath = 512, kLongestValue = 200, kMostValues = 8;
// A platform sends along what it wants to have back.
constexpr size_t kLongestHint = 4000, kMostHints = 16;

int64_t steady_s() {
    return std::chrono::duration_cast<std::chrono::seconds>(
               std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

std::string now_utc() { return curriculum::utc_text(static_cast<int64_t>(std::time(nullptr))); }

std::vector<std::string> split(const std::string& path) {
    std::vector<std::string> parts;
    for (size_t begin = 1; begin <= path.size();) {
        const size_t end = std::min(path.find('/', begin), path.size());
        parts.push_back(path.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

/// What stands for each `*`; nothing where the path is another one.
std::optional<std::vector<std::string>> match(const Route& route, const std::string& path) {
    const auto want = split(route.path), have = split(path);
    if (path.empty() || path[0] != '/' || want.size() != have.size()) return std::nullopt;
    std::vector<std::string> found;
    for (size_t i = 0; i < want.size(); ++i) {
        if (want[i] == "*" && !have[i].empty())
            found.push_back(have[i]);
        else if (want[i] != have[i])
            return std::nullopt;
    }
    return found;
}

bool is_too_long(const Request& request) {
    const bool hints = request.path == kLtiLogin;
    const size_t longest = hints ? kLongestHint : kLongestValue;
    const auto too_long = [longest](const auto& each) {
        return each.first.size() + each.second.size() > longest;
    };
    return request.path.size() > kLongestPath ||
           request.query.size() > (hints ? kMostHints : kMostValues) ||
           std::any_of(request.query.begin(), request.query.end(), too_long);
}

}  // namespace

Portal::Portal(PortalOptions options)
    : options_(std::move(options)),
      sessions_(options_.now_s ? options_.now_s : steady_s),
      reviews_(options_.review_bytes, [this](const std::string& line) {
          if (options_.log) options_.log(line);
      }) {
    if (!options_.log) options_.log = [](const std::string&) {};
    if (!options_.now_s) options_.now_s = steady_s;
    if (!options_.lti_file.empty())
        visitors_ = std::make_unique<LtiVisitors>(options_.now_s, options_.log);
    QCoreApplication::installTranslator(&polish_);
}

Portal::~Portal() { QCoreApplication::removeTranslator(&polish_); }

Portal::Signed Portal::signed_in(const Request& request) {
    const std::string token = cookie_of(request.cookies, session_name());
    if (const auto session = sessions_.find(token)) return {token, *session};
    return {};
}

Answer Portal::answer(const Request& request) noexcept {
    try {
        const reports::Speaking here(language_of(request));
        try {
            return answer_or_throw(request);
        } catch (const std::exception& error) {
            options_.log(request.method + " " + request.path.substr(0, kLongestPath) + ": " +
                         error.what());
        }
        return fault();
    } catch (const std::exception&) {
        Answer bare;
        bare.status = 500;
        return bare;
    }
}

Answer Portal::refuse(const Request& request, int status) {
    const reports::Speaking here(language_of(request));
    return refusal(status);
}

Answer Portal::answer_or_throw(const Request& request) {
    if (is_too_long(request)) return refusal(414);
    if (visitors_ != nullptr && request.path.starts_with("/lti/")) return lti(request);
    if (request.method == "POST") {
        if (request.path == "/sign-in") return sign_in(request);
        if (request.path == "/sign-out") return sign_out(request);
        return refusal(405);
    }
    if (request.method != "GET") return refusal(405);
    if (request.path == "/style.css") {
        Answer sheet;
        sheet.type = "text/css; charset=utf-8";
        sheet.body = style_sheet();
        return sheet;
    }
    const std::string scripts = "/review/";
    if (request.path.starts_with(scripts)) {
        Answer script;
        script.type = "text/javascript; charset=utf-8";
        script.body = review_script(request.path.substr(scripts.size()));
        return script.body.empty() ? refusal(404) : script;
    }
    if (auto chosen = choose_language(request)) return *chosen;
    const Signed who = signed_in(request);
    if (request.path == "/sign-in")
        return who.session.account != 0 ? redirect("/") : sign_in_form({}, 200);
    // Also for a page that does not exist: who is nobody learns nothing of what there is.
    if (who.session.account == 0) return redirect("/sign-in");
    return page(request, who);
}

Answer Portal::page(const Request& request, const Signed& who) {
    std::unique_ptr<db::Store> store;
    std::optional<db::UserRecord> user;
    try {
        store = db::open_for_reading(options_.store_url, who.session.account, options_.store);
        user = store->accounts().find(who.session.account);
    } catch (const db::StoreError& error) {
        options_.log(request.path + ": " + error.what());
        return trouble(error, {});
    }
    // Closed or erased meanwhile, its password was set anew by somebody else, or its link is gone.
    if (!user || !user->active || user->password_given || !lti_still_linked(who.session, *user)) {
        sessions_.end(who.token);
        Answer answer = redirect("/sign-in");
        answer.headers.emplace_back("Set-Cookie", cookie(session_name(), ""));
        return answer;
    }
    Visit visit{*store, tasks_, reviews_, *user, now_utc(), {}, request.query};
    const Reader reader{&visit.user, who.session.form_token, request.path, address_of(request)};
    for (const Route& route : routes())
        if (const auto parts = match(route, request.path)) {
            visit.parts = *parts;
            return show(route, visit, reader);
        }
    return message(404, Web::phrase("Not there"), Web::phrase("There is no such page."), reader);
}

Answer Portal::show(const Route& route, Visit& visit, const Reader& reader) {
    try {
        if (route.data != nullptr) return route.data(visit);
        const PageText made = route.page(visit);
        Answer answer;
        answer.body = document(made.title, made.body, reader);
        if (made.ask_again_s > 0)
            answer.headers.emplace_back("Refresh", std::to_string(made.ask_again_s));
        if (made.script)
            answer.headers.emplace_back("Content-Security-Policy", policy_with_script());
        return answer;
    } catch (const NotThere& problem) {
        return message(404, Web::phrase("Not there"), text(std::string_view(problem.what())),
                       reader);
    } catch (const db::StoreError& error) {
        if (error.kind() != db::StoreError::Kind::kRefused &&
            error.kind() != db::StoreError::Kind::kNotFound)
            options_.log(reader.path + ": " + error.what());
        return trouble(error, reader);
    } catch (const std::exception& error) {
        options_.log(reader.path + ": " + error.what());
        return fault(reader);
    }
}

}  // namespace placode::web
