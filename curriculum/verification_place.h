// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A place in the JSON of a verification scene: reads values of one type and range, and says what
// was found and what is expected. Private to curriculum.

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <string>

#include "curriculum/json_reader.h"
#include "sim/core/number_text.h"
#include "sim/verify/verification_scene.h"

namespace placode::curriculum {

using sim::Vec3;

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Allowed range of a number; open ends are excluded.
struct Range {
    double low = -kInfinity, high = kInfinity;
    bool open_low = false, open_high = false;

    [[nodiscard]] bool holds(double v) const {
        return std::isfinite(v) && (open_low ? v > low : v >= low) &&
               (open_high ? v < high : v <= high);
    }
    [[nodiscard]] std::string text() const {
        if (low == -kInfinity && high == kInfinity) return "a number";
        std::string out = "a number ";
        if (low > -kInfinity) out += (open_low ? "above " : "from ") + sim::shortest_text(low);
        if (low > -kInfinity && high < kInfinity) out += open_low || open_high ? ", " : " ";
        if (high < kInfinity) out += (open_high ? "below " : "to ") + sim::shortest_text(high);
        return out;
    }
};

inline constexpr Range kAny{};
inline constexpr Range kPositive{0, kInfinity, true, false};
inline constexpr Range kNotNegative{0, kInfinity};
/// Modulus, density and thickness in whatever system of units: water has 1e-24 kg/nm^3. A float
/// ends at 1e-38 and 3e38: the rest is for volumes, 1e-14 m^3 and less.
inline constexpr Range kAnyUnit{1e-24, 1e18, false, true};
/// Of coordinates, speeds and accelerations: their squares and cubes stay finite.
inline constexpr Range kPlace{-1e12, 1e12};
/// Metres in a file's unit of length.
inline constexpr Range kScale{0, 1e12, true, false};

/// A place in the document.
class Place {
 public:
    Place(const Json& json, std::string pointer, const std::string& origin)
        : json_(json), pointer_(std::move(pointer)), origin_(origin) {}

    [[noreturn]] void fail(const std::string& message) const {
        throw DefinitionError(origin_, pointer_.empty() ? "/" : pointer_, message);
    }
    [[noreturn]] void expected(const std::string& what) const {
        std::string found = json_.dump(-1, ' ', false, Json::error_handler_t::replace);
        if (found.size() > 60) found = found.substr(0, 57) + "...";
        fail("found " + found + "; expected " + what);
    }

    /// Keys that may stand here; anything else is refused.
    void keys(std::initializer_list<const char*> known) const {
        std::string list;
        for (const char* key : known) list += std::string(list.empty() ? "" : ", ") + key;
        if (!json_.is_object()) expected("an object with the keys " + list);
        for (const auto& [key, value] : json_.items()) {
            if (std::find(known.begin(), known.end(), key) == known.end())
                throw DefinitionError(origin_, pointer_ + "/" + key,
                                      "unknown key; expected one of: " + list);
        }
    }
    [[nodiscard]] bool has(const char* key) const { return json_.contains(key); }
    [[nodiscard]] Place at(const char* key) const {
        if (!json_.contains(key)) fail(std::string("the key \"") + key + "\" is missing");
        return {json_.at(key), pointer_ + "/" + key, origin_};
    }
    [[nodiscard]] Place at(size_t i) const {
        return {json_.at(i), pointer_ + "/" + std::to_string(i), origin_};
    }
    [[nodiscard]] bool is_text(const char* text) const {
        return json_.is_string() && json_.get<std::string>() == text;
    }
    [[nodiscard]] size_t size() const { return json_.size(); }
    [[nodiscard]] bool is_array() const { return json_.is_array(); }
    [[nodiscard]] const std::string& pointer() const { return pointer_; }

    [[nodiscard]] double number(const Range& range) const {
        if (!json_.is_number() || !range.holds(json_.get<double>())) expected(range.text());
        return json_.get<double>();
    }
    [[nodiscard]] int64_t whole(int64_t low, int64_t high) const {
        const bool is_whole =
            json_.is_number_integer() ||
            (json_.is_number_float() && json_.get<double>() == std::floor(json_.get<double>()));
        const double value = json_.is_number() ? json_.get<double>() : 0;
        if (!is_whole || !(value >= static_cast<double>(low) && value <= static_cast<double>(high)))
            expected("a whole number from " + std::to_string(low) + " to " + std::to_string(high));
        return json_.get<int64_t>();
    }
    [[nodiscard]] std::string text() const {
        if (!json_.is_string()) expected("a text");
        return json_.get<std::string>();
    }
    [[nodiscard]] bool yes() const {
        if (!json_.is_boolean()) expected("true or false");
        return json_.get<bool>();
    }
    [[nodiscard]] Vec3 vector(const Range& range = kAny) const {
        if (!json_.is_array() || json_.size() != 3) expected("an array of three numbers");
        return {at(size_t{0}).number(range), at(size_t{1}).number(range),
                at(size_t{2}).number(range)};
    }
    template <class Function>
    void each(Function&& function) const {
        if (!json_.is_array()) expected("an array");
        for (size_t i = 0; i < json_.size(); ++i) function(at(i));
    }

    void take(const char* key, double& value, const Range& range) const {
        if (has(key)) value = at(key).number(range);
    }
    void take(const char* key, int& value, int low, int high) const {
        if (has(key)) value = static_cast<int>(at(key).whole(low, high));
    }
    void take(const char* key, Vec3& value) const {
        if (has(key)) value = at(key).vector();
    }
    void take(const char* key, bool& value) const {
        if (has(key)) value = at(key).yes();
    }

 private:
    const Json& json_;
    std::string pointer_;
    const std::string& origin_;
};

/// Two corners, the one with the smaller coordinates first.
[[nodiscard]] sim::BoxSelection box_of(const Place& place);

/// "mesh" and "sheets", which may stand alone. Mesh files are looked for in `folder`.
void read_mesh_and_sheets(const Place& root, const std::string& folder,
                          sim::VerificationScene& scene);

/// Young's modulus, Poisson's ratio and density, those that are there.
void read_elastic(const Place& place, sim::Material& material);

}  // namespace placode::curriculum
