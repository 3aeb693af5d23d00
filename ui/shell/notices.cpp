// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/notices.h"

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QHeaderView>
#include <QLineEdit>
#include <QProgressBar>
#include <QTableView>
#include <algorithm>

#include "ui/shell/parts.h"

namespace placode::ui {
namespace {

constexpr int kStep = 8;       ///< Between the heights that are tried [px].
constexpr int kFromEdge = 16;  ///< From the edges of the page [px].
constexpr int kBusyAfterMs = 400, kPaceMs = 500;
constexpr int kLeastStrip = 220;  ///< Width for a few words [px].

}  // namespace

Notices::Notices(AppContext& context, QWidget* window) : QWidget(window), context_(context) {
    setObjectName("notices");
    column_ = new QVBoxLayout(this);
    column_->setContentsMargins(0, 0, 0, 0);
    column_->setSpacing(kSpace8);
    busy_ = new QFrame;
    busy_->setObjectName("busy");
    busy_->setProperty("role", "banner");
    auto* inside = new QVBoxLayout(busy_);
    inside->setContentsMargins(kSpace16, kSpace8, kSpace16, kSpace12);
    inside->setSpacing(kSpace4);
    busy_text_ = make_label({}, "small");
    busy_bar_ = new QProgressBar;
    busy_bar_->setRange(0, 0);
    busy_bar_->setTextVisible(false);
    busy_bar_->setAccessibleName(tr("Work in progress"));
    inside->addWidget(busy_text_);
    inside->addWidget(busy_bar_);
    pace_.setInterval(kPaceMs);
    connect(&pace_, &QTimer::timeout, this, &Notices::showPace);
    column_->addWidget(busy_);
    waiting_ = make_badge({});
    waiting_->setObjectName("notices_waiting");
    column_->addWidget(waiting_, 0, Qt::AlignRight);
    busy_->hide();
    waiting_->hide();
    hide();
    ticks_.setInterval(Banner::kTickMs);
    connect(&ticks_, &QTimer::timeout, this, &Notices::tick);
    busy_soon_.setSingleShot(true);
    busy_soon_.setInterval(kBusyAfterMs);
    connect(&busy_soon_, &QTimer::timeout, this, [this] {
        busy_->show();
        arrange();
    });
}

Banner* Notices::add() {
    auto* banner = new Banner(context_, this);
    banners_.push_back(banner);
    column_->insertWidget(0, banner);
    connect(banner, &Banner::closed, this, [this, banner] { remove(banner); });
    connect(banner, &Banner::resized, this, &Notices::arrange);
    return banner;
}

void Notices::showProblem(const Problem& problem) {
    // What was wrong before with the same thing may not be any more.
    for (Banner* each : std::vector<Banner*>(banners_))
        if (!problem.doing.isEmpty() && each->property("doing") == problem.doing) remove(each);
    Banner* banner = add();
    banner->setProperty("doing", problem.doing);
    banner->setProblem(problem);
    present(banner);
}

void Notices::present(Banner* banner) {
    // The same once more takes the place of the earlier one.
    for (Banner* each : std::vector<Banner*>(banners_))
        if (each != banner && each->text() == banner->text()) remove(each);
    arrange();
    banner->announce();
}

void Notices::showNotice(const QString& text, const Banner::Offer& offer) {
    Banner* banner = add();
    banner->setNotice(text, offer);
    present(banner);
}

void Notices::showWritten(const QString& text, const QString& path) {
    Banner* banner = add();
    banner->setWritten(text, path);
    present(banner);
}

void Notices::showBusy(const QString& what) {
    doing_ = what;
    showPace();
    if (!what.isEmpty()) {
        pace_.start();
        if (busy_->isHidden()) busy_soon_.start();
        return;
    }
    pace_.stop();
    busy_soon_.stop();
    busy_->hide();
    arrange();
}

/// How far the work is, where earlier work of its kind tells how long it takes.
void Notices::showPace() {
    const auto pace = context_.busyPace();
    busy_bar_->setRange(0, pace ? 100 : 0);
    if (pace) busy_bar_->setValue(static_cast<int>(100 * pace->share));
    const QString text =
        pace && pace->overdue ? tr("%1, longer than usual").arg(doing_)
        : pace ? tr("%1, about %2 left").arg(doing_, format_duration(std::max(1.0, pace->left_s)))
               : doing_;
    if (text != busy_text_->text()) busy_text_->setText(text);
    // The page and its bar may have been built, or built anew, meanwhile.
    if (!busy_->isHidden()) arrange();
}

/// Work alone, without a message: in the frame's free strip, where it covers nothing.
bool Notices::standInStrip() {
    if (count() > 0 || busy_->isHidden() || !strip_) return false;
    const QRect strip = strip_();
    if (strip.width() < kLeastStrip) return false;
    const int width = std::min(kWidth, strip.width());
    setFixedWidth(width);
    column_->activate();
    const int height =
        std::min(strip.height(), column_->hasHeightForWidth() ? column_->totalHeightForWidth(width)
                                                              : column_->totalSizeHint().height());
    resize(width, height);
    move(strip.right() - width + 1, strip.top() + (strip.height() - height) / 2);
    raise();
    return true;
}

void Notices::remove(Banner* banner) {
    const auto found = std::find(banners_.begin(), banners_.end(), banner);
    if (found == banners_.end()) return;
    banners_.erase(found);
    // Who closed it by a key goes on in the page, not in the next message.
    const QWidget* focus = window()->focusWidget();
    if (focus != nullptr && banner->isAncestorOf(focus)) window()->setFocus();
    column_->removeWidget(banner);
    banner->hide();
    banner->deleteLater();
    arrange();
}

void Notices::closeAll() {
    while (!banners_.empty()) remove(banners_.back());
}

bool Notices::closeNewest() {
    if (banners_.empty()) return false;
    remove(banners_.back());
    return true;
}

QString Notices::text() const {
    QStringList all;
    for (auto each = banners_.rbegin(); each != banners_.rend(); ++each) all << (*each)->text();
    return all.join("\n");
}

void Notices::setArea(const QRect& area) {
    area_ = area;
    arrange();
}

void Notices::restyle() {
    for (Banner* each : banners_) each->restyle();
    arrange();
}

void Notices::arrange() {
    const int shown = std::min<int>(kMostShown, count());
    for (int i = 0; i < count(); ++i)
        banners_[static_cast<size_t>(i)]->setVisible(i >= count() - shown);
    waiting_->setText(tr("More messages: %1").arg(count() - shown));
    waiting_->setVisible(count() > shown);
    setVisible(count() > 0 || !busy_->isHidden());
    count() > 0 ? ticks_.start() : ticks_.stop();
    if (!isVisible() && isHidden()) return;
    if (standInStrip()) return;
    const int width = std::min(kWidth, std::max(240, area_.width() - 2 * kFromEdge));
    setFixedWidth(width);
    // What was folded or hidden just now tells its parents only later otherwise, inmost first.
    const auto inside = findChildren<QWidget*>();
    for (auto each = inside.rbegin(); each != inside.rend(); ++each)
        QCoreApplication::sendPostedEvents(*each, QEvent::LayoutRequest);
    column_->activate();
    // Wrapped text has a height only for a width.
    const int height = column_->hasHeightForWidth() ? column_->totalHeightForWidth(width)
                                                    : column_->totalSizeHint().height();
    resize(width, std::min(height, std::max(60, area_.height() - 2 * kFromEdge)));
    move(freePlace(size(), obstacles()));
    raise();
}

std::vector<Notices::Obstacle> Notices::obstacles() const {
    std::vector<Obstacle> found;
    const auto add = [&](const QWidget* widget, int weight) {
        if (widget == nullptr || !widget->isVisible() || isAncestorOf(widget)) return;
        // What has been scrolled out of sight is not in the way.
        QRect there = widget->visibleRegion().boundingRect();
        there.moveTopLeft(widget->mapTo(window(), there.topLeft()));
        found.push_back({there, weight});
    };
    // Of a table its rows; the empty rest is free.
    const auto add_rows = [&](const QTableView* table) {
        if (!table->isVisible()) return;
        QRect rows = table->viewport()->visibleRegion().boundingRect();
        rows.setHeight(std::min(rows.height(), table->verticalHeader()->length()));
        rows.moveTopLeft(table->viewport()->mapTo(window(), rows.topLeft()));
        found.push_back({rows, 1});
    };
    // Best over nothing that is used; never over the button that the page is there for.
    for (const auto* button : window()->findChildren<QAbstractButton*>())
        add(button, button->property("role") == "primary" && button->isEnabled() ? 100 : 1);
    for (const auto* field : window()->findChildren<QLineEdit*>()) add(field, 1);
    for (const auto* box : window()->findChildren<QComboBox*>()) add(box, 1);
    for (const auto* table : window()->findChildren<QTableView*>()) add_rows(table);
    add(window()->focusWidget(), 10);
    return found;
}

int Notices::covered(const QRect& place, const std::vector<Obstacle>& obstacles) {
    int area = 0;
    for (const Obstacle& each : obstacles) {
        const QRect both = each.where.intersected(place);
        area += each.weight * both.width() * both.height();
    }
    return area;
}

/// Always at the right edge, so that everybody knows where to look: at the bottom, or as much
/// higher as what is used there asks for.
QPoint Notices::freePlace(QSize size, const std::vector<Obstacle>& obstacles) const {
    const int right = area_.right() - kFromEdge - size.width() + 1;
    const int top = area_.top() + kFromEdge,
              bottom = area_.bottom() - kFromEdge - size.height() + 1;
    QPoint best(right, bottom);
    int least = covered({best, size}, obstacles);
    for (int y = bottom - kStep; y >= top && least > 0; y -= kStep) {
        const int area = covered({{right, y}, size}, obstacles);
        if (area >= least) continue;
        least = area;
        best.setY(y);
    }
    return best;
}

void Notices::tick() {
    for (Banner* each : std::vector<Banner*>(banners_)) each->tick();
    // The page scrolled, or built itself meanwhile: out of the way of its button, unless somebody
    // is about to press something here.
    if (!isVisible() || underMouse()) return;
    const auto in_the_way = obstacles();
    const QPoint place = freePlace(size(), in_the_way);
    if (covered({place, size()}, in_the_way) < covered(geometry(), in_the_way)) move(place);
}

}  // namespace placode::ui
