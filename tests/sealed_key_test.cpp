// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/sealed_key.h"

#include <gmock/gmock.h>

#include "db/signature.h"
#include "db/store_error.h"

using namespace placode;

namespace THIS_TEST {

// Sealed as every store will have it: this is slow on purpose (libsodium, "moderate").
TEST(SealedKey, OpensWithItsPassphraseOnly) {
    const std::string secret = db::new_key_pair().secret_key;
    const std::string sealed = db::seal_key(secret, "żółć i cztery słowa", false);
    EXPECT_THAT(sealed, testing::StartsWith("sealed-1 argon2id13 3 268435456 "));
    EXPECT_NE(db::seal_key(secret, "żółć i cztery słowa", true),
              db::seal_key(secret, "żółć i cztery słowa", true))
        << "salt and nonce are new";
    EXPECT_EQ(db::open_key(sealed, "żółć i cztery słowa")->text(), secret);
    EXPECT_FALSE(db::open_key(sealed, "żółć i cztery słowa "));
    // As another keyboard composes the same letters.
    EXPECT_EQ(db::open_key(db::seal_key(secret, "ó with an accent", true), "o\u0301 with an accent")
                  ->text(),
              secret);
}

TEST(SealedKey, ATextThatAsksForTooMuchIsNone) {
    const std::string secret = db::new_key_pair().secret_key;
    const std::string sealed = db::seal_key(secret, "four words are good", true);
    for (const char* changed : {"sealed-1 argon2id13 99999999 8192 ", "sealed-1 argon2id13 1 8 ",
                                "sealed-1 argon2id13 1 99999999999 ", "sealed-1 argon2id13 "}) {
        const std::string text = changed + sealed.substr(sealed.find("8192 ") + 5);
        EXPECT_TRUE(db::is_sealed_key(text));
        EXPECT_THROW((void)db::open_key(text, "four words are good"), db::StoreError) << changed;
    }
    EXPECT_THROW((void)db::open_key(secret, "four words are good"), db::StoreError);
    EXPECT_THROW((void)db::open_key(sealed + " more", "four words are good"), db::StoreError);
    std::string other = sealed;
    other.back() = other.back() == '0' ? '1' : '0';
    EXPECT_FALSE(db::open_key(other, "four words are good")) << "one bit, and it is no key";
}

TEST(Secret, IsOverwrittenWhenItGoes) {
    std::string text = "a passphrase of some length, so that it stands in memory of its own";
    const char* const bytes = text.data();
    const size_t size = text.size();
    db::wipe(text);
    EXPECT_TRUE(text.empty());
    EXPECT_EQ(std::string(bytes, size), std::string(size, '\0')) << "the buffer is still the same";
    db::Secret first("short");
    const char* const place = first.text().data();
    db::Secret second = std::move(first);
    EXPECT_EQ(second.text(), "short");
    EXPECT_EQ(second.text().data(), place) << "moved, not copied: no second place to overwrite";
    second = db::Secret("another");
    EXPECT_EQ(second.text(), "another");
}

}  // namespace THIS_TEST
