// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What surrounds every page, and the one style sheet.

#include <string>
#include <string_view>

#include "db/records.h"
#include "ui/web/html.h"

namespace placode::web {

/// For whom a page is made; nobody: without the rail and the sign-out.
struct Reader {
    const db::UserRecord* user = nullptr;
    std::string form_token;  ///< Of the form that signs out.
    std::string path;        ///< Of the page: marked in the rail.
    /// Of the page, with its query: the switch of languages leads there.
    std::string address = "/";
};

/// The key in a query that asks for a language from now on: "/cohort?group=3&language=pl".
inline constexpr const char* kLanguageKey = "language";

/// The whole document, in the language that is spoken.
[[nodiscard]] std::string document(const Text& title, const Html& body, const Reader& reader = {});

[[nodiscard]] std::string_view style_sheet();
/// A script of the one page that shows a picture in motion; empty where there is none of this name.
[[nodiscard]] std::string review_script(const std::string& name);

}  // namespace placode::web
