// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// An attempt in three dimensions: the page, and the track that its script fetches part by part. Who
// may see the attempt may see this; each request asks the store anew.

#include <QTemporaryDir>
#include <charconv>
#include <stdexcept>

#include "db/recording_file.h"
#include "reports/text.h"
#include "reports/words.h"
#include "ui/web/attempt_parts.h"
#include "ui/web/parts.h"
#include "ui/web/review_maker.h"

namespace placode::web {

using namespace std::string_view_literals;

namespace {

constexpr int kAskAgainS = 2;
constexpr double kLongestS = 3600;  // A track of an hour would take some 100 MB.

std::string key_of(const db::AttemptRecord& record) {
    // A store that was restored may have another attempt under the number.
    return std::to_string(record.id) + " of " + record.started_utc + " seed " +
           std::to_string(record.seed);
}

sim::Recording recording_of(const Visit& visit, int64_t attempt) {
    // For this account only, and gone at the end; of the service in a /tmp of its own.
    const QTemporaryDir folder;
    if (!folder.isValid())
        throw std::runtime_error("no temporary folder: " + folder.errorString().toStdString());
    const std::string file = folder.filePath(QStringLiteral("a.placode")).toStdString();
    visit.store.attempts().extract_recording(attempt, file);
    return db::read_recording_file(file);
}

std::string address_of_attempt(int64_t id) { return "/attempts/" + std::to_string(id); }

Html back(int64_t id) {
    Html out;
    out << "<p>" << link(address_of_attempt(id), Web::phrase("Back to the attempt")) << "</p>\n";
    return out;
}

PageText short_page(int64_t id, const Text& words) {
    Html body;
    body << "<h1>" << Web::phrase("Review of attempt #%1", text(id)) << "</h1>\n<p>" << words
         << "</p>\n"
         << back(id);
    return {Web::phrase("Review of attempt %1", text(id)), body};
}

PageText waiting_page(int64_t id, const ReviewMaker::Standing& standing) {
    const int percent = static_cast<int>(100 * standing.share);
    Html body;
    body << "<h1>" << Web::phrase("Review of attempt #%1", text(id))
         << "</h1>\n<p role=\"status\">";
    if (standing.stage == ReviewMaker::Stage::kMaking ||
        standing.stage == ReviewMaker::Stage::kReading)
        body << Web::phrase("The recording is being simulated again: %1 %.", text(percent));
    else if (standing.stage == ReviewMaker::Stage::kWaiting)
        body << Web::phrase("Another recording is being simulated first.");
    else
        body << Web::phrase(
            "Several recordings wait to be simulated. This page asks again by itself.");
    body << "</p>\n<p><progress max=\"100\" value=\"" << text(percent) << "\" aria-label=\""
         << Web::phrase("Simulated") << "\"></progress></p>\n<p class=\"muted\">"
         << Web::phrase("It takes about as long as the attempt, once. The page shows it by itself.")
         << "</p>\n"
         << back(id);
    PageText page{Web::phrase("Review of attempt %1", text(id)), body};
    page.ask_again_s = kAskAgainS;
    return page;
}

Html choice_of(std::string_view id, const Text& label,
               const std::vector<std::pair<std::string, Text>>& values) {
    Html out;
    out << "<div><label for=\"" << text(id) << "\">" << label << "</label><select id=\"" << text(id)
        << "\">";
    for (const auto& [value, words] : values)
        out << "<option value=\"" << text(value) << "\">" << words << "</option>";
    out << "</select></div>";
    return out;
}

/// Canvas and controls; what the script says stands in attributes, in the reader's language.
Html viewer(int64_t id) {
    Html out;
    out << "<div id=\"review\" class=\"review\" data-track=\""
        << text(address_of_attempt(id) + "/review/track") << "\" data-part=\""
        << text(address_of_attempt(id) + "/review/parts/") << "\" data-play=\""
        << Web::phrase("Play") << "\" data-pause=\"" << Web::phrase("Pause") << "\" data-lost=\""
        << Web::phrase(
               "The track is not in memory any more, or you are signed out. Load the page again.")
        << "\" data-old=\""
        << Web::phrase("This browser cannot show it: it needs WebGL 2 and DecompressionStream.")
        << "\">\n<p id=\"review-said\" class=\"said\" role=\"alert\" hidden></p>\n"
        << "<canvas id=\"review-picture\" tabindex=\"0\" aria-label=\""
        << Web::phrase(
               "Picture of the attempt. Arrow keys turn it, plus and minus bring it nearer.")
        << "\"></canvas>\n<div class=\"line\"><button type=\"button\" id=\"review-play\">"
        << Web::phrase("Play")
        << "</button><input type=\"range\" id=\"review-time\" min=\"0\" max=\"1\" "
        << "value=\"0\" step=\"0.1\" aria-label=\"" << Web::phrase("Time in the attempt")
        << "\"><output id=\"review-clock\" for=\"review-time\">0:00</output></div>\n"
        << "<div class=\"choices\">"
        << choice_of("review-camera"sv, Web::phrase("Camera"),
                     {{"scope", Web::phrase("As the fetoscope saw it")},
                      {"above", Web::phrase("From above")},
                      {"side", Web::phrase("From the side")},
                      {"free", Web::phrase("Free: drag to turn, wheel to come nearer")}})
        << choice_of("review-speed"sv, Web::phrase("Speed"),
                     {{"0.25", text("0.25"sv)},
                      {"0.5", text("0.5"sv)},
                      {"1", text("1"sv)},
                      {"2", text("2"sv)},
                      {"4", text("4"sv)},
                      {"8", text("8"sv)}})
        << "</div>\n<noscript><p>" << Web::phrase("The picture needs JavaScript.")
        << "</p></noscript></div>\n<script type=\"module\" src=\"/review/page.js\"></script>\n";
    return out;
}

Html moment_button(double time_s) {
    Html out;
    out << "<button type=\"button\" class=\"moment\" data-time=\""
        << text(std::to_string(static_cast<int64_t>(1000 * time_s))) << "\">"
        << text(reports::minute_second(time_s)) << "</button>";
    return out;
}

/// What happened and what was remarked, each with a button that leads there.
Html moments_card(const Visit& visit, const db::AttemptDetail& detail) {
    Table table(Web::phrase("Moments; a click leads there"),
                {{Web::phrase("At@time")}, {Web::phrase("What")}});
    for (const auto& entry : ledger_of(detail, scope_of_task(detail)).entries)
        table.row({moment_button(entry.from_s), entry_words(entry)});
    for (const assessment::Reason& each : detail.score.reasons)
        if (each.time_s >= 0)
            table.row({moment_button(each.time_s), text(reports::reason_words(each))});
    for (const db::CommentRecord& each : visit.store.reviews().comments(detail.record.id))
        if (each.time_s >= 0)
            table.row({moment_button(each.time_s),
                       Html(each.text.empty() ? Web::phrase("(a mark)") : text(each.text))
                           << text(" – "sv) << text(each.author_name)});
    Html body;
    if (table.empty())
        body << "<p class=\"muted\">" << Web::phrase("Nothing was noted.") << "</p>";
    else
        body << table.html();
    return card(Web::phrase("Moments"), body);
}

PageText ready_page(const Visit& visit, const db::AttemptDetail& detail,
                    const reports::ReviewTrack& track) {
    const int64_t id = detail.record.id;
    Html proof;
    if (track.identical)
        proof << badge(Web::phrase("the same"), Tone::kGood) << " "
              << Web::phrase(
                     "Simulated again from its recording: every recorded state came out the same.");
    else
        proof
            << badge(Web::phrase("differs"), Tone::kCritical) << " "
            << Web::phrase(
                   "Simulated again from its recording, it differs from %1 on. What is shown ends "
                   "there. Another version of the program may be the cause.",
                   text(reports::minute_second(track.until_s)));
    Html body;
    body << "<h1>" << Web::phrase("Review of attempt #%1", text(id)) << "</h1>\n<p>"
         << text(visit.tasks.of(detail.record.task_id).title);
    if (detail.record.demonstration) body << " " << demonstration_badge();
    body << "</p>\n<p>" << proof << "</p>\n"
         << viewer(id) << "<p class=\"muted\">"
         << Web::phrase(
                "Shapes, burns, cuts and instruments are those of the simulation; colours are "
                "plain. Blue: planned line, yellow: tissue to be taken out, until it is cut there.")
         << "</p>\n"
         << moments_card(visit, detail) << back(id);
    PageText page{Web::phrase("Review of attempt %1", text(id)), body};
    page.script = true;
    return page;
}

/// Throws NotThere where the page was never opened, or its track has gone since.
std::shared_ptr<const reports::ReviewTrack> made_track(const Visit& visit) {
    const db::AttemptDetail detail = visit.store.attempts().detail(visit.id());
    const auto standing = visit.reviews.of(key_of(detail.record));
    if (standing.stage != ReviewMaker::Stage::kReady)
        throw NotThere(Web::plain_phrase("There is no such page."));
    return standing.track;
}

}  // namespace

PageText review_page(const Visit& visit) {
    const int64_t id = visit.id();
    const db::AttemptDetail detail = visit.store.attempts().detail(id);
    if (detail.record.duration_s > kLongestS)
        return short_page(
            id, Web::phrase("The attempt is longer than an hour; look at it in the program "
                            "on the station."));
    ReviewMaker::Standing standing;
    try {
        standing =
            visit.reviews.ask(key_of(detail.record), [&] { return recording_of(visit, id); });
    } catch (const db::StoreError& error) {
        if (error.kind() != db::StoreError::Kind::kNotFound) throw;
        return short_page(id, Web::phrase("The attempt was kept without its recording."));
    }
    if (standing.stage == ReviewMaker::Stage::kFailed)
        return short_page(id,
                          Web::phrase("The recording cannot be simulated by this version of the "
                                      "program."));
    if (standing.stage != ReviewMaker::Stage::kReady) return waiting_page(id, standing);
    return ready_page(visit, detail, *standing.track);
}

Answer review_track(const Visit& visit) {
    Answer answer;
    answer.type = "application/json";
    answer.body = made_track(visit)->head;
    return answer;
}

Answer review_part(const Visit& visit) {
    const auto track = made_track(visit);
    const std::string& number = visit.parts.at(1);
    size_t part = 0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), part);
    if (error != std::errc{} || end != number.data() + number.size() || part >= track->parts.size())
        throw NotThere(Web::plain_phrase("There is no such page."));
    Answer answer;
    answer.type = "application/octet-stream";
    answer.body = track->parts[part];
    return answer;
}

}  // namespace placode::web
