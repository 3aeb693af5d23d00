// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl bench contact: what a frame costs by part.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <memory>

#include "bench/frame_parts.h"
#include "bench/hard_scenes.h"
#include "bench/recorded_frames.h"
#include "curriculum/task.h"
#include "db/recording_file.h"
#include "reports/report.h"
#include "sim/anatomy/operative_field.h"
#include "ui/cli/cli.h"
#include "ui/cli/write_file.h"

namespace placode::cli {
namespace {

using bench::FrameParts;
using bench::kPartNames;
using bench::kParts;
using bench::other_of_frame;
using bench::other_share;
using bench::percentile;
using bench::sum;

constexpr double kFrameS = 1e-3;  // in every task

struct ContactBenchOptions {
    bool quick = false;
    std::string out, task = "diathermy_ring", recording, scene;
};

Json to_json(const FrameParts& costs) {
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
            {"all_but_solve_of_frame", other_of_frame(costs, kFrameS)},
            {"parts", parts}};
}

void write_files(const std::string& folder, const Json& json, const std::vector<FrameParts>& all) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    std::ofstream csv(folder + "/bench_contact.csv");
    csv << "case,threads,substeps,frames,mean_contacts,awake_share,part,mean_us,p50_us,p99_us,p999_"
           "us\n";
    for (const FrameParts& costs : all) {
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
void draw(const std::string& path, const std::vector<FrameParts>& all) {
    reports::CurveChart chart;
    chart.title = "Cost of a frame of 1 ms";
    chart.x_label = "share of the frames [%]";
    chart.y_label = "wall clock [us]";
    chart.log_x = false;
    for (const FrameParts& costs : all) {
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

/// What is measured: a field's work, a recorded attempt, or a scene that costs much.
struct Measured {
    std::string name;
    size_t tets = 0, triangles = 0;
    int frames = 0;  ///< A case; 0 = as many as it takes.
    std::function<std::vector<FrameParts>(int threads)> measure;
};

Measured hard_scene(const ContactBenchOptions& options) {
    const auto scenes = bench::hard_scenes();
    const auto found = std::find_if(scenes.begin(), scenes.end(), [&](const bench::HardScene& s) {
        return options.scene == s.name;
    });
    const auto field = found->field();
    return {found->name, static_cast<size_t>(field->body.tet_count()),
            field->surface.rest_triangles().size(), 0,
            [found, quick = options.quick](int threads) { return found->measure(threads, quick); }};
}

Measured measured(const ContactBenchOptions& options) {
    if (!options.scene.empty()) return hard_scene(options);
    std::shared_ptr<const sim::Recording> recording;
    if (!options.recording.empty())
        recording = std::make_shared<sim::Recording>(db::read_recording_file(options.recording));
    const curriculum::Task task =
        recording ? curriculum::load_task_text(recording->header.task_json, "recording")
                  : curriculum::load_task(options.task);
    const std::shared_ptr<const sim::Scene> scene = sim::build_operative_field(task.scene);
    const int frames = options.quick ? 300 : 5000;
    return {task.id, static_cast<size_t>(scene->body.tet_count()),
            scene->surface.rest_triangles().size(), recording ? 0 : frames, [=](int threads) {
                if (recording) return bench::measure_recording(*recording, threads);
                std::vector<FrameParts> all;
                for (const bench::WorkCase& what : bench::work_cases())
                    all.push_back(bench::measure_frames(*scene, what, threads, frames));
                return all;
            }};
}

int run(const Context& context, const ContactBenchOptions& options) {
    need_writable_folder("--out", options.out);
    const Measured what = measured(options);
    Json json{{"benchmark", "contact"}, {"machine", machine()},        {"task", what.name},
              {"tets", what.tets},      {"triangles", what.triangles}, {"rows", Json::array()}};
    std::vector<std::vector<std::string>> cells{
        {"case", "threads", "contacts", "awake", "solve", "contact", "heat", "cut", "rest",
         "recording", "frame", "p99", "p99.9", "all but solve", "of real time"}};
    std::vector<FrameParts> all;
    for (const int threads : {1, 2}) {
        for (const FrameParts& costs : what.measure(threads)) {
            std::vector<std::string> row{costs.case_name, std::to_string(threads),
                                         fixed(costs.contacts, 1),
                                         fixed(100 * costs.awake, 0) + " %"};
            for (int p = 0; p <= kParts; ++p) row.push_back(fixed(percentile(costs.us[p], 0.5), 0));
            row.push_back(fixed(percentile(costs.us[kParts], 0.99), 0));
            row.push_back(fixed(percentile(costs.us[kParts], 0.999), 0));
            row.push_back(fixed(100 * other_share(costs), 1) + " %");
            row.push_back(fixed(100 * other_of_frame(costs, kFrameS), 1) + " %");
            std::cerr << costs.case_name << ", " << threads
                      << " thread(s): " << fixed(percentile(costs.us[kParts], 0.5), 0)
                      << " us a frame\n";
            cells.push_back(row);
            json["rows"].push_back(to_json(costs));
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
            (what.frames == 0 ? "the case's" : std::to_string(what.frames)) +
            " frames of 1 ms; all but solve = share of the total time, and of the real time of the "
            "frames; " +
            std::to_string(what.tets) + " tets, " + std::to_string(all.front().substeps) +
            " substeps, kernels " + sim::kernel_target());
    return 0;
}

}  // namespace

void add_contact_bench_command(CLI::App& bench, Context& context) {
    auto options = std::make_shared<ContactBenchOptions>();
    CLI::App* command = bench.add_subcommand(
        "contact", "What a frame costs by part: solve, contact, heat, cut, recording");
    command->add_flag("--quick", options->quick, "Fewer frames");
    command->add_option("--out", options->out, "Folder for bench_contact.csv, .json and .png");
    CLI::Option* of_task =
        command->add_option("--task", options->task, "Task whose field is measured")
            ->capture_default_str();
    command
        ->add_option("--recording", options->recording,
                     "Frames of a recorded attempt instead, step by step")
        ->excludes(of_task);
    std::vector<std::string> names;
    for (const bench::HardScene& scene : bench::hard_scenes()) names.emplace_back(scene.name);
    command
        ->add_option("--scene", options->scene,
                     "Needle and thread in a row of bites, or a patch: each state beside the same "
                     "field without them")
        ->check(CLI::IsMember(names))
        ->excludes(of_task);
    command->callback([&context, options] {
        context.run = [&context, options] { return run(context, *options); };
    });
}

}  // namespace placode::cli
