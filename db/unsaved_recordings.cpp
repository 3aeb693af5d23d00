// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/unsaved_recordings.h"

#include <filesystem>

#include "db/named_word.h"
#include "db/recording_file.h"
#include "db/recording_order.h"
#include "db/sqlite_file.h"
#include "db/store_url.h"

namespace placode::db {

namespace {

namespace fs = std::filesystem;

}  // namespace

std::string recordings_beside(const std::string& url) {
    if (!url.starts_with("sqlite:")) return {};
    const StoreUrl parsed = parse_store_url(url);
    return is_store_file(parsed) ? (fs::absolute(parsed.path).parent_path() / "recordings").string()
                                 : std::string();
}

std::vector<std::string> unsaved_recordings(const std::string& folder, const StudyContext& whose,
                                            Unsaved what) {
    std::vector<std::string> found;
    if (folder.empty()) return found;
    for (const std::string& recording : leftover_recordings(folder)) {
        const std::optional<BesideRecording> order = order_beside(recording);
        if (!order || order->study != whose.study || order->participant != whose.participant)
            continue;
        found.push_back(recording);
        if (what == Unsaved::kName) continue;
        remove_sqlite_file(recording);
        std::error_code none;
        fs::remove(order_file(recording), none);
    }
    return found;
}

UnsavedOf remove_unsaved_of(const UserRecord& user, const std::string& folder) {
    UnsavedOf found;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder, none)) {
        const std::string file = entry.path().string();
        if (!file.ends_with(kOrderSuffix)) continue;
        const std::string recording = file.substr(0, file.size() - kOrderSuffix.size());
        const std::optional<BesideRecording> order = order_beside(recording);
        if (!order) continue;
        if (order->user_id == user.id && order->study.empty()) {
            remove_sqlite_file(recording);
            if (fs::remove(file, none)) found.removed.push_back(recording);
        } else if (holds_word(order->text, user.login) ||
                   holds_word(order->text, user.display_name)) {
            found.naming.push_back(file);
        }
    }
    return found;
}

}  // namespace placode::db
