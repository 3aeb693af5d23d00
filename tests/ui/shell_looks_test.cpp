// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What the eye needs: pages of the narrow rail that are told apart by their icons alone, and a
// focus that is seen on everything that takes it.

#include <QApplication>
#include <QImage>
#include <QPainter>
#include <cmath>
#include <map>
#include <vector>

#include "shell_harness.h"
#include "ui/shell/parts.h"

namespace placode::ui {

namespace {

constexpr int kIcon = 20;  ///< [px], as in the rail.
/// Likeness of two icons above which people took one for the other. Tried: a clipboard with ticks
/// beside a sheet with ticks had 0.75, two bell curves 0.74, two grids 0.91; what is kept now has
/// at most 0.67.
constexpr double kTwins = 0.71;
constexpr const char* kLongName = "Aleksandra Maria Konstantynopolska-Wierzbicka";

/// Ink of an icon at every pixel and its neighbours, less the mean of all: what is seen at a
/// glance.
std::vector<double> glance(const QString& icon) {
    QImage picture(kIcon, kIcon, QImage::Format_ARGB32_Premultiplied);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    line_icon(icon, Qt::black).paint(&painter, picture.rect());
    painter.end();
    std::vector<double> ink;
    double sum = 0;
    for (int y = 0; y < kIcon; ++y)
        for (int x = 0; x < kIcon; ++x) {
            double near = 0;
            for (int v = std::max(0, y - 1); v <= std::min(kIcon - 1, y + 1); ++v)
                for (int u = std::max(0, x - 1); u <= std::min(kIcon - 1, x + 1); ++u)
                    near += qAlpha(picture.pixel(u, v));
            ink.push_back(near);
            sum += near;
        }
    for (double& each : ink) each -= sum / (kIcon * kIcon);
    return ink;
}

/// Correlation of two glances: 1 = the same.
double likeness(const std::vector<double>& a, const std::vector<double>& b) {
    double ab = 0, aa = 0, bb = 0;
    for (size_t i = 0; i < a.size(); ++i) {
        ab += a[i] * b[i];
        aa += a[i] * a[i];
        bb += b[i] * b[i];
    }
    return ab / std::sqrt(aa * bb);
}

}  // namespace

class ShellLooksTest : public QObject {
    Q_OBJECT

 private Q_SLOTS:
    void initTestCase();
    void cleanupTestCase() { shell_.reset(); }
    void noTwoIconsOfTheRailLookAlike();
    void aColumnIsAsWideAsItsLongestName();
    void whatIsCutInATableIsWholeInItsToolTip();

 private:
    void lookAtTables(const char* page, QStringList& wrong);

    std::unique_ptr<ShellHarness> shell_;
    int cut_ = 0;  ///< Texts that had no room.
};

void ShellLooksTest::initTestCase() {
    shell_ = std::make_unique<ShellHarness>();
    QVERIFY(shell_->setUpWithDemonstration());
}

void ShellLooksTest::noTwoIconsOfTheRailLookAlike() {
    std::map<QString, std::vector<double>> icons;
    for (const char* login : {"demo.trainee", "demo.educator", "demo.coordinator", "ada"}) {
        const bool ada = QString(login) == "ada";
        QVERIFY(shell_->signIn(login, ada ? "correct horse" : "placode-demo"));
        for (const QToolButton* button : shell_->window().findChildren<QToolButton*>())
            if (button->objectName().startsWith("rail_"))
                icons[button->objectName().mid(5)] = glance(button->objectName().mid(5));
    }
    QVERIFY2(icons.size() >= 16, qPrintable(QString::number(icons.size())));
    QStringList twins;
    for (auto a = icons.begin(); a != icons.end(); ++a)
        for (auto b = std::next(a); b != icons.end(); ++b)
            if (const double alike = likeness(a->second, b->second); alike > kTwins)
                twins << QString("%1 and %2: %3").arg(a->first, b->first).arg(alike);
    QVERIFY2(twins.isEmpty(), qPrintable(twins.join("; ")));
}

// The first fifty rows told how wide a column is: a name further down was cut beside empty room.
void ShellLooksTest::aColumnIsAsWideAsItsLongestName() {
    constexpr int kRows = 300, kLongRow = 250;
    QTableWidget* table = make_table({"Name", "Remark"}, "People");
    table->setSortingEnabled(false);
    table->setRowCount(kRows);
    for (int row = 0; row < kRows; ++row) {
        table->setItem(row, 0, make_cell(row == kLongRow ? kLongName : "Ann"));
        table->setItem(row, 1, make_cell("-"));
    }
    fit_columns(table, 1);
    const std::unique_ptr<QWidget> shown(table);
    table->resize(1000, 400);
    table->show();
    QTest::qWait(50);
    const int needed = table->fontMetrics().horizontalAdvance(kLongName);
    QVERIFY2(table->columnWidth(0) >= needed,
             qPrintable(QString("%1 of %2 px").arg(table->columnWidth(0)).arg(needed)));
}

void ShellLooksTest::lookAtTables(const char* page, QStringList& wrong) {
    for (const QTableWidget* table : shell_->window().page()->findChildren<QTableWidget*>()) {
        if (!table->isVisible() || table->wordWrap()) continue;
        for (int row = 0; row < table->rowCount(); ++row)
            for (int c = 0; c < table->columnCount(); ++c) {
                const QTableWidgetItem* item = table->item(row, c);
                if (item == nullptr || table->isColumnHidden(c)) continue;
                const QString text = item->text();
                if (table->fontMetrics().horizontalAdvance(text) <= table->columnWidth(c) - 18)
                    continue;
                ++cut_;
                if (!item->toolTip().contains(text) || table->textElideMode() != Qt::ElideMiddle)
                    wrong << QString("%1, %2: \"%3\"").arg(page, table->objectName(), text);
            }
    }
}

void ShellLooksTest::whatIsCutInATableIsWholeInItsToolTip() {
    db::Store& store = shell_->owner();
    store.act_as("ada");
    const int64_t group =
        store.groups().create("Those around Aleksandra Maria Konstantynopolska-Wierzbicka");
    const int64_t person = store.accounts().create(
        {"a.log-in.name.of.forty.letters.as.some.have", kLongName, "first password",
         static_cast<db::Roles>(db::Role::kTrainee), true});
    store.groups().set_role(group, person, db::GroupRole::kMember);
    db::AttemptResult result;
    result.header.task_id = "diathermy_ring_small";
    result.header.task_version = 1;
    result.header.device = "mouse";
    result.header.demonstration = true;
    result.header.started_utc = "2026-03-01T10:00:00Z";
    result.end.reason = sim::EndReason::kFinished;
    result.score.rubric_id = "ring_incision";
    (void)store.attempts().save(person, result);
    struct Look {
        const char *login, *name;
        PageId page;
    };
    constexpr Look kLooks[]{{"ada", "people", PageId::kPeople},
                            {"ada", "audit", PageId::kAudit},
                            {"ada", "groups", PageId::kGroups},
                            {"demo.educator", "attempts", PageId::kAttempts},
                            {"demo.educator", "courses", PageId::kCourses},
                            {"demo.coordinator", "studies", PageId::kStudies},
                            {"demo.coordinator", "data", PageId::kStudyData}};
    QStringList wrong;
    for (const Look& look : kLooks) {
        QVERIFY(shell_->signIn(look.login,
                               QString(look.login) == "ada" ? "correct horse" : "placode-demo"));
        for (const char* language : {"pl", "en"})
            for (const QSize size : {QSize(960, 540), QSize(1366, 768)}) {
                shell_->context().setLanguage(language);
                shell_->window().resize(size);
                shell_->window().open({look.page, 0, {}, {}});
                QVERIFY2(shell_->arrives(look.page), look.name);
                QTest::qWait(60);
                lookAtTables(look.name, wrong);
                if (!shell_->fits())
                    wrong << QString("%1 in %2 scrolls sideways at %3 px")
                                 .arg(look.name, language)
                                 .arg(size.width());
            }
    }
    wrong.removeDuplicates();
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join("\n")));
    QVERIFY2(cut_ > 0, "names of forty letters have room nowhere in a narrow window");
}

}  // namespace placode::ui

int main(int argc, char** argv) {
    placode::ui::prepare_display();
    QApplication application(argc, argv);
    placode::ui::ShellLooksTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "shell_looks_test.moc"
