// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/attempt/status_line.h"

#include <nlohmann/json.hpp>

#include "ui/attempt/picture_pace.h"

namespace placode::ui {
namespace {

double monotonic_s() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

nlohmann::ordered_json fields(const curriculum::AttemptStatus& status) {
    return {{"t_s", status.time_s},
            {"phase", std::string(sim::phase_name(status.phase))},
            {"physics_hz", status.physics_hz},
            {"servo_p999_us", status.servo_p999_us},
            {"servo_missed", status.servo_missed},
            {"servo_gaps", status.servo_gaps},
            {"servo_faults", status.servo_faults},
            {"cut_fraction", status.cut_fraction},
            {"substeps", status.substeps},
            {"frame_p99_ms", status.frame_p99_ms},
            {"dropped", status.dropped},
            {"waiting", status.waiting},
            {"real_time", status.real_time},
            {"pictures_hz", status.pictures_hz},
            {"too_slow", PicturePace::will_not_count(status)},
            {"warning", status.warning}};
}

std::string line_of(const nlohmann::ordered_json& object) {
    // A damaged message must not end the attempt: invalid UTF-8 is replaced.
    return object.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

}  // namespace

std::string reason_text(sim::EndReason reason) {
    switch (reason) {
        case sim::EndReason::kRunning:
            return "running";
        case sim::EndReason::kFinished:
            return "finished";
        case sim::EndReason::kTimeLimit:
            return "time_limit";
        case sim::EndReason::kClosed:
            return "closed";
        case sim::EndReason::kInterrupted:
            return "interrupted";
    }
    return "unknown";
}

StatusLine::StatusLine(bool enabled, int stream) {
    if (enabled) output_.emplace(stream);
}

void StatusLine::print(const curriculum::AttemptStatus& status, bool now) {
    if (!output_) return;
    const double t = monotonic_s();
    if (!now && last_s_ >= 0 && t - last_s_ < 0.1) return;
    last_s_ = t;
    nlohmann::ordered_json object = fields(status);
    if (replay_) {
        object["paused"] = replay_->paused;
        object["speed"] = replay_->speed;
        object["pace"] = replay_->pace;
        object["target_s"] = replay_->target_s;
        object["camera"] = replay_->camera;
        if (!replay_->problem.empty()) object["problem"] = replay_->problem;
    }
    output_->send(line_of(object));
}

void StatusLine::end(const curriculum::AttemptStatus& status, const std::string& reason,
                     const std::string& recording, const std::string& detail,
                     const std::string& haptics) {
    if (!output_) return;
    nlohmann::ordered_json object = fields(status);
    object["end"] = reason;
    object["recording"] =
        recording.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(recording);
    object["recorded"] = !recording.empty() && status.warning.empty();
    if (!detail.empty()) object["detail"] = detail;
    if (!haptics.empty()) {
        const auto certificate = nlohmann::ordered_json::parse(haptics, nullptr, false);
        if (!certificate.is_discarded()) object["haptics"] = certificate;
    }
    output_->send(line_of(object), kPatience);
}

}  // namespace placode::ui
