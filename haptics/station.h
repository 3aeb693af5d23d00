// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What is particular to one computer: which arm is the right one, ports, keys of the pedals,
// limits. A text file of lines `key = value`, so that it can be read and mended without a program.

#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace placode::haptics {

/// A device that cannot be opened or is not known, or a station file that cannot be used. The
/// message names it and the way out.
class DeviceError : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

/// One setting that a station may change.
struct StationKey {
    std::string_view key, otherwise;  ///< `otherwise`: its value when nobody says anything.
    double low = 0, high = 0;         ///< Allowed range of a number; low = high: a text.
    std::string_view meaning;
};
[[nodiscard]] std::span<const StationKey> station_keys() noexcept;

/// Settings of one computer; what is not set has the default of `station_keys`.
class Station {
 public:
    /// Throws DeviceError naming file and line for unknown keys, values out of range and what is
    /// no `key = value`. `#` begins a comment.
    [[nodiscard]] static Station parse(std::string_view text, const std::string& file);
    /// The file of this computer: $PLACODE_STATION, or station.conf in the user's folder of
    /// settings. No file gives the defaults; throws DeviceError for a damaged one, and when
    /// $PLACODE_STATION names a file that cannot be read.
    [[nodiscard]] static Station of_this_computer();
    [[nodiscard]] static std::string path_of_this_computer();

    /// @pre `key` is one of `station_keys`.
    [[nodiscard]] std::string text(std::string_view key) const;
    [[nodiscard]] double number(std::string_view key) const;
    /// Throws DeviceError as `parse` does.
    void set(std::string_view key, std::string_view value);
    /// Every key with its value and meaning, as a file that `parse` reads.
    [[nodiscard]] std::string file_text() const;
    /// `text` of a station file with the values of this station: what is the same stays as it
    /// stands, with its comments; what is not there comes at the end.
    [[nodiscard]] std::string edited(std::string_view text) const;
    /// Writes the values into the file at `path`, whole or not at all; makes its folder. A file
    /// that is there is edited, otherwise it is `file_text`. Throws DeviceError.
    void save(const std::string& path) const;

 private:
    std::map<std::string, std::string, std::less<>> values_;
};

}  // namespace placode::haptics
