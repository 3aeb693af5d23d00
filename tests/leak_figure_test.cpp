// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Where a slit leaks, drawn, in words of both languages and as a table, from a made recording.
#include "reports/leak_figure.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QFile>
#include <QImage>
#include <QLocale>
#include <QPainter>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTranslator>
#include <QXmlStreamReader>
#include <map>

#include "curriculum/task.h"
#include "leaky_slit.h"
#include "report_fixture.h"
#include "reports/svg.h"
#include "reports/task_scope.h"
#include "reports/words.h"

namespace placode::reports {
namespace THIS_TEST {

using assessment::leak_map;
using assessment::LeakMap;
using test::leaky_slit;
using test::LeakySlit;

QApplication& application() {
    static int argc = 1;
    static char name[] = "leak_figure_test";
    static char* argv[] = {name, nullptr};
    qputenv("QT_QPA_PLATFORM", "offscreen");
    static QApplication app(argc, argv);
    QLocale::setDefault(QLocale::c());
    return app;
}

/// The Polish of the shell, as it stands in its file.
class Polish : public QTranslator {
 public:
    Polish() {
        QFile file(PLACODE_SOURCE_DIR "/ui/shell/translations/placode_pl.ts");
        if (!file.open(QIODevice::ReadOnly)) return;
        QXmlStreamReader reader(&file);
        QString context, source;
        while (!reader.atEnd()) {
            if (reader.readNext() != QXmlStreamReader::StartElement) continue;
            if (reader.name() == QStringLiteral("name"))
                context = reader.readElementText();
            else if (reader.name() == QStringLiteral("source"))
                source = reader.readElementText();
            else if (reader.name() == QStringLiteral("translation"))
                words_[context + '\n' + source] =
                    reader.readElementText(QXmlStreamReader::IncludeChildElements);
        }
    }
    [[nodiscard]] bool isEmpty() const override { return words_.empty(); }
    [[nodiscard]] QString translate(const char* context, const char* text, const char*,
                                    int) const override {
        const auto found = words_.find(QString::fromUtf8(context) + '\n' + QString::fromUtf8(text));
        return found == words_.end() ? QString() : found->second;
    }

 private:
    std::map<QString, QString> words_;
};

LeakMap map_of(const sim::Recording& recording) {
    auto map = leak_map(recording);
    EXPECT_TRUE(map);
    return map.value_or(LeakMap{});
}

std::string drawn(const LeakMap& map, const ChartStyle& style = {}) {
    application();
    return svg_of({900, 400}, "", "", [&](QPainter& painter) {
        draw_leak(painter, QRectF(0, 0, 900, leak_height(style)), map, style);
    });
}

TEST(LeakFigure, WordsSayWhereItLeaksAndWhereItBurst) {
    application();
    EXPECT_EQ(leak_words(map_of(leaky_slit())).toStdString(),
              "It leaks most between bites 2 and 3, 8.0 mm from the left end: 12 ml/min at 12.5 "
              "cmH2O; the rest lets 0.40 ml/min through. It burst at 10.1 cmH2O between bite 3 "
              "and the right end, 11.0 mm from the left end.");
    LeakySlit tidy;
    tidy.pass_ml_min = tidy.last_ml_min = LeakySlit::at({});
    tidy.good_ml_min = LeakySlit::at({{7, 1.5}});
    tidy.burst = false;
    EXPECT_EQ(leak_words(map_of(leaky_slit(tidy))).toStdString(),
              "It leaks most between bites 2 and 3, 8.0 mm from the left end: 1.5 ml/min at 12.5 "
              "cmH2O; the rest is tight. It held 40.0 cmH2O, the end of the test.");
    tidy.good_ml_min = LeakySlit::at({{7, 0.05}});
    EXPECT_EQ(leak_words(map_of(leaky_slit(tidy))).toStdString(),
              "It is tight at 12.5 cmH2O. It held 40.0 cmH2O, the end of the test.");
}

TEST(LeakFigure, WordsOfASlitThatRunsUpAndDownAndOfOneWithoutBites) {
    application();
    const QString upright = leak_words(map_of(test::upright(leaky_slit())));
    EXPECT_TRUE(upright.contains("8.0 mm from the upper end")) << upright.toStdString();
    sim::Recording unsewn = leaky_slit();
    std::erase_if(unsewn.events, [](const sim::Event& e) { return e.time_s < 30; });
    const QString words = leak_words(map_of(unsewn));
    EXPECT_TRUE(
        words.startsWith("It leaks most 8.0 mm from the left end: 12 ml/min at 12.5 "
                         "cmH2O; there is no finished bite."))
        << words.toStdString();
}

TEST(LeakFigure, WordsInPolish) {
    application();
    Polish polish;
    ASSERT_FALSE(polish.isEmpty());
    QCoreApplication::installTranslator(&polish);
    {
        const Speaking here{QLocale(QLocale::Polish)};
        EXPECT_EQ(leak_words(map_of(leaky_slit())).toStdString(),
                  "Najbardziej przecieka między ściegami 2 i 3, 8,0 mm od lewego końca: 12 ml/min "
                  "przy 12,5 cmH2O; reszta przepuszcza 0,40 ml/min. Puściło przy 10,1 cmH2O "
                  "między ściegiem 3 a prawym końcem, 11,0 mm od lewego końca.");
        EXPECT_EQ(no_leak_map_words().toStdString(),
                  "Brak mapy: to nagranie nie mówi, gdzie ile przecieka.");
        EXPECT_NE(drawn(map_of(leaky_slit())).find("lewy koniec"), std::string::npos);
    }
    QCoreApplication::removeTranslator(&polish);
}

TEST(LeakFigure, AnOlderRecordingSaysWhatItLacks) {
    application();
    const LeakMap old = map_of(test::without_burst_list(leaky_slit()));
    const QString words = leak_words(old);
    EXPECT_TRUE(words.startsWith("It leaks most between bites 2 and 3"));
    EXPECT_TRUE(words.endsWith("It held up to 10.1 cmH2O; where it burst then was not recorded."))
        << words.toStdString();
    const std::string svg = drawn(old);
    EXPECT_EQ(svg.find("burst at"), std::string::npos);
    EXPECT_NE(svg.find("gap [mm] without pressure"), std::string::npos);
    EXPECT_TRUE(looks_at_leak(scope_of(curriculum::load_task("suture_slit")).scored));
    EXPECT_FALSE(looks_at_leak({"slit_shut_percent", "bites_done"}));
}

TEST(LeakFigure, AllThatIsToBeReadIsDrawn) {
    const std::string svg = drawn(map_of(leaky_slit()));
    for (const char* words : {"leak at 12.5 cmH2O [ml/min]", "bites:", "gap [mm]", "left end",
                              "right end", "burst at 10.1 cmH2O", ">1<", ">2<", ">3<", ">10<"})
        EXPECT_NE(svg.find(words), std::string::npos) << words;
    LeakySlit tight;
    tight.pass_ml_min = tight.good_ml_min = tight.last_ml_min = LeakySlit::at({});
    tight.burst = false;
    const std::string quiet = drawn(map_of(leaky_slit(tight)));
    EXPECT_NE(quiet.find("nothing leaks"), std::string::npos);
    EXPECT_EQ(quiet.find("burst"), std::string::npos);
}

/// To scale: 12 mm take the width between the margins of 3.6 and 1.5 letters.
TEST(LeakFigure, BarsStandWhereItLeaksInEveryTheme) {
    application();
    ChartStyle dark;
    dark.surface = 0xff14181c;
    dark.accent = 0xff4fc3cf;
    dark.text = 0xffe8eaed;
    dark.line = 0xff2a3036;
    const LeakMap map = map_of(leaky_slit());
    for (const ChartStyle& style : {ChartStyle{}, dark}) {
        QImage image(900, static_cast<int>(leak_height(style)), QImage::Format_RGB32);
        image.fill(Qt::magenta);
        QPainter painter(&image);
        draw_leak(painter, QRectF(image.rect()), map, style);
        painter.end();
        const double em = style.font_px, left = 3.6 * em, width = 900 - 5.1 * em;
        const auto at = [&](double along_mm) {
            // The first panel ends 1.7 + 1.6 + 5.5 letters below the top.
            return image.pixel(static_cast<int>(left + width * along_mm / 12),
                               static_cast<int>(8.8 * em - 5));
        };
        const auto like = [](QRgb a, QRgb b) {
            return std::abs(qRed(a) - qRed(b)) + std::abs(qGreen(a) - qGreen(b)) +
                   std::abs(qBlue(a) - qBlue(b));
        };
        for (const double open : {7.6, 8.0, 8.4})
            EXPECT_LT(like(at(open), style.accent), like(at(open), style.surface)) << open;
        for (const double shut : {3.6, 5.1, 6.6, 9.4})
            EXPECT_LT(like(at(shut), style.surface), 30) << shut;
        EXPECT_EQ(image.pixel(1, 1), QRgb(style.surface)) << "nothing shines through";
    }
}

TEST(LeakFigure, TheTableHasALineForEachStationAndAddsUp) {
    const LeakMap map = map_of(leaky_slit());
    const LeakTable table = leak_table(map);
    ASSERT_EQ(table.rows.size(), 23U);
    ASSERT_EQ(table.columns.size(), 11U);
    double leak_6 = 0, leak_12 = 0, leak_end = 0;
    for (const auto& row : table.rows) {
        ASSERT_EQ(row.size(), table.columns.size());
        leak_6 += *row[7];
        leak_12 += *row[8];
        leak_end += *row[9];
    }
    EXPECT_NEAR(leak_6, 0.4, 1e-5);
    EXPECT_NEAR(leak_12, 12.4, 1e-4);
    EXPECT_NEAR(leak_end, 10.6, 1e-4);
    const std::string csv = leak_csv(table);
    EXPECT_EQ(csv.substr(0, csv.find('\n')),
              "station,along_mm,length_mm,gap_mm,gap_6_mm,gap_12_mm,gap_end_mm,leak_6_ml_min,"
              "leak_12_ml_min,leak_end_ml_min,opened_cmh2o");
    // Station 7 lies 8 mm from the left end; it opened at 900 Pa. One at the middle never did.
    EXPECT_NEAR(*table.rows[15][0], 7, 0);
    EXPECT_NEAR(*table.rows[15][1], 8, 1e-4);
    EXPECT_NEAR(*table.rows[15][10], 900 / 98.0665, 1e-4);
    EXPECT_FALSE(table.rows[11][10]);
    const LeakTable old = leak_table(map_of(test::without_burst_list(leaky_slit())));
    EXPECT_TRUE(old.rows[15][8]);
    for (const size_t later : {4U, 5U, 6U, 9U, 10U}) EXPECT_FALSE(old.rows[15][later]) << later;
}

TEST(LeakFigure, ThePdfHasTheMapAndTheSentence) {
    application();
    const QString pdftotext = QStandardPaths::findExecutable("pdftotext");
    if (pdftotext.isEmpty()) GTEST_SKIP() << "pdftotext (package poppler-utils) is not installed";
    QTemporaryDir folder;
    const QString path = folder.filePath("attempt.pdf");
    sim::Recording sewn = test::recording_of("suture_slit");
    const auto text_of = [&](const sim::Recording& recording) {
        write_attempt_pdf(test::attempt(), recording, {}, path.toStdString());
        QProcess process;
        process.start(pdftotext, {"-layout", path, "-"});
        return process.waitForFinished()
                   ? QString::fromUtf8(process.readAllStandardOutput()).simplified()
                   : QString();
    };
    const QString none = text_of(sewn);
    EXPECT_TRUE(none.contains("No map: this recording does not say what leaks where."))
        << "recorded by a program that did not tell it";
    const sim::Recording made = leaky_slit();
    sewn.events.insert(sewn.events.end(), made.events.begin(), made.events.end());
    const QString text = text_of(sewn);
    if (qEnvironmentVariableIsSet("PLACODE_SCREENSHOTS"))
        QFile::copy(path, qEnvironmentVariable("PLACODE_SCREENSHOTS") + "/attempt_slit.pdf");
    for (const char* words : {"Where it leaks", "burst at 10.1 cmH2O",
                              "It leaks most between bites 2 and 3, 8.0 mm from the left end"})
        EXPECT_TRUE(text.contains(words)) << words << "\nnot in\n" << text.toStdString();
    EXPECT_FALSE(text_of(test::recording()).contains("leaks")) << "of a task without a slit";
}

}  // namespace THIS_TEST
}  // namespace placode::reports
