// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A scene file with a needle: read, written, refused; and a recording of a bite in it, replayed.
#include <gmock/gmock.h>

#include <fstream>

#include "curriculum/json_reader.h"
#include "curriculum/replay.h"
#include "sim/step/needle_jaws.h"
#include "tests/stitch_scene.h"

namespace placode::curriculum {
namespace THIS_TEST {

using sim::Vec3;
using testing::HasSubstr;

Json driver_json() {
    return {{"kind", "needle_driver"},  {"hand", "right"},        {"pivot_m", {0, -0.11, 0.035}},
            {"shaft_radius_m", 0.0015}, {"tip_radius_m", 0.0005}, {"tip_length_m", 0.005},
            {"jaw_grip_m", 0.001}};
}

Json suture_json() {
    return {{"needle", {{"arc_m", 0.013}, {"wire_radius_m", 0.0002}, {"density_kg_m3", 7800}}},
            {"jaws",
             {{"force_n", 9},
              {"friction", 0.25},
              {"width_m", 0.0021},
              {"pull_n_m", 2000},
              {"turn_n_m_rad", 0.07}}},
            {"thread",
             {{"length_m", 0.1},
              {"stretch_n", 24},
              {"friction", 0.2},
              {"drag_n_m", 3},
              {"barb_n_m", 4},
              {"stopper", true}}},
            {"strength",
             {{"skin",
               {{"puncture_n", 0.008},
                {"cutting_share", 0.6},
                {"wall_friction_n_m", 2},
                {"tear_n_m", 500}}},
              {"dura", {{"puncture_n", 0.09}}}}},
            {"point_friction", 0.9},
            {"drag_per_s", 21},
            {"start",
             {{"in_jaws", true},
              {"held_share", 0.6},
              {"plane_deg", 15},
              {"position_m", {0.001, 0.002, 0.003}},
              {"yaw_deg", 30}}}};
}

/// A shipped task with other tools and a needle.
Json task_json() {
    Json task = parse_json(load_task("touch_targets").json, "touch_targets");
    Json& scene = task["scene"];
    scene["tools"][0] = driver_json();
    scene["suture"] = suture_json();
    return task;
}

TEST(SutureScene, IsReadAndWrittenWhole) {
    const Task task = load_task_text(task_json().dump(), "test");
    ASSERT_TRUE(task.scene.suture.has_value());
    EXPECT_EQ(task.scene.tools[0].kind, sim::ToolKind::kNeedleDriver);
    const sim::FieldSuture& read = *task.scene.suture;
    EXPECT_EQ(read.suture.needle.arc_m, 0.013);
    EXPECT_EQ(read.suture.thread.friction.barb_n_m, 4);
    EXPECT_TRUE(read.suture.thread.stopper);
    EXPECT_EQ(read.suture.strength[0].puncture_n, 0.008);
    EXPECT_EQ(read.suture.strength[static_cast<size_t>(sim::Tissue::kDura)].puncture_n, 0.09);
    EXPECT_EQ(read.suture.strength[static_cast<size_t>(sim::Tissue::kDura)].tear_n_m, 600)
        << "the default of what is not said";
    EXPECT_EQ(read.held_share, 0.6);
    EXPECT_EQ(read.position_m, Vec3(0.001, 0.002, 0.003));
    // What is written has every key of the test, with its value.
    const Json written = scene_to_json(task.scene)["suture"];
    const Json asked = suture_json();
    for (const auto& [section, values] : asked.items()) {
        if (!values.is_object()) {
            EXPECT_EQ(written[section], values) << section;
            continue;
        }
        for (const auto& [key, value] : values.items()) {
            if (section == "strength") {
                for (const auto& [field, number] : value.items())
                    EXPECT_EQ(written[section][key][field], number) << key << "." << field;
            } else {
                EXPECT_EQ(written[section][key], value) << section << "." << key;
            }
        }
    }
    const Json again = scene_to_json(scene_from_json(scene_to_json(task.scene), "test", ""));
    EXPECT_EQ(again, scene_to_json(task.scene));
}

TEST(SutureScene, ASceneWithoutANeedleSaysNothingOfOne) {
    const Task task = load_task("touch_targets");
    EXPECT_FALSE(task.scene.suture.has_value());
    EXPECT_FALSE(scene_to_json(task.scene).contains("suture"));
    EXPECT_EQ(task.json.find("suture"), std::string::npos);
    const auto scene = sim::build_operative_field(task.scene);
    EXPECT_FALSE(scene->suture.has_value());
    EXPECT_TRUE(sim::State(*scene, 1).suturing.needle.empty());
}

/// What a change of one value at a pointer is refused for: by the schema, or when it is built.
std::string refusal(const std::string& pointer, const Json& value) {
    Json task = task_json();
    task[Json::json_pointer("/scene" + pointer)] = value;
    try {
        const Task loaded = load_task_text(task.dump(), "test");
        (void)sim::build_operative_field(loaded.scene);
        return "taken";
    } catch (const DefinitionError& error) {
        return error.pointer() + ": " + error.what();
    } catch (const sim::MeshError& error) {
        return error.what();
    }
}

TEST(SutureScene, AnImpossibleValueNamesFieldValueAndRange) {
    ASSERT_EQ(refusal("/suture/needle/arc_m", 0.02), "taken");
    const auto expect = [](const std::string& pointer, const Json& value, const char* found,
                           const char* range) {
        const std::string said = refusal("/suture" + pointer, value);
        EXPECT_THAT(said, HasSubstr("/scene/suture" + pointer));
        EXPECT_THAT(said, HasSubstr(found));
        EXPECT_THAT(said, HasSubstr(range));
    };
    expect("/needle/arc_m", 0.1, "0.1 is too large", "0.005 to 0.04");
    expect("/needle/wire_radius_m", 0.00001, "is too small", "5e-05 to 5e-04");
    expect("/needle/density_kg_m3", 10, "10 is too small", "1000 to 25000");
    expect("/jaws/force_n", 0, "0 is too small", "0.001 to 100");
    expect("/jaws/friction", 3, "3 is too large", "0 to 2");
    expect("/jaws/width_m", 0.1, "0.1 is too large", "1e-04 to 0.01");
    expect("/jaws/pull_n_m", 1, "1 is too small", "10 to 10000");
    expect("/jaws/turn_n_m_rad", 100, "100 is too large", "0.001 to 10");
    expect("/thread/length_m", 3, "3 is too large", "0 to 2");
    expect("/thread/stretch_n", 0, "0 is too small", "0.1 to 1000");
    expect("/thread/friction", 2, "2 is too large", "0 to 1");
    expect("/strength/skin/puncture_n", 20, "20 is too large", "0.001 to 10");
    expect("/strength/skin/cutting_share", 1.5, "1.5 is too large", "0 to 1");
    expect("/strength/skin/tear_n_m", 0, "0 is too small", "1 to 1e+06");
    expect("/point_friction", 9, "9 is too large", "0 to 5");
    expect("/start/held_share", 1.5, "1.5 is too large", "0 to 1");
    expect("/start/plane_deg", 120, "120 is too large", "-90 to 90");
    EXPECT_THAT(refusal("/suture/needle/arc_mm", 17), HasSubstr("expected one of: arc_m"));
    EXPECT_THAT(refusal("/suture/strength/bone", Json::object()), HasSubstr("bone"));
    EXPECT_THAT(refusal("/suture/thread/length_m", "long"), HasSubstr("a number"));
}

// What a schema cannot say, because it hangs on another value.
TEST(SutureScene, WhatDoesNotFitTogetherIsRefusedWhenTheSceneIsBuilt) {
    EXPECT_THAT(refusal("/suture/needle/wire_radius_m", 0.00045),
                HasSubstr("suture.needle.wire_radius_m: found 0.00045; expected a number from"));
    EXPECT_THAT(
        refusal("/suture/thread/length_m", 0.001),
        HasSubstr("suture.thread.length_m: found 0.001; expected a number from 0.005 to 2"));
    EXPECT_THAT(refusal("/tools/0/kind", "grasper"),
                HasSubstr("suture.start.in_jaws: true, but none of the tools is a needle_driver"));
    Json task = task_json();
    task["scene"].erase("suture");
    const Task driver_only = load_task_text(task.dump(), "test");
    try {
        (void)sim::build_operative_field(driver_only.scene);
        ADD_FAILURE() << "taken";
    } catch (const sim::MeshError& error) {
        EXPECT_THAT(error.what(), HasSubstr("a needle_driver without a needle"));
    }
}

TEST(SutureScene, TheNeedleStartsWhereTheSceneSays) {
    const auto scene = sim::build_operative_field(load_task_text(task_json().dump(), "test").scene);
    ASSERT_TRUE(scene->suture.has_value());
    const sim::Needle& needle = scene->suture->needle();
    const sim::NeedleStart& start = scene->needle_start;
    ASSERT_TRUE(start.in_jaws);
    EXPECT_DOUBLE_EQ(start.held_arc_m, 0.6 * 0.013);
    const sim::ArcPoint held = needle.at(start.held_arc_m);
    // Across the jaws, a third of their length behind their tips; plane tipped by 15 degrees.
    EXPECT_LT((start.X_TN * held.place_m - Vec3(0, 0, -0.005 / 3)).norm(), 1e-12);
    EXPECT_LT((start.X_TN.q * held.back - Vec3::UnitX()).norm(), 1e-12);
    EXPECT_NEAR((start.X_TN.q * Vec3::UnitZ()).z(), -std::cos(15 * std::numbers::pi / 180), 1e-12);
    EXPECT_EQ(scene->suture->spec().gravity_m_s2, scene->body.spec().solver.gravity_m_s2);
    EXPECT_LT(scene->suture->spec().floor_m, 0);
    EXPECT_GE(sim::wire_between(scene->tools[0], {}, needle, start.X_TN), 0)
        << "jaws that take it where it begins";
    Json task = task_json();
    task["scene"]["suture"]["start"]["in_jaws"] = false;
    const auto lying = sim::build_operative_field(load_task_text(task.dump(), "test").scene);
    EXPECT_EQ(lying->needle_start.X_WN.p, Vec3(0.001, 0.002, 0.003));
    const Vec3 point = lying->needle_start.X_WN.q * needle.tip_m();
    EXPECT_NEAR(std::atan2(point.y(), point.x()), std::numbers::pi / 6, 1e-12);
}

/// A bite in the skin beside the lesion, as a recording.
sim::Recording recorded_bite() {
    sim::Recording recording;
    recording.header.task_json = task_json().dump();
    const Task task = load_task_text(recording.header.task_json, "test");
    recording.header.seed = task.scene.seed;
    recording.header.tools = task.scene.tools;
    recording.header.device = "script:test";
    const auto scene = sim::build_operative_field(task.scene);
    sim::State state(*scene, 1);
    sim::settle(*scene, state, task.settle_s);
    const Vec3 place(0, -0.0115, 0);
    double height = 0, nearest = 1;
    for (const sim::SurfaceTriangle& tri : state.surface.triangles())
        for (const int32_t v : tri.vertex) {
            const Vec3 p = position(state.body, v);
            if (p.z() < -1e-3 || (p - place).head<2>().norm() >= nearest) continue;
            nearest = (p - place).head<2>().norm();
            height = p.z();
        }
    sim::Pose start = sim::test::before_bite(scene->suture->needle(), 1.4e-3, 0.3e-3);
    start.p += place + Vec3(0, 0, height);
    const double radius = scene->suture->needle().radius_m();
    for (int i = 0; i < 900; ++i) {
        const sim::Pose X_WN{start.p,
                             start.q * sim::test::turned(-9e-6 * i / radius, Vec3::UnitZ())};
        sim::Input input;
        input.frame = state.frame;
        input.tool_count = 2;
        input.tools[0].set_pose(X_WN * scene->needle_start.X_TN.inverse());
        input.tools[0].engaged = 1;
        input.tools[1] = sim::test::upright(Vec3(-0.03, 0, 0.05));
        recording.inputs.push_back(input);
        std::array<sim::ToolFeedback, 2> feedback;
        (void)sim::step(*scene, state, {input.tools, 2}, feedback);
        for (int e = 0; e < state.event_count; ++e)
            recording.events.push_back(state.events[static_cast<size_t>(e)]);
        if (i % 100 != 99) continue;
        sim::Event hash;
        hash.kind = sim::EventKind::kStateHash;
        hash.time_s = state.time_s;
        hash.hash = sim::state_hash(state);
        recording.events.push_back(hash);
    }
    recording.end.reason = sim::EndReason::kFinished;
    recording.end.final_hash = sim::state_hash(state);
    return recording;
}

TEST(SutureScene, ARecordedBiteIsReplayedBitForBit) {
    const sim::Recording recording = recorded_bite();
    const auto happened = [&](sim::EventKind kind) {
        return std::any_of(recording.events.begin(), recording.events.end(),
                           [&](const sim::Event& e) { return e.kind == kind; });
    };
    ASSERT_TRUE(happened(sim::EventKind::kNeedleTaken));
    ASSERT_TRUE(happened(sim::EventKind::kNeedleEntered));
    for (const int threads : {1, 2}) {
        Replay replay(recording, threads, size_t{64} << 20);
        while (replay.step()) {
        }
        EXPECT_TRUE(replay.result().identical) << replay.result().message;
        EXPECT_EQ(replay.result().frames, std::ssize(recording.inputs));
    }
    // It can fail: another puncture force is another attempt.
    sim::Recording other = recording;
    Json task = parse_json(other.header.task_json, "test");
    task["scene"]["suture"]["strength"]["skin"]["puncture_n"] = 0.006;
    other.header.task_json = task.dump();
    Replay replay(other, 1);
    while (replay.step()) {
    }
    EXPECT_FALSE(replay.result().identical);
}

}  // namespace THIS_TEST
}  // namespace placode::curriculum
