// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/definitions.h"

#include <sodium.h>
#include <algorithm>
#include <array>

#include "curriculum/course.h"
#include "curriculum/questionnaire.h"
#include "curriculum/shipped_definitions.h"
#include "curriculum/standard.h"
#include "curriculum/study.h"
#include "curriculum/task.h"
#include "db/consent_encryption.h"
#include "db/packing.h"
#include "db/store_context.h"

namespace placode::db {
namespace {

using Kind = StoreError::Kind;

constexpr std::array<std::string_view, 7> kKinds{
    "questionnaire", "study", "course", "rubric", "standard", "consent_seal", "task"};

/// Throws DefinitionError: only what can be read again is published.
void check_content(const DefinitionRecord& definition) {
    const std::string origin = definition.kind + " " + definition.id;
    std::string id;
    int version = 0;
    if (definition.kind == "questionnaire") {
        const auto read = curriculum::load_questionnaire_text(definition.json, origin);
        id = read.id, version = read.version;
    } else if (definition.kind == "course") {
        const auto read = curriculum::load_course_text(definition.json, origin);
        id = read.id, version = read.version;
    } else if (definition.kind == "rubric") {
        const auto read = curriculum::load_rubric_text(definition.json, origin);
        id = definition.id.substr(0, definition.id.find('/') + 1) + read.id, version = read.version;
    } else if (definition.kind == "standard") {
        const auto read = curriculum::load_standard_text(definition.json, origin);
        id = read.task_id, version = read.version;
    } else if (definition.kind == "task") {
        const auto read = curriculum::load_task_text(definition.json, origin);
        id = read.id, version = read.version;
    } else if (definition.kind == "consent_seal") {
        const auto read = consent_key_of(definition.json);
        id = read.study_id, version = read.version;
    } else {
        const auto read = curriculum::load_study_text(definition.json, origin);
        id = read.id, version = read.version;
    }
    if (id != definition.id || version != definition.version)
        throw curriculum::DefinitionError(origin, "/id",
                                          "is " + id + " version " + std::to_string(version) +
                                              "; expected version " +
                                              std::to_string(definition.version));
}

/// The text that the program was built with: whoever uses it first has the store keep it. A folder
/// of definitions vouches for nothing, because whoever starts the program chooses it.
bool is_shipped(const DefinitionRecord& definition) {
    if (definition.kind == "task") {
        const auto task = curriculum::shipped_task(definition.id);
        return task && task->json == definition.json;
    }
    if (definition.kind != "course" && definition.kind != "questionnaire") return false;
    return curriculum::shipped_text(definition.kind + "s", definition.id) == definition.json;
}

/// An exam asks for the newest text of its task, and the simulator performs the one that the
/// program was built with: another one would stop every exam of this task.
void need_own_id(const Connection& connection, const DefinitionRecord& definition) {
    if (definition.kind != "task") return;
    const auto shipped = curriculum::shipped_task(definition.id);
    if (!shipped || shipped->version > definition.version || shipped->json == definition.json)
        return;
    connection.fail(Kind::kRefused,
                    Said::that("%1 is a task of Placode itself, which has version %2 of it; give "
                               "your text an id of its own")
                        .with(definition.id)
                        .with(shipped->version));
}

/// Arms are kept as numbers: once somebody is allocated, each number keeps its name.
void need_same_arms(Connection& connection, const DefinitionRecord& before,
                    const DefinitionRecord& after) {
    const auto arms = [](const DefinitionRecord& each) {
        return curriculum::load_study_text(each.json, "study " + each.id).arms;
    };
    const auto old_arms = arms(before), new_arms = arms(after);
    if (!old_arms) return;
    const auto& names = old_arms->names;
    const auto same = [](const auto& a, const auto& b) { return a.en == b.en; };
    if (new_arms && new_arms->names.size() >= names.size() &&
        std::equal(names.begin(), names.end(), new_arms->names.begin(), same))
        return;
    Statement allocated(connection,
                        "SELECT 1 FROM participant_states WHERE study_id = ? AND arm >= 0 LIMIT 1");
    if (allocated.run(after.id).next())
        connection.fail(Kind::kRefused,
                        Said::that("participants are allocated to the arms of version %1; keep "
                                   "their names and order, and add others only behind them")
                            .with(before.version));
}

Action action_of(const std::string& kind) {
    if (kind == "course") return Action::kManageCourses;
    const bool judges = kind == "rubric" || kind == "standard" || kind == "task";
    return judges ? Action::kSetStandards : Action::kRunQuestionnaire;
}

/// What stands in clear is encrypted; what was encrypted for an earlier key stays as it is.
void encrypt_signatures(StoreContext& context, const DefinitionRecord& definition) {
    Connection& connection = context.connection;
    const std::string key = consent_key_of(definition.json).public_key;
    std::vector<std::pair<std::string, std::string>> clear;
    Statement query(connection, "SELECT code, path FROM consent_signatures WHERE study_id = ?");
    query.run(definition.id);
    while (query.next())
        if (!is_encrypted(query.text("path")))
            clear.emplace_back(query.text("code"), query.text("path"));
    for (const auto& [code, path] : clear) {
        context.touch("participant", {definition.id, code});
        Statement(connection,
                  "UPDATE consent_signatures SET path = ? WHERE study_id = ? AND code = ?")
            .run(encrypted(path, key), definition.id, code);
    }
}

}  // namespace

Definitions::Definitions(StoreContext& context)
    : context_(context), connection_(context.connection) {}

void Definitions::publish(const DefinitionRecord& definition) {
    const std::string name =
        definition.kind + " " + definition.id + " version " + std::to_string(definition.version);
    connection_.begin_operation("publish " + name + " in");
    context_.need(Action::kUseStore);
    const Action action = action_of(definition.kind);
    if (!context_.may(action) && !is_shipped(definition)) context_.refuse(action);
    if (std::find(kKinds.begin(), kKinds.end(), definition.kind) == kKinds.end())
        connection_.fail(Kind::kRefused,
                         Said::that("only questionnaires, studies, courses, tasks, rubrics, "
                                    "standards and seals of consents are published"));
    check_content(definition);
    UnitOfWork work(connection_);
    connection_.lock_table("definitions");
    const auto there = context_.find_definition(definition.kind, definition.id, definition.version);
    if (there && there->json == definition.json) return;
    need_own_id(connection_, definition);
    if (there)
        connection_.fail(Kind::kConflict,
                         Said::that("%1 is published with another text, which is never changed; "
                                    "give your text the next version")
                             .with(name));
    const auto newest = context_.find_definition(definition.kind, definition.id, 0);
    if (newest && newest->version > definition.version)
        connection_.fail(
            Kind::kConflict,
            Said::that("version %1 is published already; give your text a higher version")
                .with(newest->version));
    if (newest && definition.reason.empty())
        connection_.fail(Kind::kRefused, Said::that("an amendment needs a reason"));
    if (newest && definition.kind == "study") need_same_arms(connection_, *newest, definition);
    Statement(connection_,
              "INSERT INTO definitions (kind, id, version, content, checksum, reason, "
              "published_by, published_utc) VALUES (?, ?, ?, ?, ?, ?, ?, ?)")
        .run(definition.kind, definition.id, definition.version, definition.json,
             checksum_hex(definition.json), definition.reason, context_.actor.name, utc_now());
    if (definition.kind == "study" && !newest) {
        uint64_t seed = 0;
        randombytes_buf(&seed, sizeof seed);
        Statement(connection_, "INSERT INTO study_allocations (study_id, seed) VALUES (?, ?)")
            .run(definition.id, std::to_string(seed));
        context_.made("allocation", {definition.id});
    }
    if (definition.kind == "consent_seal") encrypt_signatures(context_, definition);
    context_.made("definition",
                  {definition.kind, definition.id, std::to_string(definition.version)});
    context_.append_audit(definition.kind + ".publish",
                          definition.id + " version " + std::to_string(definition.version),
                          context_.without_names(definition.reason));
    work.commit();
}

std::optional<DefinitionRecord> Definitions::find(const std::string& kind, const std::string& id,
                                                  int version) {
    connection_.begin_operation("read the " + kind + " " + id + " from");
    context_.need(Action::kUseStore);
    return context_.find_definition(kind, id, version);
}

std::vector<DefinitionRecord> Definitions::list(const std::string& kind) {
    connection_.begin_operation("list published definitions of");
    context_.need(Action::kUseStore);
    Statement query(connection_, definition_columns() + "WHERE kind = ? ORDER BY id, version");
    query.run(kind);
    std::vector<DefinitionRecord> found;
    while (query.next()) found.push_back(read_definition(query));
    context_.show_names(found, &DefinitionRecord::published_by);
    return found;
}

}  // namespace placode::db
