// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Forms: Enter does what the primary button does, a form begins anew for the next person, and the
// log-in page proposes only people of the store that is open.

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDateEdit>
#include <QDialog>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QSlider>
#include <QSpinBox>
#include <QWheelEvent>
#include <QWindow>

#include "shell_harness.h"
#include "ui/shell/parts.h"
#include "ui/shell/typed_texts.h"

namespace placode::ui {

class ShellFormsTest : public QObject {
    Q_OBJECT

 private Q_SLOTS:
    void initTestCase() { shell_ = std::make_unique<ShellHarness>(); }
    void cleanupTestCase() { shell_.reset(); }

    void enterSubmitsTheSetUpPageOrSaysWhatIsMissing();
    void enterSignsIn();
    void theNextPersonIsATraineeAgain();
    void whoIsMoreThanATraineeIsSaidBefore();
    void enterAddsAPerson();
    void enterChangesThePassword();
    void enterMakesAnAccountByInvitation();
    void onlyPeopleOfThisStoreAreProposed();
    void whoIsDeactivatedIsNotProposed();
    void theWheelScrollsAndChangesNoAnswer();
    void whatWasTypedStaysInTheOtherLanguageAndAfterALock();
    void aQuestionThatNobodyAnswersKeepsNoSessionOpen();
    void theSecondOfTwoClicksPressesNothingNew();
    void enterAndEscapeKeepEverything();
    void aButtonThatActsIsPressedOnce();
    void whatWasChosenStaysWithWhatWasTyped();
    void aHalfFilledFormIsThereAgainAfterAnotherPage();

 private:
    [[nodiscard]] QAbstractButton* role(int bit) const {
        return shell_->find<QAbstractButton>(QString("role_%1").arg(bit));
    }
    void enter(const char* field) {
        QTest::keyClick(shell_->find<QLineEdit>(field), Qt::Key_Return);
        QCoreApplication::processEvents();
    }
    [[nodiscard]] bool fill(const char* name, const char* login) {
        return shell_->type("new_name", name) && shell_->type("new_login", login) &&
               shell_->type("new_password", "first password");
    }
    [[nodiscard]] int rolesOf(const char* login) const {
        const auto user = shell_->owner().accounts().find_login(login);
        return user ? static_cast<int>(user->roles) : -1;
    }

    std::unique_ptr<ShellHarness> shell_;
};

void ShellFormsTest::enterSubmitsTheSetUpPageOrSaysWhatIsMissing() {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.setsUpStation());
    QTest::qWait(50);  // a page puts the focus where typing begins, when it is there
    QVERIFY(shell.type("display_name", "Ada Admin"));
    enter("display_name");
    QVERIFY(shell.find<QLabel>("setup_message")->isVisible());
    QVERIFY(shell.focusIsIn("login"));
    // A box answers to Enter as well, and stays as it is.
    auto* box = shell.find<QCheckBox>("also_trainee");
    const auto below = [&shell] {
        QCoreApplication::processEvents();
        return shell.find<QPushButton>("create_administrator")->mapToGlobal(QPoint(0, 0)).y();
    };
    const int place = below();
    shell.find<QLabel>("setup_message")->hide();
    QVERIFY2(below() == place, "nothing moves under the pointer when a message goes");
    QTest::keyClick(box, Qt::Key_Return);
    QVERIFY(shell.find<QLabel>("setup_message")->isVisible() && !box->isChecked());
    QVERIFY(shell.type("login", "ada"));
    QVERIFY(shell.type("password", "short"));
    enter("password");
    QVERIFY(shell.text("setup_message").contains("too short"));
    QVERIFY(shell.focusIsIn("password"));
    QVERIFY(shell.type("password", "correct horse"));
    enter("password");
    QVERIFY(shell.focusIsIn("password_again"));
    shell.shot("60_setup_incomplete");
    QVERIFY(shell.type("password", "correct horse"));  // never kept over a change of theme
    QVERIFY(shell.type("password_again", "correct horse"));
    QCOMPARE(shell.owner().accounts().list().size(), size_t{0});
    enter("password_again");
    QVERIFY(shell.arrives(PageId::kLogin));
    QCOMPARE(shell.owner().accounts().list().size(), size_t{1});
}

void ShellFormsTest::enterSignsIn() {
    ShellHarness& shell = *shell_;
    QTest::qWait(50);
    QVERIFY(shell.type("login", "ada"));
    enter("login");
    QVERIFY(shell.focusIsIn("password"));
    QVERIFY(shell.find<QLabel>("login_message")->isVisible());
    QVERIFY(shell.type("password", "correct horse"));
    enter("password");
    QVERIFY(shell.context().signedIn());
    QVERIFY(shell.arrives(PageId::kPeople));
}

void ShellFormsTest::theNextPersonIsATraineeAgain() {
    ShellHarness& shell = *shell_;
    QVERIFY(fill("Eva Educator", "eva"));
    role(1)->setChecked(false);
    role(2)->setChecked(true);
    role(4)->setChecked(true);
    QVERIFY(shell.click("add_person"));
    QVERIFY(shell.bannerSays("Eva Educator was added: Educator, Coordinator"));
    QCOMPARE(rolesOf("eva"), 2 + 4);
    QVERIFY(role(1)->isChecked());
    for (const int bit : {2, 4, 8}) QVERIFY(!role(bit)->isChecked());
    QVERIFY(shell.focusIsIn("new_name"));
    QVERIFY(fill("Tom Trainee", "tom"));
    QVERIFY(shell.click("add_person"));
    QVERIFY(shell.bannerSays("Tom Trainee was added: Trainee"));
    QVERIFY(shell.click("add_person"));  // the second click of a double click
    QVERIFY(!shell.find<QLabel>("add_message")->isVisible());
    QCOMPARE(rolesOf("tom"), 1);
    shell.shot("61_person_added");
}

void ShellFormsTest::whoIsMoreThanATraineeIsSaidBefore() {
    ShellHarness& shell = *shell_;
    QCOMPARE(shell.text("role_summary"), QString("Will be: Trainee"));
    role(8)->setChecked(true);
    QCOMPARE(shell.text("role_summary"), QString("Will be: Trainee, Administrator"));
    QCOMPARE(shell.find<QLabel>("role_summary")->property("role").toString(), QString("warn"));
    role(1)->setChecked(false);
    role(8)->setChecked(false);
    QVERIFY(fill("Nobody", "nobody"));
    QVERIFY(shell.click("add_person"));
    QVERIFY(shell.text("add_message").contains("at least one role"));
    QCOMPARE(rolesOf("nobody"), -1);
    role(1)->setChecked(true);
}

void ShellFormsTest::enterAddsAPerson() {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.type("new_name", "Pia Person"));
    QVERIFY(shell.type("new_login", ""));
    enter("new_name");
    QVERIFY(shell.text("add_message").contains("Log-in name"));
    QVERIFY(shell.focusIsIn("new_login"));
    // The name of somebody else, and one that nobody can type again: said at the field.
    QVERIFY(fill("Pia Person", "TOM"));
    enter("new_password");
    QVERIFY(shell.text("add_message").contains("tom is taken: Tom Trainee has it"));
    QVERIFY(shell.focusIsIn("new_login"));
    QVERIFY(fill("Pia Person", "pia person"));
    enter("new_password");
    QVERIFY(shell.text("add_message").contains("no spaces"));
    QVERIFY(fill("Pia Person", "pia"));
    QVERIFY(!shell.find<QLabel>("add_message")->isVisible());
    enter("new_password");
    QCOMPARE(rolesOf("pia"), 1);
    QVERIFY(!shell.find<QLabel>("add_message")->isVisible());
}

void ShellFormsTest::enterChangesThePassword() {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.signIn("tom", "first password"));
    // Whoever made the account knows this password: signing in begins with another one.
    QVERIFY(shell.arrives(PageId::kAccount));
    QVERIFY(shell.find<QLabel>("given_password")->isVisible());
    shell.shot("63_given_password");
    QVERIFY(shell.type("new_password", "second password"));
    enter("new_password");
    QVERIFY(shell.focusIsIn("old_password"));
    QVERIFY(shell.text("account_message").contains("Present password"));
    QVERIFY(shell.type("old_password", "first password"));
    QVERIFY(shell.type("again_password", "second password"));
    enter("again_password");
    QVERIFY(shell.bannerSays("password was changed"));
    QVERIFY(!shell.find<QLabel>("given_password")->isVisible());
    QVERIFY(shell.signIn("tom", "second password"));
    QVERIFY(shell.arrives(PageId::kToday));
}

void ShellFormsTest::enterMakesAnAccountByInvitation() {
    ShellHarness& shell = *shell_;
    db::InvitationRecord invitation;
    invitation.roles = 1;
    invitation.expires_utc = "2999-01-01";
    const std::string code = shell.owner().accounts().invite(invitation);
    shell.context().signOut();
    QVERIFY(shell.arrives(PageId::kLogin));
    QVERIFY(shell.click("open_join"));
    QVERIFY(shell.arrives(PageId::kJoin));
    QTest::qWait(50);
    QVERIFY(shell.type("join_name", "I"));
    enter("join_name");
    QVERIFY(shell.focusIsIn("join_code"));
    QVERIFY(shell.type("join_code", QString::fromStdString(code)));
    QVERIFY(shell.type("join_name", "Ian Invited"));
    QVERIFY(shell.type("join_login", "ian"));
    QVERIFY(shell.type("join_password", "long enough 1"));
    QVERIFY(shell.type("join_again", "long enough 1"));
    enter("join_login");
    QVERIFY(shell.arrives(PageId::kLogin));
    QCOMPARE(shell.find<QLineEdit>("login")->text(), QString("ian"));
    QCOMPARE(rolesOf("ian"), 1);
}

void ShellFormsTest::onlyPeopleOfThisStoreAreProposed() {
    ShellHarness& shell = *shell_;
    shell.start();
    QVERIFY(shell.arrives(PageId::kLogin));
    QVERIFY(shell.find<QPushButton>("person_tom") != nullptr);
    QVERIFY(shell.find<QPushButton>("person_ada") != nullptr);
    // Another store on the same computer: nobody of the first one, and no name in the field.
    shell.start("second.db");
    QVERIFY(shell.arrives(PageId::kSetup));
    QVERIFY(shell.setUpWithDemonstration());
    QCOMPARE(shell.find<QLineEdit>("login")->text(), QString("ada"));
    QVERIFY(shell.find<QPushButton>("person_tom") == nullptr);
    QVERIFY(shell.find<QPushButton>("person_ada") == nullptr);  // has not signed in here yet
    QVERIFY(shell.signIn("demo.trainee", "placode-demo"));
    shell.start("second.db");
    QVERIFY(shell.arrives(PageId::kLogin));
    QVERIFY(shell.find<QPushButton>("person_demo.trainee") != nullptr);
    shell.shot("62_login_of_this_store");
    // And back: the first store has its own people still.
    shell.start("placode.db");
    QVERIFY(shell.arrives(PageId::kLogin));
    QVERIFY(shell.find<QPushButton>("person_tom") != nullptr);
    QVERIFY(shell.find<QPushButton>("person_demo.trainee") == nullptr);
}

void ShellFormsTest::whoIsDeactivatedIsNotProposed() {
    ShellHarness& shell = *shell_;
    db::Store& store = shell.owner();
    store.accounts().set_active(shell.idOf("tom"), false);
    shell.start();
    QVERIFY(shell.arrives(PageId::kLogin));
    QVERIFY(shell.find<QPushButton>("person_tom") == nullptr);
    QVERIFY(shell.find<QPushButton>("person_ada") != nullptr);
    QCOMPARE(shell.find<QLineEdit>("login")->text().contains("tom"), false);
}

// Scrolling past a list of answers chose one, without a word.
void ShellFormsTest::theWheelScrollsAndChangesNoAnswer() {
    QWidget page;
    auto* answer = new QComboBox(&page);
    answer->addItems({"", "yes", "no"});
    auto* years = new QSpinBox(&page);
    auto* rating = new QSlider(Qt::Horizontal, &page);
    rating->move(0, 90);
    years->move(0, 45);
    page.resize(200, 140);
    page.show();
    QVERIFY(QTest::qWaitForWindowExposed(&page));
    for (QWidget* field : {static_cast<QWidget*>(answer), static_cast<QWidget*>(years),
                           static_cast<QWidget*>(rating)}) {
        field->setFocus();
        const QPointF middle = field->rect().center();
        QWheelEvent wheel(middle, field->mapToGlobal(middle), {}, {0, -240}, Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(field, &wheel);
    }
    QCOMPARE(answer->currentIndex(), 0);
    QCOMPARE(years->value(), 0);
    QCOMPARE(rating->value(), 0);
}

void ShellFormsTest::whatWasTypedStaysInTheOtherLanguageAndAfterALock() {
    ShellHarness& shell = *shell_;
    shell.lock_after_s = 2;
    shell.start();
    QVERIFY(shell.signIn("eva", "first password"));
    const auto name = [&shell] { return shell.find<QLineEdit>("new_group")->text(); };
    shell.window().open({PageId::kGroups, 0, {}, {}});
    QVERIFY(shell.arrives(PageId::kGroups));
    QVERIFY(shell.type("new_group", "Not added yet"));
    for (const char* language : {"pl", "en"}) {
        shell.context().setLanguage(language);
        QCOMPARE(name(), QString("Not added yet"));
    }
    QVERIFY(QTest::qWaitFor([&] { return !shell.context().signedIn(); }, 10000));
    QVERIFY(shell.signIn("eva", "first password"));
    QVERIFY(shell.arrives(PageId::kGroups));
    QCOMPARE(name(), QString("Not added yet"));
    // For whoever typed it: the next person finds an empty field, also on the same page.
    QVERIFY(QTest::qWaitFor([&] { return !shell.context().signedIn(); }, 10000));
    QVERIFY(shell.signIn("ada", "correct horse"));
    shell.window().open({PageId::kGroups, 0, {}, {}});
    QVERIFY(shell.arrives(PageId::kGroups));
    QCOMPARE(name(), QString());
    shell.lock_after_s = 0;
}

void ShellFormsTest::aQuestionThatNobodyAnswersKeepsNoSessionOpen() {
    ShellHarness& shell = *shell_;
    shell.lock_after_s = 1;
    shell.start();
    QVERIFY(shell.signIn("ada", "correct horse"));
    QVERIFY2(!confirm(&shell.window(), "Remove it?", "For good.", "Remove"),
             "a question that time answers is answered with no");
    QVERIFY(QTest::qWaitFor([&] { return !shell.context().signedIn(); }, 10000));
    shell.lock_after_s = 0;
    shell.start();
}

// Where a button leads on, the second click of a double click met whatever stood there next: the
// start of a procedure, or "Remove" of the question.
void ShellFormsTest::theSecondOfTwoClicksPressesNothingNew() {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.signIn("eva", "first password"));
    shell.window().open({PageId::kAttempts, 0, {}, {}});
    QVERIFY(shell.arrives(PageId::kAttempts));
    QVERIFY(QTest::qWaitForWindowExposed(&shell.window()));
    auto* rail = shell.find<QToolButton>("rail_groups");
    QVERIFY(rail != nullptr);
    int clicks = 0;
    connect(rail, &QToolButton::clicked, this, [&clicks] { ++clicks; });
    const auto click = [&] {
        QTest::mouseClick(shell.window().windowHandle(), Qt::LeftButton, {},
                          rail->mapTo(&shell.window(), rail->rect().center()));
    };
    const int pause = QApplication::doubleClickInterval() + 100;
    QTest::qWait(pause);
    click();
    QCOMPARE(shell.window().current(), PageId::kGroups);
    click();
    QCOMPARE(clicks, 1);
    QTest::qWait(pause);
    click();
    QCOMPARE(clicks, 2);
    // A question that opens below the pointer.
    QTest::qWait(pause);
    bool stood = false;
    QTimer::singleShot(100, &shell.window(), [&stood] {
        auto* box = qobject_cast<QDialog*>(QApplication::activeModalWidget());
        if (box == nullptr) return;
        const auto* yes = box->findChild<QPushButton*>("confirm_yes");
        const QPoint at = yes->mapTo(box, yes->rect().center());
        const QPointF there = box->mapToGlobal(at);
        QWindow before;
        QMouseEvent first(QEvent::MouseButtonPress, {1, 1}, {1, 1}, there, Qt::LeftButton,
                          Qt::LeftButton, {});
        QCoreApplication::sendEvent(&before, &first);
        QTest::mouseClick(box->windowHandle(), Qt::LeftButton, {}, at);
        stood = box->isVisible();
        box->reject();
    });
    QVERIFY(!confirm(&shell.window(), "Remove it?", "For good.", "Remove"));
    QVERIFY2(stood, "the second of two clicks answers no question");
}

void ShellFormsTest::enterAndEscapeKeepEverything() {
    for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Enter, Qt::Key_Escape}) {
        bool asked = false;
        QTimer::singleShot(100, &shell_->window(), [&asked, key] {
            QWidget* box = QApplication::activeModalWidget();
            asked = box != nullptr;
            if (asked) QTest::keyClick(box, key);
        });
        QVERIFY2(!confirm(&shell_->window(), "Remove it?", "For good.", "Remove"),
                 qPrintable(QKeySequence(key).toString()));
        QVERIFY(asked);
    }
}

// A double click granted twice, made two codes of which the first was never seen, and a held Enter
// did it as often as the keyboard repeats.
void ShellFormsTest::aButtonThatActsIsPressedOnce() {
    ShellHarness& shell = *shell_;
    int clicks = 0;
    const auto made = [&](const char* role) {
        QPushButton* button = make_button(shell.context(), "Act", role);
        button->setParent(&shell.window());
        button->setGeometry(300, 300, 120, 44);
        button->show();
        button->raise();
        connect(button, &QPushButton::clicked, this, [&clicks] { ++clicks; });
        return std::unique_ptr<QPushButton>(button);
    };
    const auto click = [&](const QPushButton& button) {
        QTest::mouseClick(shell.window().windowHandle(), Qt::LeftButton, {},
                          button.mapTo(&shell.window(), button.rect().center()));
    };
    const int pause = QApplication::doubleClickInterval() + 100;
    QVERIFY(QTest::qWaitForWindowExposed(&shell.window()));
    for (const auto& [role, wanted] : {std::pair{"primary", 1}, {"danger", 1}, {"quiet", 2}}) {
        const auto button = made(role);
        QTest::qWait(pause);
        clicks = 0;
        click(*button);
        click(*button);
        QVERIFY2(clicks == wanted, role);
    }
    const auto button = made("secondary");
    button->setFocus();
    clicks = 0;
    for (const bool repeated : {false, true, true}) {
        QKeyEvent enter(QEvent::KeyPress, Qt::Key_Return, Qt::NoModifier, "\r", repeated);
        QCoreApplication::sendEvent(shell.window().windowHandle(), &enter);
    }
    QCOMPARE(clicks, 1);
}

// The name stayed and the roles went back to trainee: the person was added with other rights than
// had been ticked.
void ShellFormsTest::whatWasChosenStaysWithWhatWasTyped() {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.signIn("ada", "correct horse"));
    shell.window().open({PageId::kPeople, 0, {}, {}});
    QVERIFY(shell.arrives(PageId::kPeople));
    QVERIFY(shell.type("new_name", "Half Filled"));
    role(1)->setChecked(false);
    role(2)->setChecked(true);
    const auto anew = [&shell] {
        for (const char* language : {"pl", "en"}) shell.context().setLanguage(language);
        for (const ThemeKind theme : {ThemeKind::kDark, ThemeKind::kLight})
            shell.context().setTheme(theme);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    };
    anew();
    QCOMPARE(shell.find<QLineEdit>("new_name")->text(), QString("Half Filled"));
    QVERIFY(!role(1)->isChecked() && role(2)->isChecked());
    shell.window().open({PageId::kAdmissions, 0, {}, {}});
    QVERIFY(shell.arrives(PageId::kAdmissions));
    auto* as = shell.find<QComboBox>("invite_role");
    as->setCurrentIndex(2);
    const QDate day = shell.find<QDateEdit>("invite_until")->date().addDays(3);
    shell.find<QDateEdit>("invite_until")->setDate(day);
    anew();
    QCOMPARE(shell.find<QComboBox>("invite_role")->currentIndex(), 2);
    QCOMPARE(shell.find<QDateEdit>("invite_until")->date(), day);
    // Words that are no entry of a list stay words.
    QWidget page;
    auto* list = new QComboBox(&page);
    list->setObjectName("list");
    list->setEditable(true);
    list->addItem("One", 1);
    list->setEditText("On");
    keep_choice(list);
    const QVariantMap typed = typed_texts(page);
    list->setEditText("");
    type_again(page, typed);
    QCOMPARE(list->currentText(), QString("On"));
}

void ShellFormsTest::aHalfFilledFormIsThereAgainAfterAnotherPage() {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.signIn("ada", "correct horse"));
    const auto visit = [&shell](PageId page) {
        shell.window().open({page, 0, {}, {}});
        return shell.arrives(page);
    };
    QVERIFY(visit(PageId::kPeople));
    QVERIFY(shell.type("new_name", "Looked Up Elsewhere"));
    role(4)->setChecked(true);
    QVERIFY(visit(PageId::kGroups));
    QVERIFY(visit(PageId::kPeople));
    QCOMPARE(shell.find<QLineEdit>("new_name")->text(), QString("Looked Up Elsewhere"));
    QVERIFY(role(4)->isChecked());
    // Whoever signs in next finds an empty form.
    QVERIFY(visit(PageId::kGroups));
    QVERIFY(shell.signIn("ada", "correct horse"));
    QVERIFY(visit(PageId::kPeople));
    QCOMPARE(shell.find<QLineEdit>("new_name")->text(), QString());
}

}  // namespace placode::ui

int main(int argc, char** argv) {
    placode::ui::prepare_display();
    QApplication application(argc, argv);
    placode::ui::ShellFormsTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "shell_forms_test.moc"
