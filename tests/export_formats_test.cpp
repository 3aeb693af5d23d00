// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What each format demands: official schemas and grammars, and that other programs read the files.

// g++ 12 sees an overlap in std::string operations that is not there (GCC 105651).
#pragma GCC diagnostic ignored "-Wrestrict"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <fstream>
#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "reports/xapi.h"
#include "tests/export_fixture.h"

using namespace placode;
using namespace placode::test;
using reports::export_dataset;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

namespace THIS_TEST {

World* const world = World::install();

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
    const auto form = json_of(out("s1_fhir/Questionnaire-kinds.json"));
    EXPECT_EQ(response["questionnaire"], form["url"].get<std::string>() + "|1");
    EXPECT_THAT(form["url"].get<std::string>(),
                testing::MatchesRegex("urn:uuid:[0-9a-f]{8}(-[0-9a-f]{4}){3}-[0-9a-f]{12}"));
    EXPECT_EQ(response["subject"]["identifier"]["value"], codes[0]);
    EXPECT_EQ(response["meta"]["tag"][0]["code"], "demonstration");
}

/// Every address in a resource: the values of url, system, questionnaire.
void addresses_in(const nlohmann::json& value, std::vector<std::string>& found) {
    if (value.is_object())
        for (const auto& [key, each] : value.items()) {
            const bool address =
                key == "url" || key == "system" || key == "questionnaire" || key == "homePage";
            if (address && each.is_string()) found.push_back(each);
            addresses_in(each, found);
        }
    if (value.is_array())
        for (const auto& each : value) addresses_in(each, found);
}

std::vector<std::string> addresses_of_files(const std::string& folder) {
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(folder))
        addresses_in(json_of(entry.path().string()), found);
    return found;
}

bool is_hl7(const std::string& address) {
    return address.starts_with("http://hl7.org/") ||
           address.starts_with("http://terminology.hl7.org/");
}

TEST_F(Export, FhirAddressesAreUrnsOfTheStoreOrBelowTheCentresBase) {
    write("fhir");
    const auto urns = addresses_of_files(out("s1_fhir"));
    EXPECT_GT(urns.size(), 20u);
    for (const std::string& address : urns)
        EXPECT_TRUE(is_hl7(address) || address.starts_with("urn:uuid:")) << address;
    // The same store gives the same names, today and after a backup.
    const auto first = json_of(out("s1_fhir/Questionnaire-kinds.json"));
    fs::remove_all(out());
    write("fhir");
    EXPECT_EQ(json_of(out("s1_fhir/Questionnaire-kinds.json"))["url"], first["url"]);
    fs::remove_all(out());
    reports::ExportSource owned = source();
    owned.data =
        reports::study_dataset(*store, "s1", {false, "en", "https://fhir.hospital.org/placode/"});
    reports::export_dataset(owned, "fhir", out());
    for (const std::string& address : addresses_of_files(out("s1_fhir")))
        EXPECT_TRUE(is_hl7(address) || address.starts_with("https://fhir.hospital.org/placode/"))
            << address;
    EXPECT_EQ(json_of(out("s1_fhir/Questionnaire-kinds.json"))["url"],
              "https://fhir.hospital.org/placode/Questionnaire/kinds");
    for (const char* type : {"Questionnaire-kinds"})
        EXPECT_EQ(
            fhir_problem("Questionnaire", json_of(out(std::string("s1_fhir/") + type + ".json"))),
            "");
}

TEST_F(Export, ABaseThatIsNoAddressIsRefused) {
    for (const char* base : {"hospital", "ftp://hospital.org", "https://", "https://h.org/?a=b",
                             "https://h.org/#a", "javascript:alert(1)"})
        EXPECT_THROW((void)reports::study_dataset(*store, "s1", {false, "en", base}),
                     reports::ReportError)
            << base;
}

TEST_F(Export, NoFormatNamesAnAddressOfAnExample) {
    for (const auto& format : reports::export_formats()) {
        if (format.name == std::string("spss")) continue;  // binary; it has no addresses
        write(format.name);
    }
    int files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(out())) {
        if (!entry.is_regular_file()) continue;
        ++files;
        const std::string text = read_text(entry.path().string());
        EXPECT_THAT(text, Not(HasSubstr(".example"))) << entry.path();
        EXPECT_THAT(text, Not(HasSubstr("example.org"))) << entry.path();
    }
    EXPECT_GT(files, 10);
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
    // CDISC's own schema cannot be shipped here; where one is at hand it is used, too.
    const QString schema = qEnvironmentVariable("PLACODE_ODM_XSD");
    if (!schema.isEmpty()) {
        const auto valid = run("xmllint", {"--nonet", "--noout", "--schema", schema, path});
        ASSERT_TRUE(valid);
        EXPECT_EQ(valid->first, 0) << valid->second.toStdString();
    }
}

TEST_F(Export, OdmFitsTheGrammarOfTheElementsItWrites) {
    write("odm");
    const auto checked = [](const std::string& path) {
        return run("xmllint", {"--nonet", "--noout", "--schema",
                               PLACODE_SOURCE_DIR "/tests/data/formats/odm_1_3_2_written.xsd",
                               QString::fromStdString(path)});
    };
    const auto valid = checked(out("s1_odm.xml"));
    if (!valid) GTEST_SKIP() << "xmllint (package libxml2-utils) is not installed";
    EXPECT_EQ(valid->first, 0) << valid->second.toStdString();
    const auto sample = checked(PLACODE_SOURCE_DIR "/tests/data/formats/min_odm.xml");
    EXPECT_EQ(sample->first, 0) << sample->second.toStdString();
    // What must be refused: an attribute less, another order, an item that is not defined.
    const std::string text = read_text(out("s1_odm.xml"));
    for (const auto& [was, is] : std::vector<std::pair<std::string, std::string>>{
             {" Type=\"Scheduled\"", ""},
             {"<ItemData ItemOID=\"I.kinds.B\"", "<ItemData ItemOID=\"I.kinds.nowhere\""},
             {"SoftHard=\"Hard\"", "SoftHard=\"maybe\""},
             {"<Protocol>", "<Description/><Protocol>"}}) {
        std::string changed = text;
        const size_t at = changed.find(was);
        ASSERT_NE(at, std::string::npos) << was;
        changed.replace(at, was.size(), is);
        std::ofstream(out("changed.xml"), std::ios::binary) << changed;
        EXPECT_NE(checked(out("changed.xml"))->first, 0) << was << " -> " << is;
    }
}

TEST_F(Export, HavenReadsLabelsMissingCodesAndMeasureFromTheSpssFile) {
    write("spss");
    const auto said =
        run("Rscript",
            {"-e",
             "if (!requireNamespace('haven', quietly = TRUE)) quit(status = 77);"
             "d <- haven::read_sav(commandArgs(TRUE)[1], user_na = TRUE);"
             "l <- attr(d$by_, 'labels');"
             "cat(nrow(d), d$by_[1], attr(d$by_, 'label'), names(l)[l == -2], names(l)[l == 2],"
             "    length(attr(d$by_, 'na_values')), d$age[1], attr(d$age, 'label'), "
             "    is.na(haven::zap_missing(d$by_)[3]), class(d$by_)[1], d$comment[1], sep = '|')",
             QString::fromStdString(out("s1_kinds.sav"))});
    if (!said || said->first == 77) GTEST_SKIP() << "R with haven (r-cran-haven) is not installed";
    ASSERT_EQ(said->first, 0) << said->second.toStdString();
    EXPECT_EQ(said->second.toStdString(),
              "3|-2|How?|bad|good|3|42.5|Age [years]|TRUE|haven_labelled_spss|=HYPERLINK(\"x\"), "
              "\"good\"\nza\u017c");
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

/// Id to the name of what was answered, with the response, or to the start of the attempt.
std::map<std::string, std::string> told_by(const std::vector<reports::XapiStatement>& statements) {
    std::map<std::string, std::string> told;
    for (const auto& each : statements) {
        const auto json = QJsonDocument::fromJson(QByteArray::fromStdString(each.json));
        const QString name = json["object"]["definition"]["name"]["en"].toString();
        const QString response = json["result"]["response"].toString();
        told[each.id] = each.timestamp + " " + name.toStdString() + " " + response.toStdString();
    }
    return told;
}

TEST_F(Export, XapiIdsStayWithWhatTheyTellOf) {
    const auto save = [&](const std::string& started_utc) {
        db::AttemptResult result;
        result.header.task_id = "diathermy_ring";
        result.header.started_utc = started_utc;
        result.header.demonstration = true;
        result.end = {sim::EndReason::kFinished, 62.5, 7, 0};
        store->attempts().save(store->accounts().find_login("anna")->id, result);
    };
    const auto attempts = [&] {
        return told_by(reports::xapi_statements(
            reports::user_dataset(*store, *store->accounts().find_login("anna"))));
    };
    save("2026-11-21T12:00:00.000Z");
    save("2026-11-21T13:00:00.000Z");
    const auto sent = attempts();
    ASSERT_EQ(sent.size(), 2u);
    save("2026-11-21T11:00:00.000Z");  // Made earlier, and saved late.
    save("2026-11-21T14:00:00.000Z");
    const auto now = attempts();
    EXPECT_EQ(now.size(), 4u);
    for (const auto& [id, what] : sent) {
        ASSERT_TRUE(now.contains(id)) << what;
        EXPECT_EQ(now.at(id), what);
    }
}

TEST_F(Export, XapiIdsOfAnswersOutliveAnotherVersion) {
    const auto sent = told_by(reports::xapi_statements(source().data));
    auto changed = QJsonDocument::fromJson(kQuestionnaire).object();
    changed["version"] = 2;
    db::DefinitionRecord definition;
    definition.kind = "questionnaire";
    definition.id = "kinds";
    definition.version = 2;
    definition.json = QJsonDocument(changed).toJson().toStdString();
    definition.reason = "another version";
    store->definitions().publish(definition);
    db::AnswerRecord record;
    record.study_id = "s1";
    record.participant = codes[0];
    record.questionnaire_id = "kinds";
    record.questionnaire_version = 2;
    record.answered_utc = "2026-11-21T12:15:00Z";
    record.answers = {{"B", "2"}};
    store->studies().save_answers(record);
    const auto data = source().data;
    ASSERT_NE(data.form("kinds_v1"), nullptr) << "the form has another name now";
    const auto now = told_by(reports::xapi_statements(data));
    EXPECT_EQ(now.size(), sent.size() + 1);
    for (const auto& [id, what] : sent) {
        ASSERT_TRUE(now.contains(id)) << what;
        EXPECT_EQ(now.at(id), what);
    }
}

TEST_F(Export, AProcedureThatWasEndedTooEarlyIsFinishedInNoFormat) {
    const auto save = [&](assessment::Verdict verdict, const std::string& not_done) {
        db::AttemptResult early;
        early.header.task_id = "diathermy_ring";
        early.header.started_utc = "2026-11-21T11:05:00.000Z";
        early.header.mode = "study";
        early.score.verdict = verdict;
        early.end = {sim::EndReason::kFinished, 2.5, 7, 0};
        db::StepRecord step;
        step.study_id = "s1";
        step.participant = codes[1];
        step.step = "procedure_1";
        step.state = db::StepState::kStarted;
        step.detail = not_done;
        step.attempt_id = save_recorded(*store, store->accounts().find_login("anna")->id, early,
                                        folder.path().string());
        store->studies().record_step(step);
        replay_as_identical(*store, step.attempt_id);
    };
    const std::string why = "ended after 2 s, before the least duration of 60 s";
    save(assessment::Verdict::kPassed, why);
    save(assessment::Verdict::kNotAttempted, why);
    const auto made = source();
    const reports::Form* attempts = made.data.form("attempts");
    ASSERT_NE(attempts, nullptr);
    int early = 0;
    for (const reports::Row& row : attempts->rows) {
        if (row.participant != codes[1]) continue;
        ++early;
        EXPECT_FALSE(row.counts) << "no analysis uses it";
        EXPECT_EQ(row.values.at("counts"), "0");
        EXPECT_EQ(row.values.at("not_done"), why);
    }
    EXPECT_EQ(early, 2);
    for (const auto& format : reports::export_formats())  // each is read back and compared
        EXPECT_FALSE(export_dataset(made, format.name, out(format.name)).empty()) << format.name;
    const auto statements =
        QJsonDocument::fromJson(QByteArray::fromStdString(read_text(out("xapi/s1_xapi.json"))))
            .array();
    for (const QJsonValue& entry : statements) {
        const QString verb = entry["verb"]["id"].toString();
        for (const char* forbidden : {"launched", "abandoned", "waived", "satisfied"})
            EXPECT_FALSE(verb.endsWith(forbidden)) << "belongs to the learning system";
        if (entry["result"]["duration"] != "PT2.50S") continue;
        --early;
        EXPECT_FALSE(verb.endsWith("passed") || verb.endsWith("failed")) << verb.toStdString();
        EXPECT_FALSE(entry["result"]["completion"].toBool()) << "it is to be done again";
        EXPECT_FALSE(entry["result"].toObject().contains("success"));
    }
    EXPECT_EQ(early, 0) << "both are told";
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

}  // namespace THIS_TEST
