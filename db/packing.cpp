// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/packing.h"

#include <sodium.h>
#include <zstd.h>

#include <array>
#include <memory>

#include "db/hex.h"
#include "db/password.h"
#include "db/store_error.h"

namespace placode::db {

Bytes compress(std::span<const std::byte> bytes) {
    constexpr int kLevel = 3;
    Bytes packed(ZSTD_compressBound(bytes.size()));
    const size_t size =
        ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), kLevel);
    if (ZSTD_isError(size) != 0)
        throw StoreError(StoreError::Kind::kOther,
                         std::string("compress: ") + ZSTD_getErrorName(size));
    packed.resize(size);
    return packed;
}

size_t stated_size(std::span<const std::byte> packed) {
    const unsigned long long stated = ZSTD_getFrameContentSize(packed.data(), packed.size());
    return stated == ZSTD_CONTENTSIZE_UNKNOWN || stated == ZSTD_CONTENTSIZE_ERROR ? 0 : stated;
}

Bytes decompress(std::span<const std::byte> packed, size_t size) {
    // The frame says its size itself: never allocate what only a damaged number asks for.
    const unsigned long long stated = ZSTD_getFrameContentSize(packed.data(), packed.size());
    if (stated != size)
        throw StoreError(StoreError::Kind::kDamaged,
                         "decompress: the compressed bytes are damaged");
    Bytes bytes(size);
    const size_t got = ZSTD_decompress(bytes.data(), bytes.size(), packed.data(), packed.size());
    if (ZSTD_isError(got) != 0 || got != size)
        throw StoreError(StoreError::Kind::kDamaged,
                         "decompress: the compressed bytes are damaged");
    return bytes;
}

std::string checksum_of_packed(std::span<const std::byte> packed, size_t size) {
    need_sodium();
    const auto damaged = [] {
        return StoreError(StoreError::Kind::kDamaged,
                          "decompress: the compressed bytes are damaged");
    };
    const std::unique_ptr<ZSTD_DStream, decltype(&ZSTD_freeDStream)> stream(ZSTD_createDStream(),
                                                                            ZSTD_freeDStream);
    if (stream == nullptr || stated_size(packed) != size) throw damaged();
    Bytes part(ZSTD_DStreamOutSize());
    ZSTD_inBuffer in{packed.data(), packed.size(), 0};
    crypto_generichash_state state;
    std::array<unsigned char, 32> sum{};
    crypto_generichash_init(&state, nullptr, 0, sum.size());
    size_t got = 0;
    for (size_t left = 1; left != 0;) {
        ZSTD_outBuffer out{part.data(), part.size(), 0};
        const size_t read_before = in.pos;
        left = ZSTD_decompressStream(stream.get(), &out, &in);
        got += out.pos;
        const bool stands_still = out.pos == 0 && in.pos == read_before;
        if (ZSTD_isError(left) != 0 || got > size || (left != 0 && stands_still)) throw damaged();
        crypto_generichash_update(&state, reinterpret_cast<const unsigned char*>(part.data()),
                                  out.pos);
    }
    if (got != size || in.pos != in.size) throw damaged();
    crypto_generichash_final(&state, sum.data(), sum.size());
    return hex_of(sum);
}

std::string checksum_hex(std::span<const std::byte> bytes) {
    need_sodium();
    std::array<unsigned char, 32> sum{};
    crypto_generichash(sum.data(), sum.size(), reinterpret_cast<const unsigned char*>(bytes.data()),
                       bytes.size(), nullptr, 0);
    return hex_of(sum);
}

std::string checksum_hex(const std::string& text) {
    return checksum_hex(std::as_bytes(std::span(text.data(), text.size())));
}

}  // namespace placode::db
