// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl: the command line of Placode.

#include <QApplication>
#include <clocale>
#include <cstdio>
#include <exception>
#include <iostream>
#include <sstream>

#include "curriculum/definitions.h"
#include "db/store.h"
#include "ui/arrived.h"
#include "ui/cli/batch.h"
#include "ui/cli/dataset.h"
#include "ui/cli/on_screen.h"
#include "ui/cli/session.h"
#include "ui/cli/solver_commands.h"
#include "ui/lti/secret_file.h"
#include "ui/usage_message.h"
#include "ui/version.h"

namespace {

using namespace placode;

int fail(const cli::Context& context, int status, const std::string& message) {
    if (context.json) cli::print(context, {{"error", message}, {"exit_status", status}}, "");
    std::cerr << "placodectl: " << cli::on_screen(message) << '\n';
    return status;
}

// A recording or an order that cannot be used is bad input; a store that cannot is a failure.
int status_of(const db::StoreError& error) {
    return error.kind() == db::StoreError::Kind::kNotFound ? 2 : 1;
}

// Done is only what has arrived. Here the reason is known, which ui::arrived() may not find.
int with_output(int status) {
    const int reason = cli::output_trouble();
    return reason == 0 ? status : ui::not_arrived("placodectl", status, reason);
}

// What Qt says to itself (no XDG_RUNTIME_DIR, ...) is not for whoever reads our output.
void keep_quiet(QtMsgType type, const QMessageLogContext&, const QString& message) {
    if (type == QtCriticalMsg || type == QtFatalMsg)
        std::cerr << "placodectl: " << message.toStdString() << '\n';
}

int run(const cli::Context& context) {
    try {
        cli::refuse_open_password("--store", context.store_url);
        return context.run();
    } catch (const cli::InputError& error) {
        return fail(context, 2, error.what());
    } catch (const lti::SettingsError& error) {
        return fail(context, 2, error.what());
    } catch (const curriculum::DefinitionError& error) {
        return fail(context, 2, error.what());
    } catch (const db::StoreError& error) {
        return fail(context, status_of(error), error.what());
    } catch (const std::exception& error) {
        return fail(context, 1, error.what());
    }
}

// In the order of the help.
void add_commands(CLI::App& app, cli::Context& context) {
    cli::add_user_commands(app, context);
    cli::add_store_commands(app, context);
    cli::add_store_move_command(app, context);
    cli::add_metrics_commands(app, context);
    cli::add_import_command(app, context);
    cli::add_stats_commands(app, context);
    cli::add_report_commands(app, context);
    cli::add_solve_command(app, context);
    cli::add_export_command(app, context);
    cli::add_study_commands(app, context);
    cli::add_people_commands(app, context);
    cli::add_course_commands(app, context);
    cli::add_group_commands(app, context);
    cli::add_station_commands(app, context);
    cli::add_standard_commands(app, context);
    cli::add_task_commands(app, context);
    cli::add_rescore_commands(app, context);
    cli::add_verify_command(app, context);
    cli::add_norms_commands(app, context);
    cli::add_batch_commands(app, context);
    cli::add_dataset_command(app, context);
    cli::add_bench_commands(app, context);
    cli::add_lti_commands(app, context);
    cli::add_xapi_command(app, context);
    cli::add_demo_commands(app, context);
}

int placodectl(int argc, char** argv) {
    // No window, ever: a display is not needed, also not for a report.
    qputenv("QT_QPA_PLATFORM", "offscreen");
    qInstallMessageHandler(keep_quiet);
    // Plots are drawn by a widget class, so that the plain GUI application is not enough.
    // It gets the program's name only: it would swallow arguments of its own such as --reverse.
    int qt_argc = 1;
    QApplication application(qt_argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("placode"));
    // Qt takes over the user's locale; numbers on the command line and in files have a '.'.
    std::setlocale(LC_NUMERIC, "C");

    cli::Context context;
    CLI::App app(
        "Placode on the command line: accounts, scores, exports, reports, backup, benchmarks",
        "placodectl");
    app.set_version_flag("--version", std::string("placodectl ") + ui::version_text(),
                         "Version and commit");
    app.require_subcommand(1);
    app.fallthrough();
    app.add_option("--store", context.store_url,
                   "sqlite:PATH or postgresql://USER@HOST:PORT/NAME, its password in ~/.pgpass, "
                   "$PGPASSWORD or typed in (default: the user's data folder)");
    app.add_option("--as", context.as_user,
                   "Act as this user; the password comes from $PLACODE_PASSWORD or is asked for");
    app.add_flag("--json", context.json, "One JSON document instead of text");
    add_commands(app, context);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& help) {
        std::ostringstream text;
        const int status = app.exit(help, text);
        cli::print({}, {}, text.str());
        return with_output(status);
    } catch (const CLI::ParseError& error) {
        for (int i = 1; i < argc; ++i)
            context.json = context.json || std::string_view(argv[i]) == "--json";
        return with_output(fail(context, 2, placode::ui::usage_message(app, error)));
    }
    return with_output(run(context));
}

}  // namespace

int main(int argc, char** argv) {
    // What goes wrong before there is a command, or while its trouble is told.
    try {
        return placodectl(argc, argv);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "placodectl: %s\n", error.what());
        return 1;
    }
}
