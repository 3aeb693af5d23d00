// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/banner.h"

#include <QAccessible>
#include <QAccessibleWidget>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QStyle>
#include <utility>

#include "ui/shell/parts.h"

namespace placode::ui {
namespace {

/// Reading takes about 60 ms a letter; nobody looks at once.
constexpr int kLeastMs = 6000, kLetterMs = 60;
constexpr int kReachMs = 14000;  ///< More where there is something to press.

/// What a desktop has a program for that shows it as people know it.
bool opens_well(const QFileInfo& file) {
    static const QStringList kSuffixes{"pdf", "csv", "svg", "png"};
    return file.isDir() || kSuffixes.contains(file.suffix().toLower());
}

}  // namespace

void announce_banners_as_alerts() {
    static bool done = false;
    if (std::exchange(done, true)) return;
    QAccessible::installFactory([](const QString& name, QObject* object) -> QAccessibleInterface* {
        if (name != QLatin1String("placode::ui::Banner") || !object->isWidgetType()) return nullptr;
        return new QAccessibleWidget(static_cast<QWidget*>(object), QAccessible::AlertMessage);
    });
}

Banner::Banner(AppContext& context, QWidget* parent) : QFrame(parent), context_(context) {
    setObjectName("banner");
    setProperty("role", "banner");
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kSpace16, kSpace12, kSpace8, kSpace12);
    column->setSpacing(kSpace4);
    auto* row = new QHBoxLayout;
    row->setSpacing(kSpace12);
    icon_ = new QLabel;
    row->addWidget(icon_, 0, Qt::AlignVCenter);
    auto* text = new QVBoxLayout;
    text->setSpacing(kSpace4);
    title_ = make_label({});
    title_->setObjectName("banner_title");
    advice_ = make_label({}, "muted");
    advice_->setObjectName("banner_advice");
    text->addWidget(title_);
    text->addWidget(advice_);
    row->addLayout(text, 1);
    row->addWidget(makeClose(), 0, Qt::AlignTop);
    column->addLayout(row);
    addOffers(column);
    details_ = new Details(context);
    connect(details_, &Details::folded, this, &Banner::resized);
    column->addWidget(details_);
}

void Banner::addOffers(QVBoxLayout* column) {
    auto* row = new QHBoxLayout;
    row->setSpacing(kSpace8);
    row->addStretch();
    folder_button_ = make_button(context_, tr("Show folder"), "quiet");
    folder_button_->setObjectName("banner_folder");
    connect(folder_button_, &QPushButton::clicked, this,
            [this] { context_.showFile(QFileInfo(path_).absolutePath()); });
    row->addWidget(folder_button_);
    offer_button_ = make_button(context_, {}, "secondary");
    offer_button_->setObjectName("banner_offer");
    connect(offer_button_, &QPushButton::clicked, this, [this] {
        const Offer offer = offer_;
        Q_EMIT closed();
        if (offer.act) offer.act();
    });
    row->addWidget(offer_button_);
    column->addLayout(row);
}

QPushButton* Banner::makeClose() {
    QPushButton* close = make_button(context_, {}, "icon", "close");
    close->setObjectName("banner_close");
    close->setAccessibleName(tr("Close this message"));
    close->setToolTip(tr("Close this message (Esc)"));
    close->setFixedWidth(kTouchTarget);
    connect(close, &QPushButton::clicked, this, &Banner::closed);
    return close;
}

void Banner::setProblem(const Problem& problem) {
    title_->setText(problem.title);
    advice_->setText(problem.way_out);
    details_->setText(problem.detail, problem.open_details);
    offer_ = {};
    path_.clear();
    tone_ = Tone::kProblem;
    left_ms_ = -1;
    restyle();
}

void Banner::setNotice(const QString& text, const Offer& offer) {
    title_->setText(text);
    advice_->clear();
    details_->setText({});
    offer_ = offer;
    path_.clear();
    tone_ = offer.act ? Tone::kOffer : Tone::kGood;
    left_ms_ = offer.act ? -1 : kLeastMs + kLetterMs * static_cast<int>(text.size());
    restyle();
}

void Banner::setWritten(const QString& text, const QString& path) {
    setNotice(text);
    path_ = path;
    const QFileInfo file(path);
    if (opens_well(file))
        offer_ = {file.isDir() ? tr("Open the folder") : tr("Open"),
                  [&context = context_, path] { context.showFile(path); }};
    left_ms_ += kReachMs;
    restyle();
}

void Banner::restyle() {
    const Tokens& colors = context_.colors();
    const bool problem = tone_ == Tone::kProblem, good = tone_ == Tone::kGood;
    setProperty("tone", problem ? "problem" : good ? "good" : "");
    style()->unpolish(this);
    style()->polish(this);
    icon_->setPixmap(line_icon(problem ? "alert"
                               : good  ? "check"
                                       : "info",
                               problem ? colors.critical
                               : good  ? colors.good
                                       : colors.accent)
                         .pixmap(24, 24));
    if (auto* close = findChild<QPushButton*>("banner_close"))
        close->setIcon(line_icon("close", colors.text));
    advice_->setVisible(!advice_->text().isEmpty());
    offer_button_->setVisible(static_cast<bool>(offer_.act));
    offer_button_->setText(offer_.text);
    folder_button_->setVisible(!path_.isEmpty() && !QFileInfo(path_).isDir());
    setAccessibleName(title());
    setAccessibleDescription(details_->text());
}

void Banner::announce() {
    QAccessibleEvent event(this, QAccessible::Alert);
    QAccessible::updateAccessibility(&event);
}

void Banner::tick() {
    if (left_ms_ < 0 || !isVisible() || !window()->isActiveWindow()) return;
    const QWidget* focus = window()->focusWidget();
    if (underMouse() || (focus != nullptr && isAncestorOf(focus))) return;
    left_ms_ -= kTickMs;
    if (left_ms_ <= 0) Q_EMIT closed();
}

QString Banner::title() const { return (title_->text() + " " + advice_->text()).trimmed(); }

QString Banner::text() const {
    return details_->text().isEmpty() ? title() : title() + "\n" + details_->text();
}

}  // namespace placode::ui
