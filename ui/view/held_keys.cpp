// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/held_keys.h"

#include <dlfcn.h>

#include <cstdint>

namespace placode::view {

/// By their names: GLFW for Wayland alone has neither of them.
std::optional<DownKeys> keys_of_keyboard() noexcept {
    using Display = void* (*)();
    using Query = int (*)(void*, char*);
    static const auto display =
        reinterpret_cast<Display>(::dlsym(RTLD_DEFAULT, "glfwGetX11Display"));
    static const auto query = reinterpret_cast<Query>(::dlsym(RTLD_DEFAULT, "XQueryKeymap"));
    void* server = display != nullptr && query != nullptr ? display() : nullptr;
    if (server == nullptr) return std::nullopt;
    char bytes[32] = {};
    query(server, bytes);
    DownKeys keys;
    for (size_t i = 0; i < keys.size(); ++i)
        keys[i] = (static_cast<uint8_t>(bytes[i / 8]) >> (i % 8) & 1U) != 0;
    return keys;
}

}  // namespace placode::view
