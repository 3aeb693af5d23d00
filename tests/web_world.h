// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A store in which every page of the portal has something to show, and what a page says to who
// reads it or has it read out.

#include <QByteArray>
#include <QString>
#include <algorithm>
#include <set>

#include "curriculum/utc_time.h"
#include "db/norm_bands.h"
#include "db/standards.h"
#include "db/study_conduct.h"
#include "tests/web_fixture.h"

namespace placode::test {

inline constexpr const char* kPublished = "face_content_validity";

inline db::AttemptResult attempt_of(double points, assessment::Verdict verdict, int day) {
    db::AttemptResult result = make_result();
    result.header.device = "mouse";
    result.header.demonstration = false;
    result.header.started_utc = curriculum::utc_text(1'767'000'000 + 86400 * int64_t{day});
    result.end = {sim::EndReason::kFinished, 95.5, 1, 0};
    result.metrics.version = 2;
    result.metrics.values = {{"task_time_s", 95.5 + points / 100},
                             {"placode_contacts", 1},
                             {"path_length_mm", 812.25},
                             {"peak_force_mn", 41.5}};
    result.score.points = points;
    result.score.verdict = verdict;
    return result;
}

/// A pack of five people, in use.
inline int64_t add_norms(db::Store& store) {
    std::vector<int64_t> experts;
    for (int i = 0; i < 5; ++i) {
        experts.push_back(store.accounts().create(trainee("expert-" + std::to_string(i))));
        for (const double jitter : {-0.5, 0.5})
            (void)store.attempts().save(
                experts.back(), attempt_of(80 + 2 * i + jitter, assessment::Verdict::kPassed, i));
    }
    for (const int64_t expert : experts)
        for (const db::AttemptRecord& each : store.attempts().list(expert))
            store.attempts().set_replay(each.id, db::ReplayState::kIdentical);
    const int64_t id = db::keep_own_norms(
        store,
        db::make_norms(db::level_attempts(store, "diathermy_ring", {{"expert", experts}}),
                       "Szpital", "2026-01-20", 5),
        kPassphrase);
    store.norms().use(id);
    return id;
}

/// Second entry, correction, signature and a published study with somebody in it.
inline void add_study_work(db::Store& store, const RightsWorld& people) {
    db::SecondEntry entry;
    entry.answer_id = people.answers;
    for (const auto& each : curriculum::load_questionnaire("sus").items)
        entry.answers[each.id] = "3";
    store.records().save_second_entry(entry);
    store.records().correct_answers(people.answers, 1, {{people.item, "2"}}, "pomyłka");
    store.records().sign(RightsWorld::kStudy, people.locked, "coordinator", kPassword,
                         "sprawdzono");
    const auto shipped = curriculum::load_study(kPublished);
    db::DefinitionRecord study;
    study.kind = "study";
    study.id = kPublished;
    study.json = shipped.json;
    study.version = shipped.version;
    store.definitions().publish(study);
    (void)store.studies().new_participant(kPublished);
    store.studies().withdraw(kPublished, store.studies().new_participant(kPublished),
                             db::WithdrawalMode::kKeep, "nie podano");
}

/// More than RightsWorld has: lists of several pages, somebody stuck, norms, a standard, a study.
inline void fill_for_pages(db::Store& store, const RightsWorld& people) {
    const int64_t stuck = people.of.at("grouped").person;
    for (int i = 0; i < 30; ++i) {
        db::AttemptResult result = attempt_of(40.25, assessment::Verdict::kNotYet, i);
        if (i % 7 == 0) result.end.reason = sim::EndReason::kInterrupted;
        (void)store.attempts().save(stuck, result);
    }
    (void)store.attempts().save(people.of.at("trainee").person,
                                attempt_of(33.5, assessment::Verdict::kFailed, 3));
    for (int i = 0; i < 30; ++i)
        (void)store.accounts().create(trainee("konto-" + std::to_string(i)));
    (void)add_norms(store);
    curriculum::PassStandard standard =
        db::standard_of_groups("diathermy_ring", {40, 45, 50, 48}, {80, 84, 88, 82}, 1);
    db::set_standard(store, standard, "");
    add_study_work(store, people);
}

inline std::string without_entities(const std::string& text) {
    return QString::fromStdString(text)
        .replace("&lt;", "<")
        .replace("&gt;", ">")
        .replace("&quot;", "\"")
        .replace("&#39;", "'")
        .replace("&amp;", "&")
        .trimmed()
        .toStdString();
}

/// Texts between tags, attributes that are read out, and the same of the pictures within.
inline void read_page(const std::string& page, std::vector<std::string>& said) {
    const auto add = [&](const std::string& text) {
        const std::string plain = without_entities(text);
        if (!plain.empty()) said.push_back(plain);
    };
    for (size_t at = 0; at < page.size();) {
        const size_t open = std::min(page.find('<', at), page.size());
        add(page.substr(at, open - at));
        const size_t close = std::min(page.find('>', open), page.size());
        const std::string tag = page.substr(open, close - open);
        for (const std::string name : {" aria-label=\"", " alt=\"", " title=\"", " placeholder=\""})
            if (const size_t found = tag.find(name); found != std::string::npos) {
                const size_t begin = found + name.size();
                add(tag.substr(begin, tag.find('"', begin) - begin));
            }
        const std::string picture = " src=\"data:image/svg+xml;base64,";
        if (const size_t found = tag.find(picture); found != std::string::npos) {
            const size_t begin = found + picture.size();
            read_page(QByteArray::fromBase64(QByteArray::fromStdString(
                                                 tag.substr(begin, tag.find('"', begin) - begin)))
                          .toStdString(),
                      said);
        }
        at = close + 1;
    }
}

inline std::vector<std::string> said_by(const Seen& seen) {
    std::vector<std::string> said;
    read_page(seen.body, said);
    return said;
}

inline std::string_view without_meaning(std::string_view english) {
    return english.substr(0, english.find('@'));
}

/// The longest piece of a text between its places.
inline std::string longest_piece(std::string_view text) {
    std::string longest;
    for (size_t at = 0; at < text.size();) {
        const size_t end = std::min(text.find('%', at), text.size());
        if (end - at > longest.size()) longest = text.substr(at, end - at);
        at = end + 2;
    }
    return longest;
}

/// What stands in one language and must not in a page of the other.
struct Foreign {
    std::set<std::string> whole;  ///< As a whole text.
    std::set<std::string> piece;  ///< Anywhere: several words.

    void add(std::string_view text, const std::set<std::string>& own) {
        if (text.find('%') == std::string_view::npos) {
            if (!own.contains(std::string(text))) whole.emplace(text);
            if (std::count(text.begin(), text.end(), ' ') >= 3) piece.emplace(text);
            return;
        }
        const std::string longest = longest_piece(text);
        // " do ", ", n " and their like say nothing.
        if (longest.size() >= 9) piece.insert(longest);
    }
    /// The first of them in what a page says.
    [[nodiscard]] std::string found_in(const std::vector<std::string>& said) const {
        for (const std::string& text : said) {
            if (whole.contains(text)) return text;
            for (const std::string& each : piece)
                if (text.find(each) != std::string::npos) return each + " in: " + text;
        }
        return {};
    }
};

}  // namespace placode::test
