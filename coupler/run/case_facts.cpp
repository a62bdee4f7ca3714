// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/case_facts.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>
#include <sstream>

#include "base/sha256.hpp"

namespace interphase {

namespace {

using Facts = Checkpoints::Facts;

constexpr char between_lines = '\t';        // words of a line are parted by one blank each
constexpr std::size_t longest_shown = 120;  // of a value

bool starts_with(const std::string& text, const std::string& start) { return text.rfind(start, 0) == 0; }

std::string digest(const std::string& words)
{
    std::istringstream stream(words);
    return "sha256 " + sha256(stream);
}

/// 1e-3 and 0.001 are one number.
std::string in_one_way(const std::string& word)
{
    char* end = nullptr;
    const double number = std::strtod(word.c_str(), &end);
    if (word.empty() || *end != '\0' || std::isalpha(static_cast<unsigned char>(word[0])) != 0) return word;
    char text[32];
    std::snprintf(text, sizeof text, "%.15g", number);
    return text;
}

/// The words of a text in OpenFOAM's syntax; punctuation and quoted texts are words.
class Words {
public:
    explicit Words(const std::string& text) : text_(text) {}

    /// The next one; empty at the end.
    std::string next()
    {
        pass_blanks();
        if (at_ >= text_.size()) return "";
        const std::size_t start = at_;
        if (is_punctuation(text_[at_])) return text_.substr(at_++, 1);
        if (text_[at_] == '"') {
            for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_)
                if (text_[at_] == '\\') ++at_;
            at_ = std::min(at_ + 1, text_.size());
            return text_.substr(start, at_ - start);
        }
        while (at_ < text_.size() && !is_blank(text_[at_]) && !is_punctuation(text_[at_]) && text_[at_] != '"' &&
               !comment_starts())
            ++at_;
        return in_one_way(text_.substr(start, at_ - start));
    }

    /// Those that are left in this line, of `#include "file"`.
    std::string rest_of_line()
    {
        const std::size_t end = std::min(text_.find('\n', at_), text_.size());
        Words line(text_.substr(at_, end - at_));
        at_ = end;
        std::string rest;
        for (std::string word = line.next(); !word.empty(); word = line.next())
            rest += " " + word;
        return rest;
    }

private:
    static bool is_blank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }
    static bool is_punctuation(char c) { return std::string("{}()[];").find(c) != std::string::npos; }
    bool comment_starts() const { return text_.compare(at_, 2, "//") == 0 || text_.compare(at_, 2, "/*") == 0; }

    void pass_blanks()
    {
        while (at_ < text_.size()) {
            if (is_blank(text_[at_]))
                ++at_;
            else if (comment_starts()) {
                const bool of_line = text_[at_ + 1] == '/';
                const std::size_t end = of_line ? text_.find('\n', at_) : text_.find("*/", at_ + 2);
                at_ = end == std::string::npos ? text_.size() : end + (of_line ? 1 : 2);
            } else
                return;
        }
    }

    const std::string text_;
    std::size_t at_ = 0;
};

/// The entries of a dictionary as "block/key": value, up to its end.
void add_entries(Words& words, const std::string& block, std::map<std::string, std::string>& entries)
{
    for (std::string key = words.next(); !key.empty() && key != "}"; key = words.next()) {
        if (key == ";") continue;
        if (key[0] == '#') {
            entries[block + key + words.rest_of_line()] = "";
            continue;
        }
        std::string value, word;
        int depth = 0;
        for (word = words.next(); !word.empty(); word = words.next()) {
            if (depth == 0 && (word == ";" || word == "{" || word == "}")) break;
            if (word == "(" || word == "[") ++depth;
            if (word == ")" || word == "]") --depth;
            value += (value.empty() ? "" : " ") + word;
        }
        if (word == "{") {
            std::string inner = block + key;
            if (!value.empty()) inner += " " + value;
            std::map<std::string, std::string> own;
            add_entries(words, inner + "/", own);
            if (key == "FoamFile" && block.empty()) continue;
            if (own.empty()) own[inner] = "";
            for (const auto& [name, last] : own)
                entries[name] = last;
            continue;
        }
        entries[block + key] = value.size() > longest_shown ? digest(value) : value;
        if (word == "}") return;  // the last entry of a block without its ;
    }
}

bool is_of_openfoam(const InputFile& file)
{
    for (const char* folder : {"0/", "constant/", "system/"})
        if (starts_with(file.path, folder)) return true;
    return file.path == "parameters" || file.text->find("FoamFile") != std::string::npos;
}

std::vector<std::string> words_of(const std::string& line)
{
    std::istringstream stream(line);
    std::vector<std::string> words;
    for (std::string word; stream >> word;)
        words.push_back(in_one_way(word));
    return words;
}

/// Whether a command of LIGGGHTS has to do with what is written only.
bool is_of_output(const std::vector<std::string>& words)
{
    static const std::set<std::string> commands{"dump",          "dump_modify", "undump",  "thermo", "thermo_style",
                                                "thermo_modify", "print",       "restart", "log",    "write_restart",
                                                "write_data",    "write_dump",  "echo"};
    if (commands.count(words[0]) > 0) return true;
    return words[0] == "fix" && words.size() > 3 && (words[3] == "print" || starts_with(words[3], "ave/"));
}

struct Script {
    std::string physics, output;
};

Script script_of(const std::string& text)
{
    Script script;
    std::istringstream lines(text);
    std::string command;
    for (std::string line; std::getline(lines, line);) {
        line = line.substr(0, line.find('#'));
        const std::size_t last = line.find_last_not_of(" \t\r");
        const bool goes_on = last != std::string::npos && line[last] == '&';
        command += (goes_on ? line.substr(0, last) : line) + " ";
        if (goes_on) continue;
        const std::vector<std::string> words = words_of(command);
        command.clear();
        if (words.empty()) continue;
        std::string& to = is_of_output(words) ? script.output : script.physics;
        if (!to.empty()) to += between_lines;
        for (std::size_t i = 0; i < words.size(); ++i)
            to += (i > 0 ? " " : "") + words[i];
    }
    return script;
}

constexpr const char *lines_of = "lines of ", *output_lines_of = "lines on output of ";

/// What is looked at while a run is prepared, by tools, or says when it ends and what it writes.
bool may_change(const std::string& name)
{
    if (starts_with(name, output_lines_of) || starts_with(name, "place of plug-in ")) return true;
    static const std::set<std::string> of_tools{"blockMeshDict",   "changeDictionaryDict", "createBafflesDict",
                                                "createPatchDict", "decomposeParDict",     "extrudeMeshDict",
                                                "mapFieldsDict",   "meshQualityDict",      "mirrorMeshDict",
                                                "refineMeshDict",  "reportDict",           "sampleDict",
                                                "setFieldsDict",   "snappyHexMeshDict",    "surfaceFeatureExtractDict",
                                                "topoSetDict"};
    static const std::set<std::string> of_control{
        "endTime",      "graphFormat", "libs",          "purgeWrite",    "runTimeModifiable",
        "startFrom",    "stopAt",      "timeFormat",    "timePrecision", "writeCompression",
        "writeControl", "writeFormat", "writeInterval", "writePrecision"};
    // the others say what a row holds
    static const std::set<std::string> of_statistics{"statistics/interval",     "statistics/tapInterval",
                                                     "statistics/from",         "statistics/overlaps/percentiles",
                                                     "statistics/voidage/low",  "statistics/voidage/high",
                                                     "statistics/voidage/cells"};
    const std::size_t comma = name.find(", ");
    const std::string file = name.substr(0, comma), entry = comma == std::string::npos ? "" : name.substr(comma + 2);
    if (starts_with(file, "system/") && of_tools.count(file.substr(7)) > 0) return true;
    if (file == "system/controlDict") return of_control.count(entry) > 0 || starts_with(entry, "functions");
    if (file == "system/couplingDict")
        return starts_with(entry, "records") || starts_with(entry, "checkpoint") || entry == "plugins" ||
               of_statistics.count(entry) > 0;
    return false;
}

std::vector<std::string> lines_in(const std::string& value)
{
    std::vector<std::string> lines;
    std::istringstream stream(value);
    for (std::string line; std::getline(stream, line, between_lines);)
        lines.push_back(line);
    return lines;
}

/// "`thermo 100` is new, `thermo 50` is gone", at most so many.
std::string changed_lines(const std::string& then, const std::string& now)
{
    std::vector<std::string> before = lines_in(then), after = lines_in(now), words;
    std::sort(before.begin(), before.end());
    std::sort(after.begin(), after.end());
    const auto add = [&words](const std::vector<std::string>& of, const std::vector<std::string>& other,
                              const char* what) {
        std::vector<std::string> own;
        std::set_difference(of.begin(), of.end(), other.begin(), other.end(), std::back_inserter(own));
        for (const std::string& line : own)
            words.push_back("`" + line.substr(0, longest_shown) + "` is " + what);
    };
    add(after, before, "new");
    add(before, after, "gone");
    if (words.empty()) return "in another order";
    constexpr std::size_t most = 6;
    std::string all;
    for (std::size_t n = 0; n < std::min(most, words.size()); ++n)
        all += (n > 0 ? ", " : "") + words[n];
    return all + (words.size() > most ? ", and " + std::to_string(words.size() - most) + " more" : "");
}

std::string in_words(const std::string& name, const std::string& then, const std::string& now)
{
    for (const char* lines : {lines_of, output_lines_of})
        if (starts_with(name, lines)) return name.substr(std::string(lines).size()) + ": " + changed_lines(then, now);
    if (starts_with(name, "plug-in ")) return name + " is another build";
    if (starts_with(then, "sha256 ") || starts_with(now, "sha256 ")) return name + " has changed";
    return name + ": " + now + ", and was " + then;
}

}  // namespace

Facts facts_of(const std::vector<InputFile>& files)
{
    Facts facts;
    for (const InputFile& file : files) {
        if (!file.text) {
            facts.emplace_back(file.path, "sha256 " + file.sha256 + " of " + std::to_string(file.bytes) + " bytes");
        } else if (is_of_openfoam(file)) {
            std::map<std::string, std::string> entries;
            Words words(*file.text);
            add_entries(words, "", entries);
            for (const auto& [name, value] : entries)
                facts.emplace_back(file.path + ", " + name, value);
        } else {
            const Script script = script_of(*file.text);
            facts.emplace_back(lines_of + file.path, script.physics);
            facts.emplace_back(output_lines_of + file.path, script.output);
        }
    }
    return facts;
}

FactDifferences differences(const Facts& then, const Facts& now)
{
    FactDifferences found;
    const auto add = [&found](const std::string& name, const std::string& words) {
        (may_change(name) ? found.told : found.refused).push_back(words);
    };
    const std::map<std::string, std::string> before(then.begin(), then.end()), after(now.begin(), now.end());
    for (const auto& [name, value] : then) {
        const auto here = after.find(name);
        if (here == after.end())
            add(name, name + " is gone");
        else if (here->second != value)
            add(name, in_words(name, value, here->second));
    }
    for (const auto& [name, value] : now)
        if (before.count(name) == 0)
            add(name, name + (value.empty() || starts_with(name, "lines ") ? "" : ": " + value) + " is new");
    return found;
}

}  // namespace interphase
