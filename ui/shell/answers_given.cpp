// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/answers_given.h"

#include <QDateTime>

#include "ui/shell/parts.h"

namespace placode::ui {

using curriculum::ItemKind;
using curriculum::QuestionnaireItem;

QString AnswersGiven::of(const std::string& item) const {
    const auto found = answers_.find(item);
    return found == answers_.end() ? QString() : qstr(found->second);
}

void AnswersGiven::set(const std::string& item, const QString& answer) {
    log(item, of(item).toStdString(), answer.toStdString());
    if (answer.isEmpty()) {
        answers_.erase(item);
    } else {
        answers_[item] = answer.toStdString();
    }
}

bool AnswersGiven::follow(const QuestionnaireItem& item) {
    const bool shown = curriculum::is_shown(questionnaire_, item, answers_);
    if (shown && aside_.contains(item.id)) {
        log(item.id, "", aside_[item.id]);
        answers_[item.id] = aside_[item.id];
        aside_.erase(item.id);
    } else if (!shown && answers_.contains(item.id)) {
        log(item.id, answers_[item.id], "");
        aside_[item.id] = answers_[item.id];
        answers_.erase(item.id);
    }
    return shown;
}

void AnswersGiven::keepIn(QVariantMap& state) const {
    QVariantMap kept;
    for (const auto& [id, answer] : answers_) kept[qstr(id)] = qstr(answer);
    QVariantList changes;
    for (const db::AnswerChange& each : changes_)
        changes << QStringList{qstr(each.item), qstr(each.old_answer), qstr(each.new_answer),
                               qstr(each.at_utc)};
    state["answers"] = kept;
    state["changes"] = changes;
}

void AnswersGiven::takeFrom(const QVariantMap& state) {
    const QVariantMap kept = state.value("answers").toMap();
    for (auto it = kept.begin(); it != kept.end(); ++it)
        answers_[it.key().toStdString()] = it.value().toString().toStdString();
    for (const QVariant& each : state.value("changes").toList()) {
        const QStringList change = each.toStringList();
        changes_.push_back({change.value(0).toStdString(), change.value(1).toStdString(),
                            change.value(2).toStdString(), change.value(3).toStdString()});
    }
}

void AnswersGiven::log(const std::string& id, const std::string& before, const std::string& now) {
    if (before == now) return;
    const std::string at = QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
    const QuestionnaireItem* item = questionnaire_.item(id);
    const bool typed = item->kind == ItemKind::kText || item->kind == ItemKind::kNumber ||
                       item->kind == ItemKind::kDate || item->kind == ItemKind::kVisualAnalogue;
    if (typed && !changes_.empty() && changes_.back().item == id) {
        changes_.back().new_answer = now;
        changes_.back().at_utc = at;
    } else {
        changes_.push_back({id, before, now, at});
    }
}

}  // namespace placode::ui
