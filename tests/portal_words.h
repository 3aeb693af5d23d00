// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The portal's part of the translation files, as they stand in the source.

#include <QFile>
#include <QString>
#include <QXmlStreamReader>
#include <string>
#include <vector>

namespace placode::test {

/// A text of the portal with its forms in a language: one, or those of a counted noun.
struct PortalWords {
    std::string english;             ///< As it stands in the source.
    std::vector<std::string> forms;  ///< Finished ones.
    bool counted = false;
};

/// The context Web of ui/shell/translations/placode_LANGUAGE.ts.
inline std::vector<PortalWords> portal_words(const std::string& language) {
    QFile file(QString::fromStdString(PLACODE_SOURCE_DIR "/ui/shell/translations/placode_" +
                                      language + ".ts"));
    std::vector<PortalWords> all;
    if (!file.open(QIODevice::ReadOnly)) return all;
    QXmlStreamReader xml(&file);
    const auto text = [&xml] { return xml.readElementText().toStdString(); };
    for (std::string context; !xml.atEnd();) {
        xml.readNext();
        if (!xml.isStartElement()) continue;
        if (xml.name() == QLatin1String("name")) context = text();
        if (context != "Web") continue;
        if (xml.name() == QLatin1String("message"))
            all.push_back({{}, {}, xml.attributes().value("numerus") == QLatin1String("yes")});
        if (xml.name() == QLatin1String("source")) all.back().english = text();
        if (xml.name() != QLatin1String("translation")) continue;
        if (xml.attributes().hasAttribute("type")) continue;  // unfinished, or of no use any more
        if (!all.back().counted) all.back().forms.push_back(text());
        while (all.back().counted && xml.readNextStartElement()) all.back().forms.push_back(text());
    }
    return all;
}

}  // namespace placode::test
