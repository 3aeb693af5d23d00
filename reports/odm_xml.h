// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The elements of an ODM document as they are written. Private to reports.

#include <QString>
#include <QXmlStreamWriter>
#include <string>

#include "reports/dataset.h"

namespace placode::reports {

inline constexpr const char* kOdmEvent = "SE.STUDY";

[[nodiscard]] inline QString odm_text(const std::string& value) {
    return QString::fromStdString(value);
}
[[nodiscard]] inline QString study_oid(const Dataset& data) {
    return "S." + odm_text(plain_name(data.id));
}
[[nodiscard]] inline QString version_oid(const Dataset& data) {
    return QString("MDV.%1").arg(data.version);
}

class OdmXml {
 public:
    explicit OdmXml(QByteArray* bytes) : xml_(bytes) {
        xml_.setAutoFormatting(true);
        xml_.setAutoFormattingIndent(1);
    }

    void begin_document() {
        xml_.writeStartDocument();
        xml_.writeDefaultNamespace(kNamespace);
        start("ODM");
    }
    void end_document() {
        end();
        xml_.writeEndDocument();
    }
    void attribute(const char* name, const QString& value) { xml_.writeAttribute(name, value); }
    void start(const char* name) { xml_.writeStartElement(kNamespace, name); }
    void end() { xml_.writeEndElement(); }
    void element(const char* name, const QString& value) {
        xml_.writeTextElement(kNamespace, name, value);
    }
    void translated(const char* name, const QString& value) {
        start(name);
        element("TranslatedText", value);
        end();
    }
    void characters(const QString& text) { xml_.writeCharacters(text); }

 private:
    static constexpr const char* kNamespace = "http://www.cdisc.org/ns/odm/v1.3";
    QXmlStreamWriter xml_;
};

/// odm_clinical_data.cpp
void write_clinical_data(OdmXml& xml, const Dataset& data);

}  // namespace placode::reports
