// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// SPSS system files through ReadStat: one .sav a form, with labels, measure level, and three
// missing codes that tell "not answered" from "not asked" and "does not apply".

#include <fcntl.h>
#include <unistd.h>

#include <array>

#include "reports/formats.h"
#include "reports/report.h"
#include "reports/spss_columns.h"
#include "reports/text.h"

namespace placode::reports {
namespace {

constexpr size_t kLongestLabel = 120;

/// At most `limit` bytes, never half a letter.
std::string cut(std::string text, size_t limit) {
    if (text.size() <= limit) return text;
    size_t end = limit;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0U) == 0x80U) --end;
    text.resize(end);
    return text;
}

class Writer {
 public:
    explicit Writer(const std::string& path) : path_(path), writer_(readstat_writer_init()) {
        file_ = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
        if (file_ < 0) throw ReportError("write " + path + ": cannot be made");
        readstat_set_data_writer(writer_, [](const void* data, size_t length, void* context) {
            return ::write(*static_cast<int*>(context), data, length);
        });
    }
    ~Writer() {
        readstat_writer_free(writer_);
        if (file_ >= 0) ::close(file_);
    }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;

    void need(readstat_error_t error) const {
        if (error != READSTAT_OK)
            throw ReportError("write " + path_ + ": " + readstat_error_message(error));
    }
    [[nodiscard]] readstat_writer_t* get() const { return writer_; }
    [[nodiscard]] int* file() { return &file_; }

 private:
    std::string path_;
    readstat_writer_t* writer_;
    int file_ = -1;
};

void add_labels(Writer& writer, SpssColumn& column, size_t index) {
    const Field& field = *column.field;
    readstat_label_set_t* labels = readstat_add_label_set(writer.get(), READSTAT_TYPE_DOUBLE,
                                                          ("l" + std::to_string(index)).c_str());
    if (field.kind == FieldKind::kMultiple) {
        readstat_label_double_value(labels, 0, "not chosen");
        readstat_label_double_value(labels, 1, "chosen");
    }
    if (field.kind == FieldKind::kCode)
        for (const Code& code : field.codes)
            if (!code.label.empty())
                readstat_label_double_value(labels, code.value,
                                            cut(code.label, kLongestLabel).c_str());
    constexpr std::array<const char*, 3> kWords{"not answered", "not asked", "does not apply"};
    for (size_t i = 0; i < kWords.size(); ++i) {
        const double code = column.missing + static_cast<double>(i);
        readstat_label_double_value(labels, code, kWords[i]);
        writer.need(readstat_variable_add_missing_double_value(column.variable, code));
    }
    readstat_variable_set_label_set(column.variable, labels);
}

std::string label_of(const SpssColumn& column) {
    const Field& field = *column.field;
    std::string label = field.label;
    if (!field.unit.empty()) label += " [" + field.unit + "]";
    if (field.kind == FieldKind::kMultiple)
        for (const Code& code : field.codes)
            if (code.value == column.choice) label += ": " + code.label;
    return cut(label, 255);
}

void add_variable(Writer& writer, const Form& form, SpssColumn& column, size_t index) {
    const bool text = column.is_text();
    column.variable = readstat_add_variable(writer.get(), column.name.c_str(),
                                            text ? READSTAT_TYPE_STRING : READSTAT_TYPE_DOUBLE,
                                            text ? spss_width(form, column) : 0);
    if (column.field == nullptr) {
        readstat_variable_set_measure(column.variable,
                                      text ? READSTAT_MEASURE_NOMINAL : READSTAT_MEASURE_SCALE);
        return;
    }
    const Field& field = *column.field;
    readstat_variable_set_label(column.variable, label_of(column).c_str());
    const bool nominal = text || field.kind == FieldKind::kMultiple ||
                         (field.kind == FieldKind::kCode && !field.ordinal);
    readstat_variable_set_measure(column.variable, nominal         ? READSTAT_MEASURE_NOMINAL
                                                   : field.ordinal ? READSTAT_MEASURE_ORDINAL
                                                                   : READSTAT_MEASURE_SCALE);
    if (field.kind == FieldKind::kDate) readstat_variable_set_format(column.variable, "SDATE10");
    if (field.kind == FieldKind::kCode || field.kind == FieldKind::kMultiple)
        readstat_variable_set_format(column.variable, "F8.0");
    if (!text && column.missing != 0) add_labels(writer, column, index);
}

void write_row(Writer& writer, const Form& form, const Row& row,
               const std::vector<SpssColumn>& columns) {
    writer.need(readstat_begin_row(writer.get()));
    for (const SpssColumn& column : columns) {
        if (column.is_text()) {
            std::string text;
            if (column.field == nullptr)
                text = spss_head_text(form, row, column.head);
            else if (const auto found = row.values.find(column.field->id);
                     found != row.values.end())
                text = found->second;
            writer.need(readstat_insert_string_value(writer.get(), column.variable, text.c_str()));
            continue;
        }
        std::optional<double> number;
        if (column.field == nullptr)
            number = column.head == "instance" ? row.instance : (row.demonstration ? 1 : 0);
        else
            number = spss_number(row, column);
        writer.need(number ? readstat_insert_double_value(writer.get(), column.variable, *number)
                           : readstat_insert_missing_value(writer.get(), column.variable));
    }
    writer.need(readstat_end_row(writer.get()));
}

void write_form(const Dataset& data, const Form& form, const std::string& path) {
    Writer writer(path);
    std::vector<SpssColumn> columns = spss_columns(form);
    for (size_t i = 0; i < columns.size(); ++i) add_variable(writer, form, columns[i], i);
    writer.need(readstat_writer_set_file_label(
        writer.get(),
        cut((data.demonstration ? "DEMONSTRATION " : "") + data.id + " " + form.name, 60).c_str()));
    writer.need(readstat_begin_writing_sav(writer.get(), writer.file(),
                                           static_cast<long>(form.rows.size())));
    for (const Row& row : form.rows) write_row(writer, form, row, columns);
    writer.need(readstat_end_writing(writer.get()));
}

// --- reading back ------------------------------------------------------------------------------

struct Reading {
    const Form* form = nullptr;
    std::vector<SpssColumn> columns;
    int row = -1;
    std::string participant, instance;
    std::map<std::string, std::string> values;  ///< Of the row that is being read.
    Cells cells;

    void end_row() {
        if (row >= 0)
            for (const auto& [id, value] : values)
                cells[form->name + "|" + participant + "|" + instance + "|" + id] = value;
        values.clear();
    }
};

void take_number(Reading& reading, const SpssColumn& column, double number) {
    const Field& field = *column.field;
    if (column.missing != 0 && (number == column.missing || number == column.missing + 1)) return;
    std::string& value = reading.values[field.id];
    if (column.missing != 0 && number == column.missing + 2)
        value = curriculum::kNotApplicable;
    else if (field.kind == FieldKind::kDate)
        value = spss_date_text(number);
    else if (field.kind != FieldKind::kMultiple)
        value = shortest_text(number);
    else if (number == 1)
        value += (value.empty() ? "" : ";") + std::to_string(column.choice);
}

int take_value(int row, readstat_variable_t* variable, readstat_value_t value, void* context) {
    auto& reading = *static_cast<Reading*>(context);
    if (row != reading.row) reading.end_row();
    reading.row = row;
    const auto index = static_cast<size_t>(readstat_variable_get_index(variable));
    if (index >= reading.columns.size()) return READSTAT_HANDLER_ABORT;
    const SpssColumn& column = reading.columns[index];
    if (column.name != readstat_variable_get_name(variable)) return READSTAT_HANDLER_ABORT;
    if (column.is_text()) {
        const char* text = readstat_string_value(value);
        if (column.head == "participant") reading.participant = text == nullptr ? "" : text;
        if (column.field != nullptr && text != nullptr && *text != '\0')
            reading.values[column.field->id] = text;
        return READSTAT_HANDLER_OK;
    }
    const double number = readstat_double_value(value);
    if (column.head == "instance") reading.instance = shortest_text(number);
    if (column.field != nullptr && readstat_value_is_system_missing(value) == 0)
        take_number(reading, column, number);
    return READSTAT_HANDLER_OK;
}

Cells read_form(const Form& form, const std::string& path) {
    Reading reading;
    reading.form = &form;
    reading.columns = spss_columns(form);
    readstat_parser_t* parser = readstat_parser_init();
    // ReadStat 1.1.8 hands out values only where somebody listens to variables: else it crashes.
    readstat_set_variable_handler(parser, [](int, readstat_variable_t*, const char*, void*) -> int {
        return READSTAT_HANDLER_OK;
    });
    readstat_set_value_handler(parser, take_value);
    const readstat_error_t error = readstat_parse_sav(parser, path.c_str(), &reading);
    readstat_parser_free(parser);
    if (error != READSTAT_OK)
        throw ReportError("read " + path + ": " + readstat_error_message(error));
    reading.end_row();
    return reading.cells;
}

}  // namespace

void write_spss(const ExportSource& source, const std::string& folder) {
    for (const Form& form : source.data.forms)
        write_form(source.data, form, form_path(folder, source.data, form, ".sav"));
}

void verify_spss(const ExportSource& source, const std::string& folder) {
    Cells found;
    for (const Form& form : source.data.forms)
        found.merge(read_form(form, form_path(folder, source.data, form, ".sav")));
    // SPSS pads text with spaces and cannot tell them from typed ones at the end.
    Cells expected = cells_of(source.data);
    for (auto& [key, value] : expected) value.erase(value.find_last_not_of(' ') + 1);
    compare_cells(expected, found, "export spss");
}

}  // namespace placode::reports
