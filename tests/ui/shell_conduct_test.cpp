// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Conduct through the windows: a study of two visits, an amendment while it runs, and the three
// ways to withdraw.

#include <QApplication>
#include <QCheckBox>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QPlainTextEdit>
#include <QRadioButton>
#include <array>
#include <set>

#include "curriculum/questionnaire.h"
#include "curriculum/study.h"
#include "db/study_conduct.h"
#include "db/study_records.h"
#include "export_columns.h"
#include "shell_harness.h"

namespace placode::ui {

namespace {

constexpr const char* kStudy = "two_visits";

/// The shipped study, cut down to what needs no simulator: consent and SUS, twice.
std::string study_json(int version, const QString& title) {
    const std::string shipped =
        (curriculum::data_folder() / "studies" / "face_content_validity.json").string();
    QJsonObject study =
        QJsonDocument::fromJson(QByteArray::fromStdString(reports::read_file(shipped))).object();
    const QJsonObject consent = study["steps"][0].toObject();
    study["id"] = kStudy;
    study["version"] = version;
    study["visits"] = 2;
    study["title"] = QJsonObject{{"en", title}, {"pl", title}};
    const QString asked = QString("SUS of version %1").arg(version);
    study["steps"] =
        QJsonArray{consent, QJsonObject{{"id", "usability"},
                                        {"kind", "questionnaire"},
                                        {"title", QJsonObject{{"en", asked}, {"pl", asked}}},
                                        {"questionnaire", "sus"}}};
    return QJsonDocument(study).toJson().toStdString();
}

}  // namespace

class ShellConductTest : public QObject {
    Q_OBJECT

 private Q_SLOTS:
    void initTestCase();
    void cleanupTestCase() { shell_.reset(); }

    void aSecondVisitAsksAgainButNotForConsent();
    void anAmendmentKeepsTheVersionOfWhoIsIn();
    void withdrawalKeepsStopsOrErases();
    void anotherThemeKeepsTheChosenRecord();
    void onlyUsableDataLeave();
    void aParticipantMayRefuseOrStop();
    void aSheetOfPaperGoesToTheVisitThatIsOpen();
    void aSecondEntryGoesToTheSetThatIsChosen();
    void aStepIsCalledAsTheParticipantsVersionDoes();

 private:
    [[nodiscard]] db::Store& store() { return shell_->owner(); }
    [[nodiscard]] bool press(const QString& name) {
        return QTest::qWaitFor(
                   [&] {
                       auto* button = shell_->find<QAbstractButton>(name);
                       return button != nullptr && button->isEnabled();
                   },
                   10000) &&
               shell_->click(name);
    }
    [[nodiscard]] db::Progress progress(const std::string& code) {
        for (const auto& each : db::study_progress(store(), kStudy))
            if (each.participant.code == code) return each;
        return {};
    }
    void overview();
    void publish(int version, const QString& title, const QString& reason);
    /// Enrols and consents on paper; the code.
    std::string enrol();
    /// Answers SUS with `point` throughout.
    void usability(int point);
    /// Chooses `point` in every item of SUS that is on the screen, and submits.
    void answerSus(int point);
    /// The data of the study, with that participant chosen.
    void openData(const std::string& code);
    void withdraw(int row, db::WithdrawalMode mode);

    std::unique_ptr<ShellHarness> shell_;
    std::vector<std::string> codes_;
};

void ShellConductTest::initTestCase() {
    shell_ = std::make_unique<ShellHarness>();
    QVERIFY(shell_->setUpWithDemonstration());
    QVERIFY(shell_->signIn("demo.coordinator", "placode-demo"));
    publish(1, "Two visits", {});
}

void ShellConductTest::overview() {
    if (shell_->window().current() == PageId::kStudyRun) shell_->takeBackNext();
    shell_->window().open({PageId::kStudies, 0, {}, {{"study", kStudy}}});
    QVERIFY(shell_->arrives(PageId::kStudies));
}

void ShellConductTest::publish(int version, const QString& title, const QString& reason) {
    shell_->window().open({PageId::kProtocols, 0, {}, {{"kind", "study"}}});
    QVERIFY(shell_->arrives(PageId::kProtocols));
    auto* json = shell_->find<QPlainTextEdit>("definition_json");
    QVERIFY(json != nullptr);
    json->setPlainText(QString::fromStdString(study_json(version, title)));
    if (!reason.isEmpty()) QVERIFY(shell_->type("publish_reason", reason));
    shell_->confirmNext();  // The shipped consent text is a draft.
    QVERIFY(press("definition_publish"));
    QVERIFY2(shell_->bannerSays(QString("version %1 is published").arg(version)),
             qPrintable(shell_->window().banner().text()));
    overview();
}

std::string ShellConductTest::enrol() {
    shell_->confirmNext();
    if (!press("enrol") || !shell_->arrives(PageId::kStudyRun)) return {};
    const std::string code = store().studies().participants(kStudy).back().code;
    for (const auto& statement : curriculum::load_study("face_content_validity").consent.statements)
        if (!shell_->click("consent_" + QString::fromStdString(statement.id))) return {};
    shell_->find<QCheckBox>("signed_on_paper")->click();
    if (!press("consent_given")) return {};
    const bool on = QTest::qWaitFor([&] { return progress(code).next == "usability"; }, 10000);
    return on ? code : std::string();
}

void ShellConductTest::usability(int point) {
    QVERIFY(press("step_questionnaire"));
    answerSus(point);
    if (QTest::currentTestFailed()) return;
    QVERIFY(shell_->arrives(PageId::kStudyRun));
}

void ShellConductTest::answerSus(int point) {
    QVERIFY(shell_->arrives(PageId::kParticipant));
    for (const auto& item : curriculum::load_questionnaire("sus").items) {
        auto* radio = shell_->find<QRadioButton>(
            QString("answer_%1_%2").arg(QString::fromStdString(item.id)).arg(point));
        QVERIFY2(radio != nullptr, item.id.c_str());
        radio->click();
    }
    QVERIFY(shell_->click("review"));
    QVERIFY(shell_->click("submit_answers"));
}

void ShellConductTest::openData(const std::string& code) {
    overview();
    shell_->window().open(
        {PageId::kStudyData, 0, QString::fromStdString(code), {{"study", kStudy}}});
    QVERIFY(shell_->arrives(PageId::kStudyData));
}

void ShellConductTest::aSecondVisitAsksAgainButNotForConsent() {
    codes_.push_back(enrol());
    QVERIFY(!codes_[0].empty());
    usability(3);
    if (QTest::currentTestFailed()) return;
    const auto between = progress(codes_[0]);
    QCOMPARE(between.visit, 2);
    QCOMPARE(between.next, std::string("usability"));
    shell_->takeBackNext();
    QVERIFY(press("interrupt_run"));  // Comes back another day.
    QVERIFY(shell_->arrives(PageId::kStudies));
    overview();
    auto* table = shell_->find<QTableWidget>("progress_table");
    QVERIFY(table != nullptr);
    QCOMPARE(table->item(0, 1)->text(), QString("2 of 3"));
    table->selectRow(0);
    QVERIFY(press("continue_participant"));
    QVERIFY(shell_->arrives(PageId::kStudyRun));
    QVERIFY(shell_->find<QWidget>("signature") == nullptr);
    usability(4);
    if (QTest::currentTestFailed()) return;
    QVERIFY(progress(codes_[0]).next.empty());
    std::map<int, std::string> by_visit;
    for (const auto& each : store().studies().answers(kStudy))
        by_visit[each.visit] = each.answers.begin()->second;
    QCOMPARE(by_visit, (std::map<int, std::string>{{1, "3"}, {2, "4"}}));
    shell_->takeBackNext();
    QVERIFY(press("run_finished"));
    QVERIFY(shell_->arrives(PageId::kStudies));
}

void ShellConductTest::anAmendmentKeepsTheVersionOfWhoIsIn() {
    publish(2, "Two visits, amended", "the committee asked for another title");
    if (QTest::currentTestFailed()) return;
    for (int i = 0; i < 3; ++i) {
        codes_.push_back(enrol());
        QVERIFY(!codes_.back().empty());
        usability(2 + i);
        if (QTest::currentTestFailed()) return;
        overview();
    }
    const auto all = store().studies().participants(kStudy);
    QCOMPARE(all.at(0).protocol_version, 1);
    QCOMPARE(all.at(1).protocol_version, 2);
    QCOMPARE(store().definitions().find("study", kStudy)->reason,
             std::string("the committee asked for another title"));
    shell_->whole("69_study_of_two_visits");
    // The change of theme came back to the same study.
    QCOMPARE(shell_->find<QComboBox>("study")->currentData().toString(), QString(kStudy));
}

void ShellConductTest::withdraw(int row, db::WithdrawalMode mode) {
    overview();
    QVERIFY(QTest::qWaitFor(
        [&] {
            auto* shown = shell_->find<QTableWidget>("progress_table");
            return shown != nullptr && shown->rowCount() == 4;
        },
        10000));
    auto* table = shell_->find<QTableWidget>("progress_table");
    table->selectRow(row);
    auto* box = shell_->find<QComboBox>("withdraw_mode");
    box->setCurrentIndex(box->findData(static_cast<int>(mode)));
    QVERIFY(shell_->type("withdraw_reason", "not given"));
    shell_->refuseNext();
    QVERIFY(press("withdraw"));
    const auto before = store().studies().participants(kStudy);
    QVERIFY2(!before.at(static_cast<size_t>(row)).withdrawal, "one press does not end a run");
    // Made anew in another theme, the card is about the same participant still.
    const QString code = table->item(row, 0)->text();
    for (const ThemeKind theme : {ThemeKind::kDark, ThemeKind::kLight}) {
        shell_->context().setTheme(theme);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    table = shell_->find<QTableWidget>("progress_table");
    QCOMPARE(table->item(table->currentRow(), 0)->text(), code);
    QCOMPARE(shell_->find<QComboBox>("withdraw_mode")->currentData().toInt(),
             static_cast<int>(mode));
    QCOMPARE(shell_->find<QLineEdit>("withdraw_reason")->text(), QString("not given"));
    shell_->confirmNext();
    QVERIFY(press("withdraw"));
    QVERIFY(QTest::qWaitFor(
        [&] {
            auto* now = shell_->find<QTableWidget>("progress_table");
            return now != nullptr && now->item(row, 4) != nullptr &&
                   now->item(row, 4)->text().contains("Withdrew.");
        },
        10000));
}

void ShellConductTest::withdrawalKeepsStopsOrErases() {
    using db::WithdrawalMode;
    withdraw(1, WithdrawalMode::kKeep);
    if (!QTest::currentTestFailed()) withdraw(2, WithdrawalMode::kStop);
    QVERIFY(shell_->find<QLabel>("copies_left") == nullptr);
    const QString copy = shell_->path("before_the_erasure.db");
    store().backup(copy.toStdString());
    if (!QTest::currentTestFailed()) withdraw(3, WithdrawalMode::kErase);
    if (QTest::currentTestFailed()) return;
    const auto* left = shell_->find<QLabel>("copies_left");
    QVERIFY(left != nullptr && left->text().contains(copy));
    QVERIFY(left->text().contains(QString::fromStdString(codes_[3])));
    const auto all = store().studies().participants(kStudy);
    QCOMPARE(all.size(), size_t(4));  // A tombstone stays of everybody.
    QVERIFY(!all[0].withdrawal);
    QVERIFY(all[1].withdrawal == WithdrawalMode::kKeep && all[1].usable());
    QVERIFY(all[2].withdrawal == WithdrawalMode::kStop && !all[2].usable());
    QVERIFY(all[3].withdrawal == WithdrawalMode::kErase && !all[3].usable());
    std::map<std::string, int> answers;
    for (const auto& each : store().studies().answers(kStudy)) ++answers[each.participant];
    QCOMPARE(answers, (std::map<std::string, int>{{codes_[0], 2}, {codes_[1], 1}, {codes_[2], 1}}));
    // Who has withdrawn is asked nothing more.
    shell_->find<QTableWidget>("progress_table")->selectRow(1);
    QVERIFY(press("continue_participant"));
    QVERIFY(shell_->arrives(PageId::kStudyRun));
    QVERIFY(shell_->find<QPushButton>("step_questionnaire") == nullptr);
    overview();
    shell_->whole("69_study_withdrawals");
}

// The first record was selected again, beside what had been typed to unlock another one.
void ShellConductTest::anotherThemeKeepsTheChosenRecord() {
    openData(codes_[0]);
    if (QTest::currentTestFailed()) return;
    const auto row = [this] { return shell_->find<QTableWidget>("records_table")->currentRow(); };
    shell_->find<QTableWidget>("records_table")->selectRow(2);
    QVERIFY(shell_->type("unlock_reason", "a slip"));
    for (const ThemeKind theme : {ThemeKind::kDark, ThemeKind::kLight}) {
        shell_->context().setTheme(theme);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QCOMPARE(row(), 2);
        QCOMPARE(shell_->find<QLineEdit>("unlock_reason")->text(), QString("a slip"));
    }
}

void ShellConductTest::onlyUsableDataLeave() {
    overview();
    shell_->save_as = shell_->path("exported");
    QVERIFY(press("study_export"));
    QVERIFY(shell_->bannerSays("read back and compared", 60));
    const Rows rows = table_of(shell_->exported() + "/" + kStudy + "_sus.csv");
    std::multiset<std::string> who;
    for (size_t r = 1; r < rows.size(); ++r)
        who.insert(cell(rows, r, "participant") + " " + cell(rows, r, "visit"));
    QCOMPARE(who,
             (std::multiset<std::string>{codes_[0] + " 1", codes_[0] + " 2", codes_[1] + " 1"}));
    const Rows people = table_of(shell_->exported() + "/" + kStudy + "_participants.csv");
    QCOMPARE(people.size(), size_t(5));
    QCOMPARE(cell(people, 4, "status"), std::string("3"));
}

void ShellConductTest::aParticipantMayRefuseOrStop() {
    overview();
    const auto last = [this] { return store().studies().participants(kStudy).back(); };
    shell_->confirmNext();
    QVERIFY(press("enrol"));
    QVERIFY(shell_->arrives(PageId::kStudyRun));
    QVERIFY2(shell_->find<QPushButton>("stop_taking_part") == nullptr, "the consent refuses");
    shell_->shot("70_consent_refuse");
    shell_->refuseNext();
    QVERIFY(press("consent_refused"));
    QVERIFY2(!last().withdrawal, "asked first");
    shell_->confirmNext();
    QVERIFY(press("consent_refused"));
    QVERIFY(QTest::qWaitFor([&] { return last().withdrawal.has_value(); }, 10000));
    QVERIFY2(!last().usable(), "nothing of who did not consent is used");
    QCOMPARE(last().withdrawal_reason, std::string("did not consent"));
    QVERIFY(QTest::qWaitFor([&] { return shell_->find<QPushButton>("run_finished") != nullptr; }));
    shell_->shot("71_run_ended");
    overview();

    const std::string code = enrol();
    QVERIFY(!code.empty());
    shell_->shot("72_run_stop");
    shell_->confirmNext();
    QVERIFY(press("stop_taking_part"));
    QVERIFY(QTest::qWaitFor([&] { return last().withdrawal.has_value(); }, 10000));
    QVERIFY(last().withdrawal == db::WithdrawalMode::kKeep);
    QVERIFY(last().withdrawal_reason.find("stopped by the participant") == 0);
    QVERIFY(QTest::qWaitFor([&] { return shell_->find<QPushButton>("run_finished") != nullptr; }));
    QVERIFY(shell_->find<QPushButton>("stop_taking_part") == nullptr);
    // The participant's wish: the coordinator may still use the data less.
    store().studies().withdraw(kStudy, code, db::WithdrawalMode::kErase, "asked afterwards");
}

void ShellConductTest::aSheetOfPaperGoesToTheVisitThatIsOpen() {
    db::AnswerRecord first;
    first.study_id = kStudy;
    first.participant = store().studies().new_participant(kStudy);
    db::record_consent(store(), kStudy, first.participant, "en", {"read", "voluntary", "data"});
    const auto sus = curriculum::load_questionnaire("sus");
    first.questionnaire_id = sus.id;
    first.questionnaire_version = sus.version;
    for (const auto& item : sus.items) first.answers[item.id] = "2";
    openData(first.participant);
    if (QTest::currentTestFailed()) return;
    QCOMPARE(shell_->find<QComboBox>("entry_visit")->currentData().toInt(), 1);
    db::submit_answers(store(), sus, first);
    openData(first.participant);
    if (QTest::currentTestFailed()) return;
    QCOMPARE(shell_->find<QComboBox>("entry_visit")->currentData().toInt(), 2);
    QVERIFY(shell_->fits());
    QVERIFY(press("enter_first"));
    answerSus(5);
    if (QTest::currentTestFailed()) return;
    QVERIFY(shell_->arrives(PageId::kStudyData));
    const auto last = store().studies().answers(kStudy).back();
    QCOMPARE(last.participant, first.participant);
    QCOMPARE(last.visit, 2);
    QVERIFY2(progress(first.participant).next.empty(), "both visits are done");
}

void ShellConductTest::aSecondEntryGoesToTheSetThatIsChosen() {
    const auto last = store().studies().answers(kStudy).back();  // Of visit 2, after one of 1.
    openData(last.participant);
    if (QTest::currentTestFailed()) return;
    auto* sets = shell_->find<QComboBox>("entry_second_of");
    QVERIFY(sets != nullptr);
    QCOMPARE(sets->count(), 2);
    sets->setCurrentIndex(sets->findData(QVariant::fromValue<qint64>(last.id)));
    QVERIFY2(sets->currentText().contains("visit 2"), qPrintable(sets->currentText()));
    QVERIFY(press("enter_second"));
    answerSus(4);
    if (QTest::currentTestFailed()) return;
    QVERIFY(shell_->arrives(PageId::kStudyData));
    const auto entries = store().records().second_entries(kStudy);
    QCOMPARE(entries.size(), size_t(1));
    QCOMPARE(entries[0].answer_id, last.id);
    auto* differences = shell_->find<QTableWidget>("differences_table");
    QVERIFY(differences != nullptr);
    QCOMPARE(differences->item(0, 6)->text(), QString("2"));
    QVERIFY(shell_->fits());
    // Two sets of one person are told apart where answers are corrected, too.
    auto* corrected = shell_->find<QComboBox>("correct_answers_of");
    QVERIFY(corrected->itemText(corrected->count() - 1).contains("visit 2"));
    // What is corrected is of whose record is selected, and stays so in another theme.
    QVERIFY2(corrected->currentText().startsWith(QString::fromStdString(last.participant)),
             qPrintable(corrected->currentText()));
    corrected->setCurrentIndex(corrected->count() - 1);
    const QString chosen = corrected->currentText();
    QVERIFY(shell_->type("correct_reason", "a slip"));
    for (const ThemeKind theme : {ThemeKind::kDark, ThemeKind::kLight}) {
        shell_->context().setTheme(theme);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QCOMPARE(shell_->find<QComboBox>("correct_answers_of")->currentText(), chosen);
        QCOMPARE(shell_->find<QLineEdit>("correct_reason")->text(), QString("a slip"));
    }
}

void ShellConductTest::aStepIsCalledAsTheParticipantsVersionDoes() {
    const auto all = store().studies().participants(kStudy);
    const std::array people{all.front(), all.back()};
    QCOMPARE(people[0].protocol_version, 1);
    QCOMPARE(people[1].protocol_version, 2);
    for (const db::ParticipantRecord& each : people)
        store().records().note_step(kStudy, each.code, 1, "usability", "coughed");
    for (const db::ParticipantRecord& each : people) {
        openData(each.code);
        if (QTest::currentTestFailed()) return;
        auto* deviations = shell_->find<QTableWidget>("deviations_table");
        QVERIFY(deviations != nullptr);
        QCOMPARE(deviations->item(0, 0)->text(),
                 QString("SUS of version %1").arg(each.protocol_version));
    }
}

}  // namespace placode::ui

int main(int argc, char** argv) {
    placode::ui::prepare_display();
    QApplication application(argc, argv);
    placode::ui::ShellConductTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "shell_conduct_test.moc"
