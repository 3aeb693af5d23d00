// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>

#include "db/statement_count.h"

namespace placode::test {

/// Statements that `work` sends from this thread.
inline int64_t cost_of(const std::function<void()>& work) {
    const int64_t before = db::statements_sent();
    work();
    return db::statements_sent() - before;
}

}  // namespace placode::test
