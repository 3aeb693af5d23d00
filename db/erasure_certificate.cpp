// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What was erased where, on a page of text for whom it concerns.

#include "db/erasure.h"
#include "db/station.h"

namespace placode::db {
namespace {

std::string lines_of(const char* head, const std::vector<std::string>& lines) {
    if (lines.empty()) return {};
    std::string text = std::string(head) + "\n";
    for (const std::string& line : lines) text += "  " + line + "\n";
    return text;
}

}  // namespace

std::string erasure_certificate(const Erasure& erasure) {
    std::string text = "Placode: certificate of erasure\n";
    text += "account " + std::to_string(erasure.user_id) + " of the store " +
            erasure.store.substr(0, 16) + ", " + erasure.at_utc + "\n";
    text += "removed: name, log-in, password, PIN, groups, assignments, grants, certificates; ";
    text += erasure.with_attempts ? "the attempts as well\n" : "attempts stay without a name\n";
    text += lines_of("erased as well in these copies:", erasure.cleaned);
    text +=
        lines_of("recordings of the person that were not saved yet, removed:", erasure.recordings);
    std::string entries;
    for (const int64_t entry : erasure.entries)
        entries += (entries.empty() ? "" : ", ") + std::to_string(entry);
    if (!entries.empty())
        text +=
            "entries of the audit trail that name the person, from an earlier version or as the "
            "place of a copy; each proves those after it, so they stay: " +
            entries + "\n";
    std::vector<std::string> left;
    for (const LeftCopy& each : erasure.left) left.push_back(each.path + ": " + each.why);
    text += lines_of("may still hold the person (delete them):", left);
    text += lines_of(
        "backups that are not where they were made (a restore of them erases again, as long as the "
        "store that they replace says so):",
        erasure.gone);
    text +=
        "not in the store, and not looked at: links to a learning platform (lti.json, "
        "lti.json.sent); `placodectl lti unlink` takes the account out of the first, the second "
        "keeps which points were sent\n";
    Station station;
    const std::string key = station.public_key(), signature = station.sign(text);
    if (!signature.empty()) text += "station " + key + "\nsignature " + signature + "\n";
    return text;
}

}  // namespace placode::db
