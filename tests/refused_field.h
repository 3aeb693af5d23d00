// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "sim/suture/suture_error.h"

namespace placode::test {

/// What a specification of needle or suture is refused for: the field, "|", and the message.
template <class Build>
std::string refused(Build&& build) {
    try {
        build();
    } catch (const sim::SutureError& error) {
        return error.field() + "|" + error.what();
    }
    return "taken";
}

}  // namespace placode::test
