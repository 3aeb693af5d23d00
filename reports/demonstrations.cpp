// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/demonstrations.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "haptics/trocar.h"
#include "reports/report.h"
#include "sim/core/random.h"

namespace placode::reports {
namespace {

constexpr std::array<const char*, 8> kActions{"x",   "y",   "z",    "roll",
                                              "jaw", "cut", "coag", "engaged"};
constexpr double kMm = 1000;
constexpr double kFullTurn = 2 * std::numbers::pi;

/// Where a tool would be with no roll, and so which roll it has. A pose does not tell whole turns:
/// a roll goes on from the one before, as the hand's did.
class Rolls {
 public:
    explicit Rolls(const std::vector<sim::ToolSpec>& tools) : tools_(tools) {
        for (haptics::TrocarSettings settings : haptics::default_trocars(tools, "script")) {
            settings.mapping = haptics::Mapping::kTip;
            settings.R_WD = haptics::Mat3::Identity();
            settings.scale = 1;
            trocars_.emplace_back(tools[trocars_.size()], settings);
        }
    }
    double roll_rad(size_t tool, const sim::Pose& pose) {
        haptics::DeviceState state;
        state.position_m = pose.p - trocars_[tool].settings().home_tip_m;
        const auto turn = trocars_[tool].tip_pose(state).q.conjugate() * pose.q;
        const double roll = 2 * std::atan2(turn.z(), turn.w());
        last_[tool] = roll + kFullTurn * std::round((last_[tool] - roll) / kFullTurn);
        return last_[tool];
    }

 private:
    const std::vector<sim::ToolSpec>& tools_;
    std::vector<haptics::Trocar> trocars_;
    std::array<double, sim::kMaxTools> last_{};
};

void add_observation(const sim::Recording& recording, const sim::Sample& sample,
                     std::vector<double>& out) {
    out.insert(out.end(), {sample.time_s, static_cast<double>(sample.phase),
                           static_cast<double>(sample.cut_fraction),
                           static_cast<double>(sample.placode_peak_c),
                           static_cast<double>(sample.placode_peak_cem43_min),
                           1e9 * static_cast<double>(sample.placode_burned_m3)});
    for (size_t i = 0; i < recording.header.tools.size(); ++i) {
        const sim::ToolSample& tool = sample.tools[i];
        for (const float value : tool.tip_m) out.push_back(kMm * static_cast<double>(value));
        const auto& q = tool.orientation;
        const sim::Vec3 shaft = sim::Quat(q[0], q[1], q[2], q[3]) * sim::Vec3::UnitZ();
        for (int k = 0; k < 3; ++k) out.push_back(shaft[k]);
        for (const float value : tool.force_n) out.push_back(static_cast<double>(value));
        out.insert(out.end(),
                   {static_cast<double>(tool.in_view), static_cast<double>(tool.in_contact),
                    kMm * static_cast<double>(tool.tip_gap_m), static_cast<double>(tool.power_w)});
    }
}

void add_action(const sim::Recording& recording, const sim::Input& input, Rolls& rolls,
                std::vector<double>& out) {
    for (size_t i = 0; i < recording.header.tools.size(); ++i) {
        const sim::ToolInput& tool = input.tools[i];
        const sim::Pose pose = tool.pose();
        for (int k = 0; k < 3; ++k) out.push_back(pose.p[k]);
        out.insert(out.end(), {rolls.roll_rad(i, pose), static_cast<double>(tool.jaw_rad),
                               (tool.pedals & sim::kPedalCut) != 0 ? 1.0 : 0.0,
                               (tool.pedals & sim::kPedalCoag) != 0 ? 1.0 : 0.0,
                               tool.engaged != 0 ? 1.0 : 0.0});
    }
}

}  // namespace

std::vector<std::string> demonstration_names(size_t tools) {
    std::vector<std::string> names{"time_s",
                                   "phase",
                                   "ring_cut",
                                   "placode_peak_c",
                                   "placode_peak_cem43_min",
                                   "placode_burned_mm3"};
    for (size_t i = 0; i < tools; ++i) {
        const std::string tool = "tool" + std::to_string(i) + ".";
        for (const auto& [name, unit] :
             {std::pair{"tip", "_mm"}, std::pair{"shaft", ""}, std::pair{"force", "_n"}})
            for (const char* axis : {"_x", "_y", "_z"}) names.push_back(tool + name + axis + unit);
        for (const char* name : {"in_view", "contact", "tip_gap_mm", "power_w"})
            names.push_back(tool + name);
    }
    return names;
}

std::vector<std::string> demonstration_action_names(size_t tools) {
    std::vector<std::string> names;
    for (size_t i = 0; i < tools; ++i)
        for (const char* name : kActions) names.push_back("tool" + std::to_string(i) + "." + name);
    return names;
}

DemonstrationArrays demonstration_arrays(const sim::Recording& recording, double points,
                                         double step_s) {
    const double frame_s = recording.header.frame_s;
    const auto frames = static_cast<size_t>(std::llround(step_s / frame_s));
    const auto samples = static_cast<size_t>(std::llround(step_s / recording.header.sample_s));
    if (frames == 0 || samples == 0 ||
        std::abs(static_cast<double>(samples) * recording.header.sample_s - step_s) > 1e-9)
        throw ReportError("steps of " + std::to_string(step_s) +
                          " s: expected a multiple of 0.01 s");
    const size_t steps =
        std::min(recording.inputs.size() / frames, recording.samples.size() / samples);
    if (steps == 0)
        throw ReportError("a recording of " + std::to_string(recording.end.duration_s) +
                          " s is shorter than a step");
    const size_t tools = recording.header.tools.size();
    DemonstrationArrays arrays;
    arrays.observations = {steps, demonstration_names(tools).size(), {}};
    arrays.next_observations = arrays.observations;
    arrays.actions = {steps, kActions.size() * tools, {}};
    arrays.rewards.assign(steps, 0);
    arrays.dones.assign(steps, 0);
    arrays.rewards.back() = points / 100;
    arrays.dones.back() = 1;
    Rolls rolls(recording.header.tools);
    for (size_t step = 0; step < steps; ++step) {
        // A sample stands at the end of its 10 ms; before the first there is none but itself.
        const size_t now = step == 0 ? 0 : step * samples - 1;
        add_observation(recording, recording.samples[now], arrays.observations.values);
        add_observation(recording, recording.samples[(step + 1) * samples - 1],
                        arrays.next_observations.values);
        // Where the hand is at the end of the step is what it wanted during it.
        add_action(recording, recording.inputs[(step + 1) * frames - 1], rolls,
                   arrays.actions.values);
    }
    return arrays;
}

std::vector<int> split_by_person(const std::vector<Demonstration>& demonstrations,
                                 const std::array<int, 3>& shares, uint64_t seed) {
    // In an order that names do not tell, and that stays when somebody is added.
    std::map<std::pair<uint64_t, std::string>, size_t> persons;
    const auto key = [&](const std::string& person) {
        uint64_t hash = seed;
        for (const char c : person)
            hash = sim::mixed_bits(hash + static_cast<unsigned char>(c) + sim::kGoldenStep);
        return std::pair{hash, person};
    };
    for (const Demonstration& one : demonstrations) persons.emplace(key(one.person), 0);
    const double sum = shares[0] + shares[1] + shares[2];
    const auto count = static_cast<double>(persons.size());
    size_t next = 0;
    for (auto& [name, part] : persons) {
        const double behind = static_cast<double>(next++) + 0.5;
        part = behind < std::max(1.0, count * shares[0] / sum)  ? 0
               : behind < count * (shares[0] + shares[1]) / sum ? 1
                                                                : 2;
    }
    std::vector<int> parts;
    parts.reserve(demonstrations.size());
    for (const Demonstration& one : demonstrations)
        parts.push_back(static_cast<int>(persons.at(key(one.person))));
    return parts;
}

}  // namespace placode::reports
