// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lti/launch.h"

#include <algorithm>

namespace placode::lti {
namespace {

const std::string kClaim = "https://purl.imsglobal.org/spec/lti/claim/";
constexpr const char* kEndpoint = "https://purl.imsglobal.org/spec/lti-ags/claim/endpoint";
constexpr size_t kLongestSubject = 255;  // OpenID Connect Core, section 2.

std::string text_at(const Json& json, const std::string& key) {
    if (!json.is_object()) return {};
    const auto found = json.find(key);
    return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

Json at(const Json& json, const std::string& key) {
    const auto found = json.find(key);
    return found != json.end() ? *found : Json();
}

/// Seconds since 1970; anything that is no number, or one beyond all dates, is none.
std::optional<int64_t> time_at(const Json& claims, const char* key) {
    const Json value = at(claims, key);
    if (!value.is_number()) return std::nullopt;
    const double seconds = value.get<double>();
    if (!(seconds > 0 && seconds < 1e11)) return std::nullopt;
    return static_cast<int64_t>(seconds);
}

Refusal refusal_of(TokenFault fault) {
    switch (fault) {
        case TokenFault::kAlgorithm:
            return Refusal::kAlgorithm;
        case TokenFault::kUnknownKey:
            return Refusal::kUnknownKey;
        case TokenFault::kSignature:
            return Refusal::kSignature;
        default:
            return Refusal::kMalformed;
    }
}

Json opened(const std::string& token, const FindKey& find_key) {
    try {
        return open_token(token, find_key);
    } catch (const TokenError& error) {
        throw LaunchRefused(refusal_of(error.fault), error.what());
    }
}

/// For this tool, and where it is for several, issued to this one.
void check_audience(const Json& claims, const std::string& client_id) {
    const Json audience = at(claims, "aud");
    const bool several = audience.is_array();
    const bool named =
        several ? std::find(audience.begin(), audience.end(), client_id) != audience.end()
                : audience == client_id;
    const bool has_party = claims.contains("azp");
    if (!named || (has_party && text_at(claims, "azp") != client_id) ||
        (several && audience.size() > 1 && !has_party))
        throw LaunchRefused(Refusal::kAudience, "the token is for another tool");
}

void check_time(const Json& claims, int64_t now_s) {
    const auto until = time_at(claims, "exp"), from = time_at(claims, "iat");
    if (!until || !from)
        throw LaunchRefused(Refusal::kMalformed,
                            "the token does not say from when to when it holds");
    if (*until + kClockSkewS <= now_s) throw LaunchRefused(Refusal::kTime, "the token is over");
    if (*from - kClockSkewS > now_s)
        throw LaunchRefused(Refusal::kTime, "the token is of the future");
}

void check_message(const Json& claims, const Platform& platform) {
    const std::string deployment = text_at(claims, kClaim + "deployment_id");
    const auto& known = platform.deployment_ids;
    if (std::find(known.begin(), known.end(), deployment) == known.end())
        throw LaunchRefused(Refusal::kDeployment, "the deployment is unknown");
    if (text_at(claims, kClaim + "message_type") != "LtiResourceLinkRequest" ||
        text_at(claims, kClaim + "version") != "1.3.0")
        throw LaunchRefused(Refusal::kMessage, "the message is no launch by LTI 1.3");
}

}  // namespace

Launch check_launch(const std::string& token, const Platform& platform, const FindKey& find_key,
                    const std::string& nonce, int64_t now_s) {
    const Json claims = opened(token, find_key);
    if (text_at(claims, "iss") != platform.issuer)
        throw LaunchRefused(Refusal::kIssuer, "the token is of another platform");
    check_audience(claims, platform.client_id);
    check_time(claims, now_s);
    if (nonce.empty() || text_at(claims, "nonce") != nonce)
        throw LaunchRefused(Refusal::kNonce, "the token answers another sign-in");
    check_message(claims, platform);
    Launch launch;
    launch.subject = text_at(claims, "sub");
    // Without one somebody comes without a name, as a guest of the platform.
    if (launch.subject.size() > kLongestSubject)
        throw LaunchRefused(Refusal::kMalformed, "the token's sub is too long");
    launch.task = text_at(at(claims, kClaim + "custom"), "task");
    launch.line_item = text_at(at(claims, kEndpoint), "lineitem");
    return launch;
}

}  // namespace placode::lti
