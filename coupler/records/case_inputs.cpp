// SPDX-License-Identifier: GPL-3.0-or-later
#include "records/case_inputs.hpp"

#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <system_error>

#include "base/sha256.hpp"

namespace interphase {

namespace {

namespace fs = std::filesystem;
using Variables = std::vector<std::pair<std::string, std::string>>;

std::string whole(const fs::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

void replace_all(std::string& text, const std::string& what, const std::string& by)
{
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
        text.replace(at, what.size(), by);
}

std::string stripped(std::string word)
{
    while (!word.empty() && (word.front() == '"' || word.front() == '\''))
        word.erase(0, 1);
    while (!word.empty() && (word.back() == '"' || word.back() == '\'' || word.back() == ';'))
        word.pop_back();
    return word;
}

/// Collects the files of one case.
class Inputs {
public:
    Inputs(const fs::path& case_folder, Variables variables)
        : root_(fs::weakly_canonical(case_folder)), variables_(std::move(variables))
    {}

    void add_folder(const std::string& name)
    {
        std::error_code none;
        const fs::path folder = root_ / name;
        if (!fs::is_directory(folder, none)) return;
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder, none))
            if (entry.is_regular_file(none)) add_dictionary(entry.path());
    }

    /// A script of LIGGGHTS and, from there on, what it reads. Its paths start at the case folder.
    void add_script(const fs::path& file)
    {
        if (!add(file)) return;
        std::istringstream lines(whole(file));
        for (std::string line; std::getline(lines, line);) {
            std::istringstream stream(line.substr(0, line.find('#')));
            const std::vector<std::string> words{std::istream_iterator<std::string>(stream), {}};
            for (std::size_t i = 0; i + 1 < words.size(); ++i)
                if (reads(words, i)) add_script(root_ / with_values(stripped(words[i + 1])));
        }
    }

    std::vector<InputFile> found() const
    {
        std::vector<InputFile> all;
        all.reserve(files_.size());
        for (const std::string& path : files_)
            all.push_back(described(path));
        return all;
    }

private:
    /// A file in OpenFOAM's syntax and what it includes: paths start at its folder, or with $FOAM_CASE.
    void add_dictionary(const fs::path& file)
    {
        if (!add(file)) return;
        std::istringstream lines(whole(file));
        for (std::string line; std::getline(lines, line);) {
            std::istringstream words(line);
            std::string first, name;
            if (!(words >> first >> name) || first.rfind("#include", 0) != 0) continue;
            name = stripped(name);
            for (const char* here : {"$FOAM_CASE", "${FOAM_CASE}", "<case>"})
                replace_all(name, here, root_.string());
            add_dictionary(file.parent_path() / name);
        }
    }

    /// Whether the file is one of the case, not yet known, and a text to look into.
    bool add(const fs::path& file)
    {
        std::error_code none;
        const fs::path inside = fs::weakly_canonical(file, none).lexically_relative(root_);
        if (inside.empty() || *inside.begin() == ".." || !fs::is_regular_file(root_ / inside, none)) return false;
        return files_.insert(inside.generic_string()).second && fs::file_size(root_ / inside, none) <= longest_kept;
    }

    static bool reads(const std::vector<std::string>& words, std::size_t i)
    {
        static const std::set<std::string> commands{"include", "jump", "read_data", "read_restart", "molecule"};
        if (i == 0) return commands.count(words[0]) > 0;
        // fix ID group mesh/surface file NAME ...
        return words[0] == "fix" && i > 3 && words[i] == "file" && words[3].rfind("mesh/", 0) == 0;
    }

    std::string with_values(std::string name) const
    {
        for (const auto& [variable, value] : variables_)
            replace_all(name, "${" + variable + "}", value);
        return name;
    }

    InputFile described(const std::string& path) const
    {
        InputFile file;
        file.path = path;
        file.bytes = fs::file_size(root_ / path);
        std::ifstream stream(root_ / path, std::ios::binary);
        if (!stream) return file;  // one that may not be read
        if (file.bytes <= longest_kept) {
            const std::string text = whole(root_ / path);
            if (text.find('\0') == std::string::npos) file.text = text;
        }
        if (file.bytes <= longest_hashed) file.sha256 = sha256(stream);
        return file;
    }

    fs::path root_;
    Variables variables_;
    std::set<std::string> files_;
};

}  // namespace

std::vector<InputFile> case_inputs(const std::filesystem::path& case_folder, const std::string& script,
                                   const std::vector<std::pair<std::string, std::string>>& variables)
{
    Inputs inputs(case_folder, variables);
    for (const char* folder : {"0", "constant", "system"})
        inputs.add_folder(folder);
    inputs.add_script(case_folder / script);
    return inputs.found();
}

}  // namespace interphase
