// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The pictures of the manual are taken here:  PLACODE_WRITE_MANUAL=1 shell_pictures_test
// Without that, what the buttons of every page say is compared with what the pictures show: a
// picture that is behind is named.

#include <QDialog>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QRegularExpression>
#include <map>
#include <set>

#include "full_store.h"
#include "ui/shell/page_tour.h"
#include "ui/shell/setup_ways.h"

namespace placode::ui {

namespace {

constexpr const char* kLanguages[]{"en", "pl"};
const QSize kPictureSize{1280, 760};
constexpr int kColours = 256;

bool writes() { return qEnvironmentVariableIsSet("PLACODE_WRITE_MANUAL"); }

QString pictures(const QString& language) {
    return QString(PLACODE_SOURCE_DIR "/docs/manual/pictures/%1/").arg(language);
}

/// What the visible buttons say, without numbers, names and what depends on the computer.
QJsonArray words_of(const QWidget& window) {
    std::set<QString> words;
    static const QRegularExpression kDigits("[0-9]+");
    for (const QAbstractButton* button : window.findChildren<QAbstractButton*>()) {
        if (!button->isVisible() || button->text().trimmed().isEmpty()) continue;
        // How many reasons there are hangs on the attempt, and on the processor's last bits.
        if (button->objectName() == "user_menu" || button->objectName() == "more_reasons") continue;
        // Whether there is one hangs on the computer's systemd.
        if (button->objectName() == "daily_switch") continue;
        words.insert(button->text().remove(kDigits).trimmed());
    }
    QJsonArray all;
    for (const QString& word : words) all.append(word);
    return all;
}

/// With the colours that occur most: a third of the size, and no eye sees it.
QImage with_few_colours(const QImage& picture) {
    const QImage full = picture.convertToFormat(QImage::Format_RGB32);
    std::map<QRgb, int> seen;
    for (int y = 0; y < full.height(); ++y)
        for (int x = 0; x < full.width(); ++x) ++seen[full.pixel(x, y)];
    std::vector<std::pair<int, QRgb>> most;
    for (const auto& [colour, times] : seen) most.emplace_back(times, colour);
    std::sort(most.rbegin(), most.rend());
    QList<QRgb> table;
    for (const auto& [times, colour] : most)
        if (table.size() < kColours) table << colour;
    return full.convertToFormat(QImage::Format_Indexed8, table, Qt::ThresholdDither);
}

}  // namespace

class ShellPicturesTest : public QObject {
    Q_OBJECT

 private Q_SLOTS:
    void initTestCase();
    void cleanupTestCase() { shell_.reset(); }
    void picturesShowTheButtonsOfToday();
    void picturesOfTheSimulatorAreTaken();

 private:
    void takeBeforeSignIn();
    void takePages(const char* login, const char* password, const char* names);
    void takeRunning();
    void leaveAnAttempt();
    void takeParts();
    void take(const QString& name, const QWidget& shown);
    void check(const QString& name, const QWidget& shown);
    [[nodiscard]] bool runProgram(const QString& program, const QStringList& arguments);

    std::unique_ptr<ShellHarness> shell_;
    FullStore filled_;
    QJsonObject words_;  ///< Of the pictures, "en/today" -> buttons.
};

bool ShellPicturesTest::runProgram(const QString& program, const QStringList& arguments) {
    QProcess process;
    process.start(PLACODE_BIN_DIR "/" + program, arguments);
    const bool ended = process.waitForFinished(300000) && process.exitCode() == 0;
    if (!ended) qWarning("%s", process.readAllStandardError().constData());
    return ended;
}

void ShellPicturesTest::initTestCase() {
    shell_ = std::make_unique<ShellHarness>();
    shell_->window().resize(kPictureSize);
    takeBeforeSignIn();
    QVERIFY(filled_.fill(*shell_));
    const QString store = QString::fromStdString(shell_->context().storeUrl());
    QVERIFY(runProgram("placodectl", {"--store", store, "study", "demo"}));
    QVERIFY(runProgram("placodectl", {"--store", store, "study", "enrol", "face_content_validity",
                                      "--consented"}));
    // A whole attempt to look at: pages with it and without it have other buttons.
    const QString whole = shell_->path("whole.placode");
    QVERIFY(runProgram("placode-sim",
                       {"--task", FullStore::kTask, "--device", "script:intermediate", "--headless",
                        "--fast", "--seed", "7", "--demonstration", "--record", whole}));
    QVERIFY(
        runProgram("placodectl", {"--store", store, "import", whole, "--user", "demo.trainee"}));
}

void ShellPicturesTest::take(const QString& name, const QWidget& shown) {
    const QString language = shell_->context().language();
    QDir().mkpath(pictures(language));
    const QImage picture = with_few_colours(const_cast<QWidget&>(shown).grab().toImage());
    QVERIFY(picture.save(pictures(language) + name + ".png", "PNG", 0));
}

void ShellPicturesTest::check(const QString& name, const QWidget& shown) {
    const QString key = shell_->context().language() + "/" + name;
    words_[key] = words_of(shown);
    if (writes()) take(name, shown);
}

void ShellPicturesTest::takeBeforeSignIn() {
    for (const char* language : kLanguages) {
        shell_->context().setLanguage(language);
        for (const auto& [name, place] :
             {std::pair<const char*, Place>{"setup", {PageId::kSetup, 0, {}, {}}},
              {"setup_station", setup_place(kStationWay)},
              {"setup_server", setup_place(kServerWay)},
              {"login", {PageId::kLogin, 0, {}, {}}},
              {"join", {PageId::kJoin, 0, {}, {}}}}) {
            shell_->window().visit(place);
            settle(*shell_);
            check(name, shell_->window());
        }
    }
    shell_->context().setLanguage("en");
    shell_->window().visit({PageId::kSetup, 0, {}, {}});
}

void ShellPicturesTest::takePages(const char* login, const char* password, const char* names) {
    const QStringList wanted = QString(names).split(' ');
    QVERIFY2(shell_->signIn(login, password), login);
    for (const char* language : kLanguages) {
        shell_->context().setLanguage(language);
        for (const TourStop& stop : page_tour(shell_->context())) {
            if (!wanted.contains(stop.name)) continue;
            shell_->window().visit(stop.place);
            QVERIFY2(shell_->arrives(stop.place.page), stop.name);
            settle(*shell_);
            check(stop.name, shell_->window());
        }
    }
    shell_->context().setLanguage("en");
}

/// What stands on pages only for a moment.
void ShellPicturesTest::takeParts() {
    QVERIFY(shell_->signIn("demo.educator", "placode-demo"));
    for (const char* language : kLanguages) {
        shell_->context().setLanguage(language);
        shell_->window().visit({PageId::kCohort, 0, {}, {}});
        settle(*shell_);
        QVERIFY(shell_->click("search"));
        auto* dialog = shell_->window().findChild<QDialog*>("search_box");
        QVERIFY(dialog != nullptr);
        QTest::keyClicks(dialog->findChild<QLineEdit*>("search_text"),
                         language == QString("pl") ? "egzamin" : "exam");
        settle(*shell_);
        check("search", *dialog);
        QTest::keyClick(dialog, Qt::Key_Escape);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        shell_->context().guard(QString(), [] {
            throw db::StoreError(db::StoreError::Kind::kLocked, "read people sqlite:placode.db");
        });
        settle(*shell_);
        check("message", shell_->window());
        shell_->context().signOut();
        QVERIFY(shell_->signIn("demo.educator", "placode-demo"));
    }
    shell_->context().setLanguage("en");
}

void ShellPicturesTest::takeRunning() {
    QVERIFY(shell_->signIn("demo.trainee", "placode-demo"));
    shell_->hands = "script:expert";
    AttemptOrder order;
    order.user_id = shell_->context().user().id;
    order.task = FullStore::kTask;
    order.title = "Diathermy ring, coarse field";
    order.device = "script:expert";
    order.started_utc = "2026-04-01T10:00:00Z";
    order.demonstration = true;
    shell_->context().launcher().start(order, shell_->context().recordingsFolder());
    for (const char* language : kLanguages) {
        shell_->context().setLanguage(language);
        shell_->window().visit({PageId::kRunning, 0, {}, {}});
        QTest::qWait(writes() ? 4000 : 300);
        check("running", shell_->window());
    }
    shell_->context().setLanguage("en");
    QVERIFY(QTest::qWaitFor([&] { return !shell_->context().launcher().running(); }, 300000));
    settle(*shell_);
}

/// Something to recover.
void ShellPicturesTest::leaveAnAttempt() {
    AttemptOrder order;
    order.user_id = filled_.trainee();
    order.task = FullStore::kTask;
    order.title = "Diathermy ring, coarse field";
    order.device = "mouse";
    order.started_utc = "2026-04-01T10:00:00Z";
    order.demonstration = true;
    write_order(order, shell_->context().recordingsFolder());
    QVERIFY(runProgram("placode-sim",
                       {"--task", FullStore::kTask, "--device", "script:novice", "--headless",
                        "--fast", "--duration", "9", "--record", order.recording_file}));
}

void ShellPicturesTest::picturesShowTheButtonsOfToday() {
    if (writes()) leaveAnAttempt();
    takePages("demo.trainee", "placode-demo",
              "today course task history result watch compare account recovery");
    QDir(shell_->context().recordingsFolder()).removeRecursively();
    takePages("demo.educator", "placode-demo",
              "attempts cohort ratings standards courses course_editor groups norms devices");
    takePages("demo.coordinator", "placode-demo",
              "studies study_data study_results study_run protocols");
    takePages("ada", "correct horse", "people admissions health audit");
    takeParts();
    if (writes()) takeRunning();
    // What a picture shows beside the buttons of its computer's devices and leftovers.
    QFile file(PLACODE_SOURCE_DIR "/docs/manual/pictures/buttons.json");
    if (writes()) {
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(QJsonDocument(words_).toJson());
        return;
    }
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QJsonObject then = QJsonDocument::fromJson(file.readAll()).object();
    QStringList stale;
    for (const QString& name : words_.keys()) {
        if (name.endsWith("/devices") || name.endsWith("/recovery")) continue;
        if (then[name] == words_[name]) continue;
        stale << name;
        std::fprintf(
            stderr, "%s\n  then %s\n  now  %s\n", qPrintable(name),
            QJsonDocument(then[name].toArray()).toJson(QJsonDocument::Compact).constData(),
            QJsonDocument(words_[name].toArray()).toJson(QJsonDocument::Compact).constData());
    }
    QVERIFY2(stale.isEmpty(), qPrintable("pictures of the manual are stale; take them again with "
                                         "PLACODE_WRITE_MANUAL=1 shell_pictures_test: " +
                                         stale.join(" ")));
}

void ShellPicturesTest::picturesOfTheSimulatorAreTaken() {
    if (!writes()) QSKIP("nothing to compare: what the simulator draws has tests of its own");
    struct Shot {
        const char *task, *operator_, *name, *size;
        int second;
    };
    for (const char* language : kLanguages)
        for (const Shot& shot :
             {Shot{"diathermy_ring", "script:expert", "incision.jpg", "960x720", 30},
              Shot{"suture_bite", "script:expert", "suture.jpg", "960x720", 6},
              Shot{"familiarisation", "script:expert", "familiarisation.jpg", "1280x800", 6}}) {
            const QString folder = shell_->path(QString("shots_%1_%2").arg(shot.task, language));
            // Without an end of its own: an attempt of given length would show what is left of it.
            QProcess simulator;
            simulator.start(PLACODE_BIN_DIR "/placode-sim",
                            {"--task", shot.task, "--device", shot.operator_, "--headless",
                             "--fast", "--language", language, "--size", shot.size, "--screenshots",
                             folder + ":" + QString::number(shot.second)});
            QStringList made;
            QVERIFY(QTest::qWaitFor(
                [&] {
                    made = QDir(folder).entryList({"*.png"}, QDir::Files, QDir::Name);
                    // One of the start, and the one that is meant.
                    return made.size() > 1 || simulator.state() == QProcess::NotRunning;
                },
                600000));
            QTest::qWait(1000);  // It is being written.
            simulator.terminate();
            (void)simulator.waitForFinished();
            QVERIFY(made.size() > 1);
            QVERIFY(
                QImage(folder + "/" + made.at(1)).save(pictures(language) + shot.name, "JPG", 85));
        }
}

}  // namespace placode::ui

int main(int argc, char** argv) {
    placode::ui::prepare_display();
    QApplication application(argc, argv);
    placode::ui::ShellPicturesTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "shell_pictures_test.moc"
