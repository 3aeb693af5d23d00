// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/details.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>

#include "ui/shell/parts.h"

namespace placode::ui {
namespace {

/// Paths and numbers have no spaces to break at: a break may follow any mark between their parts.
QString breakable(QString text) {
    for (const char* mark : {"/", ":", "_", ".", "-"})
        text.replace(mark, QString(mark) + QChar(0x200B));
    return text;
}

}  // namespace

Details::Details(AppContext& context, const QString& text, bool open) {
    setObjectName("details");
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpace4);
    auto* row = new QHBoxLayout;
    row->setSpacing(kSpace8);
    toggle_ = make_button(context, {}, "quiet");
    toggle_->setObjectName("details_toggle");
    toggle_->setProperty("scale", "small");
    connect(toggle_, &QPushButton::clicked, this, [this] { fold(!open_); });
    row->addWidget(toggle_);
    copy_ = make_button(context, tr("Copy"), "quiet");
    copy_->setObjectName("details_copy");
    copy_->setProperty("scale", "small");
    copy_->setAccessibleName(tr("Copy the details"));
    connect(copy_, &QPushButton::clicked, this, [this] {
        QGuiApplication::clipboard()->setText(property("said").toString());
        copy_->setText(tr("Copied"));
    });
    row->addWidget(copy_);
    row->addStretch();
    column->addLayout(row);
    text_ = make_label({}, "small");
    text_->setObjectName("details_text");
    text_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    text_->setFocusPolicy(Qt::NoFocus);
    column->addWidget(text_);
    setText(text, open);
}

void Details::setText(const QString& text, bool open) {
    setProperty("said", text);
    text_->setText(breakable(text));
    copy_->setText(tr("Copy"));
    setVisible(!text.isEmpty());
    fold(open);
}

void Details::fold(bool open) {
    open_ = open;
    toggle_->setText(open ? tr("Hide details") : tr("Details"));
    toggle_->setAccessibleDescription(open ? QString() : tr("Shows the exact message."));
    text_->setVisible(open);
    copy_->setVisible(open);
    Q_EMIT folded();
}

}  // namespace placode::ui
