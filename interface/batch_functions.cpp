// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Batches of placode.h.

#include "interface/handles.h"

using namespace placode;
using interface::guarded;
using interface::refuse;

extern "C" {

placode_batch* placode_batch_new(placode_environment* const* environments, size_t count,
                                 placode_autoreset autoreset, int32_t threads) {
    if (environments == nullptr || count == 0 || environments[0] == nullptr) return nullptr;
    std::unique_ptr<placode_batch> made;
    (void)guarded(environments[0]->error, [&] {
        std::vector<environment::Environment*> list;
        for (size_t i = 0; i < count; ++i) {
            if (environments[i] == nullptr) refuse("a batch with an environment that is null");
            list.push_back(environments[i]->environment.get());
        }
        auto handle = std::make_unique<placode_batch>();
        handle->observation = list[0]->observation_names().size();
        handle->action = list[0]->tools() * environment::kActionSize;
        const auto mode = autoreset == PLACODE_SAME_STEP   ? environment::Autoreset::kSameStep
                          : autoreset == PLACODE_NEXT_STEP ? environment::Autoreset::kNextStep
                                                           : environment::Autoreset::kDisabled;
        handle->batch = std::make_unique<environment::Batch>(std::move(list), mode, threads);
        made = std::move(handle);
    });
    return made.release();
}

void placode_batch_free(placode_batch* batch) { delete batch; }

const char* placode_batch_error(const placode_batch* b) {
    return b != nullptr ? b->error.c_str() : "no batch: a null handle";
}

placode_status placode_batch_reset(placode_batch* b, const uint64_t* seeds, double* observations) {
    if (b == nullptr) return PLACODE_BAD_ARGUMENT;
    return guarded(b->error, [&] {
        if (seeds == nullptr || observations == nullptr) refuse("reset of a batch: a null pointer");
        const size_t n = b->batch->size();
        b->batch->reset({seeds, n}, {observations, n * b->observation});
    });
}

placode_status placode_batch_step(placode_batch* b, const double* actions, int32_t frames,
                                  double* observations, double* final_observations, double* rewards,
                                  uint8_t* terminated, uint8_t* truncated, uint8_t* success) {
    if (b == nullptr) return PLACODE_BAD_ARGUMENT;
    return guarded(b->error, [&] {
        if (actions == nullptr || observations == nullptr || rewards == nullptr ||
            terminated == nullptr || truncated == nullptr || success == nullptr)
            refuse("step of a batch: a null pointer");
        const size_t n = b->batch->size(), all = n * b->observation;
        environment::BatchOutput out;
        out.observations = {observations, all};
        if (final_observations != nullptr) out.final_observations = {final_observations, all};
        out.rewards = {rewards, n};
        out.terminated = {terminated, n};
        out.truncated = {truncated, n};
        out.success = {success, n};
        b->batch->step({actions, n * b->action}, frames, out);
    });
}

placode_status placode_batch_finish(placode_batch* b, const uint8_t* which) {
    if (b == nullptr) return PLACODE_BAD_ARGUMENT;
    return guarded(b->error, [&] {
        if (which == nullptr) refuse("finish of a batch: a null pointer");
        b->batch->finish({which, b->batch->size()});
    });
}

placode_status placode_batch_last(placode_batch* b, double* score_parts, double* approach_parts,
                                  double* points) {
    if (b == nullptr) return PLACODE_BAD_ARGUMENT;
    return guarded(b->error, [&] {
        const auto last = b->batch->last();
        for (size_t i = 0; i < last.size(); ++i) {
            if (score_parts != nullptr) score_parts[i] = last[i].outcome.score_part;
            if (approach_parts != nullptr) approach_parts[i] = last[i].outcome.approach_part;
            if (points != nullptr) points[i] = last[i].points;
        }
    });
}
}
