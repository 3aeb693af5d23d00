// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A stand-in for the Inverse service: a WebSocket server of one thread that answers every message
// by the state of its arms, and remembers the forces it was sent. It can fragment, ping, stay
// silent, and hang up. Our own code after the public descriptions of the service.

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <charconv>
#include <cstring>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace placode::test {

struct HaplyArm {
    std::string id = "04EA", handedness = "right";
    std::array<double, 3> position{};
    bool calibrated = true, ready = true;
    std::array<double, 3> force{};  ///< As last sent by the client.
};

class HaplyService {
 public:
    // What a test may change; under `mutex`.
    std::mutex mutex;
    std::vector<HaplyArm> arms{1};
    std::string grip =
        R"({"device_id":"61576","state":{"orientation":{"w":1,"x":0,"y":0,"z":0},"buttons":{"a":false}}})";
    std::string extra;     ///< Goes into every answer as it stands, e.g. unknown keys.
    std::string position;  ///< Replaces the positions, for damaged ones.
    size_t fragments = 1;
    bool ping = false, silent = false;
    std::atomic<int> messages{0}, pongs{0}, connections{0}, hellos{0};
    std::atomic<bool> closed_by_client{false};

    HaplyService() {
        listener_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
        bind_to(0);
        thread_ = std::thread([this] { run(); });
    }
    ~HaplyService() {
        stop_ = true;
        thread_.join();
        if (client_ >= 0) ::close(client_);
        if (listener_ >= 0) ::close(listener_);
    }
    [[nodiscard]] int port() const { return port_; }
    void hang_up() { hang_up_ = true; }
    template <class F>
    void change(F&& f) {
        const std::lock_guard lock(mutex);
        f(*this);
    }
    [[nodiscard]] std::array<double, 3> force(size_t arm) {
        const std::lock_guard lock(mutex);
        return arms[arm].force;
    }

 private:
    void bind_to(int port) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        address.sin_port = htons(static_cast<uint16_t>(port));
        const int on = 1;
        setsockopt(listener_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
        (void)!bind(listener_, reinterpret_cast<sockaddr*>(&address), sizeof address);
        (void)!listen(listener_, 4);
        socklen_t size = sizeof address;
        getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size);
        port_ = ntohs(address.sin_port);
    }

    void send_all(const std::string& bytes) {
        if (client_ >= 0) (void)!::send(client_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    }
    static std::string frame(uint8_t first, std::string_view payload) {
        std::string out(1, static_cast<char>(first));
        if (payload.size() < 126) {
            out += static_cast<char>(payload.size());
        } else {
            out += static_cast<char>(126);
            out += static_cast<char>(payload.size() >> 8);
            out += static_cast<char>(payload.size() & 0xFF);
        }
        return out.append(payload);
    }

    std::string answer() {
        std::string list;
        for (const HaplyArm& arm : arms) {
            const auto number = [](double v) {
                char text[32];
                return std::string(text, std::to_chars(text, text + 32, v).ptr);
            };
            const std::string where = position.empty()
                                          ? R"({"x":)" + number(arm.position[0]) + R"(,"y":)" +
                                                number(arm.position[1]) + R"(,"z":)" +
                                                number(arm.position[2]) + "}"
                                          : position;
            if (!list.empty()) list += ',';
            // The state before the id and the configuration: order means nothing in JSON.
            list += R"({"state":{"cursor_velocity":{"x":0,"y":0,"z":0},"cursor_position":)" +
                    where + R"(,"control_mode":"idle"},"device_id":")" + arm.id +
                    R"(","config":{"handedness":")" + arm.handedness +
                    R"(","gravity":[0,0]},"status":{"calibrated":)" +
                    (arm.calibrated ? "true" : "false") + R"(,"power_supply":true,"ready":)" +
                    (arm.ready ? "true" : "false") + "}}";
        }
        std::string out = R"({"inverse3":[)" + list + "]";
        if (!grip.empty()) out += R"(,"wireless_verse_grip":[)" + grip + "]";
        return out + extra + "}";
    }

    void reply() {
        const std::lock_guard lock(mutex);
        if (silent) return;
        if (ping) send_all(frame(0x89, "are you there"));
        const std::string text = answer();
        const size_t parts = std::max<size_t>(1, fragments);
        for (size_t i = 0; i < parts; ++i) {
            const size_t from = text.size() * i / parts, to = text.size() * (i + 1) / parts;
            const uint8_t opcode = i == 0 ? 1 : 0, last = i + 1 == parts ? 0x80 : 0;
            send_all(frame(static_cast<uint8_t>(last | opcode),
                           std::string_view(text).substr(from, to - from)));
            if (ping && i + 1 < parts) send_all(frame(0x89, "between fragments"));
        }
    }

    void take_force(const std::string& text) {
        const std::lock_guard lock(mutex);
        for (HaplyArm& arm : arms) {
            const size_t at = text.find("\"device_id\":\"" + arm.id + "\"");
            if (at == std::string::npos) continue;
            const size_t values = text.find("\"values\":", at);
            for (int k = 0; k < 3 && values != std::string::npos; ++k) {
                const std::string key = std::string("\"") + "xyz"[k] + "\":";
                const size_t number = text.find(key, values) + key.size();
                std::from_chars(text.data() + number, text.data() + text.size(),
                                arm.force[static_cast<size_t>(k)]);
            }
        }
    }

    void take(uint8_t opcode, const std::string& payload) {
        if (opcode == 10) ++pongs;
        if (opcode == 8) closed_by_client = true;
        if (opcode != 1) return;
        ++messages;
        if (payload.find("force_render_full_state") != std::string::npos) ++hellos;
        take_force(payload);
        reply();
    }

    void frames() {
        for (;;) {
            const auto* in = reinterpret_cast<const uint8_t*>(in_.data());
            if (in_.size() < 6) return;
            size_t header = 6, size = in[1] & 0x7F;
            if (size == 126) {
                if (in_.size() < 8) return;
                header = 8;
                size = static_cast<size_t>(in[2]) << 8 | in[3];
            }
            if (in_.size() < header + size) return;
            std::string payload = in_.substr(header, size);
            for (size_t i = 0; i < size; ++i)
                payload[i] = static_cast<char>(payload[i] ^ in[header - 4 + i % 4]);
            const uint8_t opcode = in[0] & 0x0F;
            in_.erase(0, header + size);
            take(opcode, payload);
        }
    }

    void drop() {
        if (client_ >= 0) ::close(client_);
        client_ = -1;
        in_.clear();
        shaken_ = false;
    }

    void run() {
        while (!stop_) {
            if (hang_up_.exchange(false)) {
                send_all(frame(0x88, std::string_view("\x03\xE9", 2)));
                drop();
            }
            pollfd waiting{client_ >= 0 ? client_ : listener_, POLLIN, 0};
            if (::poll(&waiting, 1, 5) <= 0) continue;
            if (client_ < 0) {
                client_ = ::accept(listener_, nullptr, nullptr);
                continue;
            }
            char buffer[4096];
            const ssize_t got = ::recv(client_, buffer, sizeof buffer, 0);
            if (got <= 0) {
                drop();
                continue;
            }
            in_.append(buffer, static_cast<size_t>(got));
            const size_t end = in_.find("\r\n\r\n");
            if (!shaken_ && end != std::string::npos) {
                in_.erase(0, end + 4);
                send_all(
                    "HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\n"
                    "Connection: Upgrade\r\nSec-WebSocket-Accept: x\r\n\r\n");
                shaken_ = true;
                ++connections;
            }
            if (shaken_) frames();
        }
    }

    int listener_ = -1, client_ = -1, port_ = 0;
    bool shaken_ = false;
    std::string in_;
    std::atomic<bool> stop_{false}, hang_up_{false};
    std::thread thread_;
};

}  // namespace placode::test
