// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Reads JSON in place: no tree, no allocation, nothing thrown, so that a servo thread may do it.
// Tolerant of unknown keys; a text that is no JSON makes `failed()` true and everything after it
// empty. Strings are handed out as they stand, escapes and all.

#include <charconv>
#include <cstddef>
#include <string_view>

namespace placode::haptics {

class JsonScan {
 public:
    explicit JsonScan(std::string_view text) noexcept : text_(text) {}

    /// Calls `each(key)` with the scan before every value of an object; what `each` does not take
    /// is skipped. False: no object.
    template <class Each>
    bool object(Each&& each) noexcept {
        if (!enter('{')) return false;
        if (take('}')) return leave();
        do {
            const std::string_view key = string();
            if (failed_ || !take(':')) return fail();
            const size_t before = at_;
            each(key);
            if (!failed_ && at_ == before) skip();
        } while (!failed_ && take(','));
        return take('}') ? leave() : fail();
    }
    /// Calls `each()` before every value of an array. False: no array.
    template <class Each>
    bool array(Each&& each) noexcept {
        if (!enter('[')) return false;
        if (take(']')) return leave();
        do {
            const size_t before = at_;
            each();
            if (!failed_ && at_ == before) skip();
        } while (!failed_ && take(','));
        return take(']') ? leave() : fail();
    }
    /// The next value when it is of that kind; otherwise `otherwise`, and nothing is taken.
    [[nodiscard]] double number(double otherwise) noexcept {
        space();
        double value = 0;
        const auto [end, error] =
            std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
        if (error != std::errc{}) return otherwise;
        at_ = static_cast<size_t>(end - text_.data());
        return value;
    }
    [[nodiscard]] bool truth(bool otherwise) noexcept {
        if (word("true")) return true;
        if (word("false")) return false;
        return otherwise;
    }
    [[nodiscard]] std::string_view text() noexcept { return next() == '"' ? string() : ""; }
    [[nodiscard]] char next() noexcept {
        space();
        return at_ < text_.size() ? text_[at_] : '\0';
    }
    void skip() noexcept;
    [[nodiscard]] bool failed() const noexcept { return failed_; }

 private:
    static constexpr int kDeepest = 32;

    bool fail() noexcept {
        failed_ = true;
        return false;
    }
    bool enter(char open) noexcept {
        if (failed_ || next() != open) return false;
        if (++depth_ > kDeepest) return fail();
        ++at_;
        return true;
    }
    bool leave() noexcept {
        --depth_;
        return true;
    }
    void space() noexcept {
        while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\n' ||
                                      text_[at_] == '\r' || text_[at_] == '\t'))
            ++at_;
    }
    bool take(char c) noexcept {
        if (next() != c) return false;
        ++at_;
        return true;
    }
    bool word(std::string_view wanted) noexcept {
        space();
        if (text_.substr(at_, wanted.size()) != wanted) return false;
        at_ += wanted.size();
        return true;
    }
    std::string_view string() noexcept {
        if (!take('"')) {
            fail();
            return {};
        }
        const size_t begin = at_;
        while (at_ < text_.size() && text_[at_] != '"') at_ += text_[at_] == '\\' ? 2 : 1;
        if (at_ >= text_.size()) {
            fail();
            return {};
        }
        return text_.substr(begin, at_++ - begin);
    }

    std::string_view text_;
    size_t at_ = 0;
    int depth_ = 0;
    bool failed_ = false;
};

inline void JsonScan::skip() noexcept {
    switch (next()) {
        case '{':
            object([](std::string_view) {});
            return;
        case '[':
            array([] {});
            return;
        case '"':
            (void)string();
            return;
        default:
            if (word("true") || word("false") || word("null")) return;
            const size_t before = at_;
            (void)number(0);
            if (at_ == before) fail();
    }
}

}  // namespace placode::haptics
