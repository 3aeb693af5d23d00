// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// First start of a station for several people: creates the administrator and, if wanted, one
// demonstration account a role.

#include <QCheckBox>
#include <QTimer>

#include "db/demonstration.h"
#include "ui/shell/account_fields.h"
#include "ui/shell/pages.h"
#include "ui/shell/parts.h"
#include "ui/shell/setup_ways.h"

namespace placode::ui {
namespace {

class SetupPage : public Page {
    Q_DECLARE_TR_FUNCTIONS(SetupPage)
 public:
    SetupPage(AppContext& context, const Place& place) : Page(context) {
        QVBoxLayout* column = make_column(this, 620);
        column->addStretch(1);
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace16);
        layout->addWidget(make_label(tr("The first account"), "display"));
        layout->addWidget(make_label(tr("The administrator adds people, keeps backups and reads "
                                        "the audit list."),
                                     "muted"));
        addFields(layout, place);
        message_ = make_hint("critical");
        message_->setObjectName("setup_message");
        layout->addWidget(message_);
        QPushButton* create =
            make_button(context_, tr("Create the administrator"), "primary", "check");
        create->setObjectName("create_administrator");
        create->setProperty("scale", "large");
        connect(create, &QPushButton::clicked, this, [this] { this->create(); });
        hide_when_edited(message_, {fields_.name, fields_.login, fields_.password, fields_.again});
        enter_submits(
            {fields_.name, fields_.login, fields_.password, fields_.again, trains_, demonstration_},
            this, [this] { this->create(); });
        layout->addWidget(create);
        // A server has no other way in.
        if (context_.storeIsFile()) layout->addWidget(make_way_back(context_, this));
        QFrame* card = make_card(layout);
        layout->setContentsMargins(kSpace32, kSpace32, kSpace32, kSpace32);
        column->addWidget(card);
        column->addStretch(2);
        QTimer::singleShot(0, this, [this] { fields_.name->setFocus(Qt::OtherFocusReason); });
    }

    [[nodiscard]] QString title() const override { return tr("First start"); }
    [[nodiscard]] QVariantMap state() const override {
        QVariantMap state = fields_.state();
        state["way"] = kStationWay;
        return state;
    }

 private:
    void addFields(QVBoxLayout* layout, const Place& place) {
        fields_.addTo(layout, place.state, {"display_name", "login", "password", "password_again"});
        trains_ = new QCheckBox(tr("I also train here (trainee)"));
        trains_->setObjectName("also_trainee");
        demonstration_ = new QCheckBox(tr("Add demonstration accounts to look around"));
        demonstration_->setObjectName("add_demonstration");
        layout->addWidget(trains_);
        layout->addWidget(demonstration_);
        layout->addWidget(
            make_label(tr("demo.trainee, demo.educator, demo.coordinator, each with the password "
                          "\"%1\"; their data is marked as demonstration everywhere.")
                           .arg(db::kDemonstrationPassword),
                       "small"));
    }

    void create() {
        message_->hide();
        if (const FormProblem problem = fields_.problem()) return say(problem);
        db::NewUser user = fields_.user();
        user.roles = static_cast<db::Roles>(db::Role::kAdministrator);
        if (trains_->isChecked()) user.roles |= static_cast<db::Roles>(db::Role::kTrainee);
        context_.guard(tr("Creating the administrator"), [&] {
            context_.store().accounts().create(user);
            if (demonstration_->isChecked()) {
                // Accounts are an administrator's matter: the new one's.
                (void)context_.store().accounts().sign_in(user.login, user.password);
                addDemonstrationAccounts();
                context_.store().sign_out();
            }
            context_.setStoreSetting("last_login", QString::fromStdString(user.login));
            Q_EMIT notice(tr("The administrator was created. Sign in to add people."));
            Q_EMIT go({PageId::kLogin, 0, {}, {}});
        });
    }

    void addDemonstrationAccounts() {
        const std::tuple<const char*, QString, db::Role> people[] = {
            {"demo.trainee", tr("Demonstration trainee"), db::Role::kTrainee},
            {"demo.educator", tr("Demonstration educator"), db::Role::kEducator},
            {"demo.coordinator", tr("Demonstration coordinator"), db::Role::kCoordinator}};
        for (const auto& [login, name, role] : people) {
            db::NewUser user;
            user.login = login;
            user.display_name = name.toStdString();
            user.password = db::kDemonstrationPassword;
            user.roles = static_cast<db::Roles>(role);
            user.demonstration = true;
            context_.store().accounts().create(user);
        }
    }

    void say(const FormProblem& problem) {
        message_->setText(problem.text);
        message_->show();
        go_to_field(problem.field);
    }

    AccountFields fields_;
    QCheckBox *trains_ = nullptr, *demonstration_ = nullptr;
    QLabel* message_ = nullptr;
};

}  // namespace

Page* make_station_setup_page(AppContext& context, const Place& place) {
    return new SetupPage(context, place);
}

}  // namespace placode::ui
