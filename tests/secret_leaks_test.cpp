// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Passwords, passphrases and the centre's key stay where they belong: in no message, log, settings,
// store, backup or export, and on no command line, where no name of a person stands either. What is
// found when one gets out is tested as well, or this would pass for want of looking.

#include <gmock/gmock.h>

#include "db/signature.h"
#include "db/store_context.h"
#include "tests/store_fixture.h"
#include "tests/watched_program.h"
#include "ui/shell/attempt_launcher.h"

using namespace placode;
using namespace placode::test;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

namespace THIS_TEST {

World* const world = World::install();
// Words that nothing else in a store is called.
constexpr const char* kPassword = "heron-Cobalt-9157";
constexpr const char* kWrong = "magpie-Ochre-2204";
constexpr const char* kPhrase = "lantern Thimble quartz 44";
constexpr const char* kNextPhrase = "walnut Ferry beacon 81";
constexpr const char* kName = "Wilhelmina Quillfeather";  // Of ada.

class SecretLeaks : public EngineTest {
 protected:
    /// Below `home` lies all that the programs write; what they are given lies in `given`.
    void ready() override {
        for (const char* name : {"home", "given"}) fs::create_directory(folder.file(name));
        put("given/phrase", std::string(kPhrase) + "\n");
        put("given/next", std::string(kNextPhrase) + "\n");
        ::setenv("PLACODE_STATION_KEY", folder.file("given/station.key").c_str(), 1);
        become_owner();
        if (is_sqlite()) {
            store_ = "sqlite:" + folder.file("home/placode.db");
        } else {
            const PostgresqlServer& server = World::get().server();
            store_ = server.url(database);
            password_ = server.password();
        }
        const auto store = db::open_store(store_, options);
        const db::NewUser ada{"ada", kName, kPassword,
                              static_cast<db::Roles>(db::Role::kAdministrator), false};
        (void)store->accounts().create(ada);
    }
    void TearDown() override {}  // The store is not where EngineTest looks for it.

    void put(const std::string& name, const std::string& text) const {
        std::ofstream(folder.file(name), std::ios::binary) << text;
        fs::permissions(folder.file(name), fs::perms::owner_read | fs::perms::owner_write);
    }
    /// As an earlier version kept it.
    void keep_key_in_clear() {
        const db::KeyPair pair = db::new_key_pair();
        key_ = pair.secret_key.substr(0, 64);  // The other half is the public key.
        db::StoreContext context(db::parse_store_url(store_), options);
        db::UnitOfWork work(context.connection);
        db::Statement(context.connection,
                      "INSERT INTO centre_key (id, centre, public_key, secret_key, made_utc) "
                      "VALUES (1, 'A', ?, ?, '')")
            .run(pair.public_key, pair.secret_key);
        context.made("centre key", 1);
        work.commit();
    }
    /// The address as people give it.
    [[nodiscard]] std::string shown_store() const {
        std::string text = store_;
        if (!is_sqlite()) text.erase(text.find(":" + password_), password_.size() + 1);
        return text;
    }
    /// A program with its home in the test's folder; everything that it said is kept.
    WatchedRun watch(std::vector<std::string> command, std::vector<std::string> environment = {},
                     const std::string& input = {}) {
        WatchedProgram program;
        program.command = std::move(command);
        program.environment = std::move(environment);
        for (const char* name : {"HOME", "XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME"})
            program.environment.push_back(std::string(name) + "=" + folder.file("home"));
        program.environment.push_back("PLACODE_LOG=" + folder.file("home/log"));
        if (!is_sqlite() && server_password_.empty()) server_password_ = "PGPASSWORD=" + password_;
        if (!is_sqlite()) program.environment.push_back(server_password_);
        program.input = input;
        WatchedRun run = program.run(folder.file("given"));
        said_ += run.said;
        lines_.insert(lines_.end(), run.command_lines.begin(), run.command_lines.end());
        return run;
    }
    WatchedRun ctl(const std::vector<std::string>& arguments,
                   std::vector<std::string> environment = {}, const std::string& input = {}) {
        std::vector<std::string> command{PLACODE_BIN_DIR "/placodectl", "--store", shown_store()};
        command.insert(command.end(), arguments.begin(), arguments.end());
        return watch(std::move(command), std::move(environment), input);
    }
    [[nodiscard]] std::vector<std::string> secrets() const {
        std::vector<std::string> all{kPassword, kWrong, kPhrase, kNextPhrase, key_};
        if (!password_.empty()) all.push_back(password_);
        return all;
    }
    /// Every place where a secret came out, of all runs so far.
    [[nodiscard]] std::vector<std::string> leaks() const {
        std::vector<std::string> found;
        for (const std::string& line : lines_)
            if (holds(line, kName)) found.push_back("command line: " + std::string(kName));
        for (const std::string& secret : secrets()) {
            for (const std::string& line : lines_)
                if (holds(line, secret)) found.push_back("command line: " + secret);
            if (holds(said_, secret)) found.push_back("message: " + secret);
            for (const std::string& file : files_with(folder.file("home"), secret))
                found.push_back(file + ": " + secret);
        }
        return found;
    }
    [[nodiscard]] std::string in_table() const {
        return is_sqlite() ? RawConnection("QSQLITE", folder.file("home/placode.db"))
                                 .value("SELECT secret_key FROM centre_key")
                           : World::get().server().connect(database).value(
                                 "SELECT secret_key FROM centre_key");
    }

    std::string store_, password_, key_, said_, server_password_;
    std::vector<std::string> lines_;
};

INSTANTIATE_TEST_SUITE_P(Engines, SecretLeaks, testing::Values("Sqlite", "Postgresql"),
                         engine_name);

TEST_P(SecretLeaks, NothingThatWasTypedOrSealedComesOut) {
    keep_key_in_clear();
    const std::string signs_in = std::string("PLACODE_PASSWORD=") + kPassword;
    const std::string phrase = folder.file("given/phrase"), next = folder.file("given/next");
    const WatchedRun checked = ctl({"--as", "ada", "check"}, {signs_in});
    EXPECT_EQ(checked.status, 0) << checked.said;
    EXPECT_THAT(checked.said, HasSubstr("`placodectl norms key seal` puts it under a passphrase"));
    EXPECT_EQ(ctl({"--as", "ada", "check"}, {std::string("PLACODE_PASSWORD=") + kWrong}).status, 1);
    EXPECT_EQ(ctl({"--as", "ada", "norms", "key", "seal", "--passphrase-file", phrase}, {signs_in})
                  .status,
              0)
        << said_;
    EXPECT_THAT(in_table(), HasSubstr("sealed-1 "));
    // The rest typed, a line each: the password of the account, the passphrases.
    EXPECT_EQ(ctl({"--as", "ada", "norms", "key", "passphrase"}, {},
                  std::string(kPassword) + "\n" + kPhrase + "\n" + kNextPhrase + "\n")
                  .status,
              0)
        << said_;
    EXPECT_EQ(ctl({"--as", "ada", "norms", "key", "passphrase", "--passphrase-file", phrase,
                   "--new-passphrase-file", next},
                  {signs_in})
                  .status,
              2)
        << "the passphrase is another one now";
    EXPECT_EQ(ctl({"--as", "ada", "norms", "key", "export", "--out", folder.file("home/a.key")},
                  {signs_in})
                  .status,
              0)
        << said_;
    EXPECT_EQ(ctl({"--as", "ada", "norms", "key", "import", folder.file("home/a.key"),
                   "--passphrase-file", phrase},
                  {signs_in})
                  .status,
              2);
    EXPECT_EQ(ctl({"--as", "ada", "--json", "norms", "key", "show"}, {signs_in}).status, 0);
    EXPECT_EQ(ctl({"--as", "ada", "audit"}, {signs_in}).status, 0);
    const WatchedRun sound = ctl({"--as", "ada", "check"}, {signs_in});
    EXPECT_EQ(sound.status, 0) << sound.said;
    if (is_sqlite()) {
        EXPECT_EQ(ctl({"--as", "ada", "backup", folder.file("home/a.backup")}, {signs_in}).status,
                  0);
    } else {
        // As the documents say: a file of passwords in place of the environment.
        put("given/pgpass", "*:*:*:*:" + password_ + "\n");
        server_password_ = "PGPASSFILE=" + folder.file("given/pgpass");
        const WatchedRun by_file = ctl({"--as", "ada", "check"}, {signs_in});
        EXPECT_EQ(by_file.status, 0) << by_file.said;
    }
    EXPECT_GE(lines_.size(), 20u) << "each program is seen when it begins and when it ends";
    EXPECT_THAT(leaks(), IsEmpty());
}

/// A browser: one wrong password, the right one, some pages. What is typed lies in files.
constexpr const char* kBrowser = R"sh(
"$1" --store "$2" --listen "unix:$3/web.sock" & pid=$!
for i in $(seq 200); do [ -S "$3/web.sock" ] && break; sleep 0.1; done
call() { folder=$1; shift; curl -s --unix-socket "$folder/web.sock" -b "$folder/jar" -c "$folder/jar" "$@"; }
for typed in wrong password; do
    token=$(call "$3" http://localhost/sign-in | sed -n 's/.*name="form_token" value="\([^"]*\)".*/\1/p' | head -n 1)
    call "$3" -o "$3/page" -w 'answered %{http_code}\n' --data-urlencode "form_token=$token" \
        --data-urlencode login=ada --data-urlencode "password@$3/$typed" http://localhost/sign-in
    cat "$3/page"
done
for page in / /people /attempts /nowhere; do call "$3" "http://localhost$page"; done
kill -TERM $pid
wait $pid
)sh";

TEST_P(SecretLeaks, NorDoTheServerForBrowsersAndTheSimulatorSayOne) {
    put("given/wrong", kWrong);
    put("given/password", kPassword);
    put("given/browser.sh", kBrowser);
    std::string store = shown_store();
    if (!is_sqlite()) {  // Where people sit the owner's log-in is refused.
        store = World::get().server().station_url(database);
        store.erase(store.find(":" + password_), password_.size() + 1);
    }
    const WatchedRun web = watch({"/bin/sh", folder.file("given/browser.sh"),
                                  PLACODE_BIN_DIR "/placode-web", store, folder.file("given")});
    EXPECT_EQ(web.status, 0) << web.said;
    EXPECT_THAT(web.said, HasSubstr("answered 403")) << "the wrong password";
    EXPECT_THAT(web.said, HasSubstr("answered 303")) << "the right one";
    // The simulator signs what it records. As the shell starts it, with whatever the shell has.
    ui::AttemptOrder order;
    order.task = "touch_targets";
    order.device = "script:expert";
    order.duration_s = 1;
    order.user_name = kName;
    const std::string recording = folder.file("home/a.placode");
    order.recording_file = QString::fromStdString(recording);
    std::vector<std::string> command{PLACODE_BIN_DIR "/placode-sim", "--headless", "--fast"};
    for (const QString& each : ui::simulator_arguments(order, {}))
        command.push_back(each.toStdString());
    const QString author = ui::simulator_environment(order).value("PLACODE_AUTHOR");
    EXPECT_EQ(author, kName) << "or a preset that is saved bears no name";
    const WatchedRun sim = watch(std::move(command), {std::string("PLACODE_PASSWORD=") + kPassword,
                                                      std::string("PLACODE_PASSPHRASE=") + kPhrase,
                                                      "PLACODE_AUTHOR=" + author.toStdString()});
    EXPECT_EQ(sim.status, 0) << sim.said;
    EXPECT_TRUE(fs::exists(recording));
    EXPECT_FALSE(holds(bytes_of(recording), kName));
    // Below its public half, which everybody may know.
    key_ = bytes_of(folder.file("given/station.key")).substr(65, 64);
    EXPECT_EQ(key_.find_first_not_of("0123456789abcdef"), std::string::npos) << "or it is another";
    EXPECT_THAT(leaks(), IsEmpty());
}

TEST_P(SecretLeaks, APassphraseComesFromAFileOfItsOwnersOrACredential) {
    if (!is_sqlite()) return;  // The same for every store.
    keep_key_in_clear();
    const std::string phrase = folder.file("given/phrase");
    fs::permissions(phrase, fs::perms::group_read, fs::perm_options::add);
    const WatchedRun open = ctl({"norms", "key", "seal", "--passphrase-file", phrase});
    EXPECT_EQ(open.status, 2);
    EXPECT_THAT(open.said, HasSubstr(phrase + ": is open to others"));
    EXPECT_THAT(in_table(), HasSubstr(key_)) << "nothing was changed";
    fs::permissions(phrase, fs::perms::group_read, fs::perm_options::remove);
    EXPECT_EQ(ctl({"norms", "key", "seal", "--passphrase-file", phrase}).status, 0) << said_;
    // A service: systemd lays the credential into a folder and names that.
    fs::create_directory(folder.file("given/credentials"));
    put("given/credentials/placode-centre-passphrase", std::string(kPhrase) + "\n");
    const WatchedRun service =
        ctl({"norms", "key", "passphrase", "--new-passphrase-file", folder.file("given/next")},
            {"CREDENTIALS_DIRECTORY=" + folder.file("given/credentials")});
    EXPECT_EQ(service.status, 0) << service.said;
    EXPECT_THAT(leaks(), IsEmpty());
}

TEST_P(SecretLeaks, OneThatGetsOutIsFound) {
    keep_key_in_clear();
    EXPECT_EQ(key_.size(), 64u);
    if (is_sqlite()) {
        // A key in clear, in the store and in a backup of it.
        EXPECT_EQ(ctl({"backup", folder.file("home/a.backup")}).status, 0) << said_;
        EXPECT_THAT(leaks(), Contains("a.backup: " + key_));
        EXPECT_THAT(leaks(), testing::Contains(HasSubstr(": " + key_)).Times(testing::Ge(2)));
    }
    // A password in an address, which the program refuses: too late, ps has shown it.
    WatchedProgram wrong;
    wrong.command = {PLACODE_BIN_DIR "/placodectl", "--store",
                     "postgresql://ada:" + std::string(kPassword) + "@localhost/x", "check"};
    const WatchedRun refused = wrong.run(folder.file("given"));
    EXPECT_EQ(refused.status, 2);
    EXPECT_THAT(refused.said, testing::Not(HasSubstr(kPassword)));
    lines_ = refused.command_lines;
    EXPECT_THAT(leaks(), Contains("command line: " + std::string(kPassword)));
    lines_ = {"placode-sim --author " + std::string(kName)};
    EXPECT_THAT(leaks(), Contains("command line: " + std::string(kName)));
    // One that a program starts, and that is gone at once.
    WatchedProgram quick;
    quick.command = {"/bin/sh", "-c", "eval \"/bin/true '$WORD'\"; exit 3"};
    quick.environment = {std::string("WORD=") + kPhrase};
    const WatchedRun started = quick.run(folder.file("given"));
    EXPECT_EQ(started.status, 3);
    lines_ = started.command_lines;
    EXPECT_THAT(leaks(), Contains("command line: " + std::string(kPhrase)));
    // In a log, in settings as Qt may write them, and as bytes.
    lines_.clear();
    put("home/placode.log", "signed in with " + std::string(kWrong) + "\n");
    put("home/settings.ini", forms_of(kNextPhrase)[1]);
    put("home/core", forms_of(key_).back());
    EXPECT_THAT(leaks(), testing::IsSupersetOf({"placode.log: " + std::string(kWrong),
                                                "settings.ini: " + std::string(kNextPhrase),
                                                "core: " + key_}));
}

}  // namespace THIS_TEST
