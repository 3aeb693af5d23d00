// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/server_session.h"

#include <sodium.h>

#include <array>
#include <map>
#include <mutex>
#include <utility>

#include "db/hex.h"
#include "db/password.h"
#include "db/store_context.h"

namespace placode::db {
namespace {

constexpr int kMostPins = 3;
// What the server unmasks as what (db/station_guard_sql.cpp).
constexpr uint8_t kHash = 1, kCode = 2;

using Digest = std::array<unsigned char, crypto_hash_sha256_BYTES>;

Digest sha256(const std::string& bytes) {
    need_sodium();
    Digest digest{};
    crypto_hash_sha256(digest.data(), reinterpret_cast<const unsigned char*>(bytes.data()),
                       bytes.size());
    return digest;
}

std::string proof_of(const std::string& channel, const std::string& what) {
    return hex_of(sha256(channel + what));
}

/// `text` under a stream of the channel's secret, hexadecimal.
std::string masked(const std::string& channel, uint8_t label, const std::string& text) {
    std::string bytes = text;
    Digest pad{};
    for (size_t i = 0; i < bytes.size(); ++i) {
        const size_t block = i / pad.size();
        if (i % pad.size() == 0)
            pad = sha256(channel + std::string{0, 0, 0, static_cast<char>(label), 0, 0, 0,
                                               static_cast<char>(block)});
        bytes[i] = static_cast<char>(static_cast<unsigned char>(bytes[i]) ^ pad[i % pad.size()]);
    }
    return hex_of({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()});
}

/// Who has signed in in this program, by the store's address and the account.
struct Ticket {
    std::string token;
    bool resting = false;  ///< Signed out: it is good for a PIN only.
};
using Place = std::pair<std::string, int64_t>;
std::mutex tickets_mutex;
std::map<Place, Ticket>& tickets() {
    static std::map<Place, Ticket> all;
    return all;
}

Ticket ticket_of(const Place& place) {
    const std::lock_guard lock(tickets_mutex);
    const auto found = tickets().find(place);
    return found == tickets().end() ? Ticket{} : found->second;
}

/// A channel and its use in one: past the watch of the store's transactions, which would write the
/// trail.
class QuietTransaction {
 public:
    explicit QuietTransaction(Connection& connection) : connection_(connection) {
        connection_.execute("BEGIN READ WRITE");  // Also where all else is for reading only.
    }
    ~QuietTransaction() {
        if (open_) QSqlQuery(connection_.handle()).exec(QStringLiteral("ROLLBACK"));
    }
    QuietTransaction(const QuietTransaction&) = delete;
    QuietTransaction& operator=(const QuietTransaction&) = delete;
    void commit() {
        open_ = false;
        connection_.execute("COMMIT");
    }

 private:
    Connection& connection_;
    bool open_ = true;
};

}  // namespace

ServerSession::ServerSession(Connection& connection) : connection_(connection) {
    connection_.after_reopening([this] { again(); });
}

// A further connection's session ends with it. That of a sign-in stays for other connections of
// this program, until somebody signs out or the server has forgotten it.
ServerSession::~ServerSession() {
    connection_.after_reopening({});
    if (token_.empty() || entered_ || !connection_.handle().isOpen()) return;
    QSqlQuery query(connection_.handle());
    for (const char* each : {"BEGIN READ WRITE", "SELECT placode_guard.leave(false)", "COMMIT"})
        query.exec(QString::fromLatin1(each));
}

std::string ServerSession::open_channel() {
    Statement query(connection_, "SELECT placode_guard.open_channel()");
    std::string secret(crypto_hash_sha256_BYTES, '\0');
    if (!query.run().next() ||
        !bytes_of_hex(query.text(0),
                      {reinterpret_cast<unsigned char*>(secret.data()), secret.size()}))
        connection_.fail(StoreError::Kind::kOther, "the server gave no channel");
    return secret;
}

void ServerSession::remember(int64_t account) {
    Statement query(connection_,
                    "SELECT placode_guard.me(), current_setting('placode.session', true)");
    if (!query.run().next() || query.integer(0) != account) return;  // It is closed.
    account_ = account;
    token_ = query.text(1);
    entered_ = true;
    const std::lock_guard lock(tickets_mutex);
    tickets()[{connection_.url().shown, account}] = {token_, false};
}

std::optional<UserRecord> ServerSession::enter(const std::string& login_key,
                                               const std::string& password) {
    std::string salt;
    {
        Statement query(connection_, "SELECT placode_guard.salt_of(?)");
        if (query.run(login_key).next()) salt = query.text(0);
    }
    const std::string hash = hash_password_as(salt, password);
    const std::string channel = open_channel();
    std::optional<UserRecord> user;
    {
        Statement query(connection_,
                        "SELECT id, login, display_name, roles, active, demonstration, "
                        "created_utc, password_given FROM placode_guard.enter(?, ?, CAST(? AS "
                        "BOOLEAN))");
        if (query.run(login_key, proof_of(channel, hash), confirms_ ? "false" : "true").next())
            user = read_user(query);
    }
    if (user && !confirms_) remember(user->id);
    return user;
}

int64_t ServerSession::enter_by_pin(int64_t account, const std::string& pin) {
    const std::string token = ticket_of({connection_.url().shown, account}).token;
    std::string salt;
    {
        const std::string channel = open_channel();
        Statement query(connection_, "SELECT placode_guard.pin_salt_of(?, ?)");
        if (query.run(account, proof_of(channel, token)).next()) salt = query.text(0);
    }
    if (salt.empty()) return 0;
    const std::string hash = hash_password_as(salt, pin);
    const std::string channel = open_channel();
    int64_t found = 0;
    {
        Statement query(connection_, "SELECT placode_guard.enter_by_pin(?, ?, ?, ?)");
        if (query.run(account, proof_of(channel, token), proof_of(channel, hash), kMostPins).next())
            found = query.integer(0);
    }
    if (found != 0) remember(found);
    return found;
}

bool ServerSession::resume_with(const std::string& token) {
    QuietTransaction work(connection_);
    const std::string channel = open_channel();
    bool resumed = false;
    {
        Statement query(connection_,
                        "SELECT CASE WHEN placode_guard.resume(?, ?) THEN 1 ELSE 0 END");
        resumed = query.run(account_, proof_of(channel, token)).next() && query.integer(0) != 0;
    }
    if (resumed) {
        Statement token(connection_, "SELECT current_setting('placode.session', true)");
        if (token.run().next()) token_ = token.text(0);
    }
    work.commit();
    return resumed;
}

void ServerSession::resume(int64_t account) {
    if (!guards() || account_ == account) return;
    const Ticket ticket = ticket_of({connection_.url().shown, account});
    if (ticket.token.empty() || ticket.resting) return;
    account_ = account;
    entered_ = false;
    if (!resume_with(ticket.token)) {
        account_ = 0;
        token_.clear();
    }
}

void ServerSession::again() {
    if (token_.empty()) return;
    const std::string token = token_;
    if (!resume_with(token)) {
        account_ = 0;
        token_.clear();
        return;
    }
    if (!entered_) return;
    const std::lock_guard lock(tickets_mutex);
    tickets()[{connection_.url().shown, account_}] = {token_, false};
}

void ServerSession::leave() noexcept {
    if (token_.empty()) return;
    bool told = false;
    try {
        connection_.execute(entered_ ? "SELECT placode_guard.leave(true)"
                                     : "SELECT placode_guard.leave(false)");
        told = true;
    } catch (const std::exception&) {
        // The server is away. Nobody has the token then, and it forgets the session by itself.
    }
    const std::lock_guard lock(tickets_mutex);
    const auto found = tickets().find({connection_.url().shown, account_});
    if (found != tickets().end() && found->second.token == token_) {
        if (told)
            found->second.resting = true;
        else
            tickets().erase(found);
    }
    token_.clear();
    account_ = 0;
    entered_ = false;
}

int64_t ServerSession::add_account(const NewAccount& account) {
    const std::string channel = open_channel();
    Statement query(connection_, "SELECT placode_guard.add_account(?, ?, ?, ?, ?, ?, ?, ?)");
    return query
        .run(masked(channel, kHash, account.hash), account.roles, account.demonstration,
             account.password_given, account.created_utc, account.login, account.login_key,
             account.display_name)
        .returned_id();
}

int64_t ServerSession::accept_invitation(const std::string& code, const NewAccount& account) {
    const std::string channel = open_channel();
    Statement query(connection_, "SELECT placode_guard.accept_invitation(?, ?, ?, ?, ?, ?, ?)");
    return query
        .run(masked(channel, kCode, code), masked(channel, kHash, account.hash),
             account.demonstration, account.created_utc, account.login, account.login_key,
             account.display_name)
        .returned_id();
}

void ServerSession::set_password(int64_t account, const std::string& hash, bool given) {
    const std::string channel = open_channel();
    Statement(connection_, "SELECT placode_guard.set_password(?, ?, ?)")
        .run(account, masked(channel, kHash, hash), given);
}

void ServerSession::set_pin(int64_t account, const std::string& hash) {
    const std::string channel = open_channel();
    Statement(connection_, "SELECT placode_guard.set_pin(?, ?)")
        .run(account, masked(channel, kHash, hash));
}

void ServerSession::drop_worn_pin(int64_t account) {
    Statement(connection_, "SELECT placode_guard.drop_worn_pin(?)").run(account);
}

}  // namespace placode::db
