// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One page of the manual, set for reading: headings that links find, pictures no wider than the
// window, tables with lines.

#include <QTextBrowser>
#include <QTimer>

#include "ui/shell/theme.h"

namespace placode::ui {

/// Main thread. Follows no link by itself: QTextBrowser::anchorClicked says which was chosen.
class ManualView : public QTextBrowser {
    Q_OBJECT
 public:
    explicit ManualView(QWidget* parent = nullptr);
    /// @param path of the Markdown file. @param anchor of a heading; empty = the beginning.
    void showFile(const QString& path, const QString& anchor, const Tokens& colors);
    /// False when no heading has this anchor.
    bool goTo(const QString& anchor);

 protected:
    QVariant loadResource(int type, const QUrl& name) override;
    void resizeEvent(QResizeEvent* event) override;

 private:
    void set();
    void setAgain();
    void setHeadings();
    void setTables();
    QString path_;
    QString anchor_;   ///< Of the heading that the reader was sent to.
    int sent_to_ = 0;  ///< Where that was [px].
    Tokens colors_;
    QTimer resized_;
    int set_for_ = 0;  ///< Width that the pictures were made for [px].
};

}  // namespace placode::ui
