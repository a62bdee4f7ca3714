// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/openfoam/gas_state.hpp"

#include <algorithm>
#include <stdexcept>
#include <type_traits>
#include <unordered_map>

#include "IStringStream.H"
#include "OStringStream.H"
#include "base/user_error.hpp"
#include "engines/openfoam/inlet_random.hpp"
#include "engines/openfoam/moved_condition.hpp"

namespace interphase {

using namespace Foam;

namespace {

std::size_t at(label i) { return static_cast<std::size_t>(i); }

template <class Type>
void keep_values(Archive& archive, const std::string& name, Field<Type>& values)
{
    static_assert(std::is_same_v<Type, scalar> || std::is_same_v<Type, vector>);
    constexpr std::size_t numbers = sizeof(Type) / sizeof(double);
    archive.keep(name, values.empty() ? nullptr : reinterpret_cast<double*>(values.data()),
                 numbers * at(values.size()));
}

std::string patch_name(label patch) { return "patch " + std::to_string(patch); }
std::string condition_name(label patch) { return "condition " + std::to_string(patch); }

template <class Type>
std::string written(const fvPatchField<Type>& condition)
{
    OStringStream stream;
    stream.precision(17);  // a double comes back as it was
    stream << condition;
    return stream.str();
}

dictionary read(const std::string& text)
{
    IStringStream stream(text);
    return dictionary(stream);
}

UserError other_mesh(const std::string& how)
{
    return UserError("the gas mesh is not that of the checkpoint: " + how, "constant/polyMesh",
                     "put that mesh back, or start anew, without -resume");
}

/// What OpenFOAM gives nobody to set.
struct OpenTime : Foam::Time {
    static void keep(Archive& archive, Foam::Time& time)
    {
        archive.keep("write_index", time.*(&OpenTime::writeTimeIndex_));
        archive.keep("start", time.*(&OpenTime::startTime_));
        archive.keep("step", time.*(&OpenTime::deltaT_));
        archive.keep("step_before", time.*(&OpenTime::deltaT0_));
        archive.keep("step_saved", time.*(&OpenTime::deltaTSave_));
    }
};

}  // namespace

GasState::GasState(Archive& archive, const fvMesh& mesh, const GasAddressing& addressing)
    : archive_(archive), mesh_(mesh), addressing_(addressing)
{
    bool numbered = addressing_.known();
    std::vector<int> cells = addressing_.cells(), faces = addressing_.faces(), starts = addressing_.patch_starts();
    int patches = addressing_.patches();
    archive_.keep("numbered", numbered);
    archive_.keep("patches", patches);
    if (patches != addressing_.patches())
        throw other_mesh(std::to_string(addressing_.patches()) + " patches, and " + std::to_string(patches) + " then");
    if (!archive_.loads()) {
        archive_.keep("cells", cells);
        archive_.keep("faces", faces);
        archive_.keep("patch_starts", starts);
    } else if (!archive_.same_ranks() || (numbered && addressing_.known() && parts_differ())) {
        if (!numbered || !addressing_.known())
            throw UserError(
                std::string("the parts of the mesh ") + (numbered ? "now" : "then") +
                    " do not say which cells of the whole mesh they have, and the ranks are others than "
                    "those of the checkpoint",
                "cellProcAddressing and faceProcAddressing in processor*/constant/polyMesh",
                "let decomposePar make the parts, or go on with " + std::to_string(archive_.parts()) + " ranks");
        moved_ = true;
        find_moves();
    }
    refuse_other_mesh();
}

bool GasState::parts_differ()
{
    std::vector<int> cells, faces;
    archive_.keep("cells", cells);
    archive_.keep("faces", faces);
    return returnReduce(cells != addressing_.cells() || faces != addressing_.faces(), orOp<bool>());
}

void GasState::find_moves()
{
    archive_.move_cells(cell_moves());
    find_face_moves();
}

Archive::CellMoves GasState::cell_moves() const
{
    Archive::CellMoves moves;
    moves.numbers = "cells";
    moves.own = addressing_.cells();
    std::unordered_map<int, int> here;
    for (std::size_t c = 0; c < moves.own.size(); ++c)
        here[moves.own[c]] = static_cast<int>(c);
    std::size_t found = 0, then = 0;
    for (int part = 0; part < archive_.parts(); ++part) {
        const std::vector<int> numbers = archive_.part_as<int>(part, "cells");
        moves.cells.push_back(numbers.size());
        moves.from.emplace_back();
        then += numbers.size();
        for (std::size_t c = 0; c < numbers.size(); ++c) {
            const auto own = here.find(numbers[c]);
            if (own == here.end()) continue;
            moves.from.back().push_back({static_cast<int>(c), own->second});
            here.erase(own);
            ++found;
        }
    }
    const label now = returnReduce(static_cast<label>(moves.own.size()), sumOp<label>());
    const label known = returnReduce(static_cast<label>(found), sumOp<label>());
    if (static_cast<std::size_t>(now) != then || now != known)
        throw other_mesh(std::to_string(now) + " cells, of which " + std::to_string(known) + " are among its " +
                         std::to_string(then));
    return moves;
}

void GasState::find_face_moves()
{
    std::unordered_map<int, int> here;
    const std::vector<int>& own = addressing_.faces();
    for (std::size_t f = 0; f < own.size(); ++f)
        here[std::abs(own[f])] = static_cast<int>(f);
    // of a face between two parts, which both have it, the value of the one to which it is not turned
    struct Source {
        std::size_t part;
        int face;
        bool turned;
    };
    std::vector<Source> sources(own.size(), {0, -1, false});
    for (int part = 0; part < archive_.parts(); ++part) {
        parts_.emplace_back();
        parts_.back().patch_starts = archive_.part_as<int>(part, "patch_starts");
        const std::vector<int> faces = archive_.part_as<int>(part, "faces");
        for (std::size_t f = 0; f < faces.size(); ++f) {
            const auto there = here.find(std::abs(faces[f]));
            if (there == here.end()) continue;
            Source& source = sources[at(there->second)];
            if (source.face < 0 || faces[f] > 0) source = {at(part), static_cast<int>(f), faces[f] < 0};
        }
    }
    const std::vector<int>& starts = addressing_.patch_starts();
    for (Part& part : parts_)
        part.patches.resize(at(addressing_.patches()));
    label nowhere = 0;
    for (std::size_t f = 0; f < sources.size(); ++f) {
        const Source& source = sources[f];
        if (source.face < 0) {
            ++nowhere;
            continue;
        }
        Part& part = parts_[source.part];
        const int to = static_cast<int>(f);
        part.faces.push_back({source.face, to, source.turned != (own[f] < 0)});
        const auto patch = std::upper_bound(starts.begin(), starts.end() - 1, to) - starts.begin() - 1;
        if (patch < 0 || patch >= addressing_.patches()) continue;
        const int from = source.face - part.patch_starts[at(patch)];
        // of a cyclic pair between two parts, OpenFOAM puts the faces into a patch of the cut
        if (from >= 0 && source.face < part.patch_starts[at(patch) + 1])
            part.patches[at(patch)].push_back({from, to - starts[at(patch)]});
        else if (!mesh_.boundary()[patch].coupled())
            ++nowhere;
    }
    if (const label all = returnReduce(nowhere, sumOp<label>()); all > 0)
        throw other_mesh(std::to_string(all) + " of its faces are not where they were");
}

/// As many cells are not the same ones.
void GasState::refuse_other_mesh()
{
    std::vector<double> centres;
    for (const vector& centre : mesh_.C().primitiveField())
        centres.insert(centres.end(), {centre.x(), centre.y(), centre.z()});
    std::vector<double> then = centres;
    archive_.keep_cells("centres", then);
    if (!archive_.loads()) return;
    bool same = then.size() == centres.size();
    const double round_off = 1e-9 * mesh_.bounds().mag();
    for (std::size_t i = 0; same && i < centres.size(); ++i)
        same = std::abs(then[i] - centres[i]) < round_off;
    if (returnReduce(!same, orOp<bool>())) throw other_mesh("cells have other places");
}

template <class Type, template <class> class PatchField, class Mesh>
void GasState::keep_level(GeometricField<Type, PatchField, Mesh>& field)
{
    if (moved_) return give_back(field);
    keep_values(archive_, "cells", static_cast<Field<Type>&>(field.primitiveFieldRef()));
    auto& boundary = field.boundaryFieldRef(false);
    forAll(boundary, patch) keep_values(archive_, patch_name(patch), static_cast<Field<Type>&>(boundary[patch]));
}

template <class Type>
void GasState::give_back(GeometricField<Type, fvPatchField, volMesh>& field)
{
    std::vector<double> cells;
    archive_.keep_cells("cells", cells);
    if (!cells.empty())
        std::copy_n(cells.data(), cells.size(), reinterpret_cast<double*>(field.primitiveFieldRef().data()));
    auto& boundary = field.boundaryFieldRef(false);
    for (label patch = 0; patch < addressing_.patches(); ++patch) {
        if (boundary[patch].coupled()) continue;
        for (int part = 0; part < archive_.parts(); ++part) {
            const std::vector<Type> there = archive_.part_as<Type>(part, patch_name(patch));
            if (there.empty() || boundary[patch].empty()) continue;  // also of patches that have no values of their own
            for (const Archive::Move& move : parts_[at(part)].patches[at(patch)])
                boundary[patch][move.to] = there[at(move.from)];
        }
    }
    const auto how = UPstream::commsTypes::nonBlocking;
    const label pending = UPstream::nRequests();
    forAll(boundary, patch) if (boundary[patch].coupled()) boundary[patch].initEvaluate(how);
    UPstream::waitRequests(pending);
    forAll(boundary, patch) if (boundary[patch].coupled()) boundary[patch].evaluate(how);
}

void GasState::give_back(surfaceScalarField& flux)
{
    scalarField& inner = flux.primitiveFieldRef();
    auto& boundary = flux.boundaryFieldRef(false);
    const auto set = [&](int face, double value) {
        if (face < inner.size()) {
            inner[face] = value;
            return;
        }
        const label patch = mesh_.boundaryMesh().whichPatch(face);
        if (!boundary[patch].empty()) boundary[patch][face - mesh_.boundaryMesh()[patch].start()] = value;
    };
    for (int n = 0; n < archive_.parts(); ++n) {
        const Part& part = parts_[at(n)];
        std::vector<double> there = archive_.part_as<double>(n, "cells");
        for (std::size_t patch = 0; patch + 1 < part.patch_starts.size(); ++patch) {
            there.resize(at(part.patch_starts[patch]), 0.0);
            const std::vector<double> more = archive_.part_as<double>(n, patch_name(static_cast<label>(patch)));
            there.insert(there.end(), more.begin(), more.end());
        }
        there.resize(at(part.patch_starts.back()), 0.0);
        for (const FaceMove& move : part.faces)
            set(move.to, move.turned ? -there[at(move.from)] : there[at(move.from)]);
    }
}

dictionary GasState::condition(const word& field, int patch, const std::string& name) const
{
    std::vector<ConditionPart> all;
    for (int n = 0; n < archive_.parts(); ++n) {
        const std::vector<char> letters = archive_.part(n, name);
        const Part& part = parts_[at(n)];
        all.push_back({read({letters.begin(), letters.end()}),
                       part.patch_starts[at(patch) + 1] - part.patch_starts[at(patch)], &part.patches[at(patch)]});
    }
    const fvPatch& own = mesh_.boundary()[patch];
    return moved_condition(all, own.size(), "the field " + std::string(field) + " on the patch " + own.name());
}

/// Conditions that the mesh itself makes have nothing but their values.
template <class Type>
void GasState::keep_conditions(GeometricField<Type, fvPatchField, volMesh>& field)
{
    auto& boundary = field.boundaryFieldRef(false);
    forAll(boundary, patch)
    {
        const fvPatch& own = mesh_.boundary()[patch];
        if (fvPatch::constraintType(own.type())) continue;
        const std::string name = condition_name(patch);
        dictionary dict;
        if (moved_)
            dict = condition(field.name(), patch, name);
        else {
            std::string text;
            if (!archive_.loads()) text = written(boundary[patch]);
            archive_.keep(name, text);
            if (archive_.loads()) dict = read(text);
        }
        if (archive_.loads()) boundary.set(patch, fvPatchField<Type>::New(own, field.internalField(), dict));
        keep_random_numbers(archive_, "random " + std::to_string(patch), boundary[patch]);
    }
}

template <class FieldOfMesh>
void GasState::keep_all(FieldOfMesh& field)
{
    archive_.within(field.name(), [&] {
        label levels = field.nOldTimes(), index = field.timeIndex();
        archive_.keep("levels", levels);
        archive_.keep("index", index);
        field.timeIndex() = field.time().timeIndex();  // nothing is shifted to the level before while it is read
        keep_conditions(field);
        keep_level(field);
        FieldOfMesh* of = &field;
        for (label level = 1; level <= levels; ++level) {
            of = &of->oldTime();
            archive_.within("level " + std::to_string(level), [&] { keep_level(*of); });
        }
        field.timeIndex() = index;
    });
}

void GasState::keep(volScalarField& field) { keep_all(field); }
void GasState::keep(volVectorField& field) { keep_all(field); }
void GasState::keep(surfaceScalarField& flux) { keep_all(flux); }

void keep_time(Archive& archive, Foam::Time& time)
{
    double now = time.value();
    label index = time.timeIndex();
    archive.keep("now", now);
    archive.keep("index", index);
    if (archive.loads()) time.setTime(now, index);
    OpenTime::keep(archive, time);
}

}  // namespace interphase
