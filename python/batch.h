// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Several environments that step at once, for Python.

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "python/environment.h"

namespace placode::python {

class Batch {
 public:
    Batch(std::vector<Environment*> environments, int autoreset, int threads)
        : environments_(std::move(environments)) {
        std::vector<placode_environment*> handles;
        for (const Environment* environment : environments_) handles.push_back(environment->get());
        if (handles.empty()) raise(PLACODE_BAD_ARGUMENT, "a batch has at least one environment");
        handle_.reset(placode_batch_new(handles.data(), handles.size(),
                                        static_cast<placode_autoreset>(autoreset), threads),
                      placode_batch_free);
        if (!handle_) raise(PLACODE_BAD_ARGUMENT, placode_error(handles[0]));
        observation_ = placode_observation_size(handles[0]);
        action_ = placode_tool_count(handles[0]) * PLACODE_ACTION_SIZE;
    }
    void reset(const std::vector<uint64_t>& seeds, py::array observations) {
        const Use use(environments_);
        double* out = room<double>(observations, seeds.size() * observation_, "observations");
        if (seeds.size() != environments_.size())
            raise(PLACODE_BAD_ARGUMENT, "expected one seed for each environment");
        placode_status status = PLACODE_OK;
        {
            const py::gil_scoped_release free;
            status = placode_batch_reset(handle_.get(), seeds.data(), out);
        }
        check(status);
    }
    void step(const Numbers& actions, int frames, py::array observations,
              const py::object& final_observations, py::array rewards, py::array terminated,
              py::array truncated, py::array success) {
        const Use use(environments_);
        const size_t n = environments_.size();
        if (static_cast<size_t>(actions.size()) != n * action_)
            raise(PLACODE_BAD_ARGUMENT, "actions: expected " + std::to_string(n * action_) +
                                            " numbers, found " + std::to_string(actions.size()));
        double* last = nullptr;
        if (!final_observations.is_none()) {
            py::array array = final_observations.cast<py::array>();
            last = room<double>(array, n * observation_, "final observations");
        }
        double* seen = room<double>(observations, n * observation_, "observations");
        double* reward = room<double>(rewards, n, "rewards");
        uint8_t* flags[] = {room<uint8_t>(terminated, n, "terminated"),
                            room<uint8_t>(truncated, n, "truncated"),
                            room<uint8_t>(success, n, "success")};
        const double* numbers = actions.data();
        placode_status status = PLACODE_OK;
        {
            const py::gil_scoped_release free;
            status = placode_batch_step(handle_.get(), numbers, frames, seen, last, reward,
                                        flags[0], flags[1], flags[2]);
        }
        check(status);
    }
    void finish(py::array which) {
        const Use use(environments_);
        check(placode_batch_finish(handle_.get(),
                                   room<uint8_t>(which, environments_.size(), "which")));
    }
    void last(py::array score_parts, py::array approach_parts, py::array points) {
        const Use use(environments_);
        const size_t n = environments_.size();
        check(placode_batch_last(handle_.get(), room<double>(score_parts, n, "score parts"),
                                 room<double>(approach_parts, n, "approach parts"),
                                 room<double>(points, n, "points")));
    }

 private:
    void check(placode_status status) const {
        if (status != PLACODE_OK) raise(status, placode_batch_error(handle_.get()));
    }

    std::vector<Environment*> environments_;
    std::shared_ptr<placode_batch> handle_;
    size_t observation_ = 0, action_ = 0;
};

}  // namespace placode::python
