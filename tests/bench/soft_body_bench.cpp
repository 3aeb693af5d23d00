// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Speed of the solver on a slab of 43,200 tets. Prints CSV; the least of many short runs, because
// a busy machine only ever adds time.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <string>

#include "sim/solver/soft_body.h"

using namespace placode::sim;

namespace {

double now_s() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

std::string machine() {
    std::ifstream in("/proc/cpuinfo");
    for (std::string line; std::getline(in, line);) {
        if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
    }
    return "unknown";
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

void measure(Method method, const char* name, int threads, double budget_s) {
    SoftBodySpec spec;
    const TetMesh box = box_mesh(Vec3(60e-3, 30e-3, 4e-3), {60, 30, 4}, Tissue::kPlacode);
    spec.mesh = renumbered(box, rcm_order(box));
    spec.solver.method = method;
    spec.solver.substeps = 8;
    for (int v = 0; v < static_cast<int>(spec.mesh.rest.size()); ++v) {
        if (spec.mesh.rest[static_cast<size_t>(v)].z() < 1e-9) spec.fixed.push_back(v);
    }
    // Springs instead of fixed vertices: every vertex is swept.
    for (const int32_t v : spec.fixed) {
        spec.springs.push_back({v, spec.mesh.rest[static_cast<size_t>(v)], Vec3::UnitZ(), 1, 0.1});
    }
    spec.fixed.clear();
    const SoftBody body(std::move(spec));
    SoftBodyState state(body);
    Workers workers(threads);
    const double h = 1e-3 / 8;
    run_substeps(body, state, 50, workers);
    begin_substep(body, state, h, workers);
    const double sweep_s = least_s(budget_s, [&] { sweep(body, state, h, workers); });
    end_substep(body, state, h, workers);
    const double substep_s = least_s(budget_s, [&] { run_substeps(body, state, 4, workers); }) / 4;
    std::printf("\"%s\",%s,%s,%d,%d,%d,%.2f,%.0f\n", machine().c_str(), kernel_target(), name,
                threads, body.tet_count(), body.vertex_count(), sweep_s * 1e9 / body.tet_count(),
                1 / substep_s);
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    const double budget_s = argc > 1 ? std::stod(argv[1]) : 1.0;
    std::printf("machine,kernels,method,threads,tets,vertices,sweep_ns_per_tet,substeps_per_s\n");
    for (int threads = 1; threads <= 2; ++threads) {
        measure(Method::kVbd, "vbd", threads, budget_s);
        measure(Method::kXpbd, "xpbd", threads, budget_s);
        measure(Method::kXpbdPair, "xpbd_pair", threads, budget_s);
    }
}
