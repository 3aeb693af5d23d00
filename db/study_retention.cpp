// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/study_retention.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <stdexcept>

#include "curriculum/utc_time.h"
#include "db/study_conduct.h"

namespace placode::db {
namespace {

/// Time of the newest record of every participant.
std::map<std::string, std::string> last_records(Store& store, const std::string& study_id) {
    std::map<std::string, std::string> last;
    const auto note = [&](const std::string& code, const std::string& utc) {
        std::string& newest = last[code];
        newest = std::max(newest, utc);
    };
    for (const StepRecord& step : store.studies().steps(study_id))
        note(step.participant, step.at_utc);
    for (const AnswerRecord& each : store.studies().answers(study_id))
        note(each.participant, each.answered_utc);
    return last;
}

/// What the protocol's versions say, each read once.
class YearsOfVersions {
 public:
    YearsOfVersions(Store& store, const std::string& study_id)
        : store_(store), study_id_(study_id) {}
    int of(int version) {
        if (version == 0) return 0;  // enrolled without a protocol
        const auto known = years_.find(version);
        if (known != years_.end()) return known->second;
        const auto protocol = published_study(store_, study_id_, version);
        return years_[version] = protocol ? protocol->keep_years : 0;
    }

 private:
    Store& store_;
    const std::string& study_id_;
    std::map<int, int> years_;
};

}  // namespace

std::string years_later(const std::string& utc, int years) {
    namespace time = std::chrono;
    const auto seconds = curriculum::utc_seconds(utc);
    if (!seconds) throw std::invalid_argument("\"" + utc + "\" is no time");
    const time::sys_seconds at{time::seconds(*seconds)};
    const auto day = time::floor<time::days>(at);
    time::year_month_day date(day);
    date += time::years(years);
    if (!date.ok()) date = date.year() / date.month() / time::last;
    const auto later = time::sys_days(date) + (at - day);
    return curriculum::utc_text(later.time_since_epoch().count());
}

std::vector<KeptRecords> kept_records(Store& store, const std::string& study_id) {
    YearsOfVersions years(store, study_id);
    std::vector<KeptRecords> kept;
    for (const ParticipantRecord& each : store.studies().participants(study_id))
        if (const int told = years.of(each.protocol_version); told > 0)
            kept.push_back({each.code, {}, told, {}});
    if (kept.empty()) return kept;  // most studies: their records need not be read
    const auto last = last_records(store, study_id);
    std::erase_if(kept, [&](const KeptRecords& each) { return !last.contains(each.code); });
    for (KeptRecords& each : kept) {
        each.last_utc = last.at(each.code);
        each.until_utc = years_later(each.last_utc, each.keep_years);
    }
    std::stable_sort(kept.begin(), kept.end(), [](const KeptRecords& a, const KeptRecords& b) {
        return a.until_utc < b.until_utc;
    });
    return kept;
}

std::vector<std::string> erase_overdue(Store& store, const std::string& study_id,
                                       const std::string& now_utc) {
    std::vector<std::string> erased;
    for (const KeptRecords& each : kept_records(store, study_id)) {
        if (!each.overdue(now_utc)) break;
        store.studies().erase_kept(study_id, each.code, each.until_utc);
        erased.push_back(each.code);
    }
    return erased;
}

}  // namespace placode::db
