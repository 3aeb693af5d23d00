// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Keys and buttons of the simulator are a person's choice: changed with the keyboard alone, kept
// for that person, named by the page of a task and given to the simulator.

#include "haptics/control_layout.h"

#include <QApplication>
#include <QCheckBox>

#include "shell_harness.h"
#include "ui/shell/controls_card.h"
#include "ui/shell/key_button.h"

namespace placode::ui {

class ShellControlsTest : public QObject {
    Q_OBJECT

 private Q_SLOTS:
    void initTestCase();
    void cleanupTestCase() { shell_.reset(); }

    void thePageOfATaskLeadsThere();
    void aKeyIsChosenWithTheKeyboardAlone();
    void twoThingsNeverShareAKey();
    void escapeAndKeysOfTheProgramAreRefused();
    void theLeftHandedLayoutIsOneClick();
    void itIsNamedOnThePageOfATaskAndGivenToTheSimulator();
    void anotherPersonHasAnother();
    void whatCannotBeReadIsAsDelivered();

 private:
    [[nodiscard]] KeyButton* key(const char* name) const {
        return shell_->find<KeyButton>(QString("key_") + name);
    }
    /// Presses the button with Enter and then a key.
    void choose(const char* name, int pressed) {
        key(name)->setFocus();
        QTest::keyClick(key(name), Qt::Key_Return);
        QTest::keyClick(key(name), static_cast<Qt::Key>(pressed));
    }
    [[nodiscard]] bool opens() {
        Q_EMIT shell_->window().page()->go({PageId::kAccount, 0, "controls", {}});
        return shell_->arrives(PageId::kAccount) && key("cut") != nullptr;
    }

    std::unique_ptr<ShellHarness> shell_;
};

void ShellControlsTest::initTestCase() {
    shell_ = std::make_unique<ShellHarness>();
    QVERIFY(shell_->setUpWithDemonstration());
    QVERIFY(shell_->signIn("demo.trainee", "placode-demo"));
}

void ShellControlsTest::thePageOfATaskLeadsThere() {
    Q_EMIT shell_->window().page()->go({PageId::kTask, 0, "touch_targets", {}});
    QVERIFY(shell_->arrives(PageId::kTask));
    QVERIFY(shell_->choose("device", "mouse"));
    QVERIFY(shell_->click("change_controls"));
    QVERIFY(shell_->arrives(PageId::kAccount));
    QVERIFY(QTest::qWaitFor([&] {
        const QWidget* card = shell_->find<QWidget>("controls_card");
        return card != nullptr && !card->visibleRegion().isEmpty() &&
               shell_->window().focusWidget() != nullptr &&
               card->isAncestorOf(shell_->window().focusWidget());
    }));
    QVERIFY(shell_->fits());
    shell_->shot("controls_card");
    QCOMPARE(key("cut")->text(), QString("X"));
    QCOMPARE(key("cut")->accessibleName(), QString("Cut, close the jaws: X"));
}

void ShellControlsTest::aKeyIsChosenWithTheKeyboardAlone() {
    key("cut")->setFocus();
    QTest::keyClick(key("cut"), Qt::Key_Space);
    QVERIFY(key("cut")->waiting());
    QCOMPARE(key("cut")->text(), QString("Press a key…"));
    QTest::keyClick(key("cut"), Qt::Key_G);
    QVERIFY(!key("cut")->waiting());
    QCOMPARE(key("cut")->text(), QString("G"));
    QVERIFY(shell_->text("controls_said").contains("G"));
    // The very keys that move and press in a page are taken as well.
    choose("cut", Qt::Key_Tab);
    QCOMPARE(key("cut")->text(), QString("Tab"));
    QCOMPARE(key("next")->text(), QString("G"));
    QVERIFY(!key("next")->waiting());
    choose("cut", Qt::Key_Space);
    QCOMPARE(key("cut")->text(), QString("Space"));
    QVERIFY(!key("cut")->waiting());
    QVERIFY(shell_->click("layout_usual"));
    QCOMPARE(own_layout(shell_->context()), haptics::ControlLayout());
}

void ShellControlsTest::twoThingsNeverShareAKey() {
    choose("cut", Qt::Key_F);
    QCOMPARE(key("cut")->text(), QString("F"));
    QCOMPARE(key("deeper")->text(), QString("X"));
    QVERIFY2(shell_->text("controls_said").contains("Go deeper, which was there, got X"),
             qPrintable(shell_->text("controls_said")));
    QVERIFY(own_layout(shell_->context()).text() == "deeper=X cut=F");
    QVERIFY(shell_->click("layout_usual"));
}

void ShellControlsTest::escapeAndKeysOfTheProgramAreRefused() {
    choose("cut", Qt::Key_Escape);
    QCOMPARE(key("cut")->text(), QString("X"));
    for (const int refused : {static_cast<int>(Qt::Key_Return), static_cast<int>(Qt::Key_F1),
                              static_cast<int>(Qt::Key_1), static_cast<int>(Qt::Key_Plus)}) {
        choose("cut", refused);
        QCOMPARE(key("cut")->text(), QString("X"));
        QVERIFY(shell_->text("controls_said").contains("cannot be chosen"));
        QVERIFY(shell_->window().current() == PageId::kAccount);
    }
    // Somebody who presses elsewhere does not want to choose.
    QTest::keyClick(key("cut"), Qt::Key_Return);
    QVERIFY(key("cut")->waiting());
    key("deeper")->setFocus();
    QVERIFY(!key("cut")->waiting() || !shell_->window().isActiveWindow());
}

void ShellControlsTest::theLeftHandedLayoutIsOneClick() {
    QVERIFY(shell_->click("layout_left"));
    QCOMPARE(key("left")->text(), QString("J"));
    QVERIFY(shell_->find<QCheckBox>("exchange_buttons")->isChecked());
    QVERIFY(!shell_->find<QPushButton>("layout_left")->isEnabled());
    shell_->scrollTo("controls_card");
    shell_->shot("controls_card_left");
    shell_->start();  // the next day
    QVERIFY(shell_->signIn("demo.trainee", "placode-demo"));
    QVERIFY(own_layout(shell_->context()) == haptics::ControlLayout::left_handed());
}

void ShellControlsTest::itIsNamedOnThePageOfATaskAndGivenToTheSimulator() {
    Q_EMIT shell_->window().page()->go({PageId::kTask, 0, "trace_contour", {}});
    QVERIFY(shell_->arrives(PageId::kTask));
    QVERIFY(shell_->choose("device", "keyboard"));
    QVERIFY2(shell_->text("controls").contains("J, L, I, K"), qPrintable(shell_->text("controls")));
    QVERIFY(shell_->choose("device", "mouse"));
    QVERIFY(shell_->text("controls").contains("hold the right button, or N"));
    AttemptOrder order;
    order.task = "trace_contour";
    order.device = "mouse";
    order.recording_file = "x.placode";
    order.controls = QString::fromStdString(own_layout(shell_->context()).text());
    const QStringList arguments = simulator_arguments(order, {});
    const qsizetype at = arguments.indexOf("--controls");
    QVERIFY(at >= 0);
    QCOMPARE(arguments.value(at + 1), QString("left-handed"));
}

void ShellControlsTest::anotherPersonHasAnother() {
    QVERIFY(shell_->signIn("demo.educator", "placode-demo"));
    QVERIFY(own_layout(shell_->context()) == haptics::ControlLayout());
}

void ShellControlsTest::whatCannotBeReadIsAsDelivered() {
    AppContext& context = shell_->context();
    QVERIFY(opens());
    choose("cut", Qt::Key_G);
    const QString name = "controls/" + QString::number(context.user().id);
    QCOMPARE(context.storeSetting(name).toString(), QString("cut=G"));
    context.setStoreSetting(name, "cut=Nonsense");
    QVERIFY(own_layout(context) == haptics::ControlLayout());
}

}  // namespace placode::ui

int main(int argc, char** argv) {
    placode::ui::prepare_display();
    QApplication application(argc, argv);
    placode::ui::ShellControlsTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "shell_controls_test.moc"
