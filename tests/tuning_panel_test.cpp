// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/attempt/tuning_panel.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

namespace placode::ui {
namespace THIS_TEST {

using sim::Key;
using sim::Tissue;
using sim::TuneParameter;
using testing::HasSubstr;

struct Change {
    TuneParameter parameter;
    Tissue tissue;
    double value;
};

class TuningPanelTest : public testing::Test {
 protected:
    TuningPanel make(bool allowed = true) {
        return {task_,
                {.language = "en",
                 .author = "Dr. Example",
                 .allowed = allowed,
                 .saved_utc = "2026-11-21T20:00:00Z",
                 .tune = [this](TuneParameter p, Tissue t, double v) {
                     made_.push_back({p, t, v});
                 }}};
    }
    curriculum::Task task_ = curriculum::load_task("diathermy_ring_small");
    std::vector<Change> made_;
};

TEST_F(TuningPanelTest, ArrowsChangeWhatIsSelectedAtOnce) {
    TuningPanel panel = make();
    panel.toggle();
    ASSERT_TRUE(panel.key(Key::kDown));  // from the tissue to its stiffness
    ASSERT_TRUE(panel.key(Key::kRight));
    ASSERT_EQ(made_.size(), 1U);
    EXPECT_EQ(made_[0].parameter, TuneParameter::kStiffness);
    EXPECT_EQ(made_[0].tissue, Tissue::kZone);
    EXPECT_NEAR(made_[0].value, 25000 * 1.15, 1e-6);
    EXPECT_TRUE(panel.tuned());
    EXPECT_TRUE(panel.picture().rows[1].changed);
    ASSERT_TRUE(panel.key(Key::kLeft));  // one step back is home exactly
    EXPECT_EQ(made_[1].value, 25000);
}

TEST_F(TuningPanelTest, TheMouseDoesTheSameAndResetPutsEverythingBack) {
    TuningPanel panel = make();
    panel.toggle();
    panel.click(view::kTuningParts * 5 + view::kTuningMore);  // cut power
    ASSERT_EQ(made_.size(), 1U);
    EXPECT_EQ(made_[0].parameter, TuneParameter::kCutPower);
    EXPECT_EQ(made_[0].value, 13);
    panel.click(view::kTuningParts * 7 + view::kTuningWhole);
    EXPECT_EQ(made_.back().value, 12);
    for (const view::TuningRow& row : panel.picture().rows) EXPECT_FALSE(row.changed);
    panel.click(-1);
    panel.click(999);
}

TEST_F(TuningPanelTest, F2OpensAndF2ClosesAndThenNoKeyTunes) {
    TuningPanel panel = make();
    EXPECT_FALSE(panel.key(Key::kRight));  // closed: keys are nobody's
    panel.toggle();
    EXPECT_TRUE(panel.shown());
    EXPECT_TRUE(panel.key(Key::kDown));
    EXPECT_TRUE(panel.key(Key::kEnter)) << "no Enter of the panel ends an attempt";
    panel.toggle();
    EXPECT_FALSE(panel.shown());
    for (const Key k : {Key::kUp, Key::kDown, Key::kLeft, Key::kRight, Key::kEnter})
        EXPECT_FALSE(panel.key(k));
    EXPECT_TRUE(made_.empty());
}

TEST_F(TuningPanelTest, ItSaysBeforeAChangeThatSuchAnAttemptDoesNotCount) {
    TuningPanel panel = make();
    panel.toggle();
    EXPECT_THAT(panel.picture().note, HasSubstr("Once something is changed"));
    EXPECT_FALSE(panel.tuned());
    panel.click(view::kTuningParts * 5 + view::kTuningMore);
    EXPECT_TRUE(panel.tuned());
    EXPECT_THAT(panel.picture().note, HasSubstr("was tuned: it does not count"));
}

TEST_F(TuningPanelTest, AnExamHasNoPanel) {
    TuningPanel panel = make(false);
    panel.toggle();
    EXPECT_FALSE(panel.shown());
}

TEST_F(TuningPanelTest, APresetIsSavedUnderTheNameThatWasTyped) {
    const auto folder = std::filesystem::path(testing::TempDir()) / "placode_panel_presets";
    std::filesystem::remove_all(folder);
    setenv("PLACODE_PRESETS", folder.c_str(), 1);
    TuningPanel panel = make();
    panel.toggle();
    const int save = view::kTuningParts * 8 + view::kTuningWhole;
    panel.click(save);
    EXPECT_TRUE(panel.typing());
    EXPECT_TRUE(panel.key(Key::kEnter));
    EXPECT_THAT(panel.picture().foot, HasSubstr("nothing to save"));
    panel.click(view::kTuningParts * 3 + view::kTuningMore);  // friction
    panel.click(save);
    panel.type("Gladż\b\bko");
    EXPECT_TRUE(panel.key(Key::kEnter));
    EXPECT_THAT(panel.picture().foot, HasSubstr("Saved as glako"));
    const auto preset = curriculum::load_preset("glako");
    EXPECT_EQ(preset.author, "Dr. Example");
    EXPECT_NEAR(preset.tissues.at(Tissue::kZone).at(TuneParameter::kFriction), 0.10, 1e-9);
    EXPECT_EQ(preset.tissues.size(), 1U);
    unsetenv("PLACODE_PRESETS");
    std::filesystem::remove_all(folder);
}

}  // namespace THIS_TEST
}  // namespace placode::ui
