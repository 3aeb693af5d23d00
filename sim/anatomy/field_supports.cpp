// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/anatomy/field_supports.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "sim/core/portable_math.h"

namespace placode::sim {

namespace {

bool on_side(const OperativeFieldSpec& spec, const Vec3& p) {
    // Points on the sides are rounded to 1 nm.
    return std::abs(p.x()) > spec.domain_x_m / 2 - 2e-9 ||
           std::abs(p.y()) > spec.domain_y_m / 2 - 2e-9;
}

// Outward area vector (a third of every triangle) of the surface vertices at one level.
std::vector<Vec3> area_vectors(const FieldMesh& field, int level) {
    std::vector<Vec3> area(field.mesh.rest.size(), Vec3::Zero());
    for (const auto& t : field.plane.triangles) {
        std::array<int32_t, 3> v{};
        for (int i = 0; i < 3; ++i) v[i] = field.vertices[t[i]][level];
        const auto& x = field.mesh.rest;
        const Vec3 third = (x[v[1]] - x[v[0]]).cross(x[v[2]] - x[v[0]]) / 6;
        for (const int32_t i : v) area[i] += third;
    }
    return area;
}

// Columns that share a triangle with a side of the domain without lying on it.
std::vector<int32_t> columns_next_to_sides(const OperativeFieldSpec& spec, const FieldMesh& field) {
    const auto side = [&](int32_t c) {
        const int32_t surface = field.vertices[c][0];  // -1 in the opening of a slit
        return surface >= 0 && on_side(spec, field.mesh.rest[surface]);
    };
    std::vector<int32_t> next;
    for (const auto& t : field.plane.triangles) {
        if (!side(t[0]) && !side(t[1]) && !side(t[2])) continue;
        std::copy_if(t.begin(), t.end(), std::back_inserter(next),
                     [&](int32_t c) { return !side(c); });
    }
    std::sort(next.begin(), next.end());
    next.erase(std::unique(next.begin(), next.end()), next.end());
    return next;
}

int32_t column_next_to(const FieldMesh& field, const Vec2& p) {
    size_t best = 0;
    for (size_t c = 0; c < field.plane.points.size(); ++c) {
        if ((field.plane.points[c] - p).squaredNorm() <
            (field.plane.points[best] - p).squaredNorm()) {
            best = c;
        }
    }
    return static_cast<int32_t>(best);
}

// Roots of a placode on a sac: from its rim outwards to the canal's floor, evenly by angle, taut
// only where the sac bulges. On an empty sac they are slack, but the placode cannot wander off.
void tie_roots(const OperativeFieldSpec& spec, const FieldMesh& field, SoftBodySpec& body) {
    constexpr double kRim = 0.85, kFoot = 1.35, kSlack = 1.15;  // shares of the placode, of a root
    for (int i = 0; i < spec.tethers; ++i) {
        const SineAndCosine angle =
            sin_cos_portable(2 * std::numbers::pi * (i + 0.5) / spec.tethers);
        const Vec2 edge(spec.placode_a_m * angle.cosine, spec.placode_b_m * angle.sine);
        const Vec2 centre(0, spec.asymmetry_m);
        const int32_t rim = column_next_to(field, centre + kRim * edge);
        const int32_t foot = column_next_to(field, centre + kFoot * edge);
        Tether tether;
        tether.vertex = {field.vertices[rim][2], field.vertices[foot][3]};
        tether.rest_m =
            kSlack * (field.mesh.rest[tether.vertex[0]] - field.mesh.rest[tether.vertex[1]]).norm();
        tether.compliance_m_n = spec.tether_compliance_m_n;
        tether.break_n = spec.tether_break_n;
        body.tethers.push_back(tether);
    }
}

// Strands through the gel, from the underside of the placode to the canal's floor, spread evenly
// over the placode's columns. Slack until the placode is lifted.
void tie_tethers(const OperativeFieldSpec& spec, const FieldMesh& field, SoftBodySpec& body) {
    std::vector<int32_t> below;
    for (size_t c = 0; c < field.columns.size(); ++c) {
        if (field.columns[c].to_placode_m < -spec.blend_placode_m) {
            below.push_back(static_cast<int32_t>(c));
        }
    }
    const int count = std::min<int>(spec.tethers, static_cast<int>(below.size()));
    for (int i = 0; i < count; ++i) {
        const auto& v = field.vertices[below[i * below.size() / count]];
        Tether tether;
        tether.vertex = {v[2], v[3]};
        tether.rest_m = (field.mesh.rest[v[2]] - field.mesh.rest[v[3]]).norm();
        tether.compliance_m_n = spec.tether_compliance_m_n;
        tether.break_n = spec.tether_break_n;
        body.tethers.push_back(tether);
    }
}

}  // namespace

void lay_on_bed(const OperativeFieldSpec& spec, const FieldMesh& field, SoftBodySpec& body) {
    const std::vector<Vec3> area = area_vectors(field, kFieldLayers);
    for (size_t v = 0; v < field.mesh.rest.size(); ++v) {
        const Vec3& p = field.mesh.rest[v];
        const bool bottom = field.level[v] == kFieldLayers;
        const FieldColumn& column = field.columns[field.column[v]];
        // The canal's floor rests on bone; that of a sac reaches as far as its membrane.
        const double to_wall = spec.cystic ? column.to_skin_m : column.to_placode_m;
        if (on_side(spec, p) || (bottom && to_wall < 0)) {
            body.fixed.push_back(static_cast<int32_t>(v));
        } else if (bottom) {
            const double a = area[v].norm();
            body.springs.push_back({static_cast<int32_t>(v), p, area[v] / a,
                                    spec.bed_normal_pa_m * a, spec.bed_tangent_pa_m * a});
        }
    }
}

void hang_on_sides(const OperativeFieldSpec& spec, const FieldMesh& field, SoftBodySpec& body) {
    const std::vector<int32_t> next = columns_next_to_sides(spec, field);
    if (next.empty() || spec.side_pa_m == 0) return;
    const double share = 2 * (spec.domain_x_m + spec.domain_y_m) / static_cast<double>(next.size());
    for (const int32_t c : next) {
        for (int level = 0; level < kFieldLayers; ++level) {
            const auto& thick = field.columns[c].thickness_m;
            const double height = (level > 0 ? thick[level - 1] / 2 : 0) + thick[level] / 2;
            const int32_t v = field.vertices[c][level];
            body.springs.push_back(
                {v, field.mesh.rest[v], Vec3::UnitZ(), 0, spec.side_pa_m * share * height});
        }
    }
}

void tie_placode(const OperativeFieldSpec& spec, const FieldMesh& field, SoftBodySpec& body) {
    if (spec.cystic)
        tie_roots(spec, field, body);
    else
        tie_tethers(spec, field, body);
}

void take_pressure(const FieldMesh& field, SoftBodySpec& body) {
    if (!field.slit.watertight) return;
    for (const Slit::Station& station : field.slit.stations) {
        for (size_t level = 0; level <= static_cast<size_t>(field.slit.layers); ++level) {
            for (const int32_t v : {station.left[level], station.right[level]})
                body.springs.push_back(
                    {v, field.mesh.rest[static_cast<size_t>(v)], Vec3::UnitZ(), 0, 0});
        }
    }
}

}  // namespace placode::sim
