// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lti/statements.h"

#include <QByteArray>
#include <span>

namespace placode::lti {
namespace {

constexpr size_t kPart = 50;
constexpr size_t kMostProblems = 5;

std::string key_of(const RecordStore& store, const Statement& statement) {
    return store.endpoint + " " + statement.id;
}

WebReply post(const RecordStore& store, std::span<const Statement> part, const Patience& patience) {
    WebCall call;
    call.method = "POST";
    call.address = store.endpoint;
    while (call.address.ends_with('/')) call.address.pop_back();
    call.address += "/statements";
    call.type = "application/json";
    call.headers = {
        {"X-Experience-API-Version", "1.0.3"},
        {"Authorization",
         "Basic " + QByteArray::fromStdString(store.user_pass).toBase64().toStdString()}};
    for (const Statement& each : part) call.body += (call.body.empty() ? "[" : ",") + each.json;
    call.body += "]";
    return ask_patiently(call, patience);
}

/// Sends and keeps in mind.
class Sender {
 public:
    Sender(const RecordStore& store, SentFile& sent, const Patience& patience)
        : store_(store), sent_(sent), patience_(patience) {}

    StatementsSent result;

    /// False: nothing more can be sent.
    [[nodiscard]] bool send(std::span<const Statement> part) {
        const WebReply reply = post(store_, part, patience_);
        if (reply.status == 200 || reply.status == 204) {
            result.sent += static_cast<int>(part.size());
            keep(part);
            return true;
        }
        const bool refused = reply.status >= 400 && reply.status < 500 && reply.status != 401 &&
                             reply.status != 403 && reply.status != 404 && reply.status != 429;
        if (refused && part.size() > 1) {
            for (const Statement& each : part)
                if (!send({&each, 1})) return false;
            return true;
        }
        if (reply.status == 409) {  // The same id in other words, as of another version of ours.
            ++result.there;
            keep(part);
            return true;
        }
        if (result.problems.size() < kMostProblems)
            result.problems.push_back(store_.endpoint + ": " +
                                      (refused ? "statement " + part.front().id + ": " : "") +
                                      problem_of(reply));
        return refused;
    }

 private:
    void keep(std::span<const Statement> part) {
        for (const Statement& each : part) sent_.set(key_of(store_, each), "sent");
        sent_.keep();
    }

    const RecordStore& store_;
    SentFile& sent_;
    Patience patience_;
};

}  // namespace

std::string read_user_pass(const std::string& path) {
    const std::string text = read_secret(path);
    const std::string line = text.substr(0, text.find_first_of("\r\n"));
    if (line.find(':') == std::string::npos)
        throw SettingsError(path + ": expected user:password in the first line");
    return line;
}

bool was_sent(const RecordStore& store, const Statement& statement, const SentFile& sent) {
    return sent.find(key_of(store, statement)).has_value();
}

StatementsSent send_statements(const RecordStore& store, const std::vector<Statement>& statements,
                               SentFile& sent, const Patience& patience) {
    std::vector<Statement> due;
    for (const Statement& each : statements)
        if (!was_sent(store, each, sent)) due.push_back(each);
    Sender sender(store, sent, patience);
    sender.result.before = static_cast<int>(statements.size() - due.size());
    for (size_t at = 0; at < due.size(); at += kPart)
        if (!sender.send(std::span(due).subspan(at, std::min(kPart, due.size() - at)))) break;
    return sender.result;
}

}  // namespace placode::lti
