// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What `cmake --install` puts somewhere works from there, without the tree that it was built from.

// g++ 12 sees an overlap in std::string operations that is not there (GCC 105651).
#pragma GCC diagnostic ignored "-Wrestrict"

#include <gmock/gmock.h>

#include <regex>

#include "tests/programs_fixture.h"

using namespace placode::test;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

namespace THIS_TEST {

class Install : public Programs {
 protected:
    void SetUp() override {
        Programs::SetUp();
        const Outcome installed =
            shell("cmake --install '" PLACODE_BIN_DIR "/..' --prefix '" + file("there") + "'");
        ASSERT_EQ(installed.status, 0) << installed.err;
    }
    [[nodiscard]] std::string there(const std::string& path) const { return file("there/" + path); }
    [[nodiscard]] Outcome backup(const std::string& environment = "") const {
        return shell("'" + there("lib/placode/scheduled-backup") + "'",
                     "PATH='" + there("bin") + "':\"$PATH\" " + environment);
    }
    [[nodiscard]] std::vector<std::string> backups() const {
        std::vector<std::string> names;
        if (!fs::exists(file("data/placode/backups"))) return names;
        for (const auto& entry : fs::directory_iterator(file("data/placode/backups")))
            names.push_back(entry.path().filename().string());
        std::sort(names.begin(), names.end());
        return names;
    }
};

TEST_F(Install, ProgramsFindTheirDataWhereTheyWereInstalled) {
    for (const char* program : {"placode", "placode-sim", "placodectl", "placode-web"}) {
        const Outcome version = shell("'" + there(std::string("bin/") + program) + "' --version",
                                      "DISPLAY= WAYLAND_DISPLAY=");
        EXPECT_EQ(version.status, 0) << version.err;
        EXPECT_THAT(version.out, StartsWith(std::string(program) + " 0."));
    }
    const std::string attempt = "'" + there("bin/placode-sim") +
                                "' --task touch_targets --device script:expert --headless "
                                "--fast --duration 0.2";
    EXPECT_EQ(shell(attempt).status, 0) << read_text(file("err"));
    for (const char* page : {"en/index.md", "pl/index.md", "pictures/en/today.png"})
        EXPECT_TRUE(fs::exists(there(std::string("share/placode/manual/") + page))) << page;
    // It reads these files and not those of the tree.
    fs::remove(there("share/placode/tasks/touch_targets.json"));
    const Outcome without = shell(attempt);
    EXPECT_EQ(without.status, 2);
    EXPECT_THAT(without.err, HasSubstr("touch_targets"));
}

TEST_F(Install, ProgramsAndLibraryAreHardened) {
    std::vector<std::string> files;
    for (const char* program : {"placode", "placode-sim", "placodectl", "placode-web"})
        files.push_back(there(std::string("bin/") + program));
    for (const auto& entry : fs::recursive_directory_iterator(there("lib")))
        if (!entry.is_symlink() && entry.path().filename().string().starts_with("libplacode.so"))
            files.push_back(entry.path().string());
    ASSERT_EQ(files.size(), 5u);
    for (const std::string& path : files) {
        const std::string elf = shell("readelf --wide -l -d --dyn-syms '" + path + "'").out;
        EXPECT_THAT(elf, HasSubstr("GNU_RELRO")) << path;
        EXPECT_THAT(elf, HasSubstr("BIND_NOW")) << path;
        EXPECT_THAT(elf, HasSubstr("__stack_chk_fail")) << path;
        EXPECT_THAT(elf, HasSubstr("_chk@")) << path << ": fortified functions";
        EXPECT_THAT(elf, HasSubstr("Elf file type is DYN")) << path;
        EXPECT_THAT(elf, Not(HasSubstr(" RWE "))) << path << ": no memory to write and run";
    }
}

TEST_F(Install, AProgramInCIsBuiltAndRunsWithWhatWasInstalled) {
    write_text(
        file("main.c"),
        "#include <placode.h>\n#include <stdio.h>\n"
        "int main(void) {\n"
        "    placode_fields* fields = placode_fields_new(1);\n"
        "    placode_environment* e = placode_environment_new(fields, \"touch_targets\", 0);\n"
        "    printf(\"%s, %d tools\\n\", e ? placode_task_id(e) : placode_fields_error(fields),\n"
        "           (int)placode_tool_count(e));\n"
        "    placode_environment_free(e);\n    placode_fields_free(fields);\n    return 0;\n}\n");
    write_text(file("build.sh"), "export PKG_CONFIG_PATH=$(dirname $(find '" + there("") +
                                     "' -name placode.pc))\n"
                                     "cc -o main main.c $(pkg-config --cflags --libs placode) "
                                     "-Wl,-rpath,$(pkg-config --variable=libdir placode)\n");
    const Outcome built = shell("sh build.sh");
    ASSERT_EQ(built.status, 0) << built.err;
    // Its tasks lie beside the library, not beside this program.
    const Outcome ran = shell("'" + file("main") + "'");
    EXPECT_EQ(ran.out, "touch_targets, 2 tools\n") << ran.err;
    fs::remove(there("share/placode/tasks/touch_targets.json"));
    EXPECT_THAT(shell("'" + file("main") + "'").out, HasSubstr("trace_contour"));
}

TEST_F(Install, TheDesktopFindsItsFiles) {
    const std::string entry = read_text(there("share/applications/org.placode.Placode.desktop"));
    EXPECT_THAT(entry, HasSubstr("\nExec=placode\n"));
    EXPECT_THAT(entry, HasSubstr("\nIcon=placode\n"));
    for (const char* path :
         {"share/icons/hicolor/scalable/apps/placode.svg", "lib/udev/rules.d/70-placode.rules",
          "share/metainfo/org.placode.Placode.metainfo.xml", "share/doc/placode/copyright",
          "share/doc/placode/examples/check_seal.py", "lib/systemd/user/placode-backup.timer",
          "lib/systemd/user/placode-backup.service",
          "lib/systemd/system/placode-server-backup.timer",
          "lib/systemd/system/placode-server-backup.service",
          "lib/systemd/system/placode-server-verify.timer",
          "lib/systemd/system/placode-server-verify.service",
          "lib/systemd/system/placode-web.service"})
        EXPECT_TRUE(fs::exists(there(path))) << path;
    EXPECT_THAT(read_text(there("lib/systemd/user/placode-backup.service")),
                HasSubstr("ExecStart=/usr/lib/placode/scheduled-backup"));
    EXPECT_THAT(read_text(there("lib/systemd/system/placode-server-verify.service")),
                HasSubstr("ExecStart=/usr/lib/placode/scheduled-verify"));
    const Outcome help = shell("'" + there("lib/placode/shared-station") + "' --help");
    EXPECT_EQ(help.status, 0) << help.err;
    EXPECT_THAT(help.out, HasSubstr("sudo /usr/lib/placode/shared-station LOGIN"));
}

TEST_F(Install, DocumentsThatProgramsAndManualNameAreThere) {
    for (const char* path :
         {"README.md", "SECURITY.md", "RELIABILITY.md", "docs/measurements/speed.md"})
        EXPECT_TRUE(fs::exists(there(std::string("share/doc/placode/") + path))) << path;
    EXPECT_FALSE(fs::exists(there("share/doc/placode/docs/manual"))) << "that is elsewhere";
    const std::regex named(R"(/usr/(share/doc/placode/[A-Za-z_./-]*[A-Za-z]))");
    int seen = 0;
    for (const auto& entry : fs::recursive_directory_iterator(there("share/placode/manual"))) {
        if (entry.path().extension() != ".md") continue;
        const std::string text = read_text(entry.path().string());
        for (std::sregex_iterator each(text.begin(), text.end(), named), end; each != end; ++each) {
            ++seen;
            EXPECT_TRUE(fs::exists(there((*each)[1]))) << entry.path() << ": " << (*each)[1];
        }
        EXPECT_THAT(text, Not(HasSubstr("`docs/"))) << entry.path() << ": no place of a package";
    }
    EXPECT_GE(seen, 4);
}

TEST_F(Install, RemovalSwitchesTheServersTimersOff) {
    fs::create_directories(file("stand_in"));
    write_text(file("stand_in/systemctl"), "#!/bin/sh\necho \"$*\"\n");
    fs::permissions(file("stand_in/systemctl"), fs::perms(0755));
    const auto prerm = [&](const std::string& words) {
        const Outcome done = shell("'" PLACODE_SOURCE_DIR "/packaging/prerm' " + words,
                                   "PATH='" + file("stand_in") + "':\"$PATH\"");
        EXPECT_EQ(done.status, 0) << done.err;
        return done.out;
    };
    EXPECT_EQ(prerm("upgrade 0.2.0"), "");
    const std::string said = prerm("remove");
    int timers = 0;
    for (const auto& entry : fs::directory_iterator(there("lib/systemd/system"))) {
        if (entry.path().extension() != ".timer") continue;
        ++timers;
        EXPECT_THAT(said, HasSubstr("disable --now " + entry.path().filename().string()));
    }
    EXPECT_EQ(timers, 2);
    EXPECT_THAT(read_text(PLACODE_SOURCE_DIR "/cmake/packaging.cmake"),
                HasSubstr("${PROJECT_SOURCE_DIR}/packaging/prerm"));
}

TEST_F(Install, ThePackageMakesTheUserOfThePortal) {
    const std::string unit = read_text(there("lib/systemd/system/placode-web.service"));
    for (const char* line :
         {"User=placode-web", "StateDirectory=placode-web", "RuntimeDirectory=placode",
          "Environment=HOME=/var/lib/placode-web", "EnvironmentFile=-/etc/placode/web.conf",
          "PrivateTmp=yes", "MemoryMax=4G"})
        EXPECT_THAT(unit, HasSubstr(std::string("\n") + line + "\n"));
    EXPECT_THAT(unit, HasSubstr("\nExecStart=/usr/bin/placode-web --store ${PLACODE_STORE} "
                                "--listen unix:/run/placode/web.sock --behind-tls"));
    // On a computer that has none of them: they write down what is asked of them.
    fs::create_directories(file("fake"));
    for (const char* program : {"getent", "groupadd", "useradd", "udevadm"}) {
        const std::string fake = file(std::string("fake/") + program);
        const bool looks = std::string(program) == "getent";
        write_text(fake, std::string("#!/bin/sh\n") +
                             (looks ? "exit 2\n" : "echo \"$(basename \"$0\") $*\"\n"));
        fs::permissions(fake, fs::perms(0755));
    }
    const Outcome made = shell("sh '" PLACODE_SOURCE_DIR "/packaging/postinst' configure",
                               "PATH='" + file("fake") + "':\"$PATH\"");
    EXPECT_EQ(made.status, 0) << made.err;
    EXPECT_THAT(made.out, HasSubstr("groupadd --system placode\n"));
    EXPECT_THAT(made.out, HasSubstr("groupadd --system placode-web\n"));
    EXPECT_THAT(made.out, ContainsRegex("useradd --system --gid placode-web .*--home-dir "
                                        "/var/lib/placode-web .*nologin placode-web\n"));
}

TEST_F(Install, CompletionAsksTheProgram) {
    const auto complete = [&](const std::string& words) {
        // As bash does: the file of the command's name; the words so far, the last one unfinished.
        const std::string command = words.substr(0, words.find(' '));
        write_text(file("ask.sh"), "export PATH='" + there("bin") + "':$PATH\nsource '" +
                                       there("share/bash-completion/completions/" + command) +
                                       "'\nCOMP_WORDS=(" + words +
                                       ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_placode\n"
                                       "echo \"${COMPREPLY[@]}\"\n");
        return shell("bash ask.sh").out;
    };
    EXPECT_EQ(complete("placodectl exp"), "export\n");
    EXPECT_THAT(complete("placodectl study re"), HasSubstr("repeat"));
    EXPECT_THAT(complete("placodectl study re"), Not(HasSubstr("restore")));
    EXPECT_EQ(complete("placode-sim --head"), "--headless\n");
    EXPECT_EQ(complete("placode-web --lis"), "--listen\n");
    EXPECT_EQ(complete("placode --vers"), "--version\n");
}

TEST_F(Install, TheDailyBackupIsCheckedAndOldOnesGo) {
    EXPECT_EQ(backup().status, 0) << "no store yet: nothing to do";
    EXPECT_TRUE(backups().empty());
    fs::create_directories(file("data/placode"));
    const std::string own = "sqlite:" + file("data/placode/placode.db");
    ASSERT_EQ(run("placodectl", "--store " + own + " user add anna --role trainee",
                  "PLACODE_NEW_PASSWORD='long enough 1'")
                  .status,
              0)
        << read_text(file("err"));
    for (int day = 0; day < 3; ++day) {
        const Outcome made = backup("PLACODE_BACKUPS_KEPT=2");
        ASSERT_EQ(made.status, 0) << made.err << made.out;
        ASSERT_EQ(shell("sleep 1.1").status, 0);  // names have seconds
    }
    // Each with the statement of its trail's end beside it, which goes with it.
    const auto kept = backups();
    ASSERT_EQ(kept.size(), 4u);
    EXPECT_EQ(kept[1], kept[0] + ".head");
    EXPECT_EQ(kept[3], kept[2] + ".head");
    const Outcome people = run(
        "placodectl", "--store sqlite:" + file("data/placode/backups/") + kept[2] + " user list");
    EXPECT_THAT(people.out, HasSubstr("anna"));
    // A number that keeps no copy: nothing is done.
    const auto before = backups();
    for (const char* number : {"0", "-1", "all", "010"}) {
        const Outcome refused = backup(std::string("PLACODE_BACKUPS_KEPT=") + number);
        EXPECT_EQ(refused.status, 2) << number;
        EXPECT_THAT(refused.err, HasSubstr("PLACODE_BACKUPS_KEPT: found \"" + std::string(number) +
                                           "\"; expected a whole number from 1"));
    }
    EXPECT_EQ(backups(), before);
    // A store that is broken takes no good copy with it.
    write_text(file("data/placode/placode.db"), "this was a store");
    EXPECT_NE(backup("PLACODE_BACKUPS_KEPT=1").status, 0);
    for (const std::string& name : kept)
        EXPECT_TRUE(fs::exists(file("data/placode/backups/" + name))) << name;
}

// The copies of a month must not be what keeps every further one from being made.
TEST_F(Install, TheDailyBackupMakesRoomAndKeepsOneFailedCopy) {
    const std::string folder = file("data/placode/backups");
    fs::create_directories(folder);
    write_text(file("data/placode/placode.db"), "a store");
    for (const char* day : {"01", "02", "03", "04", "05"})
        for (const char* ending : {".backup.db", ".backup.db.head"}) {
            const std::string copy =
                folder + "/placode-202601" + std::string(day) + "-000000" + ending;
            write_text(copy, "a copy");
            fs::resize_file(copy, 2'000'000);
        }
    // On a disk of ROOM copies; db/disk_room.cpp says the words (durable_file_test).
    fs::create_directories(file("stand_in"));
    write_text(
        file("stand_in/placodectl"),
        "#!/bin/sh\nfor file; do :; done\necho \"$*\" >>calls\n"
        "if [ -n \"${BROKEN:-}\" ]; then echo x >\"$file.failed\"; exit 1; fi\n"
        "left=$((ROOM - $(ls \"$(dirname \"$file\")\" | grep -c 'backup.db$')))\n"
        "if [ $left -lt 1 ]; then\n"
        "  echo \"placodectl: back up x: only 1 MB are free there, and the copy needs $((1 + "
        "2 * (1 - left))) MB; make room, or give another place\" >&2\n  exit 1\nfi\n"
        "echo a copy >\"$file\"\necho a head >\"$file.head\"\n");
    fs::permissions(file("stand_in/placodectl"), fs::perms(0755));
    const auto night = [&](const std::string& environment) {
        return shell("'" PLACODE_SOURCE_DIR "/packaging/scheduled-backup'",
                     "PATH='" + file("stand_in") + "':\"$PATH\" " + environment);
    };
    const auto first_copies = [&] {
        int there = 0;
        for (const std::string& name : backups())
            there += name.starts_with("placode-202601") && name.ends_with(".db") ? 1 : 0;
        return there;
    };
    // No removal would be enough: none goes.
    Outcome done = night("ROOM=1");
    EXPECT_EQ(done.status, 1);
    EXPECT_THAT(done.err, HasSubstr("nothing was backed up"));
    EXPECT_EQ(backups().size(), 10u);
    done = night("ROOM=4");
    EXPECT_EQ(done.status, 0) << done.err;
    EXPECT_EQ(first_copies(), 3) << "the two oldest made room for the new one";
    EXPECT_EQ(backups().size(), 8u) << "with what lies beside each";
    EXPECT_EQ(backups().front(), "placode-20260103-000000.backup.db");
    // Two are there whatever happens.
    done = night("ROOM=2");
    EXPECT_EQ(done.status, 1) << done.out;
    EXPECT_GE(first_copies(), 2);
    for (int i = 0; i < 2; ++i) {
        EXPECT_EQ(night("ROOM=9 BROKEN=1").status, 1);
        ASSERT_EQ(shell("sleep 1.1").status, 0);  // names have seconds
    }
    const auto names = backups();
    EXPECT_EQ(std::count_if(names.begin(), names.end(),
                            [](const std::string& each) { return each.ends_with(".failed"); }),
              1);
    // A copy is checked once, by the command that makes it.
    EXPECT_THAT(read_text(file("calls")), Not(HasSubstr(" check")));
}

TEST_F(Install, TheDailyBackupIsOfTheStoreThatIsNamedAndSaysWhenItIsGone) {
    const auto add = [&](const std::string& path, const std::string& login) {
        fs::create_directories(fs::path(path).parent_path());
        const Outcome added =
            run("placodectl", "--store 'sqlite:" + path + "' user add " + login + " --role trainee",
                "PLACODE_NEW_PASSWORD='long enough 1'");
        ASSERT_EQ(added.status, 0) << added.err;
    };
    const std::string own = file("data/placode/placode.db"), other = file("else where/other.db");
    add(own, "anna");
    add(other, "bert");
    const std::string named = "PLACODE_STORE='sqlite:" + other + "?timeout_ms=200'";
    const Outcome made = backup(named);
    ASSERT_EQ(made.status, 0) << made.err << made.out;
    const auto copies = backups();
    ASSERT_EQ(copies.size(), 2u);  // with the statement of its trail's end
    const Outcome people = run("placodectl", "--store 'sqlite:" + file("data/placode/backups/") +
                                                 copies[0] + "' user list");
    EXPECT_THAT(people.out, HasSubstr("bert"));
    EXPECT_THAT(people.out, Not(HasSubstr("anna")));
    // Gone: the timer's list of failed services has it, and nobody takes it for "not begun yet".
    fs::remove(other);
    fs::remove(own);
    for (const auto& [environment, path] : {std::pair{named, other}, {std::string(), own}}) {
        const Outcome gone = backup(environment);
        EXPECT_EQ(gone.status, 1) << path;
        EXPECT_THAT(gone.err, HasSubstr("the store is not at " + path));
    }
    EXPECT_EQ(backup("PLACODE_STORE=mysql://here").status, 2);
    EXPECT_THAT(read_text(there("lib/systemd/user/placode-backup.service")),
                Not(HasSubstr("ConditionPathExists")))
        << "the script says what is missing; a condition would skip it without a word";
}

TEST_F(Install, AttemptsAreSimulatedAgainAtNight) {
    const std::string store = "sqlite:" + file("placode.db");
    const auto ctl = [&](const std::string& words) {
        const Outcome done = run("placodectl", "--store " + store + " " + words,
                                 "PLACODE_NEW_PASSWORD='long enough 1'");
        ASSERT_EQ(done.status, 0) << done.err;
    };
    ctl("user add ada --role administrator");
    ctl("user add night --role educator");
    ctl("user add anna --role trainee");
    ASSERT_EQ(run("placode-sim",
                  "--task touch_targets --device script:expert --headless --fast "
                  "--duration 0.3 --record '" +
                      file("a.placode") + "'")
                  .status,
              0);
    ctl("import --user anna '" + file("a.placode") + "'");
    const auto night = [&](const std::string& environment) {
        return shell("'" + there("lib/placode/scheduled-verify") + "'",
                     "PATH='" + there("bin") + "':\"$PATH\" PLACODE_STORE='" + store +
                         "' PLACODE_AS=night " + environment);
    };
    const std::string credential = "CREDENTIALS_DIRECTORY='" + file("credentials") + "'";
    const Outcome without = night(credential);
    EXPECT_NE(without.status, 0);
    EXPECT_THAT(without.err, HasSubstr("credentials/password"));
    fs::create_directories(file("credentials"));
    write_text(file("credentials/password"), "another one\n");
    EXPECT_NE(night(credential).status, 0) << "a night in which nothing was done is a failure";
    write_text(file("credentials/password"), "long enough 1\n");
    // What does not fit into the night is not.
    const Outcome short_night = night(credential + " PLACODE_VERIFY_TIME=0.01");
    EXPECT_EQ(short_night.status, 0) << short_night.err;
    EXPECT_THAT(short_night.out, HasSubstr("the next night"));
    const Outcome done = night(credential);
    EXPECT_EQ(done.status, 0) << done.err;
    EXPECT_THAT(done.out, HasSubstr("1 attempt gave the same"));
    EXPECT_THAT(night(credential).out, HasSubstr("no attempt waits"));
}

}  // namespace THIS_TEST
