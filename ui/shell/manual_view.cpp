// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/manual_view.h"

#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextDocument>
#include <QTextTable>

#include "ui/shell/manual.h"

namespace placode::ui {
namespace {

constexpr int kAroundText = 24;  ///< Around the text [px].
constexpr int kHeadingPx[]{26, 18, 15, 14};

}  // namespace

ManualView::ManualView(QWidget* parent) : QTextBrowser(parent) {
    setObjectName("manual_view");
    setAccessibleName(tr("Page of the manual"));
    setOpenLinks(false);
    document()->setDocumentMargin(kAroundText);
    resized_.setSingleShot(true);
    resized_.setInterval(100);
    connect(&resized_, &QTimer::timeout, this, [this] {
        if (!path_.isEmpty() && viewport()->width() != set_for_) setAgain();
    });
}

/// For another width. Whoever was sent to a heading and has not scrolled since stays there.
void ManualView::setAgain() {
    QScrollBar* bar = verticalScrollBar();
    const bool scrolled = anchor_.isEmpty() || bar->value() != sent_to_;
    const double where = bar->value() / static_cast<double>(std::max(1, bar->maximum()));
    set();
    if (scrolled || !goTo(anchor_)) bar->setValue(static_cast<int>(where * bar->maximum()));
}

void ManualView::showFile(const QString& path, const QString& anchor, const Tokens& colors) {
    path_ = path;
    colors_ = colors;
    set();
    anchor_.clear();
    if (anchor.isEmpty() || !goTo(anchor)) verticalScrollBar()->setValue(0);
}

void ManualView::set() {
    set_for_ = viewport()->width();
    QFile file(path_);
    const QString text = file.open(QIODevice::ReadOnly)
                             ? QString::fromUtf8(file.readAll())
                             : tr("This page of the manual is missing: %1").arg(path_);
    document()->clear();  // Pictures of another width.
    setMarkdown(text);
    setHeadings();
    setTables();
}

void ManualView::setHeadings() {
    QTextCursor cursor(document());
    cursor.beginEditBlock();
    for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) {
        QTextBlockFormat format = block.blockFormat();
        const int level = format.headingLevel();
        // Not of a picture: a third of its height would stay empty below it.
        if (!block.text().contains(QChar::ObjectReplacementCharacter))
            format.setLineHeight(135, QTextBlockFormat::ProportionalHeight);
        if (level > 0) {
            format.setTopMargin(level == 1 ? 0 : 20);
            format.setBottomMargin(8);
        } else if (QTextCursor(block).currentTable() == nullptr) {
            format.setBottomMargin(block.textList() != nullptr ? 4 : 10);
        }
        cursor.setPosition(block.position());
        cursor.setBlockFormat(format);
        if (level == 0) continue;
        QTextCharFormat words;
        words.clearProperty(QTextFormat::FontSizeAdjustment);
        words.setProperty(QTextFormat::FontPixelSize, kHeadingPx[std::min(level, 4) - 1]);
        words.setFontWeight(QFont::DemiBold);
        cursor.movePosition(QTextCursor::EndOfBlock, QTextCursor::KeepAnchor);
        cursor.mergeCharFormat(words);
    }
    cursor.endEditBlock();
}

void ManualView::setTables() {
    for (QTextFrame* frame : document()->rootFrame()->childFrames()) {
        auto* table = qobject_cast<QTextTable*>(frame);
        if (table == nullptr) continue;
        QTextTableFormat format = table->format();
        format.setBorder(1);
        format.setBorderBrush(colors_.line);
        format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
        format.setBorderCollapse(true);
        format.setCellPadding(6);
        format.setTopMargin(4);
        format.setBottomMargin(16);
        format.setWidth(QTextLength(QTextLength::PercentageLength, 100));
        table->setFormat(format);
    }
}

bool ManualView::goTo(const QString& anchor) {
    for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) {
        if (block.blockFormat().headingLevel() == 0 || heading_anchor(block.text()) != anchor)
            continue;
        // To the end first: then the heading comes to stand at the top, not at the bottom.
        moveCursor(QTextCursor::End);
        setTextCursor(QTextCursor(block));
        verticalScrollBar()->setValue(verticalScrollBar()->value() + cursorRect().top() - 8);
        anchor_ = anchor;
        sent_to_ = verticalScrollBar()->value();
        return true;
    }
    return false;
}

QVariant ManualView::loadResource(int type, const QUrl& name) {
    if (type != QTextDocument::ImageResource) return {};  // Nothing else belongs to a page.
    QImage picture(QFileInfo(path_).path() + "/" + name.path());
    const int room = set_for_ - 2 * kAroundText - 4;
    // A picture of few colours would be made grainy to keep to them.
    if (!picture.isNull() && room > 50 && picture.width() > room)
        picture = picture.convertToFormat(QImage::Format_RGB32)
                      .scaledToWidth(room, Qt::SmoothTransformation);
    return picture;
}

void ManualView::resizeEvent(QResizeEvent* event) {
    QTextBrowser::resizeEvent(event);
    resized_.start();
}

}  // namespace placode::ui
