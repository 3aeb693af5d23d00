// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/json_reader.h"

#include <algorithm>
#include <fstream>
#include <functional>
#include <set>
#include <vector>

#include "sim/core/near_word.h"
#include "sim/core/text_file.h"

namespace placode::curriculum {

namespace fs = std::filesystem;

namespace {

/// "line 3, column 14" of a byte offset, both from 1.
std::string place_of(const std::string& text, size_t byte) {
    const size_t end = std::min(byte == 0 ? 0 : byte - 1, text.size());
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<long>(end), '\n');
    const size_t start = text.rfind('\n', end == 0 ? 0 : end - 1);
    const size_t column = start == std::string::npos || line == 1 ? end + 1 : end - start;
    return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

}  // namespace

std::string read_definition(const fs::path& file) {
    std::error_code error;
    if (fs::is_directory(file, error))
        throw DefinitionError(file.string(), "", "is a folder; expected a JSON file");
    // A pipe that nobody writes into would keep us waiting for ever. /dev/stdin may be one.
    if (fs::is_fifo(file, error) && !file.string().starts_with("/dev/"))
        throw DefinitionError(file.string(), "", "is a pipe; expected a JSON file");
    std::ifstream in(file, std::ios::binary);
    if (!in) throw DefinitionError(file.string(), "", "cannot be opened; check path and rights");
    auto text = sim::read_at_most(in, sim::kLargestText);
    if (!text)
        throw DefinitionError(file.string(), "", "is larger than 64 MB; expected at most that");
    return std::move(*text);
}

fs::path find_definition(const std::string& kind, const std::string& id_or_file) {
    const bool is_path = id_or_file.find('/') != std::string::npos ||
                         (id_or_file.size() > 5 && id_or_file.ends_with(".json"));
    if (is_path) return id_or_file;
    const std::vector<std::string> known = list_definitions(kind);
    if (std::find(known.begin(), known.end(), id_or_file) != known.end())
        return data_folder() / kind / (id_or_file + ".json");
    std::string list;
    for (const std::string& id : known) list += (list.empty() ? "" : ", ") + id;
    throw DefinitionError((data_folder() / kind).string(), "",
                          "no definition \"" + id_or_file +
                              "\"; expected one of: " + (list.empty() ? "(none installed)" : list) +
                              ", or the path of a .json file" +
                              sim::did_you_mean(id_or_file, known));
}

namespace {

constexpr int kDeepest = 64;  // levels; nothing of ours has ten

/// Refuses what the library takes: a key that stands twice (its last value would win unseen), and
/// levels without end (which would end the program when they are taken apart).
class Strictness {
 public:
    explicit Strictness(const std::string& origin) : origin_(origin) {}

    bool operator()(int depth, Json::parse_event_t event, const Json& value) {
        if (depth > kDeepest)
            throw DefinitionError(origin_, "",
                                  "more than " + std::to_string(kDeepest) +
                                      " levels of brackets; expected at most that");
        if (event == Json::parse_event_t::object_start) keys_.emplace_back();
        if (event == Json::parse_event_t::object_end) keys_.pop_back();
        if (event == Json::parse_event_t::key) {
            const std::string key = value.get<std::string>();
            if (!keys_.back().insert(key).second)
                throw DefinitionError(origin_, "",
                                      "key \"" + key + "\" twice in one object; expected once");
        }
        return true;
    }

 private:
    const std::string& origin_;
    std::vector<std::set<std::string>> keys_;
};

}  // namespace

Json parse_json(const std::string& text, const std::string& origin) {
    if (const size_t at = text.find('\0'); at != std::string::npos)
        throw DefinitionError(origin, "",
                              place_of(text, at + 1) + ": not JSON: a byte 0; expected text");
    try {
        Strictness strict(origin);
        return Json::parse(text, std::ref(strict));
    } catch (const Json::parse_error& error) {
        std::string what = error.what();
        // The library's own prefix repeats the place in bytes; keep what follows.
        if (const size_t at = what.find("syntax error"); at != std::string::npos)
            what = what.substr(at);
        throw DefinitionError(origin, "", place_of(text, error.byte) + ": not JSON: " + what);
    } catch (const Json::exception& error) {
        // A number beyond what a double holds; the library names it in quotation marks, not its
        // place.
        const std::string what = error.what();
        const size_t open = what.find('\''), close = what.rfind('\'');
        std::string place, number = what;
        if (open != std::string::npos && close > open) {
            number = what.substr(open + 1, close - open - 1);
            if (const size_t at = text.find(number); at != std::string::npos)
                place = place_of(text, at + 1) + ": ";
        }
        throw DefinitionError(origin, "",
                              place + "not JSON: found " + number +
                                  "; expected numbers between -1.7e308 and 1.7e308");
    }
}

LocalText local_text(const Json& value) {
    if (value.is_string()) return {value.get<std::string>(), {}};
    return {value.value("en", std::string()), value.value("pl", std::string())};
}

}  // namespace placode::curriculum
