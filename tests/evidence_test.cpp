// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Forged recordings count for nothing, an honest one does: whatever is changed in an exam's file,
// the course stands as if the exam had not been passed.

#include "db/evidence.h"

#include <gmock/gmock.h>

#include <fstream>
#include <limits>

#include "db/attempt_counting.h"
#include "db/course_conduct.h"
#include "db/recording_file.h"
#include "tests/attempt_fixture.h"
#include "tests/store_fixture.h"

using namespace placode;
using namespace placode::test;
using sim::Recording;
using testing::HasSubstr;

namespace THIS_TEST {

World* const world = World::install();
constexpr const char* kTask = "touch_targets";
constexpr const char* kNow = "2026-03-01T00:00:00Z";

/// One exam of one seed that any score passes.
constexpr const char* kCourse =
    R"({"id":"short","version":1,"title":{"en":"Short"},"stages":[{"id":"final",)"
    R"("task_id":"touch_targets","mode":"exam","consecutive":1,"benchmark_points":0,)"
    R"("exam":{"seeds":[3]}}]})";

const Recording& honest_attempt() {
    static const Recording recording = [] {
        curriculum::AttemptOptions options;
        options.device = "script:expert";
        options.fast = true;
        options.threads = 1;
        options.duration_s = 4.5;
        options.started_utc = "2026-02-01T00:00:00Z";
        const curriculum::Task task = curriculum::load_task(kTask);
        options.steps = task.steps;
        const auto made = std::make_shared<Recording>();
        curriculum::AttemptRunner runner(task, 3, options, std::make_unique<MemorySink>(made));
        runner.start();
        runner.wait();
        return std::move(*made);
    }();
    return recording;
}

struct Forgery {
    const char* name;
    std::function<void(Recording&)> make;
};

const std::vector<Forgery>& forgeries() {
    static const std::vector<Forgery> all{
        {"rubric that takes nothing off",
         [](Recording& r) {
             std::string& json = r.header.task_json;
             const size_t at = json.find("\"rubric\"");
             const size_t weight = json.find("\"max_points\":", at);
             ASSERT_NE(at, std::string::npos);
             if (weight != std::string::npos)
                 json.replace(weight, 13, "\"max_points\":0");
             else
                 json.insert(json.find_last_of('}'), ",\"title\":{\"en\":\"Mine\"}");
         }},
        {"task that nobody published", [](Recording& r) { r.header.task_id = "easy_ring"; }},
        {"version that nobody published", [](Recording& r) { r.header.task_version = 77; }},
        {"path for a task", [](Recording& r) { r.header.task_id = "../tasks/diathermy_ring"; }},
        {"task that is no JSON", [](Recording& r) { r.header.task_json = "{"; }},
        {"softer tissue",
         [](Recording& r) {
             std::string& json = r.header.task_json;
             const size_t at = json.find("time_limit_s");
             ASSERT_NE(at, std::string::npos);
             json.replace(at, 12, "time_limit_s\":9,\"x");
         }},
        {"ring that was cut",
         [](Recording& r) {
             for (auto& s : r.samples) s.cut_fraction = 1;
         }},
        {"steadier hand",
         [](Recording& r) {
             for (auto& s : r.samples) s.tools[0].tip_m = r.samples[0].tools[0].tip_m;
         }},
        {"no force",
         [](Recording& r) {
             for (auto& s : r.samples) std::ranges::fill(s.tools[0].force_n, 1e-9F);
         }},
        {"event left out", [](Recording& r) { r.events.erase(r.events.begin()); }},
        {"all events left out", [](Recording& r) { r.events.clear(); }},
        {"event of a next phase",
         [](Recording& r) {
             sim::Event more;
             more.time_s = 0.4;
             more.kind = sim::EventKind::kPhase;
             more.value = 3;
             r.events.push_back(more);
         }},
        {"contour emptied", [](Recording& r) { r.header.geometry.planned_contour.clear(); }},
        {"contour moved",
         [](Recording& r) {
             for (auto& p : r.header.geometry.planned_contour) p *= 1.2;
         }},
        {"larger placode", [](Recording& r) { r.header.geometry.placode_volume_m3 *= 100; }},
        {"shorter", [](Recording& r) { r.end.duration_s = 2.7; }},
        {"endless", [](Recording& r) { r.end.duration_s = 1e300; }},
        {"no duration",
         [](Recording& r) { r.end.duration_s = std::numeric_limits<double>::quiet_NaN(); }},
        {"finished",
         [](Recording& r) {
             r.end.final_hash = 1;
             r.end.reason = sim::EndReason::kFinished;
         }},
        {"end cut off", [](Recording& r) { r.inputs.resize(700); }},
        {"input left out", [](Recording& r) { r.inputs.erase(r.inputs.begin() + 700); }},
        {"time backwards", [](Recording& r) { r.header.sample_s = -0.01; }},
        {"no frame", [](Recording& r) { r.header.frame_s = 0; }},
        {"tip nowhere",
         [](Recording& r) {
             r.samples[9].tools[0].tip_m[1] = std::numeric_limits<float>::infinity();
         }},
        {"samples left out", [](Recording& r) { r.samples.resize(40); }},
        {"another case", [](Recording& r) { r.header.seed = 5; }},
        {"other needle", [](Recording& r) { r.header.tools[0].tip_radius_m /= 4; }},
        {"entries lost", [](Recording& r) { r.end.dropped = 900; }},
        {"quieter samples",
         [](Recording& r) {
             for (auto& s : r.samples) s.placode_peak_c = 36;
         }},
    };
    return all;
}

class Evidence : public testing::Test {
 protected:
    void SetUp() override {
        db::StoreOptions options;
        options.cheap_passwords = true;
        store = db::open_store("sqlite:" + folder.file("placode.db"), options);
        anna = add("anna", true);
        jan = add("jan", true);
        ewa = add("ewa", false);
        db::DefinitionRecord course;
        course.kind = "course";
        course.id = "short";
        course.version = 1;
        course.json = kCourse;
        course.reason = "test";
        store->definitions().publish(course);
        for (const int64_t user : {anna, jan, ewa}) {
            db::AssignmentRecord assignment;
            assignment.course_id = "short";
            assignment.course_version = 1;
            assignment.user_id = user;
            store->courses().assign(assignment);
        }
    }
    [[nodiscard]] int64_t add(const std::string& login, bool demonstration) const {
        return store->accounts().create({login, login, "long enough 1",
                                         static_cast<db::Roles>(db::Role::kTrainee),
                                         demonstration});
    }
    /// As the shell and the import do: judged, saved as the exam, simulated again.
    int64_t take(int64_t user, const Recording& recording) {
        const std::string path = folder.file("r" + std::to_string(++files) + ".placode");
        const auto sink = db::create_recording_file(path);
        sink->begin(recording.header);
        sink->append(recording.inputs, recording.samples, recording.events);
        sink->finish(recording.end);
        db::AttemptResult result = db::judged(*store, recording);
        result.recording_file = path;
        result.exam = {"short", 1, "final", "Ewa", ""};
        const int64_t id = store->attempts().save(user, result);
        if (store->attempts().detail(id).record.replay == db::ReplayState::kWaiting)
            (void)db::verify_attempt(*store, id);
        return id;
    }
    [[nodiscard]] bool mastered(int64_t user) const {
        return db::course_standing(*store, user, "short", kNow).progress.mastered;
    }
    [[nodiscard]] db::AttemptRecord record(int64_t id) const {
        return store->attempts().detail(id).record;
    }

    TemporaryFolder folder;
    std::unique_ptr<db::Store> store;
    int64_t anna = 0, jan = 0;  // Of demonstration: a script operates.
    int64_t ewa = 0;
    int files = 0;
};

TEST_F(Evidence, AnHonestExamCountsOnceItWasSimulatedAgain) {
    Recording recording = honest_attempt();
    const db::AttemptResult result = db::judged(*store, recording);
    EXPECT_EQ(result.not_verified, "");
    const int64_t id = take(anna, recording);
    EXPECT_EQ(record(id).replay, db::ReplayState::kIdentical) << record(id).void_reason;
    EXPECT_TRUE(db::counts(record(id)));
    EXPECT_TRUE(mastered(anna));
}

TEST_F(Evidence, UntilThenItDoesNot) {
    db::AttemptResult result = db::judged(*store, honest_attempt());
    result.recording_file = folder.file("a.placode");
    const auto sink = db::create_recording_file(result.recording_file);
    sink->begin(honest_attempt().header);
    sink->append(honest_attempt().inputs, honest_attempt().samples, honest_attempt().events);
    sink->finish(honest_attempt().end);
    result.exam = {"short", 1, "final", "Ewa", ""};
    const int64_t id = store->attempts().save(anna, result);
    EXPECT_EQ(record(id).replay, db::ReplayState::kWaiting);
    EXPECT_FALSE(db::counts(record(id)));
    EXPECT_FALSE(mastered(anna));
    EXPECT_THAT(store->attempts().waiting_for_replay(), testing::ElementsAre(id));
    // Stopped half-way it waits on.
    EXPECT_FALSE(db::verify_attempt(*store, id, [](double share) { return share < 0.5; }));
    EXPECT_EQ(record(id).replay, db::ReplayState::kWaiting);
    EXPECT_TRUE(db::verify_attempt(*store, id)->identical);
    EXPECT_TRUE(mastered(anna));
    EXPECT_TRUE(store->attempts().waiting_for_replay().empty());
}

TEST_F(Evidence, NoForgeryCounts) {
    for (const Forgery& forgery : forgeries()) {
        SCOPED_TRACE(forgery.name);
        Recording forged = honest_attempt();
        forgery.make(forged);
        int64_t id = 0;
        try {
            id = take(anna, forged);
        } catch (const db::StoreError&) {
            continue;  // Refused: kept nowhere.
        }
        EXPECT_FALSE(db::counts(record(id))) << record(id).points;
        EXPECT_FALSE(mastered(anna));
    }
}

TEST_F(Evidence, OneRecordingIsNotTheExamOfTwoPeople) {
    const int64_t first = take(anna, honest_attempt());
    EXPECT_TRUE(db::counts(record(first)));
    Recording copy = honest_attempt();
    // As a person's: scripts move alike, and say that they are scripts.
    copy.header.device = "mouse";
    copy.header.demonstration = false;
    Recording again = copy;
    again.header.started_utc = "2026-02-02T00:00:00Z";
    (void)take(anna, copy);
    const int64_t third = take(jan, again);
    EXPECT_FALSE(db::counts(record(third)));
    EXPECT_THAT(record(third).void_reason, HasSubstr("the recording is that of attempt"));
    EXPECT_FALSE(mastered(jan));
}

TEST_F(Evidence, AScriptPassesNoExamOfAPerson) {
    const int64_t id = take(ewa, honest_attempt());
    EXPECT_FALSE(db::counts(record(id)));
    EXPECT_EQ(record(id).void_reason, "Practice, not verified: operated by script:expert");
    EXPECT_FALSE(mastered(ewa));
    // It has used up the case.
    EXPECT_EQ(db::void_reasons(record(id).void_reason).front().cause, db::VoidCause::kScript);
}

TEST_F(Evidence, WhatAnotherProcessorRecordedWaitsAndIsNotCalledForged) {
    Recording other = honest_attempt();
    other.header.build = "placode 0.1 NEON";
    const int64_t id = take(anna, other);
    EXPECT_EQ(record(id).replay, db::ReplayState::kWaiting);
    EXPECT_EQ(record(id).void_reason, "");
    EXPECT_FALSE(mastered(anna));
}

}  // namespace THIS_TEST
