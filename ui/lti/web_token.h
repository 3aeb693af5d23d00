// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Signed JSON: tokens with RS256 and no other algorithm (RFC 7515, 7518, 7519), and the keys for
// them as JSON Web Key sets (RFC 7517). What no code is there for cannot be asked for: a token that
// names `none` or a keyed hash is refused before a key is looked up.

#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

struct evp_pkey_st;

namespace placode::lti {

using Json = nlohmann::json;

/// Keys of fewer bits are refused.
inline constexpr int kLeastKeyBits = 2048;

enum class TokenFault : uint8_t { kMalformed, kAlgorithm, kUnknownKey, kSignature };

class TokenError : public std::runtime_error {
 public:
    TokenError(TokenFault fault, const std::string& what)
        : std::runtime_error(what), fault(fault) {}
    const TokenFault fault;
};

struct PublicKey {
    std::string id;                 ///< `kid`
    std::string modulus, exponent;  ///< Big-endian bytes.
};

/// The RSA keys of a set that may sign with RS256; others are left out. Throws TokenError
/// (kMalformed) where it is no set.
[[nodiscard]] std::vector<PublicKey> parse_key_set(const std::string& text);
[[nodiscard]] std::string key_set_text(const PublicKey& key);

/// A private RSA key. Its public part is named by its thumbprint (RFC 7638). Any thread may sign.
class SigningKey {
 public:
    /// @param pem PKCS #8 or PKCS #1, without a password. Throws std::invalid_argument that says
    /// what is wrong, and nothing of what stands in it.
    explicit SigningKey(const std::string& pem);
    [[nodiscard]] const PublicKey& public_key() const noexcept { return public_; }
    /// The compact form. Throws std::runtime_error where memory is missing.
    [[nodiscard]] std::string token(const Json& claims) const;

 private:
    std::unique_ptr<evp_pkey_st, void (*)(evp_pkey_st*)> key_;
    PublicKey public_;
};

/// RSASSA-PKCS1-v1_5 with SHA-256 (RFC 7518, 3.3). False also for a key that is none.
[[nodiscard]] bool is_signed(const std::string& bytes, const std::string& signature,
                             const PublicKey& by);

using FindKey = std::function<std::optional<PublicKey>(const std::string& id)>;
/// The claims of a token whose signature is right. Throws TokenError.
[[nodiscard]] Json open_token(const std::string& token, const FindKey& find_key);

}  // namespace placode::lti
