// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace placode::db {

/// Why nothing that needs passwords happens to the store of a local profile (accounts.h).
inline constexpr const char* kOnePersonsStore =
    "this store is one person's without a password; make an account of that profile first";

}  // namespace placode::db
