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
        return say_count(standard.angoff.judges, "%1 judge, standard error %2",
                         "%1 judges, standard error %2",
                         number_text(reports::number(standard.angoff.se_points, 1)));
    const auto share = [](double wrong) { return text(reports::number(100 * wrong, 0)); };
    return say(
        "contrasting groups, novices: %1, experts: %2; novices who pass: %3 % by the curves, "
        "%4 % observed",
        text(standard.novice.n), text(standard.expert.n), share(standard.novice.theoretical_wrong),
        share(standard.novice.observed_wrong));
}

/// A level of another centre may be any word.
Text level_words(const std::string& level) {
    if (level == "expert") return say("experts");
    if (level == "novice") return say("novices");
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
        all << say_count(group.persons, "%2: %1 person", "%2: %1 people", level_words(group.level));
    }
    return all;
}

Html bands_of(const curriculum::NormGroup& group) {
    const Text people =
        say_count(group.persons, "%2: %1 person", "%2: %1 people", level_words(group.level));
    Table table(say_count(group.attempts, "%2, %1 attempt", "%2, %1 attempts", people),
                {{say("Metric")},
                 {text("n"sv), true},
                 {say("Mean"), true},
                 {say("SD"), true},
                 {say("Unit")}});
    for (const curriculum::NormMetric& metric : group.metrics) {
        const auto* known = assessment::metric_definition(metric.id);
        const auto value = [](double number) {
            return number_text(reports::metric_number(number));
        };
        const Text name = known != nullptr        ? metric_words(*known)
                          : metric.id == "points" ? say("Points")
                                                  : text(metric.id);
        table.row({name, text(metric.band.n), value(metric.band.mean), value(metric.band.sd),
                   known != nullptr ? text(reports::unit_sign(known->unit)) : say("points")});
    }
    return table.html();
}

}  // namespace

PageText standards_page(const Visit& visit) {
    const std::vector<std::string> tasks = visit.store.attempts().tasks();
    Html body;
    body << "<h1>" << say("Standards") << "</h1>\n<section class=\"card\">";
    Table table(say("Pass marks that hold now"), {{say("Task")},
                                                  {say("Pass mark"), true},
                                                  {say("Set on")},
                                                  {say("By")},
                                                  {say("From")},
                                                  {say("Reason")}});
    for (const std::string& task : tasks) {
        const Tasks::Known known = visit.tasks.of(task);
        if (const auto set = db::standard_at(visit.store, task))
            table.row({text(known.title), points(set->standard.pass_points), day(set->set_utc),
                       text(set->set_by), origin_of(*set),
                       set->reason.empty() ? dash() : text(set->reason)});
        else
            table.row({text(known.title), known.shipped ? points(known.pass_points) : dash(),
                       dash(), dash(), say("the task's own mark"), dash()});
    }
    if (table.empty())
        body << "<p class=\"muted\">" << say("There are no attempts yet.") << "</p>";
    else
        body << table.html();
    body
        << "<p class=\"small\">"
        << say("An attempt keeps the verdict of its day. Standards are set in Placode, on the page "
               "Standards.")
        << "</p></section>\n";
    return {say("Standards"), body};
}

PageText norms_page(const Visit& visit) {
    need_educator(visit);
    Html body;
    body << "<h1>" << say("Norms") << "</h1>\n<section class=\"card\">";
    Table table(say("Norm packs"), {{say("Task")},
                                    {say("Centre")},
                                    {say("Made")},
                                    {say("Groups")},
                                    {say("Key")},
                                    {say("Use")}});
    for (const db::NormPackRecord& each : visit.store.norms().list({}))
        table.row({link("/norms/" + std::to_string(each.id),
                        text(visit.tasks.of(each.pack.task_id).title)),
                   text(each.pack.centre), day(each.pack.made_utc), groups_of(each.pack),
                   text(db::fingerprint(each.norms.public_key)),
                   each.in_use ? badge(say("in use"), Tone::kGood) : Html(dash())});
    if (table.empty())
        body << "<p class=\"muted\">" << say("There are no packs yet.") << "</p>";
    else
        body << table.html();
    body
        << "<p class=\"small\">"
        << say("Bands of persons' means, never of fewer than %1 people and never a single attempt, "
               "signed by their centre.",
               text(curriculum::kLeastNormGroup))
        << "</p></section>\n";
    return {say("Norms"), body};
}

PageText norm_pack_page(const Visit& visit) {
    need_educator(visit);
    const int64_t id = visit.id();
    for (const db::NormPackRecord& each : visit.store.norms().list({})) {
        if (each.id != id) continue;
        const std::string title = visit.tasks.of(each.pack.task_id).title;
        Html body;
        const Text head = say("Norms: %1", text(title));
        body << "<h1>" << head << "</h1><p>" << link("/norms", say("All packs")) << " · "
             << say("%1, made on %2, rubric %3 %4", text(each.pack.centre), day(each.pack.made_utc),
                    text(each.pack.rubric_id), text(each.pack.rubric_version));
        if (each.in_use) body << " " << badge(say("in use"), Tone::kGood);
        if (each.pack.demonstration) body << " " << demonstration_badge();
        body << "</p>\n";
        for (const curriculum::NormGroup& group : each.pack.groups)
            body << "<section class=\"card\">" << bands_of(group) << "</section>\n";
        return {head, body};
    }
    throw NotThere(words("There is no such norm pack."));
}

}  // namespace placode::web
