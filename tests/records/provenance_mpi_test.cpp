// SPDX-License-Identifier: GPL-3.0-or-later
//
// What results.h5 says of its origin: every file that a case is started from, found by what the files name, and texts
// read back byte for byte.
#include "records/provenance.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>

#include "support/scratch_folder.hpp"
#include "support/world.hpp"

namespace {

using namespace interphase;
using test::world;

void write(const std::string& path, const std::string& text)
{
    const std::filesystem::path file(path);
    if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
}

std::map<std::string, InputFile> inputs_of(const std::vector<std::pair<std::string, std::string>>& variables = {})
{
    std::map<std::string, InputFile> found;
    for (const InputFile& file : case_inputs(".", "dem/in.liggghts", variables))
        found[file.path] = file;
    return found;
}

TEST(Provenance, FilesOfACaseAreFoundByWhatTheyName)
{
    const test::ScratchFolder folder(world());
    if (world().is_master()) {
        write("system/controlDict", "#include \"../parameters\"\n#include \"$FOAM_CASE/more/numbers\"\nendTime 1;\n");
        write("parameters", "weight 8;\n#includeIfPresent \"nowhere\"\n");
        write("more/numbers", "");
        write("constant/polyMesh/points", "(0 0 0)");
        write("0/U", "uniform (0 0 0)");
        write("0.1/U", "not of the start");
        write("notes", "that nothing names");
        write("dem/in.liggghts",
              "read_data dem/bed.data # and then\ninclude dem/${method}.liggghts\ninclude dem/${own}.liggghts\n"
              "# include dem/off.liggghts\nfix mesh all mesh/surface file dem/wall.stl type 1\n"
              "fix series all ave/time 1 1 1 c_e file dem/out.txt\ninclude ../outside.liggghts\n");
        write("dem/bed.data", "atoms\n");
        write("dem/soft.liggghts", "include dem/in.liggghts\ninclude \"dem/contact.liggghts\"\n");  // and round again
        for (const char* name : {"dem/contact.liggghts", "dem/off.liggghts", "dem/wall.stl", "dem/out.txt"})
            write(name, "");
        std::vector<std::string> paths;
        for (const auto& [path, file] : inputs_of({{"method", "soft"}}))
            paths.push_back(path);
        EXPECT_EQ(paths,
                  (std::vector<std::string>{"0/U", "constant/polyMesh/points", "dem/bed.data", "dem/contact.liggghts",
                                            "dem/in.liggghts", "dem/soft.liggghts", "dem/wall.stl", "more/numbers",
                                            "parameters", "system/controlDict"}));
    }
    world().barrier();
}

TEST(Provenance, LargeFilesAndBinaryOnesAreKeptBySizeAndHash)
{
    const test::ScratchFolder folder(world());
    if (world().is_master()) {
        write("dem/in.liggghts", "abc");
        write("0/U", std::string(longest_kept, 'x'));
        write("0/p", std::string(longest_kept + 1, 'x'));
        write("constant/binary", std::string("a\0b", 3));
        write("constant/huge", "");
        std::filesystem::resize_file("constant/huge", longest_hashed + 1);
        const auto found = inputs_of();
        EXPECT_EQ(found.at("dem/in.liggghts").text, "abc");
        EXPECT_EQ(found.at("dem/in.liggghts").sha256,
                  "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
        EXPECT_EQ(found.at("0/U").text, std::string(longest_kept, 'x'));
        EXPECT_FALSE(found.at("0/p").text);
        EXPECT_EQ(found.at("0/p").bytes, longest_kept + 1);
        EXPECT_EQ(found.at("0/p").sha256.size(), 64u);
        EXPECT_FALSE(found.at("constant/binary").text);
        EXPECT_EQ(found.at("constant/huge").bytes, longest_hashed + 1);
        EXPECT_EQ(found.at("constant/huge").sha256, "");
    }
    world().barrier();
}

TEST(Provenance, OfACaseWithoutFilesIsEmpty)
{
    const test::ScratchFolder folder(world());
    EXPECT_TRUE(inputs_of().empty());
    world().barrier();
}

TEST(Provenance, IsReadBackAsItWasRecorded)
{
    const test::ScratchFolder folder(world());
    {
        Results results(world());
        InputFile kept, large;
        kept.path = "system/controlDict";
        kept.text = "endTime 1; // \xc3\xa9\n";
        kept.bytes = kept.text->size();
        kept.sha256 = "0123";
        large.path = "0/U";
        large.bytes = 5000000;
        record_provenance(results, {"1.2.3", "c0ffee", "no", "GNU 12", "-O3", "Release"}, {large, kept});
        results.flush();
    }
    world().barrier();
    if (!world().is_master()) return;

    const Hdf5Handle file(H5Fopen("results.h5", H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "results.h5");
    const auto word = [&](const char* object, const char* name) {
        const Hdf5Handle attribute(H5Aopen_by_name(file, object, name, H5P_DEFAULT, H5P_DEFAULT), H5Aclose, name);
        const Hdf5Handle type(H5Aget_type(attribute), H5Tclose, name);
        EXPECT_GT(H5Tis_variable_str(type), 0) << name;
        char* value = nullptr;
        EXPECT_GE(H5Aread(attribute, type, static_cast<void*>(&value)), 0) << name;
        std::string words(value);
        H5free_memory(value);
        return words;
    };
    EXPECT_EQ(word("/meta", "version"), "1.2.3");
    EXPECT_EQ(word("/meta", "commit"), "c0ffee");
    EXPECT_EQ(word("/meta", "uncommitted_changes"), "no");
    EXPECT_EQ(word("/meta", "compiler"), "GNU 12");
    EXPECT_EQ(word("/meta", "compiler_flags"), "-O3");
    EXPECT_EQ(word("/meta", "build_type"), "Release");
    EXPECT_EQ(word("/meta/inputs/system/controlDict", "kept"), "yes");
    EXPECT_EQ(word("/meta/inputs/system/controlDict", "sha256"), "0123");
    EXPECT_EQ(word("/meta/inputs/0/U", "kept"), "no");
    EXPECT_LE(H5Aexists_by_name(file, "/meta/inputs/0/U", "sha256", H5P_DEFAULT), 0);

    const Hdf5Handle set(H5Dopen2(file, "/meta/inputs/system/controlDict", H5P_DEFAULT), H5Dclose, "text");
    const Hdf5Handle type(H5Dget_type(set), H5Tclose, "text");
    std::string text(H5Tget_size(type), '\0');
    ASSERT_GE(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()), 0);
    EXPECT_EQ(text, "endTime 1; // \xc3\xa9\n");
}

}  // namespace
