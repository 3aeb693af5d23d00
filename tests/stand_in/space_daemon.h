// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A stand-in for spacenavd: a socket that speaks as the daemon does.

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>

namespace placode::test {

class SpaceDaemon {
 public:
    SpaceDaemon()
        : path(std::filesystem::temp_directory_path() /
               ("spnav_" + std::to_string(::getpid()) + ".sock")) {
        listen_again();
    }
    ~SpaceDaemon() {
        quit();
        std::filesystem::remove(path);
    }
    void listen_again() {
        std::filesystem::remove(path);
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        std::strcpy(address.sun_path, path.c_str());
        listener_ = ::socket(AF_UNIX, SOCK_STREAM, 0);
        (void)!bind(listener_, reinterpret_cast<sockaddr*>(&address), sizeof address);
        (void)!listen(listener_, 4);
    }
    void accept_client() { client_ = ::accept(listener_, nullptr, nullptr); }
    void quit() {
        if (client_ >= 0) ::close(client_);
        if (listener_ >= 0) ::close(listener_);
        client_ = listener_ = -1;
    }
    void event(int32_t type, std::array<int32_t, 7> rest) {
        int32_t words[8]{type};
        std::copy(rest.begin(), rest.end(), words + 1);
        (void)!::send(client_, words, sizeof words, MSG_NOSIGNAL);
    }
    std::string path;

 private:
    int listener_ = -1, client_ = -1;
};

}  // namespace placode::test
