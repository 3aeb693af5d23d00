// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Files that come into a folder together, or not at all.
#include "reports/staged_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <system_error>

#include "reports/report.h"

namespace placode::reports {
namespace THIS_TEST {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

class StagedFolder : public testing::Test {
 protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "placode-staged-XXXXXX").string();
        ASSERT_NE(::mkdtemp(name.data()), nullptr);
        root = name;
    }
    void TearDown() override { fs::remove_all(root); }
    static void put(const fs::path& file, const std::string& text) { std::ofstream(file) << text; }
    static std::string text_of(const fs::path& file) {
        std::ifstream in(file);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    fs::path root;
};

TEST_F(StagedFolder, HandsOutEverythingAtOnceForItsOwnerAlone) {
    const fs::path place = root / "out";
    fs::create_directories(place);
    put(place / "a.csv", "old");
    put(place / "else.csv", "of somebody else");
    write_staged(place.string(), [&](const std::string& staged) {
        put(staged + "/a.csv", "new");
        fs::create_directories(staged + "/deep");
        put(staged + "/deep/b.csv", "new");
        EXPECT_EQ(text_of(place / "a.csv"), "old") << "not before all of it is there";
    });
    EXPECT_EQ(text_of(place / "a.csv"), "new");
    EXPECT_EQ(text_of(place / "deep" / "b.csv"), "new");
    EXPECT_EQ(text_of(place / "else.csv"), "of somebody else");
    EXPECT_EQ(fs::status(place / "a.csv").permissions(), fs::perms(0600));
    EXPECT_EQ(fs::status(place / "deep").permissions(), fs::perms(0700));
    EXPECT_EQ(std::distance(fs::directory_iterator(place), {}), 3) << "nothing hidden is left";
}

TEST_F(StagedFolder, WhatIsThrownLeavesTheFolderAsItWas) {
    const fs::path place = root / "out", fresh = root / "made" / "for" / "it";
    fs::create_directories(place);
    put(place / "a.csv", "old");
    for (const fs::path& folder : {place, fresh}) {
        const auto stopped = [](const std::string& staged) {
            put(staged + "/a.csv", "new");
            throw 7;  // whatever it is
        };
        EXPECT_THROW(write_staged(folder.string(), stopped), int);
    }
    EXPECT_EQ(text_of(place / "a.csv"), "old");
    EXPECT_EQ(std::distance(fs::directory_iterator(place), {}), 1);
    EXPECT_FALSE(fs::exists(root / "made"));
}

TEST_F(StagedFolder, AnErrorNamesTheFileWhereItWasToBe) {
    const std::string place = (root / "out").string();
    const auto said = [&](const std::function<void(const std::string&)>& write) {
        try {
            write_staged(place, write);
        } catch (const ReportError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(said([](const std::string& staged) {
                  throw ReportError("write " + staged + "/a.csv: no room; free space");
              }),
              "write " + place + "/a.csv: no room; free space");
    const std::string system =
        said([](const std::string& staged) { fs::create_directory(staged + "/not/there"); });
    EXPECT_THAT(system, HasSubstr(place + "/not/there: "));
    EXPECT_THAT(system, HasSubstr("choose another folder"));
    EXPECT_THAT(system, Not(HasSubstr(".placode-export")));
}

}  // namespace THIS_TEST
}  // namespace placode::reports
