// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// `placodectl store move` as administrators meet it: who may, what it says, and that no password
// shows.

#include <gmock/gmock.h>

#include "tests/programs_fixture.h"

using namespace placode;
using namespace placode::test;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

namespace THIS_TEST {

World* const world = World::install();

class StoreMovePrograms : public Programs {
 protected:
    void SetUp() override {
        Programs::SetUp();
        if (world->server().missing()) GTEST_SKIP() << world->server().problem();
        add_user("ada", "administrator");
        add_user("tom", "trainee");
        const std::string full = world->server().url(world->server().new_database());
        const std::string& password = world->server().password();
        server = full;
        server.erase(server.find(":" + password), password.size() + 1);
        with_password = full;
        environment = "PGPASSWORD=" + password + " " + kRight;
    }
    /// As ctl(), on the server.
    [[nodiscard]] Outcome on_server(const std::string& arguments) const {
        return run("placodectl", "--store " + server + " " + arguments, environment);
    }

    std::string server, with_password, environment;
};

TEST_F(StoreMovePrograms, AnAdministratorMovesItThereAndBack) {
    const Outcome look = ctl("store move --to " + server + " --dry-run", environment);
    ASSERT_EQ(look.status, 0) << look.err;
    EXPECT_THAT(look.out, AllOf(HasSubstr("accounts"), HasSubstr("would go from sqlite:"),
                                HasSubstr("which is free")));
    const Outcome there = ctl("store move --json --to " + server, environment);
    ASSERT_EQ(there.status, 0) << there.err;
    EXPECT_THAT(there.out, AllOf(HasSubstr("\"moved\": true"), HasSubstr("\"went_on\": false"),
                                 HasSubstr("{\n      \"table\": \"accounts\"")));
    const Outcome again = ctl("store move --to " + server, environment);
    EXPECT_EQ(again.status, 0) << "done already: " << again.err;
    const Outcome old = ctl("user list");
    EXPECT_EQ(old.status, 1);
    EXPECT_THAT(old.err, HasSubstr("the store was moved to " + server));
    EXPECT_EQ(on_server("--as ada check").status, 0);
    const Outcome trail = on_server("--as ada audit");
    EXPECT_THAT(trail.out,
                AllOf(HasSubstr("store.move"), HasSubstr("from sqlite:"), HasSubstr(server)));
    const Outcome back = on_server("--as ada store move --to sqlite:" + store);
    ASSERT_EQ(back.status, 0) << back.err;
    EXPECT_THAT(back.out, HasSubstr("the file that was there is kept as"));
    EXPECT_EQ(ctl("check").status, 0);
    for (const Outcome* each : {&look, &there, &again, &old, &trail, &back})
        EXPECT_THAT(each->out + each->err, Not(HasSubstr(world->server().password())));
}

TEST_F(StoreMovePrograms, NobodyElseMayAndNothingIsBegun) {
    const Outcome trainee = ctl("--as tom store move --to " + server, environment);
    EXPECT_EQ(trainee.status, 1);
    EXPECT_THAT(trainee.err, HasSubstr("an administrator can"));
    const Outcome open = ctl("store move --to " + with_password);
    EXPECT_EQ(open.status, 2);
    EXPECT_THAT(open.err, AllOf(HasSubstr("--to: the address holds a password"),
                                Not(HasSubstr(world->server().password()))));
    EXPECT_EQ(ctl("store move").status, 2);
    EXPECT_EQ(ctl("store move --to somewhere").status, 2);
    // A server does not move by whoever happens to be at it.
    EXPECT_EQ(ctl("store move --to " + server, environment).status, 0);
    const Outcome nobody = on_server("store move --to sqlite:" + file("back.db"));
    EXPECT_EQ(nobody.status, 1);
    EXPECT_THAT(nobody.err, HasSubstr("give --as USER"));
    EXPECT_FALSE(fs::exists(file("back.db.moving")));
}

}  // namespace THIS_TEST
