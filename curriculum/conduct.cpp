// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/conduct.h"

#include <array>

namespace placode::curriculum {

namespace {

constexpr const char* kModeNames[] = {"practice", "exam", "study"};

// In the order of AttemptMode.
constexpr std::array<Conduct, 3> kTable{{
    {.aids = {.planned_line = true, .read_outs = true, .warnings = true, .depth = true},
     .tuning = true,
     .performance = true,
     .screenshots = true,
     .help = true,
     .own_device = true,
     .leave = true,
     .always_ask = false,
     .own_score = true,
     .own_account = true,
     .repeats = true},
    {.aids = {},
     .tuning = false,
     .performance = false,
     .screenshots = false,
     .help = false,
     .own_device = true,  // with the proctor beside
     .leave = true,
     .always_ask = true,
     .own_score = true,
     .own_account = true,
     .repeats = false},
    {.aids = {.planned_line = false, .read_outs = true, .warnings = true, .depth = true},
     .tuning = false,
     .performance = false,
     .screenshots = false,
     .help = true,
     .own_device = false,
     .leave = true,
     .always_ask = true,
     .own_score = false,
     .own_account = false,
     .repeats = false},
}};

bool* aid_of(Aids& aids, std::string_view name) noexcept {
    if (name == kAidNames[0]) return &aids.planned_line;
    if (name == kAidNames[1]) return &aids.read_outs;
    if (name == kAidNames[2]) return &aids.warnings;
    if (name == kAidNames[3]) return &aids.depth;
    return nullptr;
}

}  // namespace

const char* mode_name(AttemptMode mode) noexcept { return kModeNames[static_cast<size_t>(mode)]; }

std::optional<AttemptMode> mode_named(std::string_view name) noexcept {
    for (size_t i = 0; i < std::size(kModeNames); ++i) {
        if (name == kModeNames[i]) return static_cast<AttemptMode>(i);
    }
    return std::nullopt;
}

std::optional<Aids> aids_named(std::string_view names) noexcept {
    Aids aids;
    while (!names.empty()) {
        const size_t comma = names.find(',');
        bool* aid = aid_of(aids, names.substr(0, comma));
        if (aid == nullptr) return std::nullopt;
        *aid = true;
        names = comma == std::string_view::npos ? std::string_view{} : names.substr(comma + 1);
    }
    return aids;
}

std::string aid_names(const Aids& aids) {
    Aids copy = aids;
    std::string names;
    for (const std::string_view name : kAidNames) {
        if (!*aid_of(copy, name)) continue;
        if (!names.empty()) names += ',';
        names += name;
    }
    return names;
}

const Conduct& conduct_of(AttemptMode mode) noexcept { return kTable[static_cast<size_t>(mode)]; }

}  // namespace placode::curriculum
