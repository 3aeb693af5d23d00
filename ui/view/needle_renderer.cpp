// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/needle_renderer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ui/view/tissue_mesh.h"
#include "ui/view/tool_renderer.h"

namespace placode::view {

using namespace sim;
namespace {

constexpr int kSides = 8, kSections = 48;
constexpr double kTaper = 0.22, kSwage = 0.10;  // shares of the arc
constexpr double kSwageWider = 1.25;            // the wire is drilled for the thread there
constexpr double kThreadRadiusMm = 0.09;        // 4/0
constexpr double kFarMm = 1e5;  // along a shaft: without the depth rings of instruments

class Tube {
 public:
    Tube(NeedleMesh& mesh, float material) : mesh_(mesh), material_(material) {}

    /// The next section of the tube.
    void section(const Vec3& at, const Vec3& along, double radius) {
        // The frame is carried on from section to section: a tube does not twist.
        if (count_ == 0) side_ = std::abs(along.z()) < 0.9 ? Vec3::UnitZ() : Vec3::UnitX();
        side_ = (side_ - side_.dot(along) * along).normalized();
        const Vec3 other = along.cross(side_);
        const auto first = static_cast<unsigned>(mesh_.vertices.size()) / kTissueVertexFloats;
        for (int k = 0; k < kSides; ++k) {
            const double a = 2 * std::numbers::pi * k / kSides;
            const Vec3 n = std::cos(a) * side_ + std::sin(a) * other;
            const Vec3 p = at + radius * n;
            const float row[kTissueVertexFloats] = {static_cast<float>(p.x()),
                                                    static_cast<float>(p.y()),
                                                    static_cast<float>(p.z()),
                                                    static_cast<float>(n.x()),
                                                    static_cast<float>(n.y()),
                                                    static_cast<float>(n.z()),
                                                    material_,
                                                    static_cast<float>(kFarMm),
                                                    static_cast<float>(a),
                                                    0,
                                                    0,
                                                    0,
                                                    0,
                                                    0,
                                                    0,
                                                    0};
            mesh_.vertices.insert(mesh_.vertices.end(), std::begin(row), std::end(row));
        }
        if (count_++ == 0) return;
        for (unsigned k = 0; k < kSides; ++k) {
            const unsigned a = first - kSides + k, b = first - kSides + (k + 1) % kSides;
            for (const unsigned v : {a, b, a + kSides, a + kSides, b, b + kSides})
                mesh_.indices.push_back(v);
        }
    }

 private:
    NeedleMesh& mesh_;
    float material_;
    Vec3 side_ = Vec3::UnitX();
    int count_ = 0;
};

Vec3 place_mm(const std::array<float, 3>& p) {
    return 1000 *
           Vec3(static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2]));
}

void add_needle(const NeedleSnapshot& needle, NeedleMesh& mesh) {
    const double radius = 1000 * static_cast<double>(needle.arc_m) / std::numbers::pi;
    const double wire = 1000 * static_cast<double>(needle.wire_radius_m);
    Tube tube(mesh, static_cast<float>(ToolMaterial::kSteel));
    for (int i = 0; i <= kSections; ++i) {
        const double share = static_cast<double>(i) / kSections, a = std::numbers::pi * share;
        const Vec3 radial(std::cos(a), std::sin(a), 0), back(-std::sin(a), std::cos(a), 0);
        double thick = wire * std::min(1.0, 0.05 + share / kTaper);
        if (share > 1 - kSwage) thick = kSwageWider * wire;
        tube.section(1000 * needle.pose.p + needle.pose.q * Vec3(radius * radial),
                     needle.pose.q * back, thick);
    }
}

void add_thread(const std::vector<std::array<float, 3>>& line, NeedleMesh& mesh) {
    Tube tube(mesh, static_cast<float>(ToolMaterial::kThread));
    for (size_t i = 0; i < line.size(); ++i) {
        const Vec3 offset =
            place_mm(line[std::min(i + 1, line.size() - 1)]) - place_mm(line[i > 0 ? i - 1 : 0]);
        if (offset.norm() > 0)
            tube.section(place_mm(line[i]), offset.normalized(), kThreadRadiusMm);
    }
}

}  // namespace

void NeedleMesh::build(const NeedleSnapshot& needle) {
    vertices.clear();
    indices.clear();
    if (needle.present == 0) return;
    add_needle(needle, *this);
    if (needle.thread.size() > 1) add_thread(needle.thread, *this);
    if (needle.loop.size() > 1) add_thread(needle.loop, *this);
}

NeedleRenderer::NeedleRenderer() { gl_.create({3, 3, 4, 4, 2}); }

void NeedleRenderer::draw(const NeedleSnapshot& needle, GlProgram& program) {
    mesh_.build(needle);
    if (mesh_.indices.empty()) return;
    gl_.vertices(mesh_.vertices.data(), mesh_.vertices.size(), true);
    gl_.indices(mesh_.indices);
    program.set("energised", 0.0F);
    gl_.draw(GL_TRIANGLES);
}

}  // namespace placode::view
