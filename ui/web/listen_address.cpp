// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/web/listen_address.h"

#include <charconv>
#include <stdexcept>

namespace placode::web {
namespace {

constexpr size_t kLongestSocketPath = 107;  // sun_path of Linux, with its end.

[[noreturn]] void refuse(const std::string& words, const std::string& problem) {
    throw std::invalid_argument("found \"" + words + "\": " + problem +
                                "; expected 127.0.0.1:PORT, [::1]:PORT or unix:PATH");
}

bool is_loopback(const std::string& host) {
    return host == "127.0.0.1" || host == "localhost" || host == "::1" || host == "[::1]";
}

}  // namespace

ListenAddress parse_listen_address(const std::string& words) {
    ListenAddress address;
    if (words.rfind("unix:", 0) == 0) {
        address.socket_path = words.substr(5);
        if (address.socket_path.empty() || address.socket_path[0] != '/')
            refuse(words, "the path of a socket begins with /");
        if (address.socket_path.size() > kLongestSocketPath)
            refuse(words, "a socket's path has at most " + std::to_string(kLongestSocketPath) +
                              " characters");
        return address;
    }
    const size_t colon = words.rfind(':');
    if (colon == std::string::npos) refuse(words, "the port is missing");
    const std::string host = words.substr(0, colon), port = words.substr(colon + 1);
    const char* end = port.data() + port.size();
    const auto [rest, error] = std::from_chars(port.data(), end, address.port);
    if (error != std::errc{} || rest != end || address.port < 0 || address.port > 65535)
        refuse(words, "the port is no number up to 65535");
    if (!is_loopback(host))
        refuse(words,
               "other computers could reach it, without TLS; listen on this computer and let "
               "nginx or Apache stand in front (docs/web.md)");
    address.host = host.find("::1") != std::string::npos ? "::1" : "127.0.0.1";
    return address;
}

}  // namespace placode::web
