// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/trainee_chooser.h"

#include <QComboBox>
#include <QCompleter>
#include <map>

#include "db/access.h"
#include "ui/shell/parts.h"

namespace placode::ui {

QComboBox* make_search_list(const char* object) {
    auto* list = new QComboBox;
    list->setObjectName(object);
    list->setMinimumWidth(180);
    list->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    list->setEditable(true);  // Types to find one among a thousand.
    list->setInsertPolicy(QComboBox::NoInsert);
    list->completer()->setCompletionMode(QCompleter::PopupCompletion);
    list->completer()->setFilterMode(Qt::MatchContains);
    return list;
}

void add_trainees(AppContext& context, QComboBox* list) {
    db::Store& store = context.store();
    const auto users = store.accounts().list();
    std::map<int64_t, const db::UserRecord*> by_id;
    for (const db::UserRecord& user : users) by_id[user.id] = &user;
    for (const int64_t id : db::reached_people(store, context.user().id)) {
        const db::UserRecord& user = *by_id.at(id);
        if (!user.active || !db::has_role(user.roles, db::Role::kTrainee)) continue;
        list->addItem(QString("%1 (%2)").arg(qstr(user.display_name), qstr(user.login)),
                      QVariant::fromValue<qint64>(id));
    }
}

int chosen_row(const QComboBox* list) {
    return list->currentText().isEmpty() ? -1
                                         : list->findText(list->currentText(), Qt::MatchContains);
}

}  // namespace placode::ui
