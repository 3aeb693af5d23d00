// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A study as a CDISC ODM 1.3.2 document: metadata and clinical data in one. Private to reports.

#include <QByteArray>

#include "reports/dataset.h"

namespace placode::reports {

/// The whole document. The order of the elements is that of the official schema.
[[nodiscard]] QByteArray odm_document(const Dataset& data);

}  // namespace placode::reports
