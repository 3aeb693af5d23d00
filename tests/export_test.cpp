// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Every export of a small study with every kind of item: what the files hold, that official schemas
// and other programs accept them, and that a file that differs from the store is never handed out.

// g++ 12 sees an overlap in std::string operations that is not there (GCC 105651).
#pragma GCC diagnostic ignored "-Wrestrict"

#include "reports/export.h"

#include <gmock/gmock.h>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QStandardPaths>
#include <fstream>
#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "db/recording_file.h"
#include "reports/csv_table.h"
#include "reports/formats.h"
#include "reports/report.h"
#include "tests/store_fixture.h"

using namespace placode;
using placode::test::read_text;
using reports::export_dataset;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

namespace {

test::World* const world = test::World::install();

constexpr const char* kQuestionnaire =
    R"({"id":"kinds","version":1,"title":{"en":"Every kind"},"licence":"test",
  "sections":[{"id":"s","title":{"en":"Second part"}}],
  "items":[
   {"id":"by","kind":"likert","text":{"en":"How?"},"scale_min":-2,"scale_max":2,"reverse":true,
    "anchor_low":{"en":"bad"},"anchor_high":{"en":"good"},"not_applicable":true},
   {"id":"B","kind":"likert","text":{"en":"And?"},"scale_min":1,"scale_max":7},
   {"id":"used","kind":"choice","text":{"en":"Used?"},"choices":[{"en":"no"},{"en":"yes | maybe"}]},
   {"id":"which","kind":"multiple","text":{"en":"Which?"},"not_applicable":true,"required":false,
    "choices":[{"en":"a"},{"en":"b"},{"en":"c"}],"show_if":{"item":"used","any_of":["1"]}},
   {"id":"age","kind":"number","text":{"en":"Age"},"number_min":18,"number_max":99,"unit":"years",
    "section":"s","required":false},
   {"id":"day","kind":"date","text":{"en":"Day"},"section":"s","required":false},
   {"id":"line","kind":"visual_analogue","text":{"en":"Line"},"section":"s","required":false,
    "anchor_low":{"en":"none"},"anchor_high":{"en":"all"}},
   {"id":"comment","kind":"text","text":{"en":"=Comment"},"section":"s","required":false},
   {"id":"name","kind":"text","text":{"en":"Name"},"identifying":true,"required":false}],
  "scales":[{"id":"mean_score","title":{"en":"Mean"},"items":["by","B"],"minimum_answered":2}]})";

class Export : public testing::Test {
 protected:
    void SetUp() override {
        db::StoreOptions options;
        options.cheap_passwords = true;
        store = db::open_store("sqlite:" + folder.file("placode.db"), options);
        db::DefinitionRecord definition;
        definition.kind = "questionnaire";
        definition.id = "kinds";
        definition.json = kQuestionnaire;
        store->publish(definition);
        add({{"by", "-2"},
             {"B", "7"},
             {"used", "1"},
             {"which", "0;2"},
             {"age", "42.5"},
             {"day", "1964-02-29"},
             {"line", "63"},
             {"comment", "=HYPERLINK(\"x\"), \"good\"\nza\u017c"},
             {"name", "Anna Nowak"}});
        add({{"by", "NA"}, {"B", "1"}, {"used", "0"}, {"comment", "'+1 <b>&amp;</b>"}});
        // The second answers of a participant make the form repeat.
        save("P001-C", {{"by", "0"}, {"B", "4"}, {"used", "1"}, {"which", "NA"}});
        attempts();
    }
    void add(const curriculum::Answers& answers) {
        codes.push_back(store->new_participant("s1", true));
        save(codes.back(), answers);
    }
    void save(const std::string& code, const curriculum::Answers& answers) {
        db::AnswerRecord record;
        record.study_id = "s1";
        record.participant = code.rfind("P001", 0) == 0 ? codes.at(0) : code;
        record.questionnaire_id = "kinds";
        record.answered_utc = "2026-11-21T10:15:00Z";
        record.answers = answers;
        record.demonstration = true;
        store->save_answers(record);
    }
    void attempts() {
        const int64_t user = store->create_user({"anna", "Anna Nowak", "correct horse", 1, true});
        db::AttemptResult result;
        result.header.task_id = "diathermy_ring";
        result.header.task_version = 1;
        result.header.started_utc = "2026-11-21T10:05:00.000Z";
        result.header.device = "script:expert";
        result.header.demonstration = true;
        result.metrics.values = {{"path_length_mm", 1.0 / 3.0}};
        result.score.points = 88.25;
        result.score.verdict = assessment::Verdict::kPassed;
        result.end = {sim::EndReason::kFinished, 62.5, 7, 0};
        result.recording_file = folder.file("a.placode");
        write_recording(result.recording_file);
        db::StepRecord step;
        step.study_id = "s1";
        step.participant = codes[0];
        step.step = "procedure_1";
        step.attempt_id = store->save_attempt(user, result);
        store->record_step(step);
    }
    static void write_recording(const std::string& path) {
        const auto sink = db::create_recording_file(path);
        sim::RecordingHeader header;
        header.task_id = "diathermy_ring";
        header.task_json = "{}";
        header.tools.resize(2);
        header.tools[1].kind = sim::ToolKind::kScope;
        sink->begin(header);
        std::vector<sim::Sample> samples(100);
        for (size_t i = 0; i < samples.size(); ++i) {
            samples[i].time_s = 0.01 * static_cast<double>(i + 1);
            samples[i].tools[0].tip_m = {0.1F / 3, -1e-7F, static_cast<float>(i)};
        }
        sink->append(std::vector<sim::Input>(1000), samples, {});
        sink->finish({sim::EndReason::kFinished, 1, 7, 0});
    }
    [[nodiscard]] reports::ExportSource source(bool identifying = false) const {
        return {reports::study_dataset(*store, "s1", {identifying, "en"}),
                reports::recordings_of(*store)};
    }
    [[nodiscard]] std::string out(const std::string& name = "") const {
        return folder.file("out") + (name.empty() ? "" : "/" + name);
    }
    void write(const std::string& format) const {
        ASSERT_NO_THROW(export_dataset(source(), format, out())) << format;
    }

    test::TemporaryFolder folder;
    std::unique_ptr<db::Store> store;
    std::vector<std::string> codes;
};

using Rows = std::vector<std::vector<std::string>>;

std::string at(const Rows& rows, size_t row, const std::string& column) {
    for (size_t c = 0; c < rows.at(0).size(); ++c)
        if (rows[0][c] == column) return rows.at(row).at(c);
    ADD_FAILURE() << "no column " << column;
    return {};
}

/// Output of a program, or nothing when it is not installed.
std::optional<std::pair<int, QString>> run(const QString& program, const QStringList& arguments) {
    const QString path = QStandardPaths::findExecutable(program);
    if (path.isEmpty()) return std::nullopt;
    QProcess process;
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start(path, arguments);
    process.waitForFinished(60000);
    return std::pair(process.exitCode(), QString::fromUtf8(process.readAll()));
}

}  // namespace

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
    const auto user = *store->user_by_login("anna");
    export_dataset({reports::user_dataset(*store, user), reports::recordings_of(*store)}, "csv",
                   out("user"));
    EXPECT_THAT(read_text(out("user/user_1_attempts.csv")),
                testing::AllOf(HasSubstr("88.25"), Not(HasSubstr("anna"))));
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

TEST_F(Export, WhoWithdrewAndWantedItIsInNoFile) {
    store->withdraw("s1", codes[1], db::WithdrawalMode::kStop, "asked for it");
    write("csv");
    EXPECT_THAT(read_text(out("s1_kinds.csv")), Not(HasSubstr(codes[1])));
    EXPECT_THAT(read_text(out("s1_participants.csv")), HasSubstr(codes[1])) << "the tombstone";
}

TEST_F(Export, RedcapDictionaryHasTheEighteenColumnsOfTheSample) {
    write("redcap");
    const Rows sample =
        reports::parse_csv(read_text(PLACODE_SOURCE_DIR "/tests/data/formats/redcap_dd.csv"));
    const Rows dictionary = reports::parse_csv(read_text(out("s1_redcap_dictionary.csv")));
    ASSERT_EQ(sample.at(0).size(), 18u);
    EXPECT_EQ(dictionary.at(0), sample.at(0));
    EXPECT_EQ(dictionary.at(1).at(0), "record_id");
    std::set<std::string> names, closed_forms;
    std::string form = dictionary.at(1).at(1);
    bool seen = false;
    for (size_t r = 1; r < dictionary.size(); ++r) {
        const std::string& name = dictionary[r].at(0);
        EXPECT_TRUE(names.insert(name).second) << name;
        EXPECT_LE(name.size(), 26u) << name;
        EXPECT_EQ(name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_"),
                  std::string::npos);
        if (dictionary[r].at(1) != form) {
            closed_forms.insert(form);
            form = dictionary[r].at(1);
        }
        EXPECT_FALSE(closed_forms.contains(form)) << "rows of a form stand together";
        if (at(dictionary, r, "Field Label") != "Which?") continue;
        seen = true;
        EXPECT_EQ(at(dictionary, r, "Field Type"), "checkbox");
        EXPECT_EQ(at(dictionary, r, "Branching Logic (Show field only if...)"),
                  "[kinds_used] = '1'");
        EXPECT_EQ(at(dictionary, r, "Choices, Calculations, OR Slider Labels"),
                  "0, a | 1, b | 2, c | 99, does not apply");
    }
    EXPECT_TRUE(seen);
    const Rows records = reports::parse_csv(read_text(out("s1_redcap_records.csv")));
    for (const std::string& column : records.at(0)) {
        const std::string stem = column.substr(0, column.find("___"));
        const bool own = column.rfind("redcap_repeat_", 0) == 0 || column.ends_with("_complete");
        EXPECT_TRUE(own || names.contains(stem)) << column << " is not in the dictionary";
    }
    EXPECT_EQ(at(records, 2, "redcap_repeat_instrument"), "kinds");
    EXPECT_EQ(at(records, 2, "kinds_which___2"), "1");
    EXPECT_EQ(at(records, 2, "kinds_which___1"), "0");
    EXPECT_EQ(at(records, 2, "kinds_by"), "-2");
}

TEST_F(Export, SpssFileIsReadByReadstatWithLabelsAndMissingCodes) {
    write("spss");
    const auto csv = run("readstat", {QString::fromStdString(out("s1_kinds.sav")), "-"});
    if (!csv) GTEST_SKIP() << "the program readstat (package readstat) is not installed";
    ASSERT_EQ(csv->first, 0) << csv->second.toStdString();
    // The program says on its error stream how many rows it has converted.
    const std::string text = csv->second.toStdString();
    const Rows rows = reports::parse_csv(text.substr(text.find("\"participant")));
    ASSERT_EQ(rows.size(), 4u) << csv->second.toStdString();
    EXPECT_EQ(at(rows, 1, "participant"), codes[0]);
    EXPECT_EQ(std::stod(at(rows, 1, "by_")), -2) << "BY is a word of SPSS";
    EXPECT_EQ(std::stod(at(rows, 1, "which_2")), 1);
    EXPECT_EQ(std::stod(at(rows, 1, "which_1")), 0);
    EXPECT_EQ(std::stod(at(rows, 1, "age")), 42.5);
    EXPECT_EQ(at(rows, 1, "comment"), "=HYPERLINK(\"x\"), \"good\"\nza\u017c");
}

namespace {

/// First complaint of HL7's schema for R4, or nothing.
std::string fhir_problem(const std::string& type, const nlohmann::json& resource) {
    static const nlohmann::json definitions = nlohmann::json::parse(read_text(
        PLACODE_SOURCE_DIR "/tests/data/formats/fhir_r4_questionnaire.schema.json"))["definitions"];
    const nlohmann::json root{{"$ref", "#/definitions/" + type}, {"definitions", definitions}};
    valijson::Schema schema;
    valijson::SchemaParser parser(valijson::SchemaParser::kDraft7);
    parser.populateSchema(valijson::adapters::NlohmannJsonAdapter(root), schema);
    valijson::Validator validator;
    valijson::ValidationResults results;
    if (validator.validate(schema, valijson::adapters::NlohmannJsonAdapter(resource), &results))
        return {};
    std::string text;
    valijson::ValidationResults::Error error;
    while (results.popError(error)) {
        for (const std::string& part : error.context) text += part;
        text += ": " + error.description + "\n";
    }
    return text;
}

nlohmann::json json_of(const std::string& path) { return nlohmann::json::parse(read_text(path)); }

}  // namespace

TEST_F(Export, FhirResourcesFitTheOfficialR4SchemaAndItsCardinalities) {
    write("fhir");
    const std::string samples = PLACODE_SOURCE_DIR "/tests/data/formats/";
    EXPECT_EQ(fhir_problem("Questionnaire", json_of(samples + "questionnaire.json")), "");
    auto wrong = json_of(samples + "questionnaire.json");
    wrong["status"] = "finished";
    EXPECT_NE(fhir_problem("Questionnaire", wrong), "") << "the schema proves nothing";
    int questionnaires = 0, responses = 0;
    for (const auto& entry : fs::directory_iterator(out("s1_fhir"))) {
        const auto resource = json_of(entry.path().string());
        const std::string type = resource["resourceType"];
        EXPECT_EQ(fhir_problem(type, resource), "") << entry;
        EXPECT_TRUE(resource.contains("status")) << entry;
        (type == "Questionnaire" ? questionnaires : responses) += 1;
        if (type != "Questionnaire") continue;
        for (const auto& item : resource["item"]) {
            EXPECT_TRUE(item.contains("linkId") && item.contains("type"));
            EXPECT_NE(item["type"], "coding") << "that is R5";
        }
    }
    EXPECT_EQ(questionnaires, 3);
    EXPECT_EQ(responses, 2 + 3 + 1);
    const auto response =
        json_of(out("s1_fhir/QuestionnaireResponse-kinds-" + codes[0] + "-1.json"));
    EXPECT_EQ(response["questionnaire"], "https://placode.example/Questionnaire/kinds|1");
    EXPECT_EQ(response["subject"]["identifier"]["value"], codes[0]);
    EXPECT_EQ(response["meta"]["tag"][0]["code"], "demonstration");
}

TEST_F(Export, OdmKeepsTheOrderOfElementsAndIsWellFormed) {
    write("odm");
    const QString path = QString::fromStdString(out("s1_odm.xml"));
    if (const auto checked = run("xmllint", {"--noout", path})) {
        EXPECT_EQ(checked->first, 0) << checked->second.toStdString();
    }
    const std::string text = read_text(out("s1_odm.xml"));
    // The sequence of MetaDataVersion in the official schema; another order is refused by it.
    size_t last = 0;
    for (const char* element : {"<GlobalVariables", "<BasicDefinitions", "<MetaDataVersion",
                                "<Protocol>", "<StudyEventDef", "<FormDef", "<ItemGroupDef",
                                "<ItemDef", "<CodeList ", "<ConditionDef", "<ClinicalData"}) {
        const size_t at_first = text.find(element);
        ASSERT_NE(at_first, std::string::npos) << element;
        EXPECT_GT(at_first, last) << element;
        last = at_first;
    }
    EXPECT_THAT(text, HasSubstr("xmlns=\"http://www.cdisc.org/ns/odm/v1.3\""));
    EXPECT_THAT(text, HasSubstr("FileType=\"Snapshot\""));
    EXPECT_THAT(text, HasSubstr("DEMONSTRATION"));
    // An official schema cannot be shipped here; where one is at hand it is used.
    const QString schema = qEnvironmentVariable("PLACODE_ODM_XSD");
    if (!schema.isEmpty()) {
        const auto valid = run("xmllint", {"--nonet", "--noout", "--schema", schema, path});
        ASSERT_TRUE(valid);
        EXPECT_EQ(valid->first, 0) << valid->second.toStdString();
    }
}

TEST_F(Export, XapiStatementsHaveOneActorAndStableIds) {
    write("xapi");
    const auto first =
        QJsonDocument::fromJson(QByteArray::fromStdString(read_text(out("s1_xapi.json")))).array();
    int passed = 0, likert = 0;
    for (const QJsonValue& entry : first) {
        const QString verb = entry["verb"]["id"].toString();
        EXPECT_TRUE(verb.startsWith("http://adlnet.gov/expapi/verbs/"));
        for (const char* forbidden : {"launched", "abandoned", "waived", "satisfied"})
            EXPECT_FALSE(verb.endsWith(forbidden)) << "belongs to the learning system";
        EXPECT_EQ(entry["actor"].toObject().size(), 2);
        EXPECT_FALSE(entry["actor"]["account"]["homePage"].toString().isEmpty());
        EXPECT_EQ(entry["id"].toString().size(), 36);
        likert += entry["object"]["definition"]["interactionType"] == "likert";
        if (!verb.endsWith("passed")) continue;
        ++passed;
        EXPECT_EQ(entry["result"]["score"]["scaled"].toDouble(), 0.8825);
        EXPECT_EQ(entry["result"]["duration"], "PT62.50S");
    }
    EXPECT_EQ(passed, 1);
    EXPECT_EQ(likert, 6);
    export_dataset(source(), "xapi", out("again"));
    const auto second =
        QJsonDocument::fromJson(QByteArray::fromStdString(read_text(out("again/s1_xapi.json"))))
            .array();
    EXPECT_EQ(first[0]["id"], second[0]["id"]) << "a store can tell that it has it already";
}

TEST_F(Export, MotionBidsHasHeaderlessMotionAndOneChannelRowAColumn) {
    write("motion-bids");
    const std::string subject = "sub-P001" + codes[0].substr(5);
    const std::string stem = out("s1_motion-bids/" + subject + "/motion/" + subject +
                                 "_task-diathermyring_tracksys-placode_run-1");
    const Rows motion = reports::parse_csv(read_text(stem + "_motion.tsv"), '\t');
    const Rows channels = reports::parse_csv(read_text(stem + "_channels.tsv"), '\t');
    ASSERT_EQ(motion.size(), 100u);
    EXPECT_EQ(motion[0].size() + 1, channels.size());
    EXPECT_EQ(channels[0],
              (std::vector<std::string>{"name", "component", "type", "tracked_point", "units"}));
    EXPECT_EQ(std::stof(motion[0][1]), 0.1F / 3) << "the same float";
    const auto json =
        QJsonDocument::fromJson(QByteArray::fromStdString(read_text(stem + "_motion.json")));
    EXPECT_EQ(json["SamplingFrequency"].toDouble(), 100);
    EXPECT_EQ(json["TaskName"], "diathermy_ring");
    EXPECT_EQ(json["MotionChannelCount"].toInt() + 1, static_cast<int>(channels.size()));
    EXPECT_TRUE(fs::exists(out("s1_motion-bids/dataset_description.json")));
    EXPECT_THAT(read_text(out("s1_motion-bids/participants.tsv")), HasSubstr(subject));
}

TEST(CsvTable, EveryCellReadsBackToWhatItWas) {
    for (const char* typed : {"", "x", "=1", "'=1", "''=1", "'quoted'", "-5", "@x", "a\tb", "\tx",
                              "line\nbreak", "\"", "a,b", "'", "''"}) {
        const auto rows =
            reports::parse_csv(reports::csv_line({"first", reports::harmless(typed), "last"}));
        ASSERT_EQ(rows.size(), 1u);
        ASSERT_EQ(rows[0].size(), 3u);
        EXPECT_EQ(reports::as_typed(rows[0][1]), typed);
        if (typed[0] != '\0') {
            EXPECT_EQ(std::string("=+-@\t\r").find(rows[0][1][0]), std::string::npos) << typed;
        }
    }
    EXPECT_THROW((void)reports::parse_csv("a,\"b"), reports::ReportError);
}
