// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Pass marks that hold, and norm packs with their bands.

#include "db/signature.h"
#include "db/standards.h"
#include "reports/text.h"
#include "sim/core/counted.h"
#include "ui/web/parts.h"

namespace placode::web {
namespace {

std::string origin_of(const db::StandardRecord& set) {
    const curriculum::PassStandard& standard = set.standard;
    if (standard.method == "angoff")
        return sim::counted(standard.angoff.judges, "judge") + ", standard error " +
               reports::number(standard.angoff.se_points, 1).toStdString();
    const auto share = [](double wrong) {
        return reports::number(100 * wrong, 0).toStdString() + " %";
    };
    return "contrasting groups: " + std::to_string(standard.novice.n) + " novices, " +
           std::to_string(standard.expert.n) +
           " experts; novices who pass: " + share(standard.novice.theoretical_wrong) +
           " by the curves, " + share(standard.novice.observed_wrong) + " observed";
}

/// Norms are for who sets standards: the page of the shell asks the same.
void need_educator(const Visit& visit) {
    if (!visit.may(db::Action::kSetStandards))
        throw db::StoreError(db::StoreError::Kind::kRefused,
                             db::refusal(db::Action::kSetStandards));
}

std::string groups_of(const curriculum::NormPack& pack) {
    std::string words;
    for (const curriculum::NormGroup& group : pack.groups)
        words += (words.empty() ? "" : ", ") + group.level + ": " +
                 sim::counted(group.persons, "person", "people");
    return words;
}

Html bands_of(const curriculum::NormGroup& group) {
    Table table(group.level + ", " + sim::counted(group.persons, "person", "people") + ", " +
                    sim::counted(group.attempts, "attempt"),
                {{"Metric"}, {"n", true}, {"Mean", true}, {"SD", true}, {"Unit"}});
    for (const curriculum::NormMetric& metric : group.metrics) {
        const auto* known = assessment::metric_definition(metric.id);
        const auto value = [](double number) { return text(reports::metric_number(number)); };
        table.row({known != nullptr ? text(std::string(known->name)) : text(metric.id),
                   text(metric.band.n), value(metric.band.mean), value(metric.band.sd),
                   known != nullptr ? text(reports::unit_sign(known->unit)) : text("points")});
    }
    return table.html();
}

}  // namespace

PageText standards_page(const Visit& visit) {
    const std::vector<std::string> tasks = visit.store.attempts().tasks();
    Html body;
    body << "<h1>Standards</h1>\n<section class=\"card\">";
    Table table("Pass marks that hold now",
                {{"Task"}, {"Pass mark", true}, {"Set on"}, {"By"}, {"From"}, {"Reason"}});
    for (const std::string& task : tasks) {
        const Tasks::Known known = visit.tasks.of(task);
        if (const auto set = db::standard_at(visit.store, task))
            table.row({text(known.title), points(set->standard.pass_points), day(set->set_utc),
                       text(set->set_by), text(origin_of(*set)),
                       text(set->reason.empty() ? "–" : set->reason)});
        else
            table.row({text(known.title), known.shipped ? points(known.pass_points) : text("–"),
                       text("–"), text("–"), text("the task's own mark"), text("–")});
    }
    if (table.empty())
        body << "<p class=\"muted\">There are no attempts yet.</p>";
    else
        body << table.html();
    body << "<p class=\"small\">An attempt keeps the verdict of its day. Standards are set in "
            "Placode, on the page Standards.</p></section>\n";
    return {"Standards", body};
}

PageText norms_page(const Visit& visit) {
    need_educator(visit);
    Html body;
    body << "<h1>Norms</h1>\n<section class=\"card\">";
    Table table("Norm packs", {{"Task"}, {"Centre"}, {"Made"}, {"Groups"}, {"Key"}, {"Use"}});
    for (const db::NormPackRecord& each : visit.store.norms().list({}))
        table.row({link("/norms/" + std::to_string(each.id),
                        text(visit.tasks.of(each.pack.task_id).title)),
                   text(each.pack.centre), day(each.pack.made_utc), text(groups_of(each.pack)),
                   text(db::fingerprint(each.norms.public_key)),
                   each.in_use ? badge(Html("in use"), "good") : Html("–")});
    if (table.empty())
        body << "<p class=\"muted\">There are no packs yet.</p>";
    else
        body << table.html();
    body << "<p class=\"small\">Bands of persons' means, never of fewer than "
         << text(curriculum::kLeastNormGroup)
         << " people and never a single attempt, signed by their centre.</p></section>\n";
    return {"Norms", body};
}

PageText norm_pack_page(const Visit& visit) {
    need_educator(visit);
    const int64_t id = visit.id();
    for (const db::NormPackRecord& each : visit.store.norms().list({})) {
        if (each.id != id) continue;
        const std::string title = visit.tasks.of(each.pack.task_id).title;
        Html body;
        body << "<h1>Norms: " << text(title) << "</h1><p>" << link("/norms", Html("All packs"))
             << " · " << text(each.pack.centre) << ", made on " << day(each.pack.made_utc)
             << ", rubric "
             << text(each.pack.rubric_id + " " + std::to_string(each.pack.rubric_version));
        if (each.in_use) body << " " << badge(Html("in use"), "good");
        if (each.pack.demonstration) body << " " << badge(Html("DEMONSTRATION"), "warn");
        body << "</p>\n";
        for (const curriculum::NormGroup& group : each.pack.groups)
            body << "<section class=\"card\">" << bands_of(group) << "</section>\n";
        return {"Norms: " + title, body};
    }
    throw NotThere("There is no such norm pack.");
}

}  // namespace placode::web
