// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Small pictures of a field that is made here, judged by their pixels. No physics.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "ui/view/fetoscope_view.h"

namespace placode::view {

inline constexpr int kPicturePx = 240;

inline std::vector<sim::Vec3> ellipse(double a, double b) {
    std::vector<sim::Vec3> line;
    for (int i = 0; i < 72; ++i) {
        const double t = 2 * 3.14159265358979 * i / 72;
        line.emplace_back(a * std::cos(t), b * std::sin(t), 0);
    }
    return line;
}

// A gently domed sheet with a needle above its middle, seen from a scope 30 mm away.
struct SmallField {
    ViewField view;
    sim::Snapshot snapshot;
};

inline SmallField small_field() {
    constexpr int kNx = 61, kNy = 47;  // vertices, about 0.65 mm apart
    SmallField f;
    for (int j = 0; j < kNy; ++j) {
        for (int i = 0; i < kNx; ++i) {
            const float x = 0.040F * (static_cast<float>(i) / (kNx - 1) - 0.5F);
            const float y = 0.030F * (static_cast<float>(j) / (kNy - 1) - 0.5F);
            f.view.rest.push_back({x, y, -y * y / 0.064F - x * x / 0.24F});
        }
    }
    f.view.depth_m.assign(f.view.rest.size(), 0.0F);
    for (int j = 0; j + 1 < kNy; ++j) {
        for (int i = 0; i + 1 < kNx; ++i) {
            const int a = j * kNx + i, b = a + 1, c = a + kNx, d = c + 1;
            f.view.rest_triangles.push_back({{a, b, d}, 0, sim::Tissue::kSkin, 0, {}});
            f.view.rest_triangles.push_back({{a, d, c}, 0, sim::Tissue::kSkin, 0, {}});
        }
    }
    f.view.placode_edge = ellipse(0.008, 0.003);
    f.view.skin_edge = ellipse(0.012, 0.008);
    sim::ToolSpec needle, scope;
    scope.kind = sim::ToolKind::kScope;
    f.view.tools = {needle, scope};
    f.snapshot.x = f.view.rest;
    f.snapshot.damage.assign(f.view.rest.size(), {0, 0, 0, 37});
    f.snapshot.triangles = f.view.rest_triangles;
    f.snapshot.surface_version = 1;
    f.snapshot.tool_count = 2;
    f.snapshot.tools[0].kind = sim::ToolKind::kNeedle;
    f.snapshot.tools[0].pose.p = sim::Vec3(0.004, -0.006, 0.004);
    f.snapshot.tools[0].pose.q =
        sim::Quat::FromTwoVectors(sim::Vec3::UnitZ(), sim::Vec3(0.4, 0.7, -0.7));
    f.snapshot.tools[1].kind = sim::ToolKind::kScope;
    f.snapshot.tools[1].pose.p = sim::Vec3(-0.016, 0, 0.026);
    sim::Mat3 axes;
    axes.col(2) = sim::Vec3(0.016, 0, -0.026).normalized();
    axes.col(0) = -sim::Vec3::UnitY();
    axes.col(1) = axes.col(2).cross(axes.col(0));
    f.snapshot.tools[1].pose.q = sim::Quat(axes);
    f.snapshot.contour_cut.assign(72, 0);
    return f;
}

struct Picture {
    std::vector<uint8_t> rgb;
    [[nodiscard]] double luminance(int x, int y) const {
        const uint8_t* p = &rgb[3 * static_cast<size_t>(y * kPicturePx + x)];
        return (0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2]) / 255;
    }
    [[nodiscard]] double mean(int x0, int y0, int x1, int y1) const {
        double sum = 0;
        for (int y = y0; y < y1; ++y) {
            for (int x = x0; x < x1; ++x) sum += luminance(x, y);
        }
        return sum / ((x1 - x0) * (y1 - y0));
    }
};

// One context for all tests: opening it compiles every shader.
class PictureTest : public testing::Test {
 protected:
    static void SetUpTestSuite() {
        ViewSettings settings;
        settings.width = settings.height = kPicturePx;
        settings.offscreen = true;
        settings.adaptive = false;
        try {
            view_ = new FetoscopeView(small_field().view, settings);
        } catch (const ViewError& error) {
            reason_ = error.what();
        }
    }
    static void TearDownTestSuite() {
        delete view_;
        view_ = nullptr;
    }
    void SetUp() override {
        if (view_ == nullptr) GTEST_SKIP() << "no OpenGL here: " << reason_;
    }
    static Picture draw(const sim::Snapshot& snapshot, const OverlayState& overlay = {}) {
        view_->draw(snapshot, overlay);
        EXPECT_EQ(view_->gl_error(), 0U);
        return {view_->pixels()};
    }
    static inline FetoscopeView* view_ = nullptr;
    static inline std::string reason_;
};

inline OverlayState quiet() {
    OverlayState overlay;
    overlay.exam = true;
    return overlay;
}

inline double difference(const Picture& a, const Picture& b) {
    double sum = 0;
    for (size_t i = 0; i < a.rgb.size(); ++i) sum += std::abs(int{a.rgb[i]} - int{b.rgb[i]});
    return sum / static_cast<double>(a.rgb.size());
}

}  // namespace placode::view
