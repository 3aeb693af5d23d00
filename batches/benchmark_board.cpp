// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numeric>

#include "batches/batch_error.h"
#include "batches/benchmark.h"
#include "sim/core/number_text.h"

namespace placode::batches {
namespace {

/// In a cell of a table.
std::string cell(std::string text) {
    for (char& c : text)
        if (c == '|' || c == '\n' || c == '<' || c == '>') c = ' ';
    return text;
}

std::string task_cell(const Json& entry, const std::string& task) {
    for (const Json& one : entry.at("tasks"))
        if (one.at("task") == task)
            return sim::fixed_text(one.at("points").get<double>(), 1) + " (" +
                   std::to_string(one.at("passed").get<int>()) + "/" +
                   std::to_string(one.at("attempts").get<int>()) + ")";
    return "-";
}

std::string state_cell(const EntryCheck& check) {
    if (!check.problems.empty()) return "refuted";
    return check.replayed ? "replayed" : "not replayed";
}

using Is = bool (Json::*)() const noexcept;

/// The first key that the board needs and `in` has not, or of another type; nullptr: none.
const char* wrong_key(const Json& in, std::initializer_list<std::pair<const char*, Is>> needed) {
    for (const auto& [key, is] : needed)
        if (!in.is_object() || !in.contains(key) || !(in.at(key).*is)()) return key;
    return nullptr;
}

}  // namespace

Json read_board_entry(const std::filesystem::path& entry_json) {
    Json entry = read_entry(entry_json);
    const auto need = [&](const std::string& place, const char* wrong) {
        if (wrong != nullptr)
            throw BatchError(BatchError::Kind::kBadInput,
                             entry_json.string() + ": " + place + wrong +
                                 " is missing or of another type; expected an entry.json of "
                                 "`placodectl bench tasks`");
    };
    need("/", wrong_key(entry, {{"name", &Json::is_string},
                                {"score", &Json::is_number},
                                {"complete", &Json::is_boolean},
                                {"held_out_seeds", &Json::is_boolean},
                                {"seeds", &Json::is_array},
                                {"build", &Json::is_string},
                                {"tasks", &Json::is_array}}));
    for (size_t i = 0; i < entry.at("tasks").size(); ++i)
        need("/tasks/" + std::to_string(i) + "/",
             wrong_key(entry.at("tasks")[i], {{"task", &Json::is_string},
                                              {"points", &Json::is_number},
                                              {"passed", &Json::is_number_integer},
                                              {"attempts", &Json::is_number_integer}}));
    return entry;
}

std::string board_text(const Protocol& protocol, const std::vector<Json>& entries,
                       const std::vector<EntryCheck>& checks) {
    std::vector<size_t> order(entries.size());
    std::iota(order.begin(), order.end(), size_t{0});
    const auto key = [&](size_t i) {
        const Json& entry = entries[i];
        return std::tuple(!checks[i].problems.empty(), !entry.at("complete").get<bool>(),
                          entry.at("held_out_seeds").get<bool>(), -entry.at("score").get<double>());
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](size_t a, size_t b) { return key(a) < key(b); });
    std::string text = "# " + protocol.id + " version " + std::to_string(protocol.version) +
                       "\n\nMean points of 100 by the tasks' own rubrics, and in brackets how many "
                       "attempts passed. Entries with held-out seeds, or of some tasks only, have "
                       "no rank.\n\n| rank | operator | score |";
    for (const BenchmarkTask& one : protocol.tasks) text += " " + one.task + " |";
    text += " seeds | checked | build |\n|---|---|---|";
    for (size_t i = 0; i < protocol.tasks.size() + 3; ++i) text += "---|";
    text += "\n";
    int rank = 0;
    for (const size_t i : order) {
        const Json& entry = entries[i];
        const bool ranked = checks[i].problems.empty() && entry.at("complete").get<bool>() &&
                            !entry.at("held_out_seeds").get<bool>();
        text += "| " + (ranked ? std::to_string(++rank) : std::string("-")) + " | " +
                cell(entry.at("name").get<std::string>()) + " | " +
                sim::fixed_text(entry.at("score").get<double>(), 1) + " |";
        for (const BenchmarkTask& one : protocol.tasks)
            text += " " + task_cell(entry, one.task) + " |";
        text += entry.at("held_out_seeds").get<bool>() ? " held out" : " published";
        text += " (" + std::to_string(entry.at("seeds").size()) + ") | " + state_cell(checks[i]) +
                " | " + cell(entry.at("build").get<std::string>()) + " |\n";
    }
    return text + "\nProtocol " + protocol.sha256.substr(0, 16) +
           ". `placodectl bench tasks --verify ENTRY/entry.json` replays an entry.\n";
}

}  // namespace placode::batches
