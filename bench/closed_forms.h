// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What `placodectl bench closed-forms` computes and draws: contact, heat and thread beside the
// closed forms that they have to meet, as figures for docs/ and a table of the differences.

#include <string>
#include <vector>

#include "bench/machine.h"
#include "sim/core/geometry.h"

namespace placode::bench {

/// One simulation and its closed form, in the units of the axes.
struct ClosedFormSeries {
    std::string name;              ///< "mu = 0.3"
    std::vector<sim::Vec2> found;  ///< What the simulation gave, point by point.
    std::vector<sim::Vec2> exact;  ///< The closed form, from one end to the other.
    double error = 0;              ///< As `ClosedFormPanel::measure` says.
};

struct ClosedFormPanel {
    std::string title, x_label, y_label;
    std::string measure;     ///< What `error` is: "largest difference, of the force at 0.2 mm".
    std::string exact_name;  ///< "Hertz"
    double target = 0;       ///< Largest error that a test accepts.
    std::vector<ClosedFormSeries> series;
};

/// A file NAME.svg of panels side by side.
struct ClosedFormFigure {
    std::string name, title;
    std::vector<ClosedFormPanel> panels;
};

/// A round tip pressed into tissue against Hertz; a plane drawn over it against Coulomb. Half a
/// minute.
/// @param wait_s at each depth, until the tissue is at rest; a test may be content with less.
[[nodiscard]] ClosedFormFigure contact_closed_forms(double wait_s = 0.1);
/// A step of temperature against the error function; a point source against Green's function.
[[nodiscard]] ClosedFormFigure heat_closed_forms();
/// A heavy cantilever against the elastica; a pinned column against Euler.
[[nodiscard]] ClosedFormFigure thread_closed_forms();

/// As SVG, on white, so that it can be read on any page. Series differ by marker as by colour.
[[nodiscard]] std::string closed_form_svg(const ClosedFormFigure& figure);
/// The page in Markdown: each figure, and a table of errors.
[[nodiscard]] std::string closed_form_page(const std::vector<ClosedFormFigure>& figures,
                                           const Machine& machine, const std::string& day);

}  // namespace placode::bench
