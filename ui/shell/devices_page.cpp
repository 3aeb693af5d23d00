// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Devices of this computer: what was found, what is missing and how to install it, a device tried
// by itself, foot pedals, and the settings of the station.

#include <QComboBox>
#include <QFile>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLineEdit>

#include "haptics/station.h"
#include "ui/shell/details.h"
#include "ui/shell/device_trial_card.h"
#include "ui/shell/pages.h"
#include "ui/shell/parts.h"

namespace placode::ui {
namespace {

using haptics::Station;

struct SettingName {
    const char *key, *name;
};
/// What people call the settings of the station file.
constexpr SettingName kSettingNames[] = {
    {"arm.mapping", QT_TRANSLATE_NOOP("DevicesPage", "What the arm stands for")},
    {"arm.scale", QT_TRANSLATE_NOOP("DevicesPage", "Scale of the motion")},
    {"arm.one_hand", QT_TRANSLATE_NOOP("DevicesPage", "Hand of a single arm")},
    {"limit.stiffness_n_m", QT_TRANSLATE_NOOP("DevicesPage", "Stiffness at most")},
    {"limit.damping_ns_m", QT_TRANSLATE_NOOP("DevicesPage", "Damping at most")},
    {"limit.force_n", QT_TRANSLATE_NOOP("DevicesPage", "Force at most")},
    {"openhaptics.library", QT_TRANSLATE_NOOP("DevicesPage", "Program library of the vendor")},
    {"openhaptics.right", QT_TRANSLATE_NOOP("DevicesPage", "Right arm")},
    {"openhaptics.left", QT_TRANSLATE_NOOP("DevicesPage", "Left arm")},
    {"haply.host", QT_TRANSLATE_NOOP("DevicesPage", "Computer of the vendor's service")},
    {"haply.port", QT_TRANSLATE_NOOP("DevicesPage", "Its port")},
    {"haply.right", QT_TRANSLATE_NOOP("DevicesPage", "Right arm")},
    {"haply.left", QT_TRANSLATE_NOOP("DevicesPage", "Left arm")},
    {"haply.axes", QT_TRANSLATE_NOOP("DevicesPage", "Directions of the arm")},
    {"haply.force_n", QT_TRANSLATE_NOOP("DevicesPage", "Force that the arm can do")},
    {"avatar.right", QT_TRANSLATE_NOOP("DevicesPage", "Right port device")},
    {"avatar.left", QT_TRANSLATE_NOOP("DevicesPage", "Left port device")},
    {"avatar.ibox", QT_TRANSLATE_NOOP("DevicesPage", "Handle and pedal box")},
    {"avatar.signs", QT_TRANSLATE_NOOP("DevicesPage", "Directions of the axes")},
    {"avatar.depth_zero_m", QT_TRANSLATE_NOOP("DevicesPage", "Depth at the port")},
    {"avatar.settle_s", QT_TRANSLATE_NOOP("DevicesPage", "Wait after opening")},
    {"forcedimension.library", QT_TRANSLATE_NOOP("DevicesPage", "Program library of the vendor")},
    {"forcedimension.swap_hands", QT_TRANSLATE_NOOP("DevicesPage", "Right and left exchanged")},
    {"spacemouse.socket", QT_TRANSLATE_NOOP("DevicesPage", "Connection to its service")},
    {"spacemouse.speed_m_s", QT_TRANSLATE_NOOP("DevicesPage", "Speed at full deflection")},
};

QString setting_name(const QString& key) {
    for (const SettingName& each : kSettingNames)
        if (key == QLatin1String(each.key))
            return QCoreApplication::translate("DevicesPage", each.name);
    return key;
}

class DevicesPage : public Page {
    Q_DECLARE_TR_FUNCTIONS(DevicesPage)
 public:
    DevicesPage(AppContext& context, const Place& place)
        : Page(context),
          lister_(context.launcher().options()),
          pedal_tester_(context.launcher().options()),
          tried_(place.state.value("tried").toString()) {
        if (!context.may(db::Action::kViewAttempts, db::Scope::kOther))
            context.require(db::Action::kBackup, db::Scope::kOther);
        QVBoxLayout* column = make_column(this, 980);
        column->addWidget(make_label(tr("Devices of this computer"), "display"));
        column->addWidget(listCard());
        trial_ = new QVBoxLayout;
        column->addLayout(trial_);
        column->addWidget(pedalCard());
        station_place_ = new QVBoxLayout;
        column->addLayout(station_place_);
        column->addStretch();
        connect(&lister_, &DeviceLister::listed, this, [this](const QString& why) { listed(why); });
        connect(&pedal_tester_, &DeviceTester::stateChanged, this, [this] { pedalMoved(); });
        connect(&pedal_tester_, &DeviceTester::ended, this,
                [this](const QString& why) { pedalsEnded(why); });
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
        fillPedals();
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
        TrialWishes wishes;
        wishes.change = [this](const auto& edit) { return change(edit); };
        wishes.station = [this] { return station(); };
        wishes.notice = [this](const QString& text) { Q_EMIT notice(text); };
        trial_->addWidget(make_trial_card(context_, name, wishes));
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
        clear(station_place_);
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace12);
        layout->addWidget(make_label(tr("Settings of this computer"), "heading"));
        layout->addWidget(make_label(
            tr("They hold for this computer, whoever is signed in. Change one only when a device "
               "does not do what the hand does."),
            "small"));
        const Station now = station();
        const double tested = now.number("tested.force_n");
        QLabel* passed = make_label(
            tested > 0 ? tr("Force test passed with %1 N: %2, %3.")
                             .arg(format_number(tested, 1), device_name(now.text("tested.device")),
                                  qstr(now.text("tested.date")))
                       : tr("No force test was passed on this computer yet."),
            tested > 0 ? "good" : "muted");
        passed->setObjectName("tested");
        layout->addWidget(passed);
        auto* grid = new QGridLayout;
        grid->setHorizontalSpacing(kSpace16);
        grid->setVerticalSpacing(kSpace8);
        edits_.clear();
        for (const haptics::StationKey& key : haptics::station_keys())
            if (wanted(key.key)) addSetting(grid, key, now);
        grid->setColumnStretch(2, 1);
        layout->addLayout(grid);
        QPushButton* save = make_button(context_, tr("Save the settings"), "primary", "check");
        save->setObjectName("save_station");
        connect(save, &QPushButton::clicked, this, [this] { saveSettings(); });
        layout->addWidget(save, 0, Qt::AlignLeft);
        QStringList raw{qstr(Station::path_of_this_computer())};
        for (const auto& [key, field] : edits_) raw << qstr(key + " = " + now.text(key));
        auto* file = new Details(context_, raw.join("\n"));
        file->setObjectName("station_details");
        layout->addWidget(file);
        station_place_->addWidget(make_card(layout));
    }

    /// Arms and limits always, the keys of a device while it is tried.
    [[nodiscard]] bool wanted(std::string_view key) const {
        if (key.starts_with("arm.") || key.starts_with("limit.")) return true;
        return !tried_.isEmpty() && key.starts_with(tried_.toStdString() + ".");
    }

    void addSetting(QGridLayout* grid, const haptics::StationKey& key, const Station& now) {
        const int row = grid->rowCount();
        const QString name = qstr(std::string(key.key)), words = setting_name(name);
        QLabel* label = make_label(words);
        label->setWordWrap(false);
        auto* field = new QLineEdit(qstr(now.text(key.key)));
        field->setObjectName("key_" + name);
        field->setAccessibleName(words);
        field->setMinimumWidth(170);
        label->setBuddy(field);
        grid->addWidget(label, row, 0);
        grid->addWidget(field, row, 1);
        QString meaning = QCoreApplication::translate("Station", std::string(key.meaning).c_str());
        if (key.low < key.high)
            meaning +=
                tr(" (%1 to %2)").arg(QLocale().toString(key.low), QLocale().toString(key.high));
        grid->addWidget(make_label(meaning, "small"), row, 2);
        edits_.emplace_back(std::string(key.key), field);
    }

    void saveSettings() {
        std::vector<std::pair<std::string, std::string>> said;
        const Station now = station();
        for (const auto& [key, field] : edits_)
            if (const std::string text = field->text().trimmed().toStdString();
                text != now.text(key))
                said.emplace_back(key, text);
        const bool done = change([&](Station& edited) {
            for (const auto& [key, text] : said) edited.set(key, text);
        });
        if (!done) return;
        Q_EMIT notice(tr("Saved for this computer."));
        // A device that is open knows the old settings.
        if (!tried_.isEmpty() && trial_->count() > 0) tryDevice(tried_);
    }

    // --- foot pedals
    QWidget* pedalCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace12);
        layout->addWidget(make_label(tr("Foot pedals"), "heading"));
        layout->addWidget(make_label(
            tr("Choose the pedals, press each and say which one it is: yellow cuts, blue "
               "coagulates. Pedals that a device brings itself need nothing here."),
            "muted"));
        pedals_ = new QComboBox;
        pedals_->setObjectName("pedals");
        pedals_->setEditable(true);
        layout->addLayout(make_field(tr("Which pedals"), pedals_));
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace12);
        QPushButton* watch = make_button(context_, tr("Watch"), "secondary", "play");
        watch->setObjectName("watch_pedals");
        connect(watch, &QPushButton::clicked, this, [this] { watchPedals(); });
        cut_ = make_button(context_, tr("This is the yellow one"), "secondary");
        cut_->setObjectName("pedal_cut");
        coag_ = make_button(context_, tr("This is the blue one"), "secondary");
        coag_->setObjectName("pedal_coag");
        connect(cut_, &QPushButton::clicked, this, [this] { keepPedal("pedals.cut_key"); });
        connect(coag_, &QPushButton::clicked, this, [this] { keepPedal("pedals.coag_key"); });
        for (QPushButton* button : {watch, cut_, coag_}) row->addWidget(button);
        row->addStretch();
        layout->addLayout(row);
        pedal_key_ = make_label({});
        pedal_key_->setObjectName("pedal_key");
        layout->addWidget(pedal_key_);
        pedal_details_ = new Details(context_);
        layout->addWidget(pedal_details_);
        cut_->setEnabled(false);
        coag_->setEnabled(false);
        return make_card(layout);
    }

    void fillPedals() {
        const QString now = qstr(station().text("pedals.device"));
        const QString typed = pedals_->currentText();
        pedals_->clear();
        pedals_->addItems(lister_.pedals());
        if (!now.isEmpty() && pedals_->findText(now) < 0) pedals_->addItem(now);
        pedals_->setCurrentText(typed.isEmpty() ? now : typed);
        if (pedals_->currentText().isEmpty() && pedals_->count() == 0)
            pedal_key_->setText(tr("No pedals were found."));
    }

    void watchPedals() {
        const QString path = pedals_->currentText().trimmed();
        if (path.isEmpty()) return;
        pedal_key_->setText(tr("Press a pedal…"));
        pedal_details_->setText({});
        context_.guard(tr("Watching the pedals"),
                       [&] { pedal_tester_.start("pedals:" + path, 0.5); });
    }

    void pedalsEnded(const QString& why) {
        pedal_details_->setText(why);
        pedal_key_->setText(why.isEmpty() ? QString() : device_problem("pedals", why).way_out);
    }

    void pedalMoved() {
        const TrialState& state = pedal_tester_.state();
        if (!state.connected) return pedal_key_->setText(tr("The pedals are unplugged."));
        cut_->setEnabled(state.key > 0);
        coag_->setEnabled(state.key > 0);
        if (state.key == 0) return;
        const Station now = station();
        QString name = tr("Key %1").arg(state.key);
        if (state.key == static_cast<int>(now.number("pedals.cut_key")))
            name += tr(", set as the yellow pedal");
        if (state.key == static_cast<int>(now.number("pedals.coag_key")))
            name += tr(", set as the blue pedal");
        pedal_key_->setText(state.pressed ? tr("%1 (pressed)").arg(name) : name);
    }

    void keepPedal(const char* key) {
        const int code = pedal_tester_.state().key;
        const std::string path = pedals_->currentText().trimmed().toStdString();
        if (change([&](Station& edited) {
                // One key cannot be both: the other pedal gets the key that this one had.
                const std::string other =
                    std::string(key) == "pedals.cut_key" ? "pedals.coag_key" : "pedals.cut_key";
                if (static_cast<int>(edited.number(other)) == code)
                    edited.set(other, edited.text(key));
                edited.set(key, std::to_string(code));
                edited.set("pedals.device", path);
            }))
            Q_EMIT notice(tr("The pedal was saved for this computer."));
        pedalMoved();
    }

    DeviceLister lister_;
    DeviceTester pedal_tester_;
    QString tried_;
    std::vector<std::pair<std::string, QLineEdit*>> edits_;
    QPushButton *again_ = nullptr, *cut_ = nullptr, *coag_ = nullptr;
    QLabel *listing_ = nullptr, *pedal_key_ = nullptr;
    QVBoxLayout *rows_ = nullptr, *trial_ = nullptr, *station_place_ = nullptr;
    Details *listing_details_ = nullptr, *pedal_details_ = nullptr;
    QComboBox* pedals_ = nullptr;
};

}  // namespace

Page* make_devices_page(AppContext& context, const Place& place) {
    return new DevicesPage(context, place);
}

}  // namespace placode::ui
