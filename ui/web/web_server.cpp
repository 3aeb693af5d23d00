// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/web/web_server.h"

#include <httplib.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <condition_variable>
#include <cstring>
#include <mutex>

namespace placode::web {
namespace {

/// Takes no more connections than it can hold: whoever accepts them waits, and the system's short
/// queue turns the rest away.
class BoundedPool : public httplib::ThreadPool {
 public:
    BoundedPool(int threads, int most)
        : httplib::ThreadPool(static_cast<size_t>(threads)), most_(most) {}

    void enqueue(std::function<void()> work) override {
        {
            std::unique_lock lock(mutex_);
            room_.wait(lock, [this] { return held_ < most_; });
            ++held_;
        }
        httplib::ThreadPool::enqueue([this, work = std::move(work)] {
            work();
            const std::lock_guard lock(mutex_);
            --held_;
            room_.notify_one();
        });
    }

 private:
    std::mutex mutex_;
    std::condition_variable room_;
    int held_ = 0;
    const int most_;
};

Request request_of(const httplib::Request& from) {
    Request request;
    request.method = from.method == "HEAD" ? "GET" : from.method;
    request.path = from.path;
    request.cookies = from.get_header_value("Cookie");
    request.languages = from.get_header_value("Accept-Language");
    // httplib puts what stands in the address and in the body into one list. A form's values are
    // taken from the body alone: a password in an address would stand in logs.
    for (const auto& [key, value] : from.params)
        (request.method == "POST" ? request.form : request.query).emplace(key, value);
    return request;
}

void give(const Answer& answer, httplib::Response& to) {
    to.status = answer.status;
    for (const auto& [name, value] : answer.headers) {
        // A second policy of content would only narrow the first; cookies are several.
        if (name == "Content-Security-Policy") to.headers.erase(name);
        to.set_header(name.c_str(), value);
    }
    if (answer.body.empty()) return to.set_content("", answer.type.c_str());
    // Piece by piece, because httplib would compress a whole one, by brotli with its slowest
    // setting. The web server in front does that better.
    to.set_content_provider(
        answer.body.size(), answer.type.c_str(),
        [body = answer.body](size_t offset, size_t length, httplib::DataSink& sink) {
            // httplib takes both from the request's "Range" and compares neither with the size.
            if (offset >= body.size()) return false;
            return sink.write(body.data() + offset, std::min(length, body.size() - offset));
        });
}

/// No answer of ours is given in parts: httplib would say a length that is not there.
void give_whole(const httplib::Request& request) {
    const_cast<httplib::Request&>(request).ranges.clear();
}

/// A form whose length stands before it: of one that comes in chunks, or until its end, httplib
/// reads all before it compares the length with the limit.
bool has_stated_length(const httplib::Request& request) {
    return request.has_header("Content-Length") && !request.has_header("Transfer-Encoding");
}

sockaddr_un socket_address(const std::string& path) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::memcpy(address.sun_path, path.data(), std::min(path.size(), sizeof address.sun_path - 1));
    return address;
}

/// Throws unless the place is free, or holds a socket at which nobody answers.
void make_place(const std::string& path) {
    struct stat status {};
    if (::lstat(path.c_str(), &status) != 0) return;
    if (!S_ISSOCK(status.st_mode))
        throw std::runtime_error(path + " is there and no socket; give another path");
    const int trial = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const sockaddr_un address = socket_address(path);
    const bool answers =
        ::connect(trial, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
    ::close(trial);
    if (answers) throw std::runtime_error(path + ": another program listens there");
    ::unlink(path.c_str());
}

}  // namespace

struct WebServer::Inside {
    explicit Inside(PortalOptions options) : portal(std::move(options)) {}

    Portal portal;
    httplib::Server server;
    std::string socket_path;

    /// True: the answer is made, without a look at the body.
    [[nodiscard]] bool answer_at_once(const httplib::Request& request,
                                      httplib::Response& response) {
        if (request.method != "POST" || !portal.takes_forms(request.path)) {
            give(portal.answer(request_of(request)), response);
            return true;
        }
        if (request.target.find('?') == std::string::npos &&
            request.get_header_value("Content-Encoding").empty() && has_stated_length(request))
            return false;
        give(portal.refuse(request_of(request), 400), response);
        return true;
    }
};

WebServer::WebServer(PortalOptions options, const ServerLimits& limits)
    : inside_(std::make_unique<Inside>(std::move(options))) {
    httplib::Server& server = inside_->server;
    server.new_task_queue = [limits] {
        return new BoundedPool(limits.threads, limits.connections);
    };
    server.set_read_timeout(limits.read_timeout_s);
    server.set_write_timeout(limits.write_timeout_s);
    server.set_payload_max_length(static_cast<size_t>(limits.body_bytes));
    // One request a connection: a body that nobody read cannot be taken for the next request.
    server.set_keep_alive_max_count(1);
    httplib::Headers headers;
    for (const auto& [name, value] : fixed_headers()) headers.emplace(name, value);
    server.set_default_headers(headers);
    server.set_pre_routing_handler(
        [this](const httplib::Request& request, httplib::Response& response) {
            give_whole(request);
            return inside_->answer_at_once(request, response)
                       ? httplib::Server::HandlerResponse::Handled
                       : httplib::Server::HandlerResponse::Unhandled;
        });
    const auto send = [this](const httplib::Request& request, httplib::Response& response) {
        give(inside_->portal.answer(request_of(request)), response);
    };
    for (const char* path : {"/sign-in", "/sign-out", kLtiLogin, kLtiLaunch})
        server.Post(path, send);
    // What httplib itself turned away.
    server.set_error_handler([this](const httplib::Request& request, httplib::Response& response) {
        give_whole(request);
        if (!response.has_header("Content-Type"))
            give(inside_->portal.refuse(request_of(request), response.status), response);
    });
}

WebServer::~WebServer() {
    stop();
    if (!inside_->socket_path.empty()) ::unlink(inside_->socket_path.c_str());
}

int WebServer::bind(const ListenAddress& address) {
    httplib::Server& server = inside_->server;
    if (!address.socket_path.empty()) {
        make_place(address.socket_path);
        server.set_address_family(AF_UNIX);
        const mode_t before = ::umask(0117);
        const bool bound = server.bind_to_port(address.socket_path, 80);
        ::umask(before);
        if (!bound)
            throw std::runtime_error(address.socket_path +
                                     " cannot be listened at; is its folder there and ours?");
        inside_->socket_path = address.socket_path;
        return 0;
    }
    // A second program at the same port is refused, not let in beside.
    server.set_socket_options([](socket_t socket) {
        const int yes = 1;
        ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    if (address.port == 0) return server.bind_to_any_port(address.host);
    if (!server.bind_to_port(address.host, address.port))
        throw std::runtime_error(address.host + ":" + std::to_string(address.port) +
                                 " is taken; give another port with --listen");
    return address.port;
}

void WebServer::serve() { inside_->server.listen_after_bind(); }

bool WebServer::ready() const { return inside_->server.is_running(); }

void WebServer::stop() { inside_->server.stop(); }

}  // namespace placode::web
