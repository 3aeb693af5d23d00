// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/sheets.h"

#include <QTextDocument>

namespace placode::reports {

Sheets::Sheets(QPdfWriter* writer, QPainter* painter, QString head, QString foot, int pages)
    : writer_(writer),
      painter_(painter),
      head_(std::move(head)),
      foot_(std::move(foot)),
      pages_(pages) {}

void Sheets::need(double height) {
    if (y_ > kTop && height > left()) newPage();
}

void Sheets::newPage() {
    finishPage();
    if (writer_ != nullptr) writer_->newPage();
    ++page_;
    y_ = kTop;
}

void Sheets::html(const QString& text) {
    const double height = draw(text, {kMargin, y_}, kInner, false);
    need(height);
    draw(text, {kMargin, y_}, kInner, true);
    y_ += height;
}

void Sheets::picture(double height, const std::function<void(QPainter&, double)>& paint) {
    need(height);
    if (painter_ != nullptr) paint(*painter_, y_);
    y_ += height;
}

void Sheets::table(const QString& title, const QString& head, const std::vector<QString>& rows) {
    const auto framed = [&](const QString& caption, const QString& body) {
        return QStringLiteral("<h3>%1</h3><table cellspacing='0' cellpadding='1' width='100%'>")
                   .arg(caption) +
               head + body + QStringLiteral("</table>");
    };
    const auto height_of = [&](const QString& html) { return draw(html, {}, kInner, false); };
    size_t at = 0;
    while (at < rows.size()) {
        const QString caption = at == 0 ? title : title + QStringLiteral(" (continued)");
        QString body = rows[at];
        // A heading, the head and two rows stay together.
        need(height_of(framed(caption, body + body)));
        size_t next = at + 1;
        for (; next < rows.size(); ++next) {
            const QString more = body + rows[next];
            if (height_of(framed(caption, more)) > left()) break;
            body = more;
        }
        html(framed(caption, body));
        at = next;
    }
    y_ += 10;
}

void Sheets::finishPage() {
    if (page_ > 1) draw(head_, {kMargin, kMargin - 22}, kInner, true);
    draw(foot_.arg(page_).arg(pages_), {kMargin, kHeight - kMargin + 8}, kInner, true);
}

double Sheets::draw(const QString& text, const QPointF& at, double width, bool paint) {
    QTextDocument document;
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPixelSize(12);
    // Letter spacing (at least 1/64 pixel) switches ligatures off: with them a search for
    // "finished" finds nothing.
    font.setLetterSpacing(QFont::AbsoluteSpacing, 0.02);
    document.setDefaultFont(font);
    document.setDocumentMargin(0);
    document.setTextWidth(width);
    document.setHtml(text);
    if (paint && painter_ != nullptr) {
        painter_->save();
        painter_->translate(at);
        document.drawContents(painter_);
        painter_->restore();
    }
    return document.size().height();
}

}  // namespace placode::reports
