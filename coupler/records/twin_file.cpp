// SPDX-License-Identifier: GPL-3.0-or-later
#include "records/twin_file.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <utility>

#include "records/unwritten.hpp"

namespace interphase {

namespace {

[[noreturn]] void refuse(const std::string& path, const std::string& why)
{
    throw unwritten("it cannot be put in place: " + why, path);
}

void rename_file(const std::string& from, const std::string& to)
{
    if (std::rename(from.c_str(), to.c_str()) != 0) refuse(to, std::strerror(errno));
}

}  // namespace

TwinFile::~TwinFile() { drop_next(); }

void TwinFile::drop_next()
{
    if (!next_) return;
    next_.reset();
    unlink(next().c_str());
}

void TwinFile::ready_next()
{
    if (next_) return;
    if (!shown_ && start_ == Start::anew) {
        next_.reset(new Copy{Hdf5File::create(next())});
        return;
    }
    std::error_code error;
    std::filesystem::copy_file(path_, next(), std::filesystem::copy_options::overwrite_existing, error);
    if (error) refuse(next(), error.message());
    next_.reset(new Copy{Hdf5File::open(next()), shown_ ? shown_->changes : 0});
}

void TwinFile::publish()
{
    if (shown_ && shown_->changes == changes_.size()) return;
    ready_next();
    try {
        for (; next_->changes < changes_.size(); ++next_->changes)
            changes_[next_->changes](next_->file);
        next_->file.flush();
        take_the_name();
    } catch (...) {
        drop_next();  // it may have half of a change
        throw;
    }
    std::swap(shown_, next_);
    // what both have is done; a copy that is still to be made has what the file has
    const std::size_t done = next_ ? next_->changes : shown_->changes;
    changes_.erase(changes_.begin(), changes_.begin() + static_cast<std::ptrdiff_t>(done));
    shown_->changes -= done;
    if (next_) next_->changes = 0;
}

void TwinFile::take_the_name()
{
    const std::string kept = path_ + ".kept";
    unlink(kept.c_str());  // of a run that was killed
    if (!shown_) {
        rename_file(next(), path_);
        return;
    }
    // A second name keeps the old copy while the new one takes the first: without a moment in which there is no file.
    const bool linked = link(path_.c_str(), kept.c_str()) == 0;
    rename_file(next(), path_);
    if (linked)
        rename_file(kept, next());
    else
        shown_.reset();  // a file system without second names: the next copy is made afresh
}

}  // namespace interphase
