// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/openfoam/foam_case.hpp"

#include <mpi.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>

#include "IFstream.H"
#include "OSspecific.H"
#include "Time.H"
#include "argList.H"
#include "base/text.hpp"
#include "base/user_error.hpp"
#include "engines/openfoam/decomposition.hpp"
#include "engines/openfoam/foam_dictionary.hpp"
#include "engines/openfoam/foam_errors.hpp"
#include "engines/openfoam/frozen_gas.hpp"
#include "engines/openfoam/function_objects.hpp"
#include "engines/openfoam/gas_state.hpp"
#include "engines/openfoam/listening_output.hpp"
#include "engines/openfoam/patch_conditions.hpp"
#include "engines/openfoam/pimple_gas.hpp"
#include "engines/openfoam/resumed_functions.hpp"
#include "engines/openfoam/unsolved_files.hpp"
#include "error.H"
#include "foamVersion.H"
#include "records/earlier_records.hpp"

namespace interphase {

namespace {

/// What OpenFOAM prints on the first rank goes to a file, behind what it holds where a run goes on: the terminal is for
/// the run's progress. Warnings are heard on all.
class OutputToLog {
public:
    OutputToLog(bool first_rank, bool goes_on) : console_(std::cout.rdbuf())
    {
        if (first_rank) file_.open(warnings_.log(), goes_on ? std::ios::app : std::ios::trunc);
        output_.emplace(first_rank ? file_.rdbuf() : nullptr, warnings_);
        std::cout.rdbuf(&*output_);
    }
    ~OutputToLog() { std::cout.rdbuf(console_); }

    void flush() { file_.flush(); }

    EngineWarnings& warnings()
    {
        output_->finish_warning();
        return warnings_;
    }

private:
    EngineWarnings warnings_{"OpenFOAM", "log.openfoam"};
    std::ofstream file_;
    std::optional<ListeningOutput> output_;
    std::streambuf* console_;
};

std::filesystem::path case_folder(int argc, char** argv)
{
    for (int i = 1; i + 1 < argc; ++i)
        if (std::string(argv[i]) == "-case") return argv[i + 1];
    return ".";
}

void refuse_folder_without_case(const std::filesystem::path& folder)
{
    for (const char* needed : {"system/controlDict", "system/couplingDict"})
        if (!std::filesystem::is_regular_file(folder / needed))
            throw UserError("`" + folder.string() + "` is not a case: it has no " + needed,
                            "the option -case (the current folder where it is not given)",
                            "name a case folder; cases/ holds examples, tools/run prepares one");
}

/// OpenFOAM strips what it does not bear in a name, and may so come to another folder. Links are not followed: a link
/// without such letters is a way.
void refuse_path_that_openfoam_cuts(const std::filesystem::path& folder)
{
    const std::string path = std::filesystem::absolute(folder).lexically_normal().string();
    const auto unfit = path.find_first_of(" \t\n\"';{}$\\");
    if (unfit == std::string::npos) return;
    throw UserError(
        "OpenFOAM bears no `" + path.substr(unfit, 1) + "` in a path, and would open another folder",
        "the case's folder, " + path,
        "rename it, or make a link to it, elsewhere and without such letters (ln -s), and name that by -case");
}

/// What a run writes in folders of the case is told where it is written.
void refuse_read_only_case(const std::filesystem::path& folder)
{
    for (const char* written : {".", "log.openfoam", "results.h5", "particles.h5", "particles.xdmf"}) {
        if (access((folder / written).c_str(), W_OK) == 0 || errno == ENOENT) continue;
        throw UserError("the run cannot write into the case: " + std::string(std::strerror(errno)),
                        std::filesystem::absolute(folder / written).lexically_normal().string(),
                        "give yourself the right to write there, or run a copy of the case in a folder of your own "
                        "(tools/run makes one)");
    }
}

/// A run begins its records anew: those of an earlier one are kept unless told otherwise.
void refuse_to_overwrite(const std::filesystem::path& folder)
{
    const std::optional<std::string> earlier = earlier_records(folder);
    if (!earlier) return;
    const bool can_go_on = std::filesystem::is_directory(folder / "checkpoints");
    throw UserError("the folder holds the records of an earlier run, which this one would replace: " + *earlier,
                    std::filesystem::absolute(folder).lexically_normal().string(),
                    std::string(can_go_on ? "-resume goes on from its last checkpoint; or " : "") +
                        "move them away, or start in another copy of the case (tools/run CASE --out DIR makes one); "
                        "-overwrite replaces them");
}

/// A file of the case, from its folder on, that holds a dictionary; an empty one where there is no such file.
class DictionaryFile {
public:
    DictionaryFile(const Foam::fileName& folder, const std::string& file)
        : dict_(parsed(folder / file)), adapted_(dict_, file)
    {}

    const Dictionary& adapted() const { return adapted_; }

private:
    static Foam::dictionary parsed(const Foam::fileName& file)
    {
        if (!Foam::isFile(file)) return {};
        Foam::IFstream stream(file);
        return Foam::dictionary(stream);
    }

    const Foam::dictionary dict_;
    const FoamDictionary adapted_;
};

}  // namespace

struct FoamCase::Parts {
    // An argList takes the whole process with it when it goes, and with exit code 0, whatever went wrong: left alive.
    ~Parts() { static_cast<void>(args.release()); }

    std::unique_ptr<Foam::argList> args;
    std::optional<OutputToLog> output;
    std::unique_ptr<Foam::Time> time;
    std::unique_ptr<DictionaryFile> coupling, scene;
    std::unique_ptr<Foam::fvMesh> mesh;
};

FoamCase::FoamCase(int& argc, char**& argv) : parts_(std::make_unique<Parts>())
{
    int ranks = 1;
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    const auto given = [&](const char* option) {
        return std::any_of(argv + 1, argv + argc, [option](const char* a) { return std::string(a) == option; });
    };
    Foam::argList::addBoolOption("overwrite", "Replace the records of an earlier run in the case's folder");
    Foam::argList::addBoolOption("resume", "Go on from the newest whole checkpoint of the case");
    Foam::argList::addOption("wallLimit", "seconds", "End, with a checkpoint, before the run has taken so long");
    if (given("-help")) {
        Foam::argList::addNote("`interphase -help keys` lists the keys of system/couplingDict.");
        Foam::argList(argc, argv);  // shows it and exits
    }
    const auto folder = case_folder(argc, argv);
    refuse_folder_without_case(folder);
    refuse_path_that_openfoam_cuts(folder);
    refuse_read_only_case(folder);
    if (!given("-overwrite") && !given("-resume")) refuse_to_overwrite(folder);
    refuse_wrong_decomposition(folder);
    if (ranks > 1 && !given("-parallel"))
        throw UserError("the run has " + std::to_string(ranks) + " ranks, and no option -parallel", "the command line",
                        "add -parallel");
    if (ranks == 1 && given("-parallel"))
        throw UserError("the option -parallel, and one rank only", "the command line",
                        "leave -parallel away, or start more ranks: mpirun -np N (srun -n N) before the program");

    setenv("PWD", std::filesystem::current_path().c_str(),
           1);  // OpenFOAM complains of a launcher that left an older one
    Foam::argList::noBanner();
    // What it refuses it says itself, and ends all ranks: an exception would come from one rank and leave the others
    // waiting.
    parts_->args = std::make_unique<Foam::argList>(argc, argv);
    Foam::FatalError.throwExceptions();
    Foam::FatalIOError.throwExceptions();
    std::filesystem::current_path(std::string(parts_->args->globalPath()));
    parts_->output.emplace(Foam::UPstream::master(), options().resumes);
    with_foam_errors([this] {
        const Foam::fileName root = parts_->args->globalPath();
        parts_->time = std::make_unique<Foam::Time>(Foam::Time::controlDictName, *parts_->args);
        parts_->coupling = std::make_unique<DictionaryFile>(root, "system/couplingDict");
        parts_->scene = std::make_unique<DictionaryFile>(root, "parameters");
    });
}

FoamCase::~FoamCase() { parts_->output->flush(); }

const Dictionary& FoamCase::coupling_dict() const { return parts_->coupling->adapted(); }
const Dictionary& FoamCase::scene_parameters() const { return parts_->scene->adapted(); }

std::unique_ptr<CaseGas> FoamCase::make_gas(const Settings& settings)
{
    std::unique_ptr<CaseGas> gas;
    with_foam_errors([&] {
        refuse_what_is_not_solved(parts_->time->globalPath());
        parts_->mesh = std::make_unique<Foam::fvMesh>(Foam::IOobject(
            Foam::fvMesh::defaultRegion, parts_->time->timeName(), *parts_->time, Foam::IOobject::MUST_READ));
        if (settings.gas == GasModel::pimple)
            gas = std::make_unique<PimpleGas>(*parts_->mesh);
        else
            gas = std::make_unique<FrozenGas>(*parts_->mesh);
        refuse_unfit_conditions(*parts_->mesh);
    });
    return gas;
}

std::string FoamCase::name() const { return parts_->args->globalPath().name(); }

RunOptions FoamCase::options() const
{
    RunOptions options;
    options.resumes = parts_->args->found("resume");
    options.overwrites = parts_->args->found("overwrite");
    if (!parts_->args->found("wallLimit")) return options;
    with_foam_errors([&] { options.wall_limit = parts_->args->get<Foam::scalar>("wallLimit"); });
    if (!(options.wall_limit > 0))
        throw UserError("-wallLimit " + std::to_string(options.wall_limit) + " leaves no time", "the command line",
                        "give the seconds that the run may take, above 0");
    return options;
}

std::string FoamCase::version() { return std::to_string(OPENFOAM); }

double FoamCase::time() const { return parts_->time->value(); }
double FoamCase::end_time() const { return parts_->time->endTime().value(); }
double FoamCase::gas_step() const { return parts_->time->controlDict().get<Foam::scalar>("deltaT"); }

bool FoamCase::adjusts_gas_step() const
{
    return parts_->time->controlDict().getOrDefault<Foam::Switch>("adjustTimeStep", false);
}

double FoamCase::largest_courant_number() const
{
    return parts_->time->controlDict().getOrDefault<Foam::scalar>("maxCo", 1);
}

double FoamCase::largest_gas_step() const
{
    return parts_->time->controlDict().getOrDefault<Foam::scalar>("maxDeltaT", Foam::GREAT);
}

bool FoamCase::running()
{
    bool more = false;
    with_foam_errors([&] { more = run_with_function_objects(*parts_->time, options().resumes); },
                     [&](const std::string& message) { return failing_function(*parts_->time, message); });
    return more;
}

void FoamCase::advance_time(double step)
{
    parts_->time->setDeltaT(step, false);
    with_foam_errors([&] { ++(*parts_->time); });
}

void FoamCase::stop() { parts_->time->setEndTime(parts_->time->value()); }

bool FoamCase::write_due() const { return parts_->time->writeTime(); }

void FoamCase::write()
{
    with_foam_errors([&] { parts_->time->writeNow(); });
    parts_->output->flush();
}

void FoamCase::keep(Archive& archive)
{
    keep_time(archive, *parts_->time);
    archive.keep("warnings", parts_->output->warnings());
}

std::vector<Problem> FoamCase::go_on()
{
    start_here(*parts_->time);
    std::vector<Problem> told;
    if (!Foam::Pstream::master()) return told;
    if (parts_->mesh)
        for (const std::string& condition : conditions_not_kept(*parts_->mesh))
            told.push_back({condition + ": its random numbers begin anew at t = " + text(time()) +
                                " s, a checkpoint does not hold them",
                            "the boundary conditions", "none is needed where they have no memory of long ago"});
    try {
        const std::string aside = put_later_output_aside(*parts_->time);
        if (!aside.empty())
            told.push_back({"what function objects wrote from t = " + text(time()) + " s on is in " + aside + "/",
                            "postProcessing/", "none is needed: the run makes it again"});
    } catch (const std::exception& error) {
        throw UserError("what function objects wrote cannot be put aside: " + std::string(error.what()),
                        "postProcessing/", "give the right to write there, or move it away");
    }
    return told;
}

std::string FoamCase::sums_lost() const { return functions_with_sums(*parts_->time); }

EngineWarnings* FoamCase::warnings() { return &parts_->output->warnings(); }

void FoamCase::with_own_errors(const std::function<void()>& body) const
{
    with_foam_errors(body, [this](const std::string& message) {
        return parts_->mesh ? failing_condition(*parts_->mesh, message) : std::string();
    });
}

}  // namespace interphase
