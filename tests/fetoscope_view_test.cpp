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
#include "picture_fixture.h"

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

class FetoscopeViewTest : public PictureTest {};

TEST_F(FetoscopeViewTest, ShowsALitRoundPictureOnNearBlack) {
    const Picture p = draw(small_field().snapshot, quiet());
    // Corners: the surround is sRGB 14..16 of 255.
    EXPECT_LT(p.mean(kPicturePx - 20, 0, kPicturePx, 20), 0.09);
    EXPECT_LT(p.mean(kPicturePx - 20, kPicturePx - 20, kPicturePx, kPicturePx), 0.09);
    // The middle is exposed like an operation: neither dark nor burnt out.
    const double middle =
        p.mean(kPicturePx / 2 - 40, kPicturePx / 2 - 40, kPicturePx / 2 + 40, kPicturePx / 2 + 40);
    EXPECT_GT(middle, 0.20);
    EXPECT_LT(middle, 0.85);
    // Tissue is red before it is green or blue.
    double red = 0, blue = 0;
    for (int i = kPicturePx / 3; i < 2 * kPicturePx / 3; ++i) {
        red += p.rgb[3 * static_cast<size_t>(kPicturePx / 2 * kPicturePx + i)];
        blue += p.rgb[3 * static_cast<size_t>(kPicturePx / 2 * kPicturePx + i) + 2];
    }
    EXPECT_GT(red, 1.15 * blue);
}

TEST_F(FetoscopeViewTest, HasDetailAndNoBrokenPixels) {
    // A value that is not a number would be black or white in a block: every 30 px cell inside the
    // circle must vary, and none may be uniformly black.
    const Picture p = draw(small_field().snapshot, quiet());
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
    SmallField f = small_field();
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
    const int a = kPicturePx / 2 - 8, b = kPicturePx / 2 + 8;
    const Picture pale = burn({1, 0, 0, 70});
    EXPECT_GT(pale.mean(a, a, b, b), before.mean(a, a, b, b) + 0.05);
    const Picture charred = burn({1, 1, 1, 220});
    EXPECT_LT(charred.mean(a, a, b, b), 0.6 * before.mean(a, a, b, b));
}

TEST_F(FetoscopeViewTest, FollowsTheTissueAndTheInstrument) {
    SmallField f = small_field();
    const Picture before = draw(f.snapshot, quiet());
    for (auto& x : f.snapshot.x) {
        x[2] += 0.003F * std::exp(-(x[0] * x[0] + x[1] * x[1]) / 2e-5F);
    }
    EXPECT_GT(difference(before, draw(f.snapshot, quiet())), 1.0);
    f = small_field();
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
    SmallField f = small_field();
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
    SmallField f = small_field();
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

// A picture that nobody could see counts for no rate of pictures.
TEST_F(FetoscopeViewTest, SaysWhetherThereWasAPictureToDraw) {
    EXPECT_FALSE(view_->draw({}, quiet()));
    EXPECT_TRUE(view_->draw(small_field().snapshot, quiet()));
}

TEST_F(FetoscopeViewTest, WritesAPngThatReadsBackTheSame) {
    const Picture p = draw(small_field().snapshot, quiet());
    const auto path = std::filesystem::temp_directory_path() /
                      ("placode_view_" + std::to_string(::getpid()) + ".png");
    view_->save_png(path.string());
    int w = 0, h = 0, n = 0;
    stbi_uc* data = stbi_load(path.c_str(), &w, &h, &n, 3);
    ASSERT_NE(data, nullptr);
    EXPECT_EQ(w, kPicturePx);
    EXPECT_EQ(h, kPicturePx);
    EXPECT_TRUE(std::equal(p.rgb.begin(), p.rgb.end(), data));
    stbi_image_free(data);
    std::filesystem::remove(path);
    EXPECT_THROW(view_->save_png("/nowhere/at/all.png"), ViewError);
}

// One context after the other: suites of their own.
std::unique_ptr<FetoscopeView> view_of(const ViewField& field, const Quality& quality) {
    ViewSettings settings;
    settings.width = settings.height = kPicturePx;
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
    for (int y = 40; y < kPicturePx - 40; ++y) {
        for (int x = 40; x < kPicturePx - 40; ++x) {
            const double change = pictures[1].luminance(x, y) - pictures[0].luminance(x, y);
            darker += change < -0.08 ? 1 : 0;
            brighter += change > 0.15 ? 1 : 0;
        }
    }
    EXPECT_GT(darker, 20);
    EXPECT_LT(darker, kPicturePx * kPicturePx / 10) << "tissue does not darken itself";
    EXPECT_LT(brighter, 40);
}

TEST(PlainPicture, ShowsTheSameInTheSamePlaces) {
    Picture pictures[2];
    for (const bool plain : {false, true}) {
        ViewSettings settings;
        settings.width = settings.height = kPicturePx;
        settings.offscreen = true;
        settings.adaptive = false;
        std::unique_ptr<FetoscopeView> view;
        try {
            view = std::make_unique<FetoscopeView>(small_field().view, settings);
        } catch (const ViewError& error) {
            GTEST_SKIP() << "no OpenGL here: " << error.what();
        }
        while (plain && view->simplify()) {
        }
        for (int i = 0; i < 3; ++i)
            view->draw(small_field().snapshot, quiet());  // the iris settles
        EXPECT_EQ(view->gl_error(), 0U);
        if (plain) {
            EXPECT_FALSE(view->simplify()) << "drawing made it less plain";
        }
        pictures[plain ? 1 : 0].rgb = view->pixels();
    }
    EXPECT_GT(difference(pictures[0], pictures[1]), 0.5) << "nothing was left out";
    // Cells of 15 px, corners and rim too: a picture in another place, or mirrored, is 0.3 apart.
    double worst = 0;
    for (int y = 0; y < kPicturePx; y += 15) {
        for (int x = 0; x < kPicturePx; x += 15)
            worst = std::max(worst, std::abs(pictures[0].mean(x, y, x + 15, y + 15) -
                                             pictures[1].mean(x, y, x + 15, y + 15)));
    }
    EXPECT_LT(worst, 0.08);
}

}  // namespace THIS_TEST
