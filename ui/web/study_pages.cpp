// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The monitor of a study, by codes and without names: how far everybody is, what is complete,
// where two entries from paper differ, what did not go as the protocol says, what is locked.

#include <algorithm>

#include "db/study_conduct.h"
#include "db/study_deviations.h"
#include "reports/attempt_counts.h"
#include "reports/study_report.h"
#include "reports/words.h"
#include "sim/core/counted.h"
#include "ui/web/parts.h"

namespace placode::web {
namespace {

/// The study of the address, which the store lists. Throws NotThere.
std::string study_of(const Visit& visit) {
    const auto ids = visit.store.studies().ids();
    if (visit.parts.empty() || std::find(ids.begin(), ids.end(), visit.parts[0]) == ids.end())
        throw NotThere("There is no such study.");
    return visit.parts[0];
}

std::string title_of(const Visit& visit, const std::string& study) {
    const auto protocol = db::published_study(visit.store, study);
    return protocol && !protocol->title.en.empty() ? protocol->title.en : study;
}

Html head(const std::string& study, const std::string& title, const std::string& view) {
    const std::string path = "/studies/" + path_part(study);
    Html out;
    out << "<h1>" << text(title) << "</h1>\n"
        << views("Study", path + view,
                 {{path, "Flow and records"},
                  {path + "/entries", "Double entry and corrections"},
                  {path + "/deviations", "Deviations"}});
    return out;
}

using States = std::map<std::string, db::RecordState>;

/// Who signed is a name, and not shown here.
Html record_words(const States& states, const std::string& code) {
    const auto found = states.find(code);
    if (found == states.end() || !found->second.locked) return badge(Html("open"), "");
    const db::RecordState& state = found->second;
    if (!state.signature) return badge(Html("locked"), "good");
    Html out;
    if (state.signature_fits)
        out << badge(Html("locked and signed"), "good");
    else
        out << badge(Html("CHANGED AFTER THE SIGNATURE"), "critical");
    out << " " << day(state.signature->at_utc) << ", " << text(state.signature->remark);
    return out;
}

Html state_words(const db::Progress& progress) {
    if (progress.participant.withdrawal) return badge(Html("withdrew"), "warn");
    if (progress.total > 0 && progress.next.empty()) return badge(Html("complete"), "good");
    Html out = badge(Html("under way"), "");
    if (!progress.open_because.empty())
        out << " to be done again: " << text(reports::not_done_words(progress.open_because));
    return out;
}

std::string step_title(const std::optional<curriculum::StudyProtocol>& protocol,
                       const std::string& step) {
    if (step.empty()) return "–";
    const auto* known = protocol ? protocol->step(step) : nullptr;
    return known != nullptr && !known->title.en.empty() ? known->title.en : step;
}

Html sums(const std::vector<db::Progress>& progress, const States& states, size_t differences,
          size_t corrections) {
    const auto count = [&](auto&& wanted) {
        return std::count_if(progress.begin(), progress.end(), wanted);
    };
    const auto in_state = [&](auto&& wanted) {
        return count([&](const db::Progress& each) {
            const auto found = states.find(each.participant.code);
            return found != states.end() && wanted(found->second);
        });
    };
    Facts list;
    list.add(Html("Participants"), text(progress.size()));
    list.add(
        Html("Complete"),
        text(count([](const db::Progress& each) { return each.total > 0 && each.next.empty(); })));
    list.add(Html("Withdrew"), text(count([](const db::Progress& each) {
                 return each.participant.withdrawal.has_value();
             })));
    list.add(Html("Locked"),
             text(in_state([](const db::RecordState& state) { return state.locked; })));
    list.add(
        Html("Signed"),
        text(in_state([](const db::RecordState& state) { return state.signature.has_value(); })));
    list.add(Html("Open differences"), text(differences));
    list.add(Html("Corrections"), text(corrections));
    return list.html();
}

Html records_card(const Visit& visit, const std::string& study,
                  const std::vector<db::Progress>& progress, const States& states,
                  const std::vector<db::AnswerRecord>& answers) {
    const auto protocol = db::published_study(visit.store, study);
    const Part part = part_of(visit, static_cast<int64_t>(progress.size()));
    Table table("Records by code", {{"Code"},
                                    {"State"},
                                    {"Steps", true},
                                    {"Next step"},
                                    {"Answers", true},
                                    {"Record"},
                                    {"Last step on"}});
    for (int64_t i = part.first; i < part.past; ++i) {
        const db::Progress& each = progress[static_cast<size_t>(i)];
        const std::string& code = each.participant.code;
        const auto sets = std::count_if(answers.begin(), answers.end(), [&](const auto& record) {
            return record.participant == code;
        });
        table.row({text(code), state_words(each),
                   each.total == 0
                       ? text("–")
                       : text(std::to_string(each.done) + " of " + std::to_string(each.total)),
                   text(step_title(protocol, each.next)), text(sets), record_words(states, code),
                   day(each.last_utc)});
    }
    Html body;
    body << table.html() << pager(part, "/studies/" + path_part(study), {});
    return card(Html("Records"), body);
}

}  // namespace

PageText studies_page(const Visit& visit) {
    Html body;
    body << "<h1>Studies</h1>\n<section class=\"card\">";
    Table table("Studies with participants or a published protocol",
                {{"Study"}, {"Id"}, {"Participants", true}});
    for (const std::string& id : visit.store.studies().ids())
        table.row({link("/studies/" + path_part(id), text(title_of(visit, id))), text(id),
                   text(visit.store.studies().participants(id).size())});
    if (table.empty())
        body << "<p class=\"muted\">There is no study yet.</p>";
    else
        body << table.html();
    body << "</section>\n";
    return {"Studies", body};
}

PageText study_page(const Visit& visit) {
    const std::string study = study_of(visit);
    const std::string title = title_of(visit, study);
    Html body = head(study, title, "");
    const auto progress = db::study_progress(visit.store, study);
    if (progress.empty()) {
        body << "<p class=\"muted\">Nobody takes part yet.</p>";
        return {title, body};
    }
    const reports::StudyReport report = reports::read_study_report(visit.store, study);
    const size_t differences = db::entry_differences(visit.store, study).size();
    if (report.data.demonstration)
        body << "<p>" << badge(Html("DEMONSTRATION, simulated data"), "warn") << "</p>";
    body << card(Html("At a glance"),
                 sums(progress, report.record_states, differences, report.corrections.size()));
    const reports::FlowNumbers flow = reports::flow_numbers(report);
    Html drawing = figure([&](const reports::ChartStyle& style) {
        return reports::flow_figure("flow", "Flow of participants", flow, style);
    });
    const QString uncounted = reports::uncounted_words(reports::attempt_counts(report.data));
    if (!uncounted.isEmpty()) drawing << "<p>" << text(uncounted) << "</p>";
    body << card(Html("Flow"), drawing)
         << records_card(visit, study, progress, report.record_states, report.data.answers);
    return {title, body};
}

PageText entries_page(const Visit& visit) {
    const std::string study = study_of(visit);
    const std::string title = title_of(visit, study);
    const auto differences = db::entry_differences(visit.store, study);
    const size_t entered = visit.store.records().second_entries(study).size();
    Html open;
    open << "<p>" << text(sim::counted(entered, "sheet was", "sheets were"))
         << " typed a second time.</p>";
    const Part part = part_of(visit, static_cast<int64_t>(differences.size()));
    Table table(sim::counted(differences.size(), "open difference"),
                {{"Code"}, {"Questionnaire"}, {"Item"}, {"First entry"}, {"Second entry"}});
    const auto answer = [](const std::string& words) { return text(words.empty() ? "–" : words); };
    for (int64_t i = part.first; i < part.past; ++i) {
        const db::EntryDifference& each = differences[static_cast<size_t>(i)];
        table.row({text(each.participant), text(each.questionnaire_id), text(each.item),
                   answer(each.first), answer(each.second)});
    }
    if (differences.empty())
        open << "<p>There are no open differences.</p>";
    else
        open << table.html() << pager(part, "/studies/" + path_part(study) + "/entries", {});
    Table changed("Corrections, with the old answer",
                  {{"On"}, {"Item"}, {"Before"}, {"After"}, {"Reason"}});
    for (const db::Correction& each : visit.store.records().corrections(study))
        changed.row({day(each.at_utc), text(each.item), answer(each.old_answer),
                     answer(each.new_answer), text(each.reason)});
    Html body = head(study, title, "/entries");
    body << card(Html("Double entry"), open)
         << card(Html("Corrections"),
                 changed.empty() ? Html("<p class=\"muted\">None.</p>") : changed.html());
    return {title + ": double entry", body};
}

PageText deviations_page(const Visit& visit) {
    const std::string study = study_of(visit);
    const std::string title = title_of(visit, study);
    const auto protocol = db::published_study(visit.store, study);
    const auto deviations = db::study_deviations(visit.store, study);
    const Part part = part_of(visit, static_cast<int64_t>(deviations.size()));
    Table table(sim::counted(deviations.size(), "deviation or note", "deviations and notes"),
                {{"Code"}, {"Step"}, {"Kind"}, {"What"}, {"On"}});
    for (int64_t i = part.first; i < part.past; ++i) {
        const db::Deviation& each = deviations[static_cast<size_t>(i)];
        Html step = text(step_title(protocol, each.step));
        if (each.visit > 1) step << ", visit " << text(each.visit);
        table.row({text(each.participant), step, text(reports::deviation_title(each.kind)),
                   text(reports::deviation_words(each)), day(each.at_utc)});
    }
    Html body = head(study, title, "/deviations");
    body << "<section class=\"card\"><h2>Deviations</h2>";
    if (deviations.empty())
        body << "<p>All went as the protocol says.</p>";
    else
        body << table.html() << pager(part, "/studies/" + path_part(study) + "/deviations", {});
    body << "<p class=\"small\">Nobody writes these down: they follow from steps, attempts and the "
            "events of their recordings. Notes are the coordinator's.</p></section>\n";
    return {title + ": deviations", body};
}

}  // namespace placode::web
