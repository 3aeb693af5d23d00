// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Part of Store: attempts with their scores and recordings, and what lists and sums say of them.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "db/records.h"
#include "db/store_check.h"

namespace placode::db {

class Connection;
struct StoreContext;

/// Whose an attempt is.
struct AttemptOwner {
    int64_t user_id = 0;  ///< 0 = of a study: it belongs to a participant's code.
    StudyContext study;
};

/// `store.attempts().list()`. Every change is one transaction and in the audit trail.
class Attempts {
 public:
    explicit Attempts(StoreContext& context);

    /// Attempt, metrics, reasons, events and the recording's bytes, all or nothing. Vaporised
    /// elements and hashes are left out of the events: the recording has them.
    int64_t save(int64_t user_id, const AttemptResult& result);
    /// Oldest first; user_id 0 = everybody's and those of studies; task_id empty = all. A person's
    /// own never hold what a participant did while that person was signed in.
    [[nodiscard]] std::vector<AttemptRecord> list(int64_t user_id, const std::string& task_id = {});
    [[nodiscard]] AttemptDetail detail(int64_t id);  ///< Throws kNotFound.
    /// Of many at once, with as many questions as for one (of 500 each); those that are not there
    /// are left out.
    [[nodiscard]] std::map<int64_t, AttemptDetail> details(const std::vector<int64_t>& ids);
    /// The same without metrics, reasons and events.
    [[nodiscard]] std::map<int64_t, AttemptRecord> records(const std::vector<int64_t>& ids);
    [[nodiscard]] AttemptOwner owner_of(int64_t id);  ///< Throws kNotFound.
    /// Writes the recording file of an attempt to `path`.
    void extract_recording(int64_t attempt_id, const std::string& path);
    /// The attempt that holds exactly this recording file, if any: a file left over from a crash
    /// between saving and removing is not saved twice.
    [[nodiscard]] std::optional<int64_t> find_recording(const std::string& recording_file);
    /// Exams and attempts of studies that are still to be simulated again: those of this build
    /// first, oldest first. On a server those of which it takes this program's word.
    [[nodiscard]] std::vector<int64_t> waiting_for_replay();
    /// Practice that may still be simulated again, in the same order: recorded to its end, not
    /// void, and nobody has done so. It counts meanwhile, unlike what waits.
    [[nodiscard]] std::vector<int64_t> never_replayed();
    /// Whether another build recorded the attempt, and this version has read that recording before
    /// and found nothing that differs: there is nothing more to find here.
    [[nodiscard]] bool was_read(int64_t attempt_id);
    /// Remembers it. It is no part of what the attempt is: neither sealed nor in the trail.
    void set_read(int64_t attempt_id);
    /// Whether a server takes this program's word for what simulating the attempt again gave. A
    /// file takes every program's.
    [[nodiscard]] bool judges_replay(int64_t attempt_id);
    /// Why the store does not believe that a recording is this attempt's: no computer of it signed
    /// the file, it ends in another state, or an earlier attempt has it. nullopt: it does.
    /// @param recording_file as extract_recording() wrote it.
    [[nodiscard]] std::optional<Said> doubt_about(int64_t attempt_id,
                                                  const std::string& recording_file);
    /// What simulating again gave. One that differs is void from then on; `difference` says where.
    /// Only a program says so, never an account.
    void set_replay(int64_t attempt_id, ReplayState state, const Said& difference = {});
    /// Adds what is damaged to `problems`, for Store::check(). Reads page by page, and holds one
    /// recording at a time.
    void check_recordings(std::vector<std::string>& problems, const CheckPace& pace = {});

    // attempts_rescores.cpp
    /// Keeps a further score beside the first one. Throws kConflict when the attempt has one under
    /// the same rubric, metric set and pre-processing.
    int64_t save_rescore(const RescoreRecord& rescore);
    [[nodiscard]] std::vector<RescoreRecord> rescores(int64_t attempt_id);

    // attempts_lists.cpp
    [[nodiscard]] AttemptPage page(const AttemptFilter& filter);  ///< Of a list.
    /// By person, task and time.
    [[nodiscard]] std::vector<AttemptPoint> points(int64_t group_id,
                                                   const std::string& task_id = {});
    /// Ids of the tasks that anybody has attempted, by name.
    [[nodiscard]] std::vector<std::string> tasks();

    // attempts_standings.cpp
    /// By name and task; group_id 0 = everybody. task_id empty = all.
    [[nodiscard]] std::vector<TaskStanding> standings(int64_t group_id,
                                                      const std::string& task_id = {});
    /// Mean of each one's last `last` finished attempts at a task, by name.
    [[nodiscard]] std::vector<RecentMean> recent_means(const std::string& task_id, int last);

 private:
    StoreContext& context_;
    Connection& connection_;
};

}  // namespace placode::db
