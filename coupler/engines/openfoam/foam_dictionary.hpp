// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>

#include "dictionary.H"
#include "settings/dictionary.hpp"

namespace interphase {

/// A dictionary of OpenFOAM, which has to outlive this. `FoamFile`, the header of a file, is none of its keys.
class FoamDictionary : public Dictionary {
public:
    /// `path`: how a user finds it, the file and the blocks in it.
    FoamDictionary(const Foam::dictionary& dict, std::string path) : dict_(dict), path_(std::move(path)) {}

    std::vector<std::string> keys() const override;
    bool has(const std::string& key) const override;
    std::optional<double> number(const std::string& key) const override;
    std::optional<std::string> text(const std::string& key) const override;
    std::optional<std::vector<std::string>> names(const std::string& key) const override;
    std::optional<std::vector<std::string>> texts(const std::string& key) const override;
    std::optional<Scalars> numbers(const std::string& key) const override;
    std::optional<std::vector<Vector>> points(const std::string& key) const override;
    std::unique_ptr<Dictionary> block(const std::string& key) const override;
    std::string written(const std::string& key) const override;
    std::string place(const std::string& key) const override;

private:
    const Foam::dictionary& dict_;
    std::string path_;
};

}  // namespace interphase
