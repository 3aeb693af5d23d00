// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Pass marks that hold, and norm packs with their bands.

#include "db/signature.h"
#include "db/standards.h"
#include "reports/text.h"
#include "ui/web/parts.h"

namespace placode::web {

using namespace std::string_view_literals;

namespace {

Text origin_of(const db::StandardRecord& set) {
    const curriculum::PassStandard& standard = set.standard;
    if (standard.method == "angoff")
        return Web::count_phrase("%n judge(s), standard error %1", standard.angoff.judges,
                                 number_text(reports::number(standard.angoff.se_points, 1)));
    const auto share = [](double wrong) { return text(reports::number(100 * wrong, 0)); };
    return Web::phrase(
        "contrasting groups, novices: %1, experts: %2; novices who pass: %3 % by the curves, "
        "%4 % observed",
        text(standard.novice.n), text(standard.expert.n), share(standard.novice.theoretical_wrong),
        share(standard.novice.observed_wrong));
}

/// A level of another centre may be any word.
Text level_words(const std::string& level) {
    if (level == "expert") return Web::phrase("experts");
    if (level == "novice") return Web::phrase("novices");
    return text(level);
}

/// Norms are for who sets standards: the page of the shell asks the same.
void need_educator(const Visit& visit) {
    if (!visit.may(db::Action::kSetStandards))
        throw db::StoreError(db::StoreError::Kind::kRefused, "",
                             db::refusal(db::Action::kSetStandards));
}

Html groups_of(const curriculum::NormPack& pack) {
    Html all;
    for (const curriculum::NormGroup& group : pack.groups) {
        if (!all.empty()) all << ", ";
        all << Web::count_phrase("%1: %n person(s)", group.persons, level_words(group.level));
    }
    return all;
}

Html bands_of(const curriculum::NormGroup& group) {
    const Text people =
        Web::count_phrase("%1: %n person(s)", group.persons, level_words(group.level));
    Table table(Web::count_phrase("%1, %n attempt(s)", group.attempts, people),
                {{Web::phrase("Metric")},
                 {text("n"sv), true},
                 {Web::phrase("Mean"), true},
                 {Web::phrase("SD"), true},
                 {Web::phrase("Unit")}});
    for (const curriculum::NormMetric& metric : group.metrics) {
        const auto* known = assessment::metric_definition(metric.id);
        const auto value = [](double number) {
            return number_text(reports::metric_number(number));
        };
        const Text name = known != nullptr        ? metric_words(*known)
                          : metric.id == "points" ? Web::phrase("Points")
                                                  : text(metric.id);
        table.row(
            {name, text(metric.band.n), value(metric.band.mean), value(metric.band.sd),
             known != nullptr ? text(reports::unit_sign(known->unit)) : Web::phrase("points")});
    }
    return table.html();
}

}  // namespace

PageText standards_page(const Visit& visit) {
    const std::vector<std::string> tasks = visit.store.attempts().tasks();
    Html body;
    body << "<h1>" << Web::phrase("Standards") << "</h1>\n<section class=\"card\">";
    Table table(Web::phrase("Pass marks that hold now"), {{Web::phrase("Task")},
                                                          {Web::phrase("Pass mark"), true},
                                                          {Web::phrase("Set on")},
                                                          {Web::phrase("By")},
                                                          {Web::phrase("From")},
                                                          {Web::phrase("Reason")}});
    for (const std::string& task : tasks) {
        const Tasks::Known known = visit.tasks.of(task);
        if (const auto set = db::standard_at(visit.store, task))
            table.row({text(known.title), points(set->standard.pass_points), day(set->set_utc),
                       text(set->set_by), origin_of(*set),
                       set->reason.empty() ? dash() : text(set->reason)});
        else
            table.row({text(known.title), known.shipped ? points(known.pass_points) : dash(),
                       dash(), dash(), Web::phrase("the task's own mark"), dash()});
    }
    if (table.empty())
        body << "<p class=\"muted\">" << Web::phrase("There are no attempts yet.") << "</p>";
    else
        body << table.html();
    body
        << "<p class=\"small\">"
        << Web::phrase(
               "An attempt keeps the verdict of its day. Standards are set in Placode, on the page "
               "Standards.")
        << "</p></section>\n";
    return {Web::phrase("Standards"), body};
}

PageText norms_page(const Visit& visit) {
    need_educator(visit);
    Html body;
    body << "<h1>" << Web::phrase("Norms") << "</h1>\n<section class=\"card\">";
    Table table(Web::phrase("Norm packs"), {{Web::phrase("Task")},
                                            {Web::phrase("Centre")},
                                            {Web::phrase("Made")},
                                            {Web::phrase("Groups")},
                                            {Web::phrase("Key")},
                                            {Web::phrase("Use")}});
    for (const db::NormPackRecord& each : visit.store.norms().list({}))
        table.row({link("/norms/" + std::to_string(each.id),
                        text(visit.tasks.of(each.pack.task_id).title)),
                   text(each.pack.centre), day(each.pack.made_utc), groups_of(each.pack),
                   text(db::fingerprint(each.norms.public_key)),
                   each.in_use ? badge(Web::phrase("in use"), Tone::kGood) : Html(dash())});
    if (table.empty())
        body << "<p class=\"muted\">" << Web::phrase("There are no packs yet.") << "</p>";
    else
        body << table.html();
    body
        << "<p class=\"small\">"
        << Web::phrase(
               "Bands of persons' means, never of fewer than %1 people and never a single attempt, "
               "signed by their centre.",
               text(curriculum::kLeastNormGroup))
        << "</p></section>\n";
    return {Web::phrase("Norms"), body};
}

PageText norm_pack_page(const Visit& visit) {
    need_educator(visit);
    const int64_t id = visit.id();
    for (const db::NormPackRecord& each : visit.store.norms().list({})) {
        if (each.id != id) continue;
        const std::string title = visit.tasks.of(each.pack.task_id).title;
        Html body;
        const Text head = Web::phrase("Norms: %1", text(title));
        body << "<h1>" << head << "</h1><p>" << link("/norms", Web::phrase("All packs")) << " · "
             << Web::phrase("%1, made on %2, rubric %3 %4", text(each.pack.centre),
                            day(each.pack.made_utc), text(each.pack.rubric_id),
                            text(each.pack.rubric_version));
        if (each.in_use) body << " " << badge(Web::phrase("in use"), Tone::kGood);
        if (each.pack.demonstration) body << " " << demonstration_badge();
        body << "</p>\n";
        for (const curriculum::NormGroup& group : each.pack.groups)
            body << "<section class=\"card\">" << bands_of(group) << "</section>\n";
        return {head, body};
    }
    throw NotThere(Web::plain_phrase("There is no such norm pack."));
}

}  // namespace placode::web
