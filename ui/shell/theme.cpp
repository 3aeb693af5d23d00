// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/theme.h"

#include <QApplication>
#include <QFile>
#include <QFont>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QPixmap>
#include <QStyleFactory>
#include <QSvgRenderer>

// A resource of a static library is registered only when somebody asks; outside any namespace.
static void register_resources() { Q_INIT_RESOURCE(shell); }

namespace placode::ui {
namespace {

/// Renders the SVG at the size and pixel ratio that the widget asks for.
/// Of what cannot be pressed: seen on the grey of a button that is off, in both themes.
constexpr const char* kOff = "#82888F";

class LineIconEngine : public QIconEngine {
 public:
    LineIconEngine(QByteArray svg, QByteArray off) : svg_(std::move(svg)), off_(std::move(off)) {}
    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
        QSvgRenderer renderer(mode == QIcon::Disabled ? off_ : svg_);
        painter->setRenderHint(QPainter::Antialiasing);
        renderer.render(painter, QRectF(rect));
    }
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        QPixmap pixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, QRect(QPoint(0, 0), size), mode, state);
        return pixmap;
    }
    [[nodiscard]] QIconEngine* clone() const override { return new LineIconEngine(svg_, off_); }

 private:
    QByteArray svg_, off_;
};

Tokens make_tokens(ThemeKind theme) {
    Tokens t;
    if (theme == ThemeKind::kLight) {
        t.surface = "#FAFAF8", t.raised = "#FFFFFF", t.line = "#E3E2DC";
        t.text = "#1C1E21", t.muted = "#5D646C";
        t.accent = "#0B6E77", t.on_accent = "#FFFFFF", t.accent_soft = "#E4F0F1";
        t.good = "#2C774B", t.good_soft = "#E6F2EA";
        t.warn = "#9C5D00", t.warn_soft = "#FBF1DF";
        t.critical = "#B3261E", t.critical_soft = "#FBE9E7";
        t.hover = "#F2F2EE", t.field = "#8C9097";
        return t;
    }
    t.surface = "#16181B", t.raised = "#1F2226", t.line = "#33373D";
    t.text = "#ECEDEE", t.muted = "#9AA3AD";
    t.accent = "#4FB8C2", t.on_accent = "#0E1A1C", t.accent_soft = "#1D3538";
    t.good = "#6CC58F", t.good_soft = "#1E3327";
    t.warn = "#E0A44A", t.warn_soft = "#382D1B";
    t.critical = "#F2857C", t.critical_soft = "#3D2422";
    t.hover = "#282C31", t.field = "#6F7782";
    return t;
}

/// `@name@` stands for a token. One sheet, both themes.
constexpr const char* kSheet = R"(
* { outline: none; }
QWidget { color: @text@; font-size: 14px; }
QMainWindow, QWidget[role="page"], QStackedWidget, QScrollArea, QScrollArea > QWidget > QWidget[role="page"] { background: @surface@; }
QScrollArea { border: none; }
QLabel { background: transparent; }
QLabel[role="display"] { font-size: 28px; font-weight: 600; }
QLabel[role="title"] { font-size: 20px; font-weight: 600; }
QLabel[role="heading"] { font-size: 16px; font-weight: 600; }
QLabel[role="muted"] { color: @muted@; }
QLabel[role="small"] { color: @muted@; font-size: 12px; }
QLabel[role="rail_heading"] { color: @muted@; font-size: 12px; font-weight: 600; padding: 8px 12px 0 12px; }
QLabel[role="good"] { color: @good@; font-weight: 600; }
QLabel[role="warn"] { color: @warn@; font-weight: 600; }
QLabel[role="critical"] { color: @critical@; font-weight: 600; }
QLabel[role="badge"] { border-radius: 8px; padding: 3px 8px; font-size: 12px; font-weight: 600; background: @hover@; color: @muted@; }
QLabel[role="badge"][tone="accent"] { background: @accent_soft@; color: @accent@; }
QLabel[role="badge"][tone="good"] { background: @good_soft@; color: @good@; }
QLabel[role="badge"][tone="warn"] { background: @warn_soft@; color: @warn@; }
QLabel[role="badge"][tone="critical"] { background: @critical_soft@; color: @critical@; }
QFrame[role="card"] { background: @raised@; border: 1px solid @line@; border-radius: 8px; }
QFrame[role="card"][tone="accent"] { border: 2px solid @accent@; }
QFrame[role="card"][tone="critical"] { border: 2px solid @critical@; }
QFrame[role="rule"] { background: @line@; max-height: 1px; min-height: 1px; border: none; }
QFrame[role="rail"] { background: @raised@; border: none; border-right: 1px solid @line@; }
QFrame[role="bar"] { background: @raised@; border: none; border-bottom: 1px solid @line@; }
QFrame[role="banner"] { border-radius: 8px; border: 1px solid @line@; background: @accent_soft@; }
QFrame[role="banner"][tone="problem"] { background: @critical_soft@; border: 1px solid @critical@; }
QFrame[role="banner"][tone="warn"] { background: @warn_soft@; border: 1px solid @warn@; }
QFrame[role="banner"][tone="good"] { background: @good_soft@; border: 1px solid @good@; }
QPushButton, QToolButton { min-height: 40px; padding: 0 16px; border-radius: 8px; border: 2px solid transparent; font-weight: 600; background: @hover@; color: @text@; }
QPushButton:hover, QToolButton:hover { background: @line@; }
QPushButton:disabled, QToolButton:disabled { color: @muted@; background: @hover@; }
QPushButton:focus, QToolButton:focus { border: 2px solid @accent@; }
QPushButton[role="primary"] { background: @accent@; color: @on_accent@; }
QPushButton[role="primary"]:hover { background: @accent_hover@; }
QPushButton[role="primary"]:focus { border: 2px solid @text@; }
QPushButton[role="primary"]:disabled { background: @line@; color: @muted@; }
QPushButton[role="secondary"] { background: @raised@; border: 1px solid @field@; }
QPushButton[role="secondary"]:hover { background: @hover@; }
QPushButton[role="secondary"]:focus { border: 2px solid @accent@; }
QPushButton[role="danger"] { background: @raised@; border: 1px solid @critical@; color: @critical@; }
QPushButton[role="danger"]:hover { background: @critical_soft@; }
QPushButton[role="danger"]:focus { border: 2px solid @accent@; }
QPushButton[role="secondary"]:disabled, QPushButton[role="danger"]:disabled { background: @hover@; border: 1px solid @line@; color: @muted@; }
QPushButton[scale="large"] { min-height: 48px; font-size: 16px; }
QPushButton[role="quiet"], QToolButton { background: transparent; }
QPushButton[role="icon"] { background: transparent; padding: 0; }
QPushButton[role="icon"]:hover { background: @hover@; }
QPushButton[role="quiet"]:hover, QToolButton:hover { background: @hover@; }
QToolButton[role="rail"] { text-align: left; padding: 0 12px; color: @muted@; }
QToolButton[role="rail"]:checked { background: @accent_soft@; color: @accent@; }
QToolButton::menu-indicator { image: none; }
QLineEdit, QComboBox, QSpinBox, QDoubleSpinBox, QDateEdit, QPlainTextEdit { background: @raised@; border: 1px solid @field@; border-radius: 8px; padding: 0 12px; min-height: 42px; selection-background-color: @accent@; selection-color: @on_accent@; }
QLineEdit:focus, QComboBox:focus, QSpinBox:focus, QDoubleSpinBox:focus, QDateEdit:focus, QPlainTextEdit:focus { border: 2px solid @accent@; padding: 0 11px; }
QPlainTextEdit[role="details"] { background: @surface@; border: 1px solid @line@; border-radius: 6px; padding: 4px; min-height: 0; font-size: 12px; color: @text@; }
QPlainTextEdit[role="details"]:focus { border: 2px solid @accent@; padding: 3px; }
QTextBrowser:focus { border: 2px solid @accent@; }
QLineEdit:disabled, QComboBox:disabled { color: @muted@; background: @surface@; }
QLineEdit[tone="critical"] { border: 2px solid @critical@; }
QLineEdit[tone="critical"]:focus { background: @critical_soft@; }
QSlider { border: 2px solid transparent; border-radius: 8px; }
QSlider:focus { border: 2px solid @accent@; }
QComboBox::drop-down, QDateEdit::drop-down { border: none; width: 32px; }
QComboBox::down-arrow, QDateEdit::down-arrow { image: url(@chevron@); width: 16px; height: 16px; }
QSpinBox::up-button, QDoubleSpinBox::up-button { subcontrol-origin: border; subcontrol-position: center right; width: 32px; height: 40px; border: none; border-left: 1px solid @line@; }
QSpinBox::down-button, QDoubleSpinBox::down-button { subcontrol-origin: border; subcontrol-position: center right; right: 33px; width: 32px; height: 40px; border: none; border-left: 1px solid @line@; }
QSpinBox::up-arrow, QDoubleSpinBox::up-arrow { image: url(@plus@); width: 16px; height: 16px; }
QSpinBox::down-arrow, QDoubleSpinBox::down-arrow { image: url(@minus@); width: 16px; height: 16px; }
QComboBox QAbstractItemView { background: @raised@; border: 1px solid @line@; selection-background-color: @accent_soft@; selection-color: @text@; padding: 4px; }
QComboBox QAbstractItemView::item { min-height: 44px; padding: 0 8px; }
QCheckBox, QRadioButton { spacing: 8px; min-height: 44px; background: transparent; }
QCheckBox:focus, QRadioButton:focus { color: @accent@; }
QCheckBox::indicator, QRadioButton::indicator { width: 20px; height: 20px; border: 2px solid @field@; background: @raised@; }
QCheckBox::indicator { border-radius: 5px; }
QRadioButton::indicator { border-radius: 12px; }
QCheckBox::indicator:focus, QRadioButton::indicator:focus { border-color: @accent@; }
QCheckBox::indicator:checked { border-color: @accent@; background: @accent@; image: url(@check@); }
QRadioButton::indicator:checked { border-color: @accent@; background: qradialgradient(cx:0.5, cy:0.5, radius:0.5, fx:0.5, fy:0.5, stop:0 @accent@, stop:0.55 @accent@, stop:0.65 @raised@, stop:1 @raised@); }
QTableWidget { background: @raised@; alternate-background-color: @raised@; border: 1px solid @line@; border-radius: 8px; gridline-color: transparent; selection-background-color: @accent_soft@; selection-color: @text@; }
QListWidget { background: @raised@; border: 1px solid @line@; border-radius: 8px; }
QListWidget:focus { border: 2px solid @accent@; }
QListWidget::item { padding: 0 12px; border-radius: 6px; }
QListWidget::item:selected { background: @accent_soft@; color: @text@; }
QTableWidget:focus { border: 2px solid @accent@; }
QTableWidget::item { border-bottom: 1px solid @line@; padding: 0 9px; }
QTableWidget::item:hover { background: @hover@; }
QTableWidget::item:selected { background: @accent_soft@; color: @text@; }
QHeaderView { background: transparent; }
QHeaderView::section { background: @raised@; color: @muted@; border: none; border-bottom: 1px solid @field@; padding: 0 12px; min-height: 40px; font-size: 12px; font-weight: 600; text-align: left; }
QHeaderView::section:horizontal:first { border-top-left-radius: 7px; }
QHeaderView::section:horizontal:last { border-top-right-radius: 7px; }
QHeaderView::section:horizontal:only-one { border-top-left-radius: 7px; border-top-right-radius: 7px; }
QHeaderView::section:hover { color: @text@; }
QTableCornerButton::section { background: @raised@; border: none; }
QProgressBar { border: none; border-radius: 4px; background: @line@; min-height: 8px; max-height: 8px; }
QProgressBar::chunk { border-radius: 4px; background: @accent@; }
QScrollBar:vertical { background: transparent; width: 12px; margin: 0; }
QScrollBar:horizontal { background: transparent; height: 12px; margin: 0; }
QScrollBar::handle { background: @scroll@; border-radius: 4px; margin: 2px; min-height: 32px; min-width: 32px; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }
QMenu { background: @raised@; border: 1px solid @line@; padding: 4px; }
QMenu::item { min-height: 36px; padding: 4px 24px 4px 12px; border-radius: 6px; }
QMenu::item:selected { background: @accent_soft@; }
QMenu::separator { height: 1px; background: @line@; margin: 4px 8px; }
QToolTip { background: @raised@; color: @text@; border: 1px solid @line@; padding: 6px; }
QDialog, QMessageBox { background: @raised@; }
QFrame[role="dialog_frame"] { background: transparent; border: 2px solid @accent@; }
QFrame[role="choice"] { background: @raised@; border: 1px solid @line@; border-radius: 8px; }
)";

QColor mixed(const QColor& a, const QColor& b, double share_b) {
    return QColor::fromRgbF(static_cast<float>(a.redF() * (1 - share_b) + b.redF() * share_b),
                            static_cast<float>(a.greenF() * (1 - share_b) + b.greenF() * share_b),
                            static_cast<float>(a.blueF() * (1 - share_b) + b.blueF() * share_b));
}

QString style_sheet(ThemeKind theme) {
    const Tokens& t = tokens(theme);
    const bool light = theme == ThemeKind::kLight;
    const std::pair<const char*, QString> names[] = {
        {"@surface@", t.surface.name()},
        {"@raised@", t.raised.name()},
        {"@line@", t.line.name()},
        {"@text@", t.text.name()},
        {"@muted@", t.muted.name()},
        {"@accent@", t.accent.name()},
        {"@accent_hover@", mixed(t.accent, t.text, 0.18).name()},
        {"@on_accent@", t.on_accent.name()},
        {"@accent_soft@", t.accent_soft.name()},
        {"@good@", t.good.name()},
        {"@good_soft@", t.good_soft.name()},
        {"@warn@", t.warn.name()},
        {"@warn_soft@", t.warn_soft.name()},
        {"@critical@", t.critical.name()},
        {"@critical_soft@", t.critical_soft.name()},
        {"@hover@", t.hover.name()},
        {"@field@", t.field.name()},
        {"@scroll@", mixed(t.line, t.muted, 0.35).name()},
        {"@chevron@", light ? ":/icons/chevron-light.svg" : ":/icons/chevron-dark.svg"},
        {"@plus@", light ? ":/icons/plus-light.svg" : ":/icons/plus-dark.svg"},
        {"@minus@", light ? ":/icons/minus-light.svg" : ":/icons/minus-dark.svg"},
        {"@check@", light ? ":/icons/check-light.svg" : ":/icons/check-dark.svg"},
    };
    QString sheet = QString::fromLatin1(kSheet);
    for (const auto& [name, value] : names) sheet.replace(QLatin1String(name), value);
    return sheet;
}

}  // namespace

const Tokens& tokens(ThemeKind theme) {
    static const Tokens kLight = make_tokens(ThemeKind::kLight);
    static const Tokens kDark = make_tokens(ThemeKind::kDark);
    return theme == ThemeKind::kLight ? kLight : kDark;
}

void apply_theme(QApplication& application, ThemeKind theme) {
    register_resources();
    const Tokens& t = tokens(theme);
    // Named, because the default "Sans Serif" resolves differently on every machine.
    QFont font;
    font.setFamilies({"Noto Sans", "DejaVu Sans"});
    font.setPixelSize(14);
    application.setFont(font);
    application.setStyle(QStyleFactory::create("Fusion"));
    QPalette palette;
    palette.setColor(QPalette::Window, t.surface);
    palette.setColor(QPalette::Base, t.raised);
    palette.setColor(QPalette::AlternateBase, t.hover);
    palette.setColor(QPalette::Button, t.raised);
    palette.setColor(QPalette::ToolTipBase, t.raised);
    palette.setColor(QPalette::Highlight, t.accent);
    palette.setColor(QPalette::HighlightedText, t.on_accent);
    palette.setColor(QPalette::PlaceholderText, t.muted);
    palette.setColor(QPalette::Link, t.accent);
    for (const QPalette::ColorRole role :
         {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText}) {
        palette.setColor(role, t.text);
        palette.setColor(QPalette::Disabled, role, t.muted);
    }
    application.setPalette(palette);
    application.setStyleSheet(style_sheet(theme));
}

reports::ChartStyle chart_style(ThemeKind theme, double font_px) {
    const Tokens& t = tokens(theme);
    reports::ChartStyle style;
    style.text = t.text.rgba();
    style.muted = t.muted.rgba();
    style.line = t.line.rgba();
    style.accent = t.accent.rgba();
    style.surface = t.raised.rgba();
    style.good = t.good.rgba();
    style.warn = t.warn.rgba();
    style.critical = t.critical.rgba();
    style.font_px = font_px;
    return style;
}

QIcon line_icon(const QString& name, const QColor& color) {
    register_resources();
    QFile file(":/icons/" + name + ".svg");
    if (!file.open(QIODevice::ReadOnly)) return {};
    const QByteArray black = file.readAll();
    const auto in = [&](const QByteArray& name) {
        return QByteArray(black).replace("#000000", name);
    };
    return QIcon(new LineIconEngine(in(color.name().toLatin1()), in(kOff)));
}

}  // namespace placode::ui
