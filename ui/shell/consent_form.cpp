// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/consent_form.h"

#include <QCheckBox>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <algorithm>

#include "ui/shell/parts.h"
#include "ui/shell/signature_pad.h"

namespace placode::ui {
namespace {

class ConsentForm : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(StudyRunPage)
 public:
    ConsentForm(AppContext& context, const curriculum::Consent& consent, ConsentAnswers answers,
                const QVariantMap& draft)
        : context_(context), answers_(std::move(answers)) {
        auto* layout = new QVBoxLayout(this);
        layout->setContentsMargins(0, 0, 0, 0);
        layout->setSpacing(kSpace12);
        for (const auto& text : consent.information)
            layout->addWidget(make_label(context_.in(text)));
        addStatements(layout, consent);
        addSignature(layout);
        addAnswers(layout);
        takeFrom(draft);
    }

 private:
    [[nodiscard]] QVariantMap draft() const {
        QStringList agreed;
        for (const auto& [box, statement] : boxes_)
            if (box->isChecked()) agreed << qstr(statement->id);
        if (agreed.isEmpty() && pad_->path().isEmpty() && !on_paper_->isChecked()) return {};
        return {{"language", context_.language()},
                {"agreed", agreed},
                {"signature", pad_->path()},
                {"on_paper", on_paper_->isChecked()}};
    }

    void takeFrom(const QVariantMap& draft) {
        if (draft.value("language").toString() == context_.language()) {
            const QStringList agreed = draft.value("agreed").toStringList();
            for (const auto& [box, statement] : boxes_)
                box->setChecked(agreed.contains(qstr(statement->id)));
            pad_->draw(draft.value("signature").toString());
            on_paper_->setChecked(draft.value("on_paper").toBool());
        }
        told_ = true;
        showMissing();
    }

    void addStatements(QVBoxLayout* layout, const curriculum::Consent& consent) {
        // Consent is given in the language that it was read in: nothing is carried over.
        QLabel* before = make_label(
            tr("Choose the language first: another language clears the ticks and the signature."),
            "small");
        before->setObjectName("consent_language");
        layout->addWidget(before);
        for (const auto& statement : consent.statements) {
            auto* box = new QCheckBox(context_.in(statement.text));
            box->setObjectName("consent_" + qstr(statement.id));
            box->setMinimumHeight(kTouchTarget);
            layout->addWidget(box);
            boxes_.emplace_back(box, &statement);
            connect(box, &QCheckBox::toggled, this, [this] { showMissing(); });
        }
    }

    void addSignature(QVBoxLayout* layout) {
        pad_ = new SignaturePad(context_.colors().text, context_.colors().line);
        pad_->setObjectName("signature");
        on_paper_ = new QCheckBox(tr("Signed on paper; the coordinator keeps the sheet"));
        on_paper_->setObjectName("signed_on_paper");
        on_paper_->setMinimumHeight(kTouchTarget);
        QPushButton* clear = make_button(context_, tr("Clear"), "quiet");
        clear->setObjectName("clear_signature");
        connect(on_paper_, &QCheckBox::toggled, this, [this] { showMissing(); });
        connect(clear, &QPushButton::clicked, this, [this] { pad_->clear(); });
        pad_->changed = [this] { showMissing(); };
        layout->addLayout(make_field(tr("Signature"), pad_));
        auto* row = new QHBoxLayout;
        row->addWidget(on_paper_);
        row->addStretch();
        row->addWidget(clear);
        layout->addLayout(row);
    }

    void addAnswers(QVBoxLayout* layout) {
        agree_ = make_button(context_, tr("I consent"), "primary", "check");
        agree_->setObjectName("consent_given");
        agree_->setEnabled(false);
        connect(agree_, &QPushButton::clicked, this, [this] { give(); });
        QPushButton* refuse = make_button(context_, tr("I do not consent"), "secondary", "close");
        refuse->setObjectName("consent_refused");
        connect(refuse, &QPushButton::clicked, this, [this] { answers_.refused(); });
        missing_ = make_label({}, "small");
        missing_->setObjectName("consent_missing");
        showMissing();
        auto* answer = new QHBoxLayout;
        answer->addStretch();
        answer->addWidget(refuse);
        answer->addWidget(agree_);
        layout->addLayout(answer);
        // Below the buttons, which stay where they are when it grows longer.
        missing_->setAlignment(Qt::AlignRight);
        layout->addWidget(missing_);
    }

    void showMissing() {
        if (told_ && answers_.changed) answers_.changed(draft());
        pad_->setEnabled(!on_paper_->isChecked());
        QStringList still;
        const auto unread = std::count_if(boxes_.begin(), boxes_.end(), [](const auto& each) {
            return !each.first->isChecked() && each.second->required;
        });
        if (unread > 0) still << tr("statements to agree to: %1").arg(unread);
        if (!on_paper_->isChecked() && pad_->path().isEmpty())
            still << tr("the signature, or the mark that it was signed on paper");
        agree_->setEnabled(still.isEmpty());
        // It never grows shorter: nothing moves while somebody reaches for a button. Before it is
        // laid out its height is only the one that Qt begins with, half a screen.
        if (missing_->isVisible()) missing_->setMinimumHeight(missing_->height());
        missing_->setText(still.isEmpty()
                              ? tr("Nothing is missing.")
                              : tr("To consent there is still missing: %1.").arg(still.join("; ")));
    }

    void give() {
        std::vector<std::string> agreed;
        for (const auto& [box, statement] : boxes_)
            if (box->isChecked()) agreed.push_back(statement->id);
        answers_.given(agreed, on_paper_->isChecked() ? QString() : pad_->path());
    }

    AppContext& context_;
    ConsentAnswers answers_;
    std::vector<std::pair<QCheckBox*, const curriculum::ConsentStatement*>> boxes_;
    SignaturePad* pad_ = nullptr;
    QCheckBox* on_paper_ = nullptr;
    QPushButton* agree_ = nullptr;
    QLabel* missing_ = nullptr;
    bool told_ = false;  ///< What the page before held is in the form: changes are the hand's.
};

}  // namespace

QWidget* make_consent_form(AppContext& context, const curriculum::Consent& consent,
                           const ConsentAnswers& answers, const QVariantMap& draft) {
    return new ConsentForm(context, consent, answers, draft);
}

}  // namespace placode::ui
