// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What tests that kill programs, or let the disk fail, look at afterwards.

#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "tests/store_fixture.h"

namespace placode::test {

/// The number of accounts of a store that is whole.
[[nodiscard]] inline int accounts_of_whole(const std::string& file,
                                           const db::StoreOptions& options) {
    const auto store = db::open_store("sqlite:" + file, options);
    EXPECT_THAT(store->check(), testing::IsEmpty());
    return static_cast<int>(store->accounts().list().size());
}

/// Files of the folder whose name holds `part`.
[[nodiscard]] inline std::vector<std::string> files_with(const fs::path& folder,
                                                         const std::string& part) {
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().filename().string().find(part) != std::string::npos)
            found.push_back(entry.path().string());
    return found;
}

}  // namespace placode::test
