// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Courses and groups on the command line: what everybody may do, and that a refusal changes
// nothing.

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "curriculum/task.h"
#include "db/store.h"
#include "tests/programs_fixture.h"

using namespace placode;
using namespace placode::test;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

namespace THIS_TEST {

World* const world = World::install();

class TrainingPrograms : public Programs {
 protected:
    void SetUp() override {
        Programs::SetUp();
        add_user("anna", "trainee");
        add_user("ewa", "educator");
        add_user("olga", "educator");
        add_user("adam", "administrator");
        add_user("carl", "coordinator");
    }
    [[nodiscard]] static db::StoreOptions cheap() {
        db::StoreOptions options;
        options.cheap_passwords = true;
        return options;
    }
    [[nodiscard]] Outcome as(const std::string& who, const std::string& arguments) const {
        return ctl("--as " + who + " " + arguments, kRight);
    }
};

TEST_F(TrainingPrograms, RightsAreAskedForBeforeAnythingHappens) {
    ASSERT_NE(world, nullptr);
    ASSERT_EQ(as("ewa", "group add A").status, 0);
    ASSERT_EQ(as("ewa", "group member A anna").status, 0);
    struct Case {
        const char* command;
        int anna, ewa, olga, adam, carl;
    };
    // 0 = may, 1 = refused. ewa teaches anna's group, olga does not.
    const Case cases[]{
        {"course list", 0, 0, 0, 0, 0},
        {"course show first_steps", 0, 0, 0, 0, 0},
        {"course next --user anna --course first_steps", 0, 0, 0, 1, 1},
        {"course assign first_steps --user anna --due 2099-01-01", 1, 0, 1, 1, 1},
        {"course grant first_steps diathermy_ring --user anna --reason x", 1, 0, 1, 1, 1},
        {"course assign full_dissection --group A", 1, 0, 1, 1, 1},
        {"course unassign 1", 1, 0, 1, 1, 1},
        {"course export first_steps --out e.json", 1, 0, 0, 1, 1},
        {"course publish first_steps", 1, 0, 0, 1, 1},
        {"group list", 1, 0, 0, 0, 1},
        {"group member A anna", 1, 0, 1, 0, 1},
    };
    for (const Case& each : cases) {
        // Who is refused comes first: what they tried must not have happened.
        const std::pair<const char*, int> people[]{{"anna", each.anna},
                                                   {"olga", each.olga},
                                                   {"adam", each.adam},
                                                   {"carl", each.carl},
                                                   {"ewa", each.ewa}};
        for (const int wanted : {1, 0})
            for (const auto& [who, status] : people) {
                if (status != wanted) continue;
                const Outcome outcome = as(who, each.command);
                EXPECT_EQ(outcome.status, status) << who << ": " << each.command << outcome.err;
                if (status == 1) {
                    EXPECT_THAT(outcome.err, HasSubstr("you may not"));
                }
            }
    }
    const Outcome drawn = as("olga", "group add B");
    EXPECT_EQ(drawn.status, 0);
    EXPECT_EQ(as("olga", "group member B anna").status, 1) << "drawn out of another's group";
}

TEST_F(TrainingPrograms, AKeyIsTakenFromNothingButAFile) {
    const std::string phrase = file("phrase"), pipe = file("pipe");
    write_text(phrase, "four words are good\n");
    fs::permissions(phrase, fs::perms::owner_read | fs::perms::owner_write);
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    write_text(file("other.json"), "{}");
    const auto take = [&](const std::string& from, const std::string& with) {
        return ctl("norms key import '" + from + "' --passphrase-file '" + with + "'");
    };
    // A pipe that nobody writes into, or a device without end, is not waited for.
    for (const std::string& wrong : {folder, pipe, std::string("/dev/zero")}) {
        const Outcome refused = take(wrong, phrase);
        EXPECT_EQ(refused.status, 2) << wrong;
        EXPECT_THAT(refused.err, HasSubstr(wrong + ": is no file"));
        EXPECT_EQ(take(file("other.json"), wrong).status, 2) << wrong;
    }
    const Outcome other = take(file("other.json"), phrase);
    EXPECT_EQ(other.status, 2);
    EXPECT_THAT(other.err, HasSubstr("holds no centre's key"));
}

TEST_F(TrainingPrograms, ACourseIsBuiltCheckedPublishedAssignedAndFollowed) {
    write_text(file("c.json"), R"({"id":"mine","version":1,"title":{"en":"Mine"},"stages":[
        {"task_id":"diathermy_ring_small","consecutive":1}]})");
    EXPECT_THAT(ctl("course check c.json").out, HasSubstr("sound"));
    write_text(file("limit.json"), R"({"id":"mine","version":1,"title":{"en":"Mine"},"stages":[
        {"task_id":"diathermy_ring_small","consecutive":1,"max_attempts":2}]})");
    const Outcome limited = ctl("course check limit.json");
    EXPECT_EQ(limited.status, 2);
    EXPECT_THAT(limited.err, HasSubstr("/stages/0/max_attempts: a limit of 2 attempts"));
    write_text(file("bad.json"), R"({"id":"mine","version":2,"title":{"en":"Mine"},"stages":[
        {"task_id":"none"}]})");
    const Outcome bad = as("ewa", "course publish bad.json");
    EXPECT_EQ(bad.status, 2);
    EXPECT_THAT(bad.err, HasSubstr("/stages/0/task_id"));
    EXPECT_EQ(as("ewa", "course publish c.json").status, 0);
    EXPECT_EQ(as("ewa", "course publish c.json").status, 0) << "the same text is no change";
    write_text(file("d.json"), R"({"id":"mine","version":1,"title":{"en":"Other"},"stages":[
        {"task_id":"diathermy_ring_small"}]})");
    EXPECT_THAT(as("ewa", "course publish d.json").err, HasSubstr("next version"));
    EXPECT_EQ(as("ewa", "course export mine --out e.json").status, 0);
    EXPECT_EQ(read_text(file("e.json")), read_text(file("c.json")));
    EXPECT_EQ(as("ewa", "course import e.json --id theirs").status, 0);
    EXPECT_THAT(ctl("course list").out, AllOf(HasSubstr("mine"), HasSubstr("theirs")));
    EXPECT_THAT(as("anna", "course next").out, HasSubstr("no course is assigned"));
    EXPECT_EQ(as("ewa", "course assign mine --user anna --from 2026-01-01 --due 2026-02-01").status,
              0);
    EXPECT_EQ(as("ewa", "course assign mine --user anna").status, 2) << "twice";
    EXPECT_EQ(as("ewa", "course assign mine --user anna --group A").status, 2);
    const Outcome next = as("anna", "--json course next --at 2026-01-15");
    EXPECT_THAT(next.out, AllOf(HasSubstr("\"kind\": \"start\""), HasSubstr("due on 2026-02-01"),
                                HasSubstr("\"task\": \"diathermy_ring_small\"")));
    EXPECT_THAT(as("anna", "course next --at 2025-12-31").out, HasSubstr("begins on 2026-01-01"));
    EXPECT_THAT(as("anna", "course next --at 2026-03-01").out, HasSubstr("was due"));
    EXPECT_EQ(as("anna", "course next --at someday").status, 2);
    EXPECT_EQ(ctl("course next").status, 2) << "the local administrator is not a person";
    EXPECT_EQ(as("ewa", "course unassign 1").status, 0);
    EXPECT_THAT(as("anna", "course next --at 2026-01-15").out, HasSubstr("no course is assigned"));
    EXPECT_EQ(as("ewa", "course unassign 1").status, 2);
    EXPECT_THAT(ctl("course assignments").out, HasSubstr("ewa"));
}

TEST_F(TrainingPrograms, AnExamRecordingIsTakenOnlyWithItsSeed) {
    write_text(file("c.json"), R"({"id":"mine","version":1,"title":{"en":"Mine"},"stages":[
        {"id":"final","task_id":"diathermy_ring_small","mode":"exam","consecutive":1,
         "benchmark_points":0,"exam":{"seeds":[5,6],"proctor":true}}]})");
    ASSERT_EQ(as("ewa", "course publish c.json").status, 0);
    ASSERT_EQ(as("ewa", "course assign mine --user anna").status, 0);
    write_text(file("d.json"), R"({"id":"open","version":1,"title":{"en":"Open"},"stages":[
        {"id":"final","task_id":"diathermy_ring_small","mode":"exam","consecutive":1,
         "benchmark_points":0,"exam":{"seeds":[5],"proctor":false}}]})");
    ASSERT_EQ(as("ewa", "course publish d.json").status, 0);
    ASSERT_EQ(as("ewa", "course assign open --user anna").status, 0);
    for (const char* seed : {"4", "5"}) {
        const Outcome made =
            run("placode-sim", std::string("--task diathermy_ring_small --headless "
                                           "--fast --duration 0.1 --exam --device "
                                           "script:expert --seed ") +
                                   seed + " --record s" + seed + ".placode");
        ASSERT_EQ(made.status, 0) << made.err;
    }
    ASSERT_EQ(run("placode-sim",
                  "--task diathermy_ring_small --headless --fast --duration 0.1 --device "
                  "script:expert --seed 5 --record practice.placode")
                  .status,
              0);
    const std::string exam = " --user anna --exam mine/final";
    EXPECT_THAT(as("anna", "import s5.placode" + exam).err, HasSubstr("proctor"));
    EXPECT_THAT(as("anna", "import s5.placode --proctor Nowak" + exam).err,
                HasSubstr("\"Nowak\" has no account"));
    EXPECT_THAT(as("anna", "import s5.placode --proctor anna" + exam).err, HasSubstr("proctor"));
    // Whoever takes the exam does not sign for the proctor.
    EXPECT_THAT(as("anna", "import s5.placode --proctor ewa" + exam).err,
                HasSubstr("PLACODE_PROCTOR_PASSWORD; it is missing"));
    const auto proctored = [&](const std::string& arguments, const std::string& password) {
        return ctl("--as anna " + arguments + " --proctor ewa" + exam,
                   std::string(kRight) + " PLACODE_PROCTOR_PASSWORD='" + password + "'");
    };
    EXPECT_THAT(ctl("import s5.placode --proctor ewa" + exam).err,
                HasSubstr("PLACODE_PROCTOR_PASSWORD; it is missing"))
        << "nor does whoever owns the file";
    EXPECT_THAT(ctl("import s5.placode --user anna --exam open/final").err,
                HasSubstr("vouches for an exam"))
        << "nor is the own word enough where the course asks for no proctor";
    EXPECT_THAT(proctored("import practice.placode", "long enough 1").err,
                HasSubstr("it was recorded as practice"));
    EXPECT_THAT(proctored("import s5.placode", "a guess 12").err, HasSubstr("it is wrong"));
    EXPECT_THAT(proctored("import s4.placode", "long enough 1").err,
                HasSubstr("expected task diathermy_ring_small, seed 5"));
    EXPECT_EQ(as("anna", "import s5.placode --user anna --exam mine").status, 2);
    EXPECT_THAT(as("anna", "attempts").out, HasSubstr("no attempts"));
    const Outcome taken = proctored("import s5.placode", "long enough 1");
    EXPECT_EQ(taken.status, 0) << taken.err;
    // A script's exam is nobody's: kept, for nothing.
    EXPECT_THAT(taken.out, HasSubstr("counts for nothing. Practice, not verified: operated by "
                                     "script:expert"));
    EXPECT_THAT(as("anna", "--json course next").out, HasSubstr("\"mastered\": false"));
}

TEST_F(TrainingPrograms, OldAttemptsAreRescoredAndBothScoresKept) {
    ASSERT_EQ(run("placode-sim",
                  "--task diathermy_ring_small --headless --fast --duration 0.5 --device "
                  "script:expert --record a.placode")
                  .status,
              0);
    ASSERT_EQ(as("anna", "import a.placode --user anna").status, 0);
    // The same rubric gives the same score again.
    const Outcome same = as("ewa", "--json rescore --task diathermy_ring_small --dry-run");
    ASSERT_EQ(same.status, 0) << same.err;
    EXPECT_EQ(number_in(same.out, "scored"), 1);
    EXPECT_EQ(number_in(same.out, "largest_difference"), 0);
    EXPECT_THAT(same.out, HasSubstr("already there"));
    // A stricter one: everything costs 30 points more.
    auto task = nlohmann::ordered_json::parse(
        read_text(std::string(PLACODE_SOURCE_DIR) + "/data/tasks/diathermy_ring_small.json"));
    task["rubric"]["start_points"] = 70;
    write_text(file("strict.json"), task.dump());
    const Outcome changed = as("ewa", "rescore --task strict.json");
    EXPECT_EQ(changed.status, 2) << "the attempt was scored under this version with another text";
    EXPECT_THAT(changed.err, HasSubstr("next version"));
    EXPECT_THAT(as("ewa", "--json scores 1").out, Not(HasSubstr("\"rubric_version\": 6")));
    task["rubric"]["version"] = 6;
    write_text(file("strict.json"), task.dump());
    EXPECT_EQ(as("anna", "rescore --task strict.json").status, 1);
    EXPECT_EQ(as("ewa", "rescore --task strict.json --dry-run").status, 0);
    EXPECT_THAT(as("anna", "scores 1").out, Not(HasSubstr("ring_incision 6")))
        << "a dry run saves nothing";
    const Outcome rescored = as("ewa", "--json rescore --task strict.json");
    ASSERT_EQ(rescored.status, 0) << rescored.err;
    EXPECT_EQ(number_in(rescored.out, "scored"), 1);
    EXPECT_THAT(rescored.out, HasSubstr("\"state\": \"rescored\""));
    const Outcome scores = as("anna", "--json scores 1");
    EXPECT_THAT(scores.out,
                AllOf(HasSubstr("\"rubric_version\": 5"), HasSubstr("\"rubric_version\": 6"),
                      HasSubstr("\"preprocessing_version\": 1")));
    EXPECT_EQ(number_in(as("ewa", "--json rescore --task strict.json").out, "scored"), 0)
        << "once is enough";
    task["rubric"]["start_points"] = 60;
    write_text(file("strict.json"), task.dump());
    const Outcome other = as("ewa", "rescore --task strict.json");
    EXPECT_EQ(other.status, 2);
    EXPECT_THAT(other.err, HasSubstr("next version"));
    EXPECT_EQ(as("adam", "scores 1").status, 1);
}

TEST_F(TrainingPrograms, StandardsAreSetFromGroupsAndExchangedSigned) {
    {
        const auto direct = db::open_store("sqlite:" + store, cheap());
        const int64_t novices = direct->groups().create("N"),
                      experts = direct->groups().create("E");
        for (int i = 0; i < 10; ++i) {
            const bool expert = i >= 5;
            const int64_t user =
                direct->accounts().create({"p" + std::to_string(i), "Person " + std::to_string(i),
                                           "long enough 1", 1, false});
            direct->groups().set_role(expert ? experts : novices, user, db::GroupRole::kMember);
            for (const double step : {-1.0, 1.0}) {
                const double jitter = i % 2 ? step : -step;  // Not the same for all.
                db::AttemptResult result;
                result.header.task_id = "diathermy_ring";
                result.metrics.values = {{"task_time_s", (expert ? 100 : 300) + 5 * i + jitter}};
                result.score.points = (expert ? 80 : 40) + 2 * (i % 5) + jitter;
                result.score.rubric_id = "ring";
                (void)direct->attempts().save(user, result);
            }
        }
    }
    const std::string make = "norms make diathermy_ring --level expert=E --level novice=N ";
    EXPECT_EQ(as("anna", make + "--centre Here").status, 1);
    EXPECT_THAT(as("ewa", make + "--centre Here --least 6").err, HasSubstr("has 5 persons"));
    EXPECT_THAT(as("ewa", make + "--centre Here").err,
                HasSubstr("20 of 20 attempts were never simulated again"));
    EXPECT_THAT(as("ewa", "norms standard diathermy_ring --novices N --experts E").err,
                HasSubstr("20 of 20 attempts were never simulated again"))
        << "a mark asks for the same";
    {
        const auto direct = db::open_store("sqlite:" + store, cheap());
        for (const auto& each : direct->attempts().list(0))
            direct->attempts().set_replay(each.id, db::ReplayState::kIdentical);
    }
    EXPECT_THAT(as("ewa", make).err, HasSubstr("no name yet"));
    EXPECT_THAT(as("ewa", make + "--centre Here").err, HasSubstr("PLACODE_NEW_PASSPHRASE"));
    const Outcome made = ctl("--as ewa --json " + make + "--centre Here",
                             kRight + std::string(" PLACODE_NEW_PASSPHRASE='four words are good'"));
    ASSERT_EQ(made.status, 0) << made.err;
    EXPECT_THAT(made.out, AllOf(HasSubstr("\"persons\": 5"), Not(HasSubstr("Person"))));
    EXPECT_THAT(as("anna", "norms list").out, HasSubstr("expert 5, novice 5"));
    EXPECT_EQ(as("ewa", "norms export 1 --out n.json").status, 0);
    // A name that no file system takes is met only when the file is made.
    EXPECT_NE(as("ewa", "norms export 1 --out " + std::string(300, 'n')).status, 0);
    EXPECT_EQ(db::open_store("sqlite:" + store, cheap())->audit().of_action("norms.export").size(),
              2u)
        << "the entry comes before the file";
    EXPECT_EQ(as("ewa", "norms import n.json").status, 0) << "its own is known";
    EXPECT_EQ(as("ewa", "norms apply 1").status, 0);
    EXPECT_EQ(as("ewa", "norms apply 9").status, 2);
    const Outcome compared = as("ewa", "--json norms compare 11 --level expert");
    EXPECT_EQ(compared.status, 0) << compared.err;
    EXPECT_LT(number_in(compared.out, "z"), 0) << "the weakest expert's first attempt";
    EXPECT_EQ(as("ewa", "norms compare 11 --level none").status, 2);
    const Outcome cut = as("ewa", "--json norms standard diathermy_ring --novices N --experts E");
    // Means 44 and 84, equal SD: the densities meet in the middle.
    EXPECT_NEAR(number_in(cut.out, "cut_score"), 64, 1e-9) << cut.err;
    const Outcome time = as("ewa",
                            "--json norms standard diathermy_ring --novices N --experts E --metric "
                            "task_time_s");
    EXPECT_NEAR(number_in(time.out, "mean_novice"), 310, 1e-9);
    EXPECT_EQ(number_in(time.out, "observed_false_positive"), 0) << "less time is better";
    EXPECT_THAT(
        as("ewa", "norms standard diathermy_ring --novices N --experts E --metric traction_held_s")
            .err,
        HasSubstr("0 novice and 0 expert"));
    EXPECT_THAT(
        as("ewa", "norms standard diathermy_ring --novices N --experts E --metric none").err,
        HasSubstr("unknown metric \"none\""));
    const Outcome panel = as("ewa", "--json norms quality diathermy_ring --novices N --experts E");
    EXPECT_THAT(panel.out, AllOf(HasSubstr("hedges_g"), HasSubstr("\"evidence\": true")));

    // Another centre: a changed pack, an unknown key, then trust.
    const Outcome setup = run("placodectl", "--store sqlite:other.db user add eva --role educator",
                              "PLACODE_NEW_PASSWORD='long enough 1'");
    ASSERT_EQ(setup.status, 0) << setup.err;
    const auto there = [&](const std::string& arguments) {
        return run("placodectl", "--store sqlite:other.db " + arguments);
    };
    std::string text = read_text(file("n.json"));
    const size_t at = text.find("\\\"persons\\\": 5");
    ASSERT_NE(at, std::string::npos);
    text.replace(at, 14, "\\\"persons\\\": 9");
    write_text(file("forged.json"), text);
    EXPECT_THAT(there("norms import forged.json --trust").err, HasSubstr("changed after"));
    const Outcome unknown = there("norms import n.json");
    EXPECT_EQ(unknown.status, 2);
    EXPECT_THAT(unknown.err, HasSubstr("is not trusted here"));
    EXPECT_EQ(there("norms import n.json --trust").status, 0);
    EXPECT_THAT(there("norms list").out, HasSubstr("Here"));
}

TEST_F(TrainingPrograms, JudgesMaySetTheStandard) {
    std::string head = "judge", first = "A", second = "B";
    double all = 0, kept = 0;
    for (const auto& item : curriculum::load_task("diathermy_ring").rubric.items) {
        const double weight = std::min(item.max_points, 100.0);
        all += weight;
        kept += weight * 0.7;
        head += "," + item.id;
        first += ",0.8";
        second += ",0.6";
    }
    write_text(file("judges.csv"), head + "\n" + first + "\n" + second + "\n");
    const std::string set = "--json standard set --task diathermy_ring --angoff judges.csv";
    EXPECT_EQ(as("anna", set).status, 1) << "a trainee sets no standard";
    const Outcome made = as("ewa", set);
    ASSERT_EQ(made.status, 0) << made.err;
    EXPECT_NEAR(number_in(made.out, "pass_points"), 100 * kept / all, 1e-9);
    EXPECT_NEAR(number_in(made.out, "se_points"), 10, 1e-9);
    const Outcome shown = as("anna", "--json standard show --task diathermy_ring");
    EXPECT_THAT(shown.out, AllOf(HasSubstr("\"angoff\""), HasSubstr("\"set_by\": \"ewa\"")));
    write_text(file("judges.csv"), head + "\n" + first + "\n");
    EXPECT_EQ(as("ewa", set + " --reason again").status, 2) << "one judge is none";
    write_text(file("judges.csv"), "judge,other\nA,0.5\nB,0.6\n");
    EXPECT_EQ(as("ewa", set + " --reason again").status, 2) << "a line of the rubric is missing";
    EXPECT_EQ(as("ewa", "standard set --task diathermy_ring").status, 2);
}

TEST_F(TrainingPrograms, ALoginTakesNobodysNumber) {
    const std::string invited = as("adam", "user invite --until 2099-01-01").out;
    const std::string code = invited.substr(0, invited.find('\n'));
    const Outcome chosen =
        ctl("user accept " + code + " 3", "PLACODE_NEW_PASSWORD='long enough 1'");
    EXPECT_EQ(chosen.status, 2);
    EXPECT_THAT(chosen.err, HasSubstr("reads as the number of an account"));
    // An earlier version let it through: bert (6) has the number of olga (3).
    add_user("bert", "trainee");
    ASSERT_TRUE(RawConnection("QSQLITE", store)
                    .run("UPDATE persons SET login = '3', login_key = '3' WHERE account_id = 6"));
    const Outcome roles = ctl("user roles 3 --role administrator");
    EXPECT_EQ(roles.status, 2);
    EXPECT_THAT(roles.err,
                HasSubstr("is the login of account 6 and the number of account \"olga\""));
    EXPECT_EQ(ctl("user roles 6 --role trainee").status, 0) << "the way out";
    EXPECT_EQ(ctl("user roles olga --role educator").status, 0);
    // The same of groups: the second one is called as the number of the first.
    ASSERT_EQ(ctl("group add A").status, 0);
    ASSERT_EQ(ctl("group add 1").status, 0);
    const Outcome member = ctl("group member 1 anna");
    EXPECT_EQ(member.status, 2);
    EXPECT_THAT(member.err, HasSubstr("the name of one group and the number of another"));
    EXPECT_EQ(ctl("group member 2 anna").status, 0);
    write_text(file("people.csv"), "login,name,group,password\njan,Jan,1,long enough 1\n");
    EXPECT_THAT(ctl("user import people.csv").err, HasSubstr("people.csv:2: \"1\" is the name of"));
}

TEST_F(TrainingPrograms, ANameOfAnOlderStoreForgesNoRow) {
    ASSERT_TRUE(RawConnection("QSQLITE", store)
                    .run("UPDATE persons SET display_name = 'Anna' || char(10) || '9  eve  Eve  "
                         "administrator' || "
                         "char(27) || '[1A' || char(8238) WHERE account_id = 1"));
    const Outcome listed = ctl("user list");
    EXPECT_EQ(listed.status, 0) << listed.err;
    EXPECT_EQ(std::count(listed.out.begin(), listed.out.end(), '\n'), 6)
        << "a head and five people";
    EXPECT_THAT(listed.out, HasSubstr("Anna\xEF\xBF\xBD"
                                      "9  eve"));
    for (const Outcome& each : {listed, ctl("--json user list")})
        for (const char* hidden : {"\x1b", "\xE2\x80\xAE"})
            EXPECT_THAT(each.out, Not(HasSubstr(hidden)));
    EXPECT_THAT(ctl("--json user list").out, HasSubstr("\\u202e"))
        << "for programs it is all there";
}

TEST_F(TrainingPrograms, PeopleComeFromAFileOrByInvitationAndMayLeave) {
    ASSERT_EQ(ctl("group add A").status, 0);
    write_text(file("bad.csv"), "login,name,roles\njan,Jan,trainee\nanna,Anna,\n");
    const Outcome taken = as("adam", "user import bad.csv --out p.csv");
    EXPECT_EQ(taken.status, 2);
    EXPECT_THAT(taken.err, HasSubstr("bad.csv:3: the login \"anna\" is taken"));
    write_text(file("bad.csv"), "login,name,roles\njan,Jan,surgeon\n");
    EXPECT_THAT(as("adam", "user import bad.csv --out p.csv").err, HasSubstr("bad.csv:2: "));
    write_text(file("bad.csv"), "login,surname\n");
    EXPECT_EQ(as("adam", "user import bad.csv").status, 2);
    EXPECT_THAT(ctl("user list").out, Not(HasSubstr("jan"))) << "nothing of a wrong file";
    write_text(file("people.csv"),
               "login,name,roles,group\njan,\"Jan, junior\",,A\nola,Ola,trainee;educator,\n");
    EXPECT_EQ(as("anna", "user import people.csv --out p.csv").status, 1);
    EXPECT_EQ(as("adam", "user import people.csv").status, 2) << "nobody would know the passwords";
    EXPECT_EQ(as("adam", "user import people.csv --out p.csv").status, 0);
    EXPECT_THAT(ctl("user list").out,
                AllOf(HasSubstr("Jan, junior"), HasSubstr("trainee, educator")));
    const std::string passwords = read_text(file("p.csv"));
    write_text(file("more.csv"), "login,name\nkim,Kim\n");
    const Outcome again = as("adam", "user import more.csv --out p.csv");
    EXPECT_EQ(again.status, 2);
    EXPECT_THAT(again.err, HasSubstr("p.csv exists and is not overwritten; give another name"));
    EXPECT_EQ(read_text(file("p.csv")), passwords) << "those of jan and ola are still known";
    EXPECT_THAT(ctl("user list").out, Not(HasSubstr("kim")));
    const std::string jans = passwords.substr(passwords.find("jan,") + 4, 16);
    EXPECT_EQ(ctl("--as jan course next", "PLACODE_PASSWORD=" + jans).status, 0);

    const Outcome invited = as("adam", "user invite --role educator --group A --until 2099-01-01");
    EXPECT_EQ(invited.status, 0) << invited.err;
    const std::string code = invited.out.substr(0, invited.out.find('\n'));
    EXPECT_EQ(ctl("user accept wrong-code bert", "PLACODE_NEW_PASSWORD='long enough 1'").status, 2);
    EXPECT_EQ(ctl("user accept " + code + " bert", "PLACODE_NEW_PASSWORD='long enough 1'").status,
              0);
    EXPECT_EQ(ctl("user accept " + code + " carla", "PLACODE_NEW_PASSWORD='long enough 1'").status,
              2);
    EXPECT_EQ(as("anna", "user invite --until 2099-01-01").status, 1);

    EXPECT_EQ(ctl("--as anna user pin", "PLACODE_NEW_PIN=1111 " + std::string(kRight)).status, 2);
    EXPECT_EQ(ctl("--as anna user pin", "PLACODE_NEW_PIN=2580 " + std::string(kRight)).status, 0);
    EXPECT_EQ(as("adam", "user pin --user anna").status, 1) << "a PIN is one's own";
    EXPECT_EQ(as("adam", "user pin --user anna --remove").status, 0);

    EXPECT_EQ(as("anna", "user data --out mine").status, 0);
    EXPECT_THAT(read_text(file("mine/my_data.json")), HasSubstr("\"login\": \"anna\""));
    EXPECT_EQ(as("ewa", "user data --user anna --out hers").status, 1);
    EXPECT_EQ(as("anna", "user ask-erasure --reason enough").status, 0);
    EXPECT_THAT(as("adam", "user erasures").out, HasSubstr("enough"));
    EXPECT_EQ(as("anna", "user erase anna --confirm anna").status, 1);
    EXPECT_EQ(as("adam", "user erase anna").status, 2) << "confirm it";
    EXPECT_EQ(as("adam", "user erase anna --confirm anna").status, 0);
    EXPECT_EQ(as("anna", "course next").status, 1);
    EXPECT_THAT(ctl("user list").out, Not(HasSubstr("anna")));
}

TEST_F(TrainingPrograms, ReportsAndTheCertificateAreWritten) {
    write_text(file("c.json"),
               R"({"id":"mine","version":1,"title":{"en":"Mine","pl":"Moj"},"stages":[
        {"task_id":"diathermy_ring_small","consecutive":1,"benchmark_points":50}]})");
    ASSERT_EQ(as("ewa", "course publish c.json").status, 0);
    ASSERT_EQ(as("ewa", "course assign mine --user anna").status, 0);
    const Outcome early = as("anna", "report certificate mine --out c.pdf");
    EXPECT_EQ(early.status, 2);
    EXPECT_THAT(early.err, HasSubstr("not mastered yet"));
    {
        const auto direct = db::open_store("sqlite:" + store, cheap());
        db::AttemptResult result;
        result.header.task_id = "diathermy_ring_small";
        result.end.reason = sim::EndReason::kFinished;
        for (const double points : {20, 30, 80}) {
            result.score.points = points;
            direct->attempts().save(direct->accounts().find_login("anna")->id, result);
        }
    }
    const Outcome certificate = as("anna", "--json report certificate mine --out c.pdf");
    EXPECT_EQ(certificate.status, 0) << certificate.err;
    EXPECT_THAT(certificate.out, HasSubstr("\"code\""));
    // Also of one that is issued already, and before the file, which comes to nothing here.
    EXPECT_NE(as("anna", "report certificate mine --out " + std::string(300, 'c')).status, 0);
    EXPECT_EQ(
        db::open_store("sqlite:" + store, cheap())->audit().of_action("report.certificate").size(),
        2u);
    EXPECT_EQ(as("carl", "report certificate mine --user anna --out d.pdf").status, 1);
    EXPECT_EQ(as("anna", "report trainee anna --out t.pdf").status, 0);
    EXPECT_EQ(as("carl", "report trainee anna --out d.pdf").status, 1);
    const Outcome cohort = as("ewa", "--json report cohort all --out g.pdf");
    EXPECT_EQ(cohort.status, 0) << cohort.err;
    EXPECT_THAT(cohort.out, HasSubstr("\"standing\": \"learning\""));
    EXPECT_EQ(as("anna", "report cohort all --out d.pdf").status, 1);
    // A pass mark from two groups, by an educator only.
    {
        const auto direct = db::open_store("sqlite:" + store, cheap());
        int n = 0;
        for (const double points : {40, 50, 80, 90}) {
            const std::string login = "p" + std::to_string(++n);
            const int64_t id = direct->accounts().create({login, login, "quiet river 7", 1, false});
            db::AttemptResult result;
            result.header.task_id = "diathermy_ring_small";
            result.end.reason = sim::EndReason::kFinished;
            result.score.points = points;
            direct->attempts().save(id, result);
        }
    }
    const std::string mark = "standard set --task diathermy_ring_small --novice p1,p2 --expert ";
    EXPECT_EQ(as("anna", mark + "p3,p4").status, 1);
    EXPECT_THAT(as("ewa", mark + "p3,p4").err,
                HasSubstr("4 of 4 attempts were never simulated again"));
    {
        const auto direct = db::open_store("sqlite:" + store, cheap());
        for (const auto& each : direct->attempts().list(0, "diathermy_ring_small"))
            direct->attempts().set_replay(each.id, db::ReplayState::kIdentical);
    }
    EXPECT_EQ(as("ewa", mark + "p3").status, 2) << "one person is no group";
    const Outcome set = as("ewa", "--json " + mark + "p3,p4");
    EXPECT_EQ(set.status, 0) << set.err;
    EXPECT_THAT(set.out, HasSubstr("\"pass_points\": 65.0"));  // Halfway: equal spreads.
    EXPECT_EQ(as("ewa", mark + "p3,p4").status, 2) << "the second one needs a reason";
    EXPECT_EQ(as("ewa", mark + "p3,p4 --reason again").status, 0);
    const Outcome holds = as("anna", "--json standard show --task diathermy_ring_small");
    EXPECT_THAT(holds.out, HasSubstr("\"version\": 2"));
    EXPECT_THAT(holds.out, HasSubstr("\"set_by\": \"ewa\""));
    // Each group is of one rubric, but not of the same one.
    {
        const auto direct = db::open_store("sqlite:" + store, cheap());
        for (const char* login : {"p5", "p6"}) {
            db::AttemptResult result;
            result.header.task_id = "diathermy_ring_small";
            result.end.reason = sim::EndReason::kFinished;
            result.score.points = login[1] == '5' ? 85 : 95;
            result.score.rubric_version = 2;
            const int64_t id = direct->attempts().save(
                direct->accounts().create({login, login, "quiet river 7", 1, false}), result);
            direct->attempts().set_replay(id, db::ReplayState::kIdentical);
        }
    }
    EXPECT_THAT(as("ewa", mark + "p5,p6 --reason again").err,
                HasSubstr("different versions of the task or of its rubric"));
    EXPECT_EQ(as("ewa", "report cohort none --out d.pdf").status, 2);
    for (const char* name : {"c.pdf", "t.pdf", "g.pdf"})
        EXPECT_THAT(read_text(file(name)), testing::StartsWith("%PDF-")) << name;
    EXPECT_FALSE(fs::exists(file("d.pdf")));
}

TEST_F(TrainingPrograms, TheStoreIsMeasuredOnlyInAnEmptyOne) {
    const Outcome refused = ctl("bench store --quick");
    EXPECT_EQ(refused.status, 2);
    EXPECT_THAT(refused.err, HasSubstr("empty store"));
    const Outcome made = run("placodectl",
                             "--json --store sqlite:bench.db bench store --users 4 --attempts 40 "
                             "--quick --out b");
    ASSERT_EQ(made.status, 0) << made.err;
    EXPECT_EQ(number_in(made.out, "attempts"), 40);
    EXPECT_GT(number_in(made.out, "peak_memory_mb"), 1);
    EXPECT_THAT(read_text(file("b/bench_store.csv")), HasSubstr("standing of everybody"));
    // The shell was opened as well, by somebody with every role and by a trainee.
    EXPECT_THAT(made.out,
                AllOf(HasSubstr("\"page\": \"standards\""), HasSubstr("\"who\": \"generated-3\"")));
    EXPECT_GT(number_in(made.out, "shell_peak_memory_mb"), 1);
    const Outcome listed = run("placodectl", "--json --store sqlite:bench.db attempts");
    EXPECT_THAT(listed.out, AllOf(HasSubstr("Generated 4"), HasSubstr("\"demonstration\": true")));
    EXPECT_EQ(run("placodectl", "--store sqlite:bench.db check").status, 0);
}

}  // namespace THIS_TEST
