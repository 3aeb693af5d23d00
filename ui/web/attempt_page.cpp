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
#include "ui/web/attempt_parts.h"
#include "ui/web/parts.h"

namespace placode::web {

using namespace std::string_view_literals;

namespace {

Html counting(const db::AttemptRecord& record) {
    const QString why = reports::not_counted_words(record);
    Html out;
    if (why.isEmpty())
        out << Web::phrase("It counts.");
    else
        out << Web::phrase("It does not count: %1.", text(why));
    return out;
}

Text end_words(sim::EndReason reason) {
    switch (reason) {
        case sim::EndReason::kRunning:
            return Web::phrase("running");
        case sim::EndReason::kFinished:
            return Web::phrase("finished");
        case sim::EndReason::kTimeLimit:
            return Web::phrase("time limit");
        case sim::EndReason::kClosed:
            return Web::phrase("closed@attempt");
        case sim::EndReason::kInterrupted:
            return Web::phrase("interrupted");
    }
    return dash();
}

/// As the shell calls them; names of products stay as the station keeps them.
Text device_words(const std::string& device) {
    if (device == "mouse") return Web::phrase("mouse");
    if (device == "keyboard") return Web::phrase("keyboard");
    if (device == "gamepad") return Web::phrase("gamepad");
    if (device == "script:expert") return Web::phrase("scripted expert");
    if (device == "script:intermediate") return Web::phrase("scripted intermediate");
    if (device == "script:novice") return Web::phrase("scripted novice");
    return text(device);
}

Text group_words(reports::MetricGroup group) {
    switch (group) {
        case reports::MetricGroup::kTime:
            return Web::phrase("Time and view");
        case reports::MetricGroup::kIncision:
            return Web::phrase("Incision");
        case reports::MetricGroup::kPlacode:
            return Web::phrase("Placode@part");
        case reports::MetricGroup::kTissue:
            return Web::phrase("Tissue");
        case reports::MetricGroup::kResection:
            return Web::phrase("Grasping and resection");
        case reports::MetricGroup::kEnergy:
            return Web::phrase("Energy and heat");
        case reports::MetricGroup::kForce:
            return Web::phrase("Force");
        case reports::MetricGroup::kMotion:
            return Web::phrase("Motion");
        case reports::MetricGroup::kHands:
            return Web::phrase("Both hands");
        case reports::MetricGroup::kPractice:
            return Web::phrase("Steps of the exercise");
        case reports::MetricGroup::kSuture:
            return Web::phrase("Needle and thread");
        case reports::MetricGroup::kClosure:
            return Web::phrase("Closed wound");
    }
    return dash();
}

Html facts(const Visit& visit, const db::AttemptRecord& record) {
    Facts list;
    if (record.study.study.empty())
        list.add(Web::phrase("Person"),
                 link("/people/" + std::to_string(record.user_id),
                      text(name_or_number(record.user_name, record.user_id))));
    else
        list.add(Web::phrase("Participant"),
                 text(record.study.participant + ", " + record.study.study));
    list.add(Web::phrase("Task"), text(visit.tasks.of(record.task_id).title));
    list.add(Web::phrase("Started"), Html(moment(record.started_utc)) << text(" UTC"sv));
    list.add(Web::phrase("Length"), text(reports::duration_words(record.duration_s)));
    list.add(Web::phrase("End"), end_words(record.end));
    list.add(Web::phrase("Device"), device_words(record.device));
    if (!record.exam.course_id.empty()) {
        list.add(Web::phrase("Exam"), text(record.exam.course_id + ", " + record.exam.stage_id));
        list.add(Web::phrase("Proctor"), text(record.exam.proctor));
    }
    if (record.demonstration)
        list.add(Web::phrase("Mark"), Web::phrase("DEMONSTRATION, simulated data"));
    list.add(Web::phrase("Scored by"),
             Web::phrase("%1 %2, metric set %3", text(record.rubric_id),
                         text(record.rubric_version), text(record.metric_set_version)));
    return list.html();
}

Html reasons_card(const assessment::Score& score) {
    Html body;
    if (score.reasons.empty()) {
        body << "<p>" << Web::phrase("No point was lost.") << "</p>";
        return card(Web::phrase("What cost points"), body);
    }
    Table table(Web::phrase("Reasons, the most costly first"),
                {{Web::phrase("Reason")}, {Web::phrase("At@time")}, {Web::phrase("Points"), true}});
    for (const assessment::Reason& each : score.reasons) {
        Html words = text(reports::reason_words(each));
        if (each.critical) words << " " << badge(Web::phrase("critical"), Tone::kCritical);
        table.row({words, each.time_s >= 0 ? text(reports::minute_second(each.time_s)) : dash(),
                   points(-each.points)});
    }
    body << table.html();
    return card(Web::phrase("What cost points"), body);
}

Html ledger_card(const db::AttemptDetail& detail, const reports::TaskScope& scope) {
    const reports::LedgerPicture timeline = ledger_of(detail, scope);
    Html body;
    if (timeline.entries.empty()) {
        body << "<p>" << Web::phrase("Nothing was harmed that the ledger watches.") << "</p>";
        return card(Web::phrase("Damage ledger"), body);
    }
    const auto height = static_cast<int>(reports::ledger_height({}));
    body << picture(
        Web::plain_phrase("Damage ledger on a time line"),
        Web::plain_phrase("Phases above, one lane for each kind of harm; the table below lists the "
                          "entries."),
        900, height, [&](QPainter& painter, const QRectF& where, const reports::ChartStyle& style) {
            reports::draw_ledger(painter, where, timeline, style);
        });
    Table table(Web::count_phrase("%n entry(ies) of the damage ledger", timeline.entries.size()),
                {{Web::phrase("At@time")}, {Web::phrase("What")}});
    for (const assessment::LedgerEntry& entry : timeline.entries)
        table.row({text(reports::minute_second(entry.from_s)), entry_words(entry)});
    body << table.html();
    return card(Web::phrase("Damage ledger"), body);
}

Html metrics_card(const db::AttemptDetail& detail, const reports::TaskScope& scope) {
    Table table(Web::phrase("What was measured"), {{Web::phrase("Metric")},
                                                   {Web::phrase("Value"), true},
                                                   {Web::phrase("Unit")},
                                                   {Web::phrase("Part")}});
    for (const reports::GroupedMetrics& group : reports::grouped_metrics(detail.metrics, scope))
        for (const assessment::MetricDefinition& metric : group.metrics) {
            const auto value = detail.metrics.find(metric.id);
            if (!value) continue;
            const bool minutes = reports::in_minutes(metric, *value);
            const Text shown = number_text(reports::metric_text(metric, *value));
            table.row({metric_words(metric), shown,
                       minutes ? text("min"sv) : text(reports::unit_sign(metric.unit)),
                       group_words(group.group)});
        }
    Html body;
    if (!table.empty()) body << table.html();
    if (body.empty()) body << "<p class=\"muted\">" << Web::phrase("None was kept.") << "</p>";
    return card(Web::phrase("Metrics"), body);
}

Html remarks_card(const Visit& visit, int64_t attempt) {
    Html body;
    for (const db::CommentRecord& each : visit.store.reviews().comments(attempt)) {
        body << "<blockquote><p>" << (each.text.empty() ? Web::phrase("(a mark)") : text(each.text))
             << "</p><footer>" << text(each.author_name);
        if (each.time_s >= 0)
            body << ", " << Web::phrase("at %1", text(reports::minute_second(each.time_s)));
        body << ", " << day(each.at_utc) << "</footer></blockquote>";
    }
    if (body.empty())
        body << "<p class=\"muted\">" << Web::phrase("Nobody has remarked on it.") << "</p>";
    return card(Web::phrase("Remarks"), body);
}

Html later_scores_card(const Visit& visit, int64_t attempt) {
    const auto rescores = visit.store.attempts().rescores(attempt);
    if (rescores.empty()) return {};
    Table table(Web::phrase("Later scores; the first one never changes"),
                {{Web::phrase("Scored on")},
                 {Web::phrase("Points"), true},
                 {Web::phrase("Result")},
                 {Web::phrase("Rubric")}});
    for (const db::RescoreRecord& each : rescores)
        table.row({day(each.scored_utc), points(each.score.points), verdict(each.score.verdict),
                   text(each.score.rubric_id + " " + std::to_string(each.score.rubric_version))});
    return card(Web::phrase("Later scores"), table.html());
}

}  // namespace

PageText attempt_page(const Visit& visit) {
    const int64_t id = visit.id();
    const db::AttemptDetail detail = visit.store.attempts().detail(id);
    const reports::TaskScope scope = scope_of_task(detail);
    Html body;
    Html score;
    score << "<strong>" << points(detail.record.points) << "</strong>";
    body << "<h1>" << Web::phrase("Attempt #%1", text(id)) << "</h1>\n<p class=\"verdict\">"
         << Web::phrase("%1 of 100 points", score) << " " << verdict_badge(detail.record)
         << "</p><p>" << counting(detail.record) << "</p>\n<p>"
         << link("/attempts/" + std::to_string(id) + "/review", Web::phrase("Look at it in 3D"))
         << "</p>\n"
         << card(Web::phrase("About it"), facts(visit, detail.record)) << reasons_card(detail.score)
         << ledger_card(detail, scope) << metrics_card(detail, scope) << remarks_card(visit, id)
         << later_scores_card(visit, id);
    return {Web::phrase("Attempt %1", text(id)), body};
}

}  // namespace placode::web
