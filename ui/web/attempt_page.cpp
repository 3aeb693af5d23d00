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
        out << say("It counts.");
    else
        out << say("It does not count: %1.", text(why));
    return out;
}

Text end_words(sim::EndReason reason) {
    switch (reason) {
        case sim::EndReason::kRunning:
            return say("running");
        case sim::EndReason::kFinished:
            return say("finished");
        case sim::EndReason::kTimeLimit:
            return say("time limit");
        case sim::EndReason::kClosed:
            return say("closed@attempt");
        case sim::EndReason::kInterrupted:
            return say("interrupted");
    }
    return dash();
}

/// As the shell calls them; names of products stay as the station keeps them.
Text device_words(const std::string& device) {
    if (device == "mouse") return say("mouse");
    if (device == "keyboard") return say("keyboard");
    if (device == "gamepad") return say("gamepad");
    if (device == "script:expert") return say("scripted expert");
    if (device == "script:intermediate") return say("scripted intermediate");
    if (device == "script:novice") return say("scripted novice");
    return text(device);
}

Text group_words(reports::MetricGroup group) {
    switch (group) {
        case reports::MetricGroup::kTime:
            return say("Time and view");
        case reports::MetricGroup::kIncision:
            return say("Incision");
        case reports::MetricGroup::kPlacode:
            return say("Placode@part");
        case reports::MetricGroup::kTissue:
            return say("Tissue");
        case reports::MetricGroup::kResection:
            return say("Grasping and resection");
        case reports::MetricGroup::kEnergy:
            return say("Energy and heat");
        case reports::MetricGroup::kForce:
            return say("Force");
        case reports::MetricGroup::kMotion:
            return say("Motion");
        case reports::MetricGroup::kHands:
            return say("Both hands");
        case reports::MetricGroup::kPractice:
            return say("Steps of the exercise");
        case reports::MetricGroup::kSuture:
            return say("Needle and thread");
    }
    return dash();
}

Html facts(const Visit& visit, const db::AttemptRecord& record) {
    Facts list;
    if (record.study.study.empty())
        list.add(say("Person"), link("/people/" + std::to_string(record.user_id),
                                     text(name_or_number(record.user_name, record.user_id))));
    else
        list.add(say("Participant"), text(record.study.participant + ", " + record.study.study));
    list.add(say("Task"), text(visit.tasks.of(record.task_id).title));
    list.add(say("Started"), Html(moment(record.started_utc)) << text(" UTC"sv));
    list.add(say("Length"), text(reports::duration_words(record.duration_s)));
    list.add(say("End"), end_words(record.end));
    list.add(say("Device"), device_words(record.device));
    if (!record.exam.course_id.empty()) {
        list.add(say("Exam"), text(record.exam.course_id + ", " + record.exam.stage_id));
        list.add(say("Proctor"), text(record.exam.proctor));
    }
    if (record.demonstration) list.add(say("Mark"), say("DEMONSTRATION, simulated data"));
    list.add(say("Scored by"), say("%1 %2, metric set %3", text(record.rubric_id),
                                   text(record.rubric_version), text(record.metric_set_version)));
    return list.html();
}

Html reasons_card(const assessment::Score& score) {
    Html body;
    if (score.reasons.empty()) {
        body << "<p>" << say("No point was lost.") << "</p>";
        return card(say("What cost points"), body);
    }
    Table table(say("Reasons, the most costly first"),
                {{say("Reason")}, {say("At@time")}, {say("Points"), true}});
    for (const assessment::Reason& each : score.reasons) {
        Html words = text(reports::reason_words(each));
        if (each.critical) words << " " << badge(say("critical"), Tone::kCritical);
        table.row({words, each.time_s >= 0 ? text(reports::minute_second(each.time_s)) : dash(),
                   points(-each.points)});
    }
    body << table.html();
    return card(say("What cost points"), body);
}

Html ledger_card(const db::AttemptDetail& detail, const reports::TaskScope& scope) {
    const reports::LedgerPicture timeline = ledger_of(detail, scope);
    Html body;
    if (timeline.entries.empty()) {
        body << "<p>" << say("Nothing was harmed that the ledger watches.") << "</p>";
        return card(say("Damage ledger"), body);
    }
    const auto height = static_cast<int>(reports::ledger_height({}));
    body << picture(words("Damage ledger on a time line"),
                    words("Phases above, one lane for each kind of harm; the table below lists the "
                          "entries."),
                    900, height,
                    [&](QPainter& painter, const QRectF& where, const reports::ChartStyle& style) {
                        reports::draw_ledger(painter, where, timeline, style);
                    });
    Table table(say_count(timeline.entries.size(), "%1 entry of the damage ledger",
                          "%1 entries of the damage ledger"),
                {{say("At@time")}, {say("What")}});
    for (const assessment::LedgerEntry& entry : timeline.entries)
        table.row({text(reports::minute_second(entry.from_s)), entry_words(entry)});
    body << table.html();
    return card(say("Damage ledger"), body);
}

Html metrics_card(const db::AttemptDetail& detail, const reports::TaskScope& scope) {
    Table table(say("What was measured"),
                {{say("Metric")}, {say("Value"), true}, {say("Unit")}, {say("Part")}});
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
    if (body.empty()) body << "<p class=\"muted\">" << say("None was kept.") << "</p>";
    return card(say("Metrics"), body);
}

Html remarks_card(const Visit& visit, int64_t attempt) {
    Html body;
    for (const db::CommentRecord& each : visit.store.reviews().comments(attempt)) {
        body << "<blockquote><p>" << (each.text.empty() ? say("(a mark)") : text(each.text))
             << "</p><footer>" << text(each.author_name);
        if (each.time_s >= 0)
            body << ", " << say("at %1", text(reports::minute_second(each.time_s)));
        body << ", " << day(each.at_utc) << "</footer></blockquote>";
    }
    if (body.empty()) body << "<p class=\"muted\">" << say("Nobody has remarked on it.") << "</p>";
    return card(say("Remarks"), body);
}

Html later_scores_card(const Visit& visit, int64_t attempt) {
    const auto rescores = visit.store.attempts().rescores(attempt);
    if (rescores.empty()) return {};
    Table table(say("Later scores; the first one never changes"),
                {{say("Scored on")}, {say("Points"), true}, {say("Result")}, {say("Rubric")}});
    for (const db::RescoreRecord& each : rescores)
        table.row({day(each.scored_utc), points(each.score.points), verdict(each.score.verdict),
                   text(each.score.rubric_id + " " + std::to_string(each.score.rubric_version))});
    return card(say("Later scores"), table.html());
}

}  // namespace

PageText attempt_page(const Visit& visit) {
    const int64_t id = visit.id();
    const db::AttemptDetail detail = visit.store.attempts().detail(id);
    const reports::TaskScope scope = scope_of_task(detail);
    Html body;
    Html score;
    score << "<strong>" << points(detail.record.points) << "</strong>";
    body << "<h1>" << say("Attempt #%1", text(id)) << "</h1>\n<p class=\"verdict\">"
         << say("%1 of 100 points", score) << " " << verdict_badge(detail.record) << "</p><p>"
         << counting(detail.record) << "</p>\n<p>"
         << link("/attempts/" + std::to_string(id) + "/review", say("Look at it in 3D")) << "</p>\n"
         << card(say("About it"), facts(visit, detail.record)) << reasons_card(detail.score)
         << ledger_card(detail, scope) << metrics_card(detail, scope) << remarks_card(visit, id)
         << later_scores_card(visit, id);
    return {say("Attempt %1", text(id)), body};
}

}  // namespace placode::web
