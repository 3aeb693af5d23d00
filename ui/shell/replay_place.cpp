// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/replay_place.h"

#include <QGuiApplication>
#include <QScreen>
#include <QWidget>
#include <algorithm>

namespace placode::ui {
namespace {

constexpr int kTitleBar = 40, kEdge = 8;             ///< Of the desktop around a window [px].
constexpr QSize kMost{1280, 800}, kLeast{420, 262};  ///< 16:10.
constexpr double kShape = 1.6;

/// The largest picture that fits into `room` with its frame, in the corner away from the shell.
QRect picture_in(QRect room) {
    room.adjust(kEdge, kTitleBar, -kEdge, -kEdge);
    int width = std::min(room.width(), kMost.width());
    int height = static_cast<int>(width / kShape);
    if (height > std::min(room.height(), kMost.height())) {
        height = std::min(room.height(), kMost.height());
        width = static_cast<int>(height * kShape);
    }
    if (width < kLeast.width() || height < kLeast.height()) return {};
    return {room.right() - width + 1, room.top(), width, height};
}

int area(const QRect& rect) { return rect.isNull() ? 0 : rect.width() * rect.height(); }

/// What is left of `all` to the right, left, below and above of `taken`.
std::vector<QRect> strips(const QRect& all, const QRect& taken) {
    const QRect in = taken.intersected(all);
    if (in.isEmpty()) return {all};
    return {QRect(QPoint(in.right() + 1, all.top()), all.bottomRight()),
            QRect(all.topLeft(), QPoint(in.left() - 1, all.bottom())),
            QRect(QPoint(all.left(), in.bottom() + 1), all.bottomRight()),
            QRect(all.topLeft(), QPoint(all.right(), in.top() - 1))};
}

QRect largest(const std::vector<QRect>& rooms) {
    QRect best;
    for (const QRect& room : rooms)
        if (const QRect picture = picture_in(room); area(picture) > area(best)) best = picture;
    return best;
}

}  // namespace

QRect replay_place(const std::vector<QRect>& screens, const QRect& window, const QRect& controls) {
    std::vector<QRect> beside, over;
    for (const QRect& screen : screens) {
        for (const QRect& room : strips(screen, window)) beside.push_back(room);
        for (const QRect& room : strips(screen, controls)) over.push_back(room);
    }
    const QRect free = largest(beside);
    // A small picture beside is worth less than a large one over what is not needed now.
    const QRect above_page = largest(over);
    return 2 * area(free) >= area(above_page) ? free : above_page;
}

QRect replay_place(const QWidget& controls, const QWidget* also) {
    std::vector<QRect> screens;
    for (const QScreen* screen : QGuiApplication::screens())
        screens.push_back(screen->availableGeometry());
    const QRect window = controls.window()->frameGeometry();
    const QRect here(controls.mapToGlobal(QPoint(0, 0)), controls.size());
    if (also != nullptr) {
        const QRect seen = also->visibleRegion().boundingRect();
        const QRect both = here.united(seen.translated(also->mapToGlobal(QPoint(0, 0))));
        const QRect place = replay_place(screens, window, both);
        if (!place.isNull()) return place;
    }
    return replay_place(screens, window, here);
}

std::vector<QRect> two_of(const QRect& place) {
    if (place.isNull()) return {{}, {}};
    const int width = (place.width() - kEdge) / 2;
    const int height = std::min(place.height(), static_cast<int>(width / 1.25));
    return {QRect(place.left(), place.top(), width, height),
            QRect(place.left() + width + kEdge, place.top(), width, height)};
}

}  // namespace placode::ui
