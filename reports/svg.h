// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Drawings as SVG, for files and for pages in a browser.

#include <QSize>
#include <functional>
#include <string>

class QPainter;

namespace placode::reports {

/// What `draw` paints on a page of this size [px]. The title and what the picture shows are its own
/// `<title>` and `<desc>`. Any thread, with a QGuiApplication.
[[nodiscard]] std::string svg_of(const QSize& size, const std::string& title,
                                 const std::string& description,
                                 const std::function<void(QPainter&)>& draw);

}  // namespace placode::reports
