// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Under which rules an attempt is made: one table says which keys, panels, aids, devices and
// endings exist in practice, in an exam and in a study. Simulator, shell and store ask it.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace placode::curriculum {

enum class AttemptMode : uint8_t { kPractice, kExam, kStudy };

/// "practice", "exam" or "study": as recordings keep it.
[[nodiscard]] const char* mode_name(AttemptMode mode) noexcept;
[[nodiscard]] std::optional<AttemptMode> mode_named(std::string_view name) noexcept;

/// Help that a picture can give beyond what a fetoscope shows. A study's protocol names its own.
struct Aids {
    bool planned_line = false;  ///< F5 shows the planned line.
    bool read_outs = false;     ///< Phase, energy, force and ring beside the time.
    bool warnings = false;      ///< Short phrases at the rim ("Too close to the placode").
    bool depth = false;         ///< Shadow of the tip and the gauge beside it.

    friend bool operator==(const Aids&, const Aids&) = default;
};

/// Names as in a study's protocol: "planned_line", "read_outs", "warnings", "depth".
inline constexpr std::string_view kAidNames[] = {"planned_line", "read_outs", "warnings", "depth"};
/// From names separated by commas; nullopt when one is unknown. Empty text = no aids.
[[nodiscard]] std::optional<Aids> aids_named(std::string_view names) noexcept;
/// The other way round, in the order of kAidNames.
[[nodiscard]] std::string aid_names(const Aids& aids);

/// What exists in a mode.
struct Conduct {
    Aids aids;
    bool tuning = false;       ///< F2: the clinician's panel.
    bool performance = false;  ///< F3: rates and frame times.
    bool screenshots = false;  ///< F12.
    bool help = false;         ///< F1: the controls; simulated time stands still behind it.
    bool own_device = false;   ///< The person chooses the device; otherwise the protocol.
    bool leave = false;        ///< The menu offers to leave without finishing.
    bool always_ask = false;   ///< Ending asks, however long the attempt has lasted.
    bool own_score = false;    ///< The person sees score and recording afterwards.
    bool own_account = false;  ///< The attempt belongs to who is signed in; otherwise to a code.
    bool repeats = false;      ///< The person may do it again without anybody's leave.
};

[[nodiscard]] const Conduct& conduct_of(AttemptMode mode) noexcept;

/// An attempt that ends earlier than this share of its usual time is asked about in every mode.
inline constexpr double kEarlyShare = 0.25;

}  // namespace placode::curriculum
