// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Signed tokens and keys against the examples of the standards.
#include "ui/lti/web_token.h"

#include "tests/mock_platform.h"

#include <gtest/gtest.h>

namespace placode::lti {
namespace THIS_TEST {

using test::from_base64url;
using test::TestKey;
using test::to_base64url;

// RFC 7515, appendix A.2.
const std::string kModulus =
    "ofgWCuLjybRlzo0tZWJjNiuSfb4p4fAkd_wWJcyQoTbji9k0l8W26mPddxHmfHQp-Vaw-4qPCJrcS2mJPMEzP1Pt0Bm4d4"
    "QlL-yRT-SFd2lZS-pCgNMsD1W_YpRPEwOWvG6b32690r2jZ47soMZo9wGzjb_7OMg0LOL-bSf63kpaSHSXndS5z5rexMdb"
    "BYUsLA9e-KXBdQOS-UTo7WTBEMa2R2CapHg665xsmtdVMTBQY4uDZlxvb3qCo5ZwKh9kG4LT6_I5IhlJH7aGhyxXFvUK-D"
    "WNmoudF8NAco9_h9iaGNj8q2ethFkMLs91kzk2PAcDTW9gb54h4FRWyuXpoQ";
const std::string kSigned =
    "eyJhbGciOiJSUzI1NiJ9.eyJpc3MiOiJqb2UiLA0KICJleHAiOjEzMDA4MTkzODAsDQogImh0dHA6Ly9leGFtcGxlLmNvb"
    "S9pc19yb290Ijp0cnVlfQ";
const std::string kSignature =
    "cC4hiUPoj9Eetdgtv3hF80EGrhuB__dzERat0XF9g2VtQgr9PJbu3XOiZj5RZmh7AAuHIm4Bh-0Qc_lF5YKt_"
    "O8W2Fp5juj"
    "Gbds9uJdbF9CUAr7t1dnZcAcQjbKBYNX4BAynRFdiuB--f_nZLgrnbyTyWzO75vRK5h6xBArLIARNPvkSjtQBMHlb1L07"
    "Qe7K0GarZRmB_eSN9383LcOLn6_dO--xi12jzDwusC-"
    "eOkHWEsqtFZESc6BfI7noOPqvhJ1phCnvWh6IeYI2w9QOYEUipUT"
    "I8np6LbgGY9Fs98rqVt5AXLIhWkWywlVmtVrBp0igcN_IoypGlUPQGe77Rw";

TEST(WebToken, TheStandardsExampleIsSigned) {
    const PublicKey key{"", from_base64url(kModulus), from_base64url("AQAB")};
    const std::string signature = from_base64url(kSignature);
    EXPECT_TRUE(is_signed(kSigned, signature, key));
    for (const size_t at : {size_t{0}, kSigned.size() - 1}) {
        std::string changed = kSigned;
        changed[at] ^= 1;
        EXPECT_FALSE(is_signed(changed, signature, key));
    }
    std::string spoilt = signature;
    spoilt.back() ^= 1;
    EXPECT_FALSE(is_signed(kSigned, spoilt, key));
    EXPECT_FALSE(is_signed(kSigned, "", key));
    EXPECT_FALSE(is_signed(kSigned, signature, {"", "", ""}));
    EXPECT_FALSE(is_signed(kSigned, signature, {"", key.modulus.substr(0, 128), key.exponent}));
}

TEST(WebToken, OwnTokensAreReadByOthersAndByUs) {
    const SigningKey key(test::tool_key().private_pem());
    const std::string token = key.token({{"iss", "ż"}, {"exp", 7}});
    const size_t dot = token.rfind('.');
    EXPECT_TRUE(
        test::tool_key().signed_by_it(token.substr(0, dot), from_base64url(token.substr(dot + 1))));
    const auto known = [&](const std::string& id) {
        return id == key.public_key().id ? std::optional(key.public_key()) : std::nullopt;
    };
    EXPECT_EQ(open_token(token, known), (Json{{"iss", "ż"}, {"exp", 7}}));
    const auto keys = parse_key_set(key_set_text(key.public_key()));
    ASSERT_EQ(keys.size(), 1U);
    EXPECT_EQ(keys[0].id, key.public_key().id);
    EXPECT_EQ(keys[0].modulus, key.public_key().modulus);
    EXPECT_EQ(keys[0].exponent, from_base64url("AQAB"));
    EXPECT_EQ(Json::parse(key_set_text(key.public_key()))["keys"][0]["n"],
              test::tool_key().public_jwk()["n"]);
}

// RFC 7638, 3.1: of the modulus there it is "NzbLsXh8...". Here by a second way, because the
// private half of that key is not published.
TEST(WebToken, AKeyIsNamedByItsThumbprint) {
    const SigningKey key(test::tool_key().private_pem());
    const auto jwk = test::tool_key().public_jwk();
    const std::string text =
        "{\"e\":\"AQAB\",\"kty\":\"RSA\",\"n\":\"" + jwk["n"].get<std::string>() + "\"}";
    unsigned char hash[32];
    unsigned length = 0;
    EVP_Digest(text.data(), text.size(), hash, &length, EVP_sha256(), nullptr);
    EXPECT_EQ(key.public_key().id,
              to_base64url(std::string(reinterpret_cast<char*>(hash), length)));
}

TEST(WebToken, KeysOfOtherKindsAreLeftOut) {
    const auto good = test::platform_key().public_jwk();
    auto encrypts = good, other = good, bare = good;
    encrypts["use"] = "enc";
    other["alg"] = "RS512";
    bare.erase("use");
    bare.erase("alg");
    bare["kid"] = "bare";
    const Json set{{"keys",
                    {encrypts, other, Json{{"kty", "EC"}, {"crv", "P-256"}},
                     Json{{"kty", "oct"}, {"k", "c2VjcmV0"}, {"kid", "platform-1"}}, 7, bare}}};
    const auto keys = parse_key_set(set.dump());
    ASSERT_EQ(keys.size(), 1U);
    EXPECT_EQ(keys[0].id, "bare");
    for (const char* text : {"", "[]", "{}", "{\"keys\":7}", "<html>"})
        EXPECT_THROW((void)parse_key_set(text), TokenError) << text;
}

TEST(WebToken, PrivateKeysThatWouldNotDoAreRefusedWithoutBeingShown) {
    const TestKey weak("weak", 1024);
    const auto problem_of = [](const std::string& pem) -> std::string {
        try {
            const SigningKey key(pem);
        } catch (const std::invalid_argument& error) {
            return error.what();
        }
        return "taken";
    };
    EXPECT_NE(problem_of(weak.private_pem()).find("1024 bits"), std::string::npos);
    EXPECT_NE(problem_of("").find("no private key"), std::string::npos);
    EXPECT_NE(problem_of(test::tool_key().public_pem()).find("no private key"), std::string::npos);
    const std::string pem = test::tool_key().private_pem();
    const std::string half = pem.substr(0, pem.size() / 2);
    EXPECT_EQ(problem_of(half).find(half.substr(100, 20)), std::string::npos);
    EXPECT_EQ(problem_of(pem), "taken");
}

}  // namespace THIS_TEST
}  // namespace placode::lti
