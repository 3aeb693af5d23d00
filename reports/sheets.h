// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A4 pages of one attempt: they fill from the top and say on each which of how many it is. Laid out
// twice, the first time without a painter, to know how many there will be. Private to reports.

#include <QPainter>
#include <QPdfWriter>
#include <QString>
#include <functional>
#include <vector>

namespace placode::reports {

class Sheets {
 public:
    static constexpr double kMargin = 56, kWidth = 794, kHeight = 1123;  ///< A4 at 96 dpi.
    static constexpr double kInner = kWidth - 2 * kMargin;

    /// @param foot HTML with %1 for the page and %2 for their number.
    Sheets(QPdfWriter* writer, QPainter* painter, QString head, QString foot, int pages);

    [[nodiscard]] int pages() const { return page_; }
    [[nodiscard]] double left() const { return kBottom - y_; }
    /// Begins a new page unless so much is left on this one.
    void need(double height);
    void newPage();
    /// HTML over the whole width, kept together.
    void html(const QString& text);
    void space(double height) { y_ += height; }
    /// A picture of that height, drawn by `paint` where it stands.
    void picture(double height, const std::function<void(QPainter&, double)>& paint);
    /// Rows of HTML in one table; goes on with title and head on the next page.
    void table(const QString& title, const QString& head, const std::vector<QString>& rows);
    void finishPage();
    /// Height of HTML in a column; paints it when asked to and there is a painter.
    double draw(const QString& text, const QPointF& at, double width, bool paint);

 private:
    static constexpr double kTop = kMargin + 20, kBottom = kHeight - kMargin - 6;

    QPdfWriter* writer_;
    QPainter* painter_;
    QString head_, foot_;
    double y_ = kMargin;
    int page_ = 1, pages_;
};

}  // namespace placode::reports
