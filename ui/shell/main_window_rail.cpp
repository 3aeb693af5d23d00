// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The rail of the main window: the pages that somebody with these roles has, by what they are for.

#include <QHBoxLayout>
#include <QToolButton>

#include "ui/shell/main_window.h"
#include "ui/shell/parts.h"
#include "ui/shell/theme.h"

namespace placode::ui {

QWidget* MainWindow::buildRail() {
    auto* rail = new QFrame;
    rail->setProperty("role", "rail");
    rail->setObjectName("rail");
    rail->setAccessibleName(tr("Pages"));
    auto* layout = new QVBoxLayout(rail);
    layout->setContentsMargins(kSpace12, kSpace16, kSpace12, kSpace16);
    layout->setSpacing(kSpace4);
    auto* mark = new QHBoxLayout;
    mark->setContentsMargins(kSpace12, 0, 0, kSpace8);
    auto* picture = new QLabel;
    picture->setPixmap(line_icon("placode", context_.colors().accent).pixmap(28, 28));
    mark->addWidget(picture);
    mark->addSpacing(kSpace8);
    QLabel* name = make_label("Placode", "title");
    name->setObjectName("rail_mark");
    mark->addWidget(name, 1);
    layout->addLayout(mark);
    rail_buttons_.clear();
    std::vector<RailSection> wanted;
    for (RailSection& section : railSections()) {
        std::erase_if(section.pages, [](const RailPage& page) { return !page.wanted; });
        if (!section.pages.empty()) wanted.push_back(std::move(section));
    }
    for (const RailSection& section : wanted) {
        // Whoever has one kind of work needs no heading for it.
        if (wanted.size() > 1) layout->addWidget(railHeading(section.heading));
        for (const RailPage& page : section.pages) layout->addWidget(railButton(page));
    }
    layout->addStretch();
    return rail;
}

std::vector<MainWindow::RailSection> MainWindow::railSections() {
    using db::Action;
    using db::Scope;
    const auto may = [this](Action action) { return context_.may(action, Scope::kOther); };
    const bool trains = context_.signedIn() && context_.may(Action::kPerformAttempt) &&
                        (db::has_role(context_.user().roles, db::Role::kTrainee) ||
                         db::has_role(context_.user().roles, db::Role::kEducator));
    const bool teaches = may(Action::kViewAttempts);
    const bool studies = context_.may(Action::kRunQuestionnaire);
    return {
        {tr("Training"),
         {{PageId::kToday, tr("Today"), "today", trains},
          {PageId::kCourse, tr("Course"), "course", trains},
          {PageId::kHistory, tr("History"), "history", trains}}},
        {tr("Teaching"),
         {{PageId::kAttempts, tr("Attempts"), "attempts", teaches},
          {PageId::kCohort, tr("Cohort"), "cohort", teaches},
          {PageId::kRatings, tr("Ratings"), "ratings", teaches},
          {PageId::kCourses, tr("Courses"), "courses", may(Action::kManageCourses)},
          {PageId::kGroups, tr("Groups"), "groups",
           context_.may(Action::kManageGroups, Scope::kGroup)},
          {PageId::kStandards, tr("Standards"), "standards", teaches},
          {PageId::kNorms, tr("Norms"), "norms", may(Action::kSetStandards)}}},
        {tr("Research"),
         {{PageId::kStudies, tr("Studies"), "studies", studies},
          {PageId::kProtocols, tr("Protocols"), "protocols", studies},
          {PageId::kStudyData, tr("Data"), "data", studies},
          {PageId::kStudyResults, tr("Results"), "results", context_.may(Action::kExportStudy)}}},
        {tr("This centre"),
         {{PageId::kPeople, tr("People"), "people", may(Action::kManageUsers)},
          {PageId::kDevices, tr("Devices"), "devices", teaches || may(Action::kBackup)},
          {PageId::kHealth, tr("Health"), "health", may(Action::kBackup)},
          {PageId::kAudit, tr("Audit"), "audit", may(Action::kViewAudit)}}}};
}

QLabel* MainWindow::railHeading(const QString& text) {
    QLabel* heading = make_label(text, "rail_heading");
    heading->setObjectName("rail_heading");
    heading->setAccessibleName(text);
    heading->setWordWrap(false);
    return heading;
}

QToolButton* MainWindow::railButton(const RailPage& page) {
    auto* button = new QToolButton;
    button->setProperty("role", "rail");
    button->setObjectName("rail_" + page.icon);
    button->setText(" " + page.text);
    button->setAccessibleName(page.text);
    button->setIcon(line_icon(page.icon, context_.colors().muted));
    button->setIconSize(QSize(20, 20));
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setCheckable(true);
    button->setFocusPolicy(Qt::StrongFocus);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    button->setMinimumHeight(kTouchTarget);
    connect(button, &QToolButton::clicked, this, [this, id = page.id] {
        open({id, 0, {}, id == PageId::kHistory ? historyState() : QVariantMap{}});
        updateFrame();
    });
    rail_buttons_.emplace_back(button, page.id);
    return button;
}

}  // namespace placode::ui
