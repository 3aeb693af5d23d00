// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The picture, judged by its pixels, on a small field made here: no physics needed.

#include "ui/view/fetoscope_view.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "drawn_field.h"
#include "ui/view/smoke.h"
#include "ui/view/strings.h"
#include "ui/view/tissue_mesh.h"
#include "ui/view/vessel_tree.h"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

using namespace placode::sim;
using namespace placode::view;

namespace THIS_TEST {

constexpr int kSize = 240;
constexpr int kNx = 61, kNy = 47;  // vertices of the field, about 0.65 mm apart

std::vector<Vec3> ellipse(double a, double b) {
    std::vector<Vec3> line;
    for (int i = 0; i < 72; ++i) {
        const double t = 2 * 3.14159265358979 * i / 72;
        line.emplace_back(a * std::cos(t), b * std::sin(t), 0);
    }
    return line;
}

// A gently domed sheet with a needle above its middle, seen from a scope 30 mm away.
struct Field {
    ViewField view;
    Snapshot snapshot;
};

Field field() {
    Field f;
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
            f.view.rest_triangles.push_back({{a, b, d}, 0, Tissue::kSkin, 0, {}});
            f.view.rest_triangles.push_back({{a, d, c}, 0, Tissue::kSkin, 0, {}});
        }
    }
    f.view.placode_edge = ellipse(0.008, 0.003);
    f.view.skin_edge = ellipse(0.012, 0.008);
    ToolSpec needle, scope;
    scope.kind = ToolKind::kScope;
    f.view.tools = {needle, scope};
    f.snapshot.x = f.view.rest;
    f.snapshot.damage.assign(f.view.rest.size(), {0, 0, 0, 37});
    f.snapshot.triangles = f.view.rest_triangles;
    f.snapshot.surface_version = 1;
    f.snapshot.tool_count = 2;
    f.snapshot.tools[0].kind = ToolKind::kNeedle;
    f.snapshot.tools[0].pose.p = Vec3(0.004, -0.006, 0.004);
    f.snapshot.tools[0].pose.q = Quat::FromTwoVectors(Vec3::UnitZ(), Vec3(0.4, 0.7, -0.7));
    f.snapshot.tools[1].kind = ToolKind::kScope;
    f.snapshot.tools[1].pose.p = Vec3(-0.016, 0, 0.026);
    Mat3 axes;
    axes.col(2) = Vec3(0.016, 0, -0.026).normalized();
    axes.col(0) = -Vec3::UnitY();
    axes.col(1) = axes.col(2).cross(axes.col(0));
    f.snapshot.tools[1].pose.q = Quat(axes);
    f.snapshot.contour_cut.assign(72, 0);
    return f;
}

struct Picture {
    std::vector<uint8_t> rgb;
    [[nodiscard]] double luminance(int x, int y) const {
        const uint8_t* p = &rgb[3 * static_cast<size_t>(y * kSize + x)];
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
class FetoscopeViewTest : public testing::Test {
 protected:
    static void SetUpTestSuite() {
        ViewSettings settings;
        settings.width = settings.height = kSize;
        settings.offscreen = true;
        settings.adaptive = false;
        try {
            view_ = new FetoscopeView(field().view, settings);
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
    static Picture draw(const Snapshot& snapshot, const OverlayState& overlay = {}) {
        view_->draw(snapshot, overlay);
        EXPECT_EQ(view_->gl_error(), 0U);
        return {view_->pixels()};
    }
    static FetoscopeView* view_;
    static std::string reason_;
};
FetoscopeView* FetoscopeViewTest::view_ = nullptr;
std::string FetoscopeViewTest::reason_;

OverlayState quiet() {
    OverlayState overlay;
    overlay.exam = true;
    return overlay;
}

double difference(const Picture& a, const Picture& b) {
    double sum = 0;
    for (size_t i = 0; i < a.rgb.size(); ++i) sum += std::abs(int{a.rgb[i]} - int{b.rgb[i]});
    return sum / static_cast<double>(a.rgb.size());
}

TEST_F(FetoscopeViewTest, ShowsALitRoundPictureOnNearBlack) {
    const Picture p = draw(field().snapshot, quiet());
    // Corners: the surround is sRGB 14..16 of 255.
    EXPECT_LT(p.mean(kSize - 20, 0, kSize, 20), 0.09);
    EXPECT_LT(p.mean(kSize - 20, kSize - 20, kSize, kSize), 0.09);
    // The middle is exposed like an operation: neither dark nor burnt out.
    const double middle = p.mean(kSize / 2 - 40, kSize / 2 - 40, kSize / 2 + 40, kSize / 2 + 40);
    EXPECT_GT(middle, 0.20);
    EXPECT_LT(middle, 0.85);
    // Tissue is red before it is green or blue.
    double red = 0, blue = 0;
    for (int i = kSize / 3; i < 2 * kSize / 3; ++i) {
        red += p.rgb[3 * static_cast<size_t>(kSize / 2 * kSize + i)];
        blue += p.rgb[3 * static_cast<size_t>(kSize / 2 * kSize + i) + 2];
    }
    EXPECT_GT(red, 1.15 * blue);
}

TEST_F(FetoscopeViewTest, HasDetailAndNoBrokenPixels) {
    // A value that is not a number would be black or white in a block: every 30 px cell inside the
    // circle must vary, and none may be uniformly black.
    const Picture p = draw(field().snapshot, quiet());
    for (int y = 60; y < 180; y += 30) {
        for (int x = 60; x < 180; x += 30) {
            double low = 1, high = 0;
            for (int j = 0; j < 30; ++j) {
                for (int i = 0; i < 30; ++i) {
                    low = std::min(low, p.luminance(x + i, y + j));
                    high = std::max(high, p.luminance(x + i, y + j));
                }
            }
            EXPECT_GT(high - low, 0.03) << x << " " << y;
            EXPECT_GT(high, 0.05) << x << " " << y;
        }
    }
}

TEST_F(FetoscopeViewTest, CharIsDarkAndBlanchingPale) {
    Field f = field();
    f.snapshot.tool_count = 1;  // default camera; the needle stays away
    f.snapshot.tools[0].pose.p = Vec3(0, 0.05, 0.05);
    const Picture before = draw(f.snapshot, quiet());
    const auto burn = [&](std::array<float, 4> damage) {
        for (size_t i = 0; i < f.view.rest.size(); ++i) {
            const auto& r = f.view.rest[i];
            if (std::hypot(r[0], r[1]) < 0.004F) f.snapshot.damage[i] = damage;
        }
        return draw(f.snapshot, quiet());
    };
    const int a = kSize / 2 - 8, b = kSize / 2 + 8;
    const Picture pale = burn({1, 0, 0, 70});
    EXPECT_GT(pale.mean(a, a, b, b), before.mean(a, a, b, b) + 0.05);
    const Picture charred = burn({1, 1, 1, 220});
    EXPECT_LT(charred.mean(a, a, b, b), 0.6 * before.mean(a, a, b, b));
}

TEST_F(FetoscopeViewTest, FollowsTheTissueAndTheInstrument) {
    Field f = field();
    const Picture before = draw(f.snapshot, quiet());
    for (auto& x : f.snapshot.x) {
        x[2] += 0.003F * std::exp(-(x[0] * x[0] + x[1] * x[1]) / 2e-5F);
    }
    EXPECT_GT(difference(before, draw(f.snapshot, quiet())), 1.0);
    f = field();
    f.snapshot.tools[0].pose.p += Vec3(0.003, 0.003, 0);
    EXPECT_GT(difference(before, draw(f.snapshot, quiet())), 0.5);
}

/// Pixels that differ by more than noise.
int differing_pixels(const Picture& a, const Picture& b) {
    int count = 0;
    for (size_t i = 0; i + 2 < a.rgb.size(); i += 3) {
        int most = 0;
        for (size_t k = 0; k < 3; ++k)
            most = std::max(most, std::abs(int{a.rgb[i + k]} - int{b.rgb[i + k]}));
        count += most > 12 ? 1 : 0;
    }
    return count;
}

TEST_F(FetoscopeViewTest, ShowsASutureNeedleAndItsThread) {
    Field f = field();
    f.snapshot.time_s = 3;
    const Picture without = draw(f.snapshot, quiet());
    f.snapshot.needle.present = 1;
    f.snapshot.needle.arc_m = 0.017F;
    f.snapshot.needle.wire_radius_m = 0.0002F;
    f.snapshot.needle.pose.p = Vec3(0, 0.002, 0.004);
    const Picture with = draw(f.snapshot, quiet());
    const int needle = differing_pixels(without, with);
    EXPECT_GT(needle, 60);
    EXPECT_LT(needle, 2500) << "a wire, not a plate";
    f.snapshot.needle.thread = {{-0.0054F, 0.002F, 0.004F}, {-0.006F, 0.006F, 0.001F}};
    EXPECT_GT(differing_pixels(with, draw(f.snapshot, quiet())), 20);
    // Below the tissue nothing is seen of it.
    f.snapshot.needle.thread.clear();
    f.snapshot.needle.pose.p = Vec3(0, 0, -0.004);
    EXPECT_LT(differing_pixels(without, draw(f.snapshot, quiet())), 5);
}

TEST_F(FetoscopeViewTest, ShowsSmokeOfVaporisedTissue) {
    Field f = field();
    f.snapshot.tools[0].energised = 1;
    f.snapshot.time_s = 10;
    const Picture clear = draw(f.snapshot, quiet());
    f.snapshot.vapour_rate_m3_s = 20e-9F;
    for (int i = 0; i < 6; ++i) {
        f.snapshot.time_s += 0.25;
        view_->draw(f.snapshot, quiet());
    }
    EXPECT_GT(difference(clear, draw(f.snapshot, quiet())), 3.0);
}

TEST(Smoke, GathersWithTheVaporisedVolumeAndClears) {
    Smoke smoke;
    Snapshot snapshot = field().snapshot;
    snapshot.tools[0].energised = 1;
    snapshot.vapour_rate_m3_s = 2e-9F;
    for (int i = 0; i < 300; ++i) {
        snapshot.time_s += 0.033;
        smoke.update(snapshot);
    }
    // 10 s at 12 W or so: some tens of puffs, a haze that is seen but does not blind.
    EXPECT_GT(smoke.puffs().size(), 30U);
    EXPECT_LT(smoke.puffs().size(), 161U);
    EXPECT_GT(smoke.haze(), 0.10);
    EXPECT_LT(smoke.haze(), 0.40);
    snapshot.vapour_rate_m3_s = 0;
    for (int i = 0; i < 600; ++i) {
        snapshot.time_s += 0.2;
        smoke.update(snapshot);
    }
    EXPECT_TRUE(smoke.puffs().empty());
    EXPECT_LT(smoke.haze(), 0.01);
}

TEST_F(FetoscopeViewTest, WritesTheReadOutsOutsideTheCircle) {
    Field f = field();
    f.snapshot.time_s = 187;
    OverlayState overlay;
    overlay.title = "Ring";
    const Picture exam = draw(f.snapshot, quiet());
    const Picture full = draw(f.snapshot, overlay);
    // Time stands top left in both; energy and ring only outside an exam.
    EXPECT_GT(exam.mean(5, 5, 50, 40), 0.10);
    EXPECT_GT(full.mean(kSize - 70, kSize - 70, kSize, kSize),
              exam.mean(kSize - 70, kSize - 70, kSize, kSize) + 0.005);
    overlay.menu.shown = true;
    overlay.menu.items = {"Continue", "Finish"};
    EXPECT_GT(difference(full, draw(f.snapshot, overlay)), 5.0);
}

TEST_F(FetoscopeViewTest, AnExamIsToldThatTheComputerIsTooSlow) {
    const Field f = field();
    OverlayState overlay = quiet();
    const Picture before = draw(f.snapshot, overlay);
    overlay.banner = "COMPUTER TOO SLOW, does not count";
    const Picture banner = draw(f.snapshot, overlay);
    overlay.banner.clear();
    overlay.notice = "This computer is slow: the picture was made simpler";
    const Picture notice = draw(f.snapshot, overlay);
    const auto foot = [](const Picture& picture) {
        return picture.mean(60, kSize - 40, kSize - 60, kSize);
    };
    EXPECT_GT(std::abs(foot(banner) - foot(before)), 0.01);
    EXPECT_GT(std::abs(foot(notice) - foot(before)), 0.01);
    EXPECT_NE(translated("COMPUTER TOO SLOW, does not count", "pl"),
              "COMPUTER TOO SLOW, does not count");
}

// Where a point of W [mm] stands in the picture of the default camera [px].
Vec2 place_of(const Vec3& mm) {
    const Camera camera = look_at(Vec3(-15.4, 0, 25.7), Vec3(0, 0, 0), 70);
    const Eigen::Vector4f clip =
        camera.view_projection() * Eigen::Vector4f(static_cast<float>(mm.x()),
                                                   static_cast<float>(mm.y()),
                                                   static_cast<float>(mm.z()), 1.0F);
    const Vec2 seen(static_cast<double>(clip.x() / clip.w()),
                    static_cast<double>(clip.y() / clip.w()));
    double r = seen.norm();  // the lens of compose.glsl, the other way round
    for (int i = 0; i < 40; ++i)
        r += 0.3 * (1.23 * seen.norm() - r * (1 + 0.20 * r * r + 0.03 * r * r * r * r));
    const Circle circle = picture_circle(kSize, kSize);
    const Vec2 p = r / seen.norm() * seen;
    return {circle.x + circle.radius * p.x(), circle.y - circle.radius * p.y()};
}

// How much light the tissue right below a needle's tip loses, `height_m` above the skin: 0..1.
double shadow_below(FetoscopeView& view, double height_m) {
    Field f = field();
    const Vec3 foot(0, -0.0105, -0.0105 * 0.0105 / 0.064);
    f.snapshot.tool_count = 1;  // the default camera
    f.snapshot.tools[0].engaged = 1;
    f.snapshot.tools[0].pose.p = foot + Vec3(0, 0, height_m);
    // From the upper right, so that it does not hide its foot.
    f.snapshot.tools[0].pose.q = Quat::FromTwoVectors(Vec3::UnitZ(), Vec3(-0.5, 0.6, -0.6));
    OverlayState overlay = quiet();
    const Vec2 at = place_of(1000 * foot);
    const int x = static_cast<int>(at.x()), y = static_cast<int>(at.y());
    // Nothing in between: smoke and fog of other tests go first.
    for (int i = 0; i < 800; ++i) {
        f.snapshot.time_s = 0.25 * i;
        view.observe(f.snapshot);
    }
    view.wipe_lens();
    f.snapshot.time_s += 2;
    view.observe(f.snapshot);
    Picture pictures[2];
    for (const bool aid : {false, true}) {
        overlay.depth_aid = aid;
        for (int i = 0; i < 3; ++i) view.draw(f.snapshot, overlay);
        EXPECT_EQ(view.gl_error(), 0U);
        pictures[aid ? 1 : 0].rgb = view.pixels();
    }
    // The darkest spot around the foot, large enough for the film's grain not to matter.
    double most = 0;
    for (int j = y - 9; j < y + 5; ++j) {
        for (int i = x - 9; i < x + 5; ++i) {
            const double before = pictures[0].mean(i, j, i + 6, j + 6);
            most = std::max(most, 1 - pictures[1].mean(i, j, i + 6, j + 6) / before);
        }
    }
    return most;
}

TEST_F(FetoscopeViewTest, DarkensTheTissueBelowATipTheMoreTheNearerItIs) {
    const double near = shadow_below(*view_, 0.002), middle = shadow_below(*view_, 0.005),
                 high = shadow_below(*view_, 0.011);
    EXPECT_GT(near, middle + 0.05) << near << " " << middle << " " << high;
    EXPECT_GT(middle, 0.10) << "still seen four millimetres above";
    EXPECT_GT(middle, high + 0.05);
}

// Changes of more than the film's grain, in a box of the window.
int changed_pixels(const Picture& a, const Picture& b) {
    int count = 0;
    for (size_t i = 0; i + 2 < a.rgb.size(); i += 3) {
        int change = 0;
        for (size_t k = 0; k < 3; ++k)
            change = std::max(change, std::abs(int{a.rgb[i + k]} - int{b.rgb[i + k]}));
        count += change > 40 ? 1 : 0;
    }
    return count;
}

TEST_F(FetoscopeViewTest, TheGaugeStandsBesideATipThatIsNearWhereAidsAreAllowed) {
    Field f = field();
    f.snapshot.tools[0].engaged = 1;
    f.snapshot.tools[0].pose.p = Vec3(0, 0, 0.002);
    f.snapshot.tools[0].tip_gap_m = 0.001F;
    OverlayState overlay;
    const Picture near = draw(f.snapshot, overlay);
    f.snapshot.tools[0].tip_gap_m = 0.004F;
    EXPECT_GT(changed_pixels(near, draw(f.snapshot, overlay)), 10) << "it says how far";
    overlay.depth_aid = false;
    const Picture off = draw(f.snapshot, overlay);
    EXPECT_GT(changed_pixels(near, off), 60);
    f.snapshot.tools[0].tip_gap_m = 0.001F;
    EXPECT_EQ(changed_pixels(off, draw(f.snapshot, overlay)), 0) << "nothing depends on it";
}

TEST_F(FetoscopeViewTest, ShowsWhatOfANeedleLiesBelowTheSurface) {
    Field f = field();
    f.snapshot.tools[0].engaged = 1;
    f.snapshot.tools[0].pose.p = Vec3(0, 0, -0.003);
    f.snapshot.tools[0].pose.q = Quat::FromTwoVectors(Vec3::UnitZ(), Vec3(0.2, 0.3, -0.9));
    OverlayState overlay;
    const Picture stump = draw(f.snapshot, overlay);
    f.snapshot.tools[0].buried_m = 0.003F;
    f.snapshot.tools[0].buried_length_m = 0.0033F;
    const Picture shown = draw(f.snapshot, overlay);
    EXPECT_GT(difference(stump, shown), 0.3);
    // In the colour of a warning, which no tissue has.
    const auto warning = [](const Picture& p) {
        int count = 0;
        for (size_t i = 0; i + 2 < p.rgb.size(); i += 3)
            count +=
                p.rgb[i] > 180 && p.rgb[i + 1] > 120 && p.rgb[i + 1] < 190 && p.rgb[i + 2] < 110
                    ? 1
                    : 0;
        return count;
    };
    EXPECT_GT(warning(shown), warning(stump) + 40);
}

OverlayState practising(PracticeKind kind, placode::haptics::HintDevice device) {
    OverlayState overlay;
    overlay.practice.steps = {{"Step", "Press the key", false}};
    overlay.practice.device = device;
    overlay.practice.goal.count = 1;
    overlay.practice.goal.step.kind = kind;
    return overlay;
}

TEST_F(FetoscopeViewTest, WhoIsStuckIsShownTheVeryKey) {
    Field f = field();
    f.snapshot.tools[0].engaged = 1;
    OverlayState overlay = practising(PracticeKind::kCut, placode::haptics::HintDevice::kMouse);
    const auto after = [&](double seconds) {  // offscreen the watcher's clock is the simulation's
        f.snapshot.time_s = seconds;
        return draw(f.snapshot, overlay);
    };
    static_cast<void>(after(100));
    // The accent's pixels: no tissue has that colour.
    const auto lit = [](const Picture& p) {
        int count = 0;
        for (size_t i = 0; i + 2 < p.rgb.size(); i += 3)
            count += p.rgb[i + 1] > p.rgb[i] + 30 && p.rgb[i + 2] > p.rgb[i] + 30 ? 1 : 0;
        return count;
    };
    const int before = lit(after(104));
    static_cast<void>(after(107));
    // The left button is pressed from 109.8 to 111.6 s: one symbol takes 1.8 s.
    const int released = lit(after(109.8)), pressed = lit(after(110.6));
    EXPECT_GT(released, before + 30);
    EXPECT_GT(pressed, released + 30) << "it moves";
    overlay.motion = false;
    const int still = lit(after(110.7));
    EXPECT_NEAR(lit(after(111.6)), still, 5) << "unless somebody wants stillness";
    overlay.tuning.shown = true;
    EXPECT_LT(lit(after(111.65)), still - 100) << "not over the tuning panel";
    overlay.tuning.shown = false;
    overlay.practice.goal.progress = 0.5;
    EXPECT_LT(lit(after(111.7)), still - 100) << "gone with the first progress";
}

TEST_F(FetoscopeViewTest, AnExamShowsWhatIsToBeTouchedAndNoMore) {
    Field f = field();
    f.snapshot.tools[0].engaged = 1;
    for (const PracticeKind step : {PracticeKind::kTouch, PracticeKind::kGrasp}) {
        OverlayState exam = practising(step, placode::haptics::HintDevice::kMouse);
        exam.exam = true;
        const Picture without = draw(f.snapshot, exam);
        exam.practice.goal.targets = 1;
        const Picture with = draw(f.snapshot, exam);
        exam.exam = false;
        const Picture practice = draw(f.snapshot, exam);
        EXPECT_GT(difference(without, with), 0.01) << "the place itself is no aid";
        EXPECT_GT(difference(with, practice), difference(without, with))
            << "distance and words are";
    }
}

TEST_F(FetoscopeViewTest, EveryKindOfStepHasAGoalInThePicture) {
    Field f = field();
    for (int kind = 0; kind < kPracticeKinds; ++kind) {
        const auto step = static_cast<PracticeKind>(kind);
        if (step == PracticeKind::kTrace) continue;  // it has the line
        f.snapshot.tools[0].engaged = 1;
        f.snapshot.time_s = 1000 + 10 * kind;
        OverlayState overlay = practising(step, placode::haptics::HintDevice::kMouse);
        overlay.practice.goal.targets = targets_of(step);
        OverlayState done = overlay;
        done.practice.goal.index = 1;
        const Picture nothing = draw(f.snapshot, done);
        EXPECT_GT(difference(nothing, draw(f.snapshot, overlay)), 0.3) << kind;
    }
}

// A window wide enough for the text at its sides, and a second instrument.
class OverlayRimTest : public FetoscopeViewTest {
 protected:
    static constexpr int kWide = 1024, kHigh = 640;
    void SetUp() override {
        FetoscopeViewTest::SetUp();
        if (IsSkipped()) return;
        field_ = field();
        ToolSpec grasper;
        grasper.kind = ToolKind::kGrasper;
        grasper.hand = Hand::kLeft;
        field_.view.tools.push_back(grasper);
        field_.snapshot.tool_count = 3;
        field_.snapshot.tools[2] = field_.snapshot.tools[0];
        field_.snapshot.tools[2].kind = ToolKind::kGrasper;
        field_.snapshot.tools[0].engaged = field_.snapshot.tools[2].engaged = 1;
        ViewSettings settings;
        settings.width = kWide, settings.height = kHigh;
        settings.offscreen = true, settings.adaptive = false;
        wide_ = std::make_unique<FetoscopeView>(field_.view, settings);
    }
    std::vector<uint8_t> draw(const OverlayState& overlay) {
        wide_->draw(field_.snapshot, overlay);
        return wide_->pixels();
    }
    /// Pixels that differ, of the window's left column.
    static std::vector<bool> changed(const std::vector<uint8_t>& a, const std::vector<uint8_t>& b) {
        std::vector<bool> out;
        for (size_t i = 0; i + 2 < a.size(); i += 3) {
            int most = 0;
            for (size_t k = 0; k < 3; ++k)
                most = std::max(most, std::abs(int{a[i + k]} - b[i + k]));
            const bool left = (i / 3) % kWide < kWide / 5;
            out.push_back(left && most > 30);
        }
        return out;
    }
    static auto count(const std::vector<bool>& marks) {
        return std::count(marks.begin(), marks.end(), true);
    }
    Field field_;
    std::unique_ptr<FetoscopeView> wide_;
};

TEST_F(OverlayRimTest, ASingleHandHasOneBarOfForce) {
    OverlayState overlay;
    overlay.practice.device = placode::haptics::HintDevice::kArm;
    const auto both = draw(overlay);
    overlay.practice.device = placode::haptics::HintDevice::kMouse;
    const auto one = draw(overlay);
    const auto gone = count(changed(both, one));
    EXPECT_GT(gone, 200) << "the instrument that is put aside has no bar";
    field_.snapshot.tools[0].in_contact = field_.snapshot.tools[2].in_contact = 1;
    EXPECT_LT(count(changed(both, draw(overlay))), 20) << "unless it touches";
    overlay.practice.device = placode::haptics::HintDevice::kArm;
    field_.snapshot.tools[2].engaged = 0;
    EXPECT_GT(count(changed(both, draw(overlay))), 200) << "a hand that is not there has none";
}

// Pushed through the surface it meets no force: "0 mN" looked like success.
TEST_F(OverlayRimTest, ANeedleBelowTheSurfaceIsSaidToBeStuckInsteadOfFree) {
    OverlayState overlay;
    const auto free = draw(overlay);
    field_.snapshot.tools[0].buried_m = 0.003F;
    field_.snapshot.tools[0].buried_length_m = 0.0033F;
    const auto stuck = draw(overlay);
    EXPECT_GT(count(changed(free, stuck)), 30) << "in the line of the force";
    EXPECT_NE(translated("stuck", "pl"), "stuck");
}

TEST_F(OverlayRimTest, TheBarIsOfTheInstrumentInHandAndTabLeadsBack) {
    OverlayState overlay;
    overlay.practice.device = placode::haptics::HintDevice::kMouse;
    overlay.practice.steps = {{"Lift the needle away", "Wheel towards you.", false}};
    overlay.practice.goal.count = 1;
    overlay.practice.goal.step.kind = PracticeKind::kWithdraw;
    overlay.practice.goal.step.hand = Hand::kRight;
    overlay.practice.in_hand = 0;
    const auto right = draw(overlay);
    overlay.practice.in_hand = 2;
    const auto wrong = draw(overlay);
    EXPECT_GT(count(changed(right, wrong)), 100) << "another name at the bar, another hint";
    EXPECT_EQ(translated("Tab: back to the %1", "pl"), "Tab: z powrotem %1");
    overlay.practice.steps[0].hint = "Draw it back.";
    EXPECT_EQ(count(changed(wrong, draw(overlay))), 0) << "the step's own hint would not help";
}

TEST_F(OverlayRimTest, ThePerformanceIsNotWrittenOverTheTask) {
    OverlayState overlay;
    const auto bare = draw(overlay);
    overlay.title = "Diathermy ring, coarse field";
    for (int i = 0; i < 12; ++i) overlay.goal += "Make a complete circumferential incision. ";
    const auto task = draw(overlay);
    const auto text = changed(bare, task);
    ASSERT_GT(count(text), 2000);
    overlay.show_performance = true;
    const auto with = draw(overlay);
    const auto written = changed(task, with);
    size_t over = 0;
    for (size_t i = 0; i < text.size(); ++i) over += text[i] && written[i] ? 1 : 0;
    EXPECT_EQ(over, 0U);
    overlay.goal.clear();
    const auto without_goal = draw(overlay);
    overlay.show_performance = false;
    EXPECT_GT(count(changed(draw(overlay), without_goal)), 500) << "below the text where it fits";
}

TEST_F(FetoscopeViewTest, WritesAPngThatReadsBackTheSame) {
    const Picture p = draw(field().snapshot, quiet());
    const auto path = std::filesystem::temp_directory_path() /
                      ("placode_view_" + std::to_string(::getpid()) + ".png");
    view_->save_png(path.string());
    int w = 0, h = 0, n = 0;
    stbi_uc* data = stbi_load(path.c_str(), &w, &h, &n, 3);
    ASSERT_NE(data, nullptr);
    EXPECT_EQ(w, kSize);
    EXPECT_EQ(h, kSize);
    EXPECT_TRUE(std::equal(p.rgb.begin(), p.rgb.end(), data));
    stbi_image_free(data);
    std::filesystem::remove(path);
    EXPECT_THROW(view_->save_png("/nowhere/at/all.png"), ViewError);
}

TEST(Camera, TakesTheScopeWithCranialUpAndADefaultBeforeAnybodyHoldsIt) {
    Field f = field();
    const Camera held = camera_of(f.snapshot, f.view.tools);
    EXPECT_LT((held.position_mm - 1000 * f.snapshot.tools[1].pose.p).norm(), 1e-9);
    EXPECT_GT(held.up.x(), 0.5);      // cranial up
    EXPECT_LT(held.right.y(), -0.9);  // the patient's right on the right
    f.view.tools[1].scope_angle_deg = 30;
    const Camera oblique = camera_of(f.snapshot, f.view.tools);
    EXPECT_NEAR(oblique.forward.dot(held.forward), std::cos(3.14159265 / 6), 1e-6);
    EXPECT_LT(oblique.forward.dot(held.up), -0.49);  // looks down past its axis
    f.snapshot.tools[1].pose = Pose{};
    EXPECT_GT(camera_of(f.snapshot, f.view.tools).position_mm.z(), 10);
}

TEST(TissueMesh, GivesFreshWallsTheirOwnVertices) {
    Field f = field();
    TissueMesh mesh(f.view);
    EXPECT_TRUE(mesh.update(f.snapshot));
    const size_t before = mesh.vertices().size();
    EXPECT_FALSE(mesh.update(f.snapshot));
    f.snapshot.triangles[100].fresh = 1;
    f.snapshot.surface_version = 2;
    EXPECT_TRUE(mesh.update(f.snapshot));
    EXPECT_EQ(mesh.vertices().size(), before + 3 * kTissueVertexFloats);
    // Its normals still point outwards.
    for (size_t c = 0; c < mesh.vertices().size(); c += kTissueVertexFloats) {
        EXPECT_GT(mesh.vertices()[c + 5], 0.5F);
    }
}

TEST(VesselTree, GrowsInsideItsBordersAndThinsOutwards) {
    VesselSpec spec;
    spec.roots = {Vec2(0, 0)};
    spec.inside = [](const Vec2& p) { return p.norm() < 5; };
    spec.low = Vec2(-5, -5);
    spec.high = Vec2(5, 5);
    const std::vector<VesselSegment> tree = grow_vessels(spec);
    ASSERT_GT(tree.size(), 50U);
    for (const VesselSegment& s : tree) {
        EXPECT_LT(s.b.norm(), 5 + 2 * spec.step_mm);
        EXPECT_GE(s.radius_a, s.radius_b - 1e-12);
    }
    EXPECT_GT(tree.front().radius_a, 3 * tree.back().radius_b);
}

TEST(Strings, SpeakPolishAndFallBackToEnglish) {
    EXPECT_EQ(translated("Paused", "pl"), "Pauza");
    EXPECT_EQ(translated("Paused", "en"), "Paused");
    EXPECT_EQ(translated("not in the table", "pl"), "not in the table");
    size_t at = 0;
    EXPECT_EQ(next_code_point("\xC5\x82", at), 0x142U);  // ł
    EXPECT_EQ(at, 2U);
    at = 0;
    EXPECT_EQ(next_code_point("\xC5", at), 0xFFFDU);
}

// One context after the other: suites of their own.
std::unique_ptr<FetoscopeView> view_of(const ViewField& field, const Quality& quality) {
    ViewSettings settings;
    settings.width = settings.height = kSize;
    settings.offscreen = true;
    settings.adaptive = false;
    settings.quality = quality;
    try {
        return std::make_unique<FetoscopeView>(field, settings);
    } catch (const ViewError&) {
        return nullptr;
    }
}

Picture settled(FetoscopeView& view, const Snapshot& snapshot) {
    for (int i = 0; i < 3; ++i) view.draw(snapshot, quiet());  // the iris settles
    EXPECT_EQ(view.gl_error(), 0U);
    return {view.pixels()};
}

TEST(Wound, AFlapThrowsAShadowWhereShadowsAreDrawn) {
    // A strip of skin stands up, across the light; nothing else differs.
    DrawnField field;
    for (size_t i = 0; i < field.view.rest.size(); ++i) {
        const auto& r = field.view.rest[i];
        if (std::abs(r[0]) < 0.0004F && std::abs(r[1]) < 0.006F) field.snapshot.x[i][2] += 0.006F;
    }
    Picture pictures[2];
    for (const bool shadows : {false, true}) {
        const auto view = view_of(field.view, {1.0, 0, false, shadows});
        if (view == nullptr) GTEST_SKIP() << "no OpenGL here";
        pictures[shadows ? 1 : 0] = settled(*view, field.snapshot);
    }
    int darker = 0, brighter = 0;
    for (int y = 40; y < kSize - 40; ++y) {
        for (int x = 40; x < kSize - 40; ++x) {
            const double change = pictures[1].luminance(x, y) - pictures[0].luminance(x, y);
            darker += change < -0.08 ? 1 : 0;
            brighter += change > 0.15 ? 1 : 0;
        }
    }
    EXPECT_GT(darker, 20);
    EXPECT_LT(darker, kSize * kSize / 10) << "tissue does not darken itself";
    EXPECT_LT(brighter, 40);
}

TEST(PlainPicture, ShowsTheSameInTheSamePlaces) {
    Picture pictures[2];
    for (const bool plain : {false, true}) {
        ViewSettings settings;
        settings.width = settings.height = kSize;
        settings.offscreen = true;
        settings.adaptive = false;
        std::unique_ptr<FetoscopeView> view;
        try {
            view = std::make_unique<FetoscopeView>(field().view, settings);
        } catch (const ViewError& error) {
            GTEST_SKIP() << "no OpenGL here: " << error.what();
        }
        while (plain && view->simplify()) {
        }
        for (int i = 0; i < 3; ++i) view->draw(field().snapshot, quiet());  // the iris settles
        EXPECT_EQ(view->gl_error(), 0U);
        if (plain) {
            EXPECT_FALSE(view->simplify()) << "drawing made it less plain";
        }
        pictures[plain ? 1 : 0].rgb = view->pixels();
    }
    EXPECT_GT(difference(pictures[0], pictures[1]), 0.5) << "nothing was left out";
    // Cells of 15 px, corners and rim too: a picture in another place, or mirrored, is 0.3 apart.
    double worst = 0;
    for (int y = 0; y < kSize; y += 15) {
        for (int x = 0; x < kSize; x += 15)
            worst = std::max(worst, std::abs(pictures[0].mean(x, y, x + 15, y + 15) -
                                             pictures[1].mean(x, y, x + 15, y + 15)));
    }
    EXPECT_LT(worst, 0.08);
}

}  // namespace THIS_TEST
