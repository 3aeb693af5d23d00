// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/csv_reader.h"

#include <gmock/gmock.h>

namespace placode::assessment {
namespace THIS_TEST {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::vector<std::string>> cells(std::string_view text, char separator = ',') {
    std::vector<std::vector<std::string>> all;
    for (const CsvRow& row : read_csv(text, separator)) all.push_back(row.cells);
    return all;
}

std::string problem(std::string_view text) {
    try {
        (void)read_csv(text);
        return "no error";
    } catch (const CsvError& error) {
        return error.what();
    }
}

TEST(CsvReader, ReadsWhatTheStandardAllows) {
    EXPECT_THAT(cells(""), IsEmpty());
    EXPECT_THAT(cells("a,b\n1,2"), ElementsAre(ElementsAre("a", "b"), ElementsAre("1", "2")));
    EXPECT_THAT(cells("\"a, b\",\"say \"\"so\"\"\",\"two\nlines\"\n"),
                ElementsAre(ElementsAre("a, b", "say \"so\"", "two\nlines")));
    EXPECT_THAT(cells("a,,\n\"\",\n"), ElementsAre(ElementsAre("a", "", ""), ElementsAre("", "")));
    EXPECT_THAT(cells("5\" wide,x\n"), ElementsAre(ElementsAre("5\" wide", "x")));
}

TEST(CsvReader, TakesAnySeparatorLineEndAndAByteOrderMark) {
    EXPECT_THAT(cells("\xef\xbb\xbf"
                      "a;b\r\n1,5;2\r\n",
                      ';'),
                ElementsAre(ElementsAre("a", "b"), ElementsAre("1,5", "2")));
    EXPECT_THAT(cells("a\tb\r1\t2\r", '\t'),
                ElementsAre(ElementsAre("a", "b"), ElementsAre("1", "2")));
    EXPECT_THAT(cells("\xef\xbb\xbf\"a\",b\n"), ElementsAre(ElementsAre("a", "b")));
}

TEST(CsvReader, KnowsInWhichLineARowBegins) {
    const auto rows = read_csv("a,b\n\n\"two\nlines\",1\nc,d\n");
    ASSERT_EQ(rows.size(), 4u);
    EXPECT_EQ(rows[1].line, 2);
    EXPECT_EQ(rows[2].line, 3);
    EXPECT_EQ(rows[3].line, 5);
}

TEST(CsvReader, NamesLineAndColumnOfWhatIsWrong) {
    EXPECT_THAT(problem("a,b\n1,\"2\n3\n"),
                HasSubstr("line 2, column 2: a quoted cell is not closed"));
    EXPECT_THAT(problem("\"a\nb\"x,c\n"),
                HasSubstr("line 2, column 1: found \"x\" after a closing quote; expected \",\""));
}

TEST(CsvReader, EmptyLinesAreLeftOutUnlessTheyAreCells) {
    auto two = read_csv("\n\na,b\n\n1,2\n\n");
    leave_out_empty_lines(two);
    ASSERT_EQ(two.size(), 2u);
    EXPECT_EQ(two[1].line, 5);
    auto one = read_csv("a\n1\n\n2\n\n\n");
    leave_out_empty_lines(one);
    ASSERT_EQ(one.size(), 4u);
    EXPECT_EQ(one[2].cells[0], "");
}

}  // namespace THIS_TEST
}  // namespace placode::assessment
