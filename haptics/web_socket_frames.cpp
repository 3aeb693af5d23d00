// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The frames of a WebSocket (RFC 6455, section 5): what is sent, what may come, and how messages
// are put together again.
#include <cstring>

#include "haptics/web_socket.h"

namespace placode::haptics {

bool WebSocket::send_frame(uint8_t opcode, std::string_view payload) noexcept {
    if (state_ != State::kOpen || payload.size() > 65535) return false;
    const size_t header = payload.size() < 126 ? 6 : 8;
    if (out_size_ + header + payload.size() > out_.size()) return false;
    auto* at = reinterpret_cast<uint8_t*>(out_.data() + out_size_);
    *at++ = static_cast<uint8_t>(0x80 | opcode);
    if (payload.size() < 126) {
        *at++ = static_cast<uint8_t>(0x80 | payload.size());
    } else {
        *at++ = 0x80 | 126;
        *at++ = static_cast<uint8_t>(payload.size() >> 8);
        *at++ = static_cast<uint8_t>(payload.size() & 0xFF);
    }
    // A client masks. xorshift32: nothing between here and a local service could be misled.
    mask_ ^= mask_ << 13;
    mask_ ^= mask_ >> 17;
    mask_ ^= mask_ << 5;
    uint8_t mask[4];
    std::memcpy(mask, &mask_, 4);
    std::memcpy(at, mask, 4);
    at += 4;
    for (size_t i = 0; i < payload.size(); ++i)
        at[i] = static_cast<uint8_t>(static_cast<uint8_t>(payload[i]) ^ mask[i % 4]);
    out_size_ += header + payload.size();
    if (!flush()) failed_ = true;
    return !failed_;
}

bool WebSocket::send_text(std::string_view text) noexcept {
    // What the service has not taken yet is older than what there is to say now.
    if (out_size_ > 0 && !flush()) failed_ = true;
    if (out_size_ > 0) return false;
    return send_frame(kText, text);
}

// What RFC 6455 allows here: no extensions, whole and short control frames, fragments only of a
// message that has begun and has not ended.
bool WebSocket::allowed(uint8_t first, uint64_t size) const noexcept {
    if ((first & 0x70) != 0) return false;
    const bool last = (first & 0x80) != 0;
    switch (first & 0x0F) {
        case kText:
        case kBinary:
            return !message_open_;
        case kContinuation:
            return message_open_;
        case kClose:
        case kPing:
        case kPong:
            return last && size <= 125;
        default:
            return false;
    }
}

// Takes one frame from the buffer; false: none is complete.
bool WebSocket::take_frame() noexcept {
    const auto* in = reinterpret_cast<const uint8_t*>(in_.data());
    if (in_size_ < 2) return false;
    size_t header = 2;
    uint64_t size = in[1] & 0x7Fu;
    if (size == 126) {
        header = 4;
        if (in_size_ < header) return false;
        size = static_cast<uint64_t>(in[2]) << 8 | in[3];
    } else if (size == 127) {
        header = 10;
        if (in_size_ < header) return false;
        size = 0;
        for (int i = 2; i < 10; ++i) size = size << 8 | in[i];
    }
    const uint8_t opcode = in[0] & 0x0F;
    // A service does not mask; a message that does not fit could never be finished; what breaks the
    // protocol cannot be understood further on.
    if ((in[1] & 0x80) != 0 || size > in_.size() - header || !allowed(in[0], size)) {
        failed_ = true;
        return false;
    }
    if (in_size_ < header + size) return false;
    const std::string_view payload(in_.data() + header, static_cast<size_t>(size));
    if (opcode == kPing) {
        send_frame(kPong, payload);
    } else if (opcode == kClose) {
        send_frame(kClose, payload.substr(0, 2));
        failed_ = true;
    } else if (opcode == kText || opcode == kBinary || opcode == kContinuation) {
        if (opcode != kContinuation) {
            message_size_ = 0;
            message_text_ = opcode == kText;
            message_open_ = true;
        }
        if (message_size_ + payload.size() > message_.size()) {
            failed_ = true;
            return false;
        }
        std::memcpy(message_.data() + message_size_, payload.data(), payload.size());
        message_size_ += payload.size();
        message_complete_ = (in[0] & 0x80) != 0;
        if (message_complete_) message_open_ = false;
    }
    const size_t all = header + static_cast<size_t>(size);
    in_size_ -= all;
    std::memmove(in_.data(), in_.data() + all, in_size_);
    return true;
}

bool WebSocket::next_message(std::string_view& text) noexcept {
    while (state_ == State::kOpen && !failed_ && take_frame()) {
        if (!message_complete_) continue;
        message_complete_ = false;
        if (!message_text_) continue;
        text = {message_.data(), message_size_};
        message_size_ = 0;
        return true;
    }
    return false;
}

}  // namespace placode::haptics
