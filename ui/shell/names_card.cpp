// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/names_card.h"

#include <QComboBox>
#include <QFileInfo>
#include <QGridLayout>
#include <QLineEdit>
#include <memory>

#include "db/participant_key.h"
#include "db/study_records.h"
#include "ui/shell/parts.h"
#include "ui/shell/signature_pad.h"
#include "ui/shell/study_parts.h"
#include "ui/shell/typed_texts.h"

namespace placode::ui {
namespace {

class NamesCard : public QFrame {
    Q_DECLARE_TR_FUNCTIONS(NamesCard)
 public:
    NamesCard(AppContext& context, Page& page, std::string study, QStringList codes)
        : context_(context), page_(page), study_(std::move(study)), codes_(std::move(codes)) {
        auto* outer = new QVBoxLayout(this);
        outer->setContentsMargins(0, 0, 0, 0);
        layout_ = new QVBoxLayout;
        layout_->setSpacing(kSpace12);
        layout_->addWidget(make_label(tr("Names behind the codes"), "heading"));
        layout_->addWidget(make_label(
            tr("In a file of its own, apart from the data, encrypted under a passphrase. It is in "
               "no export and no backup of the store: keep a copy, and the passphrase elsewhere. "
               "Whoever loses the passphrase loses the names. Once there is a key, signatures "
               "under consents are sealed: only this file opens them."),
            "muted"));
        addLocked();
        outer->addWidget(make_card(layout_));
    }

 private:
    void addLocked() {
        auto* grid = new QGridLayout;
        grid->setHorizontalSpacing(kSpace8);
        grid->setVerticalSpacing(kSpace8);
        path_ = make_line("key_path", tr("File of the key"));
        const QString kept = context_.storeSetting("key/" + qstr(study_)).toString();
        keep_choice(path_);
        path_->setText(kept.isEmpty() ? qstr(db::default_key_path(context_.storeUrl(), study_))
                                      : kept);
        passphrase_ = make_line(
            "key_passphrase",
            tr("Passphrase, at least %1 characters").arg(db::kLeastPassphraseLength), true);
        open_ = make_button(context_, tr("Open"), "secondary", "key");
        open_->setObjectName("open_key");
        connect(open_, &QPushButton::clicked, this, [this] { unlock(false); });
        make_ = make_button(context_, tr("Make a new key"), "secondary", "plus");
        make_->setObjectName("make_key");
        connect(make_, &QPushButton::clicked, this, [this] { unlock(true); });
        grid->addWidget(path_, 0, 0, 1, 3);
        grid->addWidget(passphrase_, 1, 0);
        grid->addWidget(open_, 1, 1);
        grid->addWidget(make_, 1, 2);
        layout_->addLayout(grid);
        shown_ = new QVBoxLayout;
        layout_->addLayout(shown_);
    }

    void unlock(bool make) {
        context_.guard(make ? tr("Making a key") : tr("Opening the key"), [&] {
            context_.require(db::Action::kRunQuestionnaire);
            const std::string path = path_->text().trimmed().toStdString();
            const std::string phrase = passphrase_->text().toStdString();
            auto key = make ? db::ParticipantKey::create(path, study_, phrase)
                            : db::ParticipantKey::open(path, phrase);
            if (key.study_id() != study_)
                throw Refusal(tr("These names belong to the study %1.").arg(qstr(key.study_id())));
            db::keep_consent_key(context_.store(), study_, key.consent_keys().public_key);
            key_ = std::make_unique<db::ParticipantKey>(std::move(key));
            context_.setStoreSetting("key/" + qstr(study_), path_->text().trimmed());
            context_.audit(make ? "study.key.make" : "study.key.open", qstr(study_),
                           path_->text().trimmed());
            passphrase_->clear();
            showNames();
        });
    }

    /// Also from a slot, which no exception may leave: the names lie in the key, and stand here
    /// when the store does not say who has signed.
    void showNames() {
        QStringList signatures;
        context_.guard(tr("Reading the signatures"), [&] { signatures = signedCodes(); });
        while (QLayoutItem* item = shown_->takeAt(0)) {
            if (QWidget* widget = item->widget()) {
                widget->hide();
                widget->deleteLater();
            }
            delete item;
        }
        auto* box = new QWidget;
        auto* inside = new QVBoxLayout(box);
        inside->setContentsMargins(0, 0, 0, 0);
        inside->setSpacing(kSpace8);
        QTableWidget* table =
            make_table({tr("Code"), tr("Name"), tr("Contact"), tr("Remark")}, tr("Names"));
        table->setObjectName("names_table");
        table->setRowCount(0);
        table->setSortingEnabled(false);
        for (const db::PersonEntry& each : key_->entries()) {
            const int row = table->rowCount();
            table->insertRow(row);
            int column = 0;
            for (const std::string& text : {each.code, each.name, each.contact, each.remark})
                table->setItem(row, column++, make_cell(qstr(text)));
        }
        fit_columns(table, 1);
        table->setMinimumHeight(std::min(6, table->rowCount() + 1) * kTouchTarget + 10);
        inside->addWidget(table);
        if (!signatures.isEmpty()) addSignatures(inside, signatures);
        inside->addLayout(addRow());
        shown_->addWidget(box);
        Q_EMIT page_.fieldsCame();
    }

    /// Of those who signed on the screen.
    [[nodiscard]] QStringList signedCodes() {
        QStringList found;
        for (const QString& code : codes_)
            if (context_.store().records().consent_signature(study_, code.toStdString()))
                found << code;
        return found;
    }

    /// The hand's lines under the consents.
    void addSignatures(QVBoxLayout* inside, const QStringList& codes) {
        auto* chooser = new QComboBox;
        chooser->setObjectName("signature_code");
        chooser->setAccessibleName(tr("Signature under the consent of"));
        chooser->addItems(codes);
        auto* picture = new QLabel;
        picture->setObjectName("signature_picture");
        const auto show = [this, chooser, picture] {
            const auto kept = context_.store().records().consent_signature(
                study_, chooser->currentText().toStdString());
            const auto path = kept ? db::decrypted(kept->path, key_->consent_keys()) : std::nullopt;
            picture->clear();
            if (path)
                picture->setPixmap(signature_picture(qstr(*path), context_.colors().text));
            else
                picture->setText(tr("Sealed for another key: open the one of that time."));
            context_.audit("study.consent.signature.show",
                           qstr(study_) + " " + chooser->currentText());
        };
        auto* row = new QHBoxLayout;
        QLabel* label = make_label(tr("Signature under the consent of"), "muted");
        label->setWordWrap(false);
        row->addWidget(label);
        row->addWidget(chooser);
        QPushButton* button = make_button(context_, tr("Show"), "secondary", "search");
        button->setObjectName("show_signature");
        connect(button, &QPushButton::clicked, this,
                [this, show] { context_.guard(tr("Showing a signature"), show); });
        row->addWidget(button);
        row->addStretch(1);
        inside->addLayout(row);
        inside->addWidget(picture);
    }

    QLayout* addRow() {
        auto* grid = new QGridLayout;
        grid->setHorizontalSpacing(kSpace8);
        auto* code = new QComboBox;
        code->setObjectName("name_code");
        code->setAccessibleName(tr("Code"));
        code->addItems(codes_);
        keep_choice(code);
        auto* name = make_line("name_name", tr("Name"));
        auto* contact = make_line("name_contact", tr("Contact"));
        auto* remark = make_line("name_remark", tr("Remark"));
        QPushButton* save = make_button(context_, tr("Keep the name"), "primary", "check");
        save->setObjectName("name_save");
        connect(save, &QPushButton::clicked, this, [this, code, name, contact, remark] {
            context_.guard(tr("Keeping a name"), [&] {
                key_->put({code->currentText().toStdString(),
                           name->text().trimmed().toStdString(),
                           contact->text().trimmed().toStdString(),
                           remark->text().trimmed().toStdString(),
                           {}});
                context_.audit("study.key.name", qstr(study_) + " " + code->currentText());
                // Queued: the button is among what is shown anew.
                QMetaObject::invokeMethod(
                    this, [this] { showNames(); }, Qt::QueuedConnection);
            });
        });
        QPushButton* hide = make_button(context_, tr("Hide the names"), "quiet", "lock");
        hide->setObjectName("name_hide");
        connect(hide, &QPushButton::clicked, this, [this] {
            key_.reset();
            Q_EMIT page_.go({PageId::kStudyData, 0, {}, {{"study", qstr(study_)}}});
        });
        grid->addWidget(code, 0, 0);
        grid->addWidget(name, 0, 1);
        grid->addWidget(contact, 0, 2);
        grid->addWidget(remark, 1, 0, 1, 2);
        grid->addWidget(save, 1, 2);
        grid->addWidget(hide, 2, 2);
        return grid;
    }

    AppContext& context_;
    Page& page_;
    std::string study_;
    QStringList codes_;
    std::unique_ptr<db::ParticipantKey> key_;
    QVBoxLayout *layout_ = nullptr, *shown_ = nullptr;
    QLineEdit *path_ = nullptr, *passphrase_ = nullptr;
    QPushButton *open_ = nullptr, *make_ = nullptr;
};

}  // namespace

QWidget* make_names_card(AppContext& context, Page& page, const std::string& study,
                         const QStringList& codes) {
    return new NamesCard(context, page, study, codes);
}

}  // namespace placode::ui
