// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/vessel_tree.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace placode::view {

using namespace sim;
namespace {

struct Node {
    Vec2 p = Vec2::Zero(), pull = Vec2::Zero();
    int parent = -1, pulls = 0;
    double flow = 0;
};
struct Attractor {
    Vec2 p;
    int nearest = -1;
    double distance = 1e9;
};

std::vector<Attractor> scatter(const VesselSpec& spec, std::mt19937_64& random) {
    std::vector<Attractor> points;
    for (int tries = 0; tries < 40 * spec.attractors; ++tries) {
        if (static_cast<int>(points.size()) >= spec.attractors) break;
        const Vec2 p(spec.low.x() + unit(random) * (spec.high.x() - spec.low.x()),
                     spec.low.y() + unit(random) * (spec.high.y() - spec.low.y()));
        if (spec.inside(p)) points.push_back({p});
    }
    return points;
}

// Only nodes that are new since the last round can be nearer than what is known.
void update_nearest(std::vector<Attractor>& points, const std::vector<Node>& nodes, size_t first) {
    for (Attractor& a : points) {
        for (size_t n = first; n < nodes.size(); ++n) {
            const double d = (nodes[n].p - a.p).norm();
            if (d < a.distance) {
                a.distance = d;
                a.nearest = static_cast<int>(n);
            }
        }
    }
}

std::vector<VesselSegment> segments(std::vector<Node>& nodes, const VesselSpec& spec) {
    // Leaves carry flow 1; a parent carries the sum (children come after parents).
    std::vector<uint8_t> leaf(nodes.size(), 1);
    for (const Node& n : nodes) {
        if (n.parent >= 0) leaf[static_cast<size_t>(n.parent)] = 0;
    }
    for (size_t i = nodes.size(); i-- > 0;) {
        if (leaf[i]) nodes[i].flow += 1;
        if (nodes[i].parent >= 0) nodes[static_cast<size_t>(nodes[i].parent)].flow += nodes[i].flow;
    }
    const auto radius = [&](const Node& n) {
        return spec.thinnest_mm * std::pow(n.flow, 1.0 / spec.murray);
    };
    std::vector<VesselSegment> out;
    for (const Node& n : nodes) {
        if (n.parent < 0) continue;
        const Node& parent = nodes[static_cast<size_t>(n.parent)];
        out.push_back({parent.p, n.p, std::min(radius(parent), 1.25 * radius(n)), radius(n)});
    }
    return out;
}

}  // namespace

std::vector<VesselSegment> grow_vessels(const VesselSpec& spec) {
    std::mt19937_64 random(spec.seed);
    std::vector<Attractor> points = scatter(spec, random);
    std::vector<Node> nodes;
    for (const Vec2& root : spec.roots) nodes.push_back({root, Vec2::Zero(), -1, 0, 0});
    size_t first = 0;
    for (int round = 0; round < 300 && !points.empty(); ++round) {
        update_nearest(points, nodes, first);
        first = nodes.size();
        std::erase_if(points, [&](const Attractor& a) { return a.distance < spec.kill_mm; });
        for (const Attractor& a : points) {
            if (a.nearest < 0 || a.distance > spec.reach_mm) continue;
            Node& n = nodes[static_cast<size_t>(a.nearest)];
            n.pull += (a.p - n.p).normalized();
            ++n.pulls;
        }
        for (size_t i = 0; i < first; ++i) {
            if (nodes[i].pulls == 0) continue;
            const double angle = 2 * 3.14159265358979 * unit(random);
            Vec2 direction = nodes[i].pull / nodes[i].pulls +
                             spec.wander * Vec2(std::cos(angle), std::sin(angle));
            nodes[i].pull.setZero();
            nodes[i].pulls = 0;
            if (direction.norm() < 1e-6) continue;
            const Vec2 p = nodes[i].p + spec.step_mm * direction.normalized();
            nodes.push_back({p, Vec2::Zero(), static_cast<int>(i), 0, 0});
        }
        if (nodes.size() == first || nodes.size() > 9000) break;
    }
    return segments(nodes, spec);
}

}  // namespace placode::view
