// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lti/grades.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>

#include "curriculum/utc_time.h"
#include "db/attempt_counting.h"
#include "db/password.h"

namespace placode::lti {
namespace {

constexpr const char* kScoreScope = "https://purl.imsglobal.org/spec/lti-ags/scope/score";
constexpr int64_t kAssertionS = 120;

/// A platform keeps the score with the latest time: two in one second differ.
std::string now_text() {
    const int64_t ms = std::chrono::duration_cast<std::chrono::milliseconds>(
                           std::chrono::system_clock::now().time_since_epoch())
                           .count();
    char fraction[8];
    std::snprintf(fraction, sizeof fraction, ".%03dZ", static_cast<int>(ms % 1000));
    std::string text = curriculum::utc_text(ms / 1000);
    text.pop_back();
    return text + fraction;
}

std::string value_of(const Grade& grade) {
    if (!grade.points) return "none";
    char text[32];
    std::snprintf(text, sizeof text, "%.2f", *grade.points);
    return text;
}

/// In hundredths; nothing without an attempt that counts.
std::optional<double> points_of(db::Store& store, int64_t account, const LineItem& item) {
    std::optional<double> found;
    for (const db::AttemptRecord& attempt : store.attempts().list(account, item.task)) {
        if (!db::counts(attempt)) continue;
        const double points = std::round(attempt.points * 100) / 100;
        if (!found || item.take == Take::kLatest || points > *found) found = points;
    }
    return found;
}

}  // namespace

bool is_theirs(db::Store& store, const Link& link) {
    const auto user = store.accounts().find(link.account);
    return user && db::login_key(user->login) == db::login_key(link.login);
}

std::string not_theirs(const Link& link) {
    return "sub \"" + link.subject + "\": account " + std::to_string(link.account) + " is not " +
           link.login + "'s (any more); link it again, or take the link away";
}

std::vector<Grade> grades_of(db::Store& store, const Platform& platform, const LineItem& item,
                             std::vector<std::string>& problems) {
    std::vector<Grade> grades;
    for (const Link& link : platform.links) {
        if (is_theirs(store, link))
            grades.push_back({link.subject, link.login, item.task, item.address,
                              points_of(store, link.account, item)});
        else
            problems.push_back(not_theirs(link));
    }
    return grades;
}

std::string score_text(const Grade& grade, const std::string& timestamp) {
    Json score{{"userId", grade.subject},
               {"timestamp", timestamp},
               {"activityProgress", grade.points ? "Completed" : "Initialized"},
               {"gradingProgress", grade.points ? "FullyGraded" : "NotReady"}};
    if (grade.points) {
        score["scoreGiven"] = *grade.points;
        score["scoreMaximum"] = 100;
    }
    return score.dump();
}

std::string scores_address(const std::string& line_item) {
    const size_t query = std::min(line_item.find('?'), line_item.size());
    std::string path = line_item.substr(0, query);
    while (path.ends_with('/')) path.pop_back();
    return path + "/scores" + line_item.substr(query);
}

std::string GradeSender::key_of(const Grade& grade) const {
    return Json::array({platform_.issuer, platform_.client_id, grade.line_item, grade.subject})
        .dump();
}

Sent GradeSender::due(const Grade& grade) const {
    const auto before = sent_.find(key_of(grade));
    if (!before && !grade.points) return Sent::kNothing;
    return before == value_of(grade) ? Sent::kSame : Sent::kSent;
}

bool GradeSender::get_token(std::string& problem) {
    if (!token_.empty()) return true;
    const auto now = static_cast<int64_t>(std::time(nullptr));
    const std::string assertion = key_.token({{"iss", platform_.client_id},
                                              {"sub", platform_.client_id},
                                              {"aud", platform_.token_audience},
                                              {"iat", now},
                                              {"exp", now + kAssertionS},
                                              {"jti", db::random_letters(32)}});
    WebCall call;
    call.method = "POST";
    call.address = platform_.token_url;
    call.type = "application/x-www-form-urlencoded";
    call.body = form_text(
        {{"grant_type", "client_credentials"},
         {"client_assertion_type", "urn:ietf:params:oauth:client-assertion-type:jwt-bearer"},
         {"client_assertion", assertion},
         {"scope", kScoreScope}});
    const WebReply reply = ask_patiently(call, patience_);
    const Json json = Json::parse(reply.body, nullptr, false);
    const auto found = json.is_object() ? json.find("access_token") : json.end();
    if (reply.status == 200 && json.is_object() && found != json.end() && found->is_string())
        token_ = found->get<std::string>();
    if (!token_.empty()) return true;
    away_ = true;
    problem = platform_.token_url +
              ": no token: " + (reply.status == 200 ? "the answer holds none" : problem_of(reply)) +
              "; are client_id, token_url and the tool's public key as on the platform?";
    return false;
}

Sent GradeSender::send(const Grade& grade, std::string& problem) {
    const Sent what = due(grade);
    if (what != Sent::kSent) return what;
    WebCall call;
    call.method = "POST";
    call.address = scores_address(grade.line_item);
    call.type = "application/vnd.ims.lis.v1.score+json";
    call.body = score_text(grade, now_text());
    WebReply reply;
    // A token may have run out meanwhile: once more with a new one.
    for (int tries = 0; tries < 2; ++tries) {
        if (!get_token(problem)) return Sent::kFailed;
        call.headers = {{"Authorization", "Bearer " + token_}};
        reply = ask_patiently(call, patience_);
        if (reply.status != 401) break;
        token_.clear();
    }
    if (reply.status < 200 || reply.status >= 300) {
        away_ = reply.status == 0;
        problem = call.address + ": " + grade.login + ": " + problem_of(reply);
        return Sent::kFailed;
    }
    sent_.set(key_of(grade), value_of(grade));
    sent_.keep();
    return Sent::kSent;
}

}  // namespace placode::lti
