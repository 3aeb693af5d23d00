// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/trail_head.h"

#include <charconv>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "db/durable_file.h"
#include "db/signature.h"
#include "db/store_error.h"
#include "db/whole_file.h"

namespace placode::db {
namespace {

namespace fs = std::filesystem;
using Kind = StoreError::Kind;

constexpr const char* kTitle = "Placode: end of an audit trail, format 1";
constexpr std::streamsize kMostBytes = 4096;

}  // namespace

std::string trail_statement(const TrailHead& head) {
    return std::string(kTitle) + "\nstore " + head.store + "\nentry " + std::to_string(head.entry) +
           "\nchain " + head.chain + "\nat " + head.at_utc + "\nstation " + head.station + "\n";
}

std::string trail_head_text(const TrailHead& head) {
    return trail_statement(head) + "signature " + head.signature + "\n";
}

TrailHead trail_head_of(const std::string& text, const std::string& name) {
    const auto refuse = [&name](const std::string& why) -> void {
        throw StoreError(Kind::kDamaged, name + ": " + why);
    };
    std::istringstream in(text);
    std::string line;
    if (!std::getline(in, line) || line != kTitle)
        refuse(
            "it does not say where an audit trail ended; `placodectl audit --head FILE` writes "
            "such a file");
    std::map<std::string, std::string> words;
    while (std::getline(in, line)) {
        const size_t blank = line.find(' ');
        if (blank != std::string::npos) words[line.substr(0, blank)] = line.substr(blank + 1);
    }
    TrailHead head{words["store"],    0, words["chain"], words["at"], words["station"],
                   words["signature"]};
    const std::string& number = words["entry"];
    const auto [end, error] =
        std::from_chars(number.data(), number.data() + number.size(), head.entry);
    if (error != std::errc() || end != number.data() + number.size() || head.entry < 0)
        refuse("its entry \"" + number + "\" is no number");
    // What the file says beside its five lines would not be signed.
    if (trail_head_text(head) != text) refuse("it was changed: a line is missing or too many");
    if (!head.station.empty() &&
        !signature_is_right(trail_statement(head), head.signature, head.station))
        refuse("its signature is not right: it was changed");
    return head;
}

void write_trail_head(const TrailHead& head, const std::string& path) {
    if (fs::exists(path))
        throw StoreError(Kind::kConflict,
                         path + " exists and is not overwritten; give another name");
    // In one step: a half of it beside a backup would keep that from being restored.
    WholeFile file(QString::fromStdString(path));
    const std::string text = trail_head_text(head);
    if (!file.open(QIODevice::WriteOnly) ||
        file.write(text.data(), static_cast<qint64>(text.size())) < 0 || !file.commit())
        throw StoreError(Kind::kUnavailable,
                         path + " cannot be written: " + file.errorString().toStdString());
    try {
        sync_folder_of(path);
    } catch (const fs::filesystem_error& error) {
        throw StoreError(Kind::kUnavailable, path + " cannot be written: " + error.what());
    }
}

TrailHead read_trail_head(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    if (!in) throw StoreError(Kind::kNotFound, path + ": there is no such file");
    std::string text(kMostBytes, '\0');
    in.read(text.data(), kMostBytes);
    text.resize(static_cast<size_t>(in.gcount()));
    return trail_head_of(text, path);
}

}  // namespace placode::db
