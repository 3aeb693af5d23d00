// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What every page is given: the store, who is signed in, language and theme, the attempt that
// runs. The one place of the shell that catches exceptions and turns them into a banner.

#include <QDateTime>
#include <QElapsedTimer>
#include <QObject>
#include <QSettings>
#include <QString>
#include <QThreadPool>
#include <QTimer>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>

#include "curriculum/task.h"
#include "db/access.h"
#include "db/erasure.h"
#include "db/store.h"
#include "ui/shell/attempt_launcher.h"
#include "ui/shell/attempt_order.h"
#include "ui/shell/messages.h"
#include "ui/shell/replay_queue.h"
#include "ui/shell/screen_awake.h"
#include "ui/shell/theme.h"

class QTranslator;

namespace placode::ui {

class WaitingRecordings;

/// Asks for a file to write: parent, title, proposal, filter. Empty: the user gave up.
using AskFile = std::function<QString(QWidget*, const QString&, const QString&, const QString&)>;

/// From the command line; tests set more of it.
struct ShellOptions {
    std::string store_url;  ///< Empty: the user's data folder.
    QString language;       ///< "en", "pl"; empty: as last time, else the desktop's.
    QString theme;          ///< "light", "dark"; empty: as last time.
    QString settings_file;  ///< Empty: the user's settings.
    LaunchOptions launch;
    int lock_after_s = 600;  ///< Without a touch; 0 = never.
    AskFile ask_save_file;   ///< Empty: the desktop's file dialog.
    AskFile ask_open_file;   ///< The same for a file to read.
    /// Opens a file or folder in its program; empty: the desktop's.
    std::function<void(const QString&)> show_file;
};

/// Who waits for whom in the background: an attempt that is being saved never waits behind a
/// backup, a check of the store or a report.
enum class Lane : uint8_t { kWork, kSaving };

/// Work whose time grows with the length of a recording.
struct WorkSize {
    QString kind;           ///< "scoring", "reading"; empty = nobody knows.
    double recorded_s = 0;  ///< Length of the recording [s].
};
struct WorkPace {
    double share = 0;      ///< 0..1, and 1 never before the end.
    double left_s = 0;     ///< An estimate.
    bool overdue = false;  ///< It takes so much longer than before that nobody can say.
};

/// Main thread. Outlives all pages.
class AppContext : public QObject {
    Q_OBJECT
 public:
    explicit AppContext(ShellOptions options, QObject* parent = nullptr);
    ~AppContext() override;

    /// Opens the store; on failure reports a problem and returns false. May be called again.
    [[nodiscard]] bool openStore();
    [[nodiscard]] bool storeIsOpen() const { return store_ != nullptr; }
    /// The last openStore() failed because a store that was here before is gone. Nothing was
    /// reported: there are three ways on.
    [[nodiscard]] bool storeIsMissing() const { return store_missing_; }
    [[nodiscard]] bool beginAnew();  ///< Makes a new store: only when somebody has said so.
    /// In the background, then opens the store; until `done` openStore() opens nothing.
    void restoreBackup(const QString& file, QObject* receiver, std::function<void(bool)> done);
    [[nodiscard]] bool restoring() const { return restoring_; }
    /// The last openStore() failed because an older program made the store. Nothing was reported
    /// and nothing changed: updateStore() follows.
    [[nodiscard]] bool storeIsOlder() const { return store_older_; }
    /// In the background, then opens the store; until `done` openStore() opens nothing. `done` gets
    /// whether it is open, and where the store as it was is kept; empty = no copy was made.
    void updateStore(QObject* receiver, std::function<void(bool, const QString&)> done);
    /// What updateStore() is doing; nullopt = it is not running.
    [[nodiscard]] const std::optional<db::UpdatePart>& updating() const { return updating_; }
    /// Threads of work in the background; tests take them all.
    [[nodiscard]] QThreadPool& workers() { return works_; }
    /// Another file from now on, also at the next start without --store. True also for one of an
    /// older program, which is not open then: storeIsOlder().
    [[nodiscard]] bool chooseStore(const QString& file);
    /// The same for a centre's server; `address` without a password. What was open stays open when
    /// the server cannot be reached.
    [[nodiscard]] bool chooseServer(const QString& address);
    /// Whether the store that was to be opened is one that was chosen and not this computer's own.
    [[nodiscard]] bool storeWasChosen() const;
    void useOwnStore();  ///< From the next openStore() on, and at the next start.
    [[nodiscard]] bool storeIsFile() const;  ///< On this computer; else a server's.
    /// From now on a start without this store is not a first start.
    void rememberStore();
    /// @pre storeIsOpen(); throws StoreError(kUnavailable) otherwise, and kRefused when the
    /// account of who is signed in was closed or has other roles now: the session then ends.
    [[nodiscard]] db::Store& store();
    [[nodiscard]] const std::string& storeUrl() const { return store_url_; }
    [[nodiscard]] QString recordingsFolder() const { return recordings_folder(store_url_); }
    /// Recordings that nobody writes to, and that this program is not saving just now.
    [[nodiscard]] std::vector<Leftover> leftovers(Depth depth) const {
        return find_leftovers(recordingsFolder(), depth, saving_);
    }
    void savingBegins(const QString& recording_file) { saving_.insert(recording_file); }
    void savingEnds(const QString& recording_file) { saving_.erase(recording_file); }
    [[nodiscard]] bool isBeingSaved(const QString& recording_file) const {
        return saving_.count(recording_file) > 0;
    }

    [[nodiscard]] bool signedIn() const { return user_.has_value(); }
    [[nodiscard]] const db::UserRecord& user() const { return *user_; }  ///< @pre signedIn()
    void signIn(const db::UserRecord& user);
    void ownPasswordSet() { user_->password_given = false; }  ///< @pre signedIn()
    void signOut();
    /// Why the last session ended, if it was not its owner's wish; empty otherwise.
    [[nodiscard]] const QString& sessionNote() const { return session_note_; }
    /// Asks the store, at most once a second, whether the account still is what it was when its
    /// owner signed in; if not, the session ends. True when nobody is signed in.
    [[nodiscard]] bool sessionStands();
    static constexpr int kPinHours = 12;
    /// The password was given here: for kPinHours the PIN is enough, until Placode is closed.
    void notePassword(const db::UserRecord& user);
    [[nodiscard]] bool knowsPassword(int64_t user_id) const;
    /// Who of those for whom knowsPassword() holds has this login; 0 = nobody.
    [[nodiscard]] int64_t knownHere(const QString& login) const;
    [[nodiscard]] int lockAfterSeconds() const { return lock_after_s_; }
    [[nodiscard]] bool may(db::Action action, db::Scope scope = db::Scope::kOwn) const;
    /// Throws StoreError(kRefused) with the reason when `may` is false.
    void require(db::Action action, db::Scope scope = db::Scope::kOwn) const;
    /// For what the store does not write into the audit trail by itself.
    void audit(const char* action, const QString& object, const QString& detail = {});

    /// The last erasure in the store that is open since Placode was started; nullptr = none. Its
    /// certificate, and the copies that may still hold the person, are told nowhere else.
    [[nodiscard]] const db::Erasure* lastErasure() const;
    void keepErasure(const std::string& store_url, const db::Erasure& erasure);

    [[nodiscard]] ThemeKind theme() const { return theme_; }
    [[nodiscard]] const Tokens& colors() const { return tokens(theme_); }
    void setTheme(ThemeKind theme);
    [[nodiscard]] const QString& language() const { return language_; }
    void setLanguage(const QString& language);
    [[nodiscard]] QString in(const curriculum::LocalText& text) const;
    [[nodiscard]] QSettings& settings() { return *settings_; }
    /// What this computer remembers about the store that is open, e.g. who signed in last: another
    /// store has other people, pages and backups.
    [[nodiscard]] QVariant storeSetting(const QString& key) const;
    void setStoreSetting(const QString& key, const QVariant& value);  ///< Not valid: removed.

    /// Where to put a file of this `name`; empty = cancelled. All three begin in the folder that
    /// was chosen last, at first in the user's documents, and remember what is chosen. The dialog
    /// belongs to the window of `parent`: a page may be built anew below it.
    [[nodiscard]] QString askSaveFile(QWidget* parent, const QString& title, const QString& name,
                                      const QString& filter);
    /// A file to read; empty = cancelled.
    [[nodiscard]] QString askOpenFile(QWidget* parent, const QString& title, const QString& filter);
    /// A folder to put files into; empty = cancelled.
    [[nodiscard]] QString askFolder(QWidget* parent, const QString& title);
    /// Opens a file or folder in the program that the desktop has for it.
    void showFile(const QString& path) const;

    [[nodiscard]] AttemptLauncher& launcher() { return *launcher_; }
    [[nodiscard]] ReplayQueue& replays() { return *replays_; }
    [[nodiscard]] WaitingRecordings& waiting() { return *waiting_; }
    /// Simulates again what waits for it in this store, behind everything else.
    void verifyAttempts();

    /// Runs `work`; an exception becomes a banner and `false`. `doing` names the operation.
    bool guard(const QString& doing, const std::function<void()>& work);
    /// The problem of the exception that `work` throws, if it does; nothing is reported.
    [[nodiscard]] std::optional<Problem> problemOf(const std::function<void()>& work);
    /// Runs `work` on a worker thread with a store of its own, then `done` on this thread if
    /// `receiver` still lives. An exception becomes a banner; `done` then gets false.
    /// @param size what the work grows with, where earlier work of that kind is to tell how long it
    /// takes: busyPace().
    void background(QObject* receiver, const QString& doing, std::function<void(db::Store&)> work,
                    std::function<void(bool)> done, const WorkSize& size = {});
    /// The same in the name of who began it and may have signed out meanwhile; 0 = nobody.
    /// @param dealt_with asked before an exception becomes a banner: true, and it becomes none.
    void backgroundFor(int64_t account, QObject* receiver, const QString& doing,
                       std::function<void(db::Store&)> work, std::function<void(bool)> done,
                       const WorkSize& size = {},
                       std::function<bool(const std::exception_ptr&)> dealt_with = {},
                       Lane lane = Lane::kWork);
    /// The same without a word to anybody: `done` gets the exception, or nothing.
    void quietlyFor(int64_t account, QObject* receiver, std::function<void(db::Store&)> work,
                    std::function<void(const std::exception_ptr&)> done, Lane lane = Lane::kWork);
    /// How far the work in progress is, by what work of its kind took on this computer before;
    /// nullopt when there is none, several at once, or nothing known of it.
    [[nodiscard]] std::optional<WorkPace> busyPace() const;
    [[nodiscard]] bool busy() const { return busy_ > 0; }
    /// What began last, in the words of its caller.
    [[nodiscard]] const QString& busyWith() const { return busy_with_; }
    /// Does it now, or when the work in the background is done; not when `receiver` has gone.
    void whenIdle(QObject* receiver, std::function<void()> act);
    void report(const Problem& problem) { Q_EMIT problemReported(problem); }

 Q_SIGNALS:
    /// Not by its owner's wish: who is signed in still is, and userChanged follows.
    void sessionEnds();
    void userChanged();
    void appearanceChanged();  ///< Theme or language: rebuild what is shown.
    void problemReported(const placode::ui::Problem& problem);
    void updateReached();                   ///< updating() is another one.
    void busyChanged(const QString& what);  ///< Empty: nothing is running.
    /// On whatever page its administrator is by then. Done: it is lastErasure().
    void erasureEnded(const QString& name, bool done);

 private:
    /// Says that work began; the function that comes back hears its end.
    [[nodiscard]] std::function<void(const std::exception_ptr&)> beginBusy(
        QObject* receiver, const QString& doing, std::function<void(bool)> done,
        const WorkSize& size, std::function<bool(const std::exception_ptr&)> dealt_with);
    void inThread(QObject* receiver, std::function<void()> work,
                  std::function<void(const std::exception_ptr&)> done, Lane lane);
    [[nodiscard]] bool openStore(const db::StoreOptions& options);
    [[nodiscard]] std::string startingStore(const std::string& asked) const;
    [[nodiscard]] std::string urlWithPassword();
    /// Why the session of `then` may not go on; empty = it may.
    [[nodiscard]] static QString sessionProblem(const std::optional<db::UserRecord>& now,
                                                const db::UserRecord& then);
    void endSession();
    [[nodiscard]] std::string shownStore() const;  ///< For messages: without the password.
    void installTranslators();
    [[nodiscard]] QString storeKey(const QString& key) const;
    [[nodiscard]] QString lastFolder() const;
    void rememberFolder(const QString& folder);

    std::string store_url_;
    AskFile ask_save_file_, ask_open_file_;
    std::function<void(const QString&)> show_file_;
    std::unique_ptr<QSettings> settings_;
    std::unique_ptr<db::Store> store_;
    bool store_missing_ = false, store_older_ = false, restoring_ = false;
    std::optional<db::UpdatePart> updating_;
    std::optional<db::UserRecord> user_;
    QString session_note_;
    QElapsedTimer session_asked_;
    QTimer session_watch_{this};                   ///< Not while an attempt runs.
    std::set<QString> saving_;                     ///< Recordings on their way into the store.
    std::map<std::string, db::Erasure> erasures_;  ///< The last one, by store.
    int lock_after_s_ = 600;
    struct PasswordGiven {
        QString login;  ///< Folded.
        QDateTime at;
    };
    std::map<int64_t, PasswordGiven> password_given_;  ///< By user.
    ThemeKind theme_ = ThemeKind::kLight;
    QString language_ = "en";
    std::unique_ptr<QTranslator> own_strings_, qt_strings_;
    ScreenAwake awake_;
    std::unique_ptr<AttemptLauncher> launcher_;
    std::unique_ptr<ReplayQueue> replays_;
    /// Not the pool of the process: Qt draws large pictures with that, and waits for it.
    QThreadPool works_;  ///< Of Lane::kWork.
    QThreadPool saves_;  ///< Of Lane::kSaving: one at a time.
    int busy_ = 0;
    QString busy_with_;
    WorkSize work_size_;  ///< Of the last work that began.
    QElapsedTimer work_started_;
    std::unique_ptr<WaitingRecordings> waiting_;
};

}  // namespace placode::ui
