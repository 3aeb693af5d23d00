// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/said_json.h"

#include <QJsonArray>

namespace placode::db {

QJsonObject said_json(const Said& said) {
    const auto text = [](const std::string& words) { return QString::fromStdString(words); };
    QJsonObject json;
    if (said.sentence() == nullptr) {
        const std::string &words = said.words_in("en"), &polish = said.words_in("pl");
        if (!words.empty()) json["text"] = text(words);
        if (polish != words) json["pl"] = text(polish);
        return json;
    }
    json["says"] = text(said.sentence());
    QJsonArray parts;
    for (const Said& part : said.parts()) parts.append(said_json(part));
    if (!parts.isEmpty()) json["with"] = parts;
    return json;
}

Said said_of_json(const QJsonObject& json) {
    const auto text = [&](const char* key) {
        return json[QLatin1String(key)].toString().toStdString();
    };
    if (!json.contains("says")) return Said::as_is(text("text"), text("pl"));
    Said said = Said::listed(text("says"));
    for (const QJsonValue& part : json["with"].toArray())
        said = said.with(said_of_json(part.toObject()));
    return said;
}

}  // namespace placode::db
