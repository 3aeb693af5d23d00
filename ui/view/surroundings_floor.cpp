// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The floor of the canal, as it is seen through an opened sac.
#include <algorithm>
#include <cmath>

#include "ui/view/drawn_mesh.h"
#include "ui/view/surroundings.h"

namespace placode::view {

using namespace sim;
namespace {

using Eigen::Vector3f;

// Where the floor is not known it goes on as its neighbours do, a few cells at a time.
std::vector<float> grown(const CanalFloor& floor, int cells) {
    std::vector<float> height = floor.height_m;
    const auto known = [](float h) { return h > -0.02F; };
    for (int pass = 0; pass < cells; ++pass) {
        const std::vector<float> before = height;
        for (int j = 0; j < floor.rows; ++j) {
            for (int i = 0; i < floor.columns; ++i) {
                float sum = 0;
                int count = 0;
                for (int k = 0; k < 9; ++k) {
                    const int x = i + k % 3 - 1, y = j + k / 3 - 1;
                    if (x < 0 || y < 0 || x >= floor.columns || y >= floor.rows) continue;
                    const float h = before[static_cast<size_t>(y * floor.columns + x)];
                    if (!known(h)) continue;
                    sum += h;
                    ++count;
                }
                float& h = height[static_cast<size_t>(j * floor.columns + i)];
                if (!known(h) && count > 0) h = sum / static_cast<float>(count);
            }
        }
    }
    return height;
}

// A margin of unknown cells around, into which the floor can grow.
CanalFloor padded(const CanalFloor& floor, int cells) {
    CanalFloor out = floor;
    out.x_m -= cells * floor.cell_m;
    out.y_m -= cells * floor.cell_m;
    out.columns += 2 * cells;
    out.rows += 2 * cells;
    out.height_m.assign(static_cast<size_t>(out.columns * out.rows), -1.0F);
    for (int j = 0; j < floor.rows; ++j) {
        std::copy_n(floor.height_m.begin() + j * floor.columns, floor.columns,
                    out.height_m.begin() + (j + cells) * out.columns + cells);
    }
    return out;
}

}  // namespace

DrawnMesh build_floor(const CanalFloor& given) {
    constexpr float kLowest = -0.02F;  // [m] none there
    constexpr double kBelow = 1e-4;    // [m] under what lies on it
    constexpr double kReach = 0.002;   // [m] below the skin
    constexpr float kDepthMm = 1.33F, kHollow = 0.35F;
    DrawnMesh mesh;
    if (given.columns < 2 || given.rows < 2) return mesh;
    const int cells = static_cast<int>(std::ceil(kReach / given.cell_m));
    CanalFloor floor = padded(given, cells);
    floor.height_m = grown(floor, cells);
    const auto height = [&](int i, int j) {
        i = std::clamp(i, 0, floor.columns - 1);
        j = std::clamp(j, 0, floor.rows - 1);
        return std::max(floor.height_m[static_cast<size_t>(j * floor.columns + i)], kLowest);
    };
    const auto step = static_cast<float>(2 * floor.cell_m);
    for (int j = 0; j < floor.rows; ++j) {
        for (int i = 0; i < floor.columns; ++i) {
            const Vec3 p(floor.x_m + i * floor.cell_m, floor.y_m + j * floor.cell_m,
                         static_cast<double>(height(i, j)) - kBelow);
            const Vector3f n((height(i - 1, j) - height(i + 1, j)) / step,
                             (height(i, j - 1) - height(i, j + 1)) / step, 1);
            add_vertex(mesh, {(1000 * p).cast<float>(), n.normalized(), kDepthMm, kHollow});
            if (i + 1 == floor.columns || j + 1 == floor.rows) continue;
            if (std::min({height(i, j), height(i + 1, j), height(i, j + 1),
                          height(i + 1, j + 1)}) <= kLowest)
                continue;
            const auto a = static_cast<unsigned>(j * floor.columns + i);
            add_square(mesh, a, a + static_cast<unsigned>(floor.columns));
        }
    }
    return mesh;
}

}  // namespace placode::view
