// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/odm_document.h"

#include <QXmlStreamWriter>
#include <algorithm>
#include <set>

#include "reports/odm_items.h"
#include "reports/text.h"

namespace placode::reports {
namespace {

constexpr const char* kNamespace = "http://www.cdisc.org/ns/odm/v1.3";
constexpr const char* kEvent = "SE.STUDY";

QString text(const std::string& value) { return QString::fromStdString(value); }

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
            for (const OdmItem& item : odm_items(form)) item_definition(item);
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
            for (const OdmItem& item : odm_items(form)) {
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

    void item_definition(const OdmItem& item) {
        const Field& field = *item.field;
        start("ItemDef");
        attribute("OID", item.oid());
        attribute("Name", text(field.name) +
                              (item.choice >= 0 ? "_" + QString::number(item.choice) : QString()));
        attribute("DataType", odm_type(item));
        if (field.kind != FieldKind::kDate) attribute("Length", odm_length(item));
        if (QString(odm_type(item)) == "float") attribute("SignificantDigits", "17");
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
            for (const OdmItem& item : odm_items(form)) {
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
        for (const OdmItem& item : odm_items(form)) {
            const auto found = row.values.find(item.field->id);
            if (found != row.values.end()) item_data(item, found->second);
        }
        end();
        end();
    }

    void item_data(const OdmItem& item, const std::string& value) {
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

}  // namespace

QByteArray odm_document(const Dataset& data) {
    QByteArray bytes;
    Document(data, &bytes).write();
    return bytes;
}

}  // namespace placode::reports
