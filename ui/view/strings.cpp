// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/strings.h"

#include "sim/core/translation.h"

namespace placode::view {

std::string translated(std::string_view english, std::string_view language) {
    constexpr std::string_view kContext = "Attempt";  // in the translation file
    return std::string(sim::translated(kContext, english, language));
}

}  // namespace placode::view
