// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Asking other servers: https with certificates that this computer trusts, nothing else but
// loopback.

#include <string>
#include <utility>
#include <vector>

namespace placode::lti {

struct WebAddress {
    bool tls = true;
    std::string host;
    int port = 443;
    std::string target = "/";  ///< Path and query.
};

/// Throws std::invalid_argument that says why: https, or http on loopback; no user, no fragment.
[[nodiscard]] WebAddress parse_web_address(const std::string& text);

struct WebCall {
    std::string method = "GET", address;
    std::vector<std::pair<std::string, std::string>> headers;
    std::string body, type;  ///< Of POST.
};

struct WebReply {
    int status = 0;  ///< 0: nothing came back, and `problem` says why.
    std::string body, problem;
    int retry_after_s = 0;  ///< What the server asks for; 0: nothing.
};

/// Any thread. Gives up after 5 s without a connection and 10 s without a byte; follows no
/// redirection, because what is sent is for one server; takes at most 256 kB.
/// Throws std::invalid_argument as parse_web_address() does.
[[nodiscard]] WebReply ask(const WebCall& call);

/// "key=value&..." with both percent-encoded.
[[nodiscard]] std::string form_text(const std::vector<std::pair<std::string, std::string>>& parts);

}  // namespace placode::lti
