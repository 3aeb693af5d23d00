// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/paper.h"

#include <QPageSize>
#include <QTextDocument>

namespace placode::reports {
namespace {

constexpr double kMargin = 56, kWidth = 794, kHeight = 1123;  // A4 at 96 dpi
constexpr double kInner = kWidth - 2 * kMargin;
constexpr double kBottom = kHeight - kMargin - 14;

void fill(QTextDocument& document, const QString& html) {
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPixelSize(12);
    // Letter spacing switches ligatures off: with them a search for "finished" finds nothing.
    font.setLetterSpacing(QFont::AbsoluteSpacing, 0.02);
    document.setDefaultFont(font);
    document.setDocumentMargin(0);
    document.setTextWidth(kInner);
    document.setHtml(html);
}

double height_of(const QString& html) {
    QTextDocument document;
    fill(document, html);
    return document.size().height();
}

QString row_html(const QStringList& cells, const QString& align, const char* tag) {
    QString html = QStringLiteral("<tr>");
    for (qsizetype i = 0; i < cells.size(); ++i)
        html += QString("<%1 align='%2' style='font-size:11px'>%3</%1>")
                    .arg(QLatin1String(tag),
                         align.mid(i, 1) == "r" ? QStringLiteral("right") : QStringLiteral("left"),
                         cells[i]);
    return html + QStringLiteral("</tr>");
}

}  // namespace

Paper::Paper(const std::string& path, const QString& title, const QString& creator,
             const QString& footer)
    : file_(path), path_(path), footer_(footer), y_(kMargin) {
    if (!file_.open(QIODevice::WriteOnly))
        throw ReportError("write report to " + path + ": " + file_.errorString().toStdString() +
                          "; choose a folder that you may write to");
    writer_ = std::make_unique<QPdfWriter>(&file_);
    writer_->setResolution(96);
    writer_->setPageSize(QPageSize(QPageSize::A4));
    writer_->setPageMargins(QMarginsF(0, 0, 0, 0));
    writer_->setTitle(title);
    writer_->setCreator(creator);
    painter_ = std::make_unique<QPainter>(writer_.get());
    painter_->setRenderHint(QPainter::Antialiasing);
}

void Paper::footer() {
    QTextDocument document;
    fill(document, QString("<p style='color:#5f666e;font-size:10px'>%1 - page %2</p>")
                       .arg(footer_.toHtmlEscaped())
                       .arg(page_));
    painter_->save();
    painter_->translate(kMargin, kHeight - kMargin + 8);
    document.drawContents(painter_.get());
    painter_->restore();
}

void Paper::new_page() {
    footer();
    writer_->newPage();
    ++page_;
    y_ = kMargin;
}

void Paper::need(double height) {
    if (y_ > kMargin && y_ + height > kBottom) new_page();
}

void Paper::html(const QString& text) {
    QTextDocument document;
    fill(document, text);
    need(document.size().height());
    painter_->save();
    painter_->translate(kMargin, y_);
    document.drawContents(painter_.get());
    painter_->restore();
    y_ += document.size().height() + 6;
}

void Paper::heading(const QString& text) {
    need(120);  // A heading does not stand alone at the foot of a page.
    y_ += 6;
    html(QString("<h3>%1</h3>").arg(text.toHtmlEscaped()));
}

void Paper::table(const QString& caption, const QStringList& head, const QString& align,
                  const std::vector<QStringList>& rows) {
    ++tables_;
    size_t at = 0;
    bool first = true;
    while (at < rows.size() || first) {
        const QString title = QString("<p><b>Table %1%2.</b> %3</p>")
                                  .arg(tables_)
                                  .arg(first ? QString() : QStringLiteral(" (continued)"))
                                  .arg(caption);
        const QString begin = title +
                              QStringLiteral(
                                  "<table cellspacing='0' cellpadding='3' width='100%' "
                                  "style='border-top:1px solid #1c1e21'>") +
                              row_html(head, align, "th");
        QString body;
        if (first) need(height_of(begin) + 90);
        const double room = kBottom - y_;
        const size_t from = at;
        while (at < rows.size()) {
            const QString more = body + row_html(rows[at], align, "td");
            if (at > from && height_of(begin + more + "</table>") > room) break;
            body = more;
            ++at;
        }
        html(begin + body + QStringLiteral("</table>"));
        first = false;
        if (at < rows.size()) new_page();
    }
    y_ += 6;
}

void Paper::figure(const Figure& figure) {
    ++figures_;
    const double scale = std::min(1.0, kInner / figure.width);
    const QString caption =
        QString("<p><b>Figure %1.</b> %2. <span style='color:#5f666e'>%3</span></p>")
            .arg(figures_)
            .arg(QString::fromStdString(figure.title).toHtmlEscaped(),
                 QString::fromStdString(figure.caption).toHtmlEscaped());
    need(figure.height * scale + height_of(caption) + 16);
    painter_->save();
    painter_->translate(kMargin, y_);
    painter_->scale(scale, scale);
    figure.draw(*painter_, QRectF(0, 0, figure.width, figure.height));
    painter_->restore();
    y_ += figure.height * scale + 6;
    html(caption);
    y_ += 8;
}

void Paper::finish() {
    footer();
    painter_->end();
    painter_.reset();
    writer_.reset();
    if (!file_.commit())
        throw ReportError("write report to " + path_ + ": " + file_.errorString().toStdString() +
                          "; free space or choose another folder");
}

}  // namespace placode::reports
