// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/anatomy/field_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "sim/core/portable_math.h"
#include "sim/core/random.h"

namespace placode::sim {

namespace {

constexpr int kOutlinePoints = 480;
constexpr double kTableStep = 0.0004;  // [m]; edges grow by 0.1 mm over it

double smoothstep(double low, double high, double x) {
    const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

double square(double x) { return x * x; }

// Mixes lattice coordinates and seed to [-1, 1].
double lattice_value(int64_t i, int64_t j, uint64_t seed) {
    const uint64_t h = mixed_bits(seed + kGoldenStep * static_cast<uint64_t>(i) +
                                  0xc2b2ae3d27d4eb4fULL * static_cast<uint64_t>(j));
    return static_cast<double>(h >> 11) * 0x1p-52 - 1;
}

double value_noise(const Vec2& p, uint64_t seed) {
    const double fx = std::floor(p.x()), fy = std::floor(p.y());
    const auto i = static_cast<int64_t>(fx), j = static_cast<int64_t>(fy);
    const double u = smoothstep(0, 1, p.x() - fx), v = smoothstep(0, 1, p.y() - fy);
    const double low = std::lerp(lattice_value(i, j, seed), lattice_value(i + 1, j, seed), u);
    const double high =
        std::lerp(lattice_value(i, j + 1, seed), lattice_value(i + 1, j + 1, seed), u);
    return std::lerp(low, high, v);
}

// Fractal sum of three octaves, within [-1, 1].
double fbm(const Vec2& p, uint64_t seed) {
    double sum = 0, amplitude = 4.0 / 7;
    Vec2 q = p;
    for (uint64_t octave = 0; octave < 3; ++octave) {
        sum += amplitude * value_noise(q, seed + octave);
        amplitude /= 2;
        q *= 2;
    }
    return sum;
}

double uniform(std::mt19937_64& random, double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}

}  // namespace

double squared_distance_to_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
    const Vec2 ab = b - a, ap = p - a;
    const double t = std::clamp(ap.dot(ab) / ab.squaredNorm(), 0.0, 1.0);
    return (ap - t * ab).squaredNorm();
}

Outline::Outline(const Vec2& centre, double a_m, double b_m, const std::array<double, 3>& amplitude,
                 const std::array<double, 3>& phase)
    : centre_(centre), a_m_(a_m), b_m_(b_m), amplitude_(amplitude), phase_(phase) {
    for (int i = 0; i < kOutlinePoints; ++i) {
        const double theta = 2 * std::numbers::pi * i / kOutlinePoints, s = stretch(theta);
        const SineAndCosine of = sin_cos_portable(theta);
        points_.push_back(centre_ + s * Vec2(a_m_ * of.cosine, b_m_ * of.sine));
    }
}

double Outline::stretch(double theta) const {
    double s = 1;
    for (int k = 0; k < 3; ++k)
        s += amplitude_[k] * sin_cos_portable((k + 2) * theta + phase_[k]).cosine;
    return s;
}

double Outline::rho(const Vec2& p) const {
    const Vec2 q((p.x() - centre_.x()) / a_m_, (p.y() - centre_.y()) / b_m_);
    return q.norm() / stretch(atan2_portable(q.y(), q.x()));
}

double Outline::signed_distance(const Vec2& p) const {
    const size_t n = points_.size();
    double nearest = squared_distance_to_segment(p, points_[n - 1], points_[0]);
    for (size_t i = 0; i + 1 < n; ++i) {
        nearest = std::min(nearest, squared_distance_to_segment(p, points_[i], points_[i + 1]));
    }
    return rho(p) < 1 ? -std::sqrt(nearest) : std::sqrt(nearest);
}

std::vector<Vec2> Outline::offset(double offset_m) const {
    std::vector<Vec2> out;
    const size_t n = points_.size();
    for (size_t i = 0; i < n; ++i) {
        const Vec2 along = points_[(i + 1) % n] - points_[(i + n - 1) % n];
        const Vec2 p = points_[i] + offset_m * Vec2(along.y(), -along.x()).normalized();
        // Where the outline is hollow, offset points may come too near to another part of it.
        if (signed_distance(p) > offset_m - 1e-6) out.push_back(p);
    }
    return out;
}

FieldShape::FieldShape(const OperativeFieldSpec& spec)
    : FieldShape((check_field_spec(spec), spec), wobble_of(spec)) {}

FieldShape::FieldShape(const OperativeFieldSpec& spec, const Wobble& wobble)
    : spec_(spec),
      placode_centre_(0, spec.asymmetry_m),
      placode_(placode_centre_, spec.placode_a_m, spec.placode_b_m, wobble.amplitude, wobble.phase),
      skin_(Vec2::Zero(), spec.skin_edge_a_m, spec.skin_edge_b_m, wobble.amplitude, wobble.phase),
      contour_(placode_.offset(spec.contour_offset_m)) {
    // The wobble of this seed may bring skin edge and contour closer than the check of the spec
    // could know.
    double least = 1;
    for (const Vec2& p : contour_) least = std::min(least, -skin_.signed_distance(p));
    if (least < spec.edge_ring_m / 2) {
        throw MeshError("operative field '" + spec.id + "': contour_offset_m = " +
                        std::to_string(spec.contour_offset_m) + " leads to within " +
                        std::to_string(least) + " m of the skin edge, allowed at least " +
                        std::to_string(spec.edge_ring_m / 2) + " m");
    }
    tabulate_edge_length();
}

FieldShape::Wobble FieldShape::wobble_of(const OperativeFieldSpec& spec) {
    std::mt19937_64 random(spec.seed);
    Wobble out;
    for (int k = 0; k < 3; ++k) {
        out.amplitude[k] = spec.wobble * uniform(random, -1, 1);
        out.phase[k] = uniform(random, 0, 2 * std::numbers::pi);
    }
    return out;
}

double FieldShape::relief(const Vec2& p) const {
    return fbm(p * spec_.relief_frequency_per_m, spec_.seed);
}

FieldColumn FieldShape::column(const Vec2& p) const {
    FieldColumn out;
    const double d_p = out.to_placode_m = placode_.signed_distance(p);
    const double d_s = out.to_skin_m = skin_.signed_distance(p);
    const double w_p = 1 - smoothstep(-spec_.blend_placode_m, spec_.blend_placode_m, d_p);
    const double w_s = smoothstep(-spec_.blend_skin_m, spec_.blend_skin_m, d_s);
    const double w_r = std::max(0.0, 1 - w_p - w_s), sum = w_p + w_r + w_s;

    // Base (the back of the fetus), dome of the lesion, groove, rolled rim, relief.
    // The groove fades out at the placode's edge instead of ending in a step there.
    const double groove =
        -spec_.groove_depth_m *
        exp_portable(-square((p.y() - placode_centre_.y()) / spec_.groove_width_m)) *
        smoothstep(0, spec_.blend_placode_m, -d_p);
    const double rim = spec_.rim_height_m * exp_portable(-square(d_s / spec_.rim_width_m));
    const double relief_amplitude =
        (w_s * spec_.relief_skin_m + w_p * spec_.relief_placode_m) / sum;
    out.top_m = base(p) + dome(p) + groove + rim + relief_amplitude * relief(p);

    // Atrophic skin: thin up to thin_skin_width_m outside of the edge, then full within 20 % of it.
    const double least = spec_.isotropic ? 1 : spec_.thin_skin_factor;
    const double thin = least + (1 - least) * smoothstep(0.9, 1.1, d_s / spec_.thin_skin_width_m);
    for (int l = 0; l < kFieldLayers; ++l) {
        const double skin = spec_.skin_layers_m[l] * (l < 2 ? thin : 1);
        out.thickness_m[l] =
            (w_p * spec_.placode_layers_m[l] + w_r * spec_.ring_layers_m[l] + w_s * skin) / sum;
    }
    stack_levels(p, out);
    if (spec_.cystic && d_s < 0) stack_sac(p, out);
    return out;
}

double FieldShape::base(const Vec2& p) const {
    return -square(p.y()) / (2 * spec_.base_radius_y_m) -
           square(p.x()) / (2 * spec_.base_radius_x_m);
}

double FieldShape::dome(const Vec2& p) const {
    const double rho = skin_.rho(p);
    return rho < 1 ? spec_.dome_height_m * pow_portable(1 - rho * rho, spec_.dome_exponent) : 0;
}

void FieldShape::stack_levels(const Vec2& p, FieldColumn& column) const {
    double z = column.top_m;
    column.level_m[0] = Vec3(p.x(), p.y(), z);
    for (int l = 0; l < kFieldLayers; ++l) {
        z -= column.thickness_m[l];
        column.level_m[l + 1] = Vec3(p.x(), p.y(), z);
    }
}

// The wall of the sac has its thickness across itself, not along z: on a steep flank a vertical
// stack would be thin and its tets flat. At the skin edge both agree.
void FieldShape::stack_sac(const Vec2& p, FieldColumn& column) const {
    constexpr double kStep = 0.0002, kUpright = 0.001, kWall = 0.0025;  // [m]
    const auto height = [&](double dx, double dy) {
        const Vec2 q = p + Vec2(dx, dy);
        return base(q) + dome(q);
    };
    const Vec3 normal = Vec3((height(-kStep, 0) - height(kStep, 0)) / (2 * kStep),
                             (height(0, -kStep) - height(0, kStep)) / (2 * kStep), 1)
                            .normalized();
    const double inside = -column.to_skin_m;
    const double lean = smoothstep(0, kUpright, inside);
    const Vec3 across = ((1 - lean) * Vec3::UnitZ() + lean * normal).normalized();
    double depth = 0;
    for (int l = 0; l < 2; ++l) {
        depth += column.thickness_m[l];
        column.level_m[l + 1] = column.level_m[0] - depth * across;
    }
    // The floor: as deep as the layers of the skin edge there, then the canal's.
    const double edge = column.top_m - dome(p) - depth - spec_.skin_layers_m[2];
    const double floor =
        std::lerp(edge, base(p) - spec_.canal_depth_m, smoothstep(0, kWall, inside));
    column.thickness_m[2] = column.level_m[2].z() - floor;
    column.level_m[3] = Vec3(p.x(), p.y(), floor);
    column.level_m[4] = Vec3(p.x(), p.y(), floor - column.thickness_m[3]);
}

Tissue FieldShape::tissue(int layer, double to_placode_m, double to_skin_m) const {
    if (to_placode_m < 0) {
        return std::array{Tissue::kPlacode, Tissue::kPlacode, Tissue::kGel, Tissue::kDura}[layer];
    }
    if (to_skin_m < 0) {
        return std::array{Tissue::kZone, Tissue::kZone, Tissue::kGel, Tissue::kDura}[layer];
    }
    if (layer < 2) {
        return to_skin_m < spec_.thin_skin_width_m ? Tissue::kThinSkin : Tissue::kSkin;
    }
    return layer == 2 ? Tissue::kSubcutis : Tissue::kMuscle;
}

double FieldShape::exact_edge_length(const Vec2& p) const {
    const double ring = spec_.edge_ring_m;
    if (spec_.isotropic) return ring;
    const auto grown = [&](double distance, double target) {
        const double change =
            std::min(spec_.edge_growth * std::max(0.0, distance), std::abs(target - ring));
        return target > ring ? ring + change : ring - change;
    };
    const double d_p = placode_.signed_distance(p);
    if (d_p < 0) return grown(-d_p, spec_.edge_placode_m);
    return grown(skin_.signed_distance(p) - spec_.band_outside_m, spec_.edge_outer_m);
}

void FieldShape::tabulate_edge_length() {
    table_nx_ = static_cast<int>(std::ceil(spec_.domain_x_m / kTableStep)) + 1;
    table_ny_ = static_cast<int>(std::ceil(spec_.domain_y_m / kTableStep)) + 1;
    table_m_.resize(static_cast<size_t>(table_nx_) * table_ny_);
    for (int j = 0; j < table_ny_; ++j) {
        for (int i = 0; i < table_nx_; ++i) {
            table_m_[static_cast<size_t>(j) * table_nx_ + i] = exact_edge_length(
                Vec2(i * kTableStep - spec_.domain_x_m / 2, j * kTableStep - spec_.domain_y_m / 2));
        }
    }
}

double FieldShape::edge_length(const Vec2& p) const {
    const double fx = std::clamp((p.x() + spec_.domain_x_m / 2) / kTableStep, 0.0, table_nx_ - 1.0);
    const double fy = std::clamp((p.y() + spec_.domain_y_m / 2) / kTableStep, 0.0, table_ny_ - 1.0);
    const int i = std::min(static_cast<int>(fx), table_nx_ - 2);
    const int j = std::min(static_cast<int>(fy), table_ny_ - 2);
    const double* row = table_m_.data() + static_cast<size_t>(j) * table_nx_ + i;
    return std::lerp(std::lerp(row[0], row[1], fx - i),
                     std::lerp(row[table_nx_], row[table_nx_ + 1], fx - i), fy - j);
}

}  // namespace placode::sim
