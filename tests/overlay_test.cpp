// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What is written and drawn over the picture: read-outs, notices, goals and hints of practice.

#include "ui/view/overlay.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "picture_fixture.h"
#include "ui/view/strings.h"

using namespace placode::sim;
using namespace placode::view;

namespace THIS_TEST {

class OverlayTest : public PictureTest {};

TEST_F(OverlayTest, WritesTheReadOutsOutsideTheCircle) {
    SmallField f = small_field();
    f.snapshot.time_s = 187;
    OverlayState overlay;
    overlay.title = "Ring";
    const Picture exam = draw(f.snapshot, quiet());
    const Picture full = draw(f.snapshot, overlay);
    // Time stands top left in both; energy and ring only outside an exam.
    EXPECT_GT(exam.mean(5, 5, 50, 40), 0.10);
    EXPECT_GT(full.mean(kPicturePx - 70, kPicturePx - 70, kPicturePx, kPicturePx),
              exam.mean(kPicturePx - 70, kPicturePx - 70, kPicturePx, kPicturePx) + 0.005);
    overlay.menu.shown = true;
    overlay.menu.items = {"Continue", "Finish"};
    EXPECT_GT(difference(full, draw(f.snapshot, overlay)), 5.0);
}

TEST_F(OverlayTest, ALongTitleOfAMenuStaysInsideItsBox) {
    const SmallField f = small_field();
    OverlayState overlay = quiet();
    overlay.menu.shown = true;
    overlay.menu.items = {"Continue"};
    overlay.menu.title = "Paused";
    const Picture narrow = draw(f.snapshot, overlay);
    overlay.menu.title = "Paused: another window is in front";
    const Picture wide = draw(f.snapshot, overlay);
    // In so small a window the box leaves a margin of 11 pixels, where only tissue is seen.
    const auto letters = [](const Picture& picture, int from, int to) {
        int count = 0;
        for (int y = 0; y < kPicturePx; ++y)
            for (int x = from; x < to; ++x) count += picture.luminance(x, y) > 0.5 ? 1 : 0;
        return count;
    };
    const int right = kPicturePx - 11;
    EXPECT_GT(letters(wide, 0, right), letters(narrow, 0, right) + 50) << "it is there, whole";
    EXPECT_EQ(letters(wide, right, kPicturePx), 0);
}

TEST_F(OverlayTest, AnExamIsToldThatTheComputerIsTooSlow) {
    const SmallField f = small_field();
    OverlayState overlay = quiet();
    const Picture before = draw(f.snapshot, overlay);
    overlay.banner = "COMPUTER TOO SLOW, does not count";
    const Picture banner = draw(f.snapshot, overlay);
    overlay.banner.clear();
    overlay.notice = "This computer is slow: the picture was made simpler";
    const Picture notice = draw(f.snapshot, overlay);
    const auto foot = [](const Picture& picture) {
        return picture.mean(60, kPicturePx - 40, kPicturePx - 60, kPicturePx);
    };
    EXPECT_GT(std::abs(foot(banner) - foot(before)), 0.01);
    EXPECT_GT(std::abs(foot(notice) - foot(before)), 0.01);
    EXPECT_NE(translated("COMPUTER TOO SLOW, does not count", "pl"),
              "COMPUTER TOO SLOW, does not count");
}

OverlayState practising(PracticeKind kind, placode::haptics::HintDevice device) {
    OverlayState overlay;
    overlay.practice.steps = {{"Step", "Press the key", false}};
    overlay.practice.device = device;
    overlay.practice.goal.count = 1;
    overlay.practice.goal.step.kind = kind;
    return overlay;
}

TEST_F(OverlayTest, WhoIsStuckIsShownTheVeryKey) {
    SmallField f = small_field();
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

TEST_F(OverlayTest, AnExamShowsWhatIsToBeTouchedAndNoMore) {
    SmallField f = small_field();
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

TEST_F(OverlayTest, EveryKindOfStepHasAGoalInThePicture) {
    SmallField f = small_field();
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
class OverlayRimTest : public PictureTest {
 protected:
    static constexpr int kWide = 1024, kHigh = 640;
    void SetUp() override {
        PictureTest::SetUp();
        if (IsSkipped()) return;
        field_ = small_field();
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
    SmallField field_;
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

TEST_F(OverlayRimTest, AListOfStepsThatIsTooLongLeavesTheBarsAlone) {
    OverlayState overlay;
    overlay.practice.goal.count = 1;
    overlay.practice.steps = {{"Needle in at the first mark of this bite", {}, false}};
    const auto one = draw(overlay);
    overlay.practice.steps.resize(20, overlay.practice.steps[0]);
    const auto in_the_foot = [](const std::vector<bool>& marks) {
        return std::count(marks.begin() + kWide * (kHigh - 70), marks.end(), true);
    };
    std::vector<std::vector<uint8_t>> seen;
    for (const int now : {0, 9, 19}) {
        overlay.practice.goal.index = now;
        seen.push_back(draw(overlay));
        EXPECT_EQ(in_the_foot(changed(one, seen.back())), 0) << now;
    }
    EXPECT_GT(count(changed(one, seen[0])), 500) << "what comes next is listed";
    EXPECT_GT(count(changed(seen[1], seen[2])), 100) << "and how many there are";
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

}  // namespace THIS_TEST
