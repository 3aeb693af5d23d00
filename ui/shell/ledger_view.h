// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The damage ledger as a control: pointer, finger or arrow keys choose an entry, Enter or a second
// click shows it. What is chosen stands in words below.

#include <QCoreApplication>
#include <QLabel>
#include <QWidget>
#include <functional>

#include "reports/attempt_figures.h"
#include "ui/shell/app_context.h"

namespace placode::ui {

/// "Show" begins a little before the moment, so that one sees it coming [s].
inline constexpr double kLeadS = 3;

class LedgerView : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(LedgerView)
 public:
    LedgerView(const AppContext& context, reports::LedgerPicture picture);

    /// An entry was asked for: Enter, double click, or a click on an empty place (entry -1).
    std::function<void(double time_s, int entry)> chosen;
    std::function<void(int entry)> selected;

    void select(int entry);
    [[nodiscard]] int selection() const { return picture_.selected; }
    void setCursor_s(double time_s);  ///< Where a replay stands; negative = nowhere.
    void setMarks(std::vector<reports::TimeMark> marks);
    [[nodiscard]] const reports::LedgerPicture& picture() const { return picture_; }
    /// The words for an entry, with time and place.
    [[nodiscard]] QString words(int entry) const;

 protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

 private:
    [[nodiscard]] QRectF area() const { return QRectF(rect()).adjusted(4, 4, -4, -4); }
    [[nodiscard]] int entryAt(const QPointF& point) const;

    reports::LedgerPicture picture_;
    reports::ChartStyle style_;
    QColor focus_;
};

}  // namespace placode::ui
