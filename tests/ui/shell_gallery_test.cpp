// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Every page that every role may open, with people, attempts, norms, a standard and a study in the
// store: nothing is cut off at any size in either language, everything is named. With
// $PLACODE_GALLERY set to a folder every page is also saved at every size, in both themes and both
// languages.

#include <QAbstractSpinBox>
#include <QAccessible>
#include <algorithm>
#include <set>

#include "full_store.h"
#include "page_fit.h"
#include "ui/shell/page_tour.h"

namespace placode::ui {

namespace {

const QSize kSizes[]{{960, 540}, {1024, 768}, {1366, 768}, {1920, 1080}};

struct Visitor {
    const char *login, *password;
};
constexpr Visitor kVisitors[]{{"demo.trainee", "placode-demo"},
                              {"demo.educator", "placode-demo"},
                              {"demo.coordinator", "placode-demo"},
                              {"ada", "correct horse"}};

constexpr QAccessible::Role kOperated[] = {
    QAccessible::Button,  QAccessible::CheckBox, QAccessible::RadioButton,  QAccessible::ComboBox,
    QAccessible::SpinBox, QAccessible::Slider,   QAccessible::EditableText, QAccessible::Table,
    QAccessible::Tree,    QAccessible::List,     QAccessible::PageTab,      QAccessible::Link};

/// Walks the tree that Qt hands to AT-SPI and lists what can be operated and has no name there.
/// How many things that can be operated it met.
int walk_as_a_screen_reader(const QAccessibleInterface* at, const char* page, QStringList& wrong) {
    if (at == nullptr || !at->isValid() || at->state().invisible) return 0;
    const bool operated = std::ranges::find(kOperated, at->role()) != std::end(kOperated);
    if (operated && at->text(QAccessible::Name).trimmed().isEmpty())
        wrong << QString("%1: a screen reader meets a thing of role %2 without a name (%3)")
                     .arg(page)
                     .arg(at->role())
                     .arg(at->object() != nullptr ? at->object()->objectName() : QString());
    int met = operated ? 1 : 0;
    // Inside of these stand parts of the same thing.
    const bool whole = at->role() == QAccessible::ComboBox || at->role() == QAccessible::SpinBox ||
                       at->role() == QAccessible::Table;
    for (int i = 0; !whole && i < at->childCount(); ++i)
        met += walk_as_a_screen_reader(at->child(i), page, wrong);
    return met;
}

}  // namespace

class ShellGalleryTest : public QObject {
    Q_OBJECT

 private Q_SLOTS:
    void initTestCase();
    void cleanupTestCase() { shell_.reset(); }
    void nothingIsCutOffAtAnySizeInAnyLanguage();
    void everythingThatTakesTheFocusIsNamed();
    void normsAndTheChartOfFailuresAreShown();
    void thePackThatIsUsedStaysSelected();

 private:
    void lookAt(const TourStop& stop, const QString& who, QStringList& wrong);

    std::unique_ptr<ShellHarness> shell_;
    FullStore filled_;
};

void ShellGalleryTest::initTestCase() {
    shell_ = std::make_unique<ShellHarness>();
    QVERIFY(filled_.fill(*shell_));
}

void ShellGalleryTest::lookAt(const TourStop& stop, const QString& who, QStringList& wrong) {
    ShellHarness& shell = *shell_;
    const QString folder = qEnvironmentVariable("PLACODE_GALLERY");
    if (!folder.isEmpty()) QDir().mkpath(folder);
    for (const ThemeKind theme : {ThemeKind::kDark, ThemeKind::kLight}) {
        if (folder.isEmpty() && theme == ThemeKind::kDark) continue;
        shell.context().setTheme(theme);
        shell.window().visit(stop.place);
        if (!shell.arrives(stop.place.page)) {
            wrong << QString("%1 cannot open %2").arg(who, stop.name);
            return;
        }
        for (const QSize size : kSizes) {
            shell.window().resize(size);
            settle(*shell_);
            const QString name = QString("%1_%2_%3_%4_%5")
                                     .arg(who, stop.name, shell.context().language())
                                     .arg(size.width())
                                     .arg(theme == ThemeKind::kDark ? "dark" : "light");
            for (const QString& misfit : misfits(shell.window())) wrong << name + ": " + misfit;
            if (!folder.isEmpty()) shell.window().grab().save(folder + "/" + name + ".png");
        }
    }
}

void ShellGalleryTest::nothingIsCutOffAtAnySizeInAnyLanguage() {
    ShellHarness& shell = *shell_;
    QStringList wrong;
    std::set<std::string> seen;
    for (const Visitor& visitor : kVisitors) {
        QVERIFY2(shell.signIn(visitor.login, visitor.password), visitor.login);
        for (const char* language : {"pl", "en"}) {
            shell.context().setLanguage(language);
            for (const TourStop& stop : page_tour(shell.context())) {
                // Once is enough where a page is the same for several roles.
                if (!seen.insert(std::string(stop.name) + language).second) continue;
                lookAt(stop, visitor.login, wrong);
            }
        }
    }
    // QVERIFY2 cuts a long text.
    for (const QString& each : wrong) std::fprintf(stderr, "%s\n", qPrintable(each));
    QVERIFY2(wrong.isEmpty(), qPrintable(QString("%1 misfits").arg(wrong.size())));
    QVERIFY(seen.size() >= 2 * 22);
}

void ShellGalleryTest::everythingThatTakesTheFocusIsNamed() {
    ShellHarness& shell = *shell_;
    QStringList wrong;
    shell.window().resize(1366, 768);
    for (const Visitor& visitor : kVisitors) {
        QVERIFY(shell.signIn(visitor.login, visitor.password));
        for (const TourStop& stop : page_tour(shell.context())) {
            shell.window().visit(stop.place);
            QVERIFY2(shell.arrives(stop.place.page), stop.name);
            settle(*shell_);
            for (const QWidget* widget : shell.window().findChildren<QWidget*>()) {
                if (!widget->isVisible() || (widget->focusPolicy() & Qt::TabFocus) == 0) continue;
                const QWidget* above = widget->parentWidget();
                // Inside a spin box or an editable list stands a line without a name of its own.
                if (qobject_cast<const QAbstractSpinBox*>(above) != nullptr ||
                    qobject_cast<const QComboBox*>(above) != nullptr)
                    continue;
                const auto* button = qobject_cast<const QAbstractButton*>(widget);
                const QString said = !widget->accessibleName().isEmpty() ? widget->accessibleName()
                                     : button != nullptr                 ? button->text()
                                                                         : QString();
                if (said.trimmed().isEmpty() && qobject_cast<const QScrollArea*>(widget) == nullptr)
                    wrong << QString("%1: %2 \"%3\" has no name")
                                 .arg(stop.name, widget->metaObject()->className(),
                                      widget->objectName());
            }
            const int met = walk_as_a_screen_reader(
                QAccessible::queryAccessibleInterface(&shell.window()), stop.name, wrong);
            QVERIFY2(met >= 5, stop.name);
        }
    }
    wrong.removeDuplicates();
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join("\n")));
}

void ShellGalleryTest::normsAndTheChartOfFailuresAreShown() {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.signIn("demo.trainee", "placode-demo"));
    const int64_t last = shell.owner().attempts().list(filled_.trainee()).back().id;
    shell.window().open({PageId::kResult, last, {}, {}});
    QVERIFY(shell.arrives(PageId::kResult));
    settle(*shell_);
    // Behind a measure of the pack stand the bands of novices and experts.
    auto* table = shell.find<QTableWidget>("metrics");
    QVERIFY(table != nullptr);
    int strips = 0;
    for (int row = 0; row < table->rowCount(); ++row)
        strips += table->cellWidget(row, 5) != nullptr ? 1 : 0;
    QVERIFY(strips >= 4);
    shell.whole("95_result_norms");
    shell.window().open({PageId::kHistory, 0, {}, {}});
    QVERIFY(shell.arrives(PageId::kHistory));
    settle(*shell_);
    QVERIFY2(shell.text("cusum_words").startsWith("CUSUM: since attempt"),
             qPrintable(shell.text("cusum_words")));
    QVERIFY2(!shell.text("learning_words").contains("gain"),  // Later scores are lower.
             qPrintable(shell.text("learning_words")));
    shell.whole("96_history_cusum");
}

// The list was filled anew and began with its first pack: the second press used that one.
void ShellGalleryTest::thePackThatIsUsedStaysSelected() {
    ShellHarness& shell = *shell_;
    curriculum::NormPack second = shell.owner().norms().list({}).front().pack;
    second.made_utc = "2026-04-02T10:00:00Z";
    (void)db::keep_own_norms(shell.owner(), second, "four words are good");
    QVERIFY(shell.signIn("demo.educator", "placode-demo"));
    shell.window().open({PageId::kNorms, 0, {}, {}});
    QVERIFY(shell.arrives(PageId::kNorms));
    auto* table = shell.find<QTableWidget>("norms_table");
    QCOMPARE(table->rowCount(), 2);
    for (const int row : {0, 1}) {
        table->selectRow(row);
        const QString made = table->item(row, 2)->text();
        if (shell.find<QPushButton>("use_norms")->isEnabled()) QVERIFY(shell.click("use_norms"));
        QCOMPARE(table->item(table->currentRow(), 2)->text(), made);
        QVERIFY2(!shell.find<QPushButton>("use_norms")->isEnabled(), "it is in use");
    }
}

}  // namespace placode::ui

int main(int argc, char** argv) {
    placode::ui::prepare_display();
    QApplication application(argc, argv);
    placode::ui::ShellGalleryTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "shell_gallery_test.moc"
