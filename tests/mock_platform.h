// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A learning platform and a learning record store on a free port of this computer. Signs and checks
// by code of its own, so that it does not agree with the program in a mistake.

#include <httplib.h>
#undef _res  // A macro of resolv.h, which httplib includes, and a parameter in Eigen.
#include <openssl/core_names.h>
#include <openssl/evp.h>
#include <openssl/hmac.h>
#include <openssl/pem.h>

#include <QByteArray>
#include <ctime>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <thread>
#include <vector>

namespace placode::test {

using PlainJson = nlohmann::json;

inline std::string to_base64url(const std::string& bytes) {
    return QByteArray::fromStdString(bytes)
        .toBase64(QByteArray::Base64UrlEncoding | QByteArray::OmitTrailingEquals)
        .toStdString();
}
inline std::string from_base64url(const std::string& text) {
    return QByteArray::fromBase64(QByteArray::fromStdString(text), QByteArray::Base64UrlEncoding)
        .toStdString();
}

/// An RSA key pair of a test.
class TestKey {
 public:
    explicit TestKey(std::string id, unsigned bits = 2048)
        : id(std::move(id)), key_(EVP_RSA_gen(bits), EVP_PKEY_free) {}
    std::string id;

    [[nodiscard]] EVP_PKEY* get() const { return key_.get(); }
    [[nodiscard]] std::string sign(const std::string& bytes) const {
        std::unique_ptr<EVP_MD_CTX, void (*)(EVP_MD_CTX*)> context(EVP_MD_CTX_new(),
                                                                   EVP_MD_CTX_free);
        size_t length = 0;
        const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
        EVP_DigestSignInit(context.get(), nullptr, EVP_sha256(), nullptr, get());
        EVP_DigestSign(context.get(), nullptr, &length, data, bytes.size());
        std::string signature(length, '\0');
        EVP_DigestSign(context.get(), reinterpret_cast<unsigned char*>(signature.data()), &length,
                       data, bytes.size());
        return signature;
    }
    [[nodiscard]] bool signed_by_it(const std::string& bytes, const std::string& signature) const {
        std::unique_ptr<EVP_MD_CTX, void (*)(EVP_MD_CTX*)> context(EVP_MD_CTX_new(),
                                                                   EVP_MD_CTX_free);
        EVP_DigestVerifyInit(context.get(), nullptr, EVP_sha256(), nullptr, get());
        return EVP_DigestVerify(
                   context.get(), reinterpret_cast<const unsigned char*>(signature.data()),
                   signature.size(), reinterpret_cast<const unsigned char*>(bytes.data()),
                   bytes.size()) == 1;
    }
    [[nodiscard]] PlainJson public_jwk() const {
        return {{"kty", "RSA"},
                {"use", "sig"},
                {"alg", "RS256"},
                {"kid", id},
                {"n", number(OSSL_PKEY_PARAM_RSA_N)},
                {"e", number(OSSL_PKEY_PARAM_RSA_E)}};
    }
    [[nodiscard]] std::string private_pem() const {
        return pem([this](BIO* out) {
            PEM_write_bio_PrivateKey(out, get(), nullptr, nullptr, 0, nullptr, nullptr);
        });
    }
    [[nodiscard]] std::string public_pem() const {
        return pem([this](BIO* out) { PEM_write_bio_PUBKEY(out, get()); });
    }

 private:
    [[nodiscard]] std::string number(const char* name) const {
        BIGNUM* value = nullptr;
        EVP_PKEY_get_bn_param(get(), name, &value);
        std::string bytes(static_cast<size_t>(BN_num_bytes(value)), '\0');
        BN_bn2bin(value, reinterpret_cast<unsigned char*>(bytes.data()));
        BN_free(value);
        return to_base64url(bytes);
    }
    template <class Write>
    static std::string pem(Write&& write) {
        std::unique_ptr<BIO, int (*)(BIO*)> out(BIO_new(BIO_s_mem()), BIO_free);
        write(out.get());
        char* data = nullptr;
        const long length = BIO_get_mem_data(out.get(), &data);
        return {data, static_cast<size_t>(length)};
    }

    std::unique_ptr<EVP_PKEY, void (*)(EVP_PKEY*)> key_;
};

/// Making one takes a while: tests share them.
inline TestKey& platform_key() {
    static TestKey key("platform-1");
    return key;
}
inline TestKey& other_key() {
    static TestKey key("platform-2");
    return key;
}
inline TestKey& tool_key() {
    static TestKey key("tool");
    return key;
}

inline std::string signed_by(const TestKey& key, const PlainJson& header, const PlainJson& claims) {
    const std::string bytes = to_base64url(header.dump()) + "." + to_base64url(claims.dump());
    return bytes + "." + to_base64url(key.sign(bytes));
}

/// A token as the platform means it, which a test may spoil before it is signed.
struct Saying {
    PlainJson header, claims;
    std::function<std::string(const PlainJson& header, const PlainJson& claims)> sign;
};

inline const std::string kLtiClaim = "https://purl.imsglobal.org/spec/lti/claim/";

class MockPlatform {
 public:
    static constexpr const char *kIssuer = "https://moodle.example.edu", *kClient = "placode-7";

    MockPlatform() {
        port_ = server_.bind_to_any_port("127.0.0.1");
        keys = {platform_key().public_jwk()};
        server_.Get("/jwks", [this](const auto&, auto& to) {
            const std::lock_guard lock(mutex);
            ++asked_for_keys;
            to.set_content(PlainJson{{"keys", keys}}.dump(), "application/json");
        });
        server_.Get("/authorize", [this](const auto& from, auto& to) { authorize(from, to); });
        server_.Post("/token", [this](const auto& from, auto& to) { give_token(from, to); });
        server_.Post(R"(/lineitems/(\w+)/scores)",
                     [this](const auto& from, auto& to) { take_score(from, to); });
        server_.Post("/xapi/statements",
                     [this](const auto& from, auto& to) { take_statements(from, to); });
        thread_ = std::thread([this] { server_.listen_after_bind(); });
        while (!server_.is_running()) std::this_thread::yield();
    }
    ~MockPlatform() { stop(); }
    MockPlatform(const MockPlatform&) = delete;
    MockPlatform& operator=(const MockPlatform&) = delete;
    void stop() {
        server_.stop();
        if (thread_.joinable()) thread_.join();
    }

    [[nodiscard]] std::string url(const std::string& path) const {
        return "http://127.0.0.1:" + std::to_string(port_) + path;
    }
    [[nodiscard]] int port() const { return port_; }
    /// As a settings file names this platform.
    [[nodiscard]] PlainJson settings() const {
        return {{"issuer", kIssuer},
                {"client_id", kClient},
                {"deployment_ids", {"1", "3"}},
                {"authorization_url", url("/authorize?from=placode")},
                {"token_url", url("/token")},
                {"jwks_url", url("/jwks")}};
    }

    std::mutex mutex;  ///< Of all below.
    std::vector<PlainJson> keys;
    int asked_for_keys = 0;
    std::function<void(Saying&)> spoil;  ///< Before a token is signed.
    std::string launch_url;              ///< What was registered.
    std::vector<std::string> odd;        ///< What the program did and should not have.
    std::vector<int> answers_first;      ///< Statuses instead of the next answers.
    std::vector<PlainJson> scores;       ///< With "lineitem" and "query".
    std::vector<int> scores_first;       ///< The same of scores only.
    int tokens_given = 0;
    std::map<std::string, PlainJson> statements;  ///< By id.
    int statement_posts = 0;
    std::string record_store_user = "placode:s3cret word";

 private:
    void expect(bool right, const std::string& what) {
        if (!right) odd.push_back(what);
    }
    /// True where a test wants trouble instead.
    static bool trouble(httplib::Response& to, std::vector<int>& first) {
        if (first.empty()) return false;
        to.status = first.front();
        first.erase(first.begin());
        return true;
    }

    void authorize(const httplib::Request& from, httplib::Response& to) {
        const std::lock_guard lock(mutex);
        const auto is = [&](const char* key, const std::string& value) {
            expect(from.get_param_value(key) == value,
                   std::string(key) + "=" + from.get_param_value(key));
        };
        is("from", "placode");
        is("scope", "openid");
        is("response_type", "id_token");
        is("response_mode", "form_post");
        is("prompt", "none");
        is("client_id", kClient);
        is("redirect_uri", launch_url);
        expect(from.get_param_value("nonce").size() >= 32, "nonce");
        expect(from.get_param_value("state").size() >= 32, "state");
        const auto now = static_cast<int64_t>(std::time(nullptr));
        Saying saying;
        saying.header = {{"alg", "RS256"}, {"typ", "JWT"}, {"kid", platform_key().id}};
        saying.claims = {{"iss", kIssuer},
                         {"aud", kClient},
                         {"sub", from.get_param_value("login_hint")},
                         {"iat", now},
                         {"exp", now + 60},
                         {"nonce", from.get_param_value("nonce")},
                         {kLtiClaim + "deployment_id", "1"},
                         {kLtiClaim + "message_type", "LtiResourceLinkRequest"},
                         {kLtiClaim + "version", "1.3.0"},
                         {kLtiClaim + "resource_link", {{"id", "5"}}},
                         {kLtiClaim + "custom", {{"task", "diathermy_ring"}}},
                         {"https://purl.imsglobal.org/spec/lti-ags/claim/endpoint",
                          {{"lineitem", url("/lineitems/a?type_id=1")}}}};
        saying.sign = [](const PlainJson& header, const PlainJson& claims) {
            return signed_by(platform_key(), header, claims);
        };
        if (spoil) spoil(saying);
        to.set_content(PlainJson{{"action", from.get_param_value("redirect_uri")},
                                 {"state", from.get_param_value("state")},
                                 {"hint", from.get_param_value("lti_message_hint")},
                                 {"id_token", saying.sign(saying.header, saying.claims)}}
                           .dump(),
                       "application/json");
    }

    void give_token(const httplib::Request& from, httplib::Response& to) {
        const std::lock_guard lock(mutex);
        if (trouble(to, answers_first)) return;
        const std::string assertion = from.get_param_value("client_assertion");
        const size_t dot = assertion.rfind('.'), first = assertion.find('.');
        const auto claims = PlainJson::parse(
            from_base64url(assertion.substr(first + 1, dot - first - 1)), nullptr, false);
        const auto now = static_cast<int64_t>(std::time(nullptr));
        const bool good =
            from.get_param_value("grant_type") == "client_credentials" &&
            from.get_param_value("client_assertion_type") ==
                "urn:ietf:params:oauth:client-assertion-type:jwt-bearer" &&
            from.get_param_value("scope") ==
                "https://purl.imsglobal.org/spec/lti-ags/scope/score" &&
            tool_key().signed_by_it(assertion.substr(0, dot),
                                    from_base64url(assertion.substr(dot + 1))) &&
            claims.is_object() && claims.value("iss", "") == kClient &&
            claims.value("sub", "") == kClient && claims.value("aud", "") == url("/token") &&
            claims.value("iat", int64_t{0}) <= now && claims.value("exp", int64_t{0}) > now &&
            claims.value("exp", int64_t{0}) <= now + 3600 &&
            seen_assertions_.insert(claims.value("jti", "")).second;
        if (!good) {
            to.status = 400;
            return to.set_content(R"({"error":"invalid_client"})", "application/json");
        }
        token_ = "bearer-" + std::to_string(++tokens_given);
        to.set_content(
            PlainJson{{"access_token", token_}, {"token_type", "Bearer"}, {"expires_in", 3600}}
                .dump(),
            "application/json");
    }

    void take_score(const httplib::Request& from, httplib::Response& to) {
        const std::lock_guard lock(mutex);
        if (trouble(to, answers_first) || trouble(to, scores_first)) return;
        if (token_.empty() || from.get_header_value("Authorization") != "Bearer " + token_ ||
            from.get_header_value("Content-Type") != "application/vnd.ims.lis.v1.score+json") {
            to.status = 401;
            return;
        }
        PlainJson score = PlainJson::parse(from.body, nullptr, false);
        score["lineitem"] = from.matches[1].str();
        score["query"] = from.get_param_value("type_id");
        scores.push_back(score);
        to.status = 204;
    }

    void take_statements(const httplib::Request& from, httplib::Response& to) {
        const std::lock_guard lock(mutex);
        ++statement_posts;
        if (trouble(to, answers_first)) return;
        const std::string basic =
            "Basic " + QByteArray::fromStdString(record_store_user).toBase64().toStdString();
        if (from.get_header_value("Authorization") != basic) {
            to.status = 401;
            return;
        }
        const auto all = PlainJson::parse(from.body, nullptr, false);
        if (!all.is_array() || from.get_header_value("X-Experience-API-Version") != "1.0.3") {
            to.status = 400;
            return;
        }
        PlainJson ids = PlainJson::array();
        for (const PlainJson& each : all) {
            const auto found = statements.find(each.value("id", ""));
            if (found != statements.end() && found->second != each) to.status = 409;
            ids.push_back(each.value("id", ""));
        }
        if (to.status == 409) return;
        for (const PlainJson& each : all) statements[each.value("id", "")] = each;
        to.set_content(ids.dump(), "application/json");
    }

    httplib::Server server_;
    int port_ = 0;
    std::thread thread_;
    std::string token_;
    std::set<std::string> seen_assertions_;
};

}  // namespace placode::test
