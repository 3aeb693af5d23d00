// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Walks through a mesh file: words with their line, numbers with '.' in every locale, raw binary.
// Every error is a MeshError with file and line, or byte behind binary data. Private to
// sim/mesh_io.

#include <cstdint>
#include <string>
#include <string_view>

#include "sim/mesh_io/mesh_io.h"

namespace placode::sim {

class FileCursor {
 public:
    /// Reads the whole file. @throws MeshError when it cannot be opened or is larger than 2 GiB.
    explicit FileCursor(const std::string& path);

    [[nodiscard]] const std::string& file() const noexcept { return file_; }
    [[nodiscard]] int line() const noexcept { return line_; }
    [[nodiscard]] const std::string& text() const noexcept { return text_; }

    /// '#' starts a comment that ends with the line (TetGen).
    void hash_comments(bool on) noexcept { hash_comments_ = on; }
    /// true when only white space (and comments) is left.
    [[nodiscard]] bool at_end();
    /// Next word; "" at the end.
    [[nodiscard]] std::string_view word();
    /// The next word without taking it.
    [[nodiscard]] std::string_view peek();
    /// What is left of the line, trimmed; the cursor moves to the next line.
    [[nodiscard]] std::string_view rest_of_line();
    /// Next word as a whole number. `what` names it in the message.
    [[nodiscard]] int64_t whole(std::string_view what);
    /// A count: 0 or more, and not more than the file has bytes.
    [[nodiscard]] int64_t count(std::string_view what);
    /// Next word as a number; nan and inf are read as such, the caller decides.
    [[nodiscard]] double real(std::string_view what);
    /// @throws MeshError unless the next word is `wanted`.
    void expect(std::string_view wanted);
    /// Steps over one end of line (before binary data).
    void end_line();

    /// Next bytes as a value; `swap` turns the byte order round.
    template <class T>
    [[nodiscard]] T binary(bool swap, std::string_view what) {
        unsigned char bytes[sizeof(T)];
        take(bytes, sizeof(T), what);
        if (swap) {
            for (size_t i = 0; i < sizeof(T) / 2; ++i) {
                std::swap(bytes[i], bytes[sizeof(T) - 1 - i]);
            }
        }
        T value;
        __builtin_memcpy(&value, bytes, sizeof(T));
        return value;
    }
    /// Steps over n bytes.
    void skip_bytes(int64_t n, std::string_view what);
    /// A count read from binary data, checked like count().
    [[nodiscard]] int64_t checked_count(int64_t n, std::string_view what) const;

    /// Moves to an offset of text(); the line is counted from `line`.
    void jump(size_t offset, int line) noexcept {
        at_ = offset;
        line_ = line;
    }
    [[nodiscard]] size_t offset() const noexcept { return at_; }

    /// What the file says about the part that is being read, "line 9 says 8 nodes": added to every
    /// message about what is expected next, because a wrong count shows far behind the place where
    /// it stands. "" = nothing.
    void within(std::string part) { part_ = std::move(part); }

    /// @throws MeshError "file: line n: message", or with the byte behind binary data.
    [[noreturn]] void fail(const std::string& message) const;
    /// The same for a line that was read before.
    [[noreturn]] void fail_at(int line, const std::string& message) const;
    /// "..." where `what` is expected; that the file is cut off where nothing was found.
    [[noreturn]] void fail_expecting(std::string_view found, std::string_view what) const;
    /// @throws MeshError naming point, axis and value unless all coordinates are finite.
    void check_point(int64_t id, const Vec3& x) const;

 private:
    void skip_space();
    void take(unsigned char* out, size_t n, std::string_view what);
    [[noreturn]] void fail_cut_off(std::string_view what) const;

    std::string file_, text_, part_;
    size_t at_ = 0;
    int line_ = 1;
    bool hash_comments_ = false;
    bool binary_ = false;  // Behind binary data, where lines mean nothing.
};

/// Puts point numbers of any kind (tags, 1-based) to indices. Dense tags use a table.
class PointNumbers {
 public:
    /// @throws MeshError through `cursor` for a number that is there twice.
    void add(int64_t id, int32_t index, const FileCursor& cursor);
    /// @throws MeshError through `cursor` for an unknown number.
    [[nodiscard]] int32_t index(int64_t id, const std::string& element,
                                const FileCursor& cursor) const;
    /// -1 for an unknown number.
    [[nodiscard]] int32_t find(int64_t id) const;

 private:
    std::map<int64_t, int32_t> index_;
};

/// The text in quotation marks, at most 40 characters of it.
[[nodiscard]] std::string in_quotes(std::string_view text);

/// "line 9 says 8 nodes" of the line that was just read.
[[nodiscard]] std::string says(const FileCursor& in, int64_t n, const std::string& what);

/// Reads "the number of nodes" at the head of a part, which is within() from here on; not where the
/// part is binary.
[[nodiscard]] int64_t counted(FileCursor& in, const std::string& what, bool binary = false);

/// "line 12" or "" in binary files.
[[nodiscard]] std::string place_of(const FileTet& tet);

}  // namespace placode::sim
