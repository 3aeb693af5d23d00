// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/retention_card.h"

#include <QCoreApplication>
#include <QVBoxLayout>
#include <algorithm>

#include "db/sql_connection.h"
#include "db/study_retention.h"
#include "ui/shell/parts.h"
#include "ui/shell/study_parts.h"

namespace placode::ui {
namespace {

struct RetentionWords {
    Q_DECLARE_TR_FUNCTIONS(RetentionCard)
};

QString day_of(const std::string& utc) { return qstr(utc.substr(0, 10)); }

void erase_now(AppContext& context, Page& page, const std::string& study, const QStringList& codes,
               const std::function<void(const QString& codes)>& erased) {
    const int count = static_cast<int>(codes.size());
    if (!confirm(&page, RetentionWords::tr("Erase the records of %n participant(s)?", "", count),
                 RetentionWords::tr("Answers, attempts and signatures of %1 are deleted. Codes and "
                                    "arms stay. Export first what is still to be analysed.")
                     .arg(codes.join(", ")),
                 RetentionWords::tr("Erase")))
        return;
    context.guard(RetentionWords::tr("Erasing records"), [&] {
        context.require(db::Action::kRunQuestionnaire);
        QStringList gone;
        for (const std::string& code : db::erase_overdue(context.store(), study, db::utc_now()))
            gone << qstr(code);
        Q_EMIT page.notice(RetentionWords::tr("The records of %n participant(s) are erased.", "",
                                              static_cast<int>(gone.size())));
        erased(gone.join(", "));
    });
}

}  // namespace

QWidget* make_retention_card(AppContext& context, Page& page, const std::string& study,
                             const std::function<void(const QString& codes)>& erased) {
    const std::vector<db::KeptRecords> kept = db::kept_records(context.store(), study);
    if (kept.empty()) return nullptr;
    QStringList overdue;
    for (const db::KeptRecords& each : kept)
        if (each.overdue(db::utc_now())) overdue << qstr(each.code);
    auto* layout = new QVBoxLayout;
    layout->setSpacing(kSpace12);
    layout->addWidget(make_label(RetentionWords::tr("How long records are kept"), "heading"));
    const int years = kept.front().keep_years;
    layout->addWidget(make_label(
        RetentionWords::tr("Participants were told: %n year(s) after their last step.", "", years),
        "muted"));
    const int count = static_cast<int>(overdue.size());
    if (count == 0) {
        layout->addWidget(
            make_label(RetentionWords::tr("Nothing is due before %1 (%2).")
                           .arg(day_of(kept.front().until_utc), qstr(kept.front().code))));
        return make_card(layout);
    }
    auto* due =
        make_label(RetentionWords::tr("The time of %n participant(s) is over: %1.", "", count)
                       .arg(overdue.join(", ")),
                   "warn");
    due->setObjectName("retention_due");
    layout->addWidget(due);
    QPushButton* erase =
        make_action(context, &page, RetentionWords::tr("Erase these records"), "danger", "close",
                    "erase_overdue", [&context, &page, study, overdue, erased] {
                        erase_now(context, page, study, overdue, erased);
                    });
    layout->addWidget(erase, 0, Qt::AlignLeft);
    return make_card(layout);
}

}  // namespace placode::ui
