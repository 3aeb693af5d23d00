// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A moment of an attempt: what is kept of it, and how an environment goes back to it.
#include "environment/environment.h"
#include "sim/world/saved_state.h"

namespace placode::environment {

size_t SavedMoment::bytes() const {
    const sim::Recording& r = episode.book.recording();
    return state.size() + r.inputs.size() * sizeof(sim::Input) +
           r.samples.size() * sizeof(sim::Sample) + r.events.size() * sizeof(sim::Event);
}

void Environment::save(SavedMoment& into) const {
    need_begun();
    into.field = field_;
    sim::save_state(*field_->scene, *state_, into.state);
    into.episode = episode_;
}

void Environment::restore(const SavedMoment& saved) {
    if (!saved.field)
        throw EnvironmentError(EnvironmentError::Kind::kBadArgument,
                               "nothing was saved there; call save first");
    if (saved.field->task.json != task_.json)
        throw EnvironmentError(EnvironmentError::Kind::kOtherTask,
                               "the saved moment is of another task, or its scene was changed "
                               "otherwise: found " +
                                   saved.field->task.id + ", expected " + task_.id);
    enter(saved.field);
    sim::load_own_state(*state_, saved.state);
    episode_ = saved.episode;
    looked_ = -1;
    look_for_goals();
}

}  // namespace placode::environment
