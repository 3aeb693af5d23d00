// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/void_reason.h"

#include <array>
#include <charconv>
#include <optional>

namespace placode::db {
namespace {

constexpr std::string_view kBetween = "; ";
constexpr std::string_view kTuned = "Tissue or generator was tuned";
constexpr std::string_view kInterrupted = "interrupted";
constexpr std::string_view kVoid = "void: ";

/// A sentence with two numbers: before, between and behind them.
using Sentence = std::array<std::string_view, 3>;
constexpr Sentence kPictures{"The computer was too slow: ", " pictures a second, ", " are needed"};
constexpr Sentence kOnePicture{kPictures[0], " picture a second, ", kPictures[2]};
constexpr Sentence kRealTime{"The computer was too slow: the simulation ran at ",
                             " % of real time, ", " % are needed"};
/// A sentence about a doubt: before and behind what is named.
struct Doubt {
    VoidCause cause;
    std::string_view before, behind;
};
constexpr std::array kDoubts{
    Doubt{VoidCause::kTaskUnknown, "Practice, not verified: no task ", " is published here"},
    Doubt{VoidCause::kTaskDiffers, "Practice, not verified: its task is not the published ", ""},
    Doubt{VoidCause::kUnsound, "Practice, not verified: it cannot be scored, ", ""},
    Doubt{VoidCause::kSameRecording, "Practice, not verified: the recording is that of attempt ",
          ""},
    Doubt{VoidCause::kReplayDiffers, "Practice, not verified: simulated again it differs, ", ""},
    Doubt{VoidCause::kScript, "Practice, not verified: operated by ", ""},
    Doubt{VoidCause::kUnsigned, "Practice, not verified: the recording is signed by ",
          ", not by a computer of this store"},
    Doubt{VoidCause::kNoRecording, "Practice, not verified: nothing was recorded", ""},
    Doubt{VoidCause::kOrderDiffers,
          "Practice, not verified: it was begun for another person, exam or proctor", ""},
    Doubt{VoidCause::kOrderMissing,
          "Practice, not verified: nothing shows for whom and for which exam it was begun", ""},
    Doubt{VoidCause::kProctor,
          "Practice, not verified: the proctor is the person examined, or neither educator nor "
          "administrator here",
          ""},
    Doubt{VoidCause::kExamClosed, "Practice, not verified: it is not the exam that was open, ", ""},
    Doubt{VoidCause::kClock, "Practice, not verified: the time that it says cannot be right, ", ""},
    Doubt{VoidCause::kTaskVersion,
          "Practice, not verified: the exam asked for another version than ", ""},
};
/// With one number.
constexpr std::array<std::string_view, 2> kGiven{"Begun at stage ",
                                                 ", what came before it was given"};
constexpr Sentence kEarly{"ended after ", " s, before the least duration of ", " s"};

std::string said(const Sentence& sentence, int first, int second) {
    return std::string(sentence[0]) + std::to_string(first) + std::string(sentence[1]) +
           std::to_string(second) + std::string(sentence[2]);
}

/// Takes `part` off the front; false when something else stands there.
bool take(std::string_view& text, std::string_view part) {
    if (!text.starts_with(part)) return false;
    text.remove_prefix(part.size());
    return true;
}

bool take(std::string_view& text, int& number) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc()) return false;
    text.remove_prefix(static_cast<size_t>(end - text.data()));
    return true;
}

struct Numbers {
    int first = 0, second = 0;
};
std::optional<Numbers> numbers_of(std::string_view text, const Sentence& sentence) {
    Numbers n;
    if (take(text, sentence[0]) && take(text, n.first) && take(text, sentence[1]) &&
        take(text, n.second) && text == sentence[2])
        return n;
    return std::nullopt;
}

std::optional<int> stage_of(std::string_view text) {
    int stage = 0;
    if (take(text, kGiven[0]) && take(text, stage) && text == kGiven[1]) return stage;
    return std::nullopt;
}

VoidReason void_reason(std::string_view text) {
    if (text == kTuned) return {VoidCause::kTuned, 0, 0, {}};
    // Stores hold "1 pictures" of earlier versions, too.
    for (const Sentence& sentence : {kPictures, kOnePicture})
        if (const auto n = numbers_of(text, sentence))
            return {VoidCause::kFewPictures, n->first, n->second, {}};
    if (const auto n = numbers_of(text, kRealTime))
        return {VoidCause::kNotRealTime, n->first, n->second, {}};
    if (const auto stage = stage_of(text)) return {VoidCause::kGiven, *stage, 0, {}};
    for (const Doubt& doubt : kDoubts) {
        if (!text.starts_with(doubt.before) || !text.ends_with(doubt.behind) ||
            text.size() < doubt.before.size() + doubt.behind.size())
            continue;
        text.remove_prefix(doubt.before.size());
        text.remove_suffix(doubt.behind.size());
        return {doubt.cause, 0, 0, Said::as_is(std::string(text))};
    }
    return {VoidCause::kDevice, 0, 0, Said::as_is(std::string(text))};
}

/// What is named comes from a file: it must not look like the next reason.
std::string doubt_text(const VoidReason& reason) {
    std::string named = reason.detail.english();
    for (size_t at = named.find(kBetween); at != std::string::npos; at = named.find(kBetween))
        named.replace(at, kBetween.size(), ", ");
    for (const Doubt& doubt : kDoubts)
        if (doubt.cause == reason.cause)
            return std::string(doubt.before) + named + std::string(doubt.behind);
    return named;
}

std::string text_of(const VoidReason& reason) {
    switch (reason.cause) {
        case VoidCause::kFewPictures:
            return said(reason.found == 1 ? kOnePicture : kPictures, reason.found, reason.needed);
        case VoidCause::kNotRealTime:
            return said(kRealTime, reason.found, reason.needed);
        case VoidCause::kTuned:
            return std::string(kTuned);
        case VoidCause::kGiven:
            return std::string(kGiven[0]) + std::to_string(reason.found) + std::string(kGiven[1]);
        case VoidCause::kDevice:
            return reason.detail.english();
        case VoidCause::kTaskUnknown:
        case VoidCause::kTaskDiffers:
        case VoidCause::kUnsound:
        case VoidCause::kSameRecording:
        case VoidCause::kReplayDiffers:
        case VoidCause::kScript:
        case VoidCause::kUnsigned:
        case VoidCause::kNoRecording:
        case VoidCause::kOrderDiffers:
        case VoidCause::kOrderMissing:
        case VoidCause::kProctor:
        case VoidCause::kExamClosed:
        case VoidCause::kClock:
        case VoidCause::kTaskVersion:
            return doubt_text(reason);
    }
    return {};
}

void append(std::string& text, const std::string& more) {
    if (more.empty()) return;
    if (!text.empty()) text += kBetween;
    text += more;
}

}  // namespace

std::string void_text(const std::vector<VoidReason>& reasons) {
    std::string text;
    for (const VoidReason& reason : reasons) append(text, text_of(reason));
    return text;
}

std::vector<VoidReason> void_reasons(std::string_view text) {
    std::vector<VoidReason> out;
    while (!text.empty()) {
        const size_t end = text.find(kBetween);
        if (const std::string_view part = text.substr(0, end); !part.empty())
            out.push_back(void_reason(part));
        if (end == std::string_view::npos) break;
        text.remove_prefix(end + kBetween.size());
    }
    return out;
}

std::string not_done_text(const NotDone& why) {
    std::string text;
    if (why.interrupted) append(text, std::string(kInterrupted));
    if (why.least_s > 0) append(text, said(kEarly, why.ended_s, why.least_s));
    append(text, why.note);
    if (!why.voids.empty()) append(text, std::string(kVoid) + void_text(why.voids));
    return text;
}

NotDone not_done(std::string_view text) {
    NotDone out;
    // Nothing stands behind the reasons why it is void.
    if (size_t at = text.starts_with(kVoid) ? 0 : text.find(std::string(kBetween) + "void: ");
        at != std::string_view::npos) {
        const size_t from = at == 0 ? kVoid.size() : at + kBetween.size() + kVoid.size();
        out.voids = void_reasons(text.substr(from));
        text = text.substr(0, at);
    }
    if (text == kInterrupted) {
        out.interrupted = true;
    } else if (const auto n = numbers_of(text, kEarly)) {
        out.ended_s = n->first;
        out.least_s = n->second;
    } else {
        out.note = text;
    }
    return out;
}

}  // namespace placode::db
