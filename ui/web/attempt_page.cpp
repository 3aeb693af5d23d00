// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// One attempt: score, what cost points, whether it counts, the damage ledger on a time line,
// metrics, remarks, later scores. From what the store keeps beside the recording.

#include <QPainter>
#include <set>

#include "assessment/ledger.h"
#include "db/attempt_counting.h"
#include "reports/attempt_figures.h"
#include "reports/metric_groups.h"
#include "reports/text.h"
#include "reports/words.h"
#include "sim/core/counted.h"
#include "ui/web/parts.h"

namespace placode::web {
namespace {

Html counting(const db::AttemptRecord& record) {
    const QString why = reports::not_counted_words(record);
    Html out;
    if (why.isEmpty())
        out << "It counts.";
    else
        out << "It does not count: " << text(why) << ".";
    return out;
}

Html facts(const Visit& visit, const db::AttemptRecord& record) {
    Facts list;
    if (record.study.study.empty())
        list.add(Html("Person"), link("/people/" + std::to_string(record.user_id),
                                      text(name_or_number(record.user_name, record.user_id))));
    else
        list.add(Html("Participant"), text(record.study.participant + ", " + record.study.study));
    list.add(Html("Task"), text(visit.tasks.of(record.task_id).title));
    list.add(Html("Started"), Html(moment(record.started_utc)) << " UTC");
    list.add(Html("Length"), text(reports::duration_words(record.duration_s)));
    list.add(Html("End"), text(reports::end_word(record.end)));
    list.add(Html("Device"), text(record.device));
    if (!record.exam.course_id.empty()) {
        list.add(Html("Exam"), text(record.exam.course_id + ", " + record.exam.stage_id));
        list.add(Html("Proctor"), text(record.exam.proctor));
    }
    if (record.demonstration) list.add(Html("Mark"), Html("DEMONSTRATION, simulated data"));
    list.add(Html("Scored by"),
             text(record.rubric_id + " " + std::to_string(record.rubric_version) + ", metric set " +
                  std::to_string(record.metric_set_version)));
    return list.html();
}

Html reasons_card(const assessment::Score& score) {
    Html body;
    if (score.reasons.empty()) {
        body << "<p>No point was lost.</p>";
        return card(Html("What cost points"), body);
    }
    Table table("Reasons, the most costly first", {{"Reason"}, {"At"}, {"Points", true}});
    for (const assessment::Reason& each : score.reasons) {
        Html words = text(reports::reason_words(each));
        if (each.critical) words << " " << badge(Html("critical"), "critical");
        table.row({words, each.time_s >= 0 ? text(reports::minute_second(each.time_s)) : text("–"),
                   points(-each.points)});
    }
    body << table.html();
    return card(Html("What cost points"), body);
}

Html ledger_card(const db::AttemptDetail& detail, const reports::TaskScope& scope) {
    // The store keeps the events beside the recording; no sample is needed for the time line.
    sim::Recording recording;
    recording.header.task_id = detail.record.task_id;
    recording.end.duration_s = detail.record.duration_s;
    recording.events = detail.events;
    const reports::LedgerPicture timeline = reports::ledger_picture(recording, scope);
    Html body;
    if (timeline.entries.empty()) {
        body << "<p>Nothing was harmed that the ledger watches.</p>";
        return card(Html("Damage ledger"), body);
    }
    const auto height = static_cast<int>(reports::ledger_height({}));
    body << picture("Damage ledger on a time line",
                    "Phases above, one lane for each kind of harm; the table below lists the "
                    "entries.",
                    900, height,
                    [&](QPainter& painter, const QRectF& where, const reports::ChartStyle& style) {
                        reports::draw_ledger(painter, where, timeline, style);
                    });
    Table table(sim::counted(timeline.entries.size(), "entry", "entries") + " of the damage ledger",
                {{"At"}, {"What"}});
    for (const assessment::LedgerEntry& entry : timeline.entries) {
        Html words = text(reports::ledger_words(entry));
        if (entry.has_place) words << ", " << text(entry.hour) << " o'clock";
        if (entry.critical) words << " " << badge(Html("critical"), "critical");
        table.row({text(reports::minute_second(entry.from_s)), words});
    }
    body << table.html();
    return card(Html("Damage ledger"), body);
}

Html metrics_card(const db::AttemptDetail& detail, const reports::TaskScope& scope) {
    Table table("What was measured", {{"Metric"}, {"Value", true}, {"Unit"}, {"Part"}});
    for (const reports::GroupedMetrics& group : reports::grouped_metrics(detail.metrics, scope))
        for (const assessment::MetricDefinition& metric : group.metrics) {
            const auto value = detail.metrics.find(metric.id);
            if (!value) continue;
            const bool minutes = reports::in_minutes(metric, *value);
            const Text shown = text(reports::metric_text(metric, *value));
            table.row({text(std::string(metric.name)), shown,
                       minutes ? text("min") : text(reports::unit_sign(metric.unit)),
                       text(reports::group_title(group.group))});
        }
    Html body;
    if (!table.empty()) body << table.html();
    if (body.empty()) body << "<p class=\"muted\">None was kept.</p>";
    return card(Html("Metrics"), body);
}

Html remarks_card(const Visit& visit, int64_t attempt) {
    Html body;
    for (const db::CommentRecord& each : visit.store.reviews().comments(attempt)) {
        body << "<blockquote><p>" << (each.text.empty() ? text("(a mark)") : text(each.text))
             << "</p><footer>" << text(each.author_name);
        if (each.time_s >= 0) body << ", at " << text(reports::minute_second(each.time_s));
        body << ", " << day(each.at_utc) << "</footer></blockquote>";
    }
    if (body.empty()) body << "<p class=\"muted\">Nobody has remarked on it.</p>";
    return card(Html("Remarks"), body);
}

Html later_scores_card(const Visit& visit, int64_t attempt) {
    const auto rescores = visit.store.attempts().rescores(attempt);
    if (rescores.empty()) return {};
    Table table("Later scores; the first one never changes",
                {{"Scored on"}, {"Points", true}, {"Result"}, {"Rubric"}});
    for (const db::RescoreRecord& each : rescores)
        table.row({day(each.scored_utc), points(each.score.points),
                   text(reports::verdict_word(each.score.verdict)),
                   text(each.score.rubric_id + " " + std::to_string(each.score.rubric_version))});
    return card(Html("Later scores"), table.html());
}

reports::TaskScope scope_of_task(const db::AttemptDetail& detail) {
    try {
        return reports::scope_of(curriculum::load_task(detail.record.task_id));
    } catch (const std::exception&) {
        // It ships no more: what was measured is shown.
        return {};
    }
}

}  // namespace

PageText attempt_page(const Visit& visit) {
    const int64_t id = visit.id();
    const db::AttemptDetail detail = visit.store.attempts().detail(id);
    const reports::TaskScope scope = scope_of_task(detail);
    Html body;
    body << "<h1>Attempt #" << text(id) << "</h1>\n<p class=\"verdict\"><strong>"
         << points(detail.record.points) << "</strong> of 100 points "
         << points_and_verdict(detail.record) << "</p><p>" << counting(detail.record) << "</p>\n"
         << "<section class=\"card\"><h2>About it</h2>" << facts(visit, detail.record)
         << "</section>\n"
         << reasons_card(detail.score) << ledger_card(detail, scope) << metrics_card(detail, scope)
         << remarks_card(visit, id) << later_scores_card(visit, id);
    return {"Attempt " + std::to_string(id), body};
}

}  // namespace placode::web
