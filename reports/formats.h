// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The writers and readers of the single formats, one pair a file. Private to reports.

#include <string>
#include <vector>

#include "reports/export.h"

namespace placode::reports {

inline constexpr const char* kMotionBidsTitle = "Motion-BIDS (trajectories)";

void write_csv(const ExportSource& source, const std::string& folder);
void verify_csv(const ExportSource& source, const std::string& folder);
void write_spss(const ExportSource& source, const std::string& folder);
void verify_spss(const ExportSource& source, const std::string& folder);
void write_redcap(const ExportSource& source, const std::string& folder);
void verify_redcap(const ExportSource& source, const std::string& folder);
void write_fhir(const ExportSource& source, const std::string& folder);
void verify_fhir(const ExportSource& source, const std::string& folder);
void write_odm(const ExportSource& source, const std::string& folder);
void verify_odm(const ExportSource& source, const std::string& folder);
void write_xapi(const ExportSource& source, const std::string& folder);
void verify_xapi(const ExportSource& source, const std::string& folder);
void write_motion_bids(const ExportSource& source, const std::string& folder);
void verify_motion_bids(const ExportSource& source, const std::string& folder);
void write_bundle(const ExportSource& source, const std::string& folder);
void verify_bundle(const ExportSource& source, const std::string& folder);

/// manifest.json of a bundle: what, when, by which program, and every file with its checksum.
[[nodiscard]] std::string bundle_manifest(const ExportSource& source,
                                          const std::vector<ExportedFile>& files);

/// Folder and "<study>_<form><ending>", both safe as file names.
[[nodiscard]] std::string form_path(const std::string& folder, const Dataset& data,
                                    const Form& form, const std::string& ending);

}  // namespace placode::reports
