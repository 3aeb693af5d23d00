// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Devices of this computer: what was found, what is missing and how to install it, a device tried
// by itself, foot pedals, and the settings of the station.

#include <QFile>
#include <QHBoxLayout>

#include "haptics/station.h"
#include "ui/shell/details.h"
#include "ui/shell/device_trial_card.h"
#include "ui/shell/pages.h"
#include "ui/shell/parts.h"
#include "ui/shell/pedal_card.h"
#include "ui/shell/station_card.h"

namespace placode::ui {
namespace {

using haptics::Station;

class DevicesPage : public Page {
    Q_DECLARE_TR_FUNCTIONS(DevicesPage)
 public:
    DevicesPage(AppContext& context, const Place& place)
        : Page(context),
          lister_(context.launcher().options()),
          tried_(place.state.value("tried").toString()) {
        if (!context.may(db::Action::kViewAttempts, db::Scope::kOther))
            context.require(db::Action::kBackup, db::Scope::kOther);
        QVBoxLayout* column = make_column(this, 980);
        column->addWidget(make_label(tr("Devices of this computer"), "display"));
        column->addWidget(listCard());
        trial_ = new QVBoxLayout;
        column->addLayout(trial_);
        pedals_ = new PedalCard(context, wishes());
        column->addWidget(pedals_);
        station_place_ = new QVBoxLayout;
        column->addLayout(station_place_);
        column->addStretch();
        connect(&lister_, &DeviceLister::listed, this, [this](const QString& why) { listed(why); });
        showStation();
        // Rebuilt in another language or theme: what was found is still there.
        const QByteArray before = place.state.value("listing").toByteArray();
        if (before.isEmpty())
            look();
        else
            lister_.take(before);
    }

    [[nodiscard]] QString title() const override { return tr("Devices"); }
    [[nodiscard]] QVariantMap state() const override {
        return {{"tried", tried_}, {"listing", lister_.text()}};
    }

 private:
    // --- what is there
    QWidget* listCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace12);
        auto* head = new QHBoxLayout;
        head->addWidget(make_label(tr("What was found"), "heading"));
        head->addStretch();
        again_ = make_button(context_, tr("Look again"), "secondary", "again");
        again_->setObjectName("look_again");
        connect(again_, &QPushButton::clicked, this, [this] { look(); });
        head->addWidget(again_);
        layout->addLayout(head);
        listing_ = make_label({}, "muted");
        listing_->setObjectName("listing");
        layout->addWidget(listing_);
        listing_details_ = new Details(context_);
        layout->addWidget(listing_details_);
        rows_ = new QVBoxLayout;
        rows_->setSpacing(kSpace8);
        layout->addLayout(rows_);
        return make_card(layout);
    }

    void look() {
        endTrial();  // looking opens every device
        again_->setEnabled(false);
        listing_->setText(tr("Looking for devices; this may take some seconds…"));
        listing_->show();
        listing_details_->setText({});
        if (!context_.guard(tr("Looking for devices"), [this] { lister_.start(); }))
            again_->setEnabled(true);
    }

    static void clear(QLayout* layout) {
        while (QLayoutItem* item = layout->takeAt(0)) {
            if (item->widget() != nullptr) item->widget()->deleteLater();
            if (item->layout() != nullptr) clear(item->layout());
            delete item;
        }
    }

    void listed(const QString& why) {
        again_->setEnabled(true);
        listing_->setVisible(!why.isEmpty());
        listing_->setText(tr("The list of devices could not be read."));
        listing_details_->setText(why);
        if (!why.isEmpty()) return;
        clear(rows_);
        for (const ListedDevice& device : lister_.devices())
            if (!device.name.startsWith("script")) rows_->addWidget(deviceRow(device));
        pedals_->fill(lister_.pedals());
        if (!tried_.isEmpty() && trial_->count() == 0) tryDevice(tried_);
    }

    QWidget* deviceRow(const ListedDevice& device) {
        auto* box = new QWidget;
        box->setObjectName("device_" + device.name);
        auto* line = new QHBoxLayout(box);
        line->setContentsMargins(0, 0, 0, 0);
        line->setSpacing(kSpace12);
        QLabel* badge = make_badge(device.available ? tr("found") : tr("not found"),
                                   device.available ? "good" : "");
        badge->setMinimumWidth(80);
        badge->setAlignment(Qt::AlignCenter);
        line->addWidget(badge, 0, Qt::AlignTop);
        auto* words = new QVBoxLayout;
        words->setSpacing(0);
        words->addWidget(make_label(device_name(device.name.toStdString())));
        QLabel* detail = make_label({}, "small");
        detail->setObjectName("detail_" + device.name);
        words->addWidget(detail);
        if (!device.found.isEmpty()) {
            detail->setText(device.found.join(", "));
        } else if (device.available) {
            detail->setText(
                QCoreApplication::translate("Device", device.detail.toUtf8().constData()));
        } else {
            const Problem problem = device_problem(device.name, device.detail);
            detail->setText(problem.way_out);
            auto* details = new Details(context_, problem.detail);
            details->setObjectName("details_" + device.name);
            words->addWidget(details);
        }
        line->addLayout(words, 1);
        const bool in_window = device.name == "gamepad";
        if (device.available && !device.found.isEmpty() && !in_window) {
            QPushButton* start = make_button(context_, tr("Try it"), "secondary", "play");
            start->setObjectName("try_" + device.name);
            connect(start, &QPushButton::clicked, this,
                    [this, name = device.name] { tryDevice(name); });
            line->addWidget(start, 0, Qt::AlignTop);
        }
        return box;
    }

    // --- one device
    // At once: two programs cannot hold one device.
    void endTrial() {
        while (QLayoutItem* item = trial_->takeAt(0)) {
            delete item->widget();
            delete item;
        }
        tried_.clear();
    }

    void tryDevice(QString name) {
        endTrial();
        tried_ = name;
        trial_->addWidget(make_trial_card(context_, name, wishes()));
        showStation();
    }

    // --- the station file
    [[nodiscard]] Station station() {
        Station read;
        context_.guard(tr("Reading the station file"), [&] { read = Station::of_this_computer(); });
        return read;
    }

    bool change(const std::function<void(Station&)>& edit) {
        const bool done = context_.guard(tr("Saving the station file"), [&] {
            const std::string path = Station::path_of_this_computer();
            Station now;
            if (QFile::exists(qstr(path))) now = Station::of_this_computer();
            edit(now);
            now.save(path);
            context_.audit("station.save", qstr(path));
        });
        if (done) showStation();
        return done;
    }

    void showStation() {
        UnsavedSettings unsaved;
        if (station_place_->count() > 0)
            unsaved = unsaved_settings(*station_place_->itemAt(0)->widget());
        clear(station_place_);
        station_place_->addWidget(
            make_station_card(context_, tried_, unsaved, wishes(), [this] { stationSaved(); }));
    }

    void stationSaved() {
        Q_EMIT notice(tr("Saved for this computer."));
        // A device that is open knows the old settings.
        if (!tried_.isEmpty() && trial_->count() > 0) tryDevice(tried_);
    }

    [[nodiscard]] StationWishes wishes() {
        return {[this](const auto& edit) { return change(edit); }, [this] { return station(); },
                [this](const QString& text) { Q_EMIT notice(text); }};
    }

    DeviceLister lister_;
    QString tried_;
    QPushButton* again_ = nullptr;
    QLabel* listing_ = nullptr;
    QVBoxLayout *rows_ = nullptr, *trial_ = nullptr, *station_place_ = nullptr;
    Details* listing_details_ = nullptr;
    PedalCard* pedals_ = nullptr;
};

}  // namespace

Page* make_devices_page(AppContext& context, const Place& place) {
    return new DevicesPage(context, place);
}

}  // namespace placode::ui
