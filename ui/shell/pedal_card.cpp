// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/pedal_card.h"

#include <QComboBox>
#include <QHBoxLayout>

#include "ui/shell/details.h"
#include "ui/shell/parts.h"

namespace placode::ui {

using haptics::Station;

PedalCard::PedalCard(AppContext& context, StationWishes wishes)
    : context_(context), wishes_(std::move(wishes)), tester_(context.launcher().options()) {
    auto* layout = new QVBoxLayout;
    layout->setSpacing(kSpace12);
    layout->addWidget(make_label(tr("Foot pedals"), "heading"));
    layout->addWidget(
        make_label(tr("Choose the pedals, press each and say which one it is: yellow cuts, blue "
                      "coagulates. Pedals that a device brings itself need nothing here."),
                   "muted"));
    pedals_ = new QComboBox;
    pedals_->setObjectName("pedals");
    pedals_->setEditable(true);
    layout->addLayout(make_field(tr("Which pedals"), pedals_));
    auto* row = new QHBoxLayout;
    row->setSpacing(kSpace12);
    QPushButton* watch = make_button(context_, tr("Watch"), "secondary", "play");
    watch->setObjectName("watch_pedals");
    connect(watch, &QPushButton::clicked, this, [this] { this->watch(); });
    cut_ = make_button(context_, tr("This is the yellow one"), "secondary");
    cut_->setObjectName("pedal_cut");
    coag_ = make_button(context_, tr("This is the blue one"), "secondary");
    coag_->setObjectName("pedal_coag");
    connect(cut_, &QPushButton::clicked, this, [this] { keep("pedals.cut_key"); });
    connect(coag_, &QPushButton::clicked, this, [this] { keep("pedals.coag_key"); });
    for (QPushButton* button : {watch, cut_, coag_}) row->addWidget(button);
    row->addStretch();
    layout->addLayout(row);
    key_ = make_label({});
    key_->setObjectName("pedal_key");
    layout->addWidget(key_);
    details_ = new Details(context_);
    layout->addWidget(details_);
    cut_->setEnabled(false);
    coag_->setEnabled(false);
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(make_card(layout));
    connect(&tester_, &DeviceTester::stateChanged, this, [this] { moved(); });
    connect(&tester_, &DeviceTester::ended, this, [this](const QString& why) { ended(why); });
}

void PedalCard::fill(const QStringList& found) {
    const QString now = qstr(wishes_.station().text("pedals.device"));
    const QString typed = pedals_->currentText();
    pedals_->clear();
    pedals_->addItems(found);
    if (!now.isEmpty() && pedals_->findText(now) < 0) pedals_->addItem(now);
    pedals_->setCurrentText(typed.isEmpty() ? now : typed);
    if (pedals_->currentText().isEmpty() && pedals_->count() == 0)
        key_->setText(tr("No pedals were found."));
}

void PedalCard::watch() {
    const QString path = pedals_->currentText().trimmed();
    if (path.isEmpty()) return;
    key_->setText(tr("Press a pedal…"));
    details_->setText({});
    context_.guard(tr("Watching the pedals"), [&] { tester_.start("pedals:" + path, 0.5); });
}

void PedalCard::ended(const QString& why) {
    details_->setText(why);
    key_->setText(why.isEmpty() ? QString() : device_problem("pedals", why).way_out);
}

void PedalCard::moved() {
    const TrialState& state = tester_.state();
    if (!state.connected) return key_->setText(tr("The pedals are unplugged."));
    cut_->setEnabled(state.key > 0);
    coag_->setEnabled(state.key > 0);
    if (state.key == 0) return;
    const Station now = wishes_.station();
    QString name = tr("Key %1").arg(state.key);
    if (state.key == static_cast<int>(now.number("pedals.cut_key")))
        name += tr(", set as the yellow pedal");
    if (state.key == static_cast<int>(now.number("pedals.coag_key")))
        name += tr(", set as the blue pedal");
    key_->setText(state.pressed ? tr("%1 (pressed)").arg(name) : name);
}

void PedalCard::keep(const char* key) {
    const int code = tester_.state().key;
    const std::string path = pedals_->currentText().trimmed().toStdString();
    if (wishes_.change([&](Station& edited) {
            // One key cannot be both: the other pedal gets the key that this one had.
            const std::string other =
                std::string(key) == "pedals.cut_key" ? "pedals.coag_key" : "pedals.cut_key";
            if (static_cast<int>(edited.number(other)) == code) edited.set(other, edited.text(key));
            edited.set(key, std::to_string(code));
            edited.set("pedals.device", path);
        }))
        wishes_.notice(tr("The pedal was saved for this computer."));
    moved();
}

}  // namespace placode::ui
