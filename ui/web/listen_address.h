// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where the portal listens: on this computer only. What comes from elsewhere comes through a web
// server in front, which does TLS.

#include <string>

namespace placode::web {

struct ListenAddress {
    std::string host;  ///< "127.0.0.1" or "::1"; empty: a Unix socket.
    int port = 0;
    std::string socket_path;
};

/// "127.0.0.1:8377", "[::1]:8377", "localhost:8377" or "unix:/run/placode/web.sock". Throws
/// std::invalid_argument saying what was found and what is expected, for an address that others can
/// reach as well.
[[nodiscard]] ListenAddress parse_listen_address(const std::string& words);

}  // namespace placode::web
