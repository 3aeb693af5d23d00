// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Tissue classes of the operative field and their material data.
// Values come from the scene's JSON; the defaults here are only those of a neutral soft solid.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace placode::sim {

/// Label of a tetrahedron, and index into `Scene::materials`.
enum class Tissue : uint8_t {
    kSkin = 0,
    kThinSkin,
    kSubcutis,
    kMuscle,
    kZone,     ///< Zona epitheliosa / junctional zone: the ring that is incised.
    kPlacode,  ///< Neural tissue. Must not be touched, burned or cut.
    kGel,      ///< Soft filler that stands for roots and CSF.
    kDura,
};
inline constexpr int kTissueCount = 8;

/// Name as in the scene's JSON ("skin", "thin_skin", "subcutis", "muscle", "zone", "placode",
/// "gel", "dura").
[[nodiscard]] std::string_view tissue_name(Tissue tissue) noexcept;

/// Constants of the rest-stable Neo-Hookean energy
/// Psi = lambda/2 (J - gamma)^2 + mu/2 (tr F^T F - 3), gamma = 1 + mu/lambda.
/// Source: Macklin & Mueller 2021. `lambda` is NOT Lame's: lambda = lambda_Lame + mu.
struct NeoHookean {
    double mu_pa = 0;      ///< Shear modulus [Pa].
    double lambda_pa = 0;  ///< Volume modulus of this energy [Pa].
    double gamma = 1;      ///< Rest-stable volume ratio [-].
};

/// Constants from engineering values. @pre E > 0, -1 < nu < 0.5.
[[nodiscard]] NeoHookean neo_hookean(double youngs_modulus_pa, double poissons_ratio) noexcept;

/// What one tissue is made of. Units in the names. Heat constants as in a single-set model.
struct Material {
    double youngs_modulus_pa = 5000;
    double poissons_ratio = 0.45;
    double density_kg_m3 = 1000;
    double damping_per_s = 10;           ///< Velocity damping [1/s].
    double fail_stretch = 1.6;           ///< Principal stretch at which an element tears [-].
    double injury_stretch = 1.3;         ///< Principal stretch that counts as over-stretch [-].
    double friction = 0.08;              ///< Coulomb, dynamic, against a polished shaft [-].
    double friction_static_ratio = 1.3;  ///< Static / dynamic friction [-].
    double crush_pa = 150000;            ///< Pressure between jaws that crushes [Pa].
    double traction_limit_n = 0.8;       ///< Pull of a grasper that counts as too much [N].
    double heat_conductivity_w_mk = 0.5;
    double heat_capacity_j_kgk = 3600;
    double water_fraction = 0.8;  ///< Mass fraction that must boil before removal [-].
};

using MaterialTable = std::array<Material, kTissueCount>;

}  // namespace placode::sim
