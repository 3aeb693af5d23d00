// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// REDCap: a data dictionary of 18 columns and the records to import after it.

#include <algorithm>
#include <cmath>

#include "reports/csv_table.h"
#include "reports/formats.h"
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

std::string form_name(const Form& form) { return plain_name(form.name); }

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
    if (field.kind == FieldKind::kDate) return "date_ymd";
    // "NA" is no number; the project's missing data codes would have to allow it.
    return field.kind == FieldKind::kDecimal && !field.not_applicable ? "number" : "";
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

std::string dictionary_text(const Dataset& data) {
    std::string text = csv_line(kDictionaryHead);
    for (const Form& form : data.forms) {
        if (&form == &data.forms.front())
            text += csv_line({"record_id", form_name(form), "", "text", "Pseudonymous code", "", "",
                              "", "", "", "", "", "", "", "", "", "", ""});
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
                {field.name, form_name(form), field.section != section ? field.section : "",
                 field_type(form, field), harmless(field.label), choices_of(form, field),
                 harmless(note), validation_of(form, field),
                 field.minimum ? shortest_text(*field.minimum) : "",
                 field.maximum ? shortest_text(*field.maximum) : "", field.identifying ? "y" : "",
                 branching_of(form, field), field.required ? "y" : "", "", "",
                 with_last || with_next ? form_name(form) + "_m" + std::to_string(matrix) : "", "",
                 field.derived ? "@READONLY" : ""});
            section = field.section;
        }
    }
    return text;
}

std::string checkbox_name(const Field& field, const Code& code) {
    // A minus sign has no place in a name: REDCap writes an underscore.
    return field.name + "___" + (code.value < 0 ? "_" : "") + std::to_string(std::abs(code.value));
}

std::vector<std::string> record_columns(const Dataset& data, bool repeating) {
    std::vector<std::string> columns{"record_id"};
    if (repeating) {
        columns.emplace_back("redcap_repeat_instrument");
        columns.emplace_back("redcap_repeat_instance");
    }
    for (const Form& form : data.forms) {
        for (const Field& field : form.fields) {
            if (field.kind != FieldKind::kMultiple) {
                columns.push_back(field.name);
                continue;
            }
            for (const Code& code : field.codes) columns.push_back(checkbox_name(field, code));
            if (field.not_applicable)
                columns.push_back(checkbox_name(field, {field.not_applicable_code(), ""}));
        }
        columns.push_back(form_name(form) + "_complete");
    }
    return columns;
}

using Record = std::map<std::string, std::string>;

void put(Record& record, const Field& field, const std::string& value) {
    const bool missing = value == curriculum::kNotApplicable && field.not_applicable;
    if (field.kind == FieldKind::kMultiple) {
        std::vector<int> chosen = curriculum::answer_indices(value).value_or(std::vector<int>{});
        if (missing) chosen = {field.not_applicable_code()};
        for (const Code& code : field.codes)
            record[checkbox_name(field, code)] =
                std::find(chosen.begin(), chosen.end(), code.value) != chosen.end() ? "1" : "0";
        if (field.not_applicable)
            record[checkbox_name(field, {field.not_applicable_code(), ""})] = missing ? "1" : "0";
        return;
    }
    if (field.kind == FieldKind::kCode && missing)
        record[field.name] = std::to_string(field.not_applicable_code());
    else
        record[field.name] = field.kind == FieldKind::kText ? harmless(value) : value;
}

std::string records_text(const Dataset& data) {
    const bool repeating = std::any_of(data.forms.begin(), data.forms.end(),
                                       [](const Form& form) { return form.repeating; });
    const std::vector<std::string> columns = record_columns(data, repeating);
    std::map<std::string, Record> once;
    std::vector<Record> more;
    for (const Form& form : data.forms) {
        for (const Row& row : form.rows) {
            Record fresh;
            Record& record = form.repeating ? fresh : once[row.participant];
            record["record_id"] = row.participant;
            record[form_name(form) + "_complete"] = "2";
            for (const auto& [id, value] : row.values)
                if (const Field* field = form.field(id)) put(record, *field, value);
            // Who has only repeated forms has a record as well.
            once[row.participant]["record_id"] = row.participant;
            if (!form.repeating) continue;
            fresh["redcap_repeat_instrument"] = form_name(form);
            fresh["redcap_repeat_instance"] = std::to_string(row.instance);
            more.push_back(fresh);
        }
    }
    std::string text = csv_line(columns);
    const auto add = [&](const Record& record) {
        std::vector<std::string> cells;
        for (const std::string& column : columns) {
            const auto found = record.find(column);
            cells.push_back(found == record.end() ? "" : found->second);
        }
        text += csv_line(cells);
    };
    for (const auto& [code, record] : once) {
        add(record);
        for (const Record& each : more)
            if (each.at("record_id") == code) add(each);
    }
    return text;
}

std::optional<std::string> value_in(const Record& record, const Field& field) {
    if (field.kind != FieldKind::kMultiple) {
        const auto found = record.find(field.name);
        if (found == record.end() || found->second.empty()) return std::nullopt;
        if (field.kind == FieldKind::kText) return as_typed(found->second);
        if (field.kind == FieldKind::kCode && field.not_applicable &&
            found->second == std::to_string(field.not_applicable_code()))
            return curriculum::kNotApplicable;
        return found->second;
    }
    const auto ticked = [&](const Code& code) {
        const auto found = record.find(checkbox_name(field, code));
        return found != record.end() && found->second == "1";
    };
    if (field.not_applicable && ticked({field.not_applicable_code(), ""}))
        return curriculum::kNotApplicable;
    std::string value;
    for (const Code& code : field.codes)
        if (ticked(code)) value += (value.empty() ? "" : ";") + std::to_string(code.value);
    return value.empty() ? std::nullopt : std::optional(value);
}

Cells read_records(const Dataset& data, const std::string& path) {
    Cells cells;
    const auto rows = parse_csv(read_file(path));
    for (size_t r = 1; r < rows.size(); ++r) {
        Record record;
        for (size_t c = 0; c < rows[r].size(); ++c) record[rows[0].at(c)] = rows[r][c];
        const std::string instrument = record["redcap_repeat_instrument"];
        for (const Form& form : data.forms) {
            if (form.repeating != !instrument.empty()) continue;
            if (form.repeating && instrument != form_name(form)) continue;
            Row row;
            row.participant = record["record_id"];
            row.instance = form.repeating ? std::stoi(record["redcap_repeat_instance"]) : 1;
            for (const Field& field : form.fields)
                if (const auto value = value_in(record, field))
                    cells[cell_key(form, row, field)] = *value;
        }
    }
    return cells;
}

/// The dictionary must name every column of the records, as REDCap demands on import.
void check_dictionary(const Dataset& data, const std::string& path) {
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

std::string path_of(const std::string& folder, const Dataset& data, const char* ending) {
    return folder + "/" + file_name(data.id) + ending;
}

}  // namespace

void write_redcap(const ExportSource& source, const std::string& folder) {
    save_file(path_of(folder, source.data, "_redcap_dictionary.csv"), dictionary_text(source.data));
    save_file(path_of(folder, source.data, "_redcap_records.csv"), records_text(source.data));
}

void verify_redcap(const ExportSource& source, const std::string& folder) {
    check_dictionary(source.data, path_of(folder, source.data, "_redcap_dictionary.csv"));
    compare_cells(cells_of(source.data),
                  read_records(source.data, path_of(folder, source.data, "_redcap_records.csv")),
                  "export redcap");
}

}  // namespace placode::reports
