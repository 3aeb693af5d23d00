// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What several pages show alike: days, points, words for a standing, pictures, pages of a list, the
// choice of a group.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "assessment/cohort.h"
#include "reports/figure.h"
#include "ui/web/html.h"
#include "ui/web/pages.h"
#include "ui/web/words.h"

namespace placode::web {

/// "–": there is none.
[[nodiscard]] Text dash();
/// "2026-11-25 18:03", UTC, in Polish "25 lis 2026, 18:03" as in the shell; "–" for none.
[[nodiscard]] Html moment(const std::string& utc);
[[nodiscard]] Html day(const std::string& utc);
/// A sentence of the engine, its days as day() has them.
[[nodiscard]] Text with_days(const std::string& sentence);
[[nodiscard]] Text points(double value);
[[nodiscard]] Text verdict(assessment::Verdict verdict);
/// The verdict, or that the attempt does not count.
[[nodiscard]] Html verdict_badge(const db::AttemptRecord& attempt);
[[nodiscard]] Html demonstration_badge();
[[nodiscard]] Html standing_badge(assessment::Standing standing);
/// What "stuck" and "regressed" mean (assessment/cohort.h).
[[nodiscard]] Text standings_explained();
/// The name of a metric, as the shell has it.
[[nodiscard]] Text metric_words(const assessment::MetricDefinition& metric);
[[nodiscard]] std::string role_words(db::Roles roles);
/// "number 12" where there is no name any more.
[[nodiscard]] std::string name_or_number(const std::string& name, int64_t id);

/// `<picture>` in both themes. `draw` gets the style of one of them.
[[nodiscard]] Html picture(
    const std::string& title, const std::string& description, int width, int height,
    const std::function<void(QPainter&, const QRectF&, const reports::ChartStyle&)>& draw);
/// A figure with its title and caption. @param make for a style.
[[nodiscard]] Html figure(const std::function<reports::Figure(const reports::ChartStyle&)>& make);

/// Which part of a list is shown, from `?page=`.
struct Part {
    int64_t page = 0, first = 0, past = 0, total = 0;
};
[[nodiscard]] Part part_of(const Visit& visit, int64_t total);
/// Links to the page before and after; nothing where all is shown.
[[nodiscard]] Html pager(const Part& part, const std::string& path, std::vector<QueryPart> parts);

/// The views of one matter; `here` is the address of the one that is shown.
struct View {
    std::string address;
    Text words;
};
[[nodiscard]] Html views(const Text& label, const std::string& here, const std::vector<View>& all);

/// One choice of a form that changes nothing: it only asks for the page again (GET).
struct Choice {
    std::string name;
    Text label;
    std::string chosen;
    std::vector<std::pair<std::string, Text>> values;  ///< Value and words.
};
[[nodiscard]] Html choices(const std::string& path, const std::vector<Choice>& choices);
/// "Everybody" and the groups that the store lists.
[[nodiscard]] Choice group_choice(const Visit& visit);

/// A list of attempts; `with_person` where they are of several people.
[[nodiscard]] Html attempts_table(const Visit& visit, const Text& caption,
                                  const std::vector<db::AttemptRecord>& attempts, bool with_person);

}  // namespace placode::web
