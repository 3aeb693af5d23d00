// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A whole store goes to another place: from the file of one computer to a centre's server, and
// back. The old place keeps everything, and is closed at the end: no program writes into it then.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace placode::db {

struct MoveProgress {
    enum class Step : uint8_t { kCheckHere, kCopy, kCompare, kCheckThere, kFinish };
    Step step = Step::kCheckHere;
    std::string table;            ///< kCopy, kCompare: which.
    int64_t done = 0, total = 0;  ///< Rows of all tables; 0 in the other steps.
};

struct MoveOptions {
    bool dry_run = false;  ///< Says what would be moved, and whether the place is free.
    /// Called often; false = stop. What was copied stays, and the next call goes on.
    std::function<bool(const MoveProgress&)> progress;
};

struct MoveReport {
    struct Table {
        std::string name;
        int64_t rows = 0;
    };
    std::string from, to;  ///< Addresses without passwords.
    std::vector<Table> tables;
    int64_t rows = 0, recording_bytes = 0;
    bool went_on = false;  ///< An earlier move had been stopped or killed.
    bool stopped = false;  ///< By `progress`.
    std::string old_file;  ///< The file that was in the new place is kept under this name.
};

/// The last step of a move that was killed after the old place was closed, which nobody can open
/// any more. nullopt where there is nothing of the kind: Store::move_to() does all then. On a
/// server with the log-in of the tables' owner, who needs no account: an administrator has ordered
/// the move. Also when all is done already. Throws StoreError.
[[nodiscard]] std::optional<MoveReport> finish_move(const std::string& from_url,
                                                    const std::string& to_url);

}  // namespace placode::db
