// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/passphrase_dialog.h"

#include <QApplication>
#include <QCheckBox>
#include <QDialog>
#include <QHBoxLayout>
#include <QLineEdit>

#include "db/participant_key.h"
#include "db/secret.h"
#include "ui/shell/dialog_frame.h"
#include "ui/shell/parts.h"

namespace placode::ui {
namespace {

class PassphraseDialog : public QDialog {
    Q_DECLARE_TR_FUNCTIONS(PassphraseDialog)
 public:
    PassphraseDialog(AppContext& context, QWidget* parent, const PassphraseQuestion& question,
                     const std::function<void(std::string_view)>& use)
        : QDialog(parent), context_(context), use_(use) {
        setObjectName("passphrase_dialog");
        setWindowTitle(tr("Passphrase of the centre's key"));
        setMinimumWidth(480);
        auto* column = new QVBoxLayout(this);
        column->setContentsMargins(kSpace24, kSpace24, kSpace24, kSpace24);
        column->setSpacing(kSpace12);
        column->addWidget(make_label(tr("Passphrase of the centre's key"), "title"));
        column->addWidget(make_label(question.purpose, "muted"));
        phrase_ = addLine(
            column,
            question.is_new
                ? tr("New passphrase, at least %1 characters").arg(db::kLeastPassphraseLength)
                : tr("Passphrase"),
            "passphrase");
        if (question.is_new) again_ = addLine(column, tr("Again"), "passphrase_again");
        auto* show = new QCheckBox(tr("Show what I type"));
        show->setObjectName("passphrase_show");
        connect(show, &QCheckBox::toggled, this, [this](bool shown) { showTyped(shown); });
        column->addWidget(show);
        message_ = make_label({}, "critical");
        message_->setObjectName("passphrase_message");
        message_->hide();
        column->addWidget(message_);
        column->addLayout(buttons(question.verb));
        frame_dialog(this);
        phrase_->setFocus();
    }
    ~PassphraseDialog() override { forget(); }

 private:
    QLineEdit* addLine(QVBoxLayout* column, const QString& name, const char* object_name) {
        auto* line = new QLineEdit;
        line->setObjectName(object_name);
        line->setEchoMode(QLineEdit::Password);
        column->addLayout(make_field(name, line));
        return line;
    }

    QHBoxLayout* buttons(const QString& verb) {
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace8);
        QPushButton* no = make_button(context_, tr("Cancel"), "secondary");
        no->setObjectName("passphrase_no");
        no->setAutoDefault(false);
        QPushButton* yes = make_button(context_, verb, "primary", "key");
        yes->setObjectName("passphrase_yes");
        yes->setDefault(true);
        row->addStretch();
        row->addWidget(no);
        row->addWidget(yes);
        connect(no, &QPushButton::clicked, this, &QDialog::reject);
        connect(yes, &QPushButton::clicked, this, [this] { take(); });
        return row;
    }

    void showTyped(bool shown) {
        for (QLineEdit* line : {phrase_, again_})
            if (line != nullptr) line->setEchoMode(shown ? QLineEdit::Normal : QLineEdit::Password);
    }

    void forget() {
        for (QLineEdit* line : {phrase_, again_})
            if (line != nullptr) line->clear();
    }

    void take() {
        if (phrase_->text().isEmpty()) return say(tr("Type the passphrase."));
        if (again_ != nullptr && again_->text() != phrase_->text())
            return say(tr("The two passphrases differ. Type both again."));
        std::string typed = phrase_->text().toStdString();
        const db::Secret phrase(typed);
        db::wipe(typed);
        // Argon2id takes its time on purpose: about a second.
        QApplication::setOverrideCursor(Qt::WaitCursor);
        const auto problem = context_.problemOf([&] { use_(phrase.text()); });
        QApplication::restoreOverrideCursor();
        forget();
        phrase_->setFocus();
        if (problem) return say(problem->said());
        accept();
    }

    void say(const QString& text) {
        message_->setText(text);
        message_->show();
        make_room(this);
    }

    AppContext& context_;
    const std::function<void(std::string_view)>& use_;
    QLineEdit *phrase_ = nullptr, *again_ = nullptr;
    QLabel* message_ = nullptr;
};

}  // namespace

bool ask_passphrase(AppContext& context, QWidget* parent, const PassphraseQuestion& question,
                    const std::function<void(std::string_view)>& use) {
    PassphraseDialog dialog(context, parent->window(), question, use);
    return dialog.exec() == QDialog::Accepted;
}

bool ask_centre_passphrase(AppContext& context, QWidget* parent,
                           const std::function<void(std::string_view)>& use) {
    const auto key = context.store().norms().centre_key();
    PassphraseQuestion question;
    question.verb = PassphraseDialog::tr("Sign");
    question.is_new = !key || !key->sealed;
    question.purpose =
        !key ? PassphraseDialog::tr(
                   "The centre's key is made now and signs this norm pack. Choose "
                   "its passphrase: whoever signs packs of this centre needs it. "
                   "Keep it in another place; without it only a new key helps.")
        : question.is_new
            ? PassphraseDialog::tr(
                  "The centre's key signs this norm pack. Until now it lay in "
                  "clear in the store; it is put under a passphrase now. Keep it "
                  "in another place; without it only a new key helps.")
            : PassphraseDialog::tr("The key of %1 signs this norm pack.").arg(qstr(key->centre));
    return ask_passphrase(context, parent, question, use);
}

}  // namespace placode::ui
