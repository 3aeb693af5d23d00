// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Messages: they float over the page and move nothing, keep clear of its button and go away as they
// should; what a part of the program said stands behind "Details". Their words: shell_trouble_test.

#include <QAccessible>
#include <QApplication>
#include <QClipboard>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QScreen>
#include <QSettings>
#include <QThread>
#include <atomic>

#include "seen_text.h"
#include "shell_harness.h"
#include "ui/shell/messages.h"
#include "ui/shell/parts.h"

namespace placode::ui {
namespace {

int alerts = 0;
void count_alerts(QAccessibleEvent* event) {
    if (event->type() == QAccessible::Alert) ++alerts;
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
    void whatFailsAfterTheWorkIsToldAsWell();
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
    shell_->keep(window.grab(), "63_messages_float");
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
    shell_->keep(shell_->window().grab(), "64_busy_in_the_bar");
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

// It is called by the event loop, and what it threw ended the program.
void ShellMessagesTest::whatFailsAfterTheWorkIsToldAsWell() {
    auto& context = shell_->context();
    context.background(
        &shell_->window(), "Reading the recording", [](db::Store&) {},
        [](bool) { throw Refusal("Your account was closed meanwhile."); });
    QVERIFY(shell_->bannerSays("closed meanwhile"));
    QVERIFY(!context.busy());
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
        shell_->keep(screen->grabWindow(0), "65_question");
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
        shell_->keep(
            window.grab(),
            QString("64_message_beside_%1_%2").arg(static_cast<int>(page)).arg(size.width()));
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
    shell_->keep(shell_->window().grab(), "65_message_details");
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
    shell_->keep(shell_->window().grab(), "65_message_long_details");
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
    shell_->keep(shell_->window().grab(), "67_message_written");
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
    shell_->keep(shell_->window().grab(), "66_message_dark");
    shell_->context().setTheme(ThemeKind::kLight);
    // Who signs in next does not read what was told to the one before.
    shell_->context().signOut();
    QCOMPARE(notices()->count(), 0);
    QVERIFY(shell_->signIn("ada", "correct horse"));
}

}  // namespace placode::ui

int main(int argc, char** argv) {
    placode::ui::prepare_display();
    QApplication application(argc, argv);
    placode::ui::ShellMessagesTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "shell_messages_test.moc"
