// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl bench contact: what a frame of 1 ms costs and where it goes (solve, contact, heat,
// cut, rest, recording), on the field of a task, from hands off to cutting. Wall clock of every
// frame.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>

#include "curriculum/attempt_recorder.h"
#include "curriculum/task.h"
#include "db/recording_file.h"
#include "haptics/trocar.h"
#include "reports/report.h"
#include "sim/anatomy/operative_field.h"
#include "sim/step/step.h"
#include "ui/cli/cli.h"

namespace placode::cli {
namespace {

using Clock = std::chrono::steady_clock;

struct Options {
    bool quick = false;
    std::string out, task = "diathermy_ring";
};

constexpr int kParts = 6;
constexpr const char* kPartNames[kParts] = {"solve", "contact", "heat", "cut", "rest", "recording"};

/// What the hands do.
enum class Work { kAway, kPress, kDrag, kCut };

struct Case {
    const char* name;
    Work work;
};
constexpr Case kCases[] = {{"hands off", Work::kAway},
                           {"needle presses", Work::kPress},
                           {"needle drags", Work::kDrag},
                           {"needle cuts", Work::kCut}};

struct Costs {
    std::string case_name;
    int threads = 0, substeps = 0, frames = 0;
    double contacts = 0;
    double awake = 0;                    ///< Share of the blocks of tissue that are solved, mean.
    std::vector<double> us[kParts + 1];  ///< By frame; the last is the whole frame.
};

double percentile(std::vector<double> values, double share) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    const auto last = static_cast<double>(values.size() - 1);
    return values[static_cast<size_t>(std::ceil(share * last))];
}

double sum(const std::vector<double>& values) {
    double total = 0;
    for (const double v : values) total += v;
    return total;
}

/// Share of everything but the solve, of all frames together.
double other_share(const Costs& costs) {
    const double all = sum(costs.us[kParts]);
    return all > 0 ? 1 - sum(costs.us[0]) / all : 0;
}

/// The same against the time that a frame stands for: how much of real time it takes.
double other_of_frame(const Costs& costs, double frame_s) {
    return 1e-6 * (sum(costs.us[kParts]) - sum(costs.us[0])) / (costs.frames * frame_s);
}

/// The first instrument of every port but the scope's works at the planned contour, its shaft
/// through its trocar.
void move_hands(const sim::Scene& scene, const std::vector<sim::Vec3>& contour, Work work,
                int frame, std::vector<sim::ToolInput>& inputs) {
    for (size_t i = 0; i < inputs.size(); ++i) {
        const sim::ToolSpec& tool = scene.tools[i];
        const bool scope = tool.kind == sim::ToolKind::kScope;
        // 3 mm/s along the contour where the hand moves.
        const bool moves = work == Work::kDrag || work == Work::kCut;
        double way = moves ? 3e-6 * frame : 0;
        size_t n = 0;
        sim::Vec3 target = contour.front();
        for (; n + 1 < contour.size(); ++n) {
            const double length = (contour[n + 1] - contour[n]).norm();
            if (way < length) {
                target = contour[n] + way / length * (contour[n + 1] - contour[n]);
                break;
            }
            way -= length;
        }
        const double down = std::min(0.0003, 2e-5 * frame - 0.0005);
        target.z() -= work == Work::kAway ? -0.010 : down;
        if (scope) target = sim::Vec3(0, 0, 0.030);
        const sim::Vec3 along = (target - tool.pivot_m).normalized();
        inputs[i].set_pose({target, sim::Quat::FromTwoVectors(sim::Vec3::UnitZ(), along)});
        const uint32_t before = (1U << i) - 1;
        inputs[i].engaged = (haptics::others_in_port(scene.tools, i) & before) != 0 ? 0 : 1;
        inputs[i].pedals = work == Work::kCut && !scope ? sim::kPedalCut : 0;
    }
}

Costs measure(const sim::Scene& scene, const Case& what, int threads, int frames) {
    Costs costs;
    costs.case_name = what.name;
    costs.threads = threads;
    sim::State state(scene, threads);
    sim::settle(scene, state, 0.3);
    costs.substeps = state.substeps;
    std::vector<sim::Vec3> contour(scene.contour_anchors.size());
    sim::deformed_contour(scene, state, contour);
    std::vector<sim::ToolInput> inputs(scene.tools.size());
    std::vector<sim::ToolFeedback> feedback(inputs.size());

    // Recorded as in an attempt, into a file that is thrown away.
    const auto path =
        std::filesystem::temp_directory_path() /
        ("placode-bench-" + std::to_string(Clock::now().time_since_epoch().count()) + ".placode");
    sim::RecordingHeader header;
    header.task_id = "bench";
    header.tools = scene.tools;
    header.geometry = scene.geometry;
    curriculum::AttemptRecorder recorder(db::create_recording_file(path.string()), header);
    recorder.start();
    constexpr int kWarmUp = 100;
    int64_t dropped = 0;
    for (int frame = 0; frame < frames + kWarmUp; ++frame) {
        move_hands(scene, contour, what.work, frame, inputs);
        const auto start = Clock::now();
        const sim::StepReport report = sim::step(scene, state, inputs, feedback);
        const auto stepped = Clock::now();
        sim::Input input;
        input.frame = state.frame;
        input.substeps = state.substeps;
        input.tool_count = static_cast<int32_t>(inputs.size());
        std::copy(inputs.begin(), inputs.end(), input.tools);
        dropped += !recorder.put(input);
        for (int e = 0; e < state.event_count; ++e) {
            dropped += !recorder.put(state.events[static_cast<size_t>(e)]);
        }
        const auto end = Clock::now();
        if (frame < kWarmUp) continue;
        ++costs.frames;
        costs.contacts += report.contacts;
        costs.awake += state.sleep.enabled() ? 1 - static_cast<double>(state.sleep.asleep_count) /
                                                       state.sleep.blocks()
                                             : 1;
        for (int p = 0; p < kParts - 1; ++p) {
            costs.us[p].push_back(1e-3 *
                                  static_cast<double>(report.cost_ns[static_cast<size_t>(p)]));
        }
        const auto us = [](auto d) { return std::chrono::duration<double, std::micro>(d).count(); };
        costs.us[kParts - 1].push_back(us(end - stepped));
        costs.us[kParts].push_back(us(end - start));
    }
    recorder.finish({sim::EndReason::kFinished, state.time_s, 0, dropped});
    std::error_code ignored;
    for (const char* tail : {"", "-wal", "-shm"}) {
        std::filesystem::remove(path.string() + tail, ignored);
    }
    costs.contacts /= costs.frames;
    costs.awake /= costs.frames;
    return costs;
}

Json to_json(const Costs& costs, double frame_s) {
    Json parts = Json::object();
    for (int p = 0; p <= kParts; ++p) {
        parts[p < kParts ? kPartNames[p] : "frame"] = {{"mean_us", sum(costs.us[p]) / costs.frames},
                                                       {"p50_us", percentile(costs.us[p], 0.5)},
                                                       {"p99_us", percentile(costs.us[p], 0.99)},
                                                       {"p999_us", percentile(costs.us[p], 0.999)}};
    }
    return {{"case", costs.case_name},
            {"threads", costs.threads},
            {"substeps", costs.substeps},
            {"frames", costs.frames},
            {"mean_contacts", costs.contacts},
            {"awake_share", costs.awake},
            {"share_of_all_but_solve", other_share(costs)},
            {"all_but_solve_of_frame", other_of_frame(costs, frame_s)},
            {"parts", parts}};
}

void write_files(const std::string& folder, const Json& json, const std::vector<Costs>& all) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    std::ofstream csv(folder + "/bench_contact.csv");
    csv << "case,threads,substeps,frames,mean_contacts,awake_share,part,mean_us,p50_us,p99_us,p999_"
           "us\n";
    for (const Costs& costs : all) {
        for (int p = 0; p <= kParts; ++p) {
            csv << '"' << costs.case_name << "\"," << costs.threads << ',' << costs.substeps << ','
                << costs.frames << ',' << fixed(costs.contacts, 1) << ',' << fixed(costs.awake, 3)
                << ',' << (p < kParts ? kPartNames[p] : "frame") << ','
                << fixed(sum(costs.us[p]) / costs.frames, 2) << ','
                << fixed(percentile(costs.us[p], 0.5), 2) << ','
                << fixed(percentile(costs.us[p], 0.99), 2) << ','
                << fixed(percentile(costs.us[p], 0.999), 2) << '\n';
        }
    }
    std::ofstream document(folder + "/bench_contact.json");
    document << json.dump(2) << '\n';
    csv.flush();
    document.flush();
    if (!csv || !document)
        throw InputError("--out " + folder + ": cannot be written; choose another place");
}

/// Share of the frames that cost no more than so many microseconds.
void draw(const std::string& path, const std::vector<Costs>& all) {
    reports::CurveChart chart;
    chart.title = "Cost of a frame of 1 ms";
    chart.x_label = "share of the frames [%]";
    chart.y_label = "wall clock [us]";
    chart.log_x = false;
    for (const Costs& costs : all) {
        reports::Curve curve;
        curve.name = costs.case_name + ", " + std::to_string(costs.threads) + " thread(s)";
        curve.y = costs.us[kParts];
        std::sort(curve.y.begin(), curve.y.end());
        for (size_t i = 0; i < curve.y.size(); ++i) {
            curve.x.push_back(100.0 * static_cast<double>(i + 1) /
                              static_cast<double>(curve.y.size()));
        }
        chart.curves.push_back(curve);
    }
    chart.levels.push_back({"1 ms", 1000});
    reports::write_chart_png(chart, path);
}

int run(const Context& context, const Options& options) {
    const auto scene = sim::build_operative_field(curriculum::load_task(options.task).scene);
    const int frames = options.quick ? 300 : 5000;
    const double frame_s = scene->body.spec().solver.frame_s;
    Json json{{"benchmark", "contact"},
              {"machine", machine()},
              {"task", options.task},
              {"tets", scene->body.tet_count()},
              {"triangles", scene->surface.rest_triangles().size()},
              {"rows", Json::array()}};
    std::vector<std::vector<std::string>> cells{
        {"case", "threads", "contacts", "awake", "solve", "contact", "heat", "cut", "rest",
         "recording", "frame", "p99", "p99.9", "all but solve", "of real time"}};
    std::vector<Costs> all;
    for (const int threads : {1, 2}) {
        for (const Case& what : kCases) {
            const Costs costs = measure(*scene, what, threads, frames);
            std::vector<std::string> row{costs.case_name, std::to_string(threads),
                                         fixed(costs.contacts, 1),
                                         fixed(100 * costs.awake, 0) + " %"};
            for (int p = 0; p <= kParts; ++p) row.push_back(fixed(percentile(costs.us[p], 0.5), 0));
            row.push_back(fixed(percentile(costs.us[kParts], 0.99), 0));
            row.push_back(fixed(percentile(costs.us[kParts], 0.999), 0));
            row.push_back(fixed(100 * other_share(costs), 1) + " %");
            row.push_back(fixed(100 * other_of_frame(costs, frame_s), 1) + " %");
            std::cerr << costs.case_name << ", " << threads
                      << " thread(s): " << fixed(percentile(costs.us[kParts], 0.5), 0)
                      << " us a frame\n";
            cells.push_back(row);
            json["rows"].push_back(to_json(costs, frame_s));
            all.push_back(costs);
        }
    }
    if (!options.out.empty()) {
        write_files(options.out, json, all);
        draw(options.out + "/bench_contact.png", all);
    }
    const double busy = json["machine"]["load_average_1min_before"].get<double>();
    if (busy > 0.5)
        std::cerr << "placodectl: other programs were running (load " << fixed(busy, 1)
                  << "): the times are too long; their ratios mean more than they do\n";
    print(
        context, json,
        table(cells) + "Microseconds of wall clock, medians by part over " +
            std::to_string(frames) +
            " frames of 1 ms; all but solve = share of the total time, and of the real time of the "
            "frames; " +
            std::to_string(scene->body.tet_count()) + " tets, " +
            std::to_string(all.front().substeps) + " substeps, kernels " + sim::kernel_target());
    return 0;
}

}  // namespace

void add_contact_bench_command(CLI::App& bench, Context& context) {
    auto options = std::make_shared<Options>();
    CLI::App* command = bench.add_subcommand(
        "contact", "What a frame costs by part: solve, contact, heat, cut, recording");
    command->add_flag("--quick", options->quick, "Fewer frames");
    command->add_option("--out", options->out, "Folder for bench_contact.csv, .json and .png");
    command->add_option("--task", options->task, "Task whose field is measured")
        ->capture_default_str();
    command->callback([&context, options] {
        context.run = [&context, options] { return run(context, *options); };
    });
}

}  // namespace placode::cli
