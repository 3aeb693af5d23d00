// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The haptic certificate of an attempt: what the loop that carried the hand really did. It is
// stored with the recording, so that a score can be believed, or an examination be declared void
// because of the machine and not of the candidate.

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/said.h"

namespace placode::haptics {

struct HapticCertificate {
    int format = 1;
    std::string device;      ///< Vendor, model and serial of every hand.
    bool force = false;      ///< The device gives forces.
    bool lock_step = false;  ///< Scripts and replays: the simulation was the clock.
    bool real_time = false;  ///< SCHED_FIFO was granted (or the vendor's scheduler ran).
    bool memory_locked = false;
    double duration_s = 0;  ///< Of the loop, wall clock.
    uint64_t ticks = 0;     ///< Of the loop.
    uint64_t missed = 0;    ///< Periods that were skipped because a tick came late.
    uint64_t late = 0;      ///< Ticks more than 1.1 ms after the one before.
    uint64_t gaps = 0;      ///< Ticks more than 5 ms after the one before: drop-outs.
    double period_p50_us = 0, period_p99_us = 0, period_p999_us = 0, period_max_us = 0;
    double tool_age_p50_us = 0, tool_age_p99_us = 0, tool_age_max_us = 0;  ///< Of the tool state.
    uint64_t tool_states = 0;   ///< Distinct tool states seen; all hands together, like all below.
    uint64_t saturated = 0;     ///< Ticks at the ceiling of the force.
    uint64_t slewed = 0;        ///< Ticks at the limit of its rise.
    uint64_t hot = 0;           ///< Ticks with a ceiling lowered by heat.
    uint64_t stale = 0;         ///< Ticks with a tool state older than 10 ms.
    uint64_t silent = 0;        ///< Ticks without force on purpose.
    uint64_t passivity = 0;     ///< Ticks in which the passivity controller took energy back.
    uint64_t faults = 0;        ///< Doubts: lost, not calibrated, jumps, numbers that are none.
    double least_energy_j = 0;  ///< Lowest energy that the passivity observer saw.
    double peak_force_n = 0, rms_force_n = 0;
    uint64_t compared = 0;   ///< Ticks at rest in which the force of the coupling was held against
    uint64_t differing = 0;  ///< the solver's mean over its substeps; more than 5 % apart.
    std::string last_error;  ///< What the device or its library reported last.
};

/// What makes a certificate bad. Chosen so that a bench computer with real-time rights passes and
/// a hand would have felt what does not (reference measurements: 99.9 % of the cycles within 1.1
/// ms and none above 5 ms on bare metal; a tenth of that quality is still not felt).
struct CertificateLimits {
    double late_share = 0.01;  ///< Of the ticks, with those that were missed.
    double gaps_per_minute = 1;
    double stale_share = 0.01;
    double saturated_share = 0.05;
    double hot_share = 0.05;
    double least_energy_j = -0.005;
    uint64_t faults = 0;
    double shortest_s = 1;  ///< A loop that never ran certifies nothing.
};

enum class CertificateGrade : uint8_t {
    kNotApplicable,  ///< No force was rendered: nothing to certify.
    kSound,
    kBad,  ///< An examination with it is void for cause.
};

struct CertificateVerdict {
    CertificateGrade grade = CertificateGrade::kNotApplicable;
    std::vector<sim::Said> reasons;  ///< Each with number and limit.
};

[[nodiscard]] CertificateVerdict judge(const HapticCertificate& certificate,
                                       const CertificateLimits& limits = {});
/// "not_applicable", "sound", "bad".
[[nodiscard]] std::string_view grade_name(CertificateGrade grade) noexcept;

/// One line of JSON, with the grade and its reasons under "grade" and "reasons".
[[nodiscard]] std::string certificate_to_json(const HapticCertificate& certificate);
/// Unknown keys are left out; throws CertificateError for what is no certificate.
[[nodiscard]] HapticCertificate certificate_from_json(std::string_view json);

class CertificateError : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

}  // namespace placode::haptics
