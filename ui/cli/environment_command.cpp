// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl bench environment: what the environments of docs/environment.md cost.

#include <QProcess>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>

#include "bench/environment_speed.h"
#include "curriculum/utc_time.h"
#include "ui/cli/solver_commands.h"
#include "ui/cli/write_file.h"

namespace placode::cli {
namespace {

namespace fs = std::filesystem;

struct EnvironmentOptions {
    bool quick = false, policies = false;
    std::string out, python = "/usr/bin/python3", task, scene;
    int attempts = 3;
};

/// The tasks that come as environments (placode.tasks of the Python package).
constexpr const char* kTasks[] = {
    "touch_targets",        "trace_contour",      "grasp_and_lift",  "two_handed_traction",
    "diathermy_ring_small", "scissors_resection", "needle_handover", "suture_bite",
    "suture_run",           "sb_dissection"};

/// As placode.COARSE and COARSEST of the Python package.
constexpr const char* kCoarse =
    R"({"edge_ring_m":0.0010,"edge_placode_m":0.0014,"edge_outer_m":0.003,"solver":{"substeps":2}})";
constexpr const char* kCoarsest =
    R"({"edge_ring_m":0.0016,"edge_placode_m":0.0022,"edge_outer_m":0.0036,"solver":{"substeps":2}})";
constexpr int kStepFrames = 20;

std::vector<bench::EnvironmentCase> cases(const EnvironmentOptions& options) {
    if (!options.task.empty())
        return {
            {options.scene.empty() ? "as published" : options.scene, options.task, options.scene}};
    std::vector<bench::EnvironmentCase> all{{"coarsest", "touch_targets", kCoarsest},
                                            {"coarse", "touch_targets", kCoarse},
                                            {"coarse", "diathermy_ring_small", kCoarse}};
    for (const char* task : kTasks) all.push_back({"as published", task, ""});
    if (options.quick) all.resize(3);
    return all;
}

struct PythonFigures {
    std::vector<Json> found;  ///< Of each process that gave some.
    std::string problem;      ///< Why one gave none.
};

/// What a process that ended said, or why it said nothing.
void read_figures(QProcess& process, const std::string& python, PythonFigures& into) {
    const std::string said = process.readAllStandardOutput().toStdString();
    const Json figures = Json::parse(said, nullptr, false);
    if (figures.is_object()) return into.found.push_back(figures);
    std::string why = process.error() != QProcess::UnknownError
                          ? process.errorString().toStdString()
                          : "exit status " + std::to_string(process.exitCode());
    for (const QByteArray& line : process.readAllStandardError().split('\n'))
        if (!line.trimmed().isEmpty()) why = line.trimmed().toStdString();  // the last says it
    into.problem = python + ": " + why;
}

/// What the Python package measures of itself, by so many processes at once.
PythonFigures python_figures(const EnvironmentOptions& options, const bench::EnvironmentCase& what,
                             int processes) {
    const fs::path bin = fs::read_symlink("/proc/self/exe").parent_path();
    const std::string path =
        (bin / "../python").string() + ":" + (bin / "../lib/python3/dist-packages").string();
    QProcessEnvironment surroundings = QProcessEnvironment::systemEnvironment();
    surroundings.insert(QStringLiteral("PYTHONPATH"), QString::fromStdString(path));
    std::vector<std::unique_ptr<QProcess>> running;
    for (int i = 0; i < processes; ++i) {
        running.push_back(std::make_unique<QProcess>());
        running.back()->setProcessEnvironment(surroundings);
        running.back()->start(
            QString::fromStdString(options.python),
            {QStringLiteral("-m"), QStringLiteral("placode.bench"),
             QString::fromStdString(what.task), QString::fromStdString(what.scene_changes_json),
             options.quick ? QStringLiteral("3") : QStringLiteral("9")});
    }
    PythonFigures figures;
    for (const auto& process : running) {
        process->waitForFinished(-1);
        read_figures(*process, options.python, figures);
    }
    return figures;
}

/// What one Python process and two at once reach.
Json python_row(const EnvironmentOptions& options, const bench::EnvironmentCase& what) {
    const PythonFigures one = python_figures(options, what, 1);
    if (one.found.empty()) return {{"problem", one.problem}};
    Json row = one.found.front();
    const PythonFigures two = python_figures(options, what, 2);
    if (two.found.size() == 2)
        row["two_processes_frames_per_s"] =
            two.found[0].value("frames_per_s", 0.0) + two.found[1].value("frames_per_s", 0.0);
    else
        row["problem"] = two.problem;
    return row;
}

Json to_json(const bench::EnvironmentRow& row, const Json& python) {
    return {{"case", row.what.name},
            {"task", row.what.task},
            {"tets", row.tets},
            {"substeps", row.substeps},
            {"physics_frames_per_s", row.physics_hz},
            {"environment_frames_per_s", row.environment_hz},
            {"python_frames_per_s", python.value("frames_per_s", 0.0)},
            {"python_call_us", python.value("call_us", 0.0)},
            {"python_call_share",
             python.value("call_us", 0.0) * 1e-6 * row.environment_hz / kStepFrames},
            {"pictured_frames_per_s", python.value("pictured_frames_per_s", 0.0)},
            {"picture", python.value("picture", Json())},
            {"two_processes_frames_per_s", python.value("two_processes_frames_per_s", 0.0)},
            {"python_problem", python.value("problem", "")},
            {"reset_ms", row.reset_ms},
            {"save_ms", row.save_ms},
            {"field_mib", row.field_mib},
            {"environment_mib", row.environment_mib},
            {"moment_mib", row.moment_mib},
            {"field_build_s", row.build_s}};
}

std::vector<std::string> cells_of(const Json& row) {
    const auto number = [&](const char* key, int decimals) {
        return fixed(row[key].get<double>(), decimals);
    };
    const auto known = [&](const char* key, int decimals) {
        return row[key].get<double>() > 0 ? number(key, decimals) : "-";
    };
    const double share = row["python_call_share"].get<double>();
    return {row["task"],
            row["case"],
            std::to_string(row["tets"].get<int>()),
            std::to_string(row["substeps"].get<int>()),
            number("physics_frames_per_s", 0),
            number("environment_frames_per_s", 0),
            fixed(row["environment_frames_per_s"].get<double>() / 1000, 1),
            known("python_frames_per_s", 0),
            share > 0 ? fixed(100 * share, 1) : "-",
            known("two_processes_frames_per_s", 0),
            known("pictured_frames_per_s", 0),
            number("reset_ms", 2),
            number("field_mib", 1),
            number("environment_mib", 1),
            number("field_build_s", 2)};
}

/// A table of Markdown from rows, the first of which is the head.
std::string markdown(const std::vector<std::vector<std::string>>& rows) {
    std::string text;
    for (size_t i = 0; i < rows.size(); ++i) {
        for (const std::string& cell : rows[i]) text += "| " + cell + " ";
        text += "|\n";
        for (size_t k = 0; i == 0 && k < rows[0].size(); ++k) text += "|---";
        if (i == 0) text += "|\n";
    }
    return text;
}

std::string where(const Json& machine) {
    return machine["processor"].get<std::string>() + ", " +
           std::to_string(machine["logical_cores"].get<int>()) + " logical cores, kernels " +
           machine["kernel_target"].get<std::string>() + ", " +
           machine["compiler"].get<std::string>() + ", " + curriculum::utc_day(std::time(nullptr)) +
           ", load before " + fixed(machine["load_average_1min_before"].get<double>(), 1);
}

using Rows = std::vector<std::vector<std::string>>;

Rows speed(const EnvironmentOptions& options, Json& json) {
    Rows rows{{"task", "field", "tets", "substeps", "physics alone, frames/s",
               "environment, frames/s", "x real time", "from Python, frames/s",
               "Python's part of a step, %", "two processes, frames/s",
               "with a picture a step, frames/s", "reset, ms", "field, MiB", "environment, MiB",
               "field built in, s"}};
    for (const bench::EnvironmentCase& what : cases(options)) {
        const Json row = to_json(bench::measure_environment(what, options.quick ? 3 : 9),
                                 python_row(options, what));
        json["rows"].push_back(row);
        rows.push_back(cells_of(row));
        std::cerr << row["task"].get<std::string>() << ": "
                  << fixed(row["environment_frames_per_s"].get<double>(), 0) << " frames/s\n";
        if (const auto problem = row["python_problem"].get<std::string>(); !problem.empty())
            std::cerr << row["task"].get<std::string>() << ": not measured from Python: " << problem
                      << "\n";
    }
    return rows;
}

Rows policies(const EnvironmentOptions& options, Json& json) {
    Rows rows{{"task", "policy", "attempts", "passed", "points", "dense reward", "duration, s"}};
    for (const char* task : kTasks) {
        if (!options.task.empty() && options.task != task) continue;
        const int attempts = std::string(task) == "sb_dissection" ? 1 : options.attempts;
        (void)bench::measure_policies(
            {"", task, ""}, attempts, options.quick ? 5 : 60, [&](const bench::PolicyRow& row) {
                json["policies"].push_back({{"task", row.task},
                                            {"policy", row.policy},
                                            {"attempts", row.attempts},
                                            {"passed", row.successes},
                                            {"points", row.points},
                                            {"dense_reward", row.reward},
                                            {"duration_s", row.duration_s}});
                rows.push_back({row.task, row.policy, std::to_string(row.attempts),
                                std::to_string(row.successes), fixed(row.points, 1),
                                fixed(row.reward, 3), fixed(row.duration_s, 0)});
                std::cerr << row.task << ", " << row.policy << ": " << fixed(row.points, 1)
                          << " points\n";
            });
    }
    return rows;
}

void write_files(const std::string& folder, const std::string& name, const Json& json,
                 const std::string& text) {
    std::error_code error;
    fs::create_directories(folder, error);
    std::ofstream document(folder + "/" + name + ".json"), page(folder + "/" + name + ".md");
    document << json.dump(2) << '\n';
    page << text;
    document.flush();
    page.flush();
    if (!document || !page)
        throw InputError("--out " + folder + ": cannot be written; choose another place");
}

int run(const Context& context, const EnvironmentOptions& options) {
    need_writable_folder("--out", options.out);
    Json json{{"benchmark", "environment"}, {"machine", machine()}};
    std::string text;
    if (options.policies) {
        const Rows rows = policies(options, json);
        text = options.out.empty() ? table(rows) : markdown(rows);
        text += "\n" + where(json["machine"]) + "; steps of 20 frames, seeds from 1.\n";
    } else {
        const Rows rows = speed(options, json);
        const bench::SharingRow sharing = bench::measure_sharing(cases(options).front());
        json["sharing"] = {{"environments", sharing.environments},
                           {"shared_mib", sharing.shared_mib},
                           {"apart_mib", sharing.apart_mib}};
        text = options.out.empty() ? table(rows) : markdown(rows);
        text +=
            "\n" + std::to_string(sharing.environments) + " environments of one field take " +
            fixed(sharing.shared_mib, 0) + " MiB; with a field each " +
            fixed(sharing.apart_mib, 0) + " MiB (" + cases(options).front().name + ").\n" +
            where(json["machine"]) +
            "; one thread, 2 s of the scripted expert at work in steps of 20 frames (1 ms each), "
            "physics alone and environment in turns, medians; pictures of 320 x 240.\n";
    }
    if (!options.out.empty())
        write_files(options.out, options.policies ? "environment_policies" : "environment_speed",
                    json, text);
    warn_if_busy(json["machine"]);
    print(context, json, text);
    return 0;
}

}  // namespace

void add_environment_command(CLI::App& bench, Context& context) {
    auto options = std::make_shared<EnvironmentOptions>();
    CLI::App* command = bench.add_subcommand(
        "environment", "Environments for programs: frames a second, reset, memory, policies");
    command->add_flag("--quick", options->quick, "Fewer tasks and shorter runs");
    command->add_flag("--policies", options->policies,
                      "What nothing, chance and the scripted expert reach in every task");
    command->add_option("--attempts", options->attempts, "Attempts of each policy")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command->add_option("--task", options->task, "This task only");
    command->add_option("--scene", options->scene, "With --task: changes to its scene, as JSON")
        ->needs("--task");
    command->add_option("--python", options->python, "Interpreter that has the package placode")
        ->capture_default_str();
    command->add_option("--out", options->out, "Folder for a table (Markdown) and JSON");
    command->callback([&context, options] {
        context.run = [&context, options] { return run(context, *options); };
    });
}

}  // namespace placode::cli
