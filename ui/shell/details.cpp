// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/details.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QScrollBar>
#include <algorithm>

#include "ui/shell/parts.h"

namespace placode::ui {
namespace {

constexpr int kMostLines = 8;  ///< In sight; more scroll.
constexpr int kMargin = 4;     ///< Of a text document [px].
constexpr int kInside = 4;     ///< As the style sheet pads it [px].

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
    text_ = new QPlainTextEdit;
    text_->setObjectName("details_text");
    text_->setProperty("role", "details");
    text_->setAccessibleName(tr("The exact message"));
    text_->setReadOnly(true);
    text_->document()->setDocumentMargin(kMargin);
    text_->setTabChangesFocus(true);
    // Paths and numbers have no spaces to break at.
    text_->setWordWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    text_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    column->addWidget(text_);
    setText(text, open);
}

void Details::setText(const QString& text, bool open) {
    setProperty("said", text);
    text_->setPlainText(text);
    copy_->setText(tr("Copy"));
    setVisible(!text.isEmpty());
    fold(open);
}

void Details::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    if (open_ && fitHeight()) Q_EMIT folded();
}

// As high as its text, up to some lines. True when that is another height than before.
bool Details::fitHeight() {
    const int across = 2 * (kInside + text_->frameWidth() + kMargin);
    const int room =
        std::max(80, width() - across - text_->verticalScrollBar()->sizeHint().width());
    const QFontMetrics metrics = text_->fontMetrics();
    const int text =
        metrics.boundingRect(QRect(0, 0, room, QWIDGETSIZE_MAX), Qt::TextWrapAnywhere, this->text())
            .height();
    const int line = metrics.lineSpacing();
    const int height = std::clamp(text, line, kMostLines * line) + across;
    const bool another = height != text_->minimumHeight();
    text_->setFixedHeight(height);
    return another;
}

void Details::fold(bool open) {
    open_ = open;
    toggle_->setText(open ? tr("Hide details") : tr("Details"));
    toggle_->setAccessibleDescription(open ? QString() : tr("Shows the exact message."));
    if (open) (void)fitHeight();
    text_->setVisible(open);
    copy_->setVisible(open);
    Q_EMIT folded();
}

}  // namespace placode::ui
