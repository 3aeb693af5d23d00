// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// First start as one station of a centre: the address of its server.

#include <QLineEdit>
#include <QTimer>
#include <QUrl>

#include "ui/shell/form_keys.h"
#include "ui/shell/parts.h"
#include "ui/shell/setup_ways.h"
#include "ui/shell/store_address.h"

namespace placode::ui {
namespace {

class ServerSetupPage : public Page {
    Q_DECLARE_TR_FUNCTIONS(ServerSetupPage)
 public:
    ServerSetupPage(AppContext& context, const Place& place) : Page(context) {
        QVBoxLayout* column = make_column(this, 620);
        column->addStretch(1);
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace16);
        layout->addWidget(make_label(tr("The centre's server"), "display"));
        layout->addWidget(
            make_label(tr("Type the address of this station. The password is no part of it: "
                          "it is asked for, or read from ~/.pgpass."),
                       "muted"));
        address_ = new QLineEdit(place.state.value("address").toString());
        address_->setObjectName("server_address");
        address_->setPlaceholderText("postgresql://theatre_1@db.example.org:5432/placode");
        layout->addLayout(make_field(tr("Address"), address_));
        message_ = make_hint("critical");
        message_->setObjectName("setup_message");
        layout->addWidget(message_);
        QPushButton* connect_it = make_button(context_, tr("Connect"), "primary", "next");
        connect_it->setObjectName("connect_server");
        connect_it->setProperty("scale", "large");
        connect(connect_it, &QPushButton::clicked, this, [this] { connectServer(); });
        hide_when_edited(message_, {address_});
        enter_submits({address_}, this, [this] { connectServer(); });
        layout->addWidget(connect_it);
        layout->addWidget(make_way_back(context_, this));
        QFrame* card = make_card(layout);
        layout->setContentsMargins(kSpace32, kSpace32, kSpace32, kSpace32);
        column->addWidget(card);
        column->addStretch(2);
        QTimer::singleShot(0, this, [this] { address_->setFocus(Qt::OtherFocusReason); });
    }

    [[nodiscard]] QString title() const override { return tr("First start"); }
    [[nodiscard]] QVariantMap state() const override {
        return {{"way", kServerWay}, {"address", address_->text()}};
    }

 private:
    [[nodiscard]] QString problem() const {
        const QString typed = address_->text().trimmed();
        if (typed.isEmpty()) return tr("Type the server's address.");
        if (!typed.startsWith("postgresql://") || !QUrl(typed.section('?', 0, 0)).isValid())
            return tr("Found \"%1\". An address begins with postgresql:// and names the server and "
                      "the database.")
                .arg(has_password(typed) ? QString("…") : typed);
        if (has_password(typed))
            return tr(
                "Leave the password out: whoever opens the settings could read it. Placode "
                "asks for it.");
        return {};
    }

    void connectServer() {
        message_->hide();
        if (const QString wrong = problem(); !wrong.isEmpty()) {
            message_->setText(wrong);
            message_->show();
            return go_to_field(address_);
        }
        if (!context_.chooseServer(address_->text().trimmed())) return go_to_field(address_);
        context_.guard(tr("Reading the accounts"), [&] {
            const bool first = !context_.store().accounts().any();
            Q_EMIT go({first ? PageId::kSetup : PageId::kLogin, 0, {}, {}});
        });
    }

    QLineEdit* address_ = nullptr;
    QLabel* message_ = nullptr;
};

}  // namespace

Page* make_server_setup_page(AppContext& context, const Place& place) {
    return new ServerSetupPage(context, place);
}

}  // namespace placode::ui
