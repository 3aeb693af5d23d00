// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What stands behind the opaque handles of placode.h, and the border that no exception crosses.
// Private to interface.

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "environment/batch.h"
#include "environment/environment.h"
#include "environment/expert.h"
#include "interface/placode.h"
#include "sim/step/snapshot.h"

struct placode_fields {
    std::shared_ptr<placode::environment::FieldCache> cache;
    std::string error, tasks;
};

struct placode_environment {
    std::unique_ptr<placode::environment::Environment> environment;
    std::string error, text;
};

struct placode_moment {
    placode::environment::SavedMoment moment;
};

struct placode_expert {
    std::unique_ptr<placode::environment::Expert> expert;
};

struct placode_batch {
    std::unique_ptr<placode::environment::Batch> batch;
    size_t observation = 0, action = 0;
    std::string error;
};

namespace placode::interface {

/// Status of the exception that is being handled; its words go into `error`.
[[nodiscard]] placode_status status_of_current(std::string& error) noexcept;

/// Runs `work` for a handle whose last error is `error`. What it throws becomes a status.
template <class Work>
placode_status guarded(std::string& error, Work&& work) noexcept {
    error.clear();
    try {
        std::forward<Work>(work)();
        return PLACODE_OK;
    } catch (...) {
        return status_of_current(error);
    }
}

/// For what is wrong with a call. @throws EnvironmentError
[[noreturn]] void refuse(const std::string& what);

}  // namespace placode::interface
