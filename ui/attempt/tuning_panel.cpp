// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/attempt/tuning_panel.h"

#include <algorithm>
#include <cmath>
#include <ctime>

#include "curriculum/utc_time.h"
#include "sim/core/number_text.h"
#include "ui/view/strings.h"

namespace placode::ui {

using sim::Tissue;
using sim::TuneParameter;

namespace {

constexpr int kTissueRow = 0, kFirstRow = 1;
constexpr int kResetRow = kFirstRow + sim::kTuneParameters, kSaveRow = kResetRow + 1;
constexpr int kRows = kSaveRow + 1;
constexpr size_t kLongestName = 60;

constexpr std::array<const char*, sim::kTuneParameters> kLabels{
    "Stiffness", "Damping", "Friction", "Failure stretch", "Cut power", "Coag power"};
constexpr std::array<const char*, sim::kTissueCount> kTissues{
    "Skin", "Thin skin", "Subcutis", "Muscle", "Junctional zone", "Placode", "Gel", "Dura"};

std::string number(double value, int digits) { return sim::fixed_text(value, digits); }

}  // namespace

std::string tuning_text(TuneParameter parameter, double value) {
    switch (parameter) {
        case TuneParameter::kStiffness:
            return number(value / 1000, value < 10000 ? 2 : 1) + " kPa";
        case TuneParameter::kDamping:
            return number(value, 0) + " /s";
        case TuneParameter::kFriction:
        case TuneParameter::kFailStretch:
            return number(value, 2);
        default:
            return number(value, 0) + " W";
    }
}

TuningPanel::TuningPanel(const curriculum::Task& task, TuningSetup setup)
    : setup_(std::move(setup)), scene_id_(task.scene_id) {
    for (int i = 0; i < sim::kTissueCount; ++i) {
        const sim::Material& m = task.scene.materials[static_cast<size_t>(i)];
        const auto at = [&](TuneParameter p) -> double& {
            return before_[static_cast<size_t>(p)][static_cast<size_t>(i)];
        };
        at(TuneParameter::kStiffness) = m.youngs_modulus_pa;
        at(TuneParameter::kDamping) = m.damping_per_s;
        at(TuneParameter::kFriction) = m.friction;
        at(TuneParameter::kFailStretch) = m.fail_stretch;
        for (const sim::ToolSpec& tool : task.scene.tools) {
            if (tool.kind != sim::ToolKind::kNeedle && tool.kind != sim::ToolKind::kHook) continue;
            at(TuneParameter::kCutPower) = tool.cut_power_w;
            at(TuneParameter::kCoagPower) = tool.coag_power_w;
            break;
        }
    }
    now_ = before_;
}

std::string TuningPanel::say(const char* english) const {
    return view::translated(english, setup_.language);
}

double TuningPanel::value(TuneParameter parameter, Tissue tissue) const {
    return now_[static_cast<size_t>(parameter)][static_cast<size_t>(tissue)];
}
double TuningPanel::published(TuneParameter parameter, Tissue tissue) const {
    return before_[static_cast<size_t>(parameter)][static_cast<size_t>(tissue)];
}
double TuningPanel::power_w(TuneParameter parameter) const { return value(parameter, tissue_); }

void TuningPanel::toggle() {
    if (!setup_.allowed) return;
    said_.clear();
    typing_ = warn_ = false;
    shown_ = !shown_;
}

bool TuningPanel::key(sim::Key key) {
    if (!shown()) return false;
    if (typing_) {
        if (key == sim::Key::kEnter) save();
        if (key == sim::Key::kEscape) typing_ = false;
        return true;  // every other key is a letter
    }
    switch (key) {
        case sim::Key::kUp:
            selected_ = (selected_ + kRows - 1) % kRows;
            return true;
        case sim::Key::kDown:
            selected_ = (selected_ + 1) % kRows;
            return true;
        case sim::Key::kLeft:
            change(selected_, -1);
            return true;
        case sim::Key::kRight:
            change(selected_, 1);
            return true;
        case sim::Key::kEnter:
            if (selected_ >= kResetRow) press(selected_);
            return true;
        case sim::Key::kEscape:
            shown_ = false;
            return true;
        default:
            return false;
    }
}

void TuningPanel::click(int item) {
    if (item < 0 || !shown()) return;
    const int row = item / view::kTuningParts, part = item % view::kTuningParts;
    if (row >= kRows) return;
    selected_ = row;
    if (row >= kResetRow)
        press(row);
    else if (part == view::kTuningLess)
        change(row, -1);
    else if (part == view::kTuningMore)
        change(row, 1);
}

void TuningPanel::press(int row) {
    if (row == kResetRow) reset();
    if (row == kSaveRow) {
        typing_ = true;
        name_.clear();
        said_.clear();
    }
}

void TuningPanel::type(const std::string& text) {
    if (!typing_) return;
    for (const char c : text) {
        if (c == '\b') {
            // A whole code point, not a byte of it.
            while (!name_.empty() && (static_cast<unsigned char>(name_.back()) & 0xC0) == 0x80)
                name_.pop_back();
            if (!name_.empty()) name_.pop_back();
        } else if (name_.size() < kLongestName) {
            name_ += c;
        }
    }
}

void TuningPanel::set(TuneParameter parameter, Tissue tissue, double value) {
    const sim::TuneRange& range = sim::tune_range(parameter);
    value = std::clamp(value, range.low, range.high);
    auto& row = now_[static_cast<size_t>(parameter)];
    if (row[static_cast<size_t>(tissue)] == value) return;
    if (sim::tunes_tissue(parameter))
        row[static_cast<size_t>(tissue)] = value;
    else
        row.fill(value);
    tuned_ = true;
    if (setup_.tune) setup_.tune(parameter, tissue, value);
}

void TuningPanel::change(int row, int direction) {
    said_.clear();
    warn_ = false;
    if (row == kTissueRow) {
        const int next =
            (static_cast<int>(tissue_) + direction + sim::kTissueCount) % sim::kTissueCount;
        tissue_ = static_cast<Tissue>(next);
        return;
    }
    if (row < kFirstRow || row >= kResetRow) return;
    const auto parameter = static_cast<TuneParameter>(row - kFirstRow);
    const sim::TuneRange& range = sim::tune_range(parameter);
    const double before = value(parameter, tissue_);
    double after = range.geometric
                       ? before * (direction > 0 ? 1 + range.step : 1 / (1 + range.step))
                       : before + direction * range.step;
    // Back on the published number where the steps would pass close by it.
    const double home = published(parameter, tissue_);
    const double step = range.geometric ? 0.3 * range.step * home : 0.3 * range.step;
    if (std::abs(after - home) < step) after = home;
    set(parameter, tissue_, after);
}

void TuningPanel::reset() {
    for (int p = 0; p < sim::kTuneParameters; ++p) {
        const auto parameter = static_cast<TuneParameter>(p);
        for (int i = 0; i < sim::kTissueCount; ++i)
            set(parameter, static_cast<Tissue>(i), published(parameter, static_cast<Tissue>(i)));
    }
    said_ = say("Everything as the scene says");
    warn_ = false;
}

void TuningPanel::save() {
    typing_ = false;
    curriculum::ScenePreset preset;
    preset.name = name_;
    preset.preset_of = scene_id_;
    preset.author = setup_.author;
    preset.saved_utc =
        setup_.saved_utc.empty() ? curriculum::utc_text(std::time(nullptr)) : setup_.saved_utc;
    for (int i = 0; i < sim::kTissueCount; ++i) {
        const auto tissue = static_cast<Tissue>(i);
        for (int p = 0; sim::tunes_tissue(static_cast<TuneParameter>(p)); ++p) {
            const auto parameter = static_cast<TuneParameter>(p);
            if (value(parameter, tissue) != published(parameter, tissue))
                preset.tissues[tissue][parameter] = value(parameter, tissue);
        }
    }
    for (const auto parameter : {TuneParameter::kCutPower, TuneParameter::kCoagPower}) {
        if (value(parameter, Tissue::kSkin) == published(parameter, Tissue::kSkin)) continue;
        (parameter == TuneParameter::kCutPower ? preset.cut_power_w : preset.coag_power_w) =
            value(parameter, Tissue::kSkin);
    }
    warn_ = true;
    if (preset.tissues.empty() && preset.cut_power_w < 0 && preset.coag_power_w < 0) {
        said_ = say("Nothing was changed: there is nothing to save");
        return;
    }
    try {
        curriculum::save_preset(preset);
        said_ = say("Saved as") + " " + preset.id;
        warn_ = false;
    } catch (const curriculum::DefinitionError& error) {
        said_ = error.what();
    }
}

const view::TuningOverlay& TuningPanel::picture() {
    picture_.shown = shown();
    if (!shown()) return picture_;
    picture_.title = say("Tuning");
    picture_.note = tuned_ ? say("This attempt was tuned: it does not count.")
                           : say("Once something is changed, this attempt does not count.");
    picture_.selected = selected_;
    picture_.rows.assign(kRows, {});
    picture_.rows[kTissueRow] = {say("Tissue"), say(kTissues[static_cast<size_t>(tissue_)])};
    for (int p = 0; p < sim::kTuneParameters; ++p) {
        const auto parameter = static_cast<TuneParameter>(p);
        view::TuningRow& row = picture_.rows[static_cast<size_t>(kFirstRow + p)];
        row.label = say(kLabels[static_cast<size_t>(p)]);
        row.value = tuning_text(parameter, value(parameter, tissue_));
        row.changed = value(parameter, tissue_) != published(parameter, tissue_);
        row.gap_above = parameter == TuneParameter::kCutPower;
    }
    picture_.rows[kResetRow] = {say("Reset"), "", true, false, true};
    picture_.rows[kSaveRow] = {typing_ ? say("Name:") + " " + name_ + "_" : say("Save as preset"),
                               "", true, false, false};
    picture_.warn = warn_;
    picture_.foot = !said_.empty() ? said_
                    : typing_      ? say("Enter saves, Esc does not")
                                   : say("Time stands still. Arrows or mouse tune, F2 goes on.");
    return picture_;
}

}  // namespace placode::ui
