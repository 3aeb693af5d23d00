// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/station_card.h"

#include <QCoreApplication>
#include <QGridLayout>
#include <QLineEdit>
#include <string_view>

#include "ui/shell/details.h"
#include "ui/shell/parts.h"
#include "ui/shell/typed_texts.h"

namespace placode::ui {
namespace {

using haptics::Station;
using Edits = std::vector<std::pair<std::string, QLineEdit*>>;

struct StationWords {
    Q_DECLARE_TR_FUNCTIONS(DevicesPage)
};

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

/// Arms and limits always, the keys of a device while it is tried; what is typed and not saved
/// stays besides.
bool wanted(std::string_view key, const QString& tried) {
    if (key.starts_with("arm.") || key.starts_with("limit.")) return true;
    return !tried.isEmpty() && key.starts_with(tried.toStdString() + ".");
}

constexpr QLatin1String kKeyPrefix("key_");       // names of fields
constexpr const char* kOfStation = "of_station";  // what the station file says

/// What somebody has typed for a setting; null: nothing, or it was changed elsewhere meanwhile, as
/// by the force test.
const UnsavedSetting* typed_for(const UnsavedSettings& unsaved, std::string_view key,
                                const Station& now) {
    const auto found = unsaved.find(std::string(key));
    return found != unsaved.end() && found->second.of_station == qstr(now.text(key))
               ? &found->second
               : nullptr;
}

QLineEdit* add_setting(QGridLayout* grid, const haptics::StationKey& key, const Station& now,
                       const UnsavedSetting* typed) {
    const int row = grid->rowCount();
    const QString name = qstr(std::string(key.key)), words = setting_name(name);
    QLabel* label = make_label(words);
    label->setWordWrap(false);
    auto* field = new QLineEdit(qstr(now.text(key.key)));
    field->setObjectName(kKeyPrefix + name);
    field->setProperty(kOfStation, field->text());
    if (typed != nullptr) {
        field->setText(typed->typed);
        field->setModified(true);  // kept in another language, too
    }
    keep_choice(field);
    field->setAccessibleName(words);
    field->setMinimumWidth(170);
    label->setBuddy(field);
    grid->addWidget(label, row, 0);
    grid->addWidget(field, row, 1);
    QString meaning = QCoreApplication::translate("Station", std::string(key.meaning).c_str());
    if (key.low < key.high)
        meaning += StationWords::tr(" (%1 to %2)")
                       .arg(QLocale().toString(key.low), QLocale().toString(key.high));
    grid->addWidget(make_label(meaning, "small"), row, 2);
    return field;
}

bool save_settings(const StationWishes& wishes, const Edits& edits) {
    std::vector<std::pair<std::string, std::string>> said;
    const Station now = wishes.station();
    for (const auto& [key, field] : edits)
        if (const std::string text = field->text().trimmed().toStdString(); text != now.text(key))
            said.emplace_back(key, text);
    return wishes.change([&](Station& edited) {
        for (const auto& [key, text] : said) edited.set(key, text);
    });
}

}  // namespace

UnsavedSettings unsaved_settings(const QWidget& card) {
    UnsavedSettings unsaved;
    for (const auto* field : card.findChildren<QLineEdit*>()) {
        const QString before = field->property(kOfStation).toString(), name = field->objectName();
        if (name.startsWith(kKeyPrefix) && field->text() != before)
            unsaved.insert_or_assign(name.mid(kKeyPrefix.size()).toStdString(),
                                     UnsavedSetting{before, field->text()});
    }
    return unsaved;
}

QFrame* make_station_card(AppContext& context, const QString& tried, const UnsavedSettings& unsaved,
                          const StationWishes& wishes, const std::function<void()>& saved) {
    auto* layout = new QVBoxLayout;
    layout->setSpacing(kSpace12);
    layout->addWidget(make_label(StationWords::tr("Settings of this computer"), "heading"));
    layout->addWidget(make_label(
        StationWords::tr(
            "They hold for this computer, whoever is signed in. Change one only when a device "
            "does not do what the hand does."),
        "small"));
    const Station now = wishes.station();
    const double tested = now.number("tested.force_n");
    QLabel* passed = make_label(
        tested > 0 ? StationWords::tr("Force test passed with %1 N: %2, %3.")
                         .arg(format_number(tested, 1), device_name(now.text("tested.device")),
                              qstr(now.text("tested.date")))
                   : StationWords::tr("No force test was passed on this computer yet."),
        tested > 0 ? "good" : "muted");
    passed->setObjectName("tested");
    layout->addWidget(passed);
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(kSpace16);
    grid->setVerticalSpacing(kSpace8);
    Edits edits;
    for (const haptics::StationKey& key : haptics::station_keys()) {
        const UnsavedSetting* typed = typed_for(unsaved, key.key, now);
        if (typed != nullptr || wanted(key.key, tried))
            edits.emplace_back(std::string(key.key), add_setting(grid, key, now, typed));
    }
    grid->setColumnStretch(2, 1);
    layout->addLayout(grid);
    QPushButton* save =
        make_button(context, StationWords::tr("Save the settings"), "primary", "check");
    save->setObjectName("save_station");
    QObject::connect(save, &QPushButton::clicked, save, [wishes, edits, saved] {
        if (save_settings(wishes, edits)) saved();
    });
    layout->addWidget(save, 0, Qt::AlignLeft);
    QStringList raw{qstr(Station::path_of_this_computer())};
    for (const auto& [key, field] : edits) raw << qstr(key + " = " + now.text(key));
    auto* file = new Details(context, raw.join("\n"));
    file->setObjectName("station_details");
    layout->addWidget(file);
    return make_card(layout);
}

}  // namespace placode::ui
