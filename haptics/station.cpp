// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/station.h"

#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "sim/core/number_text.h"
#include "sim/core/text_file.h"
#include "sim/core/user_folders.h"

namespace placode::haptics {

namespace {

constexpr StationKey kKeys[] = {
    {"arm.mapping", "handle", 0, 0,
     "handle: the arm is the handle outside the body (the port inverts); tip: it is the tip"},
    {"arm.scale", "1", 0.1, 5, "motion of the handle per motion of the arm"},
    {"arm.one_hand", "right", 0, 0, "right or left: the hand that a single arm stands for"},
    {"limit.stiffness_n_m", "300", 10, 1000, "stiffness of the virtual coupling [N/m]"},
    {"limit.damping_ns_m", "1.5", 0, 4, "its damping [N s/m]"},
    {"limit.force_n", "3", 0.1, 10, "largest force [N]; 0.5 for the first test of a device"},
    {"openhaptics.library", "", 0, 0, "path of libHD.so; empty: as the system finds it"},
    {"openhaptics.right", "", 0, 0,
     "name of the right arm in the vendor's setup; empty: try the "
     "default device, \"Default PHANToM\" and \"Right Device\""},
    {"openhaptics.left", "", 0, 0, "name of the left arm; empty: no left arm"},
    {"haply.host", "127.0.0.1", 0, 0, "address of the Inverse service"},
    {"haply.port", "10001", 1, 65535, "its WebSocket port"},
    {"haply.right", "", 0, 0,
     "device_id of the right Inverse3; empty: the first, with a left arm the first that is not "
     "left-handed"},
    {"haply.left", "", 0, 0,
     "device_id of the left Inverse3; auto: the first that says it is left-handed; empty: no left "
     "arm"},
    {"haply.axes", "x z -y", 0, 0,
     "the device's axes that are our x (right), y (up), z (to the operator)"},
    {"haply.force_n", "4", 0.1, 10, "its largest force [N]; not confirmed by the vendor"},
    {"avatar.right", "/dev/ttyACM0", 0, 0, "serial port of the right port device"},
    {"avatar.left", "", 0, 0, "serial port of the left port device; empty: none"},
    {"avatar.ibox", "", 0, 0, "serial port of the handle and pedal box; empty: none"},
    {"avatar.signs", "1 1 1 1", 0, 0, "signs of rotation, pitch, depth, yaw, each 1 or -1"},
    {"avatar.depth_zero_m", "0", -0.3, 0.3,
     "depth that the device reports with the tip at the port [m]"},
    {"avatar.settle_s", "2", 0, 10, "wait after opening the port, its board starts anew [s]"},
    {"forcedimension.library", "", 0, 0,
     "path of libdhd.so or libdrd.so; empty: as the system finds it"},
    {"forcedimension.swap_hands", "0", 0, 1,
     "1: the device that says left-handed is the right one"},
    {"spacemouse.socket", "", 0, 0,
     "socket of spacenavd; empty: $SPNAV_SOCKET, /run/spnav.sock, /var/run/spnav.sock"},
    {"spacemouse.speed_m_s", "0.04", 0.005, 0.15, "speed at full deflection [m/s]"},
    {"tested.device", "", 0, 0, "device whose force was tested on this computer by a person"},
    {"tested.force_n", "0", 0, 10, "largest force with which that test was passed [N]"},
    {"tested.date", "", 0, 0, "when"},
    {"pedals.device", "", 0, 0,
     "foot pedals: /dev/input/by-id/...-event-kbd; empty: none but the keyboard's F13, F14"},
    {"pedals.cut_key", "183", 1, 767, "code of the yellow pedal (KEY_F13 is 183)"},
    {"pedals.coag_key", "184", 1, 767, "code of the blue pedal (KEY_F14 is 184)"},
};

const StationKey& find(std::string_view key) {
    for (const StationKey& known : kKeys)
        if (known.key == key) return known;
    std::string names;
    for (const StationKey& known : kKeys) names.append(names.empty() ? "" : ", ").append(known.key);
    throw DeviceError("unknown key \"" + std::string(key) + "\"; known are: " + names);
}

bool to_number(std::string_view text, double& value) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc{} && end == text.data() + text.size();
}

std::string_view trimmed(std::string_view text) {
    const size_t first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

void check_words(const StationKey& key, std::string_view value) {
    const auto must = [&](bool good, const char* expected) {
        if (!good)
            throw DeviceError(std::string(key.key) + ": found \"" + std::string(value) +
                              "\", expected " + expected);
    };
    if (key.key == "arm.mapping") must(value == "handle" || value == "tip", "handle or tip");
    if (key.key == "arm.one_hand") must(value == "right" || value == "left", "right or left");
}

}  // namespace

std::span<const StationKey> station_keys() noexcept { return kKeys; }

void Station::set(std::string_view key, std::string_view value) {
    const StationKey& known = find(key);
    if (known.low < known.high) {
        double number = 0;
        if (!to_number(value, number) || !(number >= known.low && number <= known.high))
            throw DeviceError(std::string(key) + ": found \"" + std::string(value) +
                              "\", expected a number from " + sim::shortest_text(known.low) +
                              " to " + sim::shortest_text(known.high));
    }
    check_words(known, value);
    values_.insert_or_assign(std::string(key), std::string(value));
}

Station Station::parse(std::string_view text, const std::string& file) {
    Station station;
    int line = 0;
    while (!text.empty()) {
        ++line;
        const size_t end = text.find('\n');
        std::string_view one = text.substr(0, end);
        text = end == std::string_view::npos ? std::string_view{} : text.substr(end + 1);
        one = trimmed(one.substr(0, one.find('#')));
        if (one.empty()) continue;
        try {
            const size_t sign = one.find('=');
            if (sign == std::string_view::npos)
                throw DeviceError("found \"" + std::string(one) + "\", expected key = value");
            station.set(trimmed(one.substr(0, sign)), trimmed(one.substr(sign + 1)));
        } catch (const DeviceError& error) {
            throw DeviceError(file + ", line " + std::to_string(line) + ": " + error.what());
        }
    }
    return station;
}

std::string Station::path_of_this_computer() {
    if (const char* named = std::getenv("PLACODE_STATION")) return named;
    return sim::user_path(sim::UserFolder::kConfig, "placode/station.conf").string();
}

Station Station::of_this_computer() {
    const std::string path = path_of_this_computer();
    if (path.empty()) return {};
    std::ifstream in(path);
    if (!in) {
        if (std::getenv("PLACODE_STATION") != nullptr)
            throw DeviceError(path + ": cannot be read; PLACODE_STATION names it");
        return {};
    }
    const auto text = sim::read_at_most(in, sim::kLargestText);
    if (!text) throw DeviceError(path + ": has more than 64 MB; expected a station file");
    return parse(*text, path);
}

std::string Station::text(std::string_view key) const {
    const auto found = values_.find(key);
    return found != values_.end() ? found->second : std::string(find(key).otherwise);
}

double Station::number(std::string_view key) const {
    double value = 0;
    (void)to_number(text(key), value);
    return value;
}

std::string Station::file_text() const {
    std::string out = "# Devices of this computer, read by placode-sim.\n";
    for (const StationKey& known : kKeys) {
        out.append("\n# ").append(known.meaning);
        if (known.low < known.high)
            out.append("; ")
                .append(sim::shortest_text(known.low))
                .append(" to ")
                .append(sim::shortest_text(known.high));
        out.append("\n").append(values_.find(known.key) != values_.end() ? "" : "# ");
        out.append(known.key).append(" = ").append(text(known.key)).append("\n");
    }
    return out;
}

std::string Station::edited(std::string_view text) const {
    std::string out;
    std::map<std::string, std::string, std::less<>> left = values_;
    while (!text.empty()) {
        const size_t end = text.find('\n');
        const std::string_view line = text.substr(0, end);
        text = end == std::string_view::npos ? std::string_view{} : text.substr(end + 1);
        const std::string_view said = trimmed(line.substr(0, line.find('#')));
        const size_t sign = said.find('=');
        const std::string_view key = trimmed(said.substr(0, sign));
        const auto wanted = values_.find(key);
        if (sign == std::string_view::npos || wanted == values_.end() ||
            trimmed(said.substr(sign + 1)) == wanted->second)
            out.append(line);
        else
            out.append(key).append(" = ").append(wanted->second);
        if (sign != std::string_view::npos) left.erase(std::string(key));
        out.push_back('\n');
    }
    for (const auto& [key, value] : left) out.append(key).append(" = ").append(value).append("\n");
    return out;
}

void Station::save(const std::string& path) const {
    namespace fs = std::filesystem;
    const auto refuse = [&](const std::string& why) {
        throw DeviceError("station file " + path + ": cannot be written (" + why +
                          "); PLACODE_STATION can name another place");
    };
    if (path.empty()) refuse("no folder of settings is known");
    std::string text = file_text();
    if (std::ifstream in(path); in)
        text = edited(std::string(std::istreambuf_iterator<char>(in), {}));
    (void)parse(text, path);  // what we write can be read
    std::error_code error;
    const fs::path folder = fs::path(path).parent_path();
    if (!folder.empty()) fs::create_directories(folder, error);
    if (error) refuse(error.message());
    const std::string beside = path + ".new";
    {
        std::ofstream out(beside, std::ios::trunc);
        out << text;
        out.flush();
        if (!out) refuse("disk full or not allowed");
    }
    fs::rename(beside, path, error);
    if (error) {
        fs::remove(beside);
        refuse(error.message());
    }
}

}  // namespace placode::haptics
