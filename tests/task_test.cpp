// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/task.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "sim/cutting/diathermy.h"

namespace placode::curriculum {
namespace THIS_TEST {

std::string broken(const std::string& name) {
    return std::string(PLACODE_SOURCE_DIR) + "/tests/data/broken_" + name + ".json";
}

/// The refusal must come with the file, this pointer, and all of these words.
void expect_refused(const std::string& name, const std::string& pointer,
                    const std::vector<std::string>& words) {
    SCOPED_TRACE(name);
    try {
        (void)load_task(broken(name));
        ADD_FAILURE() << "was accepted";
    } catch (const DefinitionError& error) {
        const std::string text = error.what();
        EXPECT_EQ(error.pointer(), pointer) << text;
        for (const std::string& word : words)
            EXPECT_NE(text.find(word), std::string::npos) << word << " is not in: " << text;
    }
}

TEST(Task, EveryShippedTaskLoadsInBothLanguages) {
    const std::vector<std::string> ids = list_definitions("tasks");
    ASSERT_GE(ids.size(), 2u);
    for (const std::string& id : ids) {
        const Task task = load_task(id);
        EXPECT_EQ(task.id, id);
        EXPECT_FALSE(task.title.pl.empty());
        EXPECT_NE(task.title.in("pl"), task.title.in("en"));
        EXPECT_GE(task.instructions.size(), 3u);
        for (const LocalText& text : task.instructions) EXPECT_FALSE(text.pl.empty()) << text.en;
        for (const TaskStep& step : task.steps) EXPECT_FALSE(step.text.pl.empty()) << step.text.en;
        for (const assessment::RubricItem& item : task.rubric.items)
            EXPECT_FALSE(item.reason_pl.empty()) << item.reason;
        EXPECT_FALSE(task.scene.tools.empty());
        EXPECT_GE(task.rubric.items.size(), 9u);
        EXPECT_EQ(task.rubric.pass_points, 70);
        EXPECT_EQ(task.scene_id, task.scene.id);
    }
}

std::string text_of(const std::filesystem::path& path) {
    std::ifstream in(path);
    return {std::istreambuf_iterator<char>(in), {}};
}

TEST(Task, EveryShippedTaskStandsInTheTableAndTheNewOnesInTheManual) {
    const std::filesystem::path docs = std::string(PLACODE_SOURCE_DIR) + "/docs";
    const std::string table = text_of(docs / "training.md");
    std::string en, pl;
    for (const auto& page : std::filesystem::directory_iterator(docs / "manual" / "en"))
        if (page.path().filename().string().starts_with("trainee-")) {
            en += text_of(page.path());
            pl += text_of(docs / "manual" / "pl" / page.path().filename());
        }
    for (const std::string& id : list_definitions("tasks")) {
        EXPECT_NE(table.find("`" + id + "`"), std::string::npos) << id;
        const Task task = load_task(id);
        const auto& scene = task.scene;
        if (!scene.suture && !scene.patch && !scene.irrigation && !scene.plane) continue;
        EXPECT_NE(en.find(task.title.en), std::string::npos) << id << ": " << task.title.en;
        EXPECT_NE(pl.find(task.title.pl), std::string::npos) << id << ": " << task.title.pl;
    }
}

// Skin that leaves with a piece counts as torn: the reason must fit both.
TEST(Task, TornTissueMayHaveBeenTakenOutWhereAnInstrumentCutsOrCarries) {
    int both = 0;
    for (const std::string& id : list_definitions("tasks")) {
        const Task task = load_task(id);
        const bool carries =
            std::any_of(task.scene.tools.begin(), task.scene.tools.end(), [](const auto& tool) {
                return tool.kind == sim::ToolKind::kGrasper ||
                       tool.kind == sim::ToolKind::kScissors ||
                       tool.kind == sim::ToolKind::kIrrigator || sim::conducts(tool.kind);
            });
        for (const assessment::RubricItem& item : task.rubric.items) {
            if (item.metric != "torn_volume_mm3" && item.metric != "torn_skin_mm3") continue;
            const auto says = [&](const std::string& reason, const char* words) {
                return reason.find(words) != std::string::npos;
            };
            EXPECT_EQ(says(item.reason, "torn or wrongly taken out"), carries) << id << item.id;
            EXPECT_EQ(says(item.reason_pl, "lub niepotrzebnie "), carries) << id << item.id;
            both += carries ? 1 : 0;
        }
    }
    EXPECT_GE(both, 24);
}

TEST(Task, TheResolvedTextGivesTheSameTaskAgain) {
    for (const std::string& id : list_definitions("tasks")) {
        const Task task = load_task(id);
        const Task again = load_task_text(task.json, "recording");
        EXPECT_EQ(again.json, task.json);
        EXPECT_EQ(again.id, task.id);
        EXPECT_EQ(again.time_limit_s, task.time_limit_s);
        EXPECT_EQ(again.scene.edge_ring_m, task.scene.edge_ring_m);
        EXPECT_EQ(again.scene.solver.substeps, task.scene.solver.substeps);
        EXPECT_EQ(again.scene.tools.size(), task.scene.tools.size());
        for (size_t i = 0; i < task.scene.materials.size(); ++i) {
            EXPECT_EQ(again.scene.materials[i].youngs_modulus_pa,
                      task.scene.materials[i].youngs_modulus_pa);
        }
        EXPECT_EQ(again.rubric.items.size(), task.rubric.items.size());
    }
}

TEST(Task, WithoutALimitItLastsUntilSomebodyEndsIt) {
    const Task tutorial = load_task("familiarisation");
    EXPECT_EQ(tutorial.time_limit_s, 0);
    EXPECT_EQ(tutorial.json.find("time_limit_s"), std::string::npos);
    EXPECT_EQ(limit_of(tutorial, 0), kLongestS);
    EXPECT_EQ(limit_of(tutorial, 120), 120) << "a study's familiarisation";
    const Task ring = load_task("diathermy_ring");
    EXPECT_EQ(limit_of(ring, 0), 600);
    EXPECT_EQ(limit_of(ring, 120), 120);
    EXPECT_EQ(limit_of(ring, 900), 600) << "never longer than the task says";
}

TEST(Task, OverridesChangeOnlyWhatTheyName) {
    const Task plain = load_task("diathermy_ring_small");
    std::ifstream in(data_folder() / "tasks" / "diathermy_ring_small.json");
    std::string text((std::istreambuf_iterator<char>(in)), {});
    text.insert(text.find('{') + 1,
                R"("scene_overrides": {"materials": {"skin": {"youngs_modulus_pa": 12345}},
                    "solver": {"substeps": 3}},)");
    const Task changed = load_task_text(text, "changed");
    const auto skin = static_cast<size_t>(sim::Tissue::kSkin);
    EXPECT_EQ(changed.scene.materials[skin].youngs_modulus_pa, 12345);
    EXPECT_EQ(changed.scene.materials[skin].density_kg_m3,
              plain.scene.materials[skin].density_kg_m3);
    EXPECT_EQ(changed.scene.solver.substeps, 3);
    EXPECT_EQ(changed.scene.solver.iterations, plain.scene.solver.iterations);
    EXPECT_EQ(load_task_text(changed.json, "again").scene.solver.substeps, 3);
}

TEST(Task, ADataFolderNamedFromTheWorkingFolderServesScenesThatExtendOthers) {
    const std::string usual = load_task("suture_slit").json;
    const std::string here = std::filesystem::relative(data_folder()).string();
    ASSERT_EQ(::setenv("PLACODE_DATA", here.c_str(), 1), 0);
    EXPECT_EQ(load_task("suture_slit").json, usual);
    ::unsetenv("PLACODE_DATA");
}

TEST(Task, AWrongUnitNamesTheKeyThatWasMeant) {
    expect_refused("task_modulus_in_kpa", "/scene_overrides/materials/skin",
                   {"broken_task_modulus_in_kpa.json", "unknown key \"youngs_modulus_kpa\"",
                    "expected \"youngs_modulus_pa\" (a number in Pa from 10 to 1e+07)"});
    expect_refused(
        "task_limit_in_minutes", "/",
        {"unknown key \"time_limit_min\"", "expected \"time_limit_s\"", "in s", "from 1 to 7200"});
}

// What a file from outside calls a key is said, and not all of it: a megabyte took seconds.
TEST(Task, AVeryLongKeyIsShownInPart) {
    const std::string file = testing::TempDir() + "/long_key.json";
    std::ofstream(file) << "{\"" << std::string(1 << 20, 'k') << "\": 1}";
    try {
        (void)load_task(file);
        ADD_FAILURE() << "was accepted";
    } catch (const DefinitionError& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find("unknown key \"kkk"), std::string::npos) << text.substr(0, 1000);
        EXPECT_NE(text.find("kkk...\""), std::string::npos) << text.substr(0, 1000);
        EXPECT_LT(text.size(), 2000u);
    }
}

// A pipe that nobody writes into kept the simulator waiting, deaf to the signal that ends it.
TEST(Task, APipeIsNoTask) {
    const std::string pipe = testing::TempDir() + "/pipe.json";
    ::unlink(pipe.c_str());
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    try {
        (void)load_task(pipe);
        ADD_FAILURE() << "was accepted";
    } catch (const DefinitionError& error) {
        EXPECT_NE(std::string(error.what()).find("is a pipe; expected a JSON file"),
                  std::string::npos)
            << error.what();
    }
    ::unlink(pipe.c_str());
}

TEST(Task, AnImpossibleValueNamesFieldValueAndRange) {
    expect_refused("task_negative_limit", "/time_limit_s",
                   {"-5 is too small", "a number in s from 1 to 7200"});
    expect_refused("task_poisson", "/scene_overrides/materials/placode/poissons_ratio",
                   {"0.5 is too large", "to 0.499"});
    expect_refused("task_method", "/scene_overrides/solver/method",
                   {"found \"explicit\"", "\"vbd\"", "\"xpbd_pair\""});
}

TEST(Task, AStepSaysTheVeryTimeThatItAsksFor) {
    int said = 0;
    for (const std::string& id : list_definitions("tasks"))
        for (const TaskStep& step : load_task(id).steps) {
            EXPECT_EQ(step.text.en.find('{'), std::string::npos) << step.text.en;
            EXPECT_EQ(step.text.pl.find('{'), std::string::npos) << step.text.pl;
            if (step.text.en.find("0.4 s") == std::string::npos) continue;
            EXPECT_DOUBLE_EQ(step.goal.hold_s, 0.4);
            EXPECT_NE(step.text.pl.find("0,4 s"), std::string::npos) << step.text.pl;
            ++said;
        }
    EXPECT_EQ(said, 2) << "cutting and coagulating in the familiarisation";
}

TEST(Task, PlacesOfAStepAreReadAndWhatDoesNotFitIsRefused) {
    const std::string text = load_task("suture_run").json;
    EXPECT_EQ(load_task_text(text, "test").steps[1].goal.place_m[1], sim::Vec2(0.00565, 0.004));
    EXPECT_TRUE(load_task_text(text, "test").steps[0].goal.placed);
    EXPECT_FALSE(load_task("suture_bite").steps[0].goal.placed);
    const auto refusal = [&](const std::string& from, const std::string& to) {
        std::string other = text;
        const size_t at = other.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        other.replace(at, from.size(), to);
        try {
            (void)load_task_text(other, "test");
            return std::string("taken");
        } catch (const DefinitionError& error) {
            return error.pointer() + ": " + error.what();
        }
    };
    const std::string places = "\"places_m\":[[0.01235,0.004],[0.00565,0.004]]";
    const std::string one = refusal(places, "\"places_m\":[[0.01235,0.004]]");
    EXPECT_NE(one.find("/steps/0/places_m"), std::string::npos) << one;
    EXPECT_NE(one.find("expected 2"), std::string::npos) << one;
    const std::string both = refusal(places, places + ",\"hour\":3");
    EXPECT_NE(both.find("/steps/0/places_m"), std::string::npos) << both;
    EXPECT_NE(both.find("one of both"), std::string::npos) << both;
    EXPECT_NE(refusal("\"take_share\":0.7", "\"take_share\":1.2").find("take_share"),
              std::string::npos);
}

/// The stages of a task as text, in place of its own.
std::string with_stages(const std::string& stages) {
    std::string text = load_task("suture_run").json;
    const size_t from = text.find("\"stages\":["), to = text.find("],\"rubric\"", from);
    EXPECT_NE(from, std::string::npos);
    EXPECT_NE(to, std::string::npos);
    return text.replace(from, to + 1 - from, "\"stages\":" + stages);
}

std::string stage_refusal(const std::string& stages) {
    try {
        (void)load_task_text(with_stages(stages), "test");
        return "taken";
    } catch (const DefinitionError& error) {
        return error.pointer() + ": " + error.what();
    }
}

TEST(Task, StagesStandBeforeStepsThatAreThere) {
    const Task task = load_task("suture_run");
    ASSERT_EQ(task.stages.size(), 2U);
    EXPECT_EQ(task.stages[0].before_step, 5);
    EXPECT_EQ(task.stages[1].before_step, 10);
    EXPECT_EQ(task.stages[0].title.in("en"), "bite 2");
    EXPECT_EQ(&stage_of(task, 2), &task.stages[1]);
    for (const std::string& id : list_definitions("tasks")) {
        const Task each = load_task(id);
        for (const TaskStage& stage : each.stages) {
            EXPECT_FALSE(stage.title.pl.empty()) << id;
            // What a stage begins with is the first motion of something, and nothing held before.
            const sim::PracticeKind kind =
                each.steps.at(static_cast<size_t>(stage.before_step)).goal.kind;
            EXPECT_TRUE(kind == sim::PracticeKind::kNeedleIn || kind == sim::PracticeKind::kGrasp)
                << id << " " << stage.title.en;
        }
    }
    const std::string title = ",\"title\":{\"en\":\"b\",\"pl\":\"b\"}}";
    EXPECT_EQ(stage_refusal("[{\"before_step\":13" + title + "]"), "taken");
    const std::string beyond = stage_refusal("[{\"before_step\":14" + title + "]");
    EXPECT_NE(beyond.find("/stages/0/before_step: "), std::string::npos) << beyond;
    EXPECT_NE(beyond.find("found 14; expected 1 to 13"), std::string::npos) << beyond;
    const std::string falling =
        stage_refusal("[{\"before_step\":5" + title + ",{\"before_step\":5" + title + "]");
    EXPECT_NE(falling.find("/stages/1/before_step: "), std::string::npos) << falling;
    EXPECT_NE(falling.find("found 5; expected 6 to 13"), std::string::npos) << falling;
    for (const char* before : {"0", "-1", "2.5", "\"5\""})
        EXPECT_NE(stage_refusal(std::string("[{\"before_step\":") + before + title + "]")
                      .find("/stages/0/before_step"),
                  std::string::npos)
            << before;
    EXPECT_NE(stage_refusal("[]").find("/stages"), std::string::npos);
    EXPECT_NE(stage_refusal("[{\"before_step\":5}]").find("title"), std::string::npos);
}

TEST(Task, AStageThatIsNotThereIsNamedWithThoseThatAre) {
    try {
        (void)stage_of(load_task("suture_run"), 3);
        ADD_FAILURE() << "there is no third one";
    } catch (const DefinitionError& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find("has no stage 3"), std::string::npos) << text;
        EXPECT_NE(text.find("0 (the beginning), 1 (bite 2), 2 (bite 3)"), std::string::npos)
            << text;
    }
    EXPECT_THROW((void)stage_of(load_task("diathermy_ring"), 1), DefinitionError);
    EXPECT_THROW((void)stage_of(load_task("suture_run"), 0), DefinitionError);
}

TEST(Task, StepsOfSomeDevicesOnlyGoWithNoStages) {
    std::string text = load_task("suture_run").json;
    const std::string kind = "\"kind\":\"needle_in\",";
    const size_t at = text.find(kind);
    ASSERT_NE(at, std::string::npos);
    text.insert(at + kind.size(), "\"devices\":[\"mouse\"],");
    try {
        (void)load_task_text(text, "test");
        ADD_FAILURE() << "was accepted";
    } catch (const DefinitionError& error) {
        EXPECT_EQ(error.pointer(), "/stages");
    }
}

TEST(Task, WhatIsMissingOrUnknownIsNamed) {
    expect_refused("task_without_rubric", "/", {"key \"rubric\" is missing"});
    expect_refused("task_title_is_text", "/title", {"found \"Ring\"", "an object"});
    expect_refused("task_unknown_metric", "/rubric/items/0/metric",
                   {"\"path_length_cm\"", "path_length_mm"});
    expect_refused("task_unknown_scene", "", {"\"flat_defualt\"", "flat_default"});
}

TEST(Task, ASyntaxErrorNamesLineAndColumn) {
    expect_refused("task_syntax", "", {"line 3, column 16", "not JSON"});
}

TEST(Task, AFileThatIsNotThereIsNamed) {
    expect_refused("no_such_file", "", {"broken_no_such_file.json", "cannot be opened"});
    EXPECT_THROW((void)load_task("no_such_task"), DefinitionError);
    EXPECT_THROW((void)load_task_text("", "empty"), DefinitionError);
}

}  // namespace THIS_TEST
}  // namespace placode::curriculum
