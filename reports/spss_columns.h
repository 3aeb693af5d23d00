// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The columns of an SPSS system file: names that SPSS accepts, missing codes, dates, and what of a
// row stands in each. Private to reports: spss_writer.cpp writes and reads the file.

#include <readstat.h>

#include <optional>
#include <string>
#include <vector>

#include "reports/dataset.h"

namespace placode::reports {

/// One column of the file. A field with several choices becomes one column a choice.
struct SpssColumn {
    std::string name;
    const Field* field = nullptr;  ///< nullptr = about the row, not an answer.
    int choice = -1;               ///< Of a field of kind kMultiple.
    std::string head;              ///< "participant", ... for columns without a field.
    double missing = 0;            ///< First of three codes in a row; 0 = system-missing only.
    readstat_variable_t* variable = nullptr;
    [[nodiscard]] bool is_text() const {
        return field == nullptr ? head != "instance" && head != "demonstration"
                                : field->kind == FieldKind::kText;
    }
};

/// What is about the row first, then the fields.
[[nodiscard]] std::vector<SpssColumn> spss_columns(const Form& form);

/// Text of a column without a field: participant, time, language or questionnaire.
[[nodiscard]] std::string spss_head_text(const Form& form, const Row& row, const std::string& head);

/// Bytes of the longest text of a column, at least 1. Throws ReportError where SPSS cannot hold it.
[[nodiscard]] size_t spss_width(const Form& form, const SpssColumn& column);

/// A number for a cell, or nothing for system-missing.
[[nodiscard]] std::optional<double> spss_number(const Row& row, const SpssColumn& column);

/// YYYY-MM-DD of SPSS's seconds.
[[nodiscard]] std::string spss_date_text(double seconds);

}  // namespace placode::reports
