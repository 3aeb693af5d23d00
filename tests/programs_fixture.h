// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Runs the programs as people and scripts meet them, in a folder of their own.

#include <sys/wait.h>
#include <unistd.h>

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "tests/store_fixture.h"

namespace placode::test {

struct Outcome {
    int status = -1;
    std::string out, err;
};

inline void write_text(const std::string& path, const std::string& text) {
    std::ofstream(path, std::ios::binary | std::ios::trunc) << text;
}

class Programs : public testing::Test {
 protected:
    void SetUp() override {
        std::string name = (scratch_root() / "placode-programs-XXXXXX").string();
        ASSERT_NE(::mkdtemp(name.data()), nullptr);
        folder = name;
        store = folder + "/placode.db";
    }
    void TearDown() override { fs::remove_all(folder); }

    [[nodiscard]] std::string file(const std::string& name) const { return folder + "/" + name; }

    /// Runs a program as the shell would. `environment` is like "A=b C=d". No terminal.
    [[nodiscard]] Outcome run(const std::string& program, const std::string& arguments,
                              const std::string& environment = "") const {
        return shell("'" PLACODE_BIN_DIR "/" + program + "' " + arguments, environment);
    }
    /// Runs one command of the shell, in the folder and with its home there.
    [[nodiscard]] Outcome shell(const std::string& line,
                                const std::string& environment = "") const {
        const std::string command = "cd '" + folder + "' && env HOME='" + folder +
                                    "' XDG_DATA_HOME='" + folder + "/data' " + environment +
                                    " timeout 120 " + line + " < /dev/null > '" + file("out") +
                                    "' 2> '" + file("err") + "'";
        const int status = std::system(command.c_str());
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_text(file("out")),
                read_text(file("err"))};
    }
    [[nodiscard]] Outcome ctl(const std::string& arguments,
                              const std::string& environment = "") const {
        return run("placodectl", "--store sqlite:" + store + "?timeout_ms=200 " + arguments,
                   environment);
    }
    void add_user(const std::string& login, const std::string& role) const {
        const Outcome added =
            ctl("user add " + login + " --role " + role, "PLACODE_NEW_PASSWORD='long enough 1'");
        ASSERT_EQ(added.status, 0) << added.err;
    }

    std::string folder, store;
};

inline constexpr const char* kRight = "PLACODE_PASSWORD='long enough 1'";

/// Number after `"key": ` in a JSON text.
inline double number_in(const std::string& json, const std::string& key) {
    const size_t at = json.find("\"" + key + "\": ");
    if (at == std::string::npos) return std::nan("");
    double value = 0;
    const size_t begin = at + key.size() + 4;
    std::from_chars(json.data() + begin, json.data() + json.size(), value);
    return value;
}

}  // namespace placode::test
