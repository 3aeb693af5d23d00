// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cli/recording_output.h"

#include <array>

#include "db/recording_file.h"
#include "db/store.h"

namespace placode::cli {

sim::Recording load_recording(const std::string& file, bool recover, std::string& damage) {
    try {
        auto recovered = db::recover_recording_file(file);
        damage = recovered.damage;
        if (!damage.empty() && !recover)
            throw InputError("read the recording " + file + ": " + damage +
                             "; --recover uses what is whole");
        return std::move(recovered.recording);
    } catch (const db::StoreError& error) {
        throw InputError(error.what());
    }
}

Json recording_head(const sim::Recording& recording, const std::string& damage) {
    constexpr std::array<const char*, 5> kEnds{"running", "finished", "time limit", "closed",
                                               "interrupted"};
    Json json{{"task", recording.header.task_id},
              {"task_version", recording.header.task_version},
              {"device", recording.header.device},
              {"seed", recording.header.seed},
              {"build", recording.header.build},
              {"demonstration", recording.header.demonstration},
              {"duration_s", recording.end.duration_s},
              {"end", kEnds[static_cast<size_t>(recording.end.reason) % kEnds.size()]},
              {"dropped", recording.end.dropped}};
    if (recording.header.stage > 0)
        json["given"] = {{"stage", recording.header.stage},
                         {"seconds", static_cast<double>(recording.header.given_frames) *
                                         recording.header.frame_s}};
    if (!damage.empty()) json["damage"] = damage;
    return json;
}

Json metrics_json(const assessment::MetricSet& metrics) {
    Json values = Json::object();
    for (const auto& metric : metrics.values) values[metric.id] = metric.value;
    return values;
}

std::string metric_table(const assessment::MetricSet& metrics) {
    std::vector<std::vector<std::string>> rows{{"metric", "value", "unit"}};
    for (const auto& metric : metrics.values) {
        const auto* known = assessment::metric_definition(metric.id);
        rows.push_back(
            {metric.id, fixed(metric.value, 3), known == nullptr ? "" : std::string(known->unit)});
    }
    return table(rows);
}

}  // namespace placode::cli
