// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Foot pedals of this computer: which they are, and which key is which pedal.

#include <QCoreApplication>
#include <QStringList>
#include <QWidget>

#include "ui/shell/device_tester.h"
#include "ui/shell/station_wishes.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace placode::ui {

class AppContext;
class Details;

class PedalCard : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(DevicesPage)
 public:
    PedalCard(AppContext& context, StationWishes wishes);

    /// Offers what was found beside what is set.
    void fill(const QStringList& found);

 private:
    void watch();
    void ended(const QString& why);
    void moved();
    void keep(const char* key);

    AppContext& context_;
    StationWishes wishes_;
    DeviceTester tester_;
    QComboBox* pedals_ = nullptr;
    QPushButton *cut_ = nullptr, *coag_ = nullptr;
    QLabel* key_ = nullptr;
    Details* details_ = nullptr;
};

}  // namespace placode::ui
