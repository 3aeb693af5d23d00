// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cli/session.h"

#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <charconv>

#include "db/password.h"
#include "db/said.h"
#include "db/store_url.h"
#include "sim/core/near_word.h"

namespace placode::cli {
namespace {

std::string name_of_the_one_at_the_machine() {
    const passwd* user = ::getpwuid(::geteuid());
    return user != nullptr ? user->pw_name : std::to_string(::geteuid());
}

/// An address that cannot be read is bad input.
db::StoreUrl parse_url(const std::string& url) {
    try {
        return db::parse_store_url(url);
    } catch (const db::StoreError& error) {
        throw InputError(error.what());
    }
}

bool file_is_there(const db::StoreUrl& url) {
    struct stat status {};
    return ::stat(url.path.c_str(), &status) == 0;
}

}  // namespace

std::string store_url_of(const Context& context) {
    return context.store_url.empty() ? db::default_store_url() : context.store_url;
}

std::string url_to_open(const Context& context) { return url_to_open(store_url_of(context)); }

std::string url_to_open(const std::string& url) {
    const db::StoreUrl parsed = parse_url(url);
    if (!db::needs_password(parsed) || ::isatty(STDIN_FILENO) == 0) return url;
    return db::with_password(url,
                             read_password("PGPASSWORD", "Password for " + parsed.shown, false));
}

void refuse_open_password(const std::string& option, const std::string& url) {
    if (url.find(":") == std::string::npos) return;
    std::string password;
    try {
        password = db::parse_store_url(url).password;
    } catch (const db::StoreError&) {
        return;  // The command says what is wrong with the address.
    }
    if (!password.empty())
        throw InputError(
            option +
            ": the address holds a password, and everybody on this computer can read it there "
            "(ps); leave it out, and put it in ~/.pgpass (mode 600) or $PGPASSWORD, or type it "
            "when asked");
}

std::string need_local_administrator(const std::string& url) {
    const db::StoreUrl parsed = parse_url(url);
    const std::string way_out = "; give --as USER with the role for it";
    if (parsed.engine != db::Engine::kSqlite)
        throw AccessError(parsed.shown +
                          ": nobody is administrator of a server just by being here" + way_out);
    struct stat status {};
    if (::stat(parsed.path.c_str(), &status) == 0 && status.st_uid != ::geteuid())
        throw AccessError(parsed.shown + ": the file belongs to another user of this machine" +
                          way_out);
    return "local administrator (" + name_of_the_one_at_the_machine() + ")";
}

Session::Session(const Context& context, Missing missing) {
    const std::string url = store_url_of(context);
    const db::StoreUrl parsed = parse_url(url);
    if (context.as_user.empty()) actor_ = need_local_administrator(url);
    if (missing == Missing::kRefuse && parsed.engine == db::Engine::kSqlite &&
        !file_is_there(parsed) && !db::store_was_here(url))
        throw InputError("open " + parsed.shown +
                         ": there is no such store; give the right one with --store, or create it "
                         "with `placodectl user add`");
    const std::string password =
        context.as_user.empty()
            ? std::string()
            : read_password("PLACODE_PASSWORD", "Password of " + context.as_user, false);
    db::StoreOptions options;
    options.begin_anew = missing == Missing::kBeginAnew;
    url_ = url_to_open(context);
    store_ = db::open_store(url_, options);
    if (context.as_user.empty()) {
        store_->act_as(actor_);
        return;
    }
    const db::SignIn sign_in = store_->accounts().sign_in(context.as_user, password);
    const std::string prefix = "sign in as " + context.as_user + " to " + parsed.shown + ": ";
    switch (sign_in.outcome) {
        case db::SignInOutcome::kOk:
            user_ = sign_in.user;
            actor_ = user_->login;
            return;
        case db::SignInOutcome::kWrong:
            throw AccessError(
                prefix +
                "login or password is wrong; try again, or have an administrator set a "
                "new password");
        case db::SignInOutcome::kThrottled:
            throw AccessError(prefix + "too many wrong passwords; try again in " +
                              std::to_string(sign_in.wait_s) + " s");
        case db::SignInOutcome::kDeactivated:
            throw AccessError(prefix + "the account is deactivated; ask an administrator");
    }
}

db::Store& Session::program_store() {
    if (!user_) return *store_;
    if (!program_store_) {
        program_store_ = db::open_store(url_);
        program_store_->act_as(actor_);
    }
    return *program_store_;
}

bool Session::may(db::Action action, db::Scope scope) const {
    return !user_ || db::allowed(user_->roles, action, scope);
}

void Session::need(db::Action action, db::Scope scope) const {
    if (!may(action, scope)) throw AccessError(user_->login + ": " + db::refusal(action).english());
}

void Session::need_for(db::Action action, int64_t subject) const {
    if (user_) need(action, db::scope_between(*store_, user_->id, subject));
}

db::UserRecord Session::find_user(const std::string& login_or_id) {
    if (!may(db::Action::kViewPersonalData, db::Scope::kOther)) {
        if (login_or_id == std::to_string(user_->id)) return *user_;
        if (db::login_key(login_or_id) == db::login_key(user_->login)) return *user_;
        need(db::Action::kViewPersonalData, db::Scope::kOther);
    }
    const auto by_login = store_->accounts().find_login(login_or_id);
    int64_t id = 0;
    const char* end = login_or_id.data() + login_or_id.size();
    const auto [rest, error] = std::from_chars(login_or_id.data(), end, id);
    const auto by_number =
        error == std::errc{} && rest == end ? store_->accounts().find(id) : std::nullopt;
    // An earlier version let somebody choose another account's number as login.
    if (by_login && by_number && by_login->id != by_number->id)
        throw InputError("user \"" + login_or_id + "\": is the login of account " +
                         std::to_string(by_login->id) + " and the number of account \"" +
                         by_number->login + "\"; give " + std::to_string(by_login->id) + " or " +
                         by_number->login);
    if (by_login) return *by_login;
    if (by_number) return *by_number;
    std::vector<std::string> logins;
    for (const db::UserRecord& each : store_->accounts().list()) logins.push_back(each.login);
    throw InputError("user \"" + login_or_id + "\": not in " + store_->url() +
                     "; `placodectl user list` shows them" +
                     sim::did_you_mean(login_or_id, logins));
}

}  // namespace placode::cli
