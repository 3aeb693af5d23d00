// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// REDCap's data dictionary of 18 columns. Private to reports: redcap_writer.cpp writes the files.

#include <string>

#include "reports/dataset.h"

namespace placode::reports {

[[nodiscard]] inline std::string redcap_form_name(const Form& form) {
    return plain_name(form.name);
}

/// The dictionary as CSV.
[[nodiscard]] std::string redcap_dictionary(const Dataset& data);

/// The dictionary must name every column of the records, as REDCap demands on import. Throws
/// ReportError for a file that does not.
void check_redcap_dictionary(const Dataset& data, const std::string& path);

}  // namespace placode::reports
