// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The frame of the shell: rail, top bar, the page that is shown, and messages floating over it.

#include <QElapsedTimer>
#include <QMainWindow>
#include <QMouseEvent>
#include <QPoint>
#include <QPointer>
#include <QTimer>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "ui/shell/notices.h"
#include "ui/shell/pages.h"

class QHBoxLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QToolButton;
class QVBoxLayout;

namespace placode::ui {

/// Main thread. Does not own the context.
class MainWindow : public QMainWindow {
    Q_OBJECT
 public:
    explicit MainWindow(AppContext& context);

    /// Where the window stood and how large it was when it was closed.
    static constexpr const char* kGeometrySetting = "window_geometry";
    /// Opens the store and shows set-up, log-in or, when that fails, why and "Try again".
    void begin();
    void open(const Place& place);
    /// As open(), without any question: for tours of the pages, where nobody is at the screen.
    void visit(const Place& place);
    [[nodiscard]] PageId current() const { return place_.page; }
    [[nodiscard]] Page* page() const { return page_; }
    /// All messages that float over the page.
    [[nodiscard]] const Notices& banner() const { return *notices_; }

 protected:
    void closeEvent(QCloseEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    /// Every touch of keyboard or pointer begins the time to the lock anew.
    bool eventFilter(QObject* object, QEvent* event) override;

 private:
    void buildFrame();
    struct RailPage {
        PageId id;
        QString text, icon;
        bool wanted = false;  ///< By what the user may.
    };
    struct RailSection {
        QString heading;
        std::vector<RailPage> pages;
    };
    [[nodiscard]] QWidget* buildRail();
    [[nodiscard]] std::vector<RailSection> railSections();
    [[nodiscard]] static QLabel* railHeading(const QString& text);
    [[nodiscard]] QToolButton* railButton(const RailPage& page);
    [[nodiscard]] QWidget* buildTopBar();
    void addChips(QHBoxLayout* bar);
    void addAppearance(QHBoxLayout* bar);  ///< Language and theme.
    void addUserMenu(QHBoxLayout* bar);
    void addSwitch(QHBoxLayout* bar);
    void switchUser();
    /// False: something would be lost, and who is asked stays.
    [[nodiscard]] bool maySignOut();
    void rebuild();
    /// A page, with what was typed into it and is not saved.
    struct Kept {
        Place place;
        QVariantMap typed;
    };
    [[nodiscard]] Kept whatIsShown() const;
    void showAgain(const Kept& kept);
    void typeAgain(const QVariantMap& typed);  ///< Now, and when more fields have come.
    /// Of a page that is left for another one and comes back with it.
    void keepTyped(const Place& next);
    [[nodiscard]] static QString draftOf(const Place& place);
    /// A participant is at the screen: no rail, no search, no other page without the password.
    [[nodiscard]] bool handedOver() const;
    /// False keeps the screen with the participant.
    [[nodiscard]] bool mayTakeBack();
    void showPlace(const Place& place);
    /// In place of the page before. @param made of place_.
    void showPage(Page* made);
    void showRetry(const QString& text, const std::function<void()>& again);
    /// A way out below it: the store that was chosen is another computer's, and that may be gone.
    void offerOwnStore(const std::function<void()>& again);
    void showMissingStore();
    void restoreFrom(const QString& file);
    /// Brings it up to date behind a page that says so, and begins again.
    void updateStore();
    void showUpdating();
    /// @param copy where the store as it was before is kept; empty = none was made.
    void showUpdateFailed(const QString& copy);
    /// A card in the middle, in place of any page. @param layout what it holds
    QWidget* showCard(QVBoxLayout* layout);
    struct Way {
        QString text;
        const char *kind, *icon, *name;
    };
    /// A button of such a card.
    QPushButton* addWay(QVBoxLayout* layout, const Way& way, const std::function<void()>& act);
    void announce(const QString& text, const QString& written = {});
    void goBack();
    /// Leaves `from` as it asked for, not while a question stands; then only if it is shown still.
    void leavePage(const QPointer<Page>& from, const std::function<void()>& leave);
    void onUserChanged();
    void onAttemptEnded(const AttemptEnding& ending);
    void saveAttempt(const AttemptEnding& ending);
    /// Whoever looks at that attempt sees what came out.
    void onReplayed(qint64 attempt_id);
    void offerLeftovers();
    /// The server is away: said, and true, where the attempt is saved when it is back.
    [[nodiscard]] bool keepForLater(const AttemptOrder& order, const std::exception_ptr& error);
    void watchWaiting();
    void onWaitingSaved(const AttemptOrder& order, qint64 attempt_id);
    void showWaitingCount();
    /// Whoever began it is on another page than the one with its list and certificate.
    void onErasureEnded(const QString& name, bool done);
    void openSearch();
    /// The time to the lock begins anew.
    void touched();
    /// Back to log-in; who comes back as the same person is where he was. Not while an attempt
    /// runs, nor while a participant is at the screen.
    void lock();
    /// For whoever is signed in still and is sent to log-in next.
    void keepPlace();
    /// False: the rights of who has signed in do not reach that page any more.
    [[nodiscard]] bool comesBack(const Kept& kept);
    [[nodiscard]] bool closesNotice(QObject* object, QEvent* event);
    /// Enter that was held to end an attempt is still down when this window is in front again.
    [[nodiscard]] bool isLeftOverKey(QEvent* event);
    void onCameBack(Qt::ApplicationState state);
    /// A double click at a button that leads on: its second press falls on whatever page or
    /// question stands there by then, and is meant for none. Nor does it do once more what a
    /// primary or destructive button has just done.
    [[nodiscard]] bool isSecondOfTwo(const QObject* window, const QMouseEvent& press);
    void rememberPlace();
    /// The page that this user left last, if it may still be opened.
    [[nodiscard]] Place lastPlace() const;
    /// Where an attempt that came to nothing was asked for.
    [[nodiscard]] static Place placeOf(const AttemptOrder& order);
    /// Whoever is signed in may be another than the one who made the attempt.
    [[nodiscard]] bool isMine(const AttemptOrder& order) const;
    /// Work in the background would hold up the end of the program without a window: asks, and
    /// closes later where that is wished. False: there is none.
    [[nodiscard]] bool waitsForWork();
    /// From the page of an attempt that came to nothing.
    [[nodiscard]] QRect barStrip() const;
    /// The history opens on the task that is before the eyes.
    [[nodiscard]] QVariantMap historyState() const;
    void leaveRunning(const AttemptOrder& order);
    [[nodiscard]] Place home() const;
    void updateFrame();
    /// Messages float over the page, not over rail and top bar.
    void placeNotices();
    /// A narrow window (or a large scale) has icons only in the rail; the words are tool tips.
    void narrowRail();

    AppContext& context_;
    Place place_;
    std::vector<Place> trail_;
    QVariantMap late_;                       ///< Typed before; for fields that the page gets later.
    std::map<QString, QVariantMap> drafts_;  ///< Typed on pages that were left, by draftOf().
    QPointer<Page> page_;
    Notices* notices_ = nullptr;
    QWidget *rail_ = nullptr, *bar_ = nullptr;
    QVBoxLayout* content_ = nullptr;
    QPointer<QWidget> shown_;
    QLabel* title_ = nullptr;
    QToolButton *running_ = nullptr, *waiting_ = nullptr;
    std::vector<std::pair<QToolButton*, PageId>> rail_buttons_;
    QPointer<QWidget> search_;
    bool closes_when_done_ = false;  ///< Until a problem is reported: it must be read.
    QTimer idle_;
    QTimer attempt_ended_;    ///< Runs for a moment after the end of an attempt.
    QElapsedTimer held_key_;  ///< Valid: a key may still be down. Since it was heard of last.
    QElapsedTimer pressed_;   ///< Since the last press of the pointer.
    QPoint pressed_at_;       ///< On the screen.
    /// Window and page: only told apart, never looked into.
    std::pair<const void*, const void*> pressed_on_{};
    Kept kept_;
    int64_t kept_for_ = 0;  ///< Whoever was sent to log-in, and nobody else; 0 = nobody.
};

}  // namespace placode::ui
