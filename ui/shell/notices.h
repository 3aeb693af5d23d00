// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Messages float over the page and move nothing: the newest on top of the pile, three at most, the
// others wait. At the right edge, clear of the page's primary button. Esc or the cross closes the
// newest.

#include <QPointer>
#include <QWidget>
#include <functional>
#include <vector>

#include "ui/shell/banner.h"

class QProgressBar;
class QVBoxLayout;

namespace placode::ui {

/// Main thread. A child of the main window, above its frame.
class Notices : public QWidget {
    Q_OBJECT
 public:
    Notices(AppContext& context, QWidget* window);

    void showProblem(const Problem& problem);
    void showNotice(const QString& text, const Banner::Offer& offer = {});
    void showWritten(const QString& text, const QString& path);
    /// What is being worked on; empty: nothing. Short work is not worth a word.
    void showBusy(const QString& what);
    void closeAll();
    /// True when there was one to close.
    bool closeNewest();
    /// Of all that is there, the newest first; details included.
    [[nodiscard]] QString text() const;
    [[nodiscard]] int count() const { return static_cast<int>(banners_.size()); }
    [[nodiscard]] bool isShown() const { return !banners_.empty() && isVisible(); }
    /// Where pages are, in the window; messages stay within it.
    void setArea(const QRect& area);
    /// Free room in the frame, in the window: work in progress without a message is said there and
    /// covers nothing. Asked each time; an empty one: there is none.
    void setStrip(std::function<QRect()> strip) { strip_ = std::move(strip); }
    void restyle();
    static constexpr int kMostShown = 3, kWidth = 460;

 private:
    Banner* add();
    void present(Banner* banner);
    void remove(Banner* banner);
    void arrange();
    /// What should stay in sight, in the window, and how much.
    struct Obstacle {
        QRect where;
        int weight = 1;
    };
    [[nodiscard]] std::vector<Obstacle> obstacles() const;
    [[nodiscard]] static int covered(const QRect& place, const std::vector<Obstacle>& obstacles);
    [[nodiscard]] QPoint freePlace(QSize size, const std::vector<Obstacle>& obstacles) const;
    void tick();
    void showPace();
    [[nodiscard]] bool standInStrip();

    AppContext& context_;
    QRect area_;
    QVBoxLayout* column_ = nullptr;
    std::vector<Banner*> banners_;  ///< Oldest first.
    QFrame* busy_ = nullptr;
    QLabel *busy_text_ = nullptr, *waiting_ = nullptr;
    QProgressBar* busy_bar_ = nullptr;
    QString doing_;
    std::function<QRect()> strip_;
    QTimer ticks_, busy_soon_, pace_;
};

}  // namespace placode::ui
