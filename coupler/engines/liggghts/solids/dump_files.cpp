// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/liggghts/solids/dump_files.hpp"

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "base/free_name.hpp"
#include "base/text.hpp"
#include "base/user_error.hpp"
#include "dump.h"
#include "lammps.h"
#include "output.h"
#include "update.h"

namespace interphase {

namespace {

namespace fs = std::filesystem;

/// What LIGGGHTS gives nobody to see.
struct OpenDump : LAMMPS_NS::Dump {
    /// This rank's file, where it has one for all steps that is not open yet.
    static std::optional<std::string> file(LAMMPS_NS::Dump& dump)
    {
        if (dump.*(&OpenDump::multifile) != 0 || dump.*(&OpenDump::singlefile_opened) != 0 ||
            dump.*(&OpenDump::filewriter) == 0)
            return std::nullopt;
        const bool of_rank = dump.*(&OpenDump::multiproc) != 0;
        return of_rank ? dump.*(&OpenDump::multiname) : dump.*(&OpenDump::filename);
    }
    /// Others are opened in another way.
    static bool can_append(LAMMPS_NS::Dump& dump)
    {
        return dump.*(&OpenDump::binary) == 0 && dump.*(&OpenDump::compressed) == 0;
    }
    static void append(LAMMPS_NS::Dump& dump) { dump.*(&OpenDump::append_flag) = 1; }
};

bool starts_with(const std::string& line, const char* start) { return line.rfind(start, 0) == 0; }

constexpr const char *item = "ITEM: ", *step_item = "ITEM: TIMESTEP", *number_item = "ITEM: NUMBER OF",
                     *box_item = "ITEM: BOX", *step_of_xyz = "Atoms. Timestep: ";

/// Lines with the places where they end.
class Lines {
public:
    explicit Lines(std::istream& text) : text_(text) {}
    bool next()
    {
        start_ += length_;
        if (!std::getline(text_, line_)) return false;
        length_ = line_.size() + (text_.eof() ? 0 : 1);
        return true;
    }
    const std::string& line() const { return line_; }
    std::int64_t number() const { return std::atoll(line_.c_str()); }
    bool whole() const { return length_ > line_.size(); }
    std::uintmax_t end() const { return start_ + length_; }

private:
    std::istream& text_;
    std::string line_;
    std::uintmax_t start_ = 0, length_ = 0;
};

/// Goes past so many whole lines of a frame.
bool pass_data(Lines& lines, std::int64_t count)
{
    for (std::int64_t n = 0; n < count; ++n)
        if (!lines.next() || !lines.whole() || lines.line().find(item) != std::string::npos) return false;
    return true;
}

/// Goes past the lines about a frame; the number of its particles, or nothing.
std::optional<std::int64_t> pass_head(Lines& lines)
{
    std::optional<std::int64_t> count;
    while (lines.next() && lines.whole() && !starts_with(lines.line(), step_item)) {
        const bool is_item = starts_with(lines.line(), item);
        if (is_item && count && !starts_with(lines.line(), box_item)) return count;  // "ITEM: ATOMS id x"
        if (!starts_with(lines.line(), number_item)) continue;
        if (!lines.next() || !lines.whole()) return std::nullopt;
        count = lines.number();
    }
    return std::nullopt;
}

WholeFrames whole_frames_of_items(Lines& lines, std::int64_t last_step)
{
    WholeFrames found;
    do {
        found.torn = true;
        if (lines.line() != step_item || !lines.next() || !lines.whole()) return found;
        if (lines.number() > last_step) break;
        const auto count = pass_head(lines);
        if (!count || !pass_data(lines, *count)) return found;
        found.end = lines.end();
    } while (lines.next());
    found.torn = false;
    return found;
}

WholeFrames whole_frames_of_xyz(Lines& lines, std::int64_t last_step)
{
    WholeFrames found;
    do {
        found.torn = true;
        const std::int64_t count = lines.number();
        if (!lines.next() || !lines.whole() || !starts_with(lines.line(), step_of_xyz)) return found;
        if (std::atoll(lines.line().c_str() + std::strlen(step_of_xyz)) > last_step) break;
        if (!pass_data(lines, count)) return found;
        found.end = lines.end();
    } while (lines.next());
    found.torn = false;
    return found;
}

/// Cuts a file, whose rest goes into another.
void cut(const std::string& file, std::uintmax_t end, const std::string& rest)
{
    {
        std::ifstream from(file, std::ios::binary);
        from.seekg(static_cast<std::streamoff>(end));
        std::ofstream to(rest, std::ios::binary);
        to << from.rdbuf();
        to.close();
        if (!to) throw UserError("the rest of a dump could not be put into " + rest, file, "make room on the disk");
    }
    fs::resize_file(file, end);
}

std::optional<Problem> go_on_with(LAMMPS_NS::Dump& dump, const std::string& file, std::int64_t step, double time)
{
    const std::string of_dump = "dump " + std::string(dump.id) + " (" + dump.style + ")";
    std::optional<WholeFrames> whole;
    if (OpenDump::can_append(dump)) {
        std::ifstream text(file, std::ios::binary);
        whole = whole_frames(text, step);
    }
    if (!whole || whole->end == 0) {
        const std::string aside = free_name(file, "until-" + text(time));
        fs::rename(file, aside);
        return Problem{of_dump + " begins a new file at t = " + text(time) + " s; the one before is " + aside, file,
                       whole ? "none is needed: no frame of it is whole and of a step before"
                             : "none is needed; dump custom, local, atom and xyz go on in one file"};
    }
    OpenDump::append(dump);
    if (whole->end == fs::file_size(file)) return std::nullopt;
    const std::string rest = free_name(file, "beyond-" + text(time));
    cut(file, whole->end, rest);
    return Problem{of_dump + " goes on at t = " + text(time) + " s; " +
                       (whole->torn ? "frames from one that is torn on are" : "later frames are") + " in " + rest,
                   file, "none is needed: the run makes them again"};
}

}  // namespace

std::optional<WholeFrames> whole_frames(std::istream& text, std::int64_t last_step)
{
    Lines lines(text);
    if (!lines.next()) return std::nullopt;
    if (lines.line() == step_item) return whole_frames_of_items(lines, last_step);
    const bool may_be_xyz =
        !lines.line().empty() && lines.line().find_first_not_of("0123456789") == std::string::npos && lines.whole();
    std::string second(std::strlen(step_of_xyz), ' ');
    if (may_be_xyz && text.read(second.data(), static_cast<std::streamsize>(second.size())) && second == step_of_xyz) {
        text.seekg(0);
        Lines again(text);
        again.next();
        return whole_frames_of_xyz(again, last_step);
    }
    return std::nullopt;
}

std::vector<Problem> go_on_dumping(LAMMPS_NS::LAMMPS& lmp, double time, bool resumed)
{
    const std::int64_t last_step = lmp.update->ntimestep - (resumed ? 0 : 1);
    std::vector<Problem> told;
    LAMMPS_NS::Output& output = *lmp.output;
    for (int n = 0; n < output.ndump; ++n) {
        if (resumed) output.last_dump[n] = last_step;
        const std::optional<std::string> file = OpenDump::file(*output.dump[n]);
        std::error_code none;
        if (!file || !fs::is_regular_file(*file, none) || fs::file_size(*file, none) == 0) continue;
        try {
            if (const auto problem = go_on_with(*output.dump[n], *file, last_step, time)) told.push_back(*problem);
        } catch (const fs::filesystem_error& error) {
            throw UserError(
                "the file of dump " + std::string(output.dump[n]->id) + " cannot be readied to go on: " + error.what(),
                *file, "give the right to write there, or move it away");
        }
    }
    return told;
}

}  // namespace interphase
