// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl check | backup | restore | attempts | audit

#include <algorithm>
#include <array>
#include <chrono>
#include <map>
#include <memory>
#include <regex>

#include "db/ended_again.h"
#include "db/ended_meanwhile.h"
#include "db/erasure.h"
#include "db/store_url.h"
#include "ui/cli/centre_passphrase.h"
#include "ui/cli/progress.h"
#include "ui/cli/scratch_folder.h"
#include "ui/cli/session.h"
#include "ui/cli/write_file.h"

namespace placode::cli {
namespace {

using db::Action;
using db::Scope;

std::string progress_words(const db::CheckProgress& at) {
    constexpr std::array kSteps{"the file", "the audit trail: entry ",
                                "what the trail says of the store: row ", "recordings: number "};
    const bool counts = at.step != db::CheckProgress::Step::kFile;
    return std::string("checking ") + kSteps[static_cast<size_t>(at.step)] +
           (counts ? std::to_string(at.done + 1) : "");
}

/// Says on a terminal how far it is; Ctrl+C ends it.
std::vector<std::string> problems_of(db::Store& store) {
    const CancelOn cancel{SIGINT, SIGTERM};
    struct Cleared {
        ~Cleared() { clear_progress(); }
    };
    std::optional<std::vector<std::string>> problems;
    {
        const Cleared cleared;
        problems = store.check({CancelOn::requested, [](const db::CheckProgress& at) {
                                    show_progress(progress_words(at));
                                }});
    }
    if (!problems)
        throw std::runtime_error("check: stopped; whether the store is sound is not known");
    return *problems;
}

int check(const Context& context, const std::vector<std::string>& heads) {
    Session session(context, Missing::kRefuse);
    session.need(Action::kBackup, Scope::kOther);
    auto problems = problems_of(session.store());
    for (const std::string& head : heads)
        session.store().audit().check_head(db::read_trail_head(head), problems);
    std::string text;
    for (const std::string& problem : problems) text += problem + "\n";
    if (problems.empty())
        text = session.store().url() + ": sound";
    else
        text += session.store().url() + ": " + std::to_string(problems.size()) +
                " problem(s); restore a backup with `placodectl restore FILE`";
    // No damage, so that a backup of such a store is made all the same.
    const std::string note = clear_key_note(session);
    Json json{
        {"store", session.store().url()}, {"sound", problems.empty()}, {"problems", problems}};
    if (!note.empty()) json["notes"] = Json::array({note});
    print(context, json, note.empty() ? text : text + "\nnote: " + note);
    return problems.empty() ? 0 : 1;
}

int backup(const Context& context, const std::string& path) {
    for (const std::string& file : {path, db::head_file_of(path)}) need_new_file("backup", file);
    const std::string url = store_url_of(context);
    if (context.as_user.empty() && db::parse_store_url(url).engine == db::Engine::kPostgresql) {
        // With the log-in of the tables' owner, who may do all with them; the store refuses others.
        const auto store = db::open_store(url_to_open(context));
        store->act_as("owner of the tables");
        store->backup(path);
        print(context, {{"store", store->url()}, {"backup", path}},
              "backed up " + store->url() + " to " + path);
        return 0;
    }
    Session session(context, Missing::kRefuse);
    session.need(Action::kBackup, Scope::kOther);
    session.store().backup(path);
    const std::string note = clear_key_note(session);
    Json json{{"store", session.store().url()}, {"backup", path}};
    if (!note.empty()) json["notes"] = Json::array({note});
    print(context, json,
          "backed up " + session.store().url() + " to " + path +
              (note.empty() ? "" : "\nnote: " + note));
    return 0;
}

/// The store may be damaged: its own accounts cannot be asked. Its file's owner may do it.
std::string who_restores(const Context& context, const std::string& url) {
    if (context.as_user.empty()) return need_local_administrator(url);
    Session(context, Missing::kRefuse).need(Action::kBackup, Scope::kOther);
    return context.as_user;
}

/// A file that is no backup is bad input: the store is not what failed.
std::string restored(const std::string& url, const std::string& path, const std::string& actor) {
    try {
        return db::restore_store(url, path, actor);
    } catch (const db::StoreError& error) {
        if (error.kind() != db::StoreError::Kind::kDamaged &&
            error.kind() != db::StoreError::Kind::kTooNew)
            throw;
        throw InputError(std::string(error.what()) +
                         "; give a file that `placodectl backup` of this version or an earlier one "
                         "wrote");
    }
}

/// The whole restore in a folder of its own, and what would be there then.
int rehearse(const Context& context, const std::string& path) {
    const std::string actor = who_restores(context, store_url_of(context));
    const auto begin = std::chrono::steady_clock::now();
    const ScratchFolder folder;
    const std::string url = "sqlite:" + folder.path() + "/placode.db";
    (void)restored(url, path, actor);
    const auto store = db::open_store(url);
    std::string newest;
    const auto attempts = store->attempts().list(0);
    for (const auto& attempt : attempts) newest = std::max(newest, attempt.started_utc);
    const size_t people = store->accounts().list().size();
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    print(context,
          {{"restorable", true},
           {"backup", path},
           {"people", people},
           {"attempts", attempts.size()},
           {"newest_attempt_utc", newest},
           {"took_s", took.count()}},
          path + " can be restored: " + std::to_string(people) + " people, " +
              std::to_string(attempts.size()) + " attempts" +
              (newest.empty() ? "" : ", the newest of " + newest) + "; rehearsed in " +
              fixed(took.count(), 1) + " s. Nothing was changed");
    return 0;
}

int restore(const Context& context, const std::string& path) {
    const std::string url = store_url_of(context);
    const std::string actor = who_restores(context, url);
    const std::string aside = restored(url, path, actor);
    const auto store = db::open_store(url);
    const auto last = store->audit().trail(1);
    const bool unknown = !last.empty() && last.front().detail == db::kErasuresUnknown;
    const std::vector<std::string> again = db::done_again(*store);
    const std::vector<std::string> doubted = db::not_believed(*store);
    Json json{{"store", db::parse_store_url(url).shown},
              {"restored_from", path},
              {"erasures_unknown", unknown},
              {"done_again", again},
              {"not_believed", doubted}};
    if (!aside.empty()) json["old_store"] = aside;
    std::string ended;
    for (const std::string& each : again) ended += "\n  " + each;
    if (!ended.empty())
        ended = "\nerased or withdrawn since this backup, and so again in the store:" + ended;
    if (!doubted.empty())
        ended +=
            "\nnot proved in the old store by a computer that this one trusts, and so not done; "
            "look at your list of requests:";
    for (const std::string& each : doubted) ended += "\n  " + each;
    print(context, json,
          "restored " + path + (aside.empty() ? "" : "; the old store is kept as " + aside) +
              ended +
              (unknown ? "\nThe store that was there could not be read. Whoever was erased since "
                         "this backup is back, and so are the data of participants who withdrew "
                         "since: look at your list of requests, and erase them again"
                       : ""));
    return 0;
}

const char* end_name(sim::EndReason reason) {
    constexpr std::array<const char*, 5> kNames{"running", "finished", "time limit", "closed",
                                                "interrupted"};
    return kNames[static_cast<size_t>(reason) % kNames.size()];
}

int attempts(const Context& context, const std::string& login, const std::string& task) {
    Session session(context, Missing::kRefuse);
    int64_t whose = 0;
    if (!login.empty()) {
        whose = session.find_user(login).id;
    } else if (!session.may(Action::kViewAttempts, Scope::kOther)) {
        whose = session.user()->id;  // Without --user a trainee sees the own ones.
    }
    const bool own = session.user() && whose == session.user()->id;
    session.need(Action::kViewAttempts, own ? Scope::kOwn : Scope::kOther);
    Json json = Json::array();
    std::vector<std::vector<std::string>> rows{
        {"id", "started (UTC)", "person", "task", "device", "time s", "points", "verdict", "end"}};
    // Of studies with a participant's code, for who runs studies.
    const bool studies = session.may(Action::kRunQuestionnaire, Scope::kOther);
    for (const auto& attempt : session.store().attempts().list(whose, task)) {
        if (!attempt.study.study.empty() && !studies) continue;
        json.push_back({{"id", attempt.id},
                        {"user_id", attempt.user_id},
                        {"user_name", attempt.user_name},
                        {"task", attempt.task_id},
                        {"task_version", attempt.task_version},
                        {"started_utc", attempt.started_utc},
                        {"duration_s", attempt.duration_s},
                        {"device", attempt.device},
                        {"seed", attempt.seed},
                        {"build", attempt.build},
                        {"end", end_name(attempt.end)},
                        {"demonstration", attempt.demonstration},
                        {"study", attempt.study.study},
                        {"void_reason", attempt.void_reason},
                        {"points", attempt.points},
                        {"verdict", assessment::verdict_name(attempt.verdict)},
                        {"rubric", attempt.rubric_id},
                        {"rubric_version", attempt.rubric_version},
                        {"metric_set_version", attempt.metric_set_version}});
        rows.push_back(
            {std::to_string(attempt.id), attempt.started_utc, attempt.user_name, attempt.task_id,
             attempt.device + (attempt.demonstration ? " (demonstration)" : ""),
             fixed(attempt.duration_s, 1), fixed(attempt.points, 1),
             attempt.void_reason.empty() ? std::string(assessment::verdict_name(attempt.verdict))
                                         : "void",
             end_name(attempt.end)});
    }
    print(context, json, rows.size() == 1 ? "no attempts" : table(rows));
    return 0;
}

/// "user 12 (anna)": the trail holds numbers, and a log-in goes with its person.
std::string with_log_ins(const std::string& text, const std::map<std::string, std::string>& known) {
    static const std::regex kUser("user [0-9]+");
    std::string shown;
    auto from = text.cbegin();
    for (std::sregex_iterator at(text.begin(), text.end(), kUser), end; at != end; ++at) {
        const auto found = known.find(at->str());
        shown.append(from, (*at)[0].second);
        if (found != known.end()) shown += " (" + found->second + ")";
        from = (*at)[0].second;
    }
    return shown.append(from, text.cend());
}

int audit(const Context& context, int limit) {
    Session session(context, Missing::kRefuse);
    session.need(Action::kViewAudit, Scope::kOther);
    Json json = Json::array();
    std::vector<std::vector<std::string>> rows{{"at (UTC)", "who", "did", "what", "detail"}};
    std::map<std::string, std::string> known;
    for (const db::UserRecord& each : session.store().accounts().list())
        known["user " + std::to_string(each.id)] = each.login;
    for (const auto& entry : session.store().audit().trail(limit)) {
        json.push_back({{"id", entry.id},
                        {"at_utc", entry.at_utc},
                        {"actor", entry.actor},
                        {"action", entry.action},
                        {"object", entry.object},
                        {"detail", entry.detail}});
        rows.push_back({entry.at_utc, entry.actor, entry.action, with_log_ins(entry.object, known),
                        with_log_ins(entry.detail, known)});
    }
    print(context, json, table(rows));
    return 0;
}

int audit_set_aside(const Context& context, int64_t entry, const std::string& reason) {
    Session session(context, Missing::kRefuse);
    session.need(Action::kManageUsers, Scope::kOther);
    as_input([&] { session.store().audit().set_aside(entry, reason); },
             db::StoreError::Kind::kNotFound);
    print(context, {{"entry", entry}, {"set_aside", true}},
          "entry " + std::to_string(entry) +
              " is set aside: `placodectl check` names it no more as long as it stays as it is");
    return 0;
}

int audit_head(const Context& context, const std::string& path) {
    need_new_file("--head", path);
    Session session(context, Missing::kRefuse);
    session.need(Action::kBackup, Scope::kOther);
    const db::TrailHead head = session.store().audit().head();
    db::write_trail_head(head, path);
    print(context, {{"file", path}, {"entry", head.entry}, {"station", head.station}},
          "wrote " + path + ": the trail ends at entry " + std::to_string(head.entry) +
              "; keep it away from this computer, and compare with `placodectl check --head " +
              path + "`");
    return 0;
}

// In the order of the help:

void add_check(CLI::App& app, Context& context) {
    auto heads = std::make_shared<std::vector<std::string>>();
    CLI::App* check_command =
        app.add_subcommand("check", "Checks the store: file, references, audit trail, recordings");
    check_command
        ->add_option("--head", *heads,
                     "What `audit --head` or a backup once said of the trail's end")
        ->type_name("FILE");
    check_command->callback(
        [&context, heads] { context.run = [&context, heads] { return check(context, *heads); }; });
}

void add_backup(CLI::App& app, Context& context) {
    auto file = std::make_shared<std::string>();
    CLI::App* backup_command = app.add_subcommand(
        "backup", "Copies the store to FILE while others may use it; of a server with pg_dump");
    backup_command->add_option("FILE", *file, "New file for the copy")->required();
    backup_command->callback(
        [&context, file] { context.run = [&context, file] { return backup(context, *file); }; });
}

void add_restore(CLI::App& app, Context& context) {
    auto file = std::make_shared<std::string>();
    CLI::App* restore_command = app.add_subcommand(
        "restore", "Puts the backup FILE in the place of the store; the old one is kept beside it");
    restore_command->add_option("FILE", *file, "A backup that `backup` wrote")->required();
    auto rehearsal = std::make_shared<bool>(false);
    restore_command->add_flag("--rehearse", *rehearsal,
                              "Restores and checks it in a temporary folder, says what is in it "
                              "and changes nothing");
    restore_command->callback([&context, file, rehearsal] {
        context.run = [&context, file, rehearsal] {
            return *rehearsal ? rehearse(context, *file) : restore(context, *file);
        };
    });
}

void add_attempts(CLI::App& app, Context& context) {
    auto user = std::make_shared<std::string>();
    auto task = std::make_shared<std::string>();
    CLI::App* attempts_command = app.add_subcommand("attempts", "Lists attempts, oldest first");
    attempts_command->add_option("--user", *user, "Login or number");
    attempts_command->add_option("--task", *task, "Task id");
    attempts_command->callback([&context, user, task] {
        context.run = [&context, user, task] { return attempts(context, *user, *task); };
    });
}

void add_audit(CLI::App& app, Context& context) {
    auto limit = std::make_shared<int>(50);
    CLI::App* audit_command = app.add_subcommand("audit", "Shows the audit trail, newest first");
    audit_command->add_option("--limit", *limit, "Number of entries")
        ->check(CLI::Range(1, 1000000));
    auto head = std::make_shared<std::string>();
    audit_command
        ->add_option("--head", *head,
                     "Instead: writes where the trail ends, signed, to FILE, to be kept elsewhere")
        ->type_name("FILE");
    auto aside = std::make_shared<int64_t>(0);
    auto reason = std::make_shared<std::string>();
    CLI::Option* why = audit_command->add_option(
        "--reason", *reason, "Why the entry is set aside: what was found out about it");
    audit_command
        ->add_option("--set-aside", *aside,
                     "Instead: `check` names this entry, which does not fit, no more")
        ->type_name("ENTRY")
        ->needs(why);
    audit_command->callback([&context, limit, head, aside, reason] {
        context.run = [&context, limit, head, aside, reason] {
            if (*aside != 0) return audit_set_aside(context, *aside, *reason);
            return head->empty() ? audit(context, *limit) : audit_head(context, *head);
        };
    });
}

}  // namespace

void add_store_commands(CLI::App& app, Context& context) {
    add_check(app, context);
    add_backup(app, context);
    add_restore(app, context);
    add_attempts(app, context);
    add_audit(app, context);
}

}  // namespace placode::cli
