// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// "mesh" and "sheets" of a verification scene.
#include <filesystem>
#include <optional>
#include <set>

#include "curriculum/verification_place.h"
#include "sim/mesh_io/mesh_io.h"

namespace placode::curriculum {
namespace {

namespace fs = std::filesystem;

constexpr int64_t kMostTets = 3'000'000;     // about 2 GB with everything
constexpr int64_t kMostTriangles = 100'000;  // they are solved one by one

void read_box_mesh(const Place& box, sim::VerificationScene& scene) {
    box.keys({"size_m", "cells"});
    const Vec3 size = box.at("size_m").vector({0, 1e6, true, false});
    const Place cells = box.at("cells");
    if (!cells.is_array() || cells.size() != 3) cells.expected("an array of three whole numbers");
    std::array<int, 3> n{};
    for (size_t i = 0; i < 3; ++i) n[i] = static_cast<int>(cells.at(i).whole(1, 100000));
    const double tets = 6.0 * n[0] * n[1] * n[2];
    if (tets > static_cast<double>(kMostTets))
        cells.expected("at most " + std::to_string(kMostTets) +
                       " tetrahedra (six a cell), these are " + sim::shortest_text(tets));
    sim::use_box(scene, size, n);
}

/// Beside the scene, or from where the program was started.
std::string path_of(const Place& file, const std::string& folder) {
    fs::path path = file.text();
    std::error_code error;
    if (path.is_relative() && fs::exists(fs::path(folder) / path, error))
        path = fs::path(folder) / path;
    return path.string();
}

void read_file_mesh(const Place& mesh, const std::string& folder, sim::VerificationScene& scene,
                    sim::FileMesh& read) {
    const Place file = mesh.at("file");
    double scale = 1;
    bool allow = false;
    mesh.take("scale", scale, kScale);
    mesh.take("allow_disconnected", allow);
    try {
        read = sim::read_mesh_file(path_of(file, folder));
        sim::LoadedMesh loaded = sim::prepare_mesh(read, scale, allow);
        std::vector<Vec3> points;
        for (const Vec3& p : read.points) points.push_back(scale * p);
        for (std::string& warning : loaded.warnings)
            scene.warnings.push_back("/mesh/file: " + warning);
        sim::use_mesh(scene, loaded.mesh, std::move(points), loaded.vertex_of_point);
    } catch (const sim::MeshError& problem) {
        file.fail(problem.what());
    }
}

/// `read` becomes the file's mesh, where it is from one.
void read_mesh(const Place& mesh, const std::string& folder, sim::VerificationScene& scene,
               sim::FileMesh& read) {
    mesh.keys({"box", "file", "scale", "allow_disconnected"});
    if (mesh.has("box") == mesh.has("file")) mesh.expected("either \"box\" or \"file\"");
    if (mesh.has("file")) {
        read_file_mesh(mesh, folder, scene, read);
    } else {
        if (mesh.has("scale")) mesh.at("scale").fail("belongs to \"file\"; a box is in metres");
        read_box_mesh(mesh.at("box"), scene);
    }
}

/// Triangles of a file; points that none of them uses are left out of the scene.
sim::SheetInput triangles_of(const sim::FileMesh& file, const Place& place, double scale,
                             const std::optional<int64_t>& group) {
    sim::SheetInput out;
    for (const Vec3& p : file.points) out.points.push_back(scale * p);
    for (const sim::FileTriangle& t : file.triangles) {
        if (group && t.group != *group) continue;
        if (t.point[0] < 0 || t.point[1] < 0 || t.point[2] < 0)
            place.fail("triangle number " + std::to_string(t.id) +
                       ": not three points that the file has");
        out.triangles.push_back(t.point);
    }
    return out;
}

/// "group": a number of the mesh file, or "all".
sim::SheetInput sheet_of_group(const Place& place, const sim::FileMesh& file, double scale) {
    if (file.points.empty())
        place.fail(
            "belongs to a \"mesh\" from a file; expected \"box_m\", \"file\" or \"grid\" instead");
    std::optional<int64_t> group;
    if (!place.is_text("all")) group = place.whole(0, int64_t{1} << 31);
    sim::SheetInput out = triangles_of(file, place, scale, group);
    out.output.resize(file.points.size());
    for (size_t p = 0; p < out.output.size(); ++p) out.output[p] = static_cast<int32_t>(p);
    if (!out.triangles.empty()) return out;
    std::set<int64_t> known;
    for (const sim::FileTriangle& t : file.triangles) known.insert(t.group);
    std::string list;
    for (const int64_t g : known) list += (list.empty() ? "" : ", ") + std::to_string(g);
    place.expected(known.empty() ? "a mesh file with triangles; this one has none"
                                 : "\"all\" or a group with triangles: " + list);
}

/// Squares over two edges, each of two triangles with the same diagonal.
sim::SheetInput sheet_of_grid(const Place& grid) {
    grid.keys({"origin_m", "u_m", "v_m", "cells"});
    const Vec3 origin = grid.at("origin_m").vector(), u = grid.at("u_m").vector(),
               v = grid.at("v_m").vector();
    const Place cells = grid.at("cells");
    if (!cells.is_array() || cells.size() != 2) cells.expected("an array of two whole numbers");
    const auto n = static_cast<int32_t>(cells.at(size_t{0}).whole(1, 10000));
    const auto m = static_cast<int32_t>(cells.at(size_t{1}).whole(1, 10000));
    if (2 * int64_t{n} * m > kMostTriangles)
        cells.expected("at most " + std::to_string(kMostTriangles) + " triangles (two a cell)");
    if (!(u.cross(v).norm() > 1e-6 * u.norm() * v.norm()))
        grid.at("v_m").expected("a direction beside \"u_m\"");
    sim::SheetInput out;
    for (int32_t j = 0; j <= m; ++j) {
        for (int32_t i = 0; i <= n; ++i) out.points.push_back(origin + u * i / n + v * j / m);
    }
    for (int32_t j = 0; j < m; ++j) {
        for (int32_t i = 0; i < n; ++i) {
            const int32_t a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = a + n + 1;
            out.triangles.push_back({a, b, c});
            out.triangles.push_back({a, c, d});
        }
    }
    return out;
}

void read_sheet(const Place& place, const std::string& folder, const sim::FileMesh& file,
                double mesh_scale, sim::VerificationScene& scene) {
    place.keys({"box_m", "group", "file", "grid", "scale", "thickness_m", "youngs_modulus_pa",
                "poissons_ratio", "density_kg_m3", "allow_disconnected"});
    const int sources =
        place.has("box_m") + place.has("group") + place.has("file") + place.has("grid");
    if (sources != 1) place.expected("one of \"box_m\", \"group\", \"file\" and \"grid\"");
    if (scene.sheet_materials.size() == sim::kMostSheets)
        place.fail("one sheet too many; expected at most " + std::to_string(sim::kMostSheets));
    double scale = 1;
    place.take("scale", scale, kScale);
    if (place.has("scale") && !place.has("file")) place.at("scale").fail("belongs to \"file\"");
    sim::SheetInput sheet;
    try {
        if (place.has("box_m")) {
            sheet = sim::boundary_in(scene, box_of(place.at("box_m")));
            if (sheet.triangles.empty())
                place.at("box_m").expected("a box with a boundary triangle of the mesh in it");
        } else if (place.has("group")) {
            sheet = sheet_of_group(place.at("group"), file, mesh_scale);
        } else if (place.has("grid")) {
            sheet = sheet_of_grid(place.at("grid"));
        } else {
            const Place name = place.at("file");
            sheet = triangles_of(sim::read_triangle_file(path_of(name, folder)), name, scale, {});
        }
        if (static_cast<int64_t>(sheet.triangles.size()) > kMostTriangles)
            place.fail(std::to_string(sheet.triangles.size()) + " triangles; expected at most " +
                       std::to_string(kMostTriangles));
        sheet.material = scene.material;
        read_elastic(place, sheet.material);
        sheet.thickness_m = place.at("thickness_m").number(kAnyUnit);
        place.take("allow_disconnected", sheet.allow_disconnected);
        sim::use_sheet(scene, sheet);
    } catch (const sim::MeshError& problem) {
        place.fail(problem.what());
    }
}

}  // namespace

void read_mesh_and_sheets(const Place& root, const std::string& folder,
                          sim::VerificationScene& scene) {
    sim::FileMesh file;
    double scale = 1;
    if (root.has("mesh") || !root.has("sheets")) {
        read_mesh(root.at("mesh"), folder, scene, file);
        root.at("mesh").take("scale", scale, kScale);
    }
    root.take("sheet_bending", scene.sheet_bending, {0, 1});
    if (!root.has("sheets")) {
        if (root.has("sheet_bending")) root.at("sheet_bending").fail("there are no \"sheets\"");
        return;
    }
    const Place sheets = root.at("sheets");
    sheets.each([&](const Place& place) { read_sheet(place, folder, file, scale, scene); });
    if (scene.mesh.rest.empty()) sheets.expected("at least one sheet where there is no \"mesh\"");
    // Triangles were not skipped after all.
    std::erase_if(scene.warnings, [](const std::string& w) {
        return w.find("cells: triangle") != std::string::npos;
    });
}

}  // namespace placode::curriculum
