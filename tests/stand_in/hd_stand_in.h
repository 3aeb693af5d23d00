// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Controls of the stand-in for libHD.so, found with dlsym like the vendor's functions. Arms are
// numbered 0 ("Right") and 1 ("Left"). Everything in the vendor's units (mm).

struct FakeHd {
    void (*reset)();             ///< Everything as after loading.
    void (*tick)();              ///< Runs the scheduled callback once, here and now.
    void (*use_thread)(int on);  ///< The scheduler then runs by itself at its rate.
    void (*place)(int arm, double x_mm, double y_mm, double z_mm);
    void (*turn)(int arm, const double transform[16], double roll_rad);
    void (*set_buttons)(int arm, int mask);
    void (*set_inkwell)(int arm, int inside);
    void (*set_joints)(int arm, double a, double b, double c);
    void (*set_heat)(int arm, double heat);
    void (*set_calibration)(int arm, unsigned state);
    void (*push_error)(unsigned code, int arm);  ///< arm -1: no arm of ours.
    void (*fail_next_get)(unsigned code);        ///< The next state read fails with this error.
    void (*plug)(int arm, int in);
    void (*accept_null)(int on);              ///< NULL names the default device.
    void (*force)(int arm, double* newtons);  ///< What the motors of the arm render.
    int (*output_enabled)(int arm);
    int (*calibration_updates)(int arm);
    int (*scheduled)();
    int (*running)();
    int (*open)(int arm);
    unsigned long (*rate)();
    const char* (*violation)();  ///< First breach of the contract, or "".
};

extern "C" const FakeHd* fakehd();
