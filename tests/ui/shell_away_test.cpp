// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The server goes away while somebody operates: the recording waits on this computer and is saved
// when the server is back, by itself, once, and for nobody else.

#include <QApplication>
#include <QStandardPaths>

#include "shell_harness.h"
#include "tests/server_away.h"
#include "ui/shell/waiting_recordings.h"

namespace placode::ui {
namespace {

constexpr int kPatienceMs = 240000;  ///< A busy machine, and a server that starts.
constexpr const char* kPassword = "correct horse";

}  // namespace

class ShellAwayTest : public QObject {
    Q_OBJECT

 private Q_SLOTS:
    void initTestCase();
    void cleanupTestCase();
    void itIsKeptAndFollowsWhenTheServerIsBack();
    void itFollowsAtTheNextSignInOfItsOwner();
    void afterAKillBetweenSavingAndRemovingItIsThereOnce();
    void twoProgramsSaveItOnce();
    void anotherServerGetsNothing();
    void whatWasChangedIsOfferedAndNotSaved();
    void aServerThatWasGivenIsFoundAtTheNextStart();

 private:
    /// Anna operates and stops while the server is away.
    void operateWithoutServer();
    /// The same, and the shell is closed before the server is back.
    void leaveOneWaiting();
    [[nodiscard]] bool comesBack(const QString& login);
    [[nodiscard]] std::vector<db::AttemptRecord> attempts(const std::string& database) const {
        return db::open_store(server_->url(database))->attempts().list(0);
    }
    [[nodiscard]] size_t saved() const { return attempts(database_).size(); }
    [[nodiscard]] QString folder() const { return shell_->context().recordingsFolder(); }
    [[nodiscard]] QStringList files() const { return QDir(folder()).entryList(QDir::Files); }
    [[nodiscard]] bool isEmptySoon() const {
        return QTest::qWaitFor([this] { return files().isEmpty(); }, kPatienceMs);
    }
    /// Puts all files of the folder into `other`, in place of what is there.
    static void copyAll(const QString& from, const QString& to);

    QTemporaryDir home_;
    std::unique_ptr<test::PostgresqlServer> server_;
    std::unique_ptr<test::ServerAway> away_;
    std::string database_;
    std::unique_ptr<ShellHarness> shell_;
};

void ShellAwayTest::initTestCase() {
    QVERIFY(home_.isValid());
    qputenv("XDG_DATA_HOME", home_.path().toUtf8());  // where recordings of a server's store lie
    server_ = std::make_unique<test::PostgresqlServer>();
    if (server_->missing()) QSKIP(server_->problem().c_str());
    QVERIFY2(server_->problem().empty(), server_->problem().c_str());
    away_ = std::make_unique<test::ServerAway>(*server_);
    db::StoreOptions cheap;
    cheap.cheap_passwords = true;
    database_ = server_->new_store(cheap);
    const auto store = db::open_store(server_->url(database_), cheap);
    store->accounts().create({"ada", "Ada", kPassword, 8, false});
    for (const char* login : {"anna", "bert"})
        store->accounts().create(
            {login, login, kPassword, static_cast<db::Roles>(db::Role::kTrainee), false});
    shell_ = std::make_unique<ShellHarness>(server_->station_url(database_));
    shell_->hands = "script:novice";
    shell_->start();
    QVERIFY(shell_->signIn("anna", kPassword));
}

void ShellAwayTest::cleanupTestCase() {
    shell_.reset();
    away_.reset();
    server_.reset();
}

void ShellAwayTest::copyAll(const QString& from, const QString& to) {
    QDir().mkpath(to);
    for (const QString& name : QDir(from).entryList(QDir::Files)) {
        QFile::remove(to + "/" + name);
        QVERIFY(QFile::copy(from + "/" + name, to + "/" + name));
    }
}

void ShellAwayTest::operateWithoutServer() {
    ShellHarness& shell = *shell_;
    shell.window().visit({PageId::kTask, 0, "touch_targets", {}});
    QVERIFY(shell.arrives(PageId::kTask));
    QVERIFY(shell.click("start_attempt"));
    QVERIFY(shell.arrives(PageId::kRunning));
    QVERIFY(away_->stop());
    AttemptLauncher& launcher = shell.context().launcher();
    QVERIFY2(launcher.running(), "the attempt was over before the server was gone");
    QVERIFY(QTest::qWaitFor([&] { return launcher.status().time_s > 0.5 || !launcher.running(); },
                            kPatienceMs));
    if (launcher.running()) {
        shell.confirmNext();
        QVERIFY(shell.click("stop_and_score"));
    }
    QVERIFY(shell.bannerSays("kept on this computer", 120));
    QVERIFY(shell.arrives(PageId::kRecovery));
    QCOMPARE(shell.context().waiting().count(), 1);
    QCOMPARE(files().size(), 3);  // the recording, its order and its mark
}

void ShellAwayTest::leaveOneWaiting() {
    shell_->start();
    QVERIFY(shell_->signIn("anna", kPassword));
    operateWithoutServer();
    if (QTest::currentTestFailed()) return;
    shell_->stop();
    QVERIFY(away_->start());
}

bool ShellAwayTest::comesBack(const QString& login) {
    shell_->start();
    return shell_->signIn(login, kPassword);
}

void ShellAwayTest::itIsKeptAndFollowsWhenTheServerIsBack() {
    ShellHarness& shell = *shell_;
    shell.context().waiting().setPauses(200, 400);
    operateWithoutServer();
    if (QTest::currentTestFailed()) return;
    auto* chip = shell.find<QToolButton>("waiting_chip");
    QVERIFY(chip->isVisible());
    QVERIFY2(chip->text().contains("1"), qPrintable(chip->text()));
    QStringList said;
    for (const QLabel* label : shell.window().page()->findChildren<QLabel*>())
        said << label->text();
    QVERIFY2(said.join("\n").contains("waits for the server"), qPrintable(said.join("\n")));
    shell.shot("29_waits_for_the_server");
    // Whoever asks is told, and nothing is lost by it.
    QVERIFY(shell.click("waiting_chip"));
    QVERIFY(shell.bannerSays("still away", 60));
    QCOMPARE(files().size(), 3);
    QVERIFY(away_->start());
    QVERIFY(isEmptySoon());
    QVERIFY(shell.bannerSays("is saved now", 60));
    QVERIFY(!shell.find<QToolButton>("waiting_chip")->isVisible());
    const auto all = attempts(database_);
    QCOMPARE(all.size(), size_t{1});
    QCOMPARE(all[0].task_id, std::string("touch_targets"));
    QCOMPARE(all[0].user_id, shell.context().user().id);
}

void ShellAwayTest::itFollowsAtTheNextSignInOfItsOwner() {
    const size_t before = saved();
    leaveOneWaiting();
    if (QTest::currentTestFailed()) return;
    QVERIFY(comesBack("bert"));
    QVERIFY(QTest::qWaitFor([&] { return !shell_->context().busy(); }, kPatienceMs));
    QCOMPARE(shell_->context().waiting().count(), 0);
    QCOMPARE(files().size(), 3);
    QVERIFY(shell_->signIn("anna", kPassword));
    QVERIFY(isEmptySoon());
    QCOMPARE(saved(), before + 1);
}

void ShellAwayTest::afterAKillBetweenSavingAndRemovingItIsThereOnce() {
    const size_t before = saved();
    leaveOneWaiting();
    if (QTest::currentTestFailed()) return;
    const QString aside = home_.filePath("aside");
    copyAll(QDir(home_.filePath("placode/recordings")).path(), aside);
    QVERIFY(comesBack("anna"));
    QVERIFY(isEmptySoon());
    QCOMPARE(saved(), before + 1);
    // As the kill leaves it.
    copyAll(aside, folder());
    QCOMPARE(files().size(), 3);
    QVERIFY(comesBack("anna"));
    QVERIFY(isEmptySoon());
    QCOMPARE(saved(), before + 1);
    QDir(aside).removeRecursively();
}

void ShellAwayTest::twoProgramsSaveItOnce() {
    const size_t before = saved();
    leaveOneWaiting();
    if (QTest::currentTestFailed()) return;
    const QString folder = home_.filePath("placode/recordings");
    const QStringList recordings = QDir(folder).entryList({"*.placode"}, QDir::Files);
    QCOMPARE(recordings.size(), 1);
    const auto order = read_order(folder + "/" + recordings[0]);
    QVERIFY(order.has_value());
    std::atomic<int> kept{0}, gone{0};
    std::vector<std::thread> programs;
    for (int i = 0; i < 3; ++i)
        programs.emplace_back([&] {
            const auto store = db::open_store(server_->service_url(database_));
            const SavedAttempt outcome = save_recording(*store, *order);
            ++(outcome.outcome == Saving::kSaved ? kept : gone);
        });
    for (std::thread& each : programs) each.join();
    QCOMPARE(kept.load(), 1);
    QCOMPARE(gone.load(), 2);
    QCOMPARE(saved(), before + 1);
}

void ShellAwayTest::anotherServerGetsNothing() {
    const size_t before = saved();
    leaveOneWaiting();
    if (QTest::currentTestFailed()) return;
    // Where the same number is somebody as well.
    db::StoreOptions cheap;
    cheap.cheap_passwords = true;
    const std::string other = server_->new_store(cheap);
    const auto store = db::open_store(server_->url(other), cheap);
    for (const char* login : {"ada", "carl"})
        store->accounts().create(
            {login, login, kPassword, login[0] == 'a' ? db::Roles{8} : db::Roles{1}, false});
    shell_->server = server_->station_url(other);
    QVERIFY(comesBack("carl"));
    QCOMPARE(shell_->context().waiting().count(), 0);
    QVERIFY(QTest::qWaitFor([&] { return !shell_->context().busy(); }, kPatienceMs));
    QCOMPARE(files().size(), 3);
    QVERIFY(attempts(other).empty());
    shell_->server = server_->station_url(database_);
    QVERIFY(comesBack("anna"));
    QVERIFY(isEmptySoon());
    QCOMPARE(saved(), before + 1);
}

void ShellAwayTest::whatWasChangedIsOfferedAndNotSaved() {
    const size_t before = saved();
    leaveOneWaiting();
    if (QTest::currentTestFailed()) return;
    const QString folder = home_.filePath("placode/recordings");
    const QStringList orders = QDir(folder).entryList({"*.order.json"}, QDir::Files);
    QCOMPARE(orders.size(), 1);
    QFile order(folder + "/" + orders[0]);
    QVERIFY(order.open(QIODevice::ReadWrite));
    const QByteArray text = order.readAll();
    QVERIFY(order.resize(0) && order.seek(0));
    // Anna's becomes Bert's: he gets it only if he presses Save, and then it counts as changed.
    order.write(QByteArray(text).replace("\"user_id\": 2", "\"user_id\": 3"));
    order.close();
    for (const char* login : {"bert", "anna"}) {
        QVERIFY(comesBack(login));
        QCOMPARE(shell_->context().waiting().count(), 0);
        if (QByteArray(login) == "bert") QVERIFY(shell_->bannerSays("not finished or not saved"));
    }
    QCOMPARE(saved(), before);
    QCOMPARE(files().size(), 3);
}

// As `placode --store postgresql://...` once, and from the menu ever after.
void ShellAwayTest::aServerThatWasGivenIsFoundAtTheNextStart() {
    ShellHarness& shell = *shell_;
    const auto kept = [&] { return shell.context().settings().value("chosen_store").toString(); };
    shell.server = server_->station_url(database_) + "?timeout_ms=9000";
    shell.start();
    QVERIFY(shell.arrives(PageId::kLogin));
    const QString address = QString::fromStdString(shell.server)
                                .remove(":" + QString::fromStdString(server_->password()));
    QCOMPARE(kept(), address);  // Its options, and no password.
    qputenv("PGPASSWORD", QByteArray::fromStdString(server_->password()));
    shell.server.clear();
    shell.without_store = true;
    shell.start();
    QVERIFY(shell.arrives(PageId::kLogin));
    QCOMPARE(QString::fromStdString(shell.context().storeUrl()), address);
    // A file that is given is opened this once.
    shell.without_store = false;
    shell.start();
    QVERIFY(shell.arrives(PageId::kSetup));
    QCOMPARE(kept(), address);
    qunsetenv("PGPASSWORD");
}

}  // namespace placode::ui

int main(int argc, char** argv) {
    placode::ui::prepare_display();
    QApplication application(argc, argv);
    placode::ui::ShellAwayTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "shell_away_test.moc"
