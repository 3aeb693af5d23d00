// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placode: the shell.

#include <QApplication>
#include <QCommandLineParser>

#include "ui/shell/main_window.h"

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    QApplication::setApplicationName("placode");
    QApplication::setApplicationDisplayName("Placode");
    QApplication::setDesktopFileName("placode");
    QCommandLineParser parser;
    parser.setApplicationDescription("Training and assessment for fetoscopic spina bifida repair.");
    parser.addHelpOption();
    parser.addOptions({{"store", "Store to open (sqlite:PATH, postgresql://...).", "URL"},
                       {"data", "Folder with tasks, scenes, courses and questionnaires.", "FOLDER"},
                       {"language", "Language of the shell: en or pl.", "LANGUAGE"},
                       {"theme", "light or dark.", "THEME"}});
    parser.process(application);
    const auto one_of = [&](const char* name, const QStringList& known) {
        if (!parser.isSet(name) || known.contains(parser.value(name))) return true;
        std::fprintf(stderr, "placode: --%s %s: expected %s\n", name,
                     qPrintable(parser.value(name)), qPrintable(known.join(" or ")));
        return false;
    };
    if (!one_of("language", {"en", "pl"}) || !one_of("theme", {"light", "dark"})) return 2;
    if (parser.isSet("data")) qputenv("PLACODE_DATA", parser.value("data").toLocal8Bit());
    placode::ui::ShellOptions options;
    options.store_url = parser.value("store").toStdString();
    options.language = parser.value("language");
    options.theme = parser.value("theme");
    placode::ui::AppContext context(options);
    placode::ui::MainWindow window(context);
    window.show();
    window.begin();
    return QApplication::exec();
}
