// SPDX-License-Identifier: GPL-3.0-or-later
// A small gas case in a temporary folder, stepped as the coupler steps it, with voidage and exchange prescribed.
#pragma once

#include <gtest/gtest.h>
#include <mpi.h>
#include <cstdlib>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/user_error.hpp"
#include "engines/openfoam/foam_case.hpp"
#include "support/scratch_folder.hpp"

namespace interphase::testing_gas {

/// The two sides of the box that face along one axis.
struct Sides {
    std::string type;  ///< of the patches: cyclic, empty, patch or wall
    std::array<std::string, 2>
        velocity{};  ///< boundary condition of U on the low and the high side; empty: the type's own
    std::array<std::string, 2> pressure{};  ///< of p_rgh
};

inline const Sides periodic{"cyclic", {}, {}};
inline const Sides unresolved{"empty", {}, {}};

/// Flow along the axis: `velocity` [m/s] (of the three axes) enters on the low side, the pressure is 0 on the high one.
inline Sides through_flow(const std::string& velocity)
{
    return {"patch",
            {"type fixedValue; value uniform " + velocity + ";", "type zeroGradient;"},
            {"type fixedFluxPressure; gradient uniform 0; value uniform 0;", "type fixedValue; value uniform 0;"}};
}

using VectorField = std::function<Vector(const Vector&)>;
using ScalarField = std::function<double(const Vector&)>;

struct Scene {
    Vector size{1, 1, 1};  ///< of the box [m]
    std::array<int, 3> cells{1, 1, 1};
    std::array<Sides, 3> sides{unresolved, unresolved, unresolved};
    double density = 1;       ///< [kg/m3]
    double viscosity = 1e-9;  ///< [Pa s]
    double gas_step = 1e-3;   ///< [s]
    std::string time_scheme = "Euler";
    int outer_correctors = 1;
    int correctors = 2;
    double pressure_tolerance = 1e-12;
    int pressure_iterations = 1;  ///< at least; 0 where there may be nothing to correct, which PCG divides by
    Vector gravity{0, 0, 0};      ///< [m/s2]
    std::string functions;        ///< function objects: what stands in `functions { ... }` of controlDict
    VectorField velocity = [](const Vector&) { return Vector(0, 0, 0); };  ///< at the start [m/s]

    std::string flux;  ///< what stands in 0/phi, as a run leaves it; none where empty

    /// Writes another mesh than the box into the folder polyMesh; the gas is at rest then.
    std::function<void(const std::string&)> write_mesh;
    std::string pair_type = "cyclic";  ///< of its patches that are called cyclic*
};

/// GoogleTest's own main does not know MPI, which the case asks for the number of its ranks.
class MpiSession : public testing::Environment {
public:
    void SetUp() override
    {
        setenv("FOAM_SIGFPE", "false", 0);  // as the program does
        int there = 0;
        MPI_Initialized(&there);  // by the main function of tests on several ranks
        if (there) return;
        MPI_Init(nullptr, nullptr);
        started_here_ = true;
    }
    void TearDown() override
    {
        if (started_here_) MPI_Finalize();
    }

private:
    bool started_here_ = false;
};

inline testing::Environment* const mpi_session = testing::AddGlobalTestEnvironment(new MpiSession);

/// Where gravity is zero, p and p_rgh are the same.
class GasCase {
public:
    /// All of the mesh on this rank.
    explicit GasCase(const Scene& scene) : scene_(scene), start_folder_(std::filesystem::current_path())
    {
        folder_ = test::new_folder().string();
        write_case();
        make_mesh();
        open();
    }

    /// A part of the mesh on each rank of several: cell by cell the rank that has it, in blockMesh's order. Collective,
    /// as the members are then.
    GasCase(const Scene& scene, const std::vector<int>& rank_of_cell)
        : scene_(scene), start_folder_(std::filesystem::current_path()), shared_(true)
    {
        int rank = 0, ranks = 1;
        MPI_Comm_rank(MPI_COMM_WORLD, &rank);
        MPI_Comm_size(MPI_COMM_WORLD, &ranks);
        if (rank == 0) {
            folder_ = test::new_folder().string();
            write_case();
            write("system/decomposeParDict", "dictionary",
                  "numberOfSubdomains " + std::to_string(ranks) +
                      "; method manual; manualCoeffs { dataFile \"rankOfCell\"; }");
            std::string list;
            for (const int owner : rank_of_cell)
                list += std::to_string(owner) + " ";
            write("constant/rankOfCell", "labelList", "(" + list + ")");
            make_mesh();
            execute("decomposePar");
        }
        int length = static_cast<int>(folder_.size());
        MPI_Bcast(&length, 1, MPI_INT, 0, MPI_COMM_WORLD);
        folder_.resize(static_cast<std::size_t>(length));
        MPI_Bcast(folder_.data(), length, MPI_CHAR, 0, MPI_COMM_WORLD);
        arguments_.emplace_back("-parallel");
        open();
    }

    ~GasCase()
    {
        gas_.reset();
        foam_.reset();
        std::filesystem::current_path(start_folder_);
        int rank = 0;
        if (shared_) MPI_Barrier(MPI_COMM_WORLD);
        if (shared_) MPI_Comm_rank(MPI_COMM_WORLD, &rank);
        std::error_code ignored;
        if (rank == 0) std::filesystem::remove_all(folder_, ignored);
    }

    GasCase(const GasCase&) = delete;
    GasCase& operator=(const GasCase&) = delete;

    std::size_t cells() const { return gas_->mesh().size(); }
    const Vector& centre(std::size_t c) const { return gas_->mesh().centre[c]; }
    double volume(std::size_t c) const { return gas_->mesh().volume[c]; }
    const MeshView& mesh() const { return gas_->mesh(); }
    double time() const { return foam_->time(); }

    /// [n] and [n x 3] values of the cells.
    Scalars sampled(const ScalarField& field) const
    {
        Scalars values;
        for (const Vector& x : gas_->mesh().centre)
            values.push_back(field(x));
        return values;
    }
    Scalars sampled(const VectorField& field) const
    {
        Scalars values;
        for (const Vector& x : gas_->mesh().centre) {
            const Vector v = field(x);
            values.insert(values.end(), v.data(), v.data() + 3);
        }
        return values;
    }

    /// One gas step under a voidage that is given at its end. `rate` [kg/(m3 s)], `source` [N/m3]. What solids of their
    /// own motion would push out is the change of the voidage, of the order of the time scheme.
    void step(const Scalars& voidage, const Scalars& rate, const Scalars& source)
    {
        if (!scene_.functions.empty()) foam_->running();
        foam_->advance_time(scene_.gas_step);
        Demand demand(cells());
        demand.rate = rate;
        demand.source = source;
        voidages_.push_back(voidage);
        const std::size_t n = voidages_.size() - 1;
        demand.gas_share = voidages_[n > 0 ? n - 1 : 0];
        for (std::size_t c = 0; c < cells() && n > 0; ++c) {
            const double change = voidage[c] - voidages_[n - 1][c];
            const double change_before = n > 1 ? voidages_[n - 1][c] - voidages_[n - 2][c] : change;
            const bool second_order = scene_.time_scheme == "backward" && n > 1;
            demand.surplus[c] = -(second_order ? 1.5 * change - 0.5 * change_before : change) / scene_.gas_step;
        }
        gas_->set_voidage(voidage);
        foam_->with_own_errors([&] { gas_->solve(scene_.gas_step, demand); });
        if (const auto trouble = gas_->trouble()) throw UserError(*trouble);
    }

    Vector velocity(std::size_t c) const
    {
        const Scalars all = gas_->velocity();
        return {all[3 * c], all[3 * c + 1], all[3 * c + 2]};
    }
    Scalars velocities() const { return gas_->velocity(); }
    Scalars pressure_gradients() const { return gas_->pressure_gradient(); }
    Scalars velocity_gradients() const { return gas_->velocity_gradient(); }
    Scalars viscous_forces() const { return gas_->viscous_force(); }
    Scalars gradient(const Scalars& of_cells) const { return gas_->gradient(of_cells); }
    Scalars stretching(const Scalars& flow) const { return gas_->stretching(flow); }
    Scalars outflows() const { return gas_->outflow(); }
    Crossing crossing() const { return gas_->crossing(); }
    const CellLocator& locator() const { return gas_->locator(); }
    const Scalars& volumes() const { return gas_->mesh().volume; }
    double pressure(std::size_t c) const { return gas_->pressure_at(centre(c)); }

    /// The numbers of the last line that a function object wrote to postProcessing/`file`, the time first.
    std::vector<double> last_line(const std::string& file)
    {
        foam_->running();  // executes them for the last step
        std::ifstream in(folder_ + "/postProcessing/" + file);
        std::string line, last;
        while (std::getline(in, line))
            if (!line.empty() && line[0] != '#') last = line;
        for (char& c : last)
            if (c == '(' || c == ')') c = ' ';
        std::istringstream numbers(last);
        std::vector<double> found;
        for (std::string word; numbers >> word;) {
            char* end = nullptr;
            const double number = std::strtod(word.c_str(), &end);
            if (*end == '\0') found.push_back(number);
        }
        return found;
    }

private:
    void make_mesh() const
    {
        if (scene_.write_mesh)
            scene_.write_mesh(folder_ + "/constant/polyMesh");
        else
            execute("blockMesh");
    }

    void execute(const std::string& program) const
    {
        const std::string log = folder_ + "/log." + program;
        if (std::system((program + " -case " + folder_ + " > " + log + " 2>&1").c_str()) != 0)
            throw std::runtime_error(program + " failed, see " + log);
    }

    void open()
    {
        arguments_[2] = folder_;
        for (std::string& argument : arguments_)
            argument_pointers_.push_back(argument.data());
        argument_pointers_.push_back(nullptr);
        argument_count_ = static_cast<int>(arguments_.size());
        argument_list_ = argument_pointers_.data();
        foam_ = std::make_unique<FoamCase>(argument_count_, argument_list_);
        Settings settings;
        settings.gas = GasModel::pimple;
        gas_ = foam_->make_gas(settings);
    }

    void write_case() const
    {
        namespace fs = std::filesystem;
        for (const char* part : {"0", "constant", "system"})
            fs::create_directories(fs::path(folder_) / part);
        write("system/controlDict", "dictionary",
              "application interphase; startFrom startTime; startTime 0; stopAt endTime; endTime 1e9; deltaT " +
                  number(scene_.gas_step) +
                  "; writeControl timeStep; writeInterval 1000000000; timeFormat general; timePrecision 12; "
                  "writePrecision 16; functions { " +
                  scene_.functions + " }");
        write("system/couplingDict", "dictionary", "");
        write("system/fvSchemes", "dictionary",
              "ddtSchemes { default " + scene_.time_scheme +
                  "; } gradSchemes { default Gauss linear; } divSchemes { default Gauss linear; } "
                  "laplacianSchemes { default Gauss linear corrected; } interpolationSchemes { default linear; } "
                  "snGradSchemes { default corrected; }");
        const std::string tolerance = number(scene_.pressure_tolerance);
        write("system/fvSolution", "dictionary",
              "solvers { \"p_rgh.*\" { solver PCG; preconditioner DIC; tolerance " + tolerance +
                  "; relTol 0; minIter " + std::to_string(scene_.pressure_iterations) +
                  "; } \"U.*\" { solver smoothSolver; smoother symGaussSeidel; tolerance 1e-14; "
                  "relTol 0; } }\n"
                  "PIMPLE { nOuterCorrectors " +
                  std::to_string(scene_.outer_correctors) + "; nCorrectors " + std::to_string(scene_.correctors) +
                  "; p_rghRefCell 0; p_rghRefValue 0; }");
        write("constant/transportProperties", "dictionary",
              "rho " + number(scene_.density) + "; mu " + number(scene_.viscosity) + ";");
        write("constant/g", "uniformDimensionedVectorField",
              "dimensions [0 1 -2 0 0 0 0]; value " + number(scene_.gravity) + ";");
        write("system/blockMeshDict", "dictionary", mesh_description());
        write("0/U", "volVectorField",
              "dimensions [0 1 -1 0 0 0 0]; internalField " + initial_velocity() + "; boundaryField { " +
                  conditions(&Sides::velocity) + "}");
        write("0/p_rgh", "volScalarField",
              "dimensions [1 -1 -2 0 0 0 0]; internalField uniform 0; boundaryField { " + conditions(&Sides::pressure) +
                  "}");
        if (!scene_.flux.empty()) write("0/phi", "surfaceScalarField", "dimensions [0 3 -1 0 0 0 0]; " + scene_.flux);
    }

    void write(const std::string& file, const std::string& type, const std::string& content) const
    {
        std::ofstream out(folder_ + "/" + file);
        out << "FoamFile { version 2.0; format ascii; class " << type << "; object "
            << std::filesystem::path(file).filename().string() << "; }\n"
            << content << "\n";
    }

    static std::string number(double value)
    {
        char text[40];
        std::snprintf(text, sizeof text, "%.17g", value);
        return text;
    }

    static std::string number(const Vector& v)
    {
        return "(" + number(v.x()) + " " + number(v.y()) + " " + number(v.z()) + ")";
    }

    /// blockMesh numbers a block's cells along x first, then y, then z.
    std::string initial_velocity() const
    {
        std::string list = "nonuniform List<vector> (";
        const auto& n = scene_.cells;
        if (scene_.write_mesh) return "uniform (0 0 0)";
        for (int k = 0; k < n[2]; ++k)
            for (int j = 0; j < n[1]; ++j)
                for (int i = 0; i < n[0]; ++i) {
                    const Vector share((i + 0.5) / n[0], (j + 0.5) / n[1], (k + 0.5) / n[2]);
                    list += number(scene_.velocity(share.cwiseProduct(scene_.size))) + "\n";
                }
        return list + ")";
    }

    static std::string side_name(int axis, int side)
    {
        return std::string("xyz").substr(axis, 1) + (side ? "High" : "Low");
    }

    std::string conditions(std::array<std::string, 2> Sides::*which) const
    {
        if (scene_.write_mesh) return "\"cyclic.*\" { type " + scene_.pair_type + "; } sides { type zeroGradient; } ";
        std::string text;
        for (int axis = 0; axis < 3; ++axis)
            for (int side = 0; side < 2; ++side) {
                const std::string& own = (scene_.sides[axis].*which)[side];
                text += side_name(axis, side) + " { " + (own.empty() ? "type " + scene_.sides[axis].type + ";" : own) +
                        " } ";
            }
        return text;
    }

    std::string mesh_description() const
    {
        static const char* const faces[3][2] = {
            {"(0 4 7 3)", "(1 2 6 5)"}, {"(0 1 5 4)", "(3 7 6 2)"}, {"(0 3 2 1)", "(4 5 6 7)"}};
        std::string text = "scale 1; vertices (";
        for (const Vector& corner : {Vector(0, 0, 0), Vector(1, 0, 0), Vector(1, 1, 0), Vector(0, 1, 0),
                                     Vector(0, 0, 1), Vector(1, 0, 1), Vector(1, 1, 1), Vector(0, 1, 1)})
            text += number(Vector(corner.cwiseProduct(scene_.size)));
        text += "); edges (); blocks ( hex (0 1 2 3 4 5 6 7) (" + std::to_string(scene_.cells[0]) + " " +
                std::to_string(scene_.cells[1]) + " " + std::to_string(scene_.cells[2]) +
                ") simpleGrading (1 1 1) ); boundary (";
        for (int axis = 0; axis < 3; ++axis)
            for (int side = 0; side < 2; ++side) {
                text += side_name(axis, side) + " { type " + scene_.sides[axis].type + "; ";
                if (scene_.sides[axis].type == "cyclic") text += "neighbourPatch " + side_name(axis, 1 - side) + "; ";
                text += std::string("faces (") + faces[axis][side] + "); } ";
            }
        return text + ");";
    }

    Scene scene_;
    std::string folder_;
    std::filesystem::path start_folder_;
    bool shared_ = false;  ///< whether the folder is that of all ranks
    std::vector<std::string> arguments_{"gas_case", "-case", ""};
    std::vector<char*> argument_pointers_;
    int argument_count_ = 0;
    char** argument_list_ = nullptr;
    std::unique_ptr<FoamCase> foam_;
    std::unique_ptr<CaseGas> gas_;
    std::vector<Scalars> voidages_;  ///< step by step
};

/// The orders between neighbours in a series of errors whose step halves from each to the next.
inline std::vector<double> observed_orders(const std::vector<double>& errors)
{
    std::vector<double> orders;
    for (std::size_t i = 1; i < errors.size(); ++i)
        orders.push_back(std::log2(errors[i - 1] / errors[i]));
    return orders;
}

}  // namespace interphase::testing_gas
