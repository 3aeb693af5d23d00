// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What a portal does with requests that no browser sends, and where it listens.

#include <arpa/inet.h>
#include <sys/socket.h>
#include <sys/stat.h>

#include <chrono>

#include "tests/web_fixture.h"

namespace placode::test {

namespace THIS_TEST {

/// Bytes to the portal and what comes back, without a client in between.
class Wire {
 public:
    explicit Wire(int port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
        sockaddr_in to{};
        to.sin_family = AF_INET;
        to.sin_port = htons(static_cast<uint16_t>(port));
        to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        EXPECT_EQ(::connect(socket_, reinterpret_cast<const sockaddr*>(&to), sizeof to), 0);
    }
    ~Wire() { ::close(socket_); }
    Wire(const Wire&) = delete;
    Wire& operator=(const Wire&) = delete;
    void send(const std::string& bytes) const {
        (void)::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    }
    /// Until the other side closes.
    [[nodiscard]] std::string receive() const {
        std::string all;
        char part[4096];
        for (ssize_t n = 0; (n = ::recv(socket_, part, sizeof part, 0)) > 0;)
            all.append(part, static_cast<size_t>(n));
        return all;
    }

 private:
    int socket_;
};

class WebLimitsTest : public WebTest {
 protected:
    [[nodiscard]] std::string answer_to(const std::string& bytes) const {
        const Wire wire(portal->port());
        wire.send(bytes);
        return wire.receive().substr(0, 12);
    }
    void expect_alive() const { EXPECT_EQ(browser().get("/sign-in").status, 200); }
};

TEST_P(WebLimitsTest, OddRequestsAreRefused) {
    const std::string end = "\r\nHost: x\r\n\r\n";
    for (const char* path :
         {"/people/../../etc/passwd", "/%00", "/people/%2e%2e", "//", "/people/-1",
          "/people/99999999999999999999", "/style.css/", "/?a=1&a=2&b=%zz"})
        EXPECT_NE(answer_to(std::string("GET ") + path + " HTTP/1.1" + end), "") << path;
    EXPECT_EQ(answer_to("GET /" + std::string(600, 'a') + " HTTP/1.1" + end), "HTTP/1.1 414");
    EXPECT_EQ(answer_to("GET /" + std::string(20000, 'a') + " HTTP/1.1" + end).find("HTTP/1.1 2"),
              std::string::npos);
    EXPECT_EQ(answer_to("GET /?a=" + std::string(300, 'a') + " HTTP/1.1" + end), "HTTP/1.1 414");
    EXPECT_EQ(
        answer_to("GET / HTTP/1.1\r\nX: " + std::string(100000, 'a') + end).find("HTTP/1.1 2"),
        std::string::npos);
    EXPECT_EQ(answer_to("TRACE / HTTP/1.1" + end).find("HTTP/1.1 2"), std::string::npos);
    EXPECT_EQ(answer_to("nonsense\r\n\r\n").find("HTTP/1.1 2"), std::string::npos);
    EXPECT_EQ(answer_to(std::string(64, '\0') + "\r\n\r\n").find("HTTP/1.1 2"), std::string::npos);
    expect_alive();
}

TEST_P(WebLimitsTest, PagesThatDoNotExistAreNotFound) {
    Browser one = signed_in("educator");
    for (const char* path : {"/people/0", "/people/abc", "/people/999999", "/attempts/999999",
                             "/norms/77", "/no", "/people/1/tasks", "/people/1/tasks/..%2f..%2fx"})
        EXPECT_EQ(one.get(path).status, 404) << path;
    EXPECT_EQ(signed_in("coordinator").get("/studies/no").status, 404);
    EXPECT_EQ(one.get("/attempts?page=99999").status, 200) << "the last page of the list";
    EXPECT_EQ(one.get("/attempts?page=400000000000000001").status, 200) << "times rows of a page";
    EXPECT_EQ(one.get("/attempts?page=-1&group=x&task=%27").status, 200);
}

TEST_P(WebLimitsTest, ALongBodyIsNotRead) {
    const std::string form(20000, 'a');
    EXPECT_EQ(answer_to("POST /sign-in HTTP/1.1\r\nHost: x\r\nContent-Type: "
                        "application/x-www-form-urlencoded\r\nContent-Length: 20000\r\n\r\n" +
                        form),
              "HTTP/1.1 413");
    EXPECT_EQ(answer_to("POST /sign-in HTTP/1.1\r\nHost: x\r\nContent-Encoding: gzip\r\n"
                        "Content-Length: 3\r\n\r\nabc"),
              "HTTP/1.1 400");
    expect_alive();
}

/// httplib compares the limit with a length that is stated, and reads any other body to its end.
TEST_P(WebLimitsTest, ABodyWithoutALengthIsNotRead) {
    const std::string begin = "POST /sign-in HTTP/1.1\r\nHost: x\r\n";
    EXPECT_EQ(answer_to(begin + "Transfer-Encoding: chunked\r\n\r\n3\r\na=b\r\n0\r\n\r\n"),
              "HTTP/1.1 400");
    EXPECT_EQ(answer_to(begin + "Transfer-Encoding: chunked\r\nContent-Length: 3\r\n\r\n3\r\n"),
              "HTTP/1.1 400");
    EXPECT_EQ(answer_to(begin + "\r\na=b"), "HTTP/1.1 400");
    expect_alive();
}

/// Nor does it compare what a request asks for with the size of what there is.
TEST_P(WebLimitsTest, APartOfAnAnswerIsNotMoreThanTheAnswer) {
    const auto body = [&](const std::string& path, const std::string& header) {
        const Wire wire(portal->port());
        wire.send("GET " + path + " HTTP/1.1\r\nHost: x\r\n" + header + "\r\n");
        const std::string all = wire.receive();
        const size_t end = all.find("\r\n\r\n");
        return end == std::string::npos ? std::string() : all.substr(end + 4);
    };
    constexpr size_t kRefusal = 1500;  // more than the page that says "no" to nonsense has
    for (const char* path : {"/style.css", "/sign-in", "/no", "/review/page.js"}) {
        const std::string whole = body(path, "");
        for (const char* range :
             {"0-999999", "1000000-1000100", "-999999", "5-", "0-1,2-999999", "99999999999-",
              "0-99999999999999999999", "18446744073709551610-18446744073709551615", "x"}) {
            const std::string part = body(path, std::string("Range: bytes=") + range + "\r\n");
            EXPECT_LE(part.size(), std::max(whole.size(), kRefusal)) << path << " " << range;
        }
        EXPECT_EQ(body(path, "Range: bytes=0-999999\r\n").size(), whole.size()) << path;
    }
    expect_alive();
}

TEST_P(WebLimitsTest, ABodyNobodyReadIsNoSecondRequest) {
    const Wire wire(portal->port());
    const std::string second = "GET /style.css HTTP/1.1\r\nHost: x\r\n\r\n";
    wire.send("DELETE / HTTP/1.1\r\nHost: x\r\nContent-Length: " + std::to_string(second.size()) +
              "\r\n\r\n" + second);
    const std::string all = wire.receive();
    EXPECT_EQ(all.find("HTTP/1.1 "), all.rfind("HTTP/1.1 "));
    EXPECT_NE(all.find("Connection: close"), std::string::npos);
}

TEST_P(WebLimitsTest, SlowClientsAreLeftAndOthersServed) {
    web::ServerLimits limits;
    limits.threads = 4, limits.connections = 8, limits.read_timeout_s = 1;
    portal = start(limits);
    std::vector<std::unique_ptr<Wire>> slow;
    for (int i = 0; i < 6; ++i) {
        slow.push_back(std::make_unique<Wire>(portal->port()));
        slow.back()->send("GET / HT");
    }
    const auto before = std::chrono::steady_clock::now();
    expect_alive();
    for (const auto& wire : slow) (void)wire->receive();
    EXPECT_LT(std::chrono::steady_clock::now() - before, std::chrono::seconds(20));
    expect_alive();
}

TEST_P(WebLimitsTest, ManyAtOnceAreAllAnswered) {
    const auto cookies = signed_in("educator").cookies;
    std::atomic<int> good{0};
    std::vector<std::thread> threads;
    for (int t = 0; t < 8; ++t)
        threads.emplace_back([&] {
            Browser one = browser();
            one.cookies = cookies;
            for (const char* path : {"/", "/cohort", "/scores", "/attempts", "/people"})
                good += one.get(path).status == 200 ? 1 : 0;
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(good, 40);
}

TEST_P(WebLimitsTest, ListensAtASocketForOwnerAndGroup) {
    web::PortalOptions portal_options;
    portal_options.store_url = url();
    const std::string path = folder.file("web.sock");
    {
        web::WebServer server(portal_options);
        (void)server.bind({"", 0, path});
        std::thread thread([&] { server.serve(); });
        while (!server.ready()) std::this_thread::yield();
        struct stat status {};
        EXPECT_EQ(::stat(path.c_str(), &status), 0);
        EXPECT_EQ(status.st_mode & 0777, 0660U);
        httplib::Client client(path);
        client.set_address_family(AF_UNIX);
        const auto seen = client.Get("/sign-in", {{"Host", "x"}});
        EXPECT_TRUE(seen && seen->status == 200);
        web::WebServer second(portal_options);
        EXPECT_THROW((void)second.bind({"", 0, path}), std::runtime_error);
        server.stop();
        thread.join();
    }
    EXPECT_FALSE(fs::exists(path));
}

TEST(WebListenAddress, IsOnThisComputerOrRefused) {
    EXPECT_EQ(web::parse_listen_address("127.0.0.1:8377").port, 8377);
    EXPECT_EQ(web::parse_listen_address("localhost:1").host, "127.0.0.1");
    EXPECT_EQ(web::parse_listen_address("[::1]:8377").host, "::1");
    EXPECT_EQ(web::parse_listen_address("unix:/run/x.sock").socket_path, "/run/x.sock");
    for (const char* words :
         {"0.0.0.0:8377", "192.168.1.5:80", "[::]:80", "*:80", ":80", "8377", "127.0.0.1",
          "127.0.0.1:x", "127.0.0.1:70000", "unix:", "unix:web", "127.0.0.1.example.org:80"})
        EXPECT_THROW((void)web::parse_listen_address(words), std::invalid_argument) << words;
}

INSTANTIATE_TEST_SUITE_P(Engines, WebLimitsTest, testing::Values("Sqlite"), engine_name);

}  // namespace THIS_TEST
}  // namespace placode::test
