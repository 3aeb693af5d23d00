// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Why an attempt does not count, and why it does not do its step of a study: what is meant, which
// the store keeps as JSON, and the plain English that it keeps beside it, for exports and as all
// that older programs wrote. Both are written and read here only, so that no page has to guess;
// each language says what is meant (reports/words.h).

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "db/said.h"

namespace placode::db {

enum class VoidCause : uint8_t {
    kFewPictures,  ///< Fewer pictures a second than are needed.
    kNotRealTime,  ///< The simulation ran behind the clock.
    kTuned,        ///< Tissue or generator were tuned: it is not the task any more.
    kGiven,        ///< It began at a stage, what came before was given; `found` is the stage.
    kDevice,       ///< The force device; `detail` has the figures for technicians.
    // What was recorded proves nothing: practice, not verified.
    kTaskUnknown,  ///< No task of that id and version was published; `detail` names it.
    kTaskDiffers,  ///< The recording carries another text than the published one, or an older
                   ///< version than was published when it began; `detail` names the published one.
    kUnsound,      ///< What scoring needs is missing or out of range; `detail` says what.
    kSameRecording,  ///< Another attempt holds this recording; `detail` has its number.
    kReplayDiffers,  ///< Simulated again it gave something else; `detail` says where.
    kScript,         ///< A script performed what counts for a person; `detail` names it.
    kUnsigned,       ///< No computer of the centre signed the recording; `detail` says which.
    kNoRecording,    ///< An exam or an attempt of a study of which nothing was recorded.
    kOrderDiffers,   ///< Begun for another person, exam, proctor or step than is said now.
    kOrderMissing,   ///< An exam or an attempt of a study that nothing binds to what it was for.
    kProctor,        ///< Who is named as proctor may not be it: no staff here, or the examinee.
    kExamClosed,     ///< No exam could be taken then, or not this one; `detail` says why.
    kClock,          ///< It says a time that cannot be right; `detail` is that time.
    kTaskVersion     ///< The exam asked for another version of the task; `detail` names its own.
};

inline constexpr const char* kNobody = "nobody";  ///< Of kUnsigned.

/// True for what makes an attempt "practice, not verified": neither the machine nor the person's
/// skill is the reason, what was recorded is.
[[nodiscard]] constexpr bool is_doubt(VoidCause cause) noexcept {
    return cause >= VoidCause::kTaskUnknown;
}

struct VoidReason {
    VoidCause cause = VoidCause::kDevice;
    int found = 0, needed = 0;  ///< Pictures a second, or percent of real time; of kGiven a stage.
    Said detail;                ///< Of kDevice and of doubts.

    [[nodiscard]] bool operator==(const VoidReason&) const = default;
};

/// As the store keeps them, "a; b"; empty for none.
[[nodiscard]] std::string void_text(const std::vector<VoidReason>& reasons);
/// What such a text means, of earlier versions as well; what is not known is the device's.
[[nodiscard]] std::vector<VoidReason> void_reasons(std::string_view text);
/// What they mean, as the store keeps it beside the text: a JSON array with a cause for each, and
/// what is found, needed or named. Empty for none.
[[nodiscard]] std::string void_meaning(const std::vector<VoidReason>& reasons);
/// What an attempt's text and meaning mean together: the meaning where it says just this text;
/// otherwise, as of an older program, what the text means.
[[nodiscard]] std::vector<VoidReason> void_reasons(std::string_view text,
                                                   const std::string& meaning);

/// Why an attempt does not do the step it was made for.
struct NotDone {
    bool interrupted = false;
    int ended_s = 0, least_s = 0;  ///< Ended before the protocol's least duration; 0 and 0 = not.
    std::vector<VoidReason> voids;
    std::string note;  ///< A coordinator's own words, as they are.

    [[nodiscard]] bool operator==(const NotDone&) const = default;
};
/// As the store keeps it; empty = it does the step. What the person did stands first: told only
/// that the computer was slow, who ended too early would do the same again.
[[nodiscard]] std::string not_done_text(const NotDone& why);
[[nodiscard]] NotDone not_done(std::string_view text);
/// As void_meaning() and void_reasons() for the reasons of an attempt.
[[nodiscard]] std::string not_done_meaning(const NotDone& why);
[[nodiscard]] NotDone not_done(std::string_view text, const std::string& meaning);

}  // namespace placode::db
