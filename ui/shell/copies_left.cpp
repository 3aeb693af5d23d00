// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/copies_left.h"

#include <QCoreApplication>

#include "db/store_copies.h"
#include "ui/shell/parts.h"

namespace placode::ui {
namespace {

struct CopiesLeft {
    Q_DECLARE_TR_FUNCTIONS(CopiesLeft)
};

QString copies_left(AppContext& context, const QString& codes) {
    if (!context.storeIsFile())
        return CopiesLeft::tr(
                   "Backups of the server may still hold the data of %1; ask its administrator.")
            .arg(codes);
    QStringList left;
    for (const db::LeftCopy& each : db::copies_with_records(context.storeUrl()))
        left << qstr(each.path);
    if (left.isEmpty()) return {};
    return CopiesLeft::tr(
               "These copies may still hold the data of %1. A restore erases them again; delete "
               "the copies that you do not need:")
               .arg(codes) +
           '\n' + left.join('\n');
}

}  // namespace

QLabel* make_copies_left(AppContext& context, const QString& codes) {
    if (codes.isEmpty()) return nullptr;
    const QString text = copies_left(context, codes);
    if (text.isEmpty()) return nullptr;
    QLabel* label = make_label(text, "warn");
    label->setObjectName("copies_left");
    return label;
}

}  // namespace placode::ui
