// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A simulator that crashes leaves a report, and its reader sees all of it before anybody else.

#include <signal.h>

#include <QDialog>
#include <QDir>
#include <QFile>
#include <QPlainTextEdit>
#include <QProcess>

#include "shell_harness.h"
#include "ui/diagnostics/crash_report.h"

namespace placode::ui {

class ShellDiagnosticsTest : public QObject {
    Q_OBJECT

 private Q_SLOTS:
    void initTestCase();
    void cleanupTestCase() { shell_.reset(); }
    void nothingIsOfferedWhereNothingCrashed();
    void aCrashIsSaidOnceWithAWayToItsReport();
    void theLogIsReadSavedAndHoldsNoNames();
    void theDailyBackupIsSwitchedFromThePage();
    void theDailyBackupIsOnOnlyForTheStoreThatItCopies();

 private:
    /// Puts a systemctl of the test's own first, which remembers in a file that is returned, and
    /// enables only what was read again before.
    [[nodiscard]] QString putSystemctl() const;
    [[nodiscard]] static bool opensHealth(ShellHarness& shell, const char* daily_says);
    /// What the dialog does while it is open; it is closed behind it.
    void whileOpen(const std::function<void(QDialog&)>& look);
    std::unique_ptr<ShellHarness> shell_;
    QTemporaryDir log_;
};

void ShellDiagnosticsTest::whileOpen(const std::function<void(QDialog&)>& look) {
    QTimer::singleShot(50, &shell_->window(), [this, look] {
        auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
        if (dialog == nullptr || dialog->objectName() != "diagnostics") return whileOpen(look);
        look(*dialog);
        dialog->accept();
    });
}

void ShellDiagnosticsTest::initTestCase() {
    qputenv("PLACODE_LOG", log_.path().toLocal8Bit());
    shell_ = std::make_unique<ShellHarness>();
    QVERIFY(shell_->setUpWithDemonstration());
}

void ShellDiagnosticsTest::nothingIsOfferedWhereNothingCrashed() {
    QVERIFY(shell_->signIn("ada", "correct horse"));
    QVERIFY(!shell_->window().banner().text().contains("crashed"));
}

void ShellDiagnosticsTest::aCrashIsSaidOnceWithAWayToItsReport() {
    QProcess simulator;
    simulator.start(PLACODE_BIN_DIR "/placode-sim",
                    {"--task", "touch_targets", "--device", "script:expert", "--headless"});
    QVERIFY(simulator.waitForStarted());
    QVERIFY(QTest::qWaitFor(
        [] { return read_log(diagnostics_folder()).find("attempt_began") != std::string::npos; },
        60000));
    ::kill(static_cast<pid_t>(simulator.processId()), SIGSEGV);
    QVERIFY(simulator.waitForFinished(60000));
    if (simulator.exitStatus() != QProcess::CrashExit ||
        crash_reports(diagnostics_folder()).empty())
        QSKIP("the sanitizer has its own report");
    QVERIFY(shell_->signIn("ada", "correct horse"));
    QVERIFY(shell_->bannerSays("placode-sim crashed on"));
    shell_->shot("99_crash_offer");
    QString read;
    whileOpen([&](QDialog& dialog) {
        read = dialog.findChild<QPlainTextEdit*>("diagnostics_text")->toPlainText();
        shell_->keep(dialog.grab(), "99_diagnostics");
    });
    QVERIFY(shell_->click("banner_offer"));
    QVERIFY2(read.contains("signal: SIGSEGV") && read.contains("placode-sim"), qPrintable(read));
    // Said once. The page of health has it as long as it is there.
    QVERIFY(shell_->signIn("ada", "correct horse"));
    QVERIFY(!shell_->window().banner().text().contains("crashed"));
    shell_->window().open({PageId::kHealth, 0, {}, {}});
    QVERIFY(shell_->arrives(PageId::kHealth));
    shell_->whole("99_health");
    QString after;
    whileOpen([&](QDialog& dialog) {
        auto* remove = dialog.findChild<QPushButton*>("diagnostics_delete");
        QVERIFY(remove->isEnabled());
        shell_->refuseNext();
        QTest::mouseClick(remove, Qt::LeftButton);
        QVERIFY2(!crash_reports(diagnostics_folder()).empty(), "it asks before");
        shell_->confirmNext();
        QTest::mouseClick(remove, Qt::LeftButton);
        after = dialog.findChild<QPlainTextEdit*>("diagnostics_text")->toPlainText();
        QVERIFY2(!remove->isEnabled(), "the log stays");
    });
    QVERIFY(shell_->click("show_diagnostics"));
    QVERIFY(crash_reports(diagnostics_folder()).empty());
    QVERIFY2(after.contains("placode-sim") && after.contains("attempt_began"), qPrintable(after));
}

void ShellDiagnosticsTest::theLogIsReadSavedAndHoldsNoNames() {
    shell_->save_as = shell_->path("log.txt");
    shell_->window().open({PageId::kHealth, 0, {}, {}});
    QVERIFY(shell_->arrives(PageId::kHealth));
    whileOpen([&](QDialog& dialog) {
        QTest::mouseClick(dialog.findChild<QPushButton*>("diagnostics_save"), Qt::LeftButton);
    });
    QVERIFY(shell_->click("show_diagnostics"));
    QFile saved(shell_->save_as);
    QVERIFY(saved.open(QIODevice::ReadOnly));
    const QString text = saved.readAll();
    QVERIFY2(text.contains("placode-sim") && text.contains("task=touch_targets"), qPrintable(text));
    for (const char* name : {"ada", "Ada", "demo", "/tmp", "/home", "sqlite"})
        QVERIFY2(!text.contains(name), name);
}

QString ShellDiagnosticsTest::putSystemctl() const {
    const QString on = shell_->path("timer_on"), folder = shell_->path("bin");
    QDir().mkpath(folder);
    QFile fake(folder + "/systemctl");
    if (!fake.open(QIODevice::WriteOnly)) return {};
    fake.write(QString("#!/bin/sh\n[ \"$1\" = --user ] || exit 9\ncase \"$2\" in\n"
                       "is-enabled) [ -e %1 ] && echo enabled && exit 0; echo disabled; exit 1;;\n"
                       "daemon-reload) touch %1.read;;\n"
                       "enable) [ -e %1.read ] && touch %1;;\ndisable) rm %1 %1.read;;\nesac\n")
                   .arg(on)
                   .toUtf8());
    fake.close();
    fake.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    qputenv("PATH", folder.toLocal8Bit() + ":" + qgetenv("PATH"));
    qputenv("XDG_CONFIG_HOME", shell_->path("config").toLocal8Bit());
    return on;
}

void ShellDiagnosticsTest::theDailyBackupIsSwitchedFromThePage() {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.signIn("ada", "correct horse"));
    const QByteArray path = qgetenv("PATH");
    const QString on = putSystemctl();
    QVERIFY(!on.isEmpty());
    qputenv("PLACODE_BACKUP_FOLDER", shell.path("copies").toLocal8Bit());
    QVERIFY(QDir().mkpath(shell.path("copies")));
    const auto says = [&](const char* words) {
        return QTest::qWaitFor([&] { return shell.text("daily_state").contains(words); }, 20000);
    };
    shell.window().open({PageId::kHealth, 0, {}, {}});
    QVERIFY(shell.arrives(PageId::kHealth));
    QVERIFY(says("It is off."));
    QVERIFY(shell.text("daily_newest").contains("No daily copy"));
    QVERIFY(shell.click("daily_switch"));
    QVERIFY(says("It is on."));
    QVERIFY(QFile::exists(on));
    QVERIFY(QFile(shell.path("copies/placode-20260101-030000.backup.db")).open(QFile::WriteOnly));
    QVERIFY(QFile(shell.path("copies/placode-20260102-030000.backup.db.failed"))
                .open(QFile::WriteOnly));
    shell.window().open({PageId::kAudit, 0, {}, {}});
    QVERIFY(shell.arrives(PageId::kAudit));
    shell.window().open({PageId::kHealth, 0, {}, {}});
    QVERIFY(shell.arrives(PageId::kHealth));
    QVERIFY(says("It is on."));
    QVERIFY(shell.text("daily_newest").contains("did not pass its check"));
    shell.whole("99_health_daily");
    QVERIFY2(says("It is on."), "the other theme makes the page anew");
    QVERIFY(shell.click("daily_switch"));
    QVERIFY(says("It is off."));
    QVERIFY(!QFile::exists(on));
    // Without systemd it says so, and offers nothing that cannot work.
    qputenv("PATH", shell.path("nothing").toLocal8Bit());
    shell.window().open({PageId::kAudit, 0, {}, {}});
    QVERIFY(shell.arrives(PageId::kAudit));
    shell.window().open({PageId::kHealth, 0, {}, {}});
    QVERIFY(shell.arrives(PageId::kHealth));
    QVERIFY(says("cannot be switched here"));
    QVERIFY(!shell.find<QPushButton>("daily_switch")->isVisible());
    qputenv("PATH", path);
    qunsetenv("XDG_CONFIG_HOME");
}

bool ShellDiagnosticsTest::opensHealth(ShellHarness& shell, const char* daily_says) {
    shell.window().open({PageId::kHealth, 0, {}, {}});
    return shell.arrives(PageId::kHealth) &&
           QTest::qWaitFor([&] { return shell.text("daily_state").contains(daily_says); }, 20000);
}

// It said that it was on for every file, and copied the one in the usual place.
void ShellDiagnosticsTest::theDailyBackupIsOnOnlyForTheStoreThatItCopies() {
    ShellHarness& shell = *shell_;
    const QByteArray path = qgetenv("PATH"), data = qgetenv("XDG_DATA_HOME");
    const QString on = putSystemctl();
    QVERIFY(QFile(on).open(QFile::WriteOnly));
    const QString drop_in = shell.path("config/systemd/user/placode-backup.service.d/store.conf");
    QFile::remove(drop_in);
    QVERIFY(shell.signIn("ada", "correct horse"));
    QVERIFY(opensHealth(shell, "It copies another store"));
    QVERIFY(shell.click("daily_switch"));
    QVERIFY(QTest::qWaitFor([&] { return shell.text("daily_state") == "✓ It is on."; }, 20000));
    QFile written(drop_in);
    QVERIFY(written.open(QFile::ReadOnly));
    const QByteArray text = written.readAll();
    QVERIFY2(text.contains("\n[Service]\nEnvironment=\"PLACODE_STORE=sqlite:" +
                           shell.path("placode.db").toUtf8() + "\"\n"),
             text.constData());
    // The store in the usual place: the service finds it by itself.
    QVERIFY(QDir().mkpath(shell.path("placode")));
    qputenv("XDG_DATA_HOME", QFileInfo(shell.path("placode")).path().toLocal8Bit());
    shell.start("placode/placode.db");
    QVERIFY(shell.setUpWithDemonstration());
    QVERIFY(shell.signIn("ada", "correct horse"));
    QVERIFY(opensHealth(shell, "It copies another store"));
    QVERIFY(shell.click("daily_switch"));
    QVERIFY(QTest::qWaitFor([&] { return shell.text("daily_state") == "✓ It is on."; }, 20000));
    QVERIFY(!QFile::exists(drop_in));
    qputenv("PATH", path);
    qunsetenv("XDG_CONFIG_HOME");
    data.isNull() ? qunsetenv("XDG_DATA_HOME") : qputenv("XDG_DATA_HOME", data);
}

}  // namespace placode::ui

int main(int argc, char** argv) {
    placode::ui::prepare_display();
    QApplication application(argc, argv);
    placode::ui::ShellDiagnosticsTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "shell_diagnostics_test.moc"
