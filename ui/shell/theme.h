// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The look of the shell: tokens of both themes, the one style sheet made from them, icons and the
// colours of charts. A page names a role ("primary", "muted"), never a colour.

#include <QColor>
#include <QIcon>
#include <QString>

#include "reports/report.h"

class QApplication;

namespace placode::ui {

enum class ThemeKind : uint8_t { kLight, kDark };

/// Colours by role. `soft` variants are the role at low strength on the raised surface.
struct Tokens {
    QColor surface, raised, line, text, muted;
    QColor accent, on_accent, accent_soft;
    QColor good, good_soft, warn, warn_soft, critical, critical_soft;
    QColor hover;  ///< Raised surface under the pointer.
    QColor field;  ///< Border of an input: 3:1 against the surface.
};

/// Spacing steps [px].
inline constexpr int kSpace4 = 4, kSpace8 = 8, kSpace12 = 12, kSpace16 = 16, kSpace24 = 24,
                     kSpace32 = 32;
/// Least height of anything that a finger must hit [px].
inline constexpr int kTouchTarget = 44;

[[nodiscard]] const Tokens& tokens(ThemeKind theme);

/// Palette, font and style sheet of the whole application.
void apply_theme(QApplication& application, ThemeKind theme);

/// The same tokens for the charts of `reports`.
[[nodiscard]] reports::ChartStyle chart_style(ThemeKind theme, double font_px = 12);

/// Line icon `icons/NAME.svg` in one colour, sharp at any pixel ratio.
[[nodiscard]] QIcon line_icon(const QString& name, const QColor& color);

}  // namespace placode::ui
