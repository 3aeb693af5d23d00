// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The consent of a participant: the text, a box for every statement, and the signature, on the
// screen or on a sheet that the coordinator keeps.

#include <QVariantMap>
#include <functional>
#include <string>
#include <vector>

#include "curriculum/study.h"
#include "ui/shell/app_context.h"

namespace placode::ui {

/// What the participant decided.
struct ConsentAnswers {
    /// Ids of the statements agreed to; what the hand wrote, empty = signed on paper.
    std::function<void(const std::vector<std::string>& agreed, const QString& signature)> given;
    std::function<void()> refused;
    /// What stands in the form after every change, to be handed back when it is built anew in
    /// another theme; empty = nothing does.
    std::function<void(const QVariantMap& draft)> changed = {};
};

/// @param consent outlives the form.
/// @param draft from ConsentAnswers::changed; left out where it was ticked in another language:
/// consent is given in the language that it was read in.
[[nodiscard]] QWidget* make_consent_form(AppContext& context, const curriculum::Consent& consent,
                                         const ConsentAnswers& answers,
                                         const QVariantMap& draft = {});

}  // namespace placode::ui
