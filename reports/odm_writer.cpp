// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// CDISC ODM 1.3.2: metadata and clinical data of the whole study in one file. The order of the
// elements is that of the official schema.

#include <QXmlStreamReader>
#include <QXmlStreamWriter>
#include <array>

#include "reports/formats.h"
#include "reports/report.h"
#include "reports/text.h"

namespace placode::reports {
namespace {

constexpr const char* kNamespace = "http://www.cdisc.org/ns/odm/v1.3";
constexpr const char* kEvent = "SE.STUDY";

QString text(const std::string& value) { return QString::fromStdString(value); }

/// One ItemDef. A field with several choices becomes one item a choice.
struct Item {
    const Form* form;
    const Field* field;
    int choice;  ///< -1 = the field itself.
    [[nodiscard]] QString oid() const {
        QString id = QString("I.%1.%2").arg(text(form->name), text(field->id));
        if (choice >= 0) id += "." + QString::number(choice);
        return id;
    }
    [[nodiscard]] bool coded() const { return field->kind == FieldKind::kCode; }
    [[nodiscard]] QString code_list() const {
        return choice >= 0 ? QString("CL.CHOSEN")
                           : QString("CL.%1.%2").arg(text(form->name), text(field->id));
    }
};

std::vector<Item> items_of(const Form& form) {
    std::vector<Item> items;
    for (const Field& field : form.fields) {
        if (field.kind != FieldKind::kMultiple) {
            items.push_back({&form, &field, -1});
            continue;
        }
        for (const Code& code : field.codes) items.push_back({&form, &field, code.value});
        if (field.not_applicable) items.push_back({&form, &field, field.not_applicable_code()});
    }
    return items;
}

const char* type_of(const Item& item) {
    if (item.choice >= 0 || item.coded()) return "integer";
    if (item.field->kind == FieldKind::kDecimal) return "float";
    return item.field->kind == FieldKind::kDate ? "date" : "text";
}

/// Longest value, because ODM wants to know.
QString length_of(const Item& item) {
    size_t length = 1;
    for (const Code& code : item.field->codes)
        length = std::max(length, std::to_string(code.value).size());
    if (item.coded() && item.field->not_applicable)
        length = std::max(length, std::to_string(item.field->not_applicable_code()).size());
    if (item.choice >= 0) return "1";
    for (const Row& row : item.form->rows)
        if (const auto found = row.values.find(item.field->id); found != row.values.end())
            length = std::max(length, found->second.size());
    return QString::number(length);
}

class Document {
 public:
    Document(const Dataset& data, QByteArray* bytes) : data_(data), xml_(bytes) {
        xml_.setAutoFormatting(true);
        xml_.setAutoFormattingIndent(1);
    }

    void write() {
        xml_.writeStartDocument();
        xml_.writeDefaultNamespace(kNamespace);
        xml_.writeStartElement(kNamespace, "ODM");
        attribute("ODMVersion", "1.3.2");
        attribute("FileType", "Snapshot");
        attribute("FileOID", text("placode." + data_.id + "." + data_.created_utc));
        attribute("CreationDateTime", text(data_.created_utc));
        attribute("SourceSystem", "Placode");
        attribute("SourceSystemVersion", text(data_.software));
        if (data_.demonstration) attribute("Description", "DEMONSTRATION: holds simulated data");
        study();
        clinical_data();
        xml_.writeEndElement();
        xml_.writeEndDocument();
    }

 private:
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
    [[nodiscard]] QString study_oid() const { return "S." + text(plain_name(data_.id)); }
    [[nodiscard]] QString version_oid() const { return QString("MDV.%1").arg(data_.version); }
    static QString unit_oid(const std::string& unit) { return "MU." + text(plain_name(unit)); }

    void study() {
        start("Study");
        attribute("OID", study_oid());
        start("GlobalVariables");
        element("StudyName", text(data_.title));
        element("StudyDescription",
                text(data_.description.empty() ? data_.title : data_.description));
        element("ProtocolName", text(data_.id));
        end();
        units();
        start("MetaDataVersion");
        attribute("OID", version_oid());
        attribute("Name", QString("Protocol version %1").arg(data_.version));
        start("Protocol");
        start("StudyEventRef");
        attribute("StudyEventOID", kEvent);
        attribute("Mandatory", "Yes");
        end();
        end();
        start("StudyEventDef");
        attribute("OID", kEvent);
        attribute("Name", text(data_.title));
        attribute("Repeating", "No");
        attribute("Type", "Scheduled");
        for (const Form& form : data_.forms) {
            start("FormRef");
            attribute("FormOID", "F." + text(form.name));
            attribute("Mandatory", "No");
            end();
        }
        end();
        form_definitions();
        for (const Form& form : data_.forms)
            for (const Item& item : items_of(form)) item_definition(item);
        code_lists();
        conditions();
        end();
        end();
    }

    void units() {
        std::set<std::string> units;
        for (const Form& form : data_.forms)
            for (const Field& field : form.fields)
                if (!field.unit.empty()) units.insert(field.unit);
        if (units.empty()) return;
        start("BasicDefinitions");
        std::set<QString> seen;
        for (const std::string& unit : units) {
            if (!seen.insert(unit_oid(unit)).second) continue;
            start("MeasurementUnit");
            attribute("OID", unit_oid(unit));
            attribute("Name", text(unit));
            translated("Symbol", text(unit));
            end();
        }
        end();
    }

    void form_definitions() {
        for (const Form& form : data_.forms) {
            start("FormDef");
            attribute("OID", "F." + text(form.name));
            attribute("Name", text(form.title + " (" + form.name + ")"));
            attribute("Repeating", form.repeating ? "Yes" : "No");
            start("ItemGroupRef");
            attribute("ItemGroupOID", "IG." + text(form.name));
            attribute("Mandatory", "Yes");
            end();
            end();
        }
        for (const Form& form : data_.forms) {
            start("ItemGroupDef");
            attribute("OID", "IG." + text(form.name));
            attribute("Name", text(form.name));
            attribute("Repeating", "No");
            int order = 0;
            for (const Item& item : items_of(form)) {
                start("ItemRef");
                attribute("ItemOID", item.oid());
                attribute("OrderNumber", QString::number(++order));
                const bool mandatory =
                    item.field->required && !item.field->derived && !item.field->show_if;
                attribute("Mandatory", mandatory ? "Yes" : "No");
                if (item.field->show_if)
                    attribute("CollectionExceptionConditionOID",
                              "COND." + text(form.name) + "." + text(item.field->id));
                end();
            }
            end();
        }
    }

    void range_check(const char* comparator, double value) {
        start("RangeCheck");
        attribute("Comparator", comparator);
        attribute("SoftHard", "Hard");
        element("CheckValue", text(shortest_text(value)));
        end();
    }

    void item_definition(const Item& item) {
        const Field& field = *item.field;
        start("ItemDef");
        attribute("OID", item.oid());
        attribute("Name", text(field.name) +
                              (item.choice >= 0 ? "_" + QString::number(item.choice) : QString()));
        attribute("DataType", type_of(item));
        if (field.kind != FieldKind::kDate) attribute("Length", length_of(item));
        if (QString(type_of(item)) == "float") attribute("SignificantDigits", "17");
        QString label = text(field.label);
        for (const Code& code : field.codes)
            if (item.choice == code.value) label += ": " + text(code.label);
        if (item.choice == field.not_applicable_code()) label += ": does not apply";
        translated("Question", label);
        if (!field.unit.empty()) {
            start("MeasurementUnitRef");
            attribute("MeasurementUnitOID", unit_oid(field.unit));
            end();
        }
        if (field.minimum) range_check("GE", *field.minimum);
        if (field.maximum) range_check("LE", *field.maximum);
        if (item.coded() || item.choice >= 0) {
            start("CodeListRef");
            attribute("CodeListOID", item.code_list());
            end();
        }
        end();
    }

    void code_item(int value, const QString& label) {
        start("CodeListItem");
        attribute("CodedValue", QString::number(value));
        translated("Decode", label.isEmpty() ? QString::number(value) : label);
        end();
    }

    void code_lists() {
        bool chosen = false;
        for (const Form& form : data_.forms) {
            for (const Item& item : items_of(form)) {
                chosen = chosen || item.choice >= 0;
                if (!item.coded()) continue;
                start("CodeList");
                attribute("OID", item.code_list());
                attribute("Name", text(item.field->name));
                attribute("DataType", "integer");
                for (const Code& code : item.field->codes) code_item(code.value, text(code.label));
                if (item.field->not_applicable)
                    code_item(item.field->not_applicable_code(), "does not apply");
                end();
            }
        }
        if (!chosen) return;
        start("CodeList");
        attribute("OID", "CL.CHOSEN");
        attribute("Name", "chosen");
        attribute("DataType", "integer");
        code_item(0, "not chosen");
        code_item(1, "chosen");
        end();
    }

    /// When an item is NOT asked, as ODM has it.
    void conditions() {
        for (const Form& form : data_.forms) {
            for (const Field& field : form.fields) {
                if (!field.show_if) continue;
                QStringList answers;
                for (const std::string& answer : field.show_if->any_of) answers << text(answer);
                start("ConditionDef");
                attribute("OID", "COND." + text(form.name) + "." + text(field.id));
                attribute("Name", text(field.name) + "_not_asked");
                const QString rule =
                    QString("%1 is none of: %2").arg(text(field.show_if->item), answers.join(", "));
                translated("Description", rule);
                start("FormalExpression");
                attribute("Context", "Placode");
                xml_.writeCharacters(rule);
                end();
                end();
            }
        }
    }

    void clinical_data() {
        start("ClinicalData");
        attribute("StudyOID", study_oid());
        attribute("MetaDataVersionOID", version_oid());
        std::set<std::string> participants;
        for (const Form& form : data_.forms)
            for (const Row& row : form.rows) participants.insert(row.participant);
        for (const std::string& code : participants) {
            start("SubjectData");
            attribute("SubjectKey", text(code));
            start("StudyEventData");
            attribute("StudyEventOID", kEvent);
            for (const Form& form : data_.forms)
                for (const Row& row : form.rows)
                    if (row.participant == code) form_data(form, row);
            end();
            end();
        }
        end();
    }

    void form_data(const Form& form, const Row& row) {
        start("FormData");
        attribute("FormOID", "F." + text(form.name));
        if (form.repeating) attribute("FormRepeatKey", QString::number(row.instance));
        start("ItemGroupData");
        attribute("ItemGroupOID", "IG." + text(form.name));
        for (const Item& item : items_of(form)) {
            const auto found = row.values.find(item.field->id);
            if (found != row.values.end()) item_data(item, found->second);
        }
        end();
        end();
    }

    void item_data(const Item& item, const std::string& value) {
        const bool missing = item.field->not_applicable && value == curriculum::kNotApplicable;
        QString shown = text(value);
        if (item.choice >= 0) {
            const auto chosen = curriculum::answer_indices(value).value_or(std::vector<int>{});
            const bool here =
                missing ? item.choice == item.field->not_applicable_code()
                        : std::find(chosen.begin(), chosen.end(), item.choice) != chosen.end();
            shown = here ? "1" : "0";
        } else if (missing && item.coded()) {
            shown = QString::number(item.field->not_applicable_code());
        }
        start("ItemData");
        attribute("ItemOID", item.oid());
        if (missing && item.choice < 0 && !item.coded())
            attribute("IsNull", "Yes");  // of a number: nothing else can be said in ODM
        else
            attribute("Value", shown);
        end();
    }

    const Dataset& data_;
    QXmlStreamWriter xml_;
};

std::string path_of(const std::string& folder, const Dataset& data) {
    return folder + "/" + file_name(data.id) + "_odm.xml";
}

void take(Cells& cells, const Item& item, const Row& row, const QXmlStreamAttributes& attributes) {
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
    std::map<QString, Item> items;
    for (const Form& form : data.forms)
        for (const Item& item : items_of(form)) items.emplace(item.oid(), item);
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
    QByteArray bytes;
    Document(source.data, &bytes).write();
    save_file(path_of(folder, source.data), bytes.toStdString());
}

void verify_odm(const ExportSource& source, const std::string& folder) {
    compare_cells(cells_of(source.data), read_cells(source.data, path_of(folder, source.data)),
                  "export odm");
}

}  // namespace placode::reports
