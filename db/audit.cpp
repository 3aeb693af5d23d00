// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/audit.h"

#include "db/store_context.h"

namespace placode::db {
namespace {

AuditRecord read_audit(const Statement& row) {
    return {row.integer("id"),  row.text("at_utc"), row.text("actor"),
            row.text("action"), row.text("object"), row.text("detail")};
}

}  // namespace

Audit::Audit(StoreContext& context) : context_(context), connection_(context.connection) {}

void Audit::write(const std::string& actor, const std::string& action, const std::string& object,
                  const std::string& detail) {
    connection_.begin_operation("write the audit trail of");
    UnitOfWork work(connection_);
    context_.append_audit_as(actor, action, object, detail);
    work.commit();
}

std::vector<AuditRecord> Audit::trail(int limit) {
    connection_.begin_operation("read the audit trail of");
    Statement query(connection_,
                    "SELECT id, at_utc, actor, action, object, detail FROM audit ORDER BY id DESC "
                    "LIMIT ?");
    query.run(limit);
    std::vector<AuditRecord> trail;
    while (query.next()) trail.push_back(read_audit(query));
    return trail;
}

void Audit::check_chain(std::vector<std::string>& problems) {
    Statement query(connection_,
                    "SELECT id, at_utc, actor, action, object, detail, chain FROM audit ORDER BY "
                    "id");
    query.run();
    std::string previous;
    while (query.next()) {
        const AuditRecord row = read_audit(query);
        const std::string chain = query.text("chain");
        if (chain != audit_chain(previous, row)) {
            problems.push_back("audit: entry " + std::to_string(row.id) +
                               " or the one before it was changed or removed");
            return;
        }
        previous = chain;
    }
}

}  // namespace placode::db
