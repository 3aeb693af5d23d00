// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Header and end of a recording as JSON. Qt writes the shortest text that gives the same double.

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <charconv>

#include "curriculum/conduct.h"
#include "db/recording_chunks.h"
#include "db/store_error.h"

namespace placode::db {
namespace {

[[noreturn]] void damaged(const std::string& key, const std::string& expected) {
    throw StoreError(StoreError::Kind::kDamaged, "header: \"" + key + "\" is not " + expected);
}

QString text_of(const std::string& text) { return QString::fromStdString(text); }

QJsonArray array_of(const sim::Vec3& point) { return {point[0], point[1], point[2]}; }

QJsonArray array_of(const std::vector<sim::Vec3>& line) {
    QJsonArray array;
    for (const sim::Vec3& point : line) array.append(array_of(point));
    return array;
}

// Typed access that names the key.
class Reader {
 public:
    explicit Reader(QJsonObject object) : object_(std::move(object)) {}
    [[nodiscard]] double number(const char* key) const {
        const QJsonValue value = object_[QLatin1String(key)];
        if (!value.isDouble()) damaged(key, "a number");
        return value.toDouble();
    }
    /// A number that older files do not have.
    [[nodiscard]] double number(const char* key, double otherwise) const {
        return object_.contains(QLatin1String(key)) ? number(key) : otherwise;
    }
    [[nodiscard]] int64_t whole(const char* key) const {
        const QJsonValue value = object_[QLatin1String(key)];
        if (!value.isDouble()) damaged(key, "a whole number");
        return value.toInteger();
    }
    [[nodiscard]] bool truth(const char* key) const {
        const QJsonValue value = object_[QLatin1String(key)];
        if (!value.isBool()) damaged(key, "true or false");
        return value.toBool();
    }
    [[nodiscard]] std::string text(const char* key) const {
        const QJsonValue value = object_[QLatin1String(key)];
        if (!value.isString()) damaged(key, "text");
        return value.toString().toStdString();
    }
    /// Text that older files do not have.
    [[nodiscard]] std::string text(const char* key, const char* otherwise) const {
        return object_.contains(QLatin1String(key)) ? text(key) : otherwise;
    }
    [[nodiscard]] uint64_t big(const char* key) const {
        const std::string digits = text(key);
        uint64_t value = 0;
        const auto [end, error] =
            std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (error != std::errc{} || end != digits.data() + digits.size())
            damaged(key, "an unsigned 64-bit number in quotes");
        return value;
    }
    [[nodiscard]] QJsonArray array(const char* key) const {
        const QJsonValue value = object_[QLatin1String(key)];
        if (!value.isArray()) damaged(key, "a list");
        return value.toArray();
    }
    [[nodiscard]] bool has(const char* key) const { return object_.contains(QLatin1String(key)); }
    [[nodiscard]] Reader object(const char* key) const {
        const QJsonValue value = object_[QLatin1String(key)];
        if (!value.isObject()) damaged(key, "an object");
        return Reader(value.toObject());
    }
    [[nodiscard]] sim::Vec3 point(const char* key) const { return point_of(array(key), key); }
    [[nodiscard]] std::vector<sim::Vec3> line(const char* key) const {
        std::vector<sim::Vec3> line;
        for (const QJsonValue& value : array(key)) line.push_back(point_of(value.toArray(), key));
        return line;
    }

 private:
    static sim::Vec3 point_of(const QJsonArray& array, const char* key) {
        if (array.size() != 3) damaged(key, "made of points with three numbers");
        return {array[0].toDouble(), array[1].toDouble(), array[2].toDouble()};
    }

    QJsonObject object_;
};

QJsonObject tool_to_json(const sim::ToolSpec& tool) {
    QJsonObject json{{"kind", static_cast<int>(tool.kind)},
                     {"hand", static_cast<int>(tool.hand)},
                     {"pivot_m", array_of(tool.pivot_m)},
                     {"shaft_radius_m", tool.shaft_radius_m},
                     {"length_m", tool.length_m},
                     {"tip_radius_m", tool.tip_radius_m},
                     {"tip_length_m", tool.tip_length_m},
                     {"scope_angle_deg", tool.scope_angle_deg},
                     {"field_of_view_deg", tool.field_of_view_deg},
                     {"cut_power_w", tool.cut_power_w},
                     {"coag_power_w", tool.coag_power_w},
                     {"efficiency", tool.efficiency},
                     {"grip_n_m", tool.hand_n_m},
                     {"jaw_open_rad", tool.jaw_open_rad},
                     {"jaw_width_m", tool.jaw_width_m},
                     {"jaw_grip_m", tool.jaw_touch_m},
                     {"jaw_force_n", tool.jaw_force_n},
                     {"jaw_friction", tool.jaw_friction}};
    if (tool.kind == sim::ToolKind::kScope) {
        json["look_at_m"] = array_of(tool.look_at_m);
        json["look_from_m"] = tool.look_from_m;
    }
    return json;
}

sim::ToolSpec tool_from_json(const Reader& json) {
    sim::ToolSpec tool;
    const int64_t kind = json.whole("kind");
    const int64_t hand = json.whole("hand");
    if (kind < 0 || kind >= sim::kToolKinds) damaged("kind", "a known tool");
    if (hand < 0 || hand > static_cast<int>(sim::Hand::kCamera)) damaged("hand", "a known hand");
    tool.kind = static_cast<sim::ToolKind>(kind);
    tool.hand = static_cast<sim::Hand>(hand);
    tool.pivot_m = json.point("pivot_m");
    tool.shaft_radius_m = json.number("shaft_radius_m");
    tool.length_m = json.number("length_m");
    tool.tip_radius_m = json.number("tip_radius_m");
    tool.tip_length_m = json.number("tip_length_m");
    tool.scope_angle_deg = json.number("scope_angle_deg");
    tool.field_of_view_deg = json.number("field_of_view_deg");
    tool.cut_power_w = json.number("cut_power_w");
    tool.coag_power_w = json.number("coag_power_w");
    tool.efficiency = json.number("efficiency");
    tool.hand_n_m = json.number("grip_n_m");
    tool.jaw_open_rad = json.number("jaw_open_rad", tool.jaw_open_rad);  // since format 2
    tool.jaw_width_m = json.number("jaw_width_m", tool.jaw_width_m);
    tool.jaw_touch_m = json.number("jaw_grip_m", tool.jaw_touch_m);
    tool.jaw_force_n = json.number("jaw_force_n", tool.jaw_force_n);
    tool.jaw_friction = json.number("jaw_friction", tool.jaw_friction);
    // Older scopes looked at the lesion.
    if (json.has("look_at_m")) tool.look_at_m = json.point("look_at_m");
    tool.look_from_m = json.number("look_from_m", tool.look_from_m);
    return tool;
}

/// Since format 3, of an attempt that began at a stage.
void read_given(const Reader& json, sim::RecordingHeader& header) {
    const int64_t stage = json.whole("stage"), frames = json.whole("frames");
    if (stage < 1 || stage > sim::kMostStages)
        damaged("stage", "1 to " + std::to_string(sim::kMostStages));
    if (frames < 1 || frames > kMostGivenFrames)
        damaged("frames", "1 to " + std::to_string(kMostGivenFrames));
    header.stage = static_cast<int>(stage);
    header.given_frames = frames;
    header.given_hash = json.big("hash");
}

Reader parse(const std::string& json) {
    const QJsonDocument document = QJsonDocument::fromJson(QByteArray::fromStdString(json));
    if (!document.isObject())
        throw StoreError(StoreError::Kind::kDamaged, "header: not a JSON object");
    return Reader(document.object());
}

std::string compact(const QJsonObject& object) {
    return QJsonDocument(object).toJson(QJsonDocument::Compact).toStdString();
}

}  // namespace

std::string header_to_json(const sim::RecordingHeader& header) {
    QJsonArray tools;
    for (const sim::ToolSpec& tool : header.tools) tools.append(tool_to_json(tool));
    const sim::FieldGeometry& geometry = header.geometry;
    QJsonObject json(
        {{"format", header.format},
         {"task_id", text_of(header.task_id)},
         {"task_version", header.task_version},
         {"task_json", text_of(header.task_json)},
         {"seed", QString::number(header.seed)},
         {"build", text_of(header.build)},
         {"device", text_of(header.device)},
         {"started_utc", text_of(header.started_utc)},
         {"demonstration", header.demonstration},
         {"mode", text_of(header.mode)},
         {"frame_s", header.frame_s},
         {"sample_s", header.sample_s},
         {"tools", tools},
         {"geometry", QJsonObject{{"planned_contour_m", array_of(geometry.planned_contour)},
                                  {"placode_edge_m", array_of(geometry.placode_edge)},
                                  {"skin_edge_m", array_of(geometry.skin_edge)},
                                  {"target_depth_m", geometry.target_depth_m},
                                  {"placode_volume_m3", geometry.placode_volume_m3}}}});
    if (header.stage != 0)
        json["given"] = QJsonObject{{"stage", header.stage},
                                    {"frames", static_cast<qint64>(header.given_frames)},
                                    {"hash", QString::number(header.given_hash)}};
    return compact(json);
}

sim::RecordingHeader header_from_json(const std::string& text) {
    const Reader json = parse(text);
    sim::RecordingHeader header;
    header.format = static_cast<int>(json.whole("format"));
    header.task_id = json.text("task_id");
    header.task_version = static_cast<int>(json.whole("task_version"));
    header.task_json = json.text("task_json");
    header.seed = json.big("seed");
    header.build = json.text("build");
    header.device = json.text("device");
    header.started_utc = json.text("started_utc");
    header.demonstration = json.truth("demonstration");
    header.mode = json.text("mode", "practice");  // since exams and studies are told apart
    if (!curriculum::mode_named(header.mode)) damaged("mode", "practice, exam or study");
    header.frame_s = json.number("frame_s");
    header.sample_s = json.number("sample_s");
    const QJsonArray tools = json.array("tools");
    if (tools.size() > sim::kMaxTools)
        damaged("tools", "a list of at most " + std::to_string(sim::kMaxTools));
    for (const QJsonValue& tool : tools)
        header.tools.push_back(tool_from_json(Reader(tool.toObject())));
    const Reader geometry = json.object("geometry");
    header.geometry.planned_contour = geometry.line("planned_contour_m");
    header.geometry.placode_edge = geometry.line("placode_edge_m");
    header.geometry.skin_edge = geometry.line("skin_edge_m");
    header.geometry.target_depth_m = geometry.number("target_depth_m");
    header.geometry.placode_volume_m3 = geometry.number("placode_volume_m3");
    if (json.has("given")) read_given(json.object("given"), header);
    return header;
}

std::string end_to_json(const sim::RecordingEnd& end) {
    return compact({{"reason", static_cast<int>(end.reason)},
                    {"duration_s", end.duration_s},
                    {"final_hash", QString::number(end.final_hash)},
                    {"dropped", static_cast<qint64>(end.dropped)}});
}

sim::RecordingEnd end_from_json(const std::string& text) {
    const Reader json = parse(text);
    const int64_t reason = json.whole("reason");
    if (reason < 0 || reason > static_cast<int>(sim::EndReason::kInterrupted))
        damaged("reason", "a known reason");
    return {static_cast<sim::EndReason>(reason), json.number("duration_s"), json.big("final_hash"),
            json.whole("dropped")};
}

}  // namespace placode::db
