// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl station list | key | trust: the computers that sign the audit trail

#include <memory>

#include "db/signature.h"
#include "ui/cli/session.h"

namespace placode::cli {
namespace {

using db::Action;
using db::Scope;

int list_stations(const Context& context) {
    Session session(context, Missing::kRefuse);
    session.need(Action::kViewAudit, Scope::kOther);
    Json json = Json::array();
    std::vector<std::vector<std::string>> rows{
        {"station", "", "trusted", "entries", "first (UTC)", "last (UTC)"}};
    for (const db::StationRecord& each : session.store().audit().stations()) {
        const std::string mark = db::fingerprint(each.public_key);
        json.push_back({{"station", mark},
                        {"public_key", each.public_key},
                        {"own", each.own},
                        {"trusted", each.trusted},
                        {"entries", each.entries},
                        {"first_utc", each.first_utc},
                        {"last_utc", each.last_utc}});
        rows.push_back({mark, each.own ? "this computer" : "", each.trusted ? "yes" : "no",
                        std::to_string(each.entries), each.first_utc, each.last_utc});
    }
    print(context, json, rows.size() == 1 ? "nothing is signed in this store yet" : table(rows));
    return 0;
}

int key(const Context& context) {
    Session session(context, Missing::kRefuse);
    const std::string own = session.store().audit().own_station();
    if (own.empty())
        throw InputError(
            "this computer has no key, and none can be made; set PLACODE_STATION_KEY to "
            "a file that can be written");
    print(context, {{"station", db::fingerprint(own)}, {"public_key", own}},
          own + "  (" + db::fingerprint(own) + ")");
    return 0;
}

int trust(const Context& context, const std::string& fingerprint) {
    Session session(context, Missing::kRefuse);
    session.need(Action::kManageUsers, Scope::kOther);
    session.store().audit().trust_station(fingerprint);
    print(context, {{"trusted", fingerprint}}, "the station " + fingerprint + " is trusted");
    return 0;
}

}  // namespace

void add_station_commands(CLI::App& app, Context& context) {
    auto fingerprint = std::make_shared<std::string>();
    CLI::App* station = app.add_subcommand("station", "Computers that sign the audit trail");
    station->require_subcommand(1);
    station->add_subcommand("list", "Lists the stations that have written into the store")
        ->callback([&context] { context.run = [&context] { return list_stations(context); }; });
    station->add_subcommand("key", "Prints the public key of this computer")->callback([&context] {
        context.run = [&context] { return key(context); };
    });
    CLI::App* added = station->add_subcommand(
        "trust",
        "Vouches for a station, so that `check` takes its entries; run it at one that is "
        "trusted");
    added
        ->add_option(
            "STATION", *fingerprint,
            "Its fingerprint, in quotation marks, as `station list` shows it, or the public "
            "key that `station key` prints there")
        ->required();
    added->callback([&context, fingerprint] {
        context.run = [&context, fingerprint] { return trust(context, *fingerprint); };
    });
}

}  // namespace placode::cli
