// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/tile_noise.h"

#include <cmath>

#include "sim/core/geometry.h"
#include "ui/view/vessel_tree.h"

namespace placode::view {

using namespace sim;
namespace {

// Gradient noise on a torus of `period` cells.
class TileNoise {
 public:
    TileNoise(int period, std::mt19937_64& random) : period_(period) {
        for (int i = 0; i < period * period; ++i) {
            const double a = 2 * 3.14159265358979 * unit(random);
            slope_.emplace_back(std::cos(a), std::sin(a));
        }
    }
    [[nodiscard]] double at(double u, double v) const {
        const double x = u * period_, y = v * period_;
        const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
        const double fx = x - i, fy = y - j;
        const auto fade = [](double t) { return t * t * t * (t * (t * 6 - 15) + 10); };
        const auto corner = [&](int a, int b) {
            const int ii = ((i + a) % period_ + period_) % period_;
            const int jj = ((j + b) % period_ + period_) % period_;
            return slope_[static_cast<size_t>(jj * period_ + ii)].dot(Vec2(fx - a, fy - b));
        };
        const double sx = fade(fx), sy = fade(fy);
        const double top = corner(0, 0) + sx * (corner(1, 0) - corner(0, 0));
        const double bottom = corner(0, 1) + sx * (corner(1, 1) - corner(0, 1));
        return top + sy * (bottom - top);
    }

 private:
    int period_;
    std::vector<Vec2> slope_;
};

}  // namespace

std::vector<double> fbm_field(int size, int period, int octaves, double gain,
                              std::mt19937_64& random) {
    std::vector<double> field(static_cast<size_t>(size) * static_cast<size_t>(size), 0.0);
    double amplitude = 1;
    for (int o = 0; o < octaves; ++o) {
        const TileNoise noise(period << o, random);
        for (int j = 0; j < size; ++j) {
            for (int i = 0; i < size; ++i) {
                field[static_cast<size_t>(j * size + i)] +=
                    amplitude * noise.at((i + 0.5) / size, (j + 0.5) / size);
            }
        }
        amplitude *= gain;
    }
    return field;
}

}  // namespace placode::view
