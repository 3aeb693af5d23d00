// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes that say what differs from another.

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "curriculum/json_reader.h"

namespace placode::curriculum {
namespace THIS_TEST {

namespace fs = std::filesystem;
using testing::HasSubstr;

class SceneFile : public testing::Test {
 protected:
    SceneFile() {
        std::string name = (fs::temp_directory_path() / "placode-scene-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("mkdtemp");
        folder_ = name;
    }
    ~SceneFile() override {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name) << text;
    }
    [[nodiscard]] Json load(const std::string& name) const {
        const std::string file = (folder_ / name).string();
        return whole_scene(parse_json(read_definition(file), file), file);
    }
    /// Pointer and words of the refusal.
    [[nodiscard]] std::string refusal(const std::string& name) const {
        try {
            (void)load(name);
            return "accepted";
        } catch (const DefinitionError& error) {
            return error.pointer() + ": " + error.what();
        }
    }
    fs::path folder_;
};

Json shipped(const std::string& id) {
    const fs::path file = find_definition("scenes", id);
    return parse_json(read_definition(file), file.string());
}

TEST(Definition, AFileWithoutEndIsRefused) {
    try {
        (void)read_definition("/dev/zero");
        FAIL() << "it has come to an end";
    } catch (const DefinitionError& error) {
        EXPECT_THAT(error.what(), HasSubstr("larger than 64 MB"));
    }
}

TEST_F(SceneFile, TakesFromItsBaseWhatItDoesNotName) {
    const Json base = shipped("flat_default");
    write("mine.json", R"({"id": "mine", "extends": "flat_default", "edge_ring_m": 0.0007,
                           "materials": {"skin": {"youngs_modulus_pa": 12345}}, "edge_growth": null,
                           "tools": [)" +
                           base["tools"][1].dump() + "]}");
    const Json mine = load("mine.json");
    EXPECT_EQ(mine["id"], "mine");
    EXPECT_EQ(mine["edge_ring_m"], 0.0007);
    EXPECT_EQ(mine["edge_outer_m"], base["edge_outer_m"]);
    EXPECT_EQ(mine["materials"]["skin"]["youngs_modulus_pa"], 12345);
    EXPECT_EQ(mine["materials"]["skin"]["density_kg_m3"],
              base["materials"]["skin"]["density_kg_m3"]);
    EXPECT_EQ(mine["heat"], base["heat"]);
    ASSERT_GT(base["tools"].size(), 1u);
    EXPECT_EQ(mine["tools"].size(), 1u) << "lists come whole";
    EXPECT_TRUE(base.contains("edge_growth"));
    EXPECT_FALSE(mine.contains("edge_growth"));
    EXPECT_FALSE(mine.contains("extends"));
}

TEST_F(SceneFile, TheBaseMayExtendAnotherAndLieBesideIt) {
    write("a.json", R"({"id": "a", "extends": "b.json", "edge_ring_m": 0.0007})");
    write("b.json", R"({"id": "b", "extends": "flat_small", "edge_outer_m": 0.002})");
    const Json scene = load("a.json");
    EXPECT_EQ(scene["edge_ring_m"], 0.0007);
    EXPECT_EQ(scene["edge_outer_m"], 0.002);
    EXPECT_EQ(scene["contour_offset_m"], 0.0019);
    EXPECT_EQ(scene["tools"], shipped("flat_default")["tools"]);
}

TEST_F(SceneFile, RefusesABaseThatIsNotThereAndCircles) {
    write("lost.json", R"({"id": "lost", "extends": "flat_defualt"})");
    EXPECT_THAT(refusal("lost.json"), HasSubstr("/extends: "));
    EXPECT_THAT(refusal("lost.json"), HasSubstr("flat_default"));
    write("self.json", R"({"id": "self", "extends": "self.json"})");
    EXPECT_THAT(refusal("self.json"), HasSubstr("extends this scene in turn"));
    write("a.json", R"({"id": "a", "extends": "b.json"})");
    write("b.json", R"({"id": "b", "extends": "a.json"})");
    EXPECT_THAT(refusal("a.json"), HasSubstr("extends this scene in turn"));
}

TEST_F(SceneFile, RefusesWhatAWholeSceneMayNotSayEither) {
    write("unit.json", R"({"id": "unit", "extends": "flat_default", "edge_ring_mm": 0.7})");
    EXPECT_THAT(refusal("unit.json"), HasSubstr("unknown key \"edge_ring_mm\""));
    write("nameless.json", R"({"extends": "flat_default"})");
    EXPECT_THAT(refusal("nameless.json"), HasSubstr("/id: "));
    write("bare.json", R"({"id": "bare", "extends": "flat_default", "tools": null})");
    EXPECT_THAT(refusal("bare.json"), HasSubstr("key \"tools\" is missing"));
    write("number.json", R"({"id": "number", "extends": 7})");
    EXPECT_THAT(refusal("number.json"), HasSubstr("/extends: "));
}

TEST_F(SceneFile, ATasksChangesExtendNothing) {
    Json task = parse_json(load_task("diathermy_ring_small").json, "task");
    task["scene_overrides"] = {{"extends", "flat_fine"}};
    EXPECT_THROW((void)load_task_text(task.dump(), "changed"), DefinitionError);
}

}  // namespace THIS_TEST
}  // namespace placode::curriculum
