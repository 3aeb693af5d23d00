// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/store_url.h"

#include <QDir>
#include <QUrl>
#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>

#include "db/password_file.h"
#include "db/store_error.h"

namespace placode::db {
namespace {

constexpr const char* kExpected =
    "; expected sqlite:PATH or postgresql://USER@HOST:PORT/NAME, with ?timeout_ms=N behind it if "
    "wanted, and for a server &sslmode=MODE&sslrootcert=FILE&host=FOLDER";

constexpr std::array<const char*, 5> kSslModes{"verify-full", "verify-ca", "require", "prefer",
                                               "disable"};

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

/// On this computer nobody sits between: loopback, or a Unix socket.
bool is_here(const std::string& host) {
    return host.find('/') != std::string::npos || host == "localhost" || host == "::1" ||
           host.rfind("127.", 0) == 0;
}

std::string decoded(const std::string& text) {
    return QUrl::fromPercentEncoding(QByteArray::fromStdString(text)).toStdString();
}

void read_option(StoreUrl& parsed, const std::string& option) {
    const size_t equals = std::min(option.find('='), option.size());
    const std::string key = option.substr(0, equals);
    const std::string value = decoded(option.substr(std::min(equals + 1, option.size())));
    const bool server = parsed.engine == Engine::kPostgresql;
    if (key == "timeout_ms") {
        parsed.timeout_ms = parse_int(value, 0, 600000, parsed.shown, key);
    } else if (server && key == "sslmode") {
        if (std::find(kSslModes.begin(), kSslModes.end(), value) == kSslModes.end())
            refuse(parsed.shown, "sslmode \"" + value +
                                     "\" is none of verify-full, verify-ca, require, prefer and "
                                     "disable");
        parsed.sslmode = value;
    } else if (server && key == "sslrootcert" && !value.empty()) {
        parsed.sslrootcert = value;
    } else if (server && key == "host" && value.find('/') == 0) {
        parsed.host = value;
    } else {
        refuse(parsed.shown, "unknown option \"" + key + "\"");
    }
}

// The folder of a Unix socket stands in the options: there is no host then.
void read_address(StoreUrl& parsed, const std::string& base, bool has_host_option) {
    const QUrl address(QString::fromStdString(base), QUrl::StrictMode);
    parsed.shown = address.toString(QUrl::RemovePassword).toStdString();
    if (!address.isValid() || address.host().isEmpty() != has_host_option ||
        address.path().size() < 2) {
        // Never the text itself: it may hold a password.
        refuse("postgresql store", "the address cannot be read");
    }
    parsed.engine = Engine::kPostgresql;
    parsed.host = address.host().toStdString();
    parsed.port = address.port(5432);
    parsed.user = address.userName(QUrl::FullyDecoded).toStdString();
    parsed.password = address.password(QUrl::FullyDecoded).toStdString();
    parsed.name = address.path(QUrl::FullyDecoded).mid(1).toStdString();
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
        read_address(parsed, base, ("&" + options).find("&host=") != std::string::npos);
    } else {
        const size_t colon = base.find(':');
        refuse("store", "found " + (colon == std::string::npos
                                        ? "\"" + base + "\""
                                        : "the kind \"" + base.substr(0, colon) + ":\""));
    }
    for (size_t begin = 0; begin < options.size();) {
        const size_t end = std::min(options.find('&', begin), options.size());
        read_option(parsed, options.substr(begin, end - begin));
        begin = end + 1;
    }
    if (parsed.sslmode.empty()) parsed.sslmode = is_here(parsed.host) ? "prefer" : "verify-full";
    return parsed;
}

std::string connect_options(const StoreUrl& url) {
    // A cable that was pulled tells nobody: the kernel asks, and gives up on what is not answered.
    std::string options =
        "connect_timeout=5;tcp_user_timeout=10000;keepalives=1;keepalives_idle=5;"
        "keepalives_interval=2;keepalives_count=3;sslmode=" +
        url.sslmode;
    if (url.sslrootcert.empty()) return options;
    // As libpq reads values. Qt makes ';' into a blank.
    options += ";sslrootcert='";
    for (const char c : url.sslrootcert) {
        if (c == '\\' || c == '\'') options += '\\';
        options += c;
    }
    return options + "'";
}

bool needs_password(const StoreUrl& url) {
    if (url.engine != Engine::kPostgresql || !url.password.empty()) return false;
    if (url.host.find('/') != std::string::npos) return false;  // the socket knows who asks
    const char* word = std::getenv("PGPASSWORD");
    if (word != nullptr && *word != '\0') return false;
    const char* file = std::getenv("PGPASSFILE");
    return !password_file_has(
        file != nullptr ? file : (QDir::homePath() + QStringLiteral("/.pgpass")).toStdString(),
        url);
}

std::string with_password(const std::string& url, const std::string& password) {
    const size_t question = std::min(url.rfind('?'), url.size());
    QUrl address(QString::fromStdString(url.substr(0, question)), QUrl::StrictMode);
    address.setPassword(QString::fromStdString(password), QUrl::DecodedMode);
    return address.toString(QUrl::FullyEncoded).toStdString() + url.substr(question);
}

}  // namespace placode::db
