// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Small verification scenes as JSON, run or refused.

#include <string>

#include "curriculum/verification_json.h"

namespace placode::test {

/// A cube of 2 mm on rollers; `more` replaces or adds keys.
inline std::string cube(const std::string& more) {
    return R"({"mesh": {"box": {"size_m": [0.002, 0.002, 0.002], "cells": [2, 2, 2]}})" +
           (more.empty() ? "" : ", " + more) + "}";
}

inline sim::SolveResult run(const std::string& text) {
    const sim::VerificationScene scene =
        curriculum::verification_scene_from_json(text, "scene.json", ".");
    return curriculum::solve_verification_scene(scene, "scene.json");
}

inline std::string refusal(const std::string& text) {
    try {
        (void)run(text);
    } catch (const curriculum::DefinitionError& error) {
        return error.what();
    }
    return "accepted";
}

inline const std::string kRollers =
    R"("fixed": [{"box_m": [[0,0,0],[0,1,1]], "axes": "x"}, {"box_m": [[0,0,0],[1,0,1]], "axes": "y"},
                 {"box_m": [[0,0,0],[1,1,0]], "axes": "z"}])";

inline std::string solver(const std::string& method, int substeps, const std::string& more = "") {
    return R"("solver": {"method": ")" + method + R"(", "threads": 1, "substeps": )" +
           std::to_string(substeps) + more + "}";
}

/// 40 x 10 x 10 mm, held at one end, begins to fall under 1 m/s^2.
inline std::string beam(double end_s, const std::string& solver_text) {
    return R"({"mesh": {"box": {"size_m": [0.04, 0.01, 0.01], "cells": [8, 2, 2]}},
               "gravity_m_s2": [0, 0, -1], "fixed": [{"box_m": [[0,0,0],[0,1,1]]}],
               "probes": [{"name": "tip", "box_m": [[0.04,0,0],[1,1,1]]}],
               "until": {"time_s": )" +
           std::to_string(end_s) + "}, " + solver_text + "}";
}

}  // namespace placode::test
