// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placode-web: a centre in the browser, for reading only.

#include <pthread.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <QFont>
#include <QGuiApplication>
#include <chrono>
#include <clocale>
#include <csignal>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <mutex>
#include <thread>

#include "curriculum/utc_time.h"
#include "db/reading_store.h"
#include "db/store.h"
#include "db/store_url.h"
#include "ui/arrived.h"
#include "ui/diagnostics/crash_report.h"
#include "ui/lti/settings.h"
#include "ui/lti/web_token.h"
#include "ui/usage_message.h"
#include "ui/version.h"
#include "ui/web/web_server.h"

namespace {

using namespace placode;

struct Options {
    std::string store, listen = "127.0.0.1:8377", lti;
    bool behind_tls = false;
    int review_mib = static_cast<int>(web::kReviewBytes >> 20);
};

int fail(int status, const std::string& message) {
    std::cerr << "placode-web: " << message << '\n';
    return status;
}

void keep_quiet(QtMsgType type, const QMessageLogContext&, const QString& message) {
    if (type == QtCriticalMsg || type == QtFatalMsg)
        std::cerr << "placode-web: " << message.toStdString() << '\n';
}

void log(const std::string& line) {
    static std::mutex mutex;
    const std::lock_guard lock(mutex);
    // A line stays one, whatever stands in an address that was asked for.
    std::string clean = line;
    for (char& c : clean)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
    std::cerr << curriculum::utc_text(static_cast<int64_t>(std::time(nullptr))) << ' ' << clean
              << std::endl;
}

/// On a server a log-in that can do more than a station's is refused.
db::StoreOptions at_station(bool lti) {
    db::StoreOptions options;
    options.station = true;
    options.service = lti;
    return options;
}

/// The store is there, of this version, and not in the command line with its password.
std::string checked_store(const Options& options) {
    const std::string url = options.store.empty() ? db::default_store_url() : options.store;
    const db::StoreUrl parsed = db::parse_store_url(url);
    if (!parsed.password.empty())
        throw std::invalid_argument(
            "--store: the address holds a password, and everybody on this computer can read it "
            "there (ps); put it in ~/.pgpass (mode 600) or $PGPASSWORD");
    if (parsed.engine == db::Engine::kSqlite && !std::filesystem::exists(parsed.path) &&
        !db::store_was_here(url))
        throw std::invalid_argument("open " + parsed.shown +
                                    ": there is no such store; give the right one with --store");
    // For nobody: account 0 is none.
    (void)db::open_for_reading(url, 0, at_station(!options.lti.empty()));
    return url;
}

/// What is wrong with the settings shows at the start, not when the first person comes.
std::string checked_lti(const Options& options) {
    if (options.lti.empty()) return {};
    const lti::Settings settings = lti::read_settings(options.lti);
    try {
        (void)lti::SigningKey(lti::read_secret(settings.private_key_file));
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(settings.private_key_file + ": " + error.what());
    }
    const bool tls = settings.tool_url.starts_with("https://");
    if (tls != options.behind_tls)
        throw std::invalid_argument(
            options.lti + ": tool_url is " + settings.tool_url +
            (tls ? "; expected --behind-tls with it" : "; expected https with --behind-tls"));
    return options.lti;
}

/// SIGTERM and SIGINT are waited for, so that what has begun is answered.
sigset_t endings() {
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGTERM);
    sigaddset(&set, SIGINT);
    return set;
}

int serve(const Options& options) {
    web::PortalOptions portal;
    web::ListenAddress address;
    try {
        address = web::parse_listen_address(options.listen);
    } catch (const std::invalid_argument& error) {
        return fail(2, std::string("--listen: ") + error.what());
    }
    try {
        portal.lti_file = checked_lti(options);
        portal.store_url = checked_store(options);
    } catch (const std::invalid_argument& error) {
        return fail(2, error.what());
    } catch (const lti::SettingsError& error) {
        return fail(2, std::string("--lti: ") + error.what());
    } catch (const std::exception& error) {
        return fail(1, error.what());
    }
    portal.store = at_station(!options.lti.empty());
    portal.behind_tls = options.behind_tls;
    portal.review_bytes = static_cast<size_t>(options.review_mib) << 20;
    portal.log = log;
    ui::begin_diagnostics("placode-web");
    const sigset_t set = endings();
    pthread_sigmask(SIG_BLOCK, &set, nullptr);  // Before any thread is made: they inherit it.
    try {
        web::WebServer server(std::move(portal));
        const int port = server.bind(address);
        std::cout << "placode-web: listening on "
                  << (address.socket_path.empty()
                          ? "http://" + (address.host == "::1" ? "[::1]" : address.host) + ":" +
                                std::to_string(port)
                          : "unix:" + address.socket_path)
                  << ", for reading only; Ctrl+C ends it" << std::endl;
        std::thread listener([&server] {
            server.serve();
            ::kill(::getpid(), SIGTERM);  // Where it ended by itself, nothing is left to wait for.
        });
        while (!server.ready()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        int which = 0;
        sigwait(&set, &which);
        server.stop();
        listener.join();
        ui::log_note("ended");
    } catch (const std::exception& error) {
        return fail(1, std::string("--listen: ") + error.what());
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    qInstallMessageHandler(keep_quiet);
    int qt_argc = 1;
    QGuiApplication application(qt_argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("placode"));
    // Named in the pictures: a browser then takes its own.
    QGuiApplication::setFont(QFont(QStringLiteral("sans-serif")));
    std::setlocale(LC_NUMERIC, "C");
    Options options;
    CLI::App app("A centre in the browser, for reading only: cohort, curves, standards, studies",
                 "placode-web");
    app.set_version_flag("--version", std::string("placode-web ") + ui::version_text(),
                         "Version and commit");
    app.add_option("--store", options.store,
                   "sqlite:PATH or postgresql://USER@HOST:PORT/NAME, its password in ~/.pgpass or "
                   "$PGPASSWORD (default: the user's data folder)");
    app.add_option("--listen", options.listen,
                   "127.0.0.1:PORT, [::1]:PORT or unix:PATH; others reach it through nginx or "
                   "Apache, which does TLS")
        ->capture_default_str();
    app.add_flag("--behind-tls", options.behind_tls,
                 "Browsers reach it by https: the sign-in's cookie is for https only");
    app.add_option("--lti", options.lti,
                   "FILE.json: learning platforms whose people may come in by LTI 1.3, as "
                   "`placodectl lti check` reads it");
    app.add_option("--review-memory", options.review_mib,
                   "Memory for attempts that are looked at in 3D [MiB]")
        ->check(CLI::Range(16, 65536))
        ->capture_default_str();
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& help) {
        return ui::arrived("placode-web", app.exit(help));
    } catch (const CLI::ParseError& error) {
        return fail(2, ui::usage_message(app, error));
    }
    return serve(options);
}
