// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/training_reports.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QMenu>
#include <memory>
#include <vector>

#include "reports/cohort_report.h"
#include "ui/shell/pages.h"
#include "ui/shell/parts.h"

namespace placode::ui {
namespace {

struct TrainingReports {
    Q_DECLARE_TR_FUNCTIONS(TrainingReports)
};

/// A report that takes its time, what it is about for the audit trail, and a name for the file.
struct Wanted {
    QString file;
    const char* action;
    std::string object;
    /// Reads the report, calls `note`, and only then writes it.
    std::function<void(db::Store&, const std::string& path, const std::function<void()>& note)>
        write;
};

std::string now_utc() {
    return QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
}

void write_report(AppContext& context, Page& page, const Wanted& wanted) {
    const QString path = context.askSaveFile(&page, TrainingReports::tr("Write the report"),
                                             wanted.file, TrainingReports::tr("PDF (*.pdf)"));
    if (path.isEmpty()) return;
    context.background(
        &page, TrainingReports::tr("Writing the report"),
        [wanted, path = path.toStdString(), login = context.user().login](db::Store& store) {
            // On the worker: there is an entry also when the page is left meanwhile.
            wanted.write(store, path,
                         [&] { store.audit().write(login, wanted.action, wanted.object, path); });
        },
        [&page, path](bool done) {
            if (done)
                Q_EMIT page.written(TrainingReports::tr("Report written: %1").arg(path), path);
        });
}

void write_cohort(AppContext& context, Page& page, int64_t group) {
    write_report(
        context, page,
        {group == 0 ? QString("placode-cohort.pdf") : QString("placode-cohort-%1.pdf").arg(group),
         "report.cohort", "group " + std::to_string(group),
         [group](db::Store& store, const std::string& path, const std::function<void()>& note) {
             const auto report = reports::read_cohort_report(store, group, now_utc());
             note();
             reports::write_cohort_pdf(report, path);
         }});
}

void write_trainee(AppContext& context, Page& page, int64_t account) {
    write_report(
        context, page,
        {QString("placode-person-%1.pdf").arg(account), "report.trainee",
         "user " + std::to_string(account),
         [account](db::Store& store, const std::string& path, const std::function<void()>& note) {
             const auto user = store.accounts().find(account);
             if (!user) return;
             const auto report = reports::read_trainee_report(store, *user, now_utc());
             note();
             reports::write_trainee_pdf(report, path);
         }});
}

}  // namespace

QPushButton* make_cohort_report_button(AppContext& context, Page& page) {
    QPushButton* button =
        make_button(context, TrainingReports::tr("Report"), "secondary", "report");
    button->setObjectName("cohort_report");
    const auto add = [&context, &page, button](QMenu* menu, const QString& name, int64_t group) {
        QObject::connect(menu->addAction(name), &QAction::triggered, button,
                         [&context, &page, group] { write_cohort(context, page, group); });
    };
    std::vector<db::GroupRecord> groups;
    const int64_t self = context.user().id;
    for (const db::GroupRecord& each : context.store().groups().list())
        if (context.may(db::Action::kViewAttempts, db::scope_of_group(each, self)))
            groups.push_back(each);
    if (groups.empty()) {
        QObject::connect(button, &QPushButton::clicked, &page,
                         [&context, &page] { write_cohort(context, page, 0); });
        return button;
    }
    auto* menu = new QMenu(button);
    menu->setObjectName("cohort_report_of");
    add(menu, TrainingReports::tr("Of everybody"), 0);
    for (const db::GroupRecord& each : groups)
        add(menu, TrainingReports::tr("Of the group %1").arg(qstr(each.name)), each.id);
    button->setMenu(menu);
    return button;
}

QPushButton* make_trainee_report_button(AppContext& context, Page& page, const QString& text,
                                        std::function<qint64()> chosen) {
    QPushButton* button = make_button(context, text, "secondary", "report");
    button->setObjectName("trainee_report");
    QObject::connect(button, &QPushButton::clicked, &page,
                     [&context, &page, chosen = std::move(chosen)] {
                         if (const qint64 account = chosen(); account != 0)
                             write_trainee(context, page, account);
                     });
    return button;
}

}  // namespace placode::ui
