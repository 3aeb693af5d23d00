// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Why an attempt does not count, and why it does not do its step of a study: what is meant, and the
// plain text that the store keeps of it. Text is written and read here only, so that no page has to
// guess; each language says what is meant (reports/words.h).

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace placode::db {

enum class VoidCause : uint8_t {
    kFewPictures,  ///< Fewer pictures a second than are needed.
    kNotRealTime,  ///< The simulation ran behind the clock.
    kTuned,        ///< Tissue or generator were tuned: it is not the task any more.
    kDevice,       ///< The force device; `text` has the figures for technicians.
    // What was recorded proves nothing: practice, not verified.
    kTaskUnknown,    ///< No task of that id and version was published; `text` names it.
    kTaskDiffers,    ///< The recording carries another text than the published one.
    kUnsound,        ///< What scoring needs is missing or out of range; `text` says what.
    kSameRecording,  ///< Another attempt holds this recording; `text` has its number.
    kReplayDiffers,  ///< Simulated again it gave something else; `text` says where.
    kScript,         ///< An exam of a person that a script performed; `text` names it.
    kUnsigned,       ///< No computer of the centre signed the recording; `text` says which, or "".
    kNoRecording,    ///< An exam or an attempt of a study of which nothing was recorded.
    kOrderDiffers,   ///< Begun for another person, exam, proctor or step than is said now.
    kOrderMissing,   ///< An exam or an attempt of a study that nothing binds to what it was for.
    kProctor         ///< Who is named as proctor may not be it: no staff here, or the examinee.
};

inline constexpr const char* kNobody = "nobody";  ///< Of kUnsigned.

/// True for what makes an attempt "practice, not verified": neither the machine nor the person's
/// skill is the reason, what was recorded is.
[[nodiscard]] constexpr bool is_doubt(VoidCause cause) noexcept {
    return cause >= VoidCause::kTaskUnknown;
}

struct VoidReason {
    VoidCause cause = VoidCause::kDevice;
    int found = 0, needed = 0;  ///< Pictures a second, or percent of real time.
    std::string text;           ///< Of kDevice and of doubts; without "; ".

    [[nodiscard]] bool operator==(const VoidReason&) const = default;
};

/// As the store keeps them, "a; b"; empty for none.
[[nodiscard]] std::string void_text(const std::vector<VoidReason>& reasons);
/// What such a text means, of earlier versions as well; what is not known is the device's.
[[nodiscard]] std::vector<VoidReason> void_reasons(std::string_view text);

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

}  // namespace placode::db
