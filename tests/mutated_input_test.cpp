// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever a loader is given, it loads or refuses with its own exception: no crash, no hang, no
// other exception. Every loader gets files of the project, changed at random from a fixed seed.
// PLACODE_MUTATIONS=N tries N changes of each file; scripts/check.sh asan runs the same under
// AddressSanitizer and UBSan.

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>

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
#include "db/seals.h"
#include "db/store_error.h"
#include "db/store_url.h"
#include "db/void_reason.h"
#include "haptics/station.h"
#include "sim/core/random.h"
#include "sim/mesh/mesh.h"
#include "sim/mesh_io/mesh_io.h"

using namespace placode;
namespace fs = std::filesystem;

namespace THIS_TEST {

const fs::path kRoot = PLACODE_SOURCE_DIR;

std::string content(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<fs::path> files_in(const char* folder, const std::string& ending) {
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(kRoot / folder))
        if (entry.path().extension() == ending) found.push_back(entry.path());
    std::sort(found.begin(), found.end());
    return found;
}

/// What breaks parsers: ends of ranges, wrong types, brackets, other encodings.
const std::vector<std::string>& words() {
    static const std::vector<std::string> all{"-1",
                                              "0",
                                              "1e300",
                                              "-1e308",
                                              "1e-320",
                                              "NaN",
                                              "null",
                                              "true",
                                              "[]",
                                              "{}",
                                              "\"\"",
                                              "\"",
                                              "{",
                                              "}",
                                              "[",
                                              "]",
                                              ",",
                                              ":",
                                              "\n",
                                              "\r\n",
                                              "\t",
                                              "99999999999999999999",
                                              "2147483648",
                                              "-9223372036854775808",
                                              "../../../etc/passwd",
                                              "%00",
                                              "\\u0000",
                                              "\xff\xfe",
                                              "\xc3\x28",
                                              std::string(3, '\0'),
                                              std::string(300, '9'),
                                              std::string(200, '['),
                                              "\"id\":",
                                              "\"extends\":"};
    return all;
}

std::string mutated(std::string text, sim::SplitMix64& random) {
    const auto below = [&](size_t n) {
        return n == 0 ? 0 : static_cast<size_t>(random.next() % n);
    };
    const size_t changes = 1 + below(4);
    for (size_t i = 0; i < changes; ++i) {
        const size_t at = below(text.size() + 1), length = 1 + below(40);
        switch (below(7)) {
            case 0:
                if (at < text.size()) text[at] = static_cast<char>(random.next());
                break;
            case 1:
                text.erase(at, length);
                break;
            case 2:
                text.insert(at, words()[below(words().size())]);
                break;
            case 3:  // another word in the place of a number or name
                text.replace(at, std::min(length, text.size() - at),
                             words()[below(words().size())]);
                break;
            case 4:
                text.insert(at, text.substr(below(text.size() + 1), length));
                break;
            case 5:
                text.resize(at);
                break;
            default: {
                const size_t digit = text.find_first_of("0123456789", at);
                if (digit != std::string::npos) text.insert(digit, words()[below(8)]);
            }
        }
    }
    return text;
}

struct Loader {
    const char* name;
    std::vector<fs::path> files;
    std::function<void(const std::string&)> load;  ///< True exceptions come through.
};

void PrintTo(const Loader& loader, std::ostream* out) { *out << loader.name; }

/// For readers of files: the text under a name with the ending that tells the format.
std::string as_file(const std::string& text, const std::string& name) {
    const fs::path path =
        fs::temp_directory_path() / ("placode-mutated-" + std::to_string(::getpid()) + "-" + name);
    std::ofstream(path, std::ios::binary) << text;
    return path.string();
}

template <class Load>
std::function<void(const std::string&)> from_file(const std::string& name, Load load) {
    return [name, load](const std::string& text) {
        const std::string path = as_file(text, name);
        try {
            (void)load(path);
        } catch (...) {
            fs::remove(path);
            throw;
        }
        fs::remove(path);
    };
}

std::vector<Loader> loaders() {
    using namespace curriculum;
    const auto text = [](auto load) {
        return [load](const std::string& json) { (void)load(json, "mutated"); };
    };
    std::vector<Loader> all{
        {"task", files_in("data/tasks", ".json"), text(load_task_text)},
        {"course", files_in("data/courses", ".json"), text(load_course_text)},
        {"study", files_in("data/studies", ".json"), text(load_study_text)},
        {"questionnaire", files_in("data/questionnaires", ".json"), text(load_questionnaire_text)},
        {"standard", files_in("data/courses", ".json"), text(load_standard_text)},
        {"norm_pack", files_in("data/courses", ".json"), text(load_norm_pack)},
        {"signed_norms", files_in("data/courses", ".json"), text(load_signed_norms)},
        {"csv", files_in("tests/data/statistics", ".csv"),
         [](const std::string& csv) { (void)assessment::read_csv(csv); }},
        {"signal", files_in("tests/data/motion", ".csv"),
         from_file("signal.csv", assessment::read_signal_file)},
        {"station",
         {kRoot / "tests/data/README.md"},
         [](const std::string& conf) { (void)haptics::Station::parse(conf, "mutated"); }},
        {"recording_header", files_in("data/tasks", ".json"),
         [](const std::string& json) { (void)db::header_from_json(json); }},
        {"store_url",
         {kRoot / "tests/data/README.md"},
         [](const std::string& url) { (void)db::parse_store_url("postgresql://" + url); }},
        {"seals",
         {kRoot / "tests/data/README.md"},
         [](const std::string& lines) { (void)db::seals_of_text(lines); }},
        {"void_reasons",
         {kRoot / "tests/data/README.md"},
         [](const std::string& reasons) { (void)db::void_reasons(reasons); }},
    };
    for (const char* ending : {".msh", ".vtk", ".vtu"})
        all.push_back({ending + 1, files_in("tests/data/meshes", ending),
                       from_file(std::string("mesh") + ending, sim::read_mesh_file)});
    return all;
}

class MutatedInput : public testing::TestWithParam<Loader> {};

/// What a loader may say; everything else is a fault of ours.
bool is_refusal(const std::exception& error) {
    return dynamic_cast<const curriculum::DefinitionError*>(&error) != nullptr ||
           dynamic_cast<const db::StoreError*>(&error) != nullptr ||
           dynamic_cast<const haptics::DeviceError*>(&error) != nullptr ||
           dynamic_cast<const sim::MeshError*>(&error) != nullptr ||
           dynamic_cast<const assessment::CsvError*>(&error) != nullptr ||
           dynamic_cast<const assessment::SignalError*>(&error) != nullptr;
}

/// Milliseconds in truth: the limit is for what hangs.
void load(const Loader& loader, const std::string& text, const std::string& what) {
    const auto begin = std::chrono::steady_clock::now();
    try {
        loader.load(text);
    } catch (const std::exception& error) {
        EXPECT_TRUE(is_refusal(error)) << what << ": " << error.what();
        EXPECT_LT(std::string(error.what()).size(), 4000u) << what << ": nobody reads that";
    }
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20)) << what;
}

INSTANTIATE_TEST_SUITE_P(Loaders, MutatedInput, testing::ValuesIn(loaders()),
                         [](const auto& info) { return std::string(info.param.name); });

TEST_P(MutatedInput, IsLoadedOrRefused) {
    const Loader& loader = GetParam();
    ASSERT_FALSE(loader.files.empty());
    const char* set = std::getenv("PLACODE_MUTATIONS");
    const int each = set != nullptr ? std::atoi(set) : 500;
    for (const fs::path& file : loader.files) {
        const std::string whole = content(file);
        ASSERT_FALSE(whole.empty()) << file;
        sim::SplitMix64 random(std::hash<std::string>{}(file.filename().string()));
        for (int i = 0; i < each; ++i)
            load(loader, mutated(whole, random),
                 file.filename().string() + " change " + std::to_string(i));
    }
    for (const std::string& word : words()) load(loader, word, "\"" + word + "\"");
    load(loader, "", "nothing");
}

}  // namespace THIS_TEST
