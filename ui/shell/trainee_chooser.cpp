// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/trainee_chooser.h"

#include <QAbstractItemModel>
#include <QComboBox>
#include <QCompleter>
#include <QCoreApplication>
#include <algorithm>
#include <map>

#include "db/access.h"
#include "ui/shell/parts.h"

namespace placode::ui {
namespace {

constexpr qsizetype kNamedAtMost = 4;  ///< Of those who may be meant.

struct ChooserWords {
    Q_DECLARE_TR_FUNCTIONS(TraineeChooser)
};

/// Those whose whole text is typed; where there is none, those that hold what is typed.
QModelIndexList meant_rows(const QComboBox* list) {
    const QString typed = list->currentText();
    if (typed.isEmpty()) return {};
    const QAbstractItemModel* model = list->model();
    const QModelIndex first = model->index(0, list->modelColumn(), list->rootModelIndex());
    QModelIndexList rows;
    for (const Qt::MatchFlags how :
         {Qt::MatchFlags(Qt::MatchFixedString | Qt::MatchCaseSensitive),
          Qt::MatchFlags(Qt::MatchFixedString), Qt::MatchFlags(Qt::MatchContains)})
        if (rows.isEmpty()) rows = model->match(first, Qt::DisplayRole, typed, -1, how);
    return rows;
}

}  // namespace

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
    // Of two with the same text the one that was chosen; typing leaves the choice of before.
    const int chosen = list->currentIndex();
    if (chosen >= 0 && list->itemText(chosen) == list->currentText()) return chosen;
    const QModelIndexList rows = meant_rows(list);
    return rows.size() == 1 ? rows.front().row() : -1;
}

QString why_no_row(const QComboBox* list, const QString& unknown) {
    const QString typed = list->currentText();
    if (typed.isEmpty())
        return ChooserWords::tr("Nobody is chosen: type a name, or choose one of the list.");
    const QModelIndexList rows = meant_rows(list);
    if (rows.size() < 2) return unknown.arg(typed);
    QStringList names;
    for (const QModelIndex& each : rows.first(std::min(rows.size(), kNamedAtMost)))
        names << each.data().toString();
    if (rows.size() > kNamedAtMost) names << "…";
    return ChooserWords::tr("Several names match \"%1\": %2; choose one of the list.")
        .arg(typed, names.join(", "));
}

}  // namespace placode::ui
