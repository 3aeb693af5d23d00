// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The card of a study's data page that says how long records are kept, and erases what is overdue.

#include <QApplication>
#include <QLabel>
#include <QPushButton>
#include <QSqlDatabase>
#include <QSqlQuery>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "curriculum/study.h"
#include "db/study_conduct.h"
#include "shell_harness.h"

namespace placode::ui {

namespace {
constexpr const char* kStudy = "face_content_validity";
}

class ShellRetentionTest : public QObject {
    Q_OBJECT

 private Q_SLOTS:
    void initTestCase();
    void cleanupTestCase() { shell_.reset(); }
    void nothingIsDueYet();
    void whatIsOverdueIsErasedAfterAQuestion();

 private:
    void publish();
    std::string enrol();
    void openData();
    /// As if the participant's steps had been taken then.
    void age(const std::string& code, const std::string& at_utc);

    std::unique_ptr<ShellHarness> shell_;
    std::string old_, young_;
};

void ShellRetentionTest::publish() {
    auto json = nlohmann::ordered_json::parse(curriculum::load_study(kStudy).json);
    json["keep_years"] = 5;
    db::DefinitionRecord definition;
    definition.kind = "study";
    definition.id = kStudy;
    definition.version = json["version"];
    definition.json = json.dump(2);
    shell_->owner().definitions().publish(definition);
}

std::string ShellRetentionTest::enrol() {
    db::StepRecord step;
    step.study_id = kStudy;
    step.participant = shell_->owner().studies().new_participant(kStudy);
    step.step = "consent";
    shell_->owner().studies().record_step(step);
    return step.participant;
}

void ShellRetentionTest::openData() {
    shell_->window().open({PageId::kStudies, 0, {}, {}});
    QVERIFY(shell_->arrives(PageId::kStudies));
    shell_->window().open({PageId::kStudyData, 0, {}, {{"study", kStudy}}});
    QVERIFY(shell_->arrives(PageId::kStudyData));
}

void ShellRetentionTest::age(const std::string& code, const std::string& at_utc) {
    {
        QSqlDatabase raw = QSqlDatabase::addDatabase("QSQLITE", "age");
        const QString url = QString::fromStdString(shell_->context().storeUrl());
        raw.setDatabaseName(url.section('?', 0, 0).mid(QString("sqlite:").size()));
        QVERIFY(raw.open());
        QSqlQuery query(raw);
        query.prepare("UPDATE study_steps SET at_utc = ? WHERE code = ?");
        query.addBindValue(QString::fromStdString(at_utc));
        query.addBindValue(QString::fromStdString(code));
        QVERIFY(query.exec());
    }
    QSqlDatabase::removeDatabase("age");
}

void ShellRetentionTest::initTestCase() {
    shell_ = std::make_unique<ShellHarness>();
    QVERIFY(shell_->setUpWithDemonstration());
    publish();
    old_ = enrol();
    young_ = enrol();
    QVERIFY(shell_->signIn("demo.coordinator", "placode-demo"));
    QVERIFY(shell_->arrives(PageId::kStudies));
}

void ShellRetentionTest::nothingIsDueYet() {
    openData();
    QVERIFY(shell_->find<QPushButton>("erase_overdue") == nullptr);
    const auto labels = shell_->window().findChildren<QLabel*>();
    QVERIFY(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
        return label->text() == "Participants were told: 5 years after their last step.";
    }));
}

void ShellRetentionTest::whatIsOverdueIsErasedAfterAQuestion() {
    ShellHarness& shell = *shell_;
    // Before the row is made older behind the store's back: a backup is checked.
    const QString copy = shell.path("before_the_erasure.db");
    shell.owner().backup(copy.toStdString());
    age(old_, "2010-01-31T12:00:00.000Z");
    openData();
    QCOMPARE(shell.text("retention_due"),
             "The time of 1 participant is over: " + QString::fromStdString(old_) + ".");
    shell.whole("69_retention");
    shell.context().setLanguage("pl");
    QVERIFY(shell.arrives(PageId::kStudyData));
    QCOMPARE(shell.text("retention_due"),
             "Minął czas 1 uczestnika: " + QString::fromStdString(old_) + ".");
    shell.whole("69_retention_pl");
    shell.context().setLanguage("en");
    QVERIFY(shell.arrives(PageId::kStudyData));
    QVERIFY(shell.find<QLabel>("copies_left") == nullptr);
    shell.confirmNext();
    QVERIFY(shell.click("erase_overdue"));
    QVERIFY(QTest::qWaitFor([&] { return shell.find<QPushButton>("erase_overdue") == nullptr; },
                            10000));
    // Who erases is told where the records still are, also in the other language.
    for (const char* language : {"pl", "en"}) {
        const auto* left = shell.find<QLabel>("copies_left");
        QVERIFY(left != nullptr && left->text().contains(copy));
        QVERIFY(left->text().contains(QString::fromStdString(old_)));
        QVERIFY(!left->text().contains(QString::fromStdString(young_)));
        shell.context().setLanguage(language);
        QVERIFY(shell.arrives(PageId::kStudyData));
    }
    const auto steps = shell.owner().studies().steps(kStudy);
    QCOMPARE(steps.size(), size_t{1});
    QCOMPARE(steps[0].participant, young_);
    QCOMPARE(shell.owner().studies().participants(kStudy).size(), size_t{2});
}

}  // namespace placode::ui

int main(int argc, char** argv) {
    placode::ui::prepare_display();
    QApplication application(argc, argv);
    placode::ui::ShellRetentionTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "shell_retention_test.moc"
