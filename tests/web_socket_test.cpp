// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The WebSocket client against a peer that says every byte itself: partial reads, fragments, pings,
// masks, closing, and everything that is wrong. One thread, a clock of our own.
#include "haptics/web_socket.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstring>
#include <random>

#include "tests/count_allocations.h"

namespace placode::haptics {
namespace THIS_TEST {

constexpr int64_t kMs = 1'000'000;
using State = WebSocket::State;

const std::string kWelcome =
    "HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n\r\n";

std::string frame(uint8_t first, const std::string& payload) {
    std::string out(1, static_cast<char>(first));
    if (payload.size() < 126) {
        out.push_back(static_cast<char>(payload.size()));
    } else if (payload.size() < 65536) {
        out.push_back(126);
        out.push_back(static_cast<char>(payload.size() >> 8));
        out.push_back(static_cast<char>(payload.size() & 0xFF));
    } else {
        out.push_back(127);
        for (int shift = 56; shift >= 0; shift -= 8)
            out.push_back(static_cast<char>(payload.size() >> shift & 0xFF));
    }
    return out + payload;
}

struct Taken {
    uint8_t opcode = 0;
    bool masked = false, final = false;
    uint32_t mask = 0;
    std::string payload;
};

/// The other end. Its reads wait shortly for what loopback has not delivered yet.
class Peer {
 public:
    Peer() {
        listener_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        (void)!bind(listener_, reinterpret_cast<sockaddr*>(&address), sizeof address);
        (void)!listen(listener_, 4);
        socklen_t size = sizeof address;
        getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size);
        port = ntohs(address.sin_port);
    }
    ~Peer() {
        hang_up();
        ::close(listener_);
    }
    void take_call() { client_ = ::accept(listener_, nullptr, nullptr); }
    void hang_up() {
        if (client_ >= 0) ::close(client_);
        client_ = -1;
        in_.clear();
        at_ = 0;
    }
    void say(const std::string& bytes) const {
        ASSERT_EQ(::send(client_, bytes.data(), bytes.size(), MSG_NOSIGNAL),
                  static_cast<ssize_t>(bytes.size()));
    }
    /// What has come, after at most `wait_ms` of silence.
    const std::string& hear(int wait_ms = 200) {
        pollfd ready{client_, POLLIN, 0};
        while (::poll(&ready, 1, wait_ms) > 0) {
            char block[65536];
            const ssize_t got = ::recv(client_, block, sizeof block, 0);
            if (got <= 0) {
                closed = true;
                break;
            }
            in_.append(block, static_cast<size_t>(got));
            wait_ms = 0;
        }
        return in_;
    }
    /// The request, up to its empty line.
    std::string request() {
        const size_t end = hear().find("\r\n\r\n");
        if (end == std::string::npos) return {};
        std::string text = in_.substr(0, end + 4);
        in_.erase(0, end + 4);
        return text;
    }
    Taken take() {
        Taken out;
        if (parse(out)) return out;
        hear();
        (void)parse(out);
        return out;
    }
    int port = 0;
    bool closed = false;

 private:
    bool parse(Taken& out) {
        const auto* in = reinterpret_cast<const uint8_t*>(in_.data()) + at_;
        const size_t there = in_.size() - at_;
        if (there < 7) return false;
        size_t header = 2, size = in[1] & 0x7F;
        if (size == 126) {
            size = static_cast<size_t>(in[2]) << 8 | in[3];
            header = 4;
        }
        header += 4;
        if (there < header + size) return false;
        out.final = (in[0] & 0x80) != 0;
        out.opcode = in[0] & 0x0F;
        out.masked = (in[1] & 0x80) != 0;
        const uint8_t* mask = in + header - 4;
        std::memcpy(&out.mask, mask, 4);
        for (size_t i = 0; i < size; ++i)
            out.payload.push_back(static_cast<char>(in[header + i] ^ mask[i % 4]));
        at_ += header + size;
        return true;
    }

    int listener_ = -1, client_ = -1;
    std::string in_;
    size_t at_ = 0;  // taken up to here
};

struct Call {
    Call() : socket("127.0.0.1", peer.port, "/") {}
    /// Steps until something is due; loopback needs a moment, the clock of the client does not.
    bool until(State wanted) {
        for (int i = 0; i < 2000; ++i) {
            if (socket.step(now += kMs) == wanted) return true;
            ::usleep(100);
        }
        return false;
    }
    void connect() {
        socket.step(now);
        peer.take_call();
        ASSERT_TRUE(until(State::kShaking));
        socket.step(now);
        ASSERT_NE(peer.request().find("Sec-WebSocket-Version: 13"), std::string::npos);
        peer.say(kWelcome);
        ASSERT_TRUE(until(State::kOpen));
    }
    /// The next message within a moment; "" none.
    std::string message() {
        std::string_view text;
        for (int i = 0; i < 100; ++i) {
            socket.step(now += kMs);
            if (socket.next_message(text)) return std::string(text);
            ::usleep(100);
        }
        return {};
    }
    Peer peer;
    WebSocket socket;
    int64_t now = 1'000 * kMs;
};

TEST(WebSocket, TakesHandshakeAndMessageByteByByte) {
    Call call;
    call.socket.step(call.now);
    call.peer.take_call();
    ASSERT_TRUE(call.until(State::kShaking));
    call.socket.step(call.now);
    EXPECT_NE(call.peer.request().find("GET / HTTP/1.1\r\n"), std::string::npos);
    for (const char byte : kWelcome) {
        EXPECT_NE(call.socket.step(call.now += kMs), State::kOpen);
        call.peer.say(std::string(1, byte));
    }
    ASSERT_TRUE(call.until(State::kOpen));
    const std::string long_text(300, 'x');
    for (const std::string& text : {std::string("{\"a\":1}"), long_text}) {
        const std::string bytes = frame(0x81, text);
        for (size_t i = 0; i + 1 < bytes.size(); ++i) {
            call.peer.say(bytes.substr(i, 1));
            std::string_view seen;
            call.socket.step(call.now += kMs);
            EXPECT_FALSE(call.socket.next_message(seen));
        }
        call.peer.say(bytes.substr(bytes.size() - 1));
        EXPECT_EQ(call.message(), text);
    }
}

TEST(WebSocket, MasksEveryFrameAnewAndSaysItsLength) {
    Call call;
    call.connect();
    uint32_t last = 0;
    for (const size_t size : {1u, 125u, 126u, 4000u}) {
        const std::string text(size, 'y');
        ASSERT_TRUE(call.socket.send_text(text));
        const Taken taken = call.peer.take();
        EXPECT_TRUE(taken.masked);
        EXPECT_TRUE(taken.final);
        EXPECT_EQ(taken.opcode, 1);
        EXPECT_EQ(taken.payload, text);
        EXPECT_NE(taken.mask, last);
        EXPECT_NE(taken.mask, 0u);
        last = taken.mask;
    }
    EXPECT_FALSE(call.socket.send_text(std::string(70'000, 'z'))) << "more than it has room for";
}

TEST(WebSocket, AnswersPingsBetweenFragmentsAndPutsThemTogether) {
    Call call;
    call.connect();
    call.peer.say(frame(0x01, "one ") + frame(0x89, "there?") + frame(0x00, "two ") +
                  frame(0x8A, "unasked pong") + frame(0x80, "three") + frame(0x82, "binary") +
                  frame(0x81, "next"));
    EXPECT_EQ(call.message(), "one two three");
    EXPECT_EQ(call.message(), "next") << "binary is passed over";
    const Taken pong = call.peer.take();
    EXPECT_EQ(pong.opcode, 10);
    EXPECT_EQ(pong.payload, "there?");
}

TEST(WebSocket, SaysGoodbyeEitherWayAndCallsAgain) {
    Call call;
    call.connect();
    call.peer.say(frame(0x88, "\x03\xE9going"));
    EXPECT_EQ(call.message(), "");
    const Taken bye = call.peer.take();
    EXPECT_EQ(bye.opcode, 8);
    EXPECT_EQ(bye.payload, "\x03\xE9");
    EXPECT_TRUE(call.until(State::kClosed));
    call.peer.hang_up();
    // Half a second later it calls again.
    EXPECT_EQ(call.socket.step(call.now += 400 * kMs), State::kClosed);
    call.socket.step(call.now += 200 * kMs);
    EXPECT_EQ(call.socket.state(), State::kConnecting);
    call.connect();
    EXPECT_EQ(call.socket.connections(), 2u);
    call.socket.close();
    EXPECT_EQ(call.peer.take().opcode, 8);
}

TEST(WebSocket, DropsAPeerThatBreaksTheProtocol) {
    const std::string huge = std::string("\x81\x7F\x00\x00\x01\x00\x00\x00\x00\x00", 10);
    const std::string masked = std::string("\x81\x81", 2) + "abcdX";
    const std::pair<const char*, std::string> cases[] = {
        {"a frame of a terabyte", huge},
        {"a masked frame", masked},
        {"reserved bits", frame(0xC1, "x")},
        {"an unknown opcode", frame(0x83, "x")},
        {"an unknown control frame", frame(0x8B, "x")},
        {"a fragment of nothing", frame(0x80, "x")},
        {"a message within a message", frame(0x01, "x") + frame(0x81, "y")},
        {"a ping in pieces", frame(0x09, "x")},
        {"a long ping", frame(0x89, std::string(126, 'x'))},
    };
    for (const auto& [name, bytes] : cases) {
        Call call;
        call.connect();
        call.peer.say(bytes);
        EXPECT_EQ(call.message(), "") << name;
        EXPECT_EQ(call.socket.connections(), 1u);
        EXPECT_TRUE(call.socket.state() != State::kOpen || call.until(State::kClosed)) << name;
        EXPECT_FALSE(call.socket.send_text("x")) << name;
    }
}

TEST(WebSocket, DropsAMessageThatGrowsWithoutEnd) {
    Call call;
    call.connect();
    const std::string piece(30'000, 'x');
    call.peer.say(frame(0x01, piece));
    bool dropped = false;
    for (int i = 0; i < 20 && !dropped; ++i) {
        call.peer.say(frame(0x00, piece));
        EXPECT_EQ(call.message(), "");
        dropped = call.socket.state() != State::kOpen;
        if (dropped) {
            EXPECT_GE(i, 2) << "100 kB are fine";
        }
    }
    EXPECT_TRUE(dropped);
}

TEST(WebSocket, DropsWhatIsNoWebSocket) {
    for (const std::string& answer :
         {std::string("HTTP/1.1 404 Not Found\r\n\r\n"), std::string("SSH-2.0-OpenSSH\r\n\r\n"),
          std::string(9'000, 'a')}) {
        Call call;
        call.socket.step(call.now);
        call.peer.take_call();
        ASSERT_TRUE(call.until(State::kShaking));
        call.peer.say(answer);
        EXPECT_TRUE(call.until(State::kClosed)) << answer.substr(0, 20);
        EXPECT_EQ(call.socket.connections(), 0u);
    }
    // One that takes the call and says nothing is given up after two seconds.
    Call call;
    call.socket.step(call.now);
    call.peer.take_call();
    ASSERT_TRUE(call.until(State::kShaking));
    EXPECT_EQ(call.socket.step(call.now += 1'000 * kMs), State::kShaking);
    EXPECT_EQ(call.socket.step(call.now += 2'000 * kMs), State::kClosed);
}

TEST(WebSocket, NeverWaitsForAPeerThatDoesNotRead) {
    Call call;
    call.connect();
    const std::string text(4'000, 'x');
    int taken = 0;
    while (taken < 100'000 && call.socket.send_text(text)) ++taken;
    EXPECT_LT(taken, 100'000) << "it said that nothing more is taken";
    EXPECT_EQ(call.socket.step(call.now += kMs), State::kOpen);
    // What was begun is finished, nothing is lost in between.
    for (int i = 0; i < taken; ++i) {
        const Taken one = call.peer.take();
        ASSERT_EQ(one.payload.size(), text.size()) << i;
        call.socket.step(call.now += kMs);
    }
}

TEST(WebSocket, SurvivesGarbage) {
    std::minstd_rand draw(7);
    int kept = 0;
    for (int n = 0; n < 60; ++n) {
        Call call;
        call.connect();
        std::string bytes;
        const size_t size = 1 + draw() % 3000;
        for (size_t i = 0; i < size; ++i) bytes.push_back(static_cast<char>(draw()));
        // Half of them begin like a right frame, so that more than the first byte is read.
        if (n % 2 == 0) bytes = frame(0x81, "good") + bytes;
        call.peer.say(bytes);
        std::string_view text;
        for (int i = 0; i < 20; ++i) {
            call.socket.step(call.now += kMs);
            while (call.socket.next_message(text)) {
                EXPECT_LE(text.size(), size + 4);
                kept += text == "good" ? 1 : 0;
            }
            ::usleep(50);
        }
    }
    EXPECT_EQ(kept, 30) << "what was right before the garbage arrived";
}

TEST(WebSocket, AllocatesNothing) {
    Call call;
    call.connect();
    const std::string bytes =
        frame(0x01, std::string(500, 'x')) + frame(0x89, "p") + frame(0x80, std::string(500, 'y'));
    const long before = placode::test::allocations;
    for (int i = 0; i < 50; ++i) {
        call.peer.say(bytes);
        std::string_view text;
        bool got = false;
        for (int k = 0; k < 100 && !got; ++k) {
            call.socket.step(call.now += kMs);
            got = call.socket.next_message(text);
            if (!got) ::usleep(50);
        }
        ASSERT_TRUE(got);
        call.socket.send_text(text.substr(0, 100));
    }
    EXPECT_EQ(placode::test::allocations, before);
}

}  // namespace THIS_TEST
}  // namespace placode::haptics
