// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What everybody needs to use the shell: contrast, size of what is touched, names for screen
// readers, no traps for the keyboard, and room at twice the scale.

#include <QAbstractSpinBox>
#include <QApplication>
#include <QFrame>
#include <QPalette>
#include <cmath>
#include <map>

#include "shell_harness.h"
#include "tests/colour_vision.h"

namespace placode::ui {

namespace {

double linear(double share) {
    return share <= 0.03928 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
}
double luminance(const QColor& c) {
    return 0.2126 * linear(c.redF()) + 0.7152 * linear(c.greenF()) + 0.0722 * linear(c.blueF());
}
/// Source: WCAG 2.1, 1.4.3.
double contrast(const QColor& a, const QColor& b) {
    const double x = luminance(a), y = luminance(b);
    return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

struct Visit {
    const char* login;
    PageId page;
    const char* name;
};
constexpr const char* kPassword = "placode-demo";
const std::vector<Visit> kVisits{
    {"demo.trainee", PageId::kToday, "today"},
    {"demo.trainee", PageId::kCourse, "course"},
    {"demo.trainee", PageId::kHistory, "history"},
    {"demo.trainee", PageId::kAccount, "account"},
    {"demo.educator", PageId::kCohort, "cohort"},
    {"demo.educator", PageId::kCourses, "courses"},
    {"demo.educator", PageId::kCourseEditor, "course_editor"},
    {"demo.educator", PageId::kGroups, "groups"},
    {"demo.educator", PageId::kStandards, "standards"},
    {"demo.educator", PageId::kNorms, "norms"},
    {"demo.educator", PageId::kAttempts, "attempts"},
    {"demo.educator", PageId::kRatings, "ratings"},
    {"ada", PageId::kPeople, "people"},
    {"ada", PageId::kAdmissions, "admissions"},
    {"ada", PageId::kHealth, "health"},
    {"ada", PageId::kAudit, "audit"},
};

}  // namespace

class ShellAccessTest : public QObject {
    Q_OBJECT

 private Q_SLOTS:
    void initTestCase();
    void cleanupTestCase() { shell_.reset(); }
    void textStandsOutInBothThemes();
    void disabledTextIsOfTheSecondaryColour();
    void whatIsWrongIsFramedUnlikeTheFocus();
    void theFocusIsSeenOnEverythingThatTakesIt();
    void everythingIsNamedAndLargeEnough();
    void tabGoesThroughThePageAndOutAgain();

 private:
    [[nodiscard]] bool visit(const Visit& visit);
    std::unique_ptr<ShellHarness> shell_;
};

bool ShellAccessTest::visit(const Visit& visit) {
    const bool there =
        shell_->context().signedIn() && shell_->context().user().login == visit.login;
    const QString password = QString(visit.login) == "ada" ? "correct horse" : kPassword;
    if (!there && !shell_->signIn(visit.login, password)) return false;
    shell_->window().open({visit.page, 0, {}, {}});
    return shell_->arrives(visit.page);
}

void ShellAccessTest::initTestCase() {
    shell_ = std::make_unique<ShellHarness>();
    QVERIFY(shell_->setUpWithDemonstration());
}

void ShellAccessTest::textStandsOutInBothThemes() {
    for (const ThemeKind theme : {ThemeKind::kLight, ThemeKind::kDark}) {
        const Tokens& t = tokens(theme);
        for (const QColor& ground : {t.surface, t.raised})
            for (const QColor& text : {t.text, t.muted, t.accent, t.good, t.warn, t.critical})
                QVERIFY2(contrast(text, ground) >= 4.5,
                         qPrintable(QString("%1 on %2: %3")
                                        .arg(text.name(), ground.name())
                                        .arg(contrast(text, ground))));
        // Secondary text and what is disabled, on every ground that they stand on: a button that is
        // off has the colour of the line, a badge that of the pointer, a banner a soft one.
        for (const QColor& ground :
             {t.hover, t.line, t.accent_soft, t.good_soft, t.warn_soft, t.critical_soft})
            for (const QColor& text : {t.text, t.muted})
                QVERIFY2(contrast(text, ground) >= 4.5,
                         qPrintable(QString("%1 on %2: %3")
                                        .arg(text.name(), ground.name())
                                        .arg(contrast(text, ground))));
        // The ring of the focus, on whatever it is drawn: WCAG 1.4.11.
        for (const QColor& ground : {t.surface, t.raised, t.hover, t.line, t.accent_soft})
            QVERIFY2(contrast(t.accent, ground) >= 3, qPrintable(ground.name()));
        const std::pair<QColor, QColor> pairs[]{
            {t.on_accent, t.accent},       {t.good, t.good_soft},     {t.warn, t.warn_soft},
            {t.critical, t.critical_soft}, {t.accent, t.accent_soft}, {t.text, t.hover}};
        for (const auto& [text, ground] : pairs)
            QVERIFY2(contrast(text, ground) >= 4.5, qPrintable(QString("%1 on %2: %3")
                                                                   .arg(text.name(), ground.name())
                                                                   .arg(contrast(text, ground))));
        // Good, doubtful and bad also to who lacks a cone; words and signs say it as well.
        for (const test::Vision& vision : test::kVisions)
            QVERIFY2(test::closest({t.good, t.warn, t.critical}, vision.seen) >= test::kToldApart,
                     vision.name);
        // The edge of a field: WCAG 1.4.11.
        QVERIFY2(contrast(t.field, t.raised) >= 3, qPrintable(t.field.name()));
    }
}

// The contrast above is that of what is drawn.
void ShellAccessTest::disabledTextIsOfTheSecondaryColour() {
    for (const ThemeKind theme : {ThemeKind::kDark, ThemeKind::kLight}) {
        shell_->context().setTheme(theme);
        const Tokens& t = tokens(theme);
        for (const QPalette::ColorRole role :
             {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
            QCOMPARE(QApplication::palette().color(QPalette::Disabled, role), t.muted);
        QCOMPARE(QApplication::palette().color(QPalette::PlaceholderText), t.muted);
    }
}

// `outline: none` takes Qt's own ring away: a line of an analogue scale had none at all.
void ShellAccessTest::theFocusIsSeenOnEverythingThatTakesIt() {
    // What a page may hold and Tab reaches. Each has a rule of its own for the focus, or one of
    // what it derives from.
    const std::map<QString, QString> known{
        {"QPushButton", "QPushButton:focus"},   {"QToolButton", "QToolButton:focus"},
        {"QLineEdit", "QLineEdit:focus"},       {"QComboBox", "QComboBox:focus"},
        {"QSpinBox", "QSpinBox:focus"},         {"QDoubleSpinBox", "QDoubleSpinBox:focus"},
        {"QDateEdit", "QDateEdit:focus"},       {"QPlainTextEdit", "QPlainTextEdit:focus"},
        {"QCheckBox", "QCheckBox:focus"},       {"QRadioButton", "QRadioButton:focus"},
        {"QSlider", "QSlider:focus"},           {"QListWidget", "QListWidget:focus"},
        {"QTableWidget", "QTableWidget:focus"}, {"QTextBrowser", "QTextBrowser:focus"}};
    const QString sheet = qApp->styleSheet();
    for (const auto& [name, rule] : known) QVERIFY2(sheet.contains(rule), qPrintable(rule));
    QStringList wrong;
    for (const Visit& each : kVisits) {
        QVERIFY2(visit(each), each.name);
        QTest::qWait(40);
        for (const QWidget* widget : shell_->window().findChildren<QWidget*>()) {
            if (!widget->isVisible() || (widget->focusPolicy() & Qt::TabFocus) == 0) continue;
            bool seen = qobject_cast<const QScrollArea*>(widget) != nullptr;
            for (const auto& [name, rule] : known)
                seen = seen || widget->inherits(qPrintable(name));
            if (!seen)
                wrong << QString("%1: %2 \"%3\"")
                             .arg(each.name, widget->metaObject()->className(),
                                  widget->objectName());
        }
    }
    wrong.removeDuplicates();
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join("\n")));
    // A rule that comes later must not take the frame of the focus away again.
    for (const char* rule : {"QPushButton[role=\"danger\"]:focus { border: 2px solid ",
                             "QPlainTextEdit[role=\"details\"]:focus"})
        QVERIFY2(sheet.contains(rule), rule);
}

// A missing answer in the colour of the focus looked like the question to go on with.
void ShellAccessTest::whatIsWrongIsFramedUnlikeTheFocus() {
    for (const ThemeKind theme : {ThemeKind::kDark, ThemeKind::kLight}) {
        shell_->context().setTheme(theme);
        const Tokens& t = tokens(theme);
        const int apart = std::abs(t.critical.hue() - t.accent.hue());
        QVERIFY(std::min(apart, 360 - apart) > 90);
        QWidget page;
        auto* card = new QFrame(&page);
        card->setProperty("role", "card");
        auto* field = new QLineEdit(&page);
        field->move(0, 100);
        for (QWidget* wrong : {static_cast<QWidget*>(card), static_cast<QWidget*>(field)}) {
            wrong->setProperty("tone", "critical");
            wrong->resize(200, 60);
        }
        page.resize(220, 180);
        const QImage seen = page.grab().toImage();
        for (const QWidget* wrong : {static_cast<QWidget*>(card), static_cast<QWidget*>(field)}) {
            const QColor frame = seen.pixelColor(wrong->x() + 100, wrong->y());
            QVERIFY2(frame == t.critical, qPrintable(frame.name() + " is not the colour of what "
                                                                    "is wrong"));
        }
    }
}

void ShellAccessTest::everythingIsNamedAndLargeEnough() {
    QStringList wrong;
    for (const Visit& each : kVisits) {
        QVERIFY2(visit(each), each.name);
        // 1920 x 1080 at 200 %, and a small station.
        for (const QSize size : {QSize(960, 540), QSize(1366, 768)}) {
            shell_->window().resize(size);
            QTest::qWait(40);
            if (!shell_->fits())
                wrong << QString("%1: cut off at %2").arg(each.name).arg(size.width());
        }
        shell_->whole(QString("90_%1_960").arg(each.name));
        for (const QWidget* widget : shell_->window().findChildren<QWidget*>()) {
            if (!widget->isVisible() || !widget->isEnabled() ||
                (widget->focusPolicy() & Qt::TabFocus) == 0)
                continue;
            const auto* button = qobject_cast<const QAbstractButton*>(widget);
            const bool field = qobject_cast<const QLineEdit*>(widget) != nullptr ||
                               qobject_cast<const QComboBox*>(widget) != nullptr ||
                               qobject_cast<const QAbstractSpinBox*>(widget) != nullptr;
            const bool table = qobject_cast<const QTableWidget*>(widget) != nullptr;
            if (button == nullptr && !field && !table) continue;
            // Inside a spin box or an editable list stands a line without a name of its own.
            const QWidget* above = widget->parentWidget();
            if (qobject_cast<const QAbstractSpinBox*>(above) != nullptr ||
                qobject_cast<const QComboBox*>(above) != nullptr)
                continue;
            const QString said = !widget->accessibleName().isEmpty() ? widget->accessibleName()
                                 : button != nullptr                 ? button->text()
                                                                     : QString();
            const QString what =
                QString("%1: %2 %3")
                    .arg(each.name, widget->metaObject()->className(), widget->objectName());
            if (said.trimmed().isEmpty()) wrong << what + " has no name";
            if (!table && widget->height() < 40)
                wrong << what + QString(" is %1 px high").arg(widget->height());
        }
    }
    wrong.removeDuplicates();
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join("\n")));
}

void ShellAccessTest::tabGoesThroughThePageAndOutAgain() {
    QVERIFY(visit({"demo.educator", PageId::kCourseEditor, ""}));
    QTest::qWait(100);  // A new page is shown by the event loop.
    // The chain that Tab walks; without a window manager no window is active and no key arrives.
    QWidget* first = shell_->find<QLineEdit>("title_en");
    QVERIFY(first != nullptr);
    QSet<QString> seen{first->objectName()};
    QWidget* next = first->nextInFocusChain();
    for (int i = 0; i < 2000 && next != first; ++i, next = next->nextInFocusChain()) {
        QVERIFY(next != nullptr);
        if (next->isVisible() && (next->focusPolicy() & Qt::TabFocus) != 0)
            seen << next->objectName();
    }
    QCOMPARE(next, first);
    for (const char* name : {"title_en", "course_id", "add_stage", "stage_list", "publish_reason",
                             "rail_courses", "switch_user"})
        QVERIFY2(seen.contains(name), name);
}

}  // namespace placode::ui

int main(int argc, char** argv) {
    placode::ui::prepare_display();
    QApplication application(argc, argv);
    placode::ui::ShellAccessTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "shell_access_test.moc"
