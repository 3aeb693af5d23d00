// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// VTU (XML unstructured grid), data arrays in ascii only; pieces are put one behind the other.
// Source: VTK user's guide, "VTK file formats: XML formats". pugixml finds the elements; numbers
// are read from the text itself, so that every message has its line.

#include <algorithm>
#include <pugixml.hpp>

#include "sim/mesh_io/vtk_cells.h"

namespace placode::sim {
namespace {

class VtuReader {
 public:
    explicit VtuReader(const std::string& path) : in_(path) { out_.file = path; }

    FileMesh read() {
        out_.format = "VTU ascii";
        const std::string& text = in_.text();
        // As UTF-8, or offsets would not be those of the text.
        const auto parsed = document_.load_buffer(text.data(), text.size(), pugi::parse_default,
                                                  pugi::encoding_utf8);
        const pugi::xml_node file = document_.child("VTKFile");
        const std::string type = file.attribute("type").value();
        if (file && type != "UnstructuredGrid") {
            go_to(file);
            in_.fail("VTKFile type \"" + type + "\"; expected UnstructuredGrid");
        }
        const pugi::xml_node grid = file.child("UnstructuredGrid");
        if (!grid.child("Piece"))
            throw MeshError(out_.file +
                            ": no <Piece> in <VTKFile type=\"UnstructuredGrid\">; is this a VTU "
                            "file?");
        for (const pugi::xml_node piece : grid.children("Piece")) need_ascii(piece);
        if (!parsed) fail_parsing(grid, parsed);
        for (const pugi::xml_node piece : grid.children("Piece")) read_piece(piece);
        return std::move(out_);
    }

 private:
    [[noreturn]] void fail_parsing(const pugi::xml_node& grid,
                                   const pugi::xml_parse_result& parsed) {
        const auto at = static_cast<size_t>(std::max<ptrdiff_t>(0, parsed.offset));
        const std::string& text = in_.text();
        // What is cut off breaks in its last word, or in an element that nobody closes.
        const bool at_end =
            text.find_first_of("<>", std::min(at + 1, text.size())) == std::string::npos;
        const int piece = line_of(grid.last_child());
        go_to(std::min(at, text.size()));
        if (at_end)
            in_.fail("the file is cut off: it ends inside the <Piece> of line " +
                     std::to_string(piece));
        in_.fail(std::string("not well-formed XML: ") + parsed.description());
    }

    [[nodiscard]] int line_of(const pugi::xml_node& node) const {
        const std::string& text = in_.text();
        return 1 +
               static_cast<int>(std::count(text.begin(), text.begin() + node.offset_debug(), '\n'));
    }
    /// The cursor moves forward only: elements are visited as they stand in the file.
    void go_to(size_t offset) {
        const std::string& text = in_.text();
        const auto from = text.begin() + static_cast<int64_t>(in_.offset());
        const auto lines = std::count(from, text.begin() + static_cast<int64_t>(offset), '\n');
        in_.jump(offset, in_.line() + static_cast<int>(lines));
    }
    void go_to(const pugi::xml_node& node) { go_to(static_cast<size_t>(node.offset_debug())); }

    void need_ascii(const pugi::xml_node& piece) {
        for (const char* section : {"Points", "Cells"}) {
            for (const pugi::xml_node array : piece.child(section).children("DataArray")) {
                const std::string format = array.attribute("format").value();
                if (format.empty() || format == "ascii") continue;  // without one VTK takes ascii
                in_.fail_at(line_of(array), "DataArray \"" + name_of(array) + "\" has format \"" +
                                                format +
                                                "\"; only ascii is read (save with data mode "
                                                "Ascii)");
            }
        }
    }

    void read_piece(const pugi::xml_node& piece) {
        const int line = line_of(piece);
        const auto first_point = static_cast<int64_t>(out_.points.size());
        VtkCells cells;
        cells.offsets.push_back(0);
        cells.offsets_line.push_back(0);
        cells.line = line;
        for (const pugi::xml_node section : piece.children()) {
            const std::string what = section.name();
            for (const pugi::xml_node array : section.children("DataArray")) {
                if (what == "Points") points(array);
                if (what == "Cells") cell_array(array, cells);
            }
        }
        check_count(piece, line, "NumberOfPoints",
                    static_cast<int64_t>(out_.points.size()) - first_point);
        check_count(piece, line, "NumberOfCells", static_cast<int64_t>(cells.types.size()));
        add_vtk_cells(cells, in_, out_, first_point, cells_);
        cells_ += static_cast<int64_t>(cells.types.size());
    }

    void check_count(const pugi::xml_node& piece, int line, const char* key, int64_t found) {
        const std::string says = piece.attribute(key).value();
        if (says != std::to_string(found))
            in_.fail_at(line, std::string("Piece says ") + key + " \"" + says + "\", found " +
                                  std::to_string(found));
    }

    [[nodiscard]] static std::string name_of(const pugi::xml_node& array) {
        return array.attribute("Name").value();
    }

    void cell_array(const pugi::xml_node& array, VtkCells& cells) {
        const std::string name = name_of(array);
        std::vector<int32_t> unused;
        if (name == "connectivity") integers(array, cells.connectivity, cells.connectivity_line);
        if (name == "offsets") integers(array, cells.offsets, cells.offsets_line);
        if (name == "types") integers(array, cells.types, unused);
    }

    /// A number is left before the next tag.
    bool more() { return !in_.at_end() && in_.text()[in_.offset()] != '<'; }

    void integers(const pugi::xml_node& array, std::vector<int64_t>& out,
                  std::vector<int32_t>& line) {
        for (const pugi::xml_node text : array.children()) {
            if (text.type() != pugi::node_pcdata) continue;  // a comment
            go_to(text);
            while (more()) {
                out.push_back(in_.whole(name_of(array)));
                line.push_back(in_.line());
            }
        }
    }

    void points(const pugi::xml_node& array) {
        const std::string components = array.attribute("NumberOfComponents").value();
        if (components != "3")
            in_.fail_at(line_of(array),
                        "Points with NumberOfComponents \"" + components + "\"; expected 3");
        for (const pugi::xml_node text : array.children()) {
            if (text.type() != pugi::node_pcdata) continue;
            go_to(text);
            while (more()) point();
        }
    }

    void point() {
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

    FileCursor in_;
    FileMesh out_;
    pugi::xml_document document_;
    int64_t cells_ = 0;  // of all pieces so far
};

}  // namespace

FileMesh read_vtu(const std::string& path) { return VtuReader(path).read(); }

}  // namespace placode::sim
