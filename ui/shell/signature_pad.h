// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A field to sign in with finger, pen or mouse. Nothing but the lines is kept.

#include <QPixmap>
#include <QPointF>
#include <QWidget>
#include <functional>
#include <vector>

namespace placode::ui {

class SignaturePad : public QWidget {
 public:
    /// @param ink colour of the line, @param rule of the line to sign on.
    SignaturePad(const QColor& ink, const QColor& rule);

    /// Path of an SVG in pixels of the field, "M10 20 L11 22 ..."; empty until more than a dot was
    /// drawn.
    [[nodiscard]] QString path() const;
    void draw(const QString& path);  ///< In place of what is there: what path() gave.
    void clear();
    std::function<void()> changed;  ///< After every stroke, and when it was cleared.

 protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

 private:
    QColor ink_, rule_;
    std::vector<std::vector<QPointF>> strokes_;
};

/// Draws what path() gave, as large as the lines are.
[[nodiscard]] QPixmap signature_picture(const QString& path, const QColor& ink);

}  // namespace placode::ui
