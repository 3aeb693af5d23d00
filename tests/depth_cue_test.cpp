// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What shows depth to one eye: the shadow below a tip, the gauge beside it, and what of a needle
// lies below the surface.

#include "ui/view/depth_cue.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "picture_fixture.h"

using namespace placode::sim;
using namespace placode::view;

namespace THIS_TEST {

class DepthCueTest : public PictureTest {};

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
    const Circle circle = picture_circle(kPicturePx, kPicturePx);
    const Vec2 p = r / seen.norm() * seen;
    return {circle.x + circle.radius * p.x(), circle.y - circle.radius * p.y()};
}

// The same picture without and with aids to depth.
std::array<Picture, 2> without_and_with_aid(FetoscopeView& view, SmallField& f) {
    OverlayState overlay = quiet();
    // Nothing in between: smoke and fog of other tests go first.
    for (int i = 0; i < 800; ++i) {
        f.snapshot.time_s = 0.25 * i;
        view.observe(f.snapshot);
    }
    view.wipe_lens();
    f.snapshot.time_s += 2;
    view.observe(f.snapshot);
    std::array<Picture, 2> pictures;
    for (const bool aid : {false, true}) {
        overlay.depth_aid = aid;
        for (int i = 0; i < 3; ++i) view.draw(f.snapshot, overlay);
        EXPECT_EQ(view.gl_error(), 0U);
        pictures[aid ? 1 : 0].rgb = view.pixels();
    }
    return pictures;
}

// How much light the tissue right below a needle's tip loses, `height_m` above the skin: 0..1.
double shadow_below(FetoscopeView& view, double height_m) {
    SmallField f = small_field();
    const Vec3 foot(0, -0.0105, -0.0105 * 0.0105 / 0.064);
    f.snapshot.tool_count = 1;  // the default camera
    f.snapshot.tools[0].engaged = 1;
    f.snapshot.tools[0].pose.p = foot + Vec3(0, 0, height_m);
    // From the upper right, so that it does not hide its foot.
    f.snapshot.tools[0].pose.q = Quat::FromTwoVectors(Vec3::UnitZ(), Vec3(-0.5, 0.6, -0.6));
    const Vec2 at = place_of(1000 * foot);
    const int x = static_cast<int>(at.x()), y = static_cast<int>(at.y());
    const auto pictures = without_and_with_aid(view, f);
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

TEST_F(DepthCueTest, DarkensTheTissueBelowATipTheMoreTheNearerItIs) {
    const double near = shadow_below(*view_, 0.002), middle = shadow_below(*view_, 0.005),
                 high = shadow_below(*view_, 0.011);
    EXPECT_GT(near, middle + 0.05) << near << " " << middle << " " << high;
    EXPECT_GT(middle, 0.10) << "still seen four millimetres above";
    EXPECT_GT(middle, high + 0.05);
}

// A shaft that lies reaches out of the part of its shadow that is drawn: it has to end softly, and
// not where triangles do.
TEST_F(DepthCueTest, TheShadowOfAShaftThatLiesHasNoEdge) {
    SmallField f = small_field();
    f.snapshot.tool_count = 1;
    f.snapshot.tools[0].engaged = 1;
    f.snapshot.tools[0].pose.p = Vec3(0, 0.012, 0.005);
    f.snapshot.tools[0].pose.q = Quat::FromTwoVectors(Vec3::UnitZ(), Vec3(0.05, 1, -0.08));
    const auto pictures = without_and_with_aid(*view_, f);
    constexpr int kBlock = 4;
    // What is nearly black, like the shaft itself, shows noise only.
    const auto light = [&](int x, int y) {
        const double before = pictures[0].mean(x, y, x + kBlock, y + kBlock);
        return before > 0.12 ? pictures[1].mean(x, y, x + kBlock, y + kBlock) / before : 1.0;
    };
    // Around where the drawn part ends, far from the tip and its labels.
    const Vec2 end = place_of(Vec3(0, 2, 0));
    constexpr int kAround = 28;
    double darkest = 1, steepest = 0;
    for (int y = static_cast<int>(end.y()) - kAround; y < end.y() + kAround; ++y) {
        for (int x = static_cast<int>(end.x()) - kAround; x < end.x() + kAround; ++x) {
            darkest = std::min(darkest, light(x, y));
            steepest = std::max({steepest, std::abs(light(x + kBlock, y) - light(x, y)),
                                 std::abs(light(x, y + kBlock) - light(x, y))});
        }
    }
    EXPECT_LT(darkest, 0.85) << "there is a shadow";
    EXPECT_LT(steepest, 0.28) << "its own soft sides fall by 0.21 here; cut off it fell by 0.37";
    RecordProperty("steepest", std::to_string(steepest));
    RecordProperty("darkest", std::to_string(darkest));
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

TEST_F(DepthCueTest, TheGaugeStandsBesideATipThatIsNearWhereAidsAreAllowed) {
    SmallField f = small_field();
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

TEST_F(DepthCueTest, ShowsWhatOfANeedleLiesBelowTheSurface) {
    SmallField f = small_field();
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

}  // namespace THIS_TEST
