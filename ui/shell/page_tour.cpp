// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/page_tour.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <algorithm>
#include <cstdio>
#include <ctime>

#include "ui/shell/main_window.h"

namespace placode::ui {
namespace {

constexpr int kPageLimitMs = 60000;
constexpr double kTooSlowMs = 3000;  ///< Once is enough to know.

double processor_ms() {
    return static_cast<double>(std::clock()) * 1000 / static_cast<double>(CLOCKS_PER_SEC);
}

/// The attempt that shows most: with a recording where there is one, of another person for who may
/// see them.
db::AttemptPage attempts_to_show(AppContext& context) {
    db::AttemptFilter filter;
    if (!context.may(db::Action::kViewAttempts, db::Scope::kOther))
        filter.user_id = context.user().id;
    return context.store().attempts().page(filter);
}

void add_attempts(AppContext& context, std::vector<TourStop>& tour) {
    const db::AttemptPage page = attempts_to_show(context);
    if (page.rows.empty()) return;
    const db::AttemptRecord* shown = &page.rows.front();
    for (const db::AttemptRecord& each : page.rows)
        if (shown->generated && !each.generated) shown = &each;
    tour.push_back({"result", {PageId::kResult, shown->id, {}, {}}});
    tour.push_back({"watch", {PageId::kWatch, shown->id, {}, {{"watch", false}}}});
    tour.push_back({"compare", {PageId::kCompare, shown->id, {}, {}}});
}

void add_studies(AppContext& context, std::vector<TourStop>& tour) {
    if (!context.may(db::Action::kRunQuestionnaire)) return;
    for (const PageId page : {PageId::kStudies, PageId::kStudyData, PageId::kProtocols})
        tour.push_back({page == PageId::kStudies     ? "studies"
                        : page == PageId::kStudyData ? "study_data"
                                                     : "protocols",
                        {page, 0, {}, {}}});
    if (context.may(db::Action::kExportStudy))
        tour.push_back({"study_results", {PageId::kStudyResults, 0, {}, {}}});
    for (const std::string& study : context.store().studies().ids())
        for (const db::ParticipantRecord& each : context.store().studies().participants(study)) {
            if (each.protocol_version == 0 || !each.usable()) continue;
            tour.push_back({"study_run",
                            {PageId::kStudyRun,
                             0,
                             QString::fromStdString(each.code),
                             {{"study", QString::fromStdString(study)}}}});
            return;
        }
}

/// Until the page stands there as it will be seen.
void paint(MainWindow& window) {
    QCoreApplication::processEvents();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    (void)window.grab();
}

}  // namespace

std::vector<TourStop> page_tour(AppContext& context) {
    using db::Action;
    using db::Scope;
    std::vector<TourStop> tour;
    const auto add = [&](const char* name, PageId page, bool wanted, const QString& text = {}) {
        if (wanted) tour.push_back({name, {page, 0, text, {}}});
    };
    const bool trains = context.may(Action::kPerformAttempt);
    const bool teaches = context.may(Action::kViewAttempts, Scope::kOther);
    add("today", PageId::kToday, trains);
    add("course", PageId::kCourse, trains);
    add("task", PageId::kTask, trains, "diathermy_ring_small");
    add("history", PageId::kHistory, trains);
    add_attempts(context, tour);
    add("attempts", PageId::kAttempts, teaches);
    add("cohort", PageId::kCohort, teaches);
    add("ratings", PageId::kRatings, teaches);
    add("standards", PageId::kStandards, teaches);
    add("courses", PageId::kCourses, context.may(Action::kManageCourses, Scope::kOther));
    add("course_editor", PageId::kCourseEditor, context.may(Action::kManageCourses, Scope::kOther));
    add("groups", PageId::kGroups, context.may(Action::kManageGroups, Scope::kGroup));
    add("norms", PageId::kNorms, context.may(Action::kSetStandards, Scope::kOther));
    add_studies(context, tour);
    add("people", PageId::kPeople, context.may(Action::kManageUsers, Scope::kOther));
    add("admissions", PageId::kAdmissions, context.may(Action::kManageUsers, Scope::kOther));
    add("devices", PageId::kDevices, teaches || context.may(Action::kBackup, Scope::kOther));
    add("health", PageId::kHealth, context.may(Action::kBackup, Scope::kOther));
    add("audit", PageId::kAudit, context.may(Action::kViewAudit, Scope::kOther));
    add("account", PageId::kAccount, true);
    add("recovery", PageId::kRecovery, true);
    return tour;
}

std::vector<PageTime> time_pages(AppContext& context, MainWindow& window, int runs) {
    std::vector<PageTime> times;
    for (const TourStop& stop : page_tour(context)) {
        PageTime one;
        one.name = stop.name;
        std::vector<double> shown, used;
        for (int i = 0; i < runs && (i == 0 || shown.back() < kTooSlowMs); ++i) {
            window.visit({PageId::kAccount, 0, {}, {}});
            paint(window);
            QElapsedTimer clock;
            clock.start();
            const double before_ms = processor_ms();
            window.visit(stop.place);
            paint(window);
            shown.push_back(static_cast<double>(clock.nsecsElapsed()) * 1e-6);
            used.push_back(processor_ms() - before_ms);
            while (context.workers().activeThreadCount() > 0 && clock.elapsed() < kPageLimitMs)
                QCoreApplication::processEvents(QEventLoop::AllEvents, 5);
            paint(window);
            one.complete_ms =
                std::max(one.complete_ms, static_cast<double>(clock.nsecsElapsed()) * 1e-6);
        }
        one.first_ms = shown.front();
        std::sort(shown.begin(), shown.end());
        one.median_ms = shown[shown.size() / 2];
        one.worst_ms = shown.back();
        std::sort(used.begin(), used.end());
        one.processor_ms = used[used.size() / 2];
        std::fprintf(stderr, "%s: %.0f ms\n", one.name, one.median_ms);
        times.push_back(one);
    }
    return times;
}

}  // namespace placode::ui
