// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/standards.h"

#include "store_fixture.h"

namespace placode::db {
namespace THIS_TEST {

curriculum::PassStandard standard(double points) {
    curriculum::PassStandard one;
    one.task_id = "diathermy_ring_small";
    one.pass_points = points;
    one.novice = {10, 50, 8, 0.05, 0.1};
    one.expert = {11, 90, 6, 0.04, 0};
    return one;
}

class Standards : public testing::Test {
 protected:
    Standards() {
        StoreOptions options;
        options.cheap_passwords = true;
        store_ = open_store("sqlite:" + folder_.file("a.db"), options);
        store_->act_as("ewa");
    }
    test::TemporaryFolder folder_;
    std::unique_ptr<Store> store_;
};

TEST_F(Standards, AreKeptInVersionsWithWhoAndWhy) {
    EXPECT_FALSE(standard_at(*store_, "diathermy_ring_small").has_value());
    EXPECT_EQ(set_standard(*store_, standard(71.5), ""), 1);
    EXPECT_THROW(set_standard(*store_, standard(73), ""), StoreError) << "a change needs a reason";
    EXPECT_EQ(set_standard(*store_, standard(73.25), "more experts"), 2);
    const auto now = standard_at(*store_, "diathermy_ring_small");
    ASSERT_TRUE(now.has_value());
    EXPECT_EQ(now->standard.version, 2);
    EXPECT_DOUBLE_EQ(now->standard.pass_points, 73.25);
    EXPECT_EQ(now->standard.novice.n, 10);
    EXPECT_DOUBLE_EQ(now->standard.expert.theoretical_wrong, 0.04);
    EXPECT_EQ(now->set_by, "ewa");
    EXPECT_EQ(now->reason, "more experts");
    int audited = 0;
    for (const AuditRecord& each : store_->audit().trail(20))
        audited += each.action == "standard.publish" && each.actor == "ewa" ? 1 : 0;
    EXPECT_EQ(audited, 2);
}

TEST_F(Standards, JudgeAnAttemptByTheMarkOfItsDay) {
    const curriculum::Task task = curriculum::load_task("diathermy_ring_small");
    EXPECT_DOUBLE_EQ(rubric_at(*store_, task).pass_points, task.rubric.pass_points);
    set_standard(*store_, standard(81), "");
    EXPECT_DOUBLE_EQ(rubric_at(*store_, task).pass_points, 81);
    EXPECT_DOUBLE_EQ(rubric_at(*store_, task, "2020-01-01T00:00:00Z").pass_points,
                     task.rubric.pass_points)
        << "before the standard was set";
    EXPECT_DOUBLE_EQ(rubric_at(*store_, task, "2999-01-01T00:00:00Z").pass_points, 81);
    EXPECT_EQ(rubric_at(*store_, task).items.size(), task.rubric.items.size());
}

TEST_F(Standards, RefuseAMarkThatIsNone) {
    EXPECT_THROW(set_standard(*store_, standard(101), ""), curriculum::DefinitionError);
    curriculum::PassStandard lonely = standard(70);
    lonely.expert.n = 1;
    EXPECT_THROW(set_standard(*store_, lonely, ""), curriculum::DefinitionError);
    EXPECT_FALSE(standard_at(*store_, "diathermy_ring_small").has_value());
}

TEST_F(Standards, JudgesMaySetTheMarkAsWell) {
    const std::vector<double> weights{60, 40};
    set_standard(*store_,
                 standard_of_judges("diathermy_ring_small",
                                    assessment::angoff({{0.9, 0.5}, {0.8, 0.6}}, weights)),
                 "");
    const auto now = standard_at(*store_, "diathermy_ring_small");
    ASSERT_TRUE(now.has_value());
    EXPECT_EQ(now->standard.method, "angoff");
    EXPECT_NEAR(now->standard.pass_points, (74.0 + 72.0) / 2, 1e-12);
    EXPECT_EQ(now->standard.angoff.judges, 2);
    EXPECT_EQ(now->standard.angoff.items, 2);
    EXPECT_NEAR(now->standard.angoff.se_points, 1, 1e-12);
    EXPECT_THROW(curriculum::load_standard_text(
                     R"({"id": "a", "version": 1, "pass_points": 70, "method": "angoff"})", "text"),
                 curriculum::DefinitionError)
        << "judges need their number";
}

}  // namespace THIS_TEST
}  // namespace placode::db
