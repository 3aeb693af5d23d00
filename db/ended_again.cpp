// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/ended_again.h"

#include <set>
#include <string_view>
#include <tuple>

namespace placode::db {
namespace {

using Kind = StoreError::Kind;

constexpr const char* kWithdraw = "study.withdraw";
constexpr const char* kRetention = "study.retention";
constexpr std::string_view kKeptUntil = "kept until ";  // Studies::erase_kept().

/// An earlier version wrote the reason behind it: "erase: moved away".
std::optional<WithdrawalMode> mode_of(const std::string& detail) {
    return withdrawal_mode_named(detail.substr(0, detail.find(':')));
}

void end_one(Store& store, const EndedRecords& each,
             const std::map<std::string, std::string>& reasons) {
    if (!each.mode) return store.studies().erase_kept(each.study, each.code, each.until_utc);
    const auto known = reasons.find(each.entry.object);
    const bool said = known != reasons.end() && !known->second.empty();
    store.studies().withdraw(each.study, each.code, *each.mode, said ? known->second : "not given");
}

}  // namespace

std::vector<EndedRecords> ended_records(const std::vector<AuditRecord>& entries) {
    std::vector<EndedRecords> found;
    for (const AuditRecord& entry : entries) {
        // A code has no blank; a study's id may.
        const size_t blank = entry.object.rfind(' ');
        if (blank == std::string::npos) continue;
        EndedRecords each{
            entry, entry.object.substr(0, blank), entry.object.substr(blank + 1), {}, {}};
        if (entry.action == kWithdraw)
            each.mode = mode_of(entry.detail);
        else if (entry.action == kRetention && entry.detail.starts_with(kKeptUntil))
            each.until_utc = entry.detail.substr(kKeptUntil.size());
        if (each.mode || !each.until_utc.empty()) found.push_back(std::move(each));
    }
    return found;
}

void end_again(Store& store, const std::vector<EndedRecords>& records,
               const std::map<std::string, std::string>& reasons) {
    if (records.empty()) return;
    // What came before the backup is done in it, and what a participant gave after it stays.
    std::set<std::tuple<std::string, std::string, std::string>> done;
    for (const char* action : {kWithdraw, kRetention})
        for (const AuditRecord& entry : store.audit().of_action(action))
            done.insert({entry.action, entry.object, entry.at_utc});
    for (const EndedRecords& each : records) {
        if (done.contains({each.entry.action, each.entry.object, each.entry.at_utc})) continue;
        try {
            end_one(store, each, reasons);
        } catch (const StoreError& error) {
            // Withdrawn already, not there yet, or kept for longer by a clock that went back: then
            // the page of the study's data says when they are due.
            if (error.kind() != Kind::kConflict && error.kind() != Kind::kNotFound &&
                error.kind() != Kind::kRefused)
                throw;
        }
    }
}

std::vector<std::string> done_again(Store& store) {
    const std::vector<AuditRecord> restores = store.audit().of_action("store.restore");
    std::vector<std::string> lines;
    if (restores.empty()) return lines;
    for (const char* action : {"user.erase", kWithdraw, kRetention})
        for (const AuditRecord& entry : store.audit().of_action(action))
            if (entry.id > restores.back().id) lines.push_back(entry.object + ": " + entry.detail);
    return lines;
}

}  // namespace placode::db
