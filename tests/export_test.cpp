// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Every export of a small study with every kind of item: that a file that differs from the store is
// never handed out, that names stay, and what the CSV files hold.

// g++ 12 sees an overlap in std::string operations that is not there (GCC 105651).
#pragma GCC diagnostic ignored "-Wrestrict"

#include "reports/export.h"

#include <sys/stat.h>

#include <QJsonArray>
#include <QJsonDocument>
#include <filesystem>
#include <fstream>

#include "curriculum/study.h"
#include "db/study_conduct.h"
#include "db/study_records.h"
#include "tests/export_fixture.h"

using namespace placode;
using namespace placode::test;
using reports::export_dataset;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

namespace THIS_TEST {

World* const world = World::install();

TEST_F(Export, AFileForItsOwnerAloneIsWholeOrAsItWas) {
    const mode_t before = ::umask(022);
    fs::create_directories(out("place"));
    const std::string path = out("place") + "/anna.txt";
    std::ofstream(path) << "open to everybody";
    ASSERT_EQ(fs::status(path).permissions(), fs::perms(0644));
    reports::save_private_file(path, "hers");
    EXPECT_EQ(fs::status(path).permissions(), fs::perms(0600));
    EXPECT_EQ(read_text(path), "hers");
    reports::save_private_file(out("place") + "/new.txt", "hers");
    EXPECT_EQ(fs::status(out("place") + "/new.txt").permissions(), fs::perms(0600));
    EXPECT_EQ(std::distance(fs::directory_iterator(out("place")), {}), 2) << "nothing lies beside";
    try {
        reports::save_private_file(path + "/below.txt", "hers");
        ADD_FAILURE() << "a file is no folder";
    } catch (const reports::ReportError& error) {
        EXPECT_THAT(error.what(), testing::StartsWith("write " + path + "/below.txt: "));
    }
    EXPECT_EQ(read_text(path), "hers");
    ::umask(before);
}

TEST_F(Export, EveryFormatIsWrittenAndReadBack) {
    for (const auto& format : reports::export_formats()) {
        const auto files = export_dataset(source(), format.name, out(format.name));
        EXPECT_FALSE(files.empty()) << format.name;
        for (const auto& file : files) {
            EXPECT_TRUE(fs::exists(out(format.name) + "/" + file.path)) << file.path;
            EXPECT_EQ(file.sha256.size(), 64u);
        }
        for (const auto& entry : fs::directory_iterator(out(format.name)))
            EXPECT_NE(entry.path().filename().string()[0], '.') << "staging is left: " << entry;
        // Nobody else on this computer reads them.
        const auto open_to_others = [](const fs::path& path) {
            return (fs::status(path).permissions() &
                    (fs::perms::group_all | fs::perms::others_all)) != fs::perms::none;
        };
        EXPECT_FALSE(open_to_others(out(format.name))) << format.name;
        for (const auto& entry : fs::recursive_directory_iterator(out(format.name)))
            EXPECT_FALSE(open_to_others(entry.path())) << entry;
    }
}

TEST_F(Export, OneThatIsStoppedHandsOutNothing) {
    for (const auto& format : reports::export_formats()) {
        auto paced = source();
        int parts = 0;
        size_t recordings = 0;
        paced.pace.progress = [&](const reports::ExportPart& part) {
            ++parts;
            recordings += part.all;
            EXPECT_FALSE(part.name.empty()) << format.name;
            EXPECT_LE(part.done, part.all) << format.name;
        };
        EXPECT_FALSE(export_dataset(paced, format.name, out(format.name)).empty());
        EXPECT_GE(parts, 3) << format.name << ": before, between, before it is handed out";
        const bool has_recordings =
            format.write == reports::write_motion_bids || format.write == reports::write_bundle;
        EXPECT_EQ(recordings, has_recordings ? 2U : 0U) << format.name << ": written and read back";
        for (int at = 1; at <= parts; ++at) {
            int asked = 0;
            paced.pace = {[&] { return ++asked == at; }, {}};
            EXPECT_THROW(export_dataset(paced, format.name, out("stopped")), reports::ExportStopped)
                << format.name << ", " << at;
            EXPECT_FALSE(fs::exists(out("stopped"))) << format.name << ", " << at;
        }
    }
}

TEST_F(Export, AFileThatDiffersFromTheStoreIsNotHandedOut) {
    for (const auto& format : reports::export_formats()) {
        if (std::string(format.name) == "bundle" || std::string(format.name) == "motion-bids")
            continue;
        const std::string place = out(format.name);
        fs::create_directories(place);
        format.write(source(), place);
        // What is in the files is now one answer behind the store.
        auto changed = source();
        for (auto& form : changed.data.forms)
            if (form.id == "kinds") form.rows[0].values["B"] = "6";
        try {
            format.verify(changed, place);
            ADD_FAILURE() << format.name << " accepted a wrong answer";
        } catch (const reports::ReportError& error) {
            EXPECT_THAT(error.what(), HasSubstr("kinds|" + codes[0] + "|1|B")) << format.name;
            EXPECT_THAT(error.what(), HasSubstr("\"6\"")) << format.name;
        }
        auto missing = source();
        for (auto& form : missing.data.forms)
            if (form.id == "kinds") form.rows[2].values.erase("comment");
        EXPECT_THROW(format.verify(missing, place), reports::ReportError) << format.name;
    }
}

TEST_F(Export, AWrongRecordingIsFoundInMotionBids) {
    fs::create_directories(out());
    reports::write_motion_bids(source(), out());
    auto changed = source();
    const auto real = changed.recording;
    changed.recording = [real](int64_t id) {
        auto recording = real(id);
        recording->samples[50].tools[0].tip_m[1] += 1e-6F;
        return recording;
    };
    try {
        reports::verify_motion_bids(changed, out());
        FAIL() << "accepted";
    } catch (const reports::ReportError& error) {
        EXPECT_THAT(error.what(), HasSubstr("row 51"));
    }
}

TEST_F(Export, RepeatsNotesAndDeviationsLeaveInEveryFormat) {
    db::StudyRecords& records = store->records();
    records.note_step("s1", codes[0], 1, "procedure_1", "coughed; twice");
    records.repeat_step("s1", codes[0], 1, "procedure_1", "the pedal was unplugged");
    const auto made = source();
    const reports::Form* attempts = made.data.form("attempts");
    ASSERT_NE(attempts, nullptr);
    EXPECT_EQ(attempts->rows.at(0).values.at("superseded"), "1");
    EXPECT_EQ(attempts->rows[0].values.at("superseded_reason"), "the pedal was unplugged");
    EXPECT_EQ(attempts->rows[0].values.at("counts"), "0");
    EXPECT_EQ(attempts->rows[0].values.at("note"), "coughed; twice");
    EXPECT_FALSE(attempts->rows[0].counts) << "no analysis uses it";
    EXPECT_EQ(attempts->field("superseded_by"), nullptr) << "whose decision it was is a name";
    EXPECT_NE(source(true).data.form("attempts")->field("superseded_by"), nullptr);
    const reports::Form* deviations = made.data.form("deviations");
    ASSERT_NE(deviations, nullptr);
    ASSERT_EQ(deviations->rows.size(), 2u);
    EXPECT_THAT(deviations->rows[0].values.at("what"), HasSubstr("the pedal was unplugged"));
    for (const auto& format : reports::export_formats())  // Each is read back and compared.
        EXPECT_FALSE(export_dataset(made, format.name, out(format.name)).empty()) << format.name;
    const Rows rows = reports::parse_csv(read_text(out("csv") + "/s1_deviations.csv"));
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_EQ(at(rows, 1, "kind"), "4");
    EXPECT_THAT(read_text(out("xapi") + "/s1_xapi.json"), HasSubstr("verbs/terminated"))
        << "what does not count is neither passed nor failed";
}

TEST_F(Export, AnswersBeforeAndAfterSayOfWhichStepTheyAre) {
    const auto answer_at = [&](const std::string& step_id, const std::string& value) {
        db::AnswerRecord record;
        record.study_id = "s1";
        record.participant = codes[1];
        record.questionnaire_id = "kinds";
        record.answered_utc = "2026-11-21T12:15:00Z";
        record.answers = {{"by", "1"}, {"B", value}, {"used", "0"}};
        db::StepRecord step;
        step.study_id = "s1";
        step.participant = codes[1];
        step.step = step_id;
        step.answer_id = store->studies().save_answers(record);
        store->studies().record_step(step);
    };
    answer_at("before", "2");
    EXPECT_EQ(source().data.form("kinds")->field("step"), nullptr) << "there is one step only";
    answer_at("after", "6");
    const auto made = source();
    const reports::Form* form = made.data.form("kinds");
    ASSERT_NE(form->field("step"), nullptr);
    std::map<std::string, std::string> found;
    for (const reports::Row& row : form->rows)
        if (const auto step = row.values.find("step"); step != row.values.end())
            found[step->second] = row.values.at("B");
    const std::map<std::string, std::string> expected{{"before", "2"}, {"after", "6"}};
    EXPECT_EQ(found, expected);
    for (const auto& format : reports::export_formats())  // Each is read back and compared.
        EXPECT_FALSE(export_dataset(made, format.name, out(format.name)).empty()) << format.name;
    std::set<std::string> written;
    const Rows rows = reports::parse_csv(read_text(out("csv") + "/s1_kinds.csv"));
    for (size_t r = 1; r < rows.size(); ++r) written.insert(at(rows, r, "step"));
    EXPECT_EQ(written, (std::set<std::string>{"", "after", "before"}));
}

TEST_F(Export, AFailedExportLeavesTheFolderAsItWas) {
    auto broken = source();
    for (auto& form : broken.data.forms)  // More than SPSS can hold.
        if (form.id == "kinds") form.rows[0].values["comment"] = std::string(40000, 'x');
    fs::create_directories(out());
    EXPECT_THROW(export_dataset(broken, "spss", out()), reports::ReportError);
    EXPECT_TRUE(fs::is_empty(out()));
    EXPECT_THROW(export_dataset(source(), "word", out()), reports::ReportError);
    write("motion-bids");
    EXPECT_THROW(export_dataset(source(), "motion-bids", out()), reports::ReportError)
        << "a folder that is there is not mixed with another export";
}

TEST_F(Export, CsvTellsMissingFromNotAskedAndNeutralisesFormulas) {
    write("csv");
    const Rows wide = reports::parse_csv(read_text(out("s1_kinds.csv")));
    ASSERT_EQ(wide.size(), 4u);
    EXPECT_EQ(at(wide, 1, "comment"), "'=HYPERLINK(\"x\"), \"good\"\nza\u017c");
    EXPECT_EQ(at(wide, 3, "comment"), "''+1 <b>&amp;</b>") << "so that it can be undone";
    EXPECT_EQ(at(wide, 1, "by"), "-2") << "a number stays a number";
    EXPECT_EQ(at(wide, 1, "mean_score"), "4.5") << "(2 + 7) / 2: the first item is reverse-keyed";
    EXPECT_EQ(at(wide, 3, "mean_score"), "");
    EXPECT_EQ(at(wide, 2, "instance"), "2");
    const std::string all = read_text(out("s1_long.csv"));
    EXPECT_THAT(all,
                HasSubstr(codes[1] + ",kinds,1,2026-11-21T10:15:00Z,en,1,1,which,,,not asked"));
    EXPECT_THAT(all, HasSubstr("by,NA,,not applicable"));
    EXPECT_THAT(all, HasSubstr("age,,,not answered"));
    const Rows book = reports::parse_csv(read_text(out("s1_codebook.csv")));
    bool found = false;
    for (size_t r = 1; r < book.size(); ++r) {
        if (at(book, r, "item") != "by") continue;
        found = true;
        EXPECT_EQ(at(book, r, "values"), "'-2 = bad | -1 | 0 | 1 | 2 = good");
        EXPECT_EQ(at(book, r, "reverse_keyed"), "yes");
    }
    EXPECT_TRUE(found);
}

TEST_F(Export, NamesLeaveOnlyWithPermission) {
    write("bundle");
    for (const auto& entry : fs::recursive_directory_iterator(out())) {
        if (!entry.is_regular_file()) continue;
        EXPECT_THAT(read_text(entry.path().string()), Not(HasSubstr("Nowak"))) << entry;
    }
    export_dataset(source(true), "csv", out("named"));
    EXPECT_THAT(read_text(out("named/s1_kinds.csv")), HasSubstr("Anna Nowak"));
    // The attempt of the study is the participant's; this one is the person's own.
    const auto user = *store->accounts().find_login("anna");
    db::AttemptResult own;
    own.header.task_id = "diathermy_ring";
    own.header.started_utc = "2026-11-21T11:05:00.000Z";
    own.score.points = 77.75;
    store->attempts().save(user.id, own);
    export_dataset({reports::user_dataset(*store, user), reports::recordings_of(*store)}, "csv",
                   out("user"));
    EXPECT_THAT(
        read_text(out("user/user_1_attempts.csv")),
        testing::AllOf(HasSubstr("77.75"), Not(HasSubstr("88.25")), Not(HasSubstr("anna"))));
}

TEST_F(Export, TheChecksumsOfTheBundleAreThoseOfSha256sum) {
    write("bundle");
    const auto result = run("sh", {"-c", "cd '" + QString::fromStdString(out("s1_bundle")) +
                                             "' && sha256sum --strict -c SHA256SUMS"});
    ASSERT_TRUE(result);
    EXPECT_EQ(result->first, 0) << result->second.toStdString();
    const auto manifest = QJsonDocument::fromJson(
        QByteArray::fromStdString(read_text(out("s1_bundle/manifest.json"))));
    EXPECT_TRUE(manifest["demonstration"].toBool());
    EXPECT_GT(manifest["files"].toArray().size(), 15);
    EXPECT_EQ(read_text(out("s1_bundle/definitions/kinds_v1.json")), kQuestionnaire);
}

TEST_F(Export, VisitsAndStepsAreToldInEveryFormat) {
    db::AnswerRecord record;
    record.study_id = "s1";
    record.participant = codes[1];
    record.questionnaire_id = "kinds";
    record.answered_utc = "2026-11-22T10:15:00Z";
    record.visit = 2;
    record.answers = {{"by", "1"}, {"B", "2"}, {"used", "0"}};
    store->studies().save_answers(record);
    for (const auto& format : reports::export_formats()) {
        if (std::string(format.name) == "motion-bids") continue;
        EXPECT_NO_THROW(export_dataset(source(), format.name, out(format.name))) << format.name;
    }
    const Rows rows = reports::parse_csv(read_text(out("csv/s1_kinds.csv")));
    ASSERT_EQ(rows.size(), 5u);
    std::map<std::string, std::string> visit_of;
    for (size_t r = 1; r < rows.size(); ++r)
        if (at(rows, r, "participant") == codes[1])
            visit_of[at(rows, r, "B")] = at(rows, r, "visit");
    EXPECT_EQ(visit_of, (std::map<std::string, std::string>{{"1", "1"}, {"2", "2"}}));
    EXPECT_EQ(at(reports::parse_csv(read_text(out("csv/s1_attempts.csv"))), 1, "step"),
              "procedure_1");
}

TEST_F(Export, WhoWithdrewAndWantedItIsInNoFile) {
    store->studies().withdraw("s1", codes[1], db::WithdrawalMode::kStop, "asked for it");
    write("csv");
    EXPECT_THAT(read_text(out("s1_kinds.csv")), Not(HasSubstr(codes[1])));
    EXPECT_THAT(read_text(out("s1_participants.csv")), HasSubstr(codes[1])) << "the tombstone";
}

TEST_F(Export, WhoConsentedToWhatAndWhenIsInEveryFormat) {
    constexpr const char* kStudy = "face_content_validity";
    const curriculum::StudyProtocol protocol = curriculum::load_study(kStudy);
    db::DefinitionRecord study;
    study.kind = "study";
    study.id = kStudy;
    study.version = protocol.version;
    study.json = protocol.json;
    store->definitions().publish(study);
    std::vector<std::string> agreed;
    for (const auto& statement : protocol.consent.statements) agreed.push_back(statement.id);
    const std::string one = store->studies().new_participant(kStudy, true);
    const std::string two = store->studies().new_participant(kStudy, true);
    (void)store->studies().new_participant(kStudy, true);
    db::record_consent(*store, kStudy, one, "pl", agreed);
    db::record_consent(*store, kStudy, two, "en", agreed, "M0 0L1 1");
    const reports::ExportSource source{reports::study_dataset(*store, kStudy, {false, "en"}),
                                       reports::recordings_of(*store)};
    for (const auto& format : reports::export_formats()) {
        if (std::string(format.name) == "motion-bids") continue;
        EXPECT_NO_THROW(export_dataset(source, format.name, out(format.name))) << format.name;
    }
    const Rows rows =
        reports::parse_csv(read_text(out("csv/face_content_validity_participants.csv")));
    EXPECT_EQ(at(rows, 1, "consent_version"), std::to_string(protocol.consent.version));
    EXPECT_EQ(at(rows, 1, "consent_language"), "pl");
    EXPECT_THAT(at(rows, 1, "consent_agreed"), HasSubstr(agreed.front() + " "));
    EXPECT_EQ(at(rows, 1, "consent_utc").substr(0, 2), "20");
    EXPECT_EQ(at(rows, 1, "consent_checksum").size(), 64u);
    EXPECT_EQ(at(rows, 1, "consent_signed"), "0");
    EXPECT_EQ(at(rows, 2, "consent_signed"), "1");
    EXPECT_EQ(at(rows, 3, "consent_utc"), "") << "who gave none";
    EXPECT_THAT(read_text(out("odm/face_content_validity_odm.xml")),
                HasSubstr("ItemOID=\"I.participants.consent_language\" Value=\"pl\""));
}

/// @param warm_up a step in front of the procedure, or none
std::string amended_study(int version, const std::string& arms, const std::string& warm_up) {
    return R"({"id":"amended","version":)" + std::to_string(version) +
           R"(,"title":{"en":"t"},"arms":{"names":[)" + arms + R"(],"block_size":2},"steps":[)" +
           warm_up + R"({"id":"run","kind":"procedure","task":"diathermy_ring"}]})";
}

TEST_F(Export, StepsAndArmsAreThoseOfTheParticipantsVersion) {
    db::DefinitionRecord study;
    study.kind = "study";
    study.id = "amended";
    study.json = amended_study(1, R"({"en":"x"},{"en":"y"})",
                               R"({"id":"warm_up","kind":"familiarisation",)"
                               R"("task":"diathermy_ring","max_s":60},)");
    store->definitions().publish(study);
    db::StepRecord step;
    step.study_id = study.id;
    step.participant = store->studies().new_participant(study.id, true);
    step.step = "warm_up";
    db::AttemptResult result;
    result.header.task_id = "diathermy_ring";
    result.header.started_utc = "2026-11-21T10:05:00.000Z";
    result.header.mode = "study";
    result.header.demonstration = true;
    result.study = {step.study_id, step.participant};
    step.attempt_id = store->attempts().save(store->accounts().find_login("anna")->id, result);
    store->studies().record_step(step);

    // As an earlier program let it be published: the arms have changed places.
    RawConnection raw("QSQLITE", folder.file("placode.db"));
    ASSERT_TRUE(
        raw.run("INSERT INTO definitions (kind, id, version, content, checksum, reason, "
                "published_by, published_utc) VALUES ('study', 'amended', 2, '" +
                amended_study(2, R"({"en":"y"},{"en":"x"})", "") +
                "', '', 'r', 'anna', '2026-11-21T10:15:00Z')"))
        << raw.problem();
    (void)store->studies().new_participant(study.id, true);
    const auto all = store->studies().participants(study.id);
    ASSERT_EQ(all.size(), 2u);
    ASSERT_NE(all[0].arm, all[1].arm) << "a block of two";

    const auto data = reports::study_dataset(*store, study.id, {false, "en"});
    EXPECT_EQ(data.version, 2);
    EXPECT_EQ(data.form("attempts"), nullptr) << "getting used to the instruments is no data";
    const reports::Form* people = data.form("participants");
    ASSERT_NE(people, nullptr);
    const reports::Field* arm = people->field("arm");
    ASSERT_NE(arm, nullptr);
    ASSERT_EQ(arm->codes.size(), 2u);
    const std::string name = all[0].arm == 0 ? "x" : "y";
    for (const reports::Row& row : people->rows)
        EXPECT_EQ(arm->codes.at(std::stoul(row.values.at("arm"))).label, name) << row.participant;
}

TEST_F(Export, LockAndSignatureOfARecordAreInEveryFormat) {
    store->records().lock("s1", codes[0]);
    store->records().sign("s1", codes[0], "anna", "correct horse", "reviewed");
    for (const auto& format : reports::export_formats()) {
        if (std::string(format.name) == "motion-bids") continue;
        EXPECT_NO_THROW(export_dataset(source(), format.name, out(format.name))) << format.name;
    }
    const Rows rows = reports::parse_csv(read_text(out("csv/s1_participants.csv")));
    EXPECT_EQ(at(rows, 1, "record_locked"), "1");
    EXPECT_EQ(at(rows, 1, "signature_meaning"), "reviewed");
    EXPECT_EQ(at(rows, 1, "signature_fits"), "1");
    EXPECT_EQ(at(rows, 1, "signed_checksum").size(), 64u);
    EXPECT_EQ(at(rows, 2, "record_locked"), "0");
    EXPECT_EQ(at(rows, 2, "signed_utc"), "");
    EXPECT_THAT(read_text(out("odm/s1_odm.xml")),
                HasSubstr("ItemOID=\"I.participants.signature_meaning\" Value=\"reviewed\""));
    for (const auto& entry : fs::recursive_directory_iterator(out())) {
        if (!entry.is_regular_file()) continue;
        EXPECT_THAT(read_text(entry.path().string()), Not(HasSubstr("Anna Nowak"))) << entry;
    }
    export_dataset(source(true), "csv", out("named"));
    EXPECT_THAT(read_text(out("named/s1_participants.csv")), HasSubstr("Anna Nowak"));
}

TEST(CsvTable, EveryCellReadsBackToWhatItWas) {
    for (const char* typed :
         {"",        "x",    "=1",    "'=1",         "''=1",    "'quoted'",    "-5",
          "@x",      "a\tb", "\tx",   "line\nbreak", "\"",      "a,b",         "'",
          "''",      "x;=1", "x;'=1", ";;=1;-2",     "a\t\t=1", "a\n=1\r\n@b", "x;\"=1",
          "x;\"'=1", "\"=1", "a;'",   ";",           "\n"}) {
        const auto rows =
            reports::parse_csv(reports::csv_line({"first", reports::harmless(typed), "last"}));
        ASSERT_EQ(rows.size(), 1u);
        ASSERT_EQ(rows[0].size(), 3u);
        EXPECT_EQ(reports::as_typed(rows[0][1]), typed);
        // However a spreadsheet parts the text: no cell of it is a formula.
        std::string part;
        for (const char c : rows[0][1] + ";") {
            if (std::string(";\t\n\r").find(c) == std::string::npos) {
                if (c != '"' || !part.empty()) part += c;
                continue;
            }
            if (!part.empty()) {
                EXPECT_EQ(std::string("=+-@").find(part[0]), std::string::npos) << typed;
            }
            part.clear();
        }
        if (typed[0] != '\0') {
            EXPECT_EQ(std::string("=+-@\t\r").find(rows[0][1][0]), std::string::npos) << typed;
        }
    }
    EXPECT_EQ(reports::harmless("x;=HYPERLINK(\"a\")"), "x;'=HYPERLINK(\"a\")");
    EXPECT_EQ(reports::harmless("to do:\n- rest; then -1"), "to do:\n'- rest; then -1");
    EXPECT_THROW((void)reports::parse_csv("a,\"b"), reports::ReportError);
}

}  // namespace THIS_TEST
