// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What of placode.h needs the file format of the store and the picture of the shell's attempts.

#include <algorithm>

#include "db/recording_file.h"
#include "interface/handles.h"
#include "ui/view/fetoscope_view.h"

using namespace placode;
using interface::guarded;
using interface::refuse;

struct placode_picture {
    std::unique_ptr<view::FetoscopeView> view;
    view::OverlayState overlay;
    std::shared_ptr<const sim::Scene> scene;
    int width = 0, height = 0;
};

namespace {

constexpr size_t kChunk = 250;  // entries that are committed at once, as in a person's attempt

template <class T>
std::span<const T> part(const std::vector<T>& list, size_t from, size_t to) {
    return std::span<const T>(list).subspan(
        std::min(from, list.size()), std::min(to, list.size()) - std::min(from, list.size()));
}

void write_file(const sim::Recording& recording, const std::string& path) {
    const auto sink = db::create_recording_file(path);
    sink->begin(recording.header);
    // Longer chunks pack better than single seconds; the file is complete or not there.
    const size_t most =
        std::max({recording.inputs.size(), recording.samples.size(), recording.events.size()});
    for (size_t at = 0; at < most; at += 16 * kChunk)
        sink->append(part(recording.inputs, at, at + 16 * kChunk),
                     part(recording.samples, at, at + 16 * kChunk),
                     part(recording.events, at, at + 16 * kChunk));
    sink->finish(recording.end);
}

void open_view(const environment::Environment& environment, placode_picture& picture) {
    view::ViewSettings settings;
    settings.width = picture.width;
    settings.height = picture.height;
    settings.offscreen = true;
    settings.adaptive = false;
    const std::shared_ptr<const sim::Scene> scene = environment.field().scene;
    // A picture has a scene only while it has a view of it: when none can be made, the next call
    // tries again.
    picture.scene.reset();
    picture.view.reset();
    picture.view = std::make_unique<view::FetoscopeView>(
        view::view_field(*scene, environment.field().seed), settings);
    picture.scene = scene;
}

}  // namespace

extern "C" {

placode_status placode_write_recording(placode_environment* e, const char* path) {
    if (e == nullptr) return PLACODE_BAD_ARGUMENT;
    return guarded(e->error, [&] {
        if (path == nullptr) refuse("no path: a null pointer");
        write_file(e->environment->recording(), path);
    });
}

placode_picture* placode_picture_new(placode_environment* e, int32_t width, int32_t height) {
    if (e == nullptr) return nullptr;
    std::unique_ptr<placode_picture> made;
    (void)guarded(e->error, [&] {
        if (width < 64 || height < 64 || width > 8192 || height > 8192)
            refuse("a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                   "; expected 64 to 8192 each");
        auto picture = std::make_unique<placode_picture>();
        picture->width = width;
        picture->height = height;
        open_view(*e->environment, *picture);
        picture->view->let_go();
        made = std::move(picture);
    });
    return made.release();
}

void placode_picture_free(placode_picture* picture) { delete picture; }

placode_status placode_draw(placode_environment* e, placode_picture* picture, uint8_t* rgb,
                            size_t count) {
    if (e == nullptr) return PLACODE_BAD_ARGUMENT;
    return guarded(e->error, [&] {
        if (picture == nullptr || rgb == nullptr) refuse("nowhere to draw: a null pointer");
        const size_t bytes =
            size_t{3} * static_cast<size_t>(picture->width) * static_cast<size_t>(picture->height);
        if (count != bytes)
            refuse("room for " + std::to_string(count) + " bytes; the picture has " +
                   std::to_string(bytes));
        const environment::Environment& environment = *e->environment;
        if (picture->scene != environment.field().scene) open_view(environment, *picture);
        sim::Snapshot snapshot;
        sim::fill_snapshot(*picture->scene, environment.state(), snapshot);
        // The view draws anew what has another version; after a jump every surface has.
        snapshot.surface_version += environment.jumps() << 20;
        picture->view->draw(snapshot, picture->overlay);
        const std::vector<uint8_t> pixels = picture->view->pixels();
        picture->view->let_go();
        std::copy_n(pixels.begin(), std::min(bytes, pixels.size()), rgb);
    });
}
}
