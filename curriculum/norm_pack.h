// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Norms: how groups of people do a task, as bands that centres may exchange. Aggregates only: no
// person, no single attempt, no group below a least size.

#include <string>
#include <vector>

#include "assessment/benchmark.h"
#include "curriculum/definitions.h"

namespace placode::curriculum {

inline constexpr int kLeastNormGroup = 5;  ///< Persons; a smaller group is never exported.

/// One metric of one group; id "points" is the score.
struct NormMetric {
    std::string id;
    assessment::Benchmark band;  ///< `left_out` stays at home.
};

struct NormGroup {
    std::string level;  ///< "expert", "novice", ...
    int persons = 0, attempts = 0;
    std::vector<NormMetric> metrics;
    [[nodiscard]] const NormMetric* metric(std::string_view id) const;
};

struct NormPack {
    std::string centre, made_utc;
    std::string task_id, rubric_id;
    int task_version = 0, rubric_version = 0;
    int metric_set_version = 0, preprocessing_version = 0;
    bool demonstration = false;  ///< Some of it is of simulated operators.
    std::vector<NormGroup> groups;
    [[nodiscard]] const NormGroup* group(std::string_view level) const;
};

/// The text that is signed. load_norm_pack() of it gives the same pack.
[[nodiscard]] std::string norm_pack_text(const NormPack& pack);
/// Throws DefinitionError, also for a group below kLeastNormGroup.
[[nodiscard]] NormPack load_norm_pack(const std::string& text, const std::string& origin);

/// A pack with its signature (Ed25519), as it is exchanged.
struct SignedNorms {
    std::string content;                ///< norm_pack_text(), byte for byte.
    std::string signature, public_key;  ///< Hexadecimal.
};
[[nodiscard]] std::string signed_norms_text(const SignedNorms& norms);
/// Throws DefinitionError. Whether the signature is right is not looked at here.
[[nodiscard]] SignedNorms load_signed_norms(const std::string& text, const std::string& origin);

/// Text of a file. Throws DefinitionError when it cannot be read.
[[nodiscard]] std::string read_norm_file(const std::string& path);

}  // namespace placode::curriculum
