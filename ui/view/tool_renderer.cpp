// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/tool_renderer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/core/shared_hand.h"
#include "ui/view/camera.h"
#include "ui/view/tissue_mesh.h"

namespace placode::view {

using namespace sim;
namespace {

using Eigen::Vector3f;
constexpr int kSides = 28;
constexpr float kTurn = 2 * std::numbers::pi_v<float>;

struct ProfilePoint {
    float along, radius;  // [mm] from the tip, towards the hand
    ToolMaterial material;
};

// Surface of revolution. Every band has its own vertices; a normal is shared with the neighbouring
// band only where the profile bends by less than 35 degrees.
void add_revolution(ToolModel& shape, const std::vector<ProfilePoint>& profile) {
    const size_t bands = profile.size() - 1;
    std::vector<Eigen::Vector2f> slope(bands);
    for (size_t i = 0; i < bands; ++i) {
        const float dz = profile[i + 1].along - profile[i].along,
                    dr = profile[i + 1].radius - profile[i].radius;
        slope[i] = Eigen::Vector2f(dz, dr)
                       .normalized();  // outward = (radial dz, axial +dr towards the tip)
    }
    const auto normal_at = [&](size_t band, size_t point) {
        Eigen::Vector2f s = slope[band];
        const size_t other = point == band ? band - 1 : band + 1;
        if (other < bands && slope[other].dot(s) > 0.82F) s = (s + slope[other]).normalized();
        return s;
    };
    for (size_t i = 0; i < bands; ++i) {
        const auto base = static_cast<unsigned>(shape.vertices.size());
        for (size_t end = 0; end < 2; ++end) {
            const ProfilePoint& p = profile[i + end];
            const Eigen::Vector2f s = normal_at(i, i + end);
            for (int k = 0; k <= kSides; ++k) {
                const float angle = kTurn * static_cast<float>(k) / kSides;
                const Vector3f out(std::cos(angle), std::sin(angle), 0);
                shape.vertices.push_back(
                    {p.radius * out - Vector3f(0, 0, p.along), s.x() * out + Vector3f(0, 0, s.y()),
                     static_cast<float>(profile[i].material), p.along, angle, 0});
            }
        }
        for (unsigned k = 0; k < kSides; ++k) {
            const unsigned a = base + k, b = a + kSides + 1;
            for (const unsigned v : {a, b, a + 1, a + 1, b, b + 1}) shape.indices.push_back(v);
        }
    }
}

void add_face(ToolModel& shape, const std::array<Vector3f, 4>& p, ToolMaterial material, int jaw) {
    const auto base = static_cast<unsigned>(shape.vertices.size());
    const Vector3f n = (p[1] - p[0]).cross(p[2] - p[0]).normalized();
    for (const Vector3f& q : p)
        shape.vertices.push_back({q, n, static_cast<float>(material), -q.z(), q.x(), jaw});
    for (const unsigned v : {0U, 1U, 2U, 0U, 2U, 3U}) shape.indices.push_back(base + v);
}

struct JawSection {
    float along, width, inner, outer;  // [mm]; inner and outer heights from the closing plane
};

// A jaw or blade from cross sections, on the side `jaw` of the closing plane (y).
void add_jaw(ToolModel& shape, const std::vector<JawSection>& sections, int jaw) {
    const auto side = static_cast<float>(jaw);
    const auto corner = [&](const JawSection& s, int c) {
        const float x = (c == 0 || c == 3 ? -0.5F : 0.5F) * s.width * (c > 1 ? 0.7F : 1.0F);
        return Vector3f(x, side * (c < 2 ? s.inner : s.outer), -s.along);
    };
    for (size_t i = 0; i + 1 < sections.size(); ++i) {
        for (int c = 0; c < 4; ++c) {
            const int d = (c + 1) % 4;
            std::array<Vector3f, 4> face{corner(sections[i], c), corner(sections[i], d),
                                         corner(sections[i + 1], d), corner(sections[i + 1], c)};
            if (jaw > 0) std::swap(face[1], face[3]);
            add_face(shape, face, ToolMaterial::kSteel, jaw);
        }
    }
    std::array<Vector3f, 4> cap{corner(sections[0], 0), corner(sections[0], 1),
                                corner(sections[0], 2), corner(sections[0], 3)};
    add_face(shape, cap, ToolMaterial::kSteel, jaw);
}

// Insulated shaft from `from` to the hand, with a rounded shoulder.
void add_shaft(std::vector<ProfilePoint>& profile, float from, float radius, float length,
               ToolMaterial material) {
    profile.push_back({from, 0.45F * radius, material});
    profile.push_back({from + 0.25F * radius, 0.78F * radius, material});
    profile.push_back({from + 0.6F * radius, 0.95F * radius, material});
    profile.push_back({from + radius, radius, material});
    profile.push_back({length, radius, material});
}

void add_needle(ToolModel& shape, float tip, float exposed, float radius, float length) {
    const auto steel = ToolMaterial::kSteel;
    std::vector<ProfilePoint> profile{{0.0F, 0.02F, steel},
                                      {0.05F, 0.40F * tip, steel},
                                      {0.16F, 0.68F * tip, steel},
                                      {0.36F, 0.92F * tip, steel},
                                      {0.60F, tip, steel},
                                      {exposed, tip, ToolMaterial::kCeramic},
                                      {exposed + 0.02F, tip + 0.18F, ToolMaterial::kCeramic},
                                      {exposed + 0.14F, tip + 0.30F, ToolMaterial::kCeramic},
                                      {exposed + 1.6F, tip + 0.36F, ToolMaterial::kInsulation}};
    add_shaft(profile, exposed + 1.62F, radius, length, ToolMaterial::kInsulation);
    add_revolution(shape, profile);
}

void add_hook(ToolModel& shape, float tip, float exposed, float radius, float length) {
    add_needle(shape, tip, exposed, radius, length);
    // The foot of the L, across the shaft.
    const size_t first = shape.vertices.size();
    add_revolution(shape, {{-1.6F, 0.02F, ToolMaterial::kSteel},
                           {-1.5F, 0.8F * tip, ToolMaterial::kSteel},
                           {0.0F, tip, ToolMaterial::kSteel},
                           {0.1F, 0.3F * tip, ToolMaterial::kSteel}});
    for (size_t i = first; i < shape.vertices.size(); ++i) {
        auto& v = shape.vertices[i];
        v.p = Vector3f(v.p.x(), v.p.z(), -v.p.y() - tip);
        v.n = Vector3f(v.n.x(), v.n.z(), -v.n.y());
    }
}

void add_grasper(ToolModel& shape, float jaw_mm, float radius, float length) {
    std::vector<JawSection> sections;
    // Serrations of 0.5 mm pitch.
    constexpr float kFlankMm = 0.25F;
    const int flanks = static_cast<int>(jaw_mm / kFlankMm);
    for (int i = 0; i <= flanks; ++i) {
        const float s = kFlankMm * static_cast<float>(i), t = s / jaw_mm;
        const bool tooth = i % 2 == 0;
        sections.push_back({s, 1.0F + 1.0F * t, tooth ? 0.02F : 0.12F, 0.45F + 0.75F * t});
    }
    add_jaw(shape, sections, 1);
    add_jaw(shape, sections, -1);
    shape.hinge_mm = jaw_mm;
    std::vector<ProfilePoint> profile{{jaw_mm - 0.4F, 0.02F, ToolMaterial::kSteel},
                                      {jaw_mm - 0.3F, 0.8F * radius, ToolMaterial::kSteel},
                                      {jaw_mm + 2.5F, 0.95F * radius, ToolMaterial::kSteel}};
    add_shaft(profile, jaw_mm + 2.6F, radius, length, ToolMaterial::kInsulation);
    add_revolution(shape, profile);
}

void add_scissors(ToolModel& shape, float jaw_mm, float radius, float length) {
    std::vector<JawSection> sections;
    for (int i = 0; i <= 16; ++i) {
        const float t = static_cast<float>(i) / 16;
        sections.push_back({t * jaw_mm, 0.55F, -0.05F, 0.12F + 1.3F * std::sqrt(t)});
    }
    add_jaw(shape, sections, 1);
    add_jaw(shape, sections, -1);
    shape.hinge_mm = jaw_mm;
    std::vector<ProfilePoint> profile{{jaw_mm - 0.5F, 0.02F, ToolMaterial::kSteel},
                                      {jaw_mm - 0.4F, 0.8F * radius, ToolMaterial::kSteel},
                                      {jaw_mm + 2.0F, 0.95F * radius, ToolMaterial::kSteel}};
    add_shaft(profile, jaw_mm + 2.1F, radius, length, ToolMaterial::kInsulation);
    add_revolution(shape, profile);
}

void add_probe(ToolModel& shape, float radius, float length) {
    std::vector<ProfilePoint> profile;
    for (int i = 0; i <= 6; ++i) {
        const float angle = 0.25F * kTurn * static_cast<float>(i) / 6;
        profile.push_back({radius * (1 - std::cos(angle)),
                           std::max(0.01F, radius * std::sin(angle)), ToolMaterial::kSteel});
    }
    profile.push_back({length, radius, ToolMaterial::kSteel});
    add_revolution(shape, profile);
}

/// An open tube of steel, thinner than its shaft: mouth and rim are seen.
void add_cannula(ToolModel& shape, float tip, float exposed, float radius, float length) {
    const auto steel = ToolMaterial::kSteel;
    const float bore = 0.80F * tip;
    std::vector<ProfilePoint> profile{{2.0F, 0.02F, ToolMaterial::kInsulation},
                                      {1.6F, 0.9F * bore, ToolMaterial::kInsulation},
                                      {0.05F, bore, steel},
                                      {0.0F, 0.5F * (bore + tip), steel},
                                      {0.05F, tip, steel},
                                      {exposed, tip, steel}};
    add_shaft(profile, exposed + 0.02F, radius, length, ToolMaterial::kInsulation);
    add_revolution(shape, profile);
}

}  // namespace

ToolModel tool_model(const ToolSpec& spec) {
    ToolModel shape;
    const auto mm = [](double m) { return static_cast<float>(1000 * m); };
    const float tip = std::max(mm(spec.tip_radius_m), 0.05F),
                radius = std::max(mm(spec.shaft_radius_m), tip);
    const float length = std::max(mm(spec.length_m), 20.0F);
    const float jaw = std::max(mm(spec.tip_length_m), 4.0F);
    switch (spec.kind) {
        case ToolKind::kNeedle:
            add_needle(shape, tip, std::max(mm(spec.tip_length_m), 1.0F), radius, length);
            break;
        case ToolKind::kHook:
            add_hook(shape, tip, std::max(mm(spec.tip_length_m), 1.0F), radius, length);
            break;
        case ToolKind::kGrasper:
        case ToolKind::kNeedleDriver:
            add_grasper(shape, jaw, radius, length);
            break;
        case ToolKind::kScissors:
            add_scissors(shape, jaw, radius, length);
            break;
        case ToolKind::kProbe:
            add_probe(shape, radius, length);
            break;
        case ToolKind::kIrrigator:
            add_cannula(shape, tip, std::max(mm(spec.tip_length_m), 2.0F), radius, length);
            break;
        case ToolKind::kScope:
            break;
    }
    return shape;
}

std::vector<ShadowCapsule> shadow_capsules(const ToolSpec& spec, const Pose& X_WT) {
    const auto at = [&](double along_mm) -> Vec3 {
        return 1000 * X_WT.p - along_mm * (X_WT.q * Vec3::UnitZ());
    };
    if (spec.kind == ToolKind::kScope) return {};
    const double radius = 1000 * spec.shaft_radius_m, exposed = 1000 * spec.tip_length_m;
    const bool thin = spec.kind == ToolKind::kNeedle || spec.kind == ToolKind::kHook;
    const double collar = thin ? exposed + 2.4 : exposed;
    const double tip = thin ? std::max(1000 * spec.tip_radius_m, 0.2) : 0.6 * radius;
    return {{at(tip), at(collar), 1.15 * tip},
            {at(collar + 0.4 * radius), at(1000 * spec.length_m), radius}};
}

bool is_drawn(const std::vector<ToolSpec>& tools, size_t i, const Snapshot& snapshot) {
    if (tools[i].kind == ToolKind::kScope) return false;
    // It would stand in the middle of the lesion.
    if (is_nowhere(snapshot.tools[i])) return false;
    return !shares_hand(tools, tools[i]) || snapshot.tools[i].engaged != 0;
}

ToolRenderer::ToolRenderer(const std::vector<ToolSpec>& tools) : specs_(tools) {
    specs_.resize(std::min(specs_.size(), size_t{kMaxTools}));
    for (size_t i = 0; i < specs_.size(); ++i) {
        shapes_.push_back(tool_model(specs_[i]));
        meshes_[i].create({3, 3, 4, 4, 2});
        meshes_[i].indices(shapes_[i].indices);
    }
}

void ToolRenderer::draw(const Snapshot& snapshot, GlProgram& program) {
    for (size_t i = 0; i < shapes_.size() && i < static_cast<size_t>(snapshot.tool_count); ++i) {
        const ToolSnapshot& tool = snapshot.tools[i];
        const ToolModel& shape = shapes_[i];
        if (shape.indices.empty() || !is_drawn(specs_, i, snapshot)) continue;
        const Eigen::Matrix3f turn = tool.pose.q.toRotationMatrix().cast<float>();
        const Vector3f origin = (1000 * tool.pose.p).cast<float>();
        staging_.clear();
        for (const auto& v : shape.vertices) {
            Vector3f p = v.p, n = v.n;
            if (v.jaw != 0) {
                const float angle = -static_cast<float>(v.jaw) * 0.5F * tool.jaw_rad;
                const Eigen::AngleAxisf open(angle, Vector3f::UnitX());
                const Vector3f hinge(0, 0, -shape.hinge_mm);
                p = open * (p - hinge) + hinge;
                n = open * n;
            }
            p = turn * p + origin;
            n = turn * n;
            const float row[kTissueVertexFloats] = {
                p.x(),    p.y(), p.z(), n.x(), n.y(), n.z(), v.material, v.along_mm,
                v.around, 0,     0,     0,     0,     0,     0,          0};
            staging_.insert(staging_.end(), std::begin(row), std::end(row));
        }
        meshes_[i].vertices(staging_.data(), staging_.size(), true);
        const bool coag = (tool.pedals & kPedalCoag) != 0;
        program.set("energised", tool.energised != 0 ? 1.0F : 0.0F);
        program.set("glow", coag ? Vec3(0.35, 0.45, 1.1) : Vec3(1.5, 0.75, 0.25));
        meshes_[i].draw(GL_TRIANGLES);
    }
}

}  // namespace placode::view
