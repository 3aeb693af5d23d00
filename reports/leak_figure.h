// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where a sewn slit leaks, the same in window and PDF: along the slit what each station lets
// through, the bites, and how far the edges stand apart; in words for who cannot see it; as a
// table.

#include <QString>
#include <optional>
#include <string>
#include <vector>

#include "assessment/leak_map.h"
#include "reports/report.h"

namespace placode::reports {

/// Height that the figure wants at this font size [px].
[[nodiscard]] double leak_height(const ChartStyle& style);

/// From above: leak at 12.5 cmH2O [ml/min], entries and exits of the bites, gap [mm] without
/// pressure and under it. All lie to one scale along the slit; where it burst stands a line.
void draw_leak(QPainter& painter, const QRectF& where, const assessment::LeakMap& map,
               const ChartStyle& style);

/// "It leaks most between bites 2 and 3, 5.1 mm from the left end: 12 ml/min at 12.5 cmH2O; the
/// rest is tight. It burst at 21.8 cmH2O between bites 2 and 3." In the program's language.
[[nodiscard]] QString leak_words(const assessment::LeakMap& map);
/// What stands in its place where a recording has none.
[[nodiscard]] QString no_leak_map_words();

/// The score looks at what a slit holds: such an attempt has a map, or a word why there is none.
[[nodiscard]] bool looks_at_leak(const std::vector<std::string>& scored) noexcept;

/// One row for each station from the first end on; nothing where an older recording lacks it, and
/// where a station never opened. Columns: docs/suture.md.
struct LeakTable {
    std::vector<std::string> columns;
    std::vector<std::vector<std::optional<double>>> rows;  ///< As long as `columns`.
};
[[nodiscard]] LeakTable leak_table(const assessment::LeakMap& map);
/// The same as RFC 4180, a missing value empty.
[[nodiscard]] std::string leak_csv(const LeakTable& table);

}  // namespace placode::reports
