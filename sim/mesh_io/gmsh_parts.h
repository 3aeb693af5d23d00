// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Parts of the Gmsh reader: the types of elements, and the counts of a section in format 4.1, which
// stand twice: for the section and for each of its blocks. Private to sim/mesh_io.
// Source: Gmsh reference manual, "MSH file format".

#include <array>
#include <string>
#include <utility>

#include "sim/mesh_io/file_cursor.h"

namespace placode::sim {

struct GmshElementType {
    const char* name;
    int points;
};

/// Types 1 to 19 of the manual; 0 points = unknown to us.
[[nodiscard]] inline GmshElementType gmsh_element_type(int64_t type) {
    constexpr std::array<GmshElementType, 20> kTypes{{{"", 0},
                                                      {"line", 2},
                                                      {"triangle", 3},
                                                      {"quadrangle", 4},
                                                      {"tetrahedron", 4},
                                                      {"hexahedron", 8},
                                                      {"prism", 6},
                                                      {"pyramid", 5},
                                                      {"line", 3},
                                                      {"triangle", 6},
                                                      {"quadrangle", 9},
                                                      {"tetrahedron of second order", 10},
                                                      {"hexahedron", 27},
                                                      {"prism", 18},
                                                      {"pyramid", 14},
                                                      {"point", 1},
                                                      {"quadrangle", 8},
                                                      {"hexahedron", 20},
                                                      {"prism", 15},
                                                      {"pyramid", 13}}};
    if (type < 1 || type >= static_cast<int64_t>(kTypes.size())) return {"other element", 0};
    return kTypes[static_cast<size_t>(type)];
}

inline constexpr int kGmshTriangle = 2, kGmshTetrahedron = 4, kGmshSecondOrderTetrahedron = 11;

/// Walks through the blocks of $Nodes or $Elements and compares their counts with the section's.
class GmshBlocks {
 public:
    /// Behind the section's head. @param what "node" or "element"; all: of the whole section.
    /// @throws MeshError for a section with contents and no block.
    GmshBlocks(std::string what, int64_t blocks, int64_t all, bool binary, FileCursor& in)
        : in_(in), what_(std::move(what)), blocks_(blocks), all_(all), binary_(binary) {
        const std::string contents = what_ + "s in " + std::to_string(blocks_) + " blocks";
        head_ = says(in_, all_, contents);
        within(head_);
        if (blocks_ == 0 && all_ > 0)
            in_.fail(std::to_string(all_) + " " + contents + "; expected at least one block");
    }

    /// Goes to the next block. false behind the last one.
    [[nodiscard]] bool next() { return current_++ < blocks_; }

    /// Behind the head of a block. A wrong count is known here, and would show far from here.
    /// @throws MeshError when the blocks so far hold more than the section, or all of them less.
    void count(int64_t n) {
        sum_ += n;
        const std::string before =
            std::exchange(block_, says(in_, n, what_ + "s in block " + std::to_string(current_)));
        within(block_ + ", " + head_);
        if (sum_ > all_ || (current_ == blocks_ && sum_ != all_))
            in_.fail(what_ + " block " + std::to_string(current_) + " of " +
                     std::to_string(blocks_) + " says " + std::to_string(n) + " " + what_ + "s, " +
                     (current_ == 1
                          ? ""
                          : std::to_string(sum_) + " with those before it (" + before + "), ") +
                     "but " + head_);
    }

 private:
    void within(const std::string& part) {
        if (!binary_) in_.within(part);
    }

    FileCursor& in_;
    std::string what_, head_, block_;
    int64_t blocks_, all_;
    int64_t sum_ = 0, current_ = 0;
    bool binary_;
};

}  // namespace placode::sim
