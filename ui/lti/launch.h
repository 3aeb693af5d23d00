// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a platform says of somebody who comes from it, and whether it may be believed.
// Source: IMS Security Framework 1.0, section 5.1; LTI Core 1.3; AGS 2.0.

#include <cstdint>
#include <stdexcept>
#include <string>

#include "ui/lti/settings.h"
#include "ui/lti/web_token.h"

namespace placode::lti {

/// Clocks of two servers may differ by so much [s].
inline constexpr int64_t kClockSkewS = 60;

enum class Refusal : uint8_t {
    kMalformed,  ///< No token, or one without what every token has.
    kAlgorithm,
    kUnknownKey,
    kSignature,
    kIssuer,
    kAudience,
    kTime,  ///< Over, or of the future.
    kNonce,
    kDeployment,
    kMessage,  ///< Another message than the launch of a resource, or another version.
};

class LaunchRefused : public std::runtime_error {
 public:
    LaunchRefused(Refusal refusal, const std::string& what)
        : std::runtime_error(what), refusal(refusal) {}
    const Refusal refusal;
};

struct Launch {
    std::string subject;
    std::string task;       ///< The custom parameter of this name; empty: none.
    std::string line_item;  ///< Where the platform takes the grades of this link; empty: nowhere.
};

/// @param nonce that this program gave out, once, for the sign-in that the token answers.
/// @param now_s since 1970 [s]. Throws LaunchRefused.
[[nodiscard]] Launch check_launch(const std::string& token, const Platform& platform,
                                  const FindKey& find_key, const std::string& nonce, int64_t now_s);

}  // namespace placode::lti
