// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// An educator makes a group, builds a course, sees what is wrong with it, publishes, exports,
// imports and assigns it; all through the real windows.

#include <QCheckBox>
#include <QDateEdit>
#include <QDoubleSpinBox>
#include <QListWidget>
#include <QSpinBox>

#include "curriculum/course.h"
#include "db/course_conduct.h"
#include "shell_harness.h"

namespace placode::ui {

class ShellCourseTest : public QObject {
    Q_OBJECT

 private Q_SLOTS:
    void initTestCase();
    void cleanupTestCase() { shell_.reset(); }

    void educatorMakesAGroup();
    void editorSaysAtTheFieldWhatIsWrong();
    void aDoubleClickRemovesOneStage();
    void changesAreUndone();
    void courseIsPublishedAndExported();
    void importedFileBecomesTheNextVersion();
    void courseIsAssignedToTheGroupAndEnded();
    void aNameThatFitsSeveralActsOnNobody();
    void damagedFileIsRefusedWithItsPlace();
    void traineeSeesNoEditor();

 private:
    std::unique_ptr<ShellHarness> shell_;
};

void ShellCourseTest::initTestCase() {
    shell_ = std::make_unique<ShellHarness>();
    QVERIFY(shell_->setUpWithDemonstration());
    QVERIFY(shell_->signIn("demo.educator", "placode-demo"));
}

void ShellCourseTest::educatorMakesAGroup() {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.click("rail_groups"));
    QVERIFY(shell.arrives(PageId::kGroups));
    QVERIFY(shell.type("new_group", "Autumn 2026"));
    QVERIFY(shell.click("add_group"));
    auto* table = shell.find<QTableWidget>("group_table");
    QCOMPARE(table->rowCount(), 1);  // Who makes a group teaches it.
    // Pressed before anybody was chosen, it does not take the first of the list.
    QVERIFY(shell.click("group_add"));
    QVERIFY(shell.bannerSays("Nobody is chosen"));
    QVERIFY(shell.owner().groups().list().front().members.empty());
    auto* person = shell.find<QComboBox>("group_person");
    person->setCurrentIndex(
        person->findData(QVariant::fromValue<qint64>(shell.idOf("demo.trainee"))));
    QVERIFY(shell.click("group_add"));
    QVERIFY(shell.bannerSays("is in the group now"));
    QCOMPARE(shell.find<QTableWidget>("group_table")->rowCount(), 2);
    const auto groups = shell.owner().groups().list();
    QCOMPARE(groups.size(), size_t{1});
    QCOMPARE(groups[0].members, std::vector<int64_t>{shell.idOf("demo.trainee")});
    QCOMPARE(groups[0].educators, std::vector<int64_t>{shell.idOf("demo.educator")});
    // A trainee cannot be made an educator of a group.
    shell.find<QComboBox>("group_role")->setCurrentIndex(1);
    person = shell.find<QComboBox>("group_person");
    person->setCurrentIndex(
        person->findData(QVariant::fromValue<qint64>(shell.idOf("demo.trainee"))));
    QVERIFY(shell.click("group_add"));
    QVERIFY(shell.bannerSays("has not the role educator"));
    QVERIFY(shell.fitsInBothSizes("60_groups"));
}

void ShellCourseTest::editorSaysAtTheFieldWhatIsWrong() {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.click("rail_courses"));
    QVERIFY(shell.arrives(PageId::kCourses));
    QVERIFY(shell.click("new_course"));
    QVERIFY(shell.arrives(PageId::kCourseEditor));
    QVERIFY(!shell.find<QPushButton>("publish_course")->isEnabled());
    QVERIFY(shell.type("title_en", "Ring and exam"));
    QVERIFY(shell.type("title_pl", "Egzamin"));
    QVERIFY(shell.type("course_id", "ring exam"));
    QVERIFY(shell.text("problem_course").contains("\"ring exam\" is no id"));
    QVERIFY(shell.type("course_id", "ring_exam"));
    QVERIFY2(shell.text("no_stages").contains("Press Add"), "an empty list says what to do");
    QVERIFY(!shell.find<QLabel>("no_stages")->isHidden());
    QVERIFY(shell.click("add_stage"));
    QVERIFY(shell.find<QLabel>("no_stages")->isHidden());
    QVERIFY(shell.click("add_stage"));
    auto* list = shell.find<QListWidget>("stage_list");
    QCOMPARE(list->count(), 2);
    QCOMPARE(list->currentRow(), 1);
    const QString small = "diathermy_ring_small";
    auto* task = shell.find<QComboBox>("stage_task");
    task->setCurrentIndex(task->findData(small));
    // An exam without cases: said at the field, and it cannot be published.
    auto* mode = shell.find<QComboBox>("stage_mode");
    mode->setCurrentIndex(mode->findData(static_cast<int>(curriculum::StageMode::kExam)));
    auto* seeds = shell.find<QLabel>("problem_stage_exam_seeds");
    QVERIFY(!seeds->isHidden() && seeds->text().contains("needs its list of cases"));
    QVERIFY(!shell.find<QPushButton>("publish_course")->isEnabled());
    QVERIFY(shell.type("stage_seeds", "11, x"));
    QVERIFY(seeds->text().contains("\"x\" is no whole number"));
    QVERIFY(shell.fitsInBothSizes("61_editor_problem"));
    QVERIFY(shell.type("stage_seeds", "11, 12"));
    QVERIFY(shell.find<QLabel>("problem_stage_exam_seeds")->isHidden());
    shell.find<QSpinBox>("stage_consecutive")->setValue(3);
    shell.find<QSpinBox>("stage_limit")->setValue(2);
    QVERIFY(shell.find<QLabel>("problem_stage_max_attempts")->text().contains("fewer"));
    shell.find<QSpinBox>("stage_consecutive")->setValue(1);
    QVERIFY(shell.find<QPushButton>("publish_course")->isEnabled());
}

void ShellCourseTest::aDoubleClickRemovesOneStage() {
    ShellHarness& shell = *shell_;
    auto* list = shell.find<QListWidget>("stage_list");
    const int before = list->count();
    for (int i = 0; i < 2; ++i) QVERIFY(shell.click("add_stage"));
    list->setCurrentRow(before);
    shell.scrollTo("remove_stage");
    QVERIFY(QTest::qWaitForWindowExposed(&shell.window()));
    const auto* remove = shell.find<QPushButton>("remove_stage");
    // As the pointer presses: the window hears of it first.
    const auto place = [&] { return remove->mapTo(&shell.window(), remove->rect().center()); };
    const auto press = [&](const QPoint& at) {
        QTest::mouseClick(shell.window().windowHandle(), Qt::LeftButton, {}, at);
        QCoreApplication::processEvents();
    };
    const int interval = QApplication::doubleClickInterval();
    QTest::qWait(interval + 100);
    QApplication::setDoubleClickInterval(5000);  // also on a slow computer
    const QPoint at = place();
    press(at);
    press(at);
    QApplication::setDoubleClickInterval(interval);
    QCOMPARE(list->count(), before + 1);
    QTest::qWait(interval + 100);
    press(place());
    QCOMPARE(list->count(), before);
    list->setCurrentRow(before - 1);
}

void ShellCourseTest::changesAreUndone() {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.click("remove_stage"));
    QCOMPARE(shell.find<QListWidget>("stage_list")->count(), 1);
    QVERIFY(shell.click("undo"));
    QCOMPARE(shell.find<QListWidget>("stage_list")->count(), 2);
    QVERIFY(shell.click("redo"));
    QCOMPARE(shell.find<QListWidget>("stage_list")->count(), 1);
    QVERIFY(shell.click("undo"));
    QCOMPARE(shell.find<QListWidget>("stage_list")->count(), 2);
    // The draft and its past outlive a change of language.
    shell.context().setLanguage("pl");
    QVERIFY(shell.arrives(PageId::kCourseEditor));
    QCOMPARE(shell.find<QLineEdit>("title_en")->text(), QString("Ring and exam"));
    QVERIFY(shell.find<QPushButton>("undo")->isEnabled());
    QVERIFY(shell.fitsInBothSizes("62_editor_polish"));
    shell.context().setLanguage("en");
    QVERIFY(shell.arrives(PageId::kCourseEditor));
}

void ShellCourseTest::courseIsPublishedAndExported() {
    ShellHarness& shell = *shell_;
    shell.save_as = shell.path("course.json");
    QVERIFY(shell.click("export_course"));
    QVERIFY(shell.bannerSays("course.json"));
    shell.refuseNext();
    QVERIFY(shell.click("publish_course"));
    QTest::qWait(100);
    QVERIFY2(!shell.owner().definitions().find("course", "ring_exam"), "it asks first");
    shell.confirmNext();
    QVERIFY(shell.click("publish_course"));
    QVERIFY(shell.arrives(PageId::kCourses));
    const auto published = shell.owner().definitions().find("course", "ring_exam");
    QVERIFY(published.has_value());
    QCOMPARE(published->version, 1);
    const auto course = curriculum::load_course_text(published->json, "published");
    QCOMPARE(course.stages.size(), size_t{2});
    QVERIFY(course.stages[1].mode == curriculum::StageMode::kExam);
    QCOMPARE(course.stages[1].exam.seeds, (std::vector<uint64_t>{11, 12}));
    QCOMPARE(course.stages[1].max_attempts, 2);
    QCOMPARE(course.stages[1].requires_stages, std::vector<std::string>{course.stages[0].id});
    QFile file(shell.save_as);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll().toStdString(), published->json);
}

void ShellCourseTest::importedFileBecomesTheNextVersion() {
    ShellHarness& shell = *shell_;
    shell.open_this = shell.save_as;
    QVERIFY(shell.click("import_course"));
    QVERIFY(shell.arrives(PageId::kCourseEditor));
    QCOMPARE(shell.find<QPushButton>("publish_course")->text(), QString("Publish version 2"));
    QVERIFY(!shell.find<QPushButton>("publish_course")->isEnabled());  // The reason is missing.
    QVERIFY(shell.type("publish_reason", "From the other site"));
    shell.confirmNext();
    QVERIFY(shell.click("publish_course"));
    QVERIFY(shell.arrives(PageId::kCourses));
    QVERIFY(shell.bannerSays("version 2, is published"));
    QCOMPARE(shell.owner().definitions().find("course", "ring_exam")->version, 2);
    QCOMPARE(shell.owner().definitions().find("course", "ring_exam", 1)->version, 1);
}

void ShellCourseTest::courseIsAssignedToTheGroupAndEnded() {
    ShellHarness& shell = *shell_;
    auto* table = shell.find<QTableWidget>("courses_table");
    QCOMPARE(table->item(table->currentRow(), 1)->text(), QString("ring_exam"));
    auto* target = shell.find<QComboBox>("assign_target");
    target->setCurrentText("nobody of this name");
    QVERIFY(shell.click("assign_course"));
    QVERIFY(shell.bannerSays("There is nobody called"));
    target->setCurrentText("Group Autumn");
    const QDate due = QDate::currentDate().addDays(10);
    shell.find<QDateEdit>("assign_due")->setDate(due);
    QVERIFY(shell.click("assign_course"));
    QVERIFY(shell.bannerSays("Assigned to Group Autumn 2026"));
    const auto held = shell.owner().courses().assignments(shell.idOf("demo.trainee"));
    QCOMPARE(held.size(), size_t{1});
    QCOMPARE(held[0].course_id, std::string("ring_exam"));
    QCOMPARE(held[0].course_version, 2);
    QCOMPARE(QString::fromStdString(held[0].due_utc).left(10), due.toString(Qt::ISODate));
    QVERIFY(shell.fitsInBothSizes("63_courses"));
    shell.confirmNext();
    QVERIFY(shell.click("end_assignment_0"));
    QVERIFY(shell.bannerSays("The assignment has ended"));
    QVERIFY(shell.owner().courses().assignments(shell.idOf("demo.trainee")).empty());
}

// The first of the two was meant, whoever that was.
void ShellCourseTest::aNameThatFitsSeveralActsOnNobody() {
    ShellHarness& shell = *shell_;
    for (const auto& [login, name] :
         {std::pair("jan", "Jan Kowalczyk"), std::pair("ola", "Ola Kowalska")}) {
        db::NewUser user;
        user.login = login;
        user.display_name = name;
        user.password = "first password";
        (void)shell.owner().accounts().create(user);
    }
    const auto grants = [&](const char* login) {
        return shell.owner().courses().grants(shell.idOf(login)).size();
    };
    shell.window().open({PageId::kCourses, 0, "ring_exam", {}});
    QVERIFY(shell.arrives(PageId::kCourses));
    auto* person = shell.find<QComboBox>("grant_person");
    QVERIFY(person != nullptr);
    QVERIFY(shell.type("grant_reason", "Device repaired"));
    person->setCurrentText("Kowal");
    QVERIFY2(shell.text("grant_standing").trimmed().isEmpty(), "nobody's standing");
    QVERIFY(shell.click("grant"));
    QVERIFY(shell.bannerSays("Several names match \"Kowal\": "));
    QVERIFY(shell.window().banner().text().contains("Ola Kowalska (ola)"));
    QCOMPARE(grants("jan") + grants("ola"), size_t{0});
    // A part that fits one only is enough; the standing is that person's.
    person->setCurrentText("kowalska");
    QVERIFY(shell.text("grant_standing").startsWith("Attempts made: "));
    QVERIFY(shell.click("grant"));
    QVERIFY(shell.bannerSays("More attempts for Ola Kowalska (ola): 1."));
    QCOMPARE(grants("ola"), size_t{1});
    QCOMPARE(grants("jan"), size_t{0});
    QVERIFY(shell.click("rail_groups"));
    QVERIFY(shell.arrives(PageId::kGroups));
    const auto members = [&] { return shell.owner().groups().list().front().members; };
    const auto before = members();
    shell.find<QComboBox>("group_person")->setCurrentText("Kowal");
    QVERIFY(shell.click("group_add"));
    QVERIFY(shell.bannerSays("Several names match"));
    QCOMPARE(members(), before);
    // Back to the courses, where the next test goes on.
    QVERIFY(shell.click("rail_courses"));
    QVERIFY(shell.arrives(PageId::kCourses));
}

void ShellCourseTest::damagedFileIsRefusedWithItsPlace() {
    ShellHarness& shell = *shell_;
    shell.open_this = shell.path("broken.json");
    QFile file(shell.open_this);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(
        "{\"id\":\"x\",\"version\":1,\"title\":{\"en\":\"X\"},\"stages\":[{\"task_id\":"
        "\"a\",\"consecutive\":0}]}");
    file.close();
    QVERIFY(shell.click("import_course"));
    QVERIFY(shell.bannerSays("broken.json"));
    QVERIFY(shell.window().current() == PageId::kCourses);
}

void ShellCourseTest::traineeSeesNoEditor() {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.signIn("demo.trainee", "placode-demo"));
    QTest::qWait(50);  // The frame of the educator goes.
    QVERIFY(shell.find<QToolButton>("rail_courses") == nullptr);
    QVERIFY(shell.find<QToolButton>("rail_groups") == nullptr);
    shell.window().open({PageId::kCourseEditor, 0, {}, {}});
    QVERIFY(shell.bannerSays("you may not"));
    QVERIFY(shell.find<QPushButton>("publish_course") == nullptr);
}

}  // namespace placode::ui

int main(int argc, char** argv) {
    placode::ui::prepare_display();
    QApplication application(argc, argv);
    placode::ui::ShellCourseTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "shell_course_test.moc"
