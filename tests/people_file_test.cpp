// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/people_file.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "store_fixture.h"

namespace placode::reports {
namespace THIS_TEST {

using testing::HasSubstr;

class PeopleFile : public testing::Test {
 protected:
    PeopleFile() {
        db::StoreOptions options;
        options.cheap_passwords = true;
        store_ = db::open_store("sqlite:" + folder_.file("a.db"), options);
    }
    [[nodiscard]] std::string problem(const std::string& csv) {
        try {
            (void)read_people(*store_, csv, "list.csv");
            return {};
        } catch (const PeopleFileError& error) {
            return error.what();
        }
    }
    test::TemporaryFolder folder_;
    std::unique_ptr<db::Store> store_;
};

TEST_F(PeopleFile, NamesTheLineAndWhatIsExpected) {
    EXPECT_THAT(problem(""), HasSubstr("list.csv:1: expected the columns login,name"));
    EXPECT_THAT(problem("login,nom\n"), HasSubstr("expected the columns"));
    EXPECT_THAT(problem("login,name,role\n"), HasSubstr("found the column \"role\""));
    EXPECT_THAT(problem("login,name\na\n"), HasSubstr("list.csv:2: found 1 columns; expected 2"));
    EXPECT_THAT(problem("login,name\na,A\n,B\n"), HasSubstr("list.csv:3: login and name"));
    EXPECT_THAT(problem("login,name,roles\na,A,boss\n"), HasSubstr("found the role \"boss\""));
    EXPECT_THAT(problem("login,name,group\na,A,none\n"), HasSubstr("there is no group \"none\""));
    EXPECT_THAT(problem("login,name\na,A\na,B\n"),
                HasSubstr("list.csv:3: the login \"a\" is taken"));
}

TEST_F(PeopleFile, FindsWhatTheStoreWouldRefuseBeforeAnybodyIsAdded) {
    EXPECT_THAT(problem("login,name\nOtto,A\nbert,B\notto,C\n"),
                HasSubstr("list.csv:4: the login \"otto\" is taken"));
    EXPECT_THAT(problem("login,name\na,A\n12,B\n"),
                HasSubstr("list.csv:3: the login reads as the number"));
    EXPECT_THAT(problem("login,name\na,\"A\nB\"\n"),
                HasSubstr("list.csv:2: the name holds letters that are not seen"));
    EXPECT_THAT(problem("login,name,password\na,A,short\n"),
                HasSubstr("list.csv:2: the length of the password is 5"));
    EXPECT_THAT(problem("login,name\n" + std::string(201, 'a') + ",A\n"),
                HasSubstr("list.csv:2: the login is longer than 200"));
}

TEST_F(PeopleFile, AddsAllOrNobody) {
    auto people = read_people(*store_, "login,name\nanna,A\nbert,B\ncarl,C\n", "list.csv");
    (void)make_passwords(people);
    // Somebody else is quicker.
    store_->accounts().create({"bert", "Other", "quiet river 7", 1, false});
    const size_t entries = store_->audit().trail(100).size();
    try {
        make_accounts(*store_, people, "list.csv");
        ADD_FAILURE() << "was accepted";
    } catch (const PeopleFileError& error) {
        EXPECT_THAT(error.what(), HasSubstr("list.csv:3: "));
        EXPECT_THAT(error.what(), HasSubstr("is taken"));
        EXPECT_THAT(error.what(), HasSubstr("nobody was added"));
    }
    EXPECT_EQ(store_->accounts().list().size(), 1u);
    EXPECT_EQ(store_->audit().trail(100).size(), entries);
}

TEST_F(PeopleFile, PasswordsGoIntoANewFileForItsOwnerAlone) {
    const std::string path = folder_.file("passwords.csv");
    const mode_t before = ::umask(0);
    save_passwords(path, "login,password\nanna,x\n");
    ::umask(before);
    struct stat status {};
    ASSERT_EQ(::stat(path.c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 07777, 0600u);
    std::filesystem::create_symlink(folder_.file("elsewhere.csv"), folder_.file("link.csv"));
    for (const std::string& there : {path, folder_.file("link.csv")}) {
        const auto error = test::failure_of([&] { save_passwords(there, "login,password\n"); });
        EXPECT_EQ(error.kind(), db::StoreError::Kind::kRefused);
        EXPECT_THAT(error.what(),
                    HasSubstr(there + " exists and is not overwritten; give another"));
    }
    EXPECT_FALSE(std::filesystem::exists(folder_.file("elsewhere.csv")));
    std::ifstream in(path);
    EXPECT_THAT(std::string(std::istreambuf_iterator<char>(in), {}), HasSubstr("anna,x"));
    EXPECT_EQ(test::failure_of([&] { save_passwords(folder_.file("none/p.csv"), "x"); }).kind(),
              db::StoreError::Kind::kOther);
}

TEST_F(PeopleFile, TakesWhatSpreadsheetsSave) {
    // A byte order mark, quoted line ends and empty lines; the line is that of the file.
    const auto people = read_people(*store_,
                                    "\xef\xbb\xbflogin,name,password\r\nanna,Anna A,\"quiet\nriver "
                                    "7\"\r\n\r\nbert,B,\r\n\r\n",
                                    "list.csv");
    ASSERT_EQ(people.size(), 2u);
    EXPECT_EQ(people[1].line, 5);
    EXPECT_THAT(problem("login,name\na,\"A\nb,B\n"),
                HasSubstr("list.csv: line 2, column 2: a quoted cell is not closed"));
}

TEST_F(PeopleFile, MakesAccountsWithRolesGroupsAndPasswords) {
    const int64_t group = store_->groups().create("Autumn");
    auto people = read_people(*store_,
                              "login,name,roles,group,password\n"
                              "anna,Anna A,trainee;educator,Autumn,\n"
                              "bert,Bert B,,,quiet river 7\n",
                              "list.csv");
    const std::string passwords = make_passwords(people);
    EXPECT_THAT(passwords, HasSubstr("login,password"));
    EXPECT_THAT(passwords, HasSubstr("anna,"));
    EXPECT_THAT(passwords, testing::Not(HasSubstr("bert")));
    EXPECT_EQ(make_accounts(*store_, people, "list.csv"), 2u);
    const auto anna = store_->accounts().find_login("anna");
    ASSERT_TRUE(anna.has_value());
    EXPECT_TRUE(anna->password_given) << "whoever made the list knows it";
    EXPECT_TRUE(store_->accounts().find_login("bert")->password_given);
    EXPECT_TRUE(db::has_role(anna->roles, db::Role::kEducator));
    EXPECT_EQ(store_->groups().list()[0].id, group);
    EXPECT_THAT(store_->groups().list()[0].members, testing::ElementsAre(anna->id));
    EXPECT_EQ(store_->accounts().sign_in("anna", people[0].user.password).outcome,
              db::SignInOutcome::kOk);
    EXPECT_EQ(store_->accounts().sign_in("bert", "quiet river 7").outcome, db::SignInOutcome::kOk);
}

TEST_F(PeopleFile, WritesWhatIsKeptAboutOnePersonOnly) {
    std::vector<PersonLine> people = read_people(
        *store_, "login,name,password\nanna,Anna A,quiet river 7\nbert,Bert B,quiet river 8\n",
        "list.csv");
    make_accounts(*store_, people, "list.csv");
    const int64_t anna = store_->accounts().find_login("anna")->id;
    db::AttemptResult result;
    result.header.task_id = "ring";
    result.end.reason = sim::EndReason::kFinished;
    result.score.points = 81;
    result.score.reasons = {{"burn", "The needle rested.", 4, 2, false}};
    store_->attempts().save(anna, result);
    const OwnData written = write_own_data(*store_, anna, folder_.file("mine"), true);
    EXPECT_EQ(written.attempts, 1);
    EXPECT_EQ(written.recordings, 0);
    for (const auto& [made, mode] : {std::pair{"mine", 0700u}, {"mine/my_data.json", 0600u}}) {
        struct stat status {};
        ASSERT_EQ(::stat(folder_.file(made).c_str(), &status), 0) << made;
        EXPECT_EQ(status.st_mode & 07777, mode) << made;
    }
    std::ifstream in(folder_.file("mine/my_data.json"));
    std::ostringstream text;
    text << in.rdbuf();
    EXPECT_THAT(text.str(), HasSubstr("Anna A"));
    EXPECT_THAT(text.str(), HasSubstr("The needle rested."));
    EXPECT_THAT(text.str(), testing::Not(HasSubstr("Bert")));
    EXPECT_EQ(store_->audit().trail(1)[0].action, "user.data");
}

}  // namespace THIS_TEST
}  // namespace placode::reports
