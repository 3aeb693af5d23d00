// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The pages of the shell. Each stands in `<name>_page.cpp` and needs no header of its own.

#include <QCoreApplication>
#include <QVariantMap>
#include <QWidget>

#include "ui/shell/app_context.h"

namespace placode::ui {

enum class PageId : uint8_t {
    kSetup,
    kLogin,
    kToday,
    kCourse,
    kTask,
    kRunning,
    kResult,
    kHistory,
    kAttempts,
    kStudies,
    kParticipant,
    kPeople,
    kHealth,
    kAudit,
    kAccount,
    kRecovery,
    kWatch,
    kStudyRun,
    kCohort,
    kStandards,
    kRatings,
    kDevices,
    kStudyData,
    kStudyResults,
    kProtocols,
    kCourses,
    kCourseEditor,
    kGroups,
    kJoin,
    kAdmissions,
    kNorms,
    kCompare,
};

/// Where to go: a page and what it shows.
struct Place {
    PageId page = PageId::kLogin;
    qint64 number = 0;  ///< Attempt id.
    QString text;       ///< Task id, participant code.
    QVariantMap state;  ///< What a page wants back when it is rebuilt in another language.
};

/// A page is built for one visit and thrown away afterwards: what it shows is always fresh.
class Page : public QWidget {
    Q_OBJECT
 public:
    explicit Page(AppContext& context);
    [[nodiscard]] virtual QString title() const = 0;
    /// What to hand back in Place::state after a change of language or theme.
    [[nodiscard]] virtual QVariantMap state() const { return {}; }
    /// Which task the page is about, empty = none: the history opens on it.
    [[nodiscard]] virtual QString aboutTask() const { return {}; }
    /// False keeps the user here (unsaved answers).
    [[nodiscard]] virtual bool mayLeave() { return true; }
    /// True: what was typed and not saved is there again when the same person comes back to the
    /// page. Not where somebody else's words stand, nor where leaving asks.
    [[nodiscard]] virtual bool keepsTyped() const { return false; }
    /// False keeps the language: what was filled in would not be true in another one.
    [[nodiscard]] virtual bool mayTranslate() { return true; }

 Q_SIGNALS:
    void go(const placode::ui::Place& place);
    void back();
    /// Fields came that were not there when the page was made: what was typed into them goes back.
    void fieldsCame();
    void notice(const QString& text);
    /// A file or folder was written: said with the way to open it.
    void written(const QString& text, const QString& path);

 protected:
    AppContext& context_;
};

[[nodiscard]] Page* make_setup_page(AppContext& context, const Place& place);
[[nodiscard]] Page* make_login_page(AppContext& context, const Place& place);
[[nodiscard]] Page* make_today_page(AppContext& context, const Place& place);
[[nodiscard]] Page* make_course_page(AppContext& context, const Place& place);
[[nodiscard]] Page* make_task_page(AppContext& context, const Place& place);
[[nodiscard]] Page* make_running_page(AppContext& context, const Place& place);
[[nodiscard]] Page* make_result_page(AppContext& context, const Place& place);
[[nodiscard]] Page* make_history_page(AppContext& context, const Place& place);
[[nodiscard]] Page* make_attempts_page(AppContext& context, const Place& place);
[[nodiscard]] Page* make_studies_page(AppContext& context, const Place& place);
[[nodiscard]] Page* make_participant_page(AppContext& context, const Place& place);
[[nodiscard]] Page* make_people_page(AppContext& context, const Place& place);
[[nodiscard]] Page* make_health_page(AppContext& context, const Place& place);
[[nodiscard]] Page* make_audit_page(AppContext& context, const Place& place);
[[nodiscard]] Page* make_account_page(AppContext& context, const Place& place);
[[nodiscard]] Page* make_recovery_page(AppContext& context, const Place& place);
[[nodiscard]] Page* make_watch_page(AppContext& context, const Place& place);
[[nodiscard]] Page* make_study_run_page(AppContext& context, const Place& place);
[[nodiscard]] Page* make_cohort_page(AppContext& context, const Place& place);
[[nodiscard]] Page* make_standards_page(AppContext& context, const Place& place);
[[nodiscard]] Page* make_ratings_page(AppContext& context, const Place& place);
[[nodiscard]] Page* make_devices_page(AppContext& context, const Place& place);
[[nodiscard]] Page* make_study_data_page(AppContext& context, const Place& place);
[[nodiscard]] Page* make_study_results_page(AppContext& context, const Place& place);
[[nodiscard]] Page* make_protocols_page(AppContext& context, const Place& place);
[[nodiscard]] Page* make_courses_page(AppContext& context, const Place& place);
[[nodiscard]] Page* make_course_editor_page(AppContext& context, const Place& place);
[[nodiscard]] Page* make_groups_page(AppContext& context, const Place& place);
[[nodiscard]] Page* make_join_page(AppContext& context, const Place& place);
[[nodiscard]] Page* make_admissions_page(AppContext& context, const Place& place);
[[nodiscard]] Page* make_norms_page(AppContext& context, const Place& place);
[[nodiscard]] Page* make_compare_page(AppContext& context, const Place& place);
[[nodiscard]] Page* make_page(AppContext& context, const Place& place);

}  // namespace placode::ui
