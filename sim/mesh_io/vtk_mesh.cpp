// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Legacy VTK (.vtk) unstructured grids, ascii and binary (big-endian), file versions 1 to 5.1.
// Source: VTK user's guide, "VTK file formats: simple legacy formats".

#include <algorithm>
#include <bit>
#include <cctype>

#include "sim/mesh_io/file_cursor.h"
#include "sim/mesh_io/vtk_cells.h"

namespace placode::sim {
namespace {

std::string lower(std::string_view text) {
    std::string out(text);
    for (char& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return out;
}

class VtkReader {
 public:
    explicit VtkReader(const std::string& path) : in_(path) { out_.file = path; }

    FileMesh read() {
        head();
        while (!in_.at_end() && !(points_ && cells_.types_known)) {
            const std::string section = lower(in_.word());
            if (section == "points") {
                points();
            } else if (section == "cells") {
                cells();
            } else if (section == "cell_types") {
                cell_types();
            } else if (section == "metadata") {
                (void)in_.rest_of_line();
                while (!in_.rest_of_line().empty()) {
                }
            } else if (section == "field") {
                field();
            } else {
                in_.fail_expecting(section, "POINTS, CELLS or CELL_TYPES");
            }
        }
        if (!points_ || !cells_.known || !cells_.types_known)
            throw MeshError(out_.file + ": the file has no " +
                            (!points_        ? "POINTS"
                             : !cells_.known ? "CELLS"
                                             : "CELL_TYPES"));
        add_vtk_cells(cells_, in_, out_);
        return std::move(out_);
    }

 private:
    void head() {
        const std::string first(in_.rest_of_line());
        const std::string wanted = "# vtk DataFile Version ";
        if (first.rfind(wanted, 0) != 0)
            in_.fail_at(1, in_quotes(first) + " where \"" + wanted + "x.y\" is expected");
        const std::string version = first.substr(wanted.size());
        five_ = !version.empty() && version[0] >= '5';
        (void)in_.rest_of_line();
        const std::string kind = lower(in_.word());
        if (kind != "ascii" && kind != "binary")
            in_.fail(in_quotes(kind) + " where ASCII or BINARY is expected");
        binary_ = kind == "binary";
        out_.format = "VTK legacy " + version + (binary_ ? " binary" : " ascii");
        if (lower(in_.word()) != "dataset") in_.fail("expected DATASET UNSTRUCTURED_GRID");
        const std::string set = lower(in_.word());
        if (set != "unstructured_grid")
            in_.fail("DATASET " + set.substr(0, 40) + "; expected UNSTRUCTURED_GRID");
    }

    double real(const std::string& type, std::string_view what) {
        if (!binary_) return in_.real(what);
        if (type == "float") return static_cast<double>(in_.binary<float>(kSwap, what));
        return in_.binary<double>(kSwap, what);
    }

    int64_t integer(const std::string& type, std::string_view what) {
        if (!binary_) return in_.whole(what);
        if (type == "vtktypeint64" || type == "long" || type == "vtkidtype")
            return in_.binary<int64_t>(kSwap, what);
        return in_.binary<int32_t>(kSwap, what);
    }

    void points() {
        const int64_t n = counted(in_, "points", binary_);
        const std::string type = lower(in_.word());
        if (type != "float" && type != "double")
            in_.fail("points of type " + type.substr(0, 40) + "; expected float or double");
        if (binary_) (void)in_.rest_of_line();
        for (int64_t i = 0; i < n; ++i) {
            Vec3 x;
            for (int c = 0; c < 3; ++c) x[c] = real(type, "a coordinate");
            in_.check_point(i, x);
            out_.points.push_back(x);
            out_.point_id.push_back(i);
        }
        points_ = true;
    }

    void cells() {
        const int64_t n = counted(in_, "cells", binary_), size = in_.count("the size of CELLS");
        cells_.known = true;
        cells_.line = binary_ ? 0 : in_.line();
        if (five_) {
            cells_of_version_5(n, size);
            return;
        }
        if (binary_) (void)in_.rest_of_line();
        cells_.offsets.push_back(0);
        int64_t read = 0;
        for (int64_t i = 0; i < n; ++i) {
            const int64_t k = in_.checked_count(integer("int", "a number of points"), "cell size");
            for (int64_t p = 0; p < k; ++p) {
                cells_.connectivity.push_back(integer("int", "a point number"));
                if (!binary_) cells_.connectivity_line.push_back(in_.line());
            }
            cells_.offsets.push_back(static_cast<int64_t>(cells_.connectivity.size()));
            read += k + 1;
        }
        if (read != size)
            in_.fail("CELLS: " + std::to_string(read) + " numbers read, its head says " +
                     std::to_string(size));
    }

    void cells_of_version_5(int64_t offsets, int64_t size) {
        for (int part = 0; part < 2; ++part) {
            const std::string name = part == 0 ? "offsets" : "connectivity";
            if (lower(in_.word()) != name) in_.fail("expected " + name + " after CELLS");
            const std::string type = lower(in_.word());
            if (binary_) (void)in_.rest_of_line();
            for (int64_t i = 0; i < (part == 0 ? offsets : size); ++i) {
                const int64_t value = integer(type, name);
                (part == 0 ? cells_.offsets : cells_.connectivity).push_back(value);
                if (!binary_)
                    (part == 0 ? cells_.offsets_line : cells_.connectivity_line)
                        .push_back(in_.line());
            }
        }
        if (cells_.offsets.empty()) cells_.offsets.push_back(0);
    }

    void cell_types() {
        const int64_t n = counted(in_, "cell types", binary_);
        if (binary_) (void)in_.rest_of_line();
        for (int64_t i = 0; i < n; ++i) cells_.types.push_back(integer("int", "a cell type"));
        cells_.types_known = true;
    }

    /// FIELD name arrays, each: name components tuples type values.
    void field() {
        (void)in_.word();
        const int64_t arrays = in_.count("the number of arrays");
        for (int64_t i = 0; i < arrays; ++i) {
            (void)in_.word();
            const int64_t components = in_.count("components"), tuples = in_.count("tuples");
            const std::string type = lower(in_.word());
            const int64_t n = in_.checked_count(components * tuples, "the size of a field");
            if (binary_) {
                (void)in_.rest_of_line();
                in_.skip_bytes(n * bytes_of(type), "FIELD");
            } else {
                for (int64_t k = 0; k < n; ++k) (void)in_.word();
            }
        }
    }

    int64_t bytes_of(const std::string& type) {
        if (type == "double" || type == "long" || type == "unsigned_long" ||
            type == "vtktypeint64" || type == "vtkidtype")
            return 8;
        if (type == "float" || type == "int" || type == "unsigned_int") return 4;
        if (type == "short" || type == "unsigned_short") return 2;
        if (type == "char" || type == "unsigned_char") return 1;
        in_.fail("FIELD of type " + type.substr(0, 40) + " cannot be skipped");
    }

    // The format is big-endian.
    static constexpr bool kSwap = std::endian::native == std::endian::little;
    FileCursor in_;
    FileMesh out_;
    VtkCells cells_;
    bool five_ = false, binary_ = false, points_ = false;
};

}  // namespace

FileMesh read_legacy_vtk(const std::string& path) { return VtkReader(path).read(); }

}  // namespace placode::sim
