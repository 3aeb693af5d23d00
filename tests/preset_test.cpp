// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/preset.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

namespace placode::curriculum {
namespace THIS_TEST {

using testing::HasSubstr;

class Preset : public testing::Test {
 protected:
    void SetUp() override {
        folder_ = std::filesystem::path(testing::TempDir()) / "placode_presets";
        std::filesystem::remove_all(folder_);
        setenv("PLACODE_PRESETS", folder_.c_str(), 1);
    }
    void TearDown() override {
        unsetenv("PLACODE_PRESETS");
        std::filesystem::remove_all(folder_);
    }
    static ScenePreset example() {
        ScenePreset preset;
        preset.name = "Soft skin, Żółw";
        preset.preset_of = "flat_small";
        preset.author = "Dr. Example";
        preset.saved_utc = "2026-11-21T20:00:00Z";
        preset.tissues[sim::Tissue::kSkin][sim::TuneParameter::kStiffness] = 30000;
        preset.tissues[sim::Tissue::kZone][sim::TuneParameter::kFailStretch] = 2.0;
        preset.cut_power_w = 9;
        return preset;
    }
    std::filesystem::path folder_;
};

TEST_F(Preset, WhatIsSavedIsListedAndLoadedWithWhoAndWhen) {
    ScenePreset preset = example();
    save_preset(preset);
    const auto all = list_presets();
    ASSERT_EQ(all.size(), 1U);
    const ScenePreset again = load_preset(preset.id);
    EXPECT_EQ(again.name, preset.name);
    EXPECT_EQ(again.author, "Dr. Example");
    EXPECT_EQ(again.saved_utc, "2026-11-21T20:00:00Z");
    EXPECT_EQ(again.tissues, preset.tissues);
    EXPECT_EQ(again.cut_power_w, 9);
    EXPECT_EQ(again.coag_power_w, -1);
}

TEST_F(Preset, LiesInTheUsersDataUnlessTheEnvironmentNamesAFolder) {
    const auto value = [](const char* name) {
        const char* set = std::getenv(name);
        return std::string(set != nullptr ? set : "");
    };
    const std::string home = value("HOME"), data = value("XDG_DATA_HOME");
    EXPECT_EQ(preset_folder(), folder_);
    setenv("PLACODE_PRESETS", "", 1);
    setenv("HOME", "/home/ada", 1);
    setenv("XDG_DATA_HOME", "/some/where", 1);
    EXPECT_EQ(preset_folder(), "/some/where/placode/presets");
    setenv("XDG_DATA_HOME", "relative", 1);
    EXPECT_EQ(preset_folder(), "/home/ada/.local/share/placode/presets");
    unsetenv("HOME");
    EXPECT_EQ(preset_folder(), "");
    EXPECT_TRUE(list_presets().empty());
    ScenePreset preset = example();
    EXPECT_THROW(save_preset(preset), DefinitionError) << "not where the program was started";
    home.empty() ? unsetenv("HOME") : setenv("HOME", home.c_str(), 1);
    data.empty() ? unsetenv("XDG_DATA_HOME") : setenv("XDG_DATA_HOME", data.c_str(), 1);
}

TEST_F(Preset, ASecondOneOfTheSameNameDoesNotReplaceTheFirst) {
    ScenePreset first = example(), second = example();
    save_preset(first);
    save_preset(second);
    EXPECT_NE(first.id, second.id);
    EXPECT_EQ(list_presets().size(), 2U);
}

TEST_F(Preset, ATaskTakesTheNumbersAndSaysWhereTheyCameFrom) {
    ScenePreset preset = example();
    save_preset(preset);
    const Task before = load_task("diathermy_ring_small");
    const Task task = with_preset(before, preset);
    const auto at = [](const Task& t, sim::Tissue tissue) {
        return t.scene.materials[static_cast<size_t>(tissue)];
    };
    EXPECT_EQ(at(task, sim::Tissue::kSkin).youngs_modulus_pa, 30000);
    EXPECT_EQ(at(task, sim::Tissue::kZone).fail_stretch, 2.0);
    // Injury keeps its proportion: 1 + 0.25 * 1.0 / 0.5.
    EXPECT_NEAR(at(task, sim::Tissue::kZone).injury_stretch, 1.5, 1e-12);
    EXPECT_EQ(at(task, sim::Tissue::kMuscle).youngs_modulus_pa,
              at(before, sim::Tissue::kMuscle).youngs_modulus_pa);
    EXPECT_EQ(task.scene.tools[0].cut_power_w, 9);
    EXPECT_EQ(preset_of(task), preset.id);
    EXPECT_EQ(preset_of(before), "");
    // What a recording carries gives the same again.
    EXPECT_EQ(preset_of(load_task_text(task.json, "recording")), preset.id);
}

TEST_F(Preset, WrongFilesAreNamedWithPlaceAndWayOut) {
    std::filesystem::create_directories(folder_);
    std::ofstream(folder_ / "bad.json")
        << R"({"name": "x", "preset_of": "flat_small", "materials": {"skin": {"friction": 7}}})";
    try {
        static_cast<void>(load_preset("bad"));
        FAIL() << "a friction of 7 was taken";
    } catch (const DefinitionError& error) {
        EXPECT_THAT(error.what(), HasSubstr("/materials/skin/friction"));
    }
    try {
        static_cast<void>(load_preset("missing"));
        FAIL() << "a preset that is not there was loaded";
    } catch (const DefinitionError& error) {
        EXPECT_THAT(error.what(), HasSubstr("known: bad"));
    }
    EXPECT_TRUE(list_presets().empty());
    ScenePreset nameless = example();
    nameless.name.clear();
    EXPECT_THROW(save_preset(nameless), DefinitionError);
}

}  // namespace THIS_TEST
}  // namespace placode::curriculum
