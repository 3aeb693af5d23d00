// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What an ODM document calls an item: a field of a form, or one choice of a field with several.
// Private to reports.

#include <QString>
#include <vector>

#include "reports/dataset.h"

namespace placode::reports {

/// One ItemDef. A field with several choices becomes one item a choice.
struct OdmItem {
    const Form* form;
    const Field* field;
    int choice;  ///< -1 = the field itself.
    [[nodiscard]] QString oid() const {
        QString id = QString("I.%1.%2").arg(QString::fromStdString(form->name),
                                            QString::fromStdString(field->id));
        if (choice >= 0) id += "." + QString::number(choice);
        return id;
    }
    [[nodiscard]] bool coded() const { return field->kind == FieldKind::kCode; }
    [[nodiscard]] QString code_list() const {
        return choice >= 0 ? QString("CL.CHOSEN")
                           : QString("CL.%1.%2")
                                 .arg(QString::fromStdString(form->name),
                                      QString::fromStdString(field->id));
    }
};

/// All of a form, in the order of its fields.
[[nodiscard]] std::vector<OdmItem> odm_items(const Form& form);
/// Its DataType.
[[nodiscard]] const char* odm_type(const OdmItem& item);
/// Longest value, because ODM wants to know.
[[nodiscard]] QString odm_length(const OdmItem& item);

}  // namespace placode::reports
