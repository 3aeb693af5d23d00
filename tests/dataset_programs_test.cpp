// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// `placodectl dataset`: what it writes is what was recorded, and only of those who agreed.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "batches/items.h"
#include "curriculum/study.h"
#include "db/consent.h"
#include "db/recording_file.h"
#include "db/study_conduct.h"
#include "environment/policy.h"
#include "reports/demonstrations.h"
#include "reports/report.h"
#include "tests/environment_fixture.h"
#include "tests/programs_fixture.h"
#include "tests/stopped_program.h"

namespace placode::test {
namespace THIS_TEST {

using reports::Hdf5File;
using testing::HasSubstr;

/// A second of an operator, in steps of 20 frames, and the actions that it chose.
struct Episode {
    sim::Recording recording;
    std::vector<double> actions;
};

Episode episode(const std::string& policy_name, uint64_t seed, const char* task = "touch_targets") {
    static const auto fields = std::make_shared<environment::FieldCache>();
    environment::EnvironmentOptions options = coarse();
    options.units = environment::policy_units(policy_name);
    options.time_limit_s = 1;
    options.fields = 0;  // a lesion for every seed
    options.record = true;
    environment::Environment environment(fields, task, options);
    environment.reset(seed);
    environment::Policy policy(policy_name, environment, seed);
    Episode made;
    std::vector<double> action(environment.tools() * environment::kActionSize);
    while (!environment.ended()) {
        const bool done = policy.act(environment, 20, action);
        made.actions.insert(made.actions.end(), action.begin(), action.end());
        (void)environment.step(action, 20, done);
    }
    made.recording = environment.recording();
    return made;
}

/// Four people with two attempts each; the second did not agree to give data away.
std::vector<std::string> fill_study(db::Store& store, const std::string& scratch_file) {
    std::vector<std::string> codes;
    const curriculum::StudyProtocol protocol = curriculum::load_study("face_content_validity");
    std::string text = protocol.json;
    const size_t at = text.find("\"id\": \"data\",");
    EXPECT_NE(at, std::string::npos);
    text.insert(at, "\"required\": false, ");
    db::DefinitionRecord study;
    study.kind = "study";
    study.id = "face_content_validity";
    study.version = protocol.version;
    study.json = text;
    store.definitions().publish(study);
    const int64_t anybody =
        store.accounts().create({"anna", "Anna Nowak", "correct horse", 1, true});
    for (int i = 0; i < 4; ++i) {
        codes.push_back(store.studies().new_participant("face_content_validity"));
        std::vector<std::string> agreed{"read", "voluntary"};
        if (i != 1) agreed.emplace_back("data");
        db::record_consent(store, "face_content_validity", codes.back(), "en", agreed);
        for (int attempt = 0; attempt < 2; ++attempt) {
            db::AttemptResult result;
            Episode made = episode("random", static_cast<uint64_t>(10 * i + attempt + 1));
            made.recording.header.demonstration = false;
            made.recording.header.started_utc = "2026-11-21T10:05:00.000Z";
            result.header = made.recording.header;
            result.end = made.recording.end;
            result.recording_file = scratch_file;
            batches::write_recording(made.recording, result.recording_file);
            result.study = {"face_content_validity", codes.back()};
            db::StepRecord step;
            step.study_id = "face_content_validity";
            step.participant = codes.back();
            step.step = "procedure_" + std::to_string(attempt + 1);
            step.attempt_id = store.attempts().save(anybody, result);
            store.studies().record_step(step);
            store.attempts().set_replay(step.attempt_id, db::ReplayState::kIdentical);
        }
    }
    return codes;
}

class DatasetPrograms : public Programs {
 protected:
    void SetUp() override {
        Programs::SetUp();
        fs::create_directory(file("in"));
    }
    void keep(const sim::Recording& recording, const std::string& name) const {
        batches::write_recording(recording, file("in/" + name + ".placode"));
    }
    [[nodiscard]] Outcome dataset(const std::string& arguments) const {
        return ctl("dataset " + arguments);
    }
};

TEST_F(DatasetPrograms, TheArraysAreWhatWasSeenAndDone) {
    const Episode expert = episode("expert", 1);
    keep(expert.recording, "a");
    for (uint64_t seed = 2; seed <= 5; ++seed)
        keep(episode("random", seed).recording, "b" + std::to_string(seed));
    const Outcome made =
        dataset("--recordings in --out set --licence 'CC BY 4.0' --split 60,20,20");
    ASSERT_EQ(made.status, 0) << made.err;
    const Hdf5File data(file("set/touch_targets.hdf5"), Hdf5File::Open::kRead);
    const reports::Matrix actions = data.matrix("data/demo_0/actions");
    ASSERT_EQ(actions.rows, 50U);
    ASSERT_EQ(actions.values.size(), expert.actions.size());
    // Where a hand reaches what it wants within the step, the action is the wish itself.
    const size_t columns = actions.columns;
    const auto names = reports::demonstration_action_names(columns / 8);
    for (size_t row = 10; row < 50; ++row)
        for (size_t k = 0; k < 5; ++k)
            EXPECT_NEAR(actions.values[row * columns + k], expert.actions[row * columns + k], 2e-6)
                << names[k] << " in step " << row;
    const reports::Matrix seen = data.matrix("data/demo_0/obs/state");
    const reports::Matrix next = data.matrix("data/demo_0/next_obs/state");
    ASSERT_EQ(seen.columns, reports::demonstration_names(columns / 8).size());
    EXPECT_NEAR(seen.values[10 * seen.columns], 0.2, 1e-9) << "time_s of the eleventh step";
    EXPECT_TRUE(std::equal(seen.values.begin() + static_cast<long>(seen.columns), seen.values.end(),
                           next.values.begin()))
        << "what is seen after a step is what is seen before the next one";
    const size_t x = 6;  // tool0.tip_x_mm
    EXPECT_NEAR(next.values[49 * next.columns + x],
                1000.0 * static_cast<double>(expert.recording.samples[99].tools[0].tip_m[0]), 1e-9);
    const auto rewards = data.matrix("data/demo_0/rewards").values;
    EXPECT_EQ(std::count(rewards.begin(), rewards.end(), 0.0), 50 - (rewards.back() != 0 ? 1 : 0));
    EXPECT_EQ(data.matrix("data/demo_0/dones").values.back(), 1);

    EXPECT_EQ(shell("sha256sum --strict --quiet -c set/SHA256SUMS").status, 1);  // elsewhere
    EXPECT_EQ(shell("sh -c 'cd set && sha256sum --strict --quiet -c SHA256SUMS'").status, 0);
    EXPECT_THAT(read_text(file("set/DATASHEET.md")), HasSubstr("| touch_targets | 5 | 0 | 250 |"));
    EXPECT_THAT(read_text(file("set/LICENCE.txt")), HasSubstr("CC BY 4.0"));
    const auto kept = db::read_recording_file(file("set/recordings/touch_targets-demo_0.placode"));
    EXPECT_EQ(kept.end.final_hash, expert.recording.end.final_hash);
    // A folder that holds something is left alone.
    EXPECT_THAT(dataset("--recordings in --out set").err, HasSubstr("expected an empty folder"));
}

TEST_F(DatasetPrograms, PythonReadsItBack) {
    if (shell("/usr/bin/python3 -c 'import h5py'").status != 0)
        GTEST_SKIP() << "python3-h5py is not installed";
    for (uint64_t seed = 1; seed <= 5; ++seed)
        keep(episode("random", seed).recording, "b" + std::to_string(seed));
    keep(episode("nothing", 1, "trace_contour").recording, "c");
    ASSERT_EQ(dataset("--recordings in --out set --split 60,20,20").status, 0);
    const Outcome read = shell("/usr/bin/python3 set/read_dataset.py set/touch_targets.hdf5");
    EXPECT_EQ(read.status, 0) << read.err;
    EXPECT_THAT(read.out, HasSubstr("\"task\": \"touch_targets\""));
    EXPECT_THAT(read.out, HasSubstr("\"train\": 3"));
    EXPECT_THAT(read.out, HasSubstr("\"valid\": 1"));
    EXPECT_THAT(read.out, HasSubstr("\"test\": 1"));
    EXPECT_EQ(number_in(read.out, "steps"), 250);
    EXPECT_EQ(shell("/usr/bin/python3 set/read_dataset.py set/trace_contour.hdf5").status, 0);
}

TEST_F(DatasetPrograms, OnlyThoseWhoAgreedAreInAStudysDataSet) {
    std::vector<std::string> codes;
    {
        db::StoreOptions options;
        options.cheap_passwords = true;
        const auto opened = db::open_store("sqlite:" + store, options);
        codes = fill_study(*opened, file("in/s.placode"));
        opened->studies().withdraw("face_content_validity", codes[3], db::WithdrawalMode::kStop,
                                   "asked us to");
        EXPECT_TRUE(db::has_agreed(*opened, "face_content_validity", codes[0], "data"));
        EXPECT_FALSE(db::has_agreed(*opened, "face_content_validity", codes[1], "data"));
        EXPECT_TRUE(db::has_agreed(*opened, "face_content_validity", codes[1], "read"));
        EXPECT_FALSE(db::has_agreed(*opened, "face_content_validity", codes[0], "dat"));
        EXPECT_FALSE(db::has_agreed(*opened, "face_content_validity", codes[3], "data"));
    }
    const Outcome made = dataset("--json --study face_content_validity --out set --split 50,50,0");
    ASSERT_EQ(made.status, 0) << made.err;
    EXPECT_EQ(number_in(made.out, "demonstrations"), 4) << "two people with two attempts each";
    EXPECT_EQ(number_in(made.out, "left_out"), 4);
    const std::string sheet = read_text(file("set/DATASHEET.md"));
    EXPECT_THAT(sheet, HasSubstr("4 attempts of 2 people"));
    EXPECT_THAT(sheet, HasSubstr("4 attempts were left out"));
    EXPECT_THAT(sheet, HasSubstr("| 4 | 0 | 200 | 2 | 2 | 0 |"));
    // Nothing that tells who or when.
    for (const auto& one : fs::recursive_directory_iterator(file("set"))) {
        if (!one.is_regular_file()) continue;
        const std::string bytes = read_text(one.path().string());
        for (const std::string& code : codes) EXPECT_EQ(bytes.find(code), std::string::npos);
        EXPECT_EQ(bytes.find("2026-11-21"), std::string::npos) << one.path();
    }
    const auto kept = db::read_recording_file(file("set/recordings/touch_targets-demo_0.placode"));
    EXPECT_EQ(kept.header.started_utc, "");
    // Nobody agreed to what nobody was asked.
    const Outcome none = dataset("--study face_content_validity --out no --statement sell");
    EXPECT_EQ(none.status, 2);
    EXPECT_THAT(none.err, HasSubstr("did not agree to \"sell\""));
    EXPECT_THAT(ctl("audit").out, HasSubstr("export.dataset"));
}

TEST_F(DatasetPrograms, WhatWaitsForItsReplayIsNotGivenAway) {
    db::StoreOptions options;
    options.cheap_passwords = true;
    const auto opened = db::open_store("sqlite:" + store, options);
    const std::vector<std::string> codes = fill_study(*opened, file("in/s.placode"));
    std::vector<int64_t> ids;
    int64_t waits = 0;  // the last one of the first participant
    for (const db::StepRecord& step : opened->studies().steps("face_content_validity")) {
        if (step.attempt_id == 0) continue;
        ids.push_back(step.attempt_id);
        if (step.participant == codes[0]) waits = step.attempt_id;
    }
    ASSERT_EQ(ids.size(), 8U);
    for (const int64_t id : ids) opened->attempts().set_replay(id, db::ReplayState::kWaiting);
    const Outcome none = dataset("--study face_content_validity --out no");
    EXPECT_EQ(none.status, 2);
    EXPECT_THAT(none.err, HasSubstr("6 attempts that do not count, or not before"));
    for (const int64_t id : ids)
        if (id != waits) opened->attempts().set_replay(id, db::ReplayState::kIdentical);
    const Outcome made = dataset("--json --study face_content_validity --out set");
    ASSERT_EQ(made.status, 0) << made.err;
    EXPECT_EQ(number_in(made.out, "demonstrations"), 5);
    EXPECT_EQ(number_in(made.out, "not_counted"), 1);
    EXPECT_EQ(number_in(made.out, "left_out"), 2) << "of who did not agree";
}

TEST_F(DatasetPrograms, AskedToStopOrWithoutAPlaceItWritesNothing) {
    keep(episode("random", 1).recording, "0");
    for (int i = 1; i < 200; ++i)
        fs::create_hard_link(file("in/0.placode"), file("in/" + std::to_string(i) + ".placode"));
    const Outcome ended =
        stopped(folder, {"dataset", "--recordings", "in", "--out", "set"}, SIGINT);
    EXPECT_EQ(ended.status, 1);
    EXPECT_THAT(ended.err, HasSubstr("dataset: stopped; nothing was written"));
    EXPECT_FALSE(fs::exists(file("set")));
    // The place is looked at before the first recording, which cannot be read.
    write_text(file("in/0.placode"), "damaged");
    for (const auto& [out, words] :
         {std::pair{"in", "expected an empty folder"}, std::pair{"in/0.placode", "is no folder"}}) {
        const Outcome refused = dataset("--recordings in --out " + std::string(out));
        EXPECT_EQ(refused.status, 2);
        EXPECT_THAT(refused.err,
                    testing::AllOf(HasSubstr("--out " + std::string(out)), HasSubstr(words)));
    }
}

TEST_F(DatasetPrograms, APersonsRecordingInAFolderIsRefused) {
    sim::Recording recording = episode("random", 1).recording;
    recording.header.demonstration = false;
    keep(recording, "somebody");
    const Outcome refused = dataset("--recordings in --out set");
    EXPECT_EQ(refused.status, 2);
    EXPECT_THAT(refused.err, HasSubstr("somebody.placode: is of a person"));
    EXPECT_FALSE(fs::exists(file("set/touch_targets.hdf5")));
    for (const auto& [order, words] :
         {std::pair{"--out x", "expected one of --recordings FOLDER and --study ID"},
          std::pair{"--out x --recordings in --split 50,20,20", "together 100 %"},
          std::pair{"--out x --recordings in --step 25", "multiple of 10 ms"},
          std::pair{"--out x --recordings nowhere", "nowhere: is no folder"}}) {
        const Outcome bad = dataset(order);
        EXPECT_EQ(bad.status, 2) << order;
        EXPECT_THAT(bad.err, HasSubstr(words)) << order;
    }
}

TEST(DatasetSplit, NobodyIsInTwoParts) {
    std::vector<reports::Demonstration> all;
    for (int person = 0; person < 40; ++person)
        for (int attempt = 0; attempt <= person % 4; ++attempt) {
            all.emplace_back();
            all.back().person = "P" + std::to_string(person);
        }
    const std::vector<int> parts = reports::split_by_person(all, {70, 20, 10}, 1);
    std::map<std::string, std::set<int>> of;
    for (size_t i = 0; i < all.size(); ++i) of[all[i].person].insert(parts[i]);
    std::array<int, 3> people{};
    for (const auto& [person, in] : of) {
        EXPECT_EQ(in.size(), 1U) << person;
        ++people[static_cast<size_t>(*in.begin())];
    }
    EXPECT_THAT(people, testing::ElementsAre(28, 8, 4));
    EXPECT_NE(reports::split_by_person(all, {70, 20, 10}, 2), parts);
    // One person alone is to learn from.
    EXPECT_EQ(reports::split_by_person({all[0]}, {10, 10, 80}, 1), std::vector<int>{0});
}

}  // namespace THIS_TEST
}  // namespace placode::test
