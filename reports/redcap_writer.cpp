// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// REDCap: a data dictionary (redcap_dictionary.cpp) and the records to import after it.

#include <algorithm>
#include <cmath>

#include "reports/csv_table.h"
#include "reports/formats.h"
#include "reports/redcap_dictionary.h"
#include "reports/report.h"
#include "reports/text.h"

namespace placode::reports {
namespace {

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
        columns.push_back(redcap_form_name(form) + "_complete");
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
            record[redcap_form_name(form) + "_complete"] = "2";
            for (const auto& [id, value] : row.values)
                if (const Field* field = form.field(id)) put(record, *field, value);
            // Who has only repeated forms has a record as well.
            once[row.participant]["record_id"] = row.participant;
            if (!form.repeating) continue;
            fresh["redcap_repeat_instrument"] = redcap_form_name(form);
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
            if (form.repeating && instrument != redcap_form_name(form)) continue;
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

std::string path_of(const std::string& folder, const Dataset& data, const char* ending) {
    return folder + "/" + file_name(data.id) + ending;
}

}  // namespace

void write_redcap(const ExportSource& source, const std::string& folder) {
    save_file(path_of(folder, source.data, "_redcap_dictionary.csv"),
              redcap_dictionary(source.data));
    save_file(path_of(folder, source.data, "_redcap_records.csv"), records_text(source.data));
}

void verify_redcap(const ExportSource& source, const std::string& folder) {
    check_redcap_dictionary(source.data, path_of(folder, source.data, "_redcap_dictionary.csv"));
    compare_cells(cells_of(source.data),
                  read_records(source.data, path_of(folder, source.data, "_redcap_records.csv")),
                  "export redcap");
}

}  // namespace placode::reports
