// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/redcap_dictionary.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "reports/csv_table.h"
#include "reports/export.h"
#include "reports/report.h"
#include "reports/text.h"

namespace placode::reports {
namespace {

const std::vector<std::string> kDictionaryHead{"Variable / Field Name",
                                               "Form Name",
                                               "Section Header",
                                               "Field Type",
                                               "Field Label",
                                               "Choices, Calculations, OR Slider Labels",
                                               "Field Note",
                                               "Text Validation Type OR Show Slider Number",
                                               "Text Validation Min",
                                               "Text Validation Max",
                                               "Identifier?",
                                               "Branching Logic (Show field only if...)",
                                               "Required Field?",
                                               "Custom Alignment",
                                               "Question Number (surveys only)",
                                               "Matrix Group Name",
                                               "Matrix Ranking?",
                                               "Field Annotation"};

/// '|' separates choices and a line break ends them.
std::string choice_text(std::string text) {
    for (char& c : text)
        if (c == '|' || c == '\n' || c == '\r') c = '/';
    return text;
}

/// REDCap's slider keeps whole numbers only.
bool is_slider(const Form& form, const Field& field) {
    if (!field.analogue) return false;
    return std::all_of(form.rows.begin(), form.rows.end(), [&](const Row& row) {
        const auto found = row.values.find(field.id);
        if (found == row.values.end()) return true;
        const auto value = curriculum::answer_number(found->second);
        return !value || *value == std::floor(*value);
    });
}

const char* field_type(const Form& form, const Field& field) {
    switch (field.kind) {
        case FieldKind::kCode:
            return "radio";
        case FieldKind::kMultiple:
            return "checkbox";
        case FieldKind::kDecimal:
            return is_slider(form, field) ? "slider" : "text";
        case FieldKind::kText:
            return form.licence.empty() ? "text" : "notes";
        case FieldKind::kDate:
            break;
    }
    return "text";
}

std::string choices_of(const Form& form, const Field& field) {
    if (is_slider(form, field))
        return choice_text(field.anchor_low) + " |  | " + choice_text(field.anchor_high);
    std::string text;
    for (const Code& code : field.codes) {
        const std::string value = std::to_string(code.value);
        text += (text.empty() ? "" : " | ") + value + ", " +
                (code.label.empty() ? value : choice_text(code.label));
    }
    if (!text.empty() && field.not_applicable)
        text += " | " + std::to_string(field.not_applicable_code()) + ", does not apply";
    return text;
}

std::string validation_of(const Form& form, const Field& field) {
    if (is_slider(form, field)) return "number";
    // "NA" is no number and no date; the project's missing data codes would have to allow it.
    if (field.not_applicable) return "";
    if (field.kind == FieldKind::kDate) return "date_ymd";
    return field.kind == FieldKind::kDecimal ? "number" : "";
}

/// `[name] = '1' or [name] = '2'`; a checkbox has one name a choice.
std::string branching_of(const Form& form, const Field& field) {
    if (!field.show_if) return {};
    const Field* asked = form.field(field.show_if->item);
    if (asked == nullptr) return {};
    std::string text;
    for (const std::string& answer : field.show_if->any_of) {
        text += text.empty() ? "" : " or ";
        if (asked->kind == FieldKind::kMultiple)
            text += "[" + asked->name + "(" + answer + ")] = '1'";
        else
            text += "[" + asked->name + "] = '" + answer + "'";
    }
    return text;
}

/// Neighbours with the same choices stand in one matrix.
bool same_matrix(const Field& a, const Field& b) {
    const auto key = [](const Code& x, const Code& y) {
        return x.value == y.value && x.label == y.label;
    };
    return a.ordinal && b.ordinal && a.section == b.section &&
           a.not_applicable == b.not_applicable && !a.show_if && !b.show_if &&
           std::equal(a.codes.begin(), a.codes.end(), b.codes.begin(), b.codes.end(), key);
}

}  // namespace

std::string redcap_dictionary(const Dataset& data) {
    std::string text = csv_line(kDictionaryHead);
    for (const Form& form : data.forms) {
        if (&form == &data.forms.front())
            text += csv_line({"record_id", redcap_form_name(form), "", "text", "Pseudonymous code",
                              "", "", "", "", "", "", "", "", "", "", "", "", ""});
        std::string section;
        int matrix = 0;
        for (size_t i = 0; i < form.fields.size(); ++i) {
            const Field& field = form.fields[i];
            const bool with_last = i > 0 && same_matrix(form.fields[i - 1], field);
            const bool with_next =
                i + 1 < form.fields.size() && same_matrix(field, form.fields[i + 1]);
            if (with_next && !with_last) ++matrix;
            std::string note = field.unit;
            if (field.analogue && !is_slider(form, field))
                note = field.anchor_low + " ... " + field.anchor_high;
            text += csv_line(
                {field.name, redcap_form_name(form), field.section != section ? field.section : "",
                 field_type(form, field), harmless(field.label), choices_of(form, field),
                 harmless(note), validation_of(form, field),
                 field.minimum ? shortest_text(*field.minimum) : "",
                 field.maximum ? shortest_text(*field.maximum) : "", field.identifying ? "y" : "",
                 branching_of(form, field), field.required ? "y" : "", "", "",
                 with_last || with_next ? redcap_form_name(form) + "_m" + std::to_string(matrix)
                                        : "",
                 "", field.derived ? "@READONLY" : ""});
            section = field.section;
        }
    }
    return text;
}

void check_redcap_dictionary(const Dataset& data, const std::string& path) {
    const auto rows = parse_csv(read_file(path));
    size_t fields = 2;  // head and record_id
    for (const Form& form : data.forms) fields += form.fields.size();
    if (rows.size() != fields || rows[0] != kDictionaryHead)
        throw ReportError("export redcap: read back, " + path + " does not hold every field");
    std::set<std::string> names;
    for (size_t r = 1; r < rows.size(); ++r)
        if (rows[r].size() != kDictionaryHead.size() || !names.insert(rows[r][0]).second)
            throw ReportError("export redcap: read back, " + path + " row " +
                              std::to_string(r + 1) + " is short or names a field twice");
}

}  // namespace placode::reports
