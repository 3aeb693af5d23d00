// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/review_track.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "curriculum/replay.h"
#include "reports/review_part.h"
#include "sim/core/shared_hand.h"
#include "sim/core/tool_kind_name.h"

namespace placode::reports {
namespace {

constexpr int kAsksEveryPictures = 3;

QJsonArray tools_of(const std::vector<sim::ToolSpec>& tools) {
    QJsonArray list;
    for (const sim::ToolSpec& spec : tools)
        list.append(QJsonObject{{"kind", sim::tool_kind_name(spec.kind)},
                                {"shares_hand", sim::shares_hand(tools, spec)},
                                {"shaft_radius_m", spec.shaft_radius_m},
                                {"length_m", spec.length_m},
                                {"tip_radius_m", spec.tip_radius_m},
                                {"tip_length_m", spec.tip_length_m},
                                {"jaw_width_m", spec.jaw_width_m},
                                {"scope_angle_deg", spec.scope_angle_deg},
                                {"field_of_view_deg", spec.field_of_view_deg}});
    return list;
}

QJsonArray tissues_of(const sim::Scene& scene) {
    QJsonArray list;
    for (const auto& [red, green, blue] : scene.colour_linear)
        list.append(QJsonArray{static_cast<double>(red), static_cast<double>(green),
                               static_cast<double>(blue)});
    return list;
}

QJsonValue needle_of(const sim::Scene& scene) {
    if (!scene.suture) return QJsonValue::Null;
    const sim::NeedleSpec& spec = scene.suture->needle().spec();
    return QJsonObject{{"arc_m", spec.arc_m}, {"wire_radius_m", spec.wire_radius_m}};
}

std::string head_of(const sim::Scene& scene, const ReviewTrack& track, int pictures) {
    const QJsonObject head{{"version", static_cast<int>(kReviewPartVersion)},
                           {"pictures", pictures},
                           {"pictures_per_s", kReviewPicturesPerS},
                           {"pictures_of_part", kReviewPicturesOfPart},
                           {"parts", static_cast<int>(track.parts.size())},
                           {"until_s", track.until_s},
                           {"identical", track.identical},
                           {"step_m", kReviewStepM},
                           {"least_m", kReviewLeastM},
                           {"tissues_linear_rgb", tissues_of(scene)},
                           {"tools", tools_of(scene.tools)},
                           {"needle", needle_of(scene)}};
    return QJsonDocument(head).toJson(QJsonDocument::Compact).toStdString();
}

}  // namespace

size_t ReviewTrack::bytes() const {
    return std::accumulate(parts.begin(), parts.end(), head.size(),
                           [](size_t sum, const std::string& part) { return sum + part.size(); });
}

std::optional<ReviewTrack> make_review_track(const sim::Recording& recording,
                                             const std::function<bool(double)>& go_on) {
    curriculum::Replay replay(recording, 1);
    const double all = static_cast<double>(std::max<size_t>(1, recording.inputs.size()));
    const double frame_s = replay.scene().body.spec().solver.frame_s;
    ReviewTrack track;
    ReviewPart part;
    sim::Snapshot moment;
    int pictures = 0;
    const auto close_part = [&] {
        if (part.pictures() > 0) track.parts.push_back(part.encoded());
        part = ReviewPart();
    };
    const auto take = [&] {
        sim::fill_snapshot(replay.scene(), replay.state(), moment);
        part.add(moment);
        track.until_s = moment.time_s;
        ++pictures;
        if (part.pictures() == kReviewPicturesOfPart) close_part();
    };
    // Before the first input the instruments have no place: the first picture is of frame 1.
    while (replay.step()) {
        const auto frame = replay.state().frame;
        const auto due = 1 + std::llround(pictures / (kReviewPicturesPerS * frame_s));
        if (frame < due) continue;
        take();
        if (pictures % kAsksEveryPictures == 0 && go_on && !go_on(static_cast<double>(frame) / all))
            return std::nullopt;
    }
    close_part();
    track.identical = replay.result().identical;
    track.head = head_of(replay.scene(), track, pictures);
    return track;
}

}  // namespace placode::reports
