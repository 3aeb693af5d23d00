// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Exports for other programs. Each is written into a folder beside its place, read back, compared
// with the store and only then moved to where it was asked for; one that differs is deleted.

#include <functional>
#include <string>
#include <vector>

#include "reports/dataset.h"
#include "reports/export_pace.h"
#include "sim/step/recording.h"

namespace placode::reports {

/// The recording of an attempt; nothing when it has none.
using RecordingOf = std::function<std::optional<sim::Recording>(int64_t attempt_id)>;

/// Everything that the writers are given.
struct ExportSource {
    Dataset data;
    RecordingOf recording;  ///< For motion-bids and bundle.
    ExportPace pace = {};   ///< Told and asked before every format, and before every recording.
};

/// How one format is written and read. Both work in a folder of their own.
struct ExportFormat {
    const char* name;   ///< "csv", as on the command line.
    const char* title;  ///< "CSV (wide, long, codebook)"
    void (*write)(const ExportSource&, const std::string& folder);
    /// Throws ReportError when what is in the folder is not what the source holds.
    void (*verify)(const ExportSource&, const std::string& folder);
};

/// csv spss redcap fhir odm xapi motion-bids bundle.
[[nodiscard]] const std::vector<ExportFormat>& export_formats();

struct ExportedFile {
    std::string path;  ///< From the folder that was asked for.
    std::string sha256;
    int64_t bytes = 0;
};

/// Writes, reads back, compares, hands out. Returns the files, which are for their owner alone
/// (mode 0600, folders 0700). Files of the same name are replaced. Throws ReportError, or
/// ExportStopped where the source's pace said so; the folder is then as it was.
std::vector<ExportedFile> export_dataset(const ExportSource& source, const std::string& format,
                                         const std::string& folder);

/// Recordings out of a store, by way of a file that is gone afterwards.
[[nodiscard]] RecordingOf recordings_of(db::Store& store);

/// A file name from what people typed: letters, digits, '-', '_' and '.' stay.
[[nodiscard]] std::string file_name(const std::string& text);

/// The whole file, atomically on disk. Throws ReportError.
void save_file(const std::string& path, const std::string& bytes);
/// The same for its owner alone (db/private_file.h): it names people or what they did.
void save_private_file(const std::string& path, const std::string& bytes);
/// A folder that is made here is for its owner alone (0700); one that is there stays as it is.
/// Throws ReportError.
void make_private_folder(const std::string& folder);
[[nodiscard]] std::string read_file(const std::string& path);

}  // namespace placode::reports
