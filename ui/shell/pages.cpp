// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/pages.h"

namespace placode::ui {

namespace {

/// Of who runs a study, rates in it or takes part.
Page* make_page_of_studies(AppContext& context, const Place& place) {
    switch (place.page) {
        case PageId::kStudies:
            return make_studies_page(context, place);
        case PageId::kParticipant:
            return make_participant_page(context, place);
        case PageId::kStudyRun:
            return make_study_run_page(context, place);
        case PageId::kRatings:
            return make_ratings_page(context, place);
        case PageId::kStudyData:
            return make_study_data_page(context, place);
        case PageId::kStudyResults:
            return make_study_results_page(context, place);
        case PageId::kProtocols:
            return make_protocols_page(context, place);
        default:
            return make_login_page(context, place);
    }
}

/// Of who teaches: courses, groups, standards, and how people do by them.
Page* make_page_of_teaching(AppContext& context, const Place& place) {
    switch (place.page) {
        case PageId::kCohort:
            return make_cohort_page(context, place);
        case PageId::kStandards:
            return make_standards_page(context, place);
        case PageId::kCourses:
            return make_courses_page(context, place);
        case PageId::kCourseEditor:
            return make_course_editor_page(context, place);
        case PageId::kGroups:
            return make_groups_page(context, place);
        case PageId::kAdmissions:
            return make_admissions_page(context, place);
        case PageId::kNorms:
            return make_norms_page(context, place);
        default:
            return make_login_page(context, place);
    }
}

}  // namespace

Page::Page(AppContext& context) : context_(context) { setProperty("role", "page"); }

Page* make_page(AppContext& context, const Place& place) {
    switch (place.page) {
        case PageId::kSetup:
            return make_setup_page(context, place);
        case PageId::kLogin:
            return make_login_page(context, place);
        case PageId::kToday:
            return make_today_page(context, place);
        case PageId::kCourse:
            return make_course_page(context, place);
        case PageId::kTask:
            return make_task_page(context, place);
        case PageId::kRunning:
            return make_running_page(context, place);
        case PageId::kResult:
            return make_result_page(context, place);
        case PageId::kHistory:
            return make_history_page(context, place);
        case PageId::kAttempts:
            return make_attempts_page(context, place);
        case PageId::kPeople:
            return make_people_page(context, place);
        case PageId::kHealth:
            return make_health_page(context, place);
        case PageId::kAudit:
            return make_audit_page(context, place);
        case PageId::kAccount:
            return make_account_page(context, place);
        case PageId::kRecovery:
            return make_recovery_page(context, place);
        case PageId::kWatch:
            return make_watch_page(context, place);
        case PageId::kJoin:
            return make_join_page(context, place);
        case PageId::kCompare:
            return make_compare_page(context, place);
        case PageId::kDevices:
            return make_devices_page(context, place);
        case PageId::kStudies:
        case PageId::kParticipant:
        case PageId::kStudyRun:
        case PageId::kRatings:
        case PageId::kStudyData:
        case PageId::kStudyResults:
        case PageId::kProtocols:
            return make_page_of_studies(context, place);
        case PageId::kCohort:
        case PageId::kStandards:
        case PageId::kCourses:
        case PageId::kCourseEditor:
        case PageId::kGroups:
        case PageId::kAdmissions:
        case PageId::kNorms:
            return make_page_of_teaching(context, place);
    }
    return make_login_page(context, place);
}

}  // namespace placode::ui
