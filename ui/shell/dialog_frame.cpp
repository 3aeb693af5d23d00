// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/dialog_frame.h"

#include <QApplication>
#include <QDialog>
#include <QEvent>
#include <QFrame>
#include <QLayout>
#include <QPainter>
#include <QPointer>
#include <QTimer>

namespace placode::ui {
namespace {

constexpr int kDimAlpha = 110;       ///< Of black over the page; 255 hides it.
constexpr int kAfterDialogMs = 300;  ///< Until what a dialog was asked for has come to its end.

/// Lies over all of its parent, whatever size that takes, and lets every click through.
class Cover : public QFrame {
 public:
    Cover(QWidget* parent, QColor fill) : QFrame(parent), fill_(fill) {
        setAttribute(Qt::WA_TransparentForMouseEvents);
        parent->installEventFilter(this);
        setGeometry(parent->rect());
        raise();
    }

 protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::Resize || event->type() == QEvent::Show ||
            event->type() == QEvent::ChildAdded) {
            setGeometry(parentWidget()->rect());
            raise();
        }
        return QFrame::eventFilter(watched, event);
    }
    void paintEvent(QPaintEvent* event) override {
        if (fill_.isValid())
            QPainter(this).fillRect(rect(), fill_);
        else
            QFrame::paintEvent(event);
    }

 private:
    QColor fill_;
};

/// Dims the window as long as the dialog is on the screen.
class Dimming : public QObject {
 public:
    Dimming(QDialog* dialog, QWidget* behind)
        : QObject(dialog), cover_(new Cover(behind, QColor(0, 0, 0, kDimAlpha))) {
        cover_->setObjectName("dimmed");
        cover_->hide();
        dialog->installEventFilter(this);
    }
    ~Dimming() override { delete cover_; }

 protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (cover_ && event->type() == QEvent::Show) cover_->show();
        if (cover_ && event->type() == QEvent::Hide) cover_->hide();
        return QObject::eventFilter(watched, event);
    }

 private:
    QPointer<Cover> cover_;  ///< Goes with the window, if that goes first.
};

}  // namespace

void frame_dialog(QDialog* dialog) {
    auto* frame = new Cover(dialog, {});
    frame->setObjectName("dialog_frame");
    frame->setProperty("role", "dialog_frame");
    if (dialog->parentWidget() != nullptr) new Dimming(dialog, dialog->parentWidget()->window());
}

void make_room(QDialog* dialog) {
    QLayout* layout = dialog->layout();
    layout->activate();
    const int needed = layout->hasHeightForWidth() ? layout->totalHeightForWidth(dialog->width())
                                                   : layout->totalSizeHint().height();
    if (needed > dialog->height()) dialog->resize(dialog->width(), needed);
}

bool question_stands() {
    return QApplication::activeModalWidget() != nullptr ||
           QApplication::activePopupWidget() != nullptr;
}

void when_no_question(QObject* receiver, const std::function<void()>& act) {
    if (!question_stands()) return act();
    QTimer::singleShot(kAfterDialogMs, receiver,
                       [receiver, act] { when_no_question(receiver, act); });
}

}  // namespace placode::ui
