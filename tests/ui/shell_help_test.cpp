// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The manual in the shell: F1 and the button open the chapter of the page, links and search lead
// where they say, in both languages and at every size, and everything is named.

#include <QDialog>
#include <QListWidget>
#include <QProcess>
#include <QTextBlock>

#include "page_fit.h"
#include "shell_harness.h"
#include "ui/shell/help_window.h"
#include "ui/shell/manual_view.h"
#include "ui/shell/page_tour.h"

namespace placode::ui {

namespace {

constexpr const char* kLanguages[]{"en", "pl"};

}  // namespace

class ShellHelpTest : public QObject {
    Q_OBJECT

 private Q_SLOTS:
    void initTestCase();
    void cleanupTestCase() { shell_.reset(); }
    void f1OpensTheChapterOfThePage();
    void linksHeadingsAndHistoryLeadThere();
    void picturesAreShownAsTheyAre();
    void searchFindsWithoutAccents();
    void everythingIsNamedAndFits();
    void searchOverEverythingOpensTheManual();
    void aParticipantHasNoHelp();

 private:
    [[nodiscard]] HelpWindow* help() const {
        return shell_->window().findChild<HelpWindow*>("help_window");
    }

    std::unique_ptr<ShellHarness> shell_;
};

void ShellHelpTest::initTestCase() {
    shell_ = std::make_unique<ShellHarness>();
    QVERIFY(shell_->setUpWithDemonstration());
    const QString store = QString::fromStdString(shell_->context().storeUrl());
    for (const QStringList& step :
         {QStringList{"study", "demo"}, {"study", "enrol", "face_content_validity", "--consented"}})
        QCOMPARE(
            QProcess::execute(PLACODE_BIN_DIR "/placodectl", QStringList{"--store", store} + step),
            0);
}

void ShellHelpTest::f1OpensTheChapterOfThePage() {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.signIn("demo.educator", "placode-demo"));
    for (const TourStop& stop : page_tour(shell.context())) {
        QApplication::setActiveWindow(&shell.window());
        shell.window().visit(stop.place);
        QVERIFY2(shell.arrives(stop.place.page), stop.name);
        QTest::keyClick(&shell.window(), Qt::Key_F1);
        QVERIFY(help() != nullptr && help()->isVisible());
        QCOMPARE(help()->shown(), manual_chapter(stop.place.page));
        close_help(&shell.window());
    }
    shell.window().visit({PageId::kNorms, 0, {}, {}});
    QVERIFY(shell.click("help"));
    QCOMPARE(help()->shown(), QString("educator-norms.md"));
    auto* view = help()->findChild<ManualView*>();
    QVERIFY(view->toPlainText().startsWith("Norms"));
    // The other language, at the same page.
    shell.context().setLanguage("pl");
    QVERIFY(help()->isVisible());
    QVERIFY(help()->findChild<ManualView*>()->toPlainText().startsWith("Normy"));
    shell.context().setLanguage("en");
    QTest::keyClick(help(), Qt::Key_Escape);
    QVERIFY(!help()->isVisible());
}

void ShellHelpTest::linksHeadingsAndHistoryLeadThere() {
    ShellHarness& shell = *shell_;
    open_help(shell.context(), &shell.window(), "study-enrol.md");
    auto* view = help()->findChild<ManualView*>();
    Q_EMIT view->anchorClicked(QUrl("study-data.md"));
    QCOMPARE(help()->shown(), QString("study-data.md"));
    help()->open("study-data.md#sheets-of-paper");
    QTRY_VERIFY(view->verticalScrollBar()->value() > 100);
    QCOMPARE(view->textCursor().block().text(), QString("Sheets of paper"));
    QVERIFY(!view->goTo("no-such-heading"));
    const auto press = [&](const char* button) {
        QTest::mouseClick(help()->findChild<QPushButton*>(button), Qt::LeftButton);
    };
    press("help_back");
    press("help_back");
    QCOMPARE(help()->shown(), QString("study-enrol.md"));
    press("help_forward");
    QCOMPARE(help()->shown(), QString("study-data.md"));
    Q_EMIT view->anchorClicked(QUrl("https://example.org/"));  // nothing leaves the computer
    QCOMPARE(help()->shown(), QString("study-data.md"));
    press("help_contents");
    QCOMPARE(help()->shown(), QString("index.md"));
}

void ShellHelpTest::picturesAreShownAsTheyAre() {
    open_help(shell_->context(), &shell_->window(), "admin-setup.md");
    help()->resize(820, 700);
    QTest::qWait(200);
    const auto* view = help()->findChild<ManualView*>();
    QTextBlock block = view->document()->begin();
    while (block.isValid() && !block.text().contains(QChar::ObjectReplacementCharacter))
        block = block.next();
    QVERIFY(block.isValid());
    const QString name = block.begin().fragment().charFormat().toImageFormat().name();
    const auto shown =
        view->document()->resource(QTextDocument::ImageResource, QUrl(name)).value<QImage>();
    QVERIFY(shown.width() > 100);
    // Made smaller without grain: nine pixels of the page's ground are one colour.
    const QRgb ground = shown.pixel(8, shown.height() / 2);
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) QCOMPARE(shown.pixel(8 + x, shown.height() / 2 + y), ground);
    // And no empty third below it.
    const double high = view->document()->documentLayout()->blockBoundingRect(block).height();
    QVERIFY2(high < 1.1 * shown.height() + 30, qPrintable(QString::number(high)));
}

void ShellHelpTest::searchFindsWithoutAccents() {
    ShellHarness& shell = *shell_;
    shell.context().setLanguage("pl");
    open_help(shell.context(), &shell.window(), "index.md");
    auto* typed = help()->findChild<QLineEdit*>("help_search");
    auto* list = help()->findChild<QListWidget*>("help_list");
    QVERIFY(list->count() > 50);
    typed->setFocus();
    QTest::keyClicks(typed, "pedaly nozne");
    QCOMPARE(list->item(0)->text(), QString("Pedały nożne"));
    QTest::keyClick(typed, Qt::Key_Return);
    QCOMPARE(help()->shown(), QString("device-pedals.md"));
    typed->setText("xyzzy");
    QCOMPARE(list->count(), 1);
    QTest::keyClick(typed, Qt::Key_Return);
    QCOMPARE(help()->shown(), QString("device-pedals.md"));
    typed->clear();
    QVERIFY(list->count() > 50);
    QVERIFY(list->currentItem() != nullptr);
    QCOMPARE(list->currentItem()->text(), QString("Pedały nożne"));
    shell.context().setLanguage("en");
}

void ShellHelpTest::everythingIsNamedAndFits() {
    ShellHarness& shell = *shell_;
    QStringList wrong;
    for (const char* language : kLanguages) {
        shell.context().setLanguage(language);
        for (const ThemeKind theme : {ThemeKind::kDark, ThemeKind::kLight}) {
            shell.context().setTheme(theme);
            open_help(shell.context(), &shell.window(), "trainee-result.md");
            for (const QSize size : {QSize(640, 400), QSize(820, 700), QSize(1200, 900)}) {
                help()->resize(size);
                QTest::qWait(200);
                for (const QString& misfit : misfits(*help())) wrong << misfit;
                const auto* view = help()->findChild<ManualView*>();
                if (view->horizontalScrollBar()->maximum() > 0)
                    wrong << QString("%1 px: the page scrolls sideways").arg(size.width());
                shell.keep(help()->grab(), QString("97_help_%1_%2_%3")
                                               .arg(language)
                                               .arg(size.width())
                                               .arg(theme == ThemeKind::kDark ? "dark" : "light"));
            }
        }
        for (const QWidget* widget : help()->findChildren<QWidget*>()) {
            if (!widget->isVisible() || (widget->focusPolicy() & Qt::TabFocus) == 0) continue;
            const auto* button = qobject_cast<const QAbstractButton*>(widget);
            const QString said = !widget->accessibleName().isEmpty() ? widget->accessibleName()
                                 : button != nullptr                 ? button->text()
                                                                     : QString();
            if (said.isEmpty()) wrong << widget->objectName() + " has no name";
        }
    }
    shell.context().setLanguage("en");
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join("\n")));
}

void ShellHelpTest::searchOverEverythingOpensTheManual() {
    ShellHarness& shell = *shell_;
    close_help(&shell.window());
    QVERIFY(shell.signIn("demo.trainee", "placode-demo"));
    QVERIFY(shell.click("search"));
    auto* dialog = shell.window().findChild<QDialog*>("search_box");
    auto* field = dialog->findChild<QLineEdit*>("search_text");
    QTest::keyClicks(field, "motion-bids");
    QVERIFY(
        QTest::qWaitFor([&] { return shell.context().workers().activeThreadCount() == 0; }, 10000));
    QTest::qWait(50);
    QCOMPARE(dialog->findChild<QListWidget*>("search_list")->count(), 1);
    QTest::keyClick(field, Qt::Key_Return);
    QVERIFY(QTest::qWaitFor([&] { return help()->isVisible(); }, 3000));
    QCOMPARE(help()->shown(), QString("export-motion-bids.md"));
}

void ShellHelpTest::aParticipantHasNoHelp() {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.signIn("demo.coordinator", "placode-demo"));
    open_help(shell.context(), &shell.window(), "index.md");
    for (const TourStop& stop : page_tour(shell.context()))
        if (stop.place.page == PageId::kStudyRun) shell.window().visit(stop.place);
    QVERIFY(shell.arrives(PageId::kStudyRun));
    QVERIFY(!help()->isVisible());
    QTest::keyClick(&shell.window(), Qt::Key_F1);
    QVERIFY(!help()->isVisible());
    QVERIFY(!shell.find<QToolButton>("help")->isVisible());
}

}  // namespace placode::ui

int main(int argc, char** argv) {
    placode::ui::prepare_display();
    QApplication application(argc, argv);
    placode::ui::ShellHelpTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "shell_help_test.moc"
