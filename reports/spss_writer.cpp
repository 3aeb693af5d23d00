// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// SPSS system files through ReadStat: one .sav a form, with labels, measure level, and three
// missing codes that tell "not answered" from "not asked" and "does not apply".

#include <fcntl.h>
#include <readstat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>

#include "reports/formats.h"
#include "reports/report.h"
#include "reports/text.h"

namespace placode::reports {
namespace {

/// SPSS counts seconds from 14 October 1582, 141,428 days before 1970.
constexpr double kDaysTo1970 = 141428, kDay_s = 86400;
/// ReadStat's and SPSS's longest text.
constexpr size_t kLongestText = 32767, kLongestLabel = 120;

double date_seconds(const std::string& date) {
    const std::chrono::sys_days day =
        std::chrono::year(std::atoi(date.substr(0, 4).c_str())) /
        std::chrono::month(static_cast<unsigned>(std::atoi(date.substr(5, 2).c_str()))) /
        std::chrono::day(static_cast<unsigned>(std::atoi(date.substr(8, 2).c_str())));
    return (day.time_since_epoch().count() + kDaysTo1970) * kDay_s;
}

std::string date_text(double seconds) {
    const std::chrono::year_month_day date{std::chrono::sys_days{
        std::chrono::days(static_cast<int>(std::lround(seconds / kDay_s - kDaysTo1970)))}};
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%04d-%02u-%02u", static_cast<int>(date.year()),
                  static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()));
    return text.data();
}

/// At most `limit` bytes, never half a letter.
std::string cut(std::string text, size_t limit) {
    if (text.size() <= limit) return text;
    size_t end = limit;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0U) == 0x80U) --end;
    text.resize(end);
    return text;
}

/// One column of the file. A field with several choices becomes one column a choice.
struct Column {
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
double missing_codes(const Field& field) {
    if (field.kind == FieldKind::kCode) return field.not_applicable_code() - 2;
    if (field.kind == FieldKind::kMultiple) return 97;
    if (field.kind == FieldKind::kDecimal && field.minimum && *field.minimum > -9000) return -9999;
    return 0;
}

std::vector<Column> columns_of(const Form& form) {
    std::vector<Column> columns;
    std::set<std::string> used;
    for (const char* head : kHead) {
        Column column;
        column.head = head;
        column.name = spss_name(head, used);
        columns.push_back(column);
    }
    for (const Field& field : form.fields) {
        Column column;
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

std::string head_text(const Form& form, const Row& row, const std::string& head) {
    if (head == "participant") return row.participant;
    if (head == "answered_utc") return row.at_utc;
    if (head == "language") return row.language;
    return form.id + " version " + std::to_string(form.version);
}

size_t width_of(const Form& form, const Column& column) {
    size_t width = 1;
    for (const Row& row : form.rows) {
        if (column.field == nullptr) {
            width = std::max(width, head_text(form, row, column.head).size());
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

/// A number for a cell, or nothing for system-missing.
std::optional<double> number_of(const Row& row, const Column& column) {
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

void add_labels(Writer& writer, Column& column, size_t index) {
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

std::string label_of(const Column& column) {
    const Field& field = *column.field;
    std::string label = field.label;
    if (!field.unit.empty()) label += " [" + field.unit + "]";
    if (field.kind == FieldKind::kMultiple)
        for (const Code& code : field.codes)
            if (code.value == column.choice) label += ": " + code.label;
    return cut(label, 255);
}

void add_variable(Writer& writer, const Form& form, Column& column, size_t index) {
    const bool text = column.is_text();
    column.variable = readstat_add_variable(writer.get(), column.name.c_str(),
                                            text ? READSTAT_TYPE_STRING : READSTAT_TYPE_DOUBLE,
                                            text ? width_of(form, column) : 0);
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
               const std::vector<Column>& columns) {
    writer.need(readstat_begin_row(writer.get()));
    for (const Column& column : columns) {
        if (column.is_text()) {
            std::string text;
            if (column.field == nullptr)
                text = head_text(form, row, column.head);
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
            number = number_of(row, column);
        writer.need(number ? readstat_insert_double_value(writer.get(), column.variable, *number)
                           : readstat_insert_missing_value(writer.get(), column.variable));
    }
    writer.need(readstat_end_row(writer.get()));
}

void write_form(const Dataset& data, const Form& form, const std::string& path) {
    Writer writer(path);
    std::vector<Column> columns = columns_of(form);
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
    std::vector<Column> columns;
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

void take_number(Reading& reading, const Column& column, double number) {
    const Field& field = *column.field;
    if (column.missing != 0 && (number == column.missing || number == column.missing + 1)) return;
    std::string& value = reading.values[field.id];
    if (column.missing != 0 && number == column.missing + 2)
        value = curriculum::kNotApplicable;
    else if (field.kind == FieldKind::kDate)
        value = date_text(number);
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
    const Column& column = reading.columns[index];
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
    reading.columns = columns_of(form);
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
