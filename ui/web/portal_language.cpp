// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// In which language a visit is answered: what the browser asks for, else English.

#include "ui/web/portal.h"

namespace placode::web {

QLocale Portal::language_of(const Request& request) {
    return locale_of(liked_language(request.languages));
}

}  // namespace placode::web
