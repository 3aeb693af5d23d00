// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer over everything that reads what comes from outside, under AddressSanitizer and UBSan.
// scripts/fuzz.sh builds and runs it:
//   PLACODE_LOADER=task fuzz CORPUS      one loader of tests/loaders.h
//   PLACODE_LOADER=task fuzz --seeds CORPUS   writes the inputs to begin from, and ends
//   fuzz --list

#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string_view>

#include "tests/loaders.h"

namespace {

const placode::test::Loader* chosen = nullptr;

[[noreturn]] void leave(int code, const char* words) {
    std::fprintf(stderr, "%s\n", words);
    std::exit(code);
}

constexpr size_t kShort = 4096;  // bytes

using Json = nlohmann::ordered_json;

/// The same with no more than two elements in every list.
Json with_short_lists(const Json& value) {
    Json made = value;
    if (made.is_array() && made.size() > 2) made.erase(made.begin() + 2, made.end());
    if (made.is_structured())
        for (Json& each : made) each = with_short_lists(each);
    return made;
}

/// Ten short inputs are tried in the time of a long one, and a fault seldom needs a tenth item or a
/// hundredth line. Binary files stay as they are.
std::string shortened(const std::string& content) {
    if (const Json read = Json::parse(content, nullptr, false); read.is_structured())
        return with_short_lists(read).dump();
    if (content.size() <= kShort || content.find('\0') != std::string::npos) return content;
    return content.substr(0, content.rfind('\n', kShort) + 1);
}

void write_seeds(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    for (const placode::test::Seed& seed : chosen->seeds())
        std::ofstream(folder / seed.name, std::ios::binary) << shortened(seed.content);
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
    static const std::vector<placode::test::Loader> all = placode::test::loaders();
    const std::string_view first = *argc > 1 ? (*argv)[1] : "";
    if (first == "--list") {
        for (const auto& loader : all) std::puts(loader.name);
        std::exit(0);
    }
    const char* wanted = std::getenv("PLACODE_LOADER");
    if (wanted == nullptr) leave(2, "fuzz: PLACODE_LOADER is not set; --list names the loaders");
    for (const auto& loader : all)
        if (std::string_view(loader.name) == wanted) chosen = &loader;
    if (chosen == nullptr) leave(2, "fuzz: PLACODE_LOADER names no loader; --list names them");
    if (first == "--seeds") {
        if (*argc < 3) leave(2, "fuzz: --seeds needs a folder");
        write_seeds((*argv)[2]);
        std::exit(0);
    }
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    try {
        chosen->load(std::string(reinterpret_cast<const char*>(data), size));
    } catch (const std::exception& error) {
        if (!placode::test::is_refusal(error)) {
            std::fprintf(stderr, "%s: no refusal of ours: %s\n", chosen->name, error.what());
            std::abort();
        }
    }
    return 0;
}
