// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/attempt/screenshots.h"

#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>

#include "ui/attempt/user_settings.h"

namespace placode::ui {
namespace {

std::string name(double time_s) {
    char text[64];
    std::snprintf(text, sizeof text, "placode_%07.0f_ms.png", 1000 * time_s);
    return text;
}

/// A name that no other picture has: day and time of the clock on the wall, then of the attempt.
std::string dated_name(double time_s) {
    const std::time_t now = std::time(nullptr);
    std::tm local{};
    ::localtime_r(&now, &local);
    char text[64];
    std::strftime(text, sizeof text, "%Y-%m-%d_%H%M%S_", &local);
    return text + name(time_s);
}

}  // namespace

Screenshots::Screenshots(const Arguments& arguments)
    : folder_(arguments.screenshot_folder), every_s_(arguments.screenshot_every_s) {
    if (folder_.empty()) return;
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    if (error || !std::filesystem::is_directory(folder_)) {
        throw UsageError("--screenshots: cannot make folder " + folder_ + ": " + error.message());
    }
}

void Screenshots::save(view::FetoscopeView& view, double time_s) {
    view.save_png((std::filesystem::path(folder_) / name(time_s)).string());
    ++saved_;
    next_s_ = (std::floor(time_s / every_s_ + 1e-9) + 1) * every_s_;
}

std::string Screenshots::save_extra(view::FetoscopeView& view, double time_s) {
    const std::filesystem::path folder =
        folder_.empty() ? pictures_folder() : std::filesystem::path(folder_);
    const std::string path = (folder / dated_name(time_s)).string();
    view.save_png(path);
    ++saved_;
    return path;
}

}  // namespace placode::ui
