// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/solver/sweep_plan.h"

#include <algorithm>
#include <bit>
#include <numeric>

#include "sim/core/as_index.h"
#include "sim/solver/kernel_layout.h"

namespace placode::sim {
namespace {

using Tet = std::array<int32_t, 4>;

int32_t lowest(const Tet& t) { return *std::min_element(t.begin(), t.end()); }
int32_t highest(const Tet& t) { return *std::max_element(t.begin(), t.end()); }

/// Domain of each vertex: ranges that begin equally many tets.
std::vector<int32_t> cut_domains(std::span<const Tet> tets, int vertices, int domains) {
    std::vector<int64_t> begins(as_index(vertices), 0);
    for (const Tet& t : tets) ++begins[as_index(lowest(t))];
    std::vector<int32_t> domain(as_index(vertices));
    int64_t before = 0;
    for (size_t v = 0; v < domain.size(); ++v) {
        const int64_t number = before * domains / std::max<int64_t>(1, std::ssize(tets));
        domain[v] = static_cast<int32_t>(std::min<int64_t>(number, domains - 1));
        before += begins[v];
    }
    return domain;
}

/// Fills batches first fit from a window of open ones.
class Batcher {
 public:
    Batcher(std::span<const Tet> tets, int vertices, std::vector<std::vector<int32_t>>& out)
        : tets_(tets), out_(out), used_(as_index(vertices), 0) {}

    void add(int32_t t) {
        uint64_t taken = 0;
        for (const int32_t v : tets_[as_index(t)]) taken |= used_[as_index(v)];
        int slot = std::countr_one(taken);
        if (slot == kWindow) {
            emit(oldest());
            add(t);
            return;
        }
        Open& open = window_[as_index(slot)];
        if (open.tets.empty()) open.since = clock_++;
        open.tets.push_back(t);
        for (const int32_t v : tets_[as_index(t)]) used_[as_index(v)] |= uint64_t{1} << slot;
        if (open.tets.size() == kLanes) emit(slot);
    }

    void finish() {
        for (int slot = oldest(); slot >= 0; slot = oldest()) emit(slot);
    }

 private:
    static constexpr int kWindow = 64;
    struct Open {
        std::vector<int32_t> tets;
        int64_t since = 0;
    };

    /// The open batch that has waited longest, -1 = none.
    [[nodiscard]] int oldest() const {
        int best = -1;
        for (int s = 0; s < kWindow; ++s) {
            if (window_[as_index(s)].tets.empty()) continue;
            if (best < 0 || window_[as_index(s)].since < window_[as_index(best)].since) best = s;
        }
        return best;
    }

    void emit(int slot) {
        Open& open = window_[as_index(slot)];
        for (const int32_t t : open.tets) {
            for (const int32_t v : tets_[as_index(t)]) used_[as_index(v)] &= ~(uint64_t{1} << slot);
        }
        out_.push_back(std::move(open.tets));
        open.tets.clear();
    }

    std::span<const Tet> tets_;
    std::vector<std::vector<int32_t>>& out_;
    std::vector<uint64_t> used_;  // bit s: this vertex is in open batch s
    std::array<Open, kWindow> window_;
    int64_t clock_ = 0;
};

/// Orders batches [first, end) so that none waits for what the one before it has just written: the
/// earliest of the next few that shares no vertex with the last kApart, or else the one that shares
/// it longest ago. Neighbours stay near each other in time, for the cache.
void spread(std::span<const Tet> tets, int vertices, std::span<std::vector<int32_t>> batches,
            std::vector<uint8_t>& apart_out) {
    constexpr int kAhead = 48;
    constexpr int64_t kApart = 4, kLongAgo = -kApart - 1;
    std::vector<int64_t> written(as_index(vertices), kLongAgo);
    for (int64_t now = 0; now < std::ssize(batches); ++now) {
        int64_t pick = now, best = -1;
        for (int64_t i = now; i < std::min<int64_t>(now + kAhead, std::ssize(batches)); ++i) {
            int64_t newest = kLongAgo;
            for (const int32_t t : batches[as_index(i)]) {
                for (const int32_t v : tets[as_index(t)])
                    newest = std::max(newest, written[as_index(v)]);
            }
            if (const int64_t apart = now - newest; apart > best) {
                best = apart;
                pick = i;
            }
            if (best > kApart) break;
        }
        apart_out.push_back(best > 1 ? 1 : 0);
        std::rotate(batches.begin() + now, batches.begin() + pick, batches.begin() + pick + 1);
        for (const int32_t t : batches[as_index(now)]) {
            for (const int32_t v : tets[as_index(t)]) written[as_index(v)] = now;
        }
    }
}

}  // namespace

int domains_for(int tets) {
    return static_cast<int>(std::bit_floor(static_cast<unsigned>(std::clamp(tets / 10000, 1, 8))));
}

SweepPlan plan_tets(std::span<const Tet> tets, int vertices, int domains) {
    const std::vector<int32_t> domain = cut_domains(tets, vertices, domains);
    // Phase 0: inside; 1 and 2: between domain d and d + 1, d even and odd; 3: the rest.
    std::array<std::vector<std::vector<int32_t>>, 4> jobs;
    for (auto& phase : jobs) phase.resize(as_index(domains));
    for (int32_t t = 0; t < std::ssize(tets); ++t) {
        const int32_t low = domain[as_index(lowest(tets[as_index(t)]))];
        const int32_t high = domain[as_index(highest(tets[as_index(t)]))];
        const int phase = high == low ? 0 : high > low + 1 ? 3 : 1 + low % 2;
        jobs[as_index(phase)][phase == 3 ? 0 : as_index(low)].push_back(t);
    }
    SweepPlan plan;
    for (auto& phase : jobs) {
        plan.phase_start.push_back(static_cast<int32_t>(plan.job_start.size()));
        for (auto& job : phase) {
            if (job.empty()) continue;
            std::stable_sort(job.begin(), job.end(), [&](int32_t a, int32_t b) {
                return lowest(tets[as_index(a)]) < lowest(tets[as_index(b)]);
            });
            plan.job_start.push_back(static_cast<int32_t>(plan.batches.size()));
            Batcher batcher(tets, vertices, plan.batches);
            for (const int32_t t : job) batcher.add(t);
            batcher.finish();
            spread(tets, vertices, std::span(plan.batches).subspan(as_index(plan.job_start.back())),
                   plan.apart);
        }
        if (plan.phase_start.back() == std::ssize(plan.job_start)) plan.phase_start.pop_back();
    }
    plan.phase_start.push_back(static_cast<int32_t>(plan.job_start.size()));
    plan.job_start.push_back(static_cast<int32_t>(plan.batches.size()));
    return plan;
}

}  // namespace placode::sim
