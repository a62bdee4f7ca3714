// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/checkpoint.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>

#include "base/sha256.hpp"
#include "base/text.hpp"

namespace interphase {

namespace {

namespace fs = std::filesystem;

constexpr const char* manifest_name = "manifest";
constexpr const char* first_line = "interphase checkpoint 1";
constexpr std::size_t kept = 2;

std::string rank_file(int rank) { return "rank" + std::to_string(rank) + ".state"; }

std::string digest(const std::string& bytes)
{
    std::istringstream stream(bytes);
    return sha256(stream);
}

std::string whole(const fs::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw std::runtime_error(file.string() + ": " + std::strerror(errno));
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// On the disk when it returns; a std::runtime_error with the system's words where that fails.
void write_through(const fs::path& file, const std::string& bytes)
{
    const auto fail = [&](int descriptor) {
        const std::string words = file.string() + ": " + std::strerror(errno);
        if (descriptor >= 0) close(descriptor);
        throw std::runtime_error(words);
    };
    const int descriptor = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    if (descriptor < 0) fail(descriptor);
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t now = ::write(descriptor, bytes.data() + done, bytes.size() - done);
        if (now < 0 && errno == EINTR) continue;
        if (now < 0) fail(descriptor);
        done += static_cast<std::size_t>(now);
    }
    if (fsync(descriptor) != 0) fail(descriptor);
    if (close(descriptor) != 0) fail(-1);
}

/// The names in a folder are on the disk when it returns, where the file system can do that.
void sync_folder(const fs::path& folder)
{
    const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY);
    if (descriptor < 0) return;
    fsync(descriptor);
    close(descriptor);
}

struct Manifest {
    double time = 0;
    int ranks = 0;
    Checkpoints::Facts facts;
    std::map<std::string, std::string> digests;  ///< of the ranks' files
};

std::string to_text(const Manifest& manifest)
{
    std::ostringstream text;
    text.precision(17);
    text << first_line << "\ntime " << manifest.time << "\nranks " << manifest.ranks << '\n';
    for (const auto& [name, value] : manifest.facts)
        text << "fact " << name << '\t' << value << '\n';
    for (const auto& [file, sum] : manifest.digests)
        text << "file " << file << ' ' << sum << '\n';
    return text.str() + "sha256 " + digest(text.str()) + '\n';
}

Manifest read_manifest(const fs::path& folder)
{
    const std::string text = whole(folder / manifest_name);
    const std::size_t end = text.rfind("sha256 ");
    if (text.rfind(first_line, 0) != 0 || end == std::string::npos ||
        text.substr(end) != "sha256 " + digest(text.substr(0, end)) + '\n')
        throw std::runtime_error("its manifest is torn");
    Manifest manifest;
    std::istringstream lines(text.substr(0, end));
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string kind, name;
        words >> kind;
        if (kind == "time") words >> manifest.time;
        if (kind == "ranks") words >> manifest.ranks;
        if (kind == "file") {
            words >> name;
            words >> manifest.digests[name];
        }
        if (kind == "fact") {
            const std::size_t start = kind.size() + 1, tab = line.find('\t');
            manifest.facts.emplace_back(line.substr(start, tab - start), line.substr(tab + 1));
        }
    }
    return manifest;
}

std::string name_of(double time)
{
    char name[32];
    std::snprintf(name, sizeof name, "%.12g", time);
    return name;
}

/// Folders with a manifest that can be read, the newest first; and words for the others.
struct Listing {
    std::vector<std::pair<double, fs::path>> whole;
    std::vector<std::string> torn;
};

Listing listing(const fs::path& folder)
{
    Listing found;
    std::error_code none;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, none)) {
        if (!entry.is_directory(none) || entry.path().filename().string().front() == '.') continue;
        try {
            found.whole.emplace_back(read_manifest(entry.path()).time, entry.path());
        } catch (const std::runtime_error& error) {
            found.torn.push_back(entry.path().string() + " is no whole checkpoint: " + error.what());
        }
    }
    std::sort(found.whole.rbegin(), found.whole.rend());
    return found;
}

/// Text from the first rank to all.
std::string shared(const Communicator& comm, std::string text)
{
    auto size = static_cast<long>(text.size());
    MPI_Bcast(&size, 1, MPI_LONG, 0, comm.handle());
    text.resize(static_cast<std::size_t>(size));
    MPI_Bcast(text.data(), static_cast<int>(size), MPI_CHAR, 0, comm.handle());
    return text;
}

/// Runs `body` on this rank, or on the first only: what went wrong on any of them, in the words of the lowest.
template <class Body>
std::optional<std::string> tried(const Communicator& comm, bool here, const Body& body)
{
    std::string words;
    if (here) try {
            body();
        } catch (const std::exception& error) {
            words = error.what();
            if (words.empty()) words = "unknown";
        }
    std::array<char, 512> mine{};
    words.copy(mine.data(), mine.size() - 1);
    for (const auto& of_rank : comm.all_gather(mine))
        if (of_rank[0] != 0) return std::string(of_rank.data());
    return std::nullopt;
}

}  // namespace

std::string to_bytes(const Archive& state)
{
    std::string bytes;
    const auto add = [&bytes](const char* first, std::size_t size) {
        const auto length = static_cast<std::uint64_t>(size);
        bytes.append(reinterpret_cast<const char*>(&length), sizeof length);
        bytes.append(first, size);
    };
    for (const auto& [name, value] : state.state()) {
        add(name.data(), name.size());
        add(value.data(), value.size());
    }
    return bytes;
}

Archive from_bytes(const std::string& bytes)
{
    std::map<std::string, std::vector<char>> state;
    std::size_t at = 0;
    const auto next = [&] {
        std::uint64_t length = 0;
        if (bytes.size() - at < sizeof length) throw std::runtime_error("a saved state ends early");
        std::memcpy(&length, bytes.data() + at, sizeof length);
        at += sizeof length;
        if (bytes.size() - at < length) throw std::runtime_error("a saved state ends early");
        const char* first = bytes.data() + at;
        at += length;
        return std::pair(first, first + length);
    };
    while (at < bytes.size()) {
        const auto name = next(), value = next();
        state.emplace(std::string(name.first, name.second), std::vector<char>(value.first, value.second));
    }
    return Archive::loading(std::move(state));
}

std::optional<Problem> Checkpoints::write(double time, const Archive& state, const Facts& facts) const
{
    const fs::path final_place = folder_ / name_of(time), place = folder_ / (".writing-" + name_of(time));
    std::array<char, 65> sum{};
    std::optional<std::string> wrong = tried(comm_, comm_.is_master(), [&] {
        fs::create_directories(folder_);
        fs::remove_all(place);
        fs::create_directory(place);
    });
    if (!wrong)
        wrong = tried(comm_, true, [&] {
            const std::string bytes = to_bytes(state);
            write_through(place / rank_file(comm_.rank()), bytes);
            digest(bytes).copy(sum.data(), sum.size() - 1);
        });
    const auto sums = comm_.all_gather(sum);
    if (!wrong)
        wrong = tried(comm_, comm_.is_master(), [&] {
            Manifest manifest{time, comm_.size(), facts, {}};
            for (int rank = 0; rank < comm_.size(); ++rank)
                manifest.digests[rank_file(rank)] = sums[static_cast<std::size_t>(rank)].data();
            write_through(place / manifest_name, to_text(manifest));
            sync_folder(place);
            fs::remove_all(final_place);  // of the same time, by a run that went on from before it
            fs::rename(place, final_place);
            sync_folder(folder_);
            const Listing all = listing(folder_);
            std::size_t stay = 0;
            for (const auto& [written_at, path] : all.whole)
                if (written_at > time || ++stay > kept) fs::remove_all(path);
        });
    if (!wrong) return std::nullopt;
    tried(comm_, comm_.is_master(), [&] { fs::remove_all(place); });
    return Problem{"the checkpoint of t = " + text(time) + " s could not be written: " + *wrong, folder_.string(),
                   "make room there, or give the right to write; the one before it is kept"};
}

std::optional<Checkpoints::Found> Checkpoints::newest(std::vector<std::string>& passed_over) const
{
    Listing all;
    if (comm_.is_master()) all = listing(folder_);
    if (comm_.is_master()) passed_over = all.torn;
    for (std::size_t n = 0;; ++n) {
        const std::string path = shared(comm_, n < all.whole.size() ? all.whole[n].second.string() : "");
        if (path.empty()) return std::nullopt;
        Found found;
        found.path = path;
        const auto wrong = tried(comm_, true, [&] {
            const Manifest manifest = read_manifest(path);
            found.time = manifest.time;
            found.ranks = manifest.ranks;
            found.facts = manifest.facts;
            // with other ranks, each looks after some of the files
            std::map<int, Archive::State> mine;
            for (int rank = comm_.rank(); rank < manifest.ranks; rank += comm_.size()) {
                const std::string bytes = whole(fs::path(path) / rank_file(rank));
                if (digest(bytes) != manifest.digests.at(rank_file(rank)))
                    throw std::runtime_error(rank_file(rank) + " is not as it was written");
                mine[rank] = from_bytes(bytes).state();
            }
            found.state = Archive::loading(comm_, manifest.ranks, std::move(mine));
        });
        if (!wrong) return found;
        passed_over.push_back(path + " is no whole checkpoint: " + *wrong);
    }
}

std::string Checkpoints::newest_name() const
{
    if (!comm_.is_master()) return "";
    const Listing all = listing(folder_);
    return all.whole.empty() ? "" : all.whole.front().second.string();
}

void Checkpoints::refuse_earlier(const std::optional<std::string>& wrong) const
{
    comm_.fail_together(wrong ? std::optional(Problem{"checkpoints of an earlier run are in the way: " + *wrong,
                                                      folder_.string(), "move them elsewhere"})
                              : std::nullopt);
}

void Checkpoints::remove_earlier() const
{
    const auto wrong = tried(comm_, comm_.is_master(), [&] { fs::remove_all(folder_); });
    refuse_earlier(wrong);
}

std::string Checkpoints::put_earlier_aside() const
{
    std::string name;
    const auto wrong = tried(comm_, comm_.is_master(), [&] {
        std::error_code none;
        if (!fs::is_directory(folder_, none) || fs::is_empty(folder_)) return;
        int number = 1;
        const auto aside = [&] { return folder_.string() + "-of-an-earlier-run-" + std::to_string(number); };
        while (fs::exists(aside()))
            ++number;
        fs::rename(folder_, aside());
        name = aside();
    });
    refuse_earlier(wrong);
    return shared(comm_, name);
}

}  // namespace interphase
