// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The exact text of a part that failed, for whoever helps: folded away behind "Details", to be
// marked and copied; a long one scrolls.

#include <QPlainTextEdit>
#include <QPushButton>

#include "ui/shell/app_context.h"

namespace placode::ui {

class Details : public QWidget {
    Q_OBJECT
 public:
    /// Empty text: nothing is shown.
    explicit Details(AppContext& context, const QString& text = {}, bool open = false);
    void setText(const QString& text, bool open = false);
    [[nodiscard]] QString text() const { return property("said").toString(); }
    [[nodiscard]] bool isOpen() const { return open_; }

 Q_SIGNALS:
    void folded();  ///< Opened or closed: it needs another height now.

 protected:
    void resizeEvent(QResizeEvent* event) override;

 private:
    void fold(bool open);
    bool fitHeight();

    QPushButton *toggle_ = nullptr, *copy_ = nullptr;
    QPlainTextEdit* text_ = nullptr;
    bool open_ = false;
};

}  // namespace placode::ui
