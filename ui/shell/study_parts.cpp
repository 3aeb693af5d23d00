// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/study_parts.h"

#include <QCoreApplication>
#include <algorithm>
#include <map>
#include <optional>

#include "curriculum/definitions.h"
#include "db/study_conduct.h"
#include "ui/shell/parts.h"

namespace placode::ui {
namespace {

struct StudyParts {
    Q_DECLARE_TR_FUNCTIONS(StudyParts)
};

constexpr const char* kSetting = "study";

/// @param protocol as published, if it is
QString title_of(const AppContext& context, const std::string& study,
                 std::optional<curriculum::StudyProtocol> protocol,
                 const std::vector<std::string>& shipped) {
    if (!protocol && std::find(shipped.begin(), shipped.end(), study) != shipped.end())
        protocol = curriculum::load_study(study);
    const QString title = protocol ? context.in(protocol->title) : QString();
    return title.isEmpty() ? qstr(study) : title;
}

}  // namespace

QString study_title(AppContext& context, const std::string& study) {
    return title_of(context, study, db::published_study(context.store(), study),
                    curriculum::list_definitions("studies"));
}

QStringList study_titles(AppContext& context, const std::vector<std::string>& ids) {
    std::map<std::string, std::string> published;  // By version: the newest is the last.
    for (db::DefinitionRecord& each : context.store().definitions().list("study"))
        published[each.id] = std::move(each.json);
    const auto shipped = curriculum::list_definitions("studies");
    QStringList titles;
    for (const std::string& id : ids) {
        std::optional<curriculum::StudyProtocol> protocol;
        if (const auto found = published.find(id); found != published.end())
            protocol = curriculum::load_study_text(found->second, "study " + id);
        titles << title_of(context, id, std::move(protocol), shipped);
    }
    return titles;
}

std::string chosen_study(AppContext& context, const std::vector<std::string>& ids,
                         const QString& wanted) {
    const auto there = [&](const QString& id) {
        return std::find(ids.begin(), ids.end(), id.toStdString()) != ids.end();
    };
    const QString last = context.storeSetting(kSetting).toString();
    const QString chosen = there(wanted) ? wanted
                           : there(last) ? last
                           : ids.empty() ? QString()
                                         : qstr(ids.front());
    if (!chosen.isEmpty()) context.setStoreSetting(kSetting, chosen);
    return chosen.toStdString();
}

QComboBox* make_study_chooser(AppContext& context, const std::vector<std::string>& ids,
                              const std::string& chosen) {
    if (ids.size() < 2) return nullptr;
    auto* chooser = new QComboBox;
    chooser->setObjectName("study_chooser");
    chooser->setAccessibleName(StudyParts::tr("Study"));
    chooser->setMaximumWidth(420);
    const QStringList titles = study_titles(context, ids);
    for (size_t i = 0; i < ids.size(); ++i)
        chooser->addItem(titles[static_cast<qsizetype>(i)], qstr(ids[i]));
    chooser->setCurrentIndex(std::max(0, chooser->findData(qstr(chosen))));
    return chooser;
}

double step_limit_s(const curriculum::StudyStep& step) {
    const double asked = step.max_s > 0 ? step.max_s : step.time_limit_s.value_or(0);
    const curriculum::Task task = curriculum::load_task(step.task);
    return asked > 0 || task.time_limit_s > 0 ? curriculum::limit_of(task, asked) : 0;
}

QLineEdit* make_line(const char* object_name, const QString& words, bool secret) {
    auto* edit = new QLineEdit;
    edit->setObjectName(object_name);
    edit->setAccessibleName(words);
    edit->setPlaceholderText(words);
    edit->setToolTip(words);  // Whoever has begun to type sees the words no more.
    if (secret) edit->setEchoMode(QLineEdit::Password);
    return edit;
}

QPushButton* make_action(AppContext& context, const QObject* page, const QString& text,
                         const char* role, const QString& icon, const char* object_name,
                         const std::function<void()>& work) {
    QPushButton* made = make_button(context, text, role, icon);
    made->setObjectName(object_name);
    QObject::connect(made, &QPushButton::clicked, page, work);
    return made;
}

}  // namespace placode::ui
