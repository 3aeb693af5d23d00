// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/daily_backup_card.h"

#include <QDateTime>
#include <QDir>
#include <QProcess>
#include <QStandardPaths>

#include "db/whole_file.h"
#include "ui/shell/details.h"
#include "ui/shell/parts.h"

namespace placode::ui {
namespace {

constexpr const char* kTimer = "placode-backup.timer";
constexpr int kPatienceMs = 15000;  // systemd answers within milliseconds, or hangs

/// As packaging/scheduled-backup has it.
QString backup_folder() {
    QString chosen = qEnvironmentVariable("PLACODE_BACKUP_FOLDER");
    if (!chosen.isEmpty()) return chosen;
    return QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) +
           "/placode/backups";
}

/// What tells placode-backup.service which store it copies, where that is not the usual one.
QString drop_in_path() {
    return QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation) +
           "/systemd/user/placode-backup.service.d/store.conf";
}

QString clean_file(const std::string& store_url) {
    return QDir::cleanPath(QFileInfo(qstr(store_url).mid(7)).absoluteFilePath());
}

/// The drop-in for this store; empty for the one that the service copies by itself.
QByteArray drop_in_for(const std::string& store_url) {
    QString file = clean_file(store_url);
    if (file == clean_file(db::default_store_url())) return {};
    // What systemd would read otherwise within quotes: systemd.syntax(7), and % of systemd.unit(5).
    file.replace("\\", "\\\\").replace("\"", "\\\"").replace("\n", "\\n").replace("%", "%%");
    return "# Written by Placode, page Health: the store that is copied every day.\n[Service]\n"
           "Environment=\"PLACODE_STORE=sqlite:" +
           file.toUtf8() + "\"\n";
}

QByteArray drop_in_now() {
    QFile file(drop_in_path());
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// What went wrong; empty = it is there, or gone where `text` is empty.
QString keep_drop_in(const QByteArray& text) {
    const QString path = drop_in_path();
    if (text.isEmpty()) {
        QFile old(path);
        return !old.exists() || old.remove() ? QString() : path + ": " + old.errorString();
    }
    QDir().mkpath(QFileInfo(path).path());
    db::WholeFile file(path);
    const bool kept =
        file.open(QIODevice::WriteOnly) && file.write(text) == text.size() && file.commit();
    return kept ? QString() : path + ": " + file.errorString();
}

class DailyBackupCard : public QFrame {
    Q_DECLARE_TR_FUNCTIONS(DailyBackupCard)
 public:
    explicit DailyBackupCard(AppContext& context)
        : context_(context), drop_in_(drop_in_for(context.store().url())) {
        setProperty("role", "card");
        auto* layout = new QVBoxLayout(this);
        layout->setContentsMargins(kSpace24, kSpace16, kSpace24, kSpace24);
        layout->setSpacing(kSpace12);
        layout->addWidget(make_label(tr("Every day by itself"), "heading"));
        layout->addWidget(make_label(
            tr("A copy of this user's store every day, opened and checked; the last 30 stay. Copy "
               "their folder to another disk yourself."),
            "muted"));
        state_ = make_label({});
        state_->setObjectName("daily_state");
        layout->addWidget(state_);
        newest_ = make_label({}, "small");
        newest_->setObjectName("daily_newest");
        layout->addWidget(newest_);
        exact_ = new Details(context);
        exact_->setObjectName("daily_details");
        exact_->hide();
        layout->addWidget(exact_);
        switch_ = make_button(context, tr("Switch on"), "secondary");
        switch_->setObjectName("daily_switch");
        connect(switch_, &QPushButton::clicked, this, [this] { turn(); });
        layout->addWidget(switch_, 0, Qt::AlignLeft);
        switch_->hide();  // Until systemd has said that there is something to switch.
        showNewest();
        ask();
    }
    /// A page may be left before systemd has answered, and then nobody listens any more.
    ~DailyBackupCard() override {
        for (QProcess* process : findChildren<QProcess*>()) {
            process->disconnect();
            process->kill();
            process->waitForFinished(1000);
        }
    }

 private:
    /// Runs systemctl beside the page; `then` gets its exit status (-1 = it did not run) and what
    /// it said.
    void systemctl(const QStringList& arguments, std::function<void(int, QString)> then) {
        switch_->setEnabled(false);
        auto* process = new QProcess(this);
        process->setProcessChannelMode(QProcess::MergedChannels);
        auto end = [process, then = std::move(then)](int status, const QString& said) {
            process->disconnect();  // Said once.
            process->deleteLater();
            then(status, said);
        };
        connect(process, &QProcess::finished, this,
                [process, end](int status, QProcess::ExitStatus how) {
                    end(how == QProcess::NormalExit ? status : -1,
                        QString::fromLocal8Bit(process->readAll()).trimmed());
                });
        connect(process, &QProcess::errorOccurred, this, [process, end](QProcess::ProcessError e) {
            if (e == QProcess::FailedToStart) end(-1, "systemctl: " + process->errorString());
        });
        QTimer::singleShot(kPatienceMs, process, [process] { process->kill(); });
        process->start("systemctl", QStringList{"--user"} + arguments);
    }

    void ask() {
        systemctl({"is-enabled", kTimer}, [this](int status, const QString& said) {
            const bool on = status == 0, off = said == "disabled";
            showState(on, on || off, said);
        });
    }

    /// @param runs the timer, for whichever store.
    void showState(bool runs, bool possible, const QString& said) {
        const bool on = runs && drop_in_now() == drop_in_;
        on_ = on;
        state_->setText(on     ? tr("✓ It is on.")
                        : runs ? tr("It copies another store of this user, not this one. Switch "
                                    "it on here to copy this one instead.")
                        : possible ? tr("It is off.")
                                   : tr("It cannot be switched here: Placode was not installed as "
                                        "a package, or this computer runs no systemd for users."));
        exact_->setVisible(!possible);
        if (!possible)
            exact_->setText("systemctl --user is-enabled " + QString(kTimer) + ": " + said);
        switch_->setText(on ? tr("Switch off") : tr("Switch on"));
        switch_->setVisible(possible);
        switch_->setEnabled(possible);
    }

    void turn() {
        if (on_) return change("disable");
        const QString problem = keep_drop_in(drop_in_);
        if (!problem.isEmpty()) return reportFailure(problem);
        systemctl({"daemon-reload"}, [this](int status, const QString& said) {
            if (status == 0) return change("enable");
            reportFailure("systemctl --user daemon-reload: " + said);
            ask();
        });
    }

    void change(const QString& verb) {
        systemctl({verb, "--now", kTimer}, [this, verb](int status, const QString& said) {
            if (status != 0)
                reportFailure("systemctl --user " + verb + " --now " + kTimer + ": " + said);
            if (status == 0)
                context_.guard(tr("Writing the audit"), [&] {
                    context_.audit(on_ ? "backup.daily.off" : "backup.daily.on", kTimer);
                });
            ask();
        });
    }

    void reportFailure(const QString& exact) {
        context_.report({tr("The daily backup could not be switched."),
                         tr("Ask whoever looks after this computer."), exact});
    }

    void showNewest() {
        const QDir folder(backup_folder());
        const QFileInfoList made =
            folder.entryInfoList({"placode-*.backup.db", "placode-*.backup.db.failed"}, QDir::Files,
                                 QDir::Name | QDir::Reversed);
        if (made.isEmpty()) return newest_->setText(tr("No daily copy was made yet."));
        const QFileInfo& newest = made.front();
        const QString when = QLocale().toString(newest.lastModified(), "d MMM yyyy, HH:mm") + ", " +
                             newest.absoluteFilePath();
        const bool failed = newest.fileName().endsWith(".failed");
        newest_->setProperty("role", failed ? "critical" : "small");
        newest_->setText(failed ? tr("The newest daily copy did not pass its check: %1").arg(when)
                                : tr("Newest daily copy: %1").arg(when));
    }

    AppContext& context_;
    const QByteArray drop_in_;  ///< What makes the service copy the store that is open.
    QLabel *state_ = nullptr, *newest_ = nullptr;
    Details* exact_ = nullptr;
    QPushButton* switch_ = nullptr;
    bool on_ = false;
};

}  // namespace

QWidget* make_daily_backup_card(AppContext& context) { return new DailyBackupCard(context); }

}  // namespace placode::ui
