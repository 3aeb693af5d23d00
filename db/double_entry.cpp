// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Sheets of paper that were typed twice: where the entries differ, and who was right.

#include <map>
#include <set>
#include <utility>

#include "db/study_conduct.h"
#include "db/study_records.h"

namespace placode::db {
namespace {

/// Empty = not answered.
std::string given_to(const curriculum::Answers& answers, const std::string& item) {
    const auto found = answers.find(item);
    return found == answers.end() ? std::string() : found->second;
}

/// Every sheet of the study that was typed twice.
std::vector<std::pair<AnswerRecord, SecondEntry>> sheets_typed_twice(Store& store,
                                                                     const std::string& study_id) {
    std::map<int64_t, SecondEntry> second;
    for (SecondEntry& entry : store.records().second_entries(study_id))
        second[entry.answer_id] = std::move(entry);
    std::vector<std::pair<AnswerRecord, SecondEntry>> sheets;
    for (AnswerRecord& first : store.studies().answers(study_id))
        if (const auto found = second.find(first.id); found != second.end())
            sheets.emplace_back(std::move(first), std::move(found->second));
    return sheets;
}

/// The item, and all whose questions one of the entries hides and the other shows and that hang
/// together with it: only together does an entry stay valid. What both entries show is decided by
/// itself.
std::set<std::string> decided_together(const curriculum::Questionnaire& questionnaire,
                                       const curriculum::Answers& first,
                                       const curriculum::Answers& second, const std::string& item) {
    std::set<std::string> together{item};
    for (size_t before = 0; before != together.size();) {
        before = together.size();
        for (const curriculum::QuestionnaireItem& each : questionnaire.items) {
            if (!each.show_if || curriculum::is_shown(questionnaire, each, first) ==
                                     curriculum::is_shown(questionnaire, each, second))
                continue;
            if (!together.contains(each.id) && !together.contains(each.show_if->item)) continue;
            together.insert(each.id);
            together.insert(each.show_if->item);
        }
    }
    return together;
}

}  // namespace

std::vector<EntryDifference> entry_differences(Store& store, const std::string& study_id) {
    std::vector<EntryDifference> list;
    for (const auto& [first, second] : sheets_typed_twice(store, study_id)) {
        std::set<std::string> items;
        for (const auto& [item, unused] : first.answers) items.insert(item);
        for (const auto& [item, unused] : second.answers) items.insert(item);
        for (const std::string& item : items) {
            const std::string a = given_to(first.answers, item);
            const std::string b = given_to(second.answers, item);
            const auto x = curriculum::answer_number(a), y = curriculum::answer_number(b);
            if (a == b || (x && y && *x == *y)) continue;
            list.push_back({first.id, study_id, first.participant, first.questionnaire_id, item, a,
                            b, second.entered_by, first.visit, first.answered_utc});
        }
    }
    return list;
}

void decide_difference(Store& store, const EntryDifference& difference, int right,
                       const std::string& reason) {
    curriculum::Answers changes;
    for (const auto& [first, second] : sheets_typed_twice(store, difference.study_id)) {
        if (first.id != difference.answer_id) continue;
        const auto published = store.definitions().find("questionnaire", first.questionnaire_id,
                                                        first.questionnaire_version);
        if (!published) break;  // correct_answers() says so.
        const auto questionnaire = curriculum::load_questionnaire_text(
            published->json, "questionnaire " + first.questionnaire_id);
        for (const std::string& item :
             decided_together(questionnaire, first.answers, second.answers, difference.item))
            changes[item] = given_to(right == 1 ? first.answers : second.answers, item);
    }
    // What was on the screen when it was decided.
    changes[difference.item] = right == 1 ? difference.first : difference.second;
    store.records().correct_answers(difference.answer_id, right == 1 ? 2 : 1, changes,
                                    "double entry: " + reason);
}

}  // namespace placode::db
