// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Publishing the protocol of a study that came with the program: for the first time, or a newer
// version.

#include "curriculum/study.h"
#include "ui/shell/pages.h"

class QVBoxLayout;

namespace placode::ui {

/// Of a study that was never published here. `page` leads on.
void add_publishing(QVBoxLayout* layout, AppContext& context, Page& page,
                    const curriculum::StudyProtocol& protocol);

/// A newer version came with the program: participants who are in keep theirs. Adds nothing when
/// there is none.
void add_newer_version(QVBoxLayout* layout, AppContext& context, Page& page,
                       const curriculum::StudyProtocol& published);

}  // namespace placode::ui
