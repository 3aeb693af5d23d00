// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Everything of Placode that reads what comes from outside, with inputs to begin from:
// mutated_input_test changes them at random, fuzz/ lets libFuzzer do it.

#include <unistd.h>

#include <QJsonDocument>
#include <algorithm>
#include <array>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

#include "assessment/benchmark.h"
#include "assessment/csv_reader.h"
#include "assessment/signal_file.h"
#include "curriculum/course.h"
#include "curriculum/definitions.h"
#include "curriculum/norm_pack.h"
#include "curriculum/questionnaire.h"
#include "curriculum/standard.h"
#include "curriculum/study.h"
#include "curriculum/task.h"
#include "db/recording_chunks.h"
#include "db/recording_file.h"
#include "db/said_json.h"
#include "db/seals.h"
#include "db/store_error.h"
#include "db/store_url.h"
#include "db/trail_head.h"
#include "db/void_reason.h"
#include "haptics/certificate.h"
#include "haptics/haply_message.h"
#include "haptics/station.h"
#include "sim/mesh/mesh.h"
#include "sim/mesh_io/mesh_io.h"

namespace placode::test {

struct Seed {
    std::string name, content;
};

struct Loader {
    const char* name;
    std::function<std::vector<Seed>()> seeds;      ///< What to begin from.
    std::function<void(const std::string&)> load;  ///< True exceptions come through.
};

inline void PrintTo(const Loader& loader, std::ostream* out) { *out << loader.name; }

inline std::string content_of(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Files with that ending in a folder of the project, in the order of their names.
inline std::function<std::vector<Seed>()> seeds_in(const std::string& folder,
                                                   const std::string& ending) {
    return [=] {
        std::vector<Seed> found;
        const std::filesystem::path root = PLACODE_SOURCE_DIR;
        for (const auto& entry : std::filesystem::directory_iterator(root / folder))
            if (entry.path().extension() == ending)
                found.push_back({entry.path().filename().string(), content_of(entry.path())});
        std::ranges::sort(found, {}, &Seed::name);
        return found;
    };
}
inline std::function<std::vector<Seed>()> seed(const std::string& name, const std::string& text) {
    return [=] { return std::vector<Seed>{{name, text}}; };
}

/// A place for one file of this process; readers of files take the text under a name whose ending
/// tells the format.
inline std::string scratch_file(const std::string& name) {
    return (std::filesystem::temp_directory_path() /
            ("placode-mutated-" + std::to_string(::getpid()) + "-" + name))
        .string();
}

template <class Load>
std::function<void(const std::string&)> from_file(const std::string& name, Load load) {
    return [name, load](const std::string& text) {
        const std::string path = scratch_file(name);
        std::ofstream(path, std::ios::binary) << text;
        try {
            (void)load(path);
        } catch (...) {
            std::filesystem::remove(path);
            throw;
        }
        std::filesystem::remove(path);
    };
}

/// A recording of half a second, as its file.
inline std::vector<Seed> small_recording() {
    const std::string path = scratch_file("seed.placode");
    std::filesystem::remove(path);
    sim::RecordingHeader header;
    header.task_id = "touch_targets";
    header.task_json = "{}";
    header.started_utc = "2026-01-02T03:04:05.678Z";
    header.tools.emplace_back();
    header.geometry.planned_contour = {{0.1, 0.2, 0.3}};
    const auto sink = db::create_recording_file(path);
    sink->begin(header);
    sink->append(std::vector<sim::Input>(500), std::vector<sim::Sample>(50),
                 std::vector<sim::Event>(5));
    sink->finish({sim::EndReason::kFinished, 0.5, 7, 0});
    std::vector<Seed> seeds{{"small", content_of(path)}};
    std::filesystem::remove(path);
    return seeds;
}

/// A chunk of a recording: a letter for its kind, then the packed records.
inline void load_chunk(const std::string& bytes) {
    if (bytes.empty()) return;
    const std::span packed(reinterpret_cast<const std::byte*>(bytes.data()) + 1, bytes.size() - 1);
    std::vector<sim::Input> inputs;
    std::vector<sim::Sample> samples;
    std::vector<sim::Event> events;
    if (bytes[0] == 'i') return db::decode_chunk(packed, 50, inputs);
    if (bytes[0] == 's') return db::decode_chunk(packed, 50, samples);
    db::decode_chunk(packed, 50, events);
}

inline std::vector<Seed> seeds_of_chunks() {
    const auto text = [](char kind, const db::Bytes& bytes) {
        return kind + std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    };
    return {{"inputs", text('i', db::encode_chunk(std::vector<sim::Input>(50)))},
            {"samples", text('s', db::encode_chunk(std::vector<sim::Sample>(50)))},
            {"events", text('e', db::encode_chunk(std::vector<sim::Event>(50)))}};
}

inline std::string norm_pack_of_five() {
    curriculum::NormPack pack;
    pack.centre = "Centre";
    pack.made_utc = "2026-01-02T03:04:05Z";
    pack.task_id = pack.rubric_id = "diathermy_ring";
    pack.task_version = pack.rubric_version = pack.metric_set_version = 1;
    const std::vector<double> values{70, 75, 80, 85, 90};
    pack.groups = {{"expert", 5, 10, {{"points", *assessment::make_benchmark(values, false)}}}};
    return curriculum::norm_pack_text(pack);
}

inline std::vector<Seed> seeds_of_standards() {
    curriculum::PassStandard groups, judges;
    groups.task_id = judges.task_id = "diathermy_ring";
    groups.novice = groups.expert = {5, 70, 3, 0.1, 0.2};
    judges.method = "angoff";
    judges.angoff = {5, 8, 1.5};
    return {{"groups", curriculum::standard_json(groups)},
            {"judges", curriculum::standard_json(judges)}};
}

inline std::vector<Seed> seeds_of_void_reasons() {
    std::vector<Seed> seeds;
    for (int i = 0; i <= static_cast<int>(db::VoidCause::kTaskVersion); ++i)
        seeds.push_back({std::to_string(i), db::void_text({{static_cast<db::VoidCause>(i), 1, 2,
                                                            db::Said::as_is("words")}})});
    return seeds;
}

/// What the store keeps of the same reasons beside their words.
inline std::vector<Seed> seeds_of_meanings() {
    std::vector<Seed> seeds;
    for (int i = 0; i <= static_cast<int>(db::VoidCause::kTaskVersion); ++i) {
        db::NotDone why;
        why.voids.push_back({static_cast<db::VoidCause>(i), 1, 2,
                             db::Said::that("%1 of %2").with(3).with(std::string("words"))});
        seeds.push_back({"void" + std::to_string(i), db::void_meaning(why.voids)});
        why.interrupted = i % 2 == 1;
        why.note = "a note";
        seeds.push_back({"step" + std::to_string(i), db::not_done_meaning(why)});
    }
    return seeds;
}

inline std::vector<Loader> loaders() {
    using namespace curriculum;
    const auto text = [](auto load) {
        return [load](const std::string& json) { (void)load(json, "mutated"); };
    };
    std::vector<Loader> all{
        {"task", seeds_in("data/tasks", ".json"), text(load_task_text)},
        {"course", seeds_in("data/courses", ".json"), text(load_course_text)},
        {"study", seeds_in("data/studies", ".json"), text(load_study_text)},
        {"questionnaire", seeds_in("data/questionnaires", ".json"), text(load_questionnaire_text)},
        {"standard", seeds_of_standards, text(load_standard_text)},
        {"norm_pack", seed("pack", norm_pack_of_five()), text(load_norm_pack)},
        {"signed_norms", seed("signed", signed_norms_text({norm_pack_of_five(), "ab", "cd"})),
         text(load_signed_norms)},
        {"csv", seeds_in("tests/data/statistics", ".csv"),
         [](const std::string& csv) { (void)assessment::read_csv(csv); }},
        {"signal", seeds_in("tests/data/motion", ".csv"),
         from_file("signal.csv", assessment::read_signal_file)},
        {"station",
         seed("arms",
              "# arms\n\n openhaptics.right = Right arm  # the old one\r\nhaply.right = 04EA\n"
              "limit.force_n=0.5\n"),
         [](const std::string& conf) { (void)haptics::Station::parse(conf, "mutated"); }},
        {"recording", small_recording, from_file("r.placode", db::read_recording_file)},
        {"recording_header", seeds_in("data/tasks", ".json"),
         [](const std::string& json) { (void)db::header_from_json(json); }},
        {"recording_end", seed("end", db::end_to_json({sim::EndReason::kFinished, 0.5, 7, 0})),
         [](const std::string& json) { (void)db::end_from_json(json); }},
        {"chunk", seeds_of_chunks, load_chunk},
        {"certificate", seed("empty", haptics::certificate_to_json({})),
         [](const std::string& json) { (void)haptics::certificate_from_json(json); }},
        {"haply_message",
         seed(
             "arm",
             R"({"inverse3":[{"device_id":"049D","state":{"cursor_position":{"x":0.1,"y":-2e-3,"z":0}}}]})"),
         [](const std::string& json) {
             haptics::HaplyParts parts;
             parts.read(json, 1);
         }},
        {"store_url", seed("server", "user:word@host:5432/placode?sslmode=verify-full&timeout=9"),
         [](const std::string& url) { (void)db::parse_store_url("postgresql://" + url); }},
        {"seals",
         seed("two", db::seals_text({{{"participant", {"pilot", "P001-K"}}, {"-", "ab"}},
                                     {{"attempt", {"12"}}, {"cd", "-"}}})),
         [](const std::string& lines) { (void)db::seals_of_text(lines); }},
        {"void_reasons", seeds_of_void_reasons,
         [](const std::string& reasons) { (void)db::void_reasons(reasons); }},
        {"not_done", seeds_of_void_reasons,
         [](const std::string& why) { (void)db::not_done(why); }},
        {"meaning", seeds_of_meanings,
         [](const std::string& json) {
             (void)db::void_reasons("words", json);
             (void)db::not_done("words", json);
             (void)db::said_of_json(
                 QJsonDocument::fromJson(QByteArray::fromStdString(json)).object());
         }},
        {"trail_head",
         seed("head", db::trail_head_text({"ab", 3, "cd", "2026-01-02T03:04:05Z", "ef", "01"})),
         from_file("trail.head", db::read_trail_head)},
    };
    for (const char* ending : {".msh", ".vtk", ".vtu"})
        all.push_back({ending + 1, seeds_in("tests/data/meshes", ending),
                       from_file(std::string("mesh") + ending, sim::read_mesh_file)});
    return all;
}

/// What a loader may say; everything else is a fault of ours.
inline bool is_refusal(const std::exception& error) {
    return dynamic_cast<const curriculum::DefinitionError*>(&error) != nullptr ||
           dynamic_cast<const db::StoreError*>(&error) != nullptr ||
           dynamic_cast<const haptics::DeviceError*>(&error) != nullptr ||
           dynamic_cast<const haptics::CertificateError*>(&error) != nullptr ||
           dynamic_cast<const sim::MeshError*>(&error) != nullptr ||
           dynamic_cast<const assessment::CsvError*>(&error) != nullptr ||
           dynamic_cast<const assessment::SignalError*>(&error) != nullptr;
}

}  // namespace placode::test
