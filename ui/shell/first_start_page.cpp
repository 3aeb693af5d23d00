// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// First start: nobody has an account yet. Asks how this computer will be used; who is alone is in
// the first exercise with one click.

#include <QTimer>

#include "ui/shell/parts.h"
#include "ui/shell/setup_ways.h"
#include "ui/shell/training.h"

namespace placode::ui {
namespace {

class FirstStartPage : public Page {
    Q_DECLARE_TR_FUNCTIONS(FirstStartPage)
 public:
    explicit FirstStartPage(AppContext& context) : Page(context) {
        QVBoxLayout* column = make_column(this, 620);
        column->addStretch(1);
        column->addWidget(make_label(tr("Welcome to Placode"), "display"));
        column->addWidget(make_label(tr("How will this computer be used?"), "muted"));
        QPushButton* alone =
            addWay(column, tr("By me alone"),
                   tr("No account, no password. You can make an account of it later, and what you "
                      "have done stays yours."),
                   make_button(context_, tr("Begin the first exercise"), "primary", "play"));
        alone->setObjectName("way_alone");
        connect(alone, &QPushButton::clicked, this, [this] { beginAlone(); });
        QPushButton* station =
            addWay(column, tr("By several people"),
                   tr("Everybody signs in and sees their own attempts. You make the first account, "
                      "the administrator's, and add the others."),
                   make_button(context_, tr("Set up the station"), "secondary", "account"));
        station->setObjectName("way_station");
        connect(station, &QPushButton::clicked, this,
                [this] { Q_EMIT go(setup_place(kStationWay)); });
        QPushButton* server =
            addWay(column, tr("As one station of a centre"),
                   tr("People find their attempts at every station of the centre. You need the "
                      "address that whoever keeps the server gave you."),
                   make_button(context_, tr("Connect to the server"), "secondary", "next"));
        server->setObjectName("way_server");
        connect(server, &QPushButton::clicked, this,
                [this] { Q_EMIT go(setup_place(kServerWay)); });
        column->addStretch(2);
        QTimer::singleShot(0, this, [alone] { alone->setFocus(Qt::OtherFocusReason); });
    }

    [[nodiscard]] QString title() const override { return tr("First start"); }

 private:
    QPushButton* addWay(QVBoxLayout* column, const QString& name, const QString& what,
                        QPushButton* button) {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace12);
        layout->addWidget(make_label(name, "title"));
        layout->addWidget(make_label(what, "muted"));
        button->setAccessibleDescription(name + ". " + what);
        layout->addWidget(button, 0, Qt::AlignLeft);
        column->addWidget(make_card(layout));
        return button;
    }

    void beginAlone() {
        context_.guard(tr("Beginning"), [&] {
            context_.store().accounts().begin_alone(tr("Guest").toStdString());
            context_.signIn(context_.store().accounts().enter().user.value());
            const Training training = load_training(context_);
            if (training.next_stage < 0) return;  // Then the page Today says what there is.
            const TrainingStage& first = training.stages[static_cast<size_t>(training.next_stage)];
            Q_EMIT go(
                {PageId::kTask, 0, qstr(first.task_id), task_state(training.course, first.rule)});
        });
    }
};

}  // namespace

QPushButton* make_way_back(AppContext& context, Page* page) {
    QPushButton* back = make_button(context, FirstStartPage::tr("Another way to begin"), "quiet");
    back->setObjectName("way_back");
    QObject::connect(back, &QPushButton::clicked, page, [page] {
        Q_EMIT page->go({PageId::kSetup, 0, {}, {}});
    });
    return back;
}

Page* make_setup_page(AppContext& context, const Place& place) {
    const QString way = place.state.value("way").toString();
    if (way == kServerWay) return make_server_setup_page(context, place);
    // On a server everybody has an account.
    if (way == kStationWay || !context.storeIsFile())
        return make_station_setup_page(context, place);
    return new FirstStartPage(context);
}

}  // namespace placode::ui
