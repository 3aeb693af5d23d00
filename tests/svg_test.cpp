// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/svg.h"

#include <gtest/gtest.h>

#include <QGuiApplication>
#include <QPainter>
#include <QXmlStreamReader>

namespace placode::test {
namespace THIS_TEST {

TEST(Svg, IsXmlWhateverStandsInItsWords) {
    ::setenv("QT_QPA_PLATFORM", "offscreen", 1);
    int argc = 1;
    char name[] = "svg_test";
    char* argv[] = {name, nullptr};
    const QGuiApplication application(argc, argv);
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

}  // namespace THIS_TEST
}  // namespace placode::test
