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
#include "ui/web/parts.h"

namespace placode::web {
namespace {

/// The study of the address, which the store lists. Throws NotThere.
std::string study_of(const Visit& visit) {
    const auto ids = visit.store.studies().ids();
    if (visit.parts.empty() || std::find(ids.begin(), ids.end(), visit.parts[0]) == ids.end())
        throw NotThere(Web::plain_phrase("There is no such study."));
    return visit.parts[0];
}

std::string title_of(const Visit& visit, const std::string& study) {
    const auto protocol = db::published_study(visit.store, study);
    return protocol && !protocol->title.en.empty() ? in_words(protocol->title) : study;
}

Html head(const std::string& study, const std::string& title, const std::string& view) {
    const std::string path = "/studies/" + path_part(study);
    Html out;
    out << "<h1>" << text(title) << "</h1>\n"
        << views(Web::phrase("Study"), path + view,
                 {{path, Web::phrase("Flow and records")},
                  {path + "/entries", Web::phrase("Double entry and corrections")},
                  {path + "/deviations", Web::phrase("Deviations")}});
    return out;
}

using States = std::map<std::string, db::RecordState>;

/// Who signed is a name, and not shown here.
Html record_words(const States& states, const std::string& code) {
    const auto found = states.find(code);
    if (found == states.end() || !found->second.locked)
        return badge(Web::phrase("open@record"), Tone::kPlain);
    const db::RecordState& state = found->second;
    if (!state.signature) return badge(Web::phrase("locked@record"), Tone::kGood);
    Html out;
    if (state.signature_fits)
        out << badge(Web::phrase("locked and signed"), Tone::kGood);
    else
        out << badge(Web::phrase("CHANGED AFTER THE SIGNATURE"), Tone::kCritical);
    out << " " << day(state.signature->at_utc) << ", " << text(state.signature->remark);
    return out;
}

Html state_words(const db::Progress& progress) {
    if (progress.participant.withdrawal) return badge(Web::phrase("withdrew"), Tone::kWarn);
    if (progress.total > 0 && progress.next.empty())
        return badge(Web::phrase("complete"), Tone::kGood);
    Html out = badge(Web::phrase("under way"), Tone::kPlain);
    if (!progress.open_because.empty())
        out << " "
            << Web::phrase(
                   "to be done again: %1",
                   text(reports::not_done_words(progress.open_because, progress.open_meaning)));
    return out;
}

/// As the participant's version of the protocol has it.
std::string step_title(const reports::Protocols& protocols, const std::string& code,
                       const std::string& step) {
    if (step.empty()) return "–";
    const auto* protocol = protocols.of(code);
    const auto* known = protocol != nullptr ? protocol->step(step) : nullptr;
    return known != nullptr && !known->title.en.empty() ? in_words(known->title) : step;
}

reports::FlowWords flow_words() {
    return {Web::plain_phrase("enrolled"), Web::plain_phrase("withdrew, data not used or erased"),
            Web::plain_phrase("withdrew, data to date are used"), Web::plain_phrase("consented"),
            Web::plain_phrase("answers or attempts analysed")};
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
    list.add(Web::phrase("Participants"), text(progress.size()));
    list.add(
        Web::phrase("Complete@participants"),
        text(count([](const db::Progress& each) { return each.total > 0 && each.next.empty(); })));
    list.add(Web::phrase("Withdrew@participants"), text(count([](const db::Progress& each) {
                 return each.participant.withdrawal.has_value();
             })));
    list.add(Web::phrase("Locked@records"),
             text(in_state([](const db::RecordState& state) { return state.locked; })));
    list.add(
        Web::phrase("Signed@records"),
        text(in_state([](const db::RecordState& state) { return state.signature.has_value(); })));
    list.add(Web::phrase("Open differences"), text(differences));
    list.add(Web::phrase("Corrections"), text(corrections));
    return list.html();
}

Html records_card(const Visit& visit, const std::string& study,
                  const std::vector<db::Progress>& progress, const reports::StudyReport& report) {
    const auto& answers = report.data.answers;
    const Part part = part_of(visit, static_cast<int64_t>(progress.size()));
    Table table(Web::phrase("Records by code"), {{Web::phrase("Code")},
                                                 {Web::phrase("State")},
                                                 {Web::phrase("Steps"), true},
                                                 {Web::phrase("Next step")},
                                                 {Web::phrase("Answers"), true},
                                                 {Web::phrase("Record")},
                                                 {Web::phrase("Last step on")}});
    for (int64_t i = part.first; i < part.past; ++i) {
        const db::Progress& each = progress[static_cast<size_t>(i)];
        const std::string& code = each.participant.code;
        const auto sets = std::count_if(answers.begin(), answers.end(), [&](const auto& record) {
            return record.participant == code;
        });
        table.row(
            {text(code), state_words(each),
             each.total == 0 ? dash() : Web::phrase("%1 of %2", text(each.done), text(each.total)),
             text(step_title(report.protocols, code, each.next)), text(sets),
             record_words(report.record_states, code), day(each.last_utc)});
    }
    Html body;
    body << table.html() << pager(part, "/studies/" + path_part(study), {});
    return card(Web::phrase("Records"), body);
}

}  // namespace

PageText studies_page(const Visit& visit) {
    Html body;
    body << "<h1>" << Web::phrase("Studies") << "</h1>\n<section class=\"card\">";
    Table table(Web::phrase("Studies with participants or a published protocol"),
                {{Web::phrase("Study")}, {Web::phrase("Id")}, {Web::phrase("Participants"), true}});
    for (const std::string& id : visit.store.studies().ids())
        table.row({link("/studies/" + path_part(id), text(title_of(visit, id))), text(id),
                   text(visit.store.studies().participants(id).size())});
    if (table.empty())
        body << "<p class=\"muted\">" << Web::phrase("There is no study yet.") << "</p>";
    else
        body << table.html();
    body << "</section>\n";
    return {Web::phrase("Studies"), body};
}

PageText study_page(const Visit& visit) {
    const std::string study = study_of(visit);
    const std::string title = title_of(visit, study);
    Html body = head(study, title, "");
    const auto progress = db::study_progress(visit.store, study);
    if (progress.empty()) {
        body << "<p class=\"muted\">" << Web::phrase("Nobody takes part yet.") << "</p>";
        return {text(title), body};
    }
    const reports::StudyReport report = reports::read_study_report(visit.store, study);
    const size_t differences = db::entry_differences(visit.store, study).size();
    if (report.data.demonstration)
        body << "<p>" << badge(Web::phrase("DEMONSTRATION, simulated data"), Tone::kWarn) << "</p>";
    body << card(Web::phrase("At a glance"),
                 sums(progress, report.record_states, differences, report.corrections.size()));
    const reports::FlowNumbers flow = reports::flow_numbers(report, spoken_code());
    Html drawing = figure([&](const reports::ChartStyle& style) {
        reports::Figure drawn = reports::flow_figure(
            "flow", Web::plain_phrase("Flow of participants"), flow, style, flow_words());
        drawn.caption = Web::plain_phrase("Flow of participants.");
        return drawn;
    });
    const QString uncounted = reports::uncounted_words(reports::attempt_counts(report.data));
    if (!uncounted.isEmpty()) drawing << "<p>" << text(uncounted) << "</p>";
    body << card(Web::phrase("Flow"), drawing) << records_card(visit, study, progress, report);
    return {text(title), body};
}

PageText entries_page(const Visit& visit) {
    const std::string study = study_of(visit);
    const std::string title = title_of(visit, study);
    const auto differences = db::entry_differences(visit.store, study);
    const size_t entered = visit.store.records().second_entries(study).size();
    Html open;
    open << "<p>" << Web::count_phrase("%n sheet(s) was (were) typed a second time.", entered)
         << "</p>";
    const Part part = part_of(visit, static_cast<int64_t>(differences.size()));
    Table table(Web::count_phrase("%n open difference(s)", differences.size()),
                {{Web::phrase("Code")},
                 {Web::phrase("Questionnaire")},
                 {Web::phrase("Visit"), true},
                 {Web::phrase("Item")},
                 {Web::phrase("First entry")},
                 {Web::phrase("Second entry")}});
    const auto answer = [](const std::string& said) { return said.empty() ? dash() : text(said); };
    for (int64_t i = part.first; i < part.past; ++i) {
        const db::EntryDifference& each = differences[static_cast<size_t>(i)];
        table.row({text(each.participant), text(each.questionnaire_id), text(each.visit),
                   text(each.item), answer(each.first), answer(each.second)});
    }
    if (differences.empty())
        open << "<p>" << Web::phrase("There are no open differences.") << "</p>";
    else
        open << table.html() << pager(part, "/studies/" + path_part(study) + "/entries", {});
    Table changed(Web::phrase("Corrections, with the old answer"), {{Web::phrase("On")},
                                                                    {Web::phrase("Item")},
                                                                    {Web::phrase("Before")},
                                                                    {Web::phrase("After")},
                                                                    {Web::phrase("Reason")}});
    for (const db::Correction& each : visit.store.records().corrections(study))
        changed.row({day(each.at_utc), text(each.item), answer(each.old_answer),
                     answer(each.new_answer), text(each.reason)});
    Html body = head(study, title, "/entries");
    Html none;
    none << "<p class=\"muted\">" << Web::phrase("None.") << "</p>";
    body << card(Web::phrase("Double entry"), open)
         << card(Web::phrase("Corrections"), changed.empty() ? none : changed.html());
    return {Web::phrase("%1: double entry", text(title)), body};
}

PageText deviations_page(const Visit& visit) {
    const std::string study = study_of(visit);
    const std::string title = title_of(visit, study);
    const reports::Protocols protocols(visit.store, study,
                                       visit.store.studies().participants(study));
    const auto deviations = db::study_deviations(visit.store, study);
    const Part part = part_of(visit, static_cast<int64_t>(deviations.size()));
    Table table(Web::count_phrase("%n deviation(s) or note(s)", deviations.size()),
                {{Web::phrase("Code")},
                 {Web::phrase("Step")},
                 {Web::phrase("Kind")},
                 {Web::phrase("What")},
                 {Web::phrase("On")}});
    for (int64_t i = part.first; i < part.past; ++i) {
        const db::Deviation& each = deviations[static_cast<size_t>(i)];
        Html step = text(step_title(protocols, each.participant, each.step));
        if (each.visit > 1) step << ", " << Web::phrase("visit %1", text(each.visit));
        table.row({text(each.participant), step, text(reports::deviation_title(each.kind)),
                   text(reports::deviation_words(each)), day(each.at_utc)});
    }
    Html body = head(study, title, "/deviations");
    Html list;
    if (deviations.empty())
        list << "<p>" << Web::phrase("All went as the protocol says.") << "</p>";
    else
        list << table.html() << pager(part, "/studies/" + path_part(study) + "/deviations", {});
    list
        << "<p class=\"small\">"
        << Web::phrase(
               "Nobody writes these down: they follow from steps, attempts and the events of their "
               "recordings. Notes are the coordinator's.")
        << "</p>";
    body << card(Web::phrase("Deviations"), list);
    return {Web::phrase("%1: deviations", text(title)), body};
}

}  // namespace placode::web
