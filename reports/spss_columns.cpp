// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/spss_columns.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <set>

#include "reports/report.h"

namespace placode::reports {
namespace {

/// SPSS counts seconds from 14 October 1582, 141,428 days before 1970.
constexpr double kDaysTo1970 = 141428, kDay_s = 86400;
/// ReadStat's and SPSS's longest text.
constexpr size_t kLongestText = 32767;

double date_seconds(const std::string& date) {
    const std::chrono::sys_days day =
        std::chrono::year(std::atoi(date.substr(0, 4).c_str())) /
        std::chrono::month(static_cast<unsigned>(std::atoi(date.substr(5, 2).c_str()))) /
        std::chrono::day(static_cast<unsigned>(std::atoi(date.substr(8, 2).c_str())));
    return (day.time_since_epoch().count() + kDaysTo1970) * kDay_s;
}

/// Not a word of the language, starts with a letter, ends without a dot, unique without case.
std::string spss_name(const std::string& id, std::set<std::string>& used) {
    static const std::set<std::string> reserved{"ALL", "AND", "BY",  "EQ", "GE", "GT",  "LE",
                                                "LT",  "NE",  "NOT", "OR", "TO", "WITH"};
    const auto upper = [](std::string text) {
        for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
        return text;
    };
    std::string name;
    for (const char c : id)
        name += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' ? c : '_';
    if (name.empty() || std::isalpha(static_cast<unsigned char>(name[0])) == 0)
        name.insert(0, 1, 'x');
    name = name.substr(0, 56);
    if (name.back() == '.' || reserved.contains(upper(name))) name += '_';
    const std::string stem = name;
    for (int i = 2; !used.insert(upper(name)).second; ++i) name = stem + "_" + std::to_string(i);
    return name;
}

constexpr std::array<const char*, 6> kHead{"participant", "answered_utc",  "language",
                                           "instance",    "demonstration", "questionnaire"};

/// The codes are missing, missing + 1 and missing + 2: not answered, not asked, does not apply.
/// No answer is one of them.
double missing_codes(const Field& field) {
    if (field.kind == FieldKind::kCode) return field.not_applicable_code() - 2;
    if (field.kind == FieldKind::kMultiple) return 97;
    double code = -9999;
    if (field.kind == FieldKind::kDate) return code;  // seconds, and no whole days
    if (field.kind != FieldKind::kDecimal || !field.minimum) return 0;
    // A questionnaire's least number is -1e9: there is always a whole number below it.
    while (code + 2 >= *field.minimum) code = 10 * code - 9;
    return code;
}

}  // namespace

std::string spss_date_text(double seconds) {
    const std::chrono::year_month_day date{std::chrono::sys_days{
        std::chrono::days(static_cast<int>(std::lround(seconds / kDay_s - kDaysTo1970)))}};
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%04d-%02u-%02u", static_cast<int>(date.year()),
                  static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()));
    return text.data();
}

std::vector<SpssColumn> spss_columns(const Form& form) {
    std::vector<SpssColumn> columns;
    std::set<std::string> used;
    for (const char* head : kHead) {
        SpssColumn column;
        column.head = head;
        column.name = spss_name(head, used);
        columns.push_back(column);
    }
    for (const Field& field : form.fields) {
        SpssColumn column;
        column.field = &field;
        column.missing = missing_codes(field);
        if (field.kind != FieldKind::kMultiple) {
            column.name = spss_name(field.id, used);
            columns.push_back(column);
            continue;
        }
        for (const Code& code : field.codes) {
            column.choice = code.value;
            column.name = spss_name(field.id + "_" + std::to_string(code.value), used);
            columns.push_back(column);
        }
    }
    return columns;
}

std::string spss_head_text(const Form& form, const Row& row, const std::string& head) {
    if (head == "participant") return row.participant;
    if (head == "answered_utc") return row.at_utc;
    if (head == "language") return row.language;
    return form.id + " version " + std::to_string(form.version);
}

size_t spss_width(const Form& form, const SpssColumn& column) {
    size_t width = 1;
    for (const Row& row : form.rows) {
        if (column.field == nullptr) {
            width = std::max(width, spss_head_text(form, row, column.head).size());
        } else if (const auto found = row.values.find(column.field->id);
                   found != row.values.end()) {
            width = std::max(width, found->second.size());
        }
    }
    if (width > kLongestText)
        throw ReportError("export spss: " + form.name + " " + column.name + " has an answer of " +
                          std::to_string(width) + " bytes; SPSS holds " +
                          std::to_string(kLongestText) + "; use another format");
    return width;
}

std::optional<double> spss_number(const Row& row, const SpssColumn& column) {
    const Field& field = *column.field;
    const auto found = row.values.find(field.id);
    if (found == row.values.end()) {
        if (column.missing == 0) return std::nullopt;
        return row.not_asked.contains(field.id) ? column.missing + 1 : column.missing;
    }
    if (found->second == curriculum::kNotApplicable && field.not_applicable)
        return column.missing + 2;
    if (field.kind == FieldKind::kDate) return date_seconds(found->second);
    if (field.kind != FieldKind::kMultiple) return curriculum::answer_number(found->second);
    for (const int index : curriculum::answer_indices(found->second).value_or(std::vector<int>{}))
        if (index == column.choice) return 1;
    return 0;
}

}  // namespace placode::reports
