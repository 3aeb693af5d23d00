// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/safety.h"

namespace placode::haptics {

namespace {

constexpr double kMovingSpeedMS = 0.001;
constexpr double kOfDeviceForce = 0.91;  // 3.0 N of the 3.3 N of a Touch.

}  // namespace

CouplingSettings limited_to(CouplingSettings settings, const DeviceInfo& device,
                            double scale) noexcept {
    const double felt = scale * scale > 0 ? scale * scale : 1;
    const auto lower = [](double& value, double limit) {
        if (limit > 0) value = std::min(value, limit);
    };
    lower(settings.max_force_n, kOfDeviceForce * device.max_force_n);
    lower(settings.continuous_force_n, device.continuous_force_n);
    lower(settings.stiffness_n_m, device.max_stiffness_n_m / felt);
    lower(settings.damping_ns_m, device.max_damping_ns_m / felt);
    settings.thermal_floor_n = std::min(settings.thermal_floor_n, settings.max_force_n);
    return settings;
}

CouplingSettings station_limits(const Station& station) {
    CouplingSettings settings;
    settings.stiffness_n_m = station.number("limit.stiffness_n_m");
    settings.damping_ns_m = station.number("limit.damping_ns_m");
    settings.max_force_n = station.number("limit.force_n");
    settings.thermal_floor_n = std::min(settings.thermal_floor_n, settings.max_force_n);
    return settings;
}

Vec3 PassivityController::correct(const Vec3& force_n, const Vec3& velocity_m_s, double dt_s,
                                  bool& acted) noexcept {
    const double v2 = velocity_m_s.squaredNorm();
    acted = energy_j_ < -dead_j_ && dt_s > 0 && v2 >= kMovingSpeedMS * kMovingSpeedMS &&
            max_damping_ > 0;
    if (!acted) return force_n;
    return force_n - std::min((-energy_j_ - dead_j_) / (dt_s * v2), max_damping_) * velocity_m_s;
}

double ThermalBudget::ceiling_n(double motor_heat) const noexcept {
    // Not a number counts as hot.
    if (!(motor_heat <= settings_.motor_heat_limit)) return settings_.thermal_floor_n;
    const double over = rms_n() / settings_.continuous_force_n;
    const double hot = std::clamp((over - 1) / 0.5, 0.0, 1.0);
    return settings_.max_force_n + hot * (settings_.thermal_floor_n - settings_.max_force_n);
}

Vec3 ForceLimiter::apply(Vec3 force_n, double ceiling_n, double slew_n_s, double dt_s,
                         bool& saturated, bool& slewed) noexcept {
    const double size = force_n.norm();
    saturated = size > ceiling_n;
    if (saturated) force_n *= ceiling_n / size;
    const double step = slew_n_s * std::max(0.0, dt_s);
    const Vec3 change = force_n - last_;
    const double path = change.norm();
    slewed = path > step;
    if (slewed) force_n = last_ + change * (step / path);
    last_ = force_n;
    return force_n;
}

}  // namespace placode::haptics
