// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/world/cut_columns.h"

#include <algorithm>
#include <cmath>

#include "sim/core/bounds.h"
#include "sim/world/scene.h"
#include "sim/world/state.h"

namespace placode::sim {
namespace {

constexpr double kSampleStep = 0.00005;  // along a column [m]
constexpr double kSampleAbove = 0.0004;  // the surface is curved: begin above the tangent plane [m]
constexpr double kSampleBelow = 0.0008;  // and go on below the target depth [m]
constexpr double kCell = 0.0005;         // of the lookup grid [m]
constexpr uint8_t kNoColumn = 255;       // a column that meets no tissue cannot be cut
constexpr int kMiddleColumn = kColumnsPerPoint / 2;

/// Tets by the cells of the xy plane that their boxes touch.
class TetLocator {
 public:
    explicit TetLocator(const TetMesh& mesh) : mesh_(mesh) {
        const Eigen::AlignedBox3d all = bounds_of(mesh.rest);
        first_x_ = cell(all.min().x());
        first_y_ = cell(all.min().y());
        rows_ = cell(all.max().y()) - first_y_ + 1;
        columns_ = cell(all.max().x()) - first_x_ + 1;
        cells_.resize(static_cast<size_t>(rows_) * static_cast<size_t>(columns_));
        boxes_.reserve(mesh.tets.size());
        for (int t = 0; t < static_cast<int>(mesh.tets.size()); ++t) {
            Eigen::AlignedBox3d& box = boxes_.emplace_back();
            for (const int32_t v : mesh.tets[t]) box.extend(mesh.rest[v]);
            for (int i = cell(box.min().x()); i <= cell(box.max().x()); ++i) {
                for (int j = cell(box.min().y()); j <= cell(box.max().y()); ++j)
                    cells_[index(i, j)].push_back(t);
            }
            // Whatever find() takes for a point of the tet lies in here.
            const Vec3 margin = kBoxMargin * box.sizes();
            box.min() -= margin;
            box.max() += margin;
        }
    }
    /// Tet that holds `p` and its barycentric weights; -1 outside.
    [[nodiscard]] int find(const Vec3& p, Eigen::Vector4d& weight) const {
        const int i = cell(p.x()), j = cell(p.y());
        if (i < first_x_ || i >= first_x_ + columns_ || j < first_y_ || j >= first_y_ + rows_)
            return -1;
        for (const int t : cells_[index(i, j)]) {
            // Most tets of a cell lie above or below, and an inverse is dear.
            if (!boxes_[t].contains(p)) continue;
            const auto& c = mesh_.tets[t];
            Mat3 edges;
            for (int k = 0; k < 3; ++k) edges.col(k) = mesh_.rest[c[k + 1]] - mesh_.rest[c[0]];
            const Vec3 w = edges.inverse() * (p - mesh_.rest[c[0]]);
            weight << 1 - w.sum(), w.x(), w.y(), w.z();
            if (weight.minCoeff() >= kOnFace) return t;
        }
        return -1;
    }

 private:
    static constexpr double kOnFace = -1e-9;    // weight of a point that rounding put outside
    static constexpr double kBoxMargin = 1e-3;  // of a box's sides; far beyond kOnFace

    static int cell(double x) { return static_cast<int>(std::floor(x / kCell)); }
    [[nodiscard]] size_t index(int i, int j) const {
        return static_cast<size_t>(i - first_x_) * static_cast<size_t>(rows_) +
               static_cast<size_t>(j - first_y_);
    }

    const TetMesh& mesh_;
    std::vector<Eigen::AlignedBox3d> boxes_;  // (T) a little wider than the tets
    std::vector<std::vector<int32_t>> cells_;
    int first_x_ = 0, first_y_ = 0, columns_ = 0, rows_ = 0;
};

/// Frame of a contour point on the surface at rest: where, across, and outward.
struct ContourFrame {
    Vec3 at, across, normal;
};

ContourFrame contour_frame(const Scene& scene, int point) {
    const auto& contour = scene.geometry.planned_contour;
    const int n = static_cast<int>(contour.size());
    const Vec3 along = contour[(point + 1) % n] - contour[(point + n - 1) % n];
    Vec3 normal = Vec3::UnitZ();
    if (point < static_cast<int>(scene.contour_anchors.size())) {
        const auto& v = scene.contour_anchors[point].vertex;
        const auto& rest = scene.body.mesh().rest;
        const Vec3 face = (rest[v[1]] - rest[v[0]]).cross(rest[v[2]] - rest[v[0]]);
        if (face.norm() > 0) normal = face.z() < 0 ? Vec3(-face) : face;
    }
    normal.normalize();
    return {contour[point], normal.cross(along).normalized(), normal};
}

/// Tets that one column crosses between the surface and the target depth.
std::vector<int32_t> column_tets(const Scene& scene, const TetLocator& locator,
                                 const ContourFrame& frame, double offset) {
    std::vector<int32_t> found;
    const double target = scene.geometry.target_depth_m;
    const Vec3 top = frame.at + offset * frame.across + kSampleAbove * frame.normal;
    double entered = -1;
    // NOLINTNEXTLINE(clang-analyzer-security.FloatLoopCounter): replays repeat these sums.
    for (double s = 0; s <= kSampleAbove + target + kSampleBelow; s += kSampleStep) {
        Eigen::Vector4d w;
        const Vec3 p = top - s * frame.normal;
        const int t = locator.find(p, w);
        if (t < 0) continue;
        if (entered < 0) entered = s;
        double depth = s - entered;
        if (!scene.field.depth_m.empty()) {
            depth = 0;
            for (int i = 0; i < 4; ++i) {
                depth += w[i] * scene.field.depth_m[scene.body.mesh().tets[t][i]];
            }
        }
        if (depth > target) break;
        if (std::find(found.begin(), found.end(), t) == found.end()) found.push_back(t);
    }
    return found;
}

}  // namespace

CutTables make_cut_tables(const Scene& scene, CutProgress& progress) {
    CutTables tables;
    const int points = static_cast<int>(scene.geometry.planned_contour.size());
    const int tets = scene.body.tet_count();
    progress.cut.assign(points, 0);
    progress.column_left.assign(static_cast<size_t>(points) * kColumnsPerPoint, kNoColumn);
    std::vector<std::vector<int32_t>> columns_of(points > 0 ? tets : 0);
    if (points > 0) {
        const TetLocator locator(scene.body.mesh());
        for (int p = 0; p < points; ++p) {
            const ContourFrame frame = contour_frame(scene, p);
            for (int c = 0; c < kColumnsPerPoint; ++c) {
                const double offset = (c - kMiddleColumn) * kColumnSpacing;
                const auto found = column_tets(scene, locator, frame, offset);
                if (found.empty()) continue;
                const int column = p * kColumnsPerPoint + c;
                progress.column_left[column] =
                    static_cast<uint8_t>(std::min<size_t>(254, found.size()));
                for (const int32_t t : found) columns_of[t].push_back(column);
            }
        }
    }
    tables.start.assign(tets + 1, 0);
    for (int t = 0; t < tets; ++t) {
        if (points > 0) {
            tables.column.insert(tables.column.end(), columns_of[t].begin(), columns_of[t].end());
        }
        tables.start[t + 1] = static_cast<int32_t>(tables.column.size());
    }
    tables.column.shrink_to_fit();
    return tables;
}

}  // namespace placode::sim
