// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The functions of the schema placode_guard about exams, as SQL. How they are set up:
// db/station_guard_sql.cpp.
#include "db/station_guard.h"

namespace placode::db {

// An exam is begun by who is examined, and now: its time is what the recording's is compared with.
const char* const kGuardExams = R"sql(
CREATE OR REPLACE FUNCTION placode_guard.need_begin(who BIGINT, at TEXT) RETURNS BOOLEAN
LANGUAGE plpgsql STABLE SECURITY DEFINER SET search_path = pg_catalog, pg_temp AS $$
BEGIN
    RETURN placode_guard.insist(placode_guard.trusted() OR (who <> 0 AND who = placode_guard.me() AND
        at::TIMESTAMPTZ BETWEEN clock_timestamp() - INTERVAL '1 minute' AND clock_timestamp() + INTERVAL '1 minute'));
END $$
)sql";

}  // namespace placode::db
