// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The page of devices through the real window and the real placode-sim, with a stand-in for the
// Inverse service and a pipe for the pedals. No hardware.

#include <fcntl.h>
#include <linux/input.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QApplication>
#include <cmath>

#include "haptics/gamepad_search.h"
#include "haptics/station.h"
#include "shell_harness.h"
#include "tests/stand_in/haply_service.h"
#include "ui/shell/details.h"

namespace placode::ui {

namespace {
/// For what a busy machine with two cores does slowly.
constexpr int kPatienceMs = 60000;
}  // namespace

class ShellDevicesTest : public QObject {
    Q_OBJECT

 private Q_SLOTS:
    void initTestCase();
    void cleanupTestCase() { shell_.reset(); }

    void pageSaysWhatIsThereAndWhatIsMissing();
    void deviceIsTriedLive();
    void armThatIsNotCalibratedIsShownAsSuch();
    void forceTestBeginsWithHalfANewtonAndIsSaved();
    void forceThatIsWrongLowersTheLimit();
    void rightHandIsFoundAndSwapped();
    void pedalsAreMapped();
    void settingsAreCheckedAndSaved();
    void tryingKeepsWhatIsNotSaved();
    void pageIsInPolishAndFits();
    void traineeHasNoSuchPage();

 private:
    [[nodiscard]] haptics::Station station() const { return haptics::Station::of_this_computer(); }
    [[nodiscard]] bool waits(const std::function<bool()>& until) {
        return QTest::qWaitFor(until, kPatienceMs);
    }
    [[nodiscard]] bool saysIn(const QString& label, const QString& words) {
        return waits([&] { return shell_->text(label).contains(words); });
    }
    /// Moves the first arm up or down (the device's z) until it is there, in small steps.
    [[nodiscard]] bool lower(double to_m);
    /// True when nothing of the page is squeezed any more: arms come when the device answers.
    [[nodiscard]] bool settles() {
        return waits([&] {
            const QWidget* card = shell_->find<QWidget>("trial_card");
            const auto* area = shell_->window().page()->findChild<QScrollArea*>();
            return card != nullptr && card->height() >= card->minimumSizeHint().height() &&
                   area->widget()->height() >= area->widget()->minimumSizeHint().height();
        });
    }
    /// Both themes, with the trial running.
    void shots(const QString& name);

    test::HaplyService service_;
    std::unique_ptr<ShellHarness> shell_;
};

void ShellDevicesTest::initTestCase() {
    shell_ = std::make_unique<ShellHarness>();
    const QString file = shell_->path("station.conf");
    qputenv("PLACODE_STATION", file.toUtf8());
    QFile out(file);
    QVERIFY(out.open(QIODevice::WriteOnly));
    out.write(QString("# bench 1\nhaply.port = %1\nhaply.right = A\nhaply.left = B\n")
                  .arg(service_.port())
                  .toUtf8());
    out.close();
    service_.change([](auto& s) {
        s.arms.resize(2);
        s.arms[0].id = "A";
        s.arms[1].id = "B";
        s.arms[0].handedness = s.arms[1].handedness = "";
    });
    QVERIFY(shell_->setUpWithDemonstration());
    QVERIFY(shell_->signIn("ada", "correct horse"));
    QVERIFY(shell_->click("rail_devices"));
    QVERIFY(shell_->arrives(PageId::kDevices));
}

bool ShellDevicesTest::lower(double to_m) {
    double z = 0;
    service_.change([&](auto& s) { z = s.arms[0].position[2]; });
    while (std::abs(z - to_m) > 1e-9) {
        z = z > to_m ? std::max(to_m, z - 0.0005) : std::min(to_m, z + 0.0005);
        service_.change([&](auto& s) { s.arms[0].position[2] = z; });
        const int seen = service_.messages;
        if (!waits([&] { return service_.messages > seen + 2; })) return false;
    }
    return true;
}

void ShellDevicesTest::shots(const QString& name) {
    for (const ThemeKind theme : {ThemeKind::kDark, ThemeKind::kLight}) {
        shell_->context().setTheme(theme);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QVERIFY(saysIn("arm_status_0", "ready"));
        QVERIFY(settles());
        auto* inside = shell_->window().page()->findChild<QScrollArea*>()->widget();
        shell_->keep(inside->grab(), name + (theme == ThemeKind::kDark ? "_dark" : "_light"));
    }
}

void ShellDevicesTest::pageSaysWhatIsThereAndWhatIsMissing() {
    QVERIFY(waits([&] { return shell_->find<QWidget>("device_haply") != nullptr; }));
    QCOMPARE(shell_->text("detail_haply"), "Haply Inverse3 A, Haply Inverse3 B");
    // User words in sight, the driver's own behind "Details".
    QVERIFY(shell_->text("detail_openhaptics").contains("have to be installed"));
    QVERIFY(!shell_->text("detail_openhaptics").contains("libHD"));
    auto* details = shell_->find<Details>("details_openhaptics");
    QVERIFY(details->text().contains("libHD.so"));
    QVERIFY(details->text().contains("nstall"));
    QVERIFY(!details->isOpen());
    QVERIFY(shell_->text("detail_avatar").contains("switch it on"));
    QVERIFY(shell_->find<Details>("details_avatar")->text().contains("/dev/ttyACM0"));
    // The truth about the gamepad, too.
    const bool pad = !haptics::look_for_gamepads().found.empty();
    QCOMPARE(shell_->find<Details>("details_gamepad") == nullptr, pad);
    QVERIFY(shell_->find<QPushButton>("try_haply") != nullptr);
    QVERIFY(shell_->find<QPushButton>("try_openhaptics") == nullptr);
    QVERIFY(shell_->text("tested").contains("No force test"));
    shell_->whole("90_devices");
}

void ShellDevicesTest::deviceIsTriedLive() {
    QVERIFY(waits([&] { return shell_->find<QPushButton>("try_haply") != nullptr; }));
    QVERIFY(shell_->click("try_haply"));
    QVERIFY(saysIn("arm_status_0", "ready"));
    QVERIFY(saysIn("arm_status_1", "ready"));
    QCOMPARE(shell_->text("arm_name_0"), "Right hand: Haply Inverse3 A");
    QCOMPARE(shell_->text("arm_name_1"), "Left hand: Haply Inverse3 B");
    QVERIFY(shell_->text("calibration_guide").contains("Inverse service"));
    QVERIFY(saysIn("trial_loop", "Force at most 0.5 N, stiffness 100 N/m."));
    service_.change([](auto& s) {
        s.grip =
            R"({"device_id":"61576","state":{"orientation":{"w":1,"x":0,"y":0,"z":0},"buttons":{"a":true}}})";
    });
    QVERIFY(saysIn("arm_keys_0", "button 1"));
    service_.change([](auto& s) { s.grip.clear(); });
    shots("91_devices_tried");
}

void ShellDevicesTest::armThatIsNotCalibratedIsShownAsSuch() {
    service_.change([](auto& s) { s.arms[1].calibrated = false; });
    QVERIFY(saysIn("arm_status_1", "not calibrated"));
    service_.change([](auto& s) { s.arms[1].calibrated = true; });
    QVERIFY(saysIn("arm_status_1", "ready"));
    service_.change([](auto& s) { s.silent = true; });
    QVERIFY(saysIn("arm_status_0", "lost"));
    service_.change([](auto& s) { s.silent = false; });
    QVERIFY(saysIn("arm_status_0", "ready"));
}

void ShellDevicesTest::forceTestBeginsWithHalfANewtonAndIsSaved() {
    QVERIFY(shell_->text("force_text").contains("0.5 N"));
    // What nobody can have felt yet can be wrong already, but not good.
    const auto can = [&](const char* name) { return shell_->find<QPushButton>(name)->isEnabled(); };
    QVERIFY(waits([&] { return can("force_bad"); }));
    QVERIFY(!can("force_good"));
    QVERIFY(shell_->find<QLabel>("floor_first")->isVisible());
    QVERIFY(shell_->click("floor"));
    QVERIFY(
        waits([&] { return shell_->find<QPushButton>("floor")->text() == "Take the floor away"; }));
    QVERIFY(can("force_good"));
    QVERIFY(!shell_->find<QLabel>("floor_first")->isVisible());
    QVERIFY(lower(-0.025));
    QVERIFY(waits([&] { return std::abs(service_.force(0)[2] - 0.5) < 0.005; }));
    // As it is now: in the other theme the page would begin its test anew.
    shell_->keep(shell_->window().page()->findChild<QScrollArea*>()->widget()->grab(),
                 "92_devices_floor");
    QVERIFY(shell_->click("force_good"));
    QVERIFY(shell_->bannerSays("0.5 N passed and saved; now 1.0 N"));
    QCOMPARE(station().number("tested.force_n"), 0.5);
    QCOMPARE(station().text("tested.device"), std::string("haply"));
    QVERIFY(saysIn("trial_loop", "Force at most 1.0 N, stiffness 300 N/m."));
    QVERIFY(waits([&] { return can("force_bad"); }));
    QVERIFY2(!can("force_good"), "the next force has a floor of its own");
    QVERIFY(shell_->text("tested").contains("0.5 N"));
    QVERIFY(lower(0));
}

void ShellDevicesTest::forceThatIsWrongLowersTheLimit() {
    QVERIFY(saysIn("arm_status_0", "ready"));
    QVERIFY(shell_->click("force_bad"));
    QVERIFY(shell_->bannerSays("limited to 0.50 N"));
    QCOMPARE(station().number("limit.force_n"), 0.5);
    QCOMPARE(station().number("tested.force_n"), 0.0);
    QVERIFY(saysIn("trial_loop", "Force at most 0.5 N"));
    // Half of what the computer allows, where that is less than the level: it never gets more.
    for (const double limit : {0.25, 0.125}) {
        QVERIFY(waits([&] { return shell_->find<QPushButton>("force_bad")->isEnabled(); }));
        QVERIFY(shell_->click("force_bad"));
        QVERIFY(waits([&] { return station().number("limit.force_n") == limit; }));
    }
}

void ShellDevicesTest::rightHandIsFoundAndSwapped() {
    QVERIFY(saysIn("arm_status_1", "ready"));
    QVERIFY(shell_->click("identify"));
    QVERIFY(saysIn("hand_text", "Move the arm in your right hand now"));
    int i = 0;
    QVERIFY(waits([&] {
        service_.change([&](auto& s) { s.arms[1].position[0] = 0.002 * (++i % 2); });
        return shell_->text("hand_text").contains("set as the left one");
    }));
    QVERIFY(shell_->click("swap_hands"));
    QVERIFY(shell_->bannerSays("swapped and saved"));
    QCOMPARE(station().text("haply.right"), std::string("B"));
    QCOMPARE(station().text("haply.left"), std::string("A"));
    QVERIFY(saysIn("arm_name_0", "Right hand: Haply Inverse3 B"));
    service_.change([](auto& s) { s.arms[1].position[0] = 0; });
}

void ShellDevicesTest::pedalsAreMapped() {
    const QString path = shell_->path("pedals");
    QCOMPARE(::mkfifo(path.toUtf8().constData(), 0600), 0);
    const int pipe = ::open(path.toUtf8().constData(), O_RDWR | O_NONBLOCK);
    QVERIFY(pipe >= 0);
    const auto press = [&](uint16_t code, int32_t value) {
        input_event event{};
        event.type = EV_KEY;
        event.code = code;
        event.value = value;
        return ::write(pipe, &event, sizeof event) == static_cast<ssize_t>(sizeof event);
    };
    shell_->find<QComboBox>("pedals")->setCurrentText(path);
    QVERIFY(shell_->click("watch_pedals"));
    QVERIFY(saysIn("pedal_key", "Press a pedal"));
    QVERIFY(press(48, 1));
    QVERIFY(saysIn("pedal_key", "Key 48 (pressed)"));
    QVERIFY(press(48, 0));
    QVERIFY(waits([&] { return shell_->text("pedal_key") == "Key 48"; }));
    QVERIFY(shell_->click("pedal_cut"));
    QVERIFY(shell_->bannerSays("The pedal was saved"));
    QCOMPARE(station().number("pedals.cut_key"), 48.0);
    QCOMPARE(station().text("pedals.device"), path.toStdString());
    QVERIFY(saysIn("pedal_key", "set as the yellow pedal"));
    // The same key cannot be both.
    QVERIFY(shell_->click("pedal_coag"));
    QCOMPARE(station().number("pedals.coag_key"), 48.0);
    QVERIFY(station().number("pedals.cut_key") != 48.0);
    ::close(pipe);
    // Attempts would look for the pipe.
    haptics::Station without = station();
    without.set("pedals.device", "");
    without.save(haptics::Station::path_of_this_computer());
}

void ShellDevicesTest::settingsAreCheckedAndSaved() {
    QVERIFY(shell_->type("key_limit.force_n", "30"));
    QVERIFY(shell_->click("save_station"));
    QVERIFY(shell_->bannerSays("The device cannot be used"));
    QVERIFY(shell_->window().banner().text().contains("expected a number from 0.1 to 10"));
    QCOMPARE(station().number("limit.force_n"), 0.125);
    QVERIFY(shell_->type("key_limit.force_n", "2"));
    QVERIFY(shell_->type("key_arm.mapping", "tip"));
    QVERIFY(shell_->click("save_station"));
    QVERIFY(shell_->bannerSays("Saved for this computer"));
    QCOMPARE(station().number("limit.force_n"), 2.0);
    QCOMPARE(station().text("arm.mapping"), std::string("tip"));
    // User words in sight; the file and its keys stand behind "Details".
    for (const QLabel* label : shell_->window().page()->findChildren<QLabel*>())
        QVERIFY2(!label->text().contains("station.conf") && !label->text().contains("limit.force"),
                 qPrintable(label->text()));
    QCOMPARE(shell_->find<QLineEdit>("key_arm.mapping")->accessibleName(),
             QString("What the arm stands for"));
    const QString raw = shell_->find<Details>("station_details")->text();
    QVERIFY2(raw.contains("station.conf") && raw.contains("limit.force_n = 2"), qPrintable(raw));
    QFile file(shell_->path("station.conf"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY2(file.readAll().startsWith("# bench 1\n"), "what somebody wrote stays");
}

void ShellDevicesTest::tryingKeepsWhatIsNotSaved() {
    const auto typed = [&](const char* key) {
        return shell_->find<QLineEdit>(QString("key_%1").arg(key))->text();
    };
    const double scale = station().number("arm.scale");
    QVERIFY(shell_->type("key_arm.scale", "1.75"));
    QVERIFY(shell_->type("key_haply.force_n", "3.25"));
    QVERIFY(shell_->type("key_limit.force_n", "2.5"));
    QVERIFY(shell_->click("try_haply"));
    for (int again = 0; again < 2; ++again) {
        QVERIFY(saysIn("arm_status_0", "ready"));
        QCOMPARE(typed("arm.scale"), QString("1.75"));
        QCOMPARE(typed("haply.force_n"), QString("3.25"));
        QCOMPARE(typed("limit.force_n"), QString("2.5"));
        QCOMPARE(station().number("arm.scale"), scale);
        // Nor does another language lose it.
        for (const char* language : {"pl", "en"}) {
            shell_->context().setLanguage(language);
            QVERIFY(shell_->arrives(PageId::kDevices));
        }
    }
    // What the force test finds is newer than what stands there unsaved.
    QVERIFY(waits([&] { return shell_->find<QPushButton>("force_bad")->isEnabled(); }));
    QVERIFY(shell_->click("force_bad"));
    QVERIFY(waits([&] { return station().number("limit.force_n") == 0.25; }));
    QVERIFY(waits([&] { return typed("limit.force_n") == "0.25"; }));
    QCOMPARE(typed("arm.scale"), QString("1.75"));
    QVERIFY(shell_->click("save_station"));
    QVERIFY(shell_->bannerSays("Saved for this computer"));
    QCOMPARE(station().number("arm.scale"), 1.75);
    QCOMPARE(station().number("haply.force_n"), 3.25);
    QCOMPARE(station().number("limit.force_n"), 0.25);
    QCOMPARE(typed("arm.scale"), QString("1.75"));
}

void ShellDevicesTest::pageIsInPolishAndFits() {
    for (const QSize size : {QSize(1024, 768), QSize(1920, 1080)}) {
        shell_->window().resize(size);
        QVERIFY(saysIn("arm_status_0", "ready"));
        QTest::qWait(80);
        QVERIFY(shell_->fits());
        shots(QString("93_devices_%1").arg(size.width()));
    }
    shell_->context().setLanguage("pl");
    QVERIFY(shell_->arrives(PageId::kDevices));
    QVERIFY(saysIn("arm_status_0", "gotowe"));
    QVERIFY(shell_->text("force_text").contains("0,5 N"));
    QVERIFY(settles());
    shell_->keep(shell_->window().page()->findChild<QScrollArea*>()->widget()->grab(),
                 "94_devices_polish");
    shell_->context().setLanguage("en");
    QVERIFY(shell_->arrives(PageId::kDevices));
}

void ShellDevicesTest::traineeHasNoSuchPage() {
    QVERIFY(shell_->click("rail_people"));
    QVERIFY(shell_->arrives(PageId::kPeople));
    // The device was let go: the last force is none and the service saw a farewell.
    QVERIFY(waits([&] { return service_.closed_by_client.load(); }));
    QCOMPARE(service_.force(0)[2], 0.0);
    QVERIFY(shell_->signIn("demo.trainee", "placode-demo"));
    QVERIFY(shell_->arrives(PageId::kToday));
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    QVERIFY(shell_->find<QToolButton>("rail_devices") == nullptr);
}

}  // namespace placode::ui

int main(int argc, char** argv) {
    placode::ui::prepare_display();
    QApplication application(argc, argv);
    placode::ui::ShellDevicesTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "shell_devices_test.moc"
