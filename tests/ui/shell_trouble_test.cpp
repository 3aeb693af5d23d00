// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Trouble is told in the user's words: every failure of the store, a device, a file or the
// simulator says what to do, and what a part of the program said exactly stands behind "Details".

#include <QFile>
#include <QRegularExpression>
#include <filesystem>
#include <new>

#include "db/access.h"
#include "haptics/station.h"
#include "reports/report.h"
#include "seen_text.h"
#include "shell_harness.h"
#include "ui/shell/messages.h"
#include "ui/shell/parts.h"

namespace placode::ui {
namespace {

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

class ShellTroubleTest : public QObject {
    Q_OBJECT

 private Q_SLOTS:
    void initTestCase() {
        shell_ = std::make_unique<ShellHarness>();
        QVERIFY(shell_->setUpWithDemonstration());
        QVERIFY(shell_->signIn("ada", "correct horse"));
        QVERIFY(shell_->arrives(PageId::kPeople));
    }
    void cleanupTestCase() { shell_.reset(); }

    void everyTroubleHasUserWords_data();
    void everyTroubleHasUserWords();
    void endingsOfTheSimulatorHaveUserWords();
    void everyRefusalOfTheStoreIsInTheCatalogue();
    void whoMayNotIsToldWhoCan();
    void damagedLeftoversAreToldInWords();

 private:
    std::unique_ptr<ShellHarness> shell_;
};

void ShellTroubleTest::everyTroubleHasUserWords_data() {
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
    row("foreign",
        store(Kind::kRefused,
              "restore /tmp/b.db to sqlite:/tmp/x.db: it holds the trigger \"t\" of the table "
              "\"audit\", which Placode did not make and which may be there to do harm; nothing "
              "was changed; use another copy of the store, or have whoever put it there take it "
              "out"),
        "It holds the trigger \"t\"");
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

void ShellTroubleTest::everyTroubleHasUserWords() {
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

void ShellTroubleTest::endingsOfTheSimulatorHaveUserWords() {
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

void ShellTroubleTest::everyRefusalOfTheStoreIsInTheCatalogue() {
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
        QVERIFY2(words.startsWith("Bazę przeniesiono do postgresql://db:5432/p;") &&
                     words.contains("`placodectl --store postgresql://db:5432/p store move"),
                 qPrintable(words));
    }
    shell_->context().setLanguage("en");
}

void ShellTroubleTest::whoMayNotIsToldWhoCan() {
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

void ShellTroubleTest::damagedLeftoversAreToldInWords() {
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

}  // namespace placode::ui

int main(int argc, char** argv) {
    placode::ui::prepare_display();
    QApplication application(argc, argv);
    placode::ui::ShellTroubleTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "shell_trouble_test.moc"
