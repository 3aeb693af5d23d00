// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/figure.h"

#include <QBuffer>
#include <QImage>

#include "reports/export.h"
#include "reports/plot_parts.h"
#include "reports/svg.h"

namespace placode::reports {
namespace {

constexpr double kTitle = 24, kMargin = 10;

/// Title, drawing and mark: what stands in a file of its own.
void draw_whole(const Figure& figure, QPainter& painter, bool demonstration) {
    const ChartStyle style;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(QRectF(0, 0, figure.width + 2 * kMargin, figure.height + kTitle + 2 * kMargin),
                     QColor::fromRgba(style.surface));
    QString title = QString::fromStdString(figure.title);
    // In front: the end of a long title may be cut off.
    if (demonstration) title.prepend(QStringLiteral("DEMONSTRATION - "));
    draw_text(painter, QRectF(kMargin, kMargin, figure.width, kTitle - 6), Qt::AlignLeft, title,
              style.text, 13, true);
    figure.draw(painter, QRectF(kMargin, kMargin + kTitle, figure.width, figure.height));
}

}  // namespace

void save_figure(const Figure& figure, const std::string& folder, bool demonstration) {
    const QSize size(static_cast<int>(figure.width + 2 * kMargin),
                     static_cast<int>(figure.height + kTitle + 2 * kMargin));
    const std::string stem = folder + "/" + file_name(figure.id);
    save_private_file(stem + ".svg",
                      svg_of(size, figure.title, figure.caption, [&](QPainter& painter) {
                          draw_whole(figure, painter, demonstration);
                      }));
    constexpr int kScale = 3;  // 288 dpi
    QImage image(size * kScale, QImage::Format_RGB32);
    image.setDotsPerMeterX(kScale * 3780);
    image.setDotsPerMeterY(kScale * 3780);
    {
        QPainter painter(&image);
        painter.scale(kScale, kScale);
        draw_whole(figure, painter, demonstration);
    }
    QByteArray png;
    QBuffer buffer(&png);
    buffer.open(QIODevice::WriteOnly);
    if (!image.save(&buffer, "PNG")) throw ReportError("write " + stem + ".png: cannot be encoded");
    save_private_file(stem + ".png", png.toStdString());
    save_private_file(stem + ".csv", figure.csv);
}

}  // namespace placode::reports
