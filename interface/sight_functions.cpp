// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What there is to see of an environment: observation, line, surface, events, score.

#include <algorithm>
#include <nlohmann/json.hpp>

#include "interface/handles.h"
#include "sim/world/saved_state.h"

using namespace placode;
using interface::guarded;
using interface::refuse;

namespace {

placode_event event_of(const sim::Event& from) {
    placode_event event{};
    event.time_s = from.time_s;
    event.kind = static_cast<int32_t>(from.kind);
    event.tool = from.tool;
    event.value = from.value;
    event.value2 = from.value2;
    std::copy(from.rest_position_m.begin(), from.rest_position_m.end(), event.rest_position_m);
    return event;
}

std::string score_json(const environment::Judgement& judged) {
    nlohmann::ordered_json json;
    json["at_s"] = judged.at_s;
    json["points"] = judged.score.points;
    json["verdict"] = assessment::verdict_name(judged.score.verdict);
    json["metrics"] = nlohmann::ordered_json::object();
    for (const assessment::Metric& metric : judged.metrics.values)
        json["metrics"][metric.id] = metric.value;
    json["reasons"] = nlohmann::ordered_json::array();
    for (const assessment::Reason& reason : judged.score.reasons)
        json["reasons"].push_back({{"item", reason.item},
                                   {"text", reason.text},
                                   {"points", reason.points},
                                   {"critical", reason.critical}});
    return json.dump();
}

}  // namespace

extern "C" {

size_t placode_observation_size(const placode_environment* e) {
    return e != nullptr ? e->environment->observation_names().size() : 0;
}

const char* placode_observation_name(const placode_environment* e, size_t i) {
    if (i >= placode_observation_size(e)) return nullptr;
    return e->environment->observation_names()[i].c_str();
}

placode_status placode_observe(placode_environment* e, double* out, size_t count) {
    if (e == nullptr) return PLACODE_BAD_ARGUMENT;
    return guarded(e->error, [&] {
        if (out == nullptr) refuse("nowhere to write an observation: a null pointer");
        e->environment->observe({out, count});
    });
}

placode_status placode_contour(placode_environment* e, double* xyz_m, uint8_t* cut, size_t room,
                               size_t* points) {
    if (e == nullptr) return PLACODE_BAD_ARGUMENT;
    return guarded(e->error, [&] {
        const haptics::Perception seen = e->environment->look();
        const size_t count = seen.contour.size();
        if (points != nullptr) *points = count;
        if (count > room) return;
        for (size_t i = 0; i < count; ++i) {
            for (int k = 0; xyz_m != nullptr && k < 3; ++k)
                xyz_m[3 * i + static_cast<size_t>(k)] = seen.contour[i][k];
            if (cut != nullptr) cut[i] = seen.contour_cut[i];
        }
    });
}

placode_status placode_surface(placode_environment* e, float* xyz_m, float* damage,
                               size_t vertex_room, int32_t* triangles, size_t triangle_room,
                               size_t* vertices, size_t* triangle_count) {
    if (e == nullptr) return PLACODE_BAD_ARGUMENT;
    return guarded(e->error, [&] {
        sim::Snapshot snapshot;
        sim::fill_snapshot(*e->environment->field().scene, e->environment->state(), snapshot);
        if (vertices != nullptr) *vertices = snapshot.x.size();
        if (triangle_count != nullptr) *triangle_count = snapshot.triangles.size();
        if (snapshot.x.size() <= vertex_room) {
            for (size_t v = 0; v < snapshot.x.size(); ++v) {
                if (xyz_m != nullptr)
                    std::copy(snapshot.x[v].begin(), snapshot.x[v].end(), xyz_m + 3 * v);
                if (damage != nullptr)
                    std::copy(snapshot.damage[v].begin(), snapshot.damage[v].end(), damage + 4 * v);
            }
        }
        if (triangles != nullptr && snapshot.triangles.size() <= triangle_room) {
            for (size_t t = 0; t < snapshot.triangles.size(); ++t)
                for (size_t k = 0; k < 3; ++k)
                    triangles[3 * t + k] = snapshot.triangles[t].vertex[k];
        }
    });
}

placode_status placode_events(placode_environment* e, size_t first, placode_event* out, size_t room,
                              size_t* count) {
    if (e == nullptr) return PLACODE_BAD_ARGUMENT;
    return guarded(e->error, [&] {
        const std::span<const sim::Event> events = e->environment->events();
        if (count != nullptr) *count = events.size();
        for (size_t i = first; out != nullptr && i < events.size() && i - first < room; ++i)
            out[i - first] = event_of(events[i]);
    });
}

const char* placode_event_name(int32_t kind) {
    return sim::event_name(static_cast<sim::EventKind>(kind)).data();
}

placode_status placode_score(placode_environment* e, double* points, int32_t* passed) {
    if (e == nullptr) return PLACODE_BAD_ARGUMENT;
    return guarded(e->error, [&] {
        const assessment::Score& score = e->environment->judged().score;
        if (points != nullptr) *points = score.points;
        if (passed != nullptr) *passed = score.verdict == assessment::Verdict::kPassed ? 1 : 0;
    });
}

placode_status placode_score_json(placode_environment* e, const char** json) {
    if (e == nullptr) return PLACODE_BAD_ARGUMENT;
    return guarded(e->error, [&] {
        if (json == nullptr) refuse("nowhere to write the score: a null pointer");
        e->text = score_json(e->environment->judge_in_full());
        *json = e->text.c_str();
    });
}

placode_status placode_state_hash(placode_environment* e, uint64_t* hash) {
    if (e == nullptr) return PLACODE_BAD_ARGUMENT;
    return guarded(e->error, [&] {
        if (hash == nullptr) refuse("nowhere to write the hash: a null pointer");
        *hash = sim::whole_hash(e->environment->state());
    });
}
}
