// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Forged recordings count for nothing, an honest one does: whatever is changed in an exam's file,
// the course stands as if the exam had not been passed.

#include "db/evidence.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>

#include "curriculum/course.h"
#include "curriculum/questionnaire.h"
#include "curriculum/shipped_definitions.h"
#include "curriculum/utc_time.h"
#include "db/attempt_counting.h"
#include "db/course_conduct.h"
#include "db/recording_file.h"
#include "db/recording_order.h"
#include "db/rescore.h"
#include "db/sql_connection.h"
#include "tests/attempt_fixture.h"
#include "tests/bars.h"
#include "tests/exam_course.h"
#include "tests/forgeries.h"
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

class Evidence : public testing::Test {
 protected:
    void SetUp() override {
        db::StoreOptions options;
        options.cheap_passwords = true;
        store = db::open_store("sqlite:" + folder.file("placode.db"), options);
        anna = add("anna", true);
        jan = add("jan", true);
        ewa = add("ewa", false);
        for (const char* login : {"nina", "olga"})
            store->accounts().create({login, std::string("Dr ") + login, "long enough 1",
                                      static_cast<db::Roles>(db::Role::kEducator), false});
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
    /// @param begun text of the order that the attempt was begun with; empty = none.
    std::string write(const Recording& recording, const std::string& begun = {}) {
        std::string path = folder.file("r" + std::to_string(++files) + ".placode");
        const auto sink = db::create_recording_file(
            path, begun.empty() ? std::string() : db::order_checksum(begun));
        sink->begin(recording.header);
        sink->append(recording.inputs, recording.samples, recording.events);
        sink->finish(recording.end);
        return path;
    }
    /// As the import does: judged, saved as the exam, simulated again.
    int64_t take(int64_t user, const Recording& recording, const std::string& proctor = "nina") {
        db::AttemptResult result = db::judged(*store, recording);
        result.recording_file = write(recording);
        result.exam = {"short", 1, "final", proctor, ""};
        return keep(user, result);
    }
    [[nodiscard]] nlohmann::json order() const {
        return {{"user_id", anna}, {"proctor", "nina"}, {"exam_stage", "final"}};
    }
    /// Of an exam that the store knows of, as it is when its attempt begins.
    [[nodiscard]] nlohmann::json begun_order() const {
        nlohmann::json made = order();
        made["exam_begin"] =
            db::begin_exam(*store, anna,
                           db::prepare_exam(*store, anna, "short", "final", "nina", "", kNow))
                .context.begin;
        return made;
    }
    /// As the shell does: with the order that lies beside the recording. @param said text of it.
    int64_t take_with_order(const Recording& recording, const std::string& begun,
                            const std::string& said) {
        db::AttemptResult result = db::judged(*store, recording);
        result.recording_file = write(recording, begun);
        const auto json = said.empty() ? order() : nlohmann::json::parse(said);
        result.exam = {"short",
                       1,
                       json["exam_stage"].get<std::string>(),
                       json["proctor"].get<std::string>(),
                       "",
                       json.value("exam_begin", 0)};
        result.order = said;
        return keep(json["user_id"].get<int64_t>(), result);
    }
    int64_t keep(int64_t user, const db::AttemptResult& result) {
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
    EXPECT_TRUE(result.not_verified.empty());
    const int64_t id = take(anna, recording);
    EXPECT_EQ(record(id).replay, db::ReplayState::kIdentical) << record(id).void_reason;
    EXPECT_TRUE(db::counts(record(id)));
    EXPECT_TRUE(mastered(anna));
}

TEST_F(Evidence, UntilThenItDoesNot) {
    db::AttemptResult result = db::judged(*store, honest_attempt());
    result.recording_file = write(honest_attempt());
    result.exam = {"short", 1, "final", "nina", ""};
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

/// Every kind once, ten times in a long run.
TEST_F(Evidence, NoForgeryCounts) {
    Bar bar("forged exams that count");
    sim::SplitMix64 random(1);
    for (int i = 0; i < times(1, 10); ++i) {
        for (const auto* kinds : {&forgeries_of_the_task(), &forgeries_of_what_was_done()}) {
            for (const Forgery& forgery : *kinds) {
                SCOPED_TRACE(std::string(forgery.name) + " " + std::to_string(i));
                Recording forged = honest_attempt();
                forgery.make(forged, random);
                bool counts = false;
                try {
                    counts = db::counts(record(take(anna, forged)));
                } catch (const db::StoreError&) {
                    // Refused: kept nowhere.
                }
                const bool good = !counts && !mastered(anna);
                EXPECT_TRUE(good);
                bar.tried(good);
            }
        }
        // Of an honest recording, whose order was changed before it was saved.
        for (const OrderForgery& forgery : forgeries_of_the_order({jan, "olga", "other"})) {
            SCOPED_TRACE(std::string(forgery.name) + " " + std::to_string(i));
            Recording honest = honest_attempt();
            honest.header.started_utc = db::utc_now();
            const nlohmann::json begun = begun_order();
            nlohmann::json forged = begun;
            forgery.make(forged, random);
            const db::AttemptRecord kept =
                record(take_with_order(honest, begun.dump(), forged.dump()));
            const bool good = !db::counts(kept) && !mastered(anna) && !mastered(jan);
            EXPECT_TRUE(good) << kept.void_reason;
            EXPECT_THAT(kept.void_reason,
                        HasSubstr("it was begun for another person, exam or proctor"));
            bar.tried(good);
        }
    }
}

TEST_F(Evidence, AnExamCountsWithTheOrderThatItWasBegunWithAndNotWithoutOne) {
    const std::string begun = begun_order().dump();
    const auto cause_of = [&](int64_t id) {
        const auto reasons = db::void_reasons(record(id).void_reason);
        return reasons.empty() ? db::VoidCause::kDevice : reasons.front().cause;
    };
    EXPECT_EQ(cause_of(take_with_order(honest_attempt(), begun, "")), db::VoidCause::kOrderMissing);
    Recording again = honest_attempt();
    again.header.started_utc = "2026-02-01T00:00:01Z";
    EXPECT_EQ(cause_of(take_with_order(again, "", begun)), db::VoidCause::kOrderMissing)
        << "nothing in the recording binds it";
    EXPECT_FALSE(mastered(anna));
    // Practised until it went well, then given out as the exam that was begun.
    Recording practised = honest_attempt();
    practised.header.started_utc =
        curriculum::utc_text(*curriculum::utc_seconds(db::utc_now()) - 60);
    const std::string other = begun_order().dump();
    EXPECT_THAT(record(take_with_order(practised, other, other)).void_reason,
                HasSubstr("it was not recorded as an exam"));
    EXPECT_FALSE(mastered(anna));
    again.header.started_utc = db::utc_now();
    again.header.mode = "exam";
    const std::string fresh = begun_order().dump();
    const int64_t right = take_with_order(again, fresh, fresh);
    EXPECT_TRUE(db::counts(record(right))) << record(right).void_reason;
}

TEST_F(Evidence, AProctorIsAnEducatorOrAdministratorWhoIsNotExamined) {
    const int64_t teacher = store->accounts().create(
        {"teacher", "Teacher", "long enough 1",
         static_cast<db::Roles>(db::Role::kEducator) | static_cast<db::Roles>(db::Role::kTrainee),
         true});
    assign_exam(*store, teacher);
    int second = 0;
    const auto taken = [&](int64_t user, const std::string& proctor) {
        Recording recording = honest_attempt();
        recording.header.started_utc = "2026-02-01T00:01:0" + std::to_string(second++) + "Z";
        return record(take(user, recording, proctor));
    };
    for (const char* nobody : {"Ewa", "jan", "Dr Nobody", "user 1", " "}) {
        const db::AttemptRecord kept = taken(anna, nobody);
        EXPECT_FALSE(db::counts(kept)) << nobody;
        EXPECT_THAT(kept.void_reason, HasSubstr("the proctor is the person examined, or neither "
                                                "educator nor administrator here"));
    }
    EXPECT_FALSE(db::counts(taken(teacher, "teacher"))) << "the own";
    const db::AttemptRecord right = taken(teacher, "nina");
    EXPECT_TRUE(db::counts(right)) << right.void_reason;
    EXPECT_EQ(right.exam.proctor, "Dr nina") << "by name, kept by number";
    EXPECT_TRUE(db::counts(taken(anna, "Dr nina"))) << "a name is as good as a log-in";
}

TEST_F(Evidence, WhatWasNotRecordedIsNoExam) {
    db::AttemptResult result = db::judged(*store, honest_attempt());
    result.exam = {"short", 1, "final", "nina", ""};
    const int64_t id = store->attempts().save(anna, result);
    EXPECT_EQ(record(id).void_reason, "Practice, not verified: nothing was recorded");
    EXPECT_FALSE(db::counts(record(id)));
    EXPECT_FALSE(mastered(anna));
    result.exam = {};
    EXPECT_TRUE(db::counts(record(store->attempts().save(anna, result)))) << "practice is";
}

TEST_F(Evidence, PracticeCountsAndMayBeSimulatedAgainAtNight) {
    const auto practised = [&](const Recording& recording, bool recorded) {
        db::AttemptResult result = db::judged(*store, recording);
        if (recorded) result.recording_file = write(recording);
        return store->attempts().save(anna, result);
    };
    Recording broken = honest_attempt();
    broken.end.reason = sim::EndReason::kInterrupted;
    const int64_t honest = practised(honest_attempt(), true);
    (void)practised(honest_attempt(), false);
    (void)practised(broken, true);
    (void)take(jan, honest_attempt());
    Recording forged = honest_attempt();
    forged.header.started_utc = "2026-02-02T00:00:00Z";
    for (auto& sample : forged.samples) sample.tools[0].tip_m = forged.samples[0].tools[0].tip_m;
    const int64_t steady = practised(forged, true);
    EXPECT_TRUE(store->attempts().waiting_for_replay().empty()) << "nobody has to wait";
    EXPECT_TRUE(db::counts(record(honest)) && db::counts(record(steady)));
    EXPECT_THAT(store->attempts().never_replayed(), testing::ElementsAre(honest, steady));
    for (const int64_t id : store->attempts().never_replayed())
        (void)db::verify_attempt(*store, id);
    EXPECT_THAT(store->attempts().never_replayed(), testing::IsEmpty());
    EXPECT_EQ(record(honest).replay, db::ReplayState::kIdentical);
    EXPECT_TRUE(db::counts(record(honest)));
    EXPECT_FALSE(db::counts(record(steady))) << "what was found out counts no more";
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

/// Saved as an exam, not simulated again yet.
int64_t waiting(db::Store& store, int64_t user, const Recording& recording,
                const std::string& file) {
    db::AttemptResult result = db::judged(store, recording);
    result.recording_file = file;
    result.exam = {"short", 1, "final", "nina", ""};
    return store.attempts().save(user, result);
}

// Whoever writes rows writes points, too: what counts is what the recording gives.
TEST_F(Evidence, WhatTheStoreHoldsOfAnAttemptIsComparedWithItsRecording) {
    constexpr std::pair<const char*, const char*> kEdits[]{
        {"UPDATE attempts SET points = 100", "points 100.000000, not "},
        {"UPDATE attempts SET points = points + 0.001", "points "},
        {"UPDATE attempts SET verdict = 2", "verdict \"failed\", not "},
        {"UPDATE attempts SET rubric_version = 99", "rubric_version 99, not "},
        {"UPDATE attempts SET rubric_id = 'easy'", "rubric_id \"easy\", not "},
        {"UPDATE attempts SET metric_set_version = 99", "metric_set_version 99, not "},
        {"UPDATE attempts SET preprocessing_version = 99", "preprocessing_version 99, not "},
        {"UPDATE attempts SET started_utc = '2020-01-01T00:00:00Z'", "started_utc "},
        {"UPDATE attempts SET seed = '4'", "seed 4, not 3"},
        {"UPDATE attempts SET device = 'mouse'", "device \"mouse\", not "},
        {"UPDATE attempts SET duration_s = 1", "duration_s "},
        {"UPDATE attempts SET demonstration = 0", "demonstration 0, not 1"},
        {"UPDATE attempts SET task_id = 'diathermy_ring'", "task_id "},
        {"UPDATE attempts SET final_hash = '7'", "final_hash"},
        {"UPDATE attempt_metrics SET value = value + 1 WHERE position = 2",
         "attempt_metrics, position 2"},
        {"DELETE FROM attempt_metrics WHERE position = 3", "attempt_metrics, position 3"},
        {"UPDATE attempt_reasons SET points = 0 WHERE position = 0", "attempt_reasons, position 0"},
        {"DELETE FROM attempt_events WHERE position = 0", "attempt_events, position 0"}};
    int second = 0;
    for (const auto& [edit, named] : kEdits) {
        Recording recording = honest_attempt();
        recording.header.started_utc = "2026-02-01T00:02:" + std::to_string(10 + second++) + "Z";
        const int64_t id = waiting(*store, anna, recording, write(recording));
        const bool of_attempts = std::string(edit).find(" attempts ") != std::string::npos;
        RawConnection pen("QSQLITE", folder.file("placode.db"));
        ASSERT_TRUE(
            pen.run(std::string(edit) +
                    (std::string(edit).find("WHERE") == std::string::npos ? " WHERE " : " AND ") +
                    (of_attempts ? "id = " : "attempt_id = ") + std::to_string(id)))
            << edit << pen.problem();
        const auto verdict = db::verify_attempt(*store, id);
        ASSERT_TRUE(verdict) << edit;
        EXPECT_FALSE(verdict->identical) << edit;
        EXPECT_THAT(verdict->difference.english(),
                    HasSubstr("the store holds something else than the recording"));
        EXPECT_THAT(record(id).void_reason, HasSubstr(named)) << edit;
        EXPECT_FALSE(db::counts(record(id))) << edit;
    }
    EXPECT_FALSE(mastered(anna));
}

TEST_F(Evidence, WhoSignedARecordingAndWhoseItIsAreAskedAgain) {
    const std::string own = qgetenv("PLACODE_STATION_KEY").toStdString();
    Recording foreign = honest_attempt();
    foreign.header.started_utc = "2026-02-01T00:03:00Z";
    ::setenv("PLACODE_STATION_KEY", folder.file("foreign.key").c_str(), 1);
    const std::string file = write(foreign);
    own.empty() ? ::unsetenv("PLACODE_STATION_KEY")
                : ::setenv("PLACODE_STATION_KEY", own.c_str(), 1);
    const int64_t unsigned_one = waiting(*store, anna, foreign, file);
    const std::string twice = write(honest_attempt());
    (void)waiting(*store, anna, honest_attempt(), twice);
    const int64_t second = waiting(*store, jan, honest_attempt(), twice);
    RawConnection pen("QSQLITE", folder.file("placode.db"));
    for (const auto& [id, why] :
         {std::pair(unsigned_one, "no computer of this store signed its recording"),
          std::pair(second, "its recording is that of attempt")}) {
        EXPECT_FALSE(record(id).void_reason.empty()) << "or this proves nothing";
        ASSERT_TRUE(
            pen.run("UPDATE attempts SET void_reason = '', void_meaning = '', replay = 1 "
                    "WHERE id = " +
                    std::to_string(id)));
        EXPECT_FALSE(db::verify_attempt(*store, id)->identical);
        EXPECT_THAT(record(id).void_reason, HasSubstr(why));
    }
    EXPECT_FALSE(mastered(jan));
}

TEST_F(Evidence, OneForgedRecordingKeepsNobodyFromBeingRescored) {
    Recording forged = honest_attempt();
    sim::SplitMix64 random(1);
    forgeries_of_the_task().front().make(forged, random);
    forged.header.started_utc = "2026-02-02T00:00:00Z";
    const int64_t first = take(jan, forged), honest = take(anna, honest_attempt());
    const auto rescored = [&](const curriculum::Task& task) {
        const auto outcomes = db::rescore(*store, task, {});
        const auto found = std::ranges::find(outcomes, honest, &db::RescoreOutcome::attempt_id);
        EXPECT_EQ(outcomes.size(), 2u);
        return found == outcomes.end() ? db::RescoreState::kUnreadable : found->state;
    };
    EXPECT_EQ(rescored(curriculum::load_task(kTask)), db::RescoreState::kAlreadyThere);
    auto next = nlohmann::json::parse(honest_attempt().header.task_json);
    next["rubric"]["version"] = next["rubric"]["version"].get<int>() + 1;
    EXPECT_EQ(rescored(curriculum::load_task_text(next.dump(), "next")),
              db::RescoreState::kRescored);
    EXPECT_FALSE(db::counts(record(first)));
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
    Recording own = honest_attempt();
    own.header.started_utc = "2026-02-02T00:00:00Z";
    const int64_t later = waiting(*store, jan, own, write(own));
    EXPECT_THAT(store->attempts().waiting_for_replay(), testing::ElementsAre(later, id))
        << "it keeps nobody waiting who need not";
}

// After an update all that waits for the build before is left behind: a night must not go by with
// reading it again.
TEST_F(Evidence, WhatAnotherBuildRecordedIsReadOnceByEachVersion) {
    const auto practised = [&](const std::string& second, const std::string& build) {
        Recording recording = honest_attempt();
        recording.header.started_utc = "2026-02-01T00:04:0" + second + "Z";
        if (!build.empty()) recording.header.build = build;
        db::AttemptResult result = db::judged(*store, recording);
        result.recording_file = write(recording);
        return store->attempts().save(anna, result);
    };
    std::vector<int64_t> others;
    for (const char* second : {"1", "2", "3"})
        others.push_back(practised(second, "placode 0.1 NEON"));
    const int64_t own = practised("4", "");
    EXPECT_THAT(store->attempts().never_replayed(),
                testing::ElementsAre(own, others[0], others[1], others[2]));
    RawConnection pen("QSQLITE", folder.file("placode.db"));
    ASSERT_TRUE(
        pen.run("UPDATE attempts SET device = 'mouse' WHERE id = " + std::to_string(others[2])));
    for (const int64_t id : store->attempts().never_replayed())
        (void)db::verify_attempt(*store, id);
    EXPECT_EQ(record(own).replay, db::ReplayState::kIdentical);
    EXPECT_EQ(record(others[2]).replay, db::ReplayState::kDiffers) << "every build reads that";
    EXPECT_THAT(store->attempts().never_replayed(), testing::ElementsAre(others[0], others[1]));
    // Whoever reads them again cannot but say so.
    ASSERT_TRUE(pen.run("UPDATE recordings SET content = x'00'"));
    for (const int64_t id : store->attempts().never_replayed()) {
        EXPECT_FALSE(db::verify_attempt(*store, id)) << "the second night";
        EXPECT_EQ(record(id).replay, db::ReplayState::kNotReplayed);
    }
    ASSERT_TRUE(pen.run("UPDATE attempts SET read_by = 'placode 0.0'"));
    EXPECT_FALSE(db::verify_attempt(*store, others[0])->identical) << "another version reads anew";
}

/// Data folder of somebody's own for as long as this lives.
class OwnData {
 public:
    explicit OwnData(const TemporaryFolder& folder) : path_(folder.file("mine")) {
        fs::copy(curriculum::data_folder(), path_, fs::copy_options::recursive);
        ::setenv("PLACODE_DATA", path_.c_str(), 1);
    }
    ~OwnData() { ::unsetenv("PLACODE_DATA"); }
    OwnData(const OwnData&) = delete;
    OwnData& operator=(const OwnData&) = delete;

    /// Changes a definition in it; its text then.
    template <class Change>
    nlohmann::json change(const std::string& name, Change change) {
        const std::string file = path_ + "/" + name + ".json";
        std::ifstream in(file);
        nlohmann::json json = nlohmann::json::parse(in);
        change(json);
        fs::remove(file);
        std::ofstream(file) << json.dump();
        return json;
    }

 private:
    std::string path_;
};

db::DefinitionRecord definition_of(const std::string& kind, const std::string& id, int version,
                                   const std::string& json) {
    db::DefinitionRecord definition;
    definition.kind = kind;
    definition.id = id;
    definition.version = version;
    definition.json = json;
    definition.reason = "mine";
    return definition;
}

TEST_F(Evidence, NobodyMakesATaskOfficialByPuttingItIntoAFolder) {
    OwnData mine(folder);
    for (const int version : {curriculum::load_task(kTask).version, 999}) {
        SCOPED_TRACE(version);
        // Whatever is done passes.
        mine.change(std::string("tasks/") + kTask, [version](nlohmann::json& task) {
            task["version"] = version;
            task["rubric"]["pass_points"] = 1;
        });
        const curriculum::Task own = curriculum::load_task(kTask);
        Recording recording = honest_attempt();
        recording.header.task_version = version;
        recording.header.task_json = own.json;
        recording.header.started_utc = "2026-02-01T00:00:0" + std::to_string(version % 10) + "Z";
        {
            const auto trainee = db::open_store(store->url());
            trainee->act_for(anna);
            db::publish_task_on_first_use(*trainee, kTask, version);
            EXPECT_THROW(
                trainee->definitions().publish(definition_of("task", kTask, version, own.json)),
                db::StoreError);
        }
        const db::AttemptRecord kept = record(take(anna, recording));
        EXPECT_FALSE(db::counts(kept)) << kept.void_reason;
        EXPECT_FALSE(mastered(anna));
    }
    db::publish_task_on_first_use(*store, kTask, 999);
    EXPECT_FALSE(store->definitions().find("task", kTask, 999)) << "nor does the program";
}

TEST_F(Evidence, NorACourseOrAQuestionnaire) {
    OwnData mine(folder);
    const std::string course = mine.change("courses/full_dissection",
                                           [](nlohmann::json& json) {
                                               json["version"] = 999;
                                               json["stages"] =
                                                   nlohmann::json::parse(kCourse)["stages"];
                                           })
                                   .dump();
    const std::string form =
        mine.change("questionnaires/sus", [](nlohmann::json& json) { json["version"] = 999; })
            .dump();
    const auto trainee = db::open_store(store->url());
    trainee->act_for(anna);
    EXPECT_THROW(
        trainee->definitions().publish(definition_of("course", "full_dissection", 999, course)),
        db::StoreError);
    EXPECT_THROW(trainee->definitions().publish(definition_of("questionnaire", "sus", 999, form)),
                 db::StoreError);
    EXPECT_LT(db::find_course(*trainee, "full_dissection").version, 999);
    try {
        (void)db::find_course(*trainee, "of_mine");
        FAIL() << "there is none";
    } catch (const curriculum::DefinitionError& error) {
        EXPECT_THAT(error.what(), HasSubstr("placodectl course publish FILE"));
    }
}

/// What the program carries is what a folder of it holds, scenes that extend others included.
TEST(ShippedDefinitions, AreThoseOfTheSource) {
    for (const char* kind : {"tasks", "scenes", "courses", "questionnaires"})
        EXPECT_EQ(curriculum::shipped_ids(kind), curriculum::list_definitions(kind)) << kind;
    for (const std::string& id : curriculum::shipped_ids("tasks"))
        EXPECT_EQ(curriculum::shipped_task(id)->json, curriculum::load_task(id).json) << id;
    for (const std::string& id : curriculum::shipped_ids("courses"))
        EXPECT_EQ(curriculum::shipped_text("courses", id), curriculum::load_course(id).json) << id;
    for (const std::string& id : curriculum::shipped_ids("questionnaires"))
        EXPECT_EQ(curriculum::shipped_text("questionnaires", id),
                  curriculum::load_questionnaire(id).json)
            << id;
    EXPECT_FALSE(curriculum::shipped_task("none"));
}

}  // namespace THIS_TEST
