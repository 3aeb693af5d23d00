// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/standard.h"

#include "curriculum/json_reader.h"

namespace placode::curriculum {
namespace {

constexpr const char* kAngoff = "angoff";

Json group_json(const StandardGroup& group) {
    return {{"n", group.n},
            {"mean_points", group.mean_points},
            {"sd_points", group.sd_points},
            {"theoretical_wrong", group.theoretical_wrong},
            {"observed_wrong", group.observed_wrong}};
}

StandardGroup read_group(const Json& json) {
    return {json["n"], json["mean_points"], json["sd_points"], json["theoretical_wrong"],
            json["observed_wrong"]};
}

}  // namespace

std::string standard_json(const PassStandard& standard) {
    Json json{{"id", standard.task_id},
              {"version", standard.version},
              {"pass_points", standard.pass_points},
              {"method", standard.method}};
    if (standard.method == kAngoff) {
        json["judges"] = {{"n", standard.angoff.judges},
                          {"items", standard.angoff.items},
                          {"se_points", standard.angoff.se_points}};
    } else {
        json["mean_of_last_attempts"] = standard.mean_of_last_attempts;
        json["groups"] = {{"novice", group_json(standard.novice)},
                          {"expert", group_json(standard.expert)}};
    }
    return json.dump(2) + "\n";
}

PassStandard load_standard_text(const std::string& text, const std::string& origin) {
    const Json json = parse_json(text, origin);
    check_schema(json, "standard", origin);
    PassStandard standard;
    standard.task_id = json["id"];
    standard.version = json["version"];
    standard.pass_points = json["pass_points"];
    standard.method = json["method"];
    standard.mean_of_last_attempts =
        json.value("mean_of_last_attempts", standard.mean_of_last_attempts);
    if (standard.method == kAngoff) {
        const Json& judges = json["judges"];
        standard.angoff = {judges["n"], judges["items"], judges["se_points"]};
    } else {
        standard.novice = read_group(json["groups"]["novice"]);
        standard.expert = read_group(json["groups"]["expert"]);
    }
    return standard;
}

}  // namespace placode::curriculum
