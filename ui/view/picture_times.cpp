// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/picture_times.h"

#include <algorithm>
#include <cassert>
#include <chrono>

namespace placode::view {
namespace {

using Clock = std::chrono::steady_clock;

constexpr size_t kWarming = 3;  // pictures that are not counted

}  // namespace

PictureTimes time_pictures(const ViewField& field, std::span<const sim::Snapshot> moments,
                           const PictureSize& size, const Quality& quality, double seconds,
                           const std::string& save) {
    assert(!moments.empty());
    ViewSettings settings;
    settings.width = size.width;
    settings.height = size.height;
    settings.offscreen = true;
    settings.adaptive = false;
    settings.quality = quality;
    FetoscopeView view(field, settings);
    PictureTimes times{size, quality, view.renderer(), {}};
    const OverlayState overlay;
    const size_t count = std::max(moments.size(), kWarming + kLeastPictures);
    double spent_ms = 0;
    for (size_t i = 0; i < count; ++i) {
        const auto start = Clock::now();
        view.draw(moments[i % moments.size()], overlay);
        const std::chrono::duration<double, std::milli> spent = Clock::now() - start;
        if (i < kWarming) continue;
        times.ms.push_back(spent.count());
        spent_ms += spent.count();
        if (spent_ms > 1000 * seconds && times.ms.size() >= kLeastPictures) break;
    }
    if (!save.empty()) view.save_png(save);
    return times;
}

std::vector<Quality> all_qualities() {
    Quality quality;
    while (make_richer(quality)) {
    }
    std::vector<Quality> all;
    do {
        all.push_back(quality);
    } while (make_simpler(quality));
    return all;
}

}  // namespace placode::view
