// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The house rules that a compiler does not see: include order between folders, third-party headers
// in one folder only, licence lines, no common/ or util/.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace THIS_TEST {

const std::vector<std::string> kOrder{"sim",         "haptics", "assessment", "curriculum",
                                      "environment", "db",      "reports",    "bench",
                                      "batches",     "ui",      "interface",  "python"};

struct Include {
    std::string file, folder, target;
};

fs::path root() { return PLACODE_SOURCE_DIR; }

std::vector<fs::path> sources() {
    std::vector<fs::path> found;
    for (const std::string& folder : kOrder) {
        for (const auto& entry : fs::recursive_directory_iterator(root() / folder)) {
            const std::string extension = entry.path().extension().string();
            if (extension == ".h" || extension == ".cpp") found.push_back(entry.path());
        }
    }
    return found;
}

std::vector<Include> includes() {
    static const std::regex line_regex(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"])");
    std::vector<Include> found;
    for (const fs::path& path : sources()) {
        std::ifstream in(path);
        std::string line;
        const fs::path relative = fs::relative(path, root());
        while (std::getline(in, line)) {
            std::smatch match;
            if (std::regex_search(line, match, line_regex)) {
                found.push_back({relative.string(), relative.begin()->string(), match[1]});
            }
        }
    }
    return found;
}

/// Lowest first: `set(NAME ...)` in CMakeLists.txt.
std::vector<std::string> rooms_named(const std::string& name) {
    std::ifstream in(root() / "CMakeLists.txt");
    const std::string text(std::istreambuf_iterator<char>(in), {});
    const std::regex list_regex("set\\(" + name + R"( ([^)]*)\))");
    std::smatch match;
    if (!std::regex_search(text, match, list_regex)) return {};
    std::istringstream words(match[1]);
    return {std::istream_iterator<std::string>(words), {}};
}

int rank_of(const std::string& folder) {
    for (size_t i = 0; i < kOrder.size(); ++i) {
        if (kOrder[i] == folder) return static_cast<int>(i);
    }
    return -1;
}

/// The fields of sim::State, from the list that its hash and its copies go by.
std::set<std::string> fields_of_the_state() {
    std::ifstream in(root() / "sim/world/state.h");
    const std::string text(std::istreambuf_iterator<char>(in), {});
    static const std::regex list_regex(R"(auto& \[([^\]]*)\] = s;)"), name_regex(R"(\w+)");
    std::smatch match;
    if (!std::regex_search(text, match, list_regex)) return {};
    const std::string list = match[1];
    std::set<std::string> fields;
    for (std::sregex_iterator name(list.begin(), list.end(), name_regex), end; name != end; ++name)
        fields.insert(name->str());
    return fields;
}

/// `state.heat` in a room's files: the field, and where it is named first.
std::map<std::string, std::string> fields_touched_in(const std::string& room) {
    static const std::regex use_regex(R"(\bstate_?(?:\.|->)(\w+))");
    const std::set<std::string> fields = fields_of_the_state();
    std::map<std::string, std::string> touched;
    for (const auto& entry : fs::directory_iterator(root() / "sim" / room)) {
        std::ifstream in(entry.path());
        std::string line;
        for (int number = 1; std::getline(in, line); ++number)
            for (std::sregex_iterator use(line.begin(), line.end(), use_regex), end; use != end;
                 ++use)
                if (fields.contains((*use)[1]))
                    touched.try_emplace((*use)[1],
                                        entry.path().string() + ":" + std::to_string(number));
    }
    return touched;
}

TEST(Architecture, FilesIncludeOnlyFromTheirOwnFolderAndEarlierOnes) {
    int checked = 0;
    for (const Include& include : includes()) {
        const size_t slash = include.target.find('/');
        if (slash == std::string::npos) continue;
        const int target = rank_of(include.target.substr(0, slash));
        if (target < 0) continue;
        ++checked;
        EXPECT_LE(target, rank_of(include.folder))
            << include.file << " includes " << include.target;
    }
    EXPECT_GT(checked, 20) << "the scan found too few includes to prove anything";
}

TEST(Architecture, RoomsOfThePhysicsIncludeOnlyThemselvesAndEarlierOnes) {
    const std::vector<std::string> rooms = rooms_named("sim_rooms");
    ASSERT_GE(rooms.size(), 12U);
    const auto rank = [&](const std::string& path) {
        const size_t end = path.find('/', 4);
        const auto room = std::find(rooms.begin(), rooms.end(), path.substr(4, end - 4));
        EXPECT_NE(room, rooms.end()) << path << " lies in no room";
        return room - rooms.begin();
    };
    int checked = 0;
    for (const Include& include : includes()) {
        if (include.folder != "sim" || include.target.rfind("sim/", 0) != 0) continue;
        ++checked;
        EXPECT_LE(rank(include.target), rank(include.file))
            << include.file << " includes " << include.target;
    }
    EXPECT_GT(checked, 200);
}

// A device knows nothing of scripted operators; what opens either by its name stands above both.
TEST(Architecture, RoomsOfTheHandsIncludeOnlyThemselvesAndEarlierOnes) {
    const std::vector<std::string> rooms = rooms_named("haptics_rooms");
    ASSERT_GE(rooms.size(), 4U);
    const auto rank = [&](const std::string& path) {
        const auto room = std::find(rooms.begin(), rooms.end(), path.substr(0, path.rfind('/')));
        EXPECT_NE(room, rooms.end()) << path << " lies in no room";
        return room - rooms.begin();
    };
    int checked = 0;
    for (const Include& include : includes()) {
        if (include.folder != "haptics" || include.target.rfind("haptics/", 0) != 0) continue;
        ++checked;
        EXPECT_LE(rank(include.target), rank(include.file))
            << include.file << " includes " << include.target;
    }
    EXPECT_GT(checked, 80);
}

// A line in contact/ sees the whole State, as the step hands it on; what it may read or write
// stands here. By the words `state.x`: a reference that goes under another name is not seen.
TEST(Architecture, EachRoomTouchesItsPartOfTheState) {
    const std::map<std::string, std::string> may{
        {"contact",
         "frame substeps body sleep surface self_contact tools tool_side pieces held_by colour "
         "friction patch undermining flags workers scratch"},
        {"fluid", "frame time_s body surface tools irrigation scratch"},
        {"cutting",
         "frame time_s substeps body sleep surface self_contact sac heat tools grasps scissors "
         "suturing release resection pieces splits slides slides_refused held_by progress "
         "removed_m3 "
         "vapour_rate_m3_s separation flood ledger gone_by_heat stretch_count undermining flags "
         "scratch"},
        // How far blades are open, and what of a needle's hold is under way when an attempt ends.
        {"ledger",
         "frame time_s substeps phase body surface heat tools grasps scissors suturing release "
         "pieces progress ledger gone_by_heat events event_count flags scratch"},
        {"verify", "body surface tools flags scratch"},
        {"anatomy", ""},
        {"mesh_io", ""}};
    ASSERT_GT(fields_of_the_state().size(), 30U);
    for (const auto& [room, list] : may) {
        std::istringstream words(list);
        const std::set<std::string> fields{std::istream_iterator<std::string>(words), {}};
        const auto touched = fields_touched_in(room);
        for (const auto& [field, where] : touched)
            EXPECT_TRUE(fields.contains(field))
                << where << ": " << room << "/ touches state." << field
                << ", which is not its own; hand it over as an argument, or say here why";
        for (const std::string& field : fields)
            EXPECT_TRUE(touched.contains(field))
                << room << "/ does not touch state." << field << " any more: take it off the list";
    }
}

// A field that is added to a struct of state and not to its list, or not to the recorded hash, does
// not compile. One that is listed and then handed to nobody compiles: it is found here.
TEST(Architecture, EveryFieldThatAStateIsTakenApartIntoIsHandedOn) {
    static const std::regex list_regex(R"(\n( *)    (?:const )?auto& \[([^\]]*)\]\s*=[^;{]*;)"),
        name_regex(R"(\w+)");
    const std::set<std::string> hashes{"sim/world/state_hash.cpp",
                                       "sim/solver/soft_body_state.cpp"};
    int lists = 0;
    for (const fs::path& path : sources()) {
        const std::string file = fs::relative(path, root()).string();
        if (!file.starts_with("sim/") || (path.extension() != ".h" && !hashes.contains(file)))
            continue;
        std::ifstream in(path);
        const std::string text(std::istreambuf_iterator<char>(in), {});
        for (std::sregex_iterator list(text.begin(), text.end(), list_regex), end; list != end;
             ++list) {
            ++lists;
            const auto from = static_cast<size_t>(list->position() + list->length());
            const size_t to = text.find("\n" + (*list)[1].str() + "}\n", from);
            const std::string body = text.substr(from, to - from), names = (*list)[2];
            for (std::sregex_iterator name(names.begin(), names.end(), name_regex); name != end;
                 ++name)
                EXPECT_TRUE(std::regex_search(body, std::regex("\\b" + name->str() + "\\b")))
                    << file << ": " << name->str() << " is listed and handed to nobody";
        }
    }
    EXPECT_GT(lists, 60);
}

// What is verified is what is felt: whoever touches tissue goes through the one core of contact.
TEST(Architecture, OnlyTheCoreOfContactKnowsItsLaw) {
    std::set<std::string> core_users;
    for (const Include& include : includes()) {
        if (include.target == "sim/contact/contact_law.h") {
            EXPECT_EQ(include.file, "sim/contact/contact_core.h");
        }
        if (include.target == "sim/contact/contact_core.h") core_users.insert(include.file);
    }
    for (const char* user : {"sim/contact/contact.cpp", "sim/contact/contact_solve.cpp",
                             "sim/verify/pressed_vertices.cpp"})
        EXPECT_TRUE(core_users.contains(user)) << user;
}

TEST(Architecture, ThirdPartyHeadersStayInTheirFolder) {
    // header prefix -> folders (as path prefixes) that may include it
    const std::vector<std::pair<std::string, std::vector<std::string>>> owners{
        {"Eigen/", {"sim/", "ui/view/"}},
        {"hwy/", {"sim/"}},
        {"GLFW/", {"ui/view/"}},
        {"epoxy/", {"ui/view/"}},
        {"stb/", {"ui/view/"}},
        {"boost/", {"assessment/"}},
        {"nlohmann/", {"curriculum/", "batches/", "ui/", "interface/"}},
        {"pybind11/", {"python/"}},
        {"valijson/", {"curriculum/"}},
        {"sodium", {"db/"}},
        {"zstd", {"db/"}},
        {"sqlite3", {"db/"}},
        {"QSql", {"db/"}},
        {"QDBus", {"ui/shell/"}},
        {"qcustomplot", {"reports/"}},
        // What both command lines say about wrong usage, or refuse as one, stands between them.
        {"CLI/",
         {"ui/cli/", "ui/attempt/", "ui/web/main.cpp", "ui/usage_message.h", "ui/finite_range.h",
          "ui/seed_range.h"}},
        {"httplib", {"ui/web/web_server.cpp", "ui/lti/web_client.cpp"}},
        {"openssl/", {"ui/lti/web_token.cpp"}},
        {"AL/", {"ui/attempt/"}},
        {"readstat", {"reports/"}},
        {"hdf5", {"reports/hdf5_file.cpp"}},
    };
    for (const Include& include : includes()) {
        for (const auto& [prefix, folders] : owners) {
            if (include.target.rfind(prefix, 0) != 0) continue;
            bool allowed = false;
            for (const std::string& folder : folders)
                allowed = allowed || include.file.rfind(folder, 0) == 0;
            EXPECT_TRUE(allowed) << include.file << " includes " << include.target;
        }
    }
}

TEST(Architecture, WhatThePartsOfTheStoreShareIsSeenByTheirSourcesOnly) {
    int sources = 0;
    for (const Include& include : includes()) {
        if (include.target != "db/store_context.h" && include.target != "db/attempt_rows.h")
            continue;
        ++sources;
        EXPECT_TRUE(include.file.rfind("db/", 0) == 0 && include.file.ends_with(".cpp"))
            << include.file << " includes " << include.target;
    }
    EXPECT_GT(sources, 20);
    const std::set<std::string> parts{"accounts",    "attempts",     "norms",         "groups",
                                      "courses",     "reviews",      "definitions",   "studies",
                                      "audit",       "records",      "study_records", "store",
                                      "store_error", "store_options"};
    for (const Include& include : includes()) {
        const fs::path file = include.file;
        if (include.folder != "db" || file.extension() != ".h" || !parts.contains(file.stem()))
            continue;
        EXPECT_TRUE(include.target != "db/sql_connection.h" && include.target[0] != 'Q')
            << include.file << " includes " << include.target;
    }
}

TEST(Architecture, PythonKnowsNothingButTheInterface) {
    int checked = 0;
    for (const Include& include : includes()) {
        const std::string folder = include.target.substr(0, include.target.find('/'));
        if (include.folder != "python" || folder == "python" || rank_of(folder) < 0) continue;
        ++checked;
        EXPECT_EQ(include.target, "interface/placode.h") << include.file;
    }
    EXPECT_GT(checked, 0);
}

TEST(Architecture, QtEntersOnlyFromDbOn) {
    for (const Include& include : includes()) {
        const bool qt = include.target.size() > 1 && include.target[0] == 'Q' &&
                        std::isupper(include.target[1]) &&
                        include.target.find('/') == std::string::npos;
        if (!qt) continue;
        EXPECT_GE(rank_of(include.folder), rank_of("db"))
            << include.file << " includes " << include.target;
    }
}

// One file of Polish, ui/shell/translations/placode_pl.ts: no table beside it, not in escapes
// either. (Texts of definitions are data.)
TEST(Architecture, NoSourceHoldsPolish) {
    const char* const letters[]{
        "ą", "ć", "ę", "ł", "ń", "ó", "ś", "ź",         "ż",         "Ą",         "Ć",        "Ę",
        "Ł", "Ń", "Ó", "Ś", "Ź", "Ż", "„", R"(\xC4\x)", R"(\xC5\x)", R"(\xc4\x)", R"(\xc5\x)"};
    for (const fs::path& path : sources()) {
        std::ifstream in(path);
        const std::string text(std::istreambuf_iterator<char>(in), {});
        for (const char* letter : letters) {
            const size_t at = text.find(letter);
            EXPECT_EQ(at, std::string::npos)
                << path.string() << ": " << letter
                << " in: " << text.substr(at == std::string::npos ? 0 : at, 60);
        }
    }
}

/// What the C library works out with another last bit in another version and on another processor
/// (square roots, remainders and fma are exact to the last bit everywhere), and what of Eigen asks
/// it.
const std::regex& inexact_function() {
    static const std::regex found(
        R"((^|[^\w])((std::)?(a?sinh?|a?cosh?|a?tanh?|atan2|sincos|exp|exp2|expm1|log|log2|log10)"
        R"(|log1p|pow|cbrt|hypot|erfc?|[tl]gamma)f?l?\s*\(|std::(a?sin|a?cos|a?tan|exp|log|pow)\b)"
        R"(|AngleAxis|Rotation2D|computeDirect|eulerAngles|slerp\s*\())");
    return found;
}

// A recording replays with the same bits on a computer with a newer C library or another processor,
// where its scene is built anew. Outside: what reads meshes, and what verifies.
TEST(Architecture, AFrameAsksTheLibraryForNothingThatItRoundsItsOwnWay) {
    // Files that may ask it all the same. Name one here only if what it makes lies in the recording
    // too.
    const std::set<std::string> exempt{};
    const std::set<std::string> outside{"verify", "mesh_io"};
    int scanned = 0;
    for (const fs::path& path : sources()) {
        const fs::path relative = fs::relative(path, root());
        if (*relative.begin() != "sim" || outside.contains(std::next(relative.begin())->string()))
            continue;
        std::ifstream in(path);
        std::string line;
        bool asks = false;
        for (int number = 1; std::getline(in, line); ++number) {
            if (!std::regex_search(line.substr(0, line.find("//")), inexact_function())) continue;
            asks = true;
            EXPECT_TRUE(exempt.contains(relative.string()))
                << relative.string() << ":" << number
                << ": use sim/core/portable_math.h instead: " << line;
        }
        EXPECT_EQ(asks, exempt.contains(relative.string())) << relative.string();
        ++scanned;
    }
    EXPECT_GT(scanned, 200);
}

TEST(Architecture, TheScanForInexactFunctionsKnowsThemFromOthers) {
    for (const char* line :
         {"x = std::sin(a);", "return atan2(y, x);", "std::pow (a, 2)", "f(std::exp2(-x))",
          "a.array().log()", "transform(b, std::cos);", "const Eigen::AngleAxisd yaw(a, z);",
          "expf(x)", "std::hypot(a, b)", "q.slerp(0.5, p)", "eigen.computeDirect(m);"})
        EXPECT_TRUE(std::regex_search(line, inexact_function())) << line;
    for (const char* line :
         {"exp_portable(x)", "std::sqrt(x)", "arc_tangent(w)", "std::fmod(a, b)", "open_log(x)",
          "half_tangent(a)", "std::max(a, b)", "reading.dose_log += w", "expect(x)", "cosine(1)",
          "sector(a)", "std::exponential(x)"})
        EXPECT_FALSE(std::regex_search(line, inexact_function())) << line;
}

TEST(Architecture, EveryFileCarriesTheLicence) {
    for (const fs::path& path : sources()) {
        std::ifstream in(path);
        std::string first, second;
        std::getline(in, first);
        std::getline(in, second);
        EXPECT_NE(first.find("SPDX-FileCopyrightText"), std::string::npos) << path;
        EXPECT_NE(second.find("SPDX-License-Identifier: GPL-3.0-or-later"), std::string::npos)
            << path;
    }
}

TEST(Architecture, ThePageOfDependenciesNamesEveryPackage) {
    std::ifstream in(root() / "docs/dependencies.md");
    const std::string page{std::istreambuf_iterator<char>(in), {}};
    std::ifstream packages(root() / "packages.txt");
    std::string line;
    while (std::getline(packages, line)) {
        if (line.empty() || line[0] == '#') continue;
        const std::string name = line.substr(0, line.find("-dev")), row = "\n| " + name;
        EXPECT_NE(page.find(row), std::string::npos)
            << line << ": run scripts/dependencies.py after a build";
    }
}

TEST(Architecture, NoPageSaysToTypeWhatTakesOtherThingsAway) {
    // `crontab -` replaces all jobs, and `>` empties a file before the program reads it.
    const std::regex jobs(R"(\| *crontab -( |$))"),
        settings(R"(--station-file *> *\S*station\.conf)");
    size_t pages = 0;
    for (const auto& entry : fs::recursive_directory_iterator(root() / "docs")) {
        if (entry.path().extension() != ".md") continue;
        ++pages;
        std::ifstream in(entry.path());
        for (std::string line; std::getline(in, line);) {
            const bool keeps_jobs = line.find("crontab -l") != std::string::npos;
            EXPECT_TRUE(keeps_jobs || !std::regex_search(line, jobs))
                << entry.path() << ": " << line;
            EXPECT_FALSE(std::regex_search(line, settings)) << entry.path() << ": " << line;
        }
    }
    EXPECT_GT(pages, 100U);
}

TEST(Architecture, NoCatchAllFolders) {
    for (const auto& entry : fs::recursive_directory_iterator(root())) {
        const std::string name = entry.path().filename().string();
        if (!entry.is_directory() || entry.path().string().find("/build") != std::string::npos)
            continue;
        EXPECT_NE(name, "common") << entry.path();
        EXPECT_NE(name, "util") << entry.path();
        EXPECT_NE(name, "utils") << entry.path();
    }
}

}  // namespace THIS_TEST
