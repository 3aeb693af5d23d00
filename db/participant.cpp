// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/participant.h"

#include <cassert>
#include <cctype>
#include <string_view>

namespace placode::db {
namespace {

// 23 letters, a prime: with weights that differ modulo 23, every change of one digit and every swap
// of neighbours moves the sum. I, O and Q look like 1 and 0.
constexpr std::string_view kLetters = "ABCDEFGHJKLMNPRSTUVWXYZ";

char check_letter(std::string_view digits) {
    int sum = 0;
    int weight = 2;
    for (auto digit = digits.rbegin(); digit != digits.rend(); ++digit)
        sum += (*digit - '0') * weight++;
    return kLetters[static_cast<size_t>(sum) % kLetters.size()];
}

}  // namespace

std::string participant_code(int number) {
    assert(number > 0);
    std::string digits = std::to_string(number);
    if (digits.size() < 3) digits.insert(0, 3 - digits.size(), '0');
    return "P" + digits + "-" + check_letter(digits);
}

bool valid_participant_code(const std::string& code) {
    if (code.size() < 6 || std::toupper(static_cast<unsigned char>(code[0])) != 'P') return false;
    const std::string_view digits(code.data() + 1, code.size() - 3);
    for (const char digit : digits)
        if (digit < '0' || digit > '9') return false;
    return code[code.size() - 2] == '-' &&
           std::toupper(static_cast<unsigned char>(code.back())) == check_letter(digits);
}

}  // namespace placode::db
