// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// How the programs are called: every command and argument is described, and what is misspelt is
// answered in one form, `program: thing: problem; way out`, with the word that was meant.

// g++ 12 sees an overlap in std::string operations that is not there (GCC 105651).
#pragma GCC diagnostic ignored "-Wrestrict"

#include <gmock/gmock.h>

#include <algorithm>
#include <sstream>

#include "tests/coarse_scene.h"
#include "tests/programs_fixture.h"

using namespace placode::test;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

namespace THIS_TEST {

constexpr size_t kColumn = 30;  ///< Where CLI11 writes descriptions.

class Usage : public Programs {
 protected:
    /// Looks at the help of a command and of all below it; how many arguments were described.
    int walk(const std::string& program, const std::string& command) const {
        const Outcome help = run(program, command + " --help");
        EXPECT_EQ(help.status, 0) << command << help.err;
        std::istringstream lines(help.out);
        std::string line, section;
        std::vector<std::string> below;
        int described = 0;
        bool wraps = false;
        while (std::getline(lines, line)) {
            if (line.empty()) continue;
            if (line.front() != ' ') {
                section = line;
                continue;
            }
            const bool heads = section.starts_with("Positionals") ||
                               section.starts_with("Options") || section.starts_with("Subcommands");
            if (!heads) continue;
            const size_t name = line.find_first_not_of(' ');
            if (name >= kColumn) {  // below a long name, or the rest of a long description
                wraps = false;
                continue;
            }
            EXPECT_FALSE(wraps) << program << " " << command << ": no description before " << line;
            const std::string rest = line.substr(name);
            // The description stands in its column, or on the next line where the name is long.
            wraps = line.size() <= kColumn || line[kColumn - 1] != ' ';
            ++described;
            if (section.starts_with("Subcommands")) below.push_back(rest.substr(0, rest.find(' ')));
        }
        EXPECT_FALSE(wraps) << program << " " << command << ": no description at the end";
        for (const std::string& each : below)
            described += walk(program, command.empty() ? each : command + " " + each);
        return described;
    }
};

TEST_F(Usage, EveryCommandAndArgumentIsDescribed) {
    EXPECT_GT(walk("placodectl", ""), 300) << "the walk saw too little to prove anything";
    EXPECT_GT(walk("placode-sim", ""), 20);
}

TEST_F(Usage, AMisspeltWordIsAnsweredWithTheOneThatWasMeant) {
    add_user("anna", "trainee");
    const std::pair<const char*, const char*> cases[]{
        {"exprt csv --study s1", "\"export\""},
        {"study sttaus s1", "\"status\""},
        {"export cvs --study s1", "\"csv\""},
        {"attempts --usr anna", "\"--user\""},
        {"--jsn user list", "\"--json\""},
        {"stats alpa a.csv", "\"alpha\""},
        {"user add bert --role trainer", "\"trainee\""},
        {"attempts --user ana", "\"anna\""},
        {"norms standard diathermy_ring --novices N --experts E --metric path_lenght_mm",
         "\"path_length_mm\""},
        {"course show first_stps", "\"first_steps\""},
    };
    for (const auto& [command, meant] : cases) {
        const Outcome said = ctl(command, "PLACODE_NEW_PASSWORD='long enough 1'");
        EXPECT_EQ(said.status, 2) << command;
        EXPECT_THAT(said.err, HasSubstr(std::string("did you mean ") + meant)) << command;
    }
    const std::pair<const char*, const char*> attempts[]{
        {"--task diathermy_ring --device script:exprt --headless --fast", "\"script:expert\""},
        {"--task diathermy_rng --device script:expert --headless --fast", "\"diathermy_ring\""},
        {"--tsk diathermy_ring", "\"--task\""},
        {"--task diathermy_ring --language ep --headless", "expected one of: "},
    };
    for (const auto& [command, meant] : attempts) {
        const Outcome said = run("placode-sim", command);
        EXPECT_EQ(said.status, 2) << command;
        EXPECT_THAT(said.err, HasSubstr(meant)) << command;
    }
    EXPECT_THAT(run("placode", "--stroe x", "QT_QPA_PLATFORM=offscreen").err,
                HasSubstr("did you mean \"--store\""));
    EXPECT_EQ(run("placode", "--stroe x", "QT_QPA_PLATFORM=offscreen").status, 2);
    // What the help offers is answered, and begins no session.
    EXPECT_THAT(run("placode", "--help").out,
                AllOf(HasSubstr("-h, --help"), HasSubstr("--store"), Not(HasSubstr("--help-all"))));
    EXPECT_EQ(run("placode", "--help-all", "QT_QPA_PLATFORM=offscreen").status, 2);
}

TEST_F(Usage, AValueOfAnyLengthIsRefusedAndEndsNoProgram) {
    const std::string longest(100000, '9');
    for (const char* sign : {"x", "", ".5e400"}) {
        const Outcome sim = run("placode-sim", "--duration " + longest + sign);
        EXPECT_EQ(sim.status, 2) << sign;
        EXPECT_THAT(sim.err, HasSubstr("--duration: found \"9999")) << sim.err.substr(0, 300);
        EXPECT_EQ(ctl("bench store --users " + longest + sign).status, 2) << sign;
    }
}

TEST_F(Usage, WhatIsGivenTooOftenIsSaidInOurWords) {
    const Outcome twice = run("placode-sim", "--task touch_targets --task needle_bite --headless");
    EXPECT_EQ(twice.status, 2);
    EXPECT_EQ(twice.err,
              "placode-sim: --task: is given 2 times; expected once; see `placode-sim --help`\n");
    const Outcome thrice = ctl("attempts --user a --user b --user c");
    EXPECT_EQ(thrice.status, 2);
    EXPECT_EQ(thrice.err,
              "placodectl: attempts: --user: is given 3 times; expected once; see `placodectl "
              "attempts --help`\n");
    const Outcome shares = ctl("dataset --recordings in --out set --split 40,30,20,10");
    EXPECT_EQ(shares.status, 2);
    EXPECT_THAT(shares.err, AllOf(HasSubstr("--split: found 4 values; expected 3"),
                                  Not(HasSubstr("required but received"))));
    const Outcome pair = ctl("dataset --recordings in --out set --split 40,60");
    EXPECT_EQ(pair.status, 2);
    EXPECT_THAT(pair.err, AllOf(HasSubstr("--split: "), Not(HasSubstr("required but received"))));
}

TEST_F(Usage, AStrangeWordIsNotGuessedAt) {
    const Outcome said = ctl("theremin");
    EXPECT_EQ(said.status, 2);
    EXPECT_THAT(said.err, AllOf(HasSubstr("expected one of"), Not(HasSubstr("did you mean"))));
}

TEST_F(Usage, WhatIsNoNumberIsRefusedBeforeAnythingIsDone) {
    write_text(file("a.csv"), "score\n1\n2\n");
    const std::pair<const char*, const char*> cases[]{
        {"batch plan rollouts --out b --tasks touch_targets --policies nothing --seeds 1 ",
         "--time-limit"},
        {"batch forecast b ", "--lost"},
        {"batch forecast b ", "--price"},
        {"bench stability --quick ", "--rest-seconds"},
        {"bench store --quick ", "--simulate"},
        {"bench picture --recording a.placode ", "--from"},
        {"metrics a.csv ", "--threshold"},
        {"stats cusum a.csv ", "--success-at"},
        {"contour a.csv a.csv ", "--tolerance"},
    };
    for (const auto& [command, option] : cases) {
        for (const std::string value : {"nan", "-nan", "NAN", "inf"}) {
            const Outcome said = ctl(std::string(command) + option + "=" + value);
            EXPECT_EQ(said.status, 2) << command << option << " " << value;
            EXPECT_THAT(said.err, HasSubstr(option)) << command;
            EXPECT_THAT(said.err, testing::ContainsRegex("[nN][aA][nN]|inf")) << command;
        }
    }
    EXPECT_FALSE(fs::exists(file("b")));
    const Outcome arm = run("placode-sim", "--test-device haply --test-force nan");
    EXPECT_EQ(arm.status, 2);
    EXPECT_THAT(arm.err, StartsWith("placode-sim: --test-force: found \"nan\"; expected 0.1"));
}

// CLI11 made 18446744073709551615 of -1, and 8 of 010.
TEST_F(Usage, ASeedIsAWholeNumberFromZero) {
    write_text(file("a.csv"), "score\n1\n2\n4\n");
    const std::string bootstrap = "--json stats bootstrap a.csv --seed ";
    const std::string dataset = "dataset --recordings none --out set --split-seed ";
    const std::string attempt =
        "--task touch_targets --device script:expert --headless --fast --record a.placode --seed ";
    for (const std::string value : {"-1", "1.5", "0x10", "x", "18446744073709551616"}) {
        const std::string said =
            "seed: found \"" + value + "\"; expected 0 to 18446744073709551615";
        for (const Outcome& each :
             {ctl(bootstrap + value), ctl(dataset + value), run("placode-sim", attempt + value)}) {
            EXPECT_EQ(each.status, 2) << value;
            EXPECT_THAT(each.err, HasSubstr(said));
        }
    }
    EXPECT_FALSE(fs::exists(file("a.placode")));
    EXPECT_THAT(ctl(bootstrap + "010").out, HasSubstr("\"seed\": 10,"));
    EXPECT_THAT(ctl(bootstrap + "18446744073709551615").out,
                HasSubstr("\"seed\": 18446744073709551615,"));
}

TEST_F(Usage, OutputThatDoesNotFitOnTheDiskIsAFailure) {
    write_text(file("line.csv"), "x_mm,y_mm\n0,0\n5,0\n10,0\n");
    const std::string contour = "contour line.csv line.csv";
    ASSERT_EQ(ctl(contour).status, 0);
    const std::string program = "'" PLACODE_BIN_DIR "/placodectl' ";
    // The long help leaves its buffer early, the short version at the very end.
    for (const std::string& line : {"--json " + contour, contour, std::string("--help"),
                                    std::string("study --help"), std::string("--version")}) {
        write_text(file("full.sh"), program + line + " > /dev/full\n");
        const Outcome full = shell("sh full.sh");
        EXPECT_EQ(full.status, 1) << line;
        EXPECT_THAT(full.err, StartsWith("placodectl: standard output: cannot be written (No "))
            << line;
    }
    for (const std::string other : {"placode-sim", "placode-web", "placode"})
        for (const char* asked : {" --help", " --version"}) {
            write_text(file("full.sh"),
                       "'" PLACODE_BIN_DIR "/" + other + "'" + asked + " > /dev/full\n");
            const Outcome full = shell("sh full.sh");
            EXPECT_EQ(full.status, 1) << other << asked;
            EXPECT_THAT(full.err, HasSubstr(other + ": standard output: cannot be written"))
                << other << asked;
        }
    for (const char* asked : {"--list-devices", "--limits-file", "--station-file"}) {
        write_text(file("full.sh"),
                   std::string("'" PLACODE_BIN_DIR "/placode-sim' ") + asked + " > /dev/full\n");
        EXPECT_EQ(shell("sh full.sh").status, 1) << asked;
    }
    write_text(file("full.sh"), program + "--json contour none.csv none.csv > /dev/full\n");
    EXPECT_EQ(shell("sh full.sh").status, 2) << "the first trouble counts";
    // A reader that has seen enough, also where its signal is ignored.
    for (const std::string each : {"placodectl", "placode-sim", "placode-web", "placode"}) {
        for (const char* trap : {"", "trap '' PIPE\n"}) {
            write_text(file("pipe.sh"), trap + ("{ sleep 0.3; '" PLACODE_BIN_DIR "/" + each +
                                                "' --help; echo $? > status; } | true\n"));
            const Outcome closed = shell("sh pipe.sh");
            EXPECT_EQ(closed.status, 0) << each << trap;
            EXPECT_EQ(closed.err, "") << each << trap;
        }
        EXPECT_EQ(read_text(file("status")), "0\n") << each << ": where no signal ends it";
    }
}

TEST_F(Usage, WhereNothingCanBeWrittenIsSaidBeforeTheWork) {
    write_text(file("taken"), "kept");
    fs::create_symlink("nowhere", file("astray"));
    const std::string benches[]{"bench speed",
                                "bench contact",
                                "bench scaling",
                                "bench stability",
                                "bench cuts",
                                "bench haptics",
                                "bench environment",
                                "bench store",
                                "bench accuracy",
                                "bench closed-forms",
                                "bench tasks --policy nothing",
                                "bench picture --recording none.placode",
                                "solve none.json"};
    for (const std::string& bench : benches) {
        // A picture's figures are one file, which may be written over.
        const bool of_folder = !bench.starts_with("bench picture");
        for (const std::string out :
             {"taken/below", of_folder ? "taken" : ".", of_folder ? "astray/below" : "taken/b/c"}) {
            const Outcome said = ctl(bench + " --out " + out);
            EXPECT_EQ(said.status, 2) << bench << " " << out;
            EXPECT_THAT(said.err, StartsWith("placodectl: --out " + out + ": cannot be written ("))
                << bench;
            EXPECT_EQ(std::count(said.err.begin(), said.err.end(), '\n'), 1)
                << bench << ": worked before it looked\n"
                << said.err;
        }
    }
    for (const std::string report :
         {"bench stability --report ", "bench accuracy --report ", "bench tasks --board "}) {
        EXPECT_THAT(ctl(report + "taken/below.md").err, HasSubstr("taken is no folder")) << report;
        EXPECT_THAT(ctl(report + ".").err, HasSubstr(" .: cannot be written (it is a folder)"))
            << report;
    }
    EXPECT_EQ(read_text(file("taken")), "kept");
    // Looking makes nothing.
    const Outcome refused = ctl("solve none.json --out new/below");
    EXPECT_EQ(refused.status, 2);
    EXPECT_THAT(refused.err, HasSubstr("none.json"));
    EXPECT_FALSE(fs::exists(file("new")));
}

// Some of them failed when the work was done, with a status that is for work that failed, and with
// an entry in the audit trail of a file that there never was.
TEST_F(Usage, EveryCommandLooksWhereItIsToWrite) {
    add_user("anna", "trainee");
    write_text(file("taken"), "kept");
    const auto entries = [this] {
        return placode::db::open_store("sqlite:" + store)->audit().trail(1000).size();
    };
    const size_t before = entries();
    const std::string of_folders[]{"export csv --user anna", "user data --user anna",
                                   "study construct s1", "report study s1 --out a.pdf --figures",
                                   "batch plan rescore --recordings ."};
    for (const std::string& command : of_folders) {
        const std::string option = command.ends_with("--figures") ? "" : " --out";
        const Outcome said = ctl(command + option + " taken/below");
        EXPECT_EQ(said.status, 2) << command;
        EXPECT_THAT(said.err, HasSubstr(" taken/below: cannot be written (")) << command;
    }
    const std::string of_files[]{"backup",
                                 "audit --head",
                                 "report attempt 1 --out",
                                 "report seal 1 --out",
                                 "report cohort all --out",
                                 "report trainee anna --out",
                                 "report certificate first_steps --user anna --out",
                                 "report study s1 --out",
                                 "norms export 1 --out",
                                 "norms key export --out",
                                 "batch merge none --out",
                                 "study key-make s1 --file"};
    for (const std::string& command : of_files) {
        const Outcome said =
            ctl(command + " taken/a.pdf", "PLACODE_PASSPHRASE='four words are good'");
        EXPECT_EQ(said.status, 2) << command;
        EXPECT_THAT(said.err, HasSubstr(" taken/a.pdf: cannot be written (")) << command;
    }
    for (const std::string command : {"backup", "audit --head", "norms key export --out"}) {
        const Outcome said = ctl(command + " taken");
        EXPECT_EQ(said.status, 2) << command;
        EXPECT_THAT(said.err, HasSubstr(": taken exists and is not overwritten; give another name"))
            << command;
    }
    EXPECT_EQ(ctl("backup missing/copy.db").status, 2) << "it makes no folder";
    EXPECT_EQ(entries(), before);
    EXPECT_EQ(read_text(file("taken")), "kept");
    EXPECT_EQ(ctl("backup copy.db").status, 0);
}

TEST_F(Usage, WhatIsNotThereOrAFolderIsSaidAsThat) {
    const Outcome web = run("placode-web", "--store sqlite:never_was.db");
    EXPECT_EQ(web.status, 2);
    EXPECT_EQ(web.err,
              "placode-web: open sqlite:never_was.db: there is no such store; give the right one "
              "with --store\n");
    EXPECT_FALSE(fs::exists(file("never_was.db")));
    EXPECT_THAT(ctl("score .").err, HasSubstr("read the recording .: this is a folder"));
    EXPECT_THAT(run("placode-sim", "--device play:. --headless").err,
                HasSubstr("read the recording .: this is a folder"));
    add_user("anna", "trainee");
    const std::pair<const char*, const char*> cases[]{
        {"restore .", ": this is a folder; give a file that `placodectl backup` of this version"},
        {"restore --rehearse .", ": this is a folder; give a file that `placodectl backup` of"},
        {"stats alpha .", "read .: this is a folder; expected a CSV file"},
        {"contour . .", ".: this is a folder; expected a CSV file"},
        {"user import .", ".: this is a folder; expected a CSV file"},
    };
    for (const auto& [command, expected] : cases) {
        const Outcome said = ctl(command);
        EXPECT_EQ(said.status, 2) << command;
        EXPECT_THAT(said.err, HasSubstr(expected)) << command;
    }
}

TEST_F(Usage, AMisspeltLayoutOfTheControlsIsNamed) {
    for (const auto& [layout, word] : {std::pair{"'cut=C'", "cut and coagulate are both"},
                                       {"'jump=G'", "jump=G"},
                                       {"'cut=Enter'", "no such key"}}) {
        const Outcome said = run("placode-sim", std::string("--task touch_targets --device "
                                                            "script:expert --controls ") +
                                                    layout);
        EXPECT_EQ(said.status, 2) << layout;
        EXPECT_THAT(said.err, StartsWith("placode-sim: --controls: ")) << layout;
        EXPECT_THAT(said.err, HasSubstr(word)) << layout;
    }
}

TEST_F(Usage, AllMessagesHaveOneForm) {
    add_user("anna", "trainee");
    const char* const commands[]{"",
                                 "study",
                                 "exprt",
                                 "attempts --usr anna",
                                 "attempts --user",
                                 "attempts too many",
                                 "audit --limit x",
                                 "audit --limit 0",
                                 "export csv",
                                 "export",
                                 "report attempt x --out a.pdf",
                                 "report attempt 1",
                                 "stats alpa a.csv",
                                 "stats alpha missing.csv",
                                 "attempts --user nobody_at_all",
                                 "course unassign 7",
                                 "group member G anna",
                                 "study status s1",
                                 "export csv --study s1 --fhir-base nowhere"};
    for (const char* command : commands) {
        const Outcome said = ctl(command);
        EXPECT_EQ(said.status, 2) << command << said.err;
        EXPECT_THAT(said.err, StartsWith("placodectl: ")) << command;
        EXPECT_EQ(std::count(said.err.begin(), said.err.end(), '\n'), 1) << command << said.err;
        // thing: problem; way out
        EXPECT_THAT(said.err.substr(12), AllOf(HasSubstr("; "))) << command;
        EXPECT_THAT(said.err, Not(HasSubstr("Run with --help"))) << command;
        const Outcome json = ctl(std::string("--json ") + command);
        EXPECT_THAT(json.out, HasSubstr("\"error\"")) << command;
    }
}

/// An interpreter that writes down what it is given, and answers as the package would.
constexpr const char* kInterpreter = R"(#!/bin/sh
printf '%s\n' "$@" > given
echo '{"frames_per_s": 1234.5, "call_us": 1}'
)";

TEST_F(Usage, WhatAnInterpreterIsGivenIsNoCommandOfAShell) {
    const std::string task = "it's $(touch harm); touch harm.json", python = "an 'odd' python; x";
    fs::copy(PLACODE_SOURCE_DIR "/data/tasks/touch_targets.json", file(task));
    write_text(file(python), kInterpreter);
    fs::permissions(file(python), fs::perms::owner_all);
    const std::string scene = std::string(" --scene '") + kCoarseScene + "'";
    write_text(file("order"), "exec '" PLACODE_BIN_DIR
                              "/placodectl' --json bench environment "
                              "--quick --task \"it's \\$(touch harm); touch harm.json\" "
                              "--python \"./an 'odd' python; x\"" +
                                  scene + "\n");
    const Outcome measured = shell("sh order");
    ASSERT_EQ(measured.status, 0) << measured.err;
    EXPECT_EQ(number_in(measured.out, "python_frames_per_s"), 1234.5);
    EXPECT_EQ(number_in(measured.out, "two_processes_frames_per_s"), 2469);
    EXPECT_EQ(read_text(file("given")),
              "-m\nplacode.bench\n" + task + "\n" + kCoarseScene + "\n3\n");
    EXPECT_FALSE(fs::exists(file("harm")));
    EXPECT_FALSE(fs::exists(file("harm.json")));
    // What gives no figures says why.
    write_text(file(python), "#!/bin/sh\necho 'No module named placode' >&2\nexit 1\n");
    const Outcome lacking = shell("sh order");
    EXPECT_EQ(lacking.status, 0);
    EXPECT_THAT(lacking.err, HasSubstr("not measured from Python: ./an 'odd' python; x: No module "
                                       "named placode"));
    EXPECT_THAT(lacking.out, HasSubstr("No module named placode"));
}

}  // namespace THIS_TEST
