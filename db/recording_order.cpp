// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/recording_order.h"

#include <sqlite3.h>

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>

#include "db/packing.h"
#include "db/recording_chunks.h"

namespace placode::db {

std::optional<BesideRecording> order_beside(const std::string& recording_file) {
    QFile file(QString::fromStdString(order_file(recording_file)));
    if (!file.open(QIODevice::ReadOnly)) return std::nullopt;
    const QByteArray text = file.readAll();
    const QJsonObject json = QJsonDocument::fromJson(text).object();
    return BesideRecording{json["user_id"].toInteger(), json["study"].toString().toStdString(),
                           json["participant"].toString().toStdString(), text.toStdString()};
}

std::string order_checksum(const std::string& order) {
    return checksum_hex("placode order 1\n" + order);
}

bool is_order_checksum(const std::string& text) {
    constexpr size_t kDigits = 64;
    return text.size() == kDigits && std::all_of(text.begin(), text.end(), [](char c) {
               return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
           });
}

std::string recorded_order(const std::string& recording_file) {
    static const std::string kReadOrder = "read what the recording was begun for";
    const ForeignDatabase database = open_recording(recording_file, kReadOrder);
    RawStatement query(database.get(), "SELECT value FROM meta WHERE key = ?");
    int code = query.prepared();
    if (code == SQLITE_OK) code = query.bind(kOrderKey).step();
    if (code == SQLITE_DONE) return {};
    if (code != SQLITE_ROW)
        fail_sqlite(code, kReadOrder, recording_file, "the file may be damaged");
    return query.text(0);
}

std::optional<VoidCause> order_doubt(const std::string& recording_file, const std::string& order,
                                     bool matters) {
    const std::string begun = recorded_order(recording_file);
    if (order.empty() || begun.empty())
        return matters ? std::optional(VoidCause::kOrderMissing) : std::nullopt;
    if (begun != order_checksum(order)) return VoidCause::kOrderDiffers;
    return std::nullopt;
}

}  // namespace placode::db
