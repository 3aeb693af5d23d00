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
#include <QStandardPaths>
#include <QTranslator>
#include <QUrl>

#include "db/said.h"
#include "ui/shell/parts.h"
#include "ui/shell/waiting_recordings.h"

namespace placode::ui {
namespace {

constexpr const char* kLastFolder = "last_folder";

constexpr int kSessionWatchMs = 15'000;  ///< Nobody touches anything: asked all the same.

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
    saves_.setMaxThreadCount(1);
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

AppContext::~AppContext() {
    saves_.waitForDone();
    works_.waitForDone();
}

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
    return since >= 0 && since < qint64{kPinHours} * 3600;
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
    QString last = settings_->value(kLastFolder).toString();
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
    QString path = ask_save_file_
                       ? ask_save_file_(window_of(parent), title, proposal, filter)
                       : QFileDialog::getSaveFileName(window_of(parent), title, proposal, filter);
    if (!path.isEmpty()) rememberFolder(QFileInfo(path).absolutePath());
    return path;
}

QString AppContext::askOpenFile(QWidget* parent, const QString& title, const QString& filter) {
    const QString folder = lastFolder();
    QString path = ask_open_file_
                       ? ask_open_file_(window_of(parent), title, folder, filter)
                       : QFileDialog::getOpenFileName(window_of(parent), title, folder, filter);
    if (!path.isEmpty()) rememberFolder(QFileInfo(path).absolutePath());
    return path;
}

QString AppContext::askFolder(QWidget* parent, const QString& title) {
    const QString last = lastFolder();
    QString folder = ask_save_file_
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

}  // namespace placode::ui
