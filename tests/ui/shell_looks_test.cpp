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

namespace placode::ui {

namespace {

constexpr int kIcon = 20;  ///< [px], as in the rail.
/// Likeness of two icons above which people took one for the other. Tried: a clipboard with ticks
/// beside a sheet with ticks had 0.75, two bell curves 0.74, two grids 0.91; what is kept now has
/// at most 0.67.
constexpr double kTwins = 0.71;

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

 private:
    std::unique_ptr<ShellHarness> shell_;
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

}  // namespace placode::ui

int main(int argc, char** argv) {
    placode::ui::prepare_display();
    QApplication application(argc, argv);
    placode::ui::ShellLooksTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "shell_looks_test.moc"
