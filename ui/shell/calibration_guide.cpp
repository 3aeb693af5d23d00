// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>
#include <QStringList>

#include "ui/shell/device_trial_card.h"

namespace placode::ui {
namespace {

struct Guide {
    Q_DECLARE_TR_FUNCTIONS(CalibrationGuide)
};

}  // namespace

QStringList calibration_steps(const QString& device) {
    if (device == "openhaptics")
        return {Guide::tr("1. Calibrate the arm in the vendor's own program (Touch Diagnostic)."),
                Guide::tr("2. Put the stylus into the inkwell until its light stops blinking."),
                Guide::tr("3. Take it out: from now on the arm is ready.")};
    if (device == "haply")
        return {Guide::tr("1. Start the Haply hub and its Inverse service."),
                Guide::tr("2. Hold the cursor in the calibration notch and press its button until "
                          "the light is steady."),
                Guide::tr("3. Wake the grip by a press of its button.")};
    if (device == "forcedimension")
        return {Guide::tr("1. Calibrate in the vendor's program HapticInit, or move every axis to "
                          "its ends once."),
                Guide::tr("2. Press the force button on the base, if it has one.")};
    if (device == "avatar")
        return {Guide::tr("1. Put the instrument into the port device before it is switched on."),
                Guide::tr("2. Turn and move it once through its whole way."),
                Guide::tr("3. With the tip at the port, the depth must read 0; else set "
                          "avatar.depth_zero_m.")};
    if (device == "spacemouse")
        return {Guide::tr("Let go of the cap: every signal must be 0. The cap gives no force.")};
    return {};
}

}  // namespace placode::ui
