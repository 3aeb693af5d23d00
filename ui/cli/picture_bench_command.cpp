// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl bench picture: what a picture of a recorded attempt costs, from the richest quality to
// the plainest.

#include <filesystem>
#include <iostream>
#include <memory>

#include "assessment/statistics.h"
#include "bench/frame_parts.h"
#include "bench/screen_moments.h"
#include "db/recording_file.h"
#include "ui/cli/cli.h"
#include "ui/cli/write_file.h"
#include "ui/finite_range.h"
#include "ui/view/picture_times.h"

namespace placode::cli {
namespace {

constexpr int kMost = 1000;  // 0.7 MB of memory each
constexpr int kSmallestPx = 64, kLargestPx = 8192;

struct PictureOptions {
    std::string recording, out, save;
    std::vector<std::string> sizes{"640x640", "1920x1080"};
    double from_s = -1, seconds = 4;
    int pictures = 120;
};

view::PictureSize size_of(const std::string& text) {
    const auto size = view::picture_size(text);
    const auto fits = [](int px) { return px >= kSmallestPx && px <= kLargestPx; };
    if (!size || !fits(size->width) || !fits(size->height))
        throw InputError("--size " + text + ": expected WxH, each " + std::to_string(kSmallestPx) +
                         " to " + std::to_string(kLargestPx) + " pixels, as in 1920x1080");
    return *size;
}

std::string text_of(const view::PictureSize& size) {
    return std::to_string(size.width) + "x" + std::to_string(size.height);
}

double median_ms(const view::PictureTimes& times) { return assessment::median_of(times.ms); }
double p99_ms(const view::PictureTimes& times) { return bench::percentile(times.ms, 0.99); }

/// Where the last picture goes; empty: nowhere.
std::string picture_file(const PictureOptions& options, const view::PictureSize& size,
                         const view::Quality& quality) {
    if (options.save.empty()) return {};
    const std::string name = text_of(size) + "_" + fixed(quality.render_scale, 2) + "_" +
                             std::to_string(quality.samples) + (quality.shadows ? "_shadows" : "") +
                             (quality.plain ? "_plain" : "") + ".png";
    return (std::filesystem::path(options.save) / name).string();
}

Json to_json(const view::PictureTimes& row) {
    return {{"width", row.size.width},
            {"height", row.size.height},
            {"render_scale", row.quality.render_scale},
            {"samples", row.quality.samples},
            {"shadows", row.quality.shadows},
            {"plain", row.quality.plain},
            {"pictures", row.ms.size()},
            {"median_ms", median_ms(row)},
            {"p99_ms", p99_ms(row)},
            {"pictures_per_s", 1000 / median_ms(row)}};
}

std::vector<std::string> to_cells(const view::PictureTimes& row) {
    return {text_of(row.size),
            fixed(row.quality.render_scale, 2),
            std::to_string(row.quality.samples),
            row.quality.shadows ? "yes" : "no",
            row.quality.plain ? "yes" : "no",
            std::to_string(row.ms.size()),
            fixed(median_ms(row), 2),
            fixed(p99_ms(row), 2),
            fixed(1000 / median_ms(row), 1),
            p99_ms(row) <= 1000 * bench::kScreenS ? "yes" : "no"};
}

void check(const PictureOptions& options) {
    if (options.pictures < view::kLeastPictures || options.pictures > kMost)
        throw InputError("--pictures " + std::to_string(options.pictures) + ": expected " +
                         std::to_string(view::kLeastPictures) + " to " + std::to_string(kMost));
    if (!(options.seconds > 0 && options.seconds <= 600))
        throw InputError("--seconds " + fixed(options.seconds, 3) + ": expected up to 600");
    need_writable_file("--out", options.out);
    if (options.save.empty()) return;
    std::error_code error;
    std::filesystem::create_directories(options.save, error);
    if (error)
        throw InputError("--save " + options.save +
                         ": cannot be made a folder: " + error.message());
}

int run(const Context& context, const PictureOptions& options) {
    check(options);
    std::vector<view::PictureSize> sizes;
    for (const std::string& text : options.sizes) sizes.push_back(size_of(text));
    const sim::Recording recording = db::read_recording_file(options.recording);
    const double middle_s = 0.5 * recording.end.duration_s;
    const double from_s = options.from_s >= 0 ? options.from_s : middle_s;
    curriculum::Replay replay(recording, 2);
    std::cerr << "simulating to " << fixed(from_s, 1) << " s ...\n";
    const std::vector<sim::Snapshot> drawn =
        bench::screen_moments(replay, from_s, options.pictures);
    if (drawn.empty())
        throw InputError("--from " + fixed(from_s, 1) + ": the recording ends at " +
                         fixed(recording.end.duration_s, 1) + " s");
    const view::ViewField field = view::view_field(replay.scene(), recording.header.seed);
    Json json{{"benchmark", "picture"},
              {"machine", machine()},
              {"task", recording.header.task_id},
              {"from_s", from_s},
              {"triangles", drawn.front().triangles.size()},
              {"rows", Json::array()}};
    std::vector<std::vector<std::string>> cells{{"size", "scale", "samples", "shadows", "plain",
                                                 "pictures", "median [ms]", "p99", "a second",
                                                 "60/s held"}};
    for (const view::PictureSize& size : sizes) {
        for (const view::Quality& quality : view::all_qualities()) {
            const view::PictureTimes row = view::time_pictures(
                field, drawn, size, quality, options.seconds, picture_file(options, size, quality));
            json["renderer"] = row.renderer;
            json["rows"].push_back(to_json(row));
            cells.push_back(to_cells(row));
            std::cerr << text_of(size) << ": " << fixed(median_ms(row), 2) << " ms a picture\n";
        }
    }
    if (!options.out.empty()) write_file(options.out, json.dump(2) + "\n");
    warn_if_busy(json["machine"]);
    print(context, json,
          table(cells) + "Wall clock from the state of the tissue to the finished picture, with " +
              std::to_string(drawn.front().triangles.size()) + " triangles of tissue, " +
              recording.header.task_id + " from " + fixed(from_s, 1) + " s on; drawn by " +
              json["renderer"].get<std::string>() + ", no physics beside it.");
    return 0;
}

}  // namespace

void add_picture_bench_command(CLI::App& bench, Context& context) {
    auto options = std::make_shared<PictureOptions>();
    CLI::App* command = bench.add_subcommand(
        "picture", "What a picture of a recorded attempt costs, from the richest to the plainest");
    command->add_option("--recording", options->recording, "The attempt (FILE.placode)")
        ->required();
    command->add_option("--size", options->sizes, "WxH of the pictures; may be given again")
        ->capture_default_str();
    command->add_option("--from", options->from_s, "Second of the attempt (default: its middle)")
        ->check(ui::finite_range(0.0, 86400.0));
    command->add_option("--pictures", options->pictures, "Pictures, a sixtieth of a second apart")
        ->capture_default_str();
    command->add_option("--seconds", options->seconds, "At most so long for each quality")
        ->capture_default_str();
    command->add_option("--save", options->save, "Folder for the last picture of each quality");
    command->add_option("--out", options->out, "File for the figures (JSON)");
    command->callback([&context, options] {
        context.run = [&context, options] { return run(context, *options); };
    });
}

}  // namespace placode::cli
