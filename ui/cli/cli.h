// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the commands of placodectl share. Each command file adds its subcommands to the parser and
// sets `Context::run`; main() runs it and turns exceptions into the exit status:
// 0 done, 1 it ran and failed, 2 bad input or usage.

#include <CLI/CLI.hpp>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace placode::cli {

using Json = nlohmann::ordered_json;

struct Context {
    std::string store_url;     ///< --store; empty = the user's data folder.
    std::string as_user;       ///< --as; empty = local administrator, where that is possible.
    bool json = false;         ///< --json
    std::function<int()> run;  ///< Set by the subcommand that was given.
};

/// Bad input: exit status 2. Says file, place, what was found and what is expected.
class InputError : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

/// A role is missing, or the password is wrong: exit status 1.
class AccessError : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

void add_user_commands(CLI::App& app, Context& context);
void add_store_commands(CLI::App& app, Context& context);
void add_store_move_command(CLI::App& app, Context& context);
void add_metrics_commands(CLI::App& app, Context& context);
void add_score_command(CLI::App& app, Context& context);
void add_import_command(CLI::App& app, Context& context);
void add_stats_commands(CLI::App& app, Context& context);
void add_report_commands(CLI::App& app, Context& context);
void add_export_command(CLI::App& app, Context& context);
void add_study_commands(CLI::App& app, Context& context);
void add_course_commands(CLI::App& app, Context& context);
void add_group_commands(CLI::App& app, Context& context);
void add_station_commands(CLI::App& app, Context& context);
void add_standard_commands(CLI::App& app, Context& context);
void add_task_commands(CLI::App& app, Context& context);
void add_rescore_commands(CLI::App& app, Context& context);
void add_verify_command(CLI::App& app, Context& context);
void add_norms_commands(CLI::App& app, Context& context);
void add_people_commands(CLI::App& app, Context& context);
void add_erasure_commands(CLI::App& user, Context& context);
void add_bench_commands(CLI::App& app, Context& context);
void add_contact_bench_command(CLI::App& bench, Context& context);
void add_scaling_command(CLI::App& bench, Context& context);
void add_cuts_command(CLI::App& bench, Context& context);
void add_picture_bench_command(CLI::App& bench, Context& context);
void add_stability_command(CLI::App& bench, Context& context);
void add_store_bench_command(CLI::App& bench, Context& context);
void add_lti_commands(CLI::App& app, Context& context);
void add_lti_grades_command(CLI::App& lti, Context& context);
void add_xapi_command(CLI::App& app, Context& context);
void add_demo_commands(CLI::App& app, Context& context);

/// Processor, system, compiler, kernels and load, for benchmarks.
[[nodiscard]] Json machine();
/// A warning when other programs were running at the start, and so the figures are too low.
void warn_if_busy(const Json& machine);

/// Prints one JSON document with --json, else the text.
void print(const Context& context, const Json& json, const std::string& text);
/// Why what was printed did not all reach standard output, as on a full disk: errno. 0 where it
/// did, or where nobody reads the pipe any more.
[[nodiscard]] int output_trouble();

/// Fixed decimals with '.' in every locale.
[[nodiscard]] std::string fixed(double value, int decimals);
/// The shortest text that reads back as the same number, with '.' in every locale.
[[nodiscard]] std::string shortest(double value);
/// A number that may be missing: null, or "-" in a table.
[[nodiscard]] Json optional_number(const std::optional<double>& value);
[[nodiscard]] std::string optional_text(const std::optional<double>& value, int decimals);

/// Rows with columns as wide as needed; the first row is the head.
[[nodiscard]] std::string table(const std::vector<std::vector<std::string>>& rows);

/// A password from the environment variable, else typed at the terminal without echo, else the
/// first line of the standard input. @param twice asks again to catch typing errors (terminal
/// only).
[[nodiscard]] std::string read_password(const char* variable, const std::string& prompt,
                                        bool twice);

}  // namespace placode::cli
