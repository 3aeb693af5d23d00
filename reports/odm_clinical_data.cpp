// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What was answered and done, as ODM's clinical data: participant by participant, form by form.
#include <algorithm>
#include <set>

#include "reports/odm_items.h"
#include "reports/odm_xml.h"

namespace placode::reports {
namespace {

void item_data(OdmXml& xml, const OdmItem& item, const std::string& value) {
    const bool missing = item.field->not_applicable && value == curriculum::kNotApplicable;
    QString shown = odm_text(value);
    if (item.choice >= 0) {
        const auto chosen = curriculum::answer_indices(value).value_or(std::vector<int>{});
        const bool here =
            missing ? item.choice == item.field->not_applicable_code()
                    : std::find(chosen.begin(), chosen.end(), item.choice) != chosen.end();
        shown = here ? "1" : "0";
    } else if (missing && item.coded()) {
        shown = QString::number(item.field->not_applicable_code());
    }
    xml.start("ItemData");
    xml.attribute("ItemOID", item.oid());
    if (missing && item.choice < 0 && !item.coded())
        xml.attribute("IsNull", "Yes");  // of a number: nothing else can be said in ODM
    else
        xml.attribute("Value", shown);
    xml.end();
}

void form_data(OdmXml& xml, const Form& form, const Row& row) {
    xml.start("FormData");
    xml.attribute("FormOID", "F." + odm_text(form.name));
    if (form.repeating) xml.attribute("FormRepeatKey", QString::number(row.instance));
    xml.start("ItemGroupData");
    xml.attribute("ItemGroupOID", "IG." + odm_text(form.name));
    for (const OdmItem& item : odm_items(form)) {
        const auto found = row.values.find(item.field->id);
        if (found != row.values.end()) item_data(xml, item, found->second);
    }
    xml.end();
    xml.end();
}

}  // namespace

void write_clinical_data(OdmXml& xml, const Dataset& data) {
    xml.start("ClinicalData");
    xml.attribute("StudyOID", study_oid(data));
    xml.attribute("MetaDataVersionOID", version_oid(data));
    std::set<std::string> participants;
    for (const Form& form : data.forms)
        for (const Row& row : form.rows) participants.insert(row.participant);
    for (const std::string& code : participants) {
        xml.start("SubjectData");
        xml.attribute("SubjectKey", odm_text(code));
        xml.start("StudyEventData");
        xml.attribute("StudyEventOID", kOdmEvent);
        for (const Form& form : data.forms)
            for (const Row& row : form.rows)
                if (row.participant == code) form_data(xml, form, row);
        xml.end();
        xml.end();
    }
    xml.end();
}

}  // namespace placode::reports
