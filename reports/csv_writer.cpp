// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// CSV for people and statistics programs: one wide file a form, one long file, one codebook.

#include "reports/csv_table.h"
#include "reports/formats.h"
#include "reports/report.h"
#include "reports/text.h"

namespace placode::reports {
namespace {

bool is_text(const Field& field) { return field.kind == FieldKind::kText; }

std::string cell_of(const Field& field, const std::string& value) {
    return is_text(field) ? harmless(value) : value;
}

const std::vector<std::string> kRowHead{
    "study_id",     "participant", "questionnaire_id", "questionnaire_version",
    "answered_utc", "language",    "instance",         "demonstration"};

std::vector<std::string> row_head(const Dataset& data, const Form& form, const Row& row) {
    return {harmless(data.id),
            row.participant,
            form.id,
            std::to_string(form.version),
            row.at_utc,
            row.language,
            std::to_string(row.instance),
            row.demonstration ? "1" : "0"};
}

/// Why a cell has no value; empty for one that has.
std::string missing_reason(const Row& row, const Field& field) {
    const auto found = row.values.find(field.id);
    if (found != row.values.end())
        return found->second == curriculum::kNotApplicable && field.not_applicable
                   ? "not applicable"
                   : "";
    if (row.not_asked.contains(field.id)) return "not asked";
    return field.derived ? "too few items answered" : "not answered";
}

std::string wide_text(const Dataset& data, const Form& form) {
    std::vector<std::string> head = kRowHead;
    for (const Field& field : form.fields) head.push_back(field.id);
    std::string text = csv_line(head);
    for (const Row& row : form.rows) {
        std::vector<std::string> cells = row_head(data, form, row);
        for (const Field& field : form.fields) {
            // Missing stays empty: never a 0 that a mean would swallow.
            const auto found = row.values.find(field.id);
            cells.push_back(found == row.values.end() ? "" : cell_of(field, found->second));
        }
        text += csv_line(cells);
    }
    return text;
}

std::string label_of(const Field& field, const std::string& value) {
    for (const Code& code : field.codes)
        if (value == std::to_string(code.value)) return code.label;
    return {};
}

std::string long_text(const Dataset& data) {
    std::vector<std::string> head = kRowHead;
    for (const char* name : {"item", "value", "value_label", "missing"}) head.emplace_back(name);
    std::string text = csv_line(head);
    for (const Form& form : data.forms) {
        for (const Row& row : form.rows) {
            for (const Field& field : form.fields) {
                const auto found = row.values.find(field.id);
                std::vector<std::string> cells = row_head(data, form, row);
                const std::string value = found == row.values.end() ? "" : found->second;
                cells.push_back(field.id);
                cells.push_back(cell_of(field, value));
                cells.push_back(harmless(label_of(field, value)));
                cells.push_back(missing_reason(row, field));
                text += csv_line(cells);
            }
        }
    }
    return text;
}

const char* kind_word(const Field& field) {
    switch (field.kind) {
        case FieldKind::kCode:
            return field.ordinal ? "ordinal" : "nominal";
        case FieldKind::kMultiple:
            return "any of several";
        case FieldKind::kDecimal:
            return "number";
        case FieldKind::kDate:
            return "date";
        case FieldKind::kText:
            break;
    }
    return "text";
}

std::string condition_text(const Field& field) {
    if (!field.show_if) return {};
    std::string text = field.show_if->item + " is ";
    for (size_t i = 0; i < field.show_if->any_of.size(); ++i)
        text += (i == 0 ? "" : " or ") + field.show_if->any_of[i];
    return text;
}

std::string codebook_text(const Dataset& data) {
    std::string text =
        csv_line({"form", "form_version", "item", "name_in_redcap", "question", "kind", "values",
                  "unit", "minimum", "maximum", "required", "not_applicable", "reverse_keyed",
                  "asked_when", "computed", "identifying", "source", "licence"});
    for (const Form& form : data.forms) {
        for (const Field& field : form.fields) {
            std::string values;
            for (const Code& code : field.codes) {
                values += (values.empty() ? "" : " | ") + std::to_string(code.value);
                if (!code.label.empty()) values += " = " + code.label;
            }
            if (field.derived) values = field.rule;
            if (field.analogue) values = field.anchor_low + " ... " + field.anchor_high;
            const auto yes = [](bool truth) { return truth ? "yes" : "no"; };
            text +=
                csv_line({form.id, std::to_string(form.version), field.id, field.name,
                          harmless(field.label), kind_word(field), harmless(values),
                          harmless(field.unit), field.minimum ? shortest_text(*field.minimum) : "",
                          field.maximum ? shortest_text(*field.maximum) : "", yes(field.required),
                          field.not_applicable ? "yes (NA)" : "no", yes(field.reverse),
                          condition_text(field), yes(field.derived), yes(field.identifying),
                          harmless(form.source), harmless(form.licence)});
        }
    }
    return text;
}

size_t column_of(const std::vector<std::string>& head, const std::string& name,
                 const std::string& path) {
    for (size_t i = 0; i < head.size(); ++i)
        if (head[i] == name) return i;
    throw ReportError("read " + path + ": there is no column \"" + name + "\"");
}

std::string key_of(const Form& form, const std::string& participant, const std::string& instance,
                   const std::string& item) {
    return form.name + "|" + participant + "|" + instance + "|" + item;
}

Cells read_wide(const Form& form, const std::string& path) {
    Cells cells;
    const auto rows = parse_csv(read_file(path));
    const size_t who = column_of(rows.at(0), "participant", path);
    const size_t instance = column_of(rows.at(0), "instance", path);
    for (size_t r = 1; r < rows.size(); ++r) {
        if (rows[r].size() != rows[0].size())
            throw ReportError("read " + path + ": row " + std::to_string(r + 1) + " has " +
                              std::to_string(rows[r].size()) + " cells, the head " +
                              std::to_string(rows[0].size()));
        for (size_t c = kRowHead.size(); c < rows[r].size(); ++c) {
            const Field* field = form.field(rows[0][c]);
            if (field == nullptr || rows[r][c].empty()) continue;
            cells[key_of(form, rows[r][who], rows[r][instance], field->id)] =
                is_text(*field) ? as_typed(rows[r][c]) : rows[r][c];
        }
    }
    return cells;
}

Cells read_long(const Dataset& data, const std::string& path) {
    Cells cells;
    const auto rows = parse_csv(read_file(path));
    const auto at = [&](const char* name) { return column_of(rows.at(0), name, path); };
    const size_t who = at("participant"), form_column = at("questionnaire_id"),
                 version = at("questionnaire_version"), instance = at("instance"),
                 item = at("item"), value = at("value");
    for (size_t r = 1; r < rows.size(); ++r) {
        for (const Form& form : data.forms) {
            if (form.id != rows[r].at(form_column) ||
                std::to_string(form.version) != rows[r].at(version))
                continue;
            const Field* field = form.field(rows[r].at(item));
            if (field == nullptr || rows[r].at(value).empty()) continue;
            cells[key_of(form, rows[r].at(who), rows[r].at(instance), field->id)] =
                is_text(*field) ? as_typed(rows[r][value]) : rows[r][value];
        }
    }
    return cells;
}

std::string study_path(const std::string& folder, const Dataset& data, const char* ending) {
    return folder + "/" + file_name(data.id) + ending;
}

}  // namespace

std::string form_path(const std::string& folder, const Dataset& data, const Form& form,
                      const std::string& ending) {
    return folder + "/" + file_name(data.id) + "_" + file_name(form.name) + ending;
}

void write_csv(const ExportSource& source, const std::string& folder) {
    const Dataset& data = source.data;
    for (const Form& form : data.forms)
        save_file(form_path(folder, data, form, ".csv"), wide_text(data, form));
    save_file(study_path(folder, data, "_long.csv"), long_text(data));
    save_file(study_path(folder, data, "_codebook.csv"), codebook_text(data));
}

void verify_csv(const ExportSource& source, const std::string& folder) {
    const Dataset& data = source.data;
    Cells wide;
    for (const Form& form : data.forms)
        wide.merge(read_wide(form, form_path(folder, data, form, ".csv")));
    compare_cells(cells_of(data), wide, "export csv (wide)");
    compare_cells(cells_of(data), read_long(data, study_path(folder, data, "_long.csv")),
                  "export csv (long)");
    size_t fields = 1;
    for (const Form& form : data.forms) fields += form.fields.size();
    if (parse_csv(read_file(study_path(folder, data, "_codebook.csv"))).size() != fields)
        throw ReportError("export csv: read back, the codebook does not name every field");
}

}  // namespace placode::reports
