// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/hard_cases.h"

#include <stdexcept>

#include "bench/hard_case.h"

namespace placode::bench {

std::vector<std::string> hard_case_names() {
    std::vector<std::string> names;
    for (const auto cases : {suture_cases(), patch_cases()})
        for (const HardCase& each : cases) names.emplace_back(each.name);
    return names;
}

sim::StabilityResult run_hard_case(const std::string& name, const sim::StabilityOptions& options) {
    for (const auto cases : {suture_cases(), patch_cases()})
        for (const HardCase& each : cases) {
            if (name != each.name) continue;
            sim::StabilityResult result;
            result.name = name;
            result.method = "vbd";  // what instruments, needle and patch are solved with
            each.run(result, options);
            return result;
        }
    throw std::invalid_argument("no stability case named " + name);
}

}  // namespace placode::bench
