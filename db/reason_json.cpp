// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/reason_json.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <charconv>
#include <system_error>

#include "db/store_error.h"
#include "sim/core/number_text.h"

namespace placode::db {
namespace {

[[noreturn]] void damaged_reason(const std::string& what) {
    throw StoreError(StoreError::Kind::kDamaged,
                     "reason: " + what + "; restore a backup (placodectl restore)");
}

double number(const std::string& text) {
    double value = 0;
    const auto done = std::from_chars(text.data(), text.data() + text.size(), value);
    if (done.ec != std::errc() || done.ptr != text.data() + text.size())
        damaged_reason("\"" + text + "\" is no number");
    return value;
}

QString qstring(const std::string& text) { return QString::fromStdString(text); }

}  // namespace

std::string reason_json(const assessment::ReasonMeaning& meaning) {
    if (meaning.pattern.empty()) return {};
    QJsonObject pattern{{"en", qstring(meaning.pattern)}};
    if (!meaning.pattern_pl.empty()) pattern["pl"] = qstring(meaning.pattern_pl);
    QJsonObject json{{"pattern", pattern},
                     {"metric", qstring(meaning.metric)},
                     {"value", qstring(sim::shortest_text(meaning.value))},
                     {"count", meaning.count},
                     {"hour", meaning.hour}};
    if (meaning.between.any()) {
        json["between"] = QJsonArray{meaning.between.before, meaning.between.after};
        if (meaning.between.upright) json["upright"] = true;
    }
    return QJsonDocument(json).toJson(QJsonDocument::Compact).toStdString();
}

assessment::ReasonMeaning reason_from_json(const std::string& text) {
    assessment::ReasonMeaning meaning;
    if (text.empty()) return meaning;
    const QJsonDocument document = QJsonDocument::fromJson(QByteArray::fromStdString(text));
    if (!document.isObject()) damaged_reason("\"" + text + "\" is no JSON object");
    const QJsonObject json = document.object();
    const QJsonObject pattern = json["pattern"].toObject();
    meaning.pattern = pattern["en"].toString().toStdString();
    if (meaning.pattern.empty()) damaged_reason("it has no pattern");
    meaning.pattern_pl = pattern["pl"].toString().toStdString();
    meaning.metric = json["metric"].toString().toStdString();
    meaning.value = number(json["value"].toString().toStdString());
    meaning.count = json["count"].toInt();
    meaning.hour = json["hour"].toInt();
    const QJsonArray between = json["between"].toArray();
    meaning.between = {std::max(0, between.at(0).toInt()), std::max(0, between.at(1).toInt()),
                       json["upright"].toBool()};
    return meaning;
}

}  // namespace placode::db
