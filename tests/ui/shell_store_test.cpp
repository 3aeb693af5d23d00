// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A store that is gone is no first start, an older one is brought up to date; a session ends when
// its account has changed; a recording that cannot be saved is copied elsewhere.

#include <QFileInfo>
#include <QProcess>
#include <QRadioButton>
#include <QSqlDatabase>
#include <QSqlError>
#include <QSqlQuery>
#include <initializer_list>
#include <vector>

#include "all_threads_taken.h"
#include "db/recording_order.h"
#include "page_fit.h"
#include "shell_harness.h"
#include "ui/shell/details.h"

namespace placode::ui {

class ShellStoreTest : public QObject {
    Q_OBJECT

 private Q_SLOTS:
    void init();
    void cleanup() { shell_.reset(); }
    void aStoreThatWasMovedIsFoundAgain();
    void aStoreThatIsGoneComesFromItsBackup();
    void nobodyOpensTheStoreWhileABackupIsPutInPlace();
    void anOlderStoreIsBroughtUpToDateBehindAPageThatSaysSo();
    void anUpdateThatFailsSaysWhereTheCopyLies();
    void anEmptyStoreIsBegunOnlyWhenSomebodySaysSo();
    void theRolesOfAPersonAreChanged();
    void aSessionEndsWhenItsRolesAreOthers();
    void aSessionEndsWhenItsAccountIsClosed();
    void theStoreIsNotAskedWhileAnAttemptRuns();
    void whatAParticipantAnsweredOutlivesTheSession();
    void aListAskedForAfterwardsLeadsToSignIn();
    void aRecordingIsCopiedElsewhereAndNeverOverItself();
    void whoseARecordingIsIsChosen();
    void aPageStaysAsLongAsItsQuestion();

 private:
    [[nodiscard]] QString file() const { return shell_->path("placode.db"); }
    /// Takes the store away while nobody has it open, and starts the shell.
    void loseStore(const QString& moved_to = {});
    [[nodiscard]] bool asksForTheStore() const {
        return shell_->find<QPushButton>("begin_anew") != nullptr &&
               shell_->find<QLineEdit>("login") == nullptr;
    }
    /// Changes a file that no program has open.
    static void edit(const QString& file, std::initializer_list<const char*> statements);
    /// As the version before left it.
    static void makeOlder(const QString& file) {
        edit(file, {"ALTER TABLE attempts DROP COLUMN read_by", kForgetNewest});
    }
    static constexpr const char* kForgetNewest =
        "DELETE FROM schema_migrations WHERE name = '0019_readings.sql'";
    [[nodiscard]] static QStringList keptBeside(const QString& file) {
        const QFileInfo store(file);
        return store.dir().entryList({store.fileName() + ".before-update-*"}, QDir::Files);
    }
    /// As from another computer.
    [[nodiscard]] std::unique_ptr<db::Store> elsewhere() const {
        auto store = db::open_store("sqlite:" + file().toStdString());
        store->act_as("ada");
        return store;
    }
    /// A page is opened after the store was last asked who may be here.
    [[nodiscard]] bool isSentToSignIn(const QString& because);
    /// The coordinator's roles, changed from another computer: the session ends by itself.
    void sessionEndsWith(db::Roles roles);
    /// Some seconds of an attempt that nobody has saved. Returns the recording.
    [[nodiscard]] QString leftover();

    std::unique_ptr<ShellHarness> shell_;
};

void ShellStoreTest::init() {
    shell_ = std::make_unique<ShellHarness>();
    QVERIFY(shell_->setUpWithDemonstration());
}

void ShellStoreTest::loseStore(const QString& moved_to) {
    shell_->stop();
    if (!moved_to.isEmpty()) QVERIFY(QFile::copy(file(), moved_to));
    for (const char* part : {"", "-wal", "-shm"}) QFile::remove(file() + part);
    shell_->start();
}

void ShellStoreTest::aStoreThatWasMovedIsFoundAgain() {
    const QString moved = shell_->path("elsewhere.db");
    loseStore(moved);
    QVERIFY(asksForTheStore());
    for (const QSize size : {QSize(960, 540), QSize(1366, 768)}) {
        shell_->window().resize(size);
        QTest::qWait(100);
        const QStringList cut = misfits(shell_->window());
        QVERIFY2(cut.isEmpty(), qPrintable(cut.join("\n")));
        shell_->keep(shell_->window().grab(), QString("04_store_is_gone_%1").arg(size.width()));
    }
    QVERIFY(shell_->click("try_again"));
    QVERIFY(QTest::qWaitFor([&] { return asksForTheStore(); }, 5000));
    QVERIFY2(!QFile::exists(file()), "looking for it must not make a new one");
    // A file without anything in it is not the store, and that is said.
    QFile empty(shell_->path("empty.db"));
    QVERIFY(empty.open(QIODevice::WriteOnly));
    empty.close();
    shell_->open_this = empty.fileName();
    QVERIFY(shell_->click("choose_store"));
    QVERIFY(QTest::qWaitFor([&] { return shell_->window().banner().isShown(); }, 5000));
    QVERIFY(asksForTheStore());
    shell_->open_this = moved;
    QVERIFY(shell_->click("choose_store"));
    QVERIFY(shell_->arrives(PageId::kLogin));
    QVERIFY(shell_->signIn("ada", "correct horse"));
    // Also the next time, where no other store is asked for.
    QCOMPARE(shell_->context().settings().value("chosen_store").toString(), "sqlite:" + moved);
}

void ShellStoreTest::aStoreThatIsGoneComesFromItsBackup() {
    const QString copy = shell_->path("copy.db");
    shell_->owner().backup(copy.toStdString());
    loseStore();
    QVERIFY(asksForTheStore());
    shell_->open_this = copy;
    QVERIFY(shell_->click("restore_backup"));
    QVERIFY(shell_->arrives(PageId::kLogin));
    QVERIFY(shell_->bannerSays("Whoever was erased since it was made is back"));
    shell_->shot("105_restored");
    QVERIFY(shell_->signIn("ada", "correct horse"));
    QVERIFY(QFile::exists(file()));
}

void ShellStoreTest::nobodyOpensTheStoreWhileABackupIsPutInPlace() {
    const QString copy = shell_->path("copy_again.db");
    shell_->owner().backup(copy.toStdString());
    loseStore();
    QVERIFY(asksForTheStore());
    shell_->open_this = copy;
    {
        AllThreadsTaken taken(shell_->context().workers());
        QVERIFY(shell_->click("restore_backup"));
        QVERIFY(QTest::qWaitFor([&] { return shell_->context().restoring(); }, 5000));
        QVERIFY2(!QFile::exists(file()), "nothing is done in this thread");
        QVERIFY(!shell_->click("begin_anew"));
        QVERIFY(!shell_->click("try_again"));
        // The window is built anew, which looks for the store.
        shell_->context().setLanguage("pl");
        shell_->context().setLanguage("en");
        QVERIFY(asksForTheStore());
        QVERIFY(!shell_->click("begin_anew"));
        QVERIFY(!shell_->context().openStore());
        QVERIFY(!QFile::exists(file()));
        shell_->refuseNext();
        QVERIFY2(!shell_->window().close(), "it asks");
    }
    QVERIFY(shell_->arrives(PageId::kLogin, 60));
    QVERIFY(shell_->signIn("ada", "correct horse"));
    // What is no backup is said, and the ways on are there again.
    loseStore();
    QFile none(shell_->path("none.db"));
    QVERIFY(none.open(QIODevice::WriteOnly) && none.write("no store") > 0);
    none.close();
    shell_->open_this = none.fileName();
    QVERIFY(shell_->click("restore_backup"));
    QVERIFY(QTest::qWaitFor([&] { return shell_->window().banner().isShown(); }, 60000));
    QVERIFY(asksForTheStore());
    shell_->open_this = copy;
    QVERIFY(shell_->click("restore_backup"));
    QVERIFY(shell_->arrives(PageId::kLogin, 60));
}

void ShellStoreTest::edit(const QString& file, std::initializer_list<const char*> statements) {
    const QString name = "edit";
    {
        QSqlDatabase database = QSqlDatabase::addDatabase("QSQLITE", name);
        database.setDatabaseName(file);
        QVERIFY(database.open());
        for (const char* each : statements) {
            QSqlQuery query(database);
            QVERIFY2(query.exec(each), qPrintable(query.lastError().text()));
        }
    }
    QSqlDatabase::removeDatabase(name);
}

// It was done in the thread of the window, which was not there for as long as that took.
void ShellStoreTest::anOlderStoreIsBroughtUpToDateBehindAPageThatSaysSo() {
    const QString older = shell_->path("older.db");
    loseStore(older);
    makeOlder(older);
    QVERIFY(asksForTheStore());
    shell_->open_this = older;
    AppContext& context = shell_->context();
    std::vector<db::UpdatePart> parts;
    const QObject listens;
    connect(&context, &AppContext::updateReached, &listens,
            [&] { parts.push_back(context.updating().value()); });
    {
        AllThreadsTaken taken(context.workers());
        QVERIFY(shell_->click("choose_store"));
        QVERIFY(QTest::qWaitFor([&] { return context.updating().has_value(); }, 5000));
        QVERIFY2(keptBeside(older).isEmpty(), "nothing is done in this thread");
        for (const QSize size : {QSize(960, 540), QSize(1366, 768)}) {
            shell_->window().resize(size);
            QTest::qWait(100);
            const QStringList cut = misfits(shell_->window());
            QVERIFY2(cut.isEmpty(), qPrintable(cut.join("\n")));
            shell_->keep(shell_->window().grab(),
                         QString("04_store_is_older_%1").arg(size.width()));
        }
        // The window is built anew, which looks for the store.
        context.setLanguage("pl");
        context.setLanguage("en");
        QVERIFY(shell_->text("update_part").contains("from beginning to end"));
        QVERIFY(!context.openStore());
        shell_->refuseNext();
        QVERIFY2(!shell_->window().close(), "it asks");
    }
    QVERIFY(shell_->arrives(PageId::kLogin, 60));
    const std::vector<db::UpdatePart> all{db::UpdatePart::kCheck, db::UpdatePart::kCopy,
                                          db::UpdatePart::kTables};
    QVERIFY(parts == all);
    QCOMPARE(keptBeside(older).size(), 1);
    QVERIFY(!context.updating() && !context.storeIsOlder());
    QVERIFY(shell_->signIn("ada", "correct horse"));
    // At the first start after an update nobody has to do anything.
    shell_->stop();
    makeOlder(older);
    shell_->start("older.db");
    QVERIFY(shell_->arrives(PageId::kLogin, 60));
    QCOMPARE(keptBeside(older).size(), 2);
}

void ShellStoreTest::anUpdateThatFailsSaysWhereTheCopyLies() {
    shell_->stop();
    edit(file(), {kForgetNewest});  // Its column is there, so that it cannot be made.
    shell_->start();
    QVERIFY(
        QTest::qWaitFor([&] { return shell_->find<QPushButton>("try_again") != nullptr; }, 60000));
    QVERIFY(shell_->window().banner().isShown());
    const QStringList cut = misfits(shell_->window());
    QVERIFY2(cut.isEmpty(), qPrintable(cut.join("\n")));
    shell_->keep(shell_->window().grab(), "04_update_failed");
    const auto* said = shell_->find<Details>("update_copy");
    QVERIFY(said != nullptr);
    QCOMPARE(keptBeside(file()), QStringList{QFileInfo(said->text()).fileName()});
    edit(file(), {"ALTER TABLE attempts DROP COLUMN read_by"});
    QVERIFY(shell_->click("try_again"));
    QVERIFY(shell_->arrives(PageId::kLogin, 60));
    QVERIFY(shell_->signIn("ada", "correct horse"));
}

void ShellStoreTest::anEmptyStoreIsBegunOnlyWhenSomebodySaysSo() {
    loseStore();
    shell_->refuseNext();
    QVERIFY(shell_->click("begin_anew"));
    QTest::qWait(300);  // The question comes and goes.
    QVERIFY(asksForTheStore());
    QVERIFY(!QFile::exists(file()));
    shell_->confirmNext();
    QVERIFY(shell_->click("begin_anew"));
    QVERIFY(shell_->arrives(PageId::kSetup));
    QVERIFY(shell_->owner().accounts().list().empty());
}

void ShellStoreTest::theRolesOfAPersonAreChanged() {
    QVERIFY(shell_->signIn("ada", "correct horse"));
    shell_->window().open({PageId::kPeople, 0, {}, {}});
    QVERIFY(shell_->arrives(PageId::kPeople));
    const auto choose = [&](const char* login) {
        auto* table = shell_->find<QTableWidget>("people_table");
        for (int row = 0; row < table->rowCount(); ++row)
            if (table->item(row, 1)->text() == login) table->selectRow(row);
    };
    const auto box = [&](db::Role role) {
        return shell_->find<QAbstractButton>(
            QString("selected_role_%1").arg(static_cast<int>(role)));
    };
    choose("ada");
    QVERIFY2(!box(db::Role::kAdministrator)->isEnabled(), "nobody takes the own roles away");
    choose("demo.trainee");
    QVERIFY(box(db::Role::kTrainee)->isChecked() && !box(db::Role::kEducator)->isChecked());
    QVERIFY2(!shell_->find<QPushButton>("change_roles")->isEnabled(), "nothing was changed yet");
    box(db::Role::kEducator)->click();
    QTest::qWait(100);  // Lets the row appear; nothing depends on it.
    shell_->keep(shell_->window().grab(), "11_people_roles");
    for (const QSize size : {QSize(1024, 768), QSize(1366, 768)}) {
        shell_->window().resize(size);
        QTest::qWait(80);
        QVERIFY(shell_->fits());
    }
    shell_->confirmNext();
    QVERIFY(shell_->click("change_roles"));
    QVERIFY(shell_->bannerSays("is now"));
    const auto roles = shell_->owner().accounts().find_login("demo.trainee")->roles;
    QVERIFY(db::has_role(roles, db::Role::kTrainee) && db::has_role(roles, db::Role::kEducator));
    // In the audit in words.
    shell_->window().open({PageId::kAudit, 0, {}, {}});
    QVERIFY(shell_->arrives(PageId::kAudit));
    auto* audit = shell_->find<QTableWidget>("audit_table");
    QStringList line;
    for (int row = 0; row < audit->rowCount(); ++row)
        if (audit->item(row, 2)->text() == "changed the roles of a person")
            for (int c = 0; c < audit->columnCount(); ++c) line << audit->item(row, c)->text();
    QVERIFY2(line.join(' ').contains(" → "), qPrintable(line.join(' ')));
}

bool ShellStoreTest::isSentToSignIn(const QString& because) {
    QTest::qWait(1100);  // The store is asked once a second at most.
    shell_->window().open({PageId::kHistory, 0, {}, {}});
    return shell_->arrives(PageId::kLogin) && !shell_->context().signedIn() &&
           shell_->text("login_note").contains(because);
}

void ShellStoreTest::aSessionEndsWhenItsRolesAreOthers() {
    QVERIFY(shell_->signIn("demo.trainee", "placode-demo"));
    elsewhere()->accounts().set_roles(
        shell_->idOf("demo.trainee"),
        static_cast<db::Roles>(db::Role::kTrainee) | static_cast<db::Roles>(db::Role::kEducator));
    QVERIFY2(isSentToSignIn("Your roles were changed"), qPrintable(shell_->text("login_note")));
    QVERIFY(shell_->signIn("demo.trainee", "placode-demo"));
    QVERIFY(shell_->find<QToolButton>("rail_attempts") != nullptr);
}

void ShellStoreTest::aSessionEndsWhenItsAccountIsClosed() {
    QVERIFY(shell_->signIn("demo.trainee", "placode-demo"));
    elsewhere()->accounts().set_active(shell_->idOf("demo.trainee"), false);
    QVERIFY2(isSentToSignIn("Your account was closed"), qPrintable(shell_->text("login_note")));
    QVERIFY(!shell_->signIn("demo.trainee", "placode-demo"));
}

// A server that hangs held up the thread that reads what the simulator says.
void ShellStoreTest::theStoreIsNotAskedWhileAnAttemptRuns() {
    QVERIFY(shell_->signIn("demo.trainee", "placode-demo"));
    AppContext& context = shell_->context();
    AttemptLauncher& launcher = context.launcher();
    AttemptOrder order;
    order.user_id = shell_->idOf("demo.trainee");
    order.user_name = "Demo";
    order.task = order.title = "diathermy_ring_small";
    order.device = "script:novice";
    launcher.start(order, context.recordingsFolder());
    QVERIFY(QTest::qWaitFor([&] { return launcher.status().time_s > 0; }, 120000));
    elsewhere()->accounts().set_active(order.user_id, false);
    auto* watch = context.findChild<QTimer*>("session_watch");
    QVERIFY(watch != nullptr);
    watch->start(100);
    QTest::qWait(1500);  // The store is asked once a second at most.
    QVERIFY2(launcher.running(), "the attempt was over before it could be seen");
    QVERIFY(context.signedIn() && context.sessionNote().isEmpty());
    launcher.abort();
    QVERIFY(QTest::qWaitFor([&] { return !launcher.running(); }, 10000));
    QVERIFY(QTest::qWaitFor([&] { return !context.sessionNote().isEmpty(); }, 10000));
}

void ShellStoreTest::sessionEndsWith(db::Roles roles) {
    elsewhere()->accounts().set_roles(shell_->idOf("demo.coordinator"), roles);
    AppContext& context = shell_->context();
    QVERIFY(QTest::qWaitFor([&] { return !context.signedIn() || !context.sessionStands(); }, 5000));
    QVERIFY(shell_->arrives(PageId::kLogin));
    QVERIFY(shell_->text("login_note").contains("Your roles were changed"));
    QVERIFY(shell_->find<QRadioButton>("answer_sus02_3") == nullptr);
}

// The answers of somebody who had nothing to do with it were gone.
void ShellStoreTest::whatAParticipantAnsweredOutlivesTheSession() {
    const auto role = [](db::Role each) { return static_cast<db::Roles>(each); };
    QVERIFY(shell_->signIn("demo.coordinator", "placode-demo"));
    shell_->window().open({PageId::kStudies, 0, "sus", {}});
    QVERIFY(shell_->arrives(PageId::kStudies));
    QVERIFY(shell_->click("new_participant"));
    QVERIFY(shell_->arrives(PageId::kParticipant));
    shell_->find<QRadioButton>("answer_sus02_3")->click();
    sessionEndsWith(role(db::Role::kCoordinator) | role(db::Role::kEducator));
    if (QTest::currentTestFailed()) return;
    QVERIFY(shell_->signIn("demo.coordinator", "placode-demo"));
    QVERIFY(shell_->arrives(PageId::kParticipant));
    QVERIFY(shell_->find<QRadioButton>("answer_sus02_3")->isChecked());
    const auto* rail = shell_->find<QToolButton>("rail_studies");
    QVERIFY2(rail != nullptr && !rail->isVisible(), "the screen is the participant's still");
    // Rights that do not reach it any more open another page, without a word of refusal.
    sessionEndsWith(role(db::Role::kEducator));
    if (QTest::currentTestFailed()) return;
    QVERIFY(shell_->signIn("demo.coordinator", "placode-demo"));
    QVERIFY(shell_->arrives(PageId::kAttempts));
    QVERIFY(!shell_->window().banner().text().contains("may not"));
    QVERIFY(shell_->find<QRadioButton>("answer_sus02_3") == nullptr);
}

// The filter's slot reads the store, and what it throws ended the program.
void ShellStoreTest::aListAskedForAfterwardsLeadsToSignIn() {
    QVERIFY(shell_->signIn("demo.educator", "placode-demo"));
    shell_->window().open({PageId::kAttempts, 0, {}, {}});
    QVERIFY(shell_->arrives(PageId::kAttempts));
    auto* tasks = shell_->find<QComboBox>("filter_task");
    QVERIFY(tasks != nullptr && tasks->count() > 1);
    elsewhere()->accounts().set_active(shell_->idOf("demo.educator"), false);
    QTest::qWait(1100);  // The store is asked once a second at most.
    tasks->setCurrentIndex(1);
    QVERIFY(shell_->arrives(PageId::kLogin));
    QVERIFY(!shell_->context().signedIn());
    QVERIFY2(shell_->text("login_note").contains("Your account was closed"),
             qPrintable(shell_->text("login_note")));
}

QString ShellStoreTest::leftover() {
    AttemptOrder order;
    order.user_id = shell_->idOf("demo.trainee");
    order.task = "familiarisation";
    order.title = "Familiarisation";
    order.device = "mouse";
    order.started_utc = "2026-04-01T10:00:00Z";
    order.demonstration = true;
    write_order(order, shell_->context().recordingsFolder());
    QProcess simulator;
    simulator.start(PLACODE_BIN_DIR "/placode-sim",
                    {"--task", order.task, "--device", "script:novice", "--headless", "--fast",
                     "--duration", "2", "--record", order.recording_file});
    return simulator.waitForFinished(120000) ? order.recording_file : QString();
}

void ShellStoreTest::aRecordingIsCopiedElsewhereAndNeverOverItself() {
    const QString recording = leftover();
    const auto bytes = [](const QString& path) {
        QFile each(path);
        return each.open(QIODevice::ReadOnly) ? each.readAll() : QByteArray();
    };
    const QByteArray was = bytes(recording);
    QVERIFY(was.size() > 1000);
    QVERIFY(shell_->signIn("demo.trainee", "placode-demo"));
    shell_->window().open({PageId::kRecovery, 0, {}, {}});
    QVERIFY(shell_->arrives(PageId::kRecovery));
    QVERIFY(shell_->fitsInBothSizes("33_recovery_copy"));
    shell_->save_as = recording;
    QVERIFY(shell_->click("recover_copy_0"));
    QVERIFY(shell_->bannerSays("choose another folder"));
    QVERIFY2(bytes(recording) == was, "it was on the way to be lost");
    shell_->save_as = shell_->path("stick.placode");
    QVERIFY(shell_->click("recover_copy_0"));
    QVERIFY(shell_->bannerSays("Recording copied"));
    QVERIFY(bytes(shell_->save_as) == was && bytes(recording) == was);
    // What a copy cannot replace as a whole stays: a full disk, a stick that was pulled out.
    QFile other(shell_->path("older.placode"));
    QVERIFY(other.open(QIODevice::WriteOnly) && other.write("older") == 5);
    other.close();
    QVERIFY(QFile::rename(recording, recording + ".away"));
    shell_->save_as = other.fileName();
    QVERIFY(shell_->click("recover_copy_0"));
    QCOMPARE(bytes(other.fileName()), QByteArray("older"));
    QVERIFY(QFile::rename(recording + ".away", recording));
}

// The first of a list was proposed, and one press gave somebody an attempt that was not his.
void ShellStoreTest::whoseARecordingIsIsChosen() {
    const QString recording = leftover();
    QVERIFY(QFile::remove(QString::fromStdString(db::order_file(recording.toStdString()))));
    QVERIFY(shell_->signIn("ada", "correct horse"));
    shell_->window().open({PageId::kRecovery, 0, {}, {}});
    QVERIFY(shell_->arrives(PageId::kRecovery));
    auto* owner = shell_->find<QComboBox>("recover_owner_0");
    QVERIFY(owner != nullptr && owner->count() > 0);
    QCOMPARE(owner->currentIndex(), -1);
    QVERIFY(!shell_->find<QPushButton>("recover_save_0")->isEnabled());
    owner->setCurrentIndex(0);
    QVERIFY(shell_->find<QPushButton>("recover_save_0")->isEnabled());
}

// What was begun before ended under a question that lay on the stack, and took its page away.
void ShellStoreTest::aPageStaysAsLongAsItsQuestion() {
    QVERIFY(!leftover().isEmpty());
    QVERIFY(!leftover().isEmpty());
    QVERIFY(shell_->signIn("demo.trainee", "placode-demo"));
    shell_->window().open({PageId::kRecovery, 0, {}, {}});
    QVERIFY(shell_->arrives(PageId::kRecovery));
    auto* save = shell_->find<QPushButton>("recover_save_0");
    auto* remove = shell_->find<QPushButton>("recover_delete_1");
    QVERIFY(save != nullptr && remove != nullptr);
    const QPointer<Page> page = shell_->window().page();
    bool stood = false;
    int looks = 0;
    QTimer answer;
    connect(&answer, &QTimer::timeout, &answer, [&] {
        QWidget* question = QApplication::activeModalWidget();
        if (question == nullptr || shell_->context().busy()) return;
        if (++looks < 10) return;  // Saved; time enough for the page to go.
        answer.stop();
        stood = page && shell_->window().page() == page;
        QTest::mouseClick(question->findChild<QPushButton*>("confirm_no"), Qt::LeftButton);
    });
    answer.start(50);
    save->click();
    remove->click();  // Comes back when the question is answered.
    QVERIFY(stood);
    QVERIFY2(shell_->arrives(PageId::kResult), "what was saved is shown afterwards");
    QCOMPARE(shell_->owner().attempts().list(0).size(), size_t{1});
    const QDir recordings(shell_->context().recordingsFolder());
    QCOMPARE(recordings.entryList({"*.placode"}, QDir::Files).size(), 1);
}

}  // namespace placode::ui

int main(int argc, char** argv) {
    placode::ui::prepare_display();
    QApplication application(argc, argv);
    placode::ui::ShellStoreTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "shell_store_test.moc"
