// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/store_url.h"

#include <QUrl>
#include <charconv>

#include "db/store_error.h"

namespace placode::db {
namespace {

constexpr const char* kExpected =
    "; expected sqlite:PATH or postgresql://USER:PASSWORD@HOST:PORT/NAME, with ?timeout_ms=N "
    "behind it if wanted";

[[noreturn]] void refuse(const std::string& shown, const std::string& problem) {
    throw StoreError(StoreError::Kind::kOther, "open " + shown + ": " + problem + kExpected);
}

int parse_int(const std::string& text, int min, int max, const std::string& shown,
              const std::string& what) {
    int value = 0;
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc{} || rest != end || value < min || value > max)
        refuse(shown, what + " \"" + text + "\" is not a whole number from " + std::to_string(min) +
                          " to " + std::to_string(max));
    return value;
}

}  // namespace

StoreUrl parse_store_url(const std::string& url) {
    StoreUrl parsed;
    std::string base = url;
    std::string options;
    const size_t question = url.rfind('?');
    if (question != std::string::npos) {
        base = url.substr(0, question);
        options = url.substr(question + 1);
    }
    if (base.rfind("sqlite:", 0) == 0) {
        parsed.path = base.substr(7);
        if (parsed.path.empty()) refuse(url, "the path is missing");
        parsed.shown = base;
    } else if (base.rfind("postgresql://", 0) == 0 || base.rfind("postgres://", 0) == 0) {
        const QUrl address(QString::fromStdString(base), QUrl::StrictMode);
        parsed.shown = address.toString(QUrl::RemovePassword).toStdString();
        if (!address.isValid() || address.host().isEmpty() || address.path().size() < 2) {
            // Never the text itself: it may hold a password.
            refuse("postgresql store", "the address cannot be read");
        }
        parsed.engine = Engine::kPostgresql;
        parsed.host = address.host().toStdString();
        parsed.port = address.port(5432);
        parsed.user = address.userName(QUrl::FullyDecoded).toStdString();
        parsed.password = address.password(QUrl::FullyDecoded).toStdString();
        parsed.name = address.path(QUrl::FullyDecoded).mid(1).toStdString();
    } else {
        const size_t colon = base.find(':');
        refuse("store", "found " + (colon == std::string::npos
                                        ? "\"" + base + "\""
                                        : "the kind \"" + base.substr(0, colon) + ":\""));
    }
    if (!options.empty()) {
        const std::string key = "timeout_ms=";
        if (options.rfind(key, 0) != 0)
            refuse(parsed.shown, "unknown option \"" + options.substr(0, options.find('=')) + "\"");
        parsed.timeout_ms =
            parse_int(options.substr(key.size()), 0, 600000, parsed.shown, "timeout_ms");
    }
    return parsed;
}

}  // namespace placode::db
