// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Attempts and studies leave the store on the command line, in every format.

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <filesystem>
#include <utility>

#include "db/recording_file.h"
#include "db/store.h"
#include "tests/programs_fixture.h"

using namespace placode;
using namespace placode::test;
namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

namespace THIS_TEST {

test::World* const world = test::World::install();

class ExportPrograms : public Programs {
 protected:
    /// Zofia's attempt with its recording, and what a participant answered.
    void fill_store() const {
        const std::string recording = file("a.placode");
        ASSERT_EQ(run("placode-sim",
                      "--task diathermy_ring_small --headless --fast --duration 0.3 --device "
                      "script:expert --record a.placode")
                      .status,
                  0);
        const std::string zofia = "Zażółć, \"Zofia\"";
        {
            const auto direct = db::open_store("sqlite:" + store);
            const int64_t user =
                direct->accounts().create({"zofia", zofia, "long enough 1", 1, true});
            direct->accounts().create({"carl", "Carl", "long enough 1", 4, true});
            direct->accounts().create({"ewa", "Ewa", "long enough 1", 2, true});
            db::AttemptResult result;
            const sim::Recording read = db::read_recording_file(recording);
            result.header = read.header;
            result.end = read.end;
            result.events = read.events;
            result.metrics = assessment::compute_metrics(read);
            result.score.points = 12.5;
            result.recording_file = recording;
            direct->attempts().save(user, result);
            db::AnswerRecord answers;
            answers.study_id = "pilot/1";
            answers.participant = direct->studies().new_participant("pilot/1");
            answers.questionnaire_id = "face_validity";
            answers.answers = {{"A", "5"}, {"B", "4"}};
            direct->studies().save_answers(answers);
        }
    }
};

TEST_F(ExportPrograms, AttemptsAndAnswersLeaveTheStoreAsCsvAndPdf) {
    ASSERT_NE(world, nullptr);
    fill_store();
    ASSERT_FALSE(HasFatalFailure());
    const Outcome attempts = ctl("--as zofia attempts --json", kRight);
    EXPECT_EQ(attempts.status, 0) << attempts.err;
    EXPECT_EQ(number_in(attempts.out, "points"), 12.5);
    const Outcome user = ctl("--as zofia export csv --user zofia --out exported", kRight);
    EXPECT_EQ(user.status, 0) << user.err;
    EXPECT_THAT(read_text(file("exported/user_1_attempts.csv")),
                AllOf(HasSubstr("12.5"), HasSubstr("path_length_mm")));
    const Outcome study = ctl("--as carl export csv --study pilot/1 --out exported", kRight);
    EXPECT_EQ(study.status, 0) << study.err;
    EXPECT_THAT(read_text(file("exported/pilot_1_face_validity.csv")), HasSubstr("P001-"));
    EXPECT_EQ(ctl("--as carl export csv --study none", kRight).status, 2);
    EXPECT_EQ(ctl("export csv").status, 2) << "neither study nor user";
    const Outcome report = ctl("--as zofia report attempt 1 --out a.pdf", kRight);
    EXPECT_EQ(report.status, 0) << report.err;
    EXPECT_THAT(read_text(file("a.pdf")), testing::StartsWith("%PDF-"));
    EXPECT_EQ(ctl("--as carl report attempt 1 --out b.pdf", kRight).status, 1);
    EXPECT_FALSE(fs::exists(file("b.pdf")));
    EXPECT_EQ(ctl("report attempt 99 --out b.pdf").status, 2);
    EXPECT_EQ(ctl("report attempt first --out b.pdf").status, 2);
    EXPECT_THAT(ctl("audit").out, AllOf(HasSubstr("export.csv"), HasSubstr("report.pdf")));
}

TEST_F(ExportPrograms, NothingLeavesWithoutItsEntryInTheTrail) {
    fill_store();
    ASSERT_FALSE(HasFatalFailure());
    // No disk takes a name of this length, which shows only when the file is made: nothing comes of
    // it, and its entry stands all the same, because it comes first.
    const std::string name(300, 'n');
    constexpr std::pair<const char*, const char*> kCommands[]{
        {"report.pdf", "--as zofia report attempt 1 --out a.pdf"},
        {"report.seal", "--as zofia report seal 1 --out a.txt"},
        {"report.trainee", "--as zofia report trainee zofia --out t.pdf"},
        {"report.cohort", "--as ewa report cohort all --out c.pdf"},
        {"export.csv", "--as carl export csv --study pilot/1 --out e"},
        {"user.data", "--as zofia user data --out d"}};
    for (const auto& [action, asked] : kCommands) {
        std::string command = asked;
        command.insert(command.rfind(' ') + 1, name);
        EXPECT_EQ(ctl(command, kRight).status, 1) << command;
        const auto entries = db::open_store("sqlite:" + store)->audit().of_action(action);
        ASSERT_EQ(entries.size(), 1u) << command;
        EXPECT_THAT(entries[0].detail, HasSubstr(name)) << command;
    }
}

TEST_F(ExportPrograms, AReportIsWrittenOverNoRecordingAndUnderNoNameOfAnotherKind) {
    fill_store();
    ASSERT_FALSE(HasFatalFailure());
    write_text(file("own.placode"), "the only one of its attempt");
    const Outcome over =
        ctl("--as zofia report seal 1 --out s.txt --recording own.placode", kRight);
    EXPECT_EQ(over.status, 2);
    EXPECT_THAT(over.err, HasSubstr("--recording: own.placode exists and is not overwritten; "));
    EXPECT_EQ(read_text(file("own.placode")), "the only one of its attempt");
    EXPECT_FALSE(fs::exists(file("s.txt")));
    EXPECT_EQ(ctl("--as zofia report seal 1 --out s.txt --recording new.placode", kRight).status,
              0);
    EXPECT_TRUE(fs::exists(file("new.placode")));
    for (const char* command : {"--as zofia report attempt 1 --out a.png",
                                "--as carl report study pilot/1 --out a.png"}) {
        const Outcome named = ctl(command, kRight);
        EXPECT_EQ(named.status, 2) << command;
        EXPECT_THAT(named.err, HasSubstr("--out: found \"a.png\"; expected FILE.pdf")) << command;
    }
    EXPECT_FALSE(fs::exists(file("a.png")));
    EXPECT_EQ(ctl("--as zofia report attempt 1 --out A.PDF", kRight).status, 0);
}

TEST_F(ExportPrograms, WhatLeavesIsForItsOwnerAlone) {
    fill_store();
    ASSERT_FALSE(HasFatalFailure());
    const mode_t before = ::umask(022);
    for (const char* command :
         {"--as zofia report attempt 1 --out a.pdf", "--as zofia report seal 1 --out a.txt",
          "--as zofia report trainee zofia --out t.pdf", "--as ewa report cohort all --out c.pdf",
          "--as carl export csv --study pilot/1 --out e",
          "user erase zofia --confirm zofia --certificate erased.txt"}) {
        const Outcome left = ctl(command, kRight);
        EXPECT_EQ(left.status, 0) << command << ": " << left.err;
    }
    ::umask(before);
    for (const char* made : {"a.pdf", "a.txt", "t.pdf", "c.pdf", "erased.txt"})
        EXPECT_EQ(fs::status(file(made)).permissions(), fs::perms(0600)) << made;
    for (const auto& made : fs::directory_iterator(file("e")))
        EXPECT_EQ(made.status().permissions(), fs::perms(0600)) << made;
    EXPECT_THAT(read_text(file("erased.txt")), testing::StartsWith("Placode: certificate"));
}

TEST_F(Programs, TheStudyOfThePaperRunsAndLeavesInEveryFormat) {
    add_user("carl", "coordinator");
    const auto carl = [&](const std::string& arguments) {
        return ctl("--as carl " + arguments, kRight);
    };
    const Outcome made = carl("study demo");
    ASSERT_EQ(made.status, 0) << made.err;
    EXPECT_THAT(made.out, HasSubstr("14 SIMULATED participants"));
    EXPECT_EQ(carl("study demo").status, 2) << "never twice";
    const Outcome status = carl("--json study status face_content_validity");
    EXPECT_EQ(number_in(status.out, "total"), 8);
    EXPECT_EQ(number_in(status.out, "done"), 3) << "consent and two questionnaires";
    EXPECT_THAT(status.out, HasSubstr("\"next\": \"briefing\""));

    // A person's way through the protocol, and what is refused on it.
    const Outcome enrolled = carl("study enrol face_content_validity");
    const std::string code = enrolled.out.substr(0, 6);
    EXPECT_EQ(code.substr(0, 4), "P015") << enrolled.out;
    const std::string answer = "study answer face_content_validity " + code + " ";
    EXPECT_THAT(carl(answer + "sus sus01=5").err, HasSubstr("needs an answer"));
    const std::string sus =
        "sus sus01=5 sus02=4 sus03=2 sus04=1 sus05=2 sus06=3 sus07=2 sus08=4 sus09=5 sus10=2";
    EXPECT_THAT(carl(answer + sus).err, HasSubstr("has not consented"));
    const std::string consent = "study consent face_content_validity " + code + " --agreed read";
    EXPECT_THAT(carl(consent).err, HasSubstr("\"voluntary\" is required"));
    EXPECT_EQ(carl(consent + " voluntary data").status, 0);
    const Outcome answered = carl("--json " + answer + sus);
    EXPECT_EQ(answered.status, 0) << answered.err;
    EXPECT_EQ(number_in(answered.out, "sus_score"), 55);
    const std::string slip =
        "study correct face_content_validity " + code + " sus sus01=4 --visit 2 --reason slip";
    EXPECT_EQ(carl(slip).status, 2) << "nothing of a second visit yet";
    write_text(file("sheets.csv"),
               "participant,sus01,sus02,sus03,sus04,sus05,sus06,sus07,sus08,"
               "sus09,sus10\n" +
                   code + ",5,4,2,1,2,3,2,4,5,2\n");
    const Outcome taken = carl("study import face_content_validity " + file("sheets.csv") +
                               " --questionnaire sus --visit 2");
    EXPECT_EQ(taken.status, 0) << taken.err;
    const Outcome corrected = carl(slip);
    EXPECT_EQ(corrected.status, 0) << corrected.err;
    EXPECT_EQ(carl("study step face_content_validity " + code + " nap").status, 2);
    EXPECT_EQ(carl("study step face_content_validity P015-Z briefing").status, 2);
    EXPECT_EQ(carl("study step face_content_validity " + code + " briefing").status, 0);
    EXPECT_EQ(
        carl("study withdraw face_content_validity " + code + " --mode stop --reason 'not given'")
            .status,
        0);
    EXPECT_EQ(carl(answer + sus).status, 2) << "nothing more is recorded";

    for (const char* format : {"csv", "spss", "redcap", "fhir", "odm", "xapi", "bundle"}) {
        const Outcome exported = carl(std::string("--json export ") + format +
                                      " --study face_content_validity --out " + format);
        EXPECT_EQ(exported.status, 0) << exported.err;
        EXPECT_THAT(exported.out, AllOf(HasSubstr("\"read_back\": \"identical\""),
                                        HasSubstr("\"demonstration\": true"),
                                        HasSubstr("\"participants_left_out\": 1")));
    }
    EXPECT_EQ(carl("export motion-bids --study face_content_validity").status, 2) << "no attempts";
    const Outcome report = carl("--json report study face_content_validity --out study.pdf");
    EXPECT_EQ(report.status, 0) << report.err;
    EXPECT_THAT(read_text(file("study.pdf")), testing::StartsWith("%PDF-"));
    EXPECT_TRUE(fs::exists(file("study_figures/likert_face_validity_1.svg")));
    write_text(file("blocked"), "");
    EXPECT_EQ(carl("report study face_content_validity --out blocked/s.pdf").status, 2);
    const auto entries = [this] {
        return db::open_store("sqlite:" + store)->audit().of_action("report.study").size();
    };
    EXPECT_EQ(entries(), 1u) << "nothing was begun";
    // A name that no disk takes shows only when the file is made.
    const std::string long_name(300, 's');
    EXPECT_EQ(carl("report study face_content_validity --out " + long_name + ".pdf").status, 1);
    EXPECT_EQ(entries(), 2u) << "the entry comes before the file";
    EXPECT_EQ(carl("report study none --out none.pdf").status, 2);
    EXPECT_FALSE(fs::exists(file("none.pdf")));
    EXPECT_EQ(carl("export word --study face_content_validity").status, 2);
    const std::string wide = read_text(file("csv/face_content_validity_face_validity.csv"));
    EXPECT_THAT(wide, Not(HasSubstr(code)));
    // Names of persons: a coordinator may not, and the reason is needed.
    EXPECT_THAT(carl("export csv --study face_content_validity --identifying 'audit of 2026'").err,
                HasSubstr("personal data"));
    EXPECT_EQ(ctl("export csv --study face_content_validity --identifying no").status, 2);
    EXPECT_EQ(ctl("export csv --study face_content_validity --out n --identifying 'audit of 2026'")
                  .status,
              0);
    EXPECT_THAT(ctl("audit").out, AllOf(HasSubstr("WITH IDENTIFYING FIELDS: audit of 2026"),
                                        HasSubstr("study.withdraw")));
    EXPECT_THAT(carl("questionnaire list").out, AllOf(HasSubstr("sus"), HasSubstr("first use")));
    write_text(file("q.json"), R"({"id":"sus","version":1,"title":{"en":"x"},"items":[
        {"id":"a","kind":"text","text":{"en":"x"}}]})");
    EXPECT_THAT(carl("questionnaire publish q.json").err, HasSubstr("next version"));
}

/// Answers to the SUS with this first one; the others are 3.
std::string sus_answers(int first) {
    std::string answers = " sus sus01=" + std::to_string(first);
    for (const char* item : {"02", "03", "04", "05", "06", "07", "08", "09", "10"})
        answers += std::string(" sus") + item + "=3";
    return answers;
}

// Two sheets of one visit: nobody guesses which one a correction or a second entry belongs to.
TEST_F(Programs, OneOfSeveralSetsOfAnswersIsNamed) {
    ASSERT_EQ(ctl("study demo").status, 0);
    const std::string code = ctl("study enrol face_content_validity --consented").out.substr(0, 6);
    const std::string who = " face_content_validity " + code;
    std::vector<std::string> sets;
    for (const int first : {1, 2}) {
        const Outcome answered = ctl("--json study answer" + who + sus_answers(first));
        ASSERT_EQ(answered.status, 0) << answered.err;
        sets.push_back(std::to_string(static_cast<int>(number_in(answered.out, "answers"))));
    }
    const std::string& later = sets[1];
    const std::string second = "study second-entry" + who + sus_answers(5);
    const std::string correct = "study correct" + who + " sus sus02=4 --reason slip";
    for (const std::string& each : {second, correct}) {
        const Outcome asked = ctl(each);
        EXPECT_EQ(asked.status, 2) << asked.out;
        EXPECT_THAT(asked.err, AllOf(HasSubstr("has 2 sets of answers"), HasSubstr("--set: "),
                                     HasSubstr(sets[0] + " ("), HasSubstr(later + " (")));
    }
    EXPECT_THAT(ctl(second + " --set 1").err, HasSubstr("set 1 is not among the answers"));
    const Outcome entered = ctl("--json " + second + " --set " + later);
    EXPECT_EQ(entered.status, 0) << entered.err;
    EXPECT_EQ(number_in(entered.out, "differences"), 1) << "of the set that was named";
    const Outcome differences = ctl("--json study differences face_content_validity");
    EXPECT_EQ(number_in(differences.out, "answers"), std::stoi(later)) << differences.out;
    EXPECT_THAT(differences.out, HasSubstr("\"first\": \"2\""));
    // One of the two differs in the item: that one is meant, until the other one does, too.
    const std::string decide = "study decide" + who + " sus sus01 --right 2 --reason looked";
    EXPECT_EQ(ctl(second + " --set " + sets[0]).status, 0);
    EXPECT_THAT(ctl(decide).err, HasSubstr("has 2 sets of answers"));
    EXPECT_EQ(ctl(decide + " --set " + later).status, 0);
    EXPECT_EQ(ctl(decide).status, 0);
    EXPECT_THAT(ctl(decide).err, HasSubstr("do not differ in item"));
    EXPECT_EQ(ctl(correct + " --set " + later).status, 0);
    const auto stored =
        db::open_store("sqlite:" + store)->studies().answers("face_content_validity");
    for (const db::AnswerRecord& each : stored) {
        if (each.participant != code) continue;
        EXPECT_EQ(each.answers.at("sus01"), "5");
        EXPECT_EQ(each.answers.at("sus02"), std::to_string(each.id) == later ? "4" : "3");
    }
}

TEST_F(Programs, AProcedureOfAStudyIsJudgedRepeatedAndNotedOnTheCommandLine) {
    add_user("carl", "coordinator");
    const auto carl = [&](const std::string& arguments) {
        return ctl("--as carl " + arguments, kRight);
    };
    ASSERT_EQ(carl("study demo").status, 0);
    // A script operates, which does no step of a participant.
    const std::string code =
        carl("study enrol face_content_validity --consented --demonstration").out.substr(0, 6);
    const std::string of_code = " face_content_validity " + code + " ";
    for (const char* number : {"1", "2"}) {
        const std::string name = std::string(number) + ".placode";
        ASSERT_EQ(run("placode-sim",
                      "--task diathermy_ring --headless --fast --duration 0.3 --study "
                      "--aids '' --device script:expert --record " +
                          name)
                      .status,
                  0);
        ASSERT_EQ(carl("import " + name + " --user carl").status, 0);
    }
    EXPECT_THAT(carl("attempts").out, HasSubstr("carl")) << "nobody's study yet";
    // The minute that the protocol asks for is not over: what was typed does not make it one.
    const Outcome early = carl("study step" + of_code + "procedure_1 --attempt 1");
    EXPECT_EQ(early.status, 0) << early.err;
    EXPECT_THAT(early.out, HasSubstr("started: ended after 0 s"));
    EXPECT_EQ(carl("study repeat" + of_code + "procedure_1 --reason x").status, 2)
        << "it is to be done anyway";
    EXPECT_EQ(carl("study step" + of_code + "familiarisation --attempt 2").status, 0);
    EXPECT_THAT(carl("attempts").out, Not(HasSubstr("carl"))) << "they belong to the code now";
    EXPECT_NE(carl("study repeat" + of_code + "familiarisation").status, 0) << "no reason";
    const Outcome again =
        carl("study repeat" + of_code + "familiarisation --reason 'the pedal was unplugged'");
    EXPECT_EQ(again.status, 0) << again.err;
    EXPECT_EQ(carl("study note" + of_code + "familiarisation 'coughed twice'").status, 0);
    EXPECT_EQ(carl("study note face_content_validity P099-X familiarisation x").status, 2);
    const Outcome list = carl("--json study deviations face_content_validity");
    EXPECT_THAT(list.out,
                AllOf(HasSubstr("ended_early"), HasSubstr("repeated"), HasSubstr("coughed twice"),
                      HasSubstr("the pedal was unplugged"), HasSubstr(code)));
    EXPECT_THAT(carl("study deviations face_content_validity --participant P001-C").out,
                HasSubstr("no deviations"));
    ASSERT_EQ(carl("export csv --study face_content_validity --out csv").status, 0);
    EXPECT_THAT(read_text(file("csv/face_content_validity_deviations.csv")),
                HasSubstr("coughed twice"));
    EXPECT_THAT(ctl("audit").out, AllOf(HasSubstr("study.repeat"), HasSubstr("study.note")));
    // Who erases is told where the data still are, and a restore erases them again.
    ASSERT_EQ(ctl("backup before.db").status, 0);
    const Outcome erased = carl("study withdraw" + of_code + "--mode erase --reason 'not given'");
    EXPECT_EQ(erased.status, 0) << erased.err;
    EXPECT_THAT(erased.out, AllOf(HasSubstr("may still hold the data: "), HasSubstr("before.db")));
    const Outcome restored = ctl("restore before.db");
    EXPECT_EQ(restored.status, 0) << restored.err;
    EXPECT_THAT(restored.out, HasSubstr("face_content_validity " + code + ": erase"));
    EXPECT_THAT(carl("study status face_content_validity").out, HasSubstr("data are erased"));
}

TEST_F(Programs, WhoErasesOverdueRecordsIsToldWhereTheyStillAre) {
    add_user("carl", "coordinator");
    const auto carl = [&](const std::string& arguments) {
        return ctl("--as carl " + arguments, kRight);
    };
    write_text(file("pilot.json"), R"({"id":"pilot","version":1,"title":{"en":"t"},"keep_years":5,)"
                                   R"("consent":{"version":1,"information":[{"en":"i"}],)"
                                   R"("statements":[{"id":"a","text":{"en":"yes"}}]},)"
                                   R"("steps":[{"id":"consent","kind":"consent"},)"
                                   R"({"id":"run","kind":"procedure","task":"diathermy_ring"}]})");
    const Outcome published = carl("study publish pilot.json");
    ASSERT_EQ(published.status, 0) << published.err;
    const Outcome enrolled = carl("study enrol pilot --consented");
    ASSERT_EQ(enrolled.status, 0) << enrolled.err;
    const std::string code = enrolled.out.substr(0, 6);
    ASSERT_EQ(ctl("backup before.db").status, 0);
    const Outcome early = carl("--json study retention pilot --erase");
    EXPECT_EQ(early.status, 0) << early.err;
    EXPECT_THAT(early.out, Not(HasSubstr("before.db"))) << "nothing was erased";
    ASSERT_TRUE(RawConnection("QSQLITE", store)
                    .run("UPDATE study_steps SET at_utc = '2010-01-31T12:00:00.000Z'"));
    const Outcome erased = carl("study retention pilot --erase");
    EXPECT_EQ(erased.status, 0) << erased.err;
    EXPECT_THAT(erased.out, AllOf(HasSubstr("erased: " + code),
                                  HasSubstr("may still hold the data: "), HasSubstr("before.db")));
}

}  // namespace THIS_TEST
