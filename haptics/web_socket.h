// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A WebSocket client (RFC 6455) for a service on this computer that a servo thread may use: no call
// blocks, allocates or throws after construction, and a lost connection is taken up again by
// itself. Text messages only; no TLS, no extensions.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace placode::haptics {

class WebSocket {
 public:
    enum class State : uint8_t { kClosed, kConnecting, kShaking, kOpen };

    /// Looks the host up (may block) and allocates all memory; connects in `step`.
    WebSocket(const std::string& host, int port, const std::string& path);
    ~WebSocket();
    WebSocket(const WebSocket&) = delete;
    WebSocket& operator=(const WebSocket&) = delete;

    /// Goes on with connecting, receives what has come, answers pings. Every tick.
    State step(int64_t t_ns) noexcept;
    /// The next complete text message, valid until the next call. False: none.
    [[nodiscard]] bool next_message(std::string_view& text) noexcept;
    /// False: not open, or the service does not take what was sent before; nothing was sent.
    bool send_text(std::string_view text) noexcept;
    /// Gives the other side up to 0.1 s to take what is not sent yet.
    void hand_over() noexcept;
    /// Says goodbye, waits up to 0.2 s for the other side, and closes.
    void close() noexcept;

    [[nodiscard]] State state() const noexcept { return state_; }
    /// Grows with every new connection, so that its user can introduce itself again.
    [[nodiscard]] uint32_t connections() const noexcept { return connections_; }

 private:
    // Opcodes of frames.
    static constexpr uint8_t kContinuation = 0, kText = 1, kBinary = 2, kClose = 8, kPing = 9,
                             kPong = 10;

    void drop(int64_t t_ns) noexcept;
    void begin(int64_t t_ns) noexcept;
    void shake() noexcept;
    bool receive() noexcept;
    bool flush() noexcept;

    // web_socket_frames.cpp
    bool send_frame(uint8_t opcode, std::string_view payload) noexcept;
    bool take_frame() noexcept;
    [[nodiscard]] bool allowed(uint8_t first, uint64_t size) const noexcept;

    std::string request_;
    uint32_t address_ = 0;  // IPv4, network order; 0 = the host has none
    uint16_t port_ = 0;
    int socket_ = -1;
    State state_ = State::kClosed;
    uint32_t connections_ = 0, mask_ = 0x9E3779B9u;
    int64_t retry_ns_ = 0, since_ns_ = 0;
    std::vector<char> in_, out_, message_;
    size_t in_size_ = 0, out_size_ = 0, message_size_ = 0;
    bool message_complete_ = false, message_text_ = false, message_open_ = false, failed_ = false;
};

}  // namespace placode::haptics
