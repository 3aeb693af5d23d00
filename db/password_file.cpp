// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/password_file.h"

#include <sys/stat.h>

#include <array>
#include <fstream>
#include <string_view>

namespace placode::db {
namespace {

/// Takes the field before the next ':' off the line. False where the line ends before one.
bool take_field(std::string_view& line, std::string& field) {
    field.clear();
    for (size_t i = 0; i < line.size(); ++i) {
        if (line[i] == ':') {
            line.remove_prefix(i + 1);
            return true;
        }
        if (line[i] == '\\' && i + 1 < line.size()) ++i;
        field += line[i];
    }
    return false;
}

bool is_for(std::string_view line, const StoreUrl& url) {
    const std::array<std::string, 4> wanted{url.host, std::to_string(url.port), url.name, url.user};
    std::string field;
    for (const std::string& each : wanted) {
        const bool any = line.starts_with("*:");
        if (!take_field(line, field) || (!any && field != each)) return false;
    }
    return true;
}

}  // namespace

bool password_file_has(const std::string& path, const StoreUrl& url) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode) ||
        (status.st_mode & (S_IRWXG | S_IRWXO)) != 0)
        return false;
    std::ifstream in(path);
    for (std::string line; std::getline(in, line);)
        if (!line.starts_with('#') && is_for(line, url)) return true;
    return false;
}

}  // namespace placode::db
