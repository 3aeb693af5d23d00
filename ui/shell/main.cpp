// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placode: the shell.

#include <QApplication>
#include <QCommandLineParser>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QScreen>
#include <cstdio>
#include <string_view>

#include "sim/core/near_word.h"
#include "ui/arrived.h"
#include "ui/diagnostics/crash_report.h"
#include "ui/shell/main_window.h"
#include "ui/shell/page_tour.h"
#include "ui/shell/store_address.h"
#include "ui/version.h"

namespace placode::ui {
namespace {

constexpr int kRuns = 3;

/// Largest resident memory of this process [MB].
double peak_memory_mb() {
    QFile status("/proc/self/status");
    if (!status.open(QIODevice::ReadOnly)) return 0;
    for (const QByteArray& line : status.readAll().split('\n'))
        if (line.startsWith("VmHWM:"))
            return line.mid(6).simplified().split(' ')[0].toDouble() / 1024;
    return 0;
}

/// Opens every page that this person may open and prints how long each took, as JSON. The password
/// comes from $PLACODE_PASSWORD: measuring opens no door.
int measure_pages(AppContext& context, MainWindow& window, const QString& login) {
    while (context.updating()) QApplication::processEvents(QEventLoop::WaitForMoreEvents);
    if (!context.storeIsOpen()) return 1;
    const db::SignIn sign_in = context.store().accounts().sign_in(
        login.toStdString(), qEnvironmentVariable("PLACODE_PASSWORD").toStdString());
    if (!sign_in.user) {
        std::fprintf(stderr,
                     "placode: --time-pages %s: cannot sign in; give the password in "
                     "$PLACODE_PASSWORD\n",
                     qPrintable(login));
        return 2;
    }
    context.signIn(*sign_in.user);
    QJsonArray pages;
    for (const PageTime& each : time_pages(context, window, kRuns))
        pages.append(QJsonObject{{"page", each.name},
                                 {"first_ms", each.first_ms},
                                 {"median_ms", each.median_ms},
                                 {"worst_ms", each.worst_ms},
                                 {"processor_ms", each.processor_ms},
                                 {"complete_ms", each.complete_ms}});
    const QJsonObject all{{"pages", pages}, {"runs", kRuns}, {"peak_memory_mb", peak_memory_mb()}};
    std::fputs(QJsonDocument(all).toJson().constData(), stdout);
    return 0;
}

}  // namespace
}  // namespace placode::ui

namespace {

/// Says what is wrong with the command line; exit status 2.
int complain(const QCommandLineParser& parser) {
    std::string said = parser.errorText().toStdString(), meant;
    if (!parser.unknownOptionNames().isEmpty()) {
        const std::string word = "--" + parser.unknownOptionNames().front().toStdString();
        said = "unknown option \"" + word + "\"";
        meant = placode::sim::did_you_mean(word, {"--store", "--data", "--language", "--theme",
                                                  "--time-pages", "--help", "--version"});
    } else if (!parser.positionalArguments().isEmpty()) {
        said = "\"" + parser.positionalArguments().front().toStdString() +
               "\" is one argument too many; a store is given with --store";
    }
    std::fprintf(stderr, "placode: %s; see `placode --help`%s\n", said.c_str(), meant.c_str());
    return 2;
}

/// `ps` shows the command line to everybody on this computer.
int refuse_password() {
    std::fprintf(stderr,
                 "placode: --store: the address holds a password, and everybody on this computer "
                 "can read it there (ps); leave it out, and put it in ~/.pgpass (mode 600) or "
                 "$PGPASSWORD, or type it when asked\n");
    return 2;
}

void describe(QCommandLineParser& parser) {
    parser.setApplicationDescription("Training and assessment for fetoscopic spina bifida repair.");
    // Qt's own would bring --help-all, which only a parser that ends the program answers.
    parser.addOption({{"h", "help"}, "Displays help on commandline options."});
    parser.addVersionOption();
    parser.addOptions({{"store", "Store to open (sqlite:PATH, postgresql://...).", "URL"},
                       {"data", "Folder with tasks, scenes, courses and questionnaires.", "FOLDER"},
                       {"language", "Language of the shell: en or pl.", "LANGUAGE"},
                       {"theme", "light or dark.", "THEME"},
                       {"time-pages",
                        "Sign in (password in $PLACODE_PASSWORD), open every page, print how long "
                        "each took as JSON, and end.",
                        "LOGIN"}});
}

constexpr QSize kFrame{4, 40};  ///< Of the desktop around a window [px].

/// As it was left. A desk at 200 % has half the pixels: what would hang over its edge is shrunk,
/// then maximised.
void show_on_screen(QWidget& window, const QByteArray& as_left) {
    if (!as_left.isEmpty()) window.restoreGeometry(as_left);
    if (window.isMaximized()) return window.show();
    const QSize room = window.screen()->availableGeometry().size() - kFrame;
    window.setMinimumSize(window.minimumSize().boundedTo(room));
    const bool fits = window.size().boundedTo(room) == window.size();
    if (fits) return window.show();
    window.resize(window.size().boundedTo(room));
    window.showMaximized();
}

}  // namespace

int main(int argc, char** argv) {
    // What is only asked about itself needs no display.
    for (int i = 1; i < argc; ++i)
        for (const std::string_view asked : {"--help", "-h", "--version", "-v"})
            if (asked == argv[i]) qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    QApplication::setApplicationName("placode");
    QApplication::setApplicationDisplayName("Placode");
    QApplication::setDesktopFileName("org.placode.Placode");
    QApplication::setApplicationVersion(placode::ui::version_text());
    QCommandLineParser parser;
    describe(parser);
    // Our own words for what is wrong, and status 2 as with the other programs.
    const bool understood = parser.parse(QApplication::arguments());
    // QCommandLineParser would end the program itself, whether or not its text has arrived.
    if (parser.isSet("help")) {
        std::fputs(qPrintable(parser.helpText()), stdout);
        return placode::ui::arrived("placode", 0);
    }
    if (parser.isSet("version")) {
        std::printf("placode %s\n", placode::ui::version_text());
        return placode::ui::arrived("placode", 0);
    }
    if (!understood || !parser.positionalArguments().isEmpty()) return complain(parser);
    const auto one_of = [&](const char* name, const QStringList& known) {
        if (!parser.isSet(name) || known.contains(parser.value(name))) return true;
        std::fprintf(stderr, "placode: --%s: found \"%s\"; expected %s\n", name,
                     qPrintable(parser.value(name)), qPrintable(known.join(" or ")));
        return false;
    };
    if (!one_of("language", {"en", "pl"}) || !one_of("theme", {"light", "dark"})) return 2;
    if (parser.isSet("data")) qputenv("PLACODE_DATA", parser.value("data").toLocal8Bit());
    if (placode::ui::has_password(parser.value("store"))) return refuse_password();
    placode::ui::ShellOptions options;
    options.store_url = parser.value("store").toStdString();
    options.language = parser.value("language");
    options.theme = parser.value("theme");
    placode::ui::begin_diagnostics("placode");
    placode::ui::AppContext context(options);
    placode::ui::MainWindow window(context);
    show_on_screen(
        window, context.settings().value(placode::ui::MainWindow::kGeometrySetting).toByteArray());
    window.begin();
    if (parser.isSet("time-pages"))
        return placode::ui::arrived(
            "placode", placode::ui::measure_pages(context, window, parser.value("time-pages")));
    const int status = QApplication::exec();
    placode::ui::log_note("ended", {{"exit_status", status}});
    return status;
}
