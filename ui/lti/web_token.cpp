// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lti/web_token.h"

#include <openssl/bio.h>
#include <openssl/core_names.h>
#include <openssl/err.h>
#include <openssl/evp.h>
#include <openssl/param_build.h>
#include <openssl/pem.h>

#include <QByteArray>
#include <QCryptographicHash>

namespace placode::lti {
namespace {

template <auto Free>
struct Freed {
    template <class Thing>
    void operator()(Thing* thing) const {
        Free(thing);
    }
};
using Key = std::unique_ptr<EVP_PKEY, Freed<EVP_PKEY_free>>;
using KeyContext = std::unique_ptr<EVP_PKEY_CTX, Freed<EVP_PKEY_CTX_free>>;
using Digest = std::unique_ptr<EVP_MD_CTX, Freed<EVP_MD_CTX_free>>;
using Number = std::unique_ptr<BIGNUM, Freed<BN_free>>;

const unsigned char* bytes_of(const std::string& text) {
    return reinterpret_cast<const unsigned char*>(text.data());
}

std::string encoded(const std::string& bytes) {
    return QByteArray::fromStdString(bytes)
        .toBase64(QByteArray::Base64UrlEncoding | QByteArray::OmitTrailingEquals)
        .toStdString();
}

std::optional<std::string> decoded(const std::string& text) {
    // Qt would take the other alphabet and padding as well.
    if (text.find_first_of("+/=") != std::string::npos) return std::nullopt;
    const auto result = QByteArray::fromBase64Encoding(QByteArray::fromStdString(text),
                                                       QByteArray::Base64UrlEncoding |
                                                           QByteArray::OmitTrailingEquals |
                                                           QByteArray::AbortOnBase64DecodingErrors);
    if (!result) return std::nullopt;
    return result.decoded.toStdString();
}

Json object_of(const std::optional<std::string>& text, const char* what) {
    Json json = text ? Json::parse(*text, nullptr, false) : Json();
    if (!json.is_object())
        throw TokenError(TokenFault::kMalformed, std::string(what) + " is no JSON");
    return json;
}

std::string text_at(const Json& json, const char* key) {
    const auto found = json.find(key);
    return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

Number number_of(const std::string& bytes) {
    return Number(BN_bin2bn(bytes_of(bytes), static_cast<int>(bytes.size()), nullptr));
}

/// Null where it is no key for RS256.
Key key_of(const PublicKey& from) {
    const Number n = number_of(from.modulus), e = number_of(from.exponent);
    if (n == nullptr || e == nullptr || BN_num_bits(n.get()) < kLeastKeyBits) return nullptr;
    const std::unique_ptr<OSSL_PARAM_BLD, Freed<OSSL_PARAM_BLD_free>> build(OSSL_PARAM_BLD_new());
    if (build == nullptr ||
        OSSL_PARAM_BLD_push_BN(build.get(), OSSL_PKEY_PARAM_RSA_N, n.get()) != 1 ||
        OSSL_PARAM_BLD_push_BN(build.get(), OSSL_PKEY_PARAM_RSA_E, e.get()) != 1)
        return nullptr;
    const std::unique_ptr<OSSL_PARAM, Freed<OSSL_PARAM_free>> parameters(
        OSSL_PARAM_BLD_to_param(build.get()));
    const KeyContext context(EVP_PKEY_CTX_new_from_name(nullptr, "RSA", nullptr));
    EVP_PKEY* key = nullptr;
    if (parameters == nullptr || context == nullptr || EVP_PKEY_fromdata_init(context.get()) != 1 ||
        EVP_PKEY_fromdata(context.get(), &key, EVP_PKEY_PUBLIC_KEY, parameters.get()) != 1)
        return nullptr;
    return Key(key);
}

std::string number_in(const EVP_PKEY* key, const char* name) {
    BIGNUM* value = nullptr;
    if (EVP_PKEY_get_bn_param(key, name, &value) != 1) return {};
    const Number owned(value);
    std::string bytes(static_cast<size_t>(BN_num_bytes(value)), '\0');
    BN_bn2bin(value, reinterpret_cast<unsigned char*>(bytes.data()));
    return bytes;
}

/// No password is asked for at a terminal that a server does not have.
int no_password(char*, int, int, void*) { return -1; }

/// RFC 7638: of the members that are required, in the order of the alphabet.
std::string thumbprint(const PublicKey& key) {
    const std::string text = R"({"e":")" + encoded(key.exponent) + R"(","kty":"RSA","n":")" +
                             encoded(key.modulus) + "\"}";
    return encoded(
        QCryptographicHash::hash(QByteArray::fromStdString(text), QCryptographicHash::Sha256)
            .toStdString());
}

}  // namespace

std::vector<PublicKey> parse_key_set(const std::string& text) {
    const Json set = object_of(text, "the key set");
    const auto keys = set.find("keys");
    if (keys == set.end() || !keys->is_array())
        throw TokenError(TokenFault::kMalformed, "the key set has no keys");
    std::vector<PublicKey> found;
    for (const Json& each : *keys) {
        if (!each.is_object() || text_at(each, "kty") != "RSA") continue;
        const std::string use = text_at(each, "use"), algorithm = text_at(each, "alg");
        if ((!use.empty() && use != "sig") || (!algorithm.empty() && algorithm != "RS256"))
            continue;
        const auto modulus = decoded(text_at(each, "n")), exponent = decoded(text_at(each, "e"));
        if (modulus && exponent && !modulus->empty() && !exponent->empty())
            found.push_back({text_at(each, "kid"), *modulus, *exponent});
    }
    return found;
}

std::string key_set_text(const PublicKey& key) {
    const Json set{{"keys",
                    {{{"kty", "RSA"},
                      {"use", "sig"},
                      {"alg", "RS256"},
                      {"kid", key.id},
                      {"n", encoded(key.modulus)},
                      {"e", encoded(key.exponent)}}}}};
    return set.dump();
}

SigningKey::SigningKey(const std::string& pem) : key_(nullptr, EVP_PKEY_free) {
    const std::unique_ptr<BIO, Freed<BIO_free>> source(
        BIO_new_mem_buf(pem.data(), static_cast<int>(pem.size())));
    key_.reset(PEM_read_bio_PrivateKey(source.get(), nullptr, no_password, nullptr));
    ERR_clear_error();
    if (key_ == nullptr)
        throw std::invalid_argument("holds no private key that can be read without a password");
    if (EVP_PKEY_is_a(key_.get(), "RSA") != 1)
        throw std::invalid_argument("holds a key of another kind; expected RSA");
    if (EVP_PKEY_get_bits(key_.get()) < kLeastKeyBits)
        throw std::invalid_argument("holds a key of " +
                                    std::to_string(EVP_PKEY_get_bits(key_.get())) +
                                    " bits; expected at least " + std::to_string(kLeastKeyBits));
    public_.modulus = number_in(key_.get(), OSSL_PKEY_PARAM_RSA_N);
    public_.exponent = number_in(key_.get(), OSSL_PKEY_PARAM_RSA_E);
    public_.id = thumbprint(public_);
}

std::string SigningKey::token(const Json& claims) const {
    const Json header{{"alg", "RS256"}, {"typ", "JWT"}, {"kid", public_.id}};
    const std::string bytes = encoded(header.dump()) + "." + encoded(claims.dump());
    const Digest digest(EVP_MD_CTX_new());
    size_t length = 0;
    std::string signature;
    if (digest != nullptr &&
        EVP_DigestSignInit(digest.get(), nullptr, EVP_sha256(), nullptr, key_.get()) == 1 &&
        EVP_DigestSign(digest.get(), nullptr, &length, bytes_of(bytes), bytes.size()) == 1) {
        signature.resize(length);
        if (EVP_DigestSign(digest.get(), reinterpret_cast<unsigned char*>(signature.data()),
                           &length, bytes_of(bytes), bytes.size()) == 1) {
            signature.resize(length);
            return bytes + "." + encoded(signature);
        }
    }
    throw std::runtime_error("a token cannot be signed");
}

bool is_signed(const std::string& bytes, const std::string& signature, const PublicKey& by) {
    const Key key = key_of(by);
    const Digest digest(EVP_MD_CTX_new());
    const bool good =
        key != nullptr && digest != nullptr &&
        EVP_DigestVerifyInit(digest.get(), nullptr, EVP_sha256(), nullptr, key.get()) == 1 &&
        EVP_DigestVerify(digest.get(), bytes_of(signature), signature.size(), bytes_of(bytes),
                         bytes.size()) == 1;
    ERR_clear_error();  // A wrong signature leaves one, which the next TLS connection would read.
    return good;
}

Json open_token(const std::string& token, const FindKey& find_key) {
    const size_t first = token.find('.'), second = token.find('.', first + 1);
    if (first == std::string::npos || second == std::string::npos ||
        token.find('.', second + 1) != std::string::npos)
        throw TokenError(TokenFault::kMalformed, "the token has not three parts");
    const Json header = object_of(decoded(token.substr(0, first)), "the token's head");
    if (text_at(header, "alg") != "RS256" || header.contains("crit"))
        throw TokenError(TokenFault::kAlgorithm, "the token is not signed with RS256");
    const std::string id = text_at(header, "kid");
    const auto key = id.empty() ? std::nullopt : find_key(id);
    if (!key) throw TokenError(TokenFault::kUnknownKey, "the token's key is unknown");
    const auto signature = decoded(token.substr(second + 1));
    if (!signature || !is_signed(token.substr(0, second), *signature, *key))
        throw TokenError(TokenFault::kSignature, "the token's signature is wrong");
    return object_of(decoded(token.substr(first + 1, second - first - 1)), "the token");
}

}  // namespace placode::lti
