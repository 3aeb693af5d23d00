// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The three ways from the first start: alone with one click, a station, a centre's server.

#include "page_fit.h"
#include "shell_harness.h"

namespace placode::ui {

class ShellFirstStartTest : public QObject {
    Q_OBJECT

 private Q_SLOTS:
    void init() { shell_ = std::make_unique<ShellHarness>(); }
    void cleanup() { shell_.reset(); }
    void oneClickLeadsToTheFirstExercise();
    void whoIsAloneComesBackWithOneClick();
    void noLockWhereThereIsNoPassword();
    void aProfileBecomesAnAccountAndOthersMayCome();
    void theStationsFormHasAWayBack();
    void anAddressIsLookedAtBeforeItIsUsed();
    void aServerThatIsAwayLeavesEverythingAsItWas();
    void theServersPasswordIsAskedForInAFrame();
    void aChosenServerThatIsGoneIsNoDeadEnd();
    void everyWayFitsASmallScreen();

 private:
    [[nodiscard]] bool beginsAlone() {
        return shell_->arrives(PageId::kSetup) && shell_->click("way_alone") &&
               shell_->arrives(PageId::kTask);
    }
    std::unique_ptr<ShellHarness> shell_;
};

void ShellFirstStartTest::oneClickLeadsToTheFirstExercise() {
    shell_->shot("05_first_start_ways");
    QVERIFY(beginsAlone());
    QCOMPARE(shell_->window().page()->aboutTask(), QString("familiarisation"));
    QVERIFY(shell_->find<QPushButton>("start_attempt")->isEnabled());
    QCOMPARE(shell_->find<QComboBox>("device")->currentData().toString(), QString("mouse"));
    QCOMPARE(shell_->owner().accounts().list().size(), size_t{1});
    shell_->shot("06_first_exercise_of_a_guest");
}

void ShellFirstStartTest::whoIsAloneComesBackWithOneClick() {
    QVERIFY(beginsAlone());
    shell_->start();
    QVERIFY(shell_->arrives(PageId::kLogin));
    QVERIFY(shell_->find<QLineEdit>("password") == nullptr);
    const auto on_button = [&] {
        return shell_->window().focusWidget() == shell_->find<QPushButton>("enter");
    };
    QVERIFY2(QTest::qWaitFor(on_button), "Enter is enough");
    shell_->shot("07_alone_comes_back");
    QVERIFY(shell_->click("enter"));
    QVERIFY(QTest::qWaitFor([&] { return shell_->context().signedIn(); }));
    QVERIFY(shell_->window().page() != nullptr);
}

void ShellFirstStartTest::noLockWhereThereIsNoPassword() {
    QVERIFY(beginsAlone());
    const auto touched_and_left = [&] {
        QVERIFY(shell_->click("rail_today"));
        QTest::qWait(2500);
    };
    shell_->lock_after_s = 1;
    shell_->start();
    QVERIFY(shell_->click("enter"));
    touched_and_left();
    QVERIFY(shell_->context().signedIn());
    // With a password it locks as for all others.
    const db::NewUser anna{"anna", "Anna Nowak", "correct horse", 1, false};
    shell_->context().store().accounts().name_local_profile(anna);
    touched_and_left();
    QVERIFY(!shell_->context().signedIn());
}

void ShellFirstStartTest::aProfileBecomesAnAccountAndOthersMayCome() {
    QVERIFY(beginsAlone());
    const int64_t self = shell_->context().user().id;
    // Nobody else while there is no password, and the message says what to do.
    shell_->window().open({PageId::kPeople, 0, {}, {}});
    QVERIFY(shell_->arrives(PageId::kPeople));
    QVERIFY(shell_->type("new_name", "Tom Trainee"));
    QVERIFY(shell_->type("new_login", "tom"));
    QVERIFY(shell_->type("new_password", "first password"));
    QVERIFY(shell_->click("add_person"));
    QVERIFY(shell_->bannerSays("make an account of that profile first"));
    shell_->window().open({PageId::kAccount, 0, {}, {}});
    QVERIFY(shell_->arrives(PageId::kAccount));
    QVERIFY(shell_->find<QLineEdit>("old_password") == nullptr);
    shell_->shot("08_account_of_a_guest");
    QVERIFY(shell_->type("own_name", "Anna Nowak"));
    QVERIFY(shell_->type("own_login", "anna"));
    QVERIFY(shell_->type("own_password", "correct horse"));
    QVERIFY(shell_->type("own_password_again", "correct hose"));
    QVERIFY(shell_->click("make_account"));
    QVERIFY(shell_->text("account_message").contains("differ"));
    QVERIFY(shell_->owner().accounts().local_profile().has_value());
    QVERIFY(shell_->type("own_password_again", "correct horse"));
    QVERIFY(shell_->click("make_account"));
    QVERIFY(QTest::qWaitFor([&] { return shell_->context().user().login == "anna"; }));
    QCOMPARE(shell_->context().user().id, self);
    shell_->start();
    QVERIFY(shell_->arrives(PageId::kLogin));
    QVERIFY(shell_->find<QPushButton>("enter") == nullptr);
    QVERIFY(shell_->signIn("anna", "correct horse"));
    shell_->owner().accounts().create({"tom", "Tom Trainee", "first password", 1, false});
}

void ShellFirstStartTest::theStationsFormHasAWayBack() {
    QVERIFY(shell_->setsUpStation());
    QVERIFY(shell_->type("display_name", "Ada Admin"));
    // What was typed stays when the language changes.
    shell_->context().setLanguage("pl");
    QVERIFY(QTest::qWaitFor([&] {
        auto* name = shell_->find<QLineEdit>("display_name");
        return name != nullptr && name->text() == "Ada Admin";
    }));
    shell_->context().setLanguage("en");
    QVERIFY(shell_->click("way_back"));
    QVERIFY(QTest::qWaitFor([&] { return shell_->find<QPushButton>("way_alone") != nullptr; }));
}

void ShellFirstStartTest::anAddressIsLookedAtBeforeItIsUsed() {
    QVERIFY(shell_->arrives(PageId::kSetup) && shell_->click("way_server"));
    QVERIFY(QTest::qWaitFor([&] { return shell_->find<QLineEdit>("server_address") != nullptr; }));
    const std::pair<const char*, const char*> cases[]{
        {"", "Type the server"},
        {"db.example.org", "begins with postgresql://"},
        {"http://db.example.org/placode", "begins with postgresql://"},
        {"postgresql://me:secret@db.example.org/placode", "Leave the password out"}};
    for (const auto& [typed, said] : cases) {
        QVERIFY(shell_->type("server_address", typed));
        QVERIFY(shell_->click("connect_server"));
        QVERIFY2(shell_->text("setup_message").contains(said), typed);
        QVERIFY(!shell_->text("setup_message").contains("secret"));
    }
    shell_->shot("09_server_address");
}

void ShellFirstStartTest::aServerThatIsAwayLeavesEverythingAsItWas() {
    QVERIFY(shell_->arrives(PageId::kSetup) && shell_->click("way_server"));
    QVERIFY(QTest::qWaitFor([&] { return shell_->find<QLineEdit>("server_address") != nullptr; }));
    qputenv("PGPASSWORD", "not asked for");
    QVERIFY(shell_->type("server_address", "postgresql://a@127.0.0.1:1/placode"));
    QVERIFY(shell_->click("connect_server"));
    qunsetenv("PGPASSWORD");
    QVERIFY(shell_->bannerSays("cannot be reached"));
    QCOMPARE(shell_->find<QLineEdit>("server_address")->text(),
             QString("postgresql://a@127.0.0.1:1/placode"));
    // The own store is open again, and the other ways are there.
    QVERIFY(shell_->click("way_back"));
    QVERIFY(QTest::qWaitFor([&] { return shell_->find<QPushButton>("way_alone") != nullptr; }));
    QVERIFY(shell_->click("way_alone"));
    QVERIFY(shell_->arrives(PageId::kTask));
}

void ShellFirstStartTest::theServersPasswordIsAskedForInAFrame() {
    QVERIFY(shell_->arrives(PageId::kSetup) && shell_->click("way_server"));
    QVERIFY(QTest::qWaitFor([&] { return shell_->find<QLineEdit>("server_address") != nullptr; }));
    const QByteArray file = qgetenv("PGPASSFILE"), word = qgetenv("PGPASSWORD");
    qputenv("PGPASSFILE", shell_->path("no.pgpass").toLocal8Bit());
    qunsetenv("PGPASSWORD");
    QVERIFY(shell_->type("server_address", "postgresql://a@127.0.0.1:1/placode"));
    bool framed = false, on_field = false;
    QTimer::singleShot(300, &shell_->window(), [&] {
        QWidget* dialog = QApplication::activeModalWidget();
        if (dialog == nullptr) return;
        framed = dialog->objectName() == "server_password_dialog" &&
                 dialog->findChild<QFrame*>("dialog_frame") != nullptr;
        auto* field = dialog->findChild<QLineEdit*>("server_password");
        on_field = field != nullptr && dialog->focusWidget() == field;
        QTest::keyClick(dialog, Qt::Key_Escape);
    });
    QVERIFY(shell_->click("connect_server"));
    file.isEmpty() ? qunsetenv("PGPASSFILE") : qputenv("PGPASSFILE", file);
    if (!word.isEmpty()) qputenv("PGPASSWORD", word);
    QVERIFY2(framed, "as every other question");
    QVERIFY(on_field);
    QVERIFY2(!shell_->window().banner().isShown(), "who gives up has tried nothing");
    QVERIFY(shell_->context().storeIsOpen() && shell_->context().storeIsFile());
    QCOMPARE(shell_->find<QLineEdit>("server_address")->text(),
             QString("postgresql://a@127.0.0.1:1/placode"));
}

void ShellFirstStartTest::aChosenServerThatIsGoneIsNoDeadEnd() {
    AppContext& context = shell_->context();
    context.settings().setValue("chosen_store", "postgresql://a@127.0.0.1:1/placode");
    context.settings().sync();
    qputenv("PGPASSWORD", "not asked for");
    qputenv("XDG_DATA_HOME", shell_->path("own").toLocal8Bit());
    shell_->without_store = true;
    shell_->start();
    QVERIFY(QTest::qWaitFor([&] { return shell_->find<QPushButton>("use_own_store") != nullptr; },
                            20000));
    shell_->shot("10_server_is_gone");
    QVERIFY(shell_->click("use_own_store"));
    QVERIFY(shell_->arrives(PageId::kSetup));
    qunsetenv("PGPASSWORD");
    QVERIFY(shell_->context().settings().value("chosen_store").isNull());
}

void ShellFirstStartTest::everyWayFitsASmallScreen() {
    QVERIFY(shell_->arrives(PageId::kSetup));
    for (const char* way : {"", "way_station", "way_server"}) {
        if (*way != '\0') {
            QVERIFY(shell_->click(way));
            QVERIFY(
                QTest::qWaitFor([&] { return shell_->find<QPushButton>("way_back") != nullptr; }));
        }
        for (const QSize size : {QSize(960, 540), QSize(1366, 768)}) {
            shell_->window().resize(size);
            QTest::qWait(100);
            const QStringList cut = misfits(shell_->window());
            QVERIFY2(cut.isEmpty(), qPrintable(cut.join("\n")));
        }
        if (*way != '\0') {
            QVERIFY(shell_->click("way_back"));
            QVERIFY(
                QTest::qWaitFor([&] { return shell_->find<QPushButton>("way_alone") != nullptr; }));
        }
    }
}

}  // namespace placode::ui

int main(int argc, char** argv) {
    placode::ui::prepare_display();
    QApplication application(argc, argv);
    placode::ui::ShellFirstStartTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "shell_first_start_test.moc"
