// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/study_standing.h"

#include <QCoreApplication>
#include <QStringList>

#include "reports/words.h"
#include "ui/shell/parts.h"

namespace placode::ui {
namespace {

struct StudyStanding {
    Q_DECLARE_TR_FUNCTIONS(StudyStanding)
};

/// Of steps given as "visit/step".
QString names_of(const AppContext& context, const curriculum::StudyProtocol& protocol,
                 const std::vector<std::string>& keys) {
    QStringList names;
    for (const std::string& key : keys) {
        const auto* step = protocol.step(key.substr(key.find('/') + 1));
        names << (step != nullptr ? context.in(step->title) : qstr(key));
    }
    return names.join(", ");
}

}  // namespace

QString standing_remark(const AppContext& context, const curriculum::StudyProtocol& protocol,
                        const db::Progress& progress) {
    QStringList said;
    if (!progress.skipped.empty())
        said
            << StudyStanding::tr("Skipped: %1.").arg(names_of(context, protocol, progress.skipped));
    if (!progress.idle.empty())
        said << StudyStanding::tr("Nothing was done: %1.")
                    .arg(names_of(context, protocol, progress.idle));
    if (progress.participant.withdrawal)
        said << StudyStanding::tr("Withdrew.");
    else if (!progress.open_because.empty())
        said << StudyStanding::tr("To be done again: %1.")
                    .arg(reports::not_done_words(progress.open_because, progress.open_meaning));
    if (progress.participant.demonstration) said << StudyStanding::tr("DEMONSTRATION");
    return said.join(' ');
}

}  // namespace placode::ui
