// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/liggghts/plugins/plugin_opener.hpp"

#include <cxxabi.h>
#include <dlfcn.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <map>
#include <memory>
#include <optional>

#include "base/sha256.hpp"
#include "base/text.hpp"
#include "base/user_error.hpp"
#include "engines/liggghts/plugins/own_methods.hpp"
#include "engines/liggghts/plugins/plugin_fit.hpp"
#include "engines/liggghts/plugins/plugin_search.hpp"

namespace interphase {

namespace {

/// Names of our own fixes begin so.
constexpr const char* own_prefix = "interphase/";

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// The words of the dynamic linker, with the symbol that is missing as it stands in the source.
std::string readable(const std::string& words)
{
    const std::string before = "undefined symbol: ";
    const std::size_t at = words.find(before);
    if (at == std::string::npos) return words;
    const std::size_t start = at + before.size();
    const std::string symbol = words.substr(start, words.find_first_of(", \n", start) - start);
    int failed = 0;
    const std::unique_ptr<char, void (*)(void*)> plain(abi::__cxa_demangle(symbol.c_str(), nullptr, nullptr, &failed),
                                                       std::free);
    return plain ? words + " = " + plain.get() : words;
}

std::string remedy_for(const std::string& words)
{
    if (contains(words, "undefined symbol"))
        return "define it in the plug-in or link the library that has it; if LIGGGHTS or a compiler should have it, "
               "the "
               "plug-in was built against another one: build it anew";
    if (contains(words, "cannot open shared object file"))
        return "install the library that it names, or put its folder into LD_LIBRARY_PATH";
    return "give a shared library for this machine, as interphase_add_plugin (CMake) builds one";
}

std::string text_or_nothing(const char* text) { return text ? text : ""; }

/// Letters, digits and `_`, a letter first: a word of dictionaries, commands and files.
bool is_word(const std::string& name)
{
    return !name.empty() && std::isalpha(static_cast<unsigned char>(name[0])) &&
           std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) || c == '_'; });
}

class Opening {
public:
    explicit Opening(const std::string& asked_by) : asked_by_(asked_by) {}

    OpenPlugin open(const std::string& wanted)
    {
        const std::string file = find_plugin(wanted, asked_by_);
        void* library = library_in(file);
        const PluginDescriptor& plugin = descriptor_in(library, file);
        if (const auto misfit = misfit_of(plugin))
            throw UserError("the plug-in " + file + " " + misfit->what, asked_by_, misfit->remedy);
        if (!plugin.name || !*plugin.name || !plugin.styles || plugin.style_count == 0)
            throw UserError("the plug-in " + file + " has no name or brings no fix style", asked_by_,
                            "give INTERPHASE_PLUGIN a name and at least one style");
        std::ifstream content(file, std::ios::binary);
        OpenPlugin open{plugin.name, file, sha256(content), {}, {}, {}};
        for (std::uint64_t i = 0; i < plugin.style_count; ++i)
            take(plugin.styles[i], open);
        if (const auto entry = entry_of<PluginMethodsEntryPoint>(library, plugin_methods_entry_point))
            for (std::uint64_t i = 0; i < entry()->count; ++i)
                take(entry()->items[i], open);
        if (const auto entry = entry_of<PluginCountersEntryPoint>(library, plugin_counters_entry_point))
            for (std::uint64_t i = 0; i < entry()->count; ++i)
                take(entry()->items[i], open);
        return open;
    }

private:
    template <class Entry>
    static Entry entry_of(void* library, const char* name)
    {
        return reinterpret_cast<Entry>(dlsym(library, name));
    }

    void* library_in(const std::string& file)
    {
        // It is never closed: its fixes live as long as LIGGGHTS, its code as long as they may.
        void* library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
        if (!library) {
            std::string words = dlerror();
            if (words.rfind(file + ": ", 0) == 0) words.erase(0, file.size() + 2);
            throw UserError("the plug-in " + file + " cannot be loaded: " + readable(words), asked_by_,
                            remedy_for(words));
        }
        const auto [other, is_new] = files_.emplace(library, file);
        if (!is_new)
            throw UserError("the plug-in " + file + " is given twice" +
                                (other->second == file ? "" : " (it is the same as " + other->second + ")"),
                            asked_by_, "name it once");
        return library;
    }

    const PluginDescriptor& descriptor_in(void* library, const std::string& file) const
    {
        const auto entry = entry_of<PluginEntryPoint>(library, plugin_entry_point);
        const PluginDescriptor* plugin = entry ? entry() : nullptr;
        if (!plugin)
            throw UserError("the library " + file + " is no plug-in of interphase: it has no function " +
                                plugin_entry_point + " that describes one",
                            asked_by_, "add INTERPHASE_PLUGIN(...) to one of its sources (plugins/README.md)");
        return *plugin;
    }

    static std::string shown(const OpenPlugin& plugin) { return plugin.name + " (" + plugin.file + ")"; }

    void take(const PluginStyle& style, OpenPlugin& plugin)
    {
        const std::string name = text_or_nothing(style.name);
        bool usable = !name.empty() && style.create;
        for (const unsigned char c : name)
            usable = usable && std::isgraph(c);
        if (!usable)
            throw UserError("the plug-in " + plugin.file + " brings the fix style `" + name +
                                "`, which no script could name or nothing creates",
                            asked_by_, "name it in letters, digits, `_` and `/`, with a function that creates it");
        const std::string of_plugin = "the fix style `" + name + "` of the plug-in " + shown(plugin);
        if (name.rfind(own_prefix, 0) == 0)
            throw UserError(of_plugin + " begins with `" + own_prefix + "`, which is kept for the coupler", asked_by_,
                            "give it another name");
        const auto [other, is_new] = styles_.emplace(name, shown(plugin));
        if (!is_new)
            throw UserError(of_plugin + " is brought by the plug-in " + other->second + " already", asked_by_,
                            "leave one of the two plug-ins away, or rename the style in one");
        plugin.styles.push_back(&style);
    }

    void take(const PluginMethod& method, OpenPlugin& plugin)
    {
        const std::string name = text_or_nothing(method.name), about = text_or_nothing(method.about);
        const std::string of_plugin = "the method `" + name + "` of the plug-in " + shown(plugin);
        if (!is_word(name) || about.empty() || !(method.per_collision > 0 && method.per_collision < 1e300))
            throw UserError(of_plugin + " is none that a case could name: `" + about + "`, " +
                                text(method.per_collision) + " steps per collision",
                            asked_by_,
                            "give INTERPHASE_METHODS a name in letters, digits and `_`, a letter first, some words on "
                            "who collides, and steps per collision above 0");
        const Methods own = own_methods();
        if (std::any_of(own.begin(), own.end(), [&](const Method& known) { return known.name == name; }))
            throw UserError(of_plugin + " has a name that is LIGGGHTS's own", asked_by_, "give it another name");
        const auto [other, is_new] = methods_.emplace(name, shown(plugin));
        if (!is_new)
            throw UserError(of_plugin + " is brought by the plug-in " + other->second + " already", asked_by_,
                            "leave one of the two plug-ins away, or rename the method in one");
        plugin.methods.push_back({name, about, plugin.name, true, method.tracks_parcels,
                                  text_or_nothing(method.parcels_instead), method.single_collisions,
                                  method.contacts_resolved, method.pair_style_borne, method.per_collision});
    }

    void take(const Counter& counter, OpenPlugin& plugin) const
    {
        const std::string key = text_or_nothing(counter.key);
        bool usable = is_word(key) && counter.unit && counter.remedy && counter.worry_above >= 0;
        for (const char* text : {counter.text, counter.meaning, counter.reason})
            usable = usable && text && *text;
        const bool is_new = std::none_of(plugin.counters.begin(), plugin.counters.end(),
                                         [&](const Counter& other) { return other.key == key; });
        if (!usable || !is_new)
            throw UserError("the plug-in " + shown(plugin) + " counts something as `" + key + "`, which is " +
                                (usable ? "there twice" : "no word, or has no meaning"),
                            asked_by_,
                            "give each Counter of INTERPHASE_COUNTERS a key of its own in letters, digits and `_`, and "
                            "its texts");
        plugin.counters.push_back(counter);
    }

    const std::string& asked_by_;
    std::map<void*, std::string> files_;
    std::map<std::string, std::string> styles_, methods_;  ///< and who brings them
};

/// Ranks may run on machines whose disks differ.
std::string this_rank(const Communicator& comm)
{
    if (comm.is_master()) return "";
    char host[256] = "";
    gethostname(host, sizeof host - 1);
    return ", on rank " + std::to_string(comm.rank()) + " (" + host + ")";
}

}  // namespace

std::vector<OpenPlugin> open_plugins_at_hand()
{
    const std::string nobody;
    std::vector<OpenPlugin> all;
    for (const std::string& name : plugins_at_hand())
        try {
            all.push_back(Opening(nobody).open(name));
        } catch (const UserError&) {  // whoever asks for it by name will be told
        }
    return all;
}

std::vector<OpenPlugin> open_plugins(const Communicator& comm, const std::vector<std::string>& wanted,
                                     const std::string& asked_by)
{
    const std::string place = asked_by + this_rank(comm);
    Opening opening(place);
    std::vector<OpenPlugin> all;
    std::optional<Problem> problem;
    try {
        for (const std::string& name : wanted)
            all.push_back(opening.open(name));
    } catch (const UserError& error) {
        problem = error.problem();
    }
    comm.fail_together(problem);
    return all;
}

}  // namespace interphase
