// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/verify/method_checks.h"

#include <cmath>

#include "sim/core/number_text.h"

namespace placode::sim {
namespace {

constexpr double kMostRounding = 20;  // [%] of the motion lost to rounding: no result
constexpr double kVbdGoodCourant = 0.6;
// Measured: right at 2e12, vertices that never move at 2e13 (nu 0.49) and 6e13 (nu 0.3).
constexpr double kVbdMostCourant = 1e12;

class MethodChecks {
 public:
    MethodChecks(const SolveSetup& setup, const KernelUnits& units, SolveResult& out)
        : setup_(setup), units_(units), solver_(setup.scene.solver), out_(out) {}

    /// What moves a vertex by less than a position resolves is lost. Measured on swinging
    /// cantilevers, errors against the estimate: floats, 8 and 20 cells, 1 and 9.8 m/s^2, 8 to 128
    /// substeps, all three methods, 0.2 to 1.6 times where it is between 1.6 and 66 %; with low
    /// parts, 8 cells, 1 mm/s^2, 8192 and 32768 substeps, 0.5 to 1.0 times.
    void rounding() const {
        const double h = solver_.frame_s / solver_.substeps;
        const double path = h * h * setup_.usual_acceleration();
        if (path <= 0) return;
        const auto farthest = static_cast<float>(units_.farthest(setup_.scene.mesh.rest));
        const double ulp = (std::nextafter(farthest, 2 * farthest) - farthest) / units_.length;
        const double resolved = solver_.single_precision ? ulp : 0x1p-24 * ulp;
        const double percent = (solver_.single_precision ? 2 : 0.35) * resolved / path;
        if (percent < 1) return;
        const int better = static_cast<int>(std::floor(solver_.substeps * std::sqrt(1 / percent)));
        inexact(
            percent, "/solver/substeps",
            "a substep moves tissue by " + rounded_text(path, 2) + " m, positions resolve " +
                rounded_text(resolved, 2) + " m there",
            (better > 0 ? "at most " + std::to_string(better) + " substeps a frame"
                        : std::string("longer frames")) +
                (solver_.single_precision ? ", or no \"single_precision\""
                                          : ", or method explicit, which has double precision"));
    }

    /// Forces are single precision, and at rest the sum of larger ones. Measured at rest,
    /// cantilever and hanging bar, 0.1 and 1 mm/s^2, vbd and xpbd: 0.1 to 2 times the estimate.
    void forces() const {
        const double stress = setup_.usual_stress();
        const double modulus = setup_.scene.material.youngs_modulus_pa;
        const double percent = 40 * 0x1p-24 * modulus / stress;
        if (stress <= 0 || percent < 1) return;
        inexact(percent, "/solver/method",
                "stresses of about " + rounded_text(stress, 2) + " Pa are " +
                    rounded_text(stress / modulus, 2) +
                    " of Young's modulus, and forces are single precision",
                "larger loads, or explicit or newton, which have double precision");
    }

    void vbd() const {
        if (setup_.max_courant > kVbdMostCourant)
            not_valid("/material/youngs_modulus_pa",
                      courant() +
                          ": a stiffness so far above mass over step^2 leaves the range of "
                          "a float, and nothing moves; expected at most " +
                          rounded_text(kVbdMostCourant, 4) +
                          " by another modulus, density or substep, or method newton");
        if (setup_.max_courant <= kVbdGoodCourant) return;
        const bool exact = setup_.scene.material.poissons_ratio <= kVbdExactPoissonsRatio;
        out_.warnings.push_back(
            "inexact in motion: " + courant() +
            ", vbd falls behind fast motion, by 10 % in a swing at 0.6 and 60 % at 1.1; " +
            (exact ? "what comes to rest is exact"
                   : "nearly incompressible tissue comes to rest up to some per cent off"));
    }

    void xpbd() const {
        const double limit =
            solver_.method == SolveMethod::kXpbd ? kXpbdMaxCourant : kXpbdPairMaxCourant;
        if (setup_.max_courant > limit) {
            not_valid(
                "/solver/substeps",
                courant() + " is above " + rounded_text(limit, 4) + ", the limit of " +
                    method_name(solver_.method) + "; with " + std::to_string(solver_.substeps) +
                    " substeps a frame expected at least " +
                    rounded_text(std::ceil(solver_.substeps * setup_.max_courant / limit), 4) +
                    ", or method vbd, which is valid at any");
        } else if (setup_.max_courant > kXpbdGoodCourant) {
            out_.warnings.push_back("inexact: " + courant() +
                                    ", xpbd is up to about 7 % too soft (good up to " +
                                    rounded_text(kXpbdGoodCourant, 4) + ")");
        }
        if (solver_.iterations > 1)
            out_.warnings.push_back(
                "xpbd with more than one iteration a substep settles beside the equilibrium; "
                "smaller substeps are the cure");
    }

    /// Projecting one constraint after the other leaves a stress behind that grows with the square
    /// of the shear wave's Courant number. Measured on hanging and pulled bars, nu 0.3, 0.45 and
    /// 0.48, 16 to 64 substeps, weights of 0.4 and 4 permille of E: 0.59 to 0.61 mu Co_s^2 in
    /// hanging ones, 0.4 in pulled ones. Bending stresses are larger than weight x length, and
    /// cantilevers are off by a third to a tenth of the share that is said here.
    void pair() const {
        const Material& m = setup_.scene.material;
        const NeoHookean c = neo_hookean(m.youngs_modulus_pa, m.poissons_ratio);
        const double shear =
            setup_.max_courant * setup_.max_courant * c.mu_pa / (c.lambda_pa + c.mu_pa);
        const double left = 0.6 * c.mu_pa * shear, stress = setup_.usual_stress();
        const double percent = 100 * left / stress;
        if (stress <= 0 || percent < 1) return;
        out_.warnings.push_back("inexact: xpbd_pair leaves stresses of about " +
                                rounded_text(left, 2) + " Pa where tissue is at rest, up to " +
                                rounded_text(std::round(percent), 6) +
                                " % of those of the scene; expected about " +
                                rounded_text(std::ceil(solver_.substeps * std::sqrt(percent)), 6) +
                                " substeps a frame for 1 %, or method xpbd or vbd");
    }

 private:
    [[nodiscard]] std::string courant() const {
        return "Courant number " + rounded_text(setup_.max_courant, 4);
    }

    void inexact(double percent, const char* pointer, const std::string& why,
                 const std::string& cure) const {
        const std::string text =
            why + ": errors of about " + rounded_text(percent, 2) + " %; expected " + cure;
        if (percent > kMostRounding) {
            not_valid(pointer, text);
        } else {
            out_.warnings.push_back("inexact: " + text);
        }
    }

    void not_valid(const char* pointer, const std::string& text) const {
        if (!solver_.allow_invalid)
            throw VerificationError(pointer,
                                    text + " (\"allow_invalid\": true runs it nevertheless)");
        out_.warnings.push_back("not valid: " + text);
    }

    const SolveSetup& setup_;
    const KernelUnits& units_;
    const VerificationSolver& solver_;
    SolveResult& out_;
};

}  // namespace

void check_method(const SolveSetup& setup, const KernelUnits& units, SolveResult& out) {
    const MethodChecks check(setup, units, out);
    check.rounding();
    check.forces();
    if (setup.scene.solver.method == SolveMethod::kVbd) {
        check.vbd();
    } else {
        check.xpbd();
        if (setup.scene.solver.method == SolveMethod::kXpbdPair) check.pair();
    }
}

}  // namespace placode::sim
