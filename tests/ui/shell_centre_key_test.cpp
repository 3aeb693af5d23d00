// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The passphrase of the centre's key, asked for on the page that needs it: what it is for, shown
// and hidden, wrong ones, given up, and nothing that locks.

#include <QCheckBox>

#include "db/signature.h"
#include "db/store_context.h"
#include "shell_harness.h"
#include "tests/watched_program.h"
#include "ui/shell/passphrase_dialog.h"

namespace placode::ui {

class ShellCentreKeyTest : public QObject {
    Q_OBJECT

 private Q_SLOTS:
    void initTestCase() {
        shell_ = std::make_unique<ShellHarness>();
        QVERIFY(shell_->setUpWithDemonstration());
    }
    void cleanupTestCase() { shell_.reset(); }

    void aStoreFromBeforeSaysThatItsKeyLiesInClear();
    void thePassphraseIsAskedForUntilItIsRight();
    void whatWasSealedSaysNothingMore();
    void nothingThatWasTypedIsLeftBehind();

 private:
    using Dialog = std::function<void(QWidget& dialog)>;
    /// Runs the steps one after the other in the next dialog for a passphrase; the last one ends
    /// it.
    void inDialog(std::vector<Dialog> steps) {
        QTimer::singleShot(50, &shell_->window(), [this, steps] {
            QWidget* dialog = QApplication::activeModalWidget();
            if (dialog == nullptr || dialog->objectName() != "passphrase_dialog")
                return inDialog(steps);
            ++dialogs_;
            for (const Dialog& step : steps) step(*dialog);
        });
    }
    static QLineEdit* line(QWidget& dialog, const char* name) {
        return dialog.findChild<QLineEdit*>(name);
    }
    static void answer(QWidget& dialog, const QString& first, const QString& second = {}) {
        QTest::keyClicks(line(dialog, "passphrase"), first);
        if (auto* again = line(dialog, "passphrase_again")) QTest::keyClicks(again, second);
        QTest::mouseClick(dialog.findChild<QPushButton*>("passphrase_yes"), Qt::LeftButton);
    }
    static QString said(QWidget& dialog) {
        const auto* label = dialog.findChild<QLabel*>("passphrase_message");
        return label->isVisibleTo(&dialog) ? label->text() : QString();
    }
    void keepInClear() {
        const db::KeyPair pair = db::new_key_pair();
        clear_key_ = pair.secret_key.substr(0, 64);  // The other half is the public key.
        db::StoreContext context(db::parse_store_url(shell_->context().storeUrl()), {});
        db::UnitOfWork work(context.connection);
        db::Statement(context.connection,
                      "INSERT INTO centre_key (id, centre, public_key, secret_key, made_utc) "
                      "VALUES (1, 'Gdansk', ?, ?, '')")
            .run(pair.public_key, pair.secret_key);
        context.made("centre key", 1);
        work.commit();
    }

    std::unique_ptr<ShellHarness> shell_;
    int dialogs_ = 0;
    std::string clear_key_;
};

void ShellCentreKeyTest::aStoreFromBeforeSaysThatItsKeyLiesInClear() {
    ShellHarness& shell = *shell_;
    keepInClear();
    QVERIFY(shell.signIn("ada", "correct horse"));
    QVERIFY(shell.arrives(PageId::kPeople));
    shell.window().open({PageId::kHealth, 0, {}, {}});
    QVERIFY(shell.arrives(PageId::kHealth));
    QVERIFY(shell.text("clear_key").contains("lies in clear"));
    QVERIFY(shell.text("clear_key").contains("placodectl norms key seal"));
    shell.whole("90_clear_key");
}

void ShellCentreKeyTest::thePassphraseIsAskedForUntilItIsRight() {
    ShellHarness& shell = *shell_;
    // Given up: nothing was done, and it can be asked again at once.
    inDialog({[](QWidget& dialog) {
        QTest::mouseClick(dialog.findChild<QPushButton*>("passphrase_no"), Qt::LeftButton);
    }});
    QVERIFY(shell.click("seal_key"));
    QVERIFY(!shell.owner().norms().centre_key()->sealed);
    inDialog(
        {[this](QWidget& dialog) {
             QCOMPARE(line(dialog, "passphrase")->echoMode(), QLineEdit::Password);
             dialog.findChild<QCheckBox*>("passphrase_show")->setChecked(true);
             QCOMPARE(line(dialog, "passphrase_again")->echoMode(), QLineEdit::Normal);
             shell_->keep(dialog.grab(), "90_passphrase");
         },
         [](QWidget& dialog) {
             answer(dialog, "");
             QVERIFY2(said(dialog).contains("Type the passphrase"), qPrintable(said(dialog)));
         },
         [](QWidget& dialog) {
             answer(dialog, "four words are good", "four words are bad");
             QVERIFY2(said(dialog).contains("differ"), qPrintable(said(dialog)));
             line(dialog, "passphrase")->clear();
             line(dialog, "passphrase_again")->clear();
         },
         [this](QWidget& dialog) {
             answer(dialog, "short", "short");
             QVERIFY2(said(dialog).contains("too short"), qPrintable(said(dialog)));
             shell_->keep(dialog.grab(), "90_passphrase_short");
         },
         [](QWidget& dialog) { answer(dialog, "four words are good", "four words are good"); }});
    QVERIFY(shell.click("seal_key"));
    QVERIFY(shell.owner().norms().centre_key()->sealed);
    QVERIFY(shell.bannerSays("sealed"));
    QVERIFY(!shell.find<QLabel>("clear_key") || !shell.find<QLabel>("clear_key")->isVisible());
    // To open it: wrong as often as somebody likes, then right.
    int used = 0;
    std::vector<Dialog> steps(6, [](QWidget& dialog) {
        answer(dialog, "not this one at all");
        QVERIFY2(said(dialog).contains("passphrase of the centre's key is wrong"),
                 qPrintable(said(dialog)));
        QVERIFY(line(dialog, "passphrase")->text().isEmpty());
    });
    steps.emplace_back([](QWidget& dialog) { answer(dialog, "four words are good"); });
    inDialog(steps);
    QVERIFY(
        ask_centre_passphrase(shell.context(), &shell.window(), [&](std::string_view passphrase) {
            (void)shell.owner().norms().open_centre_key("", passphrase);
            ++used;
        }));
    QCOMPARE(used, 1);
    QCOMPARE(dialogs_, 3);
}

void ShellCentreKeyTest::whatWasSealedSaysNothingMore() {
    ShellHarness& shell = *shell_;
    shell.window().open({PageId::kPeople, 0, {}, {}});
    QVERIFY(shell.arrives(PageId::kPeople));
    shell.window().open({PageId::kHealth, 0, {}, {}});
    QVERIFY(shell.arrives(PageId::kHealth));
    QVERIFY(shell.find<QLabel>("clear_key") == nullptr);
}

void ShellCentreKeyTest::nothingThatWasTypedIsLeftBehind() {
    // Store, its log and note, settings: all that the shell writes here.
    const std::string folder = shell_->path({}).toStdString();
    QVERIFY(!test::files_with(folder, "Gdansk").empty());
    for (const std::string& secret :
         {std::string("correct horse"), std::string("four words are good"),
          std::string("not this one at all"), clear_key_}) {
        const auto found = test::files_with(folder, secret);
        QVERIFY2(found.empty(), found.empty() ? "" : (found.front() + ": " + secret).c_str());
    }
}

}  // namespace placode::ui

int main(int argc, char** argv) {
    placode::ui::prepare_display();
    QApplication application(argc, argv);
    placode::ui::ShellCentreKeyTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "shell_centre_key_test.moc"
