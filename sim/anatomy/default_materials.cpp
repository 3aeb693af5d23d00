// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/anatomy/operative_field.h"

namespace placode::sim {

namespace {

// What differs between the tissues; the rest is the same for all of them.
Material tissue(double youngs_modulus_pa, double poissons_ratio, double density_kg_m3,
                double fail_stretch, double injury_stretch) {
    Material material;
    material.youngs_modulus_pa = youngs_modulus_pa;
    material.poissons_ratio = poissons_ratio;
    material.density_kg_m3 = density_kg_m3;
    material.damping_per_s = 10;
    material.fail_stretch = fail_stretch;
    material.injury_stretch = injury_stretch;
    material.friction = 0.08;
    material.friction_static_ratio = 1.3;
    return material;
}

}  // namespace

// No test of fetal skin or meninges at 24 to 26 weeks is published: these are adult and animal
// values scaled down by judgement, to be confirmed by a fetal surgeon. The injury stretch of the
// placode is 1.3; that of the others is half way between rest and tearing.
MaterialTable default_materials() {
    MaterialTable table;
    const auto at = [&table](Tissue t) -> Material& { return table[static_cast<size_t>(t)]; };
    at(Tissue::kSkin) = tissue(60e3, 0.45, 1050, 1.6, 1.3);
    at(Tissue::kThinSkin) = tissue(35e3, 0.45, 1050, 1.5, 1.25);
    at(Tissue::kSubcutis) = tissue(3e3, 0.45, 1000, 1.8, 1.4);
    at(Tissue::kMuscle) = tissue(15e3, 0.45, 1060, 1.6, 1.3);
    at(Tissue::kZone) = tissue(25e3, 0.45, 1030, 1.5, 1.25);
    at(Tissue::kPlacode) = tissue(3e3, 0.45, 1040, 1.5, 1.3);
    at(Tissue::kGel) = tissue(0.5e3, 0.40, 1000, 2.0, 1.5);
    // Reflected dura is a shell of 0.1 mm and 500 kPa; the floor is a layer of about 1 mm of tets,
    // which has the same membrane stiffness (50 N/m) at a tenth of the modulus.
    at(Tissue::kDura) = tissue(50e3, 0.45, 1100, 1.25, 1.125);
    // Between jaws: 150 kPa crush skin, 20 kPa the placode; the others by judgement. Pulled too
    // hard: 0.8 N on skin, 0.5 N on membrane, 10 mN on the placode.
    const auto grasped = [&at](Tissue t, double crush_pa, double traction_limit_n) {
        at(t).crush_pa = crush_pa;
        at(t).traction_limit_n = traction_limit_n;
    };
    grasped(Tissue::kSkin, 150e3, 0.8);
    grasped(Tissue::kThinSkin, 150e3, 0.5);
    grasped(Tissue::kSubcutis, 100e3, 0.5);
    grasped(Tissue::kMuscle, 150e3, 0.8);
    grasped(Tissue::kZone, 100e3, 0.5);
    grasped(Tissue::kPlacode, 20e3, 0.010);
    grasped(Tissue::kGel, 50e3, 0.5);
    grasped(Tissue::kDura, 300e3, 0.8);
    return table;
}

}  // namespace placode::sim
