// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Parts that pages are built from, so that every page has the same labels, buttons, tables and
// numbers. They look by their `role` property, which the style sheet knows.

#include <QComboBox>
#include <QDateTime>
#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <QString>
#include <QTableWidget>
#include <QVBoxLayout>
#include <functional>

#include "db/records.h"
#include "ui/shell/app_context.h"

namespace placode::ui {

[[nodiscard]] inline QString qstr(const std::string& text) { return QString::fromStdString(text); }

/// Roles: display, title, heading, body, muted, small, good, warn, critical.
[[nodiscard]] QLabel* make_label(const QString& text, const char* role = "body");
/// For what comes and goes: hidden it keeps the room of a line, so that nothing below moves under
/// the pointer.
[[nodiscard]] QLabel* make_hint(const char* role = "small");
/// Tones: "", accent, good, warn, critical.
[[nodiscard]] QLabel* make_badge(const QString& text, const char* tone = "");
[[nodiscard]] QLabel* make_demonstration_badge();
/// Roles: primary, secondary, danger, quiet. `icon` may be empty.
[[nodiscard]] QPushButton* make_button(const AppContext& context, const QString& text,
                                       const char* role, const QString& icon = {});
/// Another icon in the colour of the button's role.
void set_button_icon(const AppContext& context, QPushButton* button, const QString& icon);
/// Of two presses of the pointer that were meant as one this button takes the first only, as
/// primary and danger do by themselves: for one that takes something out of a list, where the next
/// comes to stand in its place.
QPushButton* press_once(QPushButton* button);
/// A raised card; the layout has the card's margins set.
[[nodiscard]] QFrame* make_card(QLayout* content);
[[nodiscard]] QFrame* make_rule();
/// A label above a field; the field gets the label as accessible name.
[[nodiscard]] QVBoxLayout* make_field(const QString& name, QWidget* field);

/// A list whose longest entry must not push the page aside: room for `letters`, for more where the
/// layout has it; what is chosen stands in the tool tip, too.
void keep_narrow(QComboBox* list, int letters = 20);

/// Table with sorting, whole rows, 44 px rows and a name for screen readers.
[[nodiscard]] QTableWidget* make_table(const QStringList& headers, const QString& name);
/// Text cell; sorted as text.
[[nodiscard]] QTableWidgetItem* make_cell(const QString& text);
/// Number cell: right-aligned, sorted by `value`.
[[nodiscard]] QTableWidgetItem* make_number_cell(const QString& text, double value);
/// Sizes columns to content and lets `stretch` take the rest.
void fit_columns(QTableWidget* table, int stretch);

/// Asks with verbs on the buttons; true when `verb` was chosen. Escape and Enter keep: `stay` is
/// the word on that button, empty = "Keep".
[[nodiscard]] bool confirm(QWidget* parent, const QString& title, const QString& text,
                           const QString& verb, const QString& stay = {});

/// A picture drawn by a function, cached per size. `description` is read to those who cannot see.
[[nodiscard]] QWidget* make_picture(std::function<void(QPainter&, const QRectF&)> draw, QSize least,
                                    const QString& name, const QString& description);

/// A scrolling column of at most `width` px that holds a page's content.
[[nodiscard]] QVBoxLayout* make_column(QWidget* page, int width = 1080);
/// Scrolls such a column to a card of it, once both are laid out, and puts the focus into the card.
void begin_at(QWidget* card);

// part_words.cpp
[[nodiscard]] QString format_number(double value, int decimals);
/// A metric's value with decimals that fit its size.
[[nodiscard]] QString format_value(double value);
[[nodiscard]] QString format_duration(double seconds);      ///< "1:05", "34 s"
[[nodiscard]] QString format_when(const std::string& utc);  ///< Local date and time.
[[nodiscard]] QString format_clock(const QString& utc);     ///< Local time only.
[[nodiscard]] QString format_points(double points);         ///< "84", "69.6"
[[nodiscard]] QString points_words(double points);          ///< "84 points", "69.6 points"
[[nodiscard]] int whole_points(double points);              ///< The number that it shows.
[[nodiscard]] QString verdict_word(const db::AttemptRecord& attempt);
[[nodiscard]] const char* verdict_tone(const db::AttemptRecord& attempt);
[[nodiscard]] QString end_word(sim::EndReason reason);
[[nodiscard]] QString role_names(db::Roles roles);
[[nodiscard]] QString device_name(const std::string& device);

}  // namespace placode::ui
