// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/store_context.h"

#include <QDateTime>
#include <algorithm>
#include <charconv>
#include <set>
#include <string_view>

#include "db/named_word.h"
#include "db/password.h"

namespace placode::db {

using Kind = StoreError::Kind;

int64_t StoreContext::now_ms() const {
    return options.now_ms ? options.now_ms() : QDateTime::currentMSecsSinceEpoch();
}

void StoreContext::delete_attempt(int64_t id) {
    touch("attempt", id);
    const std::string scores =
        " WHERE score_id IN (SELECT id FROM attempt_scores WHERE attempt_id "
        "= ?)";
    for (const char* table : {"attempt_score_metrics", "attempt_score_reasons"})
        Statement(connection, std::string("DELETE FROM ") + table + scores).run(id);
    for (const char* table :
         {"attempt_scores", "attempt_metrics", "attempt_reasons", "attempt_events", "recordings"})
        Statement(connection, std::string("DELETE FROM ") + table + " WHERE attempt_id = ?")
            .run(id);
    Statement(connection, "DELETE FROM attempts WHERE id = ?").run(id);
}

std::string StoreContext::kept_name(const std::string& login) {
    const int64_t account = account_of(connection, login_key(login));
    return account != 0 ? user_object(account) : login;
}

std::string StoreContext::shown_name(const std::string& kept) { return person_of(kept, "login"); }

std::string StoreContext::shown_display_name(const std::string& kept) {
    return person_of(kept, "display_name");
}

namespace {

/// Of "user 12"; 0 for anything else.
int64_t number_in(const std::string& kept) {
    constexpr std::string_view kUser = "user ";
    int64_t id = 0;
    const char* const end = kept.data() + kept.size();
    const bool whole =
        kept.starts_with(kUser) && std::from_chars(kept.data() + kUser.size(), end, id).ptr == end;
    return whole ? std::max<int64_t>(id, 0) : 0;
}

}  // namespace

std::string StoreContext::person_of(const std::string& kept, const char* column) {
    const int64_t id = number_in(kept);
    if (id == 0) return kept;
    Statement query(connection,
                    std::string("SELECT ") + column + " FROM persons WHERE account_id = ?");
    return query.run(id).next() ? query.text(0) : kept;
}

namespace {

/// "user 12", "study pilot": what the trail itself says, whoever has such a log-in.
bool is_of_the_trail(const std::string& text, size_t at, size_t size) {
    static const std::set<std::string> kNouns{"assignment", "attempt", "batch", "comment",
                                              "entry",      "group",   "pack",  "invitation",
                                              "norm",       "study",   "task",  "user"};
    return text.size() > at + size && text[at + size] == ' ' &&
           kNouns.contains(text.substr(at, size));
}

void replace_word(std::string& text, const FoldedText& word, const std::string& by) {
    for (size_t from = 0;;) {
        const auto found = FoldedText(text).find(word, from);
        if (!found) return;
        const bool own = is_of_the_trail(text, found->at, found->size);
        if (!own) text.replace(found->at, found->size, by);
        from = found->at + (own ? found->size : by.size());
    }
}

/// Who may be named in a folded text. The engine picks them, because there are thousands of people,
/// and every entry of the trail asks; it knows the case of ASCII letters only, so that names with
/// other letters are always among them.
std::string possible_names(bool sqlite) {
    const auto small = [&](const char* name) {
        return std::string("LOWER(") + name + (sqlite ? ")" : " COLLATE \"C\")");
    };
    const std::string at = sqlite ? "INSTR" : "STRPOS";
    const std::string bytes = sqlite ? "LENGTH(CAST(login || display_name AS BLOB))"
                                     : "OCTET_LENGTH(login || display_name)";
    return "(SELECT CAST(? AS TEXT) AS said) s JOIN persons ON " + at + "(said, " + small("login") +
           ") > 0 OR " + at + "(said, " + small("display_name") + ") > 0 OR " + bytes +
           " > LENGTH(login || display_name)";
}

/// What the server looks into at once; each overlaps the next by more than a name.
std::vector<QVariant> pieces_of(const std::string& typed) {
    constexpr qsizetype kPiece = 4000, kOverlap = 1000;
    const QString all = QString::fromStdString(typed);
    std::vector<QVariant> pieces;
    for (qsizetype at = 0; at == 0 || at + kOverlap < all.size(); at += kPiece - kOverlap)
        pieces.emplace_back(
            QString::fromStdString(in_several_cases(all.mid(at, kPiece).toStdString())));
    return pieces;
}

/// The server's answer to so many pieces: of whoever is named in one, what stands there.
std::string named_in_pieces(size_t pieces) {
    constexpr const char* kOne = "SELECT * FROM placode_guard.named_in(?)";
    std::string sql = kOne;
    for (size_t i = 1; i < pieces; ++i) sql += std::string(" UNION ") + kOne;
    return "(" + sql + ") named";
}

}  // namespace

std::string StoreContext::without_names(const std::string& typed) {
    std::string text = typed;
    // A server shows a station only some names, and answers with those that the text holds; before
    // a sign-in with none.
    const bool guarded = connection.hides_passwords();
    const FoldedText folded(typed);
    const std::vector<QVariant> said =
        guarded ? pieces_of(typed)
                : std::vector<QVariant>{QString::fromStdString(folded.letters())};
    Statement query(connection, "SELECT account_id, login, display_name FROM " +
                                    (guarded ? named_in_pieces(said.size())
                                             : possible_names(connection.is_sqlite())) +
                                    " ORDER BY LENGTH(display_name) DESC, account_id");
    query.run_list(said);
    while (query.next())
        for (const int column : {2, 1})
            if (const FoldedText name(query.text(column)); folded.find(name))
                replace_word(text, name, user_object(query.integer(0)));
    return text;
}

std::optional<UserRecord> StoreContext::find_user(int64_t id) {
    Statement query(connection, user_columns() + "WHERE a.id = ?");
    if (!query.run(id).next()) return std::nullopt;
    return read_user(query);
}

UserRecord StoreContext::need_user(int64_t id) {
    if (const auto found = find_user(id)) return *found;
    connection.fail(Kind::kNotFound, "there is no user " + std::to_string(id));
}

UserRecord StoreContext::need_owner(int64_t id) {
    // Roles are taken with the name when a person is erased.
    Statement query(connection, "SELECT demonstration FROM accounts WHERE id = ? AND roles <> 0");
    if (!query.run(id).next())
        connection.fail(Kind::kNotFound, "there is no user " + std::to_string(id));
    UserRecord owner;
    owner.id = id;
    owner.demonstration = query.integer(0) != 0;
    return owner;
}

int64_t account_of(Connection& connection, const std::string& key, bool only_active) {
    const char* sql =
        "SELECT a.id FROM persons p JOIN accounts a ON a.id = p.account_id WHERE p.login_key = ? "
        "AND (a.active = 1 OR ? = 0)";
    if (connection.hides_passwords())
        sql = "SELECT placode_guard.account_of(?, CAST(? AS INTEGER) <> 0)";
    Statement query(connection, sql);
    return query.run(key, only_active ? 1 : 0).next() ? query.integer(0) : 0;
}

bool any_account(Connection& connection) {
    const bool guarded = connection.hides_passwords();
    Statement query(connection, guarded ? "SELECT 1 WHERE placode_guard.any_account()"
                                        : "SELECT id FROM accounts LIMIT 1");
    return query.run().next();
}

std::optional<UserRecord> StoreContext::find_staff(const std::string& login_or_name) {
    Statement query(
        connection,
        user_columns() +
            "WHERE a.active = 1 AND (a.id = ? OR p.login_key = ? OR p.display_name = ?) "
            "ORDER BY "
            "CASE WHEN p.login_key = ? THEN 0 ELSE 1 END, p.login_key");
    const std::string key = login_key(login_or_name);
    query.run(number_in(login_or_name), key, login_or_name, key);
    std::optional<UserRecord> found;
    // To its end: PostgreSQL gives one answer at a time.
    while (query.next()) {
        UserRecord user = read_user(query);
        if (!found &&
            (has_role(user.roles, Role::kEducator) || has_role(user.roles, Role::kAdministrator)))
            found = std::move(user);
    }
    return found;
}

void StoreContext::need_group(int64_t id) {
    Statement query(connection, "SELECT id FROM training_groups WHERE id = ?");
    if (!query.run(id).next())
        connection.fail(Kind::kNotFound, "there is no group " + std::to_string(id));
}

std::optional<DefinitionRecord> StoreContext::find_definition(const std::string& kind,
                                                              const std::string& id, int version) {
    std::vector<DefinitionRecord> found;
    {
        Statement query(connection,
                        definition_columns() +
                            "WHERE kind = ? AND id = ? AND (? = 0 OR version = ?) ORDER "
                            "BY version DESC LIMIT 1");
        query.run(kind, id, version, version);
        if (!query.next()) return std::nullopt;
        found.push_back(read_definition(query));
    }
    show_names(found, &DefinitionRecord::published_by);
    return found.front();
}

const std::string& user_columns() {
    static const std::string columns =
        "SELECT a.id, p.login, p.display_name, a.roles, a.active, a.demonstration, a.created_utc, "
        "a.password_given FROM accounts a JOIN persons p ON p.account_id = a.id ";
    return columns;
}

UserRecord read_user(const Statement& row) {
    UserRecord user;
    user.id = row.integer("id");
    user.login = row.text("login");
    user.display_name = row.text("display_name");
    user.roles = static_cast<Roles>(row.integer("roles"));
    user.active = row.integer("active") != 0;
    user.demonstration = row.integer("demonstration") != 0;
    user.created_utc = row.text("created_utc");
    user.password_given = row.integer("password_given") != 0;
    return user;
}

const std::string& definition_columns() {
    static const std::string columns =
        "SELECT kind, id, version, content, checksum, reason, published_by, published_utc FROM "
        "definitions ";
    return columns;
}

DefinitionRecord read_definition(const Statement& row) {
    return {row.text("kind"),
            row.text("id"),
            static_cast<int>(row.integer("version")),
            row.text("content"),
            row.text("checksum"),
            row.text("reason"),
            row.text("published_by"),
            row.text("published_utc")};
}

std::string user_object(int64_t id) { return "user " + std::to_string(id); }

}  // namespace placode::db
