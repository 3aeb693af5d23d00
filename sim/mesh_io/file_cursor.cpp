// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/mesh_io/file_cursor.h"

#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>

#include "sim/core/number_text.h"

namespace placode::sim {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }

}  // namespace

std::string in_quotes(std::string_view text) {
    std::string out(1, '"');
    out.append(text.substr(0, 40));
    for (char& c : out) {
        // A byte 0 would end the message, half of a letter would be no text.
        if (static_cast<unsigned char>(c) < ' ' || static_cast<unsigned char>(c) >= 127) c = '?';
    }
    out += '"';
    return out;
}

FileCursor::FileCursor(const std::string& path) : file_(path) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error))
        throw MeshError(path + ": is a folder; expected a mesh file");
    std::ifstream in(path, std::ios::binary);
    if (!in) throw MeshError(path + ": cannot be opened; check path and rights");
    in.seekg(0, std::ios::end);
    const auto size = static_cast<int64_t>(in.tellg());
    in.seekg(0);
    if (size < 0 || size > std::numeric_limits<int32_t>::max())
        throw MeshError(path + ": " + std::to_string(size) + " bytes; at most 2 GiB are read");
    text_.resize(static_cast<size_t>(size));
    in.read(text_.data(), size);
    if (in.gcount() != size) throw MeshError(path + ": could not be read to its end");
    if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;  // the mark that some editors put before UTF-8
}

void FileCursor::fail(const std::string& message) const {
    if (!binary_) fail_at(line_, message);
    throw MeshError(file_ + ": byte " + std::to_string(at_) + ": " + message);
}

void FileCursor::fail_at(int line, const std::string& message) const {
    throw MeshError(file_ + ": line " + std::to_string(line) + ": " + message);
}

void FileCursor::fail_expecting(std::string_view found, std::string_view what) const {
    const std::string wanted =
        " where " + std::string(what) + " is expected" + (part_.empty() ? "" : "; " + part_);
    fail(found.empty() ? "the file is cut off: it ends" + wanted : in_quotes(found) + wanted);
}

void FileCursor::fail_cut_off(std::string_view what) const {
    throw MeshError(file_ + ": the file is cut off: it ends at byte " +
                    std::to_string(text_.size()) + ", inside " + std::string(what));
}

void FileCursor::check_point(int64_t id, const Vec3& x) const {
    for (int a = 0; a < 3; ++a) {
        if (!std::isfinite(x[a]))
            fail("point " + std::to_string(id) + ": " + "xyz"[a] + " is " + shortest_text(x[a]) +
                 "; expected a finite number");
    }
}

void FileCursor::skip_space() {
    while (at_ < text_.size()) {
        const char c = text_[at_];
        if (hash_comments_ && c == '#') {
            while (at_ < text_.size() && text_[at_] != '\n') ++at_;
            continue;
        }
        if (!is_space(c)) return;
        if (c == '\n') ++line_;
        ++at_;
    }
}

bool FileCursor::at_end() {
    skip_space();
    return at_ == text_.size();
}

std::string_view FileCursor::word() {
    skip_space();
    const size_t start = at_;
    // '<' ends a word, so that "5</DataArray>" reads as 5; no other format has it.
    while (at_ < text_.size() && !is_space(text_[at_]) && (text_[at_] != '<' || at_ == start))
        ++at_;
    return std::string_view(text_).substr(start, at_ - start);
}

std::string_view FileCursor::peek() {
    const std::string_view next = word();
    at_ -= next.size();
    return next;
}

std::string_view FileCursor::rest_of_line() {
    size_t end = text_.find('\n', at_);
    if (end == std::string::npos) end = text_.size();
    std::string_view line = std::string_view(text_).substr(at_, end - at_);
    at_ = end;
    end_line();
    while (!line.empty() && is_space(line.front())) line.remove_prefix(1);
    while (!line.empty() && is_space(line.back())) line.remove_suffix(1);
    return line;
}

void FileCursor::end_line() {
    if (at_ < text_.size() && text_[at_] == '\r') ++at_;
    if (at_ < text_.size() && text_[at_] == '\n') {
        ++at_;
        ++line_;
    }
}

int64_t FileCursor::whole(std::string_view what) {
    std::string_view text = word();
    if (text.empty()) fail_expecting("", what);
    const std::string found(text);
    if (text.front() == '+') text.remove_prefix(1);
    int64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size())
        fail_expecting(found, std::string(what) + " (a whole number)");
    return value;
}

int64_t FileCursor::checked_count(int64_t n, std::string_view what) const {
    if (n < 0 || n > static_cast<int64_t>(text_.size()))
        fail(std::string(what) + " " + std::to_string(n) + " is not possible in a file of " +
             std::to_string(text_.size()) + " bytes");
    return n;
}

int64_t FileCursor::count(std::string_view what) { return checked_count(whole(what), what); }

double FileCursor::real(std::string_view what) {
    std::string_view text = word();
    if (text.empty()) fail_expecting("", what);
    const std::string found(text);
    if (text.front() == '+') text.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc::result_out_of_range && end == text.data() + text.size())
        fail(std::string(what) + " " + found.substr(0, 40) + " is outside the range of a number");
    if (error != std::errc() || end != text.data() + text.size())
        fail_expecting(found, std::string(what) + " (a number)");
    return value;
}

void FileCursor::expect(std::string_view wanted) {
    const std::string found(word());
    if (found != wanted) fail_expecting(found, wanted);
    part_.clear();
}

void FileCursor::take(unsigned char* out, size_t n, std::string_view what) {
    if (n > text_.size() - at_) fail_cut_off(what);
    std::memcpy(out, text_.data() + at_, n);
    at_ += n;
    binary_ = true;
}

void FileCursor::skip_bytes(int64_t n, std::string_view what) {
    if (n < 0 || static_cast<size_t>(n) > text_.size() - at_) fail_cut_off(what);
    at_ += static_cast<size_t>(n);
}

void PointNumbers::add(int64_t id, int32_t index, const FileCursor& cursor) {
    if (!index_.emplace(id, index).second)
        cursor.fail("point " + std::to_string(id) + " is there twice");
}

int32_t PointNumbers::index(int64_t id, const std::string& element,
                            const FileCursor& cursor) const {
    const auto found = index_.find(id);
    if (found != index_.end()) return found->second;
    const std::string range = index_.empty() ? "there are no points"
                                             : "the points are numbered " +
                                                   std::to_string(index_.begin()->first) + " to " +
                                                   std::to_string(index_.rbegin()->first);
    cursor.fail(element + ": no point " + std::to_string(id) + "; " + range);
}

int32_t PointNumbers::find(int64_t id) const {
    const auto found = index_.find(id);
    return found == index_.end() ? -1 : found->second;
}

std::string says(const FileCursor& in, int64_t n, const std::string& what) {
    return "line " + std::to_string(in.line()) + " says " + std::to_string(n) + " " + what;
}

int64_t counted(FileCursor& in, const std::string& what, bool binary) {
    const int64_t n = in.count("the number of " + what);
    if (!binary) in.within(says(in, n, what));
    return n;
}

std::string place_of(const FileTet& tet) {
    return tet.line > 0 ? " (line " + std::to_string(tet.line) + ")" : "";
}

}  // namespace placode::sim
