// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where along the planned line the story of a metric can be seen: gaps, the worst place of the
// incision, what still holds, a stretch that was not followed.

#include "assessment/loci.h"

namespace placode::assessment {

/// Nothing where the metric says nothing of the line.
[[nodiscard]] std::optional<Locus> locate_on_line(std::string_view metric,
                                                  const sim::Recording& recording);

}  // namespace placode::assessment
