// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/screen_awake.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace placode::ui {
namespace THIS_TEST {

/// A desktop that answers when the test says so.
struct Desktop {
    ScreenAwake::Call call() {
        return [this](const QString& method, const QVariantList& arguments,
                      const ScreenAwake::Answered& answered) {
            asked.push_back(method.toStdString() + " " + arguments.last().toString().toStdString());
            if (answered) waiting.push_back(answered);
        };
    }
    void answer(uint cookie) {
        for (const auto& answered : std::exchange(waiting, {})) answered(cookie);
    }
    std::vector<std::string> asked;
    std::vector<ScreenAwake::Answered> waiting;
};

using Asked = std::vector<std::string>;

TEST(ScreenAwake, KeepsTheScreenFromStartToEndOnce) {
    Desktop desktop;
    ScreenAwake awake(desktop.call());
    awake.release();
    EXPECT_EQ(desktop.asked, Asked{}) << "nothing to take back";
    awake.keep("a");
    desktop.answer(17);
    awake.keep("a");
    EXPECT_EQ(desktop.asked, (Asked{"Inhibit a"})) << "it is kept already";
    awake.release();
    awake.release();
    EXPECT_EQ(desktop.asked, (Asked{"Inhibit a", "UnInhibit 17"}));
    awake.keep("b");
    desktop.answer(18);
    awake.release();
    EXPECT_EQ(desktop.asked, (Asked{"Inhibit a", "UnInhibit 17", "Inhibit b", "UnInhibit 18"}));
}

TEST(ScreenAwake, TakesBackWhatIsAnsweredTooLate) {
    Desktop desktop;
    ScreenAwake awake(desktop.call());
    awake.keep("a");
    awake.release();
    EXPECT_EQ(desktop.asked, (Asked{"Inhibit a"})) << "without a cookie nothing can be taken back";
    desktop.answer(5);
    EXPECT_EQ(desktop.asked, (Asked{"Inhibit a", "UnInhibit 5"}));
}

TEST(ScreenAwake, LetsGoWhenItEndsAndStandsADesktopThatIsSilent) {
    Desktop desktop;
    {
        ScreenAwake awake(desktop.call());
        awake.keep("a");
        desktop.answer(3);
    }
    EXPECT_EQ(desktop.asked, (Asked{"Inhibit a", "UnInhibit 3"}));
    { ScreenAwake(desktop.call()).keep("b"); }
    EXPECT_EQ(desktop.asked.size(), 3U);
}

}  // namespace THIS_TEST
}  // namespace placode::ui
