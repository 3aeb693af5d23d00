// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Who is behind a code: the encrypted key of a study, opened with its passphrase for as long as the
// page is shown.

#include "ui/shell/pages.h"

namespace placode::ui {

[[nodiscard]] QWidget* make_names_card(AppContext& context, Page& page, const std::string& study,
                                       const QStringList& codes);

}  // namespace placode::ui
