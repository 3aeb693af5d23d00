// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Opening the store, what to do when it is gone, and whether who is signed in still may be.
#include <QApplication>
#include <QDialog>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPointer>
#include <memory>
#include <optional>

#include "db/store_url.h"
#include "ui/shell/app_context.h"
#include "ui/shell/dialog_frame.h"
#include "ui/shell/parts.h"
#include "ui/shell/store_address.h"

namespace placode::ui {
namespace {

constexpr const char* kChosenStore = "chosen_store";
constexpr const char* kKnown = "known";
constexpr qint64 kAskAgainMs = 1000;

/// The address with all its options, as the settings may keep it: they are a file.
QString without_password(const std::string& address) {
    QString all = qstr(address);
    if (!has_password(all)) return all;
    const QString server = all.section('?', 0, 0);
    return QUrl(server).toString(QUrl::RemovePassword | QUrl::FullyEncoded) +
           all.mid(server.size());
}

/// Who was asked for the password gave up: no error, and nothing to try.
struct GivenUp {};

/// Nothing: the user gave up. Framed as every other question: without a title bar Qt's own dialog
/// is a white patch over the page.
std::optional<QString> ask_server_password(const AppContext& context, const QString& server) {
    QDialog dialog(QApplication::activeWindow());
    dialog.setObjectName("server_password_dialog");
    dialog.setWindowTitle(AppContext::tr("Password of the server"));
    dialog.setMinimumWidth(440);
    auto* column = new QVBoxLayout(&dialog);
    column->setContentsMargins(kSpace24, kSpace24, kSpace24, kSpace24);
    column->setSpacing(kSpace12);
    column->addWidget(make_label(AppContext::tr("Password of the server"), "title"));
    auto* typed = new QLineEdit;
    typed->setObjectName("server_password");
    typed->setEchoMode(QLineEdit::Password);
    column->addLayout(make_field(AppContext::tr("Password for %1").arg(server), typed));
    auto* row = new QHBoxLayout;
    row->setSpacing(kSpace8);
    QPushButton* no = make_button(context, AppContext::tr("Cancel"), "secondary");
    no->setObjectName("server_password_no");
    no->setAutoDefault(false);
    QPushButton* yes = make_button(context, AppContext::tr("Connect"), "primary", "next");
    yes->setObjectName("server_password_yes");
    yes->setDefault(true);
    row->addStretch();
    row->addWidget(no);
    row->addWidget(yes);
    column->addLayout(row);
    QObject::connect(no, &QPushButton::clicked, &dialog, &QDialog::reject);
    QObject::connect(yes, &QPushButton::clicked, &dialog, &QDialog::accept);
    frame_dialog(&dialog);
    typed->setFocus();
    if (dialog.exec() != QDialog::Accepted) return std::nullopt;
    return typed->text();
}

}  // namespace

std::string AppContext::startingStore(const std::string& asked) const {
    if (!asked.empty()) return asked;
    const std::string chosen = settings_->value(kChosenStore).toString().toStdString();
    return chosen.empty() ? db::default_store_url() : chosen;
}

std::string AppContext::shownStore() const {
    try {
        return db::parse_store_url(store_url_).shown;
    } catch (const db::StoreError&) {
        return "(an address that cannot be read)";  // It may hold a password.
    }
}

// Kept in memory only, and only when the server took it.
std::string AppContext::urlWithPassword() {
    const db::StoreUrl url = db::parse_store_url(store_url_);
    if (!db::needs_password(url)) return store_url_;
    const std::optional<QString> typed = ask_server_password(*this, qstr(url.shown));
    if (!typed) throw GivenUp();
    return typed->isEmpty() ? store_url_ : db::with_password(store_url_, typed->toStdString());
}

bool AppContext::openStore(const db::StoreOptions& options) {
    // Another file is about to take its place, or its tables are changing.
    if (restoring_ || updating_) return false;
    store_.reset();
    store_missing_ = store_older_ = false;
    const QString asked = without_password(store_url_);
    const bool tried = guard(tr("Opening the store"), [&] {
        std::string url;
        try {
            url = urlWithPassword();
            db::StoreOptions there = options;
            there.station = true;  // Whoever sits here must not act with the owner's log-in.
            store_ = db::open_store(url, there);
            store_url_ = url;
            // From here on what the person may whom it serves, and before sign-in next to nothing.
            user_ ? store_->act_for(user_->id) : store_->sign_out();
        } catch (const GivenUp&) {  // Not opened, and nobody wonders why.
        } catch (const db::StoreError& error) {
            store_missing_ = error.kind() == db::StoreError::Kind::kMissing;
            store_older_ = error.kind() == db::StoreError::Kind::kOlder;
            if (store_older_) store_url_ = url;  // The server took the password.
            if (!store_missing_ && !store_older_) throw;
        }
    });
    if (!tried || store_ == nullptr) return false;
    // However the server was named: a start from the menu must not open another store without a
    // word. A file given with --store is for this once.
    if (!storeIsFile()) settings_->setValue(kChosenStore, asked);
    return true;
}

bool AppContext::openStore() {
    db::StoreOptions options;
    options.known = storeSetting(kKnown).toBool();
    options.leave_older = true;
    return openStore(options);
}

void AppContext::updateStore(QObject* receiver, std::function<void(bool, const QString&)> done) {
    store_.reset();
    updating_ = db::UpdatePart::kCheck;
    const auto copy = std::make_shared<QString>();  // Of this thread.
    const QPointer<QObject> alive(receiver);
    const auto updated = [this, alive, copy, done = std::move(done)](bool up_to_date) {
        updating_.reset();
        const bool open = up_to_date && openStore();
        if (alive) done(open, *copy);
    };
    db::StoreOptions options;
    options.known = storeSetting(kKnown).toBool();
    options.station = true;  // It may what openStore() may, and no more.
    options.updating = [this, copy](const db::UpdateStep& step) {
        const auto reach = [this, copy, step] {
            if (!step.copy.empty()) *copy = qstr(step.copy);
            updating_ = step.part;
            Q_EMIT updateReached();
        };
        QMetaObject::invokeMethod(this, reach, Qt::QueuedConnection);
    };
    inThread(
        this, [url = store_url_, options] { (void)db::open_store(url, options); },
        beginBusy(this, tr("Bringing the store up to date"), updated, {}, {}), Lane::kWork);
}

void AppContext::rememberStore() { setStoreSetting(kKnown, true); }

bool AppContext::beginAnew() {
    setStoreSetting(kKnown, {});
    db::StoreOptions options;
    options.begin_anew = true;
    return openStore(options);
}

bool AppContext::chooseStore(const QString& file) {
    const std::string before = store_url_;
    store_url_ = "sqlite:" + file.toStdString();
    db::StoreOptions options;
    options.known = true;
    options.leave_older = true;
    if (!openStore(options) && !store_older_) {
        if (store_missing_)
            (void)guard(tr("Opening the store"), [this] {
                throw db::StoreError(db::StoreError::Kind::kOther,
                                     "store " + shownStore() + ": the file is gone or empty");
            });
        store_url_ = before;
        store_missing_ = true;  // The question is still how to go on.
        return false;
    }
    settings_->setValue(kChosenStore, qstr(store_url_));
    return true;
}

bool AppContext::chooseServer(const QString& address) {
    const std::string before = store_url_;
    store_url_ = address.toStdString();
    if (!openStore(db::StoreOptions())) {
        store_url_ = before;
        (void)openStore();
        return false;
    }
    return true;
}

bool AppContext::storeWasChosen() const {
    const QString chosen = settings_->value(kChosenStore).toString();
    return !chosen.isEmpty() && chosen.toStdString() == store_url_;
}

void AppContext::useOwnStore() {
    settings_->remove(kChosenStore);
    store_url_ = db::default_store_url();
}

bool AppContext::storeIsFile() const { return store_url_.starts_with("sqlite:"); }

db::Store& AppContext::store() {
    if (!store_) {
        throw db::StoreError(db::StoreError::Kind::kUnavailable,
                             "store " + shownStore() + ": not open; try again");
    }
    if (!sessionStands()) throw Refusal(session_note_);
    return *store_;
}

QString AppContext::sessionProblem(const std::optional<db::UserRecord>& now,
                                   const db::UserRecord& then) {
    if (!now || !now->active)
        return tr("Your account was closed. An administrator can open it again.");
    if (now->roles != then.roles)
        return tr("Your roles were changed. Sign in again to go on with them.");
    return {};
}

bool AppContext::sessionStands() {
    if (!user_ || !store_) return true;
    if (!session_note_.isEmpty()) return false;
    if (session_asked_.isValid() && session_asked_.elapsed() < kAskAgainMs) return true;
    session_asked_.start();
    try {
        session_note_ = sessionProblem(store_->accounts().find(user_->id), *user_);
    } catch (const db::StoreError&) {
        return true;  // Whoever asks the store next says what is wrong with it.
    }
    if (session_note_.isEmpty()) return true;
    // Queued: a page may be in the middle of its work.
    QMetaObject::invokeMethod(this, &AppContext::endSession, Qt::QueuedConnection);
    return false;
}

void AppContext::endSession() {
    if (!user_ || session_note_.isEmpty()) return;
    // A page that waits for an answer must not go away under its question.
    if (question_stands()) return when_no_question(this, [this] { endSession(); });
    Q_EMIT sessionEnds();
    user_.reset();
    if (store_) store_->sign_out();
    Q_EMIT userChanged();
}

}  // namespace placode::ui
