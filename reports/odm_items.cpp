// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/odm_items.h"

#include <algorithm>

namespace placode::reports {

std::vector<OdmItem> odm_items(const Form& form) {
    std::vector<OdmItem> items;
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

const char* odm_type(const OdmItem& item) {
    if (item.choice >= 0 || item.coded()) return "integer";
    if (item.field->kind == FieldKind::kDecimal) return "float";
    return item.field->kind == FieldKind::kDate ? "date" : "text";
}

QString odm_length(const OdmItem& item) {
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

}  // namespace placode::reports
