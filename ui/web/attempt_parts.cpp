// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/web/attempt_parts.h"

#include "curriculum/task.h"
#include "reports/words.h"
#include "ui/web/words.h"

namespace placode::web {

reports::TaskScope scope_of_task(const db::AttemptDetail& detail) {
    try {
        return reports::scope_of(curriculum::load_task(detail.record.task_id));
    } catch (const std::exception&) {
        return {};
    }
}

reports::LedgerPicture ledger_of(const db::AttemptDetail& detail, const reports::TaskScope& scope) {
    sim::Recording recording;  // Without samples: the time line needs none.
    recording.header.task_id = detail.record.task_id;
    recording.end.duration_s = detail.record.duration_s;
    recording.events = detail.events;
    return reports::ledger_picture(recording, scope);
}

Html entry_words(const assessment::LedgerEntry& entry) {
    Html what = text(reports::ledger_words(entry));
    if (entry.has_place) what << ", " << Web::phrase("%1 o'clock", text(entry.hour));
    if (entry.critical) what << " " << badge(Web::phrase("critical"), Tone::kCritical);
    return what;
}

}  // namespace placode::web
