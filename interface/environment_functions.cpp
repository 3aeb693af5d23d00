// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Fields and environments of placode.h.

#include <algorithm>
#include <cstring>
#include <iterator>

#include "interface/handles.h"

using namespace placode;
using interface::guarded;
using interface::refuse;

namespace {

environment::EnvironmentOptions options_of(const placode_options* given) {
    placode_options options;
    placode_options_init(&options);
    // A program built against an older header knows fewer members.
    if (given != nullptr) {
        if (given->size < offsetof(placode_options, scene_changes))
            refuse("options: call placode_options_init first");
        std::memcpy(&options, given, std::min(given->size, sizeof options));
    }
    if (options.units != PLACODE_NORMALISED && options.units != PLACODE_ABSOLUTE)
        refuse("options.units: expected PLACODE_NORMALISED or PLACODE_ABSOLUTE");
    environment::EnvironmentOptions out;
    out.threads = options.threads;
    out.units = options.units == PLACODE_ABSOLUTE ? environment::ActionUnits::kAbsolute
                                                  : environment::ActionUnits::kNormalised;
    out.sparse = options.sparse != 0;
    out.record = options.record != 0;
    out.fields = options.fields;
    out.speed_m_s = options.speed_m_s;
    out.time_limit_s = options.time_limit_s;
    out.start_spread_m = options.start_spread_m;
    out.judge_every_s = options.judge_every_s;
    out.approach_weight = options.approach_weight;
    if (options.scene_changes != nullptr) out.scene_changes_json = options.scene_changes;
    return out;
}

void write_outcome(const environment::StepOutcome& from, placode_outcome* to) {
    placode_outcome out{};
    out.size = to->size;
    out.reward = from.reward;
    out.score = from.score_part;
    out.approach = from.approach_part;
    out.end = static_cast<int32_t>(from.end);
    out.success = from.success ? 1 : 0;
    out.frames = from.frames;
    std::memcpy(to, &out, std::min(to->size, sizeof out));
}

constexpr const char* kToolKinds[] = {"scope",    "needle", "hook",         "grasper",
                                      "scissors", "probe",  "needle_driver"};
static_assert(std::size(kToolKinds) == sim::kToolKinds);
constexpr const char* kHands[] = {"right", "left", "camera"};

const sim::ToolSpec* tool_of(const placode_environment* e, size_t tool) {
    return e != nullptr && tool < e->environment->tools()
               ? &e->environment->task().scene.tools[tool]
               : nullptr;
}

}  // namespace

extern "C" {

placode_fields* placode_fields_new(size_t most_kept) {
    try {
        auto fields = std::make_unique<placode_fields>();
        fields->cache = std::make_shared<environment::FieldCache>(most_kept);
        return fields.release();
    } catch (...) {
        return nullptr;
    }
}

void placode_fields_free(placode_fields* fields) { delete fields; }

size_t placode_fields_built(const placode_fields* fields) {
    return fields != nullptr ? fields->cache->built() : 0;
}

const char* placode_fields_error(const placode_fields* fields) {
    return fields != nullptr ? fields->error.c_str() : "no fields: a null handle";
}

const char* placode_fields_tasks(placode_fields* fields) {
    if (fields == nullptr) return "";
    (void)guarded(fields->error, [&] {
        fields->tasks.clear();
        for (const std::string& id : curriculum::list_definitions("tasks"))
            fields->tasks += (fields->tasks.empty() ? "" : "\n") + id;
    });
    return fields->tasks.c_str();
}

void placode_options_init(placode_options* options) {
    if (options == nullptr) return;
    const environment::EnvironmentOptions defaults;
    *options = {};
    options->size = sizeof *options;
    options->threads = defaults.threads;
    options->units = PLACODE_NORMALISED;
    options->fields = defaults.fields;
    options->speed_m_s = defaults.speed_m_s;
    options->judge_every_s = defaults.judge_every_s;
    options->approach_weight = defaults.approach_weight;
}

placode_environment* placode_environment_new(placode_fields* fields, const char* task,
                                             const placode_options* options) {
    if (fields == nullptr) return nullptr;
    std::unique_ptr<placode_environment> made;
    (void)guarded(fields->error, [&] {
        if (task == nullptr) refuse("no task: a null pointer");
        auto handle = std::make_unique<placode_environment>();
        handle->environment =
            std::make_unique<environment::Environment>(fields->cache, task, options_of(options));
        made = std::move(handle);
    });
    return made.release();
}

void placode_environment_free(placode_environment* environment) { delete environment; }

const char* placode_error(const placode_environment* e) {
    return e != nullptr ? e->error.c_str() : "no environment: a null handle";
}

size_t placode_tool_count(const placode_environment* e) {
    return e != nullptr ? e->environment->tools() : 0;
}

const char* placode_tool_kind(const placode_environment* e, size_t tool) {
    const sim::ToolSpec* spec = tool_of(e, tool);
    return spec != nullptr ? kToolKinds[static_cast<size_t>(spec->kind)] : nullptr;
}

const char* placode_tool_hand(const placode_environment* e, size_t tool) {
    const sim::ToolSpec* spec = tool_of(e, tool);
    return spec != nullptr ? kHands[static_cast<size_t>(spec->hand)] : nullptr;
}

const char* placode_task_id(const placode_environment* e) {
    return e != nullptr ? e->environment->task().id.c_str() : nullptr;
}

const char* placode_task_json(const placode_environment* e) {
    return e != nullptr ? e->environment->task().json.c_str() : nullptr;
}

double placode_time_limit_s(const placode_environment* e) {
    return e != nullptr ? curriculum::limit_of(e->environment->task(),
                                               e->environment->options().time_limit_s)
                        : 0;
}

placode_status placode_reset(placode_environment* e, uint64_t seed) {
    if (e == nullptr) return PLACODE_BAD_ARGUMENT;
    return guarded(e->error, [&] { e->environment->reset(seed); });
}

placode_status placode_step(placode_environment* e, const double* action, size_t count,
                            int32_t frames, int32_t finish, placode_outcome* outcome) {
    if (e == nullptr) return PLACODE_BAD_ARGUMENT;
    return guarded(e->error, [&] {
        if (action == nullptr) refuse("no action: a null pointer");
        const environment::StepOutcome out =
            e->environment->step({action, count}, frames, finish != 0);
        if (outcome != nullptr) write_outcome(out, outcome);
    });
}

placode_moment* placode_moment_new(void) {
    try {
        return std::make_unique<placode_moment>().release();
    } catch (...) {
        return nullptr;
    }
}

void placode_moment_free(placode_moment* moment) { delete moment; }

size_t placode_moment_bytes(const placode_moment* moment) {
    return moment != nullptr ? moment->moment.bytes() : 0;
}

placode_status placode_save(placode_environment* e, placode_moment* into) {
    if (e == nullptr) return PLACODE_BAD_ARGUMENT;
    return guarded(e->error, [&] {
        if (into == nullptr) refuse("no moment: a null handle");
        e->environment->save(into->moment);
    });
}

placode_status placode_restore(placode_environment* e, const placode_moment* from) {
    if (e == nullptr) return PLACODE_BAD_ARGUMENT;
    return guarded(e->error, [&] {
        if (from == nullptr) refuse("no moment: a null handle");
        e->environment->restore(from->moment);
    });
}

placode_expert* placode_expert_new(placode_environment* e, const char* level, uint64_t seed) {
    if (e == nullptr) return nullptr;
    std::unique_ptr<placode_expert> made;
    (void)guarded(e->error, [&] {
        if (level == nullptr) refuse("no level: a null pointer");
        auto handle = std::make_unique<placode_expert>();
        handle->expert = std::make_unique<environment::Expert>(*e->environment, level, seed);
        made = std::move(handle);
    });
    return made.release();
}

void placode_expert_free(placode_expert* expert) { delete expert; }

placode_status placode_expert_act(placode_environment* e, placode_expert* expert, int32_t frames,
                                  double* action, size_t count, int32_t* done) {
    if (e == nullptr) return PLACODE_BAD_ARGUMENT;
    return guarded(e->error, [&] {
        if (expert == nullptr || action == nullptr) refuse("no expert or action: a null pointer");
        const bool over = expert->expert->act(*e->environment, frames, {action, count});
        if (done != nullptr) *done = over ? 1 : 0;
    });
}
}
