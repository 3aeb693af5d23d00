// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Speed of vbd on a free sheet of 20,000 triangles: the kernel beside the same vertices solved one
// by one in double precision, as contact vertices are. Prints CSV; the least of many short runs.
#include <Eigen/Cholesky>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>

#include "sim/core/as_index.h"
#include "sim/solver/kernel_layout.h"
#include "sim/solver/soft_body_kernels.h"

using namespace placode::sim;

namespace {

double now_s() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

template <class F>
double least_s(double budget_s, F&& run) {
    double least = 1e9;
    const double stop = now_s() + budget_s;
    do {
        const double start = now_s();
        run();
        least = std::min(least, now_s() - start);
    } while (now_s() < stop);
    return least;
}

SoftBodySpec square(int cells, double bending) {
    SoftBodySpec spec;
    for (Material& m : spec.materials) m.youngs_modulus_pa = 200e3;
    const auto vertex = [cells](int i, int j) { return j * (cells + 1) + i; };
    for (int j = 0; j <= cells; ++j) {
        for (int i = 0; i <= cells; ++i) spec.mesh.rest.emplace_back(1e-3 * i, 1e-3 * j, 0);
    }
    for (int j = 0; j < cells; ++j) {
        for (int i = 0; i < cells; ++i) {
            const int a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1),
                      d = vertex(i, j + 1);
            spec.sheet.push_back({{a, b, c}, Tissue::kSkin, 1e-4});
            spec.sheet.push_back({{a, c, d}, Tissue::kSkin, 1e-4});
        }
    }
    spec.sheet_bending = bending;
    return spec;
}

void one_by_one(const SoftBody& body, SoftBodyState& state, double h) {
    for (int v = 0; v < body.vertex_count(); ++v) {
        const VertexSystem s = vertex_system(body, state, v, h);
        const Vec3 step = s.hessian.ldlt().solve(-s.gradient);
        Float4& x = state.x[as_index(v)];
        x = {static_cast<float>(x.x + step.x()), static_cast<float>(x.y + step.y()),
             static_cast<float>(x.z + step.z()), x.w};
    }
}

void measure(int cells, double bending, int threads, double budget_s) {
    const SoftBody body(square(cells, bending));
    SoftBodyState state(body);
    Workers workers(threads);
    const double h = 2.5e-4, triangles = 2.0 * cells * cells;
    run_substeps(body, state, 20, workers);
    begin_substep(body, state, h, workers);
    const double one = least_s(budget_s, [&] { one_by_one(body, state, h); });
    const double kernel = least_s(budget_s, [&] { sweep(body, state, h, workers); });
    std::printf("%s,%g,%d,%g,%.1f,%.1f,%.1f\n", kernel_target(), bending, threads, triangles,
                one * 1e9 / triangles, kernel * 1e9 / triangles, one / kernel);
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    const double budget_s = argc > 1 ? std::stod(argv[1]) : 1.0;
    std::printf("kernels,bending,threads,triangles,one_by_one_ns,kernel_ns,ratio\n");
    for (const int threads : {1, 2}) {
        for (const double bending : {1.0, 0.0}) measure(100, bending, threads, budget_s);
    }
    measure(20, 1, 1, budget_s);
}
