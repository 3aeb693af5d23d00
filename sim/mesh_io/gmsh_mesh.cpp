// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Gmsh .msh, versions 1, 2.x and 4.1, ascii and (2.x, 4.1) binary.
// Source: Gmsh reference manual, "MSH file format" and "MSH file format version 1 / 2 (Legacy)".

#include <algorithm>

#include "sim/mesh_io/gmsh_parts.h"

namespace placode::sim {
namespace {

class GmshReader {
 public:
    explicit GmshReader(const std::string& path) : in_(path) { out_.file = path; }

    FileMesh read() {
        while (!in_.at_end()) {
            const std::string section(in_.word());
            if (section == "$NOD") {
                version_ = 1;
                out_.format = "Gmsh 1 ascii";
                nodes_1_and_2();
                in_.expect("$ENDNOD");
            } else if (section == "$ELM") {
                elements_1();
                in_.expect("$ENDELM");
            } else if (section == "$MeshFormat") {
                format();
            } else if (section == "$Nodes") {
                need_format();
                version_ < 3 ? nodes_1_and_2() : nodes_4();
                in_.expect("$EndNodes");
            } else if (section == "$ParametricNodes" && version_ == 2) {
                nodes_1_and_2(true);
                in_.expect("$EndParametricNodes");
            } else if (section == "$Elements") {
                need_format();
                if (version_ < 3)
                    binary_ ? elements_2_binary() : elements_2_ascii();
                else
                    elements_4();
                in_.expect("$EndElements");
            } else if (!section.empty() && section.front() == '$') {
                skip_section(section);
            } else {
                in_.fail(in_quotes(section) +
                         " where a section ($MeshFormat, $NOD, ...) is expected; is this a Gmsh "
                         "file?");
            }
        }
        if (!nodes_read_ || !elements_read_)
            throw MeshError(out_.file + ": no " + (nodes_read_ ? "elements" : "nodes") +
                            " in the file; expected the sections $Nodes and $Elements (or $NOD and "
                            "$ELM)");
        if (second_order_ > 0)
            out_.warnings.push_back(std::to_string(second_order_) +
                                    " tetrahedra of second order: their corners are used");
        return std::move(out_);
    }

 private:
    void format() {
        const std::string version(in_.word());
        version_ = version.rfind("2", 0) == 0 ? 2 : version == "4.1" ? 4 : 0;
        if (version_ == 0)
            in_.fail("Gmsh format " + in_quotes(version) +
                     "; expected 1, 2.x or 4.1 (gmsh FILE -save -format msh41)");
        const int64_t type = in_.whole("the file type"), size = in_.whole("the size of a number");
        if (type != 0 && type != 1)
            in_.fail("file type " + std::to_string(type) + "; expected 0 (ascii) or 1 (binary)");
        if (size != 8) in_.fail("numbers of " + std::to_string(size) + " bytes; expected 8");
        binary_ = type == 1;
        out_.format = "Gmsh " + version + (binary_ ? " binary" : " ascii");
        if (binary_) {
            (void)in_.rest_of_line();
            const auto one = in_.binary<int32_t>(false, "$MeshFormat");
            swap_ = one != 1;
            if (swap_ && one != 0x01000000) in_.fail("binary: the byte order cannot be told");
        }
        in_.expect("$EndMeshFormat");
    }

    void need_format() {
        if (version_ != 2 && version_ != 4) in_.fail("$MeshFormat must stand before it");
    }

    void skip_section(const std::string& section) {
        const std::string end = "$End" + section.substr(1);
        size_t at = in_.text().find("\n" + end, in_.offset());
        if (at == std::string::npos) in_.fail(section + " is not ended by " + end);
        int line = in_.line();
        for (size_t i = in_.offset(); i <= at; ++i) line += in_.text()[i] == '\n' ? 1 : 0;
        in_.jump(at + 1 + end.size(), line);
    }

    void add_point(int64_t id, const Vec3& x) {
        in_.check_point(id, x);
        numbers_.add(id, static_cast<int32_t>(out_.points.size()), in_);
        out_.points.push_back(x);
        out_.point_id.push_back(id);
    }

    /// @param parametric with the entity and the place on it behind the coordinates.
    void nodes_1_and_2(bool parametric = false) {
        nodes_read_ = true;
        const int64_t n = counted(in_, "nodes", binary_);
        if (binary_) (void)in_.rest_of_line();
        for (int64_t i = 0; i < n; ++i) {
            const int64_t id = int_32("a node number");
            Vec3 x;
            for (int c = 0; c < 3; ++c) x[c] = real_64("a coordinate");
            if (parametric) {
                const int64_t dimension = int_32("the dimension of an entity");
                (void)int_32("the number of an entity");
                for (int64_t c = 0; c < dimension && dimension < 3; ++c)
                    (void)real_64("a parametric coordinate");
            }
            add_point(id, x);
        }
    }

    /// The head of a section of format 4.1.
    GmshBlocks head_4(const std::string& what) {
        const int64_t blocks = count_4("the number of " + what + " blocks");
        const int64_t all = count_4("the number of " + what + "s");
        for (int i = 0; i < 2; ++i) (void)size_4("the least and the greatest " + what + " number");
        return {what, blocks, all, binary_, in_};
    }

    void nodes_4() {
        nodes_read_ = true;
        if (binary_) in_.end_line();
        GmshBlocks blocks = head_4("node");
        while (blocks.next()) {
            const int64_t dimension = int_32("the dimension of a node block");
            (void)int_32("the entity of a node block");
            const int64_t parametric = int_32("0 or 1 (parametric)");
            const int64_t n = count_4("the number of nodes");
            blocks.count(n);
            std::vector<int64_t> ids;
            for (int64_t i = 0; i < n; ++i) ids.push_back(size_4("a node number"));
            for (const int64_t id : ids) {
                Vec3 x;
                for (int c = 0; c < 3; ++c) x[c] = real_64("a coordinate");
                for (int64_t c = 0; parametric != 0 && c < dimension; ++c) (void)real_64("$Nodes");
                add_point(id, x);
            }
        }
    }

    void elements_1() {
        elements_read_ = true;
        const int64_t n = counted(in_, "elements", binary_);
        for (int64_t i = 0; i < n; ++i) {
            const int64_t id = in_.whole("an element number"), type = in_.whole("an element type");
            group_ = in_.whole("a region");
            (void)in_.whole("a region");
            const int64_t points = in_.count("the number of nodes of the element");
            points_.clear();
            for (int64_t k = 0; k < points; ++k) points_.push_back(in_.whole("a node number"));
            add_element(id, type);
        }
    }

    void elements_2_ascii() {
        elements_read_ = true;
        const int64_t n = counted(in_, "elements", binary_);
        for (int64_t i = 0; i < n; ++i) {
            const int64_t id = in_.whole("an element number"), type = in_.whole("an element type");
            const int64_t tags = in_.count("the number of tags");
            for (int64_t k = 0; k < tags; ++k) {
                const int64_t tag = in_.whole("a tag");
                if (k == 0) group_ = tag;
            }
            if (tags == 0) group_ = 0;
            ascii_points(type);
            add_element(id, type);
        }
    }

    /// Unknown types are skipped by the line.
    void ascii_points(int64_t type) {
        points_.clear();
        const int points = gmsh_element_type(type).points;
        if (points == 0) (void)in_.rest_of_line();
        for (int k = 0; k < points; ++k) points_.push_back(in_.whole("a node number"));
    }

    int known_points(int64_t type) {
        const int points = gmsh_element_type(type).points;
        if (points == 0)
            throw MeshError(out_.file + ": element type " + std::to_string(type) +
                            " is unknown and cannot be skipped in a binary file; expected types 1 "
                            "to 19, or save it as ascii");
        return points;
    }

    void elements_2_binary() {
        elements_read_ = true;
        const int64_t n = counted(in_, "elements", binary_);
        (void)in_.rest_of_line();
        for (int64_t i = 0; i < n;) {
            const auto type = in_.binary<int32_t>(swap_, "$Elements");
            const int64_t block =
                in_.checked_count(in_.binary<int32_t>(swap_, "$Elements"), "elements in a block");
            const int64_t tags =
                in_.checked_count(in_.binary<int32_t>(swap_, "$Elements"), "number of tags");
            const int points = known_points(type);
            if (block == 0) in_.fail("an element block of 0 elements");
            if (block > n - i)
                in_.fail("more than the " + std::to_string(n) + " elements of the section's head");
            for (int64_t k = 0; k < block; ++k, ++i) {
                const auto id = in_.binary<int32_t>(swap_, "$Elements");
                group_ = tags > 0 ? in_.binary<int32_t>(swap_, "$Elements") : 0;
                in_.skip_bytes(4 * std::max<int64_t>(0, tags - 1), "$Elements");
                points_.clear();
                for (int p = 0; p < points; ++p)
                    points_.push_back(in_.binary<int32_t>(swap_, "$Elements"));
                add_element(id, type);
            }
        }
    }

    void elements_4() {
        elements_read_ = true;
        if (binary_) in_.end_line();
        GmshBlocks blocks = head_4("element");
        while (blocks.next()) {
            (void)int_32("the dimension of an element block");
            group_ = int_32("the entity of an element block");
            const int64_t type = int_32("an element type"), n = count_4("the number of elements");
            blocks.count(n);
            const int points = binary_ ? known_points(type) : 0;
            for (int64_t i = 0; i < n; ++i) {
                const int64_t id = size_4("an element number");
                if (binary_) {
                    points_.clear();
                    for (int k = 0; k < points; ++k) points_.push_back(size_4("a node number"));
                } else {
                    ascii_points(type);
                }
                add_element(id, type);
            }
        }
    }

    void add_element(int64_t id, int64_t type) {
        if (type != kGmshTetrahedron && type != kGmshSecondOrderTetrahedron) {
            ++out_.skipped[gmsh_element_type(type).name];
            if (type == kGmshTriangle) add_triangle(id);
            return;
        }
        const std::string name = "element " + std::to_string(id);
        if (points_.size() < 4)
            in_.fail(name + ": " + std::to_string(points_.size()) + " nodes; a tetrahedron has 4");
        if (type == kGmshSecondOrderTetrahedron) ++second_order_;
        FileTet tet;
        tet.id = id;
        tet.line = binary_ ? 0 : in_.line();
        for (size_t k = 0; k < 4; ++k) tet.point[k] = numbers_.index(points_[k], name, in_);
        out_.tets.push_back(tet);
    }

    void add_triangle(int64_t id) {
        // Most files have triangles that nobody asks for: a broken one is an error where it is
        // used.
        FileTriangle triangle{{-1, -1, -1}, id, group_};
        for (size_t k = 0; k < 3 && points_.size() == 3; ++k)
            triangle.point[k] = numbers_.find(points_[k]);
        out_.triangles.push_back(triangle);
    }

    int64_t int_32(std::string_view what) {
        return binary_ ? in_.binary<int32_t>(swap_, what) : in_.whole(what);
    }
    int64_t size_4(std::string_view what) {
        return binary_ ? in_.binary<int64_t>(swap_, what) : in_.whole(what);
    }
    int64_t count_4(std::string_view what) { return in_.checked_count(size_4(what), what); }
    double real_64(std::string_view what) {
        return binary_ ? in_.binary<double>(swap_, what) : in_.real(what);
    }

    FileCursor in_;
    FileMesh out_;
    PointNumbers numbers_;
    std::vector<int64_t> points_;
    int64_t group_ = 0;  // of the element
    int version_ = 0, second_order_ = 0;
    bool binary_ = false, swap_ = false, nodes_read_ = false, elements_read_ = false;
};

}  // namespace

FileMesh read_gmsh(const std::string& path) { return GmshReader(path).read(); }

}  // namespace placode::sim
