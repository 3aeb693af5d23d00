// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Messages: they float over the page and move nothing, keep clear of its button, go away as they
// should, and speak the user's words; what a part of the program said stands behind "Details".

#include <QAccessible>
#include <QApplication>
#include <QClipboard>
#include <QFile>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QRegularExpression>
#include <QScreen>
#include <QSettings>
#include <QThread>
#include <atomic>
#include <filesystem>
#include <new>

#include "curriculum/definitions.h"
#include "db/access.h"
#include "haptics/station.h"
#include "reports/report.h"
#include "shell_harness.h"
#include "ui/shell/messages.h"
#include "ui/shell/parts.h"
#include "ui/shell/replay_place.h"

namespace placode::ui {
namespace {

int alerts = 0;
void count_alerts(QAccessibleEvent* event) {
    if (event->type() == QAccessible::Alert) ++alerts;
}

/// All that a person could read of a widget now.
QString read_all(const QWidget* widget) {
    QStringList all;
    for (const auto* label : widget->findChildren<QLabel*>())
        if (label->isVisible()) all << label->text();
    for (const auto* edit : widget->findChildren<QPlainTextEdit*>())
        if (edit->isVisible()) all << edit->toPlainText();
    return all.join("\n");
}

std::exception_ptr thrown(const std::function<void()>& work) {
    try {
        work();
    } catch (...) {
        return std::current_exception();
    }
    return {};
}

/// What only a developer reads.
bool for_developers(const QString& text) {
    static const QRegularExpression kSigns(
        "sqlite:|postgresql:|SQL|\\.so\\b|errno|/tmp|/dev/|libHD|SELECT|what\\(\\)|0x|exit status");
    return kSigns.match(text).hasMatch();
}

}  // namespace

class ShellMessagesTest : public QObject {
    Q_OBJECT

 private Q_SLOTS:
    void initTestCase() {
        shell_ = std::make_unique<ShellHarness>();
        QVERIFY(shell_->setUpWithDemonstration());
        QVERIFY(shell_->signIn("ada", "correct horse"));
        QVERIFY(shell_->arrives(PageId::kPeople));
    }
    void cleanupTestCase() { shell_.reset(); }
    void init() {
        while (notices()->closeNewest()) {
        }
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }

    void messagesMoveNothing();
    void workInProgressHidesNothingAndSaysHowLong();
    void aQuestionHasAFrameAndDimsThePage();
    void escapeAndTheCrossCloseTheNewest();
    void manyAreStackedAndTheSameIsShownOnce();
    void goodNewsGoesByItselfAndTroubleStays();
    void screenReadersHearIt();
    void theyKeepClearOfThePrimaryButton_data();
    void theyKeepClearOfThePrimaryButton();
    void theExactTextIsFoldedAwayAndCanBeCopied();
    void aLongExactTextScrollsAndCanBeMarked();
    void whatWasWrittenCanBeOpened();
    void filesGoWhereTheLastOneWent();
    void languageAndThemeKeepThem();
    void everyTroubleHasUserWords_data();
    void everyTroubleHasUserWords();
    void endingsOfTheSimulatorHaveUserWords();
    void everyRefusalOfTheStoreIsInTheCatalogue();
    void whoMayNotIsToldWhoCan();
    void damagedLeftoversAreToldInWords();
    void aReplayGoesBesideItsControls();
    void aReplayLeavesTheTimeLineInSight();

 private:
    [[nodiscard]] Notices* notices() const { return shell_->window().findChild<Notices*>(); }
    [[nodiscard]] static Problem trouble(int number) {
        return {QString("Trouble %1.").arg(number), "Do this.", "sqlite:/tmp/x.db: exact words",
                false};
    }
    void report(int number) {
        shell_->context().report(trouble(number));
        QCoreApplication::processEvents();
    }
    [[nodiscard]] QRect place(const QWidget* widget) const {
        return {widget->mapTo(&shell_->window(), QPoint(0, 0)), widget->size()};
    }

    std::unique_ptr<ShellHarness> shell_;
};

void ShellMessagesTest::messagesMoveNothing() {
    auto& window = shell_->window();
    QTest::qWait(50);
    const QList<QWidget*> parts{shell_->window().page(), shell_->find<QWidget>("add_person"),
                                shell_->find<QWidget>("people_table"),
                                shell_->find<QWidget>("rail_people")};
    QList<QRect> before;
    for (const QWidget* part : parts) before << place(part);
    report(1);
    Q_EMIT window.page()->notice("Good news.");
    Q_EMIT shell_->context().busyChanged("Working");
    QTest::qWait(700);  // until the work is worth a word
    QCOMPARE(notices()->count(), 2);
    QVERIFY(notices()->findChild<QWidget*>("busy")->isVisible());
    for (qsizetype i = 0; i < parts.size(); ++i) QCOMPARE(place(parts[i]), before[i]);
    window.grab().save(shell_->shotFile("63_messages_float"));
    Q_EMIT shell_->context().busyChanged({});
    QVERIFY(!notices()->findChild<QWidget*>("busy")->isVisible());
}

void ShellMessagesTest::workInProgressHidesNothingAndSaysHowLong() {
    auto& context = shell_->context();
    QSettings& settings = context.settings();
    settings.setValue("pace/reading", 0.05);
    std::atomic<bool> go = false;
    bool over = false;
    context.background(
        &shell_->window(), "Reading the recording",
        [&go](db::Store&) {
            while (!go) QThread::msleep(10);
        },
        [&over](bool) { over = true; }, {"reading", 1000});  // some 50 s
    QVERIFY(QTest::qWaitFor([&] {
        return notices()->findChild<QWidget*>("busy")->isVisible() &&
               notices()->findChild<QProgressBar*>()->maximum() == 100;
    }));
    QTest::qWait(1300);
    const auto pace = context.busyPace();
    QVERIFY(pace && pace->share > 0.005 && pace->share < 0.9);
    QVERIFY2(pace->left_s > 40 && pace->left_s < 50, qPrintable(QString::number(pace->left_s)));
    QVERIFY(!pace->overdue);
    // An estimate that has turned out wrong is not repeated for ever.
    settings.setValue("pace/reading", 0.0021);  // 2 s in all; most of it has passed already
    QVERIFY(QTest::qWaitFor([&] { return context.busyPace() && context.busyPace()->overdue; }));
    QVERIFY(QTest::qWaitFor([&] {
        const auto labels = notices()->findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
            return label->text().contains("longer than usual");
        });
    }));
    settings.setValue("pace/reading", 0.05);
    // In the bar above: over no page and no button.
    const QRect there = place(notices());
    QVERIFY(!there.intersects(place(shell_->window().page())));
    for (const auto* button : shell_->window().findChildren<QAbstractButton*>())
        if (button->isVisible() && !notices()->isAncestorOf(button))
            QVERIFY2(!there.intersects(place(button)), qPrintable(button->objectName()));
    shell_->window().grab().save(shell_->shotFile("64_busy_in_the_bar"));
    // What needs the computer for itself waits for it; what has gone meanwhile is not done.
    bool begun = false, begun_by_nobody = false;
    context.whenIdle(&shell_->window(), [&] { begun = true; });
    context.whenIdle(std::make_unique<QObject>().get(), [&] { begun_by_nobody = true; });
    QTest::qWait(50);
    QVERIFY(!begun);
    go = true;
    QVERIFY(QTest::qWaitFor([&] { return over; }));
    QVERIFY(QTest::qWaitFor([&] { return begun; }));
    QVERIFY(!begun_by_nobody);
    context.whenIdle(&shell_->window(), [&] { begun = false; });
    QVERIFY2(!begun, "nothing is worked on: at once");
    QVERIFY2(settings.value("pace/reading").toDouble() < 0.05, "it was quicker than last time");
    QVERIFY(!context.busyPace());
}

void ShellMessagesTest::aQuestionHasAFrameAndDimsThePage() {
    bool framed = false, dimmed = false, titled = false;
    QTimer::singleShot(300, &shell_->window(), [&] {
        QWidget* dialog = QApplication::activeModalWidget();
        auto* box = qobject_cast<QMessageBox*>(dialog);
        titled = box != nullptr && box->text().contains("Remove it?");
        framed = dialog != nullptr && dialog->findChild<QWidget*>("dialog_frame") != nullptr &&
                 dialog->findChild<QWidget*>("dialog_frame")->size() == dialog->size();
        auto* dim = shell_->window().findChild<QWidget*>("dimmed");
        dimmed = dim != nullptr && dim->isVisible() && dim->size() == shell_->window().size();
        QScreen* screen = shell_->window().screen();
        screen->grabWindow(0).save(shell_->shotFile("65_question"));
        shell_->refuseNext();
    });
    QVERIFY(!confirm(&shell_->window(), "Remove it?", "It goes for good.", "Remove"));
    QVERIFY(framed);
    QVERIFY2(titled, "a desktop without title bars shows the question, too");
    QVERIFY(dimmed);
    QVERIFY2(shell_->window().findChild<QWidget*>("dimmed") == nullptr, "the page is bright again");
}

void ShellMessagesTest::escapeAndTheCrossCloseTheNewest() {
    report(1);
    report(2);
    QTest::keyClick(shell_->window().windowHandle(), Qt::Key_Escape);
    QCOMPARE(notices()->count(), 1);
    QVERIFY(notices()->text().contains("Trouble 1."));
    QTest::keyClick(shell_->find<QLineEdit>("new_name"), Qt::Key_Escape);
    QCOMPARE(notices()->count(), 0);
    QVERIFY(!notices()->isVisible());
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    report(3);
    QTest::mouseClick(notices()->findChild<QPushButton*>("banner_close"), Qt::LeftButton);
    QCOMPARE(notices()->count(), 0);
}

void ShellMessagesTest::manyAreStackedAndTheSameIsShownOnce() {
    for (int i = 1; i <= 5; ++i) report(i);
    report(5);
    QCOMPARE(notices()->count(), 5);
    QVERIFY(notices()->text().startsWith("Trouble 5."));
    int visible = 0;
    for (const auto* banner : notices()->findChildren<Banner*>()) visible += banner->isVisible();
    QCOMPARE(visible, Notices::kMostShown);
    QVERIFY(notices()->findChild<QLabel*>("notices_waiting")->text().contains("2"));
    // No two lie over each other, and all lie in the window.
    QVERIFY(shell_->window().rect().contains(notices()->geometry()));
    QList<QRect> places;
    for (const auto* banner : notices()->findChildren<Banner*>())
        if (banner->isVisible()) {
            for (const QRect& other : places) QVERIFY(!other.intersects(place(banner)));
            places << place(banner);
        }
    QVERIFY(notices()->closeNewest());
    QVERIFY(notices()->text().startsWith("Trouble 4."));
}

void ShellMessagesTest::goodNewsGoesByItselfAndTroubleStays() {
    QApplication::setActiveWindow(&shell_->window());
    report(1);
    Q_EMIT shell_->window().page()->notice("Done.");
    QVERIFY(shell_->bannerSays("Done."));
    QVERIFY(QTest::qWaitFor([&] { return !notices()->text().contains("Done."); }, 15000));
    QVERIFY(notices()->text().contains("Trouble 1."));
    QTest::qWait(1000);  // the time after which good news would have gone
    QCOMPARE(notices()->count(), 1);
}

void ShellMessagesTest::screenReadersHearIt() {
    alerts = 0;
    const auto before = QAccessible::installUpdateHandler(&count_alerts);
    report(1);
    QAccessible::installUpdateHandler(before);
    // Qt asks no handler as long as no assistive program is there.
    if (QAccessible::isActive()) QCOMPARE(alerts, 1);
    auto* banner = notices()->findChild<Banner*>();
    QAccessibleInterface* spoken = QAccessible::queryAccessibleInterface(banner);
    QVERIFY(spoken != nullptr);
    QCOMPARE(spoken->role(), QAccessible::AlertMessage);
    QVERIFY(spoken->text(QAccessible::Name).contains("Trouble 1. Do this."));
}

void ShellMessagesTest::theyKeepClearOfThePrimaryButton_data() {
    QTest::addColumn<QSize>("size");
    QTest::newRow("desk") << QSize(1920, 1080);
    QTest::newRow("laptop") << QSize(1366, 768);
    QTest::newRow("small") << QSize(1024, 768);
}

void ShellMessagesTest::theyKeepClearOfThePrimaryButton() {
    QFETCH(QSize, size);
    MainWindow& window = shell_->window();
    window.resize(size);
    for (const PageId page :
         {PageId::kPeople, PageId::kHealth, PageId::kAccount, PageId::kDevices}) {
        window.open({page, 0, {}, {}});
        QVERIFY(shell_->arrives(page));
        QTest::qWait(80);
        report(1);
        QTest::qWait(300);  // pages settle; then it steps aside
        for (const auto* button : window.page()->findChildren<QPushButton*>()) {
            if (button->property("role") != "primary" || button->visibleRegion().isEmpty())
                continue;
            QRect there = button->visibleRegion().boundingRect();
            there.moveTopLeft(button->mapTo(&window, there.topLeft()));
            QVERIFY2(!there.intersects(notices()->geometry()), qPrintable(button->objectName()));
        }
        // One place for all of them: at the right edge, as high as the page asks for.
        QCOMPARE(notices()->geometry().right(), window.width() - 1 - 16);
        window.grab().save(shell_->shotFile(
            QString("64_message_beside_%1_%2").arg(static_cast<int>(page)).arg(size.width())));
    }
    window.resize(1366, 768);
    window.open({PageId::kPeople, 0, {}, {}});
    QVERIFY(shell_->arrives(PageId::kPeople));
}

void ShellMessagesTest::theExactTextIsFoldedAwayAndCanBeCopied() {
    report(1);
    QVERIFY(!read_all(notices()).contains("sqlite:"));
    QVERIFY(read_all(notices()).contains("Do this."));
    const QSize closed = notices()->size();
    QTest::mouseClick(notices()->findChild<QPushButton*>("details_toggle"), Qt::LeftButton);
    auto* text = notices()->findChild<QPlainTextEdit*>("details_text");
    QVERIFY(text->isVisible());
    QVERIFY(notices()->height() > closed.height());
    QVERIFY(shell_->window().rect().contains(notices()->geometry()));
    QTest::mouseClick(notices()->findChild<QPushButton*>("details_copy"), Qt::LeftButton);
    QCOMPARE(QGuiApplication::clipboard()->text(), QString("sqlite:/tmp/x.db: exact words"));
    shell_->window().grab().save(shell_->shotFile("65_message_details"));
    QTest::mouseClick(notices()->findChild<QPushButton*>("details_toggle"), Qt::LeftButton);
    QVERIFY(!text->isVisible());
    QCOMPARE(notices()->size(), closed);
}

void ShellMessagesTest::aLongExactTextScrollsAndCanBeMarked() {
    QStringList lines;
    for (int i = 0; i < 60; ++i)
        lines << QString("line %1 of /a/path/without/a/space/%2/end").arg(i).arg(QString(90, 'x'));
    shell_->context().report({"Trouble.", "Do this.", lines.join('\n'), false});
    QCoreApplication::processEvents();
    QTest::mouseClick(notices()->findChild<QPushButton*>("details_toggle"), Qt::LeftButton);
    QTest::qWait(50);
    auto* text = notices()->findChild<QPlainTextEdit*>("details_text");
    QVERIFY(text->isVisible());
    QVERIFY2(shell_->window().rect().contains(notices()->geometry()), "cut off by the window");
    QVERIFY(place(notices()).contains(place(text)));
    QVERIFY2(text->verticalScrollBar()->maximum() > 0, "the rest scrolls");
    QCOMPARE(text->horizontalScrollBar()->maximum(), 0);
    text->selectAll();
    text->copy();
    QCOMPARE(QGuiApplication::clipboard()->text(), lines.join('\n'));
    shell_->window().grab().save(shell_->shotFile("65_message_long_details"));
}

void ShellMessagesTest::whatWasWrittenCanBeOpened() {
    const auto press = [&](const QString& name) {
        auto* button = notices()->findChild<QPushButton*>(name);
        if (button == nullptr || !button->isVisible()) return false;
        QTest::mouseClick(button, Qt::LeftButton);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        return true;
    };
    const QString pdf = shell_->path("a.pdf"), folder = QFileInfo(pdf).absolutePath();
    Q_EMIT shell_->window().page()->written("Report written: " + pdf, pdf);
    QVERIFY(shell_->bannerSays(pdf));
    shell_->window().grab().save(shell_->shotFile("67_message_written"));
    QVERIFY(press("banner_folder"));
    QCOMPARE(shell_->shown, folder);
    QVERIFY(press("banner_offer"));
    QCOMPARE(shell_->shown, pdf);
    QVERIFY(!notices()->text().contains(pdf));
    // A folder is itself what is opened; a store is no file to look at.
    Q_EMIT shell_->window().page()->written("Files written: 3", folder);
    QVERIFY(shell_->bannerSays("Files written"));
    QVERIFY(!press("banner_folder"));
    QVERIFY(press("banner_offer"));
    QCOMPARE(shell_->shown, folder);
    Q_EMIT shell_->window().page()->written("Backup written", shell_->path("copy.db"));
    QVERIFY(shell_->bannerSays("Backup"));
    QVERIFY(!press("banner_offer"));
    QVERIFY(press("banner_folder"));
    QCOMPARE(notices()->findChild<Banner*>()->tone(), Banner::Tone::kGood);  // goes by itself
}

void ShellMessagesTest::filesGoWhereTheLastOneWent() {
    AppContext& context = shell_->context();
    const auto proposed = [&](const QString& answer) {
        shell_->save_as = answer;
        (void)context.askSaveFile(nullptr, "Save", "report.pdf", {});
        return shell_->proposed;
    };
    QVERIFY(QDir(shell_->path("")).mkpath("there"));
    const QString first = proposed(shell_->path("there/mine.pdf"));
    QVERIFY2(QFileInfo(first).isAbsolute(), qPrintable(first));  // Not the program's own folder.
    QVERIFY(QFileInfo(first).absolutePath() != QDir::currentPath());
    QCOMPARE(QFileInfo(first).fileName(), QString("report.pdf"));
    QCOMPARE(proposed({}), shell_->path("there/report.pdf"));
    QCOMPARE(proposed({}), shell_->path("there/report.pdf"));  // Giving up changes nothing.
    (void)context.askFolder(nullptr, "Into");
    QCOMPARE(shell_->proposed, shell_->path("there"));
    (void)context.askOpenFile(nullptr, "Open", {});
    QCOMPARE(shell_->proposed, shell_->path("there"));
    QVERIFY(QDir(shell_->path("there")).removeRecursively());
    QCOMPARE(proposed({}), first);
}

void ShellMessagesTest::languageAndThemeKeepThem() {
    report(1);
    shell_->context().setTheme(ThemeKind::kDark);
    QCOMPARE(notices()->count(), 1);
    QVERIFY(notices()->isVisible());
    shell_->window().grab().save(shell_->shotFile("66_message_dark"));
    shell_->context().setTheme(ThemeKind::kLight);
    // Who signs in next does not read what was told to the one before.
    shell_->context().signOut();
    QCOMPARE(notices()->count(), 0);
    QVERIFY(shell_->signIn("ada", "correct horse"));
}

void ShellMessagesTest::everyTroubleHasUserWords_data() {
    using Kind = db::StoreError::Kind;
    QTest::addColumn<std::function<void()>>("work");
    QTest::addColumn<QString>("expected");
    const auto row = [](const char* name, std::function<void()> work, const char* expected) {
        QTest::newRow(name) << work << QString(expected);
    };
    const auto store = [](Kind kind, const char* said) {
        return [kind, said] { throw db::StoreError(kind, said); };
    };
    row("locked", store(Kind::kLocked, "save sqlite:/tmp/x.db: database is locked; wait"),
        "locked by another program");
    row("damaged", store(Kind::kDamaged, "open sqlite:/tmp/x.db: file is not a database"),
        "Restore a backup");
    row("new", store(Kind::kTooNew, "open sqlite:/tmp/x.db: migration 99"), "Update Placode");
    row("gone", store(Kind::kUnavailable, "open postgresql://h/x: connection refused (errno 111)"),
        "cannot be reached");
    row("full", store(Kind::kUnavailable, "save sqlite:/tmp/x.db: the disk is full; make room"),
        "disk is full");
    row("taken",
        store(Kind::kConflict,
              "create a user in sqlite:/tmp/x.db: the login is taken; choose another one"),
        "The login is taken; choose another one.");
    // As the store really says it, with the name in quotation marks.
    row("taken by name",
        store(
            Kind::kConflict,
            "create the user \"anna\" in sqlite:/tmp/x.db: the login is taken; choose another one"),
        "The login is taken; choose another one.");
    row("conflict", store(Kind::kConflict, "save sqlite:/tmp/x.db: UNIQUE constraint failed: SQL"),
        "done already");
    row("refused",
        store(Kind::kRefused, "set a PIN in sqlite:/tmp/x.db: a PIN has four to twelve digits"),
        "A PIN has four to twelve digits.");
    row("missing", store(Kind::kNotFound, "read sqlite:/tmp/x.db: there is no attempt 9"),
        "not there any more");
    row("sql", store(Kind::kOther, "save sqlite:/tmp/x.db: near SELECT: SQL error; nothing"),
        "Nothing was changed");
    row(
        "own", [] { throw Refusal("A person needs a name."); }, "A person needs a name.");
    row(
        "device",
        [] {
            throw haptics::DeviceError(
                "openhaptics: libHD.so.3.4: cannot open shared object file. Install");
        },
        "Choose another device");
    row(
        "report",
        [] { throw reports::ReportError("write report to /tmp/a.pdf: Permission denied; choose"); },
        "You may not write there");
    row(
        "program", [] { throw LaunchError(LaunchError::Kind::kMissing, "/tmp/placode-sim: not"); },
        "install Placode again");
    row(
        "busy", [] { throw LaunchError(LaunchError::Kind::kBusy, "another /tmp/attempt"); },
        "still running");
    row(
        "file",
        [] {
            throw std::filesystem::filesystem_error(
                "cannot copy", "/tmp/x", std::make_error_code(std::errc::no_space_on_device));
        },
        "disk is full");
    row(
        "memory", [] { throw std::bad_alloc(); }, "not enough memory");
    row(
        "other", [] { throw std::runtime_error("what(): vector::_M_range_check 0x7f"); },
        "Nothing was changed");
}

void ShellMessagesTest::everyTroubleHasUserWords() {
    QFETCH(std::function<void()>, work);
    QFETCH(QString, expected);
    const Problem english = problem_of(thrown(work), "Saving");
    QVERIFY2(english.said().contains(expected), qPrintable(english.said()));
    QVERIFY2(!for_developers(english.said()), qPrintable(english.said()));
    const bool own = qstrcmp(QTest::currentDataTag(), "own") == 0;
    QVERIFY(own || !english.way_out.isEmpty());
    QCOMPARE(english.detail.isEmpty(), own);
    QVERIFY(!english.open_details);
    if (own) return;
    shell_->context().setLanguage("pl");
    const Problem polish = problem_of(thrown(work), "Zapis");
    shell_->context().setLanguage("en");
    QVERIFY2(polish.title != english.title, qPrintable(polish.title));
    QVERIFY2(polish.way_out != english.way_out, qPrintable(polish.way_out));
    QCOMPARE(polish.detail, english.detail);  // exact words have one language
}

void ShellMessagesTest::endingsOfTheSimulatorHaveUserWords() {
    const auto said = [](const ProgramEnd& end) {
        const Problem problem = simulator_problem(end);
        return problem.said() + (for_developers(problem.said()) ? " FOR DEVELOPERS" : "");
    };
    const QString device =
        said({false, 2, false, "openhaptics",
              "placode-sim: openhaptics: libHD.so.3.4: cannot open\nplacode-sim: "
              "without it: --device mouse; --list-devices says what is there"});
    QVERIFY2(device.contains("could not be started") && device.contains("OpenHaptics") &&
                 !device.contains("FOR DEVELOPERS"),
             qPrintable(device));
    QVERIFY(said({false, 1, false, "mouse", "placode-sim: no display to open a window on (X11)"})
                .contains("no screen"));
    QVERIFY(said({false, 1, true, "mouse", "placode-sim: write: No space left on device"})
                .contains("disk is full"));
    const QString crash = said({true, 11, true, "mouse", "0x7fff: segfault"});
    QVERIFY2(crash.contains("unexpectedly") && crash.contains("kept") &&
                 !crash.contains("FOR DEVELOPERS"),
             qPrintable(crash));
    QVERIFY(simulator_problem({true, 11, true, "mouse", {}}).detail.contains("signal 11"));
    QVERIFY(said({false, 1, true, {}, "placode-sim: chunk 3"}).contains("score are untouched"));
    // What sound libraries print at every start has nothing to do with it.
    const Problem noisy = simulator_problem(
        {false, 1, true, "mouse",
         "ALSA lib confmisc.c:855:(parse_card) cannot find card '0'\n"
         "ALSA lib pcm.c:2664:(snd_pcm_open_noupdate) Unknown PCM default\n"
         "[ALSOFT] (EE) Failed to open device\nplacode-sim: write: No space left on device"});
    QCOMPARE(noisy.detail,
             QString("placode-sim: write: No space left on device\nplacode-sim: exit status 1"));
}

void ShellMessagesTest::everyRefusalOfTheStoreIsInTheCatalogue() {
    // Literals that follow kRefused in the store's sources; the beginning of each has to be known.
    static const QRegularExpression kLiteral(
        "k(?:Refused),\\s*(?:path_?,\\s*)?\"((?:[^\"\\\\]|\\\\.)*)\"");
    QDir folder(PLACODE_SOURCE_DIR "/db");
    int checked = 0;
    for (const QString& name : folder.entryList({"*.cpp"})) {
        // Never from the shell, but for a station's log-in, whose sentence is looked for below.
        if (name == "load_generator.cpp" || name == "reading_store.cpp" ||
            name == "station_role.cpp" || name == "work_queue.cpp" || name == "erasure.cpp" ||
            name == "store_move.cpp")
            continue;
        QFile file(folder.filePath(name));
        QVERIFY(file.open(QIODevice::ReadOnly));
        auto found = kLiteral.globalMatch(QString::fromUtf8(file.readAll()));
        while (found.hasNext()) {
            QString literal = found.next().captured(1).replace("\\\"", "\"");
            if (literal.size() < 6 || literal.startsWith("consent of") ||
                literal.startsWith("answers of") || literal.contains("nothing was changed"))
                continue;
            ++checked;
            bool known = false;
            for (const QString& sentence : store_sentences()) {
                const QString beginning = sentence.section('%', 0, 0);
                known = known || (!beginning.isEmpty() &&
                                  (literal.startsWith(beginning) || beginning.startsWith(literal)));
            }
            QVERIFY2(known, qPrintable(name + ": " + literal));
        }
    }
    QVERIFY(checked > 25);
    const QStringList all = store_sentences();
    QVERIFY(std::any_of(all.begin(), all.end(), [](const QString& each) {
        return each.startsWith("this log-in to the server can do more than a station should");
    }));
    // A store that has moved, as its place says so when it is opened, and its triggers later.
    shell_->context().setLanguage("pl");
    const QString moved =
        "open sqlite:/a.db: the store was moved to postgresql://db:5432/p; use that address, or "
        "bring it back with `placodectl --store postgresql://db:5432/p store move --to "
        "sqlite:/a.db`";
    for (const QString& said : {moved, moved + "; nothing was changed"}) {
        const QString words = store_words(said);
        QVERIFY2(words.startsWith("Magazyn danych przeniesiono do postgresql://db:5432/p;") &&
                     words.contains("`placodectl --store postgresql://db:5432/p store move"),
                 qPrintable(words));
    }
    shell_->context().setLanguage("en");
}

void ShellMessagesTest::whoMayNotIsToldWhoCan() {
    shell_->context().setLanguage("pl");
    for (int i = 0; i < 24; ++i) {
        const QString english = QString::fromStdString(db::refusal(static_cast<db::Action>(i)));
        const QString polish = store_words(english);
        QVERIFY2(!polish.isEmpty() && !polish.contains(" can"), qPrintable(english));
    }
    shell_->context().setLanguage("en");
    QCOMPARE(store_words(QString::fromStdString(db::refusal(db::Action::kViewAudit))),
             QString("You may not see the audit trail; an administrator can."));
}

void ShellMessagesTest::damagedLeftoversAreToldInWords() {
    QDir().mkpath(shell_->context().recordingsFolder());
    QFile file(shell_->context().recordingsFolder() + "/broken.placode");
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("this is no recording");
    file.close();
    shell_->window().open({PageId::kRecovery, 0, {}, {}});
    QVERIFY(shell_->arrives(PageId::kRecovery));
    QTest::qWait(80);  // until the page is on the screen
    const QString seen = read_all(shell_->window().page());
    QVERIFY2(seen.contains("cannot be scored") && seen.contains("A recording\n"), qPrintable(seen));
    QVERIFY2(!seen.contains("broken.placode") && !for_developers(seen), qPrintable(seen));
    QVERIFY(shell_->window().page()->findChild<Details*>()->text().contains("broken.placode"));
    shell_->shot("67_recovery_damaged");
    QVERIFY(file.remove());
}

void ShellMessagesTest::aReplayGoesBesideItsControls() {
    const QRect screen(0, 0, 1920, 1080);
    const auto clear = [](const QRect& place, const QRect& controls, const QRect& all) {
        return place.isValid() && all.contains(place) && !place.intersects(controls) &&
               place.width() >= 420;
    };
    // A laptop's window in the corner of a desk's screen: beside it or below the controls.
    for (const QRect& window : {QRect(0, 0, 1366, 768), QRect(500, 200, 1366, 768), screen}) {
        const QRect controls(window.x() + 216, window.y() + 60, window.width() - 216, 220);
        const QRect place = replay_place({screen}, window, controls);
        QVERIFY2(clear(place, controls, screen), qPrintable(QString::number(place.x())));
    }
    // A full small screen: over the page, below the controls.
    const QRect small(0, 0, 1366, 768), controls(216, 60, 1150, 220);
    QVERIFY(clear(replay_place({small}, small, controls), controls, small));
    // A second screen is free.
    const QRect second(1920, 0, 1920, 1080);
    QVERIFY(second.contains(replay_place({screen, second}, screen, {216, 60, 1704, 220})));
    const auto both = two_of(replay_place({second}, screen, {216, 60, 1704, 220}));
    QCOMPARE(both.size(), size_t{2});
    QVERIFY(!both[0].intersects(both[1]));
    QVERIFY(replay_place({QRect(0, 0, 400, 300)}, QRect(0, 0, 400, 300), QRect(0, 0, 400, 300))
                .isNull());
}

void ShellMessagesTest::aReplayLeavesTheTimeLineInSight() {
    QWidget window;
    const QRect screen = window.screen()->availableGeometry();
    window.setGeometry(screen.adjusted(0, 40, -100, -40));  // No room beside it.
    QWidget controls(&window), line(&window);
    controls.setGeometry(0, 0, window.width(), 200);
    line.setGeometry(0, 200, window.width(), 150);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    const auto covers = [](const QRect& place, const QWidget& part) {
        return place.intersects(QRect(part.mapToGlobal(QPoint(0, 0)), part.size()));
    };
    QVERIFY(covers(replay_place(controls), line));
    const QRect place = replay_place(controls, &line);
    QVERIFY(place.isValid() && !covers(place, line) && !covers(place, controls));
    // A line that leaves no room gives way: to watch is what the person came for.
    line.resize(window.width(), window.height() - 200);
    const QRect over = replay_place(controls, &line);
    QVERIFY(over.isValid() && !covers(over, controls));
}

}  // namespace placode::ui

int main(int argc, char** argv) {
    placode::ui::prepare_display();
    QApplication application(argc, argv);
    placode::ui::ShellMessagesTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "shell_messages_test.moc"
