// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "records/hdf5_file.hpp"

namespace interphase {

/// An HDF5 file of one rank that anybody can open at any moment, also after the process was killed while it wrote.
///
/// HDF5 changes a file in several writes, and one that is killed between two of them is torn. So there are two copies:
/// changes go to the one that is called NAME.next, which takes the name when it is complete, in one rename; then the
/// other one catches up and is the next. Each change is written twice, whatever the size of the file.
class TwinFile {
public:
    /// What the first publish() does with a file that is there.
    enum class Start { anew, from_what_is_there };

    explicit TwinFile(std::string path, Start start = Start::anew) : path_(std::move(path)), start_(start) {}
    ~TwinFile();
    TwinFile(const TwinFile&) = delete;
    TwinFile& operator=(const TwinFile&) = delete;

    using Change = std::function<void(Hdf5File&)>;

    /// To be made with the next publish(); it is called once for each copy.
    void change(Change change) { changes_.push_back(std::move(change)); }

    /// All changes so far stand in the file then. The first one replaces a file that was there, or adds to it. Throws
    /// a UserError where the disk does not take it: the file is then what it was.
    void publish();

private:
    struct Copy {
        Hdf5File file;
        std::size_t changes = 0;  ///< of changes_, how many it has
    };

    std::string next() const { return path_ + ".next"; }
    void ready_next();
    void drop_next();
    void take_the_name();

    std::string path_;
    Start start_;
    std::vector<Change> changes_;  ///< that not both copies have
    std::unique_ptr<Copy> shown_, next_;
};

}  // namespace interphase
