// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What reasons mean, as the store keeps it beside their English.

#include <QJsonArray>
#include <QJsonDocument>
#include <algorithm>
#include <array>
#include <optional>

#include "db/said_json.h"
#include "db/void_reason.h"

namespace placode::db {
namespace {

/// In the order of VoidCause. A name that a store holds is never given another meaning.
constexpr std::array kCauses{"few_pictures",   "not_real_time",  "tuned",         "given",
                             "device",         "task_unknown",   "task_differs",  "unsound",
                             "same_recording", "replay_differs", "script",        "unsigned",
                             "no_recording",   "order_differs",  "order_missing", "proctor",
                             "exam_closed",    "clock",          "task_version"};
static_assert(kCauses.size() == static_cast<size_t>(VoidCause::kTaskVersion) + 1);

std::string text_of(const QJsonDocument& json) {
    return json.toJson(QJsonDocument::Compact).toStdString();
}

QJsonDocument parsed(const std::string& json) {
    return QJsonDocument::fromJson(QByteArray::fromStdString(json));
}

QJsonArray to_json(const std::vector<VoidReason>& reasons) {
    QJsonArray list;
    for (const VoidReason& reason : reasons) {
        QJsonObject one{{"cause", kCauses[static_cast<size_t>(reason.cause)]}};
        if (reason.found != 0 || reason.needed != 0) {
            one["found"] = reason.found;
            one["needed"] = reason.needed;
        }
        if (const QJsonObject detail = said_json(reason.detail); !detail.isEmpty())
            one["detail"] = detail;
        list.append(one);
    }
    return list;
}

std::optional<std::vector<VoidReason>> of_json(const QJsonArray& list) {
    std::vector<VoidReason> reasons;
    for (const QJsonValue& each : list) {
        const QJsonObject one = each.toObject();
        const auto* const cause =
            std::find(kCauses.begin(), kCauses.end(), one["cause"].toString().toStdString());
        if (cause == kCauses.end()) return std::nullopt;
        reasons.push_back({static_cast<VoidCause>(cause - kCauses.begin()), one["found"].toInt(),
                           one["needed"].toInt(), said_of_json(one["detail"].toObject())});
    }
    return reasons;
}

}  // namespace

std::string void_meaning(const std::vector<VoidReason>& reasons) {
    return reasons.empty() ? std::string() : text_of(QJsonDocument(to_json(reasons)));
}

std::vector<VoidReason> void_reasons(std::string_view text, const std::string& meaning) {
    if (!meaning.empty())
        if (auto reasons = of_json(parsed(meaning).array()); reasons && void_text(*reasons) == text)
            return std::move(*reasons);
    return void_reasons(text);
}

std::string not_done_meaning(const NotDone& why) {
    if (why == NotDone{}) return {};
    QJsonObject json;
    if (why.interrupted) json["interrupted"] = true;
    if (why.least_s > 0) {
        json["ended_s"] = why.ended_s;
        json["least_s"] = why.least_s;
    }
    if (!why.note.empty()) json["note"] = QString::fromStdString(why.note);
    if (!why.voids.empty()) json["void"] = to_json(why.voids);
    return text_of(QJsonDocument(json));
}

NotDone not_done(std::string_view text, const std::string& meaning) {
    const QJsonObject json = meaning.empty() ? QJsonObject() : parsed(meaning).object();
    if (auto voids = of_json(json["void"].toArray()); voids && !json.isEmpty()) {
        NotDone why;
        why.interrupted = json["interrupted"].toBool();
        why.ended_s = json["ended_s"].toInt();
        why.least_s = json["least_s"].toInt();
        why.note = json["note"].toString().toStdString();
        why.voids = std::move(*voids);
        if (not_done_text(why) == text) return why;
    }
    return not_done(text);
}

}  // namespace placode::db
