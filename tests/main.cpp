// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The main program of several test files that are one executable (CMakeLists.txt says why). It is
// called by the name of a file, `contact_test`, and then runs the tests of contact_test.cpp only.

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace {

/// A test in a header would belong to no file, and nobody would run it.
void need_a_file(const testing::TestInfo& test, const std::string& stem) {
    if (stem.ends_with("_test")) return;
    std::fprintf(stderr, "%s: the test %s belongs into a file NAME_test.cpp\n", test.file(),
                 test.name());
    std::exit(2);
}

/// Patterns of all tests that do not stand in `file`.cpp, joined by colons, whole suites as one;
/// `found` counts the others.
std::string elsewhere(const std::string& file, int& found) {
    const testing::UnitTest& all = *testing::UnitTest::GetInstance();
    std::string out;
    for (int s = 0; s < all.total_test_suite_count(); ++s) {
        const testing::TestSuite& suite = *all.GetTestSuite(s);
        std::string others;
        int here = 0;
        for (int t = 0; t < suite.total_test_count(); ++t) {
            const testing::TestInfo& test = *suite.GetTestInfo(t);
            const std::string stem = std::filesystem::path(test.file()).stem();
            need_a_file(test, stem);
            if (stem == file)
                ++here;
            else
                others += std::string(":") + suite.name() + "." + test.name();
        }
        found += here;
        out += here > 0 ? others : std::string(":") + suite.name() + ".*";
    }
    return out.empty() ? out : out.substr(1);
}

}  // namespace

int main(int argc, char** argv) {
    const std::string file = std::filesystem::path(argv[0]).filename();
    testing::InitGoogleTest(&argc, argv);
    int found = 0;
    const std::string others = elsewhere(file, found);
    if (found == 0) {
        std::fprintf(stderr,
                     "%s: no test of %s.cpp is in this program; call it by the name of a test\n",
                     argv[0], file.c_str());
        return 2;
    }
    std::string& filter = testing::GTEST_FLAG(filter);
    if (!others.empty()) {
        filter += (filter.find('-') == std::string::npos ? "-" : ":") + others;
    }
    return RUN_ALL_TESTS();
}
