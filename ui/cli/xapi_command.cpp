// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl xapi send: the statements of the export into a learning record store.

#include <iostream>
#include <memory>

#include "curriculum/utc_time.h"
#include "reports/report.h"
#include "reports/xapi.h"
#include "sim/core/counted.h"
#include "ui/cli/links.h"
#include "ui/cli/session.h"
#include "ui/finite_range.h"
#include "ui/lti/statements.h"

namespace placode::cli {
namespace {

using db::Action;
using db::Scope;

struct XapiOptions {
    std::string endpoint, credentials, study, lti, since, base, sent;
    std::vector<std::string> users;
    bool dry_run = false;
    double wait_s = 2;
};

void check_sending(const XapiOptions& options) {
    try {
        (void)lti::parse_web_address(options.endpoint);
    } catch (const std::invalid_argument& error) {
        throw InputError(std::string("--endpoint: ") + error.what());
    }
    try {
        (void)reports::checked_base_uri(options.base);
    } catch (const reports::ReportError& error) {
        throw InputError(std::string("--base: ") + error.what());
    }
    const int of = static_cast<int>(!options.study.empty()) +
                   static_cast<int>(!options.users.empty()) +
                   static_cast<int>(!options.lti.empty());
    if (of != 1) throw InputError("xapi send: expected one of --study, --user and --linked");
    if (!options.since.empty() && !curriculum::utc_seconds(options.since))
        throw InputError("--since: found \"" + options.since +
                         "\"; expected a day or a time in UTC, as 2026-11-21");
}

std::vector<db::UserRecord> people_of(Session& session, const XapiOptions& options,
                                      LeftOut& left_out) {
    if (!options.lti.empty()) return linked_people(session, options.lti, left_out);
    std::vector<db::UserRecord> people;
    for (const std::string& login : options.users) people.push_back(session.find_user(login));
    return people;
}

/// As the export makes them: pseudonyms, nobody who withdrew, no field that names a person.
std::vector<reports::Dataset> data_sets(Session& session, const XapiOptions& options,
                                        LeftOut& left_out) {
    const reports::DatasetOptions plain{false, "en", options.base};
    if (!options.study.empty()) {
        session.need(Action::kExportStudy, Scope::kOther);
        return {reports::study_dataset(session.store(), options.study, plain)};
    }
    std::vector<reports::Dataset> all;
    for (const db::UserRecord& user : people_of(session, options, left_out)) {
        const bool own = session.user() && session.user()->id == user.id;
        session.need(Action::kViewAttempts, own ? Scope::kOwn : Scope::kOther);
        all.push_back(reports::user_dataset(session.store(), user, plain));
    }
    return all;
}

std::vector<lti::Statement> statements_of(Session& session, const XapiOptions& options,
                                          LeftOut& left_out) {
    const int64_t since = options.since.empty() ? 0 : *curriculum::utc_seconds(options.since);
    std::vector<lti::Statement> all;
    for (const reports::Dataset& data : data_sets(session, options, left_out))
        for (reports::XapiStatement& each : reports::xapi_statements(data))
            if (curriculum::utc_seconds(each.timestamp).value_or(0) >= since)
                all.push_back({std::move(each.id), std::move(each.json)});
    return all;
}

void complain(const std::string& problem) { std::cerr << "placodectl: " << problem << '\n'; }

int run_send(const Context& context, const XapiOptions& options) {
    check_sending(options);
    const lti::RecordStore record_store{options.endpoint, lti::read_user_pass(options.credentials)};
    Session session(context, Missing::kRefuse);
    LeftOut left_out;
    const auto statements = statements_of(session, options, left_out);
    for (const std::string& each : left_out.erased) complain(each);
    lti::SentFile sent(options.sent.empty() ? options.credentials + ".sent" : options.sent);
    if (options.dry_run) {
        for (const std::string& each : left_out.problems) complain(each);
        Json due = Json::array();
        std::string text;
        for (const lti::Statement& each : statements)
            if (!lti::was_sent(record_store, each, sent)) {
                due.push_back(Json::parse(each.json));
                text += each.json + "\n";
            }
        print(context, {{"dry_run", true}, {"statements", due}},
              text + sim::counted(due.size(), "statement") + " to be sent; none was");
        return 0;
    }
    lti::StatementsSent result =
        lti::send_statements(record_store, statements, sent, {3, options.wait_s});
    if (result.sent > 0)
        session.store().audit().write(
            session.actor(), "xapi.send",
            !options.study.empty() ? "study " + options.study
            : options.lti.empty()  ? sim::counted(options.users.size(), "person", "people")
                                   : "everybody linked in " + options.lti,
            sim::counted(result.sent, "statement") + " to " + options.endpoint);
    result.problems.insert(result.problems.begin(), left_out.problems.begin(),
                           left_out.problems.end());
    for (const std::string& each : result.problems) complain(each);
    print(context,
          {{"sent", result.sent},
           {"there_already", result.there},
           {"sent_before", result.before},
           {"problems", result.problems}},
          sim::counted(result.sent, "statement") + " sent, " + std::to_string(result.there) +
              " there already, " + std::to_string(result.before) + " sent before" +
              (result.problems.empty() ? ""
                                       : "; run it again for the others, nothing is sent twice"));
    return result.problems.empty() ? 0 : 1;
}

}  // namespace

void add_xapi_command(CLI::App& app, Context& context) {
    CLI::App* xapi = app.add_subcommand("xapi", "Statements for a learning record store");
    xapi->require_subcommand(1);
    auto options = std::make_shared<XapiOptions>();
    CLI::App* command = xapi->add_subcommand(
        "send",
        "Send what `export xapi` writes, but for attempts that wait for `verify`; what was sent "
        "before is not sent again");
    command
        ->add_option("--endpoint", options->endpoint,
                     "Of the record store, without /statements; https")
        ->required();
    command
        ->add_option("--credentials", options->credentials,
                     "File with user:password, for its owner alone (mode 600)")
        ->required();
    command->add_option("--study", options->study, "Study id");
    command->add_option("--user", options->users, "Logins or numbers")->expected(1, -1);
    command->add_option("--linked", options->lti,
                        "FILE.json: everybody who is linked with a platform (`lti link`)");
    command->add_option("--since", options->since, "Only what is of this day or later [UTC]");
    command
        ->add_option("--base", options->base,
                     "https address that the centre owns, as --fhir-base of the export")
        ->type_name("URI");
    command->add_option("--sent", options->sent,
                        "File that remembers what was sent (default: beside the credentials)");
    command->add_option("--wait", options->wait_s, "Before a second try [s]")
        ->check(ui::finite_range(0.0, 60.0))
        ->capture_default_str();
    command->add_flag("--dry-run", options->dry_run, "Print the statements and send none");
    command->callback([&context, options] {
        context.run = [&context, options] { return run_send(context, *options); };
    });
}

}  // namespace placode::cli
