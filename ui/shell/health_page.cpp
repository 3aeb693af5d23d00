// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Backup and health: is the store sound, and a consistent copy of it.

#include <QDateTime>
#include <QFileInfo>
#include <QHBoxLayout>
#include <atomic>
#include <memory>
#include <optional>

#include "ui/shell/daily_backup_card.h"
#include "ui/shell/details.h"
#include "ui/shell/diagnostics_dialog.h"
#include "ui/shell/pages.h"
#include "ui/shell/parts.h"
#include "ui/shell/passphrase_dialog.h"

namespace placode::ui {
namespace {

class HealthPage : public Page {
    Q_DECLARE_TR_FUNCTIONS(HealthPage)
 public:
    explicit HealthPage(AppContext& context) : Page(context) {
        context.require(db::Action::kBackup, db::Scope::kOther);
        QVBoxLayout* column = make_column(this, 860);
        column->addWidget(make_label(tr("Backup and health"), "display"));
        column->addWidget(checkCard());
        column->addWidget(backupCard());
        if (context.storeIsFile()) column->addWidget(make_daily_backup_card(context));
        column->addWidget(programsCard());
        column->addStretch();
    }

    /// Nobody would hear what a check that goes on has found.
    ~HealthPage() override {
        if (stop_) *stop_ = true;
    }
    HealthPage(const HealthPage&) = delete;
    HealthPage& operator=(const HealthPage&) = delete;

    [[nodiscard]] QString title() const override { return tr("Backup and health"); }

 private:
    QWidget* checkCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace12);
        layout->addWidget(make_label(tr("The store"), "heading"));
        const QString place = qstr(context_.store().url());
        const QFileInfo file(place.mid(7));
        const bool embedded = place.startsWith("sqlite:");
        layout->addWidget(make_label(embedded
                                         ? tr("A file on this computer: %1").arg(file.fileName())
                                         : tr("A server of the centre (PostgreSQL)"),
                                     "muted"));
        if (embedded && file.exists())
            layout->addWidget(make_label(
                tr("Size: %1")
                    .arg(QLocale().formattedDataSize(file.size() +
                                                     QFileInfo(file.filePath() + "-wal").size())),
                "muted"));
        auto* where = new Details(context_, place);
        where->setObjectName("store_place");
        layout->addWidget(where);
        if (!embedded) addLogIn(layout);
        addClearKey(layout);
        outcome_ = make_label(tr("Not checked since this page was opened."));
        outcome_->setObjectName("check_outcome");
        layout->addWidget(outcome_);
        problems_ = new Details(context_);
        problems_->setObjectName("check_details");
        layout->addWidget(problems_);
        QPushButton* check = make_button(context_, tr("Check the store"), "secondary", "health");
        check->setObjectName("check_store");
        connect(check, &QPushButton::clicked, this, [this] { this->check(); });
        layout->addWidget(check, 0, Qt::AlignLeft);
        check_ = check;
        cancel_ = make_button(context_, tr("Cancel the check"), "secondary", "close");
        cancel_->setObjectName("cancel_check");
        connect(cancel_, &QPushButton::clicked, this, [this] {
            *stop_ = true;
            cancel_->setEnabled(false);
        });
        cancel_->hide();
        layout->addWidget(cancel_, 0, Qt::AlignLeft);
        return make_card(layout);
    }

    /// What the log-in to the server may do beyond a station's.
    void addLogIn(QVBoxLayout* layout) {
        QStringList problems;
        for (const std::string& each : context_.store().role_problems()) problems << qstr(each);
        if (problems.isEmpty()) return;
        layout->addWidget(make_label(
            tr("Placode's log-in to the server can change scores and the audit list. Give each "
               "station a log-in of its own: see the chapter \"A store for several stations\"."),
            "critical"));
        auto* exact = new Details(context_);
        exact->setText(problems.join("\n"));
        layout->addWidget(exact);
    }

    /// An earlier version kept the centre's key as it is. No damage: the check finds none.
    void addClearKey(QVBoxLayout* layout) {
        const auto key = context_.store().norms().centre_key();
        if (!key || key->sealed) return;
        clear_key_ = new QWidget;
        auto* inside = new QVBoxLayout(clear_key_);
        inside->setContentsMargins(0, 0, 0, 0);
        inside->setSpacing(kSpace8);
        QLabel* said = make_label(
            tr("The centre's signing key lies in clear in this store and in its backups: whoever "
               "reads them can sign norm packs in the centre's name. Put it under a passphrase "
               "here, or with `placodectl norms key seal`."),
            "critical");
        said->setObjectName("clear_key");
        inside->addWidget(said);
        QPushButton* seal = make_button(context_, tr("Choose a passphrase"), "secondary", "key");
        seal->setObjectName("seal_key");
        connect(seal, &QPushButton::clicked, this, [this] { sealKey(); });
        inside->addWidget(seal, 0, Qt::AlignLeft);
        layout->addWidget(clear_key_);
    }

    void sealKey() {
        const PassphraseQuestion question{
            tr("Whoever signs norm packs of this centre needs it from now on. Keep it in another "
               "place; without it only a new key helps."),
            tr("Seal the key"), true};
        const bool sealed =
            ask_passphrase(context_, this, question, [this](std::string_view passphrase) {
                context_.require(db::Action::kBackup, db::Scope::kOther);
                context_.store().norms().seal_centre_key(passphrase);
            });
        if (!sealed) return;
        clear_key_->hide();
        Q_EMIT notice(
            tr("The key is sealed. Earlier backups hold it in clear: make a new one, and "
               "remove them."));
    }

    void check() {
        using Problems = std::optional<std::vector<std::string>>;
        auto problems = std::make_shared<Problems>();
        stop_ = std::make_shared<std::atomic<bool>>(false);
        check_->hide();
        cancel_->setEnabled(true);
        cancel_->show();
        context_.background(
            this, tr("Checking the store"),
            [problems, stop = stop_](db::Store& store) {
                *problems = store.check({[stop] { return stop->load(); }, {}});
            },
            [this, problems](bool done) {
                cancel_->hide();
                check_->show();
                if (done && !*problems)
                    return say(tr("The check was cancelled. It has not said whether the store is "
                                  "sound."),
                               "", {});
                QStringList lines, exact;
                for (const std::string& problem : problems->value_or(std::vector<std::string>{})) {
                    lines << "• " + health_problem(qstr(problem)).said();
                    exact << qstr(problem);
                }
                say(!done             ? tr("The check could not be finished.")
                    : lines.isEmpty() ? tr("✓ Sound: no problem found.")
                                      : tr("Problems found:") + "\n" + lines.join("\n"),
                    !done || !lines.isEmpty() ? "critical" : "good", exact);
            });
    }

    void say(const QString& outcome, const char* role, const QStringList& exact) {
        problems_->setText(exact.join("\n"));
        outcome_->setProperty("role", role);
        outcome_->style()->unpolish(outcome_);
        outcome_->style()->polish(outcome_);
        outcome_->setText(outcome);
    }

    QWidget* backupCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace12);
        layout->addWidget(make_label(tr("Backup"), "heading"));
        layout->addWidget(make_label(
            tr("A consistent copy, also while people work: accounts, attempts with their "
               "recordings, answers, audit. It holds personal data; keep it as safe as the store."),
            "muted"));
        const QString last = context_.storeSetting("last_backup").toString();
        last_ = make_label(last.isEmpty() ? tr("No backup was made from this machine yet.")
                                          : tr("Last backup: %1").arg(last),
                           "small");
        last_->setObjectName("last_backup");
        layout->addWidget(last_);
        QPushButton* backup = make_button(context_, tr("Back up now"), "primary", "download");
        backup->setObjectName("backup_now");
        connect(backup, &QPushButton::clicked, this, [this] { this->backup(); });
        layout->addWidget(backup, 0, Qt::AlignLeft);
        return make_card(layout);
    }

    void backup() {
        const QString name =
            "placode-" + QDateTime::currentDateTime().toString("yyyyMMdd-HHmm") + ".backup.db";
        const QString path =
            context_.askSaveFile(this, tr("Back up the store"), name, tr("Placode store (*.db)"));
        if (path.isEmpty()) return;
        context_.background(
            this, tr("Backing up the store"),
            [path](db::Store& store) { store.backup(path.toStdString()); },
            [this, path](bool done) {
                if (!done) return;
                context_.guard(tr("Noting the backup"), [&] {
                    const QString note =
                        QLocale().toString(QDateTime::currentDateTime(), "d MMM yyyy, HH:mm") +
                        ", " + path;
                    context_.setStoreSetting("last_backup", note);
                    last_->setText(tr("Last backup: %1").arg(note));
                    Q_EMIT written(tr("Backup written: %1").arg(path), path);
                });
            });
    }

    QWidget* programsCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace12);
        layout->addWidget(make_label(tr("The programs on this computer"), "heading"));
        layout->addWidget(make_label(
            tr("What started, ended and failed here, without names or results. Read it before you "
               "send it to whoever looks for a fault."),
            "muted"));
        QPushButton* show = make_button(context_, tr("Log and crash reports"), "secondary");
        show->setObjectName("show_diagnostics");
        connect(show, &QPushButton::clicked, this,
                [this] { show_diagnostics(context_, window()); });
        layout->addWidget(show, 0, Qt::AlignLeft);
        return make_card(layout);
    }

    QLabel *outcome_ = nullptr, *last_ = nullptr;
    Details* problems_ = nullptr;
    QPushButton *check_ = nullptr, *cancel_ = nullptr;
    std::shared_ptr<std::atomic<bool>> stop_;  ///< Of the check that began last.
    QWidget* clear_key_ = nullptr;
};

}  // namespace

Page* make_health_page(AppContext& context, const Place&) { return new HealthPage(context); }

}  // namespace placode::ui
