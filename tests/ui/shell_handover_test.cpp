// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The screen in a participant's hands: nothing of the coordinator's can be reached without the
// coordinator's password, by whatever way somebody tries to leave.

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QCloseEvent>
#include <QDialog>
#include <QFrame>
#include <QRadioButton>

#include "shell_harness.h"
#include "short_study.h"
#include "ui/shell/attempt_launcher.h"

namespace placode::ui {

namespace {
constexpr const char* kStudy = "face_content_validity";
}

class ShellHandoverTest : public QObject {
    Q_OBJECT

 private Q_SLOTS:
    void initTestCase();
    void cleanupTestCase() { shell_.reset(); }

    void everyModeHasItsArguments();
    void theParticipantsViewHasNothingElse();
    void everyWayOutAsksForThePassword();
    void aWrongPasswordStaysAndTheRightOneLeads();
    void afterATimeWithoutATouchItIsTheSame();
    void theScreenOfOneQuestionnaireIsTheSame();
    void aPinIsEnoughWhereItIsOnTheLockPage();
    void missingAnswersAreSaidInWordsAndTheFirstHasTheFocus();
    void questionsAreCountedAsTheyAreSeen();

 private:
    /// What is done while the question for the password is open; then the screen stays.
    void refuseToTakeBack(const QString& typed = {});
    void run();

    std::unique_ptr<ShellHarness> shell_;
    int asked_ = 0;  ///< How often the password was asked for.
};

void ShellHandoverTest::initTestCase() {
    shell_ = std::make_unique<ShellHarness>();
    QVERIFY(shell_->setUpWithDemonstration());
    QVERIFY(shell_->signIn("demo.coordinator", "placode-demo"));
    QVERIFY(shell_->arrives(PageId::kStudies));
    publish_short_study(shell_->owner(), kStudy);
    run();
}

void ShellHandoverTest::run() {
    shell_->window().open({PageId::kStudies, 0, {}, {{"study", kStudy}}});
    QVERIFY(shell_->arrives(PageId::kStudies));
    shell_->confirmNext();
    QVERIFY(shell_->click("enrol"));
    QVERIFY(shell_->arrives(PageId::kStudyRun));
}

void ShellHandoverTest::refuseToTakeBack(const QString& typed) {
    QTimer::singleShot(50, &shell_->window(), [this, typed] {
        QWidget* dialog = QApplication::activeModalWidget();
        if (dialog == nullptr || dialog->objectName() != "take_back")
            return refuseToTakeBack(typed);
        ++asked_;
        if (!typed.isEmpty()) {
            QTest::keyClicks(dialog->findChild<QLineEdit*>("take_back_password"), typed);
            QTest::mouseClick(dialog->findChild<QPushButton*>("take_back_yes"), Qt::LeftButton);
            QVERIFY(dialog->isVisible());
            const auto* said = dialog->findChild<QLabel*>("take_back_message");
            QVERIFY(said->isVisibleTo(dialog));
            QCoreApplication::processEvents();
            QVERIFY2(!said->geometry().intersects(
                         dialog->findChild<QLineEdit*>("take_back_password")->geometry()) &&
                         said->height() >= said->heightForWidth(said->width()),
                     "it lies over the field");
            shell_->keep(dialog->grab(), "65_take_back_wrong");
        } else if (asked_ == 1) {
            shell_->keep(dialog->grab(), "65_take_back");
        }
        QTest::keyClick(dialog, Qt::Key_Escape);
    });
}

void ShellHandoverTest::everyModeHasItsArguments() {
    AttemptOrder order;
    order.task = "diathermy_ring";
    order.device = "mouse";
    order.recording_file = "a.placode";
    order.user_name = "Ada";
    order.seed = 7;
    const LaunchOptions options;
    const QStringList practice = simulator_arguments(order, options);
    for (const char* absent : {"--study", "--aids", "--min-duration", "--exam", "--author", "Ada"})
        QVERIFY2(!practice.contains(absent), absent);
    QVERIFY(!practice.contains("--stage"));
    order.stage = 2;
    const QStringList further = simulator_arguments(order, options);
    QCOMPARE(further.value(further.indexOf("--stage") + 1), QString("2"));
    const auto author = [&] { return simulator_environment(order).value("PLACODE_AUTHOR"); };
    QCOMPARE(author(), QString("Ada"));
    order.study = "pilot";
    order.participant = order.user_name = "P001-C";
    order.aids = "read_outs,depth";
    order.min_s = 60;
    const QStringList study = simulator_arguments(order, options);
    QVERIFY(study.contains("--study"));
    QVERIFY2(!study.contains("--stage"), "a study begins with the beginning");
    QCOMPARE(study.value(study.indexOf("--aids") + 1), QString("read_outs,depth"));
    QCOMPARE(study.value(study.indexOf("--min-duration") + 1), QString("60"));
    QVERIFY2(!study.contains("P001-C") && author().isEmpty(), "nothing is tuned in a study");
    order.aids.clear();
    order.min_s = 0;
    const QStringList bare = simulator_arguments(order, options);
    QCOMPARE(bare.value(bare.indexOf("--aids") + 1), QString());
    QVERIFY(!bare.contains("--min-duration"));
    order.study.clear();
    order.exam.course_id = "first_steps";
    const QStringList exam = simulator_arguments(order, options);
    QVERIFY(exam.contains("--exam") && exam.contains("--seed"));
    QVERIFY2(!exam.contains("--stage"), "and so does an exam");
    for (const char* absent : {"--study", "--aids", "--author"})
        QVERIFY2(!exam.contains(absent), absent);
    qputenv("PLACODE_AUTHOR", "who was here before");
    QVERIFY(author().isEmpty());
    qunsetenv("PLACODE_AUTHOR");
}

void ShellHandoverTest::theParticipantsViewHasNothingElse() {
    ShellHarness& shell = *shell_;
    for (const char* name : {"rail_studies", "rail_data", "search", "user_menu", "switch_user"}) {
        auto* button = shell.find<QToolButton>(name);
        QVERIFY2(button == nullptr || !button->isVisible(), name);
    }
    QVERIFY2(shell.find<QComboBox>("device") == nullptr, "the coordinator has chosen the device");
    QTest::keyClick(&shell.window(), Qt::Key_K, Qt::ControlModifier);
    QVERIFY2(shell.window().findChild<QDialog*>("search_box") == nullptr, "no search");
    QTest::keyClick(&shell.window(), Qt::Key_Escape);
    QVERIFY(shell.window().current() == PageId::kStudyRun);
}

void ShellHandoverTest::everyWayOutAsksForThePassword() {
    ShellHarness& shell = *shell_;
    const auto stays = [&](const char* way, const std::function<void()>& leave) {
        const int before = asked_;
        refuseToTakeBack();
        leave();
        QVERIFY2(QTest::qWaitFor([&] { return asked_ == before + 1; }, 5000), way);
        QVERIFY2(shell.window().current() == PageId::kStudyRun, way);
        QVERIFY2(shell.context().signedIn(), way);
        QVERIFY2(!shell.find<QToolButton>("rail_studies")->isVisible(), way);
    };
    stays("the button", [&] { (void)shell.click("interrupt_run"); });
    for (const PageId page : {PageId::kStudies, PageId::kStudyData, PageId::kAccount,
                              PageId::kRecovery, PageId::kHistory, PageId::kResult})
        stays("a page", [&] { shell.window().open({page, 1, {}, {}}); });
    stays("entry from paper", [&] {
        shell.window().open({PageId::kParticipant,
                             0,
                             "P001-C",
                             {{"questionnaire", "sus"}, {"study", kStudy}, {"paper", true}}});
    });
    stays("the page before", [&] { Q_EMIT shell.window().page()->back(); });
    stays("closing the window", [&] { QVERIFY(!shell.window().close()); });
    stays("signing out", [&] { shell.window().findChild<QAction*>("action_sign_out")->trigger(); });
    stays("switching", [&] { shell.window().findChild<QAction*>("action_switch")->trigger(); });
}

void ShellHandoverTest::aWrongPasswordStaysAndTheRightOneLeads() {
    ShellHarness& shell = *shell_;
    const int before = asked_;
    refuseToTakeBack("not the password");
    QVERIFY(shell.click("interrupt_run"));
    QVERIFY(QTest::qWaitFor([&] { return asked_ == before + 1; }, 5000));
    QVERIFY(shell.window().current() == PageId::kStudyRun);
    shell.takeBackNext();
    QVERIFY(shell.click("interrupt_run"));
    QVERIFY(shell.arrives(PageId::kStudies));
    QVERIFY(shell.find<QToolButton>("rail_studies")->isVisible());
    QCOMPARE(QString::fromStdString(shell.owner().audit().trail(1).at(0).action),
             QString("session.take_back"));
    // There is no way back into somebody's run by accident.
    Q_EMIT shell.window().page()->back();
    QTest::qWait(50);
    QVERIFY(shell.window().current() != PageId::kStudyRun);
}

void ShellHandoverTest::afterATimeWithoutATouchItIsTheSame() {
    ShellHarness& shell = *shell_;
    shell.lock_after_s = 2;
    shell.start();
    QVERIFY(shell.signIn("demo.coordinator", "placode-demo"));
    run();
    if (QTest::currentTestFailed()) return;
    QTest::qWait(4500);  // Longer than the time to the lock.
    QVERIFY2(shell.window().current() == PageId::kStudyRun, "the participant is not thrown out");
    const int before = asked_;
    refuseToTakeBack();
    QVERIFY(shell.click("interrupt_run"));
    QVERIFY(QTest::qWaitFor([&] { return asked_ == before + 1; }, 5000));
    QVERIFY(shell.window().current() == PageId::kStudyRun);
    // A station that was switched off asks who it is.
    shell.lock_after_s = 0;
    shell.start();
    QVERIFY(shell.arrives(PageId::kLogin));
    QVERIFY(shell.signIn("demo.coordinator", "placode-demo"));
}

void ShellHandoverTest::theScreenOfOneQuestionnaireIsTheSame() {
    ShellHarness& shell = *shell_;
    shell.window().open({PageId::kStudies, 0, "sus", {}});
    QVERIFY(shell.arrives(PageId::kStudies));
    QVERIFY(shell.click("new_participant"));
    QVERIFY(shell.arrives(PageId::kParticipant));
    const int before = asked_;
    refuseToTakeBack();
    QVERIFY(shell.click("cancel_participant"));
    QVERIFY(QTest::qWaitFor([&] { return asked_ == before + 1; }, 5000));
    QVERIFY(shell.window().current() == PageId::kParticipant);
    shell.takeBackNext();
    QVERIFY(shell.click("cancel_participant"));
    QVERIFY(shell.arrives(PageId::kStudies));
}

void ShellHandoverTest::aPinIsEnoughWhereItIsOnTheLockPage() {
    ShellHarness& shell = *shell_;
    shell.owner().accounts().set_pin(shell.idOf("demo.coordinator"), "8305");
    shell.context().notePassword(shell.context().user());
    run();
    if (QTest::currentTestFailed()) return;
    const int before = asked_;
    refuseToTakeBack("1111");
    QVERIFY(shell.click("interrupt_run"));
    QVERIFY(QTest::qWaitFor([&] { return asked_ == before + 1; }, 5000));
    QVERIFY(shell.window().current() == PageId::kStudyRun);
    shell.takeBackNext("8305");
    QVERIFY(shell.click("interrupt_run"));
    QVERIFY(shell.arrives(PageId::kStudies));
}

void ShellHandoverTest::missingAnswersAreSaidInWordsAndTheFirstHasTheFocus() {
    ShellHarness& shell = *shell_;
    shell.window().open({PageId::kStudies, 0, "sus", {}});
    QVERIFY(shell.arrives(PageId::kStudies));
    QVERIFY(shell.click("new_participant"));
    QVERIFY(shell.arrives(PageId::kParticipant));
    shell.window().activateWindow();
    for (const char* id : {"sus01", "sus02", "sus04"})
        shell.find<QRadioButton>(QString("answer_%1_3").arg(id))->click();
    QVERIFY(shell.click("review"));
    QCOMPARE(shell.text("participant_message"),
             QString("Questions 3, 5, 6, 7, 8, 9, 10 need an answer."));
    const QWidget* page = shell.window().page();
    QVERIFY(shell.find<QLabel>("missing_sus03")->isVisibleTo(page));
    QVERIFY(!shell.find<QLabel>("missing_sus02")->isVisibleTo(page));
    QCOMPARE(shell.find<QFrame>("card_sus03")->property("tone").toString(), QString("critical"));
    QVERIFY(shell.window().focusWidget() != nullptr);
    QVERIFY(shell.find<QFrame>("card_sus03")->isAncestorOf(shell.window().focusWidget()));
    QVERIFY(QTest::qWaitFor([&] { return shell.fits(); }, 2000));
    shell.keep(shell.window().grab(), "66_missing_answers");
    shell.find<QRadioButton>("answer_sus03_3")->click();
    QVERIFY(!shell.find<QLabel>("missing_sus03")->isVisibleTo(page));
    QVERIFY(shell.find<QFrame>("card_sus03")->property("tone").toString().isEmpty());
    shell.confirmNext();
    shell.takeBackNext("8305");
    QVERIFY(shell.click("cancel_participant"));
    QVERIFY(shell.arrives(PageId::kStudies));
}

void ShellHandoverTest::questionsAreCountedAsTheyAreSeen() {
    ShellHarness& shell = *shell_;
    shell.window().open({PageId::kStudies, 0, "demographics", {}});
    QVERIFY(shell.arrives(PageId::kStudies));
    QVERIFY(shell.click("new_participant"));
    QVERIFY(shell.arrives(PageId::kParticipant));
    // A question that is hidden leaves no gap in the numbers, and shifts them when it appears.
    const auto numbers = [&] {
        QStringList list;
        const auto asked = curriculum::load_questionnaire("demographics");
        for (const auto& item : asked.items) {
            auto* heading = shell.find<QLabel>("question_" + QString::fromStdString(item.id));
            if (heading->isVisibleTo(shell.window().page()))
                list << heading->text().section(' ', 0, 0);
        }
        return list.join(' ');
    };
    QCOMPARE(numbers(), QString("1 2 3 4 5 6 7 8 9"));
    auto* used = shell.find<QComboBox>("answer_used_simulator");
    QVERIFY(used != nullptr);
    for (int i = 1; i < used->count() && numbers() == "1 2 3 4 5 6 7 8 9"; ++i)
        used->setCurrentIndex(i);
    QCOMPARE(numbers(), QString("1 2 3 4 5 6 7 8 9 10"));
    shell.whole("66_question_numbers");
}

}  // namespace placode::ui

int main(int argc, char** argv) {
    placode::ui::prepare_display();
    QApplication application(argc, argv);
    placode::ui::ShellHandoverTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "shell_handover_test.moc"
