// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A patch in the file of a scene.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "curriculum/definitions.h"
#include "curriculum/json_reader.h"
#include "sim/world/scene.h"

namespace placode::curriculum {
namespace THIS_TEST {

using ::testing::HasSubstr;

Json shipped() {
    const std::string file = find_definition("scenes", "patch_pad").string();
    return whole_scene(parse_json(read_definition(file), file), file);
}

/// Pointer and words of the refusal of a scene with another value in its patch.
std::string refusal(const char* key, const Json& value) {
    Json scene = shipped();
    scene["patch"][key] = value;
    try {
        (void)whole_scene(scene, "mine.json");
        return "accepted";
    } catch (const DefinitionError& error) {
        return error.pointer() + ": " + error.what();
    }
}

TEST(PatchScene, TheShippedPadHasAPatchBesideATrough) {
    const sim::OperativeFieldSpec spec = scene_from_json(shipped(), "patch_pad.json", "");
    ASSERT_TRUE(spec.patch);
    EXPECT_TRUE(spec.slit);
    EXPECT_DOUBLE_EQ(spec.patch->length_m, 0.015);
    EXPECT_DOUBLE_EQ(spec.patch->material.youngs_modulus_pa, 3e6);
    const auto scene = sim::build_operative_field(spec);
    ASSERT_TRUE(scene->patch);
    EXPECT_EQ(scene->patch->triangles.size(), 300U);
    const Json again = scene_to_json(spec);
    EXPECT_EQ(scene_to_json(scene_from_json(again, "again", "")), again);
}

TEST(PatchScene, RefusesValuesByPlaceAndRange) {
    EXPECT_THAT(refusal("thickness_m", 0), HasSubstr("/patch/thickness_m: "));
    EXPECT_THAT(refusal("thickness_m", 0), HasSubstr("from 1e-04 to 0.001"));
    EXPECT_THAT(refusal("youngs_modulus_pa", 0), HasSubstr("/patch/youngs_modulus_pa: "));
    EXPECT_THAT(refusal("edge_m", 0.0001), HasSubstr("/patch/edge_m: "));
    EXPECT_THAT(refusal("friction", -0.1), HasSubstr("/patch/friction: "));
    EXPECT_THAT(refusal("edge_mm", 1), HasSubstr("edge_mm"));
    EXPECT_EQ(refusal("bending", 0.2), "accepted");
}

}  // namespace THIS_TEST
}  // namespace placode::curriculum
