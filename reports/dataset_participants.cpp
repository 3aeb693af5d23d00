// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The form of participants: who takes part, which consent was given, whether the record is locked
// and signed.
#include "reports/dataset_forms.h"

namespace placode::reports {
namespace {

/// The consent that was given, where the protocol asks for one. What the hand wrote is in no
/// export.
void add_consent_fields(Form& form) {
    form.fields.push_back(text_field("consent_utc", "Consent given (UTC)"));
    form.fields.push_back(text_field("consent_version", "Version of the consent text"));
    form.fields.back().kind = FieldKind::kDecimal;
    form.fields.push_back(text_field("consent_language", "Language of the consent text"));
    form.fields.push_back(text_field("consent_agreed", "Statements agreed to"));
    form.fields.push_back(text_field("consent_checksum", "Checksum of the text that was read"));
    form.fields.push_back(
        code_field("consent_signed", "Signed", {{0, "on paper"}, {1, "on screen"}}));
}

void fill_consent(Row& row, const db::GivenConsent& consent) {
    row.values["consent_utc"] = consent.at_utc;
    row.values["consent_version"] = std::to_string(consent.version);
    row.values["consent_language"] = consent.language;
    std::string agreed;
    for (const std::string& each : consent.agreed) agreed += (agreed.empty() ? "" : " ") + each;
    if (!agreed.empty()) row.values["consent_agreed"] = agreed;
    row.values["consent_checksum"] = consent.text_checksum;
    row.values["consent_signed"] = consent.on_screen ? "1" : "0";
}

/// Lock and signature of the record. Who signed is a name, though none of a participant.
void add_care_fields(Form& form, const DatasetOptions& options) {
    form.fields.push_back(code_field("record_locked", "Record locked", {{0, "no"}, {1, "yes"}}));
    form.fields.push_back(text_field("signed_utc", "Record signed (UTC)"));
    form.fields.push_back(text_field("signature_meaning", "Meaning of the signature"));
    form.fields.push_back(text_field("signed_checksum", "Checksum of the signed record (SHA-256)"));
    form.fields.push_back(code_field("signature_fits", "The record is what was signed",
                                     {{0, "no, changed after the signature"}, {1, "yes"}}));
    if (!options.identifying) return;
    form.fields.push_back(text_field("signed_by", "Record signed by"));
    form.fields.back().identifying = true;
}

void fill_care(Row& row, const db::RecordState& state, const DatasetOptions& options) {
    row.values["record_locked"] = state.locked ? "1" : "0";
    if (!state.signature) return;
    row.values["signed_utc"] = state.signature->at_utc;
    row.values["signature_meaning"] = state.signature->remark;
    row.values["signed_checksum"] = state.signature->checksum;
    row.values["signature_fits"] = state.signature_fits ? "1" : "0";
    if (options.identifying) row.values["signed_by"] = state.signature->name;
}

}  // namespace

Form participants_form(const std::vector<db::ParticipantRecord>& all,
                       const std::map<std::string, db::RecordState>& states,
                       const std::map<std::string, db::GivenConsent>& consents,
                       const Protocols& protocols, const DatasetOptions& options) {
    Form form;
    form.id = form.name = "participants";
    form.title = "Participants";
    form.fields = {text_field("enrolled_utc", "Enrolled (UTC)"),
                   text_field("withdrawn_utc", "Withdrawn (UTC)")};
    Field status;
    status.id = "status";
    status.label = "Status";
    status.kind = FieldKind::kCode;
    status.codes = {{0, "takes part"},
                    {1, "withdrew, data to date are used"},
                    {2, "withdrew, data are not used"},
                    {3, "withdrew, data are erased"}};
    form.fields.push_back(status);
    Field version;
    version.id = "protocol_version";
    version.label = "Version of the protocol";
    version.kind = FieldKind::kDecimal;
    form.fields.push_back(version);
    if (!protocols.arms().empty()) {
        Field arm;
        arm.id = "arm";
        arm.label = "Arm";
        arm.kind = FieldKind::kCode;
        for (const curriculum::LocalText& name : protocols.arms())
            arm.codes.push_back({static_cast<int>(arm.codes.size()), name.in(options.language)});
        form.fields.push_back(arm);
    }
    const bool consent = protocols.ask_consent();
    if (consent) add_consent_fields(form);
    add_care_fields(form, options);
    for (const db::ParticipantRecord& each : all) {
        Row row;
        row.participant = each.code;
        row.at_utc = each.enrolled_utc;
        row.demonstration = each.demonstration;
        row.values["enrolled_utc"] = each.enrolled_utc;
        if (!each.withdrawn_utc.empty()) row.values["withdrawn_utc"] = each.withdrawn_utc;
        row.values["status"] =
            each.withdrawal ? std::to_string(1 + static_cast<int>(*each.withdrawal)) : "0";
        row.values["protocol_version"] = std::to_string(each.protocol_version);
        if (const auto arm = protocols.arm_of(each)) row.values["arm"] = std::to_string(*arm);
        const auto given = consents.find(each.code);
        if (consent && given != consents.end()) fill_consent(row, given->second);
        const auto state = states.find(each.code);
        fill_care(row, state == states.end() ? db::RecordState{} : state->second, options);
        form.rows.push_back(std::move(row));
    }
    return form;
}

}  // namespace placode::reports
