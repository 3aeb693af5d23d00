// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/odm_document.h"

#include <set>

#include "reports/odm_items.h"
#include "reports/odm_xml.h"
#include "reports/text.h"

namespace placode::reports {
namespace {

class Document : private OdmXml {
 public:
    Document(const Dataset& data, QByteArray* bytes) : OdmXml(bytes), data_(data) {}

    void write() {
        begin_document();
        attribute("ODMVersion", "1.3.2");
        attribute("FileType", "Snapshot");
        attribute("FileOID", odm_text("placode." + data_.id + "." + data_.created_utc));
        attribute("CreationDateTime", odm_text(data_.created_utc));
        attribute("SourceSystem", "Placode");
        attribute("SourceSystemVersion", odm_text(data_.software));
        if (data_.demonstration) attribute("Description", "DEMONSTRATION: holds simulated data");
        study();
        write_clinical_data(*this, data_);
        end_document();
    }

 private:
    static QString unit_oid(const std::string& unit) { return "MU." + odm_text(plain_name(unit)); }

    void study() {
        start("Study");
        attribute("OID", study_oid(data_));
        start("GlobalVariables");
        element("StudyName", odm_text(data_.title));
        element("StudyDescription",
                odm_text(data_.description.empty() ? data_.title : data_.description));
        element("ProtocolName", odm_text(data_.id));
        end();
        units();
        start("MetaDataVersion");
        attribute("OID", version_oid(data_));
        attribute("Name", QString("Protocol version %1").arg(data_.version));
        start("Protocol");
        start("StudyEventRef");
        attribute("StudyEventOID", kOdmEvent);
        attribute("Mandatory", "Yes");
        end();
        end();
        start("StudyEventDef");
        attribute("OID", kOdmEvent);
        attribute("Name", odm_text(data_.title));
        attribute("Repeating", "No");
        attribute("Type", "Scheduled");
        for (const Form& form : data_.forms) {
            start("FormRef");
            attribute("FormOID", "F." + odm_text(form.name));
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
            attribute("Name", odm_text(unit));
            translated("Symbol", odm_text(unit));
            end();
        }
        end();
    }

    void form_definitions() {
        for (const Form& form : data_.forms) {
            start("FormDef");
            attribute("OID", "F." + odm_text(form.name));
            attribute("Name", odm_text(form.title + " (" + form.name + ")"));
            attribute("Repeating", form.repeating ? "Yes" : "No");
            start("ItemGroupRef");
            attribute("ItemGroupOID", "IG." + odm_text(form.name));
            attribute("Mandatory", "Yes");
            end();
            end();
        }
        for (const Form& form : data_.forms) {
            start("ItemGroupDef");
            attribute("OID", "IG." + odm_text(form.name));
            attribute("Name", odm_text(form.name));
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
                              "COND." + odm_text(form.name) + "." + odm_text(item.field->id));
                end();
            }
            end();
        }
    }

    void range_check(const char* comparator, double value) {
        start("RangeCheck");
        attribute("Comparator", comparator);
        attribute("SoftHard", "Hard");
        element("CheckValue", odm_text(shortest_text(value)));
        end();
    }

    void item_definition(const OdmItem& item) {
        const Field& field = *item.field;
        start("ItemDef");
        attribute("OID", item.oid());
        attribute("Name", odm_text(field.name) +
                              (item.choice >= 0 ? "_" + QString::number(item.choice) : QString()));
        attribute("DataType", odm_type(item));
        if (field.kind != FieldKind::kDate) attribute("Length", odm_length(item));
        if (QString(odm_type(item)) == "float") attribute("SignificantDigits", "17");
        QString label = odm_text(field.label);
        for (const Code& code : field.codes)
            if (item.choice == code.value) label += ": " + odm_text(code.label);
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
                attribute("Name", odm_text(item.field->name));
                attribute("DataType", "integer");
                for (const Code& code : item.field->codes)
                    code_item(code.value, odm_text(code.label));
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
                for (const std::string& answer : field.show_if->any_of) answers << odm_text(answer);
                start("ConditionDef");
                attribute("OID", "COND." + odm_text(form.name) + "." + odm_text(field.id));
                attribute("Name", odm_text(field.name) + "_not_asked");
                const QString rule = QString("%1 is none of: %2")
                                         .arg(odm_text(field.show_if->item), answers.join(", "));
                translated("Description", rule);
                start("FormalExpression");
                attribute("Context", "Placode");
                characters(rule);
                end();
                end();
            }
        }
    }

    const Dataset& data_;
};

}  // namespace

QByteArray odm_document(const Dataset& data) {
    QByteArray bytes;
    Document(data, &bytes).write();
    return bytes;
}

}  // namespace placode::reports
