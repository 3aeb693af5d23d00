// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's study end to end: `placodectl demo` fills a store, then scripted participants go
// through the published protocol in the real windows, from consent to the last question; report
// and every export come out, are validated, and agree with each other and with the store.
//
// Four participants by default. PLACODE_SCENARIO_PARTICIPANTS=14 runs the paper's fourteen (their
// answers are those of `placodectl study demo`), PLACODE_SCENARIO_SECONDS longer procedures.

#include <QApplication>
#include <QCheckBox>
#include <QDirIterator>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QPlainTextEdit>
#include <QProcess>
#include <QRadioButton>
#include <QSlider>
#include <QStandardPaths>
#include <QXmlStreamReader>
#include <cmath>

#include "assessment/statistics.h"
#include "curriculum/questionnaire.h"
#include "curriculum/study.h"
#include "db/study_conduct.h"
#include "db/study_records.h"
#include "reports/csv_table.h"
#include "reports/export.h"
#include "shell_harness.h"

namespace placode::ui {

namespace {

constexpr const char* kStudy = "face_content_validity";
constexpr int kPatienceMs = 240000;  ///< The field takes a busy machine long to build.

using Rows = std::vector<std::vector<std::string>>;

std::string cell(const Rows& rows, size_t row, const std::string& column) {
    for (size_t c = 0; c < rows.at(0).size(); ++c)
        if (rows[0][c] == column) return rows.at(row).at(c);
    return {};
}

/// Participant to answer of one item.
using Column = std::map<std::string, std::string>;

}  // namespace

class ShellScenarioTest : public QObject {
    Q_OBJECT

 private Q_SLOTS:
    void initTestCase();
    void cleanupTestCase() { shell_.reset(); }

    void participantsGoFromConsentToTheLastQuestion();
    void recordsAreEnteredTwiceLockedAndSigned();
    void theKeyHoldsTheNames();
    void everyResultPageShowsItsNumbers();
    void reportComesOut();
    void everyExportIsWrittenAndValid();
    void exportsAgreeWithEachOtherAndWithTheStore();
    void anotherProgramFindsTheReportsNumbers();

 private:
    [[nodiscard]] bool press(const QString& name, int seconds = 20) {
        return QTest::qWaitFor(
                   [&] {
                       auto* button = shell_->find<QAbstractButton>(name);
                       return button != nullptr && button->isEnabled();
                   },
                   seconds * 1000) &&
               shell_->click(name);
    }
    [[nodiscard]] db::Progress progress(const std::string& code) {
        for (const auto& each : db::study_progress(store(), kStudy))
            if (each.participant.code == code) return each;
        return {};
    }
    [[nodiscard]] db::Store& store() { return shell_->context().store(); }
    void consent(const std::string& code);
    void answer(const std::string& questionnaire, size_t row);
    void perform(const QString& device);
    void takePart(size_t row);
    [[nodiscard]] QString out(const QString& name) const { return shell_->path("out/" + name); }
    /// Standard output; the test fails when the program does.
    QString run(const QString& program, const QStringList& arguments);
    [[nodiscard]] Column csvColumn(const std::string& form, const std::string& item) const;

    std::unique_ptr<ShellHarness> shell_;
    Rows answers_;  ///< One row a participant, of the shipped simulated answers.
    size_t count_ = 4;
    double seconds_ = 0.4;
    std::vector<std::string> codes_;
};

QString ShellScenarioTest::run(const QString& program, const QStringList& arguments) {
    QProcess process;
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start(program, arguments);
    process.waitForFinished(300000);
    const QString said = QString::fromUtf8(process.readAll());
    if (process.exitStatus() != QProcess::NormalExit || process.exitCode() != 0)
        QTest::qFail(qPrintable(program + " " + arguments.join(' ') + ": " + said), __FILE__,
                     __LINE__);
    return said;
}

void ShellScenarioTest::initTestCase() {
    QVERIFY2(QFileInfo(PLACODE_BIN_DIR "/placode-sim").isExecutable() &&
                 QFileInfo(PLACODE_BIN_DIR "/placodectl").isExecutable(),
             "build placode-sim and placodectl first: this test starts them");
    const std::string file =
        (curriculum::data_folder() / "studies" / "face_content_validity_simulated.csv").string();
    answers_ = reports::parse_csv(reports::read_file(file));
    bool ok = false;
    if (const int wanted = qEnvironmentVariableIntValue("PLACODE_SCENARIO_PARTICIPANTS", &ok); ok)
        count_ = static_cast<size_t>(wanted);
    QVERIFY(count_ >= 3 && count_ < answers_.size());
    if (const double wanted = qEnvironmentVariable("PLACODE_SCENARIO_SECONDS").toDouble();
        wanted > 0)
        seconds_ = wanted;
    shell_ = std::make_unique<ShellHarness>();
    // The store that `demo` makes: the shell opens it as it finds it.
    const QString url = "sqlite:" + shell_->path("demo.db");
    run(PLACODE_BIN_DIR "/placodectl", {"--store", url, "demo", "--attempts", "0"});
    if (QTest::currentTestFailed()) return;
    shell_->start("demo.db");
    QVERIFY(shell_->signIn("demo-coordinator", "placode-demo"));
    QVERIFY(shell_->arrives(PageId::kStudies));
    QVERIFY(press("publish_study"));
    QVERIFY(QTest::qWaitFor([&] { return shell_->find<QPushButton>("enrol") != nullptr; }, 10000));
}

void ShellScenarioTest::consent(const std::string& code) {
    ShellHarness& shell = *shell_;
    for (const auto& statement : curriculum::load_study(kStudy).consent.statements)
        QVERIFY(shell.click("consent_" + QString::fromStdString(statement.id)));
    auto* pad = shell.find<QWidget>("signature");
    QVERIFY(pad != nullptr);
    auto* agree = shell.find<QPushButton>("consent_given");
    QVERIFY2(!agree->isEnabled(), "nothing is signed yet");
    QTest::mousePress(pad, Qt::LeftButton, {}, QPoint(20, 70));
    for (int i = 1; i <= 8; ++i) {
        const QPoint at(20 + 18 * i, 70 - (i % 3) * 20);
        QTest::mouseMove(pad, at);
        QMouseEvent move(QEvent::MouseMove, QPointF(at), pad->mapToGlobal(QPointF(at)),
                         Qt::NoButton, Qt::LeftButton, {});
        QApplication::sendEvent(pad, &move);
    }
    QTest::mouseRelease(pad, Qt::LeftButton, {}, QPoint(170, 60));
    // Without a change of theme: it would make the page anew, and unsigned.
    if (codes_.empty()) shell.window().grab().save(shell.shotFile("80_scenario_consent_signed"));
    QVERIFY(press("consent_given"));
    QVERIFY(QTest::qWaitFor([&] { return progress(code).next == "demographics"; }, 20000));
}

/// As the row of the shipped table says, item by item.
void ShellScenarioTest::answer(const std::string& questionnaire, size_t row) {
    ShellHarness& shell = *shell_;
    QVERIFY(press("step_questionnaire"));
    QVERIFY(shell.arrives(PageId::kParticipant));
    using curriculum::ItemKind;
    for (const auto& item : curriculum::load_questionnaire(questionnaire).items) {
        const QString given = QString::fromStdString(cell(answers_, row, item.id));
        if (given.isEmpty()) continue;
        const QString name = "answer_" + QString::fromStdString(item.id);
        if (item.kind == ItemKind::kLikert) {
            auto* point = shell.find<QRadioButton>(name + "_" + given);
            QVERIFY2(point != nullptr, qPrintable(name + "_" + given));
            point->click();
        } else if (item.kind == ItemKind::kChoice) {
            shell.find<QComboBox>(name)->setCurrentIndex(given.toInt() + 1);
        } else if (item.kind == ItemKind::kMultiple) {
            for (const QString& each : given.split(';'))
                shell.find<QCheckBox>(name + "_" + each)->click();
        } else if (item.kind == ItemKind::kText) {
            shell.find<QPlainTextEdit>(name)->setPlainText(given);
        } else {
            QVERIFY(shell.type(name, given));
        }
    }
    QVERIFY(shell.click("review"));
    QVERIFY2(shell.find<QPushButton>("submit_answers") != nullptr,
             qPrintable(shell.text("participant_message")));
    QVERIFY(shell.click("submit_answers"));
    QVERIFY(shell.arrives(PageId::kStudyRun));
}

void ShellScenarioTest::perform(const QString& device) {
    ShellHarness& shell = *shell_;
    QVERIFY(QTest::qWaitFor([&] { return shell.find<QComboBox>("device") != nullptr; }, 10000));
    auto* devices = shell.find<QComboBox>("device");
    devices->setCurrentIndex(devices->findData(device));
    QVERIFY(press("start_attempt"));
    QVERIFY(shell.arrives(PageId::kRunning));
    QVERIFY(QTest::qWaitFor(
        [&] {
            return shell.context().launcher().status().time_s > seconds_ ||
                   shell.window().current() == PageId::kStudyRun;
        },
        kPatienceMs));
    if (shell.window().current() == PageId::kRunning) QVERIFY(shell.click("stop_and_score"));
    QVERIFY(shell.arrives(PageId::kStudyRun, 120));
}

void ShellScenarioTest::takePart(size_t row) {
    ShellHarness& shell = *shell_;
    QVERIFY(press("enrol"));
    QVERIFY(shell.arrives(PageId::kStudyRun));
    const std::string code = store().participants(kStudy).back().code;
    consent(code);
    if (QTest::currentTestFailed()) return;
    codes_.push_back(code);
    answer("demographics", row);
    if (QTest::currentTestFailed()) return;
    QVERIFY(press("step_done"));
    QVERIFY(press("step_skip"));  // Operators of a script need no getting used to.
    const char* const devices[] = {"script:novice", "script:intermediate", "script:expert"};
    for (int procedure = 1; procedure <= 3; ++procedure) {
        const std::string due = "procedure_" + std::to_string(procedure);
        QVERIFY(QTest::qWaitFor([&] { return progress(code).next == due; }, 20000));
        perform(devices[row % 3]);
        if (QTest::currentTestFailed()) return;
    }
    answer("face_validity", row);
    if (QTest::currentTestFailed()) return;
    QVERIFY(progress(code).next.empty());
    QVERIFY(press("run_finished"));
    QVERIFY(shell.arrives(PageId::kStudies));
}

void ShellScenarioTest::participantsGoFromConsentToTheLastQuestion() {
    for (size_t row = 1; row <= count_; ++row) {
        takePart(row);
        if (QTest::currentTestFailed()) return;
    }
    QCOMPARE(store().participants(kStudy).size(), count_);
    size_t attempts = 0;
    for (const auto& step : store().steps(kStudy)) attempts += step.attempt_id > 0 ? 1 : 0;
    QCOMPARE(attempts, 3 * count_);
    for (const std::string& code : codes_) {
        QVERIFY(store().records().consent_signature(kStudy, code).has_value());
        const auto done = progress(code);
        QCOMPARE(done.done, done.total);
    }
    shell_->whole("81_scenario_study");
}

void ShellScenarioTest::recordsAreEnteredTwiceLockedAndSigned() {
    ShellHarness& shell = *shell_;
    shell.window().open({PageId::kStudyData, 0, {}, {{"study", kStudy}}});
    QVERIFY(shell.arrives(PageId::kStudyData));
    auto* table = shell.find<QTableWidget>("records_table");
    QVERIFY(table != nullptr);
    QCOMPARE(table->rowCount(), static_cast<int>(count_));
    // The second entry of the first participant, with one slip.
    table->selectRow(0);
    auto* forms = shell.find<QComboBox>("entry_questionnaire");
    forms->setCurrentIndex(forms->findData("face_validity"));
    QVERIFY(press("enter_second"));
    QVERIFY(shell.arrives(PageId::kParticipant));
    const std::string was = cell(answers_, 1, "A"), slip = was == "1" ? "2" : "1";
    for (const auto& item : curriculum::load_questionnaire("face_validity").items) {
        const std::string given = item.id == "A" ? slip : cell(answers_, 1, item.id);
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
        [&] { return store().records().record_states(kStudy)[codes_[0]].locked; }, 10000));
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
        [&] { return store().records().record_states(kStudy)[codes_[0]].signature.has_value(); },
        10000));
    QVERIFY(store().records().record_states(kStudy)[codes_[0]].signature_fits);
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
    shell.window().grab().save(shell.shotFile("84_scenario_names"));
    for (const QString& file : {path, shell.path("demo.db"), shell.path("demo.db-wal")}) {
        QFile bytes(file);
        if (!bytes.open(QIODevice::ReadOnly)) continue;
        QVERIFY2(!bytes.readAll().contains("Przykladowa"), qPrintable(file));
    }
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
    QVERIFY(QFileInfo(out("figures/numbers.csv")).size() > 1000);
    QVERIFY(QFileInfo(out("figures/learning_curves_table.csv")).exists());
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
    const QString text = run("pdftotext", {"-layout", out("study.pdf"), "-"});
    const QString n = QString::number(count_);
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
            run("xmllint", {"--noout", files.next()});
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

Column ShellScenarioTest::csvColumn(const std::string& form, const std::string& item) const {
    Column column;
    const Rows rows = reports::parse_csv(reports::read_file(
        (out("csv") + "/" + kStudy + "_" + QString::fromStdString(form) + ".csv").toStdString()));
    for (size_t r = 1; r < rows.size(); ++r)
        column[cell(rows, r, "participant")] = cell(rows, r, item);
    return column;
}

void ShellScenarioTest::exportsAgreeWithEachOtherAndWithTheStore() {
    // The store: what the participants' windows saved is what the script typed.
    Column stored;
    for (const auto& record : store().answers(kStudy))
        if (record.questionnaire_id == "face_validity")
            stored[record.participant] = record.answers.at("F");
    for (size_t i = 0; i < codes_.size(); ++i)
        QCOMPARE(stored[codes_[i]], cell(answers_, i + 1, "F"));
    QCOMPARE(csvColumn("face_validity", "F"), stored);
    // FHIR
    Column fhir;
    QDirIterator responses(out("fhir"), {"QuestionnaireResponse-face_validity*"}, QDir::Files,
                           QDirIterator::Subdirectories);
    while (responses.hasNext()) {
        QFile file(responses.next());
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QJsonObject resource = QJsonDocument::fromJson(file.readAll()).object();
        const std::string who = resource["subject"]["identifier"]["value"].toString().toStdString();
        const std::function<void(const QJsonArray&)> search = [&](const QJsonArray& items) {
            for (const QJsonValue& item : items) {
                if (item["linkId"].toString() == "F") {
                    const QJsonValue answer = item["answer"][0];
                    fhir[who] = answer["valueCoding"].isObject()
                                    ? answer["valueCoding"]["code"].toString().toStdString()
                                    : std::to_string(answer["valueInteger"].toInt());
                }
                search(item["item"].toArray());
            }
        };
        search(resource["item"].toArray());
    }
    QCOMPARE(fhir, stored);
    // REDCap: the column of that name in the records.
    Column redcap;
    QDirIterator tables(out("redcap"), {"*.csv"}, QDir::Files, QDirIterator::Subdirectories);
    while (tables.hasNext()) {
        const Rows rows = reports::parse_csv(reports::read_file(tables.next().toStdString()));
        if (rows.at(0).at(0) != "record_id") continue;
        for (size_t r = 1; r < rows.size(); ++r)
            if (const std::string value = cell(rows, r, "face_val_f"); !value.empty())
                redcap[cell(rows, r, "record_id")] = value;
    }
    QCOMPARE(redcap, stored);
    // ODM
    Column odm;
    QDirIterator files(out("odm"), {"*.xml"}, QDir::Files, QDirIterator::Subdirectories);
    QVERIFY(files.hasNext());
    QFile file(files.next());
    QVERIFY(file.open(QIODevice::ReadOnly));
    QXmlStreamReader xml(&file);
    std::string subject;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) continue;
        const auto attribute = [&](const char* name) {
            return xml.attributes().value(QLatin1String(name)).toString().toStdString();
        };
        if (xml.name() == QLatin1String("SubjectData")) subject = attribute("SubjectKey");
        if (xml.name() == QLatin1String("ItemData") && attribute("ItemOID") == "I.face_validity.F")
            odm[subject] = attribute("Value");
    }
    QCOMPARE(odm, stored);
    // The report's own number.
    std::vector<double> values;
    for (const auto& [code, value] : stored) values.push_back(std::stod(value));
    const Rows numbers =
        reports::parse_csv(reports::read_file(out("figures/numbers.csv").toStdString()));
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
    const QString said = run("Rscript", {PLACODE_SOURCE_DIR "/scripts/study_report.R", out("csv"),
                                         kStudy, out("figures/numbers.csv")});
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
