// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl user data|ask-erasure|erasures|erase: what is kept about a person, and its end.

#include <filesystem>
#include <memory>

#include "db/erasure.h"
#include "db/private_file.h"
#include "reports/people_file.h"
#include "sim/core/counted.h"
#include "ui/cli/people.h"
#include "ui/cli/write_file.h"

namespace placode::cli {
namespace {

using db::Action;
using db::Scope;

struct ErasureOptions {
    std::string login, out, reason, confirm, certificate;
    bool with_attempts = false, recordings = false;
};

int data(const Context& context, const ErasureOptions& options) {
    need_writable_folder("--out", options.out);
    Session session(context, Missing::kRefuse);
    const int64_t id = named_or_self(session, options.login);
    session.need_for(Action::kExportPersonalData, id);
    const reports::OwnData written =
        reports::write_own_data(session.store(), id, options.out, options.recordings);
    print(
        context,
        {{"path", options.out}, {"attempts", written.attempts}, {"recordings", written.recordings}},
        "wrote " + options.out + "/my_data.json with " + sim::counted(written.attempts, "attempt") +
            " and " + sim::counted(written.recordings, "recording"));
    return 0;
}

int ask_erasure(const Context& context, const ErasureOptions& options) {
    Session session(context, Missing::kRefuse);
    const int64_t id = named_or_self(session, options.login);
    session.need_for(Action::kRequestErasure, id);
    as_input([&] { session.store().accounts().request_erasure(id, options.reason); });
    print(context, {{"user_id", id}, {"asked", true}}, "asked; an administrator carries it out");
    return 0;
}

int erasures(const Context& context) {
    Session session(context, Missing::kRefuse);
    session.need(Action::kErase, Scope::kOther);
    Json json = Json::array();
    std::vector<std::vector<std::string>> rows{{"person", "asked (UTC)", "done (UTC)", "reason"}};
    for (const auto& each : session.store().accounts().erasure_requests()) {
        json.push_back({{"user_id", each.user_id},
                        {"asked_utc", each.asked_utc},
                        {"done_utc", each.done_utc},
                        {"reason", each.reason}});
        rows.push_back({std::to_string(each.user_id), each.asked_utc, each.done_utc, each.reason});
    }
    print(context, json, rows.size() == 1 ? "nobody has asked" : table(rows));
    return 0;
}

int erase(const Context& context, const ErasureOptions& options) {
    Session session(context, Missing::kRefuse);
    const db::UserRecord user = session.find_user(options.login);
    session.need_for(Action::kErase, user.id);
    if (options.confirm != user.login)
        throw InputError("user erase: this cannot be undone; repeat the login with --confirm " +
                         user.login);
    // Before anything is gone for good.
    db::PrivateFile certificate(options.certificate);
    if (!options.certificate.empty()) {
        if (std::filesystem::exists(options.certificate))
            throw InputError(options.certificate +
                             " exists and is not overwritten; give another "
                             "name");
        if (!certificate.open(QIODevice::WriteOnly))
            throw InputError(options.certificate + ": cannot be written there: " +
                             certificate.errorString().toStdString());
    }
    const db::Erasure done = as_input([&] {
        return db::erase_person(session.store(), store_url_of(context), user.id,
                                options.with_attempts);
    });
    const bool certified =
        !certificate.isOpen() ||
        (certificate.write(db::erasure_certificate(done).c_str()) > 0 && certificate.commit());
    std::string text =
        "erased; attempts " +
        std::string(options.with_attempts ? "went as well" : "stay without a name") +
        (done.cleaned.empty() ? ""
                              : "; also in " + sim::counted(done.cleaned.size(), "copy", "copies"));
    Json left = Json::array();
    for (const db::LeftCopy& each : done.left) {
        left.push_back({{"path", each.path}, {"why", each.why}});
        text += "\nmay still hold the person: " + each.path + ": " + each.why;
    }
    if (!certified)
        text += "\nthe certificate is not written: " + options.certificate + ": " +
                certificate.errorString().toStdString();
    print(context,
          {{"user_id", user.id},
           {"with_attempts", options.with_attempts},
           {"copies", done.cleaned},
           {"left", left}},
          text);
    return done.left.empty() && certified ? 0 : 1;
}

}  // namespace

void add_erasure_commands(CLI::App& user, Context& context) {
    auto options = std::make_shared<ErasureOptions>();
    const auto command = [&](const char* name, const char* help, auto work) {
        CLI::App* added = user.add_subcommand(name, help);
        added->callback([&context, options, work] {
            context.run = [&context, options, work] { return work(context, *options); };
        });
        return added;
    };
    CLI::App* own = command("data", "Everything that is kept about a person, as files", data);
    own->add_option("--user", options->login, "Login or number (default: whoever acts)");
    own->add_option("--out", options->out, "Folder")->required();
    own->add_flag("--recordings", options->recordings, "With the recording of every attempt");
    CLI::App* asked =
        command("ask-erasure", "Asks an administrator to erase a person", ask_erasure);
    asked->add_option("--user", options->login, "Login or number (default: whoever acts)");
    asked->add_option("--reason", options->reason, "If you like");
    command("erasures", "Who asked to be erased",
            [](const Context& c, const ErasureOptions&) { return erasures(c); });
    CLI::App* erased = command("erase", "Erases a person for good", erase);
    erased->add_option("login", options->login, "Login or number")->required();
    erased->add_option("--confirm", options->confirm, "The login once more");
    erased->add_flag("--with-attempts", options->with_attempts, "The attempts go as well");
    erased->add_option("--certificate", options->certificate,
                       "FILE.txt to write: what was erased where, signed, without the name");
}

}  // namespace placode::cli
