// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// VTU (XML unstructured grid), data arrays in ascii only; pieces are put one behind the other.
// Source: VTK user's guide, "VTK file formats: XML formats". Reads the tags it needs and steps over
// the others; it is no XML parser.

#include <algorithm>

#include "sim/mesh_io/vtk_cells.h"

namespace placode::sim {
namespace {

struct Tag {
    std::string name;  ///< "/Piece" for an end tag.
    std::map<std::string, std::string> attribute;
    bool closed = false;  ///< <Tag/>
};

class VtuReader {
 public:
    explicit VtuReader(const std::string& path) : in_(path) { out_.file = path; }

    FileMesh read() {
        out_.format = "VTU ascii";
        Tag tag;
        bool file = false, grid = false;
        while (next(tag)) {
            if (tag.name == "VTKFile") {
                file = true;
                if (tag.attribute["type"] != "UnstructuredGrid")
                    in_.fail("VTKFile type \"" + tag.attribute["type"] +
                             "\"; expected UnstructuredGrid");
            } else if (tag.name == "UnstructuredGrid") {
                grid = true;
            } else if (tag.name == "Piece") {
                if (!file || !grid) break;
                piece(tag);
            }
        }
        if (!file || !grid || pieces_ == 0)
            throw MeshError(out_.file +
                            ": no <Piece> in <VTKFile type=\"UnstructuredGrid\">; is this a VTU "
                            "file?");
        return std::move(out_);
    }

 private:
    /// Next tag behind the cursor; false at the end. Comments and declarations are stepped over.
    bool next(Tag& tag) {
        const std::string& text = in_.text();
        for (;;) {
            const size_t open = text.find('<', in_.offset());
            if (open == std::string::npos) return false;
            const bool comment = text.compare(open, 4, "<!--") == 0;
            const size_t close = comment ? text.find("-->", open) : end_of_tag(open);
            go_to(open);
            if (close == std::string::npos) in_.fail("a tag that is not closed by '>'");
            const std::string inside = text.substr(open + 1, close - open - 1);
            go_to(close + (comment ? 3 : 1));
            if (comment || inside.empty() || inside[0] == '?' || inside[0] == '!') continue;
            tag = parse(inside);
            return true;
        }
    }

    /// The '>' that closes the tag at `open`: one within quotes is part of a value.
    [[nodiscard]] size_t end_of_tag(size_t open) const {
        const std::string& text = in_.text();
        char quote = 0;
        for (size_t i = open; i < text.size(); ++i) {
            const char c = text[i];
            if (quote == 0 && c == '>') return i;
            if (quote == 0 && (c == '"' || c == '\'')) {
                quote = c;
            } else if (c == quote) {
                quote = 0;
            }
        }
        return std::string::npos;
    }

    void go_to(size_t offset) {
        const std::string& text = in_.text();
        const auto from = text.begin() + static_cast<int64_t>(in_.offset());
        const auto lines = std::count(from, text.begin() + static_cast<int64_t>(offset), '\n');
        in_.jump(offset, in_.line() + static_cast<int>(lines));
    }

    Tag parse(const std::string& inside) {
        Tag tag;
        tag.closed = inside.back() == '/';
        size_t at = inside.find_first_of(" \t\r\n/", 1);
        tag.name = inside.substr(0, at);
        while (at != std::string::npos) {
            const size_t equals = inside.find('=', at);
            if (equals == std::string::npos) break;
            const size_t from = inside.find_first_not_of(" \t\r\n", at);
            const size_t end = inside.find_last_not_of(" \t\r\n", equals - 1);
            const size_t open = inside.find_first_of("\"'", equals);
            const size_t close =
                open == std::string::npos ? open : inside.find(inside[open], open + 1);
            if (close == std::string::npos) in_.fail("<" + tag.name + ">: broken attribute");
            tag.attribute[inside.substr(from, end - from + 1)] =
                inside.substr(open + 1, close - open - 1);
            at = close + 1;
        }
        return tag;
    }

    void piece(Tag& head) {
        ++pieces_;
        const int line = in_.line();
        const auto first_point = static_cast<int64_t>(out_.points.size());
        std::string section;
        VtkCells cells;
        cells.offsets.push_back(0);
        cells.offsets_line.push_back(0);
        cells.line = line;
        Tag tag;
        while (!head.closed) {
            if (!next(tag))
                in_.fail("the file is cut off: it ends inside the <Piece> of line " +
                         std::to_string(line));
            if (tag.name == "/Piece") break;
            if (tag.name == "Points" || tag.name == "Cells" || tag.name == "PointData" ||
                tag.name == "CellData") {
                section = tag.name;
            } else if (tag.name[0] == '/' && tag.name.substr(1) == section) {
                section.clear();
            } else if (tag.name == "DataArray" && section == "Points") {
                points(tag);
            } else if (tag.name == "DataArray" && section == "Cells") {
                const std::string name = tag.attribute["Name"];
                std::vector<int32_t> unused;
                if (name == "connectivity")
                    integers(tag, cells.connectivity, cells.connectivity_line);
                if (name == "offsets") integers(tag, cells.offsets, cells.offsets_line);
                if (name == "types") integers(tag, cells.types, unused);
            }
        }
        check_count(head, line, "NumberOfPoints",
                    static_cast<int64_t>(out_.points.size()) - first_point);
        check_count(head, line, "NumberOfCells", static_cast<int64_t>(cells.types.size()));
        add_vtk_cells(cells, in_, out_, first_point, cells_);
        cells_ += static_cast<int64_t>(cells.types.size());
    }

    void check_count(Tag& tag, int line, const std::string& key, int64_t found) {
        if (tag.attribute[key] != std::to_string(found))
            in_.fail_at(line, "Piece says " + key + " \"" + tag.attribute[key] + "\", found " +
                                  std::to_string(found));
    }

    void need_ascii(Tag& tag) {
        const std::string& format = tag.attribute["format"];
        if (!format.empty() && format != "ascii")  // without one it is ascii to VTK, too
            in_.fail("DataArray \"" + tag.attribute["Name"] + "\" has format \"" + format +
                     "\"; only ascii is read (save with data mode Ascii)");
    }

    bool more() { return !in_.at_end() && in_.text()[in_.offset()] != '<'; }

    void integers(Tag& tag, std::vector<int64_t>& out, std::vector<int32_t>& line) {
        need_ascii(tag);
        while (more()) {
            out.push_back(in_.whole(tag.attribute["Name"]));
            line.push_back(in_.line());
        }
    }

    void points(Tag& tag) {
        need_ascii(tag);
        if (tag.attribute["NumberOfComponents"] != "3")
            in_.fail("Points with NumberOfComponents \"" + tag.attribute["NumberOfComponents"] +
                     "\"; expected 3");
        while (more()) {
            Vec3 x;
            for (int c = 0; c < 3; ++c) {
                if (!more()) in_.fail("a point with fewer than three coordinates");
                x[c] = in_.real("a coordinate");
            }
            const auto id = static_cast<int64_t>(out_.points.size());
            in_.check_point(id, x);
            out_.points.push_back(x);
            out_.point_id.push_back(id);
        }
    }

    FileCursor in_;
    FileMesh out_;
    int64_t cells_ = 0;  // of all pieces so far
    int pieces_ = 0;
};

}  // namespace

FileMesh read_vtu(const std::string& path) { return VtuReader(path).read(); }

}  // namespace placode::sim
