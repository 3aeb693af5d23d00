// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// One substep on a team of threads. Every part works on ranges that depend on indices only, and
// inside a colour nothing is shared: the bits do not depend on the number of threads.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>

#include "sim/core/as_index.h"
#include "sim/core/event.h"
#include "sim/solver/soft_body_kernels.h"
#include "sim/solver/tethers.h"
#include "sim/solver/topology.h"
#include "sim/solver/vertex_motion.h"

namespace placode::sim {
namespace {

/// Part `part` of `parts` of [0, n), in whole cache lines.
std::pair<size_t, size_t> share(size_t n, int part, int parts) noexcept {
    const auto edge = [&](int p) {
        return p == parts ? n : n * static_cast<size_t>(p) / static_cast<size_t>(parts) / 16 * 16;
    };
    return {edge(part), edge(part + 1)};
}

/// Vertices done one by one when the kernels of begin and end give up.
constexpr size_t kByHand = 4;
/// Batches of a sheet that one thread solves in one go: some 5 us, ten times a barrier.
constexpr int kSheetJob = 8;

class Substep {
 public:
    Substep(const SoftBody& body, SoftBodyState& state, double h, Workers& workers) noexcept
        : body_(body),
          state_(state),
          packed_(packed_of(body, state)),
          workers_(workers),
          by_hand_(state, motion_) {
        const SolverSettings& s = body.spec().solver;
        vbd_ = s.method == Method::kVbd;
        h_ = h;
        arguments_.packed = &packed_;
        arguments_.x = state.x.data();
        arguments_.x_start = state.x_start.data();
        if (!state.force_n.empty()) state.pushed.resize(state.v.size());  // once
        if (!state.x_low.empty()) {
            arguments_.x_low = state.x_low.data();
            arguments_.x_start_low = state.x_start_low.data();
        }
        arguments_.v = state.force_n.empty() ? state.v.data() : state.pushed.data();
        arguments_.lanes = state.lanes.data();
        arguments_.springs = state.springs.data();
        arguments_.h = static_cast<float>(h);
        arguments_.over_relaxation = static_cast<float>(s.over_relaxation);
        if (s.method == Method::kXpbdPair) solve_tets_ = solve_tet_batches_in_pairs;
        for (size_t i = 0; i < 3; ++i) {
            const double g = s.gravity_m_s2[static_cast<Eigen::Index>(i)];
            arguments_.planned_fall_m[i] = static_cast<float>(h * h * g);
            motion_.fall_m_s[i] = static_cast<float>(h * g);
        }
        motion_.x = state.x.data();
        motion_.v = state.v.data();
        motion_.x_start = state.x_start.data();
        motion_.free_vertex = state.free_vertex.data();
        motion_.damping_per_s = packed_.damping_per_s.data();
        motion_.h = arguments_.h;
        motion_.gravity_in_guess = !vbd_;
        motion_.fused = kernels_fuse();
    }

    void begin(int part) noexcept {
        uint32_t flags = 0;
        for_vertices(part, [&](size_t i, size_t last) noexcept {
            while (i < last) {
                if (by_hand_.plain()) i = begin_motion(motion_, i, last);
                for (const size_t end = std::min(i + kByHand, last); i < end; ++i) {
                    flags |= by_hand_.begin(i);
                }
            }
        });
        raise(flags);
        if (packed_.tet_lambda_start >= 0) {
            const size_t start = as_index(packed_.tet_lambda_start);
            const auto [a, b] = share(state_.lanes.size() - start, part, workers_.threads());
            std::fill(state_.lanes.begin() + static_cast<int64_t>(start + a),
                      state_.lanes.begin() + static_cast<int64_t>(start + b), 0.0F);
        }
        if (part == 0) {
            // A broken one keeps the force at which it broke, for the ledger.
            for (size_t i = 0; i < state_.tether_lambda_n.size(); ++i)
                if (state_.tether_alive[i] != 0) state_.tether_lambda_n[i] = 0;
        }
    }

    /// One sweep, from the caller: a run of the team for each colour or phase.
    void sweep() noexcept { vbd_ ? sweep_vertices() : sweep_tets(); }

    void end(int part) noexcept {
        uint32_t flags = 0;
        for_vertices(part, [&](size_t i, size_t last) noexcept {
            while (i < last) {
                if (by_hand_.plain()) i = end_motion(motion_, i, last);
                for (const size_t end = std::min(i + kByHand, last); i < end; ++i) {
                    flags |= by_hand_.end(i);
                }
            }
        });
        raise(flags);
        if (part == 0) break_tethers();
    }

    /// A whole substep without contact, from the caller.
    void all(int iterations) noexcept {
        workers_.run<&Substep::begin>(workers_.threads(), *this);
        for (int k = 0; k < iterations; ++k) sweep();
        workers_.run<&Substep::end>(workers_.threads(), *this);
    }

    /// Contact vertices are held for the time of a sweep; x_start.w remembers.
    void hold_contacts() noexcept {
        for_contacts([&](size_t i) noexcept {
            state_.x_start[i].w = state_.x[i].w;
            state_.x[i].w = 0;
        });
    }
    void release_contacts() noexcept {
        for_contacts([&](size_t i) noexcept { state_.x[i].w = state_.x_start[i].w; });
    }

    [[nodiscard]] bool broke_tether() const noexcept { return broke_; }

 private:
    void sweep_vertices() noexcept {
        const auto& phases = packed_.phase_start;
        for (size_t p = 0; p + 1 < phases.size(); ++p) {
            first_job_ = phases[p];
            workers_.run<&Substep::vertex_job>(phases[p + 1] - phases[p], *this);
        }
        sweep_sheets();
        if (!packed_.single_vertices.empty()) raise(solve_singles_vbd(body_, state_, h_));
    }
    /// Colour by colour. A sheet of its own material is stiffer than tissue by far (Courant numbers
    /// of 14 in its plane): it is swept there and back, and without over-relaxation, or it bursts.
    void sweep_sheets() noexcept {
        const auto& colours = packed_.sheet_strips.colour_start;
        const bool stiff = body_.spec().sheet_material.has_value();
        const AwakeRuns& awake = state_.awake;
        if (stiff && !awake.all && awake.job_start.back() == std::ssize(awake.batches)) return;
        const float kept = arguments_.over_relaxation;
        if (stiff) arguments_.over_relaxation = 1;
        for (size_t c = 0; c + 1 < colours.size(); ++c) sweep_sheet_colour(c);
        for (size_t c = colours.size(); stiff && c > 1; --c) sweep_sheet_colour(c - 2);
        arguments_.over_relaxation = kept;
    }
    /// The jobs of a colour touch nothing of each other, in any number of them.
    void sweep_sheet_colour(size_t colour) noexcept {
        first_job_ = packed_.sheet_strips.colour_start[colour];
        jobs_end_ = packed_.sheet_strips.colour_start[colour + 1];
        const int jobs = (jobs_end_ - first_job_ + kSheetJob - 1) / kSheetJob;
        if (jobs == 1)
            sheet_job(0);
        else
            workers_.run<&Substep::sheet_job>(jobs, *this);
    }
    void sheet_job(int number) noexcept {
        const int first = first_job_ + number * kSheetJob;
        raise(solve_sheet_batches(arguments_, first, std::min(first + kSheetJob, jobs_end_)));
    }
    void vertex_job(int number) noexcept {
        const size_t job = as_index(first_job_ + number);
        const AwakeRuns& awake = state_.awake;
        uint32_t flags = 0;
        if (awake.all) {
            flags = solve_vertex_batches(arguments_, packed_.job_start[job],
                                         packed_.job_start[job + 1]);
        } else {
            for (int r = awake.job_start[job]; r < awake.job_start[job + 1]; ++r) {
                const auto& [first, last] = awake.batches[as_index(r)];
                flags |= solve_vertex_batches(arguments_, first, last);
            }
        }
        for_copies(state_, static_cast<int>(job), [&](int batch) noexcept {
            flags |= solve_vertex_batches(arguments_, batch, batch + 1);
        });
        raise(flags);
    }

    void sweep_tets() noexcept {
        const bool backward = body_.turns() && state_.backward;
        state_.backward = !state_.backward;
        arguments_.direction = backward ? -1 : 1;
        const auto& phases = packed_.tet_phase_start;
        for (size_t n = 1; n < phases.size(); ++n) {
            const size_t p = backward ? phases.size() - 1 - n : n - 1;
            first_job_ = phases[p];
            workers_.run<&Substep::tet_job>(phases[p + 1] - phases[p], *this);
        }
        if (!packed_.springs.empty()) {
            workers_.run<&Substep::spring_job>(workers_.threads(), *this);
        }
        solve_tethers_xpbd(body_, state_, h_);
    }
    void spring_job(int part) noexcept {
        for_share(state_.awake.batches, packed_.batches.size(), part,
                  [&](size_t first, size_t last) noexcept {
                      solve_spring_batches(arguments_, static_cast<int>(first),
                                           static_cast<int>(last));
                  });
    }
    void tet_job(int number) noexcept {
        const size_t job = as_index(first_job_ + number);
        const AwakeRuns& awake = state_.awake;
        if (awake.all) {
            solve_tets_(arguments_, packed_.tet_job_start[job], packed_.tet_job_start[job + 1]);
            return;
        }
        const int start = awake.tet_job_start[job], end = awake.tet_job_start[job + 1];
        for (int r = start; r < end; ++r) {
            const auto& [first, last] =
                awake.tets[as_index(arguments_.direction < 0 ? start + end - 1 - r : r)];
            solve_tets_(arguments_, first, last);
        }
    }

    /// Calls `visit(first, last)` on the part's share of the vertices that are awake.
    template <class Visit>
    void for_vertices(int part, Visit&& visit) const noexcept {
        for_share(state_.awake.vertices, state_.x.size(), part, std::forward<Visit>(visit));
    }

    /// Calls `visit(first, last)` on the part's share of all `n`, or of the runs that are awake.
    template <class Visit>
    void for_share(const std::vector<AwakeRuns::Run>& runs, size_t n, int part,
                   Visit&& visit) const noexcept {
        if (state_.awake.all) {
            const auto [first, last] = share(n, part, workers_.threads());
            visit(first, last);
            return;
        }
        size_t count = 0;
        for (const auto& [first, last] : runs) count += as_index(last - first);
        auto [from, to] = share(count, part, workers_.threads());
        for (const auto& [first, last] : runs) {
            const size_t here = as_index(last - first);
            if (from < here && to > 0)
                visit(as_index(first) + from, as_index(first) + std::min(to, here));
            from -= std::min(from, here);
            to -= std::min(to, here);
        }
    }

    template <class Visit>
    void for_contacts(Visit&& visit) const noexcept {
        const uint8_t* const flags = state_.contact_vertex.data();
        const size_t count = state_.contact_vertex.size();
        for (size_t i = 0; i < count; ++i) {
            const void* next = std::memchr(flags + i, 1, count - i);
            if (next == nullptr) return;
            i = static_cast<size_t>(static_cast<const uint8_t*>(next) - flags);
            visit(i);
        }
    }

    void raise(uint32_t flags) noexcept {
        if (flags != 0) {
            std::atomic_ref<uint32_t>(state_.flags).fetch_or(flags, std::memory_order_relaxed);
        }
    }

    void break_tethers() noexcept { broke_ = break_overloaded_tethers(body_, state_); }

    const SoftBody& body_;
    SoftBodyState& state_;
    const KernelLayout& packed_;
    Workers& workers_;
    KernelArguments arguments_;
    decltype(&solve_tet_batches) solve_tets_ = solve_tet_batches;
    MotionArguments motion_;
    VertexMotion by_hand_;
    double h_ = 0;
    int first_job_ = 0;  // of the current run
    int jobs_end_ = 0;   // of a colour of the sheets: one past its last batch
    bool vbd_ = true, broke_ = false;
};

}  // namespace

void begin_substep(const SoftBody& body, SoftBodyState& state, double h,
                   Workers& workers) noexcept {
    Substep job(body, state, h, workers);
    workers.run<&Substep::begin>(workers.threads(), job);
}

void sweep(const SoftBody& body, SoftBodyState& state, double h, Workers& workers) noexcept {
    Substep job(body, state, h, workers);
    job.hold_contacts();
    job.sweep();
    job.release_contacts();
}

void end_substep(const SoftBody& body, SoftBodyState& state, double h, Workers& workers) noexcept {
    Substep job(body, state, h, workers);
    workers.run<&Substep::end>(workers.threads(), job);
    if (!job.broke_tether()) return;
    const bool holding = state.awake.holding;  // what sleeps holds nothing
    release_sleepers(state);
    update_free_vertices(body, state);
    if (holding) hold_sleepers(state);
}

void run_substeps(const SoftBody& body, SoftBodyState& state, int substeps,
                  Workers& workers) noexcept {
    const SolverSettings& s = body.spec().solver;
    state.backward = false;
    const bool contact = std::any_of(state.contact_vertex.begin(), state.contact_vertex.end(),
                                     [](uint8_t c) { return c != 0; });
    if (contact || !state.tether_alive.empty()) {
        // Held vertices and breaking tethers are looked after between the calls.
        for (int i = 0; i < substeps; ++i) {
            const double h = s.frame_s / s.substeps;
            begin_substep(body, state, h, workers);
            for (int k = 0; k < s.iterations; ++k) sweep(body, state, h, workers);
            end_substep(body, state, h, workers);
        }
        return;
    }
    Substep job(body, state, s.frame_s / s.substeps, workers);
    for (int i = 0; i < substeps; ++i) job.all(s.iterations);
}

}  // namespace placode::sim
