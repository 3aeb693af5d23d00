// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A replay's window stands where it hides neither its controls nor the time line.

#include "ui/shell/replay_place.h"

#include <QApplication>
#include <QScreen>

#include "shell_harness.h"

namespace placode::ui {

class ShellReplayPlaceTest : public QObject {
    Q_OBJECT

 private Q_SLOTS:
    void aReplayGoesBesideItsControls();
    void aReplayLeavesTheTimeLineInSight();
};

void ShellReplayPlaceTest::aReplayGoesBesideItsControls() {
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

void ShellReplayPlaceTest::aReplayLeavesTheTimeLineInSight() {
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
    placode::ui::ShellReplayPlaceTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "shell_replay_place_test.moc"
