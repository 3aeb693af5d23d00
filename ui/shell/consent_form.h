// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The consent of a participant: the text, a box for every statement, and the signature, on the
// screen or on a sheet that the coordinator keeps.

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
};

/// @param consent outlives the form.
[[nodiscard]] QWidget* make_consent_form(AppContext& context, const curriculum::Consent& consent,
                                         const ConsentAnswers& answers);

}  // namespace placode::ui
