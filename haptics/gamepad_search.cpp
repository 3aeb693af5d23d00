// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/gamepad_search.h"

#include <linux/input-event-codes.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "haptics/station.h"

namespace placode::haptics {
namespace {

namespace fs = std::filesystem;

std::string first_line(const fs::path& file) {
    std::ifstream in(file);
    std::string line;
    std::getline(in, line);
    return line;
}

/// The kernel writes a bit field as words of a long in hexadecimal, the highest first.
bool has_bit(const std::string& words, unsigned bit) {
    std::vector<unsigned long> values;
    std::istringstream in(words);
    for (std::string word; in >> word;) {
        char* end = nullptr;
        values.push_back(std::strtoul(word.c_str(), &end, 16));
        if (*end != '\0') return false;
    }
    constexpr unsigned kBits = 8 * sizeof(unsigned long);
    const size_t index = bit / kBits;
    return index < values.size() && ((values[values.size() - 1 - index] >> (bit % kBits)) & 1) != 0;
}

std::string joined(const std::vector<std::string>& parts) {
    std::string text;
    for (const std::string& part : parts) text += (text.empty() ? "" : ", ") + part;
    return text;
}

}  // namespace

GamepadSearch look_for_gamepads(const InputFolders& folders) {
    GamepadSearch search;
    std::error_code error;
    std::vector<fs::path> nodes;
    for (const auto& entry : fs::directory_iterator(folders.list, error))
        if (entry.path().filename().string().starts_with("event")) nodes.push_back(entry.path());
    std::sort(nodes.begin(), nodes.end());
    for (const fs::path& node : nodes) {
        ++search.looked_at;
        if (!has_bit(first_line(node / "device/capabilities/key"), BTN_GAMEPAD)) continue;
        const std::string file = folders.devices + "/" + node.filename().string();
        if (::access(file.c_str(), R_OK) == 0)
            search.found.push_back(first_line(node / "device/name"));
        else
            search.unreadable.push_back(file);
    }
    return search;
}

std::string GamepadSearch::reason(const InputFolders& folders) const {
    if (!found.empty()) return {};
    if (!unreadable.empty())
        return "gamepad: " + joined(unreadable) +
               " may not be read by this account. Add the user to the group input and log in "
               "again.";
    return "gamepad: none of the " + std::to_string(looked_at) + " input devices of " +
           folders.devices + " has a gamepad's buttons. Plug one in, or switch it on and pair it.";
}

void need_gamepad(const InputFolders& folders) {
    const GamepadSearch search = look_for_gamepads(folders);
    if (search.found.empty()) throw DeviceError(search.reason(folders));
}

}  // namespace placode::haptics
