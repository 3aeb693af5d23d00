// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a person may type as the address of a store.

#include <QUrl>

namespace placode::ui {

/// A password in it would be read by others: in `ps`, or in the settings.
[[nodiscard]] inline bool has_password(const QString& address) {
    return !QUrl(address.section('?', 0, 0)).password().isEmpty();
}

}  // namespace placode::ui
