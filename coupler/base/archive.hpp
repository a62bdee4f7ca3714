// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace interphase {

class Archive;

/// Whether an object has keep(Archive&).
template <class Object, class = void>
inline constexpr bool keeps_itself = false;
template <class Object>
inline constexpr bool
    keeps_itself<Object, std::void_t<decltype(std::declval<Object&>().keep(std::declval<Archive&>()))>> = true;

/// The state of a rank's objects, by name, as bytes. An object with state has one function `keep(Archive&)` that names
/// its members in turn; the archive either takes them in or gives them back, so that what is saved is what is loaded:
///
///     void keep(Archive& archive) { archive.keep("time", time_); archive.keep("watch", watch_); }
class Archive {
public:
    /// Takes in.
    Archive() = default;

    /// One that gives back what this one has taken in.
    Archive to_load() const
    {
        Archive archive;
        archive.state_ = state_;
        archive.loads_ = true;
        return archive;
    }

    /// One that gives back what another has taken in, as its state() tells.
    static Archive loading(std::map<std::string, std::vector<char>> state)
    {
        Archive archive;
        archive.state_ = std::move(state);
        archive.loads_ = true;
        return archive;
    }

    /// Whether it gives back.
    bool loads() const { return loads_; }

    /// An object that has keep(Archive&), also one whose bytes could be copied (it may hold references), a number or
    /// any other trivially copyable object, or a vector of such. Throws a std::runtime_error where it gives back and
    /// has no such name, or one of another size.
    template <class Object>
    void keep(const std::string& name, Object& object)
    {
        if constexpr (keeps_itself<Object>)
            within(name, [&] { object.keep(*this); });
        else {
            static_assert(std::is_trivially_copyable_v<Object>);
            bytes(name, &object, sizeof object);
        }
    }

    template <class Object>
    void keep(const std::string& name, std::vector<Object>& objects)
    {
        if constexpr (std::is_trivially_copyable_v<Object> && !keeps_itself<Object>) {
            if (loads_) objects.resize(found(name).size() / sizeof(Object));
            bytes(name, objects.data(), objects.size() * sizeof(Object));
        } else {
            std::size_t count = objects.size();
            keep(name + ".count", count);
            objects.resize(count);
            for (std::size_t i = 0; i < count; ++i)
                keep(name + "." + std::to_string(i), objects[i]);
        }
    }

    void keep(const std::string& name, std::string& text)
    {
        std::vector<char> letters(text.begin(), text.end());
        keep(name, letters);
        text.assign(letters.begin(), letters.end());
    }

    /// So many numbers that lie side by side, whose count does not change.
    void keep(const std::string& name, double* numbers, std::size_t count)
    {
        bytes(name, numbers, count * sizeof(double));
    }

    /// What `body` keeps is named "name/...".
    template <class Body>
    void within(const std::string& name, const Body& body)
    {
        const std::string outside = prefix_;
        prefix_ += name + "/";
        body();
        prefix_ = outside;
    }

    const std::map<std::string, std::vector<char>>& state() const { return state_; }

private:
    const std::vector<char>& found(const std::string& name) const
    {
        const auto entry = state_.find(prefix_ + name);
        if (entry == state_.end()) throw std::runtime_error("a saved state has no " + prefix_ + name);
        return entry->second;
    }

    void bytes(const std::string& name, void* object, std::size_t size)
    {
        if (!loads_) {
            const char* first = static_cast<const char*>(object);
            state_[prefix_ + name].assign(first, first + size);
            return;
        }
        const std::vector<char>& saved = found(name);
        if (saved.size() != size)
            throw std::runtime_error("a saved state has " + std::to_string(saved.size()) + " bytes of " + prefix_ +
                                     name + " instead of " + std::to_string(size));
        if (size > 0) std::memcpy(object, saved.data(), size);
    }

    std::map<std::string, std::vector<char>> state_;
    std::string prefix_;
    bool loads_ = false;
};

}  // namespace interphase
