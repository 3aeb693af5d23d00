// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Trouble is told in the user's words: every failure of the store, a device, a file or the
// simulator says what to do, and what a part of the program said exactly stands behind "Details".

#include <QCoreApplication>
#include <QFile>
#include <QRegularExpression>
#include <filesystem>
#include <new>

#include "curriculum/questionnaire.h"
#include "db/access.h"
#include "haptics/station.h"
#include "reports/report.h"
#include "reports/words.h"
#include "seen_text.h"
#include "shell_harness.h"
#include "store_sentences.h"
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

QString in_catalogue(const char* sentence) {
    return QCoreApplication::translate(db::Said::kContext, sentence);
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
    void everyRefusalOfTheStoreIsMarked();
    void everyRefusalOfTheStoreIsInTheCatalogue();
    void anAnswerThatDoesNotFitIsToldInWords();
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
    row(
        "taken",
        [] {
            throw db::StoreError(Kind::kConflict, "create a user in sqlite:/tmp/x.db: ",
                                 db::Said::that("the login is taken; choose another one"));
        },
        "The login is taken; choose another one.");
    // As the store really says it.
    row(
        "taken by name",
        [this] {
            db::NewUser again{"ada", "Ada", "correct horse battery", 1, false};
            shell_->context().store().accounts().create(again);
        },
        "The login is taken; choose another one.");
    row("conflict", store(Kind::kConflict, "save sqlite:/tmp/x.db: UNIQUE constraint failed: SQL"),
        "done already");
    row(
        "refused",
        [] {
            throw db::StoreError(Kind::kRefused, "set a PIN in sqlite:/tmp/x.db: ",
                                 db::Said::that("a PIN has four to twelve digits"));
        },
        "A PIN has four to twelve digits.");
    row("refused without a meaning", store(Kind::kRefused, "try sqlite:/tmp/x.db: no SELECT"),
        "Nothing was changed");
    row(
        "foreign",
        [] {
            throw db::StoreError(
                Kind::kRefused, "restore /tmp/b.db to sqlite:/tmp/x.db: ",
                db::Said::that("it holds %1, which Placode did not make and which may be there to "
                               "do harm; nothing was changed; use another copy of the store, or "
                               "have whoever put it there take it out")
                    .with("the trigger \"t\" of the table \"audit\""));
        },
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

void ShellTroubleTest::everyRefusalOfTheStoreIsMarked() {
    // Whatever is thrown with these kinds has its sentence in a db::Said. "problem" is one that a
    // function made.
    static const QRegularExpression kThrown(
        "(?:fail|StoreError)\\(\\s*(?:StoreError::)?(?:Kind::)?k(?:Refused|Conflict),([^;]*?)\\);");
    const QDir folder(PLACODE_SOURCE_DIR "/db");
    int checked = 0;
    for (const QString& name : folder.entryList({"*.cpp"})) {
        // Never from the shell.
        if (name == "load_generator.cpp" || name == "reading_store.cpp" ||
            name == "work_queue.cpp" || name == "erasure.cpp" || name == "store_move.cpp" ||
            name == "move_target.cpp" || name == "trail_head.cpp" || name == "audit.cpp")
            continue;
        QString source = text_of(folder.filePath(name));
        // A semicolon within a sentence ends no statement.
        static const QRegularExpression kLiteral("\"(?:[^\"\\\\\\n]|\\\\.)*\"");
        for (auto each = kLiteral.globalMatch(QString(source)); each.hasNext();) {
            const QRegularExpressionMatch literal = each.next();
            for (qsizetype at = literal.capturedStart(); at < literal.capturedEnd(); ++at)
                if (source[at] == ';') source[at] = ',';
        }
        auto found = kThrown.globalMatch(source);
        while (found.hasNext()) {
            const QString words = found.next().captured(1).simplified();
            ++checked;
            const bool plain = words.contains('"') && !words.contains("Said::") &&
                               !words.endsWith(", problem") && !words.endsWith(", *problem") &&
                               !words.endsWith("(other)");
            // Of the command line, like those of the files above.
            const bool other = (name == "station_role.cpp" || name == "rescore.cpp") && plain;
            QVERIFY2(!plain || other, qPrintable(name + ": " + words));
        }
    }
    QVERIFY2(checked > 80, qPrintable(QString::number(checked)));
}

void ShellTroubleTest::everyRefusalOfTheStoreIsInTheCatalogue() {
    shell_->context().setLanguage("pl");
    const QStringList all = store_sentences();
    QVERIFY2(all.size() > 95, qPrintable(QString::number(all.size())));
    for (const QString& sentence : all)
        QVERIFY2(in_catalogue(sentence.toUtf8().constData()) != sentence, qPrintable(sentence));
    // A store that has moved, as its place says so when it is opened, and its triggers later.
    const std::string place = "postgresql://db:5432/p";
    const std::string back = "placodectl --store " + place + " store move --to sqlite:/a.db";
    for (const db::Said& said :
         {db::Said::that("the store was moved to %1; use that address, or bring it back with `%2`"),
          db::Said::that("the store was moved to %1; use that address, or bring it back with `%2`; "
                         "nothing was changed")}) {
        const QString words = reports::said_words(said.with(place).with(back));
        QVERIFY2(words.startsWith("Bazę przeniesiono do postgresql://db:5432/p;") &&
                     words.contains("`placodectl --store postgresql://db:5432/p store move"),
                 qPrintable(words));
    }
    shell_->context().setLanguage("en");
}

void ShellTroubleTest::anAnswerThatDoesNotFitIsToldInWords() {
    const auto sus = curriculum::load_questionnaire("sus");
    curriculum::Answers answers;
    for (const auto& item : sus.items) answers[item.id] = "4";
    const auto said = [&] {
        return reports::said_words(curriculum::check_answers(sus, answers).value_or(db::Said()));
    };
    shell_->context().setLanguage("pl");
    QCOMPARE(said(), QString());
    answers["sus01"] = "9";
    QCOMPARE(said(), QString::fromUtf8("Pytanie sus01: 9 to więcej niż 5."));
    answers.erase("sus01");
    QCOMPARE(said(), QString::fromUtf8("Pytanie sus01 wymaga odpowiedzi."));
    shell_->context().setLanguage("en");
    QCOMPARE(said(), QString("Item sus01 needs an answer."));
}

void ShellTroubleTest::whoMayNotIsToldWhoCan() {
    shell_->context().setLanguage("pl");
    for (int i = 0; i < 24; ++i) {
        const db::Said said = db::refusal(static_cast<db::Action>(i));
        const QString polish = reports::said_words(said);
        QVERIFY2(polish.startsWith("Nie możesz ") && !polish.contains(" can"),
                 said.english().c_str());
        // Both of its parts have their Polish.
        (void)said.in("pl", [](const char* english) {
            const QString words = in_catalogue(english);
            [&] { QVERIFY2(words != english, english); }();
            return words.toStdString();
        });
    }
    shell_->context().setLanguage("en");
    QCOMPARE(reports::said_words(db::refusal(db::Action::kViewAudit)),
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
