// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/banner.h"

#include <QAccessible>
#include <QHBoxLayout>
#include <QStyle>

#include "ui/shell/parts.h"

namespace placode::ui {

Banner::Banner(AppContext& context) : context_(context) {
    setObjectName("banner");
    setProperty("role", "banner");
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(kSpace16, kSpace12, kSpace12, kSpace12);
    row->setSpacing(kSpace12);
    icon_ = new QLabel;
    row->addWidget(icon_, 0, Qt::AlignVCenter);
    auto* text = new QVBoxLayout;
    text->setSpacing(kSpace4);
    title_ = make_label({});
    title_->setObjectName("banner_title");
    detail_ = make_label({}, "small");
    detail_->setObjectName("banner_detail");
    detail_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    detail_->setFocusPolicy(Qt::NoFocus);
    text->addWidget(title_);
    text->addWidget(detail_);
    row->addLayout(text, 1);
    offer_button_ = make_button(context, {}, "secondary");
    offer_button_->setObjectName("banner_offer");
    connect(offer_button_, &QPushButton::clicked, this, [this] {
        const Offer offer = offer_;
        hide();
        if (offer.act) offer.act();
    });
    row->addWidget(offer_button_, 0, Qt::AlignVCenter);
    QPushButton* close = make_button(context, {}, "icon", "close");
    close->setObjectName("banner_close");
    close->setAccessibleName(tr("Close this message"));
    close->setToolTip(tr("Close this message"));
    close->setFixedWidth(kTouchTarget);
    connect(close, &QPushButton::clicked, this, [this] { hide(); });
    row->addWidget(close, 0, Qt::AlignVCenter);
    hide();
}

void Banner::showProblem(const Problem& problem) {
    title_->setText((problem.title + " " + problem.way_out).trimmed());
    detail_->setText(problem.detail);
    offer_ = {};
    present("problem", "alert", context_.colors().critical);
}

void Banner::showNotice(const QString& text, const Offer& offer) {
    title_->setText(text);
    detail_->clear();
    offer_ = offer;
    present(offer.act ? "" : "good", offer.act ? "info" : "check",
            offer.act ? context_.colors().accent : context_.colors().good);
}

void Banner::takeOver(const Banner& other) {
    if (other.isHidden()) return;
    if (other.property("tone") == "problem") {
        showProblem({other.title_->text(), {}, other.detail_->text()});
    } else {
        showNotice(other.title_->text(), other.offer_);
    }
}

void Banner::present(const char* tone, const char* icon, const QColor& color) {
    setProperty("tone", tone);
    style()->unpolish(this);
    style()->polish(this);
    icon_->setPixmap(line_icon(icon, color).pixmap(24, 24));
    detail_->setVisible(!detail_->text().isEmpty());
    offer_button_->setVisible(static_cast<bool>(offer_.act));
    offer_button_->setText(offer_.text);
    setAccessibleName(text());
    QFrame::show();
    // A screen reader hears it without the focus moving.
    QAccessibleEvent event(this, QAccessible::Alert);
    QAccessible::updateAccessibility(&event);
}

QString Banner::text() const {
    return detail_->text().isEmpty() ? title_->text() : title_->text() + "\n" + detail_->text();
}

}  // namespace placode::ui
