// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/web_socket.h"

#include <arpa/inet.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "haptics/real_time.h"

namespace placode::haptics {

namespace {

constexpr int64_t kRetryNs = 500'000'000, kPatienceNs = 2'000'000'000;
constexpr int64_t kGoodbyeNs = 100'000'000;
constexpr size_t kRoom = 1 << 17;  // of the longest message; full states are some kilobytes
constexpr size_t kOutRoom = 1 << 13;

}  // namespace

WebSocket::WebSocket(const std::string& host, int port, const std::string& path)
    : request_("GET " + path + " HTTP/1.1\r\nHost: " + host + ":" + std::to_string(port) +
               "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
               // Any 16 bytes do: the answer is not checked, the service is on this computer.
               "Sec-WebSocket-Key: cGxhY29kZS1oYXB0aWNzIQ==\r\nSec-WebSocket-Version: 13\r\n\r\n"),
      port_(static_cast<uint16_t>(port)),
      in_(kRoom),
      out_(kOutRoom),
      message_(kRoom) {
    addrinfo hints{}, *found = nullptr;
    hints.ai_family = AF_INET;
    hints.ai_socktype = SOCK_STREAM;
    if (getaddrinfo(host.c_str(), nullptr, &hints, &found) == 0 && found != nullptr) {
        address_ = reinterpret_cast<const sockaddr_in*>(found->ai_addr)->sin_addr.s_addr;
        freeaddrinfo(found);
    }
}

WebSocket::~WebSocket() { close(); }

void WebSocket::drop(int64_t t_ns) noexcept {
    if (socket_ >= 0) ::close(socket_);
    socket_ = -1;
    state_ = State::kClosed;
    retry_ns_ = t_ns + kRetryNs;
    in_size_ = out_size_ = message_size_ = 0;
    message_complete_ = message_open_ = failed_ = false;
}

void WebSocket::begin(int64_t t_ns) noexcept {
    if (address_ == 0) return;
    socket_ = ::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    if (socket_ < 0) {
        drop(t_ns);
        return;
    }
    const int on = 1;
    setsockopt(socket_, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    sockaddr_in peer{};
    peer.sin_family = AF_INET;
    peer.sin_port = htons(port_);
    peer.sin_addr.s_addr = address_;
    since_ns_ = t_ns;
    if (connect(socket_, reinterpret_cast<const sockaddr*>(&peer), sizeof peer) == 0 ||
        errno == EINPROGRESS)
        state_ = State::kConnecting;
    else
        drop(t_ns);
}

bool WebSocket::flush() noexcept {
    while (out_size_ > 0) {
        const ssize_t sent = ::send(socket_, out_.data(), out_size_, MSG_DONTWAIT | MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) continue;
        if (sent < 0) return errno == EAGAIN || errno == EWOULDBLOCK;
        std::memmove(out_.data(), out_.data() + sent, out_size_ - static_cast<size_t>(sent));
        out_size_ -= static_cast<size_t>(sent);
    }
    return true;
}

// False: the other end has gone.
bool WebSocket::receive() noexcept {
    while (in_size_ < in_.size()) {
        const ssize_t got =
            ::recv(socket_, in_.data() + in_size_, in_.size() - in_size_, MSG_DONTWAIT);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return errno == EAGAIN || errno == EWOULDBLOCK;
        if (got == 0) return false;
        in_size_ += static_cast<size_t>(got);
    }
    return true;
}

// The answer to the request: 101, then frames.
void WebSocket::shake() noexcept {
    const std::string_view seen(in_.data(), in_size_);
    const size_t end = seen.find("\r\n\r\n");
    if (end == std::string_view::npos) {
        failed_ = in_size_ > 8192;
        return;
    }
    if (seen.substr(0, 12) != "HTTP/1.1 101") {
        failed_ = true;
        return;
    }
    in_size_ -= end + 4;
    std::memmove(in_.data(), in_.data() + end + 4, in_size_);
    state_ = State::kOpen;
    ++connections_;
}

WebSocket::State WebSocket::step(int64_t t_ns) noexcept {
    if (state_ == State::kClosed) {
        if (t_ns >= retry_ns_) begin(t_ns);
        return state_;
    }
    if (state_ == State::kConnecting) {
        pollfd ready{socket_, POLLOUT, 0};
        if (::poll(&ready, 1, 0) > 0) {
            int error = 0;
            socklen_t size = sizeof error;
            getsockopt(socket_, SOL_SOCKET, SO_ERROR, &error, &size);
            failed_ = error != 0;
            std::memcpy(out_.data(), request_.data(), request_.size());
            out_size_ = request_.size();
            state_ = State::kShaking;
        }
    }
    if (state_ != State::kConnecting && !failed_) {
        failed_ = !flush() || !receive();
        if (!failed_ && state_ == State::kShaking) shake();
    }
    const bool waited = state_ != State::kOpen && t_ns - since_ns_ > kPatienceNs;
    if (failed_ || waited) drop(t_ns);
    return state_;
}

namespace {

/// Waits for what the socket may be ready for. False when the time is up.
bool wait_ready(int socket, short events, int64_t until_ns) noexcept {
    const int64_t left = until_ns - monotonic_ns();
    if (left <= 0) return false;
    pollfd p{socket, events, 0};
    return ::poll(&p, 1, static_cast<int>(left / 1'000'000) + 1) > 0;
}

}  // namespace

void WebSocket::hand_over() noexcept {
    const int64_t until = monotonic_ns() + kGoodbyeNs;
    while (state_ == State::kOpen && !failed_ && out_size_ > 0 &&
           wait_ready(socket_, POLLOUT, until)) {
        if (!flush()) failed_ = true;
    }
}

void WebSocket::close() noexcept {
    if (state_ == State::kOpen && !failed_) {
        const char normal[2] = {0x03, static_cast<char>(0xE8)};
        send_frame(kClose, {normal, 2});
        hand_over();
        // Closed with answers unread, a socket is reset, and a reset discards what the other side
        // has not read yet: the last forces. So no more is sent, and read until the other side
        // ends.
        ::shutdown(socket_, SHUT_WR);
        const int64_t until = monotonic_ns() + kGoodbyeNs;
        std::array<char, 4096> rest;
        while (wait_ready(socket_, POLLIN, until) &&
               ::recv(socket_, rest.data(), rest.size(), MSG_DONTWAIT) > 0) {
        }
    }
    drop(0);
}

}  // namespace placode::haptics
