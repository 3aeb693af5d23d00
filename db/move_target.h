// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The place that a store is moved to: whether it is free, the unfinished store in it, and the step
// that makes it the store. A file is filled under another name, PATH.moving; a server's tables are
// where they will be, and no program opens them meanwhile. Only db/ includes this.

#include <memory>
#include <string>

#include "db/store_options.h"
#include "db/store_place.h"

namespace placode::db {

struct StoreContext;

class MoveTarget {
 public:
    /// @param store chain of the first entry of the store that comes
    MoveTarget(const StoreUrl& url, std::string store, const StoreOptions& options);

    /// Changes nothing. Throws kConflict, saying what is there, unless the place is free: empty, a
    /// move of this store that was not finished, or its file from before it moved away.
    void need_free();
    /// After need_free(): whether an unfinished move goes on.
    [[nodiscard]] bool underway() const { return underway_; }

    /// Opens the unfinished store, with the tables of this program, which is made where there is
    /// none. Throws kRefused where a server's log-in may not.
    [[nodiscard]] std::unique_ptr<StoreContext> open(const StorePlace& place);
    /// The same, without a row in it.
    [[nodiscard]] std::unique_ptr<StoreContext> open_empty(std::unique_ptr<StoreContext> old,
                                                           const StorePlace& place);

    /// From now on it is the store; once the old place is closed. May be done again after a kill.
    /// Returns where the file that was there is kept; "" = none was.
    std::string finish();

 private:
    void needFreeFile();
    void needFreeServer();
    std::string finishFile();
    std::string putOldFileAside();
    void finishServer();
    /// The unfinished one's own address.
    [[nodiscard]] StoreUrl working() const;

    StoreUrl url_;
    std::string store_, operation_;
    StoreOptions options_;
    bool underway_ = false;
};

}  // namespace placode::db
