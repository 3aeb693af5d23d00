// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Drives the real windows of the shell on a store of its own in a temporary folder. Every helper
// works through widgets that a person could reach; screenshots go to $PLACODE_SCREENSHOTS.

#include <QAbstractButton>
#include <QComboBox>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QThreadPool>
#include <QTimer>
#include <QToolButton>
#include <memory>

#include "tests/scratch_root.h"
#include "ui/shell/main_window.h"

namespace placode::ui {

class ShellHarness {
 public:
    ShellHarness() { start(); }
    /// On a server's store.
    explicit ShellHarness(const std::string& address) : server(address) { start(); }

    /// Starts the shell anew on the same store, as after a restart of the machine; or on another
    /// one of the folder.
    void start(const QString& file = {}) {
        if (!file.isEmpty()) file_ = file;
        stop();
        ShellOptions options;
        // A lock is reported after 0.3 s instead of 5 s.
        if (!server.empty())
            options.store_url = server;
        else if (!without_store)
            options.store_url = "sqlite:" + path(file_).toStdString() + "?timeout_ms=300";
        options.language = "en";
        options.theme = "light";
        options.settings_file = path("settings.ini");
        options.launch.program = simulator;
        options.launch.more_arguments = QStringList{"--headless", "--fast"};
        options.launch.hands = hands;
        options.launch.more_arguments << more_arguments;
        options.lock_after_s = lock_after_s;
        options.launch.replay_arguments = QStringList{"--headless"};
        options.ask_save_file = [this](QWidget*, const QString&, const QString& proposal,
                                       const QString&) {
            proposed = proposal;
            return save_as;
        };
        options.ask_open_file = [this](QWidget*, const QString&, const QString& folder,
                                       const QString&) {
            proposed = folder;
            return open_this;
        };
        options.show_file = [this](const QString& path) { shown = path; };
        context_ = std::make_unique<AppContext>(options);
        window_ = std::make_unique<MainWindow>(*context_);
        window_->resize(1366, 768);
        window_->show();
        window_->begin();
    }

    /// Nobody has the store open until start().
    void stop() {
        window_.reset();
        context_.reset();
        owner_.reset();
    }

    /// The shell's store as its owner has it, from beside: the shell itself may only what the
    /// person may who has signed in.
    [[nodiscard]] db::Store& owner() const {
        if (!owner_ || owner_url_ != context_->storeUrl()) {
            owner_url_ = context_->storeUrl();
            owner_ = db::open_store(owner_url_);
        }
        return *owner_;
    }

    [[nodiscard]] AppContext& context() { return *context_; }
    [[nodiscard]] MainWindow& window() { return *window_; }
    [[nodiscard]] QString path(const QString& name) const { return folder_.filePath(name); }

    /// A widget of the page that is shown, or of the frame around it.
    template <typename T>
    [[nodiscard]] T* find(const QString& name) const {
        if (window_->page() != nullptr) {
            if (T* found = window_->page()->template findChild<T*>(name)) return found;
        }
        // Of the frame: a page that was left lives on for a moment and must not be found.
        for (T* found : window_->template findChildren<T*>(name)) {
            const QWidget* above = found;
            while (above != nullptr && dynamic_cast<const Page*>(above) == nullptr)
                above = above->parentWidget();
            if (above == nullptr) return found;
        }
        return nullptr;
    }

    [[nodiscard]] bool click(const QString& name) {
        auto* button = find<QAbstractButton>(name);
        if (button == nullptr || !button->isEnabled()) return false;
        QTest::mouseClick(button, Qt::LeftButton);
        QCoreApplication::processEvents();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        return true;
    }

    [[nodiscard]] bool type(const QString& name, const QString& text) {
        auto* field = find<QLineEdit>(name);
        if (field == nullptr) return false;
        field->setFocus();
        field->clear();
        QTest::keyClicks(field, text);
        return field->text() == text;
    }

    /// Whether what is typed goes there; also where no desktop makes a window the active one.
    [[nodiscard]] bool focusIsIn(const QString& name) const {
        return window_->focusWidget() != nullptr &&
               window_->focusWidget() == static_cast<QWidget*>(find<QLineEdit>(name));
    }

    /// Chooses what a box holds under `value`, whatever its words are.
    [[nodiscard]] bool choose(const QString& name, const QString& value) {
        auto* box = find<QComboBox>(name);
        if (box == nullptr || box->findData(value) < 0) return false;
        box->setCurrentIndex(box->findData(value));
        return true;
    }

    [[nodiscard]] QString text(const QString& name) const {
        const auto* label = find<QLabel>(name);
        return label != nullptr ? label->text() : QString();
    }

    /// Waits until a page is shown; false after `seconds`.
    [[nodiscard]] bool arrives(PageId page, int seconds = 10) {
        return QTest::qWaitFor(
            [&] { return window_->page() != nullptr && window_->current() == page; },
            seconds * 1000);
    }

    [[nodiscard]] bool bannerSays(const QString& words, int seconds = 10) {
        return QTest::qWaitFor(
            [&] { return window_->banner().isShown() && window_->banner().text().contains(words); },
            seconds * 1000);
    }

    /// Presses the affirming button of the next question.
    void confirmNext() {
        QTimer::singleShot(50, window_.get(), [this] { pressInDialog("confirm_yes"); });
    }

    /// Presses the button of the next question that keeps everything as it is.
    void refuseNext() {
        QTimer::singleShot(50, window_.get(), [this] { pressInDialog("confirm_no"); });
    }

    /// Types the coordinator's password when the screen is taken back from a participant.
    void takeBackNext(const QString& password = "placode-demo") {
        QTimer::singleShot(50, window_.get(), [this, password] { typeToTakeBack(password); });
    }

    [[nodiscard]] bool signIn(const QString& login, const QString& password) {
        if (context_->signedIn()) context_->signOut();
        if (!arrives(PageId::kLogin)) return false;
        if (!type("login", login) || !type("password", password)) return false;
        QTest::keyClick(find<QLineEdit>("password"), Qt::Key_Return);
        QCoreApplication::processEvents();
        return context_->signedIn();
    }

    /// What is on the screen, in both themes.
    void shot(const QString& name) {
        for (const ThemeKind theme : {ThemeKind::kDark, ThemeKind::kLight}) {
            settleIn(theme);
            keep(window_->grab(), name + (theme == ThemeKind::kDark ? "_dark" : "_light"));
        }
    }

    /// Writes a picture where somebody wants to look at them: into $PLACODE_SCREENSHOTS.
    static void keep(const QPixmap& picture, const QString& name) {
        if (!keepsPictures()) return;
        const QString folder = qEnvironmentVariable("PLACODE_SCREENSHOTS");
        QDir().mkpath(folder);
        picture.save(QString("%1/%2.png").arg(folder, name));
    }
    [[nodiscard]] static bool keepsPictures() {
        return !qEnvironmentVariableIsEmpty("PLACODE_SCREENSHOTS");
    }

    /// The whole page, also what has to be scrolled to, in both themes.
    void whole(const QString& name) {
        for (const ThemeKind theme : {ThemeKind::kDark, ThemeKind::kLight}) {
            settleIn(theme);
            auto* area = window_->page()->findChild<QScrollArea*>();
            QWidget* inside = area != nullptr ? area->widget() : window_->page();
            keep(inside->grab(), name + (theme == ThemeKind::kDark ? "_dark" : "_light"));
        }
    }

    /// The folder that the last export has made within save_as, or within another one.
    [[nodiscard]] QString exported() const { return exportedIn(save_as); }
    [[nodiscard]] static QString exportedIn(const QString& chosen) {
        const QDir folder(chosen);
        const QStringList made = folder.entryList({"placode_*"}, QDir::Dirs, QDir::Name);
        return made.isEmpty() ? QString("no folder of its own") : folder.filePath(made.back());
    }

    /// Waits until every exam and every attempt of a study has been simulated again.
    [[nodiscard]] bool replaysEnd(int seconds = 240) {
        // The store is asked ten times a second: at every turn of the loop it would take a tenth of
        // the machine from the replays that are waited for.
        QElapsedTimer asked;
        return QTest::qWaitFor(
            [&] {
                if (context_->replays().working() || (asked.isValid() && asked.elapsed() < 100))
                    return false;
                asked.start();
                return owner().attempts().waiting_for_replay().empty();
            },
            seconds * 1000);
    }

    [[nodiscard]] int64_t idOf(const std::string& login) const {
        return owner().accounts().find_login(login)->id;
    }

    /// Whether the page fits on a desk and on a small screen, with a picture of each.
    [[nodiscard]] bool fitsInBothSizes(const QString& name) {
        bool all = true;
        for (const QSize size : {QSize(1920, 1080), QSize(1024, 768)}) {
            window_->resize(size);
            QTest::qWait(80);
            all = fits() && all;
            whole(QString("%1_%2").arg(name).arg(size.width()));
        }
        return all;
    }

    /// True when nothing on the page is cut off at the side.
    [[nodiscard]] bool fits() const {
        for (const QScrollArea* area : window_->page()->findChildren<QScrollArea*>())
            if (area->horizontalScrollBar()->maximum() > 0) return false;
        return true;
    }

    void scrollTo(const QString& name) {
        auto* area = window_->page()->findChild<QScrollArea*>();
        auto* widget = find<QWidget>(name);
        if (area != nullptr && widget != nullptr) area->ensureWidgetVisible(widget, 0, 200);
    }

    /// First start: chooses the way of a station for several people.
    [[nodiscard]] bool setsUpStation() {
        return arrives(PageId::kSetup) && click("way_station") &&
               QTest::qWaitFor([this] { return find<QLineEdit>("display_name") != nullptr; });
    }

    /// First start: the administrator "ada" and the demonstration accounts.
    [[nodiscard]] bool setUpWithDemonstration() {
        if (!setsUpStation() || !type("display_name", "Ada Admin") || !type("login", "ada") ||
            !type("password", "correct horse") || !type("password_again", "correct horse"))
            return false;
        find<QAbstractButton>("add_demonstration")->setChecked(true);
        return click("create_administrator") && arrives(PageId::kLogin);
    }

    QString save_as;             ///< Answer to the next file dialog.
    QString proposed;            ///< Where the last file dialog began.
    QString shown;               ///< What was last opened in a program of the desktop.
    QString hands;               ///< Of the next start(): who operates, whatever device is chosen.
    QStringList more_arguments;  ///< Of the next start(), for the simulator.
    QString simulator = PLACODE_BIN_DIR "/placode-sim";  ///< Of the next start().
    int lock_after_s = 0;                                ///< Of the next start().
    bool without_store = false;  ///< Of the next start(): no --store is given.
    std::string server;          ///< Of the next start(): its address, in place of the file's.
    QString open_this;           ///< Answer to the next dialog for a file to read.

 private:
    /// The page made anew in a theme, with everything that it loads.
    void settleIn(ThemeKind theme) {
        context_->setTheme(theme);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        (void)QTest::qWaitFor([&] { return context_->workers().activeThreadCount() == 0; }, 20000);
        QCoreApplication::processEvents();
        // Lets layouts come to rest for a picture that somebody looks at; nothing depends on it.
        if (keepsPictures()) QTest::qWait(120);
    }

    void pressInDialog(const QString& name) {
        QWidget* dialog = QApplication::activeModalWidget();
        auto* button = dialog != nullptr ? dialog->findChild<QPushButton*>(name) : nullptr;
        if (button != nullptr) {
            QTest::mouseClick(button, Qt::LeftButton);
        } else {
            QTimer::singleShot(50, window_.get(), [this, name] { pressInDialog(name); });
        }
    }

    void typeToTakeBack(const QString& password) {
        QWidget* dialog = QApplication::activeModalWidget();
        auto* field =
            dialog != nullptr ? dialog->findChild<QLineEdit*>("take_back_password") : nullptr;
        if (field == nullptr) return takeBackNext(password);
        QTest::keyClicks(field, password);
        QTest::keyClick(field, Qt::Key_Return);
    }

    QTemporaryDir folder_{
        QString::fromStdString((test::scratch_root() / "placode-shell-XXXXXX").string())};
    QString file_ = "placode.db";
    std::unique_ptr<AppContext> context_;
    std::unique_ptr<MainWindow> window_;
    mutable std::unique_ptr<db::Store> owner_;
    mutable std::string owner_url_;
};

/// Works without a display, too.
inline void prepare_display() {
    if (qEnvironmentVariableIsEmpty("DISPLAY") && qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY") &&
        qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
}

}  // namespace placode::ui
