// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "Time.H"
#include "base/archive.hpp"
#include "engines/openfoam/gas_addressing.hpp"
#include "surfaceFields.H"
#include "volFields.H"

namespace interphase {

/// The fields of a gas, in and out of an archive: values in cells (faces) and on boundaries, those of the steps before
/// that a time scheme looks at, and what boundary conditions have beside their values (a gradient, a reference), as
/// they write it into a case's files.
///
/// Where the parts of the mesh are not those of the run that saved (other ranks, or other cuts), each value goes to
/// where its cell or face is now, by their numbers in the whole mesh, and the archive is told how cells have moved.
class GasState {
public:
    /// Throws a UserError where the mesh is another one, or parts are others and unnumbered. Collective.
    GasState(Archive& archive, const Foam::fvMesh& mesh, const GasAddressing& addressing);

    void keep(Foam::volScalarField& field);
    void keep(Foam::volVectorField& field);
    /// Of fluxes: what goes through a face changes its sign with the face's direction.
    void keep(Foam::surfaceScalarField& flux);

private:
    struct FaceMove {
        int from, to;
        bool turned;
    };
    /// How the part of one rank that saved lies on this one.
    struct Part {
        std::vector<int> patch_starts;
        std::vector<FaceMove> faces;                      ///< each face of this rank once, in all parts together
        std::vector<std::vector<Archive::Move>> patches;  ///< of the whole mesh, faces counted from their start
    };

    bool parts_differ();
    void find_moves();
    void find_face_moves();
    void refuse_other_mesh();
    Archive::CellMoves cell_moves() const;

    template <class FieldOfMesh>
    void keep_all(FieldOfMesh& field);
    template <class Type, template <class> class PatchField, class Mesh>
    void keep_level(Foam::GeometricField<Type, PatchField, Mesh>& field);
    template <class Type>
    void give_back(Foam::GeometricField<Type, Foam::fvPatchField, Foam::volMesh>& field);
    void give_back(Foam::surfaceScalarField& flux);
    template <class Type>
    void keep_conditions(Foam::GeometricField<Type, Foam::fvPatchField, Foam::volMesh>& field);
    void keep_conditions(Foam::surfaceScalarField&) {}
    Foam::dictionary condition(const Foam::word& field, int patch, const std::string& name) const;

    Archive& archive_;
    const Foam::fvMesh& mesh_;
    const GasAddressing& addressing_;
    bool moved_ = false;
    std::vector<Part> parts_;
};

/// The clock: time, number and length of the steps, and what was written last.
void keep_time(Archive& archive, Foam::Time& time);

}  // namespace interphase
