// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// CDISC ODM 1.3.2: writes the document of a study (reports/odm_document.h), reads it back and
// compares it with the data set.

#include <QXmlStreamReader>

#include "reports/formats.h"
#include "reports/odm_document.h"
#include "reports/odm_items.h"
#include "reports/report.h"

namespace placode::reports {
namespace {

std::string path_of(const std::string& folder, const Dataset& data) {
    return folder + "/" + file_name(data.id) + "_odm.xml";
}

void take(Cells& cells, const OdmItem& item, const Row& row,
          const QXmlStreamAttributes& attributes) {
    const std::string key = cell_key(*item.form, row, *item.field);
    const std::string value = attributes.value("Value").toString().toStdString();
    if (attributes.value("IsNull") == QLatin1String("Yes")) {
        cells[key] = curriculum::kNotApplicable;
    } else if (item.choice < 0) {
        const bool missing = item.coded() && item.field->not_applicable &&
                             value == std::to_string(item.field->not_applicable_code());
        cells[key] = missing ? curriculum::kNotApplicable : value;
    } else if (value == "1") {
        std::string& list = cells[key];
        if (item.field->not_applicable && item.choice == item.field->not_applicable_code())
            list = curriculum::kNotApplicable;
        else
            list += (list.empty() ? "" : ";") + std::to_string(item.choice);
    }
}

Cells read_cells(const Dataset& data, const std::string& path) {
    std::map<QString, OdmItem> items;
    for (const Form& form : data.forms)
        for (const OdmItem& item : odm_items(form)) items.emplace(item.oid(), item);
    Cells cells;
    Row row;
    QXmlStreamReader xml(QByteArray::fromStdString(read_file(path)));
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) continue;
        const auto attributes = xml.attributes();
        if (xml.name() == QLatin1String("SubjectData"))
            row.participant = attributes.value("SubjectKey").toString().toStdString();
        if (xml.name() == QLatin1String("FormData"))
            row.instance = attributes.hasAttribute("FormRepeatKey")
                               ? attributes.value("FormRepeatKey").toInt()
                               : 1;
        if (xml.name() != QLatin1String("ItemData")) continue;
        const auto found = items.find(attributes.value("ItemOID").toString());
        if (found == items.end())
            throw ReportError("export odm: read back, " + path +
                              " holds an item without a "
                              "definition: " +
                              attributes.value("ItemOID").toString().toStdString());
        take(cells, found->second, row, attributes);
    }
    if (xml.hasError())
        throw ReportError("export odm: read back, " + path + ": " +
                          xml.errorString().toStdString());
    return cells;
}

}  // namespace

void write_odm(const ExportSource& source, const std::string& folder) {
    save_file(path_of(folder, source.data), odm_document(source.data).toStdString());
}

void verify_odm(const ExportSource& source, const std::string& folder) {
    compare_cells(cells_of(source.data), read_cells(source.data, path_of(folder, source.data)),
                  "export odm");
}

}  // namespace placode::reports
