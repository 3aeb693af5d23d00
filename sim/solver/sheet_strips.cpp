// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/solver/sheet_strips.h"

#include <algorithm>
#include <cmath>

#include "sim/core/as_index.h"
#include "sim/core/portable_math.h"
#include "sim/mesh/dihedral.h"
#include "sim/solver/kernel_layout.h"

namespace placode::sim {
namespace {

/// Number of the edge between two corners of a triangle.
size_t edge_of(const std::array<int32_t, 3>& v, int32_t a, int32_t b) noexcept {
    for (size_t k = 0; k < 3; ++k) {
        const int32_t from = v[k], to = v[(k + 1) % 3];
        if ((from == a && to == b) || (from == b && to == a)) return k;
    }
    return 3;
}

/// A power of two, so that scaling rounds nothing.
double units_a_metre(const SoftBody& body) {
    double sum = 0;
    for (const SheetTriangle& t : body.spec().sheet) sum += area_of(body.mesh().rest, t);
    const double mean = sum / static_cast<double>(body.spec().sheet.size());
    return std::ldexp(1.0, static_cast<int>(std::round(-log2_portable(2 * mean) / 2)));
}

/// The triangle beyond every edge.
std::vector<std::array<int32_t, 3>> neighbours(const std::vector<SheetElement>& triangles) {
    std::vector<std::array<int32_t, 4>> sides;  // vertices in rising order, triangle, edge
    for (size_t t = 0; t < triangles.size(); ++t) {
        for (size_t k = 0; k < 3; ++k) {
            const auto [a, b] = std::minmax(triangles[t].v[k], triangles[t].v[(k + 1) % 3]);
            sides.push_back({a, b, static_cast<int32_t>(t), static_cast<int32_t>(k)});
        }
    }
    std::sort(sides.begin(), sides.end());
    std::vector<std::array<int32_t, 3>> out(triangles.size(), {-1, -1, -1});
    for (size_t i = 1; i < sides.size(); ++i) {
        const auto &s = sides[i], &r = sides[i - 1];
        if (s[0] != r[0] || s[1] != r[1]) continue;
        out[as_index(s[2])][as_index(s[3])] = r[2];
        out[as_index(r[2])][as_index(r[3])] = s[2];
    }
    return out;
}

}  // namespace

SheetFans::SheetFans(const SoftBody& body)
    : body_(body),
      elements_(sheet_elements(body.spec())),
      neighbour_(neighbours(elements_.triangles)),
      per_length_(units_a_metre(body)),
      bends_(body.spec().sheet_bending > 0) {}

int SheetFans::steps(int32_t vertex) const {
    if (elements_.around(vertex).empty()) return 0;
    return static_cast<int>(fan_of(vertex).steps.size()) - 1;
}

std::vector<int32_t> SheetFans::around(int32_t vertex) const {
    std::vector<int32_t> out;
    for (const int32_t t : elements_.around(vertex)) {
        const SheetElement& e = elements_.triangles[as_index(t)];
        for (const auto& corners : {e.v, e.flap}) {
            for (const int32_t v : corners) {
                if (v >= 0 && v != vertex) out.push_back(v);
            }
        }
    }
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
}

int32_t SheetFans::beyond(int32_t triangle, int32_t a, int32_t b) const {
    if (triangle < 0) return -1;
    return neighbour_[as_index(triangle)][edge_of(elements_.triangles[as_index(triangle)].v, a, b)];
}

/// Takes the triangles at the vertex that hang together by edges, round the vertex; the next ones,
/// where it has several such fans, follow behind a step that leads over to them.
SheetFans::Fan SheetFans::fan_of(int32_t vertex) const {
    std::vector<int32_t> own;
    for (const int32_t t : elements_.around(vertex)) {
        const auto& v = elements_.triangles[as_index(t)].v;
        if (std::find(v.begin(), v.end(), vertex) != v.end()) own.push_back(t);
    }
    Fan fan;
    fan.before = fan.first = vertex;
    std::vector<int32_t> left = own;
    while (!left.empty()) {
        // Back from any triangle to the first one of its fan, then forward to the last.
        const auto turn = [&](int32_t t, int32_t from) {  // the third corner
            for (const int32_t v : elements_.triangles[as_index(t)].v) {
                if (v != vertex && v != from) return v;
            }
            return vertex;
        };
        const auto& first = elements_.triangles[as_index(left.front())].v;
        const size_t at = as_index(std::find(first.begin(), first.end(), vertex) - first.begin());
        int32_t t = left.front(), a = first[(at + 1) % 3];
        bool closed = false;
        for (int32_t back = beyond(t, vertex, a); back >= 0; back = beyond(t, vertex, a)) {
            if (back == left.front()) {
                closed = true;
                t = left.front();
                a = first[(at + 1) % 3];
                break;
            }
            a = turn(back, a);
            t = back;
        }
        std::vector<std::array<int32_t, 3>> ring;  // triangle, a, b
        for (const int32_t start = t; t >= 0;) {
            const int32_t b = turn(t, a);
            ring.push_back({t, a, b});
            left.erase(std::find(left.begin(), left.end(), t));
            t = beyond(t, vertex, b);
            a = b;
            if (t == start) break;
        }
        append(vertex, ring, closed, fan);
    }
    return fan;
}

void SheetFans::append(int32_t vertex, const std::vector<std::array<int32_t, 3>>& ring, bool closed,
                       Fan& out) const {
    const int32_t before = closed ? ring.back()[1] : vertex, first = ring.front()[1];
    const auto lead = [&](int32_t to) {
        Step step;
        step.point = {to, vertex, vertex, vertex};
        return step;
    };
    if (out.steps.empty()) {
        out.before = before;
        out.first = first;
    } else {
        out.steps.push_back(lead(before));
        out.steps.push_back(lead(first));
    }
    for (const auto& [t, a, b] : ring) out.steps.push_back(step_of(vertex, a, b, t));
    // The last edge: in a closed fan the first one again, with the triangle behind it.
    Step last = lead(closed ? ring.front()[2] : vertex);
    if (closed && bends_) {
        const Step& begin = out.steps[out.steps.size() - ring.size()];
        last.row[kSpokeCos] = begin.row[kSpokeCos];
        last.row[kSpokeSin] = begin.row[kSpokeSin];
    }
    out.steps.push_back(last);
}

SheetFans::Step SheetFans::step_of(int32_t v, int32_t a, int32_t b, int32_t triangle) const {
    const SheetElement& t = elements_.triangles[as_index(triangle)];
    Step step;
    step.point = {b, v, v, v};
    const double area = per_length_ * per_length_;  // units of area a square metre
    const auto set = [&step](int row, double value) {
        step.row[as_index(row)] = static_cast<float>(value);
    };
    set(kEdgeA, t.edge_n_m[edge_of(t.v, v, a)] / area);
    set(kEdgeB, t.edge_n_m[edge_of(t.v, v, b)] / area);
    set(kAreaScale, t.r2 / (area * area));
    // W'(q) V = -pressure / (1 + stiffening q)^2
    const double mu = t.material.mu_pa, lambda = t.material.lambda_pa;
    set(kPressure, t.volume_m3 * (mu + lambda) * (mu + lambda) / (2 * mu));
    set(kStiffening, lambda / mu);
    if (bends_) set_bending(step, v, a, b, triangle);
    return step;
}

void SheetFans::set_angle(Step& step, int row, const std::array<int32_t, 4>& hinge) const {
    HingePoints<double> p;
    for (size_t k = 0; k < 4; ++k) p[k] = body_.mesh().rest[as_index(hinge[k])];
    const SineAndCosine angle = sin_cos_portable(hinge_angle(p));
    step.row[as_index(row)] = static_cast<float>(angle.cosine);
    step.row[as_index(row) + 1] = static_cast<float>(angle.sine);
}

void SheetFans::set_bending(Step& step, int32_t v, int32_t a, int32_t b, int32_t triangle) const {
    const SheetElement& t = elements_.triangles[as_index(triangle)];
    const std::array<size_t, 3> edge{edge_of(t.v, v, a), edge_of(t.v, a, b), edge_of(t.v, b, v)};
    const auto own = [&](size_t i, size_t k) {
        return t.bending(static_cast<int>(edge[i]), static_cast<int>(edge[k]));
    };
    const auto set = [&step](int row, double value) {
        step.row[as_index(row)] = static_cast<float>(value);
    };
    set(kBend00, own(0, 0));
    set(kBend01, own(0, 1));
    set(kBend02, own(0, 2));
    set(kBend12, own(1, 2));
    set(kBend22, own(2, 2));
    double rim = own(1, 1);
    if (const int32_t before = t.flap[edge[0]]; before >= 0)
        set_angle(step, kSpokeCos, {v, a, b, before});
    if (const int32_t far = beyond(triangle, a, b); far >= 0) {
        const SheetElement& f = elements_.triangles[as_index(far)];
        const int32_t o = t.flap[edge[1]];
        step.point[1] = o;
        set_angle(step, kRimCos, {a, b, v, o});
        const size_t middle = edge_of(f.v, a, b), first = edge_of(f.v, a, o),
                     second = edge_of(f.v, o, b);
        const auto theirs = [&](size_t k) {
            return f.bending(static_cast<int>(middle), static_cast<int>(k));
        };
        rim += theirs(middle);
        set(kRimFirst, theirs(first));
        set(kRimSecond, theirs(second));
        if (const int32_t p = f.flap[first]; p >= 0) {
            step.point[2] = p;
            set_angle(step, kFirstCos, {a, o, b, p});
        }
        if (const int32_t q = f.flap[second]; q >= 0) {
            step.point[3] = q;
            set_angle(step, kSecondCos, {o, b, a, q});
        }
    }
    set(kBend11, rim);
}

void SheetFans::add(const std::vector<int32_t>& members, int32_t batch, SheetStrips& out) const {
    SheetBatch b;
    b.batch = batch;
    b.start = static_cast<int64_t>(out.index.size()) / (kSheetPoints * kLanes);
    std::vector<Fan> fans;
    for (const int32_t v : members) {
        fans.push_back(fan_of(v));
        b.steps = std::max(b.steps, static_cast<int32_t>(fans.back().steps.size()) - 1);
    }
    const auto offset = [](int32_t v) { return 2 * static_cast<uint32_t>(v); };
    const size_t steps = as_index(b.steps) + 1;
    const size_t entry = out.entry.size(), index = out.index.size(), rows = out.rows.size();
    out.entry.resize(entry + 2 * kLanes);
    out.index.resize(index + steps * kSheetPoints * kLanes);
    out.rows.resize(rows + steps * kSheetRows * kLanes, 0.0F);
    for (size_t lane = 0; lane < kLanes; ++lane) {
        const bool used = lane < members.size();
        const int32_t self = members[used ? lane : 0];
        out.entry[entry + lane] = offset(used ? fans[lane].before : self);
        out.entry[entry + kLanes + lane] = offset(used ? fans[lane].first : self);
        for (size_t s = 0; s < steps; ++s) {
            const bool there = used && s < fans[lane].steps.size();
            for (size_t k = 0; k < kSheetPoints; ++k) {
                out.index[index + (s * kSheetPoints + k) * kLanes + lane] =
                    offset(there ? fans[lane].steps[s].point[k] : self);
            }
            for (size_t r = 0; r < kSheetRows && there; ++r)
                out.rows[rows + (s * kSheetRows + r) * kLanes + lane] = fans[lane].steps[s].row[r];
        }
    }
    out.batches.push_back(b);
}

}  // namespace placode::sim
