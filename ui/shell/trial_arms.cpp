// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/trial_arms.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QStyle>
#include <QVBoxLayout>

#include "ui/shell/parts.h"
#include "ui/shell/signal_view.h"

namespace placode::ui {
namespace {

void retone(QLabel* badge, const QString& text, const char* tone) {
    if (badge->text() == text) return;
    badge->setText(text);
    badge->setProperty("tone", tone);
    badge->style()->unpolish(badge);
    badge->style()->polish(badge);
}

void show_status(QLabel* badge, const TriedArm& arm) {
    if (arm.status == "ready") return retone(badge, TrialArms::tr("ready"), "good");
    if (arm.status == "resting")
        return retone(badge, TrialArms::tr("rests: take it out of its inkwell or cradle"), "warn");
    if (arm.status == "not_calibrated")
        return retone(badge, TrialArms::tr("not calibrated: follow the steps above"), "critical");
    if (arm.status == "lost")
        return retone(badge, TrialArms::tr("lost: is it plugged in and switched on?"), "critical");
    retone(badge, TrialArms::tr("fault"), "critical");
}

QString keys_of(const TriedArm& arm) {
    QStringList held;
    for (unsigned i = 0; i < 4; ++i)
        if ((arm.buttons >> i & 1u) != 0) held << TrialArms::tr("button %1").arg(i + 1);
    if ((arm.pedals & 1u) != 0) held << TrialArms::tr("yellow pedal");
    if ((arm.pedals & 2u) != 0) held << TrialArms::tr("blue pedal");
    const QString turn = TrialArms::tr("turn %1°").arg(format_number(arm.roll_deg, 0));
    return held.isEmpty() ? turn : turn + " · " + held.join(", ");
}

}  // namespace

TrialArms::TrialArms(const AppContext& context) : context_(context), arms_(new QVBoxLayout) {
    arms_->setSpacing(kSpace12);
}

void TrialArms::rebuild(const TrialState& state) {
    while (QLayoutItem* item = arms_->takeAt(0)) {
        if (item->widget() != nullptr) item->widget()->deleteLater();
        delete item;
    }
    rows_.clear();
    for (size_t i = 0; i < state.arms.size(); ++i) {
        auto* box = new QWidget;
        auto* layout = new QVBoxLayout(box);
        layout->setContentsMargins(0, 0, 0, 0);
        layout->setSpacing(kSpace4);
        auto* line = new QHBoxLayout;
        line->setSpacing(kSpace8);
        Row row;
        row.name = make_label(state.arms[i].name);
        row.name->setObjectName(QString("arm_name_%1").arg(i));
        row.name->setWordWrap(false);
        row.status = make_badge("–", "");
        row.status->setObjectName(QString("arm_status_%1").arg(i));
        row.keys = make_label({}, "small");
        row.keys->setObjectName(QString("arm_keys_%1").arg(i));
        row.keys->setWordWrap(false);
        line->addWidget(row.name);
        line->addWidget(row.status);
        line->addStretch();
        line->addWidget(row.keys);
        layout->addLayout(line);
        row.view = new SignalView(context_.colors());
        row.view->setAccessibleName(tr("Signals of %1").arg(state.arms[i].name));
        row.view->setFixedHeight(200);
        layout->addWidget(row.view);
        arms_->addWidget(box);
        rows_.push_back(row);
    }
}

bool TrialArms::show(const TrialState& state) {
    if (rows_.size() != state.arms.size()) rebuild(state);
    bool force = false;
    for (size_t i = 0; i < rows_.size(); ++i) {
        const TriedArm& arm = state.arms[i];
        force = force || arm.force_device;
        rows_[i].name->setText(
            (arm.hand == "left" ? tr("Left hand: %1") : tr("Right hand: %1")).arg(arm.name));
        show_status(rows_[i].status, arm);
        rows_[i].keys->setText(keys_of(arm));
        rows_[i].view->show(arm, state.limit_n, state.floor);
    }
    return force;
}

}  // namespace placode::ui
