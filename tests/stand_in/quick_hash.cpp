// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Stands before libsodium (LD_PRELOAD) in programs that tests start some hundred times: a password
// is hashed with the least that Argon2id allows, where the product takes two passes over 64 MiB. A
// hash carries its own costs, so that programs with and without this read each other's.
// programs_test looks at the product's.

#include <dlfcn.h>

#include <cstddef>

namespace {

// crypto_pwhash_OPSLIMIT_INTERACTIVE and _MIN, crypto_pwhash_MEMLIMIT_INTERACTIVE and _MIN.
constexpr unsigned long long kPasses = 2, kFewestPasses = 1;
constexpr size_t kBytes = size_t{64} << 20, kFewestBytes = 8192;

/// What comes after this in the order of loading.
template <class Function>
Function* real(const char* name) {
    return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" int crypto_pwhash_str(char* out, const char* password, unsigned long long length,
                                 unsigned long long passes, size_t bytes) {
    static const auto hash =
        real<int(char*, const char*, unsigned long long, unsigned long long, size_t)>(
            "crypto_pwhash_str");
    const bool of_accounts = passes == kPasses && bytes == kBytes;
    return of_accounts ? hash(out, password, length, kFewestPasses, kFewestBytes)
                       : hash(out, password, length, passes, bytes);
}

extern "C" int crypto_pwhash_str_needs_rehash(const char* text, unsigned long long passes,
                                              size_t bytes) {
    static const auto needs =
        real<int(const char*, unsigned long long, size_t)>("crypto_pwhash_str_needs_rehash");
    const bool of_accounts = passes == kPasses && bytes == kBytes;
    return of_accounts ? needs(text, kFewestPasses, kFewestBytes) : needs(text, passes, bytes);
}
