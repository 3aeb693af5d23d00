// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/svg.h"

#include <gtest/gtest.h>

#include <QGuiApplication>
#include <QPainter>
#include <QXmlStreamReader>

#include "reports/points_figure.h"

namespace placode::test {
namespace THIS_TEST {

const QGuiApplication& application() {
    ::setenv("QT_QPA_PLATFORM", "offscreen", 1);
    static int argc = 1;
    static char name[] = "svg_test";
    static char* argv[] = {name, nullptr};
    static const QGuiApplication only(argc, argv);
    return only;
}

TEST(Svg, IsXmlWhateverStandsInItsWords) {
    application();
    const std::string odd = "</title><script>alert(1)</script> & \"zażółć\"";
    const std::string svg = reports::svg_of({200, 100}, odd, odd, [&](QPainter& painter) {
        painter.drawText(QRectF(0, 0, 200, 100), Qt::AlignCenter, QString::fromStdString(odd));
    });
    EXPECT_EQ(svg.find("<script"), std::string::npos);
    QXmlStreamReader reader(QString::fromStdString(svg));
    int titles = 0;
    while (!reader.atEnd()) {
        if (reader.readNext() != QXmlStreamReader::StartElement) continue;
        if (reader.name() != QStringLiteral("title")) continue;
        ++titles;
        EXPECT_EQ(reader.readElementText().toStdString(), odd);
    }
    EXPECT_FALSE(reader.hasError()) << reader.errorString().toStdString();
    EXPECT_EQ(titles, 1);
}

// With one value of 0 points the axis went from 0 to 1.
TEST(Svg, AnAxisOfPointsGoesToAHundredWhateverTheValuesAre) {
    application();
    const auto drawn = [](const reports::Figure& figure) {
        return reports::svg_of({680, 200}, "", "", [&](QPainter& painter) {
            figure.draw(painter, QRectF(0, 0, 680, 200));
        });
    };
    for (const double value : {0.0, 50.0, 100.0})
        EXPECT_NE(drawn(reports::points_figure("scores", "", "points", {{"first", {value}}}, {}))
                      .find(">100<"),
                  std::string::npos)
            << value;
    EXPECT_EQ(drawn(reports::strip_figure("years", "", "years", {{"all", {3}}}, {})).find(">100<"),
              std::string::npos)
        << "any other axis follows its values";
}

}  // namespace THIS_TEST
}  // namespace placode::test
