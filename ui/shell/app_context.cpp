// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/app_context.h"

#include <QApplication>
#include <QCryptographicHash>
#include <QDesktopServices>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QLibraryInfo>
#include <QLocale>
#include <QPointer>
#include <QStandardPaths>
#include <QThreadPool>
#include <QTranslator>
#include <QUrl>

#include "db/said.h"
#include "ui/shell/parts.h"
#include "ui/shell/waiting_recordings.h"

namespace placode::ui {
namespace {

constexpr const char* kLastFolder = "last_folder";

constexpr int kSessionWatchMs = 15'000;  ///< Nobody touches anything: asked all the same.

constexpr double kWorthAnEstimateS = 2;  ///< Shorter work is over before anybody reads it.
constexpr double kOverdue = 1.5;         ///< Times the estimate; then it is worth nothing.
constexpr double kLateShare = 0.9;       ///< From here on the estimate was too short.
constexpr double kTeachingS = 5;         ///< Of a recording: a shorter one tells of the start-up.

/// Remembers how long a second of a recording takes, half of it from before.
void learn_pace(QSettings& settings, const WorkSize& size, double took_s) {
    if (size.kind.isEmpty() || size.recorded_s < kTeachingS || took_s <= 0) return;
    const QString key = "pace/" + size.kind;
    const double now = took_s / size.recorded_s, before = settings.value(key).toDouble();
    settings.setValue(key, before > 0 ? 0.5 * (before + now) : now);
}

/// What a dialog belongs to: the page below it may be built anew.
QWidget* window_of(QWidget* parent) { return parent != nullptr ? parent->window() : nullptr; }

}  // namespace

AppContext::AppContext(ShellOptions options, QObject* parent) : QObject(parent) {
    settings_ = options.settings_file.isEmpty()
                    ? std::make_unique<QSettings>("Placode", "placode")
                    : std::make_unique<QSettings>(options.settings_file, QSettings::IniFormat);
    store_url_ = startingStore(options.store_url);
    const QString desktop = QLocale::system().language() == QLocale::Polish ? "pl" : "en";
    language_ = !options.language.isEmpty() ? options.language
                                            : settings_->value("language", desktop).toString();
    const QString theme =
        !options.theme.isEmpty() ? options.theme : settings_->value("theme", "light").toString();
    theme_ = theme == "dark" ? ThemeKind::kDark : ThemeKind::kLight;
    ask_save_file_ = options.ask_save_file;
    ask_open_file_ = options.ask_open_file;
    show_file_ = options.show_file;
    lock_after_s_ = options.lock_after_s;
    options.launch.language = language_;
    launcher_ = std::make_unique<AttemptLauncher>(options.launch);
    replays_ = std::make_unique<ReplayQueue>();
    waiting_ = std::make_unique<WaitingRecordings>(*this);
    connect(launcher_.get(), &AttemptLauncher::started, this, [this] {
        replays_->hold(true);
        awake_.keep(QCoreApplication::translate("RunningPage", "Attempt is running"));
    });
    connect(launcher_.get(), &AttemptLauncher::ended, this, [this] {
        replays_->hold(false);
        awake_.release();
    });
    installTranslators();
    apply_theme(*qApp, theme_);
    session_watch_.setObjectName("session_watch");
    session_watch_.setInterval(kSessionWatchMs);
    // A server that hangs holds up this thread, which reads what a running attempt says.
    connect(&session_watch_, &QTimer::timeout, this, [this] {
        if (!launcher_->running()) (void)sessionStands();
    });
    session_watch_.start();
}

AppContext::~AppContext() { QThreadPool::globalInstance()->waitForDone(); }

void AppContext::verifyAttempts() {
    if (user_) replays_->begin(store_url_, user_->login);
}

void AppContext::signIn(const db::UserRecord& user) {
    user_ = user;
    session_note_.clear();
    session_asked_.start();
    if (!user.demonstration) rememberStore();
    setStoreSetting("last_login", QString::fromStdString(user.login));
    Q_EMIT userChanged();
}

void AppContext::signOut() {
    user_.reset();
    session_note_.clear();
    if (store_) store_->sign_out();
    Q_EMIT userChanged();
}

bool AppContext::may(db::Action action, db::Scope scope) const {
    return user_ && db::allowed(user_->roles, action, scope);
}

void AppContext::notePassword(const db::UserRecord& user) {
    password_given_[user.id] = {qstr(user.login).trimmed().toCaseFolded(),
                                QDateTime::currentDateTimeUtc()};
}

int64_t AppContext::knownHere(const QString& login) const {
    for (const auto& [id, given] : password_given_)
        if (given.login == login.trimmed().toCaseFolded() && knowsPassword(id)) return id;
    return 0;
}

bool AppContext::knowsPassword(int64_t user_id) const {
    const auto found = password_given_.find(user_id);
    if (found == password_given_.end()) return false;
    // A clock that was set back does not make the hours longer.
    const qint64 since = found->second.at.secsTo(QDateTime::currentDateTimeUtc());
    return since >= 0 && since < kPinHours * 3600;
}

void AppContext::require(db::Action action, db::Scope scope) const {
    if (!may(action, scope))
        throw db::StoreError(db::StoreError::Kind::kRefused, "", db::refusal(action));
}

void AppContext::audit(const char* action, const QString& object, const QString& detail) {
    store().audit().write(user_ ? user_->login : "(nobody)", action, object.toStdString(),
                          detail.toStdString());
}

const db::Erasure* AppContext::lastErasure() const {
    const auto found = erasures_.find(store_url_);
    return found == erasures_.end() ? nullptr : &found->second;
}

void AppContext::keepErasure(const std::string& store_url, const db::Erasure& erasure) {
    erasures_[store_url] = erasure;
}

void AppContext::setTheme(ThemeKind theme) {
    if (theme == theme_) return;
    theme_ = theme;
    settings_->setValue("theme", theme == ThemeKind::kDark ? "dark" : "light");
    apply_theme(*qApp, theme_);
    Q_EMIT appearanceChanged();
}

void AppContext::setLanguage(const QString& language) {
    if (language == language_) return;
    language_ = language;
    settings_->setValue("language", language);
    launcher_->setLanguage(language);
    installTranslators();
    Q_EMIT appearanceChanged();
}

QString AppContext::in(const curriculum::LocalText& text) const {
    return QString::fromStdString(text.in(language_.toStdString()));
}

QString AppContext::storeKey(const QString& key) const {
    // The address without password and options.
    QString place = qstr(shownStore());
    if (place.startsWith("sqlite:")) place = "sqlite:" + QFileInfo(place.mid(7)).absoluteFilePath();
    const QByteArray name =
        QCryptographicHash::hash(place.toUtf8(), QCryptographicHash::Sha256).toHex();
    return QString("store_%1/%2").arg(QString::fromLatin1(name.left(16)), key);
}

QVariant AppContext::storeSetting(const QString& key) const {
    return settings_->value(storeKey(key));
}

void AppContext::setStoreSetting(const QString& key, const QVariant& value) {
    value.isValid() ? settings_->setValue(storeKey(key), value) : settings_->remove(storeKey(key));
}

QString AppContext::lastFolder() const {
    const QString last = settings_->value(kLastFolder).toString();
    if (!last.isEmpty() && QFileInfo(last).isDir()) return last;
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return QFileInfo(documents).isDir() ? documents : QDir::homePath();
}

void AppContext::rememberFolder(const QString& folder) {
    if (QFileInfo(folder).isDir()) settings_->setValue(kLastFolder, folder);
}

QString AppContext::askSaveFile(QWidget* parent, const QString& title, const QString& name,
                                const QString& filter) {
    const QString proposal = QDir(lastFolder()).filePath(name);
    const QString path =
        ask_save_file_ ? ask_save_file_(window_of(parent), title, proposal, filter)
                       : QFileDialog::getSaveFileName(window_of(parent), title, proposal, filter);
    if (!path.isEmpty()) rememberFolder(QFileInfo(path).absolutePath());
    return path;
}

QString AppContext::askOpenFile(QWidget* parent, const QString& title, const QString& filter) {
    const QString folder = lastFolder();
    const QString path =
        ask_open_file_ ? ask_open_file_(window_of(parent), title, folder, filter)
                       : QFileDialog::getOpenFileName(window_of(parent), title, folder, filter);
    if (!path.isEmpty()) rememberFolder(QFileInfo(path).absolutePath());
    return path;
}

QString AppContext::askFolder(QWidget* parent, const QString& title) {
    const QString last = lastFolder();
    const QString folder = ask_save_file_
                               ? ask_save_file_(window_of(parent), title, last, {})
                               : QFileDialog::getExistingDirectory(window_of(parent), title, last);
    if (!folder.isEmpty()) rememberFolder(QFileInfo(folder).absoluteFilePath());
    return folder;
}

void AppContext::showFile(const QString& path) const {
    if (show_file_) return show_file_(path);
    QDesktopServices::openUrl(QUrl::fromLocalFile(path));
}

void AppContext::installTranslators() {
    own_strings_ = std::make_unique<QTranslator>();
    qt_strings_ = std::make_unique<QTranslator>();
    const QLocale locale(language_ == "pl" ? QLocale(QLocale::Polish, QLocale::Poland)
                                           : QLocale(QLocale::English, QLocale::UnitedKingdom));
    QLocale::setDefault(locale);
    if (language_ != "en" && qt_strings_->load(locale, "qtbase", "_",
                                               QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        QCoreApplication::installTranslator(qt_strings_.get());
    if (own_strings_->load(":/i18n/placode_" + language_ + ".qm"))
        QCoreApplication::installTranslator(own_strings_.get());
}

std::optional<Problem> AppContext::problemOf(const std::function<void()>& work) {
    try {
        work();
        return std::nullopt;
    } catch (...) {
        return problem_of(std::current_exception(), tr("This"));
    }
}

bool AppContext::guard(const QString& doing, const std::function<void()>& work) {
    try {
        work();
        return true;
    } catch (...) {
        Problem problem = problem_of(std::current_exception(), doing);
        problem.doing = doing;
        report(problem);
        return false;
    }
}

void AppContext::background(QObject* receiver, const QString& doing,
                            std::function<void(db::Store&)> work, std::function<void(bool)> done,
                            const WorkSize& size) {
    backgroundFor(user_ ? user_->id : 0, receiver, doing, std::move(work), std::move(done), size);
}

void AppContext::backgroundFor(int64_t account, QObject* receiver, const QString& doing,
                               std::function<void(db::Store&)> work, std::function<void(bool)> done,
                               const WorkSize& size,
                               std::function<bool(const std::exception_ptr&)> dealt_with) {
    ++busy_;
    work_size_ = size;
    work_started_.start();
    Q_EMIT busyChanged(doing);
    const QPointer<QObject> alive(receiver);
    const QElapsedTimer began = work_started_;
    quietlyFor(account, this, std::move(work),
               [this, alive, doing, done = std::move(done), dealt_with = std::move(dealt_with),
                size, began](const std::exception_ptr& error) {
                   if (!error)
                       learn_pace(*settings_, size, static_cast<double>(began.elapsed()) / 1000);
                   if (--busy_ == 0) Q_EMIT busyChanged({});
                   if (error && !(alive && dealt_with && dealt_with(error)))
                       report(problem_of(error, doing));
                   // `done` may read on, and no exception may leave a queued call.
                   if (alive) guard(doing, [&] { done(!error); });
               });
}

void AppContext::quietlyFor(int64_t account, QObject* receiver,
                            std::function<void(db::Store&)> work,
                            std::function<void(const std::exception_ptr&)> done) {
    const QPointer<QObject> alive(receiver);
    QThreadPool::globalInstance()->start([this, alive, work = std::move(work),
                                          done = std::move(done), url = store_url_, user = user_,
                                          account] {
        std::exception_ptr error;
        try {
            const std::unique_ptr<db::Store> own = db::open_store(url);
            account != 0 ? own->act_for(account) : own->sign_out();
            if (user && user->id == account)
                if (const QString note = sessionProblem(own->accounts().find(user->id), *user);
                    !note.isEmpty())
                    throw Refusal(note);
            work(*own);
        } catch (...) {
            error = std::current_exception();
        }
        const auto deliver = [alive, done, error] {
            if (alive) done(error);
        };
        QMetaObject::invokeMethod(this, deliver, Qt::QueuedConnection);
    });
}

void AppContext::whenIdle(QObject* receiver, std::function<void()> act) {
    if (!busy()) return act();
    // Queued: whoever began the work hears first that it is done.
    auto* once = new QObject(receiver);
    connect(
        this, &AppContext::busyChanged, once,
        [this, once, act = std::move(act), done = false](const QString& what) mutable {
            // Two ends may have been queued before the first was heard.
            if (done || !what.isEmpty() || busy()) return;
            done = true;
            once->deleteLater();
            act();
        },
        Qt::QueuedConnection);
}

std::optional<WorkPace> AppContext::busyPace() const {
    if (busy_ != 1 || work_size_.kind.isEmpty() || work_size_.recorded_s <= 0) return std::nullopt;
    const double per_s = settings_->value("pace/" + work_size_.kind).toDouble();
    if (per_s <= 0) return std::nullopt;
    const double whole = per_s * work_size_.recorded_s;
    if (whole < kWorthAnEstimateS) return std::nullopt;
    const double passed = static_cast<double>(work_started_.elapsed()) / 1000;
    // Late work does not stand at its end: what is left shrinks ever more slowly.
    const double share = passed < kLateShare * whole
                             ? passed / whole
                             : 1 - (1 - kLateShare) * kLateShare * whole / passed;
    return WorkPace{share, passed / share - passed, passed > kOverdue * whole};
}

}  // namespace placode::ui
