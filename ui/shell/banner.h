// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The strip at the top of a page that says what happened: a problem with its thing, value and way
// out, or something calm with one thing to do.

#include <QFrame>
#include <functional>

#include "ui/shell/app_context.h"

class QHBoxLayout;
class QLabel;
class QPushButton;

namespace placode::ui {

class Banner : public QFrame {
    Q_OBJECT
 public:
    /// What the button of a banner does.
    struct Offer {
        QString text;
        std::function<void()> act;
    };

    explicit Banner(AppContext& context);

    void showProblem(const Problem& problem);
    /// Good news or a question; `offer` may be empty.
    void showNotice(const QString& text, const Offer& offer = {});
    /// Shows what `other` shows: the frame was rebuilt in another theme or language.
    void takeOver(const Banner& other);
    [[nodiscard]] QString text() const;

 private:
    void present(const char* tone, const char* icon, const QColor& color);

    AppContext& context_;
    QLabel *icon_ = nullptr, *title_ = nullptr, *detail_ = nullptr;
    QPushButton* offer_button_ = nullptr;
    Offer offer_;
};

}  // namespace placode::ui
