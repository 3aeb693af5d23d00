// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The portal without the network: a request in, an answer out. Who is signed in sees what the store
// shows them; the only thing that can be sent is a sign-in or a sign-out.

#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "ui/web/answers.h"
#include "ui/web/pages.h"
#include "ui/web/review_maker.h"
#include "ui/web/sessions.h"
#include "ui/web/words.h"

namespace placode::lti {
struct Launch;
struct Platform;
}  // namespace placode::lti

namespace placode::web {

struct LtiVisitors;

struct PortalOptions {
    std::string store_url;
    db::StoreOptions store;          ///< Tests: cheap passwords.
    bool behind_tls = false;         ///< Browsers reach it by https: cookies say Secure.
    std::function<int64_t()> now_s;  ///< Of sessions [s]; empty: the computer's steady clock.
    std::function<void(const std::string&)> log;  ///< What went wrong here, for who runs it.
    size_t review_bytes = kReviewBytes;           ///< Memory for tracks of attempts.
    std::string lti_file;  ///< Settings for learning platforms (ui/lti/settings.h); empty: none.
};

/// Any thread: every page opens a store of its own.
class Portal {
 public:
    /// @pre a QGuiApplication.
    explicit Portal(PortalOptions options);
    ~Portal();
    Portal(const Portal&) = delete;
    Portal& operator=(const Portal&) = delete;
    /// Never throws.
    [[nodiscard]] Answer answer(const Request& request) noexcept;
    /// What is wrong with a request that asks for no page, in the language of who asks.
    [[nodiscard]] Answer refuse(const Request& request, int status);
    /// Whether something can be sent there: a sign-in or a sign-out, and nothing else.
    [[nodiscard]] bool takes_forms(const std::string& path) const;

 private:
    /// The session of the request with its token; account 0 = none.
    struct Signed {
        std::string token;
        Session session;
    };
    [[nodiscard]] Signed signed_in(const Request& request);
    [[nodiscard]] Answer answer_or_throw(const Request& request);
    [[nodiscard]] Answer page(const Request& request, const Signed& who);
    [[nodiscard]] Answer show(const Route& route, Visit& visit, const Reader& reader);
    // portal_language.cpp
    /// The one that was chosen, else the one the browser asks for.
    [[nodiscard]] QLocale language_of(const Request& request) const;
    /// To the same page with the choice kept; nothing where none is made.
    [[nodiscard]] std::optional<Answer> choose_language(const Request& request) const;
    [[nodiscard]] std::string language_name() const;
    // portal_sign_in.cpp
    [[nodiscard]] Answer sign_in_form(const Html& said, int status);
    [[nodiscard]] Answer sign_in(const Request& request);
    /// What the store says to a name and a password. Throws StoreError.
    [[nodiscard]] db::SignIn ask_the_store(const std::string& login, const std::string& password);
    [[nodiscard]] Answer sign_out(const Request& request);
    [[nodiscard]] std::string cookie(const std::string& name, const std::string& value) const;
    [[nodiscard]] std::string session_name() const;
    [[nodiscard]] std::string form_name() const;
    // portal_lti.cpp: in from a learning platform. The store is read and not written.
    [[nodiscard]] Answer lti(const Request& request);
    [[nodiscard]] Answer lti_keys();
    /// Sends a browser that a platform sent here back to it, to be told who that is.
    [[nodiscard]] Answer lti_login(const std::map<std::string, std::string>& said);
    /// The platform's answer to that.
    [[nodiscard]] Answer lti_launch(const Request& request);
    [[nodiscard]] Answer lti_enter(const lti::Platform& platform, const lti::Launch& launch);
    [[nodiscard]] Answer lti_begin_session(const lti::Platform& platform, const lti::Launch& launch,
                                           db::Store& store, const db::UserRecord& user);
    /// True, too, for whoever came by password.
    [[nodiscard]] bool lti_still_linked(const Session& session, const db::UserRecord& user) const;
    [[nodiscard]] std::string lti_cookie(const std::string& value) const;

    PortalOptions options_;
    Sessions sessions_;
    Tasks tasks_;
    ReportsInPolish polish_;
    ReviewMaker reviews_;
    std::unique_ptr<LtiVisitors> visitors_;  ///< Null: no platform.
    std::timed_mutex door_;  ///< One sign-in at a time: each fills 64 MB with its password.
};

}  // namespace placode::web
