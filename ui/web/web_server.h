// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// HTTP around the portal, with limits on everything that comes in.

#include <memory>

#include "ui/web/listen_address.h"
#include "ui/web/portal.h"

namespace placode::web {

struct ServerLimits {
    int threads = 8;         ///< Requests that are answered at once.
    int connections = 64;    ///< Answered and waiting; further ones wait in the system's queue.
    int read_timeout_s = 5;  ///< Without a byte from the client.
    int write_timeout_s = 5;
    int body_bytes = 8192;  ///< A sign-in has some 300.
};

/// One portal on one address.
class WebServer {
 public:
    WebServer(PortalOptions options, const ServerLimits& limits = {});
    ~WebServer();
    WebServer(const WebServer&) = delete;
    WebServer& operator=(const WebServer&) = delete;

    /// Returns the port: port 0 takes a free one. A socket that a dead program left is replaced,
    /// and the new one is for owner and group. Throws std::runtime_error where it is taken.
    int bind(const ListenAddress& address);
    /// Until stop(). @pre bind().
    void serve();
    [[nodiscard]] bool ready() const;  ///< Any thread: serve() has begun.
    /// Any thread, once it is ready. Answers what has begun.
    void stop();

 private:
    struct Inside;
    std::unique_ptr<Inside> inside_;
};

}  // namespace placode::web
