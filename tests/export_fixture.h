// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A small study with every kind of item, one attempt and its recording, to be exported.

#include <gmock/gmock.h>

#include <QProcess>
#include <QStandardPaths>
#include <filesystem>
#include <optional>

#include "db/recording_file.h"
#include "reports/csv_table.h"
#include "reports/export.h"
#include "reports/formats.h"
#include "reports/report.h"
#include "tests/recorded_attempt.h"
#include "tests/store_fixture.h"

namespace placode::test {

inline constexpr const char* kQuestionnaire =
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
        store->definitions().publish(definition);
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
        codes.push_back(store->studies().new_participant("s1", true));
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
        store->studies().save_answers(record);
    }
    void attempts() {
        const int64_t user =
            store->accounts().create({"anna", "Anna Nowak", "correct horse", 1, true});
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
        step.attempt_id = store->attempts().save(user, result);
        store->studies().record_step(step);
        replay_as_identical(*store, step.attempt_id);
    }
    static void write_recording(const std::string& path) {
        const auto sink = db::create_recording_file(path);
        sim::RecordingHeader header;
        header.task_id = "diathermy_ring";
        header.task_json = "{}";
        header.mode = "study";
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
        ASSERT_NO_THROW(reports::export_dataset(source(), format, out())) << format;
    }

    TemporaryFolder folder;
    std::unique_ptr<db::Store> store;
    std::vector<std::string> codes;
};

using Rows = std::vector<std::vector<std::string>>;

inline std::string at(const Rows& rows, size_t row, const std::string& column) {
    for (size_t c = 0; c < rows.at(0).size(); ++c)
        if (rows[0][c] == column) return rows.at(row).at(c);
    ADD_FAILURE() << "no column " << column;
    return {};
}

/// Output of a program, or nothing when it is not installed.
inline std::optional<std::pair<int, QString>> run(const QString& program,
                                                  const QStringList& arguments) {
    const QString path = QStandardPaths::findExecutable(program);
    if (path.isEmpty()) return std::nullopt;
    QProcess process;
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start(path, arguments);
    process.waitForFinished(60000);
    return std::pair(process.exitCode(), QString::fromUtf8(process.readAll()));
}

}  // namespace placode::test
