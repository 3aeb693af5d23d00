// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/norm_pack.h"

#include "curriculum/json_reader.h"

namespace placode::curriculum {
namespace {

Json band_json(const NormMetric& metric) {
    const assessment::Benchmark& b = metric.band;
    return {{"id", metric.id}, {"n", b.n},     {"log", b.log}, {"mean", b.mean},
            {"sd", b.sd},      {"q25", b.q25}, {"q50", b.q50}, {"q75", b.q75}};
}

NormMetric read_metric(const Json& json) {
    NormMetric metric;
    metric.id = json["id"];
    metric.band.n = json["n"];
    metric.band.log = json["log"];
    metric.band.mean = json["mean"];
    metric.band.sd = json["sd"];
    metric.band.q25 = json["q25"];
    metric.band.q50 = json["q50"];
    metric.band.q75 = json["q75"];
    return metric;
}

}  // namespace

const NormMetric* NormGroup::metric(std::string_view id) const {
    for (const NormMetric& candidate : metrics)
        if (candidate.id == id) return &candidate;
    return nullptr;
}

const NormGroup* NormPack::group(std::string_view level) const {
    for (const NormGroup& candidate : groups)
        if (candidate.level == level) return &candidate;
    return nullptr;
}

std::string norm_pack_text(const NormPack& pack) {
    Json json{{"format", "placode norms"},
              {"format_version", 1},
              {"centre", pack.centre},
              {"made_utc", pack.made_utc},
              {"task_id", pack.task_id},
              {"task_version", pack.task_version},
              {"rubric_id", pack.rubric_id},
              {"rubric_version", pack.rubric_version},
              {"metric_set_version", pack.metric_set_version},
              {"preprocessing_version", pack.preprocessing_version},
              {"demonstration", pack.demonstration},
              {"groups", Json::array()}};
    for (const NormGroup& group : pack.groups) {
        Json entry{{"level", group.level},
                   {"persons", group.persons},
                   {"attempts", group.attempts},
                   {"metrics", Json::array()}};
        for (const NormMetric& metric : group.metrics)
            entry["metrics"].push_back(band_json(metric));
        json["groups"].push_back(std::move(entry));
    }
    return json.dump(1) + "\n";
}

NormPack load_norm_pack(const std::string& text, const std::string& origin) {
    const Json json = parse_json(text, origin);
    check_schema(json, "norms", origin);
    NormPack pack;
    pack.centre = json["centre"];
    pack.made_utc = json["made_utc"];
    pack.task_id = json["task_id"];
    pack.task_version = json["task_version"];
    pack.rubric_id = json["rubric_id"];
    pack.rubric_version = json["rubric_version"];
    pack.metric_set_version = json["metric_set_version"];
    pack.preprocessing_version = json["preprocessing_version"];
    pack.demonstration = json["demonstration"];
    for (size_t i = 0; i < json["groups"].size(); ++i) {
        const Json& entry = json["groups"][i];
        NormGroup group;
        group.level = entry["level"];
        group.persons = entry["persons"];
        group.attempts = entry["attempts"];
        if (group.persons < kLeastNormGroup)
            throw DefinitionError(origin, "/groups/" + std::to_string(i) + "/persons",
                                  "found " + std::to_string(group.persons) +
                                      "; expected at least " + std::to_string(kLeastNormGroup) +
                                      ": bands of fewer people tell about persons");
        for (const Json& metric : entry["metrics"]) group.metrics.push_back(read_metric(metric));
        pack.groups.push_back(std::move(group));
    }
    return pack;
}

std::string signed_norms_text(const SignedNorms& norms) {
    const Json json{{"format", "placode signed norms"},
                    {"format_version", 1},
                    {"content", norms.content},
                    {"signature", norms.signature},
                    {"public_key", norms.public_key}};
    return json.dump(1) + "\n";
}

SignedNorms load_signed_norms(const std::string& text, const std::string& origin) {
    const Json json = parse_json(text, origin);
    check_schema(json, "signed_norms", origin);
    return {json["content"], json["signature"], json["public_key"]};
}

std::string read_norm_file(const std::string& path) { return read_definition(path); }

}  // namespace placode::curriculum
