// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl bench picture: what a picture of a recorded attempt costs, from the richest quality to
// the plainest.

#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "assessment/statistics.h"
#include "bench/frame_parts.h"
#include "curriculum/replay.h"
#include "db/recording_file.h"
#include "ui/cli/cli.h"
#include "ui/cli/write_file.h"
#include "ui/view/fetoscope_view.h"
#include "ui/view/picture_size.h"

namespace placode::cli {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kScreenMs = 1000.0 / 60;  // of most screens
constexpr double kEveryS = 1.0 / 60;       // of the attempt: what a screen shows after another
constexpr int kWarming = 3;                // pictures: shaders are compiled, caches filled
constexpr int kLeast = 10;                 // pictures that a median is made of
constexpr int kMost = 1000;                // 0.7 MB of memory each
constexpr int kSmallestPx = 64, kLargestPx = 8192;

struct PictureOptions {
    std::string recording, out, save;
    std::vector<std::string> sizes{"640x640", "1920x1080"};
    double from_s = -1, seconds = 4;
    int pictures = 120;
};

struct Row {
    view::PictureSize size;
    view::Quality quality;
    std::string renderer;
    std::vector<double> ms;
    [[nodiscard]] double median_ms() const { return assessment::median_of(ms); }
    [[nodiscard]] double p99_ms() const { return bench::percentile(ms, 0.99); }
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

/// What a screen would show one after another, from `from_s` of the attempt on.
std::vector<sim::Snapshot> moments(curriculum::Replay& replay, double from_s, int count) {
    std::vector<sim::Snapshot> all;
    while (static_cast<int>(all.size()) < count && replay.step()) {
        const double next_s = from_s + kEveryS * static_cast<double>(all.size());
        if (replay.state().time_s < next_s) continue;
        sim::fill_snapshot(replay.scene(), replay.state(), all.emplace_back());
    }
    // Pictures of tissue that the recording never had are no pictures of the attempt.
    if (static_cast<int>(all.size()) < count && !replay.result().identical)
        throw std::runtime_error(replay.result().message);
    return all;
}

/// Until every moment was drawn or the time is up, but never so few that a median means nothing.
Row measure(const view::ViewField& field, const std::vector<sim::Snapshot>& moments,
            const view::PictureSize& size, const view::Quality& quality,
            const PictureOptions& options) {
    view::ViewSettings settings;
    settings.width = size.width;
    settings.height = size.height;
    settings.offscreen = true;
    settings.adaptive = false;
    settings.quality = quality;
    view::FetoscopeView view(field, settings);
    Row row{size, quality, view.renderer(), {}};
    const view::OverlayState overlay;
    const size_t count = std::max(moments.size(), static_cast<size_t>(kWarming + kLeast));
    double spent_ms = 0;
    for (size_t i = 0; i < count; ++i) {
        const auto start = Clock::now();
        view.draw(moments[i % moments.size()], overlay);
        const std::chrono::duration<double, std::milli> spent = Clock::now() - start;
        if (i < kWarming) continue;
        row.ms.push_back(spent.count());
        spent_ms += spent.count();
        if (spent_ms > 1000 * options.seconds && row.ms.size() >= kLeast) break;
    }
    if (!options.save.empty()) {
        const std::string name = text_of(size) + "_" + fixed(quality.render_scale, 2) + "_" +
                                 std::to_string(quality.samples) +
                                 (quality.shadows ? "_shadows" : "") +
                                 (quality.plain ? "_plain" : "") + ".png";
        view.save_png((std::filesystem::path(options.save) / name).string());
    }
    return row;
}

Json to_json(const Row& row) {
    return {{"width", row.size.width},
            {"height", row.size.height},
            {"render_scale", row.quality.render_scale},
            {"samples", row.quality.samples},
            {"shadows", row.quality.shadows},
            {"plain", row.quality.plain},
            {"pictures", row.ms.size()},
            {"median_ms", row.median_ms()},
            {"p99_ms", row.p99_ms()},
            {"pictures_per_s", 1000 / row.median_ms()}};
}

std::vector<std::string> to_cells(const Row& row) {
    return {text_of(row.size),
            fixed(row.quality.render_scale, 2),
            std::to_string(row.quality.samples),
            row.quality.shadows ? "yes" : "no",
            row.quality.plain ? "yes" : "no",
            std::to_string(row.ms.size()),
            fixed(row.median_ms(), 2),
            fixed(row.p99_ms(), 2),
            fixed(1000 / row.median_ms(), 1),
            row.p99_ms() <= kScreenMs ? "yes" : "no"};
}

void check(const PictureOptions& options) {
    if (options.pictures < kLeast || options.pictures > kMost)
        throw InputError("--pictures " + std::to_string(options.pictures) + ": expected " +
                         std::to_string(kLeast) + " to " + std::to_string(kMost));
    if (!(options.seconds > 0 && options.seconds <= 600))
        throw InputError("--seconds " + fixed(options.seconds, 3) + ": expected up to 600");
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
    const std::vector<sim::Snapshot> drawn = moments(replay, from_s, options.pictures);
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
        view::Quality quality;
        while (view::make_richer(quality)) {
        }
        do {
            const Row row = measure(field, drawn, size, quality, options);
            json["renderer"] = row.renderer;
            json["rows"].push_back(to_json(row));
            cells.push_back(to_cells(row));
            std::cerr << text_of(size) << ": " << fixed(row.median_ms(), 2) << " ms a picture\n";
        } while (view::make_simpler(quality));
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
    command->add_option("--from", options->from_s, "Second of the attempt (default: its middle)");
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
