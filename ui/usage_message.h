// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What was wrong with a command line, in the one form that all messages of the programs have:
// `thing: problem; way out`, with the word that was probably meant.

#include <CLI/CLI.hpp>
#include <regex>
#include <string>
#include <vector>

#include "sim/core/near_word.h"

namespace placode::ui {

/// The command that was being read, and its way from the program: "study answer".
struct ReadCommand {
    const CLI::App* app = nullptr;
    std::string path;
};

inline ReadCommand read_command(const CLI::App& root) {
    ReadCommand read{&root, {}};
    while (!read.app->get_subcommands().empty()) {
        read.app = read.app->get_subcommands().back();
        read.path += (read.path.empty() ? "" : " ") + read.app->get_name();
    }
    return read;
}

/// Names of options that may stand here: those of the command and of the commands around it.
inline std::vector<std::string> option_names(const CLI::App* app) {
    std::vector<std::string> names;
    for (; app != nullptr; app = app->get_parent())
        for (const CLI::Option* option : app->get_options())
            for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    return names;
}

inline std::vector<std::string> command_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* each : app.get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(each->get_name());
    return names;
}

inline std::string list_of(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

inline std::string quoted(const std::string& word) { return "\"" + word + "\""; }

/// Without the middle of what is longer than any option: std::regex calls itself for every letter,
/// and a value of 100,000 would end the program.
inline std::string without_middle(const std::string& said) {
    constexpr size_t kSide = 1000;
    if (said.size() <= 2 * kSide) return said;
    return said.substr(0, kSide) + "..." + said.substr(said.size() - kSide);
}

/// What CLI11 says of a value, in our form: its own sentence when it is none of the known ones.
inline std::string value_message(const std::string& sentence) {
    std::string said = without_middle(sentence);
    static const std::regex kNoMember(R"(^(?:(.+?): )?(.*) not in \{(.*)\}$)");
    static const std::regex kRange(
        R"(^(?:(.+?): )?Value (.*) not in range \[?(.*?)(?: - | to )(.*?)\]?$)");
    static const std::regex kConvert(R"(^Could not convert: (.+?) = (.*)$)");
    static const std::regex kMissing(R"(^(.+?): \d+ required (.*) missing$)");
    static const std::regex kRequired(R"(^(.+) is required$)");
    static const std::regex kTooMany(
        R"(^(.+?): (?:At Most|At least) (\d+) required but received (\d+)$)");
    std::smatch part;
    const auto thing = [&] { return part[1].matched ? part[1].str() + ": " : std::string(); };
    if (std::regex_match(said, part, kNoMember)) {
        std::vector<std::string> known;
        std::string word;
        std::istringstream list(part[3].str());
        while (std::getline(list, word, ',')) known.push_back(word);
        return thing() + "found " + quoted(part[2]) + "; expected one of: " + list_of(known) +
               sim::did_you_mean(part[2].str(), known);
    }
    if (std::regex_match(said, part, kRange))
        return thing() + "found " + quoted(part[2]) + "; expected " + part[3].str() + " to " +
               part[4].str();
    if (std::regex_match(said, part, kConvert))
        return part[1].str() + ": found " + quoted(part[2]) + "; expected a number";
    if (std::regex_match(said, part, kMissing))
        return part[1].str() + ": the value is missing; expected " + part[2].str();
    if (std::regex_match(said, part, kRequired)) return part[1].str() + ": is missing";
    if (std::regex_match(said, part, kTooMany)) {
        const bool once = part[2] == "1";
        return part[1].str() + (once ? ": is given " : ": found ") + part[3].str() +
               (once ? " times; expected once" : " values; expected " + part[2].str());
    }
    return said;
}

/// The sentence without the program's name. `program` is called for help.
inline std::string usage_message(const CLI::App& root, const CLI::ParseError& error) {
    const ReadCommand read = read_command(root);
    const std::string help =
        "`" + root.get_name() + (read.path.empty() ? "" : " " + read.path) + " --help`";
    const std::string thing = read.path.empty() ? std::string() : read.path + ": ";
    const std::vector<std::string> left = root.remaining(true);
    const std::vector<std::string> commands = command_names(*read.app);
    if (!left.empty()) {
        const std::string& word = left.front();
        if (word.starts_with("-"))
            return thing + "unknown option " + quoted(word) + "; see " + help +
                   sim::did_you_mean(word.substr(0, word.find('=')), option_names(read.app));
        if (!commands.empty())
            return thing + "unknown command " + quoted(word) +
                   "; expected one of: " + list_of(commands) + sim::did_you_mean(word, commands);
        return thing + quoted(word) + " is one argument too many; see " + help;
    }
    if (!commands.empty() && read.app->get_require_subcommand_min() > 0 &&
        read.app->get_subcommands().empty())
        return thing + "the command is missing; expected one of: " + list_of(commands);
    std::string said = error.what();
    for (char& c : said)
        if (c == '\n') c = ' ';
    const std::string value = value_message(said);
    return thing + value + (value.ends_with('?') ? "" : "; see " + help);
}

}  // namespace placode::ui
