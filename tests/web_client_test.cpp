// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What is asked of other servers, and what is not sent to them.
#include "ui/lti/web_client.h"

#include "tests/mock_platform.h"
#include "ui/lti/sending.h"

#include <gtest/gtest.h>
#include <openssl/x509.h>

#include <chrono>

namespace placode::lti {
namespace THIS_TEST {

TEST(WebClient, TakesHttpsAndLoopbackOnly) {
    const WebAddress address =
        parse_web_address("https://moodle.example.edu/mod/lti/token.php?a=b");
    EXPECT_TRUE(address.tls);
    EXPECT_EQ(address.host, "moodle.example.edu");
    EXPECT_EQ(address.port, 443);
    EXPECT_EQ(address.target, "/mod/lti/token.php?a=b");
    EXPECT_EQ(parse_web_address("https://x.example:8443?a").port, 8443);
    EXPECT_EQ(parse_web_address("https://x.example:8443?a").target, "/?a");
    EXPECT_EQ(parse_web_address("http://[::1]:80/").host, "::1");
    EXPECT_EQ(parse_web_address("http://localhost").target, "/");
    for (const char* text :
         {"", "moodle.example.edu", "ftp://x.example", "http://moodle.example.edu/",
          "http://127.0.0.1.example.edu/", "http://127.0.0.1@x.example/", "https://a:b@x.example/",
          "https://", "https:///x", "https://x.example:0/", "https://x.example:99999/",
          "https://x.example:/", "https://x example/", "https://x.example/#a",
          "https://x.example/\n", "https://ż.example/", "http://10.0.0.1/", "HTTP://127.0.0.1/"})
        EXPECT_THROW((void)parse_web_address(text), std::invalid_argument) << text;
    try {
        (void)parse_web_address("https://anna:pass1@x.example/");
    } catch (const std::invalid_argument& error) {
        EXPECT_EQ(std::string(error.what()).find("pass1"), std::string::npos);
    }
}

/// A server that vouches for itself.
TEST(WebClient, ACertificateThatNobodyVouchesForIsRefused) {
    std::unique_ptr<X509, void (*)(X509*)> certificate(X509_new(), X509_free);
    ASN1_INTEGER_set(X509_get_serialNumber(certificate.get()), 1);
    X509_gmtime_adj(X509_getm_notBefore(certificate.get()), 0);
    X509_gmtime_adj(X509_getm_notAfter(certificate.get()), 3600);
    X509_set_pubkey(certificate.get(), test::platform_key().get());
    X509_NAME_add_entry_by_txt(X509_get_subject_name(certificate.get()), "CN", MBSTRING_ASC,
                               reinterpret_cast<const unsigned char*>("localhost"), -1, -1, 0);
    X509_set_issuer_name(certificate.get(), X509_get_subject_name(certificate.get()));
    X509_sign(certificate.get(), test::platform_key().get(), EVP_sha256());
    httplib::SSLServer server(certificate.get(), test::platform_key().get());
    ASSERT_TRUE(server.is_valid());
    int asked = 0;
    server.Get("/jwks", [&](const auto&, auto& to) {
        ++asked;
        to.set_content("{\"keys\":[]}", "application/json");
    });
    const int port = server.bind_to_any_port("127.0.0.1");
    std::thread thread([&] { server.listen_after_bind(); });
    while (!server.is_running()) std::this_thread::yield();
    WebCall call;
    call.address = "https://localhost:" + std::to_string(port) + "/jwks";
    const WebReply reply = ask(call);
    // The server does answer, to who does not look.
    httplib::SSLClient careless("localhost", port);
    careless.enable_server_certificate_verification(false);
    const auto seen = careless.Get("/jwks");
    server.stop();
    thread.join();
    EXPECT_EQ(reply.status, 0);
    EXPECT_NE(reply.problem.find("certificate"), std::string::npos) << reply.problem;
    EXPECT_TRUE(seen && seen->status == 200);
    EXPECT_EQ(asked, 1);
}

class WebClientTest : public testing::Test {
 protected:
    WebClientTest() : port_(server.bind_to_any_port("127.0.0.1")) {}
    void serve() {
        thread_ = std::thread([this] { server.listen_after_bind(); });
        while (!server.is_running()) std::this_thread::yield();
    }
    ~WebClientTest() override {
        server.stop();
        if (thread_.joinable()) thread_.join();
    }
    [[nodiscard]] WebCall call(const std::string& path) const {
        WebCall one;
        one.address = "http://127.0.0.1:" + std::to_string(port_) + path;
        return one;
    }
    httplib::Server server;

 private:
    int port_;
    std::thread thread_;
};

TEST_F(WebClientTest, FollowsNoRedirectionAndReadsNoEndlessAnswer) {
    int reached = 0;
    server.Get("/to", [&](const auto&, auto& to) { to.set_redirect("/there"); });
    server.Get("/there", [&](const auto&, auto&) { ++reached; });
    server.Get("/long", [](const auto&, auto& to) {
        to.set_content(std::string(300 * 1024, 'a'), "text/plain");
    });
    serve();
    EXPECT_EQ(ask(call("/to")).status, 302);
    EXPECT_EQ(reached, 0);
    const WebReply reply = ask(call("/long"));
    EXPECT_EQ(reply.status, 0);
    EXPECT_NE(reply.problem.find("256 kB"), std::string::npos);
}

TEST_F(WebClientTest, ABusyServerIsAskedAgainAndARefusalIsNot) {
    int asked = 0;
    server.Post("/busy", [&](const auto&, auto& to) { to.status = ++asked < 3 ? 503 : 204; });
    server.Post("/always", [&](const auto&, auto& to) { ++asked, to.status = 500; });
    server.Post("/no", [&](const auto&, auto& to) { ++asked, to.status = 403; });
    server.Post("/later", [&](const auto&, auto& to) {
        to.status = ++asked < 2 ? 429 : 200;
        to.set_header("Retry-After", "1");
    });
    serve();
    const auto send = [&](const char* path) {
        asked = 0;
        WebCall one = call(path);
        one.method = "POST";
        return ask_patiently(one, {3, 0.001}).status;
    };
    EXPECT_EQ(send("/busy"), 204);
    EXPECT_EQ(asked, 3);
    EXPECT_EQ(send("/always"), 500);
    EXPECT_EQ(asked, 3);
    EXPECT_EQ(send("/no"), 403);
    EXPECT_EQ(asked, 1);
    const auto before = std::chrono::steady_clock::now();
    EXPECT_EQ(send("/later"), 200);
    EXPECT_GE(std::chrono::steady_clock::now() - before, std::chrono::milliseconds(990));
}

TEST(WebClient, FormsAreEncoded) {
    EXPECT_EQ(form_text({{"a b", "c&d=e+f"}, {"ż", ""}}), "a%20b=c%26d%3De%2Bf&%C5%BC=");
}

}  // namespace THIS_TEST
}  // namespace placode::lti
