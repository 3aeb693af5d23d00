// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl solve SCENE.json --out DIR: a verification scene, with vertices.csv, probes.csv and
// summary.json. Everything is checked before the first file is written.

#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>

#include "curriculum/verification_json.h"
#include "ui/cli/progress.h"
#include "ui/cli/solver_commands.h"
#include "ui/cli/write_file.h"

namespace placode::cli {
namespace {

struct SolveOptions {
    std::string scene, out;
};

std::string csv(const sim::Vec3& p) {
    return shortest(p.x()) + ',' + shortest(p.y()) + ',' + shortest(p.z());
}

Json to_json(const sim::Vec3& p) { return {p.x(), p.y(), p.z()}; }

Json to_json(const std::vector<sim::RegionForce>& forces) {
    Json list = Json::array();
    for (const auto& f : forces)
        list.push_back({{"region", f.pointer}, {"force_n", to_json(f.force_n)}});
    return list;
}

std::string hex(uint64_t value) {
    std::array<char, 16> text{};
    const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value, 16);
    std::string digits(text.data(), end);
    return std::string(16 - digits.size(), '0') + digits;
}

Json summary_of(const sim::VerificationScene& scene, const sim::SolveResult& result) {
    return {{"vertices", scene.output_points.size()},
            {"tets", scene.mesh.tets.size()},
            {"sheet_triangles", scene.sheet.size()},
            {"method", sim::method_name(scene.solver.method)},
            {"simulated_s", result.simulated_s},
            {"wall_s", result.wall_s},
            {"substeps", scene.solver.substeps},
            {"substeps_total", result.substeps_total},
            {"threads", scene.solver.threads},
            {"kinetic_energy_j", result.kinetic_energy_j},
            {"elastic_energy_j", result.elastic_energy_j},
            {"inverted_tets", result.inverted_tets},
            {"not_finite", result.not_finite},
            {"max_courant", result.max_courant},
            {"reaction_n", to_json(result.reaction_n)},
            {"reactions", to_json(result.reactions)},
            {"contact_force_n", to_json(result.contact_force_n)},
            {"contact_forces", to_json(result.contact_forces)},
            {"penetration_m", result.penetration_m},
            {"at_rest", result.at_rest},
            {"equilibrium_error_m",
             result.equilibrium_error_m ? Json(*result.equilibrium_error_m) : Json()},
            {"diverged", result.diverged},
            {"newton_iterations", result.newton_iterations},
            {"newton_residual_n", result.newton_residual_n},
            {"kernels", result.kernels},
            {"state_hash", hex(result.state_hash)},
            {"warnings", result.warnings}};
}

void write_vertices(std::ostream& out, const sim::VerificationScene& scene,
                    const sim::SolveResult& result) {
    out << "id,X_m,Y_m,Z_m,x_m,y_m,z_m\n";
    for (size_t i = 0; i < result.final_m.size(); ++i)
        out << i << ',' << csv(scene.output_points[i]) << ',' << csv(result.final_m[i]) << '\n';
}

void write_probes(std::ostream& out, const sim::VerificationScene& scene,
                  const sim::SolveResult& result) {
    out << "t_s";
    for (const auto& probe : scene.probes)
        out << ',' << probe.name << "_x_m," << probe.name << "_y_m," << probe.name << "_z_m";
    out << '\n';
    for (size_t i = 0; i < result.sample_time_s.size(); ++i) {
        out << shortest(result.sample_time_s[i]);
        for (const auto& p : result.probe_m[i]) out << ',' << csv(p);
        out << '\n';
    }
}

template <class Write>
void write_with(const std::filesystem::path& path, Write&& write) {
    std::ofstream out(path, std::ios::binary);
    write(out);
    out.flush();
    if (!out)
        throw InputError("--out: " + path.string() + " cannot be written; choose another place");
}

void make_folder(const std::string& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error || !std::filesystem::is_directory(folder))
        throw InputError("--out " + folder + ": cannot be made (" + error.message() +
                         "); choose another place");
}

int solve(const Context& context, const SolveOptions& options) {
    need_writable_folder("--out", options.out);
    const sim::VerificationScene scene = curriculum::load_verification_scene(options.scene);
    const bool show = isatty(STDERR_FILENO) != 0;
    const sim::SolveResult result = curriculum::solve_verification_scene(
        scene, options.scene, show ? show_progress : sim::SolveWatch());
    clear_progress();
    make_folder(options.out);
    const std::filesystem::path folder = options.out;
    const Json summary = summary_of(scene, result);
    write_with(folder / "vertices.csv",
               [&](std::ostream& out) { write_vertices(out, scene, result); });
    write_with(folder / "probes.csv", [&](std::ostream& out) { write_probes(out, scene, result); });
    write_with(folder / "summary.json", [&](std::ostream& out) {
        out << summary.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
    });
    for (const std::string& warning : result.warnings)
        std::cerr << "placodectl: warning: " << warning << '\n';
    std::vector<std::vector<std::string>> rows;
    for (const auto& [key, value] : summary.items()) {
        if (key != "warnings")
            rows.push_back({key, value.is_string() ? value.get<std::string>() : value.dump()});
    }
    print(context, summary,
          table(rows) + "written: " + options.out + "/vertices.csv, probes.csv, summary.json");
    return result.diverged || result.not_finite > 0 ? 1 : 0;
}

}  // namespace

void add_solve_command(CLI::App& app, Context& context) {
    auto options = std::make_shared<SolveOptions>();
    CLI::App* command = app.add_subcommand(
        "solve", "Solves a verification scene: one soft body, one method, results as CSV and JSON");
    command->add_option("SCENE", options->scene, "SCENE.json")->required();
    command
        ->add_option("--out", options->out, "Folder for vertices.csv, probes.csv and summary.json")
        ->required();
    command->callback([&context, options] {
        context.run = [&context, options] { return solve(context, *options); };
    });
}

}  // namespace placode::cli
