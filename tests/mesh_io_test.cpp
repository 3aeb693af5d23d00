// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Every format on one box of six tetrahedra (written by an independent program, see
// tests/data/README.md), and what is said about broken files: never a crash, always the number.
#include "sim/mesh_io/mesh_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>
#include <filesystem>
#include <fstream>
#include <sstream>

using namespace placode::sim;
using ::testing::HasSubstr;

namespace THIS_TEST {

const std::string kFolder = std::string(PLACODE_SOURCE_DIR) + "/tests/data/meshes/";

std::string text_of(const std::string& name) {
    std::ifstream in(kFolder + name, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

/// A file of its own for one test.
class Scratch {
 public:
    Scratch() : folder_(std::filesystem::temp_directory_path() / ("mesh_io_" + name())) {
        std::filesystem::create_directories(folder_);
    }
    ~Scratch() {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }
    std::string write(const std::string& file, const std::string& text) const {
        std::ofstream(folder_ / file, std::ios::binary) << text;
        return (folder_ / file).string();
    }

 private:
    static std::string name() {
        return std::to_string(::getpid()) + "_" +
               ::testing::UnitTest::GetInstance()->current_test_info()->name();
    }
    std::filesystem::path folder_;
};

std::string error_of(const std::string& path) {
    try {
        (void)prepare_mesh(read_mesh_file(path), 1, false);
    } catch (const MeshError& error) {
        return error.what();
    }
    return "accepted";
}

std::string msh1_error(const std::string& from, const std::string& to) {
    const Scratch scratch;
    return error_of(scratch.write("a.msh", replaced(text_of("box_gmsh1.msh"), from, to)));
}

struct Good {
    const char* file;
    const char* format;
    int triangles, first_point, first_tet;
    int points = 9;
};
void PrintTo(const Good& good, std::ostream* out) { *out << good.file; }

class EveryFormat : public ::testing::TestWithParam<Good> {};
INSTANTIATE_TEST_SUITE_P(
    Formats, EveryFormat,
    ::testing::Values(Good{"box_gmsh1.msh", "Gmsh 1 ascii", 2, 10, 3},
                      Good{"box_gmsh22_ascii.msh", "Gmsh 2.2 ascii", 2, 1, 3},
                      Good{"box_gmsh22_binary.msh", "Gmsh 2.2 binary", 2, 1, 3},
                      Good{"box_gmsh41_ascii.msh", "Gmsh 4.1 ascii", 2, 1, 3},
                      Good{"box_gmsh41_binary.msh", "Gmsh 4.1 binary", 2, 1, 3},
                      Good{"box_vtk42_ascii.vtk", "VTK legacy 4.2 ascii", 2, 0, 2},
                      Good{"box_vtk42_binary.vtk", "VTK legacy 4.2 binary", 2, 0, 2},
                      Good{"box_vtk51_ascii.vtk", "VTK legacy 5.1 ascii", 2, 0, 2},
                      Good{"box_vtk51_binary.vtk", "VTK legacy 5.1 binary", 2, 0, 2},
                      Good{"box_ascii.vtu", "VTU ascii", 2, 0, 2},
                      Good{"box_tetgen.node", "TetGen", 0, 0, 0}));

TEST_P(EveryFormat, ReadsTheBoxOfSixTetrahedra) {
    const Good good = GetParam();
    const FileMesh file = read_mesh_file(kFolder + good.file);
    EXPECT_EQ(file.format, good.format);
    ASSERT_EQ(file.points.size(), 9u);
    EXPECT_EQ(file.points[3], Vec3(1, 2, 0));
    EXPECT_EQ(file.points[8], Vec3(9, 9, 9));
    EXPECT_EQ(file.point_id[0], good.first_point);
    ASSERT_EQ(file.tets.size(), 6u);
    EXPECT_EQ(file.tets[0].id, good.first_tet);
    EXPECT_EQ(file.tets[0].point, (std::array<int32_t, 4>{0, 1, 3, 7}));
    if (good.triangles > 0) {
        EXPECT_EQ(file.skipped.at("triangle"), good.triangles);
    }

    const LoadedMesh loaded = prepare_mesh(file, 1e-3, false);
    EXPECT_EQ(loaded.mesh.rest.size(), 8u);  // the ninth is used by no tet
    EXPECT_EQ(loaded.vertex_of_point[8], -1);
    EXPECT_EQ(loaded.vertex_of_point[7], 7);
    double volume = 0;
    for (int t = 0; t < 6; ++t) volume += rest_volume(loaded.mesh, t);
    EXPECT_NEAR(volume, 6e-9, 1e-18);
    std::string all;
    for (const std::string& warning : loaded.warnings) all += warning + "\n";
    EXPECT_THAT(all, HasSubstr("1 points are used by no tetrahedron"));
    if (good.triangles > 0) {
        EXPECT_THAT(all, HasSubstr("skipped 2 cells: triangle"));
    }
}

TEST(MeshIo, NamesInvertedElementsWithTheirNumberAndLine) {
    // Element 3 stands in line 17 of the file.
    const std::string error = msh1_error("3 4 1 1 4 10 20 40 80", "3 4 1 1 4 20 10 40 80");
    EXPECT_THAT(error, HasSubstr("a.msh: 1 of 6 tetrahedra are inverted: number 3 (line 17)"));
}

TEST(MeshIo, TurnsAMeshRoundThatIsInvertedAsAWhole) {
    FileMesh file = read_mesh_file(kFolder + "box_gmsh1.msh");
    for (FileTet& tet : file.tets) std::swap(tet.point[2], tet.point[3]);
    const LoadedMesh loaded = prepare_mesh(file, 1, false);
    for (int t = 0; t < 6; ++t) EXPECT_GT(rest_volume(loaded.mesh, t), 0);
    EXPECT_THAT(loaded.warnings, ::testing::Contains(HasSubstr("opposite orientation")));
}

TEST(MeshIo, NamesDuplicatesDegenerateAndOverlappingElements) {
    EXPECT_THAT(msh1_error("4 4 1 1 4 10 30 70 80", "4 4 1 1 4 20 40 10 80"),
                ::testing::AllOf(HasSubstr("1 duplicate tetrahedra (same four points): number 4 "
                                           "(line 18) = 3 (line 17); repair"),
                                 ::testing::Not(HasSubstr("overlap"))));
    EXPECT_THAT(msh1_error("4 4 1 1 4 10 30 70 80", "4 4 1 1 4 10 20 40 30"),
                HasSubstr("1 degenerate tetrahedra: number 4 (line 18)"));
    EXPECT_THAT(msh1_error("4 4 1 1 4 10 30 70 80", "4 4 1 1 4 10 30 30 80"),
                ::testing::AllOf(HasSubstr("a.msh: 1 tetrahedra without four different points: "
                                           "number 4 (line 18): corners 2 and 3 are both point 30"),
                                 ::testing::Not(HasSubstr("degenerate")),
                                 ::testing::Not(HasSubstr("overlap"))));
    // Everything that is wrong is said at once.
    EXPECT_THAT(msh1_error("4 4 1 1 4 10 30 70 80", "4 4 1 1 4 20 10 40 80"),
                ::testing::AllOf(HasSubstr("duplicate"), HasSubstr("inverted")));
    // A third tet on the inner face 10 40 80: all three are named, each once.
    EXPECT_THAT(msh1_error("4 4 1 1 4 10 30 70 80", "4 4 1 1 4 10 80 40 90"),
                HasSubstr("more than two tetrahedra at one face, so that some of them overlap: "
                          "number 3 (line 17), 4 (line 18), 8 (line 22)"));
}

TEST(MeshIo, NamesPointsThatDoNotExistOrAreNotFinite) {
    EXPECT_THAT(msh1_error("3 4 1 1 4 10 20 40 80", "3 4 1 1 4 10 20 45 80"),
                HasSubstr("line 17: element 3: no point 45; the points are numbered 10 to 90"));
    EXPECT_THAT(msh1_error("20 1 0 0", "20 nan 0 0"),
                HasSubstr("line 4: point 20: x is nan; expected a finite number"));
    EXPECT_THAT(msh1_error("20 1 0 0", "20 1 0 -inf"), HasSubstr("line 4: point 20: z is -inf"));
    EXPECT_THAT(msh1_error("20 1 0 0", "20 1e999 0 0"), HasSubstr("outside the range"));
    EXPECT_THAT(msh1_error("20 1 0 0", "10 1 0 0"), HasSubstr("point 10 is there twice"));
    EXPECT_THAT(msh1_error("20 1 0 0", "20 1,5 0 0"), HasSubstr("line 4: \"1,5\""));
}

TEST(MeshIo, RefusesCountsThatTheFileCannotHold) {
    EXPECT_THAT(msh1_error("$NOD\n9", "$NOD\n900000000000"), HasSubstr("is not possible"));
    EXPECT_THAT(msh1_error("$NOD\n9", "$NOD\n-9"), HasSubstr("is not possible"));
    EXPECT_THAT(msh1_error("$NOD\n9", "$NOD\n8"),
                HasSubstr("line 11: \"90\" where $ENDNOD is expected; line 2 says 8 nodes"));
}

TEST(MeshIo, NamesTheHeadWhoseCountIsWrong) {
    const Scratch scratch;
    const auto error = [&](const char* from, const char* to) {
        return error_of(
            scratch.write("a.msh", replaced(text_of("box_gmsh41_ascii.msh"), from, to)));
    };
    for (const char* count : {"8", "10"})
        EXPECT_THAT(error("3 1 0 9", (std::string("3 1 0 ") + count).c_str()),
                    HasSubstr(std::string("a.msh: line 10: node block 1 of 1 says ") + count +
                              " nodes, but line 9 says 9 nodes in 1 blocks"));
    EXPECT_THAT(error("3 1 4 6", "3 1 4 5"),
                HasSubstr("line 35: element block 2 of 2 says 5 elements, 7 with those before it "
                          "(line 32 says 2 elements in block 1), but line 31 says 8 elements in 2 "
                          "blocks"));
    EXPECT_THAT(error("2 8 1 8", "1 8 1 8"),
                HasSubstr("line 32: element block 1 of 1 says 2 elements, but line 31 says 8"));
    EXPECT_THAT(error("2 8 1 8", "3 8 1 8"),
                HasSubstr("\"$EndElements\" where the dimension of an element block (a whole "
                          "number) is expected; line 35 says 6 elements in block 2, line 31 says 8 "
                          "elements in 3 blocks"));
    // The second element is taken for the head of block 2.
    EXPECT_THAT(error("2 1 2 2\n1 1 2 4\n2 1 4 3\n", "2 1 2 1\n1 1 2 4\n2 1 4 3\n"),
                HasSubstr("line 32 says 1 elements in block 1), but line 31 says 8 elements"));
    EXPECT_THAT(error("1 9 1 9", "0 9 1 9"),
                HasSubstr("line 9: 9 nodes in 0 blocks; expected at least one block"));
}

TEST(MeshIo, TakesVtuAsXmlAllowsIt) {
    const Scratch scratch;
    const auto tets = [&](const std::string& from, const std::string& to) {
        return read_mesh_file(scratch.write("a.vtu", replaced(text_of("box_ascii.vtu"), from, to)))
            .tets.size();
    };
    EXPECT_EQ(tets("Name=\"Points\" ", "Name='a > \"b\"' "), 6u);
    EXPECT_EQ(tets("Name=\"offsets\" format=\"ascii\"", "Name=\"offsets\""), 6u);
}

TEST(MeshIo, NamesTheLineOfCellsInVtkFiles) {
    const Scratch scratch;
    const std::string cells = "<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n";
    const auto vtu = [&](const std::string& from, const std::string& to) {
        return error_of(scratch.write("a.vtu", replaced(text_of("box_ascii.vtu"), from, to)));
    };
    const std::string faces = cells + "0\n1\n3\n0\n3\n2\n";  // the first tet follows: 0 1 3 7
    EXPECT_THAT(vtu(faces + "0\n1\n3\n7", faces + "1\n0\n3\n7"),
                HasSubstr("a.vtu: 1 of 6 tetrahedra are inverted: number 2 (line 46)"));
    EXPECT_THAT(vtu(faces + "0\n1\n3\n7", faces + "0\n1\n3\n70"),
                HasSubstr("a.vtu: line 49: cell 2: no point 70; the points are numbered 0 to 8"));
    EXPECT_THAT(vtu(faces + "0\n1\n3\n7", faces + "0\n1\n3"),
                HasSubstr("line 79: cell 7: offsets 26 to 30 do not fit the connectivity of 29"));
    EXPECT_THAT(vtu("5\n5\n10", "5\n10"),
                HasSubstr("line 5: Piece says NumberOfCells \"8\", found 7"));
    EXPECT_THAT(vtu("30\n\n</DataArray>", "\n</DataArray>"),
                HasSubstr("line 5: 7 cells, but 8 cell types"));
    // Cells are counted through all pieces.
    const std::string text = text_of("box_ascii.vtu");
    const std::string piece =
        text.substr(text.find("<Piece"), text.find("</UnstructuredGrid>") - text.find("<Piece"));
    const std::string second = replaced(piece, faces + "0\n1\n3\n7", faces + "0\n1\n1\n7");
    EXPECT_THAT(vtu("</UnstructuredGrid>", second + "</UnstructuredGrid>"),
                HasSubstr("number 10 (line "));
    EXPECT_THAT(error_of(scratch.write("a.vtk", replaced(text_of("box_vtk51_ascii.vtk"),
                                                         "0 1 3 7 0 2 6", "0 1 3 70 0 2 6"))),
                HasSubstr("a.vtk: line 23: cell 2: no point 70"));
    // Behind binary data lines mean nothing.
    std::string binary = text_of("box_gmsh22_binary.msh");
    const size_t x = binary.find("$Nodes\n9\n") + 9 + 4;
    binary.replace(x, 8, std::string("\0\0\0\0\0\0\xf0\x7f", 8));
    EXPECT_THAT(error_of(scratch.write("a.msh", binary)),
                HasSubstr("a.msh: byte " + std::to_string(x + 24) + ": point 1: x is inf"));
}

TEST(MeshIo, RefusesPiecesThatDoNotHangTogetherUnlessAllowed) {
    const std::string two =
        "$NOD\n8\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 5 0 0\n6 6 0 0\n7 5 1 0\n8 5 0 1\n$ENDNOD\n"
        "$ELM\n2\n1 4 1 1 4 1 2 3 4\n2 4 1 1 4 5 6 7 8\n$ENDELM\n";
    const Scratch scratch;
    const std::string path = scratch.write("two.msh", two);
    EXPECT_THAT(error_of(path), HasSubstr("2 pieces that do not hang together"));
    const LoadedMesh loaded = prepare_mesh(read_mesh_file(path), 1, true);
    EXPECT_EQ(loaded.mesh.tets.size(), 2u);
    EXPECT_THAT(loaded.warnings, ::testing::Contains(HasSubstr("2 pieces")));
}

TEST(MeshIo, SaysWhatItCannotRead) {
    const Scratch scratch;
    EXPECT_THAT(error_of(kFolder + "broken_binary.vtu"), HasSubstr("only ascii is read"));
    EXPECT_THAT(error_of(scratch.write("a.msh", "$MeshFormat\n4 0 8\n$EndMeshFormat\n")),
                HasSubstr("Gmsh format \"4\"; expected 1, 2.x or 4.1"));
    EXPECT_THAT(error_of(scratch.write("a.stl", "solid")), HasSubstr("expected .msh"));
    EXPECT_THAT(error_of(scratch.write("b.msh", "hello")), HasSubstr("is this a Gmsh file?"));
    EXPECT_THAT(error_of(scratch.write("b2.msh", std::string("\x1f\x00gz", 4))),
                HasSubstr("\"??gz\" where a section"));
    EXPECT_THAT(error_of(scratch.write("c.msh", "")), HasSubstr("no nodes"));
    EXPECT_THAT(error_of(scratch.write("a.vtk", "nonsense")),
                HasSubstr("a.vtk: line 1: \"nonsense\" where \"# vtk DataFile Version"));
    EXPECT_THAT(error_of(scratch.write(
                    "b.vtk", replaced(text_of("box_vtk42_ascii.vtk"), "POINTS 9", "POINTS 10"))),
                HasSubstr("\"CELLS\" where a coordinate (a number) is expected; line 5 says 10 "
                          "points"));
    const std::string empty = "<Piece NumberOfPoints=\"0\" NumberOfCells=\"0\"/>\n<Piece ";
    EXPECT_EQ(
        read_mesh_file(scratch.write("b.vtu", replaced(text_of("box_ascii.vtu"), "<Piece ", empty)))
            .tets.size(),
        6u);
    EXPECT_THAT(error_of(scratch.write("a.vtu", "nonsense")), HasSubstr("VTU"));
    EXPECT_THAT(error_of(scratch.write("a.node", "1 3 0 0\n0 0 0 0\n")),
                HasSubstr("a.ele: cannot be opened"));
    EXPECT_THAT(error_of("/nowhere/a.msh"), HasSubstr("cannot be opened"));
    // A count that is too small must not drop what follows.
    const std::string points = "1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 0 0 -1\n";
    (void)scratch.write("two.ele", "1 4 0\n1 1 2 3 4\n2 1 3 2 5\n");
    EXPECT_THAT(error_of(scratch.write("two.node", "5 3 0 0\n" + points)),
                HasSubstr("line 3: found \"2\" behind the 1 tetrahedra"));
    (void)scratch.write("few.ele", "1 4 0\n1 1 2 3 4\n");
    EXPECT_THAT(error_of(scratch.write("few.node", "4 3 0 0\n" + points)),
                HasSubstr("found \"5\" behind the 4 points"));
    const std::string surface =
        "$NOD\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n$ENDNOD\n$ELM\n1\n1 2 1 1 3 1 2 3\n$ENDELM\n";
    EXPECT_THAT(error_of(scratch.write("d.msh", surface)),
                HasSubstr("no tetrahedra; found 1 triangle"));
}

TEST(MeshIo, ReadsParametricNodesOfGmsh2) {
    // Behind the coordinates: dimension and number of an entity, and the place on it.
    Scratch scratch;
    std::string text = text_of("box_gmsh22_ascii.msh");
    const size_t from = text.find("$Nodes\n"), to = text.find("$EndNodes");
    std::istringstream nodes(text.substr(from + 7, to - from - 7));
    std::ostringstream parametric;
    std::string line;
    std::getline(nodes, line);
    parametric << "$ParametricNodes\n" << line << "\n";
    for (int i = 0; std::getline(nodes, line); ++i) {
        const char* const place[]{" 0 1", " 1 4 0.5", " 2 3 0.25 0.75", " 3 1"};
        parametric << line << place[i % 4] << "\n";
    }
    text = text.substr(0, from) + parametric.str() + "$EndParametricNodes" + text.substr(to + 9);
    const FileMesh plain = read_mesh_file(kFolder + "box_gmsh22_ascii.msh");
    const FileMesh read = read_mesh_file(scratch.write("parametric.msh", text));
    EXPECT_EQ(read.points, plain.points);
    EXPECT_EQ(read.point_id, plain.point_id);
    EXPECT_EQ(read.tets.size(), plain.tets.size());
}

TEST(MeshIo, WhatItQuotesOfAFileIsText) {
    Scratch scratch;
    const std::string error = error_of(
        scratch.write("bytes.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n\xAE\xFF\x01 x\n"));
    EXPECT_THAT(error, HasSubstr("\"???\" where a section"));
}

TEST(MeshIo, TakesTheMarkThatSomeEditorsPutBeforeUtf8) {
    Scratch scratch;
    for (const char* name : {"box_gmsh22_ascii.msh", "box_vtk42_ascii.vtk", "box_ascii.vtu"}) {
        const std::string path = scratch.write(name, "\xEF\xBB\xBF" + text_of(name));
        EXPECT_EQ(read_mesh_file(path).tets.size(), 6U) << name;
    }
}

TEST(MeshIo, SaysThatAFileIsCutOff) {
    const Scratch scratch;
    const auto cut = [&](const char* name, const char* from, size_t more) {
        const std::string text = text_of(name);
        const std::string ending = std::string(name).substr(std::string(name).rfind('.'));
        return error_of(scratch.write("cut" + ending, text.substr(0, text.find(from) + more)));
    };
    EXPECT_THAT(cut("box_gmsh22_ascii.msh", "$Elements", 12),
                HasSubstr("line 18: the file is cut off: it ends where an element number is "
                          "expected"));
    EXPECT_THAT(cut("box_gmsh41_ascii.msh", "$Elements", 40), HasSubstr("the file is cut off"));
    EXPECT_THAT(cut("box_gmsh41_ascii.msh", "$EndElements", 0),
                HasSubstr("the file is cut off: it ends where $EndElements is expected"));
    EXPECT_THAT(cut("box_gmsh1.msh", "$ELM", 25), HasSubstr("the file is cut off"));
    EXPECT_THAT(cut("box_gmsh22_binary.msh", "$Elements", 40),
                HasSubstr("the file is cut off: it ends at byte "));
    EXPECT_THAT(cut("box_vtk42_ascii.vtk", "CELLS", 30), HasSubstr("the file is cut off"));
    EXPECT_THAT(cut("box_ascii.vtu", "offsets", 40),
                HasSubstr("the file is cut off: it ends inside the <Piece> of line 5"));
}

TEST(MeshIo, SurvivesFilesThatAreCutOffAnywhere) {
    const Scratch scratch;
    for (const char* name : {"box_gmsh1.msh", "box_gmsh22_ascii.msh", "box_gmsh22_binary.msh",
                             "box_gmsh41_ascii.msh", "box_gmsh41_binary.msh", "box_vtk42_ascii.vtk",
                             "box_vtk42_binary.vtk", "box_vtk51_binary.vtk", "box_ascii.vtu"}) {
        const std::string text = text_of(name);
        const std::string ending = std::string(name).substr(std::string(name).rfind('.'));
        for (size_t n = 0; n + 40 < text.size(); n += 31) {
            const std::string path = scratch.write("cut" + ending, text.substr(0, n));
            EXPECT_NE(error_of(path), "accepted") << name << " cut at " << n;
        }
    }
}

TEST(MeshIo, SurvivesBytesThatAreWrong) {
    // Any byte may be anything: an answer or a MeshError, nothing else (run under sanitizers).
    const Scratch scratch;
    uint32_t seed = 1;
    for (const char* name :
         {"box_gmsh1.msh", "box_gmsh22_binary.msh", "box_gmsh41_ascii.msh", "box_gmsh41_binary.msh",
          "box_vtk42_binary.vtk", "box_ascii.vtu", "box_vtk51_binary.vtk"}) {
        const std::string good = text_of(name);
        const std::string ending = std::string(name).substr(std::string(name).rfind('.'));
        for (int round = 0; round < 60; ++round) {
            std::string text = good;
            for (int i = 0; i < 3; ++i) {
                seed = seed * 1664525 + 1013904223;
                text[seed % text.size()] = static_cast<char>(seed >> 24);
            }
            (void)error_of(scratch.write("wrong" + ending, text));
        }
    }
}

}  // namespace THIS_TEST
