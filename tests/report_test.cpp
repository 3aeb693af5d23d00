// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reports are read back: PDF by its text, pictures by their pixels.

#include "reports/report.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <QApplication>
#include <QFile>
#include <QImage>
#include <QPainter>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>

#include "report_fixture.h"
#include "reports/attempt_figures.h"
#include "reports/svg.h"

using namespace placode;

namespace THIS_TEST {

using namespace placode::test;

QApplication& application() {
    static int argc = 1;
    static char name[] = "report_test";
    static char* argv[] = {name, nullptr};
    qputenv("QT_QPA_PLATFORM", "offscreen");
    static QApplication app(argc, argv);
    return app;
}

int pixels_unlike(const QImage& image, QRgb background) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) count += image.pixel(x, y) != background;
    }
    return count;
}

TEST(Report, ThePdfSaysVerdictReasonsAndDemonstration) {
    application();
    const QString pdftotext = QStandardPaths::findExecutable("pdftotext");
    if (pdftotext.isEmpty()) GTEST_SKIP() << "pdftotext (package poppler-utils) is not installed";
    QTemporaryDir folder;
    const QString path = folder.filePath("attempt.pdf");
    std::vector<db::AttemptRecord> history(3, attempt().record);
    reports::write_attempt_pdf(attempt(), recording(), history, path.toStdString());
    if (qEnvironmentVariableIsSet("PLACODE_SCREENSHOTS")) {
        QFile::copy(path, qEnvironmentVariable("PLACODE_SCREENSHOTS") + "/attempt.pdf");
    }
    QProcess process;
    process.start(pdftotext, {"-layout", path, "-"});
    ASSERT_TRUE(process.waitForFinished());
    const QString text = QString::fromUtf8(process.readAllStandardOutput());
    for (const char* expected :
         {"Failed", "61.5 of 100", "DEMONSTRATION", "4 o'clock", "critical", "Zofia \u0141ucka",
          "abcdef", "score [points of 100]", "pass mark of the task: 70"}) {
        EXPECT_TRUE(text.contains(QString::fromUtf8(expected))) << expected << "\nnot in\n"
                                                                << text.toStdString();
    }
}

TEST(Report, ThePdfIsForItsOwnerAlone) {
    application();
    const mode_t before = ::umask(022);
    QTemporaryDir folder;
    const QString path = folder.filePath("attempt.pdf");
    QFile open(path);
    ASSERT_TRUE(open.open(QIODevice::WriteOnly));
    open.close();
    reports::write_attempt_pdf(attempt(), recording(), {}, path.toStdString());
    ::umask(before);
    struct stat status {};
    ASSERT_EQ(::stat(path.toStdString().c_str(), &status), 0);
    EXPECT_GT(status.st_size, 5000);
    EXPECT_EQ(status.st_mode & 07777, 0600U) << "it names a person";
}

TEST(Report, ThePdfHasNoPathThatEndsBeforeItBegins) {
    application();
    const QString pdftotext = QStandardPaths::findExecutable("pdftotext");
    if (pdftotext.isEmpty()) GTEST_SKIP() << "pdftotext (package poppler-utils) is not installed";
    QTemporaryDir folder;
    const QString path = folder.filePath("attempt.pdf");
    // A grasper without energy beside the needle, and nothing cut at all.
    sim::Recording still = recording();
    still.header.tools[1].kind = sim::ToolKind::kGrasper;
    for (sim::Sample& sample : still.samples) sample.tools[1].tip_m = sample.tools[0].tip_m;
    still.events.clear();
    reports::write_attempt_pdf(attempt(), still, {}, path.toStdString());
    QProcess process;
    process.start(pdftotext, {path, "-"});
    ASSERT_TRUE(process.waitForFinished());
    const QString complaints = QString::fromUtf8(process.readAllStandardError());
    EXPECT_FALSE(complaints.contains("Syntax")) << complaints.toStdString();
}

TEST(Report, AFieldWithoutEnergyHasNoScaleOfIt) {
    application();
    const auto drawn = [](const sim::Recording& shown) {
        return reports::svg_of({320, 320}, "", "", [&](QPainter& painter) {
            reports::draw_field_map(painter, QRectF(0, 0, 320, 320), shown, {},
                                    reports::FieldLayer::kEnergy, {});
        });
    };
    sim::Recording shown = recording();
    EXPECT_EQ(drawn(shown).find("J/mm"), std::string::npos) << "0 to 0.0";
    shown.header.sample_s = 0.01;
    for (sim::Sample& sample : shown.samples) sample.tools[0].power_w = 20;
    EXPECT_NE(drawn(shown).find("J/mm"), std::string::npos);
}

TEST(Report, LossesOfMoreThanTheWholeScoreSayWhereItEnds) {
    application();
    const QString pdftotext = QStandardPaths::findExecutable("pdftotext");
    if (pdftotext.isEmpty()) GTEST_SKIP() << "pdftotext (package poppler-utils) is not installed";
    QTemporaryDir folder;
    const QString path = folder.filePath("attempt.pdf");
    db::AttemptDetail low = attempt();
    const auto text = [&] {
        reports::write_attempt_pdf(low, recording(), {low.record}, path.toStdString());
        QProcess process;
        process.start(pdftotext, {"-layout", path, "-"});
        return process.waitForFinished()
                   ? QString::fromUtf8(process.readAllStandardOutput()).simplified()
                   : QString();
    };
    EXPECT_FALSE(text().contains("add up")) << "38.5 points are lost";
    low.score.reasons.front().points = 129.2;
    low.score.points = low.record.points = 0;
    const QString said = text();
    EXPECT_TRUE(said.contains("The losses add up to 155.7 points; a score does not go below 0."))
        << said.toStdString();
}

TEST(Report, AnAttemptThatDoesNotCountHasNoScoreOnPaper) {
    application();
    const QString pdftotext = QStandardPaths::findExecutable("pdftotext");
    if (pdftotext.isEmpty()) GTEST_SKIP() << "pdftotext (package poppler-utils) is not installed";
    QTemporaryDir folder;
    const QString path = folder.filePath("attempt.pdf");
    db::AttemptDetail slow = attempt();
    slow.record.duration_s = 548;
    slow.record.void_reason = "The computer was too slow: 14 pictures a second, 20 are needed";
    reports::write_attempt_pdf(slow, recording(), {slow.record}, path.toStdString());
    const auto text = [&] {
        QProcess process;
        process.start(pdftotext, {"-layout", path, "-"});
        // Where a line is broken is not the point.
        return process.waitForFinished()
                   ? QString::fromUtf8(process.readAllStandardOutput()).simplified()
                   : QString();
    };
    const QString voided = text();
    for (const char* said : {"Does not count: the computer was too slow", "14 pictures a second",
                             "9:08 min, finished", "The machine failed, not the person",
                             "What was noticed (not scored)", "No attempt at this task counts yet"})
        EXPECT_TRUE(voided.contains(said)) << said << "\nnot in\n" << voided.toStdString();
    EXPECT_FALSE(voided.contains("of 100 points"));
    EXPECT_FALSE(voided.contains("-26.5"));
    slow.record.end = sim::EndReason::kInterrupted;
    slow.record.duration_s = 5;
    reports::write_attempt_pdf(slow, recording(), {slow.record}, path.toStdString());
    const QString left = text();
    EXPECT_TRUE(left.contains("Does not count: left after 5 s"));
    EXPECT_FALSE(left.contains("not the person"));
}

/// The text of each page.
QStringList pages_of(const QString& path) {
    QProcess process;
    process.start("pdftotext", {"-layout", path, "-"});
    if (!process.waitForFinished()) return {};
    QStringList pages = QString::fromUtf8(process.readAllStandardOutput()).split('\f');
    if (!pages.isEmpty() && pages.back().trimmed().isEmpty()) pages.removeLast();
    return pages;
}

TEST(Report, ThePdfIsAPaperToFileAndSign) {
    application();
    if (QStandardPaths::findExecutable("pdftotext").isEmpty())
        GTEST_SKIP() << "pdftotext (package poppler-utils) is not installed";
    QTemporaryDir folder;
    const QString path = folder.filePath("exam.pdf");
    db::AttemptDetail exam = attempt();
    qputenv("TZ", "Europe/Warsaw");
    exam.record.started_utc = "2026-03-01T10:30:00Z";
    exam.record.exam = {"resident", 3, "final", "Piotr Proctor", ""};
    exam.record.build = "placode 0.1 avx2";
    exam.record.rubric_id = "ring";
    exam.record.rubric_version = 4;
    exam.record.metric_set_version = 6;
    reports::write_attempt_pdf(exam, recording(), {}, path.toStdString(),
                               {"Clinic of Testing", "Residency"});
    const QStringList pages = pages_of(path);
    ASSERT_GE(pages.size(), 3);
    const QString all = pages.join("\n");
    EXPECT_TRUE(pages.front().contains("Clinic of Testing"));
    EXPECT_TRUE(pages.front().contains("Piotr Proctor"));
    // Titles, not what a file calls them; and the clock on the wall, with its zone.
    const QString front = QString(pages.front()).simplified();
    for (const char* part : {"exam of Residency (resident, version 3),",
                             "stage diathermy_ring (final)"})  // The line is broken here.
        EXPECT_TRUE(front.contains(part)) << front.toStdString();
    EXPECT_TRUE(front.contains("2026-03-01 11:30:00 CET (UTC+01:00)")) << front.toStdString();
    EXPECT_FALSE(front.contains("10:30"));
    for (qsizetype i = 0; i < pages.size(); ++i) {
        EXPECT_TRUE(pages[i].contains(QString("page %1 of %2").arg(i + 1).arg(pages.size())))
            << pages[i].toStdString();
        EXPECT_TRUE(pages[i].contains("DEMONSTRATION"));
        EXPECT_TRUE(pages[i].contains("placode 0.1 avx2"));
    }
    // In this order, each once or continued.
    qsizetype before = all.indexOf("In bold: what the score looks at");
    for (const char* group :
         {"Time and view", "Incision", "Placode", "Tissue", "Energy and heat", "Force", "Motion"}) {
        const qsizetype at = all.indexOf(QRegularExpression(QString("^ *%1\\s*$").arg(group),
                                                            QRegularExpression::MultilineOption),
                                         before + 1);
        EXPECT_GT(at, before) << group;
        before = at;
    }
    EXPECT_TRUE(all.contains("lower is better") && all.contains("higher is better"));
    EXPECT_TRUE(all.contains("Rubric ring version 4"));
    const QString last = pages.back();
    EXPECT_TRUE(last.contains("Signatures"));
    EXPECT_TRUE(last.contains("person: Zofia"));
    EXPECT_TRUE(last.contains("proctor: Piotr Proctor"));
    EXPECT_TRUE(last.contains("date"));
    // One needle and a scope: no second hand, no jaws, no steps.
    EXPECT_FALSE(all.contains("Both hands"));
    EXPECT_FALSE(all.contains("Grasping and resection"));
}

TEST(Report, ManyReasonsGoOnOnTheNextPage) {
    application();
    if (QStandardPaths::findExecutable("pdftotext").isEmpty())
        GTEST_SKIP() << "pdftotext (package poppler-utils) is not installed";
    QTemporaryDir folder;
    const QString path = folder.filePath("many.pdf");
    db::AttemptDetail many = attempt();
    for (int i = 0; i < 60; ++i)
        many.score.reasons.push_back(
            {"x", "Reason number " + std::to_string(i) + ".", 1, 1, false});
    reports::write_attempt_pdf(many, recording(), {}, path.toStdString());
    const QStringList pages = pages_of(path);
    EXPECT_TRUE(pages.join("").contains("Reasons (continued)"));
    for (int i = 0; i < 60; ++i)
        EXPECT_TRUE(pages.join("").contains(QString("Reason number %1.").arg(i))) << i;
}

TEST(Report, ThePdfOfATouchingTaskDoesNotSpeakOfCutting) {
    application();
    const QTemporaryDir folder;
    const auto text_of = [&](const char* task) {
        db::AttemptDetail detail = attempt();
        detail.record.task_id = task;
        const std::string path = folder.filePath(QString(task) + ".pdf").toStdString();
        reports::write_attempt_pdf(detail, recording_of(task, 7), {detail.record}, path);
        return pages_of(QString::fromStdString(path)).join("");
    };
    const QString touch = text_of("touch_targets"), ring = text_of("diathermy_ring");
    for (const char* cutting :
         {"Incise", "No energy reached tissue", "planned", "Ring completeness", "Largest gap",
          "Length off the planned line", "Energy"}) {
        EXPECT_FALSE(touch.contains(cutting)) << cutting;
        EXPECT_TRUE(ring.contains(cutting)) << cutting;
    }
    EXPECT_TRUE(touch.contains("not done")) << "places that were asked for";
    EXPECT_FALSE(ring.contains("not done"));
}

TEST(Report, ThePlacesOfAnExerciseAreShownDoneOrNot) {
    application();
    const sim::Recording made = recording_of("touch_targets", 7);
    const reports::AskedPlaces asked = reports::asked_places(made);
    ASSERT_EQ(asked.places.size(), 8u);
    EXPECT_EQ(asked.done(), 7);
    EXPECT_FALSE(asked.places[7].done);
    EXPECT_FALSE(asked.line);
    EXPECT_FALSE(reports::asked_places(recording_of("diathermy_ring")).any());
    EXPECT_TRUE(reports::asked_places(recording_of("trace_contour")).line);
    const reports::ChartStyle style;
    const auto drawn = [&](const reports::AskedPlaces& places) {
        QImage image(400, 400, QImage::Format_RGB32);
        QPainter painter(&image);
        reports::draw_asked(painter, QRectF(0, 0, 400, 400), made.header.geometry, places, style);
        painter.end();
        return image;
    };
    EXPECT_NE(drawn(asked), drawn(reports::asked_places(recording_of("touch_targets", 8))));
}

TEST(Report, TheIncisionPictureShowsWhatWasCut) {
    application();
    const reports::ChartStyle style;
    QImage bare(400, 400, QImage::Format_RGB32), cut(400, 400, QImage::Format_RGB32);
    sim::Recording without = recording();
    without.events.clear();
    {
        QPainter painter(&bare);
        reports::draw_incision(painter, QRectF(0, 0, 400, 400), without, style);
    }
    {
        QPainter painter(&cut);
        reports::draw_incision(painter, QRectF(0, 0, 400, 400), recording(), style);
    }
    EXPECT_GT(pixels_unlike(bare, style.surface), 5000) << "anatomy is drawn";
    // Events lie at angles 0..180 degrees, y > 0: the patient's left, which is the left half.
    int left = 0, right = 0;
    for (int y = 0; y < 400; ++y) {
        for (int x = 0; x < 400; ++x) {
            if (bare.pixel(x, y) == cut.pixel(x, y)) continue;
            (x < 200 ? left : right) += 1;
        }
    }
    EXPECT_GT(left, 200);
    EXPECT_LT(right, left / 10);
}

TEST(Report, APointAtZeroIsAsLargeInTheHistoryAsAnyOther) {
    application();
    const reports::ChartStyle style;
    const auto ink = [&](double points) {
        db::AttemptRecord record = attempt().record;
        record.verdict = assessment::Verdict::kFailed;
        record.points = points;
        QImage image(500, 240, QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        // Far below the line of a pass, whose ink is another one.
        reports::draw_history(painter, QRectF(0, 0, 500, 240), {record}, 70, style);
        painter.end();
        int count = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x) {
                const QColor pixel = image.pixelColor(x, y);
                count += pixel.red() > pixel.green() + 60 && pixel.red() > pixel.blue() + 60;
            }
        return count;
    };
    const int whole = ink(50);
    ASSERT_GT(whole, 20);
    EXPECT_NEAR(ink(0), whole, 0.1 * whole);
}

TEST(Report, HistoryIsDrawnForOneAndForManyAttempts) {
    application();
    const reports::ChartStyle style;
    for (int n : {0, 1, 40}) {
        QImage image(500, 240, QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        reports::draw_history(
            painter, QRectF(0, 0, 500, 240),
            std::vector<db::AttemptRecord>(static_cast<size_t>(n), attempt().record), 70, style);
        painter.end();
        EXPECT_GT(pixels_unlike(image, style.surface), 500) << n << " attempts";
    }
}

}  // namespace THIS_TEST
