// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/svg.h"

#include <QBuffer>
#include <QPainter>
#include <QSvgGenerator>

namespace placode::reports {

std::string svg_of(const QSize& size, const std::string& title, const std::string& description,
                   const std::function<void(QPainter&)>& draw) {
    QByteArray svg;
    {
        QBuffer buffer(&svg);
        QSvgGenerator generator;
        generator.setOutputDevice(&buffer);
        generator.setSize(size);
        generator.setViewBox(QRect(QPoint(0, 0), size));
        // Qt writes both as they are: an ampersand would break the file.
        generator.setTitle(QString::fromStdString(title).toHtmlEscaped());
        generator.setDescription(QString::fromStdString(description).toHtmlEscaped());
        QPainter painter(&generator);
        draw(painter);
    }
    return svg.toStdString();
}

}  // namespace placode::reports
