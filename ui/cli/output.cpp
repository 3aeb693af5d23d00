// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <iostream>

#include "sim/core/number_text.h"
#include "ui/cli/cli.h"
#include "ui/cli/on_screen.h"

namespace placode::cli {
namespace {

// Characters, not bytes: names have letters beyond ASCII.
size_t width_of(const std::string& text) {
    size_t width = 0;
    for (const char c : text) width += (static_cast<unsigned char>(c) & 0xc0) != 0x80 ? 1 : 0;
    return width;
}

// A cell begins no line of its own.
bool hides_something(const std::vector<std::string>& row) {
    return std::any_of(row.begin(), row.end(),
                       [](const std::string& cell) { return sim::has_hidden_letters(cell); });
}

std::vector<std::vector<std::string>> as_seen(std::vector<std::vector<std::string>> rows) {
    for (auto& row : rows)
        for (std::string& cell : row) cell = sim::without_hidden_letters(cell);
    return rows;
}

// Why standard output took no more; 0 = it took everything.
int trouble = 0;

// The reason is only known where the writing fails, so nothing is left in a buffer.
void write_out(const std::string& text) {
    errno = 0;
    std::cout << text << std::flush;
    if (!std::cout && trouble == 0) trouble = errno != 0 ? errno : EIO;
}

std::string read_line() {
    std::string line;
    std::getline(std::cin, line);
    if (!line.empty() && line.back() == '\r') line.pop_back();
    return line;
}

std::string ask_without_echo(const std::string& prompt) {
    std::cerr << prompt << ": " << std::flush;
    termios before{};
    tcgetattr(STDIN_FILENO, &before);
    termios silent = before;
    silent.c_lflag &= ~static_cast<tcflag_t>(ECHO);
    tcsetattr(STDIN_FILENO, TCSAFLUSH, &silent);
    std::string line = read_line();
    tcsetattr(STDIN_FILENO, TCSAFLUSH, &before);
    std::cerr << '\n';
    return line;
}

}  // namespace

void print(const Context& context, const Json& json, const std::string& text) {
    if (!context.json) {
        write_out(on_screen(text) + (text.empty() || text.back() == '\n' ? "" : "\n"));
        return;
    }
    std::string whole = json.dump(2, ' ', false, Json::error_handler_t::replace);
    // For programs nothing is lost: written as \uXXXX such a letter does nothing to a terminal.
    if (sim::has_hidden_letters(whole, "\n"))
        whole = json.dump(2, ' ', true, Json::error_handler_t::replace);
    write_out(whole + '\n');
}

// Whoever reads through a pipe may have seen enough, as `head` has.
int output_trouble() { return trouble == EPIPE ? 0 : trouble; }

std::string fixed(double value, int decimals) { return sim::fixed_text(value, decimals); }

std::string shortest(double value) { return sim::shortest_text(value); }

Json optional_number(const std::optional<double>& value) {
    return value ? Json(*value) : Json(nullptr);
}

std::string optional_text(const std::optional<double>& value, int decimals) {
    return value ? fixed(*value, decimals) : "-";
}

std::string table(const std::vector<std::vector<std::string>>& rows) {
    if (std::any_of(rows.begin(), rows.end(), hides_something)) return table(as_seen(rows));
    std::vector<size_t> widths;
    for (const auto& row : rows)
        for (size_t i = 0; i < row.size(); ++i) {
            if (widths.size() <= i) widths.push_back(0);
            widths[i] = std::max(widths[i], width_of(row[i]));
        }
    std::string text;
    for (const auto& row : rows) {
        std::string line;
        for (size_t i = 0; i < row.size(); ++i)
            line += row[i] +
                    std::string(i + 1 < row.size() ? widths[i] - width_of(row[i]) + 2 : 0, ' ');
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + '\n';
    }
    return text;
}

std::string read_password(const char* variable, const std::string& prompt, bool twice) {
    if (const char* set = std::getenv(variable); set != nullptr) return set;
    if (isatty(STDIN_FILENO) == 0) {
        std::string line = read_line();
        if (line.empty())
            throw InputError(prompt + ": no terminal to ask at; set " + variable +
                             " or give it on the standard input");
        return line;
    }
    std::string first = ask_without_echo(prompt);
    if (twice && ask_without_echo(prompt + " (again)") != first)
        throw InputError(prompt + ": the two passwords differ; nothing was changed");
    return first;
}

}  // namespace placode::cli
