// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The picture of a task on its page.

#include <QPainter>
#include <QPixmap>
#include <QWidget>
#include <utility>

namespace placode::ui {

/// As wide as its column, with every pixel that the screen has.
class TaskPicture : public QWidget {
 public:
    explicit TaskPicture(QPixmap picture) : picture_(std::move(picture)) {
        QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
        policy.setHeightForWidth(true);
        setSizePolicy(policy);
        setMaximumWidth(kWidest);
    }
    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override {
        return width * picture_.height() / picture_.width();
    }
    [[nodiscard]] QSize sizeHint() const override { return {kWidest, heightForWidth(kWidest)}; }
    [[nodiscard]] QSize minimumSizeHint() const override {
        return {kNarrowest, heightForWidth(kNarrowest)};
    }

 protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawPixmap(QRect(0, 0, width(), heightForWidth(width())), picture_);
    }

 private:
    static constexpr int kNarrowest = 280, kWidest = 560;
    QPixmap picture_;
};

}  // namespace placode::ui
