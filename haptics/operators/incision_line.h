// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The planned incision as a person at work keeps it in mind: where the line lies, what of it is cut
// or given up, where it is still warm, and, once it is cut, where the placode hangs on all the
// same.

#include <array>
#include <cstdint>
#include <vector>

#include "haptics/device.h"
#include "sim/cutting/pieces.h"

namespace placode::haptics {

/// A closed line, asked by arc length from its first point [m], wrapped. Allocates in `see` only
/// while the number of its points is new.
class IncisionLine {
 public:
    struct Place {
        Vec3 point, normal, inward;  ///< In W [m]; outwards; towards the placode, in the surface.
    };
    struct Run {  ///< A piece that is left, end > begin.
        double begin_m = 0, end_m = 0;
    };

    /// @param tip_m of the needle: beside it the line is not seen.
    /// @param watched_s for how long the hand has been lifted to look at the line anew; < 0 = not.
    void see(const Perception& seen, const Vec3& tip_m, double watched_s);
    /// From now on what counts is where the placode hangs on, also where the line was given up.
    void seek_bridges() noexcept;

    [[nodiscard]] bool known() const noexcept { return contour_.size() >= 3; }
    [[nodiscard]] double length_m() const noexcept { return arc_.back(); }
    [[nodiscard]] double start_m() const noexcept { return start_m_; }  ///< < 0: not seen yet.
    [[nodiscard]] double wrapped(double s_m) const noexcept;
    [[nodiscard]] size_t index(double s_m) const noexcept;  ///< Of the point before.
    [[nodiscard]] Place place(double s_m) const noexcept;
    [[nodiscard]] bool cut(double s_m) const noexcept { return cut_[index(s_m)] != 0; }
    /// Something is left within `reach_m` to either side.
    [[nodiscard]] bool left_near(double s_m, double reach_m) const noexcept;
    /// Something is left within `reach_m` ahead that was heated less than `cool_s` ago.
    [[nodiscard]] bool warm_ahead(double s_m, double reach_m, double time_s,
                                  double cool_s) const noexcept;
    /// The next piece that is left, from `from_m` on. Pieces shorter than `least_m` and places with
    /// `most_tries` are passed over.
    [[nodiscard]] bool next_run(double from_m, int most_tries, double least_m,
                                Run& run) const noexcept;
    void count_try(size_t point) noexcept;
    void note_heat(size_t point, double time_s) noexcept { heated_s_[point] = time_s; }

    /// The whole line sinks (an opened sac): the hand waits until it lies still.
    [[nodiscard]] bool sinks() const noexcept { return sinks_; }
    /// That is over, and the line was looked at anew.
    [[nodiscard]] bool has_sunk() const noexcept { return has_sunk_; }
    [[nodiscard]] bool placode_hangs_on() const noexcept { return hangs_on_; }
    [[nodiscard]] bool by_bridges() const noexcept { return by_bridges_; }
    /// It hangs on nothing, and that is what counts now.
    [[nodiscard]] bool freed() const noexcept { return freed_; }

 private:
    void learn(const Perception& seen);
    void look_for_bridges(const Perception& seen) noexcept;
    void watch_sinking(const Perception& seen, double watched_s);
    void measure() noexcept;
    [[nodiscard]] size_t points(double reach_m) const noexcept;

    std::vector<Vec3> contour_, normal_;
    std::vector<uint8_t> cut_, tries_;
    std::vector<double> arc_{0.0};  // (points + 1)
    std::vector<double> heated_s_;  // when the current was last on there
    Vec3 centre_ = Vec3::Zero();
    double start_m_ = -1, seen_s_ = 0;
    double sunk_m_ = 0;  // how much lower the whole line lies than remembered
    double still_z_m_ = 0, still_since_s_ = 0;
    std::array<uint8_t, sim::kSectors> bridge_{};  // 1 = something in this sector holds the placode
    bool sinks_ = false, has_sunk_ = false, hangs_on_ = false, by_bridges_ = false, freed_ = false;
};

}  // namespace placode::haptics
