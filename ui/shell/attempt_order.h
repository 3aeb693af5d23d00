// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Whose attempt it is, what was asked for, and how its recording reaches the store. The order lies
// as a small JSON file beside the recording, so that an attempt left over from a crash still
// knows its owner. The recording holds the file's checksum, so that nobody changes it unseen.

#include <QByteArray>
#include <QString>
#include <optional>
#include <set>
#include <vector>

#include "curriculum/conduct.h"
#include "db/store.h"

namespace placode::ui {

/// Behind the name of a recording that waits for its server (waiting_recordings.h): an empty file.
inline constexpr const char* kWaitingSuffix = ".waiting";

/// One attempt, from Start to the store.
struct AttemptOrder {
    int64_t user_id = 0;
    QString user_name;  ///< For the simulator, while the shell runs; not in the file.
    QString task;       ///< Task id.
    QString title;      ///< Task title as it was shown.
    QString device;     ///< As on the command line.
    QString controls;   ///< Keys and buttons, as on the command line; empty: as delivered.
    QString started_utc;
    QString recording_file;
    bool demonstration = false;        ///< Of a demonstration account.
    QString study, participant, step;  ///< Of a study; empty = of a course.
    int visit = 1;
    QString aids;           ///< Of a study: what the picture may show, as aid_names().
    double min_s = 0;       ///< Of a study: a shorter attempt does not count as done.
    double duration_s = 0;  ///< 0 = the task's limit.
    uint64_t seed = 0;      ///< Of anatomy and operator; 0 = the program's own.
    int stage = 0;          ///< Of the task, to begin at, in practice; 0 = the beginning.
    db::ExamContext exam;   ///< Of an exam stage; no course = practice.
    QByteArray text;        ///< As it lies beside the recording; empty: no file does.
    QString store;          ///< server_place() of the one that it was begun for.

    [[nodiscard]] curriculum::AttemptMode mode() const {
        if (!study.isEmpty()) return curriculum::AttemptMode::kStudy;
        return exam.course_id.empty() ? curriculum::AttemptMode::kPractice
                                      : curriculum::AttemptMode::kExam;
    }
};

/// A recording that was not saved: crash, power cut, or a store that could not be reached.
struct Leftover {
    QString recording_file;
    std::optional<AttemptOrder> order;  ///< Absent: nobody knows whose it is.
    double duration_s = 0;
    bool complete = false;  ///< The recording has an end: only the saving failed.
    QString started_utc;
    QString task;
    QString damage;  ///< Not empty: what of it is damaged and how much is whole.
    std::optional<db::StoreError> problem;  ///< Why it cannot be read at all.
};

/// Which server's store this address is, without log-in and options: the recordings of all of them
/// lie in one folder. Empty for a store that is a file, which has a folder of its own.
[[nodiscard]] QString server_place(const std::string& store_url);

/// Folder for recordings of a store: beside an embedded one, else in the user's data folder.
[[nodiscard]] QString recordings_folder(const std::string& store_url);

/// Fills `recording_file` with a fresh name in `folder`, and `text`, and writes it beside it.
/// Throws db::StoreError(kUnavailable) when the folder cannot be written.
void write_order(AttemptOrder& order, const QString& folder);

/// The order beside a recording, if there is a readable one.
[[nodiscard]] std::optional<AttemptOrder> read_order(const QString& recording_file);

/// How much of each recording is read: its length (milliseconds), or all of it, which finds what is
/// damaged and takes seconds.
enum class Depth : uint8_t { kLength, kWhole };
/// Recordings in `folder` that nobody writes to, oldest first. @param saved those that are being
/// saved now: they are no leftovers. One in which nothing was recorded is removed on the way.
[[nodiscard]] std::vector<Leftover> find_leftovers(const QString& folder, Depth depth,
                                                   const std::set<QString>& saved = {});

/// Removes a recording, its order and the mark that it waits.
void remove_recording(const QString& recording_file);

/// What became of a recording.
enum class Saving : uint8_t {
    kSaved,
    kEmpty,  ///< Nothing was recorded: there is no attempt to save.
    kGone,   ///< Not there any more: another window has saved it meanwhile, or removed it.
};
struct SavedAttempt {
    Saving outcome = Saving::kEmpty;
    int64_t attempt_id = 0;
};

/// Reads the recording, computes metrics and score, saves all of it in one transaction and only
/// then removes the files. A file that the store already holds is not saved twice, also when
/// several programs save it at once: those wait for the first. Throws what the parts throw; the
/// files then stay. Any thread, with a store of that thread.
[[nodiscard]] SavedAttempt save_recording(db::Store& store, const AttemptOrder& order);

/// A recording file, read back up to a damage.
[[nodiscard]] sim::Recording recording_of_file(const QString& file);

/// The recording of a stored attempt, read back up to a damage. Any thread, with a store of that
/// thread.
[[nodiscard]] sim::Recording stored_recording(db::Store& store, int64_t attempt_id);

}  // namespace placode::ui
