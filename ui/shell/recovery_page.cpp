// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Recovery: recordings that a crash, a power cut or a failed saving left behind. Save, keep for
// later, or delete; nothing happens by itself.

#include <QComboBox>
#include <QFile>
#include <QFileInfo>
#include <QHBoxLayout>
#include <memory>

#include "db/whole_file.h"
#include "ui/shell/details.h"
#include "ui/shell/pages.h"
#include "ui/shell/parts.h"
#include "ui/shell/waiting_recordings.h"

namespace placode::ui {
namespace {

class RecoveryPage : public Page {
    Q_DECLARE_TR_FUNCTIONS(RecoveryPage)
 public:
    explicit RecoveryPage(AppContext& context) : Page(context) {
        QVBoxLayout* column = make_column(this, 860);
        column->addWidget(make_label(tr("Attempts that were not finished"), "display"));
        column->addWidget(make_label(
            tr("Everything up to half a second before the end is in the recording."), "muted"));
        int shown = 0;
        for (const Leftover& leftover : context.leftovers(Depth::kWhole)) {
            if (!mine(leftover)) continue;
            column->addWidget(card(leftover, shown++));
        }
        if (shown == 0) {
            column->addWidget(make_label(tr("Nothing is left to recover."), "heading"));
        }
        column->addStretch();
    }

    [[nodiscard]] QString title() const override { return tr("Recovery"); }

 private:
    /// One's own; an administrator also sees those of others and those without an owner, and those
    /// of studies are who runs studies's.
    [[nodiscard]] bool mine(const Leftover& leftover) const {
        if (leftover.order && !leftover.order->study.isEmpty())
            return context_.may(db::Action::kRunQuestionnaire);
        if (leftover.order && leftover.order->user_id == context_.user().id) return true;
        return context_.may(db::Action::kManageUsers, db::Scope::kOther);
    }

    /// The file beside the recording holds a number: names are the store's.
    [[nodiscard]] QString whose(const AttemptOrder& order) const {
        if (!order.study.isEmpty()) return order.participant;
        const auto owner = context_.store().accounts().find(order.user_id);
        return owner ? qstr(owner->display_name) : tr("number %1").arg(order.user_id);
    }

    QWidget* card(const Leftover& leftover, int index) {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace12);
        layout->addWidget(make_label(headline(leftover), "heading"));
        if (leftover.order &&
            (leftover.order->user_id != context_.user().id || !leftover.order->study.isEmpty()))
            layout->addWidget(
                make_label(tr("Belongs to %1.").arg(whose(*leftover.order)), "muted"));
        if (leftover.problem)
            layout->addWidget(make_label(recording_problem(*leftover.problem).title, "critical"));
        else if (!leftover.damage.isEmpty())
            layout->addWidget(make_label(damaged_part(leftover.damage).title, "warn"));
        QComboBox* owner = nullptr;
        if (!leftover.order && !leftover.problem) {
            owner = ownerChooser();
            owner->setObjectName(QString("recover_owner_%1").arg(index));
            layout->addLayout(make_field(tr("Nobody knows whose it is. Save it for"), owner));
        }
        QStringList exact{leftover.recording_file};
        if (leftover.problem) exact << QString::fromUtf8(leftover.problem->what());
        if (!leftover.damage.isEmpty()) exact << leftover.damage;
        if (keepsExam(leftover))
            layout->addWidget(
                make_label(tr("This is an exam: it is saved and uses up this attempt."), "warn"));
        layout->addWidget(new Details(context_, exact.join("\n")));
        layout->addLayout(buttons(leftover, owner, index));
        return make_card(layout);
    }

    /// Its case was seen: nobody throws an exam away, or begins the next one beside it.
    [[nodiscard]] static bool keepsExam(const Leftover& leftover) {
        return leftover.order && leftover.order->mode() == curriculum::AttemptMode::kExam &&
               !leftover.problem;
    }

    [[nodiscard]] QString headline(const Leftover& leftover) const {
        const QString when = format_clock(leftover.started_utc);
        if (leftover.problem)
            return when.isEmpty() ? tr("A recording") : tr("Recording of %1").arg(when);
        const QString length = format_duration(leftover.duration_s);
        if (context_.waiting().holds(leftover.recording_file))
            return tr("%1 of %2 (%3) waits for the server. It is saved by itself when that is "
                      "back.")
                .arg(leftover.task, when, length);
        return leftover.complete
                   ? tr("%1 of %2 (%3) was finished but could not be saved. Save it now?")
                         .arg(leftover.task, when, length)
                   : tr("%1 of %2 was not finished (%3). Save it as interrupted?")
                         .arg(leftover.task, when, length);
    }

    QComboBox* ownerChooser() {
        auto* box = new QComboBox;
        keep_narrow(box);
        for (const db::UserRecord& person : context_.store().accounts().list()) {
            if (db::has_role(person.roles, db::Role::kTrainee))
                box->addItem(qstr(person.display_name), QVariant::fromValue<qint64>(person.id));
        }
        box->setPlaceholderText(tr("Choose …"));
        box->setCurrentIndex(-1);  // It becomes nobody's by his being first in a list.
        return box;
    }

    QHBoxLayout* buttons(const Leftover& leftover, QComboBox* owner, int index) {
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace12);
        const QString file = leftover.recording_file;
        if (!leftover.problem) {
            QPushButton* save = make_button(context_, tr("Save"), "primary", "check");
            save->setObjectName(QString("recover_save_%1").arg(index));
            save->setEnabled(owner == nullptr);
            if (owner != nullptr)
                connect(owner, &QComboBox::currentIndexChanged, save,
                        [save](int row) { save->setEnabled(row >= 0); });
            connect(save, &QPushButton::clicked, this, [this, leftover, owner] {
                AttemptOrder order = leftover.order.value_or(AttemptOrder{});
                order.recording_file = leftover.recording_file;
                if (owner != nullptr) order.user_id = owner->currentData().toLongLong();
                this->save(order);
            });
            row->addWidget(save);
        }
        QPushButton* keep = make_button(context_, tr("Keep for later"), "secondary");
        keep->setObjectName(QString("recover_keep_%1").arg(index));
        connect(keep, &QPushButton::clicked, this, [this] { Q_EMIT back(); });
        QPushButton* remove = make_button(context_, tr("Delete"), "danger", "close");
        remove->setObjectName(QString("recover_delete_%1").arg(index));
        connect(remove, &QPushButton::clicked, this, [this, file] {
            if (!confirm(this, tr("Delete this recording?"), tr("The attempt is lost for good."),
                         tr("Delete")))
                return;
            context_.guard(tr("Deleting the recording"), [&] {
                context_.audit("recording.delete", file);
                remove_recording(file);
                Q_EMIT go({PageId::kRecovery, 0, {}, {}});
            });
        });
        row->addWidget(keep);
        QPushButton* elsewhere = make_button(context_, tr("Copy it to another disk"), "secondary");
        elsewhere->setObjectName(QString("recover_copy_%1").arg(index));
        connect(elsewhere, &QPushButton::clicked, this, [this, file] { copyElsewhere(file); });
        row->addWidget(elsewhere);
        row->addStretch();
        remove->setVisible(!keepsExam(leftover));
        row->addWidget(remove);
        return row;
    }

    /// What is there already stays unless the copy is whole. Why it is not; empty = it is.
    [[nodiscard]] static QString copyWhole(const QString& from, const QString& to) {
        constexpr qint64 kAtOnce = 1 << 20;
        QFile source(from);
        db::WholeFile copy(to);
        if (!source.open(QIODevice::ReadOnly)) return source.errorString();
        if (!copy.open(QIODevice::WriteOnly)) return copy.errorString();
        for (QByteArray part = source.read(kAtOnce); !part.isEmpty(); part = source.read(kAtOnce))
            if (copy.write(part) != part.size()) return copy.errorString();
        if (source.error() != QFileDevice::NoError) return source.errorString();
        return copy.commit() ? QString() : copy.errorString();
    }

    /// Where this disk is full or ends: the file is whole elsewhere before anybody relies on it.
    void copyElsewhere(const QString& file) {
        const QString path =
            context_.askSaveFile(this, tr("Copy the recording"), QFileInfo(file).fileName(),
                                 tr("Recording (*.placode)"));
        if (path.isEmpty()) return;
        context_.guard(tr("Copying the recording"), [&] {
            if (QFileInfo(path) == QFileInfo(file))
                throw Refusal(tr("The recording is there already: choose another folder."));
            if (const QString said = copyWhole(file, path); !said.isEmpty())
                throw db::StoreError(db::StoreError::Kind::kOther, "copy " + file.toStdString() +
                                                                       " to " + path.toStdString() +
                                                                       ": " + said.toStdString());
            context_.audit("recording.copy", QFileInfo(file).fileName());
            Q_EMIT written(tr("Recording copied: %1").arg(path), path);
        });
    }

    void save(const AttemptOrder& order) {
        auto saved = std::make_shared<SavedAttempt>();
        context_.backgroundFor(
            context_.user().id, this, tr("Saving the attempt"),
            [saved, order](db::Store& store) { *saved = save_recording(store, order); },
            [this, saved, order](bool done) {
                if (!done) return;
                context_.verifyAttempts();
                if (saved->outcome == Saving::kGone) {
                    Q_EMIT go({PageId::kRecovery, 0, {}, {}});
                    return;
                }
                if (saved->outcome == Saving::kEmpty) {
                    Q_EMIT notice(tr("Nothing had been recorded; the empty file was removed."));
                    Q_EMIT go({PageId::kRecovery, 0, {}, {}});
                    return;
                }
                Q_EMIT notice(tr("The attempt was saved."));
                Q_EMIT go(
                    order.study.isEmpty()
                        ? Place{PageId::kResult, saved->attempt_id, {}, {}}
                        : Place{
                              PageId::kStudyData, 0, order.participant, {{"study", order.study}}});
            },
            {}, {}, Lane::kSaving);
    }
};

}  // namespace

Page* make_recovery_page(AppContext& context, const Place&) { return new RecoveryPage(context); }

}  // namespace placode::ui
