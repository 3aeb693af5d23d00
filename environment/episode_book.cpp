// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "environment/episode_book.h"

#include <exception>

namespace placode::environment {

template <class T>
void EpisodeBook::add(std::vector<T>& list, const T& value) noexcept {
    try {
        list.push_back(value);
    } catch (const std::exception&) {
        lost_ = true;
    }
}

void EpisodeBook::write(const sim::Input& input) noexcept {
    if (keep_inputs_) add(recording_.inputs, input);
}

void EpisodeBook::write(const sim::Sample& sample) noexcept { add(recording_.samples, sample); }

void EpisodeBook::write(const sim::Event& event) noexcept {
    add(recording_.events, event);
    for (size_t i = 0; i < kHarms.size(); ++i)
        if (kHarms[i].event == event.kind)
            harms_[i] +=
                kHarms[i].scale > 0 ? kHarms[i].scale * static_cast<double>(event.value) : 1;
}

}  // namespace placode::environment
