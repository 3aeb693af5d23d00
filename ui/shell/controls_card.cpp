// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/controls_card.h"

#include <QCheckBox>
#include <QCoreApplication>
#include <QGridLayout>
#include <QHBoxLayout>
#include <map>

#include "haptics/control_words.h"
#include "ui/shell/key_button.h"
#include "ui/shell/parts.h"

namespace placode::ui {
namespace {

using haptics::Control;
using haptics::ControlLayout;
using sim::Key;

QString setting_of(const AppContext& context) {
    return "controls/" + QString::number(context.user().id);
}

QString action_words(const Control& control) {
    return QCoreApplication::translate("Layout", control.action.data());
}

class ControlsCard : public QFrame {
    Q_DECLARE_TR_FUNCTIONS(ControlsCard)
 public:
    explicit ControlsCard(AppContext& context) : context_(context), layout_(own_layout(context)) {
        setProperty("role", "card");
        setObjectName("controls_card");
        auto* column = new QVBoxLayout(this);
        column->setContentsMargins(kSpace24, kSpace16, kSpace24, kSpace24);
        column->setSpacing(kSpace12);
        column->addWidget(make_label(tr("Keys and buttons"), "heading"));
        column->addWidget(make_label(
            tr("For mouse, keyboard and gamepad, at this computer. The help and the hints name the "
               "keys that you choose. Press a key below to change it; Enter, Escape and the "
               "function keys always stay."),
            "muted"));
        column->addLayout(wholeLayouts());
        column->addLayout(keys());
        buttons_ = exchange(tr("Exchange the left and right mouse button"), "exchange_buttons");
        sticks_ = exchange(tr("Exchange the sticks of the gamepad"), "exchange_sticks");
        column->addWidget(buttons_);
        column->addWidget(
            make_label(tr("Not if the desktop has exchanged them already."), "small"));
        column->addWidget(sticks_);
        said_ = make_hint("small");
        said_->setObjectName("controls_said");
        column->addWidget(said_);
        fill();
    }

 private:
    QHBoxLayout* wholeLayouts() {
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace12);
        usual_ = make_button(context_, tr("As delivered"), "secondary");
        usual_->setObjectName("layout_usual");
        left_ = make_button(context_, tr("Mouse in the left hand"), "secondary");
        left_->setObjectName("layout_left");
        connect(usual_, &QPushButton::clicked, this,
                [this] { keep({}, tr("All keys and buttons are as delivered.")); });
        connect(left_, &QPushButton::clicked, this, [this] {
            keep(ControlLayout::left_handed(),
                 tr("The keys are below the right hand now, and the mouse buttons exchanged."));
        });
        row->addWidget(usual_);
        row->addWidget(left_);
        row->addStretch();
        return row;
    }

    /// In two columns, first down and then right, as Tab goes.
    QGridLayout* keys() {
        auto* grid = new QGridLayout;
        grid->setHorizontalSpacing(kSpace12);
        grid->setVerticalSpacing(kSpace4);
        const auto controls = haptics::layout_controls();
        const int rows = (static_cast<int>(controls.size()) + 1) / 2;
        for (int i = 0; i < static_cast<int>(controls.size()); ++i) {
            const Control& control = controls[static_cast<size_t>(i)];
            auto* button = new KeyButton;
            button->setObjectName("key_" + QString::fromLatin1(control.name.data()));
            connect(button, &KeyButton::chosen, this,
                    [this, &control](Key key) { put(control, key); });
            connect(button, &KeyButton::refused, this, [this](const QString& key) {
                say(tr("%1 cannot be chosen. Letters, digits from 3, signs, arrows, the number "
                       "pad, "
                       "Space, Tab, Shift, Ctrl and Alt can.")
                        .arg(key.isEmpty() ? tr("This key") : key));
            });
            keys_[control.does] = button;
            QLabel* name = make_label(action_words(control));
            name->setBuddy(button);
            grid->addWidget(name, i % rows, 2 * (i / rows));
            grid->addWidget(button, i % rows, 2 * (i / rows) + 1);
        }
        grid->setColumnStretch(0, 1);
        grid->setColumnStretch(2, 1);
        return grid;
    }

    QCheckBox* exchange(const QString& text, const char* name) {
        auto* box = new QCheckBox(text);
        box->setObjectName(name);
        connect(box, &QCheckBox::clicked, this, [this] {
            ControlLayout changed = layout_;
            changed.buttons_exchanged = buttons_->isChecked();
            changed.sticks_exchanged = sticks_->isChecked();
            keep(changed, tr("Kept."));
        });
        return box;
    }

    void put(const Control& control, Key key) {
        const Key before = layout_.key_for(control.does);
        const Key other = layout_.does(key);
        ControlLayout changed = layout_;
        if (!changed.put(control.does, key)) return fill();
        QString said = tr("%1: %2.").arg(action_words(control), keyName(key));
        for (const Control& each : haptics::layout_controls())
            if (each.does == other && other != control.does)
                said += " " +
                        tr("%1, which was there, got %2.").arg(action_words(each), keyName(before));
        keep(changed, said);
    }

    void keep(const ControlLayout& changed, const QString& said) {
        layout_ = changed;
        const std::string text = layout_.text();
        context_.setStoreSetting(setting_of(context_), text.empty() ? QVariant() : qstr(text));
        fill();
        say(said);
    }

    void fill() {
        for (const auto& [does, button] : keys_) {
            button->showKey(layout_.key_for(does), context_.language());
            for (const Control& control : haptics::layout_controls())
                if (control.does == does)
                    button->setAccessibleName(
                        tr("%1: %2").arg(action_words(control), button->text()));
        }
        buttons_->setChecked(layout_.buttons_exchanged);
        sticks_->setChecked(layout_.sticks_exchanged);
        usual_->setEnabled(layout_ != ControlLayout());
        left_->setEnabled(layout_ != ControlLayout::left_handed());
    }

    void say(const QString& text) {
        said_->setText(text);
        said_->show();
    }

    [[nodiscard]] QString keyName(Key key) const {
        return qstr(haptics::key_name_in(key, context_.language().toStdString()));
    }

    AppContext& context_;
    ControlLayout layout_;
    std::map<Key, KeyButton*> keys_;
    QPushButton *usual_ = nullptr, *left_ = nullptr;
    QCheckBox *buttons_ = nullptr, *sticks_ = nullptr;
    QLabel* said_ = nullptr;
};

}  // namespace

ControlLayout own_layout(const AppContext& context) {
    if (!context.signedIn()) return {};
    const std::string text = context.storeSetting(setting_of(context)).toString().toStdString();
    try {
        return ControlLayout::parse(text);
    } catch (const haptics::LayoutError&) {
        return {};  // Of a newer Placode, or edited: as delivered, and chosen anew on the page.
    }
}

QWidget* make_controls_card(AppContext& context) { return new ControlsCard(context); }

}  // namespace placode::ui
