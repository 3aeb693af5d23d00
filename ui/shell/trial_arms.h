// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The arms of a device that is tried: name, state, keys and signals of each, as they come.

#include <QCoreApplication>
#include <vector>

#include "ui/shell/app_context.h"
#include "ui/shell/device_tester.h"

class QLabel;
class QVBoxLayout;

namespace placode::ui {

class SignalView;

class TrialArms {
    Q_DECLARE_TR_FUNCTIONS(TrialCard)
 public:
    /// `context` must outlive it.
    explicit TrialArms(const AppContext& context);

    /// Belongs to whoever adds it to a layout.
    [[nodiscard]] QVBoxLayout* layout() const { return arms_; }
    [[nodiscard]] bool empty() const { return rows_.empty(); }
    /// True where one of them gives forces.
    bool show(const TrialState& state);

 private:
    void rebuild(const TrialState& state);

    struct Row {
        QLabel *name = nullptr, *status = nullptr, *keys = nullptr;
        SignalView* view = nullptr;
    };

    const AppContext& context_;
    std::vector<Row> rows_;
    QVBoxLayout* arms_ = nullptr;
};

}  // namespace placode::ui
