// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// By what name other programs know a data set and its things.

#include <QUrl>
#include <QUuid>

#include "reports/dataset_forms.h"
#include "reports/report.h"

namespace placode::reports {

std::string identity_of(db::Store& store) {
    static const QUuid space(QStringLiteral("{c4a0bb0e-52a6-5f2d-8d11-7c3a9e0f4b21}"));
    std::string first;
    if (const auto made = store.audit().first())
        for (const std::string& part : {made->at_utc, made->actor, made->action, made->object})
            first += part + "|";
    return QUuid::createUuidV5(space, QString::fromStdString(first))
        .toString(QUuid::WithoutBraces)
        .toStdString();
}

std::string address_of(const Dataset& data, const std::string& thing) {
    if (!data.base_uri.empty()) return data.base_uri + "/" + thing;
    const QUuid space = QUuid::fromString(QString::fromStdString(data.origin));
    return "urn:uuid:" + QUuid::createUuidV5(space, QString::fromStdString(thing))
                             .toString(QUuid::WithoutBraces)
                             .toStdString();
}

std::string checked_base_uri(const std::string& text) {
    if (text.empty()) return {};
    const QUrl url(QString::fromStdString(text), QUrl::StrictMode);
    const bool web =
        url.scheme() == QLatin1String("https") || url.scheme() == QLatin1String("http");
    if (!url.isValid() || !web || url.host().isEmpty() || url.hasQuery() || url.hasFragment())
        throw ReportError("found \"" + text +
                          "\"; expected an address that the centre owns, such as "
                          "https://fhir.hospital.org/placode");
    std::string base = text;
    while (base.ends_with('/')) base.pop_back();
    return base;
}

}  // namespace placode::reports
