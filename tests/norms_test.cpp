// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Norm packs, the quality panel and further scores in the store, on both engines.

#include "db/norm_bands.h"

#include <gmock/gmock.h>

#include <cmath>

#include "db/signature.h"
#include "tests/store_fixture.h"

using namespace placode;
using namespace placode::test;
using db::StoreError;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

namespace THIS_TEST {

World* const world = World::install();
constexpr const char* kDay = "2026-01-31T00:00:00Z";

class Norms : public EngineTest {
 protected:
    void ready() override { store = open(); }
    int64_t person(const std::string& login) const {
        return store->accounts().create(
            {login, login, "long enough 1", static_cast<db::Roles>(db::Role::kTrainee), false});
    }
    int64_t attempt(int64_t user, double points, double time_s, int metric_set = 2,
                    sim::EndReason end = sim::EndReason::kFinished, int task_version = 1,
                    int rubric_version = 0) const {
        db::AttemptResult result;
        result.header.task_id = "diathermy_ring";
        result.header.task_version = task_version;
        result.header.started_utc = "2026-01-01T00:00:00Z";
        result.end.reason = end;
        result.metrics.version = metric_set;
        result.metrics.values = {{"task_time_s", time_s}, {"placode_contacts", 1}};
        result.score.points = points;
        result.score.rubric_id = "ring";
        result.score.rubric_version = rubric_version;
        const int64_t id = store->attempts().save(user, result);
        if (replayed) store->attempts().set_replay(id, db::ReplayState::kIdentical);
        return id;
    }
    /// `n` persons, two attempts each, about `points` and `time_s`.
    std::vector<int64_t> level(const std::string& name, int n, double points, double time_s) const {
        std::vector<int64_t> people;
        for (int i = 0; i < n; ++i) {
            people.push_back(person(name + std::to_string(i)));
            for (const double jitter : {-0.5, 0.5})
                attempt(people.back(), points + 2 * i + (i % 2 ? jitter : -jitter),
                        time_s + 3 * i + (i % 2 ? jitter : -jitter));
        }
        return people;
    }

    std::unique_ptr<db::Store> store;
    bool replayed = true;  ///< Attempts were simulated again.
};

INSTANTIATE_TEST_SUITE_P(Engines, Norms, testing::Values("Sqlite", "Postgresql"), engine_name);

TEST_P(Norms, BandsAreOfThePersonsMeansAndNameNobody) {
    const auto experts = level("secret-name", 5, 80, 100);
    const auto levels = db::level_attempts(*store, "diathermy_ring", {{"expert", experts}});
    ASSERT_EQ(levels.size(), 1u);
    EXPECT_EQ(levels[0].attempts(), 10);
    const auto pack = db::make_norms(levels, "Centre A", kDay, 5);
    const curriculum::NormGroup* group = pack.group("expert");
    ASSERT_NE(group, nullptr);
    EXPECT_EQ(group->persons, 5);
    // Means 80, 82, 84, 86, 88: mean 84, sample SD sqrt(10).
    EXPECT_DOUBLE_EQ(group->metric("points")->band.mean, 84);
    EXPECT_DOUBLE_EQ(group->metric("points")->band.sd, std::sqrt(10.0));
    EXPECT_TRUE(group->metric("task_time_s")->band.log);
    EXPECT_DOUBLE_EQ(group->metric("task_time_s")->band.q50, 106);
    const std::string text = curriculum::norm_pack_text(pack);
    EXPECT_THAT(text, Not(HasSubstr("secret-name")));
    EXPECT_EQ(curriculum::norm_pack_text(curriculum::load_norm_pack(text, "x")), text);
}

TEST_P(Norms, ASmallGroupIsNeverMadeIntoABand) {
    const auto four = level("e", 4, 80, 100);
    const auto levels = db::level_attempts(*store, "diathermy_ring", {{"expert", four}});
    for (const int least : {0, 5})
        EXPECT_THAT(failure_of([&] { (void)db::make_norms(levels, "A", kDay, least); }).what(),
                    HasSubstr("has 4 persons"));
    EXPECT_EQ(failure_of([&] { (void)db::make_norms({}, "A", kDay, 5); }).kind(),
              StoreError::Kind::kRefused);
    // Also not when somebody writes a file by hand.
    auto text = curriculum::norm_pack_text(
        db::make_norms(db::level_attempts(*store, "diathermy_ring", {{"x", level("f", 5, 80, 90)}}),
                       "A", kDay, 5));
    text.replace(text.find("\"persons\": 5"), 12, "\"persons\": 4");
    EXPECT_THROW((void)curriculum::load_norm_pack(text, "x"), curriculum::DefinitionError);
}

TEST_P(Norms, WhatWasNotSimulatedAgainIsNobodysNorm) {
    auto people = level("e", 5, 80, 100);
    replayed = false;
    attempt(people[2], 99, 1);
    EXPECT_THAT(failure_of([&] {
                    (void)db::make_norms(
                        db::level_attempts(*store, "diathermy_ring", {{"expert", people}}), "A",
                        kDay, 5);
                }).what(),
                HasSubstr("norms: 1 of 11 attempts were never simulated again; let `placodectl "
                          "verify --all` do that first"));
}

TEST_P(Norms, APackIsOfOneVersionOfTheTaskAndOfItsRubric) {
    const auto people = level("e", 5, 80, 100);
    const auto refused = [&](const std::vector<int64_t>& who) {
        return std::string(failure_of([&] {
                               (void)db::make_norms(
                                   db::level_attempts(*store, "diathermy_ring", {{"expert", who}}),
                                   "A", kDay, 5);
                           }).what());
    };
    auto other_task = people, other_rubric = people;
    other_task.push_back(person("other1"));
    attempt(other_task.back(), 80, 100, 2, sim::EndReason::kFinished, 2);
    other_rubric.push_back(person("other2"));
    attempt(other_rubric.back(), 80, 100, 2, sim::EndReason::kFinished, 1, 1);
    for (const auto& who : {other_task, other_rubric})
        EXPECT_THAT(refused(who), HasSubstr("norms: the attempts are of different versions of the "
                                            "task or of its rubric"));
}

TEST_P(Norms, OnlyAttemptsThatCanBeComparedAreUsed) {
    const auto people = level("e", 5, 80, 100);
    attempt(people[0], 5, 1, 1);                                // An older metric set.
    attempt(people[1], 5, 1, 2, sim::EndReason::kInterrupted);  // Interrupted.
    const auto levels = db::level_attempts(*store, "diathermy_ring", {{"expert", people}});
    EXPECT_EQ(levels[0].attempts(), 10);
    EXPECT_EQ(levels[0].left_out, 1);
    EXPECT_THAT(db::level_attempts(*store, "grasp_and_lift", {{"expert", people}})[0].by_person,
                IsEmpty());
}

TEST_P(Norms, APackIsSignedKeptOnceAndUsedForItsTask) {
    const auto pack = db::make_norms(
        db::level_attempts(*store, "diathermy_ring", {{"expert", level("e", 5, 80, 100)}}), "A",
        kDay, 5);
    const int64_t id = db::keep_own_norms(*store, pack, kPassphrase);
    EXPECT_EQ(db::keep_own_norms(*store, pack, kPassphrase), id)
        << "Ed25519 signs the same text the same way";
    const auto record = store->norms().list("diathermy_ring").at(0);
    EXPECT_TRUE(db::signature_is_right(record.norms.content, record.norms.signature,
                                       record.norms.public_key));
    EXPECT_FALSE(db::norms_in_use(*store, "diathermy_ring"));
    store->norms().use(id);
    ASSERT_TRUE(db::norms_in_use(*store, "diathermy_ring"));
    auto later = pack;
    later.made_utc = "2026-02-01";
    const int64_t other = db::keep_own_norms(*store, later, kPassphrase);
    store->norms().use(other);
    EXPECT_EQ(db::norms_in_use(*store, "diathermy_ring")->id, other) << "one at a time";
    EXPECT_THAT(store->norms().list("grasp_and_lift"), IsEmpty());
    EXPECT_EQ(failure_of([&] { store->norms().use(99); }).kind(), StoreError::Kind::kNotFound);
}

TEST_P(Norms, AChangedOrUntrustedPackIsRefused) {
    const auto pack = db::make_norms(
        db::level_attempts(*store, "diathermy_ring", {{"expert", level("e", 5, 80, 100)}}), "B",
        kDay, 5);
    const db::KeyPair foreign = db::new_key_pair();
    curriculum::SignedNorms norms;
    norms.content = curriculum::norm_pack_text(pack);
    norms.signature = db::sign_text(norms.content, foreign.secret_key);
    norms.public_key = foreign.public_key;
    EXPECT_THAT(failure_of([&] { store->norms().save(norms); }).what(), HasSubstr("not trusted"));
    store->norms().trust_centre(foreign.public_key, "B");
    auto changed = norms;
    changed.content.replace(changed.content.find("\"centre\": \"B\""), 13, "\"centre\": \"C\"");
    EXPECT_THAT(failure_of([&] { store->norms().save(changed); }).what(),
                HasSubstr("changed after"));
    auto swapped = norms;
    swapped.public_key = db::new_key_pair().public_key;
    EXPECT_THAT(failure_of([&] { store->norms().save(swapped); }).what(),
                HasSubstr("changed after"));
    // One that is trusted does not speak for another one.
    auto posing = pack;
    posing.centre = "University hospital A";
    curriculum::SignedNorms theirs;
    theirs.content = curriculum::norm_pack_text(posing);
    theirs.signature = db::sign_text(theirs.content, foreign.secret_key);
    theirs.public_key = foreign.public_key;
    const auto refused = failure_of([&] { store->norms().save(theirs); });
    EXPECT_EQ(refused.kind(), StoreError::Kind::kRefused);
    EXPECT_THAT(refused.what(), HasSubstr("says to be of \"University hospital A\""));
    EXPECT_THAT(refused.what(), HasSubstr("as that of \"B\""));
    EXPECT_THAT(store->norms().list(""), IsEmpty());
    EXPECT_GT(store->norms().save(norms), 0);
}

TEST_P(Norms, AnAttemptIsScoredAgainstTheBand) {
    const auto people = level("e", 5, 80, 100);
    const auto pack = db::make_norms(
        db::level_attempts(*store, "diathermy_ring", {{"expert", people}}), "A", kDay, 5);
    const auto mine = store->norms().measured_attempts(people[0], "diathermy_ring").at(0);
    EXPECT_EQ(mine.metrics.values.size(), 2u);
    const auto compared = db::compare_with_band(mine, pack.groups[0]);
    ASSERT_EQ(compared.size(), 3u);
    EXPECT_EQ(compared[0].metric, "points");
    EXPECT_NEAR(*compared[0].z, (80.5 - 84) / std::sqrt(10.0), 1e-12);
    EXPECT_NEAR(*compared[0].score, 100 * (*compared[0].z + 4) / 4, 1e-12);
    EXPECT_GT(*compared[1].z, 0) << "quicker than the experts' mean";
    EXPECT_FALSE(compared[2].z) << "everybody touched the placode once";
}

TEST_P(Norms, ThePanelSaysWhichMetricHasEvidence) {
    const auto levels = db::level_attempts(
        *store, "diathermy_ring",
        {{"expert", level("e", 5, 80, 100)}, {"novice", level("n", 5, 30, 300)}});
    const auto panel = db::metric_panel(levels[1], levels[0], 2);
    ASSERT_EQ(panel.size(), 3u);
    EXPECT_EQ(panel[0].metric, "points");
    EXPECT_TRUE(panel[0].evidence) << panel[0].why;
    EXPECT_EQ(panel[1].metric, "task_time_s");
    EXPECT_GT(*panel[1].g, 0) << "less time is better";
    EXPECT_FALSE(panel[2].evidence) << "always 1";
}

TEST_P(Norms, AFurtherScoreIsKeptBesideTheFirstOne) {
    const int64_t id = attempt(person("anna"), 40, 100);
    db::RescoreRecord record;
    record.attempt_id = id;
    record.score.points = 55;
    record.score.verdict = assessment::Verdict::kFailed;
    record.score.rubric_id = "ring";
    record.score.rubric_version = 2;
    record.score.reasons = {
        {"late", "Late.", 45, 3, true, {"Late, {value}.", "Późno.", "time_s", 1e300, 2, 12}}};
    record.metrics.values = {{"task_time_s", 101}};
    store->attempts().save_rescore(record);
    EXPECT_EQ(failure_of([&] { store->attempts().save_rescore(record); }).kind(),
              StoreError::Kind::kConflict);
    EXPECT_DOUBLE_EQ(store->attempts().detail(id).score.points, 40) << "the first one stays";
    const auto further = store->attempts().rescores(id);
    ASSERT_EQ(further.size(), 1u);
    EXPECT_DOUBLE_EQ(further[0].score.points, 55);
    EXPECT_EQ(further[0].score.verdict, assessment::Verdict::kFailed);
    EXPECT_EQ(further[0].score.rubric_version, 2);
    EXPECT_EQ(further[0].score.reasons.at(0).text, "Late.");
    EXPECT_EQ(further[0].score.reasons[0].meaning, record.score.reasons[0].meaning);
    EXPECT_DOUBLE_EQ(*further[0].metrics.find("task_time_s"), 101);
    EXPECT_EQ(further[0].preprocessing_version, 1);
    record.attempt_id = 99;
    EXPECT_EQ(failure_of([&] { store->attempts().save_rescore(record); }).kind(),
              StoreError::Kind::kNotFound);
}

}  // namespace THIS_TEST
