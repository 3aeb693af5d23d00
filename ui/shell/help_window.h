// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The manual beside the page that it explains: contents, search, back and forward. A window of its
// own, so that somebody can read a step and do it.

#include <QWidget>
#include <vector>

#include "ui/shell/manual.h"

class QLineEdit;
class QListWidget;
class QPushButton;
class QUrl;

namespace placode::ui {

class ManualView;

/// Main thread. Lives and closes with the main window; follows its language and theme.
class HelpWindow : public QWidget {
    Q_OBJECT
 public:
    HelpWindow(AppContext& context, QWidget* main_window);
    /// @param page "trainee-today.md", with "#anchor" where a heading is meant.
    void open(const QString& page);
    [[nodiscard]] QString shown() const { return here_; }

 protected:
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

 private:
    void build();
    [[nodiscard]] QWidget* buildBar();
    void turnTo(const QString& page);
    void step(std::vector<QString>& from, std::vector<QString>& to);
    void setListWidth();
    void fillList();
    void addRow(const QString& text, const QString& target);
    void openRow();
    void markRow();
    void follow(const QUrl& link);
    void updateButtons();

    AppContext& context_;
    Manual manual_;
    QString here_;  ///< Page and anchor.
    std::vector<QString> before_, after_;
    QWidget* content_ = nullptr;
    QPushButton *back_ = nullptr, *forward_ = nullptr;
    QLineEdit* typed_ = nullptr;
    QListWidget* list_ = nullptr;
    ManualView* view_ = nullptr;
};

/// Opens the manual of `main_window` at a page, or turns the one that is open to it.
void open_help(AppContext& context, QWidget* main_window, const QString& page);
/// Closes it, if it is open.
void close_help(QWidget* main_window);

}  // namespace placode::ui
