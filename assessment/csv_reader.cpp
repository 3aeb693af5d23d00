// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/csv_reader.h"

#include <algorithm>
#include <utility>

namespace placode::assessment {
namespace {

class Reader {
 public:
    Reader(std::string_view text, char separator) : text_(text), separator_(separator) {}

    std::vector<CsvRow> rows() {
        std::vector<CsvRow> found;
        while (at_ < text_.size()) {
            CsvRow row{{}, line_};
            do {
                row.cells.push_back(cell(row.cells.size() + 1));
            } while (skip_separator());
            end_line();
            found.push_back(std::move(row));
        }
        return found;
    }

 private:
    [[nodiscard]] bool ends_line(char c) const { return c == '\n' || c == '\r'; }

    std::string cell(size_t column) {
        if (at_ < text_.size() && text_[at_] == '"') return quoted_cell(column);
        const size_t begin = at_;
        while (at_ < text_.size() && text_[at_] != separator_ && !ends_line(text_[at_])) ++at_;
        return std::string(text_.substr(begin, at_ - begin));
    }

    std::string quoted_cell(size_t column) {
        const int begun = line_;
        std::string cell;
        for (++at_;; ++at_) {
            if (at_ == text_.size())
                fail(begun, column,
                     "a quoted cell is not closed; expected a \" before the end of the text");
            if (text_[at_] == '"') {
                if (at_ + 1 == text_.size() || text_[at_ + 1] != '"') break;
                ++at_;
            } else if (text_[at_] == '\n') {
                ++line_;
            }
            cell += text_[at_];
        }
        ++at_;
        if (at_ < text_.size() && text_[at_] != separator_ && !ends_line(text_[at_]))
            fail(line_, column,
                 std::string("found \"") + text_[at_] + "\" after a closing quote; expected \"" +
                     separator_ + "\" or the end of the line");
        return cell;
    }

    bool skip_separator() {
        if (at_ == text_.size() || text_[at_] != separator_) return false;
        ++at_;
        return true;
    }

    void end_line() {
        if (at_ < text_.size() && text_[at_] == '\r') ++at_;
        if (at_ < text_.size() && text_[at_] == '\n') ++at_;
        ++line_;
    }

    [[noreturn]] static void fail(int line, size_t column, const std::string& what) {
        throw CsvError("line " + std::to_string(line) + ", column " + std::to_string(column) +
                       ": " + what);
    }

    std::string_view text_;
    char separator_;
    size_t at_ = 0;
    int line_ = 1;
};

bool is_empty(const CsvRow& row) { return row.cells.size() == 1 && row.cells[0].empty(); }

}  // namespace

std::vector<CsvRow> read_csv(std::string_view text, char separator) {
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    return Reader(text, separator).rows();
}

void need_commas(const std::vector<CsvRow>& rows) {
    if (rows.empty()) return;
    const std::string& head = rows[0].cells[0];
    // As UTF-16 it has a mark that is no letter of UTF-8, and a NUL at every letter.
    if (head.starts_with("\xff\xfe") || head.starts_with("\xfe\xff"))
        throw CsvError("line 1: found UTF-16; expected UTF-8: save it as CSV UTF-8 with commas");
    if (rows[0].cells.size() != 1) return;
    for (const auto& [sign, name] : {std::pair{';', "semicolons"}, std::pair{'\t', "tabs"}})
        if (head.find(sign) != std::string::npos)
            throw CsvError(std::string("line 1: found ") + name +
                           " between the names; expected commas: save it as CSV with commas and "
                           "'.' in numbers");
}

void leave_out_empty_lines(std::vector<CsvRow>& rows) {
    rows.erase(rows.begin(), std::find_if_not(rows.begin(), rows.end(), is_empty));
    while (!rows.empty() && is_empty(rows.back())) rows.pop_back();
    if (!rows.empty() && rows.front().cells.size() > 1) std::erase_if(rows, is_empty);
}

}  // namespace placode::assessment
