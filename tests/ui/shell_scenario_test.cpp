// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's study end to end: `placodectl demo` fills a store, then fourteen scripted
// participants go through the published protocol in the real windows, from consent to the last
// question; report and every export come out, are validated, and agree with each other and with
// the store.
//
// Procedures are real attempts of placode-sim, on large elements and cut short after 5 to 9 s, when
// something was done: the others count in no analysis. PLACODE_SCENARIO_PARTICIPANTS=4 is quicker,
// PLACODE_SCENARIO_SECONDS=600 lets every operator finish.

#include <QFileInfo>
#include <QStandardPaths>

#include <algorithm>
#include <cmath>

#include "assessment/statistics.h"
#include "db/consent_encryption.h"
#include "db/study_records.h"
#include "reports/export.h"
#include "scripted_participants.h"
#include "short_study.h"

namespace placode::ui {

class ShellScenarioTest : public QObject {
    Q_OBJECT

 private Q_SLOTS:
    void initTestCase();
    void cleanupTestCase() { people_.shell.reset(); }

    void aParticipantGoesFromConsentToTheLastQuestion_data();
    void aParticipantGoesFromConsentToTheLastQuestion();
    void everybodyIsThroughAndTheAttemptsAreReal();
    void everyAttemptIsTheSameWhenItIsSimulatedAgain();
    void recordsAreEnteredTwiceLockedAndSigned();
    void theKeyHoldsTheNames();
    void everyResultPageShowsItsNumbers();
    void reportComesOut();
    void everyExportIsWrittenAndValid();
    void exportsAgreeWithEachOtherAndWithTheStore();
    void anotherProgramFindsTheReportsNumbers();

 private:
    [[nodiscard]] db::Store& store() { return people_.store(); }
    [[nodiscard]] bool press(const QString& name) { return people_.press(name); }
    [[nodiscard]] QString out(const QString& name) const { return shell_->path("out/" + name); }
    /// Where the export that went into out(name) has put its files.
    [[nodiscard]] QString in(const QString& name) const {
        return ShellHarness::exportedIn(out(name));
    }

    ScriptedParticipants people_;
    ShellHarness* shell_ = nullptr;  ///< Of people_.
};

void ShellScenarioTest::initTestCase() {
    QVERIFY2(QFileInfo(PLACODE_BIN_DIR "/placode-sim").isExecutable() &&
                 QFileInfo(PLACODE_BIN_DIR "/placodectl").isExecutable(),
             "build placode-sim and placodectl first: this test starts them");
    const std::string file =
        (curriculum::data_folder() / "studies" / "face_content_validity_simulated.csv").string();
    people_.answers = reports::parse_csv(reports::read_file(file));
    bool ok = false;
    if (const int wanted = qEnvironmentVariableIntValue("PLACODE_SCENARIO_PARTICIPANTS", &ok); ok)
        people_.count = static_cast<size_t>(wanted);
    QVERIFY(people_.count >= 3 && people_.count < people_.answers.size());
    if (const double wanted = qEnvironmentVariable("PLACODE_SCENARIO_SECONDS").toDouble();
        wanted > 0)
        people_.seconds = wanted;
    people_.shell = std::make_unique<ShellHarness>();
    shell_ = people_.shell.get();
    // The store that `demo` makes: the shell opens it as it finds it.
    const QString url = "sqlite:" + shell_->path("demo.db");
    run_program(PLACODE_BIN_DIR "/placodectl", {"--store", url, "demo", "--attempts", "0"});
    if (QTest::currentTestFailed()) return;
    shell_->start("demo.db");
    QVERIFY(shell_->signIn("demo-coordinator", "placode-demo"));
    QVERIFY(shell_->arrives(PageId::kStudies));
    shell_->confirmNext();  // The shipped consent text is a draft.
    QVERIFY(press("publish_study"));
    QVERIFY(QTest::qWaitFor([&] { return shell_->find<QPushButton>("enrol") != nullptr; }, 10000));
    // The minute that a procedure must last is too long for a test, and the ring's field too large:
    // every attempt is computed twice.
    publish_short_ring(store(), shell_->path("data").toStdString());
    publish_short_study(store(), kStudy, {}, kShortRing);
    shell_->window().open({PageId::kStudies, 0, {}, {}});
    QVERIFY(shell_->arrives(PageId::kStudies));
}

void ShellScenarioTest::aParticipantGoesFromConsentToTheLastQuestion_data() {
    // A row each: Qt Test's watchdog ends a function after five minutes.
    QTest::addColumn<int>("row");
    for (size_t row = 1; row <= people_.count; ++row)
        QTest::addRow("participant %zu", row) << static_cast<int>(row);
}

void ShellScenarioTest::aParticipantGoesFromConsentToTheLastQuestion() {
    QFETCH(int, row);
    QCOMPARE(people_.codes.size(), static_cast<size_t>(row - 1));
    people_.takePart(static_cast<size_t>(row));
}

void ShellScenarioTest::everybodyIsThroughAndTheAttemptsAreReal() {
    QCOMPARE(store().studies().participants(kStudy).size(), people_.count);
    std::map<std::string, int> procedures;
    for (const auto& step : store().studies().steps(kStudy)) {
        if (step.attempt_id <= 0) continue;
        const size_t row =
            1 + static_cast<size_t>(
                    std::find(people_.codes.begin(), people_.codes.end(), step.participant) -
                    people_.codes.begin());
        const int procedure = ++procedures[step.participant];
        const auto attempt = store().attempts().detail(step.attempt_id);
        QCOMPARE(QString::fromStdString(attempt.record.device), ScriptedParticipants::device(row));
        QVERIFY(attempt.record.duration_s >= people_.length_s(row, procedure));
        QVERIFY2(attempt.score.verdict != assessment::Verdict::kNotAttempted, "nothing was done");
        // The instrument moved, and what is kept of it can be scored again.
        QVERIFY(attempt.metrics.find("path_length_mm").value_or(0) > 0);
        const QString file = shell_->path("again.placode");
        QFile::remove(file);
        store().attempts().extract_recording(step.attempt_id, file.toStdString());
        QVERIFY(QFileInfo(file).size() > 0);
    }
    QCOMPARE(procedures.size(), people_.count);
    // Whoever was signed in: what participants did is in nobody's training.
    QVERIFY(store().attempts().list(shell_->idOf("demo-coordinator")).empty());
    QVERIFY(db::study_deviations(store(), kStudy).size() >= people_.count);  // all skipped practice
    for (const std::string& code : people_.codes) {
        QCOMPARE(procedures[code], 3);
        QVERIFY(store().records().consent_signature(kStudy, code).has_value());
        const auto done = people_.progress(code);
        QCOMPARE(done.skipped, std::vector<std::string>{"1/familiarisation"});
        QCOMPARE(done.done, done.total - 1);  // What was skipped was not done.
    }
    shell_->whole("81_scenario_study");
}

// Only then do they count: all that follows here needs them.
void ShellScenarioTest::everyAttemptIsTheSameWhenItIsSimulatedAgain() {
    // They run with what the machine leaves over: beside a compiler 600 s were too few.
    QVERIFY(shell_->replaysEnd(1200));
    for (const auto& step : store().studies().steps(kStudy)) {
        if (step.attempt_id <= 0) continue;
        const auto record = store().attempts().detail(step.attempt_id).record;
        QVERIFY2(record.replay == db::ReplayState::kIdentical && record.void_reason.empty(),
                 record.void_reason.c_str());
    }
}

void ShellScenarioTest::recordsAreEnteredTwiceLockedAndSigned() {
    ShellHarness& shell = *shell_;
    shell.window().open({PageId::kStudyData, 0, {}, {{"study", kStudy}}});
    QVERIFY(shell.arrives(PageId::kStudyData));
    auto* table = shell.find<QTableWidget>("records_table");
    QVERIFY(table != nullptr);
    QCOMPARE(table->rowCount(), static_cast<int>(people_.count));
    // The second entry of the first participant, with one slip.
    table->selectRow(0);
    auto* forms = shell.find<QComboBox>("entry_questionnaire");
    forms->setCurrentIndex(forms->findData("face_validity"));
    QVERIFY(press("enter_second"));
    QVERIFY(shell.arrives(PageId::kParticipant));
    const std::string was = cell(people_.answers, 1, "A"), slip = was == "1" ? "2" : "1";
    for (const auto& item : curriculum::load_questionnaire("face_validity").items) {
        const std::string given = item.id == "A" ? slip : cell(people_.answers, 1, item.id);
        if (given.empty() || item.kind != curriculum::ItemKind::kLikert) continue;
        auto* point =
            shell.find<QRadioButton>(QString::fromStdString("answer_" + item.id + "_" + given));
        QVERIFY(point != nullptr);
        QVERIFY2(!point->isChecked(), "the first entry must not show");
        point->click();
    }
    shell.shot("82_scenario_second_entry");
    QVERIFY(shell.click("review"));
    QVERIFY(shell.click("submit_answers"));
    QVERIFY(shell.arrives(PageId::kStudyData));
    auto* differences = shell.find<QTableWidget>("differences_table");
    QVERIFY(differences != nullptr);
    QCOMPARE(differences->rowCount(), 1);
    QCOMPARE(differences->item(0, 2)->text(), QString("A"));
    shell.whole("83_scenario_differences");
    QVERIFY(shell.type("decide_reason", "looked at the sheet"));
    QVERIFY(press("first_is_right"));
    QVERIFY(QTest::qWaitFor([&] { return db::entry_differences(store(), kStudy).empty(); }, 10000));
    // A signature needs a lock and the password again.
    shell.window().open({PageId::kStudyData, 0, {}, {{"study", kStudy}}});
    QVERIFY(QTest::qWaitFor([&] { return shell.find<QWidget>("differences_table") == nullptr; },
                            10000));
    QVERIFY(press("lock_record"));
    QVERIFY(QTest::qWaitFor(
        [&] { return store().records().states(kStudy)[people_.codes[0]].locked; }, 10000));
    QVERIFY(QTest::qWaitFor(
        [&] {
            auto* now = shell.find<QTableWidget>("records_table");
            return now != nullptr && now->item(0, 3)->text() == "locked";
        },
        10000));
    QVERIFY(shell.type("sign_meaning", "reviewed and complete"));
    QVERIFY(shell.type("sign_password", "not the password"));
    QVERIFY(press("sign_record"));
    QVERIFY(shell.bannerSays("wrong"));
    QVERIFY(shell.type("sign_password", "placode-demo"));
    QVERIFY(press("sign_record"));
    QVERIFY(QTest::qWaitFor(
        [&] { return store().records().states(kStudy)[people_.codes[0]].signature.has_value(); },
        10000));
    QVERIFY(store().records().states(kStudy)[people_.codes[0]].signature_fits);
}

void ShellScenarioTest::theKeyHoldsTheNames() {
    ShellHarness& shell = *shell_;
    shell.window().open({PageId::kStudyData, 0, {}, {{"study", kStudy}}});
    QVERIFY(shell.arrives(PageId::kStudyData));
    const QString path = shell.path("apart/key.placode-key");
    QVERIFY(shell.type("key_path", path));
    QVERIFY(shell.type("key_passphrase", "four quiet grey needles"));
    QVERIFY(press("make_key"));
    QVERIFY(QTest::qWaitFor([&] { return shell.find<QLineEdit>("name_name") != nullptr; }, 20000));
    QVERIFY(shell.type("name_name", "Zofia Przykladowa"));
    QVERIFY(press("name_save"));
    QVERIFY(QTest::qWaitFor(
        [&] {
            auto* names = shell.find<QTableWidget>("names_table");
            return names != nullptr && names->rowCount() == 1;
        },
        20000));
    QTest::qWait(100);  // Lets the new table appear; nothing depends on it.
    shell.scrollTo("name_save");
    shell.keep(shell.window().grab(), "84_scenario_names");
    // Another theme closes the key; what was being typed waits until it is open again.
    QVERIFY(shell.type("name_name", "Half A Name"));
    shell.find<QComboBox>("name_code")->setCurrentIndex(1);
    for (const ThemeKind theme : {ThemeKind::kDark, ThemeKind::kLight}) {
        shell.context().setTheme(theme);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    QVERIFY(shell.find<QLineEdit>("name_name") == nullptr);
    QVERIFY(shell.type("key_passphrase", "four quiet grey needles"));
    QVERIFY(press("open_key"));
    QVERIFY(QTest::qWaitFor([&] { return shell.find<QLineEdit>("name_name") != nullptr; }, 20000));
    QCOMPARE(shell.find<QLineEdit>("name_name")->text(), QString("Half A Name"));
    QCOMPARE(shell.find<QComboBox>("name_code")->currentIndex(), 1);
    for (const QString& file : {path, shell.path("demo.db"), shell.path("demo.db-wal")}) {
        QFile bytes(file);
        if (!bytes.open(QIODevice::ReadOnly)) continue;
        QVERIFY2(!bytes.readAll().contains("Przykladowa"), qPrintable(file));
    }
    // With the key there is no signature in clear any more, but its holder can see each.
    for (const std::string& code : people_.codes)
        QVERIFY(db::is_encrypted(store().records().consent_signature(kStudy, code)->path));
    QCOMPARE(shell.find<QComboBox>("signature_code")->count(),
             static_cast<int>(people_.codes.size()));
    QVERIFY(press("show_signature"));
    QVERIFY(!shell.find<QLabel>("signature_picture")->pixmap().isNull());
    QTest::qWait(100);  // Lets the picture appear; nothing depends on it.
    shell.scrollTo("signature_picture");
    shell.keep(shell.window().grab(), "84_scenario_signature");
    QVERIFY(press("name_hide"));
}

void ShellScenarioTest::everyResultPageShowsItsNumbers() {
    ShellHarness& shell = *shell_;
    for (const char* view :
         {"figures", "construct_validity", "test_retest", "learning_curves", "rater_agreement"}) {
        shell.window().open({PageId::kStudyResults, 0, {}, {{"study", kStudy}, {"view", view}}});
        QVERIFY(shell.arrives(PageId::kStudyResults));
        QVERIFY(QTest::qWaitFor(
            [&] { return shell.window().page()->state().value("view") == view; }, 10000));
        QVERIFY(QTest::qWaitFor([&] { return shell.find<QLabel>("results_outcome") == nullptr; },
                                60000));
        shell.whole(QString("85_scenario_") + view);
        QVERIFY2(shell.fits(), view);
        if (QString(view) == "figures") {
            QVERIFY(shell.find<QWidget>("figure_likert_face_validity_1") != nullptr ||
                    shell.find<QWidget>("figure_likert_face_validity") != nullptr);
            QVERIFY(shell.find<QWidget>("figure_flow") != nullptr);
        } else if (QString(view) == "rater_agreement") {
            // Nobody has rated: the page says what is missing.
            QVERIFY(shell.text("analysis_problem").contains("0"));
        } else {
            auto* table = shell.find<QTableWidget>("analysis_table");
            QVERIFY2(table != nullptr, view);
            QVERIFY(table->rowCount() > 0);
        }
    }
    shell.save_as = out("figures");
    QVERIFY(press("save_results"));
    QVERIFY(shell.bannerSays("files written", 120));
    QVERIFY(QFileInfo(shell.exported() + "/numbers.csv").size() > 1000);
    QVERIFY(QFileInfo(shell.exported() + "/learning_curves_table.csv").exists());
}

void ShellScenarioTest::reportComesOut() {
    ShellHarness& shell = *shell_;
    shell.window().open({PageId::kStudies, 0, {}, {{"study", kStudy}}});
    QVERIFY(shell.arrives(PageId::kStudies));
    shell.save_as = out("study.pdf");
    QDir().mkpath(out({}));
    QVERIFY(press("study_report"));
    QVERIFY(shell.bannerSays("study.pdf", 120));
    QVERIFY(QFileInfo(out("study.pdf")).size() > 20000);
    if (QStandardPaths::findExecutable("pdftotext").isEmpty()) return;
    const QString text = run_program("pdftotext", {"-layout", out("study.pdf"), "-"});
    const QString n = QString::number(people_.count);
    for (const QString& words :
         {QString("DEMONSTRATION"), "enrolled (n = " + n + ")", "consented (n = " + n + ")",
          QString("Methods"), QString("CUSUM"), QString("What this sample can carry")})
        QVERIFY2(text.contains(words), qPrintable(words));
}

void ShellScenarioTest::everyExportIsWrittenAndValid() {
    ShellHarness& shell = *shell_;
    auto* format = shell.find<QComboBox>("study_export_format");
    QVERIFY(format != nullptr);
    QStringList names;
    for (int i = 0; i < format->count(); ++i) names << format->itemData(i).toString();
    QCOMPARE(names.size(), 8);
    for (const QString& name : names) {
        auto* box = shell.find<QComboBox>("study_export_format");
        box->setCurrentIndex(box->findData(name));
        shell.save_as = out(name);
        QVERIFY(press("study_export"));
        QVERIFY2(shell.bannerSays(shell.save_as, 60),
                 qPrintable(name + ": " + shell.window().banner().text()));
        QVERIFY(!QDir(out(name)).isEmpty());
    }
    if (!QStandardPaths::findExecutable("xmllint").isEmpty()) {
        QDirIterator files(shell.path("out"), {"*.xml"}, QDir::Files, QDirIterator::Subdirectories);
        int checked = 0;
        while (files.hasNext()) {
            run_program("xmllint", {"--noout", files.next()});
            ++checked;
        }
        QVERIFY(checked > 0);
    }
    // Every JSON file is one, and every checksum of the bundle is right.
    QDirIterator json(shell.path("out"), {"*.json"}, QDir::Files, QDirIterator::Subdirectories);
    while (json.hasNext()) {
        QFile file(json.next());
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY2(!QJsonDocument::fromJson(file.readAll()).isNull(), qPrintable(file.fileName()));
    }
    QDirIterator sums(out("bundle"), {"*SHA256*", "*sha256*"}, QDir::Files,
                      QDirIterator::Subdirectories);
    QVERIFY(sums.hasNext());
    const QFileInfo list(sums.next());
    QProcess check;
    check.setWorkingDirectory(list.absolutePath());
    check.start("sha256sum", {"--check", "--quiet", list.fileName()});
    QVERIFY(check.waitForFinished(60000));
    QCOMPARE(check.exitCode(), 0);
}

void ShellScenarioTest::exportsAgreeWithEachOtherAndWithTheStore() {
    const QString form = "face_validity";
    for (const std::string item : {"A", "B", "C", "D", "E", "F"}) {
        const QString name = QString::fromStdString(item);
        // The store: what the participants' windows saved is what the script typed.
        Column stored;
        for (const auto& record : store().studies().answers(kStudy))
            if (record.questionnaire_id == form.toStdString())
                stored[record.participant] = record.answers.at(item);
        for (size_t i = 0; i < people_.codes.size(); ++i)
            QCOMPARE(stored[people_.codes[i]], cell(people_.answers, i + 1, item));
        QCOMPARE(csv_column(in("csv"), kStudy, form, item), stored);
        QCOMPARE(fhir_column(in("fhir"), form, name), stored);
        QCOMPARE(redcap_column(in("redcap"), "face_val_" + name.toLower().toStdString()), stored);
        QCOMPARE(odm_column(in("odm"), "I.face_validity." + item), stored);
        QCOMPARE(xapi_column(in("xapi"), form, name), stored);
        if (!QStandardPaths::findExecutable("readstat").isEmpty())
            QCOMPARE(spss_column(in("spss") + "/" + kStudy + "_face_validity.sav", item), stored);
    }
    Column stored;
    for (const auto& [code, value] : csv_column(in("csv"), kStudy, form, "F")) stored[code] = value;
    // The report's own number.
    std::vector<double> values;
    for (const auto& [code, value] : stored) values.push_back(std::stod(value));
    const Rows numbers =
        reports::parse_csv(reports::read_file((in("figures") + "/numbers.csv").toStdString()));
    bool found = false;
    for (const auto& row : numbers)
        if (row[0] == "face_validity" && row[1] == "F" && row[2] == "mean") {
            QVERIFY(std::abs(std::stod(row[3]) - *assessment::mean_of(values)) < 1e-12);
            found = true;
        }
    QVERIFY(found);
}

void ShellScenarioTest::anotherProgramFindsTheReportsNumbers() {
    if (QStandardPaths::findExecutable("Rscript").isEmpty())
        QSKIP("R is not installed; study_report_test holds the numbers against stored values");
    const QString said =
        run_program("Rscript", {PLACODE_SOURCE_DIR "/scripts/study_report.R", in("csv"), kStudy,
                                in("figures") + "/numbers.csv"});
    QVERIFY2(said.contains("numbers agree"), qPrintable(said));
}

}  // namespace placode::ui

int main(int argc, char** argv) {
    placode::ui::prepare_display();
    QApplication application(argc, argv);
    placode::ui::ShellScenarioTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "shell_scenario_test.moc"
